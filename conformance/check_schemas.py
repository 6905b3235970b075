# SPDX-License-Identifier: BSD-2-Clause
"""Checks every suite and file of rules below a folder against the published schemas.

    python3 check_schemas.py conformance/suites
"""
import json
import pathlib
import sys

import jsonschema


def main():
    folder = pathlib.Path(sys.argv[1])
    wrong = checked = 0
    for schema_name, pattern in (('suite', '*/suite.json'), ('rules', 'rules/*.json')):
        schema = json.loads((folder / f'{schema_name}.schema.json').read_text())
        validator = jsonschema.Draft7Validator(schema)
        for path in sorted(folder.glob(pattern)):
            checked += 1
            for error in validator.iter_errors(json.loads(path.read_text())):
                wrong += 1
                print(f'{path}: /{"/".join(map(str, error.absolute_path))}: {error.message}')
    print(f'{checked} files, {wrong} faults')
    return 1 if wrong or not checked else 0


if __name__ == '__main__':
    sys.exit(main())
