"""Reads the fields of solved sheets back with readers that know nothing of this project: meshio and h5py."""
import os
import subprocess
import sys
import tempfile
import xml.etree.ElementTree as xml

SKIPPED = 77
try:
    import h5py
    import meshio
    import numpy as np
except ImportError as missing:
    print(f"skipped: {missing}")
    sys.exit(SKIPPED)

validate = sys.argv[1]


def run(*words):
    folder = os.path.join(tempfile.mkdtemp(), "run")
    subprocess.run([validate, *words, "--out", folder, "--quiet"], check=True, stdout=subprocess.DEVNULL)
    return folder


def strain_of(flat, points, corners):
    """Green-Lagrange strain of every triangle from the positions alone, as matrices."""
    def edges(p):
        p = p[corners]
        return np.stack([p[:, 1] - p[:, 0], p[:, 2] - p[:, 0]], axis=2)

    F = edges(points) @ np.linalg.inv(edges(flat)[:, :2, :])
    return (np.swapaxes(F, 1, 2) @ F - np.eye(2)) / 2


def areas(points, corners):
    (x, y), (a, b, c) = points[:, :2].T, corners.T
    return 0.5 * ((x[b] - x[a]) * (y[c] - y[a]) - (x[c] - x[a]) * (y[b] - y[a]))


def check_sheet(vtu_file, fields, Eh, nu):
    """One sheet in both formats: the same numbers, and what they say of each other. No prestress."""
    vtu = meshio.read(vtu_file)
    corners = vtu.cells_dict["triangle"]
    flat = fields["nodes_A"][:].reshape(-1, 3)
    displacement = fields["at_nodes/displacement_A"][:].reshape(-1, 3)
    np.testing.assert_array_equal(fields["triangles"][:].reshape(-1, 3), corners)
    np.testing.assert_allclose(flat + displacement, vtu.points, rtol=0, atol=1e-12)
    for key, values in fields["at_triangles"].items():
        np.testing.assert_allclose(vtu.cell_data[key][0].ravel(), values[:], rtol=1e-14, err_msg=key)
        assert "meaning" in values.attrs and "unit" in values.attrs, key
    for key, values in fields["at_nodes"].items():
        np.testing.assert_allclose(vtu.point_data[key].ravel(), values[:], rtol=1e-14, err_msg=key)
    totals = {a.get("Name"): float(a.text) for a in xml.parse(vtu_file).iter("DataArray") if a.get("NumberOfTuples")}
    assert "energy_eV" in totals and "support_force_z_eV_per_A" in totals
    for key, value in totals.items():
        assert value == fields.attrs[key], key

    E = strain_of(flat, vtu.points, corners)
    np.testing.assert_allclose(np.stack([E[:, 0, 0], E[:, 1, 1], E[:, 0, 1]], axis=1), vtu.cell_data["strain"][0],
                               rtol=1e-8, atol=1e-9)  # under a point there are strains of 100
    principal, axes = np.linalg.eigh(E)
    E2, E1 = principal.T
    state = vtu.cell_data["state"][0].ravel()
    expected = np.where(E1 <= 0, 2, np.where(E2 + nu * E1 <= 0, 1, 0))
    clear = np.abs(E2 + nu * E1) > 1e-9
    np.testing.assert_array_equal(state[clear], expected[clear])

    # St Venant-Kirchhoff, relaxed: forces, their direction, energy; Cauchy stress where taut.
    taut = expected == 0
    S1 = Eh * np.where(taut, (E1 + nu * E2) / (1 - nu**2), np.maximum(E1, 0))
    S2 = np.where(taut, Eh * (E2 + nu * E1) / (1 - nu**2), 0)
    force_1, force_2 = (vtu.cell_data[f"force_{i}_eV_per_A2"][0].ravel() for i in (1, 2))
    np.testing.assert_allclose(force_1, S1, rtol=1e-7, atol=1e-9 * Eh)
    np.testing.assert_allclose(force_2, S2, rtol=1e-7, atol=1e-9 * Eh)
    apart = E1 - E2 > 1e-3
    along = np.abs(np.sum(vtu.cell_data["direction"][0][:, :2] * axes[:, :, 1], axis=1))
    np.testing.assert_allclose(along[apart], 1, atol=1e-9)
    area = areas(flat, corners)
    energy = fields.attrs["copies"] * np.sum(area * (S1 * E1 + S2 * E2)) / 2
    np.testing.assert_allclose(fields.attrs["energy_eV"], energy, rtol=1e-7)
    for key, number in (("wrinkled_area_fraction", 1), ("slack_area_fraction", 2)):
        np.testing.assert_allclose(fields.attrs[key], area[state == number].sum() / area.sum(), atol=1e-12)
    L1, L2 = 1 + 2 * E1, 1 + 2 * E2  # squares of the stretches
    L3 = 1 - nu / (1 - nu) * (L1 + L2 - 2)
    taut &= L3 > 0  # not so under a point
    for i, (L, S) in enumerate(((L1, S1), (L2, S2)), 1):
        cauchy = L * S / np.sqrt(L1 * L2 * L3, where=taut, out=np.ones_like(L)) / fields.attrs["thickness_A"]
        found = vtu.cell_data[f"cauchy_{i}_eV_per_A3"][0].ravel()
        np.testing.assert_allclose(found[taut], cauchy[taut], rtol=1e-7, atol=1e-9)
    return vtu, corners


# A bulge: the supports carry the pressure on the sheet's present outline.
folder = run("bulge", "--cells", "12")
with h5py.File(os.path.join(folder, "run.h5")) as file:
    fields = file["runs/0/fields/0"]
    vtu, corners = check_sheet(os.path.join(folder, "membrane-0.vtu"), fields, 5.864 * 1.37, 0.19)
    assert vtu.points.shape == (13 * 13, 3) and corners.shape == (2 * 12 * 12, 3)
    copies = fields.attrs["copies"]
    reaction = copies * vtu.point_data["reaction_eV_per_A"][:, 2].sum()
    pressure = file["runs/0/pressure_eV_per_A3"][0]
    np.testing.assert_allclose(reaction, pressure * copies * areas(vtu.points, corners).sum(), rtol=1e-6)

# An indentation: the rim carries the load to 1e-8, at every depth in the order of the path.
folder = run("indentation", "--models", "membrane", "--radius", "110", "--E", "5.864", "--thickness", "1.37", "--nu",
             "0.19", "--loads", "point,disc", "--depth-max", "12", "--depth-step", "4", "--all-fields")
with h5py.File(os.path.join(folder, "run.h5")) as file:
    for curve in file["runs"].values():
        name = f"membrane-{curve.attrs['load']}-{curve.attrs['constants']}"
        series = xml.parse(os.path.join(folder, name + ".pvd")).getroot().find("Collection")
        assert len(series) == len(curve["fields"]) == len(curve["force_eV_per_A"]) == 3
        for i, entry in enumerate(series):
            fields = curve[f"fields/{i}"]
            assert float(entry.get("timestep")) == fields.attrs["level"]
            vtu, corners = check_sheet(os.path.join(folder, entry.get("file")), fields, 5.864 * 1.37, 0.19)
            force = curve["force_eV_per_A"][i]
            reaction = fields.attrs["copies"] * vtu.point_data["reaction_eV_per_A"][:, 2].sum()
            np.testing.assert_allclose([reaction, fields.attrs["support_force_z_eV_per_A"]], force, rtol=1e-8)
            assert fields.attrs["thickness_A"] == 1.37 and fields.attrs["energy_eV"] == curve["energy_eV"][i]
            depth = -vtu.points[np.argmin(np.hypot(*vtu.points[:, :2].T)), 2]
            np.testing.assert_allclose(depth, curve["depth_A"][i], rtol=1e-12)
print("fields read back: positions, strains, states, forces, stresses, reactions, energies agree")
