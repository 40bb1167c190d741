"""Table and chart of all scenes of the peers; the scenes themselves have tests of their own."""

from compare import Row, draw


def test_aims_and_chart(tmp_path):
    quick = Row("K", 2169, 8.6, 298.0, "")
    slow = Row("T 19 x 80", 4617, 21.0, None, "")
    assert quick.aim == "30 s: reached" and slow.aim == "20 s: MISSED"
    assert Row("S 7", 1071, 2.0, 92.0, "").aim == ""
    assert draw([quick, slow], tmp_path / "peers.png").stat().st_size > 10_000
