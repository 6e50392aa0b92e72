! A sphere pressed on a plane and shifted in two steps, as example/cattaneo.c:
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

    call check(contactd_set_grid_centred(contact, 40, 40, 0.06d0, 0.06d0)) ! elements, and the size of one (mm)
    call check(contactd_set_material(contact, contactd_both, 200d0, 0.42d0)) ! G (N/mm^2), nu
    call check(contactd_set_paraboloid(contact, 50d0, 50d0)) ! radii (mm)
    call check(contactd_set_approach(contact, 0.02d0)) ! mm
    call check(contactd_set_mu(contact, 0.4d0))
    call check(contactd_set_shift(contact, 0.00817d0 / 2, 0d0, 0d0)) ! mm in each step
    call check(contactd_want(contact, "pressure", 1))
    call check(contactd_start(contact))
    do step = 1, 2
        call advance()
    end do
    call check(contactd_free(contact))
    call check(contactd_close(connection))

contains

    subroutine advance()
        real(c_double) :: Fn, Fx, Fy, Mz, pressure(40, 40)
        integer(c_int32_t) :: number, all, adhesion, slip, border

        call check(contactd_step(contact))
        call check(contactd_get_step(contact, number))
        call check(contactd_get_forces(contact, Fn, Fx, Fy, Mz))
        call check(contactd_get_counts(contact, all, adhesion, slip, border))
        call check(contactd_get_array(contact, "pressure", pressure, size(pressure, kind=c_int32_t)))
        print "(a, i0, a, es16.9, a, es16.9, a, i0, a, i0, a)", "step ", number, ": Fn ", Fn, " N, Fx ", Fx, " N, ", &
            adhesion, " elements stick, ", slip, " slip"
        if (abs(sum(pressure) * 0.06d0**2 - Fn) > 1d-9 * Fn) error stop "the pressures do not sum up to Fn"
    end subroutine

    ! Ends the program with the sentence of what failed.
    subroutine check(code)
        integer(c_int32_t), intent(in) :: code
        if (code == contactd_ok) return
        print "(3a)", contactd_code_name(code), ": ", contactd_last_error(contact)
        stop 1
    end subroutine
end program cattaneo
