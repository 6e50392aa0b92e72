! Presses a sphere on a plane and shifts it in two steps, like example/cattaneo.c:
!
!     contactd-fortran-example ipc:///run/contactd.sock
program cattaneo
    use contactd
    implicit none
    type(c_ptr) :: connection, contact
    character(256) :: where
    integer :: step

    if (command_argument_count() /= 1) error stop "usage: contactd-fortran-example ENDPOINT"
    call get_command_argument(1, where)
    contact = c_null_ptr
    call check(contactd_open(where, connection))
    call check(contactd_new(connection, contact))

    call set("grid.nx", 40d0) ! elements
    call set("grid.ny", 40d0)
    call set("grid.dx", 0.06d0) ! their size (mm)
    call set("grid.dy", 0.06d0)
    call set("bodies.upper.G", 200d0) ! N/mm^2; the lower body equals the upper one
    call set("bodies.upper.nu", 0.42d0)
    call set("gap.paraboloid.Rx", 50d0) ! mm
    call set("gap.paraboloid.Ry", 50d0)
    call set("approach", 0.02d0) ! mm
    call set("friction.mu", 0.4d0)
    call set("friction.rigid_shift.x", 0.00817d0 / 2) ! mm in each step
    call check(contactd_want(contact, "pressure", 1))
    call check(contactd_start(contact))
    do step = 1, 2
        call advance()
    end do
    call check(contactd_free(contact))
    call check(contactd_close(connection))

contains

    subroutine set(path, value)
        character(*), intent(in) :: path
        real(c_double), intent(in) :: value
        call check(contactd_set(contact, path, value))
    end subroutine

    subroutine advance()
        real(c_double) :: number, Fn, Fx, adhesion, slip, pressure(40, 40)

        call check(contactd_step(contact))
        call check(contactd_get(contact, "step", number))
        call check(contactd_get(contact, "forces.Fn", Fn))
        call check(contactd_get(contact, "forces.Fx", Fx))
        call check(contactd_get(contact, "elements.adhesion", adhesion))
        call check(contactd_get(contact, "elements.slip", slip))
        call check(contactd_get_array(contact, "pressure", pressure, size(pressure, kind=c_int32_t)))
        print "(a, i0, a, es16.9, a, es16.9, a, i0, a, i0, a)", "step ", nint(number), ": Fn ", Fn, " N, Fx ", Fx, " N, ", &
            nint(adhesion), " elements stick, ", nint(slip), " slip"
        if (abs(sum(pressure) * 0.06d0**2 - Fn) > 1d-9 * Fn) error stop "the pressures do not sum up to Fn"
    end subroutine

    ! Ends the program with the error message.
    subroutine check(code)
        integer(c_int32_t), intent(in) :: code
        if (code == contactd_ok) return
        print "(3a)", contactd_code_name(code), ": ", contactd_last_error(contact)
        stop 1
    end subroutine
end program cattaneo
