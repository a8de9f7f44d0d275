"""Recordings: formats read and written, and the commands convert, check and sample."""

from __future__ import annotations

import subprocess
import sys

import numpy as np
import pytest
import qtraj
from conftest import SOURCE
from orientations import angle_between, walk
from qtraj import recordings
from qtraj.recordings import Recording, RecordingError

DATA = SOURCE / "examples" / "data"
STAMPS = 1403715273262142976 + np.arange(20) * 5000000


@pytest.fixture
def recording(rng):
    return Recording(qtraj.seconds_from_ns(STAMPS), walk(rng, 20), positions=rng.normal(size=(20, 3)), nanoseconds=STAMPS)


@pytest.mark.parametrize("suffix", ["tum", "csv", "parquet", "aem", "euroc", "kitti"])
def test_what_is_written_is_read_back_bit_for_bit(suffix, recording, tmp_path):
    if suffix == "parquet":
        pytest.importorskip("pyarrow")
    path = tmp_path / f"file.{suffix}"
    recordings.write(path, recording, format=suffix)
    assert [p.name for p in tmp_path.iterdir()] == [path.name]
    settings = {}
    if suffix == "kitti":
        settings["times"] = tmp_path / "times.txt"
        settings["times"].write_text("\n".join(map(repr, recording.times.tolist())))
    back = recordings.read(path, **settings)
    if suffix == "kitti":
        assert angle_between(back.q, recording.q).max() < 1e-14
    else:
        np.testing.assert_array_equal(back.q, recording.q)
    if suffix != "aem":
        np.testing.assert_array_equal(back.positions, recording.positions)
    if suffix in ("csv", "parquet", "aem", "euroc"):
        np.testing.assert_array_equal(back.nanoseconds, STAMPS)
        np.testing.assert_array_equal(back.times, recording.times)
    if suffix == "tum":
        assert "1403715273.262142976 " in path.read_text()


def test_recordings_of_the_examples():
    tum = recordings.read(DATA / "tum_fr1_xyz.tum")
    assert len(tum) == 3000 and tum.positions.shape == (3000, 3) and tum.nanoseconds is None
    first = next(line for line in (DATA / "tum_fr1_xyz.tum").read_text().splitlines() if not line.startswith("#")).split()
    np.testing.assert_array_equal(tum.q[0], np.array([first[7], *first[4:7]], dtype=float))
    cassini = recordings.read(DATA / "cassini_turn.csv", conjugate=True)
    plain = recordings.read(DATA / "cassini_turn.csv")
    np.testing.assert_array_equal(cassini.q, plain.q * [1, -1, -1, -1])
    assert len(qtraj.Trajectory(cassini.times, cassini.q)) == 2428


@pytest.mark.parametrize(
    ("text", "q", "positions"),
    [
        ("t,qw,qx,qy,qz\n1,1,2,3,4\n", [1, 2, 3, 4], None),
        ("qx;qy;qz;qw;time\n2;3;4;1;1\n", [1, 2, 3, 4], None),
        ("z\ty\tx\tw\ttimestamp\n4\t3\t2\t1\t1\n", [1, 2, 3, 4], None),
        ("time [s], Q_W, Q_X, Q_Y, Q_Z, X, Y, Z\n1, 1, 2, 3, 4, 7, 8, 9\n", [1, 2, 3, 4], [7, 8, 9]),
        ('"t","px","py","pz","w","x","y","z"\n1,7,8,9,1,2,3,4\n', [1, 2, 3, 4], [7, 8, 9]),
        ("t qw qx qy qz note\n1 1 2 3 4 5\n", [1, 2, 3, 4], None),
    ],
)
def test_columns_are_found_by_name(text, q, positions, tmp_path):
    (tmp_path / "a.csv").write_text(text)
    found = recordings.read(tmp_path / "a.csv")
    assert found.times.tolist() == [1.0] and found.q.tolist() == [q]
    assert (found.positions is None) if positions is None else found.positions.tolist() == [positions]


def test_an_order_that_nothing_says_must_be_given(tmp_path):
    (tmp_path / "a.csv").write_text("0 1 2 3 4\n1 1e0 2 3 4\n")
    with pytest.raises(RecordingError, match="a.csv:1: no names of columns: say order='wxyz' or 'xyzw'"):
        recordings.read(tmp_path / "a.csv")
    assert recordings.read(tmp_path / "a.csv", order="wxyz").q[0].tolist() == [1, 2, 3, 4]
    assert recordings.read(tmp_path / "a.csv", order="xyzw").q[0].tolist() == [4, 1, 2, 3]
    with pytest.raises(ValueError, match="order='zyxw'"):
        recordings.read(tmp_path / "a.csv", order="zyxw")


@pytest.mark.parametrize(
    ("name", "text", "message"),
    [
        ("a.csv", "t,qw,qx,qy,qz\n1,1,2,3,4\n2,1,x,3,4\n", "a.csv:3: could not convert"),
        ("a.csv", "t,qw,qx,qy,qz\n1,1,2\n", "a.csv:2: 3 columns; 5 are needed"),
        ("a.csv", "t,a,b,c,d\n", "a.csv:1: no columns of a quaternion"),
        ("a.csv", "qw,qx,qy,qz\n", "a.csv:1: no column of times"),
        ("a.csv", "t_ns,qw,qx,qy,qz\n1.5,1,0,0,0\n", "a.csv:2: '1.5' is no whole number"),
        ("a.csv", "", "the file is empty"),
        ("a.tum", "1 2 3\n", "a.tum:1: 3 columns; 8 are needed"),
        ("a.kitti", "1 0 0 0 0 1 0 0 0 0 1 0\n", "--times"),
        ("a.aem", "META_START\n", "no CCSDS_AEM_VERS"),
        ("a.bin", b"\xff\xfe\x00", "this is no text"),
    ],
)
def test_faults_name_file_and_line(name, text, message, tmp_path):
    (tmp_path / name).write_bytes(text if isinstance(text, bytes) else text.encode())
    with pytest.raises(RecordingError, match=message):
        recordings.read(tmp_path / name)


AEM = """CCSDS_AEM_VERS = {version}
ORIGINATOR = X
META_START
OBJECT_NAME = ONE
REF_FRAME_A = {a}
REF_FRAME_B = {b}
{direction}TIME_SYSTEM = UTC
ATTITUDE_TYPE = QUATERNION
{order}META_STOP
COMMENT a quarter turn about z
DATA_START
2026-12-01T00:00:00.000000001 {numbers}
2026-335T00:00:01 {numbers}
DATA_STOP
"""


@pytest.mark.parametrize(
    ("version", "a", "b", "direction", "order", "numbers", "sign"),
    [
        ("2.0", "EME2000", "SC_BODY_1", "", "", "0 0 0.6 0.8", 1),
        ("2.0", "SC_BODY_1", "EME2000", "", "", "0 0 0.6 0.8", -1),
        ("1.0", "EME2000", "SC_BODY", "A2B", "LAST", "0 0 0.6 0.8", 1),
        ("1.0", "EME2000", "SC_BODY", "B2A", "LAST", "0 0 0.6 0.8", -1),
        ("1.0", "SC_BODY", "EME2000", "B2A", "FIRST", "0.8 0 0 0.6", 1),
        ("1.0", "SC_BODY", "EME2000", "A2B", "FIRST", "0.8 0 0 0.6", -1),
    ],
)
def test_attitude_messages_say_which_way_and_where_the_scalar_is(version, a, b, direction, order, numbers, sign, tmp_path):
    """The spacecraft's x axis, seen from the inertial frame, is turned towards y where the rotation from it to the body is."""
    text = AEM.format(version=version, a=a, b=b, numbers=numbers,
                      direction=f"ATTITUDE_DIR = {direction}\n" if direction else "", order=f"QUATERNION_TYPE = {order}\n" if order else "")
    (tmp_path / "a.aem").write_text(text)
    found = recordings.read(tmp_path / "a.aem")
    np.testing.assert_allclose(found.q, [[0.8, 0, 0, 0.6 * sign]] * 2)
    np.testing.assert_allclose(qtraj.rotate(found.q[0], [1, 0, 0]), [0.28, 0.96 * sign, 0], atol=1e-15)
    assert np.diff(found.nanoseconds).tolist() == [10**9 - 1] and found.name == "ONE"
    assert str(found.nanoseconds.view("datetime64[ns]")[0]) == "2026-12-01T00:00:00.000000001"


def test_attitude_messages_that_leave_something_open_are_refused(tmp_path):
    whole = AEM.format(version="2.0", a="EME2000", b="SC_BODY_1", direction="", order="", numbers="0 0 0.6 0.8")
    for old, new, message in (
        ("SC_BODY_1", "LVLH", "which one is the body"),
        ("QUATERNION\n", "EULER_ANGLE\n", "ATTITUDE_TYPE is EULER_ANGLE"),
        ("335T00:00:01", "335T23:59:60", "leap second"),
        ("2026-335T00:00:01", "yesterday", "no epoch"),
        ("= 2.0", "= 1.0", "QUATERNION_TYPE is missing"),
    ):
        (tmp_path / "a.aem").write_text(whole.replace(old, new))
        with pytest.raises(RecordingError, match=message):
            recordings.read(tmp_path / "a.aem")
    two = whole + whole.split("\n", 2)[2].replace("ONE", "TWO")
    (tmp_path / "a.aem").write_text(two)
    with pytest.raises(RecordingError, match="2 tracks: say which, of 'ONE', 'TWO'"):
        recordings.read(tmp_path / "a.aem")
    assert recordings.read(tmp_path / "a.aem", track="TWO").name == "TWO"


def test_bags_and_mcap(recording, tmp_path):
    rosbag2 = pytest.importorskip("rosbags.rosbag2")
    from rosbags.typesys import Stores, get_typestore

    store = get_typestore(Stores.ROS2_HUMBLE)
    kinds = store.types
    message = lambda name: kinds[f"{name}"]  # noqa: E731
    header = lambda ns: message("std_msgs/msg/Header")(message("builtin_interfaces/msg/Time")(sec=ns // 10**9, nanosec=ns % 10**9), "map")  # noqa: E731
    vector = lambda kind, p: message(f"geometry_msgs/msg/{kind}")(x=p[0], y=p[1], z=p[2])  # noqa: E731
    turn = lambda q: message("geometry_msgs/msg/Quaternion")(x=q[1], y=q[2], z=q[3], w=q[0])  # noqa: E731
    for plugin, folder in ((rosbag2.StoragePlugin.SQLITE3, "bag"), (rosbag2.StoragePlugin.MCAP, "mcap")):
        with rosbag2.Writer(tmp_path / folder, version=9, storage_plugin=plugin) as writer:
            poses = writer.add_connection("/pose", "geometry_msgs/msg/PoseStamped", typestore=store)
            frames = writer.add_connection("/tf", "tf2_msgs/msg/TFMessage", typestore=store)
            for ns, q, p in zip(recording.nanoseconds.tolist(), recording.q.tolist(), recording.positions.tolist(), strict=True):
                pose = message("geometry_msgs/msg/PoseStamped")(header(ns), message("geometry_msgs/msg/Pose")(vector("Point", p), turn(q)))
                writer.write(poses, ns, store.serialize_cdr(pose, poses.msgtype))
                transform = message("geometry_msgs/msg/TransformStamped")(
                    header(ns), "base", message("geometry_msgs/msg/Transform")(vector("Vector3", p), turn(q)))
                writer.write(frames, ns, store.serialize_cdr(message("tf2_msgs/msg/TFMessage")([transform]), frames.msgtype))
        with pytest.raises(RecordingError, match="2 tracks: say which, of '/pose', '/tf:base'"):
            recordings.read(tmp_path / folder)
        for track in ("/pose", "base"):
            found = recordings.read(tmp_path / folder, track=track)
            np.testing.assert_array_equal(found.q, recording.q)
            np.testing.assert_array_equal(found.positions, recording.positions)
            np.testing.assert_array_equal(found.nanoseconds, STAMPS)
    (file,) = (tmp_path / "mcap").glob("*.mcap")
    np.testing.assert_array_equal(recordings.read(file, track="/pose").q, recording.q)


@pytest.mark.parametrize("interpolation", ["LINEAR", "STEP", "CUBICSPLINE"])
@pytest.mark.parametrize("suffix", ["gltf", "glb"])
def test_animations_of_gltf(interpolation, suffix, rng, tmp_path):
    library = pytest.importorskip("pygltflib")
    times, q = np.arange(4, dtype="<f4"), walk(rng, 4).astype("<f4")
    tangents = rng.normal(size=(2, 4, 4)).astype("<f4")
    xyzw = q[:, [1, 2, 3, 0]]
    if interpolation == "CUBICSPLINE":
        xyzw = np.stack([tangents[0][:, [1, 2, 3, 0]], xyzw, tangents[1][:, [1, 2, 3, 0]]], axis=1).reshape(-1, 4)
    blob = times.tobytes() + np.ascontiguousarray(xyzw).tobytes()
    document = library.GLTF2(
        nodes=[library.Node(name="arm")],
        buffers=[library.Buffer(byteLength=len(blob))],
        bufferViews=[library.BufferView(buffer=0, byteOffset=0, byteLength=16), library.BufferView(buffer=0, byteOffset=16, byteLength=len(blob) - 16)],
        accessors=[library.Accessor(bufferView=0, componentType=5126, count=4, type="SCALAR"), library.Accessor(bufferView=1, componentType=5126, count=len(xyzw), type="VEC4")],
        animations=[library.Animation(name="wave", samplers=[library.AnimationSampler(input=0, output=1, interpolation=interpolation)],
                                      channels=[library.AnimationChannel(sampler=0, target=library.AnimationChannelTarget(node=0, path="rotation"))])],
    )
    document.set_binary_blob(blob)
    if suffix == "gltf":
        document.convert_buffers(library.BufferFormat.DATAURI)
    document.save(str(tmp_path / f"a.{suffix}"))
    found = recordings.read(tmp_path / f"a.{suffix}")
    assert found.name == "wave:arm" and found.method == {"LINEAR": "slerp", "STEP": "step", "CUBICSPLINE": "quaternion_hermite"}[interpolation]
    np.testing.assert_array_equal(found.q, q.astype(float))
    if interpolation == "CUBICSPLINE":
        np.testing.assert_array_equal(found.tangents[0], tangents[0].astype(float))
        curve = qtraj.Trajectory(found.times, found.q, found.method, tangents=found.tangents)
        np.testing.assert_allclose(curve.unnormalized([1.0, 2.0]).dp, tangents[1][[1, 2]], atol=1e-6)
    out = run("sample", tmp_path / f"a.{suffix}", "-", "--rate", "10", "--to", "csv")
    assert out.returncode == 0 and len(out.stdout.splitlines()) == 32


@pytest.mark.parametrize(("code", "kind"), [(5120, "i1"), (5121, "u1"), (5122, "<i2"), (5123, "<u2")])
def test_whole_numbers_of_gltf_are_fractions(code, kind, tmp_path):
    library = pytest.importorskip("pygltflib")
    largest = np.iinfo(kind).max
    xyzw = np.array([[0, 0, 0, largest], [largest, 0, 0, 0]], kind)
    stride = 4 * xyzw.itemsize
    blob = np.arange(2, dtype="<f4").tobytes() + xyzw.tobytes()
    document = library.GLTF2(
        nodes=[library.Node()],
        buffers=[library.Buffer(byteLength=len(blob))],
        bufferViews=[library.BufferView(buffer=0, byteLength=8), library.BufferView(buffer=0, byteOffset=8, byteLength=2 * stride, byteStride=stride)],
        accessors=[library.Accessor(bufferView=0, componentType=5126, count=2, type="SCALAR"),
                   library.Accessor(bufferView=1, componentType=code, normalized=True, count=2, type="VEC4")],
        animations=[library.Animation(samplers=[library.AnimationSampler(input=0, output=1)],
                                      channels=[library.AnimationChannel(sampler=0, target=library.AnimationChannelTarget(node=0, path="rotation"))])],
    )
    document.set_binary_blob(blob)
    document.save(str(tmp_path / "a.glb"))
    found = recordings.read(tmp_path / "a.glb")
    assert found.name == "0:0" and found.method == "slerp"
    np.testing.assert_array_equal(found.q, [[1, 0, 0, 0], [0, 1, 0, 0]])
    document.accessors[1].count = 3
    document.save(str(tmp_path / "b.glb"))
    with pytest.raises(RecordingError, match="reaches past the end|2 times for 3"):
        recordings.read(tmp_path / "b.glb")


def test_kernels_of_spice(rng, tmp_path):
    spice = pytest.importorskip("spiceypy")
    path, ticks, c_matrix = tmp_path / "a.bc", np.arange(5.0) * 256, walk(rng, 5)
    omega = rng.normal(size=(5, 3))
    handle = spice.ckopn(str(path), "TEST", 0)
    spice.ckw03(handle, ticks[0], ticks[-1], -82000, "J2000", True, "TEST", 5, ticks, c_matrix, omega, 1, [ticks[0]])
    spice.ckcls(handle)
    found = recordings.read(path)
    assert found.name == "-82000" and found.frame == "world"
    np.testing.assert_array_equal(found.times, ticks)
    np.testing.assert_array_equal(found.omega, omega)
    # SPICE's own matrix takes the base frame to the body
    for k in range(5):
        matrix = spice.q2m(c_matrix[k])
        np.testing.assert_allclose(qtraj.matrix_from_q(found.q[k]), matrix.T, atol=1e-15)


def test_packages_that_are_missing_say_what_to_install(tmp_path, monkeypatch):
    for module, suffix, extra in (("rosbags.highlevel", "bag", "ros"), ("pygltflib", "glb", "gltf"), ("spiceypy", "bc", "spice"), ("pyarrow.parquet", "parquet", "arrow")):
        monkeypatch.setitem(sys.modules, module, None)
        (tmp_path / f"a.{suffix}").write_bytes(b"x")
        with pytest.raises(ImportError, match=rf"pip install 'qtraj\[{extra}\]'"):
            recordings.read(tmp_path / f"a.{suffix}")


def run(*arguments, **more):
    return subprocess.run([sys.executable, "-m", "qtraj", *map(str, arguments)], capture_output=True, text=True, **more)


def test_convert_and_nothing_is_written_over(recording, tmp_path):
    recordings.write(tmp_path / "a.euroc", recording, "euroc")
    assert run("convert", tmp_path / "a.euroc", tmp_path / "a.csv").returncode == 0
    np.testing.assert_array_equal(recordings.read(tmp_path / "a.csv").nanoseconds, STAMPS)
    refused = run("convert", tmp_path / "a.euroc", tmp_path / "a.csv")
    assert refused.returncode == 2 and "--force" in refused.stderr and refused.stdout == ""
    assert run("convert", tmp_path / "a.euroc", tmp_path / "a.csv", "--force").returncode == 0
    piped = run("convert", "-", "-", "--to", "tum", input=(tmp_path / "a.csv").read_text())
    assert piped.returncode == 0 and piped.stdout.splitlines()[1].startswith("1403715273.262142976 ")
    wrong = run("convert", tmp_path / "missing.csv", "-")
    assert wrong.returncode == 1 and "missing.csv" in wrong.stderr
    assert run("convert").returncode == 2


def test_check_tells_what_is_wrong(recording, tmp_path):
    recordings.write(tmp_path / "a.csv", recording)
    good = run("check", tmp_path / "a.csv")
    assert good.returncode == 0 and "keys            20" in good.stdout and "FAULT" not in good.stdout
    lines = (tmp_path / "a.csv").read_text().splitlines()
    lines[5] = lines[4]
    lines[9] = ",".join([lines[9].split(",")[0], "0,0,0,0", *lines[9].split(",")[5:]])
    (tmp_path / "a.csv").write_text("\n".join(lines))
    bad = run("check", tmp_path / "a.csv")
    assert bad.returncode == 1 and "key 4: " in bad.stdout and "key 8: " in bad.stdout
    clock = run("check", DATA / "tum_fr2_desk_head.tum")
    assert "gaps            " in clock.stdout


def test_sample_resamples(tmp_path):
    out = tmp_path / "out.csv"
    done = run("sample", DATA / "tum_fr1_xyz.tum", out, "--rate", "50", "--method", "squad", "--rates", "body")
    assert done.returncode == 0, done.stderr
    found = recordings.read(out)
    source = recordings.read(DATA / "tum_fr1_xyz.tum")
    curve = qtraj.Trajectory(source.times, source.q, "squad")
    times, q = curve.uniform(rate=50)
    np.testing.assert_array_equal(found.times, times)
    np.testing.assert_array_equal(found.q, q)
    assert "wx,wy,wz" in out.read_text().splitlines()[0] and found.positions.shape == (len(times), 3)
    wrong = run("sample", DATA / "tum_fr1_xyz.tum", "-", "--rate", "50", "--method", "squat")
    assert wrong.returncode == 2 and "one of 'slerp'" in wrong.stderr
    command = ("sample", DATA / "tum_fr2_desk_head.tum", "-", "--rate", "100")
    whole, parts = run(*command), run(*command, "--longest-gap", "0.5")
    assert whole.returncode == parts.returncode == 0 and parts.stderr == ""
    assert 0.5 * len(whole.stdout) < len(parts.stdout) < 0.9 * len(whole.stdout)
