#!/usr/bin/env bash
# quoted.sh project: every ratio that docs/speed.md quotes is the one in bench/results.md.
set -euo pipefail
cd "$1"
awk -F' *[|] *' '
  { gsub(/[*]/, "") }
  FILENAME == "bench/results.md" { ratio[$2 "/" $3 "/" $4 "/" $6 "/" $5] = $9; next }
  /^<!-- from bench\/results.md -->/ { quoted = 1; next }
  quoted && /^\|/ {
    if ($2 == "work" || $2 ~ /^-/) next
    rows++
    row = $2 "/" $3 "/" $4 "/" $5
    if ($6 != ratio[row "/avx512 fused"] || $7 != ratio[row "/avx2 fused"]) {
      print "docs/speed.md: not measured: " $0
      bad = 1
    }
    next
  }
  quoted && rows { quoted = 0 }
  END { if (!rows) print "docs/speed.md quotes no ratios"; exit bad || !rows }' bench/results.md docs/speed.md
