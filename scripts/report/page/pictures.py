"""The pictures of a page, each once, within a budget."""

import base64
import io

from report import grids
from report.errors import BadInput

# Bytes of all pictures together, so that the page stays below 25 MB.
BUDGET = 21_000_000
QUALITY = {"reference": 78, "flip": 45}


def encode(picture, quality):
    """(media type, bytes), WebP where Pillow knows it."""
    from PIL import features
    out = io.BytesIO()
    kind = "webp" if features.check("webp") else "jpeg"
    picture.convert("RGB").save(out, kind, quality=quality)
    return f"image/{kind}", out.getvalue()


def shrunk(file, role):
    """A picture as a data URL without `data:`, as it is where that is less."""
    from PIL import Image, UnidentifiedImageError
    try:
        data = file.read_bytes()
        with Image.open(io.BytesIO(data)) as picture:
            kind, small = encode(picture, QUALITY[role])
            if picture.format == "JPEG" and len(data) < len(small):
                kind, small = "image/jpeg", data
    except (OSError, UnidentifiedImageError) as error:
        raise BadInput(f"{file}: not a picture: {error}") from error
    return f"{kind};base64,{base64.b64encode(small).decode('ascii')}"


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

    def picture(self, name, role):
        """The id of a picture, or None where there is none."""
        if not name or name in self.names:
            return self.names.get(name)
        file = self.file(name)
        if not file.exists():
            return None
        return self.keep(name, shrunk(file, role))

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
