"""The pictures of a page, each once, within a budget."""

import base64
import io

from report import grids
from report.errors import BadInput

# Bytes of all pictures together, so that the page stays below 25 MB.
BUDGET = 21_000_000
JPEG_QUALITY = 86


def jpeg_bytes(file):
    """A JPEG as it is, any other picture as JPEG."""
    from PIL import Image, UnidentifiedImageError
    try:
        data = file.read_bytes()
        if data[:3] == b"\xff\xd8\xff":
            return data
        with Image.open(io.BytesIO(data)) as picture:
            out = io.BytesIO()
            picture.convert("RGB").save(out, "JPEG", quality=JPEG_QUALITY)
            return out.getvalue()
    except (OSError, UnidentifiedImageError) as error:
        raise BadInput(f"{file}: not a picture: {error}") from error


class Store:
    """Texts by id; a file that is asked for again is stored once."""

    def __init__(self, folder):
        self.folder = folder
        self.alphabet = grids.Alphabet()
        self.texts = {}
        self.names = {}
        self.sizes = {}
        self.size = 0

    def keep(self, name, text):
        """The id of a text, or None when the budget is spent."""
        if self.size + len(text) > BUDGET:
            return None
        self.size += len(text)
        key = f"b{len(self.texts)}"
        self.texts[key] = text
        self.names[name] = key
        return key

    def file(self, name):
        """A run's picture; BadInput when its name leads elsewhere."""
        path = self.folder / name
        if path.parent != self.folder:
            raise BadInput(f"{name}: a picture outside of {self.folder}")
        return path

    def picture(self, name):
        """The id of a picture, or None where there is none."""
        if not name or name in self.names:
            return self.names.get(name)
        file = self.file(name)
        if not file.exists():
            return None
        return self.keep(name, base64.b64encode(
            jpeg_bytes(file)).decode("ascii"))

    def grid(self, name):
        """(id, [columns, rows]) of a grid, or (None, None)."""
        if not name or not self.file(name).exists():
            return None, None
        if name not in self.names:
            grid = grids.read(self.file(name))
            key = self.keep(name, grids.pack(grid, self.alphabet))
            if key is None:
                return None, None
            self.sizes[name] = [grid["columns"], grid["rows"]]
        return self.names[name], self.sizes[name]

    def blobs(self):
        return list(self.texts.items())
