/ Tape 3: lines in space and their perspective

        IFZERO ROTATE <   / with ROTATE these are on tape 9
/ Bounds for the eye and scale of this pass: K = 4, doubled while K*W is below
/ 1024 points; with two or three fraction bits 1 if 4*W is above 2^15.
/ In: pjw.
/ Out: nzcap, km1, the shifts of newz and zleast.
/ Destroys: nothing else.
setbnd, 0
        lac (nop
        dac shl8
        dac shl16
        dac shl32
        dac shr8
        dac shr16
        dac shr32
        IFNZRO FRACTION&2 <
        lac (rcl
        dac shl4
        lac (rcr
        dac shr4
        >
        lac (-100000+1  / -(2^17)/4
        dac nzcap
        lac (3
        dac km1
        lac pjw
        tad (-u400+1
        sma
        IFZERO FRACTION&2 <
        jmp i setbnd
        >
        IFNZRO FRACTION&2 <
        jmp sbwide
        >
        lac (rcl
        dac shl8
        lac (rcr
        dac shr8
        jms kdoubl
        lac pjw
        tad (-u200+1
        sma
        jmp i setbnd
        lac (rcl
        dac shl16
        lac (rcr
        dac shr16
        jms kdoubl
        lac pjw
        tad (-u100+1
        sma
        jmp i setbnd
        lac (rcl
        dac shl32
        lac (rcr
        dac shr32
        jms kdoubl
        jmp i setbnd
        IFNZRO FRACTION&2 <
sbwide, tad (u400-20000
        spa             / is W above 2^13?
        jmp i setbnd
        lac (400000     / K = 1
        dac nzcap
        dzm km1
        lac (skp        / pass over both shifts
        dac shl4
        dac shr4
        jmp i setbnd
        >
/ In: nzcap, km1.  Out: nzcap, km1.  Destroys: nothing else.
kdoubl, 0               / K doubles: the cap halves
        lac nzcap
        stl
        rar
        dac nzcap
        lac km1
        stl
        ral
        dac km1
        jmp i kdoubl

/ The bound B = min(K*z, 377777) and the divisor, for the point's new z.
/ In: pz.  Out: bound; the divisor of proj is pz.  Destroys: nothing else.
newz,   0
        lac pz
        IFNZRO EAE <
        dac pjz
        dac pjzn
        rcr
        dac pjh
        >
        IFZERO EAE <
        cma
        tad (1
        dac pjnz
        >
        lac pz
        tad nzcap
        sma
        jmp nzmost
        lac pz
shl4,   rcl
        rcl
shl8,   nop             / rcl for K = 8
shl16,  nop             / 16
shl32,  nop             / 32
        dac bound
        jmp i newz
nzmost, lac (377777
        dac bound
        jmp i newz

/ Follow a chain of vectors.  10 points before its X; on return at its last
/ word.  Real lines are drawn; with ringf set the corners are collected as a
/ polygon.
/ In: 10, ringf, the mask, nex ney nez; with ringf set also zh nzh ucell and a
/   polygon begun by newpol.
/ Out: 10; the lines are in the file, the corners in the polygon.
/ Destroys: px py pz bound vx vy sx sy told vecw clmpa clmpb zmin, what clip2
/   destroys; with ringf set also what corner and middle destroy.
chain,  0
        lac i 10
        tad nex
        dac px
        lac i 10
        tad ney
        dac py
        lac i 10
        tad nez
        dac pz
        jms newz
        dzm vx
        dzm vy
        lac ringf
        sza
        jms corner
        lac i 10
        cma
        tad (1
        sna
        jmp i chain
        dac nvec
vector, lac i 10
        dac vecw
        rtl             / L = bit 1, AC0 = bit 2
        szl
        jmp vecjk
        sma
        jmp flt6

/ Along i: y and z stay.
        lac px
        dac told
        lac vecw
        and (77777      / sign-extend the magnitude
        xor (40000
        tad (740000
        tad px
        dac px
        lac vecw
        sma
        jmp veciz       / a dummy
        lac vy
        sna
        jmp vicold
        lac vx
        sna
        jmp viclmp
        lac told        / the end before is known, so in the bound
        dac clmpa
        lac px
        jms clamp
        dac clmpb
        sad told
        jmp veciz
        jmp viseen
vicold, lac pz
        tad (777777
        spa
        jmp veciz
        lac py
        spa
        jmp .+3
        cma
        tad (1
        tad bound       / B - |y|
        spa
        jmp veciz
viclmp, lac told
        jms clamp
        dac clmpa
        lac px
        jms clamp
        dac clmpb
        sad clmpa
        jmp veciz
        lac vy
        sza
        jmp viseen
        lac py
        jms proj
        dac sy
        isz vy
viseen, lac sy
        dac lay
        dac lby
        lac vx
        sna
        jmp viproj
        lac clmpa
        sad told
        jmp viends
viproj, lac clmpa
        jms proj
        dac sx
viends, lac sx
        dac lax
        lac clmpb
        jms proj
        dac lbx
        dac sx
        dzm vx
        lac clmpb
        sad px
        isz vx
        jms clip2
        jmp vecend
veciz,  dzm vx
        jmp vecend

vecjk,  spa
        jmp veck

/ Along j: x and z stay.
        lac py
        dac told
        lac vecw
        and (77777
        xor (40000
        tad (740000
        tad py
        dac py
        lac vecw
        sma
        jmp vecjz
        lac vx
        sna
        jmp vjcold
        lac vy
        sna
        jmp vjclmp
        lac told        / the end before is known, so in the bound
        dac clmpa
        lac py
        jms clamp
        dac clmpb
        sad told
        jmp vecjz
        jmp vjseen
vjcold, lac pz
        tad (777777
        spa
        jmp vecjz
        lac px
        spa
        jmp .+3
        cma
        tad (1
        tad bound       / B - |x|
        spa
        jmp vecjz
vjclmp, lac told
        jms clamp
        dac clmpa
        lac py
        jms clamp
        dac clmpb
        sad clmpa
        jmp vecjz
        lac vx
        sza
        jmp vjseen
        lac px
        jms proj
        dac sx
        isz vx
vjseen, lac sx
        dac lax
        dac lbx
        lac vy
        sna
        jmp vjproj
        lac clmpa
        sad told
        jmp vjends
vjproj, lac clmpa
        jms proj
        dac sy
vjends, lac sy
        dac lay
        lac clmpb
        jms proj
        dac lby
        dac sy
        dzm vy
        lac clmpb
        sad py
        isz vy
        jms clip2
        jmp vecend
vecjz,  dzm vy
        jmp vecend

/ Along k: x and y stay, both projections move.
veck,   lac pz
        dac told
        lac vecw
        and (77777
        xor (40000
        tad (740000
        dac mag
        tad pz
        dac pz
        lac vecw
        sma
        jmp veckz
        lac vx          / the quick way: both ends in the bound
        sza
        lac vy
        sna
        jmp vkcold
        lac mag
        sma
        jmp vkin        / going away from a point in the bound
        jms newz
        lac pz
        tad (777777
        spa
        jmp vkrais
        jms inside
        spa
        jmp vkrais
        jmp vkin
vkcold, lac mag
        spa
        jmp vkrais
        lac told
        tad (777777
        spa
        jmp vkrais
        jms inside
        spa
        jmp vkrais
        lac px
        jms proj
        dac sx
        lac py
        jms proj
        dac sy
vkin,   lac sx
        dac lax
        lac sy
        dac lay
        jms newz
        jms projxy
        clc
        dac vx
        dac vy
        jms clip2
        jmp vecend      / no bend: both ends are in the bound
vkrais, lac px          / raise both ends to the least z in the bound
        jms zleast
        dac zmin
        lac py
        jms zleast
        jms raise
        dac zmin
        lac told
        jms raise
        dac clmpa
        lac pz
        jms raise
        dac clmpb
        sad clmpa
        jmp veckz
        lac clmpa
        jms setz
        lac px
        jms proj
        dac lax
        lac py
        jms proj
        dac lay
        lac clmpb
        jms setz
        jms projxy
        jms newz
        dzm vx
        dzm vy
        lac clmpb
        sad pz
        skp
        jmp veckl
        clc
        dac vx
        dac vy
veckl,  jms clip2
        jmp veckm
veckz,  jms newz
        lac ringf
        sna
        jmp veckd
        lac vx
        sza
        lac vy
        sna
        jmp veckb
        lac mag
        sma
        jmp veckd       / going away from a point in the bound: no bend
veckb,  jms middle
veckd,  dzm vx
        dzm vy
        jmp vecend
veckm,  lac ringf
        sza
        jms middle

vecend, isz nvec
        jmp vecnxt
        jmp i chain     / a ring's last corner is its first
vecnxt, lac ringf
        sza
        jms corner
        jmp vector

/ Append the corner reached, drawn back into the bound, to the polygon.
/ In: px py pz vx vy sx sy zh nzh, the polygon being made.
/ Out: the polygon; sx sy vx vy.
/ Destroys: clmpa crx cry told t1, what proj destroys.
corner, 0
        lac nzh
        tad pz
        spa
        jmp cornnr      / nearer than the plane's least z
        lac vx
        sza
        jmp corny
        lac px
        jms clamp
        dac clmpa
        jms proj
        dac sx
        lac clmpa
        sad px
        isz vx
corny,  lac vy
        sza
        jmp cornap
        lac py
        jms clamp
        dac clmpa
        jms proj
        dac sy
        lac clmpa
        sad py
        isz vy
cornap, lac sx
        dac crx
        lac sy
        dac cry
        jms append
        jmp i corner
cornnr, lac pz
        dac told
        lac zh
        dac pz
        jms newz
        lac px
        jms clamp
        jms proj
        dac crx
        lac py
        jms clamp
        jms proj
        dac cry
        jms append
        lac told
        dac pz
        jms newz
        jmp i corner

/ Along k, from told to pz, the outline may enter or leave the bound where
/ the coordinate in ucell is K*z: append that point.
/ In: px py pz told zh ucell, the polygon being made.
/ Out: the polygon; the divisor of proj is pz.
/ Destroys: clmpa clmpb zmin crx cry t1 t3 t4 t5, what proj destroys.
middle, 0
        lac i ucell
        jms zleast
        dac t3
        lac zh
        dac zmin
        lac told
        jms raise
        dac clmpa
        lac pz
        jms raise
        dac clmpb
        lac t3          / zb must lie between the two, not on them
        cma
        tad (1
        dac t4
        tad clmpa
        sna
        jmp i middle
        dac t5
        lac t4
        tad clmpb
        sna
        jmp i middle
        xor t5
        sma
        jmp i middle
        lac t3
        jms setz
        lac px
        jms proj
        dac crx
        lac py
        jms proj
        dac cry
        jms append
        lac pz
        jms setz
        jmp i middle

/ In: px py, the divisor of proj.
/ Out: lbx = sx, lby = sy.
/ Destroys: what proj destroys.
projxy, 0               / both coordinates at the point reached
        lac px
        jms proj
        dac lbx
        dac sx
        lac py
        jms proj
        dac lby
        dac sy
        jmp i projxy

/ In: px py bound.  Out: AC.  Destroys: nothing else.
inside, 0               / AC negative if |x| or |y| is beyond the bound
        lac px
        spa
        jmp .+3
        cma
        tad (1
        tad bound
        spa
        jmp i inside
        lac py
        spa
        jmp .+3
        cma
        tad (1
        tad bound
        jmp i inside

/ AC within -bound..bound.
/ In: AC, bound.  Out: AC.  Destroys: t1.
clamp,  0
        dac t1
        spa
        jmp clampn
        cma
        tad bound       / B-1 - x: at B either way gives B
        sma
        jmp clmpok
        lac bound
        jmp i clamp
clampn, tad bound
        sma
        jmp clmpok
        lac bound
        cma
        tad (1
        jmp i clamp
clmpok, lac t1
        jmp i clamp

/ AC = max(1, (|AC|+K-1)/K): the least z at which a coordinate is in the bound
/ In: AC.  Out: AC.  Destroys: t1.
zleast, 0
        sma
        jmp .+3
        cma
        tad (1
        tad km1
shr4,   rcr
        rcr
shr8,   nop             / rcr for K = 8
shr16,  nop             / 16
shr32,  nop             / 32
        dac t1
        tad (777777
        sma
        jmp zlkeep
        lac (1
        jmp i zleast
zlkeep, lac t1
        jmp i zleast

/ In: AC, zmin.  Out: AC.  Destroys: t1.
raise,  0               / AC, but not below zmin
        dac t1
        cma
        tad (1
        tad zmin
        spa
        jmp rskeep
        lac zmin
        jmp i raise
rskeep, lac t1
        jmp i raise
        >

/ Perspective: AC = sign * (|AC|*W + z/2) / z, with W in pjw, z by setz; half
/ of z is left out where quotients are cut off.
        IFNZRO EAE <
/ In: AC = z, positive.  Out: the divisor of proj.  Destroys: nothing else.
setz,   0
        dac pjz
        dac pjzn
        rcr
        dac pjh
        jmp i setz

/ In: AC, pjw, the divisor by newz or setz.
/ Out: AC.
/ Destroys: t1 and mdm without the EAE; leaves by flt3 if the quotient is too
/   large.
proj,   0
        spa
        jmp projn
        lmq
        IFZERO TRUNCATE <
        lac pjh         / mulac adds it to the product
        >
        IFNZRO TRUNCATE <
        lac (0
        >
        cll
        mulac
pjw,    0
        div
pjz,    0
        szl
        jmp flt3
        lacq
        jmp i proj
projn,  cma             / the same of a negative one
        tad (1
        dac pjx
        lac pjw
        lmq
        IFZERO TRUNCATE <
        lac pjh
        >
        IFNZRO TRUNCATE <
        lac (0
        >
        cll
        mulac
pjx,    0
        div
pjzn,   0
        szl
        jmp flt3
        lacq
        cma
        tad (1
        jmp i proj
pjh,    0
        >
        IFZERO EAE <
/ Without the EAE one loop over the bits of W multiplies and divides: q and r
/ of x*W/z grow together, so that nothing needs a double word.  Whole
/ multiples of z are taken out of x first.
setz,   0
        cma
        tad (1
        dac pjnz
        jmp i setz

proj,   0
        dac pjs
        sma
        jmp .+3
        cma
        tad (1
        dzm pjq
projsb, dac mdm         / x, less whole multiples of z
        tad pjnz
        spa
        jmp projm
        dac t1
        lac pjq
        tad pjw
        dac pjq
        lac t1
        jmp projsb
projm,  lac pjnz
        dac mdnc
        lac pjw
        jms mdloop
        tad pjq
        dac t1
        lac pjs
        spa
        jmp projng
        lac t1
        jmp i proj
projng, lac t1
        cma
        tad (1
        jmp i proj
pjw,    0               / W
pjnz,   0
pjq,    0
pjs,    0
        >

nex,    0               / minus the eye
ney,    0
nez,    0
px,     0               / the point reached, as seen from the eye
py,     0
pz,     0
bound,  0               / largest |x|, |y| at this z
nzcap,  0               / minus the z at which the bound stops growing
km1,    0               / K-1
zmin,   0
vx,     0               / nonzero: sx is the projection of px
vy,     0
sx,     0
sy,     0
nvec,   0
vecw,   0
mag,    0
told,   0
clmpa,  0
clmpb,  0
lax,    0               / the line on the screen, A to B
lay,    0
lbx,    0
lby,    0
