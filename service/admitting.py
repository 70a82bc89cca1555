"""Who is let in, as the settings say."""

from pathlib import Path
from urllib.parse import urlsplit

from service.admission import Admitted, Allowance
from service.keys import KeyRing, listed_keys, read_keys
from service.service_settings import Settings
from solver.errors import FieldError


def admitted_of(settings: Settings) -> Admitted:
    """Returns who is let in.

    Raises:
        FieldError: a key, or an origin, cannot be one.
        SyntaxFault: the file of keys is no YAML.
        OSError: it cannot be read.
    """
    for origin in settings.allow_origin:
        place = urlsplit(origin)
        if place.scheme not in ("http", "https") or not place.netloc or place.path or place.query:
            raise FieldError("allow_origin", f"{origin!r:.80} is no place", "scheme, host and port, such as https://homes.example")
    return Admitted(
        _keys(settings),
        Allowance(settings.key_calls, settings.key_work),
        Allowance(settings.address_calls, settings.address_work),
        settings.allow_origin,
    )


def _keys(settings: Settings) -> KeyRing:
    """Reads the keys; a file that is named but holds none opens the service to nobody by mistake."""
    pairs = listed_keys(settings.keys)
    if settings.keys_file is not None:
        in_file = read_keys(Path(settings.keys_file).read_bytes())
        if not in_file:
            raise FieldError("keys_file", f"{settings.keys_file} holds no key", "at least one, or no file")
        pairs = [*pairs, *in_file]
    return KeyRing(pairs)
