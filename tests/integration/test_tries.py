"""Tests repeated steps, which restart from the same state."""

import pytest

from contactd import ConnectionFailed, Friction, InvalidArgument, KineticFriction
from support.sessions import open_session

FIELDS = ("pressure", "traction_x", "traction_y")
#: Increases with the slip velocity.
REFUSED = Friction(mu=0.3, rigid_shift=(0.001, 0), kinetic=KineticFriction(mu=0.4, slip_velocity=1))


def arrays(step):
    return [getattr(step, name).tobytes() for name in FIELDS]


def test_a_step_tried_again_starts_where_the_first_try_did(shared):
    with open_session(shared) as tried, open_session(shared) as straight:
        for shift in (0.004, -0.003, 0.002):
            for factor in (1.5, -0.5):
                tried.step(rigid_shift=(factor * shift, 0), again=factor < 0)
            last = tried.step(rigid_shift=(shift, 0), fields=FIELDS, again=True)
            expected = straight.step(rigid_shift=(shift, 0), fields=FIELDS)
            assert arrays(last) == arrays(expected)
            assert last.step == expected.step
            tried.step(rigid_shift=(0.001, 0))
            straight.step(rigid_shift=(0.001, 0))


def test_a_step_tried_again_is_what_restore_and_a_step_are(shared):
    with open_session(shared) as session:
        session.step(rigid_shift=(0.004, 0))
        state = session.save()
        session.step(rigid_shift=(-0.001, 0))
        again = session.step(rigid_shift=(0.002, 0), fields=FIELDS, again=True)
        session.restore(state)
        assert arrays(session.step(rigid_shift=(0.002, 0), fields=FIELDS)) == arrays(again)


def test_a_try_that_fails_leaves_what_was_solved_before(shared):
    with open_session(shared) as session, open_session(shared) as straight:
        session.step(rigid_shift=(0.004, 0))
        with pytest.raises(InvalidArgument):
            session.step(friction=REFUSED, again=True)
        assert shared.join_session(session.name).step_number == 1
        with pytest.raises(InvalidArgument):
            session.step(friction=REFUSED)
        assert session.step(rigid_shift=(0.002, 0), again=True).step == 2
        straight.step(rigid_shift=(0.004, 0))
        assert straight.step(rigid_shift=(0.002, 0)).step == 2
        assert arrays(session.step(fields=FIELDS)) == arrays(straight.step(fields=FIELDS))


def test_a_try_whose_answer_is_lost_is_solved_once(shared, monkeypatch):
    with open_session(shared) as session:
        session.step(rigid_shift=(0.004, 0))
        replies, exchange = [], type(shared)._exchange

        def lossy(self, request):
            replies.append(exchange(self, request))
            if len(replies) == 1:
                raise ConnectionFailed("lost")
            return replies[-1]

        monkeypatch.setattr(type(shared), "_exchange", lossy)
        assert session.step(rigid_shift=(0.002, 0), again=True).step == 1
        monkeypatch.undo()
        first, second = replies
        assert first.result == second.result, "the seconds that it took, too"
