! Declares the functions of contactd.h. Programs use contactd.f90, which adds the enumerators and Fortran strings.
module contactd_calls
    use, intrinsic :: iso_c_binding
    implicit none

    interface
        integer(c_int32_t) function contactd_version_number() bind(c)
            import
        end function
        integer(c_int32_t) function contactd_has_local() bind(c)
            import
        end function
        integer(c_int32_t) function contactd_last_code(handle) bind(c)
            import; type(c_ptr), value :: handle
        end function
        integer(c_int32_t) function contactd_close(connection) bind(c)
            import; type(c_ptr), value :: connection
        end function
        integer(c_int32_t) function contactd_ping(connection) bind(c)
            import; type(c_ptr), value :: connection
        end function
        integer(c_int32_t) function contactd_set_timeout(connection, seconds) bind(c)
            import; type(c_ptr), value :: connection; real(c_double), value :: seconds
        end function
        integer(c_int32_t) function contactd_set_build_timeout(connection, seconds) bind(c)
            import; type(c_ptr), value :: connection; real(c_double), value :: seconds
        end function
        integer(c_int32_t) function contactd_set_connect_timeout(connection, seconds) bind(c)
            import; type(c_ptr), value :: connection; real(c_double), value :: seconds
        end function
        integer(c_int32_t) function contactd_set_log(connection, log, user) bind(c)
            import; type(c_ptr), value :: connection; type(c_funptr), value :: log; type(c_ptr), value :: user
        end function
        integer(c_int32_t) function contactd_new(connection, contact) bind(c)
            import; type(c_ptr), value :: connection; type(c_ptr), intent(out) :: contact
        end function
        integer(c_int32_t) function contactd_free(contact) bind(c)
            import; type(c_ptr), value :: contact
        end function
        integer(c_int32_t) function contactd_start(contact) bind(c)
            import; type(c_ptr), value :: contact
        end function
        integer(c_int32_t) function contactd_step(contact) bind(c)
            import; type(c_ptr), value :: contact
        end function
        integer(c_int32_t) function contactd_cancel(contact) bind(c)
            import; type(c_ptr), value :: contact
        end function
        integer(c_int32_t) function contactd_save(contact, state) bind(c)
            import; type(c_ptr), value :: contact; integer(c_int32_t), intent(out) :: state
        end function
        integer(c_int32_t) function contactd_restore(contact, state) bind(c)
            import; type(c_ptr), value :: contact; integer(c_int32_t), value :: state
        end function
        integer(c_int32_t) function contactd_forget(contact, state) bind(c)
            import; type(c_ptr), value :: contact; integer(c_int32_t), value :: state
        end function
        integer(c_int32_t) function set_table_c(contact, path, nx, ny, dx, dy, values, count) &
            bind(c, name="contactd_set_table")
            import; type(c_ptr), value :: contact; character(c_char), intent(in) :: path(*)
            integer(c_int32_t), value :: nx, ny; real(c_double), value :: dx, dy
            real(c_double), intent(in) :: values(*); integer(c_int32_t), value :: count
        end function
        integer(c_int32_t) function get_frames_c(contact, body, y, z, angle, length) &
            bind(c, name="contactd_get_frames")
            import; type(c_ptr), value :: contact; character(c_char), intent(in) :: body(*)
            integer(c_int32_t), value :: length; real(c_double), intent(out) :: y(*), z(*), angle(*)
        end function
        integer(c_int32_t) function read_profile_c(handle, path, file) bind(c, name="contactd_read_profile")
            import; type(c_ptr), value :: handle; character(c_char), intent(in) :: path(*), file(*)
        end function
        integer(c_int32_t) function contactd_step_again(contact) bind(c)
            import; type(c_ptr), value :: contact
        end function
        integer(c_int32_t) function contactd_set_step_timeout(contact, seconds) bind(c)
            import; type(c_ptr), value :: contact; real(c_double), value :: seconds
        end function

        ! Functions with texts have private names here; contactd.f90 wraps them for Fortran strings.
        type(c_ptr) function version_c() bind(c, name="contactd_version")
            import
        end function
        type(c_ptr) function code_name_c(code) bind(c, name="contactd_code_name")
            import; integer(c_int32_t), value :: code
        end function
        type(c_ptr) function last_error_c(handle) bind(c, name="contactd_last_error")
            import; type(c_ptr), value :: handle
        end function
        type(c_ptr) function last_field_c(handle) bind(c, name="contactd_last_field")
            import; type(c_ptr), value :: handle
        end function
        type(c_ptr) function last_reason_c(handle) bind(c, name="contactd_last_reason")
            import; type(c_ptr), value :: handle
        end function
        integer(c_int32_t) function open_c(where, connection) bind(c, name="contactd_open")
            import; character(c_char), intent(in) :: where(*); type(c_ptr), intent(out) :: connection
        end function
        integer(c_int32_t) function set_keys_c(connection, server_key, own_key) bind(c, name="contactd_set_keys")
            import; type(c_ptr), value :: connection; character(c_char), intent(in) :: server_key(*), own_key(*)
        end function
        integer(c_int32_t) function set_c(handle, path, value) bind(c, name="contactd_set")
            import; type(c_ptr), value :: handle; character(c_char), intent(in) :: path(*); real(c_double), value :: value
        end function
        integer(c_int32_t) function set_word_c(handle, path, word) bind(c, name="contactd_set_word")
            import; type(c_ptr), value :: handle; character(c_char), intent(in) :: path(*), word(*)
        end function
        integer(c_int32_t) function clear_c(handle, path) bind(c, name="contactd_clear")
            import; type(c_ptr), value :: handle; character(c_char), intent(in) :: path(*)
        end function
        integer(c_int32_t) function get_c(handle, path, value) bind(c, name="contactd_get")
            import; type(c_ptr), value :: handle; character(c_char), intent(in) :: path(*)
            real(c_double), intent(out) :: value
        end function
        integer(c_int32_t) function get_word_c(handle, path, text, length) bind(c, name="contactd_get_word")
            import; type(c_ptr), value :: handle; character(c_char), intent(in) :: path(*)
            character(c_char), intent(out) :: text(*); integer(c_int32_t), value :: length
        end function
        integer(c_int32_t) function set_array_c(handle, path, values, count) bind(c, name="contactd_set_array")
            import; type(c_ptr), value :: handle; character(c_char), intent(in) :: path(*)
            real(c_double), intent(in) :: values(*); integer(c_int32_t), value :: count
        end function
        integer(c_int32_t) function get_array_c(handle, path, values, count) bind(c, name="contactd_get_array")
            import; type(c_ptr), value :: handle; character(c_char), intent(in) :: path(*)
            real(c_double), intent(out) :: values(*); integer(c_int32_t), value :: count
        end function
        integer(c_int32_t) function length_c(handle, path, count) bind(c, name="contactd_length")
            import; type(c_ptr), value :: handle; character(c_char), intent(in) :: path(*)
            integer(c_int32_t), intent(out) :: count
        end function
        integer(c_int32_t) function want_c(handle, array, wanted) bind(c, name="contactd_want")
            import; type(c_ptr), value :: handle; character(c_char), intent(in) :: array(*)
            integer(c_int32_t), value :: wanted
        end function
        integer(c_int32_t) function path_c(handle, path, id) bind(c, name="contactd_path")
            import; type(c_ptr), value :: handle; character(c_char), intent(in) :: path(*)
            integer(c_int32_t), intent(out) :: id
        end function
        integer(c_int32_t) function contactd_set_at(handle, id, value) bind(c)
            import; type(c_ptr), value :: handle; integer(c_int32_t), value :: id; real(c_double), value :: value
        end function
        integer(c_int32_t) function contactd_get_at(handle, id, value) bind(c)
            import; type(c_ptr), value :: handle; integer(c_int32_t), value :: id
            real(c_double), intent(out) :: value
        end function
        integer(c_int32_t) function contactd_wheel_new(connection, wheel) bind(c)
            import; type(c_ptr), value :: connection; type(c_ptr), intent(out) :: wheel
        end function
        integer(c_int32_t) function contactd_wheel_free(wheel) bind(c)
            import; type(c_ptr), value :: wheel
        end function
        integer(c_int32_t) function contactd_wheel_solve(wheel) bind(c)
            import; type(c_ptr), value :: wheel
        end function
        integer(c_int32_t) function contactd_wheel_solve_many(wheels, count, threads) bind(c)
            import; type(c_ptr), intent(in) :: wheels(*); integer(c_int32_t), value :: count, threads
        end function
        integer(c_int32_t) function contactd_wheel_solve_wheelset(right, left) bind(c)
            import; type(c_ptr), value :: right, left
        end function
        integer(c_int32_t) function contactd_wheel_cancel(wheel) bind(c)
            import; type(c_ptr), value :: wheel
        end function
        integer(c_int32_t) function contactd_wheel_set_timeout(wheel, seconds) bind(c)
            import; type(c_ptr), value :: wheel; real(c_double), value :: seconds
        end function
        integer(c_int32_t) function creep_table_open_c(path, nu, table) bind(c, name="contactd_creep_table_open")
            import; character(c_char), intent(in) :: path(*); real(c_double), value :: nu
            type(c_ptr), intent(out) :: table
        end function
        integer(c_int32_t) function contactd_creep_table_close(table) bind(c)
            import; type(c_ptr), value :: table
        end function
        integer(c_int32_t) function creep_table_info_c(table, nu, ratios, text, size) &
            bind(c, name="contactd_creep_table_info")
            import; type(c_ptr), value :: table; real(c_double), intent(out) :: nu, ratios(2)
            character(c_char), intent(out) :: text(*); integer(c_int32_t), value :: size
        end function
        integer(c_int32_t) function contactd_creep_table_forces(table, a, b, G, mu, Fn, creepages, forces, jacobian, &
            bounds) bind(c)
            import; type(c_ptr), value :: table; real(c_double), value :: a, b, G, mu, Fn
            real(c_double), intent(in) :: creepages(3); real(c_double), intent(out) :: forces(3)
            real(c_double), intent(out), optional :: jacobian(3, 3), bounds(2) ! jacobian(j, i): of force i by creepage j
        end function
        integer(c_int32_t) function contactd_creep_table_many(table, count, contacts, creepages, forces, jacobians, &
            bounds) bind(c)
            import; type(c_ptr), value :: table; integer(c_int32_t), value :: count
            real(c_double), intent(in) :: contacts(5, *), creepages(3, *); real(c_double), intent(out) :: forces(3, *)
            real(c_double), intent(out), optional :: jacobians(3, 3, *), bounds(2, *)
        end function
        integer(c_size_t) function strlen(text) bind(c)
            import; type(c_ptr), value :: text
        end function
    end interface
end module contactd_calls
