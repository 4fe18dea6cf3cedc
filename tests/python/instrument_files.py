"""Writes force curves in the formats that `validate curve` reads, from their published layouts alone: nothing here comes from
the program. FILES lists for each file a function that makes its bytes, the calibration to give, and what must be read: the
points and kinds of the segments, and first, last and mean of each column."""
import io
import json
import math
import struct

K, SENSITIVITY = 0.05, 60e-9  # N/m, m/V
N_APPROACH, N_RETRACT = 40, 32


def signal(z_nm):
    """Deflection in V at a height above the contact in nm: bends by the depth below it."""
    return 0.1 + max(0.0, -z_nm) * 1e-9 / SENSITIVITY + 1e-4 * z_nm


def ramp(points, down):
    """Heights in nm from 300 to -200, or back."""
    heights = [300 - 500 * i / (points - 1) for i in range(points)]
    return heights if down else heights[::-1]


APPROACH, RETRACT = ramp(N_APPROACH, True), ramp(N_RETRACT, False)


def column(unit, approach, retract=()):
    values = list(approach) + list(retract)
    return {"unit": unit, "first": values[0], "last": values[-1], "mean": sum(values) / len(values)}


def cycle(names):
    """What must be read of the whole cycle."""
    every = {
        "height (piezo)": column("m", [1e-9 * z for z in APPROACH], [1e-9 * z for z in RETRACT]),
        "deflection": column("m", [SENSITIVITY * signal(z) for z in APPROACH], [SENSITIVITY * signal(z) for z in RETRACT]),
        "force": column("N", [K * SENSITIVITY * signal(z) for z in APPROACH], [K * SENSITIVITY * signal(z) for z in RETRACT]),
    }
    return {name: every[name] for name in names}


BOTH = [["approach", N_APPROACH], ["retract", N_RETRACT]]


# NanoScope: a header of lines that begin with a backslash, integers of 2 or 4 bytes, both ways from the contact outwards.
RAMP_V, Z_SENSITIVITY, FULL_V = 50.0, 10.0, 24.576


def nanoscope_raw(volts, size):
    return [round(v / FULL_V * 2 ** (8 * size)) for v in volts]


def nanoscope_volts(volts, size):
    return [r * FULL_V / 2 ** (8 * size) for r in nanoscope_raw(volts, size)]


def nanoscope(size, said=None, curves=1, points=None):
    n_app, n_ret = points or (N_APPROACH, N_RETRACT)
    offset = 4096
    app, ret = [signal(z) for z in ramp(n_app, True)], [signal(z) for z in ramp(n_ret, False)]
    code = {2: "h", 4: "i"}[size]
    data = b"".join(struct.pack(f"<{n_app + n_ret}{code}", *[r + c for r in nanoscope_raw(app, size)][::-1],
                                *[r + c for r in nanoscope_raw(ret, size)]) for c in range(curves))
    lines = ["\\*Force file list", "\\Version: 0x09400103", "\\Date: 02:15:07 PM Mon Jun 08 2015", "\\*Scanner list",
             f"\\@Sens. Zsens: V {Z_SENSITIVITY} nm/V", "\\*Ciao scan list", f"\\@Sens. DeflSens: V {SENSITIVITY * 1e9} nm/V",
             "\\*Ciao force list", "\\Forward vel.: 100.0", "\\*Ciao force image list", f"\\Data offset: {offset}",
             f"\\Data length: {len(data)}", f"\\Bytes/pixel: {said or size}", f"\\Samps/line: {n_ret} {n_app}",
             f"\\Spring Constant: {K}", '\\@4:Image Data: S [DeflectionError] "Deflection Error"',
             f"\\@4:Z scale: V [Sens. DeflSens] ({FULL_V / 2 ** (8 * size)} V/LSB) {FULL_V} V",
             f"\\@4:Ramp size: V [Sens. Zsens] (0.006713867 V/LSB) {RAMP_V} V", "\\*File list end", "\x1a"]
    header = "\r\n".join(lines).encode("latin-1")
    return header + b"\0" * (offset - len(header)) + data


def nanoscope_expected(size):
    d = [SENSITIVITY * v for v in nanoscope_volts([signal(z) for z in APPROACH + RETRACT], size)]
    length = 1e-9 * RAMP_V * Z_SENSITIVITY
    down = [-length * i / N_APPROACH for i in range(N_APPROACH)]
    up = [-length * (N_RETRACT - 1 - i) / N_RETRACT for i in range(N_RETRACT)]
    return {"deflection": column("m", d), "force": column("N", [K * x for x in d]), "height (piezo)": column("m", down, up)}


def nanoscope_text():
    """Columns of both ways beside each other, the shorter one ends in empty cells."""
    lines = ['"\\*Force file list"', f'"\\Spring Constant: {K}"', f'"\\@Sens. DeflSens: V {SENSITIVITY * 1e9} nm/V"',
             '"\\*File list end"', "", "Calc_Ramp_Ex_nm\tCalc_Ramp_Rt_nm\tDefl_V_Ex\tDefl_V_Rt"]
    for i in range(N_APPROACH):
        back = [f"{RETRACT[i]!r}", f"{signal(RETRACT[i])!r}"] if i < N_RETRACT else ["", ""]
        lines.append("\t".join([f"{APPROACH[i]!r}", back[0], f"{signal(APPROACH[i])!r}", back[1]]))
    return "\r\n".join(lines).encode()


# Nanosurf: INI sections in Latin-1, "#!", then the data sets in order.
def nanosurf():
    low, span, z_low, z_span = -10.0, 20.0, -1e-6, 2e-6
    sections, data, names = [], b"", []
    for group, (frame, heights) in enumerate((("Spec forward", APPROACH), ("Spec backward", RETRACT))):
        sets = [("Deflection", "V", low, span, [signal(z) for z in heights]), ("Z-Axis", "m", z_low, z_span, [1e-9 * z for z in heights])]
        names.append(f"Gr{group}-Name={frame}\r\nGr{group}-Count={len(sets)}")
        for channel, (name, unit, lowest, width, values) in enumerate(sets):
            names.append(f"Gr{group}-Ch{channel}=DataSet-{group}:{channel}")
            sections.append(f"[DataSet-{group}:{channel}]\r\nVersion=2\r\nPoints={len(values)}\r\nLines=1\r\nFrame={frame}\r\n"
                            f"SaveMode=Binary\r\nSaveBits=32\r\nSaveSign=Signed\r\nSaveOrder=Intel\r\nDim0Name=Z\r\nDim0Unit=m\r\n"
                            f"Dim0Range=5e-7\r\nDim0Min=0\r\nDim2Name={name}\r\nDim2Unit={unit}\r\nDim2Range={width}\r\nDim2Min={lowest}\r\n")
            data += struct.pack(f"<{len(values)}i", *[round((v - lowest) / width * 2**32) - 2**31 for v in values])
    head = "[DataSet]\r\nVersion=2\r\nGroupCount=2\r\n" + "\r\n".join(names) + "\r\n\r\n" + "\r\n".join(sections)
    head += (f"\r\n[DataSet\\Calibration\\Cantilever]\r\nPropCount=2\r\nProp0=D[{K}]*[N/m]\r\nProp1=D[{SENSITIVITY}]*[m/V]\r\n"
             "\r\n[DataSet-Info]\r\nDate=08-06-2015\r\nTime=14:15:07\r\n")
    return head.encode("latin-1") + b"\r\n\r\n#!" + data


def comma(value):
    return f"{value:.9g}".replace(".", ",")


NTMDT_A_PER_V = 1e-9  # so that the same signal is in nA


def ntmdt():
    """Height from the contact outwards; the approach beside it, read backwards; the first rows of the way back are padded."""
    heights = APPROACH[::-1]
    rows = []
    for i, z in enumerate(heights):
        back = signal(heights[3]) if i < 3 else signal(z)
        rows.append(f"{comma(z)}\t{comma(signal(z))}\t{comma(back)}")
    return "\r\n".join(rows).encode() + b"\r\n"


def ntmdt_expected():
    app = [float(f"{signal(z):.9g}") for z in APPROACH]
    ret = [float(f"{signal(z):.9g}") for z in APPROACH[::-1][3:]]
    h = [1e-9 * float(f"{z:.9g}") for z in APPROACH]
    return {"height (piezo)": column("m", h, h[::-1][3:]),
            "force": column("N", [K * SENSITIVITY * v for v in app], [K * SENSITIVITY * v for v in ret])}


def jpk_text():
    text = f"# xPosition: 1.5E-6\n# yPosition: -2.5E-6\n# springConstant: {K}\n# sensitivity: {SENSITIVITY}\n"
    for index, (kind, heights) in enumerate((("extend", APPROACH), ("retract", RETRACT))):
        text += (f"#\n# segmentIndex: {index}\n# segment: {kind}\n# columns: height vDeflection seriesTime\n# fancyNames: \"Height\" "
                 "\"Vertical deflection\" \"Series Time\"\n# units: m N s\n#\n")
        for i, z in enumerate(heights):
            text += f"{1e-9 * z!r} {K * SENSITIVITY * signal(z)!r} {0.001 * (i + index * N_APPROACH)!r}\n"
        text += "\n"
    return text.encode()


def igor(order, doubles):
    """Version 5 in either byte order; dimension 0 the points, dimension 1 the channels."""
    heights = APPROACH + RETRACT
    columns = [[-1e-9 * z for z in heights], [SENSITIVITY * signal(z) for z in heights]]
    data = b"".join(struct.pack(f"{order}{len(c)}{'d' if doubles else 'f'}", *c) for c in columns)
    note = f"SpringConstant: {K}\rInvOLS: {SENSITIVITY}\rIndexes: 0,{N_APPROACH},{len(heights) - 1}\rDirection: NaN,1,-1,\r".encode()
    labels = b"".join(name.ljust(32, b"\0") for name in (b"", b"Raw", b"Defl"))
    head = bytearray(384)
    struct.pack_into(f"{order}h", head, 0, 5)
    struct.pack_into(f"{order}3i", head, 4, 320 + len(data), 0, len(note))
    struct.pack_into(f"{order}4i", head, 36, 0, len(labels), 0, 0)
    struct.pack_into(f"{order}ih", head, 76, 2 * len(heights), 4 if doubles else 2)
    struct.pack_into(f"{order}4i", head, 132, len(heights), 2, 0, 0)
    struct.pack_into(f"{order}d", head, 148, 5e-4)
    total = sum(struct.unpack(f"{order}192H", bytes(head))) & 0xFFFF
    struct.pack_into(f"{order}H", head, 2, (-total) & 0xFFFF)
    return bytes(head) + data + note + labels


def igor_expected():
    return cycle(["height (piezo)", "deflection", "force"])


# Tables as people make them: depth and force of one approach.
DEPTHS = [2.5 * i for i in range(30)]  # nm
FORCES = [0.4 * d + 0.001 * d**3 for d in DEPTHS]  # nN
TABLE = {"depth": column("m", [1e-9 * d for d in DEPTHS]), "force": column("N", [1e-9 * f for f in FORCES])}
ONE_WAY = [["approach", len(DEPTHS)]]


def table(header, separator=",", number=repr, rows=None, end="\n"):
    lines = list(header) + [separator.join(number(v) for v in row) for row in (rows or zip(DEPTHS, FORCES))]
    return (end.join(lines) + end)


def decimal_comma(value):
    return repr(value).replace(".", ",")


def cycle_table():
    rows = [(z, K * SENSITIVITY * 1e9 * signal(z)) for z in APPROACH + RETRACT]
    return table(["height (nm),force (nN)"], rows=rows).encode()


def h5(units_in_names):
    import h5py
    buffer = io.BytesIO()
    with h5py.File(buffer, "w") as file:
        for index in (10, 2):  # sorted as numbers
            group = file.create_group(f"curves/{index}")
            group.attrs["spring constant"] = K
            for name, unit, values in (("height (piezo)", "nm", APPROACH + RETRACT),
                                       ("force", "pN", [index * K * SENSITIVITY * 1e12 * signal(z) for z in APPROACH + RETRACT])):
                data = group.create_dataset(f"{name}_{unit}" if units_in_names else name, data=values, compression="gzip")
                if not units_in_names:
                    data.attrs["unit"] = unit
            group.create_dataset("segment", data=[0] * N_APPROACH + [1] * N_RETRACT)
    return buffer.getvalue()


def tab():
    meta = json.dumps({"spring constant": K, "sensitivity": SENSITIVITY, "imaging mode": "force-distance", "enum": 7}, indent=2)
    lines = ["# afmformats 0.18.0", "#", "# BEGIN METADATA", *("# " + line for line in meta.splitlines()), "# END METADATA", "#",
             "# force\theight (piezo)\tsegment"]
    for s, heights in ((0, APPROACH), (1, RETRACT)):
        lines += [f"{K * SENSITIVITY * signal(z):.8g}\t{1e-9 * z:.8g}\t{s}" for z in heights]
    return "\r\n".join(lines).encode()


FORCE_AND_HEIGHT = cycle(["height (piezo)", "force"])
FILES = {
    "nanoscope2.spm": (lambda: nanoscope(2), {}, BOTH, nanoscope_expected(2)),
    "nanoscope4.000": (lambda: nanoscope(4, said=2), {}, BOTH, nanoscope_expected(4)),
    "nanoscope.txt": (nanoscope_text, {}, BOTH, cycle(["height (piezo)", "deflection", "force"])),
    "nanosurf.nid": (nanosurf, {}, BOTH, cycle(["height (piezo)", "deflection", "force"])),
    "ntmdt.txt": (ntmdt, {"--spring-constant": K, "--sensitivity": SENSITIVITY / NTMDT_A_PER_V},
                  [["approach", N_APPROACH], ["retract", N_APPROACH - 3]], ntmdt_expected()),
    "jpk.txt": (jpk_text, {}, BOTH, FORCE_AND_HEIGHT),
    "little.ibw": (lambda: igor("<", False), {}, BOTH, igor_expected()),
    "big.ibw": (lambda: igor(">", True), {}, BOTH, igor_expected()),
    "afmformats.tab": (tab, {}, BOTH, FORCE_AND_HEIGHT),
    "cycle.csv": (cycle_table, {}, BOTH, FORCE_AND_HEIGHT),
    "plain.csv": (lambda: table(["depth_nm,force_nN"]).encode(), {}, ONE_WAY, TABLE),
    "bom.csv": (lambda: b"\xef\xbb\xbf" + table(["Depth (nm),Force (nN)"], end="\r\n").encode(), {}, ONE_WAY, TABLE),
    "utf16.txt": (lambda: b"\xff\xfe" + table(["Depth [nm]\tForce [nN]"], "\t").encode("utf-16-le"), {}, ONE_WAY, TABLE),
    "comma.csv": (lambda: table(["Depth (nm);Force (nN)"], ";", decimal_comma).encode(), {}, ONE_WAY, TABLE),
    "comma.txt": (lambda: table(["Depth_nm\tForce_nN"], "\t", decimal_comma).encode(), {}, ONE_WAY, TABLE),
    "latin.csv": (lambda: table(["Depth (\u00b5m),Force (\u00b5N)"], rows=[(d / 1e3, f / 1e3) for d, f in zip(DEPTHS, FORCES)]
                                ).encode("latin-1"), {}, ONE_WAY, TABLE),
    "units.csv": (lambda: table(["Instrument: X-1", "Indentation;Load", "nm;nN"], ";").encode(), {}, ONE_WAY, TABLE),
    "comment.dat": (lambda: table(["# made by numpy", "# depth_nm force_nN"], " ").encode(), {}, ONE_WAY, TABLE),
    "trailing.csv": (lambda: table(["depth_nm,force_nN,"], rows=None).replace("\n", ",\n").replace("nN,,", "nN,").encode(), {},
                     ONE_WAY, TABLE),
}
SEVERAL = {"own.h5": lambda: h5(False), "names.h5": lambda: h5(True)}


def close(value, wanted):
    return value is not None and math.isclose(value, wanted, rel_tol=2e-7, abs_tol=2e-16)
