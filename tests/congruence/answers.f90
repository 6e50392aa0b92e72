! What the driver in Fortran says of a step: telling.py has the order.
module answers
    use contactd
    use, intrinsic :: iso_fortran_env, only: int64
    implicit none
    private
    public :: need, tell, tell_whole, digest, tell_array, tell_step, arrays

    ! Arrays over the grid, of which a contact has all but the last and a wheel all.
    character(16), parameter :: arrays(7) = [character(16) :: "element_division", "pressure", &
        "traction_x", "traction_y", "slip_x", "slip_y", "gap"]

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

    subroutine tell_arrays(contact, elements)
        type(c_ptr), intent(in) :: contact
        integer(c_int32_t), intent(in) :: elements
        real(c_double) :: array(elements)
        integer :: which
        do which = 1, 6
            call need(contactd_get_array(contact, arrays(which), array, elements))
            call tell_array(array, which == 1)
        end do
    end subroutine

    subroutine tell_warnings(contact)
        type(c_ptr), intent(in) :: contact
        character(2000) :: text
        integer(c_int32_t) :: warnings, i
        integer(int64) :: sum
        integer :: c
        sum = 0
        call need(contactd_get_warnings(contact, warnings))
        do i = 0, warnings - 1
            call need(contactd_get_warning(contact, i, text))
            do c = 1, len_trim(text)
                call digest(sum, int(ichar(text(c:c)), int64))
            end do
        end do
        write (*, "(1x, i0, 1x, i0)", advance="no") warnings, sum
    end subroutine

    subroutine tell_solvers(contact)
        type(c_ptr), intent(in) :: contact
        integer(c_int32_t) :: solver, iterations, converged, code
        real(c_double) :: v(3)
        integer :: i
        call need(contactd_get_converged(contact, converged))
        call tell_whole(converged, contactd_ok)
        do solver = contactd_normal, contactd_force
            code = contactd_get_evidence(contact, solver, iterations, v(1), converged)
            call tell_whole(iterations, code)
            call tell(v(1), code)
            call tell_whole(converged, code)
        end do
        code = contactd_get_discretisation(contact, iterations, v(1), v(2), v(3))
        call tell_whole(iterations, code)
        do i = 1, 3
            call tell(v(i), code)
        end do
    end subroutine

    subroutine tell_step(contact, nx, ny)
        type(c_ptr), intent(in) :: contact
        integer(c_int32_t), intent(in) :: nx, ny
        integer(c_int32_t) :: n(4), of, by, code
        real(c_double) :: v(4)
        integer :: i
        code = contactd_get_step(contact, n(1))
        call tell_whole(n(1), code)
        code = contactd_get_forces(contact, v(1), v(2), v(3), v(4))
        do i = 1, 4
            call tell(v(i), code)
        end do
        code = contactd_get_approach(contact, v(1))
        call tell(v(1), code)
        code = contactd_get_pmax(contact, v(1))
        call tell(v(1), code)
        code = contactd_get_areas(contact, v(1), v(2), v(3))
        do i = 1, 3
            call tell(v(i), code)
        end do
        code = contactd_get_counts(contact, n(1), n(2), n(3), n(4))
        do i = 1, 4
            call tell_whole(n(i), code)
        end do
        code = contactd_get_creepages(contact, v(1), v(2), v(3))
        if (code /= contactd_ok) code = contactd_get_shift(contact, v(1), v(2), v(3))
        do i = 1, 3
            call tell(v(i), code)
        end do
        code = contactd_get_frictional_work(contact, v(1))
        call tell(v(1), code)
        code = contactd_get_frictional_power(contact, v(1))
        call tell(v(1), code)
        call tell_solvers(contact)
        do of = contactd_of_fx, contactd_of_approach
            do by = contactd_by_x, contactd_by_mu
                code = contactd_get_derivative(contact, of, by, v(1))
                call tell(v(1), code)
            end do
        end do
        call tell_warnings(contact)
        call tell_arrays(contact, nx * ny)
        call tell_resultant(contact)
    end subroutine

    subroutine tell_resultant(contact)
        type(c_ptr), intent(in) :: contact
        integer(c_int32_t) :: code
        real(c_double) :: forces(6)
        integer :: i
        forces = 0
        code = contactd_get_resultant(contact, forces)
        do i = 1, 6
            call tell(forces(i), code)
        end do
    end subroutine
end module answers
