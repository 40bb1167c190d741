"""python -m braidx: the command line."""

from braidx.cli import main

if __name__ == "__main__":
    main()
