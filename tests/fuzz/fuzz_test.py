#!/ usr / bin / env python3
"""Damages the instruments' files of the tests, those of the independent writer among them, for a while each.
usage: fuzz_test.py INSTRUMENTS_FUZZ DATA_FOLDER SECONDS [NAME...]"""
import pathlib
import shutil
import subprocess
import sys
import tempfile

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "python"))
import instrument_files as files

fuzz, data, seconds, *names = sys.argv[1:]
with tempfile.TemporaryDirectory() as name:
    folder = pathlib.Path(name)
    for file in pathlib.Path(data).glob("fmt-*"):
        shutil.copy(file, folder)
    for name, (make, *_) in files.FILES.items():
        (folder / name).write_bytes(make())
    try:
        for name, make in files.SEVERAL.items():
            (folder / name).write_bytes(make())
    except ImportError:
        print("no h5py: HDF5 is left out")
    (folder / "curves.csv").write_text("# title: force-depth curves of validate\nrun,model,load,constants,depth_A,force_eV_per_A\n"
                                       + "".join(f"{r},membrane,disc,card,{i},{i * i}\n" for r in (0, 1) for i in range(20)))
    sys.exit(subprocess.run([fuzz, folder, seconds, *names]).returncode)
