"""python3 -m contactctl"""

from .main import main

if __name__ == "__main__":
    main()
