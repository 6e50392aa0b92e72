! What the driver in Fortran says of a wheel on its rail: wheel_telling.py has the order.
module wheel_answers
    use contactd
    use answers, only: need, tell, tell_whole, digest, tell_array, arrays, sure_arrays
    use, intrinsic :: iso_fortran_env, only: int64
    implicit none
    private
    public :: tell_wheel

contains

    subroutine tell_field(wheel, path)
        type(c_ptr), intent(in) :: wheel
        character(*), intent(in) :: path
        real(c_double) :: value
        integer(c_int32_t) :: code
        code = contactd_get(wheel, path, value)
        call tell(value, code)
    end subroutine

    subroutine tell_whole_field(wheel, path)
        type(c_ptr), intent(in) :: wheel
        character(*), intent(in) :: path
        real(c_double) :: value
        integer(c_int32_t) :: code
        value = 0
        code = contactd_get(wheel, path, value)
        call tell_whole(int(value, c_int32_t), code)
    end subroutine

    ! The numbers of an object.
    subroutine tell_object(wheel, path, numbers)
        type(c_ptr), intent(in) :: wheel
        character(*), intent(in) :: path
        integer(c_int32_t), intent(in) :: numbers
        real(c_double) :: v(numbers)
        integer(c_int32_t) :: code
        integer :: i
        code = contactd_get_array(wheel, path, v, numbers)
        do i = 1, numbers
            call tell(v(i), code)
        end do
    end subroutine

    subroutine tell_forces(wheel, prefix)
        type(c_ptr), intent(in) :: wheel
        character(*), intent(in) :: prefix
        call tell_object(wheel, prefix // "forces.track", 6)
        call tell_object(wheel, prefix // "forces.rail", 6)
        call tell_object(wheel, prefix // "forces.wheelset", 6)
    end subroutine

    subroutine tell_arrays(wheel, prefix)
        type(c_ptr), intent(in) :: wheel
        character(*), intent(in) :: prefix
        real(c_double), allocatable :: array(:)
        integer(c_int32_t) :: elements, code
        integer :: which
        call need(contactd_length(wheel, prefix // "solution.pressure", elements))
        allocate (array(elements))
        do which = 1, size(arrays) - 1
            code = contactd_get_array(wheel, prefix // "solution." // arrays(which), array, elements)
            if (which <= sure_arrays) call need(code)
            if (code /= contactd_ok) array = 0
            call tell_array(array, which == 1)
        end do
        ! Simplified models have no gap.
        code = contactd_get_array(wheel, prefix // "gap", array, elements)
        if (code /= contactd_ok) array = 0
        call tell_array(array, .false.)
    end subroutine

    subroutine tell_patch(wheel, patch)
        type(c_ptr), intent(in) :: wheel
        integer, intent(in) :: patch
        character(9), parameter :: counts(4) = [character(9) :: "contact", "adhesion", "slip", "border"]
        character(2), parameter :: sizes(4) = ["dx", "dy", "x0", "y0"]
        character(8), parameter :: creepages(4) = [character(8) :: "xi", "eta", "phi", "velocity"]
        character(40) :: text
        character(:), allocatable :: prefix
        integer :: i
        write (text, "(a, i0, a)") "patches[", patch, "]."
        prefix = trim(text)
        call tell_object(wheel, prefix // "place.reference", 4)
        call tell_whole_field(wheel, prefix // "place.grid.nx")
        call tell_whole_field(wheel, prefix // "place.grid.ny")
        do i = 1, 4
            call tell_field(wheel, prefix // "place.grid." // sizes(i))
        end do
        do i = 1, 4
            call tell_field(wheel, prefix // "place.creepages." // creepages(i))
        end do
        call tell_object(wheel, prefix // "place.radii", 4)
        call tell_object(wheel, prefix // "solution.forces", 4)
        call tell_forces(wheel, prefix)
        call tell_field(wheel, prefix // "solution.approach")
        call tell_field(wheel, prefix // "solution.pmax")
        call tell_object(wheel, prefix // "solution.area", 4)
        do i = 1, 4
            call tell_whole_field(wheel, prefix // "solution.elements." // counts(i))
        end do
        call tell_arrays(wheel, prefix)
    end subroutine

    subroutine tell_warnings(wheel)
        type(c_ptr), intent(in) :: wheel
        character(2000) :: text
        character(40) :: path
        real(c_double) :: warnings
        integer(int64) :: sum
        integer :: i, c
        sum = 0
        call need(contactd_get(wheel, "warnings", warnings))
        do i = 0, int(warnings) - 1
            write (path, "(a, i0, a)") "warnings[", i, "]"
            call need(contactd_get_word(wheel, path, text))
            do c = 1, len_trim(text)
                call digest(sum, int(ichar(text(c:c)), int64))
            end do
        end do
        write (*, "(1x, i0, 1x, i0)", advance="no") int(warnings), sum
    end subroutine

    subroutine tell_wheel(wheel)
        type(c_ptr), intent(in) :: wheel
        character(14), parameter :: inputs(10) = [character(14) :: "position.y", "position.z", "position.roll", &
            "position.yaw", "velocity.x", "velocity.y", "velocity.z", "velocity.roll", "velocity.yaw", "velocity.pitch"]
        character(12), parameter :: searches(3) = [character(12) :: "force", "pitch_search", "rail_search"]
        real(c_double) :: patches
        integer :: i
        call tell_field(wheel, "z")
        call tell_field(wheel, "pitch_rate")
        call tell_field(wheel, "clearance")
        call tell_forces(wheel, "")
        do i = 1, size(inputs)
            call tell_object(wheel, "derivatives." // inputs(i), 6)
        end do
        call tell_whole_field(wheel, "converged")
        call tell_object(wheel, "rail_deflection", 2)
        do i = 1, size(searches)
            call tell_whole_field(wheel, trim(searches(i)) // ".iterations")
            call tell_field(wheel, trim(searches(i)) // ".residual")
            call tell_whole_field(wheel, trim(searches(i)) // ".converged")
        end do
        call tell_warnings(wheel)
        call tell_whole_field(wheel, "patches")
        call need(contactd_get(wheel, "patches", patches))
        do i = 0, int(patches) - 1
            call tell_patch(wheel, i)
        end do
    end subroutine
end module wheel_answers
