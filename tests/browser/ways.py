"""The three ways in which a person works the page: a pointer, the keyboard alone, fingers."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import TypeAlias

from playwright.sync_api import CDPSession, Locator, expect

from tests.browser.visit import ANSWER_MS, COME_TO_REST, Visit

Spot: TypeAlias = tuple[float, float]
"""A place of the window [CSS pixels]."""

SCENE = "JSON.stringify(compose.scene)"
OTHER_AT_REST = f"""async ([before, patience]) => {{
    const end = performance.now() + patience;
    while ({SCENE} === before && performance.now() < end) await new Promise(requestAnimationFrame);
    return await ({COME_TO_REST})(end - performance.now()) ? {SCENE} : null;
}}"""
"""Waits in the page for another scene than one, if any, and for rest; tells the scene then: to ask thrice costs thrice as much."""
REACHED = "one => one.tabIndex >= 0 && one.checkVisibility({visibilityProperty: true}) && one.closest('[inert]') === null"
"""Whether the Tab key comes to an element."""
LET_GO = f"""patience => {{
    document.activeElement?.blur();
    for (const one of document.querySelectorAll('dialog[open]')) one.close();
    for (const one of document.querySelectorAll(':popover-open')) one.hidePopover();
    for (let times = 0; times < 6; times += 1)
        document.body.dispatchEvent(new KeyboardEvent('keydown', {{key: 'Escape', code: 'Escape', bubbles: true, cancelable: true}}));
    return ({COME_TO_REST})(patience);
}}"""
"""Presses Escape as often as there may be something to put away, all at once: as many calls to the page take as long as a short act."""
STEPS = 6


class Way:
    """A way to work the page; each act of it waits until the page is at rest."""

    name = ""
    seen = "2"
    """The key of the view in which acts begin."""

    def __init__(self, visit: Visit) -> None:
        self.visit, self.page = visit, visit.page

    def press(self, control: Locator) -> None:
        """Press a button, or follow a link."""
        raise NotImplementedError

    def tool(self, name: str) -> None:
        """Use one of the tools over the house."""
        self.press(self.page.locator(f"#tools [data-tool={name}]"))

    def view(self, name: str) -> None:
        """Look at the house in another way: `plan`, `corner`, `top`, `walk`, `split`."""
        self.press(self.page.locator(f"#camera_{name}"))

    def switch(self, control: Locator) -> None:
        """Turn a checkbox over."""
        self.press(control)

    def select(self, control: Locator, value: str) -> None:
        """Choose an option of a list, in the browser's own menu."""
        control.select_option(value)
        self.visit.settle()

    def write(self, field: Locator, words: str) -> None:
        """Go to a field, write in it, and press Enter, as every keyboard has it."""
        field.focus()
        field.fill(words)
        self.page.keyboard.press("Enter")
        self.visit.settle()

    def to_end(self, slider: Locator) -> None:
        """Move a slider to its end."""
        slider.scroll_into_view_if_needed()
        box = slider.bounding_box()
        assert box
        self.tap(box["x"] + box["width"] - 3, box["y"] + box["height"] / 2)

    def tap(self, x: float, y: float) -> None:
        """Press and let go at a place of the window [CSS pixels]."""
        self.page.mouse.click(x, y)
        self.visit.settle()

    def choose(self, id_of: str) -> None:
        """Choose a piece."""
        raise NotImplementedError

    def add(self, id_of: str) -> None:
        """Choose one more piece."""
        raise NotImplementedError

    def drag(self, start: Spot, end: Spot, *, held: bool = True) -> None:
        """Drag from a place to another and let go; `held`: what is there is taken hold of at once."""
        raise NotImplementedError

    def at(self, id_of: str) -> Spot:
        """Where in the window a body is met, with the stage in view."""
        self.page.locator("#stage").scroll_into_view_if_needed()
        at = self.page.evaluate("id => compose.whereIs(id)", id_of)
        assert at is not None, f"{id_of} is hidden"
        return at["x"], at["y"]

    def floor(self, x: float, z: float) -> Spot:
        """Where in the window a place of the floor is seen [m]."""
        at = self.page.evaluate("([x, z]) => compose.whereAt(x, z)", [x, z])
        return at["x"], at["y"]

    def changed(self, act: Callable[[], object]) -> str:
        """Do something that changes the home; returns the scene then, to the byte."""
        before = self.scene()
        act()
        after = self.scene(before)
        assert after != before, "the home stays as it was"
        return after

    def scene(self, before: str | None = None) -> str:
        """The scene shown, to the byte, once all is at rest; where another is given, once it is none such."""
        shown: str | None = self.page.evaluate(OTHER_AT_REST, [before, ANSWER_MS])
        assert shown is not None, "the page does not come to rest"
        return shown

    def let_go(self) -> None:
        """Choose nothing, put everything away that lies over the house."""
        assert self.page.evaluate(LET_GO, ANSWER_MS), "the page does not come to rest"


class Pointer(Way):
    """A mouse."""

    name = "pointer"

    def press(self, control: Locator) -> None:
        control.click()
        self.visit.settle()

    def choose(self, id_of: str) -> None:
        self.page.mouse.click(*self.at(id_of))
        self.visit.settle()

    def add(self, id_of: str) -> None:
        self.page.keyboard.down("Shift")
        self.page.mouse.click(*self.at(id_of))
        self.page.keyboard.up("Shift")
        self.visit.settle()

    def drag(self, start: Spot, end: Spot, *, held: bool = True) -> None:
        self.page.mouse.move(*start)
        self.page.mouse.down()
        self.page.mouse.move(*end, steps=STEPS)
        self.page.mouse.up()
        self.visit.settle()


class Keyboard(Way):
    """Keys alone: what has a shortcut is done by it, as the page announces it; all else has the focus first."""

    name = "keyboard"

    def press(self, control: Locator) -> None:
        expect(control).to_be_enabled()
        keys = (control.get_attribute("aria-keyshortcuts") or "").split()
        if keys:
            self.page.evaluate("document.activeElement?.blur()")
            self.page.keyboard.press(keys[0] if len(keys[0]) > 1 else keys[0].lower())
        else:
            self._go_to(control)
            is_box = control.evaluate("one => one.type === 'checkbox'")
            self.page.keyboard.press("Space" if is_box else "Enter")
        self.visit.settle()

    def _go_to(self, control: Locator) -> None:
        """By the Tab key; in a group that is one stop of it, by arrows from there."""
        if control.evaluate(REACHED):
            control.focus()
            return
        group = control.locator("xpath=ancestor::*[@role='group'][1]")
        stop = group.locator("[tabindex='0']")
        assert stop.count() == 1 and stop.evaluate(REACHED), f"the Tab key does not reach {control}"
        stop.focus()
        for _ in range(group.locator("button").count()):
            if control.evaluate("one => one === document.activeElement"):
                break
            self.page.keyboard.press("ArrowRight")
        expect(control).to_be_focused()

    def select(self, control: Locator, value: str) -> None:
        """By the arrows, each of which is a choice; the list keeps the focus meanwhile."""
        self._go_to(control)
        wanted: int = control.evaluate("(one, value) => [...one.options].findIndex(of => of.value === value)", value)
        shown: int = control.evaluate("one => one.selectedIndex")
        for _ in range(abs(wanted - shown)):
            expect(control).to_be_focused()
            self.page.keyboard.press("ArrowDown" if shown < wanted else "ArrowUp")
            self.visit.settle()
        expect(control).to_have_value(value)

    def to_end(self, slider: Locator) -> None:
        self._go_to(slider)
        self.page.keyboard.press("End")
        self.visit.settle()

    def choose(self, id_of: str) -> None:
        self._find(id_of, "Enter")

    def add(self, id_of: str) -> None:
        line = self.visit.line_of(id_of)
        line.focus()  # the arrows come to it, from the one line that the Tab key reaches
        self.page.keyboard.press("Shift+Enter")
        self.visit.settle()

    def _find(self, id_of: str, key: str) -> None:
        """Finds a piece in the text by its id, and goes to the house with it."""
        find = self.page.locator("#find")
        self._go_to(find)
        find.fill(id_of)
        for _ in range(20):
            self.page.keyboard.press(key)
            if self.page.evaluate("compose.state.selected") == id_of:
                break
        assert self.page.evaluate("compose.state.selected") == id_of
        find.fill("")
        self.page.locator("#stage").focus()
        self.visit.settle()


class Touch(Way):
    """Fingers."""

    name = "touch"

    def __init__(self, visit: Visit) -> None:
        super().__init__(visit)
        self._session: CDPSession = visit.page.context.new_cdp_session(visit.page)

    def fingers(self, kind: str, places: Sequence[Spot] = ()) -> None:
        """Tells where all fingers are: `touchStart` or `touchMove`; or that none are, `touchEnd`."""
        points = [{"x": x, "y": y, "id": number} for number, (x, y) in enumerate(places)]
        self._session.send("Input.dispatchTouchEvent", {"type": kind, "touchPoints": points})

    def lift(self, *places: Spot) -> None:
        """Lifts all fingers from where they are, having rested there."""
        self.page.wait_for_timeout(REST_MS)
        self.fingers("touchMove", places)
        self.fingers("touchEnd")

    def press(self, control: Locator) -> None:
        control.tap()
        self.visit.settle()

    def tap(self, x: float, y: float) -> None:
        self.page.touchscreen.tap(x, y)
        self.visit.settle()

    def choose(self, id_of: str) -> None:
        self.page.touchscreen.tap(*self.at(id_of))
        self.page.wait_for_function("id => compose.state.selected === id", arg=id_of)
        self.visit.settle()

    def add(self, id_of: str) -> None:
        self.tool("several")
        self.page.touchscreen.tap(*self.at(id_of))
        self.visit.settle()
        self.tool("several")

    def drag(self, start: Spot, end: Spot, *, held: bool = True) -> None:
        (x, y), (to_x, to_y) = start, end
        self.fingers("touchStart", [start])
        if not held:
            self.page.evaluate(LONG_PRESSED)
        for step in range(1, STEPS + 1):
            self.fingers("touchMove", [(x + (to_x - x) * step / STEPS, y + (to_y - y) * step / STEPS)])
        self.lift(end)
        self.visit.settle()


LONG_PRESSED = "new Promise(done => setTimeout(done, 500))"
"""Waits until the page takes a finger to have stayed on something, by its own timers: they come in order, however busy it is."""
REST_MS = 150
"""A finger that has rested so long is not flung: after a fling the browser takes the next tap for its end, and no click comes of it."""
WAYS: tuple[type[Way], ...] = (Pointer, Keyboard, Touch)


def unfold(way: Way, *groups: str) -> None:
    """Unfolds groups of controls."""
    for name in groups:
        if way.page.locator(f"#{name}").get_attribute("open") is None:
            way.press(way.page.locator(f"#{name} > summary"))
