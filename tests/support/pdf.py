"""What is on the pages of a PDF file that Qt has written."""

import re
import zlib


def pages_of(pdf: bytes) -> int:
    return len(re.findall(rb"/Type\s*/Page\b", pdf))


_PLACED = re.compile(
    rb"(?P<scale>[\d.]+) 0 0 [\d.]+ (?P<left>[\d.]+) [\d.]+ cm\n"
    rb"|BT\n/F(?P<font>\d+) \S+ Tf \S+ \S+ \S+ \S+ 0 0 Tm\n(?P<x>\S+) (?P<run>.*?)ET\n",
    re.DOTALL,
)
PAGE_WIDTH = (210.0 - 2.0 * 18.0) / 25.4 * 1200.0
"""Between the margins, in the units that places are in."""


def content_of(pdf: bytes) -> bytes:
    """All that is painted on the pages."""
    streams = re.findall(rb"\nstream\r?\n(.*?)\r?\nendstream", pdf, re.DOTALL)
    return b"".join(
        zlib.decompressobj().decompress(stream) for stream in streams if stream[:1] == b"x"
    )


def printed(pdf: bytes) -> list[str]:
    """What is written on the pages, run by run: nothing beyond the right margin."""
    letters: dict[tuple[bytes, int], str] = {}
    fonts = rb"(\d+) 0 obj\s<< /Type /Font\s/Subtype /Type0.*?/ToUnicode (\d+)"
    for font, table in re.findall(fonts, pdf, re.DOTALL):
        found = re.search(rb"\n%b 0 obj.*?endcmap" % table, pdf, re.DOTALL)
        assert found is not None
        for first, codes in re.findall(rb"<(\w+)> <\w+> \[(.*?)\]", found[0]):
            for number, code in enumerate(re.findall(rb"\w+", codes), int(first, 16)):
                letters[font, number] = chr(int(code, 16))
    runs = []
    for stream in re.findall(rb"\nstream\r?\n(.*?)\r?\nendstream", pdf, re.DOTALL):
        if stream[:1] == b"x":  # deflated
            content = zlib.decompressobj().decompress(stream)
            scale = left = 0.0
            for place in _PLACED.finditer(content):
                if place["scale"]:
                    scale, left = float(place["scale"]), float(place["left"])
                    continue
                assert left + scale * float(place["x"]) < PAGE_WIDTH
                glyphs = re.findall(rb"<(\w+)> Tj", place["run"])
                text = "".join(letters[place["font"], int(glyph, 16)] for glyph in glyphs)
                runs.append(text.replace("\t", " "))  # which have one glyph
    return runs
