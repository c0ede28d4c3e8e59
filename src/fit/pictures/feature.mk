NEEDS_fit_pictures := fit pictures
