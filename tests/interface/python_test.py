"""python_test.py CASE [ARGUMENT]: one promise of the Python module; the case is a function below."""

import copy
import csv
import io
import pickle
import subprocess
import sys

import numpy as np
import thermoroll

steel = {"friction": 0.6, "peclet": 4360, "heating": 0.0175}


def raises(error, words, function, *arguments, **named):
    try:
        function(*arguments, **named)
    except error as told:
        assert words in str(told), told
    else:
        raise AssertionError(f"no {error.__name__} with {words}")


def SameAsTheProgram(program):
    """Every option of a scene has the effect that it has in a sweep, to the last bit."""
    rows = [
        {"traction": 0.5},
        {"traction": -0.5, "roller": "identical", "method": "coupled"},
        {"creep": 0.1, "formulation": "printed", "tolerance": 1e-9},
        {"stick_slip_border": 0.2, "direction": "braking", "method": "first-order"},
        {"traction": 0.3, "roller": "conducting", "conductivity_ratio": 4.0, "heating_2": 0.05},
        {"traction": 0.3, "roller": "conducting", "conductivity_ratio": 2.0, "heating_2": 0.05, "peclet_2": 760.0},
        {"creep": 0.1, "roller": "identical", "bulk_difference": 0.002},
        {"traction": 0.3, "peclet": 100, "friction_law": "linear", "friction_temperature": 0.02, "branch": "falling"},
        {"creep": 0.2, "friction_law": "exponential", "friction_temperature": 0.02, "friction_floor": 0.5},
        {"creep": 0.2, "friction_law": "rational", "friction_temperature": 0.02, "friction_reference_temperature": 0.001},
        {"creep": 0.2, "friction_law": "piecewise-linear", "friction_temperature": 0.02, "friction_floor": 0.6},
        {"traction": 0.5, "method": "closed-form"},
        {"traction": 0.5, "method": "gauss-chebyshev", "formulation": "printed", "nodes": 60},
        {"traction": 0.7},
    ]
    for row in rows:
        scene = {**steel, **row}
        words = [part for name, x in scene.items() for part in ("--" + name.replace("_", "-"), str(x))]
        answer = subprocess.run([program, "solve", "--format", "csv", *words], capture_output=True, text=True)
        found = thermoroll.solve(**scene)
        assert found.status == answer.returncode, (row, answer.stderr)
        if answer.returncode != 0:
            assert found.messages in answer.stderr and np.isnan(found.creep), found.messages
            continue
        expected = next(csv.DictReader(io.StringIO(answer.stdout)))
        assert found.model == (expected["model"] if found.model else ""), row
        for name in vars(found.errors):
            if name in expected and expected[name]:
                assert getattr(found, name) == float(expected[name]), (row, name)
                error = expected.get("error_estimate." + name)
                assert not error or getattr(found.errors, name) == float(error), (row, name)


wheel = {"friction": 0.35, "load": 1.2e7, "speed": 40.0, "half_width": 7.8e-3, "shear_modulus": 8.1e10, "poisson": 0.3,
         "expansion": 1.1e-5, "diffusivity": 1.4e-5, "conductivity": 50.0}
falling = {"friction_law": "exponential", "friction_temperature": 400.0, "friction_floor": 0.4, "bulk_temperature": 20.0}
metals = {"roller": "conducting", "expansion_2": 1.6e-5, "conductivity_2": 20.0}
by_radius = {name: x for name, x in wheel.items() if name != "half_width"}
wheels = [
    {**wheel, "creep_ratio": 0.002},
    {**wheel, "tangential_load": -3e6, "roller": "identical"},
    {**by_radius, "radius": 0.46, "traction": 0.2},
    {**by_radius, "radius": 0.46, "creep_ratio": 0.001, "bulk_temperature": -10.0},
    {**wheel, **falling, "creep_ratio": 0.01, "roller": "identical"},
    {**wheel, **falling, "creep_ratio": 0.01, "tolerance": 1e-3, "friction_reference_temperature": 60.0},
    {**wheel, **metals, "creep": 0.1},
    {**wheel, **metals, "diffusivity_2": 5e-6, "stick_slip_border": 0.3, "direction": "braking"},
    {**wheel, "roller": "identical", "creep": 0.3, "bulk_temperature": 20.0, "bulk_temperature_2": 21.0},
    {**wheel, "traction": 0.2, "method": "gauss-chebyshev", "nodes": 60},
    {**wheel, "shear_modulus": 81.0, "traction": 0.3},
    {**wheel, "tangential_load": 5e6},
]


def options(scene):
    return [part for name, x in scene.items() for part in ("--" + name.replace("_", "-"), str(x))]


def SameAsTheProgramInSiUnits(program):
    """The results of the command line in SI units with their errors, to the last bit; and its notes."""
    for row in wheels:
        answer = subprocess.run([program, "solve", "--format", "csv", *options(row)], capture_output=True, text=True)
        found = thermoroll.solve(**row)
        assert found.status == answer.returncode, (row, answer.stderr, found.messages)
        if answer.returncode != 0:
            assert row is wheels[-1] and "tangential_load = 5e+06: traction = " in found.messages and np.isnan(found.physical.radius)
            continue
        expected = next(csv.DictReader(io.StringIO(answer.stdout)))
        for name in vars(found.physical):
            value, error = getattr(found.physical, name), getattr(found.physical_errors, name)
            cell, told = expected.get("physical." + name), expected.get("physical.error_estimate." + name)
            if name[:5] == "heat_" and row.get("roller", "insulated") == "insulated":  # no columns
                all_heat = found.physical.dissipation if name == "heat_1" else 0
                off = 1e-6 if error >= 0 else 0.01  # the scheme has no error, and 60 nodes
                assert cell is None and abs(value - all_heat) <= off * all_heat, (row, name, value, all_heat)
                continue
            assert value == float(cell) if cell else np.isnan(value) and name[:7] == "contact", (row, name, value, cell)
            assert error == float(told) if told else np.isnan(error), (row, name, error, told)
        assert found.notes.count(" is above ") == expected["notes"].count(" is above "), found.notes
        assert (found.notes != "") == (row["shear_modulus"] == 81)
        assert f"notes={found.notes!r}" in repr(found), found
        np.testing.assert_array_equal(
            [found.creep, found.errors.creep], [float(expected["creep"]), float(expected["error_estimate.creep"] or "nan")])
    some = [x for x in wheels if set(x) == set(wheel) | {"creep_ratio"}] * 2
    table = {name: [x[name] for x in some] for name in some[0]}
    assert thermoroll.solve(**table).physical.tangential_load.shape == (2,)
    assert thermoroll.solve(**steel, traction=0.1).physical is None and thermoroll.solve(**steel, traction=0.1).notes == ""


def ProfileIsThatOfTheProgram(program):
    """All columns of solve --profile; those in units to the rounding of a product."""
    import tempfile

    for scene in ({**steel, "traction": 0.5}, wheels[1], wheels[4], wheels[7]):
        with tempfile.NamedTemporaryFile("r") as file:
            command = [program, "solve", *options(scene), "--profile", file.name + ".csv", "--profile-points", "21"]
            subprocess.run(command, capture_output=True, check=True)
            expected = np.genfromtxt(file.name + ".csv", delimiter=",", names=True, deletechars="")
            __import__("os").unlink(file.name + ".csv")
        found = thermoroll.profile(**scene, points=21)
        for name in expected.dtype.names:
            here = name.removeprefix("error_estimate.")
            suffix = next((x for x in ("_pa", "_m_per_s", "_w_per_m2", "_celsius") if here.endswith(x)), "")
            here = here if here == name else here.removesuffix(suffix) + "_error" + suffix
            np.testing.assert_allclose(getattr(found, here), expected[name], rtol=4e-16, err_msg=name)
        assert ("friction" in expected.dtype.names) == ("friction_law" in scene)
        assert "friction_law" in scene or (found.friction == scene["friction"]).all()
        assert ("x_m" in expected.dtype.names) == (found.x_m is not None) == ("load" in scene)
        assert found.solution.traction == thermoroll.solve(**scene).traction
        if scene.get("roller", "insulated") == "insulated":
            assert (found.heat_flux_1 == found.heat_flux).all() and (found.heat_flux_2 == 0).all()
        if "bulk_temperature" in scene:
            assert (found.absolute_temperature_celsius == 20 + found.temperature_celsius).all()
        else:
            assert found.absolute_temperature_celsius is None
    assert thermoroll.profile(**steel, traction=0.5).s.shape == (401,)


def ProfilesThatAreNot():
    raises(ValueError, "friction = -1 is not allowed: it must be positive", thermoroll.profile, friction=-1, traction=0.1, peclet=1)
    raises(ValueError, "single numbers", thermoroll.profile, **steel, traction=[0.1, 0.2])
    raises(TypeError, "frction", thermoroll.profile, frction=0.6, friction=0.6, traction=0.1, peclet=1)
    raises(TypeError, "threads", thermoroll.profile, **steel, traction=0.1, threads=1)
    raises(RuntimeError, "no solution found", thermoroll.profile, friction=0.6, traction=0.5, peclet=100, heating=1e6)
    for points in (1, 100001, -1):
        raises(ValueError, "points must be from 2 to 100000", thermoroll.profile, **steel, traction=0.1, points=points)


def TemperaturesAreThoseOfTheProgram(program):
    """A map of positions and depths, column by column; those in units to the rounding of a product."""
    at, depth = np.linspace(-1.5, 3, 7), np.array([[0.0], [0.05]])
    for scene in ({**steel, "traction": 0.5}, wheels[1]):
        command = [program, "temperature", *options(scene), "--at=-1.5:3:7", "--depth", "0,0.05"]
        lines = subprocess.run(command, capture_output=True, check=True, text=True).stdout.splitlines()
        expected = np.genfromtxt(lines, delimiter=",", names=True)
        found = thermoroll.temperature(at=at, depth=depth, **scene)
        assert found.temperature.shape == (2, 7)
        for name in expected.dtype.names:
            column = getattr(found, name.replace("error_estimate", "temperature_error"))
            np.testing.assert_allclose(column.ravel(), expected[name], rtol=4e-16, err_msg=name)
        in_si = "load" in scene
        assert ("depth_m" in expected.dtype.names) == (found.depth_m is not None) == in_si
        assert ("absolute_temperature_celsius" in expected.dtype.names) == (found.absolute_temperature_celsius is not None)
        if in_si:
            ratio = found.temperature_error_celsius / found.temperature_error
            np.testing.assert_allclose(ratio, found.temperature_celsius[0, 3] / found.temperature[0, 3])
        assert found.solution.traction == thermoroll.solve(**scene).traction
    assert np.shape(thermoroll.temperature(at=2, **steel, traction=0.5).temperature) == ()


def PlacesThatAreNot():
    raises(ValueError, "depth = -1 is not allowed", thermoroll.temperature, at=0, depth=-1, **steel, traction=0.1)
    raises(ValueError, "s = nan is not allowed", thermoroll.temperature, at=np.nan, **steel, traction=0.1)
    raises(ValueError, "from 1 to 100000 places", thermoroll.temperature, at=np.zeros(100001), **steel, traction=0.1)
    raises(ValueError, "from 1 to 100000 places", thermoroll.temperature, at=[], **steel, traction=0.1)
    raises(ValueError, "single numbers", thermoroll.temperature, at=0, **steel, traction=[0.1, 0.2])
    raises(TypeError, "at must be real numbers", thermoroll.temperature, at="0", **steel, traction=0.1)


def ConductingRollersHaveTheirData():
    """As the program refuses them; an expansion of zero must be told, and a diffusivity may be that of the half-space."""
    pair = {**wheels[1], "roller": "conducting", "conductivity_2": 200.0}
    for names in ("expansion_2", "expansion_2, conductivity_2"):
        try:
            thermoroll.solve(**{name: x for name, x in pair.items() if name not in names.split(", ")})
        except TypeError as error:
            assert str(error) == f"a conducting roller in SI units lacks {names}", error
        else:
            raise AssertionError(names)
    assert thermoroll.solve(**pair, expansion_2=0.0).status == 0


def SiDataAreWhole():
    """What is missing is named at once; the reference temperature is absolute, as on the command line."""
    raises(TypeError, "peclet is needed, or data in SI units", thermoroll.solve, friction=0.6, traction=0.1)
    raises(TypeError, "tolerance must be numbers", thermoroll.solve, **steel, traction=0.1, tolerance=None)
    infinite = thermoroll.solve(**steel, traction=0.1, roller="identical", bulk_difference=np.inf)
    assert "finite and of any sign" in str(infinite.messages), infinite.messages
    raises(TypeError, "load is for data in SI units, which lack speed, shear_modulus", thermoroll.solve, friction=0.6, traction=0.1, load=1e7)
    raises(TypeError, "creep_ratio is for data in SI units, which lack load", thermoroll.solve, friction=0.6, creep_ratio=0.1, peclet=3)
    hot = {**wheel, "creep_ratio": 0.01, "friction_law": "linear", "friction_temperature": 400.0}
    raises(TypeError, "needs bulk_temperature", thermoroll.solve, **hot, friction_reference_temperature=50.0)
    assert "are not for data in SI units" in thermoroll.solve(**wheel, traction=0.1, peclet=3).messages
    refused = thermoroll.solve(**wheel, traction=0.1, radius=0.46)
    assert "either half_width or radius" in refused.messages and refused.messages in str(refused), refused
    both = str(thermoroll.solve(friction=[0.6, -1], traction=0.1, peclet=10, heating=0))
    assert "friction = -1" in both and "traction=array([" in both and "_notes" not in both, both


def RefusesWhatIsNoNumber():
    """Texts, complex numbers, objects, truth values and times are mistakes, in words too."""
    for x, kind in ((0.1j, "complex128"), ("0.1", "str_"), ([None, 0.1], "object_"), (True, "bool_"), (np.datetime64(3, "s"), "datetime64")):
        raises(TypeError, f"traction must be real numbers, not {kind}", thermoroll.solve, **steel, traction=x)
        raises(TypeError, f"creep must be real numbers, not {kind}", thermoroll.law(friction=0.6, peclet=1), x)
    raises(TypeError, "nodes must be whole numbers, not float64", thermoroll.solve, **steel, traction=0.1, nodes=20.0)
    found = thermoroll.solve(**steel, traction=0.1, method="gauss-chebyshev", nodes=[2**32 + 200, -(2**40)])
    assert all("from 3 to 5000" in message for message in found.messages), found.messages
    raises(ValueError, "roller must be one of", thermoroll.solve, **steel, traction=0.1, roller=1.0)
    found = thermoroll.solve(friction=np.float32(0.5), traction=np.int8(0), peclet=np.array([3], dtype=np.uint64), roller=np.array(["identical"], object))
    assert (found.status == 0).all() and found.traction == 0


def LawInSiUnits():
    """The law of a wheel takes creep ratios and gives N/m and degree C, as solve() does."""
    scene = {**wheel, **falling, "roller": "identical"}
    values, found = thermoroll.law(**scene, reach=0.02)(0.01), thermoroll.solve(**scene, creep_ratio=0.01)
    near = abs(values.traction - found.physical.tangential_load)
    assert near <= values.traction_error + found.physical_errors.tangential_load, near
    near = abs(values.max_temperature - found.physical.max_temperature_celsius)
    assert near <= values.max_temperature_error + found.physical_errors.max_temperature_celsius, near
    radius = {name: x for name, x in scene.items() if name != "half_width"}
    raises(TypeError, "radius", thermoroll.law, **radius, radius=0.46)
    raises(ValueError, "either half_width or radius", thermoroll.law, **radius)


def Broadcasts():
    traction, peclet = np.array([[0.1], [0.4], [0.7]]), np.array([10.0, 1000.0])
    roller = np.array([["identical", "insulated"]])
    found = thermoroll.solve(friction=0.6, traction=traction, peclet=peclet, heating=0.01, roller=roller, threads=2)
    assert found.creep.shape == found.errors.creep.shape == found.status.shape == found.messages.shape == (3, 2)
    for i, j in np.ndindex(3, 2):
        one = thermoroll.solve(friction=0.6, traction=traction[i, 0], peclet=peclet[j], heating=0.01, roller=roller[0, j])
        assert one.messages == found.messages[i, j] and one.model == found.model[i, j]
        np.testing.assert_array_equal([one.creep, one.max_temperature, one.errors.creep],
                                      [found.creep[i, j], found.max_temperature[i, j], found.errors.creep[i, j]])
    assert (found.status == [[0], [0], [2]] * np.ones((1, 2))).all()
    assert np.isnan(found.max_temperature[2]).all() and not np.isnan(found.max_temperature[:2]).any()
    assert found.creep.flags.c_contiguous
    assert thermoroll.solve(friction=0.6, traction=[], peclet=10).creep.shape == (0,)
    every_other = thermoroll.solve(friction=0.6, traction=np.array([0.1, 9, 0.4, 9])[::2], peclet=10.0, heating=0.01)
    assert every_other.traction.tolist() == [0.1, 0.4]
    blocks = thermoroll.solve(friction=0.6, traction=np.linspace(-0.5, 0.5, 11), peclet=10.0)
    assert (blocks.status == 0).all() and np.allclose(blocks.traction, np.linspace(-0.5, 0.5, 11), atol=0)
    solve_block, sizes = thermoroll._solve, []  # a long array is cut into blocks
    def counted(scenes, results, size, threads):
        sizes.append(size)
        return solve_block(scenes, results, size, threads)
    thermoroll._first_block, thermoroll._solve = 4, counted
    again = thermoroll.solve(friction=0.6, traction=np.linspace(-0.5, 0.5, 11), peclet=10.0)
    assert sizes == [4, 7]
    np.testing.assert_array_equal(again.creep, blocks.creep)


def Scalars():
    found = thermoroll.solve(**steel, traction=0.5, method="coupled")
    assert isinstance(found.creep, float) and isinstance(found.messages, str)
    assert found.model == "coupled" and found.unknowns > 10 and found.status == 0
    assert found.traction == 0.5 and found.errors.traction == 0
    assert found.heat_1 == found.heat_integral and found.heat_2 == 0


def RefusesWhatIsNoWord():
    raises(ValueError, "roller must be one of insulated, identical, conducting", thermoroll.solve, **steel, traction=0.1, roller="steel")
    raises(ValueError, "method must be one of", thermoroll.solve, **steel, traction=0.1, method=["auto", "closed_form"])
    raises(ValueError, "formulation must be one of", thermoroll.solve, **steel, traction=0.1, formulation=None)
    raises(TypeError, "exactly one of traction, creep and stick_slip_border is needed", thermoroll.solve, **steel)
    raises(TypeError, "exactly one of", thermoroll.solve, **steel, traction=0.1, creep=0.1)
    raises(TypeError, "nodes must be whole numbers", thermoroll.solve, **steel, traction=0.1, nodes=20.5)
    raises(ValueError, "threads must be from 0", thermoroll.solve, **steel, traction=0.1, threads=-1)
    raises(ValueError, "these shapes do not fit: friction (2,)", thermoroll.solve, friction=[0.5, 0.6], traction=[0.1] * 3, peclet=10)


def LawIsThatOfTheLibrary():
    """The law agrees with solve() within both errors, and tells where it ends."""
    law = thermoroll.law(**steel, tolerance=1e-4, reach=2.0)
    creeps = np.array([[-1.5, -0.3, -0.01], [0.0, 0.05, 1.9]])
    values, found = law(creeps), thermoroll.solve(**steel, creep=creeps)
    assert values.traction.shape == (2, 3) and (values.status == 0).all() and (found.status == 0).all()
    assert (abs(values.traction - found.traction) <= values.traction_error + found.errors.traction).all()
    hotter = values.max_temperature_error + found.errors.max_temperature
    assert (abs(values.max_temperature - found.max_temperature) <= hotter).all()
    borders = values.stick_slip_border_error + found.errors.stick_slip_border
    assert (abs(values.stick_slip_border - found.stick_slip_border) <= borders).all()
    near = law([0.05 - 1e-5, 0.05 + 1e-5]).traction
    assert abs((near[1] - near[0]) / 2e-5 - values.slope[1, 1]) < 1e-3
    assert law.driving_end == 2 and "driving: " in law.message
    beyond = law(2.5)
    assert beyond.status == 2 and np.isnan(beyond.traction) and isinstance(law(0.1).traction, float)


def LawsAreNotCopied():
    """A copy would point to what the first one frees."""
    x = thermoroll.law(friction=0.6, peclet=100, heating=0.1)
    for attempt in (copy.copy, copy.deepcopy, pickle.dumps):
        raises(TypeError, "cannot be copied or pickled", attempt, x)
    assert abs(x(0.1).traction) > 0


def MessagesEndWhereTheyEnd():
    """They have no zeros, and an empty one is empty."""
    assert thermoroll.law(friction=0.6, peclet=1, heating=0).message == ""
    try:
        thermoroll.law(friction=-1, peclet=1)
    except ValueError as error:
        assert str(error) == "friction = -1 is not allowed: it must be positive", repr(error)
    else:
        raise AssertionError("a negative friction has a law")


def RefusesWhatDoesNotFit():
    """Shapes by the names of their arguments, masked values, and numbers of threads."""
    raises(ValueError, "traction (2,)", thermoroll.solve, friction=0.6, traction=[0.1, 0.2], peclet=[1, 2, 3])
    masked = np.ma.masked_array([0.1, 0.2], [False, True])
    raises(TypeError, "masked", thermoroll.solve, friction=0.6, traction=masked, peclet=1)
    for threads in (-1, 1025, 2**32):
        raises(ValueError, "from 0", thermoroll.solve, friction=0.6, traction=0.1, peclet=1, threads=threads)
    raises(TypeError, "", thermoroll.solve, friction=0.6, traction=0.1, peclet=1, threads=1.5)


def LawsThatAreNot():
    raises(ValueError, "tolerance = 1 is not allowed", thermoroll.law, **steel, tolerance=1.0)
    raises(ValueError, "single numbers", thermoroll.law, friction=[0.5, 0.6], peclet=10)
    raises(ValueError, "reach", thermoroll.law, **steel, reach=-1.0)
    raises(TypeError, "reach must be real numbers", thermoroll.law, **steel, reach="1")
    raises(TypeError, "reach must be a single number", thermoroll.law, **steel, reach=[1.0, 2.0])
    for _ in range(3):  # laws that are dropped are freed once
        law = thermoroll.law(**steel, tolerance=1e-2, reach=1.0)
        law._free()
        assert not law._free.alive


def SameInEveryLocale(*names):
    """Answers, messages and notes of a program that takes the decimals of its user's language."""
    import locale

    def text(x):
        return repr({name: text(y) for name, y in vars(x).items()}) if hasattr(x, "__dict__") else repr(np.asarray(x).tolist())

    def refusal(function, **named):
        try:
            function(**named)
        except (ValueError, RuntimeError) as told:
            return str(told)
        raise AssertionError("not refused")

    def everything():
        soft = {**wheel, "shear_modulus": 2.1e9}
        law = thermoroll.law(**steel, tolerance=1e-2, reach=1.0)
        return [
            text(thermoroll.solve(**soft, traction=[0.25, 0.3455, 0.355, -0.1], tolerance=1e-3)),
            text(thermoroll.solve(friction=0.6, traction=0.5, peclet=[100.5, -1.5], heating=0.0175, roller="identical")),
            text(thermoroll.profile(**wheel, creep_ratio=0.001, points=9)),
            text(thermoroll.temperature(**wheel, creep_ratio=0.001, at=[-0.5, 1.5], depth=0.25)),
            text(law(np.linspace(-1.5, 1.5, 7))),
            refusal(thermoroll.law, friction=-0.5, peclet=100.5),
            refusal(thermoroll.profile, **steel, traction=0.65),
        ]

    expected = everything()
    assert "0.355 is not allowed" in expected[0] and "half_width_over_radius = 0." in expected[0], expected[0]
    assert "-0.5 is not allowed" in expected[5] and "0.65" in expected[6], expected[5:]
    for name in names:
        locale.setlocale(locale.LC_ALL, name)
        assert locale.localeconv()["decimal_point"] == ",", name
        for ours, theirs in zip(expected, everything()):
            assert ours == theirs, (name, ours, theirs)


def Throughput(program):
    """A hundred thousand scenes take no longer than in a program in C++, but for a tenth."""
    import tempfile
    import time

    random, count = np.random.default_rng(1), 100_000
    scenes = np.stack([random.uniform(0.05, 0.55, count), 10 ** random.uniform(0, 5, count), 10 ** random.uniform(-6, -2, count)], 1)
    with tempfile.NamedTemporaryFile() as file:
        scenes.tofile(file.name)
        cpp, python = [], []
        for _ in range(3):
            cpp.append(float(subprocess.run([program, file.name], capture_output=True, text=True, check=True).stdout))
            begin = time.perf_counter()
            found = thermoroll.solve(friction=0.6, traction=scenes[:, 0], peclet=scenes[:, 1], heating=scenes[:, 2])
            python.append(time.perf_counter() - begin)
            assert (found.status == 0).all()
    ratio = min(cpp) / min(python)
    print(f"C++ {min(cpp):.2f} s, Python {min(python):.2f} s, ratio {ratio:.3f}")
    assert ratio >= 0.9


globals()[sys.argv[1]](*sys.argv[2:])
