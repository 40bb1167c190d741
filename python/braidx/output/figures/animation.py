"""The bending of a rope as an animated picture."""

from __future__ import annotations

from collections.abc import Sequence
from io import BytesIO
from pathlib import Path

import numpy as np
from PIL import Image, ImageDraw, ImageFont

from braidx.output.figures.bent import aslant_view, bent_image
from braidx.output.snapshot import Snapshot

WIDTH = 800  # pixels
_MOST_BYTES = 3_000_000
_MOST_FRAMES = 60
_TITLE = 34  # pixels kept free above the picture


def draw_bending_movie(
    snapshots: Sequence[Snapshot], path: Path, seconds: float = 4.0, width: int | None = None
) -> Path:
    """One frame per snapshot, all in the same view, as a GIF of at most 3 MB that repeats for ever.

    Of more than 60 snapshots 60 are shown, evenly chosen. Colours and size are reduced as far as
    the size of the file asks for.

    Args:
        snapshots: States in the order of the run, two or more.
        path: File name ending in .gif.
        seconds: How long all frames take together; the last one stays a second longer.
        width: Of the picture, pixels; WIDTH if None.
    Raises:
        ValueError: If there are fewer than two snapshots.
    """
    if len(snapshots) < 2:
        raise ValueError(f"animation: {len(snapshots)} snapshot(s); give two or more.")
    chosen = np.unique(np.linspace(0, len(snapshots) - 1, _MOST_FRAMES).round().astype(int))
    shown = [snapshots[i] for i in chosen]
    view = aslant_view(shown, width or WIDTH)
    frames = [_frame(snapshot, bent_image(snapshot, view)) for snapshot in shown]
    times = [int(1000 * seconds / len(frames))] * len(frames)
    times[-1] += 1000
    for colours, scale in ((128, 1.0), (64, 1.0), (48, 0.8), (32, 0.6)):
        data = _encoded(frames, times, colours, scale)
        if len(data) <= _MOST_BYTES:
            break
    part = path.with_name(path.name + ".part")
    part.write_bytes(data)
    part.replace(path)
    return path


def _frame(snapshot: Snapshot, picture: np.ndarray) -> Image.Image:
    """A picture on white under the name of its state."""
    on_white = picture[..., :3] * picture[..., 3:] + (1.0 - picture[..., 3:])
    rows, columns, _ = on_white.shape
    page = Image.new("RGB", (columns, rows + _TITLE), "white")
    page.paste(Image.fromarray((255 * on_white + 0.5).astype(np.uint8)), (0, _TITLE))
    font = ImageFont.load_default(18)
    ImageDraw.Draw(page).text((10, 6), snapshot.state, fill="#23272e", font=font)
    return page


def _encoded(frames: list[Image.Image], times: list[int], colours: int, scale: float) -> bytes:
    """The GIF, all frames in one palette, taken from the last frame."""
    size = (int(frames[0].width * scale), int(frames[0].height * scale))
    resized = [frame.resize(size, Image.Resampling.LANCZOS) for frame in frames]
    palette = resized[-1].quantize(colours)
    coded = [f.quantize(palette=palette, dither=Image.Dither.NONE) for f in resized]
    stream = BytesIO()
    coded[0].save(
        stream,
        "GIF",
        save_all=True,
        append_images=coded[1:],
        duration=times,
        loop=0,
        optimize=False,
    )
    return stream.getvalue()
