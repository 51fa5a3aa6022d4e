# Transfers between particles and grid; moving least squares and the iMPM.
run projection-review velocity_projection --cells 3 --ppc 1
run projection-shifted velocity_projection --ppc 3 --jitter 0.8
for k in 1 2 4 8 16 32 64; do run projection-fmpm-$k velocity_projection --ppc 3 --jitter 0.8 --transfer fmpm --order $k; done
run mls-linear mls_approximation
run mls-sine mls_approximation --function sine --points 0 --cells 20,40,80,160
for G in 0.05 1e-4; do
    cfl=0.2765; [ $G = 1e-4 ] && cfl=0.2325  # 0.2 h/c
    impm="mms_segment --scheme impm --ppc 2 --records 10 --watch warn --G $G --cfl $cfl"
    run impm-linear-1.1-$G $impm --cells 16,32,64,128,256,512
    if [ $G = 0.05 ]; then for d in 1.1 1.5; do run impm-hat-$d-$G $impm --cells 16,32,64,128,256,512 --gradient hat --limit 1e4 --support $d || [ $? -eq 3 ]; done; fi
done
for d in 1.01 1.5; do run impm-noise-$d impm_noise --support $d --cells 32,64,128,256; done
run impm-noise-1.1 impm_noise --cells 32,64,128,256,512
for q in centre gauss; do run beam-$q impm_cantilever --quadrature $q --periods 1 --frames 1 --watch warn || [ $? -eq 3 ]; done
