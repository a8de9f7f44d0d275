#!/usr/bin/env bash
# coefficients.sh root python3: src/math/coefficients.hpp is what generate_coefficients.py beside it writes.
set -euo pipefail
"$2" -c 'import mpmath' || { echo "$2 has no mpmath (Debian: python3-mpmath)"; exit 1; }
"$2" -B "$1/src/math/generate_coefficients.py" --check
echo "the same"
