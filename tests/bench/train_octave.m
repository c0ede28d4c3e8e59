## SPDX-License-Identifier: GPL-3.0-or-later
## The questions of the benchmark, as a user of GNU Octave would solve them: energies for many tilts at once,
## roots by fzero, integrals by quadgk.
## Reads questions, one a line and blank ones between (see the end), and answers each with the seconds that it took
## and a number.
1;
## No file is left behind where the benchmark is stopped.
crash_dumps_octave_core (false);
sigterm_dumps_octave_core (false);
sighup_dumps_octave_core (false);

## The maximum of f over [0, last], f(0) = 0: the best of a few tilts, then of as many around it, and so on.  f is
## asked for all of them at once, which takes less time than fminbnd.
function height = highest (f, last, tol)
  heights = f ([1e-6, (1:16) / 16] * last);
  [height, k] = max (heights);
  if (height <= 0 || k == 17)   # upright, or at the end
    height = max (height, 0);
    return;
  endif
  lo = max (k - 2, 0) / 16 * last;
  hi = k / 16 * last;
  do
    theta = linspace (lo, hi, 17);
    [top, k] = max (f (theta));
    height = max (height, top);
    lo = theta(max (k - 1, 1));
    hi = theta(min (k + 1, 17));
  until (hi - lo < sqrt (tol) * last)   # the height is right to the square of that
endfunction

## An endless train: what one growth r has in common for all tilts.
function t = train_at (s, r, d, q, tol)
  L = s + d;
  t = struct ("r", r, "d", d, "L", L, "weight", r^-q, "inertia", r^-(q + 1), "enough", tol / 100,
              "theta_c", asin (min (r * s, 1)), "theta_leave", Inf, "h_f", 0);
  if (1 / r^2 < L^2 - d^2)
    t.theta_leave = acos (min ((L^2 + d^2 - 1 / r^2) / (2 * d * L), 1));
    theta_f = asin (min ((1 + r^2 * (L^2 - d^2)) / (2 * r * L), 1));
    t.h_f = cos (theta_f) + d * sin (theta_f);
  endif
  [fall, J] = rise (t, t.theta_c);
  T = t.inertia * J;
  t.kinetic = -fall * T / (r^q * (1 + T) - T);
endfunction

## H(theta) - H(0) and J(theta), term by term until the rest no longer matters.  The upright train goes along as
## the last column.
function [H, J] = rise (t, theta)
  rounding = 1e-15;   # of the difference of two heights
  theta = [theta, 0];
  H = J = size_ = zeros (1, numel (theta));
  weight = inertia = 1;
  slope = on = ones (1, numel (theta));
  while (true)
    c = cos (theta);
    height = c + t.d * sin (theta);
    term = weight * on .* (height - height(end));
    H += term;
    size_ += abs (term);
    J += inertia * on .* slope .^ 2;
    weight *= t.weight;
    inertia *= t.inertia;
    if (theta(end) >= t.theta_leave)
      break;
    endif
    X = t.r * (t.L * c - t.d);
    stays = theta < t.theta_leave;
    next = theta + asin (min (X, 1));
    if (! all (stays))   # who falls off during this cycle keeps its energy
      left = on & ! stays;
      H(left) += weight * (t.h_f - cos (next(end)) - t.d * sin (next(end)));
      on = on & stays;
    endif
    steep = theta > 0;
    slope(steep) .*= 1 - t.r * t.L * sin (theta(steep)) ./ sqrt (max (1 - X(steep) .^ 2, realmin));
    differs = abs (next - next(end)) - rounding;
    theta = next;
    if (all (! on(1:end-1) | (weight * differs + inertia * slope .^ 2)(1:end-1) < t.enough * size_(1:end-1)))
      break;
    endif
  endwhile
  H = H(1:end-1);
  J = J(1:end-1);
endfunction

function m = margin_at (s, r, d, q, tol)
  t = train_at (s, r, d, q, tol);
  m = t.kinetic - highest (@(theta) rise (t, theta), t.theta_c, tol);
endfunction

function r = rmax (tol, s, d, q)
  margin = @(r) margin_at (s, r, d, q, tol);
  if (margin (1) < 0)
    r = NaN;
  elseif (margin (1 / s) >= 0)
    r = 1 / s;
  else
    r = fzero (margin, [1, 1 / s], optimset ("TolX", tol));
  endif
endfunction

function w = slowness (f, kinetic, theta)
  [fall, J] = f (theta(:)');
  w = reshape (sqrt (J ./ (kinetic - fall)), size (theta));
endfunction

function t_f = duration (tol, s, r, d, q)
  t = train_at (s, r, d, q, tol);
  f = @(theta) rise (t, theta);
  if (t.kinetic < highest (f, t.theta_c, tol))
    t_f = NaN;
  else
    t_f = quadgk (@(theta) slowness (f, t.kinetic, theta), 0, t.theta_c, "AbsTol", 0, "RelTol", max (tol, 1e-14));
  endif
endfunction

## Twice the energy over that of the upright ones, and the inertia, of domino k of a row and all that lean on it.
function [E, J] = moving (row, k, theta)
  theta = [theta, 0];
  E = J = zeros (1, numel (theta));
  slope = ones (1, numel (theta));
  for j = k:-1:1
    E += row.mass(j) * row.g * (row.height(j) * cos (theta) + row.thick(j) * sin (theta));
    J += row.inertia(j) * slope .^ 2;
    if (j > 1)
      pitch = row.gap(j) + row.thick(j);
      X = (pitch * cos (theta) - row.thick(j)) / row.height(j-1);
      slope .*= 1 - pitch * sin (theta) ./ (row.height(j-1) * sqrt (1 - X .^ 2));
      theta += asin (X);
    endif
  endfor
  E = E(1:end-1) - E(end);
  J = J(1:end-1);
endfunction

## Seconds until the last domino of a row lies, each domino with its own measures.
function clock = row_time (tol, n, growth, s, d, h, g, push)
  height = h * growth .^ (0:n-1);
  row = struct ("g", g, "height", height, "thick", d * height, "gap", s * height, "mass", growth .^ (3 * (0:n-1)));
  row.inertia = row.mass .* (row.height .^ 2 + row.thick .^ 2) / 3;
  clock = 0;
  momentum = row.inertia(1) * push;
  for k = 1:n
    f = @(theta) moving (row, k, theta);
    [~, J] = f (0);
    kinetic = momentum^2 / J;   # twice
    last = pi / 2;
    if (k < n)
      last = asin (row.gap(k+1) / row.height(k));
    endif
    if (kinetic < highest (f, last, tol))
      clock = NaN;
      return;
    endif
    clock += quadgk (@(theta) slowness (f, kinetic, theta), 0, last, "AbsTol", 0, "RelTol", max (tol, 1e-14));
    [E, J] = f (last);
    momentum = sqrt (J * (kinetic - E));
  endfor
endfunction

## NAME NUMBER...: the name of a question and its arguments.
while (ischar (line = fgetl (stdin)))
  if (isempty (line))
    continue;
  endif
  [name, numbers] = strtok (line);
  n = sscanf (numbers, "%f");
  begun = tic ();
  switch (name)
    case "rmax"
      answer = rmax (n(1), n(2), n(4), n(5));
    case "duration"
      answer = duration (n(1), n(2), n(3), n(4), n(5));
    case "row"
      answer = row_time (n(1), n(2), n(3), n(4), n(5), n(6), n(7), n(8));
  endswitch
  seconds = toc (begun);
  printf ("%.9g %.17g\n", seconds, answer);
  fflush (stdout);
endwhile
