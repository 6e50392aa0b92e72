package Contactd "Contact of wheels on rails, by the C library of contactd"

  class WheelObject "A wheel on its rail, kept between calls"
    extends ExternalObject;

    function constructor "Opens it: S1002 on 60E1 at 1/40, of steel"
      input String endpoint "\"local\": solved in this process; or the endpoint of a daemon";
      input String side "\"left\" or \"right\"";
      input String theory "\"full\", \"fastsim\", \"hertz\", \"fastrip\" or \"polach\"";
      input Real friction "Coefficient of friction";
      input Real element(unit = "m") "Size of the elements along and across the rail";
      output WheelObject wheel;
      external "C" wheel = contactd_modelica_open(endpoint, side, theory, friction, element)
        annotation(Include = "#include \"contactd_modelica.h\"", IncludeDirectory = "modelica://Contactd/Resources/Include", Library = "contactd-local");
    end constructor;

    function destructor "Gives it back"
      input WheelObject wheel;
      external "C" contactd_modelica_close(wheel)
        annotation(Include = "#include \"contactd_modelica.h\"", IncludeDirectory = "modelica://Contactd/Resources/Include", Library = "contactd-local");
    end destructor;
  end WheelObject;

  function wrench "Forces and moments on the rail, in the wheelset's axes and about its centre"
    input WheelObject wheel;
    input Real y(unit = "m") "Of the wheelset's centre, to the right";
    input Real yaw(unit = "rad") "From x to y";
    input Real velocity(unit = "m/s") "Forwards";
    input Real yRate(unit = "m/s");
    input Real yawRate(unit = "rad/s");
    input Real pitchRate(unit = "rad/s") "Rolling forwards is near -velocity over the radius";
    input Real load(unit = "N") "Vertical force on the rail";
    output Real w[6] "Fx, Fy, Fz (N), Mx, My, Mz (N.m)";
    external "C" contactd_modelica_solve(wheel, y, yaw, velocity, yRate, yawRate, pitchRate, load, w, size(w, 1))
      annotation(Include = "#include \"contactd_modelica.h\"", IncludeDirectory = "modelica://Contactd/Resources/Include", Library = "contactd-local");
  end wrench;

  class CreepTable "Creep forces of steady rolling from a file, at one Poisson's ratio"
    extends ExternalObject;

    function constructor "Opens it"
      input String path "The file that contactctl table build writes";
      input Real nu "Poisson's ratio";
      output CreepTable table;
      external "C" table = contactd_modelica_table_open(path, nu)
        annotation(Include = "#include \"contactd_modelica.h\"", IncludeDirectory = "modelica://Contactd/Resources/Include", Library = "contactd-local");
    end constructor;

    function destructor "Closes it"
      input CreepTable table;
      external "C" contactd_modelica_table_close(table)
        annotation(Include = "#include \"contactd_modelica.h\"", IncludeDirectory = "modelica://Contactd/Resources/Include", Library = "contactd-local");
    end destructor;
  end CreepTable;

  function creepForces "Forces on the upper body in steady rolling along x"
    input CreepTable table;
    input Real a(unit = "m") "Semi-axis along x";
    input Real b(unit = "m") "Semi-axis along y";
    input Real G(unit = "N/m2") "Shear modulus of the combined material";
    input Real mu "Coefficient of friction";
    input Real load(unit = "N") "Normal force";
    input Real xi "Longitudinal creepage";
    input Real eta "Lateral creepage";
    input Real phi(unit = "1/m") "Spin";
    output Real w[3] "Fx, Fy (N), Mz (N.m)";
    external "C" contactd_modelica_creep_forces(table, a, b, G, mu, load, xi, eta, phi, w, size(w, 1))
      annotation(Include = "#include \"contactd_modelica.h\"", IncludeDirectory = "modelica://Contactd/Resources/Include", Library = "contactd-local");
  end creepForces;

  package Examples "Whole models"

    model Wheelset "A wheelset that is free across the track and about the vertical, from 3 mm beside the middle"
      parameter Real mass(unit = "kg") = 1000;
      parameter Real inertia(unit = "kg.m2") = 600;
      parameter Real stiffness(unit = "N/m") = 0 "Of springs across the track";
      parameter Real yawStiffness(unit = "N.m/rad") = 0;
      parameter Real velocity(unit = "m/s") = 10;
      parameter Real radius(unit = "m") = 0.46;
      parameter Real load(unit = "N") = 50e3 "Of each wheel";
      parameter Real element(unit = "m") = 1e-3;
      WheelObject left = WheelObject("local", "left", "fastsim", 0.3, element);
      WheelObject right = WheelObject("local", "right", "fastsim", 0.3, element);
      Real y(start = 3e-3, fixed = true, unit = "m");
      Real yaw(start = 0, fixed = true, unit = "rad");
      Real yRate(start = 0, fixed = true, unit = "m/s");
      Real yawRate(start = 0, fixed = true, unit = "rad/s");
      Real onLeft[6] "On the left rail";
      Real onRight[6] "On the right rail";
    equation
      onLeft = wrench(left, y, yaw, velocity, yRate, yawRate, -velocity/radius, load);
      onRight = wrench(right, y, yaw, velocity, yRate, yawRate, -velocity/radius, load);
      der(y) = yRate;
      der(yaw) = yawRate;
      mass*der(yRate) = -onLeft[2] - onRight[2] - stiffness*y;
      inertia*der(yawRate) = -onLeft[6] - onRight[6] - yawStiffness*yaw;
      annotation(experiment(StopTime = 1, Tolerance = 1e-6));
    end Wheelset;

  end Examples;

  annotation(version = "0.1.0", uses());
end Contactd;
