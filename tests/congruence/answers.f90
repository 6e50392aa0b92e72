! What the driver in Fortran says of a step: telling.py has the order.
module answers
    use contactd
    use, intrinsic :: iso_fortran_env, only: int64
    implicit none
    private
    public :: need, tell, tell_whole, digest, tell_array, tell_step, arrays, sure_arrays

    ! Arrays over the grid, of which every solution has the first, a contact may have all but the last, and a wheel all.
    integer, parameter :: sure_arrays = 6
    character(20), parameter :: arrays(8) = [character(20) :: "element_division", "pressure", &
        "traction_x", "traction_y", "slip_x", "slip_y", "pressure_by_approach", "gap"]

contains

    subroutine need(code)
        integer(c_int32_t), intent(in) :: code
        if (code /= contactd_ok) error stop 3
    end subroutine

    subroutine tell(value, code)
        real(c_double), intent(in) :: value
        integer(c_int32_t), intent(in) :: code
        if (code == contactd_ok) then
            write (*, "(1x, z16.16)", advance="no") transfer(value, 0_int64)
        else
            write (*, "(a)", advance="no") " -"
        end if
    end subroutine

    subroutine tell_whole(value, code)
        integer(c_int32_t), intent(in) :: value, code
        if (code == contactd_ok) then
            write (*, "(1x, i0)", advance="no") value
        else
            write (*, "(a)", advance="no") " -"
        end if
    end subroutine

    subroutine digest(sum, more)
        integer(int64), intent(inout) :: sum
        integer(int64), intent(in) :: more
        sum = mod(sum * 65599_int64 + more, 4294967291_int64)
    end subroutine

    ! The elements' words are told as whole numbers, all others by their bits.
    subroutine tell_array(values, are_words)
        real(c_double), intent(in) :: values(:)
        logical, intent(in) :: are_words
        integer(int64) :: sum, bits
        integer :: i
        sum = 0
        do i = 1, size(values)
            if (are_words) then
                call digest(sum, int(values(i), int64))
            else
                bits = transfer(values(i), 0_int64)
                call digest(sum, ibits(bits, 32, 32))
                call digest(sum, ibits(bits, 0, 32))
            end if
        end do
        write (*, "(1x, i0)", advance="no") sum
    end subroutine

    subroutine tell_field(contact, path)
        type(c_ptr), intent(in) :: contact
        character(*), intent(in) :: path
        real(c_double) :: value
        integer(c_int32_t) :: code
        code = contactd_get(contact, path, value)
        call tell(value, code)
    end subroutine

    subroutine tell_whole_field(contact, path)
        type(c_ptr), intent(in) :: contact
        character(*), intent(in) :: path
        real(c_double) :: value
        integer(c_int32_t) :: code
        value = 0
        code = contactd_get(contact, path, value)
        call tell_whole(nint(value, c_int32_t), code)
    end subroutine

    subroutine tell_fields(contact, path, number)
        type(c_ptr), intent(in) :: contact
        character(*), intent(in) :: path
        integer(c_int32_t), intent(in) :: number
        real(c_double) :: values(number)
        integer(c_int32_t) :: code
        integer :: i
        code = contactd_get_array(contact, path, values, number)
        do i = 1, number
            call tell(values(i), code)
        end do
    end subroutine

    subroutine tell_arrays(contact)
        type(c_ptr), intent(in) :: contact
        integer :: which
        do which = 1, size(arrays) - 1
            call tell_one(which)
        end do

    contains

        subroutine tell_one(which)
            integer, intent(in) :: which
            integer(c_int32_t) :: elements, code
            real(c_double), allocatable :: array(:)
            call need(contactd_length(contact, "pressure", elements))
            allocate (array(elements))
            code = contactd_get_array(contact, arrays(which), array, elements)
            if (which <= sure_arrays) call need(code)
            if (code /= contactd_ok) array = 0
            call tell_array(array, which == 1)
        end subroutine
    end subroutine

    subroutine tell_warnings(contact)
        type(c_ptr), intent(in) :: contact
        character(2000) :: text
        character(40) :: path
        real(c_double) :: warnings
        integer(int64) :: sum
        integer :: c, i
        sum = 0
        call need(contactd_get(contact, "warnings", warnings))
        do i = 0, nint(warnings) - 1
            write (path, "(a, i0, a)") "warnings[", i, "]"
            call need(contactd_get_word(contact, path, text))
            do c = 1, len_trim(text)
                call digest(sum, int(ichar(text(c:c)), int64))
            end do
        end do
        write (*, "(1x, i0, 1x, i0)", advance="no") nint(warnings), sum
    end subroutine

    subroutine tell_solvers(contact)
        type(c_ptr), intent(in) :: contact
        character(10), parameter :: solvers(4) = [character(10) :: "normal", "tangential", "outer", "force"]
        character(*), parameter :: fine = "evidence.discretisation."
        character(:), allocatable :: solver
        integer(c_int32_t) :: code
        real(c_double) :: value
        integer :: i
        call tell_whole_field(contact, "converged")
        do i = 1, size(solvers)
            solver = "evidence." // trim(solvers(i))
            call tell_whole_field(contact, solver // ".iterations")
            call tell_field(contact, solver // ".residual")
            call tell_whole_field(contact, solver // ".converged")
        end do
        call tell_whole_field(contact, fine // "elements_across")
        call tell_field(contact, fine // "force_error")
        call tell_field(contact, fine // "pmax_error")
        if (contactd_get(contact, fine // "rolling_error", value) /= contactd_ok) value = 0
        code = contactd_length(contact, "evidence.discretisation.elements_across", i)
        call tell(value, code)
    end subroutine

    subroutine tell_motion(contact)
        type(c_ptr), intent(in) :: contact
        real(c_double) :: value
        if (contactd_get(contact, "motion.xi", value) == contactd_ok) then
            call tell_field(contact, "motion.xi")
            call tell_field(contact, "motion.eta")
            call tell_field(contact, "motion.phi")
        else
            call tell_field(contact, "motion.rigid_shift.x")
            call tell_field(contact, "motion.rigid_shift.y")
            call tell_field(contact, "motion.rotation")
        end if
    end subroutine

    ! By whichever of these there is.
    subroutine tell_derivatives(contact)
        type(c_ptr), intent(in) :: contact
        character(8), parameter :: of(5) = [character(8) :: "Fx", "Fy", "Mz", "Fn", "approach"]
        character(13), parameter :: by(2, 5) = reshape([character(13) :: "xi", "rigid_shift.x", &
            "eta", "rigid_shift.y", "phi", "rotation", "approach", "Fn", "mu", "mu"], [2, 5])
        character(:), allocatable :: above
        integer(c_int32_t) :: code
        real(c_double) :: value
        integer :: i, k
        do i = 1, size(of)
            above = "derivatives." // trim(of(i)) // "."
            do k = 1, size(by, 2)
                code = contactd_get(contact, above // by(1, k), value)
                if (code /= contactd_ok) code = contactd_get(contact, above // by(2, k), value)
                call tell(value, code)
            end do
        end do
    end subroutine

    subroutine tell_step(contact)
        type(c_ptr), intent(in) :: contact
        call tell_whole_field(contact, "step")
        call tell_fields(contact, "forces", 4)
        call tell_field(contact, "approach")
        call tell_field(contact, "pmax")
        call tell_fields(contact, "area", 4)
        call tell_whole_field(contact, "elements.contact")
        call tell_whole_field(contact, "elements.adhesion")
        call tell_whole_field(contact, "elements.slip")
        call tell_whole_field(contact, "elements.border")
        call tell_motion(contact)
        call tell_field(contact, "frictional_work")
        call tell_field(contact, "frictional_power")
        call tell_solvers(contact)
        call tell_derivatives(contact)
        call tell_warnings(contact)
        call tell_arrays(contact)
        call tell_fields(contact, "resultant", 6)
    end subroutine
end module answers
