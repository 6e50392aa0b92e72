! What the driver in Fortran says of a wheel on its rail: wheel_telling.py has the order.
module wheel_answers
    use contactd
    use answers, only: need, tell, tell_whole, digest
    use, intrinsic :: iso_fortran_env, only: int64
    implicit none
    private
    public :: tell_wheel

contains

    subroutine tell_numbers(values, code)
        real(c_double), intent(in) :: values(:)
        integer(c_int32_t), intent(in) :: code
        integer :: i
        do i = 1, size(values)
            call tell(values(i), code)
        end do
    end subroutine

    subroutine tell_arrays(wheel, patch, elements)
        type(c_ptr), intent(in) :: wheel
        integer(c_int32_t), intent(in) :: patch, elements
        real(c_double) :: array(elements)
        integer(c_int32_t) :: division(elements), which, code
        integer(int64) :: sum, bits
        integer :: i
        call need(contactd_wheel_get_division(wheel, patch, division, elements))
        sum = 0
        do i = 1, elements
            call digest(sum, int(division(i), int64))
        end do
        write (*, "(1x, i0)", advance="no") sum
        do which = contactd_pressure, contactd_gap
            ! Quick models have no gap.
            code = contactd_wheel_get_array(wheel, patch, which, array, elements)
            if (which == contactd_gap .and. code /= contactd_ok) then
                array = 0
            else
                call need(code)
            end if
            sum = 0
            do i = 1, elements
                bits = transfer(array(i), 0_int64)
                call digest(sum, ibits(bits, 32, 32))
                call digest(sum, ibits(bits, 0, 32))
            end do
            write (*, "(1x, i0)", advance="no") sum
        end do
    end subroutine

    subroutine tell_patch(wheel, patch)
        type(c_ptr), intent(in) :: wheel
        integer(c_int32_t), intent(in) :: patch
        real(c_double) :: v(6)
        integer(c_int32_t) :: nx, ny, n(4), in, code
        integer :: i
        code = contactd_wheel_get_place(wheel, patch, v(1), v(2), v(3), v(4))
        call tell_numbers(v(:4), code)
        code = contactd_wheel_get_grid(wheel, patch, nx, ny, v(1), v(2), v(3), v(4))
        call tell_whole(nx, code)
        call tell_whole(ny, code)
        call tell_numbers(v(:4), code)
        code = contactd_wheel_get_creepages(wheel, patch, v(1), v(2), v(3), v(4))
        call tell_numbers(v(:4), code)
        code = contactd_wheel_get_radii(wheel, patch, v(1), v(2), v(3), v(4))
        call tell_numbers(v(:4), code)
        code = contactd_wheel_get_contact_forces(wheel, patch, v(1), v(2), v(3), v(4))
        call tell_numbers(v(:4), code)
        do in = contactd_in_track, contactd_in_wheelset
            code = contactd_wheel_get_patch_forces(wheel, patch, in, v)
            call tell_numbers(v, code)
        end do
        code = contactd_wheel_get_pressure(wheel, patch, v(1), v(2))
        call tell_numbers(v(:2), code)
        code = contactd_wheel_get_areas(wheel, patch, v(1), v(2), v(3))
        call tell_numbers(v(:3), code)
        code = contactd_wheel_get_counts(wheel, patch, n(1), n(2), n(3), n(4))
        do i = 1, 4
            call tell_whole(n(i), code)
        end do
        call tell_arrays(wheel, patch, nx * ny)
    end subroutine

    subroutine tell_warnings(wheel)
        type(c_ptr), intent(in) :: wheel
        character(2000) :: text
        integer(c_int32_t) :: warnings, i
        integer(int64) :: sum
        integer :: c
        sum = 0
        call need(contactd_wheel_get_warnings(wheel, warnings))
        do i = 0, warnings - 1
            call need(contactd_wheel_get_warning(wheel, i, text))
            do c = 1, len_trim(text)
                call digest(sum, int(ichar(text(c:c)), int64))
            end do
        end do
        write (*, "(1x, i0, 1x, i0)", advance="no") warnings, sum
    end subroutine

    subroutine tell_wheel(wheel)
        type(c_ptr), intent(in) :: wheel
        real(c_double) :: v(6)
        integer(c_int32_t), parameter :: searches(3) = [contactd_force, contactd_pitch, contactd_rail_shift]
        integer(c_int32_t) :: in, by, n, converged, patch, code
        integer :: search
        code = contactd_wheel_get_motion(wheel, v(1), v(2))
        call tell_numbers(v(:2), code)
        code = contactd_wheel_get_clearance(wheel, v(1))
        call tell(v(1), code)
        do in = contactd_in_track, contactd_in_wheelset
            code = contactd_wheel_get_forces(wheel, in, v)
            call tell_numbers(v, code)
        end do
        do by = contactd_by_position_y, contactd_by_velocity_pitch
            code = contactd_wheel_get_derivative(wheel, by, v)
            call tell_numbers(v, code)
        end do
        code = contactd_wheel_get_converged(wheel, converged)
        call tell_whole(converged, code)
        code = contactd_wheel_get_rail_shift(wheel, v(1), v(2))
        call tell_numbers(v(:2), code)
        do search = 1, size(searches)
            code = contactd_wheel_get_evidence(wheel, searches(search), n, v(1), converged)
            call tell_whole(n, code)
            call tell(v(1), code)
            call tell_whole(converged, code)
        end do
        call tell_warnings(wheel)
        code = contactd_wheel_get_patches(wheel, n)
        call tell_whole(n, code)
        do patch = 0, n - 1
            call tell_patch(wheel, patch)
        end do
    end subroutine
end module wheel_answers
