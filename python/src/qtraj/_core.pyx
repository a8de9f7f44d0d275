# cython: language_level=3, freethreading_compatible=True, binding=True
"""Curves and diagnostics: the C interface as classes and functions. It translates, and checks shapes and types."""

cimport cython
cimport numpy as cnp
from cpython.float cimport PyFloat_AsDouble, PyFloat_Check
from libc.math cimport NAN
from libc.stdint cimport SIZE_MAX, int32_t, int64_t
from _capi cimport *

import operator
import warnings

import numpy as np

from qtraj import _arrays, _results, _ufuncs, _words
from qtraj._errors import AmbiguousWarning, NormWarning, error

cnp.import_array()

# Calls of fewer samples are over before another thread could take over.
cdef enum:
    MANY = 64

include "status.pxi"
include "settings.pxi"
include "trajectory.pxi"
include "vector_curve.pxi"
include "poses.pxi"
include "batches.pxi"
include "diagnostics.pxi"
include "means.pxi"
