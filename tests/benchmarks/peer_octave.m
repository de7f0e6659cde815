% Octave's ode45 and lsode, for peer_octave.py. The first line of the standard input holds the
% constants of the aircraft; each line after it a job, whose answer is one line: the seconds that
% it took by Octave's own clock, and the states. An empty line is the last.
1;

% x is [v; r; y; theta], each of one trajectory or stacked of many; p is {a, Ct, u, constants}.
function dx = rates (x, p)
  [a, Ct, u, c] = p{:};
  x = reshape (x, [], 4);
  v = x(:, 1);
  r = x(:, 2);
  friction = c.B5 + c.C5 * c.FZ;
  slip = (c.B3 + c.C3 * c.FZ) * ((v + a .* r) ./ u) / friction;
  psi = (1 - c.E1) * slip + c.E1 / c.B1 * atan (c.B1 * slip);
  main = 2 * c.D1 * sin (c.C1 * atan (c.B1 * psi)) * friction * c.FZ;
  tail = 0.5 * c.RHO * u .* u * c.AP * c.CL_GAMMA + Ct;
  side = tail .* atan ((v - c.ARM_B * r) ./ u);
  dx = [(-main - side) / c.MASS - u .* r; (-a .* main + c.ARM_B * side) / c.IZZ; v; r];
end

function x = solve (method, tol, t, x0, p)
  if strcmp (method, "lsode")
    x = lsode (@(x, t) rates (x, p), x0, t);
  else
    options = odeset ("RelTol", tol, "AbsTol", 1e-3 * tol);
    [~, x] = ode45 (@(t, x) rates (x, p), t, x0, options);
  end
end

sigterm_dumps_octave_core (false);
lsode_options ("integration method", "adams");
constants = jsondecode (input ("", "s"));
% fgetl would wait for a character of the next line
while ! isempty (line = input ("", "s"))
  job = jsondecode (line);
  lsode_options ("relative tolerance", job.tol);
  lsode_options ("absolute tolerance", 1e-3 * job.tol);
  states = {};
  tic;
  for k = 1:columns (job.draws)
    % a column of a, Ct, u, v0 is one trajectory, or all of them stacked
    d = reshape (job.draws(:, k), [], 4);
    x0 = [d(:, 4); zeros(3 * rows (d), 1)];
    states{k} = solve (job.method, job.tol, job.times, x0, {d(:, 1), d(:, 2), d(:, 3), constants});
  end
  seconds = toc;
  if job.final
    states = cellfun (@(x) x(end, :), states, "UniformOutput", false);
  end
  printf ("%.17g ", seconds, vertcat (states{:}).');
  printf ("\n");
  fflush (stdout);
end
