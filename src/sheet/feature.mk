# A page about a row, which ends in what 'fit' reads.
NEEDS_sheet := fit pictures rows
