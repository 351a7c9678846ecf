# SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
"""From a recording to a picture: how far one drop has spread on each face, and how the stain grew.

    python3 recording_to_picture.py [recording.hygrorec] [picture.png]

Without a recording a drop is simulated first. With matplotlib the picture has axes and curves; without it, it is the map alone.
"""
# %% The recording
import pathlib
import struct
import sys
import zlib

import numpy as np

import hygroloom

examples = pathlib.Path(__file__).resolve().parent.parent
picture = pathlib.Path(sys.argv[2] if len(sys.argv) > 2 else "drop.png")
if len(sys.argv) > 1:
    ds = hygroloom.read_recording(sys.argv[1], cells=1)
else:
    run = hygroloom.simulate(examples / "one-drop-on-cotton.hygro", fidelity="live", recording="drop.hygrorec")
    ds = hygroloom.read_recording(run.recording, cells=1)

# %% What is in it: nothing of a frame is read yet
print(ds)

# %% The map at the end, g/m2; only the last frame is read
end = ds.water_map.isel(time=-1)
most = float(end.sel(side=["top", "bottom"]).max())
print(f"At {float(end.time):.3g} s the wettest cell holds {most:.0f} g/m2.")


# %% The picture
def write_png(path: pathlib.Path, shades: np.ndarray) -> None:
    """Shades of grey, 0 white to 1 black, the first row on top."""
    rows = (255 * (1 - np.clip(shades, 0, 1))).astype(np.uint8)
    lines = b"".join(b"\0" + row.tobytes() for row in rows)
    parts = [(b"IHDR", struct.pack(">IIBBBBB", rows.shape[1], rows.shape[0], 8, 0, 0, 0, 0)), (b"IDAT", zlib.compress(lines)), (b"IEND", b"")]
    chunks = [struct.pack(">I", len(body)) + name + body + struct.pack(">I", zlib.crc32(name + body)) for name, body in parts]
    path.write_bytes(b"\x89PNG\r\n\x1a\n" + b"".join(chunks))


try:
    import matplotlib

    matplotlib.use("Agg")
    from matplotlib import pyplot
except ImportError:
    sides = [end.sel(side=side).values[::-1] / max(most, 1e-9) for side in ("top", "bottom")]
    write_png(picture, np.kron(np.hstack(sides), np.ones((4, 4))))
else:
    figure, axes = pyplot.subplots(1, 3, figsize=(12, 4), layout="constrained")
    for axis, side in zip(axes, ("top", "bottom")):
        end.sel(side=side).plot(ax=axis, vmin=0, vmax=most, cmap="Blues")
    ds.wetted_radius_top_mm.plot(ax=axes[2], label="top")
    ds.wetted_radius_bottom_mm.plot(ax=axes[2], label="bottom")
    axes[2].legend()
    figure.savefig(picture)
print(f"Picture: {picture}")
