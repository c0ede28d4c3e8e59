fuel            0.1772870173 mgh/2  P, the one in use: see 'show fuel'
fuel_exact      0.1772870173 mgh/2  from the energy balance of one cycle
fuel_paper      0.5922924467 mgh/2  closed form of (c7), 1 - cos theta_f - d sin theta_f
