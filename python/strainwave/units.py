"""Units: mm and degrees outside, radians inside; angles also as degrees, minutes and seconds of arc."""

from __future__ import annotations

import math
import re

MICROMETRES_PER_MM = 1000.0
ARCSECONDS_PER_DEGREE = 3600.0
ARCSECONDS_PER_RADIAN = math.degrees(1.0) * ARCSECONDS_PER_DEGREE

_ANGLE = re.compile(
    r"^\s*(?P<sign>[+-]?)\s*(?P<degrees>[0-9]+(?:\.[0-9]+)?)\s*[°º]"
    r"(?:\s*(?P<minutes>[0-9]+(?:\.[0-9]+)?)\s*['′’]"
    r"(?:\s*(?P<seconds>[0-9]+(?:\.[0-9]+)?)\s*(?:[\"″”]|''))?)?\s*$"
)
_LONGEST_ANGLE = 64  # characters; far above any angle, far below what makes float() slow


def parse_angle(text: str) -> float:
    """Degrees from text such as 7°30'30", 8°24' or 12.5°.

    Only the last part may have a decimal fraction; minutes and seconds lie below 60. ValueError says what is allowed.
    """
    match = _ANGLE.match(text) if len(text) <= _LONGEST_ANGLE else None
    if match is None:
        raise ValueError('must be a number of degrees or text such as "7°30\'30\\""')
    parts = [part for part in match.group("degrees", "minutes", "seconds") if part is not None]
    if any("." in part for part in parts[:-1]):
        raise ValueError("may have a decimal fraction in its last part only")
    if any(float(part) >= 60.0 for part in parts[1:]):
        raise ValueError("must have minutes and seconds below 60")
    if len(parts) == 1:
        degrees = float(parts[0])
    else:  # one division at the end, so that 7°30' is exactly 7.5
        arcseconds = sum(float(part) * 60.0 ** (2 - place) for place, part in enumerate(parts))
        degrees = arcseconds / ARCSECONDS_PER_DEGREE
    return -degrees if match["sign"] == "-" else degrees


def format_angle(degrees: float) -> str:
    """Text for `degrees`: whole arcseconds where they say exactly the same in fewer characters, else decimal degrees.

    `parse_angle` reads it back to the last bit (a number that needs an exponent is for people only).
    """
    decimal = f"{degrees!r}°"
    minutes, second = divmod(round(abs(degrees) * ARCSECONDS_PER_DEGREE), 60)
    degree, minute = divmod(minutes, 60)
    text = f"{'-' if degrees < 0 else ''}{degree}°"
    if minute or second:
        text += f"{minute}'"
    if second:
        text += f'{second}"'
    return text if len(text) < len(decimal) and parse_angle(text) == degrees else decimal
