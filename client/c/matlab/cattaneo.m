function results = cattaneo(where)
% CATTANEO  Presses a sphere on a plane and shifts it in two steps, like example/cattaneo.c:
%
%     cattaneo('ipc:///run/contactd.sock')
%
% Returns a row [Fn Fx] (N) for each step. Runs in MATLAB and in Octave.
connection = contactd('open', where);
contact = contactd('new', connection);
set = @(path, value) contactd('set', contact, path, value);
set('grid.nx', 40), set('grid.ny', 40);                  % elements
set('grid.dx', 0.06), set('grid.dy', 0.06);              % their size (mm)
set('bodies.upper.G', 200), set('bodies.upper.nu', 0.42);  % N/mm^2; the lower body equals the upper one
contactd('set_array', contact, 'gap.paraboloid', [50 50]);  % radii (mm)
set('approach', 0.02);                                   % mm
set('friction.mu', 0.4);
set('friction.rigid_shift.x', 0.00817 / 2);              % mm in each step
contactd('want', contact, 'pressure', 1);
contactd('start', contact);
results = zeros(2, 2);
for step = 1:2
    contactd('step', contact);
    Fn = contactd('get', contact, 'forces.Fn');
    Fx = contactd('get', contact, 'forces.Fx');
    adhesion = contactd('get', contact, 'elements.adhesion');
    slip = contactd('get', contact, 'elements.slip');
    fprintf('step %d: Fn %.8g N, Fx %.8g N, %d elements stick, %d slip\n', step, Fn, Fx, adhesion, slip);
    pressure = contactd('get_array', contact, 'pressure', 40, 40);
    assert(abs(sum(pressure(:)) * 0.06^2 - Fn) < 1e-9 * Fn);
    results(step, :) = [Fn, Fx];
end
contactd('free', contact);
contactd('close', connection);
end
