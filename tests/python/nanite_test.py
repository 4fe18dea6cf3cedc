#!/usr/bin/env python3
"""The model that `validate export nanite` writes: it has what nanite asks of a model's module, and its forces are those of the
sheets in sheet_curves.json, which were solved by shooting. usage: nanite_test.py VALIDATE"""
import importlib.util
import inspect
import json
import pathlib
import subprocess
import sys
import tempfile
import types

try:
    import numpy as np
except ImportError:
    sys.exit(77)

from suspended_curves import REFERENCE

try:
    import lmfit  # noqa: F401
except ImportError:
    class Parameters(dict):
        """As much of lmfit's as a model's module uses."""
        def add(self, name, **more):
            self[name] = more
    sys.modules["lmfit"] = types.SimpleNamespace(Parameters=Parameters)

faults = []
reference = json.loads(REFERENCE.read_text())
with tempfile.TemporaryDirectory() as name:
    for number, (tip, radius) in enumerate(sorted({(c["tip"], c["tip_radius_nm"]) for c in reference["curves"]})):
        file = pathlib.Path(name) / f"model{number}.py"
        done = subprocess.run([sys.argv[1], "export", "nanite", "--radius", f"{reference['radius_nm']} nm", "--nu",
                               str(reference["nu"]), "--tip", tip, "--tip-radius", f"{radius} nm", "--out", file],
                              capture_output=True, text=True)
        if done.returncode != 0:
            faults.append(f"{tip}: exit code {done.returncode}: {done.stderr}")
            continue
        spec = importlib.util.spec_from_file_location(file.stem, file)
        model = importlib.util.module_from_spec(spec)
        spec.loader.exec_module(model)
        keys = list(model.get_parameter_defaults())
        arguments = list(inspect.signature(model.model_func).parameters)
        if keys != model.parameter_keys or arguments[1:] != keys:
            faults.append(f"{tip}: parameters {keys}, {arguments}, {model.parameter_keys}")
        if not len(keys) == len(model.parameter_names) == len(model.parameter_units):
            faults.append(f"{tip}: names and units are not as many as the keys")
        for attribute in ("model_doc", "model_key", "model_name", "valid_axes_x", "valid_axes_y"):
            if not getattr(model, attribute, None):
                faults.append(f"{tip}: there is no {attribute}")
        for curve in reference["curves"]:
            if (curve["tip"], curve["tip_radius_nm"]) != (tip, radius):
                continue
            depth, force = 1e-9 * np.array(curve["depth_nm"]), 1e-9 * np.array(curve["force_nN"])
            found = model.model_func(2e-7 - depth, reference["Eh_N_per_m"], curve["pretension_N_per_m"], 2e-7, 1e-9) - 1e-9
            off = np.max(np.abs(found - force)) / np.max(force)
            if not off < 3e-4:
                faults.append(f"{tip} of {radius} nm, {curve['pretension_N_per_m']} N/m: forces are {off:.1e} of the largest off")
        out = model.model_func(np.array([3e-7]), 340.0, 0.1, 2e-7, 5e-9)
        if out[0] != 5e-9:
            faults.append(f"{tip}: before the contact the force is {out[0]}, not the baseline")
for fault in faults:
    print(fault)
sys.exit(1 if faults else 0)
