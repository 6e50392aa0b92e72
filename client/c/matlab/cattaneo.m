function results = cattaneo(where)
% CATTANEO  A sphere pressed on a plane and shifted in two steps, as example/cattaneo.c:
%
%     cattaneo('ipc:///run/contactd.sock')
%
% returns a row [Fn Fx] (N) for each step. Runs in MATLAB and in Octave.
connection = contactd('open', where);
contact = contactd('new', connection);
contactd('set_grid_centred', contact, 40, 40, 0.06, 0.06);  % elements, and the size of one (mm)
contactd('set_material', contact, 'both', 200, 0.42);       % G (N/mm^2), nu
contactd('set_paraboloid', contact, 50, 50);                % radii (mm)
contactd('set_approach', contact, 0.02);                    % mm
contactd('set_mu', contact, 0.4);
contactd('set_shift', contact, 0.00817 / 2, 0, 0);          % mm in each step
contactd('want', contact, 'pressure', 1);
contactd('start', contact);
results = zeros(2, 2);
for step = 1:2
    contactd('step', contact);
    [Fn, Fx] = contactd('get_forces', contact);
    [~, adhesion, slip] = contactd('get_counts', contact);
    fprintf('step %d: Fn %.8g N, Fx %.8g N, %d elements stick, %d slip\n', step, Fn, Fx, adhesion, slip);
    pressure = contactd('get_array', contact, 'pressure', 40, 40);
    assert(abs(sum(pressure(:)) * 0.06^2 - Fn) < 1e-9 * Fn);
    results(step, :) = [Fn, Fx];
end
contactd('free', contact);
contactd('close', connection);
end
