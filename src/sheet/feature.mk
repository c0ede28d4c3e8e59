# The page ends in what 'fit' reads.
NEEDS_sheet := fit pictures
