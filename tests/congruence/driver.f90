! The cases that paths.py writes, in a file, through the Fortran module; telling.py says what stands in a line.
!
!     congruence-fortran ipc:///run/contactd.sock cases.txt
program driver
    use contactd
    use answers
    use words
    implicit none
    type(c_ptr) :: place, contact
    integer :: unit
    character(longest_line) :: line
    integer(c_int32_t) :: states(0:9)

    contact = c_null_ptr
    call open_cases(place, unit)
    do while (next_line(unit, line))
        call take()
    end do
    if (c_associated(contact)) call need(contactd_free(contact))
    call need(contactd_close(place))

contains

    ! Words from i on as numbers.
    function numbers(i) result(made)
        integer, intent(in) :: i
        real(c_double) :: made(count - i)
        integer :: n
        made = [(number(n), n=i, count - 1)]
    end function

    integer(c_int32_t) function set() result(code)
        select case (word(0))
        case ("set"); code = contactd_set(contact, word(1), number(2))
        case ("word"); code = contactd_set_word(contact, word(1), word(2))
        case ("clear"); code = contactd_clear(contact, word(1))
        case ("array"); code = contactd_set_array(contact, word(1), numbers(2), int(count - 2, c_int32_t))
        case ("columns"); code = set_columns(whole(1))
        case ("table")
            code = contactd_set_table(contact, word(1), whole(2), whole(3), number(4), number(5), numbers(6), &
                int(count - 6, c_int32_t))
        case default; code = -1
        end select
    end function

    ! "ny direction y z": contact on the columns of the lower body's section.
    integer(c_int32_t) function set_columns(ny) result(code)
        integer(c_int32_t), intent(in) :: ny
        real(c_double) :: y(ny), z(ny), angle(ny), frames(3, ny)
        code = contactd_get_frames(contact, "lower", y, z, angle, ny)
        frames(1, :) = y
        frames(2, :) = z
        frames(3, :) = angle
        if (code == contactd_ok) code = contactd_set_array(contact, "columns.frames", frames, 3 * ny)
        if (code == contactd_ok) code = contactd_set(contact, "columns.direction", number(2))
        if (code == contactd_ok) code = contactd_set_array(contact, "columns.origin", numbers(3), 2)
    end function

    ! The line of a call; one that a setter has refused for is not made.
    subroutine make_call()
        write (*, "(a, 1x, a)", advance="no") trim(name), trim(word(0))
        if (refused == contactd_ok) then
            select case (word(0))
            case ("start"); call note(contact, contactd_start(contact))
            case ("step"); call note(contact, contactd_step(contact))
            case ("again"); call note(contact, contactd_step_again(contact))
            case ("save"); call note(contact, contactd_save(contact, states(whole(1))))
            case ("restore"); call note(contact, contactd_restore(contact, states(whole(1))))
            case ("forget"); call note(contact, contactd_forget(contact, states(whole(1))))
            end select
        end if
        if (refused /= contactd_ok) then
            call tell_refusal()
        else if (word(0) == "step" .or. word(0) == "again") then
            call tell_step(contact)
        end if
        write (*, "()")
        refused = contactd_ok
    end subroutine

    subroutine take()
        integer :: array
        select case (word(0))
        case ("case")
            if (c_associated(contact)) call need(contactd_free(contact))
            call need(contactd_new(place, contact))
            refused = contactd_ok
            name = word(1)
            do array = 1, size(arrays) - 1
                call need(contactd_want(contact, arrays(array), 1))
            end do
        case ("start", "step", "again", "save", "restore", "forget")
            call make_call()
        case default
            call note(contact, set())
        end select
    end subroutine
end program driver
