"""A thin layer over libmpm by ctypes, with NumPy arrays, and a reader of results by h5py.

    import touchstone
    draft = touchstone.Draft("bar", text)            # YAML, or nothing
    draft.set("method.shape", "cpdi")                # paths and checks of `mpm run --set`
    simulation = touchstone.Simulation(draft.build())
    simulation.advance_to(1.5)
    velocity = simulation.field("velocity")          # (particles, 2), sorted by id

    scene.run("results", observers=[touchstone.Observer(function, interval=0.1)])
    results = touchstone.Results("results")
    results.field("stress", -1), results.history["kinetic_energy"]

The library is the one that pkg-config finds, or that of the variable TOUCHSTONE_LIBRARY.

SPDX-License-Identifier: GPL-3.0-or-later
"""

import ctypes
import json
import os
import subprocess
import sys

import numpy

INTERFACE = "0.2"  # the shared library's, of which the structs below are


class Error(Exception):
    """The library's message; `status` as the exit status of the command mpm."""

    def __init__(self, status, message):
        super().__init__(message)
        self.status = status


# ------------------------------------------------------------------------------ structs


class _Error(ctypes.Structure):
    _fields_ = [
        ("status", ctypes.c_int),
        ("cause", ctypes.c_int),
        ("line", ctypes.c_int),
        ("message", ctypes.c_char * 1024),
    ]


class _SimulationOptions(ctypes.Structure):
    _fields_ = [
        ("threads", ctypes.c_int),
        ("kernels", ctypes.c_int),
        ("simd", ctypes.c_int),
        ("monitor", ctypes.c_void_p),
    ]


class _FieldInfo(ctypes.Structure):
    _fields_ = [
        ("name", ctypes.c_char_p),
        ("components", ctypes.c_size_t),
        ("integer", ctypes.c_bool),
        ("dimension", ctypes.c_int8 * 4),
        ("description", ctypes.c_char_p),
    ]


class _View(ctypes.Structure):
    _fields_ = [
        ("values", ctypes.POINTER(ctypes.c_double)),
        ("count", ctypes.c_size_t),
        ("components", ctypes.c_size_t),
        ("stride", ctypes.c_size_t),
    ]


_Observe = ctypes.CFUNCTYPE(ctypes.c_int, ctypes.c_void_p, ctypes.c_void_p, ctypes.POINTER(_Error))


class _Observer(ctypes.Structure):
    _fields_ = [
        ("steps", ctypes.c_uint64),
        ("interval", ctypes.c_double),
        ("times", ctypes.POINTER(ctypes.c_double)),
        ("time_count", ctypes.c_size_t),
        ("observe", _Observe),
        ("context", ctypes.c_void_p),
    ]


class _RunOptions(ctypes.Structure):
    _fields_ = [
        ("output", ctypes.c_char_p),
        ("simulation", _SimulationOptions),
        ("overwrite", ctypes.c_bool),
        ("resume", ctypes.c_bool),
        ("scene_path", ctypes.c_char_p),
        ("progress", ctypes.c_void_p),
        ("warn", ctypes.c_void_p),
        ("progress_context", ctypes.c_void_p),
        ("interrupted", ctypes.c_void_p),
        ("observers", ctypes.POINTER(_Observer)),
        ("observer_count", ctypes.c_size_t),
    ]


# ------------------------------------------------------------------------------ library


def _library_path():
    if "TOUCHSTONE_LIBRARY" in os.environ:
        return os.environ["TOUCHSTONE_LIBRARY"]
    name = f"libmpm.{INTERFACE}.dylib" if sys.platform == "darwin" else f"libmpm.so.{INTERFACE}"
    found = subprocess.run(["pkg-config", "--variable=libdir", "touchstone"],
                           capture_output=True, text=True, check=False)
    return os.path.join(found.stdout.strip(), name) if found.returncode == 0 else name


# name, result, arguments; where the result is a status, the last argument is an error that _call adds
_P, _S, _Z, _D = ctypes.c_void_p, ctypes.c_char_p, ctypes.c_size_t, ctypes.c_double
_FUNCTIONS = [
    ("mpm_draft_create", int, [_S, _S, _Z, _P]),
    ("mpm_draft_set", int, [_P, _S, _S]),
    ("mpm_draft_build", int, [_P, _P]),
    ("mpm_draft_free", None, [_P]),
    ("mpm_scene_read", int, [_S, _P, _Z, _P]),
    ("mpm_scene_run", int, [_P, _P]),
    ("mpm_scene_end_time", _D, [_P]),
    ("mpm_scene_free", None, [_P]),
    ("mpm_simulation_create", int, [_P, _P, _P]),
    ("mpm_simulation_advance", int, [_P, _D]),
    ("mpm_simulation_judge", int, [_P]),
    ("mpm_simulation_time", _D, [_P]),
    ("mpm_simulation_step", ctypes.c_uint64, [_P]),
    ("mpm_simulation_particle_count", _Z, [_P]),
    ("mpm_simulation_field", None, [_P, ctypes.c_int, _P]),
    ("mpm_simulation_free", None, [_P]),
    ("mpm_field_find", int, [_S, _P]),
    ("mpm_field_describe", ctypes.POINTER(_FieldInfo), [ctypes.c_int]),
    ("mpm_observation_simulation", _P, [_P]),
    ("mpm_observation_field", int, [_P, ctypes.c_int, _P]),
]
_library = ctypes.CDLL(_library_path())
for _name, _result, _arguments in _FUNCTIONS:
    _function = getattr(_library, _name)
    _function.restype = ctypes.c_int if _result is int else _result
    _function.argtypes = _arguments + ([ctypes.POINTER(_Error)] if _result is int else [])


def _call(name, *arguments):
    error = _Error()
    status = getattr(_library, name)(*arguments, ctypes.byref(error))
    if status != 0:
        raise Error(status, error.message.decode(errors="replace"))


def _find(name):
    field = ctypes.c_int()
    _call("mpm_field_find", name.encode(), ctypes.byref(field))
    return field.value, _library.mpm_field_describe(field.value).contents.components


def _shaped(array):
    return array[:, 0] if array.shape[1] == 1 else array


class _Owner:
    """Holds a pointer that a function of the library frees."""

    free = None

    def __init__(self):
        self.pointer = ctypes.c_void_p()

    def __del__(self):
        if self.pointer:
            getattr(_library, self.free)(self.pointer)
            self.pointer = ctypes.c_void_p()


# ------------------------------------------------------------------------------- scenes


class Draft(_Owner):
    """A scene that is being made: a text, and values set by path."""

    free = "mpm_draft_free"

    def __init__(self, name, text=None):
        super().__init__()
        data = None if text is None else text.encode()
        _call("mpm_draft_create", name.encode(), data, len(data or b""), ctypes.byref(self.pointer))

    def set(self, path, value):
        """Numbers, texts, booleans, lists and dicts; JSON is YAML."""
        _call("mpm_draft_set", self.pointer, path.encode(), json.dumps(value).encode())

    def build(self):
        scene = Scene()
        _call("mpm_draft_build", self.pointer, ctypes.byref(scene.pointer))
        return scene


class Scene(_Owner):
    """What Draft.build and read_scene return."""

    free = "mpm_scene_free"

    @property
    def end_time(self):
        return _library.mpm_scene_end_time(self.pointer)

    def run(self, output=None, observers=(), threads=1, overwrite=False):
        """To the end; results go to the folder `output`, if there is one."""
        list_of = (_Observer * len(observers))(*[each.struct for each in observers])
        options = _RunOptions(
            output=None if output is None else os.fsencode(output),
            simulation=_SimulationOptions(threads=threads),
            overwrite=overwrite,
            observers=list_of,
            observer_count=len(observers),
        )
        try:
            _call("mpm_scene_run", self.pointer, ctypes.byref(options))
        except Error:
            for each in observers:
                if each.raised is not None:
                    raise each.raised
            raise


def read_scene(path, settings=()):
    """A scene file, with texts PATH=VALUE."""
    scene = Scene()
    texts = (ctypes.c_char_p * len(settings))(*[text.encode() for text in settings])
    _call("mpm_scene_read", os.fsencode(path), texts, len(settings), ctypes.byref(scene.pointer))
    return scene


# ---------------------------------------------------------------------------- simulation


class Simulation(_Owner):
    """A scene that is advanced step by step."""

    free = "mpm_simulation_free"

    def __init__(self, scene, threads=1):
        super().__init__()
        self.scene = scene  # must outlive the simulation
        options = _SimulationOptions(threads=threads)
        _call("mpm_simulation_create", scene.pointer, ctypes.byref(options),
              ctypes.byref(self.pointer))

    time = property(lambda self: _library.mpm_simulation_time(self.pointer))
    step = property(lambda self: _library.mpm_simulation_step(self.pointer))
    particle_count = property(lambda self: _library.mpm_simulation_particle_count(self.pointer))

    def advance(self, time_limit):
        """One step, that does not pass the limit."""
        _call("mpm_simulation_advance", self.pointer, time_limit)

    def advance_to(self, time):
        """Steps up to that time, the last of which lands on it; judges the energy then."""
        while self.time < time:
            self.advance(time)
        _call("mpm_simulation_judge", self.pointer)

    def field(self, name):
        """A copy: (particles,) or (particles, components), sorted by id."""
        field, components = _find(name)
        values = numpy.empty((self.particle_count, components))
        _library.mpm_simulation_field(self.pointer, field, values.ctypes.data)
        return _shaped(values)


class Observation:
    """The state that an observer is called in: valid until it returns."""

    def __init__(self, pointer):
        self._pointer = pointer
        simulation = _library.mpm_observation_simulation(pointer)
        self.time = _library.mpm_simulation_time(simulation)
        self.step = _library.mpm_simulation_step(simulation)

    def field(self, name):
        """The library's own array, read-only: copy what is to be kept."""
        view = _View()
        _call("mpm_observation_field", self._pointer, _find(name)[0], ctypes.byref(view))
        flat = numpy.ctypeslib.as_array(view.values, (view.count * view.stride,))
        array = flat.reshape(view.count, view.stride)[:, : view.components]
        array.flags.writeable = False
        return _shaped(array)


class Observer:
    """Calls function(observation) each `steps` steps, at 0, interval, 2 interval, ... and at `times`, and at
    the start and the end. What the function raises ends the run and is raised by it."""

    def __init__(self, function, steps=0, interval=0.0, times=()):
        self.raised = None
        self._function = function
        self._times = (ctypes.c_double * len(times))(*times)
        self._observe = _Observe(self._call)
        self.struct = _Observer(steps, interval, self._times, len(times), self._observe, None)

    def _call(self, _context, observation, error):
        try:
            self._function(Observation(observation))
            return 0
        except BaseException as raised:  # must not pass through C
            self.raised = raised
            error.contents.message = str(raised).encode()[:1023]
            return raised.status if isinstance(raised, Error) else 3


# ------------------------------------------------------------------------------- results


class Results:
    """A folder that `mpm run` or Scene.run has written."""

    def __init__(self, folder):
        self.folder = folder
        with open(os.path.join(folder, "particles.hdf.series"), encoding="utf-8") as file:
            entries = json.load(file)["files"]
        self.files = [os.path.join(folder, entry["name"]) for entry in entries]
        self.times = numpy.array([entry["time"] for entry in entries])
        with open(os.path.join(folder, "history.csv"), encoding="utf-8") as file:
            names = file.readline().strip().split(",")
            self.units = dict(zip(names, file.readline().lstrip("# ").strip().split(",")))
            rows = numpy.loadtxt(file, delimiter=",", ndmin=2)
        self.history = {name: rows[:, k] for k, name in enumerate(names)}

    def field(self, name, index=-1):
        """Of one snapshot, sorted by id."""
        import h5py

        with h5py.File(self.files[index], "r") as file:
            return file["mpm/particles"][name][()]

    def unit(self, name):
        import h5py

        with h5py.File(self.files[0], "r") as file:
            unit = file["mpm/particles"][name].attrs["unit"]
            return unit.decode() if isinstance(unit, bytes) else unit
