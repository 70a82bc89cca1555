"""What plans call rooms: words of many languages and ways of writing are understood, and nothing is where nothing is said."""

from __future__ import annotations

from difflib import get_close_matches
from pathlib import Path
from random import Random

import pytest

from catalogs import CatalogError, load_catalogs
from catalogs.synonyms import NEARLY, _close_to, room_names_of, synonyms_of, words_of
from tests.every import every

KNOWN = load_catalogs()
NAMES = room_names_of(KNOWN)


@every(
    ("type_name", "names"),
    [
        (
            "bathroom",
            [
                "Bathroom",
                "WC 2",
                "Gäste-WC",
                "Salle de bain",
                "Cuarto de baño",
                "Bagno",
                "Casa de banho",
                "Łazienka",
                "Baderom",
                "Санузел",
                "卫生间",
            ],
        ),
        (
            "kitchen",
            [
                "KITCHEN",
                "Küche",
                "cuisine",
                "Cocina",
                "Cucina",
                "Cozinha",
                "Keuken",
                "kuchnia",
                "Køkken",
                "Kök",
                "кухня",
                "厨房",
                "キッチン",
            ],
        ),
        (
            "bedroom",
            [
                "Bedroom #1",
                "BedRoom_02",
                "Schlafzimmer",
                "Chambre Anna",
                "Dormitorio 2",
                "Camera da letto",
                "Quarto",
                "Slaapkamer",
                "Sypialnia",
            ],
        ),
        (
            "living_room",
            ["Living room", "LivingRoom", "Wohnzimmer", "Séjour", "Salón", "Soggiorno", "Sala de estar", "Woonkamer", "Vardagsrum", "客厅"],
        ),
        ("bedroom_master", ["Master Bedroom", "Elternschlafzimmer", "主卧", "camera matrimoniale"]),
        ("kids_bedroom", ["Kids' room", "Kinderzimmer 1", "Chambre d'enfant", "детская", "Barnrum"]),
        ("hallway", ["Corridor", "Flur", "Couloir", "Pasillo", "Przedpokój", "коридор", "廊下"]),
        ("foyer", ["Entrance hall", "Windfang", "Entrée", "прихожая", "玄関"]),
        ("bathroom", ["Kylpyhuone", "KH", "Fürdőszoba", "Ebeveyn banyosu", "Záchod"]),
        ("kitchen", ["Keittiö", "Konyha", "MUTFAK", "Kuchyně"]),
        ("living_room", ["Olohuone", "OH", "Nappali", "Oturma odası", "Obývací pokoj"]),
        ("bedroom", ["Makuuhuone 2", "MH 1", "Hálószoba", "Yatak Odası 1", "Ložnice"]),
        ("kids_bedroom", ["Lastenhuone", "Gyerekszoba", "ÇOCUK ODASI", "Dětský pokoj"]),
        ("dining_room", ["Ruokailutila", "Étkező", "Yemek odası", "Jídelna"]),
        ("foyer", ["Eteinen", "Előszoba", "Giriş", "Předsíň"]),
        ("backyard", ["Piha", "Kert", "Bahçe", "Zahrada"]),
        ("storage", ["Varasto", "Kamra", "Kiler", "Komora", "창고", "팬트리", "Gudang", "Nhà kho", "ห้องเก็บของ", "Debara", "מחסן"]),
        ("bathroom", ["화장실", "욕실 2", "Phòng tắm", "ห้องน้ำ 1", "حَمّام", "חדר רחצה", "Санвузол", "Μπάνιο", "बाथरूम", "Baie"]),
        ("kitchen", ["주방", "부엌", "Bếp", "ห้องครัว", "المطبخ", "מטבח", "ΚΟΥΖΊΝΑ", "रसोई", "Dapur", "Bucătărie", "廚房"]),
        ("living_room", ["거실", "P. KHÁCH", "ห้องนั่งเล่น", "غرفة المعيشة", "סלון", "Вітальня", "Σαλόνι", "R. Tamu", "客廳"]),
        ("bedroom", ["침실1", "Phòng ngủ 2", "ห้องนอน 2", "غرفة نوم", "חדר שינה", "Υπνοδωμάτιο", "शयनकक्ष", "Dormitor"]),
        ("bedroom_master", ["안방", "부부침실", "ห้องนอนใหญ่", "חדר הורים", "主臥", "غرفة النوم الرئيسية"]),
        ("kids_bedroom", ["자녀방", "아이방", "Дитяча кімната", "חדר ילדים", "Παιδικό", "Kamar anak", "غرفة الأطفال"]),
        ("dining_room", ["식당", "Phòng ăn", "Їдальня", "Τραπεζαρία", "भोजन कक्ष", "פינת אוכל", "餐廳"]),
        ("laundry", ["다용도실", "세탁실", "ซักล้าง", "غرفة غسيل", "חדר כביסה", "Пральня"]),
        ("foyer", ["현관", "Передпокій", "מבואה", "مدخل", "Predsieň", "玄關"]),
        ("hallway", ["복도", "Hành lang", "מסדרון", "Διάδρομος", "ทางเดิน", "Hodnik"]),
        ("balcony", ["발코니", "베란다", "Ban công", "ระเบียง", "מרפסת", "Μπαλκόνι", "बालकनी", "陽台"]),
        ("closet", ["드레스룸", "옷방", "ห้องแต่งตัว", "Гардеробна"]),
    ],
)
def test_rooms_are_known_by_what_many_languages_call_them(type_name: str, names: list[str]) -> None:
    found = {name: meaning and meaning.key for name in names for meaning in [NAMES.meaning(name)]}
    assert found == dict.fromkeys(names, type_name)


@every(
    ("name", "key"),
    [
        ("BR 1", "bedroom"),
        ("Bdrm", "bedroom"),
        ("Bed 2", "bedroom"),
        ("MBR", "bedroom_master"),
        ("Mstr Bed", "bedroom_master"),
        ("LIV RM", "living_room"),
        ("Fam. Rm.", "living_room"),
        ("KIT.", "kitchen"),
        ("Brkfst", "dining_room"),
        ("Pwdr Rm", "bathroom"),
        ("TOIL.", "bathroom"),
        ("LAV", "bathroom"),
        ("Laund.", "laundry"),
        ("UTIL", "laundry"),
        ("Corr.", "hallway"),
        ("Ent.", "foyer"),
        ("GAR", "garage"),
        ("Coats", "closet"),
        ("Clos.", "closet"),
        ("Mech", "technical_room"),
        ("STOR.", "storage"),
        ("WZ", "living_room"),
        ("Schlafz. 2", "bedroom"),
        ("Kü.", "kitchen"),
        ("Abst.", "storage"),
        ("SdB", "bathroom"),
        ("Chbre 2", "bedroom"),
        ("Dgt", "hallway"),
        ("Dorm. 1", "bedroom"),
        ("Coc.", "kitchen"),
        ("Sogg.", "living_room"),
        ("Cam. 2", "bedroom"),
        ("Slpk 1", "bedroom"),
        ("Łaz.", "bathroom"),
    ],
)
def test_what_architects_abbreviate_is_plain(name: str, key: str) -> None:
    meaning = NAMES.meaning(name)
    assert meaning is not None
    assert meaning == (key, True)


@every(
    ("name", "type_name"),
    [
        ("Master bath", "bathroom"),
        ("Bedroom / Office", "bedroom"),
        ("Living and dining", "living_room"),
        ("Esszimmer + Küche", "dining_room"),
        ("Chambre d'amis", "bedroom"),
        ("Livng room", "living_room"),
        ("Wintergarten", "living_room"),
        ("Winter garden", "living_room"),
        ("Wohn-/Schlafzimmer", "living_room"),
        ("Pièce de vie", "living_room"),
        ("north bathroom (upper floor)", "bathroom"),
    ],
)
def test_of_several_words_those_count_that_say_what_it_is(name: str, type_name: str) -> None:
    meaning = NAMES.meaning(name)
    assert meaning is not None
    assert meaning.key == type_name


@every("name", ["", "room", "Room 12", "Loft", "Zimmer 3", "B1", "x", "Raum", "???", "部屋", "방 2", "ห้อง 3", "Кімната", "חדר", "flurble"])
def test_what_tells_nothing_is_not_understood(name: str) -> None:
    assert NAMES.meaning(name) is None


@every("name", ["Walk-in closet", "Treppenhaus", "Storage", "Keller", "кладовая"])
def test_rooms_that_we_have_no_type_for_are_none_of_ours(name: str) -> None:
    meaning = NAMES.meaning(name)
    assert meaning is not None
    assert meaning.key not in KNOWN.rooms


def test_every_type_is_called_by_its_own_name_and_no_word_stands_for_two() -> None:
    assert {name: NAMES.meaning(name) and NAMES.meaning(name).key for name in KNOWN.rooms if not name.startswith("garage_")} == {  # type: ignore[union-attr]
        name: name for name in KNOWN.rooms if not name.startswith("garage_")
    }
    meant: dict[str, set[str]] = {}
    for key, entry in KNOWN.room_names.items():
        for word in entry.known_as:
            meant.setdefault("".join(words_of(word)), set()).add(key)
    assert {word: keys for word, keys in meant.items() if len(keys) > 1 or not word} == {}


def test_words_of_ones_own_count(tmp_path: Path) -> None:
    (tmp_path / "room_names.yaml").write_text("kitchen: {known_as: [flurble]}\n")
    meaning = room_names_of(load_catalogs(tmp_path)).meaning("Flurble 2")
    assert meaning is not None
    assert meaning.key == "kitchen"


def test_a_room_type_that_is_none_is_refused_with_its_line(tmp_path: Path) -> None:
    (tmp_path / "room_names.yaml").write_text("kitchen: {known_as: [flurble]}\nkichen: {known_as: [cook]}\n")
    with pytest.raises(CatalogError, match=r"room_names\.yaml.*2.*kichen"):
        load_catalogs(tmp_path)


@every(
    ("name", "key"),
    [("Wohnen/Essen/Kochen", "living_room"), ("Bad/WC", "bathroom"), ("Kitchen & Dining", "kitchen"), ("Baño principal", "bathroom")],
)  # fmt: skip
def test_names_of_rooms_in_a_row_are_plain(name: str, key: str) -> None:
    assert NAMES.meaning(name) == (key, True)
    assert not NAMES.is_plain(f"{name} tiles")


def test_a_plain_name_is_one_whose_meaning_is_plain() -> None:
    said = [*KNOWN.room_names, *(word for entry in KNOWN.room_names.values() for word in entry.known_as)]
    said += [f"{one} {two}" for one, two in zip(said, said[7:], strict=False)] + [f"x{word}" for word in said] + ["", "7", "path 12"]
    meanings = {name: NAMES.meaning(name) for name in said}
    assert {name for name in said if NAMES.is_plain(name)} == {name for name, one in meanings.items() if one and one.plain}
    assert any(one and not one.plain for one in meanings.values())


@pytest.mark.parametrize("known", ["rooms", "pieces"])
def test_what_is_nearly_a_word_is_what_the_whole_list_says(known: str) -> None:
    """Words of other lengths are not looked at: none of them is ever the nearest."""
    by_length = NAMES._endings_by_length if known == "rooms" else synonyms_of(KNOWN)._by_length
    words, chance, told = sorted(word for some in by_length.values() for word in some), Random(known), 0
    for _ in range(60):
        letters = list(chance.choice(words))
        for _ in range(chance.randrange(4)):
            at = chance.randrange(len(letters) + 1)
            letters[at : at + chance.randrange(2)] = chance.choice(("", "e", "zi"))
        near = get_close_matches("".join(letters), words, 1, NEARLY)
        assert _close_to("".join(letters), by_length) == near
        told += bool(near)
    assert 0 < told < 60
