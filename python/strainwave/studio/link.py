"""A design in an address, so that a link reproduces it."""

from __future__ import annotations

import base64
import binascii
import zlib

from strainwave.design import Design, decode, dumps
from strainwave.design.reader import LARGEST_FILE_BYTES
from strainwave.errors import StrainwaveError

# An address may carry two, the design and its reference; servers and browsers take so much. The longest table of a wave
# generator's samples needs nearly as much.
LONGEST_CODE = 15_000
_DAMAGED = "The link is damaged: copy it once more, whole, or ask for the design file"


def design_code(design: Design) -> str | None:
    """The design file in the letters that an address may hold; None where it would be longer than `LONGEST_CODE`."""
    packed = base64.urlsafe_b64encode(zlib.compress(dumps(design).encode(), 9))
    code = packed.rstrip(b"=").decode("ascii")
    return code if len(code) <= LONGEST_CODE else None


def coded_design(code: str) -> Design:
    """The design that `design_code` put in a link. StrainwaveError where it is damaged, or holds no design."""
    if len(code) > LONGEST_CODE:
        raise StrainwaveError(f"The link holds {len(code)} characters; no design that a link can hold has so many")
    try:
        packed = base64.b64decode(code + "=" * (-len(code) % 4), altchars=b"-_", validate=True)
        unpacking = zlib.decompressobj()
        # A few letters can unpack to gigabytes.
        content = unpacking.decompress(packed, max_length=LARGEST_FILE_BYTES + 1)
    except (binascii.Error, ValueError, zlib.error):
        raise StrainwaveError(_DAMAGED) from None
    if len(content) <= LARGEST_FILE_BYTES and (not unpacking.eof or unpacking.unused_data):
        raise StrainwaveError(_DAMAGED)
    return decode(content, "the link")
