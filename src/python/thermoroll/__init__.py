# Tangled from paper/K-from-other-languages.md; edit there.
"""Rolling contact of a cylinder with frictional heating, by the shared library of thermoroll.

Numbers are dimensionless, as in the report, or in SI units. Arguments are broadcast against each other as
NumPy does, and results have the broadcast shape. The library is looked for in the file
THERMOROLL_LIBRARY, beside an installed module, below sys.prefix, and where the system looks.
"""

from __future__ import annotations

import ctypes
import dataclasses
import inspect
import math
import operator
import os
import sys
import time
import weakref
from pathlib import Path

import numpy as np
from numpy.typing import ArrayLike, NDArray

__all__ = ["Law", "LawValues", "Physical", "Profile", "Solution", "Temperatures", "Values"]
__all__ += ["law", "profile", "solve", "temperature", "version"]

def _structure(*members: str) -> np.dtype:
    return np.dtype([tuple(member.split()) for line in members for member in line.split(",")])


_scene = _structure(
    "size u4, quantity i4, given f8, friction f8, peclet f8, heating f8, roller i4, direction i4",
    "conductivity_ratio f8, heating_2 f8, peclet_2 f8, bulk_difference f8, friction_law i4",
    "branch i4, friction_temperature f8, friction_floor f8, friction_reference_temperature f8",
    "method i4, formulation i4, tolerance f8, nodes i4, places i4",
    "load f8, speed f8, half_width f8, radius f8, shear_modulus f8, poisson f8, expansion f8",
    "diffusivity f8, conductivity f8, expansion_2 f8, conductivity_2 f8, diffusivity_2 f8",
    "bulk_temperature f8, bulk_temperature_2 f8",
)

_values = _structure(
    "stick_slip_border f8, slip_length f8, traction f8, creep_constant f8, creep f8",
    "load_ratio f8, gamma0 f8, heat_integral f8, max_temperature f8, max_temperature_at f8",
    "eccentricity f8, heat_1 f8, heat_2 f8, traction_limit f8, creep_at_traction_limit f8",
)
_units = _structure("length f8, traction f8, slip f8, heat_flux f8, temperature f8")
_physical = _structure(
    "half_width f8, radius f8, creep_ratio f8, hertz_pressure f8, max_pressure f8, max_traction f8",
    "max_heat_flux f8, max_temperature_celsius f8, half_width_over_radius f8, dissipation f8",
    "tangential_load f8, max_temperature_at_m f8, heat_1 f8, heat_2 f8",
    "contact_temperature_celsius f8",
)
_result = np.dtype(
    _structure("size u4, status i4, model i4, unknowns i4").descr
    + [("value", _values), ("error", _values), ("message", "S256"), ("unit", _units)]
    + [("physical", _physical), ("physical_error", _physical), ("notes", "S256")]
)
_point = _structure(
    "size u4, status i4, s f8, pressure f8, traction f8, slip f8, heat_flux f8, temperature f8",
    "heat_flux_1 f8, heat_flux_2 f8, depth f8, temperature_error f8, friction f8",
    "pressure_error f8, traction_error f8, slip_error f8, heat_flux_error f8",
)
_law_info = _structure("size u4, status i4, driving_end f8, braking_end f8, message S256")
_law_value = _structure(
    "size u4, status i4, traction f8, slope f8, max_temperature f8, stick_slip_border f8",
    "traction_error f8, max_temperature_error f8, stick_slip_border_error f8",
)

def _load() -> ctypes.CDLL:
    name = "libthermoroll_c.so.0"
    asked = os.environ.get("THERMOROLL_LIBRARY")
    beside = [str(folder / name) for folder in list(Path(__file__).resolve().parents)[3:4]]
    reasons = []
    for place in [asked] if asked else [*beside, f"{sys.prefix}/lib/{name}", name]:
        try:
            return ctypes.CDLL(place)
        except OSError as error:
            reasons.append(str(error))
    raise ImportError(
        f"thermoroll lacks its library: run make install, or set THERMOROLL_LIBRARY ({'; '.join(reasons)})"
    )

_library = _load()


def _function(name: str, result: type | None, *arguments: type):
    try:
        function = getattr(_library, "thermoroll_" + name)
    except AttributeError:
        raise ImportError(f"{_library._name} has no thermoroll_{name}: it is of another version") from None
    function.restype, function.argtypes = result, arguments
    return function


_array, _count = ctypes.c_void_p, ctypes.c_size_t
_version = _function("version", ctypes.c_char_p)
_solve = _function("solve", ctypes.c_int, _array, _array, _count, ctypes.c_int)
_profile = _function("profile", ctypes.c_int, _array, _array, _array, _count)
_law_new = _function("law_new", ctypes.c_void_p, _array, ctypes.c_double, _array)
_law_evaluate = _function("law_evaluate", ctypes.c_int, _array, _array, _array, _count)
_law_free = _function("law_free", None, ctypes.c_void_p)


def version() -> str:
    """The version of the library, as "0.2.0"."""
    return _version().decode()

_models = ("closed-form", "first-order", "coupled")
_words = {
    "quantity": ("traction", "creep", "stick_slip_border", "creep_ratio", "tangential_load"),
    "roller": ("insulated", "identical", "conducting"),
    "direction": ("driving", "braking"),
    "friction_law": ("constant", "linear", "exponential", "rational", "piecewise-linear"),
    "branch": ("rising", "falling"),
    "method": ("auto", *_models, "gauss-chebyshev"),
    "formulation": ("printed", "corrected"),
    "places": ("along-contact", "as-given"),
}

def _numbers(name: str, value: ArrayLike) -> NDArray:
    if np.ma.is_masked(value):
        raise TypeError(f"{name} has masked values: fill them, or leave their scenes out")
    given = np.asarray(value)
    if name in _words:
        numbers = np.full(given.shape, -1)
        for number, word in enumerate(_words[name]):
            numbers[given == word] = number
        if (numbers < 0).any():
            raise ValueError(f"{name} must be one of {', '.join(_words[name])}")
        return numbers
    if given.dtype.kind not in ("iu" if name == "nodes" else "iuf") and given.size > 0:
        kind = "whole" if name == "nodes" else "real"
        raise TypeError(f"{name} must be {kind} numbers, not {given.dtype.type.__name__}")
    return given.astype(float) if name != "nodes" else given.clip(-(2**31), 2**31 - 1)

_si_needed = ("load", "speed", "shear_modulus", "poisson", "expansion", "diffusivity", "conductivity")
_si_more = ("half_width", "radius", "expansion_2", "conductivity_2", "diffusivity_2")
_si_more += ("bulk_temperature", "bulk_temperature_2", "creep_ratio", "tangential_load")


def _in_si(members: dict[str, ArrayLike | None]) -> bool:
    given = [name for name in (*_si_needed, *_si_more) if members.get(name) is not None]
    missing = [name for name in _si_needed if members.get(name) is None]
    if not given and members["peclet"] is None:
        raise TypeError("peclet is needed, or data in SI units")
    if given and missing:
        raise TypeError(f"{given[0]} is for data in SI units, which lack {', '.join(missing)}")
    if given and np.any(np.asarray(members.get("roller")) == "conducting"):
        missing = [name for name in ("expansion_2", "conductivity_2") if members.get(name) is None]
        if missing:
            raise TypeError(f"a conducting roller in SI units lacks {', '.join(missing)}")
    return bool(given)

def _over_bulk(members: dict[str, ArrayLike | None]) -> ArrayLike | None:
    name, bulk = "friction_reference_temperature", members.get("bulk_temperature")
    if not _in_si(members) or members[name] is None:
        return members[name]
    if bulk is None:
        raise TypeError(f"{name} in degree C needs bulk_temperature")
    return np.subtract(_numbers(name, members[name]), _numbers("bulk_temperature", bulk))

def _scenes(members: dict[str, ArrayLike | None]) -> NDArray:
    given = [name for name in _words["quantity"] if members.get(name) is not None]
    if len(given) != 1:
        raise TypeError(
            "exactly one of traction, creep and stick_slip_border is needed, or in SI units creep_ratio or tangential_load"
        )
    for name in ("friction", "tolerance", "nodes"):
        if members.get(name, 0) is None:
            raise TypeError(f"{name} must be numbers, not None")
    members = {**members, "friction_reference_temperature": _over_bulk(members)}
    known = {name: x for name, x in members.items() if x is not None or name in _words}
    known = {name: known[name] for name in known if name not in _words["quantity"]}
    known.update(quantity=given[0], given=_numbers(given[0], members[given[0]]))
    numbers = {name: _numbers(name, x) for name, x in known.items()}
    try:
        shape = np.broadcast_shapes(*(x.shape for x in numbers.values()))
    except ValueError:
        numbers[given[0]] = numbers.pop("given")
        arrays = ", ".join(f"{name} {x.shape}" for name, x in numbers.items() if x.shape)
        raise ValueError(f"these shapes do not fit: {arrays}") from None
    scenes = np.zeros(shape, _scene)
    scenes["size"] = _scene.itemsize
    scenes["bulk_temperature"] = scenes["bulk_temperature_2"] = np.nan
    for name, x in numbers.items():
        scenes[name] = x
    return scenes

@dataclasses.dataclass(frozen=True, eq=False)
class Values:
    """Results of scenes, or their estimated absolute errors: arrays of one shape, dimensionless."""

    stick_slip_border: NDArray  #: c0, -1 in full slip
    slip_length: NDArray  #: 1 - c0, to its own digits
    traction: NDArray  #: Q*, negative when braking
    creep_constant: NDArray  #: C
    creep: NDArray  #: xi*, negative when braking
    load_ratio: NDArray  #: kappa
    gamma0: NDArray  #: gamma0
    heat_integral: NDArray  #: the integral of v* p*
    max_temperature: NDArray  #: the largest T* in the contact
    max_temperature_at: NDArray  #: s there
    eccentricity: NDArray  #: of the contact's centre from the axis
    heat_1: NDArray  #: the heat that flows into the half-space
    heat_2: NDArray  #: the heat that flows into the roller
    traction_limit: NDArray  #: the largest traction, of a given traction with a law, or NaN
    creep_at_traction_limit: NDArray  #: the creep there

@dataclasses.dataclass(frozen=True, eq=False)
class Physical:
    """Results in SI units, or their estimated absolute errors: arrays of one shape."""

    half_width: NDArray  #: a, m
    radius: NDArray  #: R of the cylinder, m
    creep_ratio: NDArray  #: xi, the creep as a fraction of the speed
    hertz_pressure: NDArray  #: 2 P / (pi a), Pa
    max_pressure: NDArray  #: the largest p, Pa
    max_traction: NDArray  #: the largest q by size, with its sign, Pa
    max_heat_flux: NDArray  #: W/m^2
    max_temperature_celsius: NDArray  #: the largest rise of the surface, degree C
    half_width_over_radius: NDArray  #: a / R
    dissipation: NDArray  #: power lost to friction per unit length, W/m
    tangential_load: NDArray  #: Q, N/m, negative when braking
    max_temperature_at_m: NDArray  #: x of the hottest point, m
    heat_1: NDArray  #: the heat that flows into the half-space, W/m
    heat_2: NDArray  #: the heat that flows into the roller, W/m
    contact_temperature_celsius: NDArray  #: bulk temperature and largest rise, degree C, or NaN

@dataclasses.dataclass(frozen=True, eq=False)
class Solution(Values):
    """Solved scenes. Where the status is not 0, the results are NaN and the message says why."""

    errors: Values  #: estimated absolute errors; NaN for the published scheme
    status: NDArray  #: 0 done, 1 failed, 2 refused, 3 not converged, 5 no contact
    model: NDArray  #: "closed-form", "first-order" or "coupled"; "" for none
    unknowns: NDArray  #: of the coupled solver's last grid, else 0
    physical: Physical | None  #: of data in SI units
    physical_errors: Physical | None
    _messages: NDArray
    _notes: NDArray

    def __repr__(self) -> str:
        """All but the raw bytes, with the messages and notes as text."""
        told = {"messages": self.messages, "notes": self.notes}
        rest = {name: x for name, x in vars(self).items() if name[0] != "_"}
        return f"Solution({', '.join(f'{name}={x!r}' for name, x in {**told, **rest}.items())})"

    @property
    def messages(self) -> NDArray | str:
        """Why each scene failed, or why its model was enough."""
        return np.frompyfunc(bytes.decode, 1, 1)(self._messages)

    @property
    def notes(self) -> NDArray | str:
        """What is beyond the model: a/R, creep, pressure or temperature; a modulus may be in GPa. Else ""."""
        return np.frompyfunc(bytes.decode, 1, 1)(self._notes)

def _columns(rows: NDArray) -> dict[str, NDArray]:
    return {name: rows[name].copy()[()] for name in rows.dtype.names}


def _solution(rows: NDArray, in_si: bool) -> Solution:
    return Solution(
        **_columns(rows["value"]),
        errors=Values(**_columns(rows["error"])),
        status=rows["status"].copy()[()],
        model=np.array([*_models, ""])[rows["model"]],
        unknowns=rows["unknowns"].copy()[()],
        physical=Physical(**_columns(rows["physical"])) if in_si else None,
        physical_errors=Physical(**_columns(rows["physical_error"])) if in_si else None,
        _messages=rows["message"].copy()[()],
        _notes=rows["notes"].copy()[()],
    )

_first_block, _block_time, _largest_block = 256, 0.2, 8192
_other_version = "the library has other structures: it is of another version"


def _next_block(size: int, seconds: float) -> int:
    return max(16, min(int(size * _block_time / max(seconds, 1e-4)), 4 * size, _largest_block))

def _solve_all(scenes: NDArray, threads: int) -> NDArray:
    results = np.zeros(scenes.shape, _result)
    results["size"] = _result.itemsize
    rows, answers = scenes.reshape(-1), results.reshape(-1)
    begin, size = 0, _first_block
    while begin < rows.size:
        part, told = rows[begin : begin + size], answers[begin : begin + size]
        start = time.monotonic()
        if _solve(part.ctypes.data, told.ctypes.data, part.size, threads) == 2:
            raise RuntimeError(_other_version)
        begin, size = begin + size, _next_block(size, time.monotonic() - start)
    return results

def solve(
    *,
    friction: ArrayLike,
    peclet: ArrayLike | None = None,
    heating: ArrayLike = 0.0,
    traction: ArrayLike | None = None,
    creep: ArrayLike | None = None,
    stick_slip_border: ArrayLike | None = None,
    creep_ratio: ArrayLike | None = None,
    tangential_load: ArrayLike | None = None,
    radius: ArrayLike | None = None,
    roller: ArrayLike = "insulated",
    conductivity_ratio: ArrayLike = 0.0,
    heating_2: ArrayLike = 0.0,
    peclet_2: ArrayLike = 0.0,
    bulk_difference: ArrayLike = 0.0,
    friction_law: ArrayLike = "constant",
    friction_temperature: ArrayLike = 0.0,
    friction_floor: ArrayLike = 0.0,
    friction_reference_temperature: ArrayLike | None = None,
    formulation: ArrayLike = "corrected",
    load: ArrayLike | None = None,
    speed: ArrayLike | None = None,
    half_width: ArrayLike | None = None,
    shear_modulus: ArrayLike | None = None,
    poisson: ArrayLike | None = None,
    expansion: ArrayLike | None = None,
    diffusivity: ArrayLike | None = None,
    conductivity: ArrayLike | None = None,
    expansion_2: ArrayLike | None = None,
    conductivity_2: ArrayLike | None = None,
    diffusivity_2: ArrayLike | None = None,
    bulk_temperature: ArrayLike | None = None,
    bulk_temperature_2: ArrayLike | None = None,
    direction: ArrayLike = "driving",
    branch: ArrayLike = "rising",
    method: ArrayLike = "auto",
    tolerance: ArrayLike = 1e-6,
    nodes: ArrayLike = 200,
    threads: int = 0,
) -> Solution:
    """
    Solve scenes on all processors; each argument is a number, a word, or an array of them.

    friction: 0 < f <= 1e100. peclet: Pe from 1e-280 to 1e306. heating: H >= 0.
    traction, creep or stick_slip_border: exactly one. Q* from -f to f (beyond with a law of friction
        that rises) or xi*, negative for braking; or c0 between -1 and 1.
    roller: "insulated", "identical" or "conducting".
    conductivity_ratio, heating_2, peclet_2: K2 / K1 > 0, H2 >= 0 and Pe2 > 0 (0: Pe), for a
        conducting roller only. bulk_difference: Theta, by how much a roller is warmer far away; not of
        an insulated one.
    friction_law: "constant", "linear", "exponential", "rational" or "piecewise-linear", with
        friction_temperature (T0* > 0; of a linear one that rises, below 0), friction_floor (0 to 1;
        of a piecewise-linear one any end value), friction_reference_temperature.
    formulation: "corrected" or "printed".
    In SI units, in place of peclet and heating: load (N/m), speed (m/s), half_width or radius (m),
        shear_modulus (Pa), poisson, expansion (1/K), diffusivity (m^2/s), conductivity (W/(m K));
        expansion_2, conductivity_2 and diffusivity_2 of a conducting roller; bulk_temperature and
        bulk_temperature_2 (degree C), unknown unless given. There creep_ratio (a fraction of the
        speed) or tangential_load (N/m) may be what is given, friction_temperature is in K and
        friction_reference_temperature in degree C, and the results have physical.
    direction: "driving" or "braking", of a border. branch: "rising" or "falling", of a traction
        with a law of friction.
    method: "auto", "closed-form", "first-order", "coupled" or "gauss-chebyshev". The closed form
        asked for by name leaves out what the heat does to the tractions, in its errors too.
    tolerance: 1e-11 to 1e-2. nodes: of gauss-chebyshev, 3 to 5000.
    threads: how many up to 1024, 0 for one on each processor; the results are the same.

    Returns the results in the broadcast shape of all arguments. A scene that fails raises nothing:
    it has a status, a message and NaN. Raises ValueError for an unknown word or shapes that do not
    fit, and TypeError unless one quantity and a complete kind of data is given, in real numbers.
    """
    members = {name: x for name, x in locals().items() if name != "threads"}
    if not 0 <= operator.index(threads) <= 1024:
        raise ValueError("threads must be from 0, for all processors, to 1024")
    return _solution(_solve_all(_scenes(members), threads), _in_si(members))

@dataclasses.dataclass(frozen=True, eq=False)
class Profile:
    """Curves along the contact, which the surfaces enter at s = -1 and leave at s = 1: arrays of one length."""

    s: NDArray  #: x / a
    pressure: NDArray  #: p*
    traction: NDArray  #: q*, negative when braking
    slip: NDArray  #: v*, negative when braking
    heat_flux: NDArray  #: v* p*
    temperature: NDArray  #: T*, over the bulk temperature
    heat_flux_1: NDArray  #: into the half-space
    heat_flux_2: NDArray  #: into the roller
    friction: NDArray  #: the coefficient of friction at T*
    pressure_error: NDArray  #: estimated, absolute; the largest, at one distance from the border
    traction_error: NDArray
    slip_error: NDArray
    heat_flux_error: NDArray
    temperature_error: NDArray
    solution: Solution  #: the results of the scene, numbers
    x_m: NDArray | None = None  #: as above, of data in SI units
    pressure_pa: NDArray | None = None
    traction_pa: NDArray | None = None
    slip_m_per_s: NDArray | None = None
    heat_flux_w_per_m2: NDArray | None = None
    temperature_celsius: NDArray | None = None  #: the rise
    heat_flux_1_w_per_m2: NDArray | None = None
    heat_flux_2_w_per_m2: NDArray | None = None
    absolute_temperature_celsius: NDArray | None = None  #: with a bulk temperature
    pressure_error_pa: NDArray | None = None
    traction_error_pa: NDArray | None = None
    slip_error_m_per_s: NDArray | None = None
    heat_flux_error_w_per_m2: NDArray | None = None
    temperature_error_celsius: NDArray | None = None

def _curves_in_si(points: NDArray, unit: NDArray, bulk: float) -> dict[str, NDArray]:
    of = {"pressure_pa": "traction", "traction_pa": "traction", "slip_m_per_s": "slip", "temperature_celsius": "temperature"}
    of.update({f"heat_flux{body}_w_per_m2": "heat_flux" for body in ("", "_1", "_2")})
    of.update({f"{x}_error_pa": "traction" for x in ("pressure", "traction")})
    of.update(slip_error_m_per_s="slip", heat_flux_error_w_per_m2="heat_flux", temperature_error_celsius="temperature")
    bare = ("_pa", "_m_per_s", "_w_per_m2", "_celsius")
    curves = {"x_m": points["s"] * unit["length"]}
    for name, by in of.items():
        curves[name] = points[next(name.removesuffix(x) for x in bare if name.endswith(x))] * unit[by]
    if not np.isnan(bulk):
        curves["absolute_temperature_celsius"] = bulk + curves["temperature_celsius"]
    return curves

def _raise(told: NDArray) -> None:
    if told["status"] == 0:
        raise RuntimeError(_other_version)
    raised = ValueError if told["status"] == 2 else RuntimeError
    raise raised(told["message"][()].decode())

def _points(rows: NDArray, places: str, scene: dict[str, ArrayLike]) -> tuple[NDArray, NDArray, bool]:
    """The scene, its answer, and whether it is in SI units; fills the rows."""
    if "threads" in scene:
        raise TypeError("a profile is of one scene and has no threads")
    members = inspect.signature(solve).bind(**scene)
    members.apply_defaults()
    del members.arguments["threads"]
    given = _scenes({**members.arguments, "places": places})
    if given.shape:
        raise ValueError("a profile is of one scene: its arguments are single numbers")
    result = np.zeros((), _result)
    rows["size"], result["size"] = _point.itemsize, _result.itemsize
    if _profile(given.ctypes.data, result.ctypes.data, rows.ctypes.data, rows.size) != 0:
        _raise(result)
    return given, result, _in_si(members.arguments)

def profile(*, points: int = 401, **scene: ArrayLike) -> Profile:
    """Curves along the contact of one scene, with the arguments of solve() as single numbers.

    points: how many, 2 to 100000, dense at the edges and at the border. Raises ValueError for data
    out of range, RuntimeError if there is no solution, and TypeError as solve() does.
    """
    if not 2 <= operator.index(points) <= 100_000:
        raise ValueError("points must be from 2 to 100000")
    rows = np.zeros(points, _point)
    given, result, in_si = _points(rows, "along-contact", scene)
    curves = _columns(rows)
    for name in ("size", "status", "depth"):
        del curves[name]
    if in_si:
        curves.update(_curves_in_si(rows, result["unit"], given["bulk_temperature"]))
    return Profile(**curves, solution=_solution(result, in_si))

@dataclasses.dataclass(frozen=True, eq=False)
class Temperatures:
    """Temperatures of the half-space at places of one shape, and their estimated absolute errors."""

    s: NDArray  #: x / a; the contact is from -1 to 1
    depth: NDArray  #: y / a
    temperature: NDArray  #: T*, over the bulk temperature
    temperature_error: NDArray  #: of T*; NaN for the published scheme
    solution: Solution  #: the results of the scene, numbers
    x_m: NDArray | None = None  #: as above, of data in SI units
    depth_m: NDArray | None = None
    temperature_celsius: NDArray | None = None  #: the rise
    temperature_error_celsius: NDArray | None = None
    absolute_temperature_celsius: NDArray | None = None  #: with a bulk temperature

def temperature(*, at: ArrayLike, depth: ArrayLike = 0.0, **scene: ArrayLike) -> Temperatures:
    """Temperatures of one scene at the positions s = at and at depths, broadcast against each other.

    at: x / a, any finite numbers; behind the contact they are above 1. depth: y / a >= 0 in the
    half-space; 0 for the published scheme. At most 100000 places. The other arguments are those of
    solve() as single numbers. Raises ValueError for data out of range, RuntimeError if there is no
    solution, and TypeError as solve() does.
    """
    s, y = np.broadcast_arrays(_numbers("at", at), _numbers("depth", depth))
    rows = np.zeros(s.shape, _point)
    rows["s"], rows["depth"] = s, y
    if not 1 <= rows.size <= 100_000:
        raise ValueError("there must be from 1 to 100000 places")
    given, result, in_si = _points(rows, "as-given", scene)
    names = ("s", "depth", "temperature", "temperature_error")
    found = {name: rows[name].copy()[()] for name in names}
    if in_si:
        unit, bulk = result["unit"], given["bulk_temperature"]
        found.update(x_m=found["s"] * unit["length"], depth_m=found["depth"] * unit["length"])
        for name in names[2:]:
            found[name + "_celsius"] = found[name] * unit["temperature"]
        if not np.isnan(bulk):
            found["absolute_temperature_celsius"] = bulk + found["temperature_celsius"]
    return Temperatures(**found, solution=_solution(result, in_si))

@dataclasses.dataclass(frozen=True, eq=False)
class LawValues:
    """A law at creeps: arrays of their shape; NaN beyond the end of the law.

    Dimensionless, or of data in SI units with what follows "or".
    """

    traction: NDArray  #: Q*, or Q in N/m; with one bulk temperature it has the creep's sign
    slope: NDArray  #: dQ*/dxi*, or dQ/dxi in N/m; it has no error estimate
    max_temperature: NDArray  #: the largest T*, or rise in degree C
    stick_slip_border: NDArray  #: c0, -1 in full slip
    traction_error: NDArray  #: estimated, absolute, as are the next two
    max_temperature_error: NDArray
    stick_slip_border_error: NDArray
    status: NDArray  #: 0, or 2 beyond the end of the law

class Law:
    """Traction, temperature and border of a scene by creep; made by law()."""

    driving_end: float  #: the size of the creep where it ends, infinite if it does not
    braking_end: float
    message: str  #: why it ends; "" if it does not

    def __init__(self, handle: int, info: NDArray) -> None:
        self._handle = handle
        self._free = weakref.finalize(self, _law_free, handle)
        self.driving_end = float(info["driving_end"])
        self.braking_end = float(info["braking_end"])
        self.message = info["message"][()].decode()

    def __reduce__(self):
        raise TypeError("a law cannot be copied or pickled: make it again by law()")

    def __call__(self, creep: ArrayLike) -> LawValues:
        """The law at creeps xi* of either sign, or of data in SI units at fractions of the speed."""
        creeps = np.array(_numbers("creep", creep), order="C")
        values = np.zeros(creeps.shape, _law_value)
        values["size"] = _law_value.itemsize
        if _law_evaluate(self._handle, creeps.ctypes.data, values.ctypes.data, creeps.size) == 2:
            raise RuntimeError(_other_version)
        columns = _columns(values)
        del columns["size"]
        return LawValues(**columns)

def law(
    *,
    friction: ArrayLike,
    peclet: ArrayLike | None = None,
    heating: ArrayLike = 0.0,
    roller: ArrayLike = "insulated",
    conductivity_ratio: ArrayLike = 0.0,
    heating_2: ArrayLike = 0.0,
    peclet_2: ArrayLike = 0.0,
    bulk_difference: ArrayLike = 0.0,
    friction_law: ArrayLike = "constant",
    friction_temperature: ArrayLike = 0.0,
    friction_floor: ArrayLike = 0.0,
    friction_reference_temperature: ArrayLike | None = None,
    formulation: ArrayLike = "corrected",
    load: ArrayLike | None = None,
    speed: ArrayLike | None = None,
    half_width: ArrayLike | None = None,
    shear_modulus: ArrayLike | None = None,
    poisson: ArrayLike | None = None,
    expansion: ArrayLike | None = None,
    diffusivity: ArrayLike | None = None,
    conductivity: ArrayLike | None = None,
    expansion_2: ArrayLike | None = None,
    conductivity_2: ArrayLike | None = None,
    diffusivity_2: ArrayLike | None = None,
    bulk_temperature: ArrayLike | None = None,
    bulk_temperature_2: ArrayLike | None = None,
    tolerance: ArrayLike = 1e-4,
    reach: float = math.inf,
) -> Law:
    """The law of all creeps of one scene, driving and braking, with the arguments of solve().

    Of data in SI units, which need the half_width, it takes fractions of the speed.

    tolerance: of traction, border and relative temperature, 1e-7 to 1e-2. reach: the size of the
    creep up to which full slip is computed. Raises ValueError for data out of range, RuntimeError
    if there is no law to this tolerance.
    """
    members = {name: x for name, x in locals().items() if name != "reach"}
    rest = {"direction": "driving", "branch": "rising", "method": "auto", "nodes": 200}
    scene = _scenes({**members, **rest, "traction": 0.0})
    if scene.shape:
        raise ValueError("a law is of one scene: its arguments are single numbers")
    info = np.zeros((), _law_info)
    info["size"] = _law_info.itemsize
    farthest = _numbers("reach", reach)
    if farthest.shape:
        raise TypeError("reach must be a single number")
    handle = _law_new(scene.ctypes.data, float(farthest), info.ctypes.data)
    if not handle:
        _raise(info)
    return Law(handle, info)
