# The dam break with a barrier in motion, coloured by the speed.
film = 2
load 'dam_break_film.gp'
