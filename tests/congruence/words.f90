! The cases that both drivers in Fortran read: a line is a word and what belongs to it.
module words
    use contactd
    use, intrinsic :: iso_fortran_env, only: error_unit
    implicit none
    public

    integer, parameter :: most_words = 2000, longest_line = 65536
    character(100) :: word(0:most_words), name, reason, field
    integer :: count = 0
    integer(c_int32_t) :: refused = contactd_ok ! what a setter answered since the last line

contains

    subroutine split(line)
        character(*), intent(in) :: line
        integer :: at, next
        count = 0
        at = 1
        do while (at <= len_trim(line))
            next = index(line(at:) // " ", " ") + at - 1
            if (next > at .and. count < most_words) then
                word(count) = line(at:next - 1)
                count = count + 1
            end if
            at = next + 1
        end do
    end subroutine

    real(c_double) function number(i)
        integer, intent(in) :: i
        read (word(i), *) number
    end function

    integer(c_int32_t) function whole(i)
        integer, intent(in) :: i
        read (word(i), *) whole
    end function

    ! The place of word i in a list of words.
    integer(c_int32_t) function place_of(i, list)
        integer, intent(in) :: i
        character(*), intent(in) :: list(0:)
        do place_of = 0, size(list, kind=c_int32_t) - 1
            if (word(i) == list(place_of)) return
        end do
        write (error_unit, *) trim(name), ": ", trim(word(0)), " has no such word"
        stop 2
    end function

    subroutine note(handle, code)
        type(c_ptr), intent(in) :: handle
        integer(c_int32_t), intent(in) :: code
        if (code == -1) error stop "a line that this does not know"
        if (code == contactd_ok .or. refused /= contactd_ok) return
        refused = code
        reason = contactd_last_reason(handle)
        field = contactd_last_field(handle)
    end subroutine

    subroutine tell_refusal()
        write (*, "(a, i0, 1x, a, 1x, a)", advance="no") " refused ", refused, trim(reason), trim(field)
    end subroutine

    ! Opens the file and the place that the command line names.
    subroutine open_cases(place, unit)
        type(c_ptr), intent(out) :: place
        integer, intent(out) :: unit
        character(256) :: where, file
        if (command_argument_count() /= 2) error stop "usage: WHERE CASES"
        call get_command_argument(1, where)
        call get_command_argument(2, file)
        if (contactd_open(where, place) /= contactd_ok) error stop "nobody is there"
        open (newunit=unit, file=file, status="old", action="read")
    end subroutine

    ! The next line that says something.
    logical function next_line(unit, line)
        integer, intent(in) :: unit
        character(*), intent(out) :: line
        integer :: status
        do
            read (unit, "(a)", iostat=status) line
            next_line = status == 0
            if (.not. next_line) return
            call split(line)
            if (count > 0) return
        end do
    end function
end module words
