"""Reads the fields of a solved sheet back with readers that know nothing of this project: meshio and h5py."""
import json
import os
import subprocess
import sys
import tempfile

SKIPPED = 77
try:
    import h5py
    import meshio
    import numpy as np
except ImportError as missing:
    print(f"skipped: {missing}")
    sys.exit(SKIPPED)

validate = sys.argv[1]
folder = os.path.join(tempfile.mkdtemp(), "run")
subprocess.run([validate, "bulge", "--cells", "12", "--out", folder, "--quiet"], check=True)

vtu = meshio.read(os.path.join(folder, "membrane-0.vtu"))
corners = vtu.cells_dict["triangle"]
assert vtu.points.shape == (13 * 13, 3) and corners.shape == (2 * 12 * 12, 3)

with h5py.File(os.path.join(folder, "run.h5")) as file:
    fields = file["fields/0"]
    flat = fields["nodes_A"][:].reshape(-1, 3)
    displacement = fields["at_nodes/displacement_A"][:].reshape(-1, 3)
    np.testing.assert_array_equal(fields["triangles"][:].reshape(-1, 3), corners)
    np.testing.assert_allclose(flat + displacement, vtu.points, rtol=0, atol=1e-12)
    for key, values in fields["at_triangles"].items():
        np.testing.assert_allclose(vtu.cell_data[key][0].ravel(), values[:], rtol=1e-14, err_msg=key)
        assert "meaning" in values.attrs and "unit" in values.attrs, key
    summary = json.loads(file.attrs["summary"])
    copies = fields.attrs["copies"]

# Green-Lagrange strain of every triangle from the positions alone.
def edges(points):
    p = points[corners]
    return np.stack([p[:, 1] - p[:, 0], p[:, 2] - p[:, 0]], axis=2)

F = edges(vtu.points) @ np.linalg.inv(edges(flat)[:, :2, :])
E = (np.swapaxes(F, 1, 2) @ F - np.eye(2)) / 2
strain = vtu.cell_data["strain"][0]
np.testing.assert_allclose(np.stack([E[:, 0, 0], E[:, 1, 1], E[:, 0, 1]], axis=1), strain, rtol=0, atol=1e-9)

# States follow from the strain: St Venant-Kirchhoff, nu = 0.19, no prestress.
principal = np.linalg.eigvalsh(E)
state = vtu.cell_data["state"][0].ravel()
clear = np.abs(principal[:, 0] + 0.19 * principal[:, 1]) > 1e-9
expected = np.where(principal[:, 1] <= 0, 2, np.where(principal[:, 0] + 0.19 * principal[:, 1] <= 0, 1, 0))
np.testing.assert_array_equal(state[clear], expected[clear])

# The supports carry the pressure on the sheet's present outline.
reaction = copies * vtu.point_data["reaction_eV_per_A"][:, 2].sum()
x, y = vtu.points[:, 0], vtu.points[:, 1]
a, b, c = corners.T
outline = copies * 0.5 * ((x[b] - x[a]) * (y[c] - y[a]) - (x[c] - x[a]) * (y[b] - y[a])).sum()
np.testing.assert_allclose(reaction, summary["case"]["pressures_eV_per_A3"][0] * outline, rtol=1e-6)
print("fields read back: positions, strains, states, reactions agree")
