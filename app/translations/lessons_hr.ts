<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="hr" sourcelanguage="en">
<context>
    <name>ideas</name>
    <message>
        <source>Wrong ideas, and what refutes them</source>
        <translation>Pogrešne predodžbe i što ih opovrgava</translation>
    </message>
    <message>
        <source>n is where I look</source>
        <translation>n je kamo gledam</translation>
    </message>
    <message>
        <source>This takes the direction of view for {0}. The camera looks along {1}: {2} runs from the target back to the eye, so that with {3} to the right and {4} up the three axes are right-handed.</source>
        <translation>Ovo uzima smjer gledanja kao {0}. Kamera gleda duž {1}: {2} ide od cilja natrag prema kameri, tako da su s {3} udesno i {4} gore tri osi desni sustav.</translation>
    </message>
    <message>
        <source>My up vector is v</source>
        <translation>Moj vektor prema gore je v</translation>
    </message>
    <message>
        <source>This takes the normalised up vector for {0}. Up only has to point roughly upwards; {1} is at a right angle to the view direction, so the more the camera looks down, the farther {2} tilts away from up.</source>
        <translation>Ovo uzima normirani vektor prema gore kao {0}. On treba pokazivati samo otprilike gore; {1} je okomit na smjer gledanja, pa se {2} to više naginje od smjera prema gore što kamera više gleda dolje.</translation>
    </message>
    <message>
        <source>Unit times unit is a unit</source>
        <translation>Jedinični puta jedinični je jedinični</translation>
    </message>
    <message>
        <source>This does not normalise the cross product of up and {0}, because both are unit vectors. But its length is the sine of the angle between them, so {1} is the product divided by that length; otherwise everything measured along {2} is too short.</source>
        <translation>Ovo ne normira vektorski umnožak smjera prema gore i {0}, jer su oba jedinični vektori. Ali njegova je duljina sinus kuta između njih, pa je {1} umnožak podijeljen tom duljinom; inače je sve mjereno duž {2} prekratko.</translation>
    </message>
    <message>
        <source>The view matrix puts the camera in its place</source>
        <translation>Matrica pogleda stavlja kameru na njezino mjesto</translation>
    </message>
    <message>
        <source>This writes down the inverse of the view matrix, which moves a camera from the origin to its place. The view matrix does the opposite: it moves the world until the eye is at the origin, so its last column is minus the eye along {0}, {1} and {2}, not the eye.</source>
        <translation>Ovo zapisuje inverz matrice pogleda, koji kameru iz ishodišta pomiče na njezino mjesto. Matrica pogleda čini suprotno: pomiče svijet dok kamera ne bude u ishodištu, pa je njezin posljednji stupac minus položaj kamere duž {0}, {1} i {2}, a ne položaj kamere.</translation>
    </message>
    <message>
        <source>Rows and columns may change places</source>
        <translation>Retci i stupci smiju zamijeniti mjesta</translation>
    </message>
    <message>
        <source>This reads the matrix with rows and columns exchanged. Points are columns here, {0}, so a cell {1} says how much of coordinate {2} goes into coordinate {3}, and the axes are the columns.</source>
        <translation>Ovo čita matricu sa zamijenjenim retcima i stupcima. Točke su ovdje stupci, {0}, pa ćelija {1} kaže koliko koordinate {2} ulazi u koordinatu {3}, a osi su stupci.</translation>
    </message>
    <message>
        <source>The order does not matter</source>
        <translation>Redoslijed nije važan</translation>
    </message>
    <message>
        <source>This multiplies the factors in the opposite order. The factor on the right acts first. First rotating and then moving differs from first moving and then rotating, because the later rotation rotates the move as well.</source>
        <translation>Ovo množi faktore obrnutim redom. Prvi djeluje faktor zdesna. Najprije rotirati pa pomaknuti nije isto što i najprije pomaknuti pa rotirati, jer kasnija rotacija rotira i pomak.</translation>
    </message>
    <message>
        <source>The function takes my degrees</source>
        <translation>Funkcija uzima moje stupnjeve</translation>
    </message>
    <message>
        <source>This passes degrees to a function that expects radians. 60 degrees are {0} radians; 60 radians are nine and a half turns, so the result can be anything, even of the opposite sign, and the picture upside down.</source>
        <translation>Ovo predaje stupnjeve funkciji koja očekuje radijane. 60 stupnjeva je {0} radijana; 60 radijana je devet i pol okreta, pa rezultat može biti bilo što, čak i suprotnog predznaka, a slika naopačke.</translation>
    </message>
    <message>
        <source>The lens takes the whole angle</source>
        <translation>Objektiv uzima cijeli kut</translation>
    </message>
    <message>
        <source>This takes the tangent or cotangent of the whole field of view. The right-angled triangle lies between the axis and the edge of the picture and contains half of the angle: at 90° the lens has {0}, whereas {1} is 0.</source>
        <translation>Ovo uzima tangens ili kotangens cijelog vidnog polja. Pravokutni trokut leži između osi i ruba slike i sadrži polovicu kuta: kod 90° objektiv ima {0}, dok je {1} jednak 0.</translation>
    </message>
    <message>
        <source>Twice the angle is twice the width</source>
        <translation>Dvostruki kut je dvostruka širina</translation>
    </message>
    <message>
        <source>This assumes that widths are proportional to angles. They are proportional to the tangent of half the angle: with 120° high and 16:9 that tangent is 1.73 upwards and 3.08 sideways, so the picture is 144.0° wide: 72.0° on each side, not 213°, which no picture can be.</source>
        <translation>Ovo pretpostavlja da su širine proporcionalne kutovima. One su proporcionalne tangensu polovice kuta: uz 120° u visinu i 16:9 taj je tangens 1.73 u visinu i 3.08 u širinu, pa je slika široka 144.0°: 72.0° na svaku stranu, a ne 213°, što nijedna slika ne može biti.</translation>
    </message>
    <message>
        <source>An angle is an angle</source>
        <translation>Kut je kut</translation>
    </message>
    <message>
        <source>This uses the vertical angle in place of the horizontal one. A picture that is wider than high reaches farther sideways than upwards, as width to height, and so does the tangent of half the angle; only then do circles stay round.</source>
        <translation>Ovo koristi vertikalni kut umjesto horizontalnog. Slika koja je šira nego viša seže dalje u širinu nego u visinu, u omjeru širine i visine, a tako i tangens polovice kuta; samo tada kružnice ostaju okrugle.</translation>
    </message>
    <message>
        <source>I measure from the picture plane</source>
        <translation>Mjerim od ravnine slike</translation>
    </message>
    <message>
        <source>This divides by the distance from the plane, {0}. The two similar triangles share the corner at the eye, so measure both depths from the eye: {1}.</source>
        <translation>Ovo dijeli s udaljenošću od ravnine, {0}. Dva slična trokuta imaju zajednički vrh kod kamere, zato obje dubine mjerite od kamere: {1}.</translation>
    </message>
    <message>
        <source>Dividing by z is enough</source>
        <translation>Dovoljno je dijeliti sa z</translation>
    </message>
    <message>
        <source>This has the sign for the wrong side of the eye: in front of it {0} is negative, and {1} is the result for a film *behind* the hole. A plane in front of the eye has {2} and an upright image; only a film behind it, at {3}, has it upside down.</source>
        <translation>Ovo ima predznak za pogrešnu stranu kamere: ispred nje {0} je negativan, a {1} je rezultat za film *iza* rupice. Ravnina ispred kamere ima {2} i uspravnu sliku; naopačke je samo na filmu iza nje, na {3}.</translation>
    </message>
    <message>
        <source>Near enlarges</source>
        <translation>Bliska ravnina povećava</translation>
    </message>
    <message>
        <source>This multiplies the picture by {0}. The image on the near plane does grow with {1}, but so does the window round it. {2} does not contain {3}: near only decides what is cut.</source>
        <translation>Ovo množi sliku s {0}. Slika na bliskoj ravnini doista raste s {1}, ali raste i prozor oko nje. {2} ne sadrži {3}: bliska ravnina samo odlučuje što se odsijeca.</translation>
    </message>
    <message>
        <source>near 1</source>
        <translation>bliska 1</translation>
    </message>
    <message>
        <source>near 2</source>
        <translation>bliska 2</translation>
    </message>
    <message>
        <source>Near is a z, so it is negative</source>
        <translation>Bliska ravnina je z, pa je negativna</translation>
    </message>
    <message>
        <source>This uses a negative number where a length belongs. Near, far and the distance of a picture plane are lengths from the eye, and positive; the planes are at negative {0}, and the formulas already contain that minus.</source>
        <translation>Ovo koristi negativan broj ondje gdje treba duljina. Udaljenosti bliske i daleke ravnine te ravnine slike duljine su od kamere, i pozitivne su; ravnine su na negativnom {0}, a formule već sadrže taj minus.</translation>
    </message>
    <message>
        <source>n and f may change places</source>
        <translation>n i f smiju zamijeniti mjesta</translation>
    </message>
    <message>
        <source>This swaps {0} and {1}, which changes the sign of {2} and of everything divided by it. The near plane would then be at {3}, where the far plane belongs, and all depths would run backwards.</source>
        <translation>Ovo zamjenjuje {0} i {1}, što mijenja predznak od {2} i od svega što se time dijeli. Bliska ravnina tada bi bila na {3}, gdje pripada daleka, a sve bi dubine išle unatrag.</translation>
    </message>
    <message>
        <source>A window to the right moves the picture right</source>
        <translation>Prozor udesno pomiče sliku udesno</translation>
    </message>
    <message>
        <source>This shifts the picture to the same side as the window. The window frames what you see: if its middle is right of the axis, the axis appears left of the picture&apos;s middle, at {0}. The matrix has a plus there because that cell is multiplied by {1}, which is negative.</source>
        <translation>Ovo pomiče sliku na istu stranu kao prozor. Prozor uokviruje ono što vidite: ako mu je sredina desno od osi, os se pojavljuje lijevo od sredine slike, u {0}. Matrica ondje ima plus jer se ta ćelija množi s {1}, što je negativno.</translation>
    </message>
    <message>
        <source>Cameras turn as eyes do</source>
        <translation>Kamere se okreću kao oči</translation>
    </message>
    <message>
        <source>This toes the two cameras in, because eyes turn to what they look at. But each turned camera divides by the depth along its own axis, so points at the sides are not equally high in both pictures, and no pair of eyes can look up with one eye and down with the other: both cameras look straight ahead, and their windows move.</source>
        <translation>Ovo okreće dvije kamere jednu prema drugoj, jer se oči okreću prema onome što gledaju. Ali svaka okrenuta kamera dijeli s dubinom duž vlastite osi, pa točke sa strana nisu jednako visoko na objema slikama, a nikoji par očiju ne može jednim okom gledati gore, a drugim dolje: obje kamere gledaju ravno naprijed, a pomiču se njihovi prozori.</translation>
    </message>
    <message>
        <source>Far is always small</source>
        <translation>Daleko je uvijek malo</translation>
    </message>
    <message>
        <source>This divides by the depth, although the projectors are parallel. A parallel lens divides every point by 1, so equal heights stay equal at every depth.</source>
        <translation>Ovo dijeli s dubinom premda su zrake projiciranja paralelne. Paralelni objektiv svaku točku dijeli s 1, pa jednake visine ostaju jednake na svakoj dubini.</translation>
    </message>
    <message>
        <source>Clip is NDC</source>
        <translation>Odsijecanje je NDC</translation>
    </message>
    <message>
        <source>This stops at the clip coordinates. The division by {0} is still to come, {1} and {2}; it makes far things small.</source>
        <translation>Ovo staje kod koordinata odsijecanja. Dijeljenje s {0} tek dolazi, {1} i {2}; ono čini daleke stvari malima.</translation>
    </message>
    <message>
        <source>z needs no divide</source>
        <translation>z ne treba dijeliti</translation>
    </message>
    <message>
        <source>This stops before the division. The depth is divided by {0} like {1} and {2}: only then does far come to 1, and only then do straight lines stay straight.</source>
        <translation>Ovo staje prije dijeljenja. Dubina se dijeli s {0} kao {1} i {2}: samo tada daleka ravnina dolazi u 1 i samo tada pravci ostaju pravci.</translation>
    </message>
    <message>
        <source>Depth is the distance to the eye</source>
        <translation>Dubina je udaljenost do kamere</translation>
    </message>
    <message>
        <source>This measures straight from the eye to the point. Depth is measured along the axis only, because near and far are planes, not spheres: a point at the side is farther away than it is deep.</source>
        <translation>Ovo mjeri ravno od kamere do točke. Dubina se mjeri samo duž osi, jer su bliska i daleka ravnina ravnine, a ne sfere: točka sa strane udaljenija je nego što joj je dubina.</translation>
    </message>
    <message>
        <source>Depth runs evenly</source>
        <translation>Dubina teče jednoliko</translation>
    </message>
    <message>
        <source>This spreads the depth evenly between near and far. But {0} changes with one over the depth, so the cube is filled fast at first: its middle is less than twice as deep as near.</source>
        <translation>Ovo dubinu raspoređuje jednoliko između bliske i daleke ravnine. Ali {0} se mijenja s jedan kroz dubinu, pa se kocka isprva brzo puni: njezina je sredina na manje od dvostruke dubine bliske ravnine.</translation>
    </message>
    <message>
        <source>Near stays where it is in the pyramid</source>
        <translation>Bliska ravnina u piramidi ostaje gdje jest</translation>
    </message>
    <message>
        <source>This leaves the near plane at {0}. On the way into the canonical pyramid everything is divided by {1}, so far comes to {2} and near to {3}.</source>
        <translation>Ovo ostavlja blisku ravninu na {0}. Na putu u kanonsku piramidu sve se dijeli s {1}, pa daleka ravnina dolazi u {2}, a bliska u {3}.</translation>
    </message>
    <message>
        <source>NDC starts at 0</source>
        <translation>NDC počinje od 0</translation>
    </message>
    <message>
        <source>This takes an NDC coordinate for a share from 0 to 1. It runs from {0} to {1} with 0 in the middle, so first add 1 and then halve: {2} and depth {3}.</source>
        <translation>Ovo uzima koordinatu NDC kao udio od 0 do 1. Ona ide od {0} do {1}, s 0 u sredini, zato najprije dodajte 1, a zatim prepolovite: {2} i dubina {3}.</translation>
    </message>
    <message>
        <source>Pixel rows count up</source>
        <translation>Retci piksela broje se prema gore</translation>
    </message>
    <message>
        <source>This counts the rows of pixels upwards, like {0}. The image begins at its upper left corner and its rows count downwards: the higher a point is, the smaller is its row.</source>
        <translation>Ovo broji retke piksela prema gore, kao {0}. Slika počinje u gornjem lijevom kutu i njezini se retci broje prema dolje: što je točka viša, to joj je redak manji.</translation>
    </message>
    <message>
        <source>Pixel 100 is at 100</source>
        <translation>Piksel 100 je na 100</translation>
    </message>
    <message>
        <source>This takes a pixel&apos;s number for the position of its centre. Pixel {0} reaches from {1} to {2}, so its centre is at {3}, so {4}: the outer centres of four pixels are at {5}, not at {6}.</source>
        <translation>Ovo uzima broj piksela kao položaj njegova središta. Piksel {0} seže od {1} do {2}, pa mu je središte na {3}, i {4}: vanjska središta četiriju piksela su u {5}, a ne u {6}.</translation>
    </message>
    <message>
        <source>k makes up the difference</source>
        <translation>k nadoknađuje razliku</translation>
    </message>
    <message>
        <source>This adds the whole missing length at one end and again at the other. Both ends get the same share, so each gets half of what is missing.</source>
        <translation>Ovo dodaje cijelu duljinu koja nedostaje na jednom kraju i još jednom na drugom. Oba kraja dobivaju isti dio, dakle svaki polovicu onoga što nedostaje.</translation>
    </message>
    <message>
        <source>stretched</source>
        <translation>rastegnuto</translation>
    </message>
    <message>
        <source>variant X</source>
        <translation>varijanta X</translation>
    </message>
    <message>
        <source>X adjusts x</source>
        <translation>X podešava x</translation>
    </message>
    <message>
        <source>This takes the letter for the coordinate that changes. Variant X *keeps* {0} and {1} and adjusts {2} until the window has the picture&apos;s proportions; variant Y keeps {3} and adjusts {4}.</source>
        <translation>Ovo uzima slovo kao koordinatu koja se mijenja. Varijanta X *zadržava* {0} i {1} i podešava {2} dok prozor ne dobije proporcije slike; varijanta Y zadržava {3} i podešava {4}.</translation>
    </message>
    <message>
        <source>variant Y</source>
        <translation>varijanta Y</translation>
    </message>
    <message>
        <source>The slant grows with alpha</source>
        <translation>Nagib raste s alfa</translation>
    </message>
    <message>
        <source>This takes {0} for the slant. {1} is the angle between the projectors and the picture, so at 90° they meet it head-on and nothing is shifted. The formula is {2}; at 80° the shift is only 0.18 for each unit of depth.</source>
        <translation>Ovo uzima {0} kao nagib. {1} je kut između zraka projiciranja i slike, pa je pod 90° sijeku okomito i ništa se ne pomiče. Formula je {2}; kod 80° pomak je samo 0.18 za svaku jedinicu dubine.</translation>
    </message>
    <message>
        <source>Half the scale, half the slant</source>
        <translation>Pola mjerila, pola nagiba</translation>
    </message>
    <message>
        <source>This assumes that the angle is proportional to the scale. The scale is the cotangent of the angle, {0}, so a cabinet drawing with {1} has {2}, not 67.5°.</source>
        <translation>Ovo pretpostavlja da je kut proporcionalan mjerilu. Mjerilo je kotangens kuta, {0}, pa kabinetski crtež s {1} ima {2}, a ne 67.5°.</translation>
    </message>
    <message>
        <source>Infinity is very far</source>
        <translation>Beskonačno je vrlo daleko</translation>
    </message>
    <message>
        <source>This takes a point that is very far away for the point at infinity. A direction has {0} and no starting point, so its image depends on the direction alone, {1}; every point on the way there falls short of it.</source>
        <translation>Ovo uzima vrlo daleku točku kao beskonačno daleku. Smjer ima {0} i nema početnu točku, pa njegova slika ovisi samo o smjeru, {1}; nijedna točka na putu onamo ne doseže je.</translation>
    </message>
    <message>
        <source>A box has three</source>
        <translation>Kvadar ih ima tri</translation>
    </message>
    <message>
        <source>This counts the directions of the box. Only a direction that is not parallel to the picture has a vanishing point, {0}; edges that are parallel to the picture stay parallel in it.</source>
        <translation>Ovo broji smjerove kvadra. Nedogled ima samo smjer koji nije paralelan sa slikom, {0}; bridovi paralelni sa slikom na njoj ostaju paralelni.</translation>
    </message>
    <message>
        <source>Join the two images</source>
        <translation>Spojite dvije slike</translation>
    </message>
    <message>
        <source>This divides both ends and joins the results. An end behind the eye has {0}, and its image is mirrored. The right image of the segment runs through infinity, not between the two, so cut the segment in front of the eye before dividing.</source>
        <translation>Ovo dijeli oba kraja i spaja rezultate. Kraj iza kamere ima {0}, i slika mu je zrcaljena. Prava slika dužine ide kroz beskonačnost, a ne između njih, zato dužinu odsijecite ispred kamere prije dijeljenja.</translation>
    </message>
    <message>
        <source>The middle of the picture is the middle of the edge</source>
        <translation>Sredina slike je sredina brida</translation>
    </message>
    <message>
        <source>This interpolates {0} itself on the screen. There {1} and {2} are linear, so {3}, and the middle of the picture shows a place that is closer to the nearer end.</source>
        <translation>Ovo na ekranu interpolira sam {0}. Ondje su linearni {1} i {2}, pa je {3}, i sredina slike pokazuje mjesto bliže bližem kraju.</translation>
    </message>
    <message>
        <source>A lamp is a sun</source>
        <translation>Svjetiljka je sunce</translation>
    </message>
    <message>
        <source>This takes the lamp&apos;s position for a direction that all rays share. From a lamp each ray has its own direction, {0}, and meets the ground at {1}; only the sun is so far away that all rays are parallel.</source>
        <translation>Ovo uzima položaj svjetiljke kao smjer koji dijele sve zrake. Iz svjetiljke svaka zraka ima vlastiti smjer, {0}, i siječe tlo u {1}; samo je sunce tako daleko da su sve zrake paralelne.</translation>
    </message>
    <message>
        <source>As sharp behind as before</source>
        <translation>Oštro iza koliko i ispred</translation>
    </message>
    <message>
        <source>This puts the far limit as far behind the focus as the near limit is in front of it. The limits are {0} and {1}. Their reciprocals are equally far from {2}, so the sharp range reaches farther behind than in front, and it has no end from {3} on.</source>
        <translation>Ovo stavlja dalju granicu jednako daleko iza ravnine izoštravanja kao što je bliža ispred nje. Granice su {0} i {1}. Njihove su recipročne vrijednosti jednako udaljene od {2}, pa oštro područje seže dalje iza nego ispred, a od {3} nadalje nema kraja.</translation>
    </message>
    <message>
        <source>Zooming is walking</source>
        <translation>Zumiranje je hodanje</translation>
    </message>
    <message>
        <source>This keeps the size ratio of the old place after a walk. A zoom enlarges the whole picture by one factor, but sizes are proportional to one over the distance. Walking therefore changes {0}, the size ratio of a thing and an equal one {1} behind it.</source>
        <translation>Ovo zadržava omjer veličina sa starog mjesta nakon hodanja. Zum povećava cijelu sliku jednim faktorom, ali veličine su proporcionalne s jedan kroz udaljenost. Zato hodanje mijenja {0}, omjer veličine stvari i njoj jednake {1} iza nje.</translation>
    </message>
    <message>
        <source>More places than pixels are enough</source>
        <translation>Dovoljno je više mjesta nego piksela</translation>
    </message>
    <message>
        <source>This counts the places of a coordinate against the pixels of a picture. The places are spread over the whole scene, {0} apart, and a picture may show a small part of it: there the gap between two of 65 536 places can be wider than a pixel.</source>
        <translation>Ovo uspoređuje broj mjesta koordinate s brojem piksela slike. Mjesta su raspoređena po cijeloj sceni, razmaknuta {0}, a slika može pokazivati njezin mali dio: ondje razmak između dva od 65 536 mjesta može biti širi od piksela.</translation>
    </message>
    <message>
        <source>Seven digits, so seven are right</source>
        <translation>Sedam znamenaka, dakle sedam točnih</translation>
    </message>
    <message>
        <source>This takes the digits of a coordinate for those of the picture. A float32 keeps 24 bits of the whole number; when eye and vertex, both near 1 000 000, are subtracted, the leading digits go and the rounding stays, so two or three digits are left.</source>
        <translation>Ovo uzima znamenke koordinate kao znamenke slike. Broj float32 čuva 24 bita cijelog broja; kad se oduzmu kamera i vrh, oboje blizu 1 000 000, vodeće znamenke odlaze, a zaokruživanje ostaje, pa preostaju dvije ili tri znamenke.</translation>
    </message>
    <message>
        <source>An error is the same everywhere</source>
        <translation>Pogreška je svuda ista</translation>
    </message>
    <message>
        <source>This takes the error in the scene for the error in the picture. A vertex is stored wrong by a fixed length, but a length is drawn with {0} pixels a unit: twice as near, every error is twice as large.</source>
        <translation>Ovo uzima pogrešku u sceni kao pogrešku na slici. Vrh je spremljen pogrešno za stalnu duljinu, ali duljina se crta s {0} piksela po jedinici: na upola manjoj udaljenosti svaka je pogreška dvostruko veća.</translation>
    </message>
    <message>
        <source>Seven digits, so 360 steps keep five</source>
        <translation>Sedam znamenaka, pa 360 koraka čuva pet</translation>
    </message>
    <message>
        <source>This takes the digits of the format for those of the result. How much a step loses depends on what it does: with a fast inverse square root each renormalising is off by 0.17 %, and after one round two digits are left, in float32 and in float64.</source>
        <translation>Ovo uzima znamenke formata kao znamenke rezultata. Koliko korak gubi, ovisi o tome što čini: s brzim inverznim korijenom svako renormiranje griješi 0.17 %, i nakon jednog kruga ostaju dvije znamenke, u float32 i u float64.</translation>
    </message>
    <message>
        <source>Renormalising repairs the direction</source>
        <translation>Renormiranje popravlja smjer</translation>
    </message>
    <message>
        <source>This expects of axes that are made orthonormal again that they point where they should. Renormalising knows the lengths, 1, and the angles between the axes, 90°. It does not know where the camera should look, so the drift of the direction stays.</source>
        <translation>Ovo od osi koje se ponovno ortonormiraju očekuje da pokazuju kamo trebaju. Renormiranje zna duljine, 1, i kutove između osi, 90°. Ne zna kamo kamera treba gledati, pa odlutavanje smjera ostaje.</translation>
    </message>
    <message>
        <source>Logarithmic depth is always better</source>
        <translation>Logaritamska dubina uvijek je bolja</translation>
    </message>
    <message>
        <source>This takes a better spread of digits for a better depth. A logarithm at each pixel is right everywhere; at the vertices it is interpolated linearly on the screen, where only {0} is linear. A piece whose far end is {1} times as far as its near end is drawn up to {2} times too far.</source>
        <translation>Ovo uzima bolji raspored znamenaka kao bolju dubinu. Logaritam u svakom pikselu svuda je točan; u vrhovima se interpolira linearno na ekranu, gdje je linearno samo {0}. Komad čiji je dalji kraj {1} puta dalje od bližega crta se do {2} puta dalje nego što treba.</translation>
    </message>
    <message>
        <source>Fine enough is equal</source>
        <translation>Dovoljno fino je jednako</translation>
    </message>
    <message>
        <source>This takes a small error for none. Two grids put the same vertex at two places, however many bits they have: more bits make the gap narrower, and from near enough it is seen again. Only a common grid rounds both copies alike.</source>
        <translation>Ovo uzima malu pogrešku kao nikakvu. Dvije rešetke stavljaju isti vrh na dva mjesta, koliko god bitova imale: više bitova sužava procjep, a iz dovoljne blizine opet se vidi. Samo zajednička rešetka obje kopije zaokružuje jednako.</translation>
    </message>
    <message>
        <source>The inverse undoes exactly</source>
        <translation>Inverz poništava egzaktno</translation>
    </message>
    <message>
        <source>This takes the inverse on paper for the one in the computer. Its cells are rounded, and so is each product. Far from the origin the eye&apos;s coordinates are large, and the inverse multiplies them with a small difference of rounded numbers: float32 misses a point by per cent of its distance.</source>
        <translation>Ovo uzima inverz s papira kao onaj u računalu. Njegove su ćelije zaokružene, a tako i svaki umnožak. Daleko od ishodišta koordinate kamere su velike, i inverz ih množi malom razlikom zaokruženih brojeva: float32 promašuje točku za postotke njezine udaljenosti.</translation>
    </message>
    <message>
        <source>First the move, then the turn</source>
        <translation>Najprije pomak, zatim okret</translation>
    </message>
    <message>
        <source>This moves first and then turns. A rotation turns about the world&apos;s origin, so it carries the moved object along a circle: {0} turns it in its place, {1} swings it round.</source>
        <translation>Ovo najprije pomiče, a zatim okreće. Rotacija okreće oko ishodišta svijeta, pa pomaknuti objekt nosi po kružnici: {0} okreće ga na njegovu mjestu, a {1} ga vodi ukrug.</translation>
    </message>
    <message>
        <source>A scale leaves the move alone</source>
        <translation>Skaliranje ne dira pomak</translation>
    </message>
    <message>
        <source>This moves first and then scales. A scale is about the world&apos;s origin, so it multiplies the move, too: with a factor of 2 a move by 3 ends at 6.</source>
        <translation>Ovo najprije pomiče, a zatim skalira. Skaliranje polazi od ishodišta svijeta, pa množi i pomak: uz faktor 2 pomak za 3 završava na 6.</translation>
    </message>
    <message>
        <source>The mirror stands beside the object</source>
        <translation>Zrcalo stoji pokraj objekta</translation>
    </message>
    <message>
        <source>This moves first and then mirrors. The mirror is a plane through the world&apos;s origin, so it takes a move by 3 to the other side, to {0}.</source>
        <translation>Ovo najprije pomiče, a zatim zrcali. Zrcalo je ravnina kroz ishodište svijeta, pa pomak za 3 prebacuje na drugu stranu, u {0}.</translation>
    </message>
    <message>
        <source>Scale and turn may change places</source>
        <translation>Skaliranje i okret smiju zamijeniti mjesta</translation>
    </message>
    <message>
        <source>This turns first and then scales along the world&apos;s axes. With unequal factors the turned object loses its right angles. Scaled first, along its own axes, and then turned, it keeps them.</source>
        <translation>Ovo najprije okreće, a zatim skalira duž osi svijeta. Uz nejednake faktore okrenuti objekt gubi prave kutove. Ako se najprije skalira, duž vlastitih osi, a zatim okrene, zadržava ih.</translation>
    </message>
    <message>
        <source>Mirror and turn may change places</source>
        <translation>Zrcaljenje i okret smiju zamijeniti mjesta</translation>
    </message>
    <message>
        <source>This turns first and then mirrors. A mirror reverses the turns that were made before it, so the mirrored object is turned by minus the angle.</source>
        <translation>Ovo najprije okreće, a zatim zrcali. Zrcaljenje obrće okrete koji su učinjeni prije njega, pa je zrcaljeni objekt okrenut za minus taj kut.</translation>
    </message>
    <message>
        <source>Shear and turn may change places</source>
        <translation>Smicanje i okret smiju zamijeniti mjesta</translation>
    </message>
    <message>
        <source>This turns first and then shears along the world&apos;s axes. Sheared first, the object has its slant along its own axes, and takes it along when it turns.</source>
        <translation>Ovo najprije okreće, a zatim primjenjuje smicanje duž osi svijeta. Ako se smicanje primijeni prvo, nagib objekta ide duž njegovih vlastitih osi i okreće se s njim.</translation>
    </message>
    <message>
        <source>Turns about two axes may change places</source>
        <translation>Okreti oko dviju osi smiju zamijeniti mjesta</translation>
    </message>
    <message>
        <source>This exchanges two rotations about different axes. Read from the right, each turns about an axis of the world, which stays fixed. Read from the left, each turns about an axis that the turns before have moved.</source>
        <translation>Ovo zamjenjuje dvije rotacije oko različitih osi. Čita li se zdesna, svaka okreće oko osi svijeta, koja miruje. Čita li se slijeva, svaka okreće oko osi koju su prethodni okreti pomaknuli.</translation>
    </message>
    <message>
        <source>The camera turns before it moves</source>
        <translation>Kamera se okreće prije nego što se pomakne</translation>
    </message>
    <message>
        <source>This rotates before the eye is at the origin. The view matrix first moves the eye to the origin and then rotates about it, so the translation stands on the right of the rotation.</source>
        <translation>Ovo rotira prije nego što je kamera u ishodištu. Matrica pogleda najprije pomiče kameru u ishodište, a zatim rotira oko njega, pa translacija stoji desno od rotacije.</translation>
    </message>
    <message>
        <source>The view comes before the object</source>
        <translation>Pogled dolazi prije objekta</translation>
    </message>
    <message>
        <source>This puts the view matrix on the right of the object&apos;s moves. A point starts in object space: the object&apos;s matrix takes it to the world, and only then the view matrix takes it to the camera.</source>
        <translation>Ovo stavlja matricu pogleda desno od pomicanja objekta. Točka počinje u koordinatnom sustavu objekta: matrica objekta prebacuje je u svijet, i tek je zatim matrica pogleda prebacuje u koordinatni sustav kamere.</translation>
    </message>
    <message>
        <source>Project first, then look</source>
        <translation>Najprije projicirati, zatim gledati</translation>
    </message>
    <message>
        <source>This projects before the points are in camera space. The lens makes {0} of {1}, which is the depth only in camera space. Of a point of the world it takes the world&apos;s {2}, and {3} is no longer the depth.</source>
        <translation>Ovo projicira prije nego što su točke u koordinatnom sustavu kamere. Objektiv čini {0} od {1}, a to je dubina samo u koordinatnom sustavu kamere. Od točke svijeta uzima njezin globalni {2}, pa {3} više nije dubina.</translation>
    </message>
    <message>
        <source>The depths are stretched first</source>
        <translation>Dubine se rastežu prve</translation>
    </message>
    <message>
        <source>This puts {0} on the right of {1}. {2} stretches depths that run from 0 to {3}, and only {4} makes such depths.</source>
        <translation>Ovo stavlja {0} desno od {1}. {2} rasteže dubine koje idu od 0 do {3}, a takve dubine daje samo {4}.</translation>
    </message>
    <message>
        <source>The box needs no pyramid</source>
        <translation>Kvadru ne treba piramida</translation>
    </message>
    <message>
        <source>This puts {0} on the right of {1}. {2} needs the canonical pyramid, with far at {3} and sides at {4}, and only {5} makes it.</source>
        <translation>Ovo stavlja {0} desno od {1}. {2} treba kanonsku piramidu, s dalekom ravninom na {3} i stranama na {4}, a nju daje samo {5}.</translation>
    </message>
    <message>
        <source>Pixels before the divide</source>
        <translation>Pikseli prije dijeljenja</translation>
    </message>
    <message>
        <source>This counts pixels before the division by {0}. The viewport needs {1} and {2} from {3} to 1, and only the division makes them: its shift to the middle of the picture would be divided, too.</source>
        <translation>Ovo broji piksele prije dijeljenja s {0}. Prozor prikaza treba {1} i {2} od {3} do 1, a daje ih samo dijeljenje: inače bi se dijelio i njegov pomak u sredinu slike.</translation>
    </message>
    <message>
        <source>The divide is done twice</source>
        <translation>Dijeli se dvaput</translation>
    </message>
    <message>
        <source>This divides {0}, {1} and {2} by {3} and keeps {4}, so the next division divides them again. Once divided, a point has {5}, and dividing by that changes nothing.</source>
        <translation>Ovo dijeli {0}, {1} i {2} s {3} i zadržava {4}, pa ih sljedeće dijeljenje opet dijeli. Nakon dijeljenja točka ima {5}, a dijeljenje tim brojem ništa ne mijenja.</translation>
    </message>
    <message>
        <source>Clockwise is positive</source>
        <translation>U smjeru kazaljke na satu je pozitivno</translation>
    </message>
    <message>
        <source>This turns by minus the angle. An angle is positive anticlockwise, seen from the tip of its axis: about z it turns x towards y.</source>
        <translation>Ovo okreće za minus taj kut. Kut je pozitivan suprotno od kazaljke na satu, gledano s vrha njegove osi: oko z okreće x prema y.</translation>
    </message>
    <message>
        <source>Moves have the other sign</source>
        <translation>Pomaci imaju drugi predznak</translation>
    </message>
    <message>
        <source>This moves by minus the numbers. A translation adds its numbers to the coordinates. The view matrix subtracts the eye, because it moves the world and not the camera.</source>
        <translation>Ovo pomiče za minus te brojeve. Translacija svoje brojeve pribraja koordinatama. Matrica pogleda oduzima položaj kamere, jer pomiče svijet, a ne kameru.</translation>
    </message>
    <message>
        <source>A scale divides</source>
        <translation>Skaliranje dijeli</translation>
    </message>
    <message>
        <source>This divides by the factors of the scale. A factor of 2 makes the object twice as large; one half undoes that.</source>
        <translation>Ovo dijeli faktorima skaliranja. Faktor 2 čini objekt dvostruko većim; jedna polovina to poništava.</translation>
    </message>
    <message>
        <source>Any axis will do</source>
        <translation>Dobra je bilo koja os</translation>
    </message>
    <message>
        <source>This turns about another axis. What lies on the axis of a rotation stays where it is: a turn about z changes x and y, and keeps z.</source>
        <translation>Ovo okreće oko druge osi. Što leži na osi rotacije, ostaje gdje jest: okret oko z mijenja x i y, a zadržava z.</translation>
    </message>
    <message>
        <source>The camera&apos;s axes are columns of R</source>
        <translation>Osi kamere su stupci od R</translation>
    </message>
    <message>
        <source>This writes {0}, {1} and {2} into the columns of the rotation. That rotation places a camera. The view matrix needs its inverse, which is the transpose, so the axes are its rows.</source>
        <translation>Ovo zapisuje {0}, {1} i {2} u stupce rotacije. Ta rotacija postavlja kameru. Matrici pogleda treba njezin inverz, a to je transponirana matrica, pa su osi njezini retci.</translation>
    </message>
    <message>
        <source>The move stands in the last row</source>
        <translation>Pomak stoji u posljednjem retku</translation>
    </message>
    <message>
        <source>This is a translation for row vectors. Here points are columns, {0}, so the move is the last column. In the last row its numbers would change {1}.</source>
        <translation>Ovo je translacija za vektore retke. Točke su ovdje stupci, {0}, pa je pomak posljednji stupac. U posljednjem retku njegovi bi brojevi mijenjali {1}.</translation>
    </message>
    <message>
        <source>One factor is enough</source>
        <translation>Dovoljan je jedan faktor</translation>
    </message>
    <message>
        <source>This leaves a factor out. Each factor hands its points to the one on its left, and without it they arrive unchanged.</source>
        <translation>Ovo izostavlja faktor. Svaki faktor predaje svoje točke onome lijevo od sebe, a bez njega one stižu nepromijenjene.</translation>
    </message>
    <message>
        <source>An inverse keeps the order</source>
        <translation>Inverz zadržava redoslijed</translation>
    </message>
    <message>
        <source>This inverts each factor and keeps the order. An inverse undoes the last move first, so the order turns round: {0}.</source>
        <translation>Ovo invertira svaki faktor i zadržava redoslijed. Inverz najprije poništava posljednji korak, pa se redoslijed okreće: {0}.</translation>
    </message>
    <message>
        <source>The inverse leads there, too</source>
        <translation>I inverz vodi onamo</translation>
    </message>
    <message>
        <source>This is the inverse of the chain, which leads back: from the world to the object, or from the camera to the world. The inverse undoes what the chain does.</source>
        <translation>Ovo je inverz lanca, koji vodi natrag: iz svijeta u objekt ili iz koordinatnog sustava kamere u svijet. Inverz poništava ono što lanac čini.</translation>
    </message>
</context>
<context>
    <name>l01-camera-frame</name>
    <message>
        <source>The camera&apos;s own axes</source>
        <translation>Vlastite osi kamere</translation>
    </message>
    <message>
        <source>Which way does n point?</source>
        <translation>Kamo pokazuje n?</translation>
    </message>
    <message>
        <source>A camera carries three unit vectors: {0} to its right, {1} upwards, and {2} along its line of sight. Lecture 001 puts the camera at {3} and lets it look along the world&apos;s {4} axis; the letter F stands 8 units ahead. **World** shows the eye {5}, the line of sight to the target {6}, and the up vector {7}. {8} is not there yet.</source>
        <translation>Kamera nosi tri jedinična vektora: {0} udesno, {1} gore i {2} duž smjera gledanja. Predavanje 001 stavlja kameru u {3}, s pogledom duž globalne osi {4}; slovo F stoji 8 jedinica ispred. **Svijet** pokazuje položaj kamere {5}, smjer gledanja do cilja {6} i smjer prema gore {7}. {8} još nije tu.</translation>
    </message>
    <message>
        <source>What is {0} of this camera?</source>
        <translation>Koliko je {0} ove kamere?</translation>
    </message>
    <message>
        <source>(1, 0, 0), the direction in which it looks</source>
        <translation>(1, 0, 0), smjer u kojem gleda</translation>
    </message>
    <message>
        <source>The camera looks along {0}: {1} runs from the target back to the eye. Look at its arrow: it points away from the F.</source>
        <translation>Kamera gleda duž {0}: {1} ide od cilja natrag prema kameri. Pogledajte njegovu strelicu: pokazuje na suprotnu stranu od slova F.</translation>
    </message>
    <message>
        <source>(-1, 0, 0), opposite to the direction in which it looks</source>
        <translation>(-1, 0, 0), suprotno od smjera u kojem gleda</translation>
    </message>
    <message>
        <source>(0, 0, -1), as for every camera</source>
        <translation>(0, 0, -1), kao kod svake kamere</translation>
    </message>
    <message>
        <source>That is the direction in which it looks in its own coordinates, after the view matrix. In the world it looks along +x. Look at {0}: it lies along the world&apos;s x axis, not along z.</source>
        <translation>To je smjer u kojem gleda u vlastitim koordinatama, nakon matrice pogleda. U svijetu gleda duž +x. Pogledajte {0}: leži duž globalne osi x, a ne duž z.</translation>
    </message>
    <message>
        <source>n runs from the target back to the eye. The camera looks along {0}.</source>
        <translation>n ide od cilja natrag prema kameri. Kamera gleda duž {0}.</translation>
    </message>
    <message>
        <source>Eye, target, up: then u, v, n</source>
        <translation>Položaj kamere, cilj, prema gore: zatim u, v, n</translation>
    </message>
    <message>
        <source>The eye {0} is at {1}, the target {2} at the origin, and {3}.</source>
        <translation>Kamera {0} je u {1}, cilj {2} u ishodištu, a {3}.</translation>
    </message>
    <message>
        <source>{0}; its length is 3, so {1}.</source>
        <translation>{0}; duljina mu je 3, pa je {1}.</translation>
    </message>
    <message>
        <source>{0}; its length is only 0.745, so it is divided too: {1}.</source>
        <translation>{0}; duljina mu je samo 0.745, pa se i on dijeli: {1}.</translation>
    </message>
    <message>
        <source>{0}; {1} and {2} are unit vectors at a right angle, so {3} needs no division.</source>
        <translation>{0}; {1} i {2} su međusobno okomiti jedinični vektori, pa {3} ne treba dijeliti.</translation>
    </message>
    <message>
        <source>In *Camera frame*, **Back** and **Next** build them one by one.</source>
        <translation>U ploči *Koordinatni sustav kamere* grade ih jedan po jedan **Natrag** i **Dalje**.</translation>
    </message>
    <message>
        <source>V is not v</source>
        <translation>V nije v</translation>
    </message>
    <message>
        <source>The up vector {0} only says roughly which way is up. Here it is {1}, and the camera looks slightly down.</source>
        <translation>Smjer prema gore {0} kaže samo otprilike gdje je gore. Ovdje je {1}, a kamera gleda malo dolje.</translation>
    </message>
    <message>
        <source>Turn {0} away from {1} until the angle between them is 30° or more.</source>
        <translation>Okrećite {0} od {1} dok kut između njih ne bude 30° ili više.</translation>
    </message>
    <message>
        <source>v is always at a right angle to the line of sight. What tilts the line of sight?</source>
        <translation>v je uvijek okomit na smjer gledanja. Što naginje smjer gledanja?</translation>
    </message>
    <message>
        <source>Raise the eye: Elevation in the dock.</source>
        <translation>Podignite kameru: Elevacija na bočnoj ploči.</translation>
    </message>
    <message>
        <source>Right: v has the direction of the part of V at a right angle to the line of sight. Only for a camera that looks level are the two the same.</source>
        <translation>Točno: v ima smjer onog dijela od V koji je okomit na smjer gledanja. Samo kod kamere koja gleda horizontalno to dvoje je isto.</translation>
    </message>
    <message>
        <source>The length of a cross product</source>
        <translation>Duljina vektorskog umnoška</translation>
    </message>
    <message>
        <source>A cross product of two unit vectors has length 1 only if they are at a right angle to each other. {0} and {1} are seldom at a right angle.</source>
        <translation>Vektorski umnožak dvaju jediničnih vektora ima duljinu 1 samo ako su međusobno okomiti. {0} i {1} su rijetko okomiti.</translation>
    </message>
    <message>
        <source>Eye (2, 3, 6), target at the origin, {0}. How large is {1}?</source>
        <translation>Kamera (2, 3, 6), cilj u ishodištu, {0}. Koliko je {1}?</translation>
    </message>
    <message>
        <source>This takes {0} itself for {1}. Look at the two arrows: {2} is at a right angle to {3}, and {4} is not.</source>
        <translation>Ovo uzima sam {0} umjesto {1}. Pogledajte dvije strelice: {2} je okomit na {3}, a {4} nije.</translation>
    </message>
    <message>
        <source>{0} is shorter than 1, because {1} and {2} are not at a right angle. Look at them, and divide by the length before the second product.</source>
        <translation>{0} je kraći od 1, jer {1} i {2} nisu okomiti. Pogledajte ih i podijelite duljinom prije drugog umnoška.</translation>
    </message>
    <message>
        <source>N = (2, 3, 6) is 7 long.</source>
        <translation>N = (2, 3, 6) ima duljinu 7.</translation>
    </message>
    <message>
        <source>{0}. Its length is not 1.</source>
        <translation>{0}. Duljina mu nije 1.</translation>
    </message>
    <message>
        <source>{0} is 0.904 long, so {1}, and {2}.</source>
        <translation>{0} ima duljinu 0.904, pa je {1} i {2}.</translation>
    </message>
    <message>
        <source>The last column of the view matrix</source>
        <translation>Posljednji stupac matrice pogleda</translation>
    </message>
    <message>
        <source>The view matrix first moves the eye to the origin, then rotates: {0}, where the rows of {1} are {2}, {3}, {4}. Its last column is therefore {5} times minus the eye.</source>
        <translation>Matrica pogleda najprije pomiče kameru u ishodište, a zatim rotira: {0}, gdje su retci od {1} {2}, {3}, {4}. Njezin je posljednji stupac zato {5} puta minus položaj kamere.</translation>
    </message>
    <message>
        <source>The same camera: eye (2, 3, 6), target at the origin. Which number stands in row 3, column 4 of the view matrix?</source>
        <translation>Ista kamera: položaj (2, 3, 6), cilj u ishodištu. Koji broj stoji u retku 3, stupcu 4 matrice pogleda?</translation>
    </message>
    <message>
        <source>This rotates first and then moves. The move acts first, so row {0} multiplies all its three numbers. Look at view space: the target, the world&apos;s origin, lies on the axis.</source>
        <translation>Ovo najprije rotira, a zatim pomiče. Pomak djeluje prvi, pa redak {0} množi sva tri njegova broja. Pogledajte koordinatni sustav kamere: cilj, ishodište svijeta, leži na osi.</translation>
    </message>
    <message>
        <source>This puts the camera in its place. The view matrix moves the world until the eye is at the origin. Look at view space: the eye is at the origin, and the target in front of it.</source>
        <translation>Ovo stavlja kameru na njezino mjesto. Matrica pogleda pomiče svijet dok kamera ne bude u ishodištu. Pogledajte koordinatni sustav kamere: kamera je u ishodištu, a cilj ispred nje.</translation>
    </message>
    <message>
        <source>This takes the direction of view for {0}. Look at view space: {1} points backwards, so the target, the world&apos;s origin, has a negative z.</source>
        <translation>Ovo uzima smjer gledanja kao {0}. Pogledajte koordinatni sustav kamere: {1} pokazuje unatrag, pa cilj, ishodište svijeta, ima negativan z.</translation>
    </message>
    <message>
        <source>Row 3 is n. What does it make of the moved origin, {0}?</source>
        <translation>Redak 3 je n. Što čini od pomaknutog ishodišta, {0}?</translation>
    </message>
    <message>
        <source>{0}. The world&apos;s origin is 7 units in front of the camera, so its z there is {1}.</source>
        <translation>{0}. Ishodište svijeta je 7 jedinica ispred kamere, pa je njegov z ondje {1}.</translation>
    </message>
    <message>
        <source>A camera for a given n</source>
        <translation>Kamera za zadani n</translation>
    </message>
    <message>
        <source>Now the other way round: find the camera for a given axis.</source>
        <translation>Sada obrnuto: nađite kameru za zadanu os.</translation>
    </message>
    <message>
        <source>Give the camera {0}.</source>
        <translation>Postavite kameru tako da bude {0}.</translation>
    </message>
    <message>
        <source>n has no height: the camera looks level.</source>
        <translation>n nema visinu: kamera gleda horizontalno.</translation>
    </message>
    <message>
        <source>From the target, go along n to the eye: 6 along x for every 8 along z. Then Elevation is 0 and Azimuth 36.87.</source>
        <translation>Od cilja idite duž n do kamere: 6 po x na svakih 8 po z. Tada je Elevacija 0, a Azimut 36.87.</translation>
    </message>
    <message>
        <source>Right: any eye on the ray from the target along n will do. The distance does not matter.</source>
        <translation>Točno: odgovara svaki položaj kamere na zraci od cilja duž n. Udaljenost nije važna.</translation>
    </message>
    <message>
        <source>Back to the camera at (4, 2, 0)</source>
        <translation>Natrag na kameru u (4, 2, 0)</translation>
    </message>
    <message>
        <source>It is tempting to take {0} as the direction in which the camera looks, {1}. But {2} to the right, {3} up and the third axis must make a right-handed system, so the third one comes out of the picture, towards the reader: {4}. Lecture 001 calls it {5} and writes {6}.</source>
        <translation>Primamljivo je za {0} uzeti smjer u kojem kamera gleda, {1}. Ali {2} udesno, {3} gore i treća os moraju činiti desni sustav, pa treća izlazi iz slike, prema čitatelju: {4}. Predavanje 001 zove je {5} i piše {6}.</translation>
    </message>
    <message>
        <source>That is why what is in front of a camera has a *negative* z in its coordinates: the F, 8 units ahead, is at {0}. In *Camera frame*, row 3 of the matrix begins with {1}.</source>
        <translation>Zato ono što je ispred kamere u njezinim koordinatama ima *negativan* z: F, 8 jedinica ispred, je na {0}. U ploči *Koordinatni sustav kamere* redak 3 matrice počinje s {1}.</translation>
    </message>
    <message>
        <source>Practise: how upright is v?</source>
        <translation>Vježba: koliko je v uspravan?</translation>
    </message>
    <message>
        <source>Eye {0} and target {1} are new each time; {2}.</source>
        <translation>Položaj kamere {0} i cilj {1} svaki su put novi; {2}.</translation>
    </message>
    <message>
        <source>The eye is at {0}, the target at {1}. How large is {2}?</source>
        <translation>Kamera je u {0}, cilj u {1}. Koliko je {2}?</translation>
    </message>
    <message>
        <source>{0}, divided by its length, is {1}.</source>
        <translation>{0}, podijeljen svojom duljinom, je {1}.</translation>
    </message>
    <message>
        <source>{0} is shorter than 1. Divide it by its length before you form {1}.</source>
        <translation>{0} je kraći od 1. Podijelite ga njegovom duljinom prije nego što načinite {1}.</translation>
    </message>
    <message>
        <source>{0} is {1} long, {2} only {3}.</source>
        <translation>{0} ima duljinu {1}, a {2} samo {3}.</translation>
    </message>
    <message>
        <source>Practise: a row of the view matrix</source>
        <translation>Vježba: redak matrice pogleda</translation>
    </message>
    <message>
        <source>The view matrix is {0}: {1} moves the eye {2} to the origin, and the rows of {3} are {4}, {5}, {6}.</source>
        <translation>Matrica pogleda je {0}: {1} pomiče kameru {2} u ishodište, a retci od {3} su {4}, {5}, {6}.</translation>
    </message>
    <message>
        <source>The eye is at {0}, the target at {1}. Which four numbers are in row 3 of the view matrix?</source>
        <translation>Kamera je u {0}, cilj u {1}. Koja su četiri broja u retku 3 matrice pogleda?</translation>
    </message>
    <message>
        <source>This rotates first and then moves. The move acts first, so {0} multiplies all three numbers of {1}. Look at view space: the eye is at the origin.</source>
        <translation>Ovo najprije rotira, a zatim pomiče. Pomak djeluje prvi, pa {0} množi sva tri broja od {1}. Pogledajte koordinatni sustav kamere: kamera je u ishodištu.</translation>
    </message>
    <message>
        <source>This puts the camera in its place. The view matrix moves the world until the eye is at the origin. Look at view space: the eye is there, and the target in front of it.</source>
        <translation>Ovo stavlja kameru na njezino mjesto. Matrica pogleda pomiče svijet dok kamera ne bude u ishodištu. Pogledajte koordinatni sustav kamere: kamera je ondje, a cilj ispred nje.</translation>
    </message>
    <message>
        <source>This takes the direction of view for {0}. Look at view space: {1} points backwards, away from the target.</source>
        <translation>Ovo uzima smjer gledanja kao {0}. Pogledajte koordinatni sustav kamere: {1} pokazuje unatrag, od cilja.</translation>
    </message>
    <message>
        <source>{0} is {1} long.</source>
        <translation>{0} ima duljinu {1}.</translation>
    </message>
    <message>
        <source>Row 3 of {0} is {1}. What does it make of the moved origin, {2}?</source>
        <translation>Redak 3 od {0} je {1}. Što čini od pomaknutog ishodišta, {2}?</translation>
    </message>
    <message>
        <source>{0} is {1} long. Row 3 begins with {2} and ends with {3}.</source>
        <translation>{0} ima duljinu {1}. Redak 3 počinje s {2}, a završava s {3}.</translation>
    </message>
    <message>
        <source>Practise: a camera for a given n</source>
        <translation>Vježba: kamera za zadani n</translation>
    </message>
    <message>
        <source>Use *Azimuth* and *Elevation* in the dock, drag the eye in **World**, or type its coordinates.</source>
        <translation>Upotrijebite kontrole *Azimut* i *Elevacija* na bočnoj ploči, povucite kameru u oknu **Svijet** ili upišite njezine koordinate.</translation>
    </message>
    <message>
        <source>Give the camera an {0} in the direction of {1}.</source>
        <translation>Postavite kameru tako da {0} ima smjer {1}.</translation>
    </message>
    <message>
        <source>{0} runs from the target to the eye.</source>
        <translation>{0} ide od cilja prema kameri.</translation>
    </message>
    <message>
        <source>The tangent of the azimuth is {0}. The tangent of the elevation is {1}, divided by the length of {2}.</source>
        <translation>Tangens azimuta je {0}. Tangens elevacije je {1}, podijeljeno duljinom od {2}.</translation>
    </message>
    <message>
        <source>The eye is on the ray from the target along {0}: {1}. The distance does not matter.</source>
        <translation>Kamera je na zraci od cilja duž {0}: {1}. Udaljenost nije važna.</translation>
    </message>
    <message>
        <source>Your camera looks in the direction of {0}. Look at its {1}: it points the other way, from the target to the eye.</source>
        <translation>Vaša kamera gleda u smjeru {0}. Pogledajte njezin {1}: pokazuje na drugu stranu, od cilja prema kameri.</translation>
    </message>
    <message>
        <source>Practise: build the view matrix</source>
        <translation>Vježba: složite matricu pogleda</translation>
    </message>
    <message>
        <source>Put the tiles in order, and leave out what does not belong.</source>
        <translation>Poredajte pločice i izostavite ono što ne pripada umnošku.</translation>
    </message>
    <message>
        <source>The eye is at {0}. The rows of {1} are {2}, {3}, {4}, and {5} moves by {6}. Which product is the view matrix?</source>
        <translation>Kamera je u {0}. Retci od {1} su {2}, {3}, {4}, a {5} pomiče za {6}. Koji je umnožak matrica pogleda?</translation>
    </message>
    <message>
        <source>{0} moves the eye to the origin, and {1} rotates about it. {2} moves the wrong way.</source>
        <translation>{0} pomiče kameru u ishodište, a {1} rotira oko njega. {2} pomiče na pogrešnu stranu.</translation>
    </message>
    <message>
        <source>A camera at the origin looks along {0}. It was turned about y by {1}°, then moved by {2}. Which product is its view matrix?</source>
        <translation>Kamera u ishodištu gleda duž {0}. Okrenuta je oko y za {1}°, zatim pomaknuta za {2}. Koji je umnožak njezina matrica pogleda?</translation>
    </message>
    <message>
        <source>A camera was tilted about x by {0}°, turned about y by {1}°, and moved by {2}. Which product is its view matrix?</source>
        <translation>Kamera je nagnuta oko x za {0}°, okrenuta oko y za {1}° i pomaknuta za {2}. Koji je umnožak njezina matrica pogleda?</translation>
    </message>
    <message>
        <source>Where is the eye after the view matrix?</source>
        <translation>Gdje je kamera nakon matrice pogleda?</translation>
    </message>
    <message>
        <source>At the origin, so the factor that moves acts first. {0} moves by {1}.</source>
        <translation>U ishodištu, pa faktor koji pomiče djeluje prvi. {0} pomiče za {1}.</translation>
    </message>
    <message>
        <source>The view matrix undoes both, the last one first.</source>
        <translation>Matrica pogleda poništava oboje, najprije posljednje.</translation>
    </message>
    <message>
        <source>The camera was placed by {0}. Its inverse is {1}: the move is undone first.</source>
        <translation>Kamera je postavljena umnoškom {0}. Njegov je inverz {1}: najprije se poništava pomak.</translation>
    </message>
    <message>
        <source>The camera was placed by {0}. What is undone first?</source>
        <translation>Kamera je postavljena umnoškom {0}. Što se poništava prvo?</translation>
    </message>
    <message>
        <source>The move, then the turn, then the tilt.</source>
        <translation>Pomak, zatim okret, zatim nagib.</translation>
    </message>
    <message>
        <source>{0}: an inverse turns the order round.</source>
        <translation>{0}: inverz okreće redoslijed.</translation>
    </message>
</context>
<context>
    <name>l02-columns</name>
    <message>
        <source>First rotate, then move</source>
        <translation>Najprije rotacija, zatim pomak</translation>
    </message>
    <message>
        <source>An object has coordinates of its own; {0} takes them to the world. Here {1}: the object is turned by 90° about z, then moved by 3 along x. With column vectors the matrix on the right acts first. In **World** the letter F still stands where it was made.</source>
        <translation>Objekt ima vlastite koordinate; {0} ih prebacuje u svijet. Ovdje je {1}: objekt se okreće za 90° oko z, zatim pomiče za 3 duž x. Kod vektora stupaca prva djeluje matrica zdesna. U oknu **Svijet** slovo F još stoji ondje gdje je napravljeno.</translation>
    </message>
    <message>
        <source>The object&apos;s point (1, 0, 0): how high above the ground, in y, does it end up in the world?</source>
        <translation>Točka objekta (1, 0, 0): koliko visoko iznad tla, po y, završava u svijetu?</translation>
    </message>
    <message>
        <source>This moves first and then turns, which turns the move as well. Look at point 1: the object&apos;s point would come there, 4 high.</source>
        <translation>Ovo najprije pomiče, a zatim okreće, čime okreće i pomak. Pogledajte točku 1: onamo bi došla točka objekta, na visinu 4.</translation>
    </message>
    <message>
        <source>The move alone keeps it on the ground, but the turn by 90° takes x to y. Look at point 1: it is where the move alone takes the point, on the ground.</source>
        <translation>Sam pomak ostavlja je na tlu, ali okret za 90° prebacuje x u y. Pogledajte točku 1: ondje je kamo točku dovodi sam pomak, na tlu.</translation>
    </message>
    <message>
        <source>The turn takes (1, 0, 0) to (0, 1, 0), and then the move takes that to (3, 1, 0): probe 1 in World.</source>
        <translation>Okret prebacuje (1, 0, 0) u (0, 1, 0), a zatim pomak to prebacuje u (3, 1, 0): sonda 1 u oknu Svijet.</translation>
    </message>
    <message>
        <source>Read the matrix by columns</source>
        <translation>Čitajte matricu po stupcima</translation>
    </message>
    <message>
        <source>In *Matrices*, world ← object holds the turn and the move:</source>
        <translation>U ploči *Matrice* svijet ← objekt sadrži okret i pomak:</translation>
    </message>
    <message>
        <source>x axis</source>
        <translation>os x</translation>
    </message>
    <message>
        <source>y axis</source>
        <translation>os y</translation>
    </message>
    <message>
        <source>z axis</source>
        <translation>os z</translation>
    </message>
    <message>
        <source>origin</source>
        <translation>ishodište</translation>
    </message>
    <message>
        <source>Column 1 says where the object&apos;s x axis points in the world: {0}, up. Column 2 is its y axis, column 3 its z axis, and column 4 is the position of its origin. So the point {1} lies at column 4 plus column 1: {2}. Point at a column with the mouse to highlight its axis in **World**.</source>
        <translation>Stupac 1 kaže kamo u svijetu pokazuje os x objekta: {0}, gore. Stupac 2 je njegova os y, stupac 3 os z, a stupac 4 položaj njegova ishodišta. Zato točka {1} leži u stupcu 4 plus stupac 1: {2}. Pokažite mišem na stupac da istaknete njegovu os u oknu **Svijet**.</translation>
    </message>
    <message>
        <source>Exchange the two tiles in *Chain*, in the dock, and play the strip again. How does the letter reach its place now?</source>
        <translation>Zamijenite dvije pločice u odjeljku *Lanac*, na bočnoj ploči, i ponovno pokrenite traku. Kako slovo sada dolazi na svoje mjesto?</translation>
    </message>
    <message>
        <source>A point through T and R</source>
        <translation>Točka kroz T i R</translation>
    </message>
    <message>
        <source>The letter is turned by 30° about z and then moved by 4 along x: {0}.</source>
        <translation>Slovo se okreće za 30° oko z, a zatim pomiče za 4 duž x: {0}.</translation>
    </message>
    <message>
        <source>What is x of the object&apos;s point (2, 1, 0) in the world?</source>
        <translation>Koliki je x točke objekta (2, 1, 0) u svijetu?</translation>
    </message>
    <message>
        <source>This moves first and then turns, which turns the move as well. Look at point 1: it is where the object&apos;s point would come then.</source>
        <translation>Ovo najprije pomiče, a zatim okreće, čime okreće i pomak. Pogledajte točku 1: ondje je kamo bi tada došla točka objekta.</translation>
    </message>
    <message>
        <source>This reads rows for columns, as if the letter were turned by −30°. Look at point 1: it is where the object&apos;s point would come then.</source>
        <translation>Ovo čita retke kao stupce, kao da je slovo okrenuto za −30°. Pogledajte točku 1: ondje je kamo bi tada došla točka objekta.</translation>
    </message>
    <message>
        <source>2 times column 1, plus 1 times column 2, plus column 4.</source>
        <translation>2 puta stupac 1, plus 1 puta stupac 2, plus stupac 4.</translation>
    </message>
    <message>
        <source>cos 30° = 0.866, sin 30° = 0.5</source>
        <translation>cos 30° = 0.866, sin 30° = 0.5</translation>
    </message>
    <message>
        <source>Where must it move?</source>
        <translation>Kamo se mora pomaknuti?</translation>
    </message>
    <message>
        <source>The letter is turned by 90° about z. Probe 1 in **World** is at {0}.</source>
        <translation>Slovo je okrenuto za 90° oko z. Sonda 1 u oknu **Svijet** je u {0}.</translation>
    </message>
    <message>
        <source>Keep the turn, and move the object so that its point (1, 0, 0) comes to probe 1.</source>
        <translation>Zadržite okret i pomaknite objekt tako da njegova točka (1, 0, 0) dođe u sondu 1.</translation>
    </message>
    <message>
        <source>Where is the point now, when it is turned but not moved?</source>
        <translation>Gdje je točka sada, kad je okrenuta, ali ne i pomaknuta?</translation>
    </message>
    <message>
        <source>It is at (0, 1, 0), and it must go to (2, 3, 0).</source>
        <translation>U (0, 1, 0) je, a mora u (2, 3, 0).</translation>
    </message>
    <message>
        <source>Right: column 1 plus column 4 is (2, 3, 0).</source>
        <translation>Točno: stupac 1 plus stupac 4 je (2, 3, 0).</translation>
    </message>
    <message>
        <source>Back to the prediction</source>
        <translation>Natrag na predviđanje</translation>
    </message>
    <message>
        <source>It is tempting to move first, from {0} to {1}, and then to rotate. But a rotation about the world&apos;s origin rotates the move as well: {2} goes to {3}, where probe 1 is. That is {4}, which this step shows: in *Chain* the rotation stands above the move, so it acts last.</source>
        <translation>Primamljivo je najprije pomaknuti, od {0} do {1}, a zatim rotirati. Ali rotacija oko ishodišta svijeta rotira i pomak: {2} dolazi u {3}, gdje je sonda 1. To je {4}, što ovaj korak i pokazuje: u odjeljku *Lanac* rotacija stoji iznad pomaka, pa djeluje posljednja.</translation>
    </message>
    <message>
        <source>The letter is turned about z by {0} and not moved yet. Its move is in *Chain*, in the dock.</source>
        <translation>Slovo je okrenuto oko z za {0} i još nije pomaknuto. Pomak mu je u odjeljku *Lanac*, na bočnoj ploči.</translation>
    </message>
    <message>
        <source>The letter was turned about z by {0}° and then moved by {1} along x. Which product did that?</source>
        <translation>Slovo je okrenuto oko z za {0}°, a zatim pomaknuto za {1} duž x. Koji je umnožak to učinio?</translation>
    </message>
    <message>
        <source>The letter was made {0} times as wide, turned about z by {1}°, and moved by {2} along x. It kept its right angles. Which product did that?</source>
        <translation>Slovo je rašireno {0} puta, okrenuto oko z za {1}° i pomaknuto za {2} duž x. Zadržalo je prave kutove. Koji je umnožak to učinio?</translation>
    </message>
    <message>
        <source>Object, world, camera</source>
        <translation>Objekt, svijet, kamera</translation>
    </message>
    <message>
        <source>Each factor is a place</source>
        <translation>Svaki faktor je mjesto</translation>
    </message>
    <message>
        <source>The strip below the cube has a stop for each move: *Object*, *Rz* and *World*. At *Rz* the letter is turned and not yet moved; its other places are pale beside it. Play the strip from its beginning.</source>
        <translation>Traka ispod kocke ima postaju za svaki pomak i okret: *Objekt*, *Rz* i *Svijet*. Na postaji *Rz* slovo je okrenuto i još nije pomaknuto; njegova su ostala mjesta blijeda pokraj njega. Pokrenite traku od njezina početka.</translation>
    </message>
    <message>
        <source>The arrow beside *Play* reads the product the other way. **←** does the moves from right to left, each in the axes of the world. **→** does them from left to right, each in the axes that the moves before have moved: the letter goes 3 along x and is then turned about its own origin. Both ways end in the same place.</source>
        <translation>Strelica pokraj *Pokreni* čita umnožak s druge strane. **←** izvodi faktore zdesna nalijevo, svaki po osima svijeta. **→** ih izvodi slijeva nadesno, svaki po osima koje su prethodni već pomaknuli: slovo ide 3 duž x, a zatim se okreće oko vlastitog ishodišta. Oba načina završavaju na istom mjestu.</translation>
    </message>
    <message>
        <source>Drag a tile by the grip at its left, or press the arrow keys there.</source>
        <translation>Povucite pločicu za ručicu lijevo od nje ili ondje pritišćite strelice.</translation>
    </message>
    <message>
        <source>Now the move is turned as well: the letter swings about the world&apos;s origin, from {0} to {1}.</source>
        <translation>Sada se okreće i pomak: slovo ide ukrug oko ishodišta svijeta, od {0} do {1}.</translation>
    </message>
    <message>
        <source>{0} has the turn on the left, so it acts last, about the world&apos;s origin.</source>
        <translation>{0} ima okret slijeva, pa on djeluje posljednji, oko ishodišta svijeta.</translation>
    </message>
    <message>
        <source>From the world to the camera</source>
        <translation>Od svijeta do kamere</translation>
    </message>
    <message>
        <source>The camera has axes of its own, and {0} takes the world to them. It undoes how the camera was placed. For a point {1} of the letter both matrices are multiplied:</source>
        <translation>Kamera ima vlastite osi, a {0} svijet prebacuje na njih. Ona poništava postavljanje kamere. Točka {1} slova množi se objema matricama:</translation>
    </message>
    <message>
        <source>Which chain takes a point of the letter to the camera&apos;s axes?</source>
        <translation>Koji lanac točku slova prebacuje na osi kamere?</translation>
    </message>
    <message>
        <source>In which space does the point have its coordinates at first?</source>
        <translation>U kojem koordinatnom sustavu točka na početku ima koordinate?</translation>
    </message>
    <message>
        <source>The point starts in the letter&apos;s own space. The turn and the move take it to the world, and the view matrix takes it from there to the camera.</source>
        <translation>Točka počinje u vlastitom koordinatnom sustavu slova. Okret i pomak prebacuju je u svijet, a odande je matrica pogleda prebacuje u koordinatni sustav kamere.</translation>
    </message>
    <message>
        <source>With {0} the letter is rotated in its place and then moved, and column 4 is the move as you typed it. With {1} column 4 is the move after the rotation, {2}.</source>
        <translation>Kod {0} slovo se rotira na svojem mjestu, a zatim pomiče, i stupac 4 je pomak kako ste ga upisali. Kod {1} stupac 4 je pomak nakon rotacije, {2}.</translation>
    </message>
    <message>
        <source>Practise: the matrix of a turn</source>
        <translation>Vježba: matrica okreta</translation>
    </message>
    <message>
        <source>The letter is turned about z by an angle {0}. Seen from the tip of z, a positive angle turns it anticlockwise.</source>
        <translation>Slovo se okreće oko z za kut {0}. Gledano s vrha osi z, pozitivan kut okreće ga suprotno od kazaljke na satu.</translation>
    </message>
    <message>
        <source>Here {0}. Which numbers are in rows 1 and 2, columns 1 and 2 of {1}?</source>
        <translation>Ovdje je {0}. Koji su brojevi u retcima 1 i 2, stupcima 1 i 2 matrice {1}?</translation>
    </message>
    <message>
        <source>This has rows and columns exchanged, which turns the letter the other way. Look at its own axes: they are turned by {0}°.</source>
        <translation>Ovdje su retci i stupci zamijenjeni, pa se slovo okreće na drugu stranu. Pogledajte njegove osi: okrenute su za {0}°.</translation>
    </message>
    <message>
        <source>My degrees are radians</source>
        <translation>Moji stupnjevi su radijani</translation>
    </message>
    <message>
        <source>This takes {0}° for {1} radians. Look at the letter, turned by that many radians.</source>
        <translation>Ovo uzima {0}° kao {1} u radijanima. Pogledajte slovo okrenuto za toliko radijana.</translation>
    </message>
    <message>
        <source>Column 1 is the x axis of the turned letter, column 2 its y axis.</source>
        <translation>Stupac 1 je os x okrenutog slova, stupac 2 njegova os y.</translation>
    </message>
    <message>
        <source>Column 1 is where the x axis points after the turn, column 2 where the y axis points.</source>
        <translation>Stupac 1 je ono kamo nakon okreta pokazuje os x, stupac 2 kamo pokazuje os y.</translation>
    </message>
    <message>
        <source>Practise: turn, then move</source>
        <translation>Vježba: okret, zatim pomak</translation>
    </message>
    <message>
        <source>The letter is turned about z by {0}, then moved along x: {1}. Point 1 is where a point of the letter&apos;s own space comes to.</source>
        <translation>Slovo se okreće oko z za {0}, zatim pomiče duž x: {1}. Točka 1 je ondje kamo dođe točka iz vlastitog koordinatnog sustava slova.</translation>
    </message>
    <message>
        <source>Here {0}, and the move is {1} along x. What is x of the object&apos;s point {2} in the world?</source>
        <translation>Ovdje je {0}, a pomak je {1} duž x. Koliki je x točke objekta {2} u svijetu?</translation>
    </message>
    <message>
        <source>This reads rows for columns, as if the letter were turned by {0}°. Look at point 1: it is where the object&apos;s point would come then.</source>
        <translation>Ovo čita retke kao stupce, kao da je slovo okrenuto za {0}°. Pogledajte točku 1: ondje je kamo bi tada došla točka objekta.</translation>
    </message>
    <message>
        <source>{0} times column 1, plus {1} times column 2, plus column 4.</source>
        <translation>{0} puta stupac 1, plus {1} puta stupac 2, plus stupac 4.</translation>
    </message>
    <message>
        <source>The x of column 1 is {0}, and the x of column 2 is {1}.</source>
        <translation>x stupca 1 je {0}, a x stupca 2 je {1}.</translation>
    </message>
    <message>
        <source>First the turn, then the move.</source>
        <translation>Najprije okret, zatim pomak.</translation>
    </message>
    <message>
        <source>Practise: bring a point to its place</source>
        <translation>Vježba: dovedite točku na mjesto</translation>
    </message>
    <message>
        <source>Keep the turn of {0}°, and move the letter so that its point {1} comes to probe 1, at {2}.</source>
        <translation>Zadržite okret od {0}° i pomaknite slovo tako da njegova točka {1} dođe u sondu 1, u {2}.</translation>
    </message>
    <message>
        <source>Where does the turn alone take {0}?</source>
        <translation>Kamo {0} prebacuje sam okret?</translation>
    </message>
    <message>
        <source>To {0}. The move adds to that.</source>
        <translation>U {0}. Tome se dodaje pomak.</translation>
    </message>
    <message>
        <source>Column 1 plus column 4 is {0}: {1} {2} and {3} {4}.</source>
        <translation>Stupac 1 plus stupac 4 je {0}: {1} {2} i {3} {4}.</translation>
    </message>
    <message>
        <source>This move is right if it acts before the turn. Look at the letter with the order R T S: only there does it bring the point to probe 1.</source>
        <translation>Ovaj je pomak točan ako djeluje prije okreta. Pogledajte slovo s redoslijedom R T S: samo ondje dovodi točku u sondu 1.</translation>
    </message>
    <message>
        <source>Practise: build the chain</source>
        <translation>Vježba: složite lanac</translation>
    </message>
    <message>
        <source>Put the tiles in order, and leave out what does not belong.</source>
        <translation>Poredajte pločice i izostavite ono što ne pripada umnošku.</translation>
    </message>
    <message>
        <source>Which of the two acts first? It stands at the bottom.</source>
        <translation>Što od toga dvoga djeluje prvo? Ono stoji na dnu.</translation>
    </message>
    <message>
        <source>{0}: the factor on the right acts first.</source>
        <translation>{0}: faktor zdesna djeluje prvi.</translation>
    </message>
    <message>
        <source>A scale after the turn would bend the right angles.</source>
        <translation>Skaliranje nakon okreta iskrivilo bi prave kutove.</translation>
    </message>
    <message>
        <source>A scale after the move would multiply the move.</source>
        <translation>Skaliranje nakon pomaka množilo bi i pomak.</translation>
    </message>
    <message>
        <source>{0}: first the scale, along the letter&apos;s own axes, then the turn about its own origin, and the move last.</source>
        <translation>{0}: najprije skaliranje, duž vlastitih osi slova, zatim okret oko njegova ishodišta, a pomak posljednji.</translation>
    </message>
    <message>
        <source>Give the tiles their numbers, and arrange them. Columns 1 and 4 of their product {0} must be {1} and {2}.</source>
        <translation>Dajte pločicama brojeve i poredajte ih. Stupci 1 i 4 njihova umnoška {0} moraju biti {1} i {2}.</translation>
    </message>
    <message>
        <source>Column 4 is the move, if the move acts last.</source>
        <translation>Stupac 4 je pomak ako pomak djeluje posljednji.</translation>
    </message>
    <message>
        <source>Column 1 is {0}.</source>
        <translation>Stupac 1 je {0}.</translation>
    </message>
    <message>
        <source>Column 4 of {0} is the move itself, and columns 1 to 3 are those of the rotation.</source>
        <translation>Stupac 4 umnoška {0} je sam pomak, a stupci 1 do 3 su stupci rotacije.</translation>
    </message>
</context>
<context>
    <name>l03-field-of-view</name>
    <message>
        <source>Which angle is the field of view?</source>
        <translation>Koji je kut vidno polje?</translation>
    </message>
    <message>
        <source>How wide is 60 degrees?</source>
        <translation>Koliko je široko 60 stupnjeva?</translation>
    </message>
    <message>
        <source>The number in *Field of view* is the vertical angle, from the bottom of the picture to its top. The picture is 16 wide and 9 high. **World**, seen from *Above*, shows half of the horizontal angle at the eye: {0}.</source>
        <translation>Broj u polju *Vidno polje* vertikalni je kut, od donjeg do gornjeg ruba slike. Slika je široka 16, a visoka 9. **Svijet**, gledan *Odozgo*, pokazuje kod kamere polovicu horizontalnog kuta: {0}.</translation>
    </message>
    <message>
        <source>The vertical angle is set to 60°. How large is the horizontal one?</source>
        <translation>Vertikalni kut postavljen je na 60°. Koliki je horizontalni?</translation>
    </message>
    <message>
        <source>Widths are proportional to the tangent of half the angle. Look at 120° upwards: 16/9 times that would be 213°, more than half a turn; {0} is 72.0°.</source>
        <translation>Širine su proporcionalne tangensu polovice kuta. Pogledajte 120° u visinu: 16/9 puta toliko bilo bi 213°, više od pola okreta; {0} je 72.0°.</translation>
    </message>
    <message>
        <source>This takes the vertical angle for the horizontal one. Look at this square picture: only here both are 60°, and {0} is 30°.</source>
        <translation>Ovo uzima vertikalni kut umjesto horizontalnog. Pogledajte ovu kvadratnu sliku: samo su ovdje oba 60°, a {0} je 30°.</translation>
    </message>
    <message>
        <source>The sides of the picture are in the ratio 16 to 9, and so are the tangents of the half angles: {0}.</source>
        <translation>Stranice slike su u omjeru 16 prema 9, pa su u tom omjeru i tangensi polovica kutova: {0}.</translation>
    </message>
    <message>
        <source>From one angle to the other</source>
        <translation>Od jednog kuta do drugog</translation>
    </message>
    <message>
        <source>Lecture 003 has {0} for the horizontal angle, {1} for the vertical one, and {2} for the proportions, here {3}. At the distance {4} from the eye the picture reaches from {5} to {6}, and from {7} to {8}. So</source>
        <translation>Predavanje 003 označava horizontalni kut s {0}, vertikalni s {1}, a proporcije s {2}, ovdje {3}. Na udaljenosti {4} od kamere slika seže od {5} do {6} i od {7} do {8}. Dakle</translation>
    </message>
    <message>
        <source>With {0}: {1}, so {2} and {3}. The side of the near plane&apos;s window is {4} in x and {5} in y. In the dock, *More of the lens* has **Horizontal fov** and **Focal length e**.</source>
        <translation>Uz {0} je {1}, pa je {2} i {3}. Rub prozora na bliskoj ravnini je {4} po x i {5} po y. Na bočnoj ploči *Više o objektivu* sadrži **Horizontalno vidno polje** i **Žarišna duljina e**.</translation>
    </message>
    <message>
        <source>A right angle</source>
        <translation>Pravi kut</translation>
    </message>
    <message>
        <source>The picture is still 16 by 9.</source>
        <translation>Slika je i dalje 16 puta 9.</translation>
    </message>
    <message>
        <source>Make the horizontal angle 90°.</source>
        <translation>Neka horizontalni kut bude 90°.</translation>
    </message>
    <message>
        <source>At 90° the half angle is 45°, and its tangent is 1.</source>
        <translation>Kod 90° polovica kuta je 45°, a njezin tangens 1.</translation>
    </message>
    <message>
        <source>Then e is 1, and the vertical half angle has the tangent a = 9/16.</source>
        <translation>Tada je e jednak 1, a polovica vertikalnog kuta ima tangens a = 9/16.</translation>
    </message>
    <message>
        <source>Right: e is 1, and the vertical angle is 58.7°, if the picture is 16 by 9.</source>
        <translation>Točno: e je 1, a vertikalni kut je 58.7° ako je slika 16 puta 9.</translation>
    </message>
    <message>
        <source>A picture twice as wide as high</source>
        <translation>Slika dvostruko šira nego viša</translation>
    </message>
    <message>
        <source>Now the picture is 1000 by 500 pixels, and the vertical angle is 40°.</source>
        <translation>Slika sada ima 1000 puta 500 piksela, a vertikalni kut je 40°.</translation>
    </message>
    <message>
        <source>How large is the horizontal angle?</source>
        <translation>Koliki je horizontalni kut?</translation>
    </message>
    <message>
        <source>Widths are proportional to the tangent of half the angle. Look from above at 100° upwards: twice that would be 200°, more than half a turn; {0} is 67.2°.</source>
        <translation>Širine su proporcionalne tangensu polovice kuta. Pogledajte odozgo 100° u visinu: dvaput toliko bilo bi 200°, više od pola okreta; {0} je 67.2°.</translation>
    </message>
    <message>
        <source>This takes the vertical angle for the horizontal one. Look from above at a square picture: only here both are 40°, and {0} is 20°.</source>
        <translation>Ovo uzima vertikalni kut umjesto horizontalnog. Pogledajte odozgo kvadratnu sliku: samo su ovdje oba 40°, a {0} je 20°.</translation>
    </message>
    <message>
        <source>Take the tangent of half the vertical angle.</source>
        <translation>Uzmite tangens polovice vertikalnog kuta.</translation>
    </message>
    <message>
        <source>tan 20° = 0.364. What is twice that the tangent of?</source>
        <translation>tan 20° = 0.364. Čega je dvostruko toliko tangens?</translation>
    </message>
    <message>
        <source>tan(α/2) = 2·tan 20° = 0.728, so α/2 = 36.05° and α = 72.1°.</source>
        <translation>tan(α/2) = 2·tan 20° = 0.728, pa je α/2 = 36.05° i α = 72.1°.</translation>
    </message>
    <message>
        <source>The focal length e</source>
        <translation>Žarišna duljina e</translation>
    </message>
    <message>
        <source>Here the picture is square, so both angles are 50°.</source>
        <translation>Ovdje je slika kvadratna, pa su oba kuta 50°.</translation>
    </message>
    <message>
        <source>How large is {0} for {1}?</source>
        <translation>Koliko je {0} za {1}?</translation>
    </message>
    <message>
        <source>The triangle of eye, axis and edge has half of the angle at the eye. Look at {0}: the edge is as far from the axis as from the eye, so {1}; {2} would be 0.</source>
        <translation>Trokut između kamere, osi i ruba ima kod kamere polovicu kuta. Pogledajte {0}: rub je od osi udaljen koliko i od kamere, pa je {1}; {2} bi bilo 0.</translation>
    </message>
    <message>
        <source>The cotangent takes my 25</source>
        <translation>Kotangens uzima mojih 25</translation>
    </message>
    <message>
        <source>This is the cotangent of 25 radians, almost four turns. Look at the angle: 25° is 0.436 radians.</source>
        <translation>Ovo je kotangens od 25 radijana, gotovo četiri okreta. Pogledajte kut: 25° je 0.436 radijana.</translation>
    </message>
    <message>
        <source>In the triangle between eye, axis and the picture&apos;s edge, the angle at the eye is α/2.</source>
        <translation>U trokutu između kamere, osi i ruba slike kut kod kamere je α/2.</translation>
    </message>
    <message>
        <source>e = cot 25° = 2.145. The wider the angle, the smaller e.</source>
        <translation>e = cot 25° = 2.145. Što je kut širi, to je e manji.</translation>
    </message>
    <message>
        <source>A wide picture on purpose</source>
        <translation>Namjerno široka slika</translation>
    </message>
    <message>
        <source>The picture is 1000 by 500 again.</source>
        <translation>Slika je opet 1000 puta 500.</translation>
    </message>
    <message>
        <source>Keep the picture twice as wide as high, and make the horizontal angle 100°.</source>
        <translation>Neka slika ostane dvostruko šira nego viša, a horizontalni kut neka bude 100°.</translation>
    </message>
    <message>
        <source>Half of 100° has the tangent 1.192.</source>
        <translation>Polovica od 100° ima tangens 1.192.</translation>
    </message>
    <message>
        <source>The vertical half angle has half that tangent.</source>
        <translation>Polovica vertikalnog kuta ima upola manji tangens.</translation>
    </message>
    <message>
        <source>Right: tan(β/2) = 1.192/2, so the vertical angle is 61.6°, not 50°.</source>
        <translation>Točno: tan(β/2) = 1.192/2, pa je vertikalni kut 61.6°, a ne 50°.</translation>
    </message>
    <message>
        <source>Back to the prediction</source>
        <translation>Natrag na predviđanje</translation>
    </message>
    <message>
        <source>It is tempting to multiply the angle by 16/9, like the width: {0}. That would be right if the picture were bent round the eye. But the picture is flat: the tangent of the half angle grows evenly, and far from the axis a degree takes more and more of the picture.</source>
        <translation>Primamljivo je kut pomnožiti s 16/9, kao širinu: {0}. To bi bilo točno kad bi slika bila savijena oko kamere. Ali slika je ravna: tangens polovice kuta raste jednoliko, a daleko od osi jedan stupanj zauzima sve veći dio slike.</translation>
    </message>
    <message>
        <source>The wider the angle, the larger the error: here the vertical angle is 120°. Multiplied, it would be 213° across, more than half a turn. The model has 144°.</source>
        <translation>Što je kut širi, pogreška je veća: ovdje je vertikalni kut 120°. Pomnožen, dao bi 213° u širinu, više od pola okreta. Model ima 144°.</translation>
    </message>
    <message>
        <source>Practise: how wide?</source>
        <translation>Vježba: koliko široko?</translation>
    </message>
    <message>
        <source>The field of view is the vertical angle {0}; {1} is the horizontal one.</source>
        <translation>Vidno polje je vertikalni kut {0}; {1} je horizontalni.</translation>
    </message>
    <message>
        <source>The picture has {0} by {1} pixels, and {2}. How large is {3} then?</source>
        <translation>Slika ima {0} puta {1} piksela, a {2}. Koliko je tada {3}?</translation>
    </message>
    <message>
        <source>Widths are proportional to the tangent of half the angle. Look at {0}: {1} times that would be {2}°, more than half a turn, but the pyramid stays narrower.</source>
        <translation>Širine su proporcionalne tangensu polovice kuta. Pogledajte {0}: {1} puta toliko bilo bi {2}°, više od pola okreta, ali piramida ostaje uža.</translation>
    </message>
    <message>
        <source>This takes the vertical angle for the horizontal one. Look at a square picture: only here both are {0}°, and the pyramid is narrower.</source>
        <translation>Ovo uzima vertikalni kut umjesto horizontalnog. Pogledajte kvadratnu sliku: samo su ovdje oba {0}°, a piramida je uža.</translation>
    </message>
    <message>
        <source>Half of the vertical angle has the tangent {0}.</source>
        <translation>Polovica vertikalnog kuta ima tangens {0}.</translation>
    </message>
    <message>
        <source>The tangents of the half angles are in the ratio of the sides, {0} to {1}.</source>
        <translation>Tangensi polovica kutova su u omjeru stranica, {0} prema {1}.</translation>
    </message>
    <message>
        <source>Practise: the focal length e</source>
        <translation>Vježba: žarišna duljina e</translation>
    </message>
    <message>
        <source>At the distance {0} from the eye the picture reaches from {1} to {2}.</source>
        <translation>Na udaljenosti {0} od kamere slika seže od {1} do {2}.</translation>
    </message>
    <message>
        <source>The horizontal angle is {0}, and the picture is 16 by 9. How large is {1}?</source>
        <translation>Horizontalni kut je {0}, a slika 16 puta 9. Koliko je {1}?</translation>
    </message>
    <message>
        <source>The cotangent takes my degrees</source>
        <translation>Kotangens uzima moje stupnjeve</translation>
    </message>
    <message>
        <source>This takes {0}° for {1} radians, which is more than a whole turn. Look at the angle: it is less than a quarter of one.</source>
        <translation>Ovo uzima {0}° kao {1} u radijanima, a to je više od cijelog okreta. Pogledajte kut: manji je od četvrtine okreta.</translation>
    </message>
    <message>
        <source>This takes the vertical angle for the horizontal one. Look at a square picture with the same vertical angle: only here is it the horizontal one.</source>
        <translation>Ovo uzima vertikalni kut umjesto horizontalnog. Pogledajte kvadratnu sliku s istim vertikalnim kutom: samo je ovdje on ujedno horizontalni.</translation>
    </message>
    <message>
        <source>Draw the triangle of the eye, the axis, and the picture&apos;s right edge: {0} along the axis, 1 across it.</source>
        <translation>Nacrtajte trokut između kamere, osi i desnog ruba slike: {0} duž osi, 1 poprijeko.</translation>
    </message>
    <message>
        <source>Its angle at the eye is half of {0}.</source>
        <translation>Kut kod kamere mu je polovica od {0}.</translation>
    </message>
    <message>
        <source>Practise: a wide picture on purpose</source>
        <translation>Vježba: namjerno široka slika</translation>
    </message>
    <message>
        <source>Set the vertical angle in the dock; the picture keeps its pixels.</source>
        <translation>Postavite vertikalni kut na bočnoj ploči; slika zadržava svoje piksele.</translation>
    </message>
    <message>
        <source>The picture has {0} by 600 pixels. Make the horizontal angle {1}°.</source>
        <translation>Slika ima {0} puta 600 piksela. Neka horizontalni kut bude {1}°.</translation>
    </message>
    <message>
        <source>Half of {0}° has the tangent {1}.</source>
        <translation>Polovica od {0}° ima tangens {1}.</translation>
    </message>
    <message>
        <source>Half of the vertical angle has {0} of that tangent.</source>
        <translation>Polovica vertikalnog kuta ima {0} tog tangensa.</translation>
    </message>
    <message>
        <source>The field of view that you set is the vertical one. Look from above: the pyramid is wider than {0}°.</source>
        <translation>Vidno polje koje postavljate jest vertikalno. Pogledajte odozgo: piramida je šira od {0}°.</translation>
    </message>
    <message>
        <source>Angles are not in the ratio of the sides; the tangents of the half angles are. Look from above: the pyramid is narrower than {0}°.</source>
        <translation>Kutovi nisu u omjeru stranica; u tom su omjeru tangensi polovica kutova. Pogledajte odozgo: piramida je uža od {0}°.</translation>
    </message>
</context>
<context>
    <name>l04-view-volumes</name>
    <message>
        <source>What fits into the view volume?</source>
        <translation>Što stane u volumen pogleda?</translation>
    </message>
    <message>
        <source>Twice as deep in the box</source>
        <translation>U kvadru, dvostruko dublje</translation>
    </message>
    <message>
        <source>Only what lies in the view volume is drawn. Here it is a pyramid without its tip: **World** shows it, with five test cubes of one size, A to E. Cube B (probe 1) is 4 units deep, A (probe 2) is 8 units deep. B lies outside the pyramid, so its name is grey there. A box that contains both cubes will now replace the pyramid.</source>
        <translation>Crta se samo ono što leži u volumenu pogleda. Ovdje je to piramida bez vrha: pokazuje je **Svijet**, s pet jednako velikih testnih kocaka, od A do E. Kocka B (sonda 1) je na dubini od 4 jedinice, A (sonda 2) na dubini od 8 jedinica. B leži izvan piramide, pa joj je ime ondje sivo. Sada će piramidu zamijeniti kvadar koji sadrži obje kocke.</translation>
    </message>
    <message>
        <source>In the picture of the box: how wide is cube A, as a multiple of cube B, which is half as deep?</source>
        <translation>Kolika je na slici kvadra širina kocke A podijeljena širinom kocke B, koja je na upola manjoj dubini?</translation>
    </message>
    <message>
        <source>This divides by the depth, as a pyramid does. Look at a pyramid wide enough for both: here A is half as wide as B, because its projectors meet. Those of the box do not.</source>
        <translation>Ovo dijeli s dubinom, kao piramida. Pogledajte piramidu dovoljno široku za obje: ovdje je A upola uža od B, jer joj se zrake projiciranja sijeku. Zrake kvadra se ne sijeku.</translation>
    </message>
    <message>
        <source>Nothing is larger for being farther away. Twice the depth would halve it in a pyramid. Look at the box: A and B are equally wide.</source>
        <translation>Ništa nije veće zato što je dalje. U piramidi bi dvostruka dubina prepolovila širinu. Pogledajte kvadar: A i B jednako su široke.</translation>
    </message>
    <message>
        <source>The projectors of a box are parallel. Everything is divided by the same w = 1, whatever its depth.</source>
        <translation>Zrake projiciranja kvadra su paralelne. Sve se dijeli s istim w = 1, bez obzira na dubinu.</translation>
    </message>
    <message>
        <source>The pyramid grows, the box does not</source>
        <translation>Piramida raste, kvadar ne</translation>
    </message>
    <message>
        <source>With the vertical angle {0} the pyramid reaches, at the depth {1}, up to</source>
        <translation>Uz vertikalni kut {0} piramida na dubini {1} seže do</translation>
    </message>
    <message>
        <source>above the axis, and {0} of that to the side. Here {1}.</source>
        <translation>iznad osi, a u stranu {0} toliko. Ovdje je {1}.</translation>
    </message>
    <message>
        <source>depth</source>
        <translation>dubina</translation>
    </message>
    <message>
        <source>height</source>
        <translation>visina</translation>
    </message>
    <message>
        <source>to the side</source>
        <translation>u stranu</translation>
    </message>
    <message>
        <source>4, cube B</source>
        <translation>4, kocka B</translation>
    </message>
    <message>
        <source>8, cube A</source>
        <translation>8, kocka A</translation>
    </message>
    <message>
        <source>12, cube C</source>
        <translation>12, kocka C</translation>
    </message>
    <message>
        <source>The box has, at every depth, the sides that the pyramid has at the target, 8 units away: 2.91 and 5.18. Cube B stands 3 to the side: outside 2.59, inside 5.18. **World**, seen from *Above*, shows the pyramid.</source>
        <translation>Kvadar na svakoj dubini ima stranice koje piramida ima kod cilja, na udaljenosti od 8 jedinica: 2.91 i 5.18. Kocka B stoji 3 u stranu: izvan 2.59, unutar 5.18. **Svijet**, gledan *Odozgo*, pokazuje piramidu.</translation>
    </message>
    <message>
        <source>In the box, not in the pyramid</source>
        <translation>U kvadru, a ne u piramidi</translation>
    </message>
    <message>
        <source>Now the volume is the box. Probe 1 is at cube A, in both volumes. Drag it in **Image**, or type {0}, {1}, {2} in the world in *Probe*. The eye is at {3} and looks along {4}.</source>
        <translation>Sada je volumen kvadar. Sonda 1 je kod kocke A, u obama volumenima. Povucite je u oknu **Slika** ili u ploči *Sonda* upišite {0}, {1}, {2} kao globalne koordinate. Kamera je u {3} i gleda duž {4}.</translation>
    </message>
    <message>
        <source>Keep the box, and bring probe 1 to a place that is in the box but was outside the 40° pyramid.</source>
        <translation>Zadržite kvadar i dovedite sondu 1 na mjesto koje je u kvadru, a bilo je izvan piramide od 40°.</translation>
    </message>
    <message>
        <source>Where is the pyramid narrower than the box?</source>
        <translation>Gdje je piramida uža od kvadra?</translation>
    </message>
    <message>
        <source>Nearer to the eye than the target: there a point at the side of the box is beside the pyramid.</source>
        <translation>Bliže kameri nego što je cilj: ondje je točka na strani kvadra pokraj piramide.</translation>
    </message>
    <message>
        <source>Right: in front of the target the box is wider than the pyramid, behind it narrower.</source>
        <translation>Točno: ispred cilja kvadar je širi od piramide, iza njega uži.</translation>
    </message>
    <message>
        <source>The other way round</source>
        <translation>Obrnuto</translation>
    </message>
    <message>
        <source>The pyramid again, with near at 3 and far at 13. A grey name in **World** is outside. In the dock, *View volume* switches between the box and the pyramid.</source>
        <translation>Opet piramida, s bliskom ravninom na 3 i dalekom na 13. Sivo ime u oknu **Svijet** znači da je kocka izvan. Na bočnoj ploči *Volumen pogleda* prebacuje između kvadra i piramide.</translation>
    </message>
    <message>
        <source>Which cube is in the pyramid, but not in the box?</source>
        <translation>Koja je kocka u piramidi, a nije u kvadru?</translation>
    </message>
    <message>
        <source>B</source>
        <translation>B</translation>
    </message>
    <message>
        <source>B is the other way round: in the box, but beside the pyramid. Look at the box: B is inside.</source>
        <translation>Kod B je obrnuto: u kvadru je, ali pokraj piramide. Pogledajte kvadar: B je unutra.</translation>
    </message>
    <message>
        <source>C</source>
        <translation>C</translation>
    </message>
    <message>
        <source>E</source>
        <translation>E</translation>
    </message>
    <message>
        <source>E is in both: it is deep, but close to the axis. Look at the box: E is inside, too.</source>
        <translation>E je u obama: duboko je, ali blizu osi. Pogledajte kvadar: i E je unutra.</translation>
    </message>
    <message>
        <source>None: C is 13.9 from the eye, beyond far</source>
        <translation>Nijedna: C je 13.9 od kamere, iza daleke ravnine</translation>
    </message>
    <message>
        <source>Far is a plane across the axis: only the depth of 12 counts, not the 13.9. Look from above: C lies before far.</source>
        <translation>Daleka ravnina je ravnina okomita na os: računa se samo dubina 12, a ne 13.9. Pogledajte odozgo: C leži ispred daleke ravnine.</translation>
    </message>
    <message>
        <source>C is 12 deep and 7 to the side. There the pyramid reaches 7.76 to the side, the box only 5.18.</source>
        <translation>C je na dubini 12 i 7 u stranu. Ondje piramida seže 7.76 u stranu, a kvadar samo 5.18.</translation>
    </message>
    <message>
        <source>How high at depth 10?</source>
        <translation>Koliko visoko na dubini 10?</translation>
    </message>
    <message>
        <source>Now the angle is 50° and the depth is 10.</source>
        <translation>Sada je kut 50°, a dubina 10.</translation>
    </message>
    <message>
        <source>How far above the axis does the pyramid reach there?</source>
        <translation>Koliko visoko iznad osi ondje seže piramida?</translation>
    </message>
    <message>
        <source>The triangle of eye, axis and upper plane has half of the angle at the eye. Look at 90°: there the pyramid is as high as it is deep, {0}.</source>
        <translation>Trokut između kamere, osi i gornje ravnine ima kod kamere polovicu kuta. Pogledajte 90°: ondje je piramida visoka koliko i duboka, {0}.</translation>
    </message>
    <message>
        <source>The tangent takes my 25</source>
        <translation>Tangens uzima mojih 25</translation>
    </message>
    <message>
        <source>This is the tangent of 25 radians, almost four turns. Look at the angle: 25° is 0.436 radians.</source>
        <translation>Ovo je tangens od 25 radijana, gotovo četiri okreta. Pogledajte kut: 25° je 0.436 radijana.</translation>
    </message>
    <message>
        <source>The right-angled triangle between eye, axis and upper plane has half of the angle at the eye.</source>
        <translation>Pravokutni trokut između kamere, osi i gornje ravnine ima kod kamere polovicu kuta.</translation>
    </message>
    <message>
        <source>h = 10·tan 25° = 4.66</source>
        <translation>h = 10·tan 25° = 4.66</translation>
    </message>
    <message>
        <source>Three to the side at depth 6</source>
        <translation>Tri u stranu na dubini 6</translation>
    </message>
    <message>
        <source>The picture is 16 by 9. **World** shows the pyramid from *Above*; the label at the eye gives half of the horizontal angle.</source>
        <translation>Slika je 16 puta 9. **Svijet** pokazuje piramidu *Odozgo*; oznaka kod kamere daje polovicu horizontalnog kuta.</translation>
    </message>
    <message>
        <source>Keep the pyramid, and set the field of view so that it reaches 3 units to each side of the axis at depth 6.</source>
        <translation>Zadržite piramidu i postavite vidno polje tako da na dubini 6 seže po 3 jedinice na svaku stranu osi.</translation>
    </message>
    <message>
        <source>Half of the horizontal angle has the tangent 3/6.</source>
        <translation>Polovica horizontalnog kuta ima tangens 3/6.</translation>
    </message>
    <message>
        <source>Half of the vertical one has 9/16 of that tangent: 0.281.</source>
        <translation>Polovica vertikalnog ima 9/16 tog tangensa: 0.281.</translation>
    </message>
    <message>
        <source>Right: horizontally 53.1°, vertically 31.4° in this picture.</source>
        <translation>Točno: horizontalno 53.1°, vertikalno 31.4° na ovoj slici.</translation>
    </message>
    <message>
        <source>Back to the prediction</source>
        <translation>Natrag na predviđanje</translation>
    </message>
    <message>
        <source>It is tempting to expect the farther cube to be smaller: every picture of an eye or a camera shows it so, and it is true of the pyramid, whose section grows with the depth. A cube takes a smaller share of a larger section.</source>
        <translation>Primamljivo je očekivati da je udaljenija kocka manja: tako je pokazuje svaka slika oka ili kamere, i to vrijedi za piramidu, čiji presjek raste s dubinom. Kocka zauzima manji dio većeg presjeka.</translation>
    </message>
    <message>
        <source>The section of the box does not grow. A cube takes the same share of it at every depth. The picture loses the impression of depth: in **Image** nothing says that B is the nearer one.</source>
        <translation>Presjek kvadra ne raste. Kocka na svakoj dubini zauzima isti njegov dio. Slika gubi dojam dubine: u oknu **Slika** ništa ne govori da je B bliža.</translation>
    </message>
    <message>
        <source>Practise: which point goes first?</source>
        <translation>Vježba: koja točka nestaje prva?</translation>
    </message>
    <message>
        <source>You see the pyramid from above. Points 1, 2 and 3 are in it, at the height of the eye.</source>
        <translation>Piramidu vidite odozgo. Točke 1, 2 i 3 su u njoj, na visini kamere.</translation>
    </message>
    <message>
        <source>The far plane moves towards the eye. Mark the point that it cuts off first.</source>
        <translation>Daleka ravnina pomiče se prema kameri. Označite točku koju prvu odsiječe.</translation>
    </message>
    <message>
        <source>Far is a plane, so the depth counts, not the distance from the eye. Look at far, moved in: it has cut off another point, and this one is still before it.</source>
        <translation>Daleka ravnina je ravnina, pa se računa dubina, a ne udaljenost od kamere. Pogledajte primaknutu daleku ravninu: odsjekla je drugu točku, a ova je još ispred nje.</translation>
    </message>
    <message>
        <source>Far meets the nearest point first</source>
        <translation>Daleka ravnina prvo nailazi na najbližu točku</translation>
    </message>
    <message>
        <source>The far plane reaches this point last: it is the one that is least deep. Look at far, moved in to just behind this point: the other two are cut off.</source>
        <translation>Daleka ravnina do ove točke dolazi posljednje: ona je na najmanjoj dubini. Pogledajte daleku ravninu primaknutu tik iza ove točke: druge dvije su odsječene.</translation>
    </message>
    <message>
        <source>How does the far plane look from above?</source>
        <translation>Kako daleka ravnina izgleda odozgo?</translation>
    </message>
    <message>
        <source>It is {0} deep, the one at the side {1}, and the third {2}.</source>
        <translation>Na dubini je {0}, ona sa strane na {1}, a treća na {2}.</translation>
    </message>
    <message>
        <source>Practise: how high?</source>
        <translation>Vježba: koliko visoko?</translation>
    </message>
    <message>
        <source>You see the pyramid from the side; {0} is its vertical angle.</source>
        <translation>Piramidu vidite sa strane; {0} je njezin vertikalni kut.</translation>
    </message>
    <message>
        <source>Here {0}. How far above the axis does the pyramid reach at the depth {1}?</source>
        <translation>Ovdje je {0}. Koliko visoko iznad osi piramida seže na dubini {1}?</translation>
    </message>
    <message>
        <source>The tangent takes my degrees</source>
        <translation>Tangens uzima moje stupnjeve</translation>
    </message>
    <message>
        <source>This takes {0}° for {1} radians, which is more than a whole turn. Look at the angle: it is less than a quarter of one.</source>
        <translation>Ovo uzima {0}° kao {1} u radijanima, a to je više od cijelog okreta. Pogledajte kut: manji je od četvrtine okreta.</translation>
    </message>
    <message>
        <source>In the triangle of eye, axis and upper plane, the angle at the eye is half of {0}.</source>
        <translation>U trokutu između kamere, osi i gornje ravnine kut kod kamere je polovica od {0}.</translation>
    </message>
    <message>
        <source>Practise: how far to the side?</source>
        <translation>Vježba: koliko daleko u stranu?</translation>
    </message>
    <message>
        <source>The picture is 16 by 9. **World** shows the pyramid from above.</source>
        <translation>Slika je 16 puta 9. **Svijet** pokazuje piramidu odozgo.</translation>
    </message>
    <message>
        <source>Set the field of view so that the pyramid reaches {0} units to each side of the axis at the depth {1}.</source>
        <translation>Postavite vidno polje tako da piramida na dubini {1} seže {0} na svaku stranu osi.</translation>
    </message>
    <message>
        <source>Half of the horizontal angle has the tangent {0}/{1}.</source>
        <translation>Polovica horizontalnog kuta ima tangens {0}/{1}.</translation>
    </message>
    <message>
        <source>Half of the vertical angle has 9/16 of that tangent.</source>
        <translation>Polovica vertikalnog kuta ima 9/16 tog tangensa.</translation>
    </message>
    <message>
        <source>Half of the vertical angle has the tangent {0}, so the angle is {1} {2}.</source>
        <translation>Polovica vertikalnog kuta ima tangens {0}, pa je kut {1} {2}.</translation>
    </message>
    <message>
        <source>The triangle of eye, axis and side has half of the horizontal angle at the eye. Look from above: at the depth {0} the pyramid does not reach {1} to the side.</source>
        <translation>Trokut između kamere, osi i strane ima kod kamere polovicu horizontalnog kuta. Pogledajte odozgo: na dubini {0} piramida ne seže {1} u stranu.</translation>
    </message>
    <message>
        <source>The field of view is the vertical angle. Look from above: at the depth {0} the pyramid reaches {1} to the side.</source>
        <translation>Vidno polje je vertikalni kut. Pogledajte odozgo: na dubini {0} piramida seže {1} u stranu.</translation>
    </message>
</context>
<context>
    <name>l05-similar-triangles</name>
    <message>
        <source>How big on the picture plane?</source>
        <translation>Koliko veliko na ravnini slike?</translation>
    </message>
    <message>
        <source>The plane moves out</source>
        <translation>Ravnina se odmiče</translation>
    </message>
    <message>
        <source>The picture plane stands at the distance {0} in front of the eye. P is 5 units deep and 2 units above the axis. In **World**, from the *Side*, its projector runs to the eye and meets the plane at P&apos;, {1} above the axis. The plane will now move to {2}.</source>
        <translation>Ravnina slike stoji na udaljenosti {0} ispred kamere. P je na dubini od 5 jedinica i 2 jedinice iznad osi. U oknu **Svijet**, *Sa strane*, njezina zraka projiciranja ide do kamere i siječe ravninu u P&apos;, {1} iznad osi. Ravnina će se sada pomaknuti na {2}.</translation>
    </message>
    <message>
        <source>How many times as high as before is P&apos; above the axis then?</source>
        <translation>Koliko je puta P&apos; tada viša iznad osi nego prije?</translation>
    </message>
    <message>
        <source>This measures from the plane to P. The two triangles share the corner at the eye. Look at {0}: from the eye P is 5 deep, wherever the plane is.</source>
        <translation>Ovo mjeri od ravnine do P. Oba trokuta imaju zajednički vrh kod kamere. Pogledajte {0}: od kamere je P na dubini 5, gdje god bila ravnina.</translation>
    </message>
    <message>
        <source>The area of an image grows 4 times. Its height and its width grow in proportion to d. Look at {0} and {1}: both are twice as long as before.</source>
        <translation>Površina slike raste 4 puta. Visina i širina rastu proporcionalno s d. Pogledajte {0} i {1}: oboje je dvostruko dulje nego prije.</translation>
    </message>
    <message>
        <source>The height is proportional to d as long as P stays where it is.</source>
        <translation>Visina je proporcionalna s d dok P ostaje na mjestu.</translation>
    </message>
    <message>
        <source>Two similar triangles</source>
        <translation>Dva slična trokuta</translation>
    </message>
    <message>
        <source>The large triangle runs from the eye along the axis to the depth of P, and up to P: its sides are {0} and {1}. The small one runs along the axis to the plane, and up to P&apos;: {2} and {3}. Both have the same angle at the eye:</source>
        <translation>Veliki trokut ide od kamere duž osi do dubine točke P, pa gore do P: stranice su mu {0} i {1}. Mali ide duž osi do ravnine, pa gore do P&apos;: {2} i {3}. Oba imaju isti kut kod kamere:</translation>
    </message>
    <message>
        <source>P is {0} in camera space. With {1}: {2}. The dock has the numbers and the matrix with {3}. It takes P to {4}; divided by the last number, that is {5}.</source>
        <translation>P je {0} u koordinatnom sustavu kamere. Uz {1} je {2}. Na bočnoj ploči su brojevi i matrica s {3}. Ona točku P preslika u {4}; podijeljeno posljednjim brojem, to je {5}.</translation>
    </message>
    <message>
        <source>Half as large as the thing itself</source>
        <translation>Upola manje od same stvari</translation>
    </message>
    <message>
        <source>You can also use the triangles the other way round: how far away must the plane be?</source>
        <translation>Trokute možete upotrijebiti i obrnuto: koliko daleko mora biti ravnina?</translation>
    </message>
    <message>
        <source>Make the image of P half as far from the axis as P itself: {0}, {1}.</source>
        <translation>Neka slika točke P bude upola manje udaljena od osi nego sama P: {0}, {1}.</translation>
    </message>
    <message>
        <source>The scale is {0}. It is a number in the dock.</source>
        <translation>Mjerilo je {0}. To je broj na bočnoj ploči.</translation>
    </message>
    <message>
        <source>The plane must be halfway between the eye and the depth of P.</source>
        <translation>Ravnina mora biti na pola puta između kamere i dubine točke P.</translation>
    </message>
    <message>
        <source>Right: half way, half the size. Nothing else affects the scale.</source>
        <translation>Točno: na pola puta, upola manje. Ništa drugo ne utječe na mjerilo.</translation>
    </message>
    <message>
        <source>Another point</source>
        <translation>Druga točka</translation>
    </message>
    <message>
        <source>Now P is at {0} in camera space, and the plane is at {1}. The numbers in the dock come back with your answer.</source>
        <translation>Sada je P u {0} u koordinatnom sustavu kamere, a ravnina na {1}. Brojevi na bočnoj ploči vraćaju se s vašim odgovorom.</translation>
    </message>
    <message>
        <source>How large is {0}?</source>
        <translation>Koliko je {0}?</translation>
    </message>
    <message>
        <source>This divides by the distance from the plane to P. Look at {0} and {1}: both begin at the eye, where the two triangles have their common corner.</source>
        <translation>Ovo dijeli s udaljenošću od ravnine do P. Pogledajte {0} i {1}: oboje počinje kod kamere, gdje dva trokuta imaju zajednički vrh.</translation>
    </message>
    <message>
        <source>In front of the eye {0} is negative, so divide by {1}. Look at the plane behind the eye: only there is the image below the axis.</source>
        <translation>Ispred kamere {0} je negativan, zato dijelite s {1}. Pogledajte ravninu iza kamere: samo je ondje slika ispod osi.</translation>
    </message>
    <message>
        <source>The ratio of {0} to {1} equals the ratio of {2} to the depth.</source>
        <translation>Omjer {0} i {1} jednak je omjeru {2} i dubine.</translation>
    </message>
    <message>
        <source>The cell with d</source>
        <translation>Ćelija s d</translation>
    </message>
    <message>
        <source>As a matrix (000, formula 2) the projection leaves {0}, {1} and {2} as they are and makes the fourth coordinate {3}. The division does the rest.</source>
        <translation>Kao matrica (000, formula 2) projekcija ostavlja {0}, {1} i {2} kakvi jesu, a četvrtu koordinatu čini {3}. Dijeljenje čini ostalo.</translation>
    </message>
    <message>
        <source>The plane is at {0}. Which number is in row 4, column 3?</source>
        <translation>Ravnina je na {0}. Koji je broj u retku 4, stupcu 3?</translation>
    </message>
    <message>
        <source>There is no minus in the matrix</source>
        <translation>U matrici nema minusa</translation>
    </message>
    <message>
        <source>Then the fourth coordinate would be {0}. For points in front of the eye {1} is negative, so {2} and {3} would change their signs. Look at the plane of this matrix: it is behind the eye, and the image is upside down.</source>
        <translation>Tada bi četvrta koordinata bila {0}. Za točke ispred kamere {1} je negativan, pa bi {2} i {3} promijenili predznak. Pogledajte ravninu te matrice: iza kamere je, a slika je naopačke.</translation>
    </message>
    <message>
        <source>This is row 3, column 4. Row 4 makes the fourth coordinate, {0}, and column 3 is the share of {1}. Look at {2} and {3}: their ratio is the divisor.</source>
        <translation>Ovo je redak 3, stupac 4. Redak 4 čini četvrtu koordinatu, {0}, a stupac 3 je udio koordinate {1}. Pogledajte {2} i {3}: njihov je omjer djelitelj.</translation>
    </message>
    <message>
        <source>Row 4 times (x, y, z, 1) must equal {0}.</source>
        <translation>Redak 4 puta (x, y, z, 1) mora biti jednak {0}.</translation>
    </message>
    <message>
        <source>{0}. For points in front {1} is negative, and so {2} is positive.</source>
        <translation>{0}. Za točke ispred kamere {1} je negativan, pa je {2} pozitivan.</translation>
    </message>
    <message>
        <source>Set the plane</source>
        <translation>Postavite ravninu</translation>
    </message>
    <message>
        <source>P is at {0} in camera space again, and the plane is at {1}.</source>
        <translation>P je opet u {0} u koordinatnom sustavu kamere, a ravnina na {1}.</translation>
    </message>
    <message>
        <source>Keep P in its place, and move the plane until the image of P is 1.5 above the axis.</source>
        <translation>Ostavite P na mjestu i pomičite ravninu dok slika točke P ne bude 1.5 iznad osi.</translation>
    </message>
    <message>
        <source>1.5 is three quarters of 2.</source>
        <translation>1.5 je tri četvrtine od 2.</translation>
    </message>
    <message>
        <source>Right: three quarters of the height, three quarters of the way: d = 3.75.</source>
        <translation>Točno: tri četvrtine visine, tri četvrtine puta: d = 3.75.</translation>
    </message>
    <message>
        <source>Back to the prediction</source>
        <translation>Natrag na predviđanje</translation>
    </message>
    <message>
        <source>It is tempting to measure from the plane to P: 4 units before, 3 units after, so {0} against {1}, which is 2.67 times. But the two triangles share the corner at the eye. Measured from there, P stays 5 units deep wherever the plane is, and {2} grows from {3} to {4}.</source>
        <translation>Primamljivo je mjeriti od ravnine do P: 4 jedinice prije, 3 jedinice poslije, dakle {0} prema {1}, što je 2.67 puta. Ali dva trokuta imaju zajednički vrh kod kamere. Mjereno odande, P ostaje na dubini od 5 jedinica gdje god bila ravnina, a {2} raste od {3} do {4}.</translation>
    </message>
    <message>
        <source>This also says what happens to the *picture* when the plane moves: everything grows by the same factor, and nothing moves against the rest.</source>
        <translation>To govori i što biva sa *slikom* kad se ravnina pomakne: sve raste istim faktorom i ništa se ne pomiče prema ostalome.</translation>
    </message>
    <message>
        <source>Practise: how high is the image?</source>
        <translation>Vježba: koliko je visoka slika?</translation>
    </message>
    <message>
        <source>P is in camera space, and the picture plane is at the distance {0} from the eye.</source>
        <translation>P je u koordinatnom sustavu kamere, a ravnina slike na udaljenosti {0} od kamere.</translation>
    </message>
    <message>
        <source>P is at {0}, and {1}. How large is {2}?</source>
        <translation>P je u {0}, a {1}. Koliko je {2}?</translation>
    </message>
    <message>
        <source>The two similar triangles share the corner at the eye.</source>
        <translation>Dva slična trokuta imaju zajednički vrh kod kamere.</translation>
    </message>
    <message>
        <source>Practise: the matrix with -1/d</source>
        <translation>Vježba: matrica s -1/d</translation>
    </message>
    <message>
        <source>The matrix keeps {0}, {1} and {2}; its row 4 has {3} in column 3 and zeros elsewhere. The division comes afterwards.</source>
        <translation>Matrica zadržava {0}, {1} i {2}; njezin redak 4 ima {3} u stupcu 3, a drugdje nule. Dijeljenje dolazi poslije.</translation>
    </message>
    <message>
        <source>The plane is at {0}. What does the matrix make of {1}?</source>
        <translation>Ravnina je na {0}. Što matrica čini od {1}?</translation>
    </message>
    <message>
        <source>In front of the eye {0} is negative, so the division would change the signs of {1} and {2}. Look at the plane of this matrix: it is behind the eye, and the image is upside down.</source>
        <translation>Ispred kamere {0} je negativan, pa bi dijeljenje promijenilo predznake od {1} i {2}. Pogledajte ravninu te matrice: iza kamere je, a slika je naopačke.</translation>
    </message>
    <message>
        <source>This has {0} in row 3, column 4. Row 4 makes the fourth coordinate, and column 3 is the share of {1}. Look at {2} and {3}: their ratio is the divisor.</source>
        <translation>Ovo ima {0} u retku 3, stupcu 4. Redak 4 čini četvrtu koordinatu, a stupac 3 je udio koordinate {1}. Pogledajte {2} i {3}: njihov je omjer djelitelj.</translation>
    </message>
    <message>
        <source>Row 4 times {0} is {1} times {2}.</source>
        <translation>Redak 4 puta {0} je {1} puta {2}.</translation>
    </message>
    <message>
        <source>Divided by its last number, it is P&apos;: {0}.</source>
        <translation>Podijeljeno posljednjim brojem to je P&apos;: {0}.</translation>
    </message>
    <message>
        <source>Practise: set the plane</source>
        <translation>Vježba: postavite ravninu</translation>
    </message>
    <message>
        <source>The plane is at {0}. Drag it, or type {1} in the dock.</source>
        <translation>Ravnina je na {0}. Povucite je ili na bočnoj ploči upišite {1}.</translation>
    </message>
    <message>
        <source>P is {0} deep and {1} above the axis. Leave it there, and move the plane until the image P&apos; is {2} above the axis.</source>
        <translation>P je na dubini {0} i {1} iznad osi. Ostavite je ondje i pomičite ravninu dok slika P&apos; ne bude {2} iznad osi.</translation>
    </message>
    <message>
        <source>Your plane is behind the eye. Look at P&apos;: it is below the axis.</source>
        <translation>Vaša ravnina je iza kamere. Pogledajte P&apos;: ispod osi je.</translation>
    </message>
    <message>
        <source>This measures the depth of P from the plane. Both triangles begin at the eye. Look at P&apos;: it is less than {0} above the axis.</source>
        <translation>Ovo mjeri dubinu točke P od ravnine. Oba trokuta počinju kod kamere. Pogledajte P&apos;: manje je od {0} iznad osi.</translation>
    </message>
</context>
<context>
    <name>l06-off-axis-frustum</name>
    <message>
        <source>Why six numbers?</source>
        <translation>Zašto šest brojeva?</translation>
    </message>
    <message>
        <source>The window goes to the right</source>
        <translation>Prozor ide udesno</translation>
    </message>
    <message>
        <source>A frustum is given by six numbers: left, right, bottom and top of its window on the near plane, and near and far. The window here reaches from {0} to {1}; the point straight ahead of the eye, probe 1, is in the middle of **Image**. The eye stays where it is, and the window moves to the right: {2}, {3}.</source>
        <translation>Krnju piramidu zadaje šest brojeva: lijevi, desni, donji i gornji rub njezina prozora na bliskoj ravnini te bliska i daleka ravnina. Prozor ovdje seže od {0} do {1}; točka ravno ispred kamere, sonda 1, u sredini je okna **Slika**. Kamera ostaje gdje jest, a prozor se pomiče udesno: {2}, {3}.</translation>
    </message>
    <message>
        <source>Where is probe 1 in the picture then? NDC has {0} at the left edge and {1} at the right one.</source>
        <translation>Gdje je tada sonda 1 na slici? NDC ima {0} na lijevom rubu, a {1} na desnom.</translation>
    </message>
    <message>
        <source>Straight ahead is in the middle only if the window is as far to the left as to the right. Look at this window: it reaches 2 to each side, and probe 1 is in the middle.</source>
        <translation>Ravno naprijed je u sredini samo ako prozor seže ulijevo koliko i udesno. Pogledajte ovaj prozor: seže po 2 na svaku stranu, i sonda 1 je u sredini.</translation>
    </message>
    <message>
        <source>This moves the picture with its window. Look at the window that has moved to the left: only then is probe 1 at {0}.</source>
        <translation>Ovo pomiče sliku s prozorom. Pogledajte prozor koji se pomaknuo ulijevo: samo je tada sonda 1 u {0}.</translation>
    </message>
    <message>
        <source>There is now 1 unit of window left of the axis, and 3 units right of it. So the axis is a quarter of the way across.</source>
        <translation>Sada je 1 jedinica prozora lijevo od osi, a 3 jedinice desno od nje. Zato je os na četvrtini širine.</translation>
    </message>
    <message>
        <source>From the window to [-1, 1]</source>
        <translation>Od prozora do [-1, 1]</translation>
    </message>
    <message>
        <source>First the point comes to the near plane, by similar triangles: {0}. Then the range {1} becomes {2}:</source>
        <translation>Točka najprije dolazi na blisku ravninu, po sličnim trokutima: {0}. Zatim interval {1} postaje {2}:</translation>
    </message>
    <message>
        <source>With {0}, {1}, {2} the cells are {3} and {4}. The second one stands in column 3: it is multiplied by {5}, which is negative, and so the axis comes to {6}.</source>
        <translation>Uz {0}, {1}, {2} ćelije su {3} i {4}. Druga stoji u stupcu 3: množi se s {5}, što je negativno, i zato os dolazi u {6}.</translation>
    </message>
    <message>
        <source>Bottom, top and y work the same way. *Matrices* shows the whole matrix as clip ← view. For {0} that cell is 0, as in gluPerspective.</source>
        <translation>Donji rub, gornji rub i y rade na isti način. *Matrice* pokazuju cijelu matricu kao odsijecanje ← kamera. Za {0} ta je ćelija 0, kao u gluPerspective.</translation>
    </message>
    <message>
        <source>The axis on the other side</source>
        <translation>Os na drugoj strani</translation>
    </message>
    <message>
        <source>Probe 1 still is straight ahead of the eye. *Probe*, below the pictures, has its {0} in the row NDC.</source>
        <translation>Sonda 1 je i dalje ravno ispred kamere. *Sonda*, ispod slika, ima njezin {0} u retku NDC.</translation>
    </message>
    <message>
        <source>Bring the axis to the right half of the picture, to x&apos; = 0.5.</source>
        <translation>Dovedite os na desnu polovicu slike, u x&apos; = 0.5.</translation>
    </message>
    <message>
        <source>Which side must the window reach farther to?</source>
        <translation>Na koju stranu prozor mora sezati dalje?</translation>
    </message>
    <message>
        <source>Three times as far to the left as to the right: Left −3, Right 1.</source>
        <translation>Triput dalje ulijevo nego udesno: Lijevi rub −3, Desni rub 1.</translation>
    </message>
    <message>
        <source>Right: three quarters of the window are left of the axis.</source>
        <translation>Točno: tri četvrtine prozora su lijevo od osi.</translation>
    </message>
    <message>
        <source>The cell beside 2n/(r-l)</source>
        <translation>Ćelija uz 2n/(r-l)</translation>
    </message>
    <message>
        <source>The window now reaches from {0} to {1} on the near plane at {2}.</source>
        <translation>Prozor sada seže od {0} do {1} na bliskoj ravnini na {2}.</translation>
    </message>
    <message>
        <source>Which number is in row 1, column 3 of the frustum matrix?</source>
        <translation>Koji je broj u retku 1, stupcu 3 matrice krnje piramide?</translation>
    </message>
    <message>
        <source>The cell is positive if the window reaches farther to the right; {0}, which is negative, turns the sign. Look at the window from −4 to 1: it is the one with −0.6.</source>
        <translation>Ćelija je pozitivna ako prozor seže dalje udesno; {0}, koji je negativan, okreće predznak. Pogledajte prozor od −4 do 1: njemu pripada −0.6.</translation>
    </message>
    <message>
        <source>This is row 3, column 1. Row 1 makes {0}, and its column 3 is the share of {1}. Look at a symmetric window: only there is this share 0.</source>
        <translation>Ovo je redak 3, stupac 1. Redak 1 čini {0}, a njegov stupac 3 je udio koordinate {1}. Pogledajte simetričan prozor: samo je ondje taj udio 0.</translation>
    </message>
    <message>
        <source>r + l is 3, r - l is 5.</source>
        <translation>r + l je 3, r - l je 5.</translation>
    </message>
    <message>
        <source>(r + l)/(r - l) = 3/5. The cell is multiplied by z, which is negative; that turns the sign.</source>
        <translation>(r + l)/(r - l) = 3/5. Ćelija se množi sa z, koji je negativan; to okreće predznak.</translation>
    </message>
    <message>
        <source>The cell for the depth</source>
        <translation>Ćelija za dubinu</translation>
    </message>
    <message>
        <source>Row 3 is {0} with {1} and {2}.</source>
        <translation>Redak 3 je {0}, uz {1} i {2}.</translation>
    </message>
    <message>
        <source>Near is 2 and far is 10. How large is {0}, in row 3, column 4?</source>
        <translation>Bliska ravnina je 2, a daleka 10. Koliko je {0}, u retku 3, stupcu 4?</translation>
    </message>
    <message>
        <source>This uses {0} and {1}, but near and far are lengths. Look at the planes: both are in front of the eye, at negative {2}, and the formula already contains that minus.</source>
        <translation>Ovo uzima {0} i {1}, ali bliska i daleka ravnina zadane su duljinama. Pogledajte ravnine: obje su ispred kamere, na negativnom {2}, a formula već sadrži taj minus.</translation>
    </message>
    <message>
        <source>This is row 4, column 3, which makes {0}. {1} is added to {2} in row 3. Look at near and far: {3} and {4} take them to {5} and {6}.</source>
        <translation>Ovo je redak 4, stupac 3, koji čini {0}. {1} se pribraja {2} u retku 3. Pogledajte blisku i daleku ravninu: {3} i {4} preslikavaju ih u {5} i {6}.</translation>
    </message>
    <message>
        <source>n and f are distances, and positive.</source>
        <translation>n i f su udaljenosti, i pozitivne su.</translation>
    </message>
    <message>
        <source>Back to the prediction</source>
        <translation>Natrag na predviđanje</translation>
    </message>
    <message>
        <source>It is tempting to move the picture with the window: to the right, {0}. But the window is the frame through which you see the scene. If you move a frame to the right, you see more of what is on the right, and what was in the middle is now left of the middle.</source>
        <translation>Primamljivo je pomaknuti sliku zajedno s prozorom: udesno, {0}. Ali prozor je okvir kroz koji vidite scenu. Ako okvir pomaknete udesno, vidite više onoga što je desno, a ono što je bilo u sredini sada je lijevo od sredine.</translation>
    </message>
    <message>
        <source>The plus in {0} does not contradict this. The cell is multiplied by {1}, and {2} is {3} at probe 1: {4}. Lecture 002 writes a plus where its own signs require a minus. So always try such a sign on a point.</source>
        <translation>Plus u {0} tome ne proturječi. Ćelija se množi s {1}, a {2} je {3} kod sonde 1: {4}. Predavanje 002 piše plus ondje gdje njegovi vlastiti predznaci traže minus. Zato takav predznak uvijek isprobajte na točki.</translation>
    </message>
    <message>
        <source>Two eyes, one window</source>
        <translation>Dva oka, jedan prozor</translation>
    </message>
    <message>
        <source>A stereo pair needs two such frusta: both eyes look through one window, the screen plane at {0}. The right eye is {1} to the right, so its window on the near plane, at {2}, is {3} farther left. Both {4} and {5} are 0.2 less; only the cell {6} changes.</source>
        <translation>Stereopar treba dvije takve krnje piramide: oba oka gledaju kroz isti prozor, ravninu ekrana na {0}. Desno oko je {1} udesno, pa je njegov prozor na bliskoj ravnini, na {2}, {3} više lijevo. I {4} i {5} manji su za 0.2; mijenja se samo ćelija {6}.</translation>
    </message>
    <message>
        <source>{0}, below the middle and right of it, is equally high in both pictures. Now both cameras get a symmetric frustum and turn to the middle of the screen plane, as eyes turn.</source>
        <translation>{0}, ispod sredine i desno od nje, jednako je visoko na objema slikama. Sada obje kamere dobivaju simetričnu krnju piramidu i okreću se prema sredini ravnine ekrana, kao što se okreću oči.</translation>
    </message>
    <message>
        <source>How high is {0} in the right picture then?</source>
        <translation>Koliko je {0} tada visoko na desnoj slici?</translation>
    </message>
    <message>
        <source>Lower than in the left one</source>
        <translation>Niže nego na lijevoj</translation>
    </message>
    <message>
        <source>As high as in the left one</source>
        <translation>Jednako visoko kao na lijevoj</translation>
    </message>
    <message>
        <source>Each turned camera divides by the depth along its own axis, and no pair of eyes can look up with one eye and down with the other. Look at {0}: it is not equally high in both pictures.</source>
        <translation>Svaka okrenuta kamera dijeli s dubinom duž vlastite osi, a nikoji par očiju ne može jednim okom gledati gore, a drugim dolje. Pogledajte {0}: na dvjema slikama nije jednako visoko.</translation>
    </message>
    <message>
        <source>Higher than in the left one</source>
        <translation>Više nego na lijevoj</translation>
    </message>
    <message>
        <source>The right camera turns left, so {0}, on the right, is less deep for it. It divides by less, and {1} is farther from the middle. Look at {2} in both pictures: in the right one it is lower.</source>
        <translation>Desna kamera okreće se ulijevo, pa je {0}, koje je desno, za nju na manjoj dubini. Dijeli s manjim brojem, i {1} je dalje od sredine. Pogledajte {2} na objema slikama: na desnoj je niže.</translation>
    </message>
    <message>
        <source>Each camera divides by the depth along its own axis: 5.06 for the left one, 4.96 for the right one. The right one divides by less, so {0} is 3.5 pixels lower there. Off the axis both divide by 5.</source>
        <translation>Svaka kamera dijeli s dubinom duž vlastite osi: 5.06 za lijevu, 4.96 za desnu. Desna dijeli s manjim brojem, pa je {0} ondje 3.5 piksela niže. Kod asimetričnih krnjih piramida obje dijele s 5.</translation>
    </message>
    <message>
        <source>Practise: the row with l and r</source>
        <translation>Vježba: redak s l i r</translation>
    </message>
    <message>
        <source>The window on the near plane, at the distance {0}, reaches from {1} to {2} in x.</source>
        <translation>Prozor na bliskoj ravnini, na udaljenosti {0}, po x seže od {1} do {2}.</translation>
    </message>
    <message>
        <source>Here {0}, {1} and {2}. Which four numbers are in row 1 of the frustum matrix?</source>
        <translation>Ovdje je {0}, {1} i {2}. Koja su četiri broja u retku 1 matrice krnje piramide?</translation>
    </message>
    <message>
        <source>The cell is positive if the window reaches farther to the right; {0}, which is negative, turns the sign. Look at the mirrored window: it is the one with your row.</source>
        <translation>Ćelija je pozitivna ako prozor seže dalje udesno; {0}, koji je negativan, okreće predznak. Pogledajte zrcaljeni prozor: njemu pripada vaš redak.</translation>
    </message>
    <message>
        <source>Row 1 makes {0}, and its column 3 is the share of {1}. Look at a symmetric window: only there is this share 0.</source>
        <translation>Redak 1 čini {0}, a njegov stupac 3 je udio koordinate {1}. Pogledajte simetričan prozor: samo je ondje taj udio 0.</translation>
    </message>
    <message>
        <source>Row 1 times {0} is {1}.</source>
        <translation>Redak 1 puta {0} je {1}.</translation>
    </message>
    <message>
        <source>The axis comes to {0}, because {1} is negative.</source>
        <translation>Os dolazi u {0}, jer je {1} negativan.</translation>
    </message>
    <message>
        <source>Practise: two images in the screen plane</source>
        <translation>Vježba: dvije slike u ravnini ekrana</translation>
    </message>
    <message>
        <source>Two eyes, {0} apart, look through the screen plane at the distance {1}. For each eye {2}, at the distance {3}, has an image there: {4} and {5}.</source>
        <translation>Dva oka, razmaknuta {0}, gledaju kroz ravninu ekrana na udaljenosti {1}. Za svako oko {2}, na udaljenosti {3}, ondje ima sliku: {4} i {5}.</translation>
    </message>
    <message>
        <source>The eyes are {0} apart, the screen plane is at {1}, and {2} is at {3}. How far to the right of {4} is {5}, in the screen plane? If it is to the left, the number is negative.</source>
        <translation>Oči su razmaknute {0}, ravnina ekrana je na {1}, a {2} na {3}. Koliko je desno od {4} slika {5}, u ravnini ekrana? Ako je lijevo, broj je negativan.</translation>
    </message>
    <message>
        <source>The screen&apos;s distance is the height</source>
        <translation>Udaljenost ekrana je visina</translation>
    </message>
    <message>
        <source>This takes the screen&apos;s distance for the height of the large triangle. That one reaches from {0} to the eyes, and its height is {1}. Look at both triangles.</source>
        <translation>Ovo uzima udaljenost ekrana kao visinu velikog trokuta. On seže od {0} do očiju, i visina mu je {1}. Pogledajte oba trokuta.</translation>
    </message>
    <message>
        <source>Two symmetric frusta will do</source>
        <translation>Dovoljne su dvije simetrične krnje piramide</translation>
    </message>
    <message>
        <source>This is what two symmetric frusta side by side show: what is infinitely far away would lie in the screen plane. The windows move by {0} against each other, so add {1}. Look at {2} and {3}: {4} is behind the screen plane, and they are closer together than the eyes.</source>
        <translation>To pokazuju dvije simetrične krnje piramide jedna uz drugu: što je beskonačno daleko, ležalo bi u ravnini ekrana. Prozori se pomiču za {0} jedan prema drugome, zato dodajte {1}. Pogledajte {2} i {3}: {4} je iza ravnine ekrana, a one su bliže jedna drugoj nego oči.</translation>
    </message>
    <message>
        <source>Both eyes and {0} are a triangle, {1}, {2} and {3} another one, similar to it.</source>
        <translation>Oba oka i {0} čine trokut, {1}, {2} i {3} drugi, njemu sličan.</translation>
    </message>
    <message>
        <source>Their heights are {0} and {1}. Before the screen plane the second one stands upside down.</source>
        <translation>Visine su im {0} i {1}. Ispred ravnine ekrana drugi stoji naopačke.</translation>
    </message>
    <message>
        <source>The triangles are similar, so {0}. What lies in the screen plane has {1}, and nothing behind it reaches {2}.</source>
        <translation>Trokuti su slični, pa je {0}. Što leži u ravnini ekrana, ima {1}, a ništa iza nje ne doseže {2}.</translation>
    </message>
    <message>
        <source>Practise: move the window</source>
        <translation>Vježba: pomaknite prozor</translation>
    </message>
    <message>
        <source>The window reaches from {0} to {1} on the near plane.</source>
        <translation>Prozor na bliskoj ravnini seže od {0} do {1}.</translation>
    </message>
    <message>
        <source>Make the cell in row 1, column 3 of the frustum matrix equal to {0}, and leave the cell in row 1, column 1 at {1}.</source>
        <translation>Neka ćelija u retku 1, stupcu 3 matrice krnje piramide bude jednaka {0}, a ćelija u retku 1, stupcu 1 neka ostane {1}.</translation>
    </message>
    <message>
        <source>The cells are {0} and {1}.</source>
        <translation>Ćelije su {0} i {1}.</translation>
    </message>
    <message>
        <source>If {0} stays at {1}, the width {2} stays 4.</source>
        <translation>Ako {0} ostaje {1}, širina {2} ostaje 4.</translation>
    </message>
    <message>
        <source>With {0} the width {1} stays {2}, and {3}. So {4} and {5}.</source>
        <translation>Uz {0} širina {1} ostaje {2}, a {3}. Dakle {4} i {5}.</translation>
    </message>
    <message>
        <source>The cell has the sign of {0}. Look at your window: it reaches farther to the other side.</source>
        <translation>Ćelija ima predznak izraza {0}. Pogledajte svoj prozor: dalje seže na drugu stranu.</translation>
    </message>
</context>
<context>
    <name>l07-proportions</name>
    <message>
        <source>A picture of another shape</source>
        <translation>Slika drugog oblika</translation>
    </message>
    <message>
        <source>A wide window in a square picture</source>
        <translation>Širok prozor na kvadratnoj slici</translation>
    </message>
    <message>
        <source>The window on the near plane is 4 wide and 2 high: {0} from -2 to 2, {1} from -1 to 1. The picture has 720 by 720 pixels. Stretched into it, the letter F is twice as high as it should be. Lecture 000 has two remedies. Variant X replaces {2} by {3} (and {4} by {5}), so that the proportions are right.</source>
        <translation>Prozor na bliskoj ravnini širok je 4, a visok 2: {0} od -2 do 2, {1} od -1 do 1. Slika ima 720 puta 720 piksela. Rastegnuto na nju, slovo F je dvaput više nego što treba biti. Predavanje 000 ima dva lijeka. Varijanta X zamjenjuje {2} s {3} (i {4} s {5}), tako da proporcije budu ispravne.</translation>
    </message>
    <message>
        <source>How large is {0}?</source>
        <translation>Koliko je {0}?</translation>
    </message>
    <message>
        <source>Variant X *keeps* x. Look at variant Y: it is the one that leaves y as it is, and adjusts x.</source>
        <translation>Varijanta X *zadržava* x. Pogledajte varijantu Y: ona ostavlja y kakav jest i prilagođava x.</translation>
    </message>
    <message>
        <source>This adds the whole missing length at each end. Look at the picture: the window is 6 high and 4 wide now, and the F is too low.</source>
        <translation>Ovo dodaje cijelu duljinu koja nedostaje na svakom kraju. Pogledajte sliku: prozor je sada visok 6 i širok 4, pa je F prenizak.</translation>
    </message>
    <message>
        <source>The window must become as high as it is wide, 4. It grows equally at both ends: by 1 below and by 1 above.</source>
        <translation>Prozor mora postati visok koliko je širok, 4. Raste jednako na oba kraja: za 1 dolje i za 1 gore.</translation>
    </message>
    <message>
        <source>The number k</source>
        <translation>Broj k</translation>
    </message>
    <message>
        <source>Only the proportions matter: circles stay round if</source>
        <translation>Važne su samo proporcije: kružnice ostaju okrugle ako je</translation>
    </message>
    <message>
        <source>Variant X keeps {0} and adds {1} at both ends of {2}:</source>
        <translation>Varijanta X zadržava {0} i dodaje {1} na oba kraja intervala {2}:</translation>
    </message>
    <message>
        <source>Here {0}, so {1} goes from {2} to {3}. Variant Y keeps {4}: {5}, and {6} goes from {7} to {8}. **World** has {9}, {10} and {11} at the window. **Image** shows the three: stretched, variant Y, variant X. In the dock they are **Proportions**, in *More of the lens*.</source>
        <translation>Ovdje je {0}, pa {1} ide od {2} do {3}. Varijanta Y zadržava {4}: {5}, a {6} ide od {7} do {8}. **Svijet** uz prozor ima {9}, {10} i {11}. **Slika** pokazuje sve tri: rastegnutu, varijantu Y, varijantu X. Na bočnoj ploči to su **Proporcije**, u *Više o objektivu*.</translation>
    </message>
    <message>
        <source>stretched</source>
        <translation>rastegnuta</translation>
    </message>
    <message>
        <source>variant Y</source>
        <translation>varijanta Y</translation>
    </message>
    <message>
        <source>variant X</source>
        <translation>varijanta X</translation>
    </message>
    <message>
        <source>Cubes that are cubes</source>
        <translation>Kocke koje su kocke</translation>
    </message>
    <message>
        <source>The picture is stretched.</source>
        <translation>Slika je rastegnuta.</translation>
    </message>
    <message>
        <source>Give the picture its right proportions: choose keep x, fit y.</source>
        <translation>Dajte slici ispravne proporcije: odaberite zadrži x, prilagodi y.</translation>
    </message>
    <message>
        <source>Find Proportions in the dock: More of the lens.</source>
        <translation>Nađite Proporcije na bočnoj ploči: Više o objektivu.</translation>
    </message>
    <message>
        <source>Right: a unit of x has as many pixels as a unit of y. The fields still show the typed window.</source>
        <translation>Točno: jedinica po x ima onoliko piksela koliko i jedinica po y. Polja i dalje pokazuju upisani prozor.</translation>
    </message>
    <message>
        <source>A picture twice as wide as high</source>
        <translation>Slika dvostruko šira nego viša</translation>
    </message>
    <message>
        <source>The window is {0} from -3 to 3, {1} from -1 to 1. The picture has 1000 by 500 pixels.</source>
        <translation>Prozor je {0} od -3 do 3, {1} od -1 do 1. Slika ima 1000 puta 500 piksela.</translation>
    </message>
    <message>
        <source>Variant X: how large is {0}?</source>
        <translation>Varijanta X: koliko je {0}?</translation>
    </message>
    <message>
        <source>This adds the whole missing length at each end. Look at the picture: the window is 4 high and 6 wide now, not twice as wide as high, and the F is too low.</source>
        <translation>Ovo dodaje cijelu duljinu koja nedostaje na svakom kraju. Pogledajte sliku: prozor je sada visok 4 i širok 6, a ne dvostruko širi nego viši, pa je F prenizak.</translation>
    </message>
    <message>
        <source>How high must a window be that is 6 wide, for a picture of 1000 by 500?</source>
        <translation>Koliko visok mora biti prozor širine 6 za sliku od 1000 puta 500?</translation>
    </message>
    <message>
        <source>3 high, and it is 2 high now.</source>
        <translation>Visok 3, a sada je visok 2.</translation>
    </message>
    <message>
        <source>{0}, and so {1} goes from {2} to 1.5.</source>
        <translation>{0}, pa {1} ide od {2} do 1.5.</translation>
    </message>
    <message>
        <source>Variant Y</source>
        <translation>Varijanta Y</translation>
    </message>
    <message>
        <source>Variant Y keeps {0} and adds {1} at both ends of {2}: {3}. (The last line of the handout has {4} there, which is a slip.)</source>
        <translation>Varijanta Y zadržava {0} i dodaje {1} na oba kraja intervala {2}: {3}. (Posljednji redak nastavnog materijala ondje ima {4}, što je omaška.)</translation>
    </message>
    <message>
        <source>The window is {0} from -1 to 3, {1} from -2 to 2, the picture 1000 by 500.</source>
        <translation>Prozor je {0} od -1 do 3, {1} od -2 do 2, a slika 1000 puta 500.</translation>
    </message>
    <message>
        <source>This adds the whole missing length at each end. Look at the picture: the window is 12 wide and 4 high now, not twice as wide as high, and the F is too narrow.</source>
        <translation>Ovo dodaje cijelu duljinu koja nedostaje na svakom kraju. Pogledajte sliku: prozor je sada širok 12 i visok 4, a ne dvostruko širi nego viši, pa je F preuzak.</translation>
    </message>
    <message>
        <source>Variant Y *keeps* y. Look at variant X: it is the one that leaves x as it is, and adjusts y.</source>
        <translation>Varijanta Y *zadržava* y. Pogledajte varijantu X: ona ostavlja x kakav jest i prilagođava y.</translation>
    </message>
    <message>
        <source>The window must become 8 wide.</source>
        <translation>Prozor mora postati širok 8.</translation>
    </message>
    <message>
        <source>{0}, and so {1} goes from {2} to 5. Its middle is still 1.</source>
        <translation>{0}, pa {1} ide od {2} do 5. Sredina mu je i dalje 1.</translation>
    </message>
    <message>
        <source>X by hand</source>
        <translation>X ručno</translation>
    </message>
    <message>
        <source>The picture is 720 by 720 and stretched; the window is {0} from -2 to 2, {1} from -1 to 1 again.</source>
        <translation>Slika je 720 puta 720 i rastegnuta; prozor je opet {0} od -2 do 2, {1} od -1 do 1.</translation>
    </message>
    <message>
        <source>Leave Proportions at stretch, and give Bottom and Top the values that variant X would.</source>
        <translation>Ostavite Proporcije na postavci rastegni i dajte Donjem rubu i Gornjem rubu vrijednosti koje bi dala varijanta X.</translation>
    </message>
    <message>
        <source>The window must be as high as it is wide.</source>
        <translation>Prozor mora biti visok koliko je širok.</translation>
    </message>
    <message>
        <source>Right: keep x does exactly this, and repeats it whenever the picture changes its shape.</source>
        <translation>Točno: zadrži x čini upravo to i ponavlja kad god slika promijeni oblik.</translation>
    </message>
    <message>
        <source>Back to the prediction</source>
        <translation>Natrag na predviđanje</translation>
    </message>
    <message>
        <source>Two answers are tempting. The answer 3 adds 2 units at each end, so the window would be 6 high instead of 4. {0} is *half* of what is missing, because it is added twice.</source>
        <translation>Primamljiva su dva odgovora. Odgovor 3 dodaje 2 jedinice na svakom kraju, pa bi prozor bio visok 6 umjesto 4. {0} je *polovica* onoga što nedostaje, jer se dodaje dvaput.</translation>
    </message>
    <message>
        <source>The answer 1 leaves {0} as it is: the name of the variant sounds as if X changed. But X is what it *keeps*. With the same letter F and the same eye, X shows more of the scene above and below; Y takes away at the sides.</source>
        <translation>Odgovor 1 ostavlja {0} kakav jest: ime varijante zvuči kao da se X mijenja. Ali X je ono što *zadržava*. S istim slovom F i istom kamerom X pokazuje više scene gore i dolje; Y oduzima sa strana.</translation>
    </message>
    <message>
        <source>Practise: how wide does Y make it?</source>
        <translation>Vježba: koliko ga širokim čini Y?</translation>
    </message>
    <message>
        <source>The picture is stretched. Variant Y keeps {0}, and makes the window as wide as the picture&apos;s proportions require.</source>
        <translation>Slika je rastegnuta. Varijanta Y zadržava {0}, a prozor čini onoliko širokim koliko traže proporcije slike.</translation>
    </message>
    <message>
        <source>The window is {0} from {1} to {2}, {3} from {4} to {5}, the picture {6} by {7} pixels. How large is {8} in variant Y?</source>
        <translation>Prozor je {0} od {1} do {2}, {3} od {4} do {5}, a slika {6} puta {7} piksela. Koliko je {8} u varijanti Y?</translation>
    </message>
    <message>
        <source>Both ends get the same share, so each gets half of what is missing. Look at variant Y: the left end moves as far as the right one.</source>
        <translation>Oba kraja dobivaju isti dio, dakle svaki polovicu onoga što nedostaje. Pogledajte varijantu Y: lijevi se kraj pomiče koliko i desni.</translation>
    </message>
    <message>
        <source>How wide must the window be for a picture of {0} by {1}?</source>
        <translation>Koliko širok mora biti prozor za sliku od {0} puta {1}?</translation>
    </message>
    <message>
        <source>{0} wide; it is {1} wide now. Both ends get the same share.</source>
        <translation>Širok {0}; sada je širok {1}. Oba kraja dobivaju isti dio.</translation>
    </message>
    <message>
        <source>Practise: where does X put it?</source>
        <translation>Vježba: kamo ga stavlja X?</translation>
    </message>
    <message>
        <source>The picture is that of variant X: {0} as given, {1} adjusted. Its frame has the numbers of the pixels.</source>
        <translation>Slika je ona varijante X: {0} kako je zadan, {1} prilagođen. Njezin okvir ima brojeve piksela.</translation>
    </message>
    <message>
        <source>The given window is {0} from {1} to {2} and {3} from {4} to {5}. Mark where variant X puts the point with {6}, {7} of the near plane.</source>
        <translation>Zadani prozor je {0} od {1} do {2} i {3} od {4} do {5}. Označite kamo varijanta X stavlja točku bliske ravnine s {6}, {7}.</translation>
    </message>
    <message>
        <source>Variant X *keeps* x. Look at variant Y: it is the one that leaves y as it is, and your place belongs to its picture.</source>
        <translation>Varijanta X *zadržava* x. Pogledajte varijantu Y: ona ostavlja y kakav jest, a vaše mjesto pripada njezinoj slici.</translation>
    </message>
    <message>
        <source>Rows are counted from the top. Look at the numbers beside the frame: 0 is at the top, so a positive {0} lies in the upper half.</source>
        <translation>Retci se broje odozgo. Pogledajte brojeve uz okvir: 0 je na vrhu, pa pozitivan {0} leži u gornjoj polovici.</translation>
    </message>
    <message>
        <source>In variant X the window reaches from {0} to {1} in x. How far does it reach in y?</source>
        <translation>U varijanti X prozor po x seže od {0} do {1}. Koliko daleko seže po y?</translation>
    </message>
    <message>
        <source>Its height and width are as {0} to {1}, so {2}.</source>
        <translation>Visina i širina su mu u omjeru {0} prema {1}, pa je {2}.</translation>
    </message>
    <message>
        <source>{0}. From the middle, the place is {1} of half the width to the right, and {2} of half the height up.</source>
        <translation>{0}. Od sredine je mjesto {1} polovice širine udesno i {2} polovice visine prema gore.</translation>
    </message>
    <message>
        <source>Practise: X by hand</source>
        <translation>Vježba: X ručno</translation>
    </message>
    <message>
        <source>*Proportions*, in *More of the lens*, stay at stretch.</source>
        <translation>*Proporcije*, u *Više o objektivu*, ostaju na postavci rastegni.</translation>
    </message>
    <message>
        <source>The picture has {0} by 600 pixels. Give *Bottom* and *Top* the values {1} and {2} of variant X.</source>
        <translation>Slika ima {0} puta 600 piksela. Dajte polju *Donji rub* i polju *Gornji rub* vrijednosti {1} i {2} varijante X.</translation>
    </message>
    <message>
        <source>How high must a window be that is {0} wide, for {1} by 600 pixels?</source>
        <translation>Koliko visok mora biti prozor širine {0} za {1} puta 600 piksela?</translation>
    </message>
    <message>
        <source>{0} high; it is {1} high now. Both ends get the same share.</source>
        <translation>Visok {0}; sada je visok {1}. Oba kraja dobivaju isti dio.</translation>
    </message>
    <message>
        <source>{0} {1}. Half of it goes to each end: {2} and {3}.</source>
        <translation>{0} {1}. Polovica toga ide na svaki kraj: {2} i {3}.</translation>
    </message>
    <message>
        <source>Both ends get the same share, so each gets half of what is missing. Look at variant X: the F has its proportions again.</source>
        <translation>Oba kraja dobivaju isti dio, dakle svaki polovicu onoga što nedostaje. Pogledajte varijantu X: F opet ima svoje proporcije.</translation>
    </message>
    <message>
        <source>Variant X *keeps* x, and you have changed it. Look at variant Y: it adjusts x as you did.</source>
        <translation>Varijanta X *zadržava* x, a vi ste ga promijenili. Pogledajte varijantu Y: ona prilagođava x kao vi.</translation>
    </message>
</context>
<context>
    <name>l08-depth-not-affine</name>
    <message>
        <source>Why not Az + B for the depth?</source>
        <translation>Zašto dubina nije Az + B?</translation>
    </message>
    <message>
        <source>A straight segment in the cube</source>
        <translation>Ravna dužina u kocki</translation>
    </message>
    <message>
        <source>In space PQ is straight, and both ends are 6 units deep. {0} and {1} are divided by {2}. The depth could just be scaled and shifted, {3}, so that near comes to {4} and far to {5}. With both ends equally deep the segment is still straight in **NDC**: the deviation in the dock is 0 %. Now P will come nearer, to a depth of 2.</source>
        <translation>U prostoru je PQ ravna, a oba su kraja na dubini od 6 jedinica. {0} i {1} dijele se s {2}. Dubina bi se mogla samo skalirati i pomaknuti, {3}, tako da bliska ravnina dođe u {4}, a daleka u {5}. Dok su oba kraja jednako duboko, dužina je i u **NDC** ravna: odstupanje na bočnoj ploči je 0 %. Sada će P doći bliže, na dubinu 2.</translation>
    </message>
    <message>
        <source>What does {0} make of the straight segment PQ then?</source>
        <translation>Što {0} tada čini od ravne dužine PQ?</translation>
    </message>
    <message>
        <source>A straight segment: scaling and shifting bend nothing</source>
        <translation>Ravnu dužinu: skaliranje i pomicanje ništa ne savijaju</translation>
    </message>
    <message>
        <source>Az + B bends nothing</source>
        <translation>Az + B ništa ne savija</translation>
    </message>
    <message>
        <source>They bend nothing in space. But {0} and {1} are divided by {2} and the depth is not, so halfway between the images of P and Q the depth is not halfway. Look at the line {3}: it is bent.</source>
        <translation>U prostoru ne savijaju ništa. Ali {0} i {1} dijele se s {2}, a dubina ne, pa na pola puta između slika točaka P i Q dubina nije na polovici. Pogledajte liniju {3}: savijena je.</translation>
    </message>
    <message>
        <source>A bow</source>
        <translation>Luk</translation>
    </message>
    <message>
        <source>A straight segment, but from other ends</source>
        <translation>Ravnu dužinu, ali s drugim krajevima</translation>
    </message>
    <message>
        <source>The ends are right: near and far come to −1 and 1 either way. What changes lies between them. Look at the two lines: they have the same ends.</source>
        <translation>Krajevi su točni: bliska i daleka ravnina u oba slučaja dolaze u −1 i 1. Mijenja se ono što je između njih. Pogledajte dvije linije: imaju iste krajeve.</translation>
    </message>
    <message>
        <source>x and y are divided, but z is not. Along the image of PQ the depth does not grow evenly.</source>
        <translation>x i y se dijele, ali z ne. Duž slike dužine PQ dubina ne raste jednoliko.</translation>
    </message>
    <message>
        <source>The middle of the picture</source>
        <translation>Sredina slike</translation>
    </message>
    <message>
        <source>P is 2 deep, Q is 6 deep, {0}, {1}. Halfway between their images the depth is not 4. {2} changes evenly on the screen, so the depth there is {3}.</source>
        <translation>P je na dubini 2, Q na dubini 6, {0}, {1}. Na pola puta između njihovih slika dubina nije 4. {2} se na ekranu mijenja jednoliko, pa je dubina ondje {3}.</translation>
    </message>
    <message>
        <source>depth</source>
        <translation>dubina</translation>
    </message>
    <message>
        <source>middle of the ends</source>
        <translation>sredina krajeva</translation>
    </message>
    <message>
        <source>scaled and shifted</source>
        <translation>skalirano i pomaknuto</translation>
    </message>
    <message>
        <source>divided as well</source>
        <translation>i podijeljeno</translation>
    </message>
    <message>
        <source>In the first row, 3 does not come to the middle of the ends; in the second it does:</source>
        <translation>U prvom retku 3 ne dolazi u sredinu krajeva; u drugom dolazi:</translation>
    </message>
    <message>
        <source>with {0}, {1}.</source>
        <translation>uz {0}, {1}.</translation>
    </message>
    <message>
        <source>Bend it</source>
        <translation>Savijte je</translation>
    </message>
    <message>
        <source>Both ends are 6 deep again. Drag P and Q in **World**, or type them.</source>
        <translation>Oba kraja su opet na dubini 6. Povucite P i Q u oknu **Svijet** ili ih upišite.</translation>
    </message>
    <message>
        <source>Make the bow deviate by more than 5 % of its length.</source>
        <translation>Neka luk odstupa za više od 5 % svoje duljine.</translation>
    </message>
    <message>
        <source>If both ends are equally deep, nothing is bent.</source>
        <translation>Ako su oba kraja jednako duboko, ništa se ne savija.</translation>
    </message>
    <message>
        <source>Bring P nearer to the eye: larger z.</source>
        <translation>Dovedite P bliže kameri: veći z.</translation>
    </message>
    <message>
        <source>Right: the larger the ratio of the two depths, the more the segment is bent.</source>
        <translation>Točno: što je omjer dviju dubina veći, dužina se jače savija.</translation>
    </message>
    <message>
        <source>The depth of a point</source>
        <translation>Dubina točke</translation>
    </message>
    <message>
        <source>Now the planes are {0} and {1}, and a point is 4 units deep, {2}.</source>
        <translation>Sada su ravnine {0} i {1}, a točka je na dubini od 4 jedinice, {2}.</translation>
    </message>
    <message>
        <source>How large is {0} of the perspective projection?</source>
        <translation>Koliko je {0} perspektivne projekcije?</translation>
    </message>
    <message>
        <source>This spreads the depth evenly between the planes. But {0} changes with {1}, fast just behind near. Look at point 1, 4 deep, in the cube: it is beyond the middle.</source>
        <translation>Ovo dubinu raspoređuje jednoliko između ravnina. Ali {0} se mijenja s {1}, brzo odmah iza bliske ravnine. Pogledajte točku 1, na dubini 4, u kocki: iza sredine je.</translation>
    </message>
    <message>
        <source>This stops before the division by {0}. Look at point 1, 4 deep, in the cube: it is inside, so its {1} is less than 1.</source>
        <translation>Ovo staje prije dijeljenja s {0}. Pogledajte točku 1, na dubini 4, u kocki: unutra je, pa je njezin {1} manji od 1.</translation>
    </message>
    <message>
        <source>Az + B = 8/6. It is not yet divided.</source>
        <translation>Az + B = 8/6. To još nije podijeljeno.</translation>
    </message>
    <message>
        <source>The middle of the cube</source>
        <translation>Sredina kocke</translation>
    </message>
    <message>
        <source>The planes are the same: {0}, {1}.</source>
        <translation>Ravnine su iste: {0}, {1}.</translation>
    </message>
    <message>
        <source>How deep is the point with {0}?</source>
        <translation>Na kojoj je dubini točka s {0}?</translation>
    </message>
    <message>
        <source>This is the middle in the world. Look at point 1, 5 deep, in the cube: it is beyond the middle.</source>
        <translation>To je sredina u svijetu. Pogledajte točku 1, na dubini 5, u kocki: iza sredine je.</translation>
    </message>
    <message>
        <source>-A - B/z = 0</source>
        <translation>-A - B/z = 0</translation>
    </message>
    <message>
        <source>{0}, and its depth is {1}. The first half of the cube ends there.</source>
        <translation>{0}, a dubina je {1}. Ondje završava prva polovica kocke.</translation>
    </message>
    <message>
        <source>Place the middle</source>
        <translation>Smjestite sredinu</translation>
    </message>
    <message>
        <source>Probe 1 is 4 units deep; near is 1 and far is 9.</source>
        <translation>Sonda 1 je na dubini od 4 jedinice; bliska ravnina je na 1, daleka na 9.</translation>
    </message>
    <message>
        <source>Set near and far so that probe 1, at depth 4, comes to the middle of the cube: z&apos; = 0.</source>
        <translation>Postavite blisku i daleku ravninu tako da sonda 1, na dubini 4, dođe u sredinu kocke: z&apos; = 0.</translation>
    </message>
    <message>
        <source>Use 1/z: 1/4 must be halfway between 1/near and 1/far.</source>
        <translation>Uzmite 1/z: 1/4 mora biti na pola puta između 1/bliska i 1/daleka.</translation>
    </message>
    <message>
        <source>With far at 9, near must be 2.57; with near at 3, far must be 6.</source>
        <translation>S dalekom ravninom na 9 bliska mora biti na 2.57; s bliskom na 3 daleka mora biti na 6.</translation>
    </message>
    <message>
        <source>Right: 2nf/(n + f) = 4.</source>
        <translation>Točno: 2nf/(n + f) = 4.</translation>
    </message>
    <message>
        <source>Back to the prediction</source>
        <translation>Natrag na predviđanje</translation>
    </message>
    <message>
        <source>It is tempting to trust {0}, because in space it bends nothing. But after {1} and {2} are divided by {3}, equal steps along the picture are unequal steps of depth, and a straight line stays straight only if the depth is divided as well.</source>
        <translation>Primamljivo je vjerovati izrazu {0}, jer u prostoru ništa ne savija. Ali kad se {1} i {2} podijele s {3}, jednaki koraci po slici nejednaki su koraci dubine, i pravac ostaje pravac samo ako se podijeli i dubina.</translation>
    </message>
    <message>
        <source>Bent lines would spoil the depth buffer: between the corners of a triangle, depths are interpolated evenly over the pixels. The computed depth would not be the true one, and a surface behind could be drawn in front.</source>
        <translation>Savijene linije pokvarile bi spremnik dubine: između vrhova trokuta dubine se interpoliraju jednoliko po pikselima. Izračunata dubina ne bi bila prava, i ploha koja je iza mogla bi se nacrtati ispred.</translation>
    </message>
    <message>
        <source>Practise: the depth of a point</source>
        <translation>Vježba: dubina točke</translation>
    </message>
    <message>
        <source>The planes are at the depths {0} and {1}. In the cube they come to {2} and {3}.</source>
        <translation>Ravnine su na dubinama {0} i {1}. U kocki dolaze u {2} i {3}.</translation>
    </message>
    <message>
        <source>Here {0} and {1}. Point 1 is at {2}. How large is its {3}?</source>
        <translation>Ovdje je {0} i {1}. Točka 1 je na {2}. Koliki je njezin {3}?</translation>
    </message>
    <message>
        <source>This spreads the depth evenly between the planes. But {0} changes with {1}, fast just behind near. Look at point 1, moved to where {2}: it is closer to near than to far.</source>
        <translation>Ovo dubinu raspoređuje jednoliko između ravnina. Ali {0} se mijenja s {1}, brzo odmah iza bliske ravnine. Pogledajte točku 1, pomaknutu onamo gdje je {2}: bliža je bliskoj nego dalekoj ravnini.</translation>
    </message>
    <message>
        <source>This stops before the division by {0}. Look at point 1, moved to far: there {1} is {2}, and only the division makes it 1.</source>
        <translation>Ovo staje prije dijeljenja s {0}. Pogledajte točku 1, pomaknutu na daleku ravninu: ondje je {1} jednako {2}, i tek dijeljenje od toga čini 1.</translation>
    </message>
    <message>
        <source>{0}, with {1} and {2}.</source>
        <translation>{0}, uz {1} i {2}.</translation>
    </message>
    <message>
        <source>Practise: the middle of the cube</source>
        <translation>Vježba: sredina kocke</translation>
    </message>
    <message>
        <source>You see the segment PQ from the side. P is on the near plane, and Q on the far plane.</source>
        <translation>Dužinu PQ vidite sa strane. P je na bliskoj ravnini, a Q na dalekoj.</translation>
    </message>
    <message>
        <source>Near is {0} and far is {1}. Which point of PQ comes to {2} in the cube? Mark it.</source>
        <translation>Bliska ravnina je na {0}, daleka na {1}. Koja točka dužine PQ dolazi u {2} u kocki? Označite je.</translation>
    </message>
    <message>
        <source>This is the middle of PQ in the world. But {0} changes with {1}, fast just behind near. Look at point 1: it is the place that you marked, and the cube&apos;s middle lies before it.</source>
        <translation>To je sredina dužine PQ u svijetu. Ali {0} se mijenja s {1}, brzo odmah iza bliske ravnine. Pogledajte točku 1: to je mjesto koje ste označili, a sredina kocke leži ispred njega.</translation>
    </message>
    <message>
        <source>At which depth is {0}?</source>
        <translation>Na kojoj je dubini {0}?</translation>
    </message>
    <message>
        <source>At {0}, which is {1} deep.</source>
        <translation>Kod {0}, a to je na dubini {1}.</translation>
    </message>
    <message>
        <source>It is {0} deep.</source>
        <translation>Na dubini je {0}.</translation>
    </message>
    <message>
        <source>Practise: place the middle</source>
        <translation>Vježba: smjestite sredinu</translation>
    </message>
    <message>
        <source>**World** shows the planes and probe 1 from the side.</source>
        <translation>**Svijet** pokazuje ravnine i sondu 1 sa strane.</translation>
    </message>
    <message>
        <source>Probe 1 is {0} deep. Leave far at {1}, and set near so that the depth {2} comes to {3}.</source>
        <translation>Sonda 1 je na dubini {0}. Ostavite daleku ravninu na {1} i postavite blisku tako da dubina {2} dođe u {3}.</translation>
    </message>
    <message>
        <source>The middle of the cube is {0} deep.</source>
        <translation>Sredina kocke je na dubini {0}.</translation>
    </message>
    <message>
        <source>So {0} is halfway between {1} and {2}.</source>
        <translation>Zato je {0} na pola puta između {1} i {2}.</translation>
    </message>
    <message>
        <source>{0}, so {1} {2} {3}, more than half of {4}.</source>
        <translation>{0}, pa je {1} {2} {3}, više od polovice od {4}.</translation>
    </message>
    <message>
        <source>This puts the point half-way between the planes in the world. But {0} changes with {1}. Look at the planes: the cube&apos;s middle is nearer to near than the point is.</source>
        <translation>Ovo stavlja točku na pola puta između ravnina u svijetu. Ali {0} se mijenja s {1}. Pogledajte ravnine: sredina kocke bliža je bliskoj ravnini nego točka.</translation>
    </message>
</context>
<context>
    <name>l09-pyramid-to-cube</name>
    <message>
        <source>From the pyramid to the cube</source>
        <translation>Od piramide do kocke</translation>
    </message>
    <message>
        <source>Where does the near plane go?</source>
        <translation>Kamo ide bliska ravnina?</translation>
    </message>
    <message>
        <source>Every lens has a volume of its own. Lecture 001 brings them all into one pyramid first: {0} moves the far plane to {1} and the sides of the picture to {2}. Here {3} and {4}, and the strip under the large cube is at *View*.</source>
        <translation>Svaki objektiv ima vlastiti volumen. Predavanje 001 sve ih najprije dovodi u jednu piramidu: {0} pomiče daleku ravninu u {1}, a stranice slike u {2}. Ovdje je {3} i {4}, a traka ispod velike kocke je na postaji *Kamera*.</translation>
    </message>
    <message>
        <source>The strip goes on to *Pyramid*: the far plane moves from {0} to {1}. Where does the near plane go?</source>
        <translation>Traka ide dalje na *Piramida*: daleka ravnina pomiče se iz {0} u {1}. Kamo ide bliska ravnina?</translation>
    </message>
    <message>
        <source>It stays at z = −1</source>
        <translation>Ostaje na z = −1</translation>
    </message>
    <message>
        <source>{0} divides every depth by {1}, not only far&apos;s. Look at near: it is at −0.111, close to the eye.</source>
        <translation>{0} dijeli svaku dubinu s {1}, a ne samo dubinu daleke ravnine. Pogledajte blisku ravninu: na −0.111 je, blizu kamere.</translation>
    </message>
    <message>
        <source>At z = −0.111</source>
        <translation>Na z = −0.111</translation>
    </message>
    <message>
        <source>At z = 0, with the eye</source>
        <translation>Na z = 0, uz kameru</translation>
    </message>
    <message>
        <source>{0} is the eye. {1} only scales: a plane that is in front of the eye stays in front of it. Look at near and the eye: they are 0.111 apart.</source>
        <translation>{0} je kamera. {1} samo skalira: ravnina koja je ispred kamere ostaje ispred nje. Pogledajte blisku ravninu i kameru: razmaknute su 0.111.</translation>
    </message>
    <message>
        <source>{0} only scales. All depths are divided by {1}, so the near plane is at {2}, and the eye stays at 0.</source>
        <translation>{0} samo skalira. Sve se dubine dijele s {1}, pa je bliska ravnina na {2}, a kamera ostaje u 0.</translation>
    </message>
    <message>
        <source>The two factors</source>
        <translation>Dva faktora</translation>
    </message>
    <message>
        <source>*Matrices* shows the chain in the lecture&apos;s letters and highlights the matrix of the strip&apos;s stop. {0} divides z by {1}: here {2}.</source>
        <translation>*Matrice* pokazuju lanac slovima predavanja i ističu matricu postaje na kojoj je traka. {0} dijeli z s {1}: ovdje je {2}.</translation>
    </message>
    <message>
        <source>{0} turns the pyramid into a box. Its third row ends in {1} and {2}, here 1.125 and 0.125, and its last row gives {3}. Try it on both planes:</source>
        <translation>{0} pretvara piramidu u kvadar. Njezin treći redak završava s {1} i {2}, ovdje 1.125 i 0.125, a posljednji redak daje {3}. Isprobajte to na objema ravninama:</translation>
    </message>
    <message>
        <source>z</source>
        <translation>z</translation>
    </message>
    <message>
        <source>numerator</source>
        <translation>brojnik</translation>
    </message>
    <message>
        <source>w</source>
        <translation>w</translation>
    </message>
    <message>
        <source>z of the box</source>
        <translation>z kvadra</translation>
    </message>
    <message>
        <source>c</source>
        <translation>c</translation>
    </message>
    <message>
        <source>{0} takes 0 … −1 to OpenGL&apos;s −1 … 1: {1}. Click *Pyramid*, *Box* and *NDC* under the cube.</source>
        <translation>{0} prebacuje 0 … −1 u OpenGL-ov −1 … 1: {1}. Kliknite *Piramida*, *Kvadar* i *NDC* ispod kocke.</translation>
    </message>
    <message>
        <source>The product</source>
        <translation>Umnožak</translation>
    </message>
    <message>
        <source>Each stop of the strip is a place, and each factor leads from one to the next. A point {0} of view space goes through all of them: what it meets first stands on the right, next to it.</source>
        <translation>Svaka postaja trake je mjesto, a svaki faktor vodi s jednog mjesta na sljedeće. Točka {0} koordinatnog sustava kamere prolazi kroz sva: ono na što najprije naiđe stoji zdesna, do nje.</translation>
    </message>
    <message>
        <source>Which volume does each factor start from: the lens&apos;s own, the pyramid or the box?</source>
        <translation>Od kojeg volumena polazi svaki faktor: od vlastitog volumena objektiva, od piramide ili od kvadra?</translation>
    </message>
    <message>
        <source>{0} starts from the lens&apos;s own volume, {1} from the pyramid, and {2} from the box: {3}.</source>
        <translation>{0} polazi od vlastitog volumena objektiva, {1} od piramide, a {2} od kvadra: {3}.</translation>
    </message>
    <message>
        <source>Half-way through the box</source>
        <translation>Na pola puta kroz kvadar</translation>
    </message>
    <message>
        <source>Probe 1 is pinned to a point of the F, 7.5 in front of the eye. {0} in the box is {1} in NDC; the Probe panel shows it.</source>
        <translation>Sonda 1 prikvačena je za točku slova F, 7.5 ispred kamere. {0} u kvadru je {1} u NDC; pokazuje to ploča Sonda.</translation>
    </message>
    <message>
        <source>Bring point 1 to z = −1/2 of the box, by near and far, by the camera, or by the point itself.</source>
        <translation>Dovedite točku 1 u z = −1/2 kvadra, bliskom i dalekom ravninom, kamerom ili samom točkom.</translation>
    </message>
    <message>
        <source>With near = 6 the point is half-way between the planes in the world. Where is it in the box then?</source>
        <translation>S bliskom ravninom na 6 točka je u svijetu na pola puta između ravnina. Gdje je tada u kvadru?</translation>
    </message>
    <message>
        <source>{0} at the depth {1}, which is nearer to {2} than to {3}.</source>
        <translation>{0} na dubini {1}, koja je bliža {2} nego {3}.</translation>
    </message>
    <message>
        <source>The middle of the box is not the middle of the pyramid: the space close behind near fills half of the box.</source>
        <translation>Sredina kvadra nije sredina piramide: prostor odmah iza bliske ravnine ispunjava polovicu kvadra.</translation>
    </message>
    <message>
        <source>The cells of the chain</source>
        <translation>Ćelije lanca</translation>
    </message>
    <message>
        <source>Compute before you open *Matrices*. In this step {0} and {1}.</source>
        <translation>Računajte prije nego što otvorite *Matrice*. U ovom koraku je {0} i {1}.</translation>
    </message>
    <message>
        <source>What is in row 3, column 4 of {0}?</source>
        <translation>Što je u retku 3, stupcu 4 matrice {0}?</translation>
    </message>
    <message>
        <source>This takes {0}. On the way into the pyramid every depth is divided by {1}. Look at near: it is closer to the eye, at {2}.</source>
        <translation>Ovo uzima {0}. Na putu u piramidu svaka se dubina dijeli s {1}. Pogledajte blisku ravninu: bliža je kameri, na {2}.</translation>
    </message>
    <message>
        <source>This swaps {0} and {1}. Look at the box: near comes to 0 and far to {2}; swapped, they would change places.</source>
        <translation>Ovo zamjenjuje {0} i {1}. Pogledajte kvadar: bliska ravnina dolazi u 0, a daleka u {2}; zamijenjene, promijenile bi mjesta.</translation>
    </message>
    <message>
        <source>{0} with {1}.</source>
        <translation>{0} uz {1}.</translation>
    </message>
    <message>
        <source>{0}, here 0.5/8.5.</source>
        <translation>{0}, ovdje 0.5/8.5.</translation>
    </message>
    <message>
        <source>And in row 3, column 3 of the product {0}?</source>
        <translation>A u retku 3, stupcu 3 umnoška {0}?</translation>
    </message>
    <message>
        <source>{0} acts first, so it stands on the right. Look at the box that it makes: only then does {1} stretch its depth from 0 … −1 to −1 … 1.</source>
        <translation>{0} djeluje prva, pa stoji zdesna. Pogledajte kvadar koji ona daje: tek tada {1} rasteže njegovu dubinu s 0 … −1 na −1 … 1.</translation>
    </message>
    <message>
        <source>This swaps {0} and {1}. Look at the cube: near comes to {2} and far to 1; swapped, they would change places.</source>
        <translation>Ovo zamjenjuje {0} i {1}. Pogledajte kocku: bliska ravnina dolazi u {2}, a daleka u 1; zamijenjene, promijenile bi mjesta.</translation>
    </message>
    <message>
        <source>Third row of {0} times third column of {1}: {2} times one cell, and {3} times another.</source>
        <translation>Treći redak od {0} puta treći stupac od {1}: {2} puta jedna ćelija i {3} puta druga.</translation>
    </message>
    <message>
        <source>{0}. That is {1}, which other lectures derive in one step.</source>
        <translation>{0}. To je {1}, koji druga predavanja izvode u jednom koraku.</translation>
    </message>
    <message>
        <source>A near plane of your choice</source>
        <translation>Bliska ravnina po želji</translation>
    </message>
    <message>
        <source>The pyramid keeps its shape for every lens. Only {0} differs.</source>
        <translation>Piramida zadržava oblik za svaki objektiv. Razlikuje se samo {0}.</translation>
    </message>
    <message>
        <source>Set near or far so that the near plane is at z = −0.2 in the pyramid.</source>
        <translation>Postavite blisku ili daleku ravninu tako da bliska u piramidi bude na z = −0.2.</translation>
    </message>
    <message>
        <source>The title of the large pane shows {0}.</source>
        <translation>Naslov velikog okna pokazuje {0}.</translation>
    </message>
    <message>
        <source>In {0} only the quotient matters: 1.8 to 9 gives the same pyramid as 1 to 5.</source>
        <translation>U {0} je važan samo kvocijent: 1.8 prema 9 daje istu piramidu kao 1 prema 5.</translation>
    </message>
    <message>
        <source>Back to the prediction</source>
        <translation>Natrag na predviđanje</translation>
    </message>
    <message>
        <source>It is tempting to leave the near plane where it is, at {0}, because the step is about far. But a matrix that scales z moves every depth; if near stayed, it would lie on far. Only the quotient {1} of the two distances remains, and {2} is made of it. Let the strip run from *World* to *NDC* once more: in the pyramid the near plane is 0.111 from the eye, and in the end it is a whole face of the cube.</source>
        <translation>Primamljivo je ostaviti blisku ravninu gdje jest, na {0}, jer se korak tiče daleke. Ali matrica koja skalira z pomiče svaku dubinu; kad bi bliska ravnina ostala, ležala bi na dalekoj. Ostaje samo kvocijent {1} dviju udaljenosti, i od njega je načinjena {2}. Pustite traku da još jednom ide od postaje *Svijet* do *NDC*: u piramidi je bliska ravnina 0.111 od kamere, a na kraju je cijela strana kocke.</translation>
    </message>
    <message>
        <source>Practise: from the pyramid to the box</source>
        <translation>Vježba: od piramide do kvadra</translation>
    </message>
    <message>
        <source>{0} takes the pyramid, whose near plane is at {1} and whose far plane is at {2}, to a box from 0 to {3}.</source>
        <translation>{0} prebacuje piramidu, čija je bliska ravnina na {1}, a daleka na {2}, u kvadar od 0 do {3}.</translation>
    </message>
    <message>
        <source>The near plane is {0} in front of the eye, the far plane {1}. What is in row 3 of {2}?</source>
        <translation>Bliska ravnina je {0} ispred kamere, daleka {1}. Što je u retku 3 matrice {2}?</translation>
    </message>
    <message>
        <source>This takes {0}. On the way into the pyramid every depth is divided by {1}. Look at near: it is at {2}.</source>
        <translation>Ovo uzima {0}. Na putu u piramidu svaka se dubina dijeli s {1}. Pogledajte blisku ravninu: na {2} je.</translation>
    </message>
    <message>
        <source>The row ends in {0} and {1}.</source>
        <translation>Redak završava s {0} i {1}.</translation>
    </message>
    <message>
        <source>{0} and {1} with {2}: near comes to 0, and far to {3}.</source>
        <translation>{0} i {1} uz {2}: bliska ravnina dolazi u 0, a daleka u {3}.</translation>
    </message>
    <message>
        <source>Practise: from the pyramid to the cube</source>
        <translation>Vježba: od piramide do kocke</translation>
    </message>
    <message>
        <source>{0} takes the box, from 0 to {1}, to OpenGL&apos;s depths from {2} to {3}: {4}, and {5} stays. {6} comes first.</source>
        <translation>{0} prebacuje kvadar, od 0 do {1}, na OpenGL-ove dubine od {2} do {3}: {4}, a {5} ostaje. Prva djeluje {6}.</translation>
    </message>
    <message>
        <source>With {0} and {1}, what is in rows 3 and 4, columns 3 and 4 of the product {2}?</source>
        <translation>Uz {0} i {1}, što je u retcima 3 i 4, stupcima 3 i 4 umnoška {2}?</translation>
    </message>
    <message>
        <source>{0} acts first, so it stands on the right. Look at the box that it makes: only then does {1} stretch its depth.</source>
        <translation>{0} djeluje prva, pa stoji zdesna. Pogledajte kvadar koji ona daje: tek tada {1} rasteže njegovu dubinu.</translation>
    </message>
    <message>
        <source>In these rows and columns {0} is {1} above {2}.</source>
        <translation>U tim retcima i stupcima {0} je {1} iznad {2}.</translation>
    </message>
    <message>
        <source>{0} is {1} above {2} there.</source>
        <translation>{0} je ondje {1} iznad {2}.</translation>
    </message>
    <message>
        <source>Row 3 of {0} takes {1} times row 3 of {2} and {3} times its row 4.</source>
        <translation>Redak 3 od {0} uzima {1} puta redak 3 od {2} i {3} puta njezin redak 4.</translation>
    </message>
    <message>
        <source>Practise: choose the pyramid</source>
        <translation>Vježba: odaberite piramidu</translation>
    </message>
    <message>
        <source>In the canonical pyramid the far plane is at {0}. The lens decides where the near plane is.</source>
        <translation>U kanonskoj piramidi daleka ravnina je na {0}. Objektiv odlučuje gdje je bliska.</translation>
    </message>
    <message>
        <source>Set near or far so that the near plane is at {0} in the pyramid.</source>
        <translation>Postavite blisku ili daleku ravninu tako da bliska u piramidi bude na {0}.</translation>
    </message>
    <message>
        <source>All depths are divided by {0} on the way into the pyramid.</source>
        <translation>Na putu u piramidu sve se dubine dijele s {0}.</translation>
    </message>
    <message>
        <source>{0}: only the quotient of the two distances matters. If far stays at {1}, near is {2}.</source>
        <translation>{0}: važan je samo kvocijent dviju udaljenosti. Ako daleka ravnina ostaje na {1}, bliska je {2}.</translation>
    </message>
    <message>
        <source>This puts near {0} in front of the eye in the world. All depths are divided by {1} on the way into the pyramid. Look at near: it is far too close, at {2}/{3} in the pyramid.</source>
        <translation>Ovo stavlja blisku ravninu {0} ispred kamere u svijetu. Na putu u piramidu sve se dubine dijele s {1}. Pogledajte blisku ravninu: preblizu je, u piramidi na {2}/{3}.</translation>
    </message>
    <message>
        <source>Practise: build the product</source>
        <translation>Vježba: složite umnožak</translation>
    </message>
    <message>
        <source>Put the tiles in order, and leave out what does not belong.</source>
        <translation>Poredajte pločice i izostavite ono što ne pripada umnošku.</translation>
    </message>
    <message>
        <source>{0} and {1}. Which chain leads from view space to NDC?</source>
        <translation>{0} i {1}. Koji lanac vodi od koordinatnog sustava kamere do NDC?</translation>
    </message>
    <message>
        <source>The box has near at {0} and far at {1}. Another program wants near at {2} and far at {3}. Which chain is its {4}?</source>
        <translation>U kvadru je bliska ravnina na {0}, a daleka na {1}. Jednom drugom programu treba bliska na {2}, a daleka na {3}. Koji je lanac njegova {4}?</translation>
    </message>
    <message>
        <source>The eye is at {0}, {1} and {2}. Which chain takes a point of the world to NDC, up to the division?</source>
        <translation>Kamera je u {0}, {1} i {2}. Koji lanac točku svijeta prebacuje u NDC, sve do dijeljenja?</translation>
    </message>
    <message>
        <source>{0} takes the pyramid to the box. What makes the pyramid?</source>
        <translation>{0} prebacuje piramidu u kvadar. Što čini piramidu?</translation>
    </message>
    <message>
        <source>Which chain leads from *View* to *NDC*?</source>
        <translation>Koji lanac vodi od postaje *Kamera* do *NDC*?</translation>
    </message>
    <message>
        <source>{0} makes the pyramid, {1} turns it into the box, and {2} stretches its depths.</source>
        <translation>{0} čini piramidu, {1} je pretvara u kvadar, a {2} mu rasteže dubine.</translation>
    </message>
    <message>
        <source>Where does near, at 0, come to? The scale leaves it at 0.</source>
        <translation>Kamo dolazi bliska ravnina, koja je na 0? Skaliranje je ostavlja na 0.</translation>
    </message>
    <message>
        <source>Far is at {0}: the scale takes it to minus its factor.</source>
        <translation>Daleka ravnina je na {0}: skaliranje je prebacuje u minus svoj faktor.</translation>
    </message>
    <message>
        <source>{0}: the scale acts first, and the move takes near from 0 to {1}.</source>
        <translation>{0}: skaliranje djeluje prvo, a pomak prebacuje blisku ravninu s 0 na {1}.</translation>
    </message>
    <message>
        <source>The lens needs points in view space.</source>
        <translation>Objektivu trebaju točke u koordinatnom sustavu kamere.</translation>
    </message>
    <message>
        <source>The view matrix comes first, because the lens&apos;s matrices are made for view space.</source>
        <translation>Matrica pogleda dolazi prva, jer su matrice objektiva načinjene za koordinatni sustav kamere.</translation>
    </message>
</context>
<context>
    <name>l10-parallel-lens</name>
    <message>
        <source>What does depth do in a parallel lens?</source>
        <translation>Što čini dubina u paralelnom objektivu?</translation>
    </message>
    <message>
        <source>Twice as far away</source>
        <translation>Dvostruko dalje</translation>
    </message>
    <message>
        <source>Post 1 is 5 units in front of the eye, post 2 is 9.8, and both are equally high. With the perspective lens, post 2 is drawn about half as high (0.51 times): look at *Image*.</source>
        <translation>Stup 1 je 5 jedinica ispred kamere, stup 2 je 9.8, a oba su jednako visoka. Perspektivni objektiv stup 2 crta otprilike upola nižim (0.51 puta): pogledajte okno *Slika*.</translation>
    </message>
    <message>
        <source>The lens becomes orthographic; camera and posts stay. How many times as high as post 1 is post 2 drawn now?</source>
        <translation>Objektiv postaje ortogonalni; kamera i stupovi ostaju. Kolika je sada nacrtana visina stupa 2 podijeljena visinom stupa 1?</translation>
    </message>
    <message>
        <source>1 times: both are equally high</source>
        <translation>1 puta: oba su jednako visoka</translation>
    </message>
    <message>
        <source>0.51 times, as before</source>
        <translation>0.51 puta, kao prije</translation>
    </message>
    <message>
        <source>This divides by the depth, as the perspective lens does. The projectors of a parallel lens do not meet, so its pictures are not divided by anything: equal heights stay equal at every depth. Look at the two posts: they are equally high.</source>
        <translation>Ovo dijeli s dubinom, kao perspektivni objektiv. Zrake projiciranja paralelnog objektiva se ne sijeku, pa se njegove slike ničim ne dijele: jednake visine ostaju jednake na svakoj dubini. Pogledajte dva stupa: jednako su visoki.</translation>
    </message>
    <message>
        <source>More than half, but not as high</source>
        <translation>Više od polovice, ali ne jednako visok</translation>
    </message>
    <message>
        <source>There is nothing in between: the lens either divides by the depth, or not. The orthographic one does not. Look at the two posts: they are equally high.</source>
        <translation>Ničega između nema: objektiv ili dijeli s dubinom ili ne. Ortogonalni ne dijeli. Pogledajte dva stupa: jednako su visoki.</translation>
    </message>
    <message>
        <source>The projectors are parallel: nothing is divided by the depth, and the heights in the picture are those of the world.</source>
        <translation>Zrake projiciranja su paralelne: ništa se ne dijeli s dubinom, i visine na slici su one iz svijeta.</translation>
    </message>
    <message>
        <source>The box becomes the cube</source>
        <translation>Kvadar postaje kocka</translation>
    </message>
    <message>
        <source>A parallel lens has a box, from {0} to {1}, {2} to {3} and {4} to {5}. Each range is moved to the middle and scaled to length 2:</source>
        <translation>Paralelni objektiv ima kvadar, od {0} do {1}, od {2} do {3} i od {4} do {5}. Svaki se interval pomiče u sredinu i skalira na duljinu 2:</translation>
    </message>
    <message>
        <source>Point 1 is at {0} in view space. With {1}, {2} it has {3}; its depth of 5 affects only {4}. The Probe panel shows every step: the division is by 1.</source>
        <translation>Točka 1 je u {0} u koordinatnom sustavu kamere. Uz {1}, {2} ima {3}; njezina dubina od 5 utječe samo na {4}. Ploča Sonda pokazuje svaki korak: dijeli se s 1.</translation>
    </message>
    <message>
        <source>The same height, by another lens</source>
        <translation>Ista visina, drugim objektivom</translation>
    </message>
    <message>
        <source>The lens is perspective again, and point 1 is at {0} in view space: its {1} is less than {2}.</source>
        <translation>Objektiv je opet perspektivni, a točka 1 je u {0} u koordinatnom sustavu kamere: njezin {1} manji je od {2}.</translation>
    </message>
    <message>
        <source>Bring point 1 to {0} with an orthographic lens.</source>
        <translation>Dovedite točku 1 u {0} ortogonalnim objektivom.</translation>
    </message>
    <message>
        <source>Choose *orthographic* for the lens, then set bottom and top.</source>
        <translation>Za objektiv odaberite *ortogonalni*, zatim postavite donji i gornji rub.</translation>
    </message>
    <message>
        <source>Move the camera back and forth. What happens to {0}?</source>
        <translation>Pomičite kameru naprijed i natrag. Što se događa s {0}?</translation>
    </message>
    <message>
        <source>Only the height of the window matters. The distance of the point does not.</source>
        <translation>Važna je samo visina prozora. Udaljenost točke nije.</translation>
    </message>
    <message>
        <source>Cells and coordinates</source>
        <translation>Ćelije i koordinate</translation>
    </message>
    <message>
        <source>This box is not in the middle: {0}, {1}, {2}, {3}, from 1 to 9. The window is stretched to the picture.</source>
        <translation>Ovaj kvadar nije u sredini: {0}, {1}, {2}, {3}, od 1 do 9. Prozor je rastegnut na sliku.</translation>
    </message>
    <message>
        <source>What is in row 1, column 4 of clip ← view?</source>
        <translation>Što je u retku 1, stupcu 4 matrice odsijecanje ← kamera?</translation>
    </message>
    <message>
        <source>This moves the middle of the box farther out. The cell is added to {0}; it must take the middle, {1}, to {2}. Look from above: the middle of the box is to the right of the eye&apos;s axis.</source>
        <translation>Ovo pomiče sredinu kvadra još dalje. Ćelija se pribraja izrazu {0}; mora sredinu, {1}, prebaciti u {2}. Pogledajte odozgo: sredina kvadra je desno od osi kamere.</translation>
    </message>
    <message>
        <source>This is row 4, column 1. Row 1 computes {0} from x, y, z and 1; its last cell is what is added. Look from above: the box reaches farther to the right, so something must be added to {1}.</source>
        <translation>Ovo je redak 4, stupac 1. Redak 1 računa {0} iz x, y, z i 1; njegova je posljednja ćelija ono što se pribraja. Pogledajte odozgo: kvadar seže dalje udesno, pa se {1} nešto mora pribrojiti.</translation>
    </message>
    <message>
        <source>The middle of the box, {0}, must come to {1}.</source>
        <translation>Sredina kvadra, {0}, mora doći u {1}.</translation>
    </message>
    <message>
        <source>{0}: the middle of the box is right of the axis, so it is moved to the left.</source>
        <translation>{0}: sredina kvadra je desno od osi, pa se pomiče ulijevo.</translation>
    </message>
    <message>
        <source>What is {0} of the point (1, 1, −5) in view space?</source>
        <translation>Koliki je {0} točke (1, 1, −5) u koordinatnom sustavu kamere?</translation>
    </message>
    <message>
        <source>This divides by the depth of 5. The projectors of a parallel lens do not meet: {0} does not contain z. Look at points 1 and 2, 5 and 8 deep: they are equally high in the picture.</source>
        <translation>Ovo dijeli s dubinom 5. Zrake projiciranja paralelnog objektiva se ne sijeku: {0} ne sadrži z. Pogledajte točke 1 i 2, na dubinama 5 i 8: na slici su jednako visoko.</translation>
    </message>
    <message>
        <source>{0}, and {1}: there is nothing to divide by.</source>
        <translation>{0}, a {1}: nema se čime dijeliti.</translation>
    </message>
    <message>
        <source>Back to the prediction</source>
        <translation>Natrag na predviđanje</translation>
    </message>
    <message>
        <source>Far things look small to an eye, and to every lens whose projectors meet in a point. It is tempting to take this for a law of pictures. In a box the projectors never meet: the last row of the matrix is 0, 0, 0, 1, so {0} at every depth, and x and y do not depend on z. The depth is not lost: {1} keeps it and decides what hides what. That is why the posts are drawn equally high, side by side.</source>
        <translation>Daleke stvari izgledaju male oku i svakom objektivu čije se zrake projiciranja sijeku u točki. Primamljivo je to uzeti kao zakon slika. U kvadru se zrake projiciranja nikad ne sijeku: posljednji redak matrice je 0, 0, 0, 1, pa je {0} na svakoj dubini, a x i y ne ovise o z. Dubina nije izgubljena: {1} je čuva i odlučuje što će što sakriti. Zato su stupovi nacrtani jednako visoki, jedan uz drugi.</translation>
    </message>
    <message>
        <source>Practise: the first row</source>
        <translation>Vježba: prvi redak</translation>
    </message>
    <message>
        <source>A parallel lens takes its box, from {0} to {1} in x, to {2} from {3} to {4}.</source>
        <translation>Paralelni objektiv prebacuje svoj kvadar, po x od {0} do {1}, na {2} od {3} do {4}.</translation>
    </message>
    <message>
        <source>The box reaches from {0} to {1}. What is in row 1 of clip ← view?</source>
        <translation>Kvadar seže od {0} do {1}. Što je u retku 1 matrice odsijecanje ← kamera?</translation>
    </message>
    <message>
        <source>This moves the middle of the box farther out. The row&apos;s last cell is added to {0}, so it must be {1}: then the middle, {2}, comes to {3}. Look from above: the middle of the box is not on the eye&apos;s axis.</source>
        <translation>Ovo pomiče sredinu kvadra još dalje. Posljednja ćelija retka pribraja se izrazu {0}, pa mora biti {1}: tada sredina, {2}, dolazi u {3}. Pogledajte odozgo: sredina kvadra nije na osi kamere.</translation>
    </message>
    <message>
        <source>This is column 1. Row 1 computes {0} from x, y, z and 1, so what is added to x stands in its last cell. Look from above: the box reaches farther to one side, so something must be added to {1}.</source>
        <translation>Ovo je stupac 1. Redak 1 računa {0} iz x, y, z i 1, pa ono što se pribraja x stoji u njegovoj posljednjoj ćeliji. Pogledajte odozgo: kvadar seže dalje na jednu stranu, pa se {1} nešto mora pribrojiti.</translation>
    </message>
    <message>
        <source>{0} is {1} plus a number that brings the middle of the box to 0.</source>
        <translation>{0} je {1} plus broj koji sredinu kvadra dovodi u 0.</translation>
    </message>
    <message>
        <source>The middle of the box, {0}, comes to {1}, and its width {2} to 2.</source>
        <translation>Sredina kvadra, {0}, dolazi u {1}, a njegova širina {2} u 2.</translation>
    </message>
    <message>
        <source>Practise: a point in a parallel lens</source>
        <translation>Vježba: točka u paralelnom objektivu</translation>
    </message>
    <message>
        <source>A parallel lens has a box from {0} to {1} in y.</source>
        <translation>Paralelni objektiv ima kvadar po y od {0} do {1}.</translation>
    </message>
    <message>
        <source>The box reaches from {0} to {1}. Point 1 is at {2} in view space, {3} in front of the eye. What is its {4}?</source>
        <translation>Kvadar seže od {0} do {1}. Točka 1 je u {2} u koordinatnom sustavu kamere, {3} ispred kamere. Koliki je njezin {4}?</translation>
    </message>
    <message>
        <source>This divides by the depth of {0}. The projectors of a parallel lens do not meet: {1} does not contain z. Look at points 1 and 2: they have the same {2} at two depths, and the same {3}.</source>
        <translation>Ovo dijeli s dubinom {0}. Zrake projiciranja paralelnog objektiva se ne sijeku: {1} ne sadrži z. Pogledajte točke 1 i 2: imaju isti {2} na dvjema dubinama, i isti {3}.</translation>
    </message>
    <message>
        <source>The middle moves out</source>
        <translation>Sredina se odmiče</translation>
    </message>
    <message>
        <source>This moves the middle of the box farther out instead of to 0: from {0} the lens subtracts {1}. Look at point 2, at {2}: it is in the middle of the picture, where {3}.</source>
        <translation>Ovo sredinu kvadra pomiče još dalje umjesto u 0: od {0} objektiv oduzima {1}. Pogledajte točku 2, u {2}: u sredini je slike, gdje je {3}.</translation>
    </message>
    <message>
        <source>{0} comes to {1} and {2} to {3}. What does the depth change?</source>
        <translation>{0} dolazi u {1}, a {2} u {3}. Što mijenja dubina?</translation>
    </message>
    <message>
        <source>The depth of {0} does not matter: the division is by {1}.</source>
        <translation>Dubina {0} nije važna: dijeli se s {1}.</translation>
    </message>
    <message>
        <source>Practise: a height in the picture</source>
        <translation>Vježba: visina na slici</translation>
    </message>
    <message>
        <source>Point 1 is seen by a parallel lens. Its box reaches from {0} to {1} in y.</source>
        <translation>Točku 1 gleda paralelni objektiv. Njegov kvadar po y seže od {0} do {1}.</translation>
    </message>
    <message>
        <source>Point 1 is at {0} in view space, {1} in front of the eye. Keep the lens parallel and bring the point to {2}.</source>
        <translation>Točka 1 je u {0} u koordinatnom sustavu kamere, {1} ispred kamere. Neka objektiv ostane paralelni i dovedite točku u {2}.</translation>
    </message>
    <message>
        <source>With {0}, {1}.</source>
        <translation>Uz {0} je {1}.</translation>
    </message>
    <message>
        <source>{0} {1}, and {2}. The depth of {3} has no part in it.</source>
        <translation>{0} {1}, i {2}. Dubina {3} u tome ne sudjeluje.</translation>
    </message>
    <message>
        <source>A parallel lens divides by nothing but the half height of its box. Look at a box with {0}, twice as high as the point: there the point is at {1}, whatever its depth.</source>
        <translation>Paralelni objektiv ne dijeli ničim osim polovicom visine svojega kvadra. Pogledajte kvadar s {0}, dvostruko viši od točke: ondje je točka u {1}, bez obzira na dubinu.</translation>
    </message>
</context>
<context>
    <name>l11-oblique-drawing</name>
    <message>
        <source>Where receding edges go</source>
        <translation>Kamo idu bridovi koji idu u dubinu</translation>
    </message>
    <message>
        <source>Half the scale</source>
        <translation>Upola manje mjerilo</translation>
    </message>
    <message>
        <source>The front of this body is parallel to the picture, so it keeps its shape. If the projectors slant, edges along n are drawn too. A cavalier drawing shows them at full length; its projectors meet the picture at 45°. A cabinet drawing shows them half as long.</source>
        <translation>Prednja strana ovog tijela paralelna je sa slikom, pa zadržava oblik. Ako zrake projiciranja padaju koso, crtaju se i bridovi duž n. Kavalirski crtež pokazuje ih u punoj duljini; njegove zrake projiciranja sijeku sliku pod 45°. Kabinetski crtež pokazuje ih upola kraćima.</translation>
    </message>
    <message>
        <source>At which angle do the projectors of a cabinet drawing meet the picture?</source>
        <translation>Pod kojim kutom zrake projiciranja kabinetskog crteža sijeku sliku?</translation>
    </message>
    <message>
        <source>67.5°: half the scale is half the slant</source>
        <translation>67.5°: pola mjerila je pola nagiba</translation>
    </message>
    <message>
        <source>This assumes that the angle is proportional to the scale. One unit of depth and half a unit along the picture are the legs of a right triangle: the angle between projector and picture has the tangent 2, and is 63.4°. Look from above at the lines to the near plane: they go 2 deep for 1 to the side.</source>
        <translation>Ovo pretpostavlja da je kut proporcionalan mjerilu. Jedna jedinica dubine i pola jedinice po slici katete su pravokutnog trokuta: kut između zrake projiciranja i slike ima tangens 2, i iznosi 63.4°. Pogledajte odozgo linije do bliske ravnine: idu 2 u dubinu na 1 u stranu.</translation>
    </message>
    <message>
        <source>45°, as in every oblique drawing</source>
        <translation>45°, kao na svakom kosom crtežu</translation>
    </message>
    <message>
        <source>At 45° a projector goes as far along the picture as into the depth, so edges along n are drawn at full length. That is the cavalier drawing. Look from above at its lines to the near plane: they go 1 deep for 1 to the side.</source>
        <translation>Pod 45° zraka projiciranja ide po slici koliko i u dubinu, pa se bridovi duž n crtaju u punoj duljini. To je kavalirski crtež. Pogledajte odozgo njegove linije do bliske ravnine: idu 1 u dubinu na 1 u stranu.</translation>
    </message>
    <message>
        <source>A projector that goes 1 unit deep moves by the scale {0} along the picture: {1}, and {2} is the angle with {3}.</source>
        <translation>Zraka projiciranja koja ide 1 jedinicu u dubinu pomiče se po slici za mjerilo {0}: {1}, a {2} je kut s {3}.</translation>
    </message>
    <message>
        <source>The matrix H</source>
        <translation>Matrica H</translation>
    </message>
    <message>
        <source>A projector that meets the near plane at {0} (seen from above) and {1} (from the side) moves a point by</source>
        <translation>Zraka projiciranja koja siječe blisku ravninu pod {0} (gledano odozgo) i pod {1} (sa strane) pomiče točku za</translation>
    </message>
    <message>
        <source>That is a shear: the matrix {0}, which leaves the near plane as it is. Here {1}, {2} and {3}: one unit behind the near plane {4}, and x moves by {5}. *Matrices* shows it as *sheared ← view*. After {6} the slanted box is straight, so {7}; the three matrices stand side by side.</source>
        <translation>To je smicanje: matrica {0}, koja ostavlja blisku ravninu kakva jest. Ovdje je {1}, {2} i {3}: jednu jedinicu iza bliske ravnine je {4}, a x se pomiče za {5}. *Matrice* je pokazuju kao *smicanje ← kamera*. Nakon {6} kosi kvadar je uspravan, pa je {7}; tri matrice stoje jedna uz drugu.</translation>
    </message>
    <message>
        <source>Make it a cabinet drawing</source>
        <translation>Pretvorite ga u kabinetski crtež</translation>
    </message>
    <message>
        <source>The scale of receding edges is {0}; their direction in the picture is free.</source>
        <translation>Mjerilo bridova koji idu u dubinu je {0}; njihov smjer na slici je slobodan.</translation>
    </message>
    <message>
        <source>Set the lens so that {0}, in any direction.</source>
        <translation>Postavite objektiv tako da bude {0}, u bilo kojem smjeru.</translation>
    </message>
    <message>
        <source>The numbers below the scene&apos;s controls give the drawn scale.</source>
        <translation>Brojevi ispod kontrola scene daju nacrtano mjerilo.</translation>
    </message>
    <message>
        <source>The scale is 1/2 then.</source>
        <translation>Mjerilo je tada 1/2.</translation>
    </message>
    <message>
        <source>A unit of depth is drawn half as long, in whatever direction it recedes.</source>
        <translation>Jedinica dubine crta se upola kraća, u kojem god smjeru išla.</translation>
    </message>
    <message>
        <source>How far H moves</source>
        <translation>Koliko H pomiče</translation>
    </message>
    <message>
        <source>The letter F with an oblique lens: {0}, {1}, and the near plane is 2 in front of the eye, so {2}.</source>
        <translation>Slovo F s kosim objektivom: {0}, {1}, a bliska ravnina je 2 ispred kamere, pa je {2}.</translation>
    </message>
    <message>
        <source>What is in row 1, column 4 of H, {0}?</source>
        <translation>Što je u retku 1, stupcu 4 matrice H, {0}?</translation>
    </message>
    <message>
        <source>This takes {0} for the slant. At {1} the projectors are straight and shift nothing, so the slant is {2}. Look from above at {3}: the box is almost straight, {4}.</source>
        <translation>Ovo uzima {0} kao nagib. Kod {1} zrake projiciranja su okomite i ništa ne pomiču, pa je nagib {2}. Pogledajte odozgo {3}: kvadar je gotovo uspravan, {4}.</translation>
    </message>
    <message>
        <source>The near plane is at z = 2</source>
        <translation>Bliska ravnina je na z = 2</translation>
    </message>
    <message>
        <source>{0} is {1}, so {2} is positive. With this cell, points of the near plane would move. Look from above: the box slants away from near, and near stays where it is.</source>
        <translation>{0} je {1}, pa je {2} pozitivno. S tom ćelijom pomicale bi se točke bliske ravnine. Pogledajte odozgo: kvadar se naginje od bliske ravnine, a bliska ravnina ostaje gdje jest.</translation>
    </message>
    <message>
        <source>{0} itself is negative here.</source>
        <translation>{0} je ovdje i sam negativan.</translation>
    </message>
    <message>
        <source>{0}. With {1} it is 0: the projectors are straight then.</source>
        <translation>{0}. Uz {1} to je 0: zrake projiciranja tada su okomite.</translation>
    </message>
    <message>
        <source>By how much does H change x of a point 3 units behind the near plane?</source>
        <translation>Za koliko H mijenja x točke 3 jedinice iza bliske ravnine?</translation>
    </message>
    <message>
        <source>What recedes goes to the right</source>
        <translation>Što ide u dubinu, ide udesno</translation>
    </message>
    <message>
        <source>The size is right. Behind the near plane {0} is positive, and the formula subtracts it: x becomes smaller. Look from above at the sides of the box: they lean to the right, and H moves them back to the left.</source>
        <translation>Veličina je točna. Iza bliske ravnine {0} je pozitivan, a formula ga oduzima: x postaje manji. Pogledajte odozgo strane kvadra: nagnute su udesno, i H ih pomiče natrag ulijevo.</translation>
    </message>
    <message>
        <source>{0} with {1}.</source>
        <translation>{0} uz {1}.</translation>
    </message>
    <message>
        <source>{0}: receding points move to the left.</source>
        <translation>{0}: točke u dubini pomiču se ulijevo.</translation>
    </message>
    <message>
        <source>Projectors at 70°</source>
        <translation>Zrake projiciranja pod 70°</translation>
    </message>
    <message>
        <source>Between the cabinet drawing and the orthographic one the projectors are even steeper.</source>
        <translation>Između kabinetskog crteža i ortogonalnog zrake projiciranja još su strmije.</translation>
    </message>
    <message>
        <source>Draw with projectors that meet the picture at 70°, within 1 %.</source>
        <translation>Nacrtajte zrakama projiciranja koje sijeku sliku pod 70°, s točnošću od 1 %.</translation>
    </message>
    <message>
        <source>Which scale belongs to this angle? It is {0}.</source>
        <translation>Koje mjerilo pripada tom kutu? To je {0}.</translation>
    </message>
    <message>
        <source>The scale is 0.364 there.</source>
        <translation>Mjerilo je ondje 0.364.</translation>
    </message>
    <message>
        <source>Back to the prediction</source>
        <translation>Natrag na predviđanje</translation>
    </message>
    <message>
        <source>Scale 0 belongs to 90°, scale 1 to 45°, so it is tempting to take the middle, 67.5°, for scale 1/2. But the angle does not change evenly with the scale. One unit of depth and {0} units along the picture are the legs of a right triangle, and {1}: for 1/2 that is 63.4°. Look at *World* from above, with the lines from the corners of the body to the near plane.</source>
        <translation>Mjerilo 0 pripada kutu 90°, mjerilo 1 kutu 45°, pa je primamljivo za mjerilo 1/2 uzeti sredinu, 67.5°. Ali kut se ne mijenja jednoliko s mjerilom. Jedna jedinica dubine i {0} jedinica po slici katete su pravokutnog trokuta, i {1}: za 1/2 to je 63.4°. Pogledajte *Svijet* odozgo, s linijama od vrhova tijela do bliske ravnine.</translation>
    </message>
    <message>
        <source>Practise: the first row of H</source>
        <translation>Vježba: prvi redak matrice H</translation>
    </message>
    <message>
        <source>{0} takes x along the projectors to the near plane, which is at {1}. {2} is its matrix.</source>
        <translation>{0} pomiče x duž zraka projiciranja do bliske ravnine, koja je na {1}. {2} je njegova matrica.</translation>
    </message>
    <message>
        <source>The projectors will slant, with {0}. The near plane is {1} in front of the eye: {2}. What is in row 1 of {3}?</source>
        <translation>Zrake projiciranja padat će koso, uz {0}. Bliska ravnina je {1} ispred kamere: {2}. Što je u retku 1 matrice {3}?</translation>
    </message>
    <message>
        <source>The near plane is at a positive z</source>
        <translation>Bliska ravnina je na pozitivnom z</translation>
    </message>
    <message>
        <source>The last cell is {0}, and {1} is negative itself. With this row, points of the near plane would move. Look from above: the box slants away from near, and near stays where it is.</source>
        <translation>Posljednja ćelija je {0}, a {1} je i sam negativan. S tim retkom pomicale bi se točke bliske ravnine. Pogledajte odozgo: kvadar se naginje od bliske ravnine, a bliska ravnina ostaje gdje jest.</translation>
    </message>
    <message>
        <source>Multiply out: how often is z in {0}, and what is left without x and z?</source>
        <translation>Izmnožite: koliko puta je z u {0} i što ostaje bez x i z?</translation>
    </message>
    <message>
        <source>{0}: points of the near plane stay where they are.</source>
        <translation>{0}: točke bliske ravnine ostaju gdje jesu.</translation>
    </message>
    <message>
        <source>Practise: a far corner</source>
        <translation>Vježba: daleki vrh</translation>
    </message>
    <message>
        <source>Points that are {0} behind the front of the cube move by {1} in x and by {2} in y. The front stays.</source>
        <translation>Točke koje su {0} iza prednje strane kocke pomiču se za {1} po x i za {2} po y. Prednja strana ostaje.</translation>
    </message>
    <message>
        <source>The picture shows a cube, 1 unit wide, from straight in front. With {0} and {1}, where will the corner of its back be drawn that is at {2}, {3} from the middle?</source>
        <translation>Slika pokazuje kocku, široku 1 jedinicu, točno sprijeda. Gdje će uz {0} i {1} biti nacrtan vrh njezine stražnje strane koji je u {2}, {3} od sredine?</translation>
    </message>
    <message>
        <source>This moves the corner by {0} and {1}. At 90° the projectors are straight and move nothing, so it is {2} and {3}. Look at the cube with 80° and 80°: its back has moved very little.</source>
        <translation>Ovo pomiče vrh za {0} i {1}. Pod 90° zrake projiciranja su okomite i ništa ne pomiču, pa je to {2} i {3}. Pogledajte kocku s 80° i 80°: stražnja se strana jedva pomaknula.</translation>
    </message>
    <message>
        <source>What recedes goes to the right and up</source>
        <translation>Što ide u dubinu, ide udesno i gore</translation>
    </message>
    <message>
        <source>This moves the corner the opposite way. An angle below 90° moves what is behind the front to the left, or down; one above 90° to the right, or up. Look at the cube with 60° and 60°: its back has moved to the left and down.</source>
        <translation>Ovo pomiče vrh na suprotnu stranu. Kut manji od 90° pomiče ono što je iza prednje strane ulijevo ili dolje; kut veći od 90° udesno ili gore. Pogledajte kocku s 60° i 60°: stražnja se strana pomaknula ulijevo i dolje.</translation>
    </message>
    <message>
        <source>What recedes goes up</source>
        <translation>Što ide u dubinu, ide gore</translation>
    </message>
    <message>
        <source>x is right. But y was moved the opposite way: {0} below 90° moves the back down, above 90° up. Look at the cube with 60° and 60°: its back has moved to the left and down.</source>
        <translation>x je točan. Ali y je pomaknut na suprotnu stranu: {0} manji od 90° pomiče stražnju stranu dolje, veći od 90° gore. Pogledajte kocku s 60° i 60°: stražnja se strana pomaknula ulijevo i dolje.</translation>
    </message>
    <message>
        <source>Which way is {0} here, and how many widths of the cube is it?</source>
        <translation>Na koju je stranu ovdje {0} i koliko je to širina kocke?</translation>
    </message>
    <message>
        <source>The edges that lead to the back are all drawn alike, {0} to the right and {1} up. The picture is 8 units wide and 4.5 high.</source>
        <translation>Svi bridovi koji vode do stražnje strane crtaju se jednako, {0} udesno i {1} gore. Slika je široka 8 jedinica i visoka 4.5.</translation>
    </message>
    <message>
        <source>Practise: an angle of your choice</source>
        <translation>Vježba: kut po želji</translation>
    </message>
    <message>
        <source>The projectors of this drawing meet the picture at the angle {0}. Edges that recede are drawn {1} times as long as they are.</source>
        <translation>Zrake projiciranja ovog crteža sijeku sliku pod kutom {0}. Nacrtana duljina bridova koji idu u dubinu iznosi {1} njihove prave duljine.</translation>
    </message>
    <message>
        <source>Make {0}, to within 1 %. The direction of the receding edges is free.</source>
        <translation>Neka bude {0}, s točnošću od 1 %. Smjer bridova koji idu u dubinu je slobodan.</translation>
    </message>
    <message>
        <source>Choose *Free scale*. Which scale belongs to this angle?</source>
        <translation>Odaberite *Slobodno mjerilo*. Koje mjerilo pripada tom kutu?</translation>
    </message>
    <message>
        <source>A projector goes {0} along the picture for 1 unit of depth. Draw the right triangle with the angle {1}.</source>
        <translation>Zraka projiciranja ide {0} po slici na 1 jedinicu dubine. Nacrtajte pravokutni trokut s kutom {1}.</translation>
    </message>
    <message>
        <source>The angle is not proportional to the scale: {0}. Look from above at the lines to the near plane: they are flatter than {1}°.</source>
        <translation>Kut nije proporcionalan mjerilu: {0}. Pogledajte odozgo linije do bliske ravnine: položitije su od {1}°.</translation>
    </message>
    <message>
        <source>The scale is the cotangent of the angle. Look from above at the lines to the near plane: they meet it at {0}°.</source>
        <translation>Mjerilo je kotangens kuta. Pogledajte odozgo linije do bliske ravnine: sijeku je pod {0}°.</translation>
    </message>
</context>
<context>
    <name>l12-vanishing-points</name>
    <message>
        <source>How many vanishing points?</source>
        <translation>Koliko nedogleda?</translation>
    </message>
    <message>
        <source>A box, turned</source>
        <translation>Kvadar, okrenut</translation>
    </message>
    <message>
        <source>A box has edges in three directions. With the camera straight in front of it, the edges that lead away from you meet in one point of the picture, {0}. This is a 1-point perspective.</source>
        <translation>Kvadar ima bridove u tri smjera. Kad je kamera točno pred njim, bridovi koji vode od vas sijeku se u jednoj točki slike, {0}. To je perspektiva s 1 nedogledom.</translation>
    </message>
    <message>
        <source>The camera stays level and goes round the box by 30°. How many vanishing points do the box&apos;s edges have now?</source>
        <translation>Kamera ostaje horizontalna i obilazi kvadar za 30°. Koliko nedogleda sada imaju bridovi kvadra?</translation>
    </message>
    <message>
        <source>Still one</source>
        <translation>I dalje jedan</translation>
    </message>
    <message>
        <source>One belongs to a camera that looks straight at a side of the box. Turned by 30°, it sees two directions of level edges lead away. Look at the horizon: {0} and {1} lie on it.</source>
        <translation>Jedan pripada kameri koja gleda ravno na stranu kvadra. Okrenuta za 30°, ona vidi kako u dubinu vode dva smjera horizontalnih bridova. Pogledajte horizont: na njemu leže {0} i {1}.</translation>
    </message>
    <message>
        <source>Two</source>
        <translation>Dva</translation>
    </message>
    <message>
        <source>Three: a box has three directions</source>
        <translation>Tri: kvadar ima tri smjera</translation>
    </message>
    <message>
        <source>This counts the directions of the box. Edges that are parallel to the picture stay parallel in it and meet nowhere; the uprights are, because the camera is level. Look at the uprights: they are parallel in the picture.</source>
        <translation>Ovo broji smjerove kvadra. Bridovi paralelni sa slikom na njoj ostaju paralelni i nigdje se ne sijeku; takvi su uspravni bridovi, jer je kamera horizontalna. Pogledajte uspravne bridove: na slici su paralelni.</translation>
    </message>
    <message>
        <source>A direction has a vanishing point if it is not parallel to the picture plane, {0}. Uprights are parallel to the picture plane of a level camera and stay parallel in the picture.</source>
        <translation>Smjer ima nedogled ako nije paralelan s ravninom slike, {0}. Uspravni bridovi paralelni su s ravninom slike horizontalne kamere i ostaju paralelni na slici.</translation>
    </message>
    <message>
        <source>A point that runs to infinity</source>
        <translation>Točka koja odlazi u beskonačnost</translation>
    </message>
    <message>
        <source>{0} runs along an edge. At {1} its {2} is 0: it is no longer a point of space but the direction {3}. Its image is the point that it was heading for all the time.</source>
        <translation>{0} ide duž brida. Kod {1} njezin je {2} jednak 0: to više nije točka prostora, nego smjer {3}. Njezina je slika točka prema kojoj je cijelo vrijeme išla.</translation>
    </message>
    <message>
        <source>For a direction {0} in view space the image on a plane at distance {1} is {2}, the same formula as for a point. The start of a line does not matter, so all lines in this direction meet there.</source>
        <translation>Za smjer {0} u koordinatnom sustavu kamere slika na ravnini na udaljenosti {1} je {2}, ista formula kao za točku. Početak pravca nije važan, pa se ondje sijeku svi pravci tog smjera.</translation>
    </message>
    <message>
        <source>Drag *t* to 1 and beyond: P returns from the other side.</source>
        <translation>Povucite *t* do 1 i dalje: P se vraća s druge strane.</translation>
    </message>
    <message>
        <source>Just one</source>
        <translation>Samo jedan</translation>
    </message>
    <message>
        <source>The camera looks down on the box: three directions, three vanishing points.</source>
        <translation>Kamera gleda na kvadar odozgo: tri smjera, tri nedogleda.</translation>
    </message>
    <message>
        <source>Turn the camera until the picture has just one vanishing point, by any axis of the box.</source>
        <translation>Okrenite kameru tako da slika ima samo jedan nedogled, od bilo koje osi kvadra.</translation>
    </message>
    <message>
        <source>Elevation 0 removes the vanishing point of the uprights. What next?</source>
        <translation>Elevacija 0 uklanja nedogled uspravnih bridova. Što dalje?</translation>
    </message>
    <message>
        <source>The camera&apos;s {0} must be one of the axes.</source>
        <translation>{0} kamere mora biti jedna od osi.</translation>
    </message>
    <message>
        <source>Two of the three directions are parallel to the picture now; only the third one leads away.</source>
        <translation>Dva od tri smjera sada su paralelna sa slikom; samo treći vodi u dubinu.</translation>
    </message>
    <message>
        <source>Where, and how many</source>
        <translation>Gdje i koliko</translation>
    </message>
    <message>
        <source>Here the camera stands in front of the cube and looks down by 30°.</source>
        <translation>Ovdje kamera stoji pred kockom i gleda dolje za 30°.</translation>
    </message>
    <message>
        <source>How many of the cube&apos;s three directions have a vanishing point?</source>
        <translation>Koliko od tri smjera kocke ima nedogled?</translation>
    </message>
    <message>
        <source>That would be a camera that looks along an axis of the cube. This one looks down: the edges along y and those along z both lead away. Look at the edges along y: they run together downwards.</source>
        <translation>To bi bila kamera koja gleda duž osi kocke. Ova gleda dolje: i bridovi duž y i oni duž z vode u dubinu. Pogledajte bridove duž y: stječu se prema dolje.</translation>
    </message>
    <message>
        <source>This counts the directions of the cube. The camera is straight in front of it, so the edges along x are parallel to the picture and stay parallel in it. Look at the edges along x: they are parallel in the picture.</source>
        <translation>Ovo broji smjerove kocke. Kamera je točno pred njom, pa su bridovi duž x paralelni sa slikom i na njoj ostaju paralelni. Pogledajte bridove duž x: na slici su paralelni.</translation>
    </message>
    <message>
        <source>Which edges are parallel to the picture?</source>
        <translation>Koji su bridovi paralelni sa slikom?</translation>
    </message>
    <message>
        <source>{0}: its x is 0, so edges along x stay parallel. The other two directions have one vanishing point each.</source>
        <translation>{0}: x je 0, pa bridovi duž x ostaju paralelni. Druga dva smjera imaju po jedan nedogled.</translation>
    </message>
    <message>
        <source>Lines run along {0} in view space, one of them through {1}. At which x on the plane {2} do they meet?</source>
        <translation>Pravci idu duž {0} u koordinatnom sustavu kamere, jedan od njih kroz {1}. U kojem se x na ravnini {2} sijeku?</translation>
    </message>
    <message>
        <source>This is a point ten steps along the line, which falls short of the point where all lines meet. That point depends on the direction alone. Look at P on an edge of this box: as long as {0} is less than 1, it has not reached its vanishing point.</source>
        <translation>Ovo je točka deset koraka po pravcu, a ona ne doseže točku u kojoj se svi pravci sijeku. Ta točka ovisi samo o smjeru. Pogledajte P na bridu ovog kvadra: dok je {0} manji od 1, nije stigla do svojega nedogleda.</translation>
    </message>
    <message>
        <source>The lines meet in front of the eye, where z is negative: divide by {0}, which is positive. Look at P on an edge of this box: the edge leads away from you, and P has come to its vanishing point on the same side.</source>
        <translation>Pravci se sijeku ispred kamere, gdje je z negativan: dijelite s {0}, što je pozitivno. Pogledajte P na bridu ovog kvadra: brid vodi od vas, a P je stigla do svojega nedogleda na istoj strani.</translation>
    </message>
    <message>
        <source>The image of the direction itself: {0}.</source>
        <translation>Slika samog smjera: {0}.</translation>
    </message>
    <message>
        <source>{0}. After ten steps along the line you are at 0.571; the vanishing point is the limit.</source>
        <translation>{0}. Nakon deset koraka po pravcu ste na 0.571; nedogled je granična vrijednost.</translation>
    </message>
    <message>
        <source>Three, with one below</source>
        <translation>Tri, od kojih jedan dolje</translation>
    </message>
    <message>
        <source>Photographs of high houses are often taken from below, or from a tower.</source>
        <translation>Fotografije visokih zgrada često se snimaju odozdo ili s tornja.</translation>
    </message>
    <message>
        <source>Make a 3-point perspective whose {0} lies below the picture.</source>
        <translation>Napravite perspektivu s 3 nedogleda čiji {0} leži ispod slike.</translation>
    </message>
    <message>
        <source>Change the elevation. On which side does {0} appear?</source>
        <translation>Promijenite elevaciju. Na kojoj se strani pojavljuje {0}?</translation>
    </message>
    <message>
        <source>A camera that looks down sees uprights run together below.</source>
        <translation>Kamera koja gleda dolje vidi kako se uspravni bridovi stječu prema dolje.</translation>
    </message>
    <message>
        <source>Back to the prediction</source>
        <translation>Natrag na predviđanje</translation>
    </message>
    <message>
        <source>A box has three directions, and everybody knows the name 3-point perspective, so three is tempting. But the number depends on the camera, not on the box. Each axis of the box that is parallel to the picture, {0}, has its vanishing point at infinity, and its edges stay parallel. A level camera keeps uprights upright, which is why architects keep it level. *Kinds of projection* has all of them as small pictures.</source>
        <translation>Kvadar ima tri smjera, a svi znaju naziv perspektiva s 3 nedogleda, pa je odgovor tri primamljiv. Ali broj ovisi o kameri, a ne o kvadru. Svaka os kvadra koja je paralelna sa slikom, {0}, ima nedogled u beskonačnosti, i njezini bridovi ostaju paralelni. Horizontalna kamera ostavlja uspravne bridove uspravnima, zato je arhitekti i drže horizontalno. *Vrste projekcija* ih sve imaju kao male slike.</translation>
    </message>
    <message>
        <source>Practise: where lines meet</source>
        <translation>Vježba: gdje se pravci sijeku</translation>
    </message>
    <message>
        <source>All lines in one direction {0} of view space meet in one point of the picture, which lies on the plane {1}.</source>
        <translation>Svi pravci jednog smjera {0} koordinatnog sustava kamere sijeku se u jednoj točki slike, koja leži na ravnini {1}.</translation>
    </message>
    <message>
        <source>The edges of the box that lead away run along {0} in view space. One more line of this direction starts at {1}. At which {2} do they all meet if {3}?</source>
        <translation>Bridovi kvadra koji vode u dubinu idu duž {0} u koordinatnom sustavu kamere. Još jedan pravac tog smjera počinje u {1}. U kojem se {2} svi sijeku ako je {3}?</translation>
    </message>
    <message>
        <source>This is a point ten steps along the line, which is still before the point where the lines meet. That depends on the direction alone: {0}. Look at P, which runs along such an edge: before {1} it has not reached {2}.</source>
        <translation>Ovo je točka deset koraka po pravcu, a to je još ispred točke u kojoj se pravci sijeku. Ona ovisi samo o smjeru: {0}. Pogledajte P, koja ide po takvom bridu: prije {1} nije stigla do {2}.</translation>
    </message>
    <message>
        <source>The line ends where it starts</source>
        <translation>Pravac završava gdje počinje</translation>
    </message>
    <message>
        <source>This is the image of the point where the line starts. Where it starts does not matter, only its direction: {0}. Look at P at the start of its edge: it is not at {1}.</source>
        <translation>Ovo je slika točke u kojoj pravac počinje. Gdje počinje, nije važno, važan je samo smjer: {0}. Pogledajte P na početku njezina brida: nije u {1}.</translation>
    </message>
    <message>
        <source>The lines meet in front of the eye, where z is negative: divide by {0}, which is positive. Look at P at {1}: it has come to {2} on the side to which the edges lead.</source>
        <translation>Pravci se sijeku ispred kamere, gdje je z negativan: dijelite s {0}, što je pozitivno. Pogledajte P kod {1}: stigla je u {2} na onoj strani na koju bridovi vode.</translation>
    </message>
    <message>
        <source>The formula for a point&apos;s image, {0}, holds for a direction too.</source>
        <translation>Formula za sliku točke, {0}, vrijedi i za smjer.</translation>
    </message>
    <message>
        <source>The start of a line does not matter.</source>
        <translation>Početak pravca nije važan.</translation>
    </message>
    <message>
        <source>Practise: find the point</source>
        <translation>Vježba: nađite točku</translation>
    </message>
    <message>
        <source>The grid&apos;s lines along z meet in one point of the picture, {0}.</source>
        <translation>Linije rešetke duž z sijeku se u jednoj točki slike, {0}.</translation>
    </message>
    <message>
        <source>The camera&apos;s azimuth is {0}°, its elevation {1}°, and the field of view {2}°. Mark {3}.</source>
        <translation>Azimut kamere je {0}°, elevacija {1}°, a vidno polje {2}°. Označite {3}.</translation>
    </message>
    <message>
        <source>This is the end of the middle line of the grid. The grid ends, but the directions of its lines meet farther up: extend two of them. Look at the level lines: the farther away they are, the closer together they lie.</source>
        <translation>Ovo je kraj srednje linije rešetke. Rešetka završava, ali se smjerovi njezinih linija sijeku više gore: produljite dvije od njih. Pogledajte horizontalne linije: što su dalje, to su gušće.</translation>
    </message>
    <message>
        <source>Rows are counted from the top. The camera looks down, so level lines meet above the middle of the picture. Look at the lines of the grid: they run together upwards.</source>
        <translation>Retci se broje odozgo. Kamera gleda dolje, pa se horizontalni pravci sijeku iznad sredine slike. Pogledajte linije rešetke: stječu se prema gore.</translation>
    </message>
    <message>
        <source>The lines meet on the other side</source>
        <translation>Pravci se sijeku na drugoj strani</translation>
    </message>
    <message>
        <source>The height is right, the side is not: extend two lines along z, and look on which side of the middle they meet. Look at two of them: the gap between them closes towards one side.</source>
        <translation>Visina je točna, strana nije: produljite dvije linije duž z i pogledajte na kojoj se strani od sredine sijeku. Pogledajte dvije od njih: razmak među njima zatvara se prema jednoj strani.</translation>
    </message>
    <message>
        <source>Two of the lines are enough; extend them with a ruler, or compute.</source>
        <translation>Dovoljne su dvije linije; produljite ih ravnalom ili računajte.</translation>
    </message>
    <message>
        <source>The direction {0} is {1} in view space, with {2}, the elevation, and {3}, the azimuth.</source>
        <translation>Smjer {0} je {1} u koordinatnom sustavu kamere, gdje je {2} elevacija, a {3} azimut.</translation>
    </message>
    <message>
        <source>{0} and {1}, with the elevation {2} and the azimuth {3}.</source>
        <translation>{0} i {1}, gdje je {2} elevacija, a {3} azimut.</translation>
    </message>
    <message>
        <source>Practise: as many as asked</source>
        <translation>Vježba: koliko se traži</translation>
    </message>
    <message>
        <source>A direction of the cube has a vanishing point if it is not parallel to the picture.</source>
        <translation>Smjer kocke ima nedogled ako nije paralelan sa slikom.</translation>
    </message>
    <message>
        <source>The cube is turned by {0}° about y. Set the camera so that exactly {1} of its three directions have a vanishing point.</source>
        <translation>Kocka ima tri smjera i okrenuta je za {0}° oko y. Postavite kameru tako da broj smjerova s nedogledom bude točno {1}.</translation>
    </message>
    <message>
        <source>Which elevation makes the uprights parallel to the picture?</source>
        <translation>Uz koju su elevaciju uspravni bridovi paralelni sa slikom?</translation>
    </message>
    <message>
        <source>Azimuth {0}° looks straight at one side of the cube.</source>
        <translation>Azimut {0}° gleda ravno na jednu stranu kocke.</translation>
    </message>
    <message>
        <source>The uprights are parallel to the picture if the camera looks level. From azimuth {0}° one more direction is; from another azimuth two have a vanishing point.</source>
        <translation>Uspravni bridovi paralelni su sa slikom ako kamera gleda horizontalno. Iz azimuta {0}° paralelan je još jedan smjer; iz drugog azimuta nedogled imaju dva.</translation>
    </message>
</context>
<context>
    <name>l13-homogeneous</name>
    <message>
        <source>What w is for</source>
        <translation>Čemu služi w</translation>
    </message>
    <message>
        <source>Four numbers for a point</source>
        <translation>Četiri broja za točku</translation>
    </message>
    <message>
        <source>A point can be written with a fourth coordinate, {0}. Many such rows of numbers stand for the same point. With them, matrices can do what they cannot do with three numbers: translate and divide.</source>
        <translation>Točka se može zapisati s četvrtom koordinatom, {0}. Mnogo takvih redaka brojeva predstavlja istu točku. S njima matrice mogu ono što s tri broja ne mogu: translatirati i dijeliti.</translation>
    </message>
    <message>
        <source>Which point of space is {0}?</source>
        <translation>Koja je točka prostora {0}?</translation>
    </message>
    <message>
        <source>(2, 4, −6); the 2 is dropped</source>
        <translation>(2, 4, −6); 2 se odbacuje</translation>
    </message>
    <message>
        <source>The fourth number is an extra</source>
        <translation>Četvrti broj je dodatak</translation>
    </message>
    <message>
        <source>The fourth number is not an extra: it is the divisor of the other three. Only if {0} can it be dropped. Look at points 1 and 2: {1} is another place than {2}.</source>
        <translation>Četvrti broj nije dodatak: on je djelitelj ostalih triju. Može se odbaciti samo ako je {0}. Pogledajte točke 1 i 2: {1} je drugo mjesto nego {2}.</translation>
    </message>
    <message>
        <source>None: four numbers are not a point of space</source>
        <translation>Nijedna: četiri broja nisu točka prostora</translation>
    </message>
    <message>
        <source>They stand for one: divide the first three by the fourth. Many rows of four numbers stand for the same point. Look at point 1: it is the point that they stand for.</source>
        <translation>Predstavljaju jednu: podijelite prva tri četvrtim. Mnogo redaka od četiri broja predstavlja istu točku. Pogledajte točku 1: to je točka koju predstavljaju.</translation>
    </message>
    <message>
        <source>{0} is the point {1}. Type 2, 4, −6 and w = 2 in the Probe panel: it becomes point 1.</source>
        <translation>{0} je točka {1}. Upišite 2, 4, −6 i w = 2 u ploči Sonda: to postaje točka 1.</translation>
    </message>
    <message>
        <source>The w of the lens</source>
        <translation>w objektiva</translation>
    </message>
    <message>
        <source>Point 1 is at {0} in view space. The last row of the lens&apos;s matrix is {1}, so {2}, the depth. In clip space nothing is divided yet:</source>
        <translation>Točka 1 je u {0} u koordinatnom sustavu kamere. Posljednji redak matrice objektiva je {1}, pa je {2}, dubina. U prostoru odsijecanja još ništa nije podijeljeno:</translation>
    </message>
    <message>
        <source>x</source>
        <translation>x</translation>
    </message>
    <message>
        <source>y</source>
        <translation>y</translation>
    </message>
    <message>
        <source>z</source>
        <translation>z</translation>
    </message>
    <message>
        <source>w</source>
        <translation>w</translation>
    </message>
    <message>
        <source>clip</source>
        <translation>odsijecanje</translation>
    </message>
    <message>
        <source>NDC</source>
        <translation>NDC</translation>
    </message>
    <message>
        <source>The matrix keeps straight lines straight. The division by {0}, which is not a matrix, makes far things small. *Probe* shows each in a row of its own.</source>
        <translation>Matrica čuva pravce ravnima. Dijeljenje s {0}, koje nije matrica, čini daleke stvari malima. *Sonda* pokazuje svako u zasebnom retku.</translation>
    </message>
    <message>
        <source>Without a w</source>
        <translation>Bez w</translation>
    </message>
    <message>
        <source>If {0}, the division is impossible.</source>
        <translation>Ako je {0}, dijeljenje nije moguće.</translation>
    </message>
    <message>
        <source>Move the camera, or point 1, until the point&apos;s w in clip space is 0, within 0.05.</source>
        <translation>Pomičite kameru ili točku 1 dok w točke u prostoru odsijecanja ne bude 0, do na 0.05.</translation>
    </message>
    <message>
        <source>{0} is the depth in front of the eye, here 5.</source>
        <translation>{0} je dubina ispred kamere, ovdje 5.</translation>
    </message>
    <message>
        <source>The distance is 8, and the point is 3 in front of the target.</source>
        <translation>Udaljenost je 8, a točka je 3 ispred cilja.</translation>
    </message>
    <message>
        <source>The point lies beside the eye, in the eye plane: its image is at infinity, in no pixel.</source>
        <translation>Točka leži pokraj kamere, u ravnini kamere: slika joj je u beskonačnosti, ni u jednom pikselu.</translation>
    </message>
    <message>
        <source>Computing with w</source>
        <translation>Računanje s w</translation>
    </message>
    <message>
        <source>Each question is about a point {0} after the lens&apos;s matrix, or about such a matrix.</source>
        <translation>Svako se pitanje tiče točke {0} nakon matrice objektiva ili takve matrice.</translation>
    </message>
    <message>
        <source>A point comes out of the matrix as {0}. What is its {1} in NDC?</source>
        <translation>Točka izlazi iz matrice kao {0}. Koliki je njezin {1} u NDC?</translation>
    </message>
    <message>
        <source>This is still the first number of the row. In NDC it is divided by the last one, {0}. Look at point 1, which has {1} and {2} in clip space: it is inside the cube, where {3} is at most 1.</source>
        <translation>To je još prvi broj retka. U NDC se dijeli posljednjim, {0}. Pogledajte točku 1, koja u prostoru odsijecanja ima {1} i {2}: unutar kocke je, gdje je {3} najviše 1.</translation>
    </message>
    <message>
        <source>w has the sign of z</source>
        <translation>w ima predznak od z</translation>
    </message>
    <message>
        <source>The sign has changed: {0} already is the positive depth {1}, so divide by {2} itself. Look at point 1, which has {3} and {4} in clip space: it is in the right half of the picture.</source>
        <translation>Predznak se promijenio: {0} je već pozitivna dubina {1}, zato dijelite samim {2}. Pogledajte točku 1, koja u prostoru odsijecanja ima {3} i {4}: u desnoj je polovici slike.</translation>
    </message>
    <message>
        <source>NDC is the result of the division.</source>
        <translation>NDC je rezultat dijeljenja.</translation>
    </message>
    <message>
        <source>{0}. The same w divides y and z.</source>
        <translation>{0}. Isti w dijeli y i z.</translation>
    </message>
    <message>
        <source>Lecture 000: with {0} in row 4, column 3 the matrix has 1 in row 1, column 1. Multiply the matrix by the {1} that makes row 4, column 3 equal to {2}; let {3}. What is in row 1, column 1 then?</source>
        <translation>Predavanje 000: s {0} u retku 4, stupcu 3 matrica ima 1 u retku 1, stupcu 1. Pomnožite matricu onim {1} koji u retku 4, stupcu 3 daje {2}; neka je {3}. Što je tada u retku 1, stupcu 1?</translation>
    </message>
    <message>
        <source>One minus is left over</source>
        <translation>Jedan je minus preostao</translation>
    </message>
    <message>
        <source>{0} makes {1}, which is positive: both sides have a minus. Look at {2} in the lecture&apos;s scene: {3} is this length.</source>
        <translation>{0} daje {1}, što je pozitivno: obje strane imaju minus. Pogledajte {2} u sceni predavanja: {3} je ta duljina.</translation>
    </message>
    <message>
        <source>{0} and {1} take a point to the same point. Multiply every cell.</source>
        <translation>{0} i {1} preslikavaju točku u istu točku. Pomnožite svaku ćeliju.</translation>
    </message>
    <message>
        <source>{0}. All four resulting coordinates are four times as large, and their quotients are the same.</source>
        <translation>{0}. Sve četiri dobivene koordinate četiri su puta veće, a kvocijenti su im isti.</translation>
    </message>
    <message>
        <source>w = 0 before the lens</source>
        <translation>w = 0 prije objektiva</translation>
    </message>
    <message>
        <source>{0} is not a point but a direction: a *point at infinity*. A matrix takes it like any other row, and a translation leaves it unchanged. Here P is at {1} along z: its {2} is 0 in the world, yet it has an image, because its w in clip space is not 0.</source>
        <translation>{0} nije točka, nego smjer: *beskonačno daleka točka*. Matrica je preslikava kao i svaki drugi redak, a translacija je ne mijenja. Ovdje je P kod {1} duž z: njezin {2} je u svijetu 0, a ipak ima sliku, jer njezin w u prostoru odsijecanja nije 0.</translation>
    </message>
    <message>
        <source>The image is 720 high and the field of view 70°. In which row is the image of the direction {0} in view space? Its {1} is {2}.</source>
        <translation>Slika je visoka 720, a vidno polje 70°. U kojem je retku slika smjera {0} iz koordinatnog sustava kamere? Njegov {1} je {2}.</translation>
    </message>
    <message>
        <source>Rows are counted from the top. {0} is positive, so the row is above the middle, 360. Look at the numbers beside the frame: 0 is at the top.</source>
        <translation>Retci se broje odozgo. {0} je pozitivan, pa je redak iznad sredine, 360. Pogledajte brojeve uz okvir: 0 je na vrhu.</translation>
    </message>
    <message>
        <source>This is a point ten steps along a line in this direction. The point at infinity depends on the direction alone: {0}. Look at P at {1}: it has not reached its vanishing point.</source>
        <translation>Ovo je točka deset koraka po pravcu tog smjera. Beskonačno daleka točka ovisi samo o smjeru: {0}. Pogledajte P kod {1}: nije stigla do svojega nedogleda.</translation>
    </message>
    <message>
        <source>Row {0}.</source>
        <translation>Redak {0}.</translation>
    </message>
    <message>
        <source>{0}, so row 102.9. All lines in this direction meet there.</source>
        <translation>{0}, dakle redak 102.9. Ondje se sijeku svi pravci tog smjera.</translation>
    </message>
    <message>
        <source>Back to the prediction</source>
        <translation>Natrag na predviđanje</translation>
    </message>
    <message>
        <source>It is tempting to read the fourth number as an extra and to drop it. But it is the divisor of the other three. {0} and {1} lie on one line through the origin of four-dimensional space, and this line stands for one point. That is why a matrix can divide: it writes the divisor into {2}. And if {3} is 0, the line stands for a direction, not for a point.</source>
        <translation>Primamljivo je četvrti broj čitati kao dodatak i odbaciti ga. Ali on je djelitelj ostalih triju. {0} i {1} leže na istom pravcu kroz ishodište četverodimenzionalnog prostora, a taj pravac predstavlja jednu točku. Zato matrica može dijeliti: ona upisuje djelitelj u {2}. A ako je {3} jednak 0, pravac predstavlja smjer, a ne točku.</translation>
    </message>
    <message>
        <source>Practise: divide</source>
        <translation>Vježba: podijelite</translation>
    </message>
    <message>
        <source>Point 1 comes out of the lens&apos;s matrix as {0}.</source>
        <translation>Točka 1 izlazi iz matrice objektiva kao {0}.</translation>
    </message>
    <message>
        <source>Its row of numbers is {0}. What is its {1} in NDC?</source>
        <translation>Njezin redak brojeva je {0}. Koliki je njezin {1} u NDC?</translation>
    </message>
    <message>
        <source>This is still the first number of the row. In NDC it is divided by the last one, {0}. Look at point 1 in the cube: its {1} is between −1 and 1.</source>
        <translation>To je još prvi broj retka. U NDC se dijeli posljednjim, {0}. Pogledajte točku 1 u kocki: njezin {1} je između −1 i 1.</translation>
    </message>
    <message>
        <source>The sign has changed: {0} already is the positive depth {1}, so divide by {2} itself. Look at point 1 in the picture: it is on the side that the sign of {3} says.</source>
        <translation>Predznak se promijenio: {0} je već pozitivna dubina {1}, zato dijelite samim {2}. Pogledajte točku 1 na slici: na strani je koju kaže predznak od {3}.</translation>
    </message>
    <message>
        <source>The third number divides</source>
        <translation>Treći broj dijeli</translation>
    </message>
    <message>
        <source>This divides by the third number of the row. The divisor is the fourth one, {0}, which the matrix made of the depth. Look at point 1 in the cube: its {1} is between −1 and 1.</source>
        <translation>Ovo dijeli trećim brojem retka. Djelitelj je četvrti, {0}, koji je matrica načinila od dubine. Pogledajte točku 1 u kocki: njezin {1} je između −1 i 1.</translation>
    </message>
    <message>
        <source>Which of the four numbers is the divisor?</source>
        <translation>Koji je od četiri broja djelitelj?</translation>
    </message>
    <message>
        <source>The same {0} divides the first three numbers.</source>
        <translation>Isti {0} dijeli prva tri broja.</translation>
    </message>
    <message>
        <source>Practise: the same matrix, multiplied</source>
        <translation>Vježba: ista matrica, pomnožena</translation>
    </message>
    <message>
        <source>Lecture 000 projects onto the plane {0} by a matrix {1} with 1, 1, 1, 0 on its diagonal, {2} in row 4, column 3, and 0 elsewhere. {3} and {4} take every point to the same point.</source>
        <translation>Predavanje 000 projicira na ravninu {0} matricom {1} koja na dijagonali ima 1, 1, 1, 0, u retku 4, stupcu 3 {2}, a drugdje 0. {3} i {4} preslikavaju svaku točku u istu točku.</translation>
    </message>
    <message>
        <source>{0}. Which {1} has {2} in row 4, column 3? Give its rows 3 and 4, columns 3 and 4.</source>
        <translation>{0}. Koja {1} ima {2} u retku 4, stupcu 3? Napišite njezine retke 3 i 4, stupce 3 i 4.</translation>
    </message>
    <message>
        <source>{0} makes {1}, which is positive: both sides have a minus. Look at {2}: {3} is this length.</source>
        <translation>{0} daje {1}, što je pozitivno: obje strane imaju minus. Pogledajte {2}: {3} je ta duljina.</translation>
    </message>
    <message>
        <source>One cell is enough</source>
        <translation>Dovoljna je jedna ćelija</translation>
    </message>
    <message>
        <source>This changes one cell only. {0} multiplies every cell of the matrix, the ones on the diagonal too. Look at {1}: only for this plane is 1 right.</source>
        <translation>Ovo mijenja samo jednu ćeliju. {0} množi svaku ćeliju matrice, i jedinice na dijagonali. Pogledajte {1}: samo je za tu ravninu 1 točno.</translation>
    </message>
    <message>
        <source>The diagonal is divided</source>
        <translation>Dijagonala se dijeli</translation>
    </message>
    <message>
        <source>This multiplies the diagonal by {0}, but the last row by {1}. All cells have the same factor. Look at {2}: only for this plane are {3} and {4} the same.</source>
        <translation>Ovo množi dijagonalu s {0}, a posljednji redak s {1}. Sve ćelije imaju isti faktor. Pogledajte {2}: samo su za tu ravninu {3} i {4} isti.</translation>
    </message>
    <message>
        <source>By what is {0} multiplied to become {1}?</source>
        <translation>Čime se množi {0} da postane {1}?</translation>
    </message>
    <message>
        <source>{0}. All four numbers of a point are {1} times as large, and their quotients are the same.</source>
        <translation>{0}. Sva četiri broja točke {1} puta su veća, a kvocijenti su im isti.</translation>
    </message>
    <message>
        <source>Practise: a direction in the picture</source>
        <translation>Vježba: smjer na slici</translation>
    </message>
    <message>
        <source>Lines in one direction of view space run to one point of the picture: the image of {0}.</source>
        <translation>Pravci jednog smjera koordinatnog sustava kamere idu prema jednoj točki slike: slici od {0}.</translation>
    </message>
    <message>
        <source>A line starts at {0} in view space and runs along {1}. The field of view is {2}°. Mark the image of the line&apos;s point at infinity.</source>
        <translation>Pravac počinje u {0} u koordinatnom sustavu kamere i ide duž {1}. Vidno polje je {2}°. Označite sliku beskonačno daleke točke pravca.</translation>
    </message>
    <message>
        <source>This is a point five steps along the line. At infinity {0}, and the start has no part in the image: only the direction counts. Look at point 1, 60 steps along the line: it has moved on.</source>
        <translation>Ovo je točka pet koraka po pravcu. U beskonačnosti je {0}, a početak u slici ne sudjeluje: računa se samo smjer. Pogledajte točku 1, 60 koraka po pravcu: otišla je dalje.</translation>
    </message>
    <message>
        <source>The column is right, but the rows are counted from the top: a direction that leads up ends in the upper half of the picture. Look at point 1, 60 steps along the line.</source>
        <translation>Stupac je točan, ali retci se broje odozgo: smjer koji vodi gore završava u gornjoj polovici slike. Pogledajte točku 1, 60 koraka po pravcu.</translation>
    </message>
    <message>
        <source>{0}, where *aspect* is 16/9.</source>
        <translation>{0}, gdje je *aspect* 16/9.</translation>
    </message>
    <message>
        <source>{0} is the middle of the picture and {1} its right edge; {2} is its top.</source>
        <translation>{0} je sredina slike, a {1} njezin desni rub; {2} je njezin vrh.</translation>
    </message>
    <message>
        <source>The direction takes the place of a point: {0} and {1} are its clip coordinates divided by their {2}.</source>
        <translation>Mjesto točke zauzima smjer: {0} i {1} su njegove koordinate odsijecanja podijeljene s njegovim {2}.</translation>
    </message>
    <message>
        <source>Practise: where the divide belongs</source>
        <translation>Vježba: gdje je mjesto dijeljenju</translation>
    </message>
    <message>
        <source>Put the tiles in order, and leave out what does not belong.</source>
        <translation>Poredajte pločice i izostavite ono što ne pripada umnošku.</translation>
    </message>
    <message>
        <source>The letter was turned about y by {0}° and moved by {1} along x; the eye is at {2}. Which chain takes a point of the letter to NDC?</source>
        <translation>Slovo je okrenuto oko y za {0}° i pomaknuto za {1} duž x; kamera je u {2}. Koji lanac točku slova prebacuje u NDC?</translation>
    </message>
    <message>
        <source>A point {0} is scaled by {1}, then moved by {2}, then divided. Which chain is that?</source>
        <translation>Točka {0} skalira se s {1}, zatim se pomiče za {2}, a zatim se dijeli. Koji je to lanac?</translation>
    </message>
    <message>
        <source>The viewport needs numbers from −1 to 1.</source>
        <translation>Prozoru prikaza trebaju brojevi od −1 do 1.</translation>
    </message>
    <message>
        <source>Which chain leads from view space to {0} by 400 pixels?</source>
        <translation>Koji lanac vodi od koordinatnog sustava kamere do slike od {0} puta 400 piksela?</translation>
    </message>
    <message>
        <source>Only one division makes them. Which one leaves {0}?</source>
        <translation>Daje ih samo jedno dijeljenje. Nakon kojeg ostaje {0}?</translation>
    </message>
    <message>
        <source>The lens&apos;s matrix writes the divisor into {0}, the division makes {1} and {2}, and the viewport makes pixels of these.</source>
        <translation>Matrica objektiva upisuje djelitelj u {0}, dijeljenje daje {1} i {2}, a prozor prikaza od njih čini piksele.</translation>
    </message>
    <message>
        <source>Begin at the letter: which matrix takes its points to the world?</source>
        <translation>Počnite od slova: koja matrica njegove točke prebacuje u svijet?</translation>
    </message>
    <message>
        <source>From the letter to the world, to the camera, through the lens, and at last the division.</source>
        <translation>Od slova u svijet, u koordinatni sustav kamere, kroz objektiv, i na kraju dijeljenje.</translation>
    </message>
    <message>
        <source>What acts first stands at the bottom.</source>
        <translation>Što djeluje prvo, stoji na dnu.</translation>
    </message>
    <message>
        <source>The scale acts first, so it does not change the move. The division may stand anywhere: neither matrix changes {0}.</source>
        <translation>Skaliranje djeluje prvo, pa ne mijenja pomak. Dijeljenje može stajati bilo gdje: nijedna od matrica ne mijenja {0}.</translation>
    </message>
</context>
<context>
    <name>l14-to-pixels</name>
    <message>
        <source>From NDC to pixels</source>
        <translation>Od NDC do piksela</translation>
    </message>
    <message>
        <source>Which row is the top?</source>
        <translation>Koji je redak na vrhu?</translation>
    </message>
    <message>
        <source>The picture is 1280 × 720 pixels. NDC goes from −1 to 1 in x and y, with y upwards.</source>
        <translation>Slika ima 1280 × 720 piksela. NDC ide od −1 do 1 po x i po y, s osi y prema gore.</translation>
    </message>
    <message>
        <source>A point has {0}. At which y of the image is it?</source>
        <translation>Točka ima {0}. U kojem je y slike?</translation>
    </message>
    <message>
        <source>In NDC y runs upwards, but the rows of an image are counted from the top, as you read. 720 is the lower edge. Look at point 1, at {0}, and at the numbers beside the frame: 720 is at the bottom.</source>
        <translation>U NDC y ide prema gore, ali retci slike broje se odozgo, kako čitate. 720 je donji rub. Pogledajte točku 1, u {0}, i brojeve uz okvir: 720 je dolje.</translation>
    </message>
    <message>
        <source>360, in the middle</source>
        <translation>360, u sredini</translation>
    </message>
    <message>
        <source>The middle is at {0}, because NDC goes from −1 to 1. {1} is an edge of the picture. Look at point 1, at {2}: it is in the middle.</source>
        <translation>Sredina je u {0}, jer NDC ide od −1 do 1. {1} je rub slike. Pogledajte točku 1, u {2}: u sredini je.</translation>
    </message>
    <message>
        <source>The rows of an image are counted from the top, as you read. {0} reverses y.</source>
        <translation>Retci slike broje se odozgo, kako čitate. {0} okreće y.</translation>
    </message>
    <message>
        <source>The viewport transform</source>
        <translation>Transformacija u prozor prikaza</translation>
    </message>
    <message>
        <source>where {0} and {1} are the image&apos;s width and height. Point 1 has {2} and {3}:</source>
        <translation>gdje su {0} i {1} širina i visina slike. Točka 1 ima {2} i {3}:</translation>
    </message>
    <message>
        <source>The Probe panel shows both, in the rows *NDC* and *image px*. A whole number is an edge between pixels: the first pixel goes from 0 to 1, and its centre is at 0.5.</source>
        <translation>Ploča Sonda pokazuje oboje, u retcima *NDC* i *slika px*. Cijeli broj je rub između piksela: prvi piksel ide od 0 do 1, a središte mu je na 0.5.</translation>
    </message>
    <message>
        <source>Into the corner</source>
        <translation>U kut</translation>
    </message>
    <message>
        <source>Point 1 is a corner of the F.</source>
        <translation>Točka 1 je jedan od vrhova slova F.</translation>
    </message>
    <message>
        <source>Bring point 1 within one pixel of (0, 0).</source>
        <translation>Dovedite točku 1 na najviše jedan piksel od (0, 0).</translation>
    </message>
    <message>
        <source>Drag its mark in *Image*, or move the camera.</source>
        <translation>Povucite njezinu oznaku u oknu *Slika* ili pomaknite kameru.</translation>
    </message>
    <message>
        <source>In NDC it must come to {0}.</source>
        <translation>U NDC mora doći u {0}.</translation>
    </message>
    <message>
        <source>(0, 0) is the upper left corner of the picture: x&apos; is −1 there, and y&apos; is 1.</source>
        <translation>(0, 0) je gornji lijevi kut slike: ondje je x&apos; jednak −1, a y&apos; jednak 1.</translation>
    </message>
    <message>
        <source>By the formula</source>
        <translation>Po formuli</translation>
    </message>
    <message>
        <source>The image has 1280 × 720 pixels.</source>
        <translation>Slika ima 1280 × 720 piksela.</translation>
    </message>
    <message>
        <source>What is in row 2, column 2 of image ← NDC?</source>
        <translation>Što je u retku 2, stupcu 2 matrice slika ← NDC?</translation>
    </message>
    <message>
        <source>With this cell, {0} would come to the lowest row. Rows are counted from the top, so {1} changes its sign. Look at point 1, at {2}: it is at the top, in row 0.</source>
        <translation>S tom bi ćelijom {0} došlo u najdonji redak. Retci se broje odozgo, pa {1} mijenja predznak. Pogledajte točku 1, u {2}: na vrhu je, u retku 0.</translation>
    </message>
    <message>
        <source>This takes {0} to run from 0 to 1. It runs from −1 to 1, over a length of 2, so each unit of {1} is half the height. Look at point 1, at {2}: it is in the middle of the picture, and only half the height is left above it.</source>
        <translation>Ovo pretpostavlja da {0} ide od 0 do 1. Ide od −1 do 1, po duljini 2, pa je svaka jedinica {1} polovica visine. Pogledajte točku 1, u {2}: u sredini je slike, a iznad nje je ostala samo polovica visine.</translation>
    </message>
    <message>
        <source>It is the factor of {0}.</source>
        <translation>To je faktor uz {0}.</translation>
    </message>
    <message>
        <source>{0}: half the height, because NDC is 2 high, and negative, because y is reversed.</source>
        <translation>{0}: polovica visine, jer je NDC visok 2, i negativno, jer se y okreće.</translation>
    </message>
    <message>
        <source>This counts the rows upwards, like {0}. They are counted from the top, so a point above the middle has a y below 360. Look at point 1: it is above the middle of the picture.</source>
        <translation>Ovo broji retke prema gore, kao {0}. Broje se odozgo, pa točka iznad sredine ima y manji od 360. Pogledajte točku 1: iznad sredine slike je.</translation>
    </message>
    <message>
        <source>This takes {0} to run from 0 to 1. It runs from −1 to 1 and is 0 in the middle of the picture. Look at point 1: it is above the middle, so its row is less than 360.</source>
        <translation>Ovo pretpostavlja da {0} ide od 0 do 1. Ide od −1 do 1, a u sredini slike je 0. Pogledajte točku 1: iznad sredine je, pa je njezin redak manji od 360.</translation>
    </message>
    <message>
        <source>Four pixels wide</source>
        <translation>Širina od četiri piksela</translation>
    </message>
    <message>
        <source>This image has 4 × 2 pixels, counted from 0.</source>
        <translation>Ova slika ima 4 × 2 piksela, brojenih od 0.</translation>
    </message>
    <message>
        <source>At which {0} is the centre of pixel 1?</source>
        <translation>U kojem je {0} središte piksela 1?</translation>
    </message>
    <message>
        <source>This is the left edge of pixel 1. Its centre is half a pixel farther. Look at the numbers beside the frame, from 0 to 4: pixel 1 reaches from 1 to 2, and its centre is at 1.5.</source>
        <translation>To je lijevi rub piksela 1. Središte je pola piksela dalje. Pogledajte brojeve uz okvir, od 0 do 4: piksel 1 seže od 1 do 2, a središte mu je na 1.5.</translation>
    </message>
    <message>
        <source>This is the share of the width, from 0 to 1. {0} runs from −1 to 1. Look at the numbers beside the frame, from 0 to 4: 1.5 is left of the middle, where {1} is negative.</source>
        <translation>To je udio širine, od 0 do 1. {0} ide od −1 do 1. Pogledajte brojeve uz okvir, od 0 do 4: 1.5 je lijevo od sredine, gdje je {1} negativan.</translation>
    </message>
    <message>
        <source>Pixel 1 goes from 1 to 2 along the image.</source>
        <translation>Piksel 1 ide po slici od 1 do 2.</translation>
    </message>
    <message>
        <source>{0}. The outermost centres are at {1}, not at {2}.</source>
        <translation>{0}. Krajnja su središta u {1}, a ne u {2}.</translation>
    </message>
    <message>
        <source>Back to the prediction</source>
        <translation>Natrag na predviđanje</translation>
    </message>
    <message>
        <source>In a diagram y goes up, and in NDC too, so 720 is tempting for the top. But an image is stored row by row from the top, and y of the image counts these rows. The minus in {0} does all the work. If you forget it, the picture is upside down, and you notice. If you forget the half pixel, the picture is shifted by half a pixel, and you do not notice.</source>
        <translation>Na dijagramu y ide prema gore, a tako je i u NDC, pa je za vrh primamljivo 720. Ali slika se sprema redak po redak odozgo, i y slike broji te retke. Minus u {0} čini sav posao. Ako ga zaboravite, slika je naopačke, i to primijetite. Ako zaboravite pola piksela, slika je pomaknuta za pola piksela, a to ne primijetite.</translation>
    </message>
    <message>
        <source>Practise: the viewport as a matrix</source>
        <translation>Vježba: prozor prikaza kao matrica</translation>
    </message>
    <message>
        <source>The viewport transform takes {0} to {1} by two rows of three numbers.</source>
        <translation>Transformacija u prozor prikaza preslikava {0} u {1} s dva retka od po tri broja.</translation>
    </message>
    <message>
        <source>The image has {0} × {1} pixels. Write down the two rows.</source>
        <translation>Slika ima {0} × {1} piksela. Napišite ta dva retka.</translation>
    </message>
    <message>
        <source>With this, {0} comes to the lowest row. Rows are counted from the top: {1}. Look at point 1, at {2}: it is at the top, in row 0.</source>
        <translation>S tim {0} dolazi u najdonji redak. Retci se broje odozgo: {1}. Pogledajte točku 1, u {2}: na vrhu je, u retku 0.</translation>
    </message>
    <message>
        <source>This takes {0} and {1} to run from 0 to 1. They run from {2} to {3}, over a length of 2, with 0 in the middle of the picture. Look at point 1, at {4}: it is in the middle of the picture.</source>
        <translation>Ovo pretpostavlja da {0} i {1} idu od 0 do 1. Idu od {2} do {3}, po duljini 2, s 0 u sredini slike. Pogledajte točku 1, u {4}: u sredini je slike.</translation>
    </message>
    <message>
        <source>0 is the corner</source>
        <translation>0 je kut</translation>
    </message>
    <message>
        <source>The factors are right. But {0} is the middle of the picture, at {1}, and this takes it to the corner. Look at point 1, at {2}: it is in the middle of the picture.</source>
        <translation>Faktori su točni. Ali {0} je sredina slike, u {1}, a ovo je preslikava u kut. Pogledajte točku 1, u {2}: u sredini je slike.</translation>
    </message>
    <message>
        <source>Where do {0} and {1} come to? And {2}?</source>
        <translation>Kamo dolaze {0} i {1}? A {2}?</translation>
    </message>
    <message>
        <source>{0} and {1}.</source>
        <translation>{0} i {1}.</translation>
    </message>
    <message>
        <source>Practise: find a point</source>
        <translation>Vježba: nađite točku</translation>
    </message>
    <message>
        <source>{0} and {1} run from {2} to {3} in the picture.</source>
        <translation>{0} i {1} idu na slici od {2} do {3}.</translation>
    </message>
    <message>
        <source>Mark where a point with {0} and {1} is.</source>
        <translation>Označite gdje je točka s {0} i {1}.</translation>
    </message>
    <message>
        <source>The column is right. But {0} runs upwards: {1} is the top of the picture. Look at point 1, at {2}: it is close to the top.</source>
        <translation>Stupac je točan. Ali {0} ide prema gore: {1} je vrh slike. Pogledajte točku 1, u {2}: blizu je vrha.</translation>
    </message>
    <message>
        <source>This takes {0} and {1} for shares of the picture from 0 to 1. Both are 0 in the middle of the picture, and {2} at its left and lower edges. Look at point 1, at {3}.</source>
        <translation>Ovo uzima {0} i {1} kao udjele slike od 0 do 1. Oba su u sredini slike 0, a na lijevom i donjem rubu {2}. Pogledajte točku 1, u {3}.</translation>
    </message>
    <message>
        <source>Where is {0}, and where {1}?</source>
        <translation>Gdje je {0}, a gdje {1}?</translation>
    </message>
    <message>
        <source>{0} and {1}, where {2} and {3} are the image&apos;s width and height.</source>
        <translation>{0} i {1}, gdje su {2} i {3} širina i visina slike.</translation>
    </message>
    <message>
        <source>Practise: the centre of a pixel</source>
        <translation>Vježba: središte piksela</translation>
    </message>
    <message>
        <source>The pixels of a row are counted from 0. {0} runs from {1} at the left edge of the picture to {2} at the right.</source>
        <translation>Pikseli u retku broje se od 0. {0} ide od {1} na lijevom rubu slike do {2} na desnom.</translation>
    </message>
    <message>
        <source>The image is {0} pixels wide. At which {1} is the centre of pixel {2}?</source>
        <translation>Širina slike je {0} px. U kojem je {1} središte piksela {2}?</translation>
    </message>
    <message>
        <source>This is the left edge of the pixel. Its centre is half a pixel farther, at {0}. Look at the numbers beside the frame, from 0 to {1}: pixel {2} reaches from {3} to {4}.</source>
        <translation>To je lijevi rub piksela. Središte je pola piksela dalje, na {0}. Pogledajte brojeve uz okvir, od 0 do {1}: piksel {2} seže od {3} do {4}.</translation>
    </message>
    <message>
        <source>This is its share of the width, from 0 to 1. {0} runs from {1} to {2}: take it twice and subtract 1. Look at the numbers beside the frame, from 0 to {3}: half-way is {4}, not {5}.</source>
        <translation>To je njegov udio širine, od 0 do 1. {0} ide od {1} do {2}: udvostručite ga i oduzmite 1. Pogledajte brojeve uz okvir, od 0 do {3}: polovica puta je {4}, a ne {5}.</translation>
    </message>
    <message>
        <source>The outermost centres are at the edges</source>
        <translation>Krajnja su središta na rubovima</translation>
    </message>
    <message>
        <source>This puts the centres of the outermost pixels at {0} and {1}. These are the edges of the picture; the outermost centres are half a pixel inside. Look at the numbers beside the frame, from 0 to {2}: the first centre is at 0.5.</source>
        <translation>Ovo stavlja središta krajnjih piksela u {0} i {1}. To su rubovi slike; krajnja su središta pola piksela unutra. Pogledajte brojeve uz okvir, od 0 do {2}: prvo središte je na 0.5.</translation>
    </message>
    <message>
        <source>Pixel {0} reaches from {1} to {2} along the row.</source>
        <translation>Piksel {0} seže u retku od {1} do {2}.</translation>
    </message>
    <message>
        <source>The centre is at {0}, and {1} pixels are 2 wide in {2}.</source>
        <translation>Središte je na {0}, a {1} piksela široko je 2 u {2}.</translation>
    </message>
</context>
<context>
    <name>l15-clipping</name>
    <message>
        <source>What is cut, and when?</source>
        <translation>Što se odsijeca, i kada?</translation>
    </message>
    <message>
        <source>Behind, and in the middle</source>
        <translation>Iza, a u sredini</translation>
    </message>
    <message>
        <source>The eye looks along {0}. A point lies behind it, at {1} in view space. If you divide by its {2} anyway, {3} and {4} are between −1 and 1.</source>
        <translation>Kamera gleda duž {0}. Točka leži iza nje, u {1} u koordinatnom sustavu kamere. Ako je ipak podijelite s njezinim {2}, {3} i {4} su između −1 i 1.</translation>
    </message>
    <message>
        <source>Is the point drawn?</source>
        <translation>Crta li se točka?</translation>
    </message>
    <message>
        <source>No</source>
        <translation>Ne</translation>
    </message>
    <message>
        <source>Yes: its {0} and {1} are within the picture</source>
        <translation>Da: njezini {0} i {1} su unutar slike</translation>
    </message>
    <message>
        <source>What is in the picture is in front</source>
        <translation>Što je na slici, ispred je</translation>
    </message>
    <message>
        <source>After the division it looks like a point of the picture, but {0} says that it is behind the eye. The test comes before the division, while the sign of {1} is still there. Look from above: point 1 is behind the eye.</source>
        <translation>Nakon dijeljenja izgleda kao točka slike, ali {0} govori da je iza kamere. Ispituje se prije dijeljenja, dok još postoji predznak od {1}. Pogledajte odozgo: točka 1 je iza kamere.</translation>
    </message>
    <message>
        <source>Yes, but upside down</source>
        <translation>Da, ali naopačke</translation>
    </message>
    <message>
        <source>A camera is a dark box</source>
        <translation>Kamera je mračna kutija</translation>
    </message>
    <message>
        <source>The division would draw it mirrored, as on a film behind a hole. But a camera draws only what is in front of it: the point is removed before the division. Look from above: point 1 is behind the eye, and nothing of the pyramid is there.</source>
        <translation>Dijeljenje bi je nacrtalo zrcaljeno, kao na filmu iza rupice. Ali kamera crta samo ono što je ispred nje: točka se uklanja prije dijeljenja. Pogledajte odozgo: točka 1 je iza kamere, a ondje nema ništa od piramide.</translation>
    </message>
    <message>
        <source>A point is kept if {0}. No point with a negative w satisfies this. The test comes before the division.</source>
        <translation>Točka se zadržava ako je {0}. To ne ispunjava nijedna točka s negativnim w. Ispituje se prije dijeljenja.</translation>
    </message>
    <message>
        <source>Six planes</source>
        <translation>Šest ravnina</translation>
    </message>
    <message>
        <source>Before the division the six planes of every lens are the same: {0}. What is wholly inside is drawn, what is wholly beyond one of them is not, and what crosses a plane is cut. An edge from {1} to {2} meets {3} at</source>
        <translation>Prije dijeljenja šest je ravnina svakog objektiva isto: {0}. Što je cijelo unutra, crta se, što je cijelo iza jedne od njih, ne crta se, a što siječe ravninu, odsijeca se. Brid od {1} do {2} siječe {3} kod</translation>
    </message>
    <message>
        <source>From {0} to {1}: {2}.</source>
        <translation>Od {0} do {1}: {2}.</translation>
    </message>
    <message>
        <source>Step through *Planes that have cut*: each plane cuts what the plane before it has left, and adds two new corners where it crosses. The highlighted face of the cube is the plane of the step.</source>
        <translation>Prođite kroz *Ravnine koje su odsjekle*: svaka ravnina odsijeca ono što je prethodna ostavila i dodaje dva nova vrha gdje siječe. Istaknuta strana kocke je ravnina tog koraka.</translation>
    </message>
    <message>
        <source>One edge, two planes</source>
        <translation>Jedan brid, dvije ravnine</translation>
    </message>
    <message>
        <source>Points 1 and 2 are the ends of an edge: one is 4 units in front of the eye, the other 12. Both are inside.</source>
        <translation>Točke 1 i 2 su krajevi brida: jedna je 4 jedinice ispred kamere, druga 12. Obje su unutra.</translation>
    </message>
    <message>
        <source>Let the edge cross near and far, so that both planes cut it.</source>
        <translation>Neka brid siječe blisku i daleku ravninu, tako da ga obje odsijecaju.</translation>
    </message>
    <message>
        <source>Near must lie beyond point 1, far in front of point 2.</source>
        <translation>Bliska ravnina mora biti iza točke 1, a daleka ispred točke 2.</translation>
    </message>
    <message>
        <source>The planes cut the edge into three pieces; the piece between them is drawn.</source>
        <translation>Ravnine dijele brid na tri komada; crta se komad između njih.</translation>
    </message>
    <message>
        <source>Where it is cut</source>
        <translation>Gdje se odsijeca</translation>
    </message>
    <message>
        <source>Here are the test points A to E. The eye is at {0} and looks along {1}; far is 11. C is at {2}.</source>
        <translation>Ovdje su testne točke od A do E. Kamera je u {0} i gleda duž {1}; daleka ravnina je na 11. C je u {2}.</translation>
    </message>
    <message>
        <source>An edge runs from {0} to {1} in clip space. At which t does it meet {2}?</source>
        <translation>Brid ide od {0} do {1} u prostoru odsijecanja. Kod kojeg t siječe {2}?</translation>
    </message>
    <message>
        <source>This looks for {0}. Before the division the plane is {1}, and {2} changes along the edge as well. Look from above at the side of the pyramid: it slants, because there {3}.</source>
        <translation>Ovo traži {0}. Prije dijeljenja ravnina je {1}, a duž brida se mijenja i {2}. Pogledajte odozgo stranu piramide: nagnuta je, jer je ondje {3}.</translation>
    </message>
    <message>
        <source>The share in the picture is the share of the edge</source>
        <translation>Udio na slici je udio brida</translation>
    </message>
    <message>
        <source>This is the place in the picture, after the division. Along the edge itself {0} changes evenly, {1} does not. Look from above at the side of the pyramid: an edge is cut there, in the world, before it is drawn.</source>
        <translation>To je mjesto na slici, nakon dijeljenja. Duž samog brida jednoliko se mijenja {0}, a {1} ne. Pogledajte odozgo stranu piramide: brid se odsijeca ondje, u svijetu, prije nego što se nacrta.</translation>
    </message>
    <message>
        <source>{0} is 1 at one end and −5 at the other. Where is it 0?</source>
        <translation>{0} je 1 na jednom kraju, a −5 na drugom. Gdje je 0?</translation>
    </message>
    <message>
        <source>{0}. Both x and w change along the edge; in NDC the same place is at 4/9.</source>
        <translation>{0}. Duž brida se mijenjaju i x i w; u NDC isto je mjesto na 4/9.</translation>
    </message>
    <message>
        <source>From which value of far on is C inside?</source>
        <translation>Od koje je udaljenosti daleke ravnine C unutra?</translation>
    </message>
    <message>
        <source>This measures straight from the eye to C. The far plane is a plane, not a sphere: only the depth along the axis counts. Look from above at far = 12.5: C is inside, though it is 13.9 away.</source>
        <translation>Ovo mjeri ravno od kamere do C. Daleka ravnina je ravnina, a ne sfera: računa se samo dubina duž osi. Pogledajte odozgo s dalekom ravninom na 12.5: C je unutra, premda je udaljena 13.9.</translation>
    </message>
    <message>
        <source>The far plane is a plane: only the depth matters.</source>
        <translation>Daleka ravnina je ravnina: važna je samo dubina.</translation>
    </message>
    <message>
        <source>{0}, however far C is to the side.</source>
        <translation>{0}, koliko god C bila sa strane.</translation>
    </message>
    <message>
        <source>Just four</source>
        <translation>Točno četiri</translation>
    </message>
    <message>
        <source>A test point with a grey name is outside.</source>
        <translation>Testna točka sa sivim imenom je izvan.</translation>
    </message>
    <message>
        <source>With near and far alone, make exactly four of the five test points lie inside.</source>
        <translation>Samo bliskom i dalekom ravninom postignite da unutra leže točno četiri od pet testnih točaka.</translation>
    </message>
    <message>
        <source>Which points lie outside because of their depth, and which are beyond a side?</source>
        <translation>Koje točke leže izvan zbog svoje dubine, a koje su preko bočne strane?</translation>
    </message>
    <message>
        <source>Take far back, and watch *test points inside*.</source>
        <translation>Odmaknite daleku ravninu i promatrajte *testne točke unutra*.</translation>
    </message>
    <message>
        <source>Neither near nor far brings back what the sides cut off.</source>
        <translation>Ni bliska ni daleka ravnina ne vraćaju ono što odsijecaju bočne.</translation>
    </message>
    <message>
        <source>Back to the prediction</source>
        <translation>Natrag na predviđanje</translation>
    </message>
    <message>
        <source>&quot;Its {0} is between −1 and 1, so it is in the picture&quot;: that is tempting, because after the division no other test is left. But the division has lost the sign of {1}. A point behind the eye then looks like one in front of it, upside down and on the other side. So clip before the division, by {2}; the near plane removes everything without a positive {3}.</source>
        <translation>„Njezin {0} je između −1 i 1, dakle na slici je”: to je primamljivo, jer nakon dijeljenja drugog ispita više nema. Ali dijeljenje je izgubilo predznak od {1}. Točka iza kamere tada izgleda kao ona ispred nje, naopačke i na drugoj strani. Zato odsijecajte prije dijeljenja, po {2}; bliska ravnina uklanja sve što nema pozitivan {3}.</translation>
    </message>
    <message>
        <source>Practise: where an edge leaves</source>
        <translation>Vježba: gdje brid izlazi</translation>
    </message>
    <message>
        <source>The edge from point 1 to point 2 leaves the view volume at the plane {0}. It is cut before the division.</source>
        <translation>Brid od točke 1 do točke 2 izlazi iz volumena pogleda kroz ravninu {0}. Odsijeca se prije dijeljenja.</translation>
    </message>
    <message>
        <source>In clip space point 1 has {0}, {1} and point 2 has {2}, {3}. At which {4}, from point 1 to point 2, does the edge meet {5}?</source>
        <translation>U prostoru odsijecanja točka 1 ima {0}, {1}, a točka 2 ima {2}, {3}. Kod kojeg {4}, od točke 1 do točke 2, brid siječe {5}?</translation>
    </message>
    <message>
        <source>This is the place in the picture, after the division. Along the edge itself {0} changes evenly, {1} does not. Look from above at the edge from 1 to 2: it is cut there, not in the picture.</source>
        <translation>To je mjesto na slici, nakon dijeljenja. Duž samog brida jednoliko se mijenja {0}, a {1} ne. Pogledajte odozgo brid od 1 do 2: odsijeca se ondje, a ne na slici.</translation>
    </message>
    <message>
        <source>{0} changes evenly along the edge. How large is it at point 1, and at point 2?</source>
        <translation>{0} se duž brida mijenja jednoliko. Koliko je kod točke 1, a koliko kod točke 2?</translation>
    </message>
    <message>
        <source>{0} is {1} at point 1 and negative at point 2; at {2} it is 0.</source>
        <translation>{0} je {1} kod točke 1, a negativno kod točke 2; kod {2} je 0.</translation>
    </message>
    <message>
        <source>Practise: cut by near</source>
        <translation>Vježba: odsijeca bliska ravnina</translation>
    </message>
    <message>
        <source>Point 1 is in front of the camera, point 2 behind it. The near plane cuts the edge between them.</source>
        <translation>Točka 1 je ispred kamere, točka 2 iza nje. Brid između njih odsijeca bliska ravnina.</translation>
    </message>
    <message>
        <source>In view space point 1 is at {0}, point 2 at {1}, and near is {2}. In this picture {3}. Mark where the image of the edge ends.</source>
        <translation>U koordinatnom sustavu kamere točka 1 je u {0}, točka 2 u {1}, a bliska ravnina na {2}. Na ovoj je slici {3}. Označite gdje završava slika brida.</translation>
    </message>
    <message>
        <source>This divides point 2, which is behind the camera: its image is mirrored. First cut the edge at {0}, then divide. Look from above: point 2 is behind the eye, and near cuts the edge before it comes there.</source>
        <translation>Ovo dijeli točku 2, koja je iza kamere: njezina je slika zrcaljena. Najprije odsijecite brid kod {0}, zatim dijelite. Pogledajte odozgo: točka 2 je iza kamere, a bliska ravnina odsijeca brid prije nego što onamo dođe.</translation>
    </message>
    <message>
        <source>This goes from one image to the other by the right {0}. Cut the edge in view space: take {1} at this {2}, then divide. Look from above: near cuts the edge in the world.</source>
        <translation>Ovo ide od jedne slike do druge po točnom {0}. Odsijecite brid u koordinatnom sustavu kamere: uzmite {1} kod tog {2}, zatim dijelite. Pogledajte odozgo: bliska ravnina odsijeca brid u svijetu.</translation>
    </message>
    <message>
        <source>At which {0} is {1}? Go from {2} to {3}.</source>
        <translation>Kod kojeg {0} vrijedi {1}? Idite od {2} do {3}.</translation>
    </message>
    <message>
        <source>{0} at the cut is {1}; {2} is the right edge of the picture.</source>
        <translation>{0} na mjestu odsijecanja je {1}; {2} je desni rub slike.</translation>
    </message>
    <message>
        <source>{0}, and the x there is divided by its depth {1}.</source>
        <translation>{0}, a x ondje dijeli se s dubinom {1}.</translation>
    </message>
    <message>
        <source>Practise: cut by far</source>
        <translation>Vježba: odsijeca daleka ravnina</translation>
    </message>
    <message>
        <source>The far plane cuts the edge from point 1 to point 2; {0} is 0 at point 1 and 1 at point 2.</source>
        <translation>Daleka ravnina odsijeca brid od točke 1 do točke 2; {0} je 0 kod točke 1, a 1 kod točke 2.</translation>
    </message>
    <message>
        <source>In view space point 1 is at {0} and point 2 at {1}. Set far so that it cuts the edge at {2}.</source>
        <translation>U koordinatnom sustavu kamere točka 1 je u {0}, a točka 2 u {1}. Postavite daleku ravninu tako da brid odsiječe kod {2}.</translation>
    </message>
    <message>
        <source>Which depth does the edge have at {0}? It changes evenly from {1} to {2}.</source>
        <translation>Koju dubinu brid ima kod {0}? Mijenja se jednoliko od {1} do {2}.</translation>
    </message>
    <message>
        <source>{0} {1} {2}. How far the points are to the side does not matter.</source>
        <translation>{0} {1} {2}. Koliko su točke sa strane, nije važno.</translation>
    </message>
    <message>
        <source>This measures straight from the eye. Far is a plane across the axis, and only the depth counts. Look from above: your far cuts the edge too far out.</source>
        <translation>Ovo mjeri ravno od kamere. Daleka ravnina je ravnina okomita na os, i računa se samo dubina. Pogledajte odozgo: vaša daleka ravnina odsijeca brid predaleko.</translation>
    </message>
</context>
<context>
    <name>l16-eye-plane</name>
    <message>
        <source>A line through the eye plane</source>
        <translation>Dužina kroz ravninu kamere</translation>
    </message>
    <message>
        <source>Both ends have an image</source>
        <translation>Oba kraja imaju sliku</translation>
    </message>
    <message>
        <source>In camera space point 1 is A, at {0}, and point 2 is B, at {1}, behind the camera. With {2} the division gives {3} for each: 0.5 for A and −0.5 for B.</source>
        <translation>U koordinatnom sustavu kamere točka 1 je A, u {0}, a točka 2 je B, u {1}, iza kamere. Uz {2} dijeljenje za svaku daje {3}: 0.5 za A i −0.5 za B.</translation>
    </message>
    <message>
        <source>Which {0} does the image of the segment AB cover?</source>
        <translation>Koje {0} pokriva slika dužine AB?</translation>
    </message>
    <message>
        <source>From 0.5 to −0.5, the way from one to the other</source>
        <translation>Od 0.5 do −0.5, put od jedne do druge</translation>
    </message>
    <message>
        <source>This divides both ends and joins the results. B is behind the camera, so its image is mirrored. On the way from A, {0} goes to 0 and {1} beyond every bound: the image runs through infinity, not from 0.5 to −0.5. Look at A&apos; and B&apos;: the line that joins them is wrong.</source>
        <translation>Ovo dijeli oba kraja i spaja rezultate. B je iza kamere, pa je njezina slika zrcaljena. Na putu od A {0} ide u 0, a {1} preko svake granice: slika ide kroz beskonačnost, a ne od 0.5 do −0.5. Pogledajte A&apos; i B&apos;: crta koja ih spaja je pogrešna.</translation>
    </message>
    <message>
        <source>From 0.5 to infinity</source>
        <translation>Od 0.5 do beskonačnosti</translation>
    </message>
    <message>
        <source>Just 0.5: B is behind the camera and does not count</source>
        <translation>Samo 0.5: B je iza kamere i ne računa se</translation>
    </message>
    <message>
        <source>A is only one end. The half of AB between A and the plane {0} is in front of the camera, and every point of it has an image. Look at the image: it begins at A&apos; and leaves the picture on the right.</source>
        <translation>A je samo jedan kraj. Polovica dužine AB između A i ravnine {0} je ispred kamere, i svaka njezina točka ima sliku. Pogledajte sliku: počinje u A&apos; i izlazi iz slike desno.</translation>
    </message>
    <message>
        <source>From A the segment approaches the eye plane {0}; x stays 1, so {1} grows beyond every bound. The part behind the eye plane has no image.</source>
        <translation>Od A dužina se približava ravnini kamere {0}; x ostaje 1, pa {1} raste preko svake granice. Dio iza ravnine kamere nema sliku.</translation>
    </message>
    <message>
        <source>Cut before the divide</source>
        <translation>Odsijecite prije dijeljenja</translation>
    </message>
    <message>
        <source>Lecture 004 cuts the segment at {0} before dividing:</source>
        <translation>Predavanje 004 odsijeca dužinu kod {0} prije dijeljenja:</translation>
    </message>
    <message>
        <source>The scene&apos;s controls have A and B in world coordinates, {0} and {1}; the eye is at {2} and looks along the world&apos;s {3}, so in camera space they are {4} and {5}.</source>
        <translation>Kontrole scene imaju A i B u globalnim koordinatama, {0} i {1}; kamera je u {2} i gleda duž globalne osi {3}, pa su u koordinatnom sustavu kamere {4} i {5}.</translation>
    </message>
    <message>
        <source>At the cut {0} and {1}, with {2}: far outside the picture, on the right. The naive division goes to {3} instead, on the left.</source>
        <translation>Na mjestu odsijecanja je {0} i {1}, uz {2}: daleko izvan slike, desno. Naivno dijeljenje umjesto toga ide u {3}, lijevo.</translation>
    </message>
    <message>
        <source>*Image* shows the three ways: *naive*, divided without a cut; *cut*, at {0}; and *clipped*, in homogeneous coordinates, which need no such number.</source>
        <translation>*Slika* pokazuje tri načina: *naivno*, dijeljeno bez odsijecanja; *odsječeno*, kod {0}; i *odsječeno homogeno*, u homogenim koordinatama, kojima taj broj ne treba.</translation>
    </message>
    <message>
        <source>Case 4</source>
        <translation>Slučaj 4</translation>
    </message>
    <message>
        <source>The lecture distinguishes four cases by which ends lie in front of the camera. Now both are in front: case 1.</source>
        <translation>Predavanje razlikuje četiri slučaja po tome koji krajevi leže ispred kamere. Sada su oba ispred: slučaj 1.</translation>
    </message>
    <message>
        <source>Make it case 4: A in front of the camera, B behind it. (The controls are in world coordinates; the eye is at z = 4.)</source>
        <translation>Neka bude slučaj 4: A ispred kamere, B iza nje. (Kontrole su u globalnim koordinatama; kamera je na z = 4.)</translation>
    </message>
    <message>
        <source>Move the camera nearer, or drag B in *World*.</source>
        <translation>Pomaknite kameru bliže ili povucite B u oknu *Svijet*.</translation>
    </message>
    <message>
        <source>B must go behind the plane marked {0}.</source>
        <translation>B mora iza ravnine označene s {0}.</translation>
    </message>
    <message>
        <source>Now the image of AB leaves the picture and goes on to infinity.</source>
        <translation>Sada slika dužine AB izlazi iz slike i nastavlja u beskonačnost.</translation>
    </message>
    <message>
        <source>At the cut</source>
        <translation>Na mjestu odsijecanja</translation>
    </message>
    <message>
        <source>In this segment A is at {0} in camera space and B at {1}. It is cut at {2}.</source>
        <translation>U ovoj dužini A je u {0} u koordinatnom sustavu kamere, a B u {1}. Odsijeca se kod {2}.</translation>
    </message>
    <message>
        <source>At which t, from A to B, is the cut?</source>
        <translation>Kod kojeg je t, od A do B, mjesto odsijecanja?</translation>
    </message>
    <message>
        <source>The cut is at the eye plane</source>
        <translation>Odsijeca se na ravnini kamere</translation>
    </message>
    <message>
        <source>This is where {0}, in the eye plane, where the division is by 0. The lecture cuts a little before it, at {1}. Look at the plane {2}: it goes through the eye, where nothing has an image.</source>
        <translation>Ondje je {0}, u ravnini kamere, gdje se dijeli s 0. Predavanje odsijeca malo prije nje, kod {1}. Pogledajte ravninu {2}: prolazi kroz kameru, gdje ništa nema sliku.</translation>
    </message>
    <message>
        <source>Put {0} into {1}.</source>
        <translation>Uvrstite {0} u {1}.</translation>
    </message>
    <message>
        <source>{0}, a little before the middle.</source>
        <translation>{0}, malo prije sredine.</translation>
    </message>
    <message>
        <source>At which {0} is the image of the cut, with {1}?</source>
        <translation>U kojem je {0} slika mjesta odsijecanja, uz {1}?</translation>
    </message>
    <message>
        <source>This divides B, which is behind the camera. Only the part in front of {0} has an image, and it ends at the cut. Look at A&apos; and B&apos;: the line that joins them is wrong.</source>
        <translation>Ovo dijeli B, koja je iza kamere. Sliku ima samo dio ispred {0}, i završava na mjestu odsijecanja. Pogledajte A&apos; i B&apos;: crta koja ih spaja je pogrešna.</translation>
    </message>
    <message>
        <source>The side is wrong: at the cut {0} is positive, so {1} has the sign of x. Look at the image: it leaves the picture on the right.</source>
        <translation>Strana je pogrešna: na mjestu odsijecanja {0} je pozitivno, pa {1} ima predznak od x. Pogledajte sliku: izlazi iz slike desno.</translation>
    </message>
    <message>
        <source>First x at the cut, {0}.</source>
        <translation>Najprije x na mjestu odsijecanja, {0}.</translation>
    </message>
    <message>
        <source>{0}, so {1}: the line runs out of the picture on the right.</source>
        <translation>{0}, pa je {1}: crta izlazi iz slike desno.</translation>
    </message>
    <message>
        <source>Case 2</source>
        <translation>Slučaj 2</translation>
    </message>
    <message>
        <source>If both ends are behind the camera, nothing is drawn. The naive division draws the segment anyway, mirrored.</source>
        <translation>Ako su oba kraja iza kamere, ništa se ne crta. Naivno dijeljenje dužinu ipak crta, zrcaljenu.</translation>
    </message>
    <message>
        <source>Make it case 2, with B where it is.</source>
        <translation>Neka bude slučaj 2, a B neka ostane gdje jest.</translation>
    </message>
    <message>
        <source>A must go behind the plane {0} too.</source>
        <translation>I A mora iza ravnine {0}.</translation>
    </message>
    <message>
        <source>In this case the lecture only remembers the end point and draws no line.</source>
        <translation>U tom slučaju predavanje samo pamti krajnju točku i ne crta liniju.</translation>
    </message>
    <message>
        <source>Back to the prediction</source>
        <translation>Natrag na predviđanje</translation>
    </message>
    <message>
        <source>Two ends, two images, and a line between them: every segment in front of the camera is drawn like this, so it is tempting here too. But the segment crosses the plane {0}, and that point has no image. The image runs to infinity on one side, and the mirrored rest comes back from the other. Joining A&apos; and B&apos; draws exactly the part of the line that is *not* the image of AB. So cut first, then divide.</source>
        <translation>Dva kraja, dvije slike i crta između njih: tako se crta svaka dužina ispred kamere, pa je primamljivo i ovdje. Ali dužina siječe ravninu {0}, a ta točka nema sliku. Slika na jednoj strani odlazi u beskonačnost, a zrcaljeni ostatak vraća se s druge. Spajanje A&apos; i B&apos; crta upravo onaj dio pravca koji *nije* slika dužine AB. Zato najprije odsijecite, zatim dijelite.</translation>
    </message>
    <message>
        <source>Practise: cut, then divide</source>
        <translation>Vježba: odsijecite, zatim dijelite</translation>
    </message>
    <message>
        <source>AB is cut at {0} in camera space, and then divided: {1} with {2}.</source>
        <translation>AB se odsijeca kod {0} u koordinatnom sustavu kamere, a zatim dijeli: {1} uz {2}.</translation>
    </message>
    <message>
        <source>In camera space A is at {0}, {1} and B at {2}, {3}; {4} is 0. At which {5} is the image of the cut?</source>
        <translation>U koordinatnom sustavu kamere A je u {0}, {1}, a B u {2}, {3}; {4} je 0. U kojem je {5} slika mjesta odsijecanja?</translation>
    </message>
    <message>
        <source>This divides B, which is behind the camera. Only the part of AB in front of {0} has an image, and it ends at the cut. Look from above: B is behind the plane {1}.</source>
        <translation>Ovo dijeli B, koja je iza kamere. Sliku ima samo dio dužine AB ispred {0}, i završava na mjestu odsijecanja. Pogledajte odozgo: B je iza ravnine {1}.</translation>
    </message>
    <message>
        <source>The side is wrong: at the cut {0} is positive, so {1} has the sign of {2}. Look from above: the cut, just before the plane {3}, is on the side of its {4}.</source>
        <translation>Strana je pogrešna: na mjestu odsijecanja {0} je pozitivno, pa {1} ima predznak od {2}. Pogledajte odozgo: mjesto odsijecanja, tik prije ravnine {3}, na strani je svojega {4}.</translation>
    </message>
    <message>
        <source>At which {0} from A to B is {1}? There {2}.</source>
        <translation>Kod kojeg {0}, od A do B, vrijedi {1}? Ondje je {2}.</translation>
    </message>
    <message>
        <source>{0}; the {1} there is divided by 0.01.</source>
        <translation>{0}; {1} ondje dijeli se s 0.01.</translation>
    </message>
    <message>
        <source>Practise: the right piece</source>
        <translation>Vježba: pravi komad</translation>
    </message>
    <message>
        <source>A is in front of the camera, B behind it. The picture joins their images A&apos; and B&apos;, as the division alone does.</source>
        <translation>A je ispred kamere, B iza nje. Slika spaja njihove slike A&apos; i B&apos;, kao što to čini samo dijeljenje.</translation>
    </message>
    <message>
        <source>Mark where the right image of AB leaves the picture.</source>
        <translation>Označite gdje prava slika dužine AB izlazi iz slike.</translation>
    </message>
    <message>
        <source>This is B&apos;, the mirrored image of a point behind the camera. The right image never comes there. Look at the world: B is behind the plane {0}.</source>
        <translation>To je B&apos;, zrcaljena slika točke iza kamere. Prava slika onamo nikad ne dolazi. Pogledajte svijet: B je iza ravnine {0}.</translation>
    </message>
    <message>
        <source>Through B&apos; and on</source>
        <translation>Kroz B&apos; i dalje</translation>
    </message>
    <message>
        <source>This goes from A&apos; through B&apos; and on. B&apos; is mirrored, so the right image starts at A&apos; in the opposite direction. Look at the world: on the way from A to the plane {0} the edge leaves the pyramid on one side.</source>
        <translation>Ovo ide od A&apos; kroz B&apos; i dalje. B&apos; je zrcaljena, pa prava slika počinje u A&apos; u suprotnom smjeru. Pogledajte svijet: na putu od A do ravnine {0} brid izlazi iz piramide na jednoj strani.</translation>
    </message>
    <message>
        <source>It lies on the same line. On which side of A&apos;?</source>
        <translation>Leži na istom pravcu. Na kojoj strani od A&apos;?</translation>
    </message>
    <message>
        <source>It starts at A&apos; and goes away from B&apos;. In {0} and {1}, {2}, {3}, and the edge of the picture is at {4}.</source>
        <translation>Počinje u A&apos; i udaljava se od B&apos;. U {0} i {1} je {2}, {3}, a rub slike je u {4}.</translation>
    </message>
    <message>
        <source>Practise: the four cases</source>
        <translation>Vježba: četiri slučaja</translation>
    </message>
    <message>
        <source>Case 1: both ends are in front of the camera. Case 2: both are behind it. Case 3: only A is behind it. Case 4: only B is.</source>
        <translation>Slučaj 1: oba su kraja ispred kamere. Slučaj 2: oba su iza nje. Slučaj 3: samo je A iza nje. Slučaj 4: samo je B.</translation>
    </message>
    <message>
        <source>Make it case {0}. Leave A and B where they are.</source>
        <translation>Neka bude slučaj {0}. Ostavite A i B gdje jesu.</translation>
    </message>
    <message>
        <source>What is behind the camera lies beyond the plane marked {0}. Move the camera, or turn it.</source>
        <translation>Što je iza kamere, leži iza ravnine označene s {0}. Pomaknite kameru ili je okrenite.</translation>
    </message>
    <message>
        <source>In camera space the ends behind the camera have {0}. So it is with the eye at {1}, if it looks towards {2}.</source>
        <translation>U koordinatnom sustavu kamere krajevi iza kamere imaju {0}. Tako je s kamerom u {1} ako gleda prema {2}.</translation>
    </message>
</context>
<context>
    <name>l17-depth-buffer</name>
    <message>
        <source>What eats the depth buffer?</source>
        <translation>Što troši spremnik dubine?</translation>
    </message>
    <message>
        <source>Half of the range gone</source>
        <translation>Upola manji raspon</translation>
    </message>
    <message>
        <source>A depth buffer keeps one code for each pixel, here of 16 bits. Surface 2 lies behind surface 1. Where both get the same code, you see the one drawn last; this makes the stripes at the far end of the ramp. The scene&apos;s numbers say how large a gap at the target, 20 units away, is certain to be resolved.</source>
        <translation>Spremnik dubine čuva po jedan kod za svaki piksel, ovdje od 16 bitova. Ploha 2 leži iza plohe 1. Gdje obje dobiju isti kod, vidite onu koja je nacrtana posljednja; otud pruge na dalekom kraju kosine. Brojevi scene kažu koliko velik razmak kod cilja, na udaljenosti od 20 jedinica, sigurno razlikuje.</translation>
    </message>
    <message>
        <source>Far moves in from 100 to 50. By how much does the gap needed at 20 units shrink?</source>
        <translation>Daleka ravnina primiče se sa 100 na 50. Za koliko se smanji razmak potreban na 20 jedinica?</translation>
    </message>
    <message>
        <source>by 50 %</source>
        <translation>za 50 %</translation>
    </message>
    <message>
        <source>This spreads the codes evenly from near to far, so that half of the range would need half as many. Most codes lie just behind near; the part from 50 to 100 had hardly any to give. Look at both pictures: as much of the ramp is striped, though single stripes move.</source>
        <translation>Ovo raspoređuje kodove jednoliko od bliske do daleke ravnine, pa bi polovica raspona trebala upola manje njih. Većina kodova leži odmah iza bliske ravnine; dio od 50 do 100 jedva ih je imao. Pogledajte obje slike: prugast je jednak dio kosine, premda se pojedine pruge pomiču.</translation>
    </message>
    <message>
        <source>far 100</source>
        <translation>daleka 100</translation>
    </message>
    <message>
        <source>far 50</source>
        <translation>daleka 50</translation>
    </message>
    <message>
        <source>by 0.1 %</source>
        <translation>za 0.1 %</translation>
    </message>
    <message>
        <source>by 75 %</source>
        <translation>za 75 %</translation>
    </message>
    <message>
        <source>The square belongs to the distance {0} of the surfaces, which has not changed; far enters as {1}. Look at both pictures: as much of the ramp is striped, though single stripes move.</source>
        <translation>Kvadrat pripada udaljenosti {0} ploha, koja se nije promijenila; daleka ravnina ulazi kao {1}. Pogledajte obje slike: prugast je jednak dio kosine, premda se pojedine pruge pomiču.</translation>
    </message>
    <message>
        <source>Depth depends on {0}, and {1} has only become {2}. (Single stripes move with every change of the codes, and with the size of the picture; the gap does not depend on it.)</source>
        <translation>Dubina ovisi o {0}, a {1} je postalo tek {2}. (Pojedine se pruge pomiču sa svakom promjenom kodova i s veličinom slike; razmak o njoj ne ovisi.)</translation>
    </message>
    <message>
        <source>Where the codes are</source>
        <translation>Gdje su kodovi</translation>
    </message>
    <message>
        <source>The buffer stores a number from 0 at near to 1 at far. At the distance {0} it is</source>
        <translation>Spremnik čuva broj od 0 na bliskoj do 1 na dalekoj ravnini. Na udaljenosti {0} to je</translation>
    </message>
    <message>
        <source>Here {0}, {1}, and point 1 lies at {2}: {3}, as in the row *depth* of the Probe panel. The first two fifths of the way use 97 % of the codes. A step of {4} in {5} is therefore long in the world:</source>
        <translation>Ovdje je {0}, {1}, a točka 1 leži na {2}: {3}, kao u retku *dubina* ploče Sonda. Prve dvije petine puta troše 97 % kodova. Korak od {4} u {5} zato je dug u svijetu:</translation>
    </message>
    <message>
        <source>With 16 bits {0}, and the gap is 0.00598. As {1} is so small, the gap grows with {2}, and a near plane ten times as close makes it ten times as large.</source>
        <translation>Sa 16 bitova je {0}, a razmak je 0.00598. Kako je {1} tako malen, razmak raste s {2}, a deset puta bliža bliska ravnina čini ga deset puta većim.</translation>
    </message>
    <message>
        <source>Make it sure</source>
        <translation>Neka bude sigurno</translation>
    </message>
    <message>
        <source>At the start near is 0.1, and the gap that is certain at the target is 0.061.</source>
        <translation>Na početku je bliska ravnina na 0.1, a siguran razmak kod cilja je 0.061.</translation>
    </message>
    <message>
        <source>Make that gap smaller than 0.01, with the whole ramp still between near and far. The ramp begins 3.35 units from the eye and ends at 47.75.</source>
        <translation>Neka taj razmak bude manji od 0.01, a cijela kosina i dalje između bliske i daleke ravnine. Kosina počinje 3.35 jedinica od kamere i završava na 47.75.</translation>
    </message>
    <message>
        <source>Which of near and far stands alone in the denominator of the gap?</source>
        <translation>Koja od bliske i daleke ravnine stoji sama u nazivniku razmaka?</translation>
    </message>
    <message>
        <source>Move Near outwards, to 1 or more. More bits, under Format, also work.</source>
        <translation>Odmaknite blisku ravninu, na 1 ili više. Rješava to i više bitova, pod Format.</translation>
    </message>
    <message>
        <source>The stripes are gone. Near matters, and so does the number of bits; far hardly does.</source>
        <translation>Pruga više nema. Važna je bliska ravnina, a i broj bitova; daleka jedva.</translation>
    </message>
    <message>
        <source>How deep is it stored?</source>
        <translation>Kolika se dubina sprema?</translation>
    </message>
    <message>
        <source>Near is 2 and far is 50. Which number from 0 to 1 is stored for a point at the distance 10?</source>
        <translation>Bliska ravnina je na 2, daleka na 50. Koji se broj od 0 do 1 sprema za točku na udaljenosti 10?</translation>
    </message>
    <message>
        <source>This spreads the stored numbers evenly from near to far. They change with one over the distance, fast just behind near and hardly at all before far. Look at point 1, 10 away, in the cube: it is close to far.</source>
        <translation>Ovo raspoređuje spremljene brojeve jednoliko od bliske do daleke ravnine. Oni se mijenjaju s jedan kroz udaljenost, brzo odmah iza bliske ravnine, a gotovo nikako pred dalekom. Pogledajte točku 1, na 10, u kocki: blizu je daleke ravnine.</translation>
    </message>
    <message>
        <source>The buffer holds z&apos;</source>
        <translation>Spremnik sadrži z&apos;</translation>
    </message>
    <message>
        <source>This is the depth from −1 to 1 of NDC. The buffer begins with 0 at near: add 1, then halve. Look at point 1, 10 away, in the cube: its {0} is your number.</source>
        <translation>Ovo je dubina od −1 do 1 iz NDC. Spremnik počinje s 0 na bliskoj ravnini: dodajte 1, zatim prepolovite. Pogledajte točku 1, na 10, u kocki: njezin {0} je vaš broj.</translation>
    </message>
    <message>
        <source>This leaves out a division by the distance 10. No stored number is larger than 1, which is the far plane&apos;s. Look at point 1, 10 away, in the cube: it lies before far.</source>
        <translation>Ovo izostavlja dijeljenje s udaljenošću 10. Nijedan spremljeni broj nije veći od 1, što je broj daleke ravnine. Pogledajte točku 1, na 10, u kocki: leži ispred daleke ravnine.</translation>
    </message>
    <message>
        <source>{0}: the first sixth of the way takes five sixths of the codes.</source>
        <translation>{0}: prva šestina puta uzima pet šestina kodova.</translation>
    </message>
    <message>
        <source>The formula for {0} is in step 2.</source>
        <translation>Formula za {0} je u koraku 2.</translation>
    </message>
    <message>
        <source>How far apart must two surfaces be at the distance 40, with a buffer of 16 bits?</source>
        <translation>Koliko moraju biti razmaknute dvije plohe na udaljenosti 40, uz spremnik od 16 bitova?</translation>
    </message>
    <message>
        <source>This makes the gap the same at every distance. It would be if the codes were spread evenly, but most of them lie just behind near; at the distance {0} the gap is proportional to {1}. Look at the stripes with near = 0.1: they begin far out and widen with the distance.</source>
        <translation>Ovo čini razmak jednakim na svakoj udaljenosti. Bio bi takav kad bi kodovi bili raspoređeni jednoliko, ali većina ih leži odmah iza bliske ravnine; na udaljenosti {0} razmak je proporcionalan s {1}. Pogledajte pruge s bliskom ravninom na 0.1: počinju daleko i s udaljenošću se šire.</translation>
    </message>
    <message>
        <source>The gap grows with {0}: it is a little more than four times the scene&apos;s number for the target, at the distance 20.</source>
        <translation>Razmak raste s {0}: malo je više od četiri puta veći od broja scene za cilj, na udaljenosti 20.</translation>
    </message>
    <message>
        <source>Back to far</source>
        <translation>Natrag na daleku ravninu</translation>
    </message>
    <message>
        <source>With far at 50 instead of 100 the range is half as long, so it is tempting to expect codes twice as close. They would be if depth changed evenly. But it changes with {0}, so most codes lie just behind near. The space from 50 to 100 had hardly any, and giving them up gains nothing. Now move *Near* a little and watch the stripes.</source>
        <translation>S dalekom ravninom na 50 umjesto na 100 raspon je upola kraći, pa je primamljivo očekivati dvostruko gušće kodove. Bili bi takvi kad bi se dubina mijenjala jednoliko. Ali ona se mijenja s {0}, pa većina kodova leži odmah iza bliske ravnine. Prostor od 50 do 100 jedva ih je imao, i odreći ga se ne donosi ništa. Sada malo pomaknite klizač *Bliska ravnina* i promatrajte pruge.</translation>
    </message>
    <message>
        <source>Practise: a stored depth</source>
        <translation>Vježba: spremljena dubina</translation>
    </message>
    <message>
        <source>Near is {0}, far is {1}, and point 1 is at the distance {2}, straight ahead. Which number from 0 to 1 is stored for it?</source>
        <translation>Bliska ravnina je {0}, daleka {1}, a točka 1 je na udaljenosti {2}, ravno naprijed. Koji se broj od 0 do 1 za nju sprema?</translation>
    </message>
    <message>
        <source>This spreads the stored numbers evenly from near to far. They change with {0}, fast just behind near and hardly at all before far. Look at point 1 in the cube: it is closer to far than in the world.</source>
        <translation>Ovo raspoređuje spremljene brojeve jednoliko od bliske do daleke ravnine. Oni se mijenjaju s {0}, brzo odmah iza bliske ravnine, a gotovo nikako pred dalekom. Pogledajte točku 1 u kocki: bliža je dalekoj ravnini nego u svijetu.</translation>
    </message>
    <message>
        <source>This is the depth from −1 to 1 of NDC. The buffer begins with 0 at near: add 1, then halve. Look at point 1 in the cube: its {0} is your number.</source>
        <translation>Ovo je dubina od −1 do 1 iz NDC. Spremnik počinje s 0 na bliskoj ravnini: dodajte 1, zatim prepolovite. Pogledajte točku 1 u kocki: njezin {0} je vaš broj.</translation>
    </message>
    <message>
        <source>This leaves out a division by {0}. No stored number is larger than 1, which is the far plane&apos;s. Look at point 1 in the cube: it lies before far.</source>
        <translation>Ovo izostavlja dijeljenje s {0}. Nijedan spremljeni broj nije veći od 1, što je broj daleke ravnine. Pogledajte točku 1 u kocki: leži ispred daleke ravnine.</translation>
    </message>
    <message>
        <source>It must be 0 for {0} and 1 for {1}.</source>
        <translation>Mora biti 0 za {0}, a 1 za {1}.</translation>
    </message>
    <message>
        <source>Only {0} is spread evenly, so the formula divides by {1}.</source>
        <translation>Jednoliko je raspoređeno samo {0}, pa formula dijeli s {1}.</translation>
    </message>
    <message>
        <source>Of the way from near to far, the point has come {0} %.</source>
        <translation>Od puta od bliske do daleke ravnine točka je prešla {0} %.</translation>
    </message>
    <message>
        <source>Practise: the gap that is certain</source>
        <translation>Vježba: siguran razmak</translation>
    </message>
    <message>
        <source>Near is {0}, far is {1}, and the buffer has 16 bits. Point 1 on the ramp is at the distance {2}. How far behind it must another surface be to be certain of a code of its own?</source>
        <translation>Bliska ravnina je {0}, daleka {1}, a spremnik ima 16 bitova. Točka 1 na kosini je na udaljenosti {2}. Koliko daleko iza nje mora biti druga ploha da sigurno ima vlastiti kod?</translation>
    </message>
    <message>
        <source>This makes the gap the same at every distance. It would be if the codes were spread evenly, but most of them lie just behind near; the gap is proportional to {0}. Look at the stripes with near = 0.1: they begin far out and widen with the distance.</source>
        <translation>Ovo čini razmak jednakim na svakoj udaljenosti. Bio bi takav kad bi kodovi bili raspoređeni jednoliko, ali većina ih leži odmah iza bliske ravnine; razmak je proporcionalan s {0}. Pogledajte pruge s bliskom ravninom na 0.1: počinju daleko i s udaljenošću se šire.</translation>
    </message>
    <message>
        <source>Twice as far, twice the gap</source>
        <translation>Dvostruko dalje, dvostruko veći razmak</translation>
    </message>
    <message>
        <source>This makes the gap proportional to {0}. The stored number changes with {1}, whose slope is {2}: twice as far needs four times the gap. Look at the stripes with near = 0.1: they widen faster than the distance grows.</source>
        <translation>Ovo čini razmak proporcionalnim s {0}. Spremljeni broj mijenja se s {1}, čiji je nagib {2}: dvostruko dalje traži četverostruki razmak. Pogledajte pruge s bliskom ravninom na 0.1: šire se brže nego što raste udaljenost.</translation>
    </message>
    <message>
        <source>The 16 bits have {0} steps.</source>
        <translation>16 bitova ima {0} koraka.</translation>
    </message>
    <message>
        <source>Share {0} among them: that is {1}, and the gap is {2}.</source>
        <translation>Podijelite {0} na njih: to je {1}, a razmak je {2}.</translation>
    </message>
    <message>
        <source>With near twice as far out, the gap would be about half as large.</source>
        <translation>Kad bi bliska ravnina bila dvostruko dalje, razmak bi bio otprilike upola manji.</translation>
    </message>
    <message>
        <source>Practise: near for a depth</source>
        <translation>Vježba: bliska ravnina za dubinu</translation>
    </message>
    <message>
        <source>Far is {0}, and point 1 is at the distance {1}. Move near until {2} is stored for the point, on the scale from 0 to 1.</source>
        <translation>Daleka ravnina je {0}, a točka 1 na udaljenosti {1}. Pomičite blisku ravninu dok se za točku ne sprema {2}, na ljestvici od 0 do 1.</translation>
    </message>
    <message>
        <source>Solve {0} for {1}; here {2}, {3}, {4}.</source>
        <translation>Riješite {0} po {1}; ovdje je {2}, {3}, {4}.</translation>
    </message>
    <message>
        <source>{0}. Then type it under Near.</source>
        <translation>{0}. Zatim to upišite u polje Bliska ravnina.</translation>
    </message>
    <message>
        <source>You have set {0} to {1}. The buffer begins with 0 at near: it stores {2}. Look at point 1 in the cube: it is at {3}.</source>
        <translation>Postavili ste {0} na {1}. Spremnik počinje s 0 na bliskoj ravnini: sprema {2}. Pogledajte točku 1 u kocki: u {3} je.</translation>
    </message>
</context>
<context>
    <name>l18-interpolation</name>
    <message>
        <source>What is half-way?</source>
        <translation>Što je na pola puta?</translation>
    </message>
    <message>
        <source>Half-way in the picture</source>
        <translation>Na pola puta na slici</translation>
    </message>
    <message>
        <source>A rasteriser knows a quantity {0}, such as a colour or a texture coordinate, at the ends of an edge. It must find {1} at the pixels between. In the Image pane the left edge of the board is marked.</source>
        <translation>Rasterizator zna veličinu {0}, npr. boju ili koordinatu teksture, na krajevima brida. Mora naći {1} u pikselima između. U oknu Slika označen je lijevi brid ploče.</translation>
    </message>
    <message>
        <source>The camera goes down until the far end of the marked edge is four times as deep as the near end. Along the edge, {0} grows evenly from 0 at the near end to 1. What is {1} half-way between the two ends in the *picture*?</source>
        <translation>Kamera se spušta dok daleki kraj označenog brida nije na četiri puta većoj dubini od bližeg. Duž brida {0} raste jednoliko od 0 na bližem kraju do 1. Koliko je {1} na pola puta između dvaju krajeva na *slici*?</translation>
    </message>
    <message>
        <source>This spreads {0} evenly over the picture. The far half of the edge is drawn much shorter than the near half, so the middle of the picture shows a place closer to the near end. Look at the two marks: half-way in the picture is the nearer one.</source>
        <translation>Ovo raspoređuje {0} jednoliko po slici. Dalja polovica brida crta se mnogo kraće od bliže, pa sredina slike pokazuje mjesto bliže bližem kraju. Pogledajte dvije oznake: polovica na slici je ona bliža.</translation>
    </message>
    <message>
        <source>The middle of the *edge* is seen there, four fifths of the way in the picture. The question is about half-way in the picture. Look at the two marks: half-way in the world is the farther one.</source>
        <translation>Ondje se vidi sredina *brida*, na četiri petine puta na slici. Pita se za polovicu na slici. Pogledajte dvije oznake: polovica u svijetu je ona dalja.</translation>
    </message>
    <message>
        <source>The last of the scene&apos;s numbers says 20 %. The far parts are drawn shorter, so four fifths of the edge share the far half of its picture.</source>
        <translation>Posljednji broj scene kaže 20 %. Daleki se dijelovi crtaju kraće, pa četiri petine brida dijele dalju polovicu njegove slike.</translation>
    </message>
    <message>
        <source>One over the depth</source>
        <translation>Jedan kroz dubinu</translation>
    </message>
    <message>
        <source>Two points have depths {0}, {1} and values {2}, {3}. At the share {4} of the way in the picture,</source>
        <translation>Dvije točke imaju dubine {0}, {1} i vrijednosti {2}, {3}. Na udjelu {4} puta na slici je</translation>
    </message>
    <message>
        <source>The edge now begins at 5 and ends at 15. Half-way in the picture {0}, so the place is at the depth 7.5, and {1}. Both diagrams below show straight lines: {2} and the depth {3} may be interpolated directly on the screen.</source>
        <translation>Brid sada počinje na 5 i završava na 15. Na pola puta na slici je {0}, pa je to mjesto na dubini 7.5, i {1}. Oba dijagrama dolje pokazuju pravce: {2} i dubina {3} smiju se na ekranu interpolirati izravno.</translation>
    </message>
    <message>
        <source>A quarter off</source>
        <translation>Pogreška od četvrtine</translation>
    </message>
    <message>
        <source>Now the board is drawn *affine*: {0} itself is interpolated, and the checks bend at the diagonal.</source>
        <translation>Sada je ploča nacrtana *afino*: interpolira se sam {0}, a kvadratići se savijaju na dijagonali.</translation>
    </message>
    <message>
        <source>Move the camera until the point half-way in the picture of the marked edge is at most 25 % along the edge. Then affine is wrong by a quarter of the edge. The edge must stay beyond the near plane.</source>
        <translation>Pomičite kameru dok točka na polovici slike označenog brida ne bude na najviše 25 % brida. Tada afina interpolacija griješi za četvrtinu brida. Brid mora ostati iza bliske ravnine.</translation>
    </message>
    <message>
        <source>One end must be at least three times as deep as the other.</source>
        <translation>Jedan kraj mora biti na bar tri puta većoj dubini od drugog.</translation>
    </message>
    <message>
        <source>Go nearer with Distance, or lower with Elevation. If the board reaches behind near, make Near smaller.</source>
        <translation>Priđite bliže kontrolom Udaljenost ili niže kontrolom Elevacija. Ako ploča seže iza bliske ravnine, primaknite blisku ravninu.</translation>
    </message>
    <message>
        <source>The deeper the edge leads, the larger the error. Choose *correct* under Interpolation and see what moves.</source>
        <translation>Što brid vodi dublje, pogreška je veća. Odaberite *točno* pod Interpolacija i pogledajte što se pomiče.</translation>
    </message>
    <message>
        <source>By the formula</source>
        <translation>Po formuli</translation>
    </message>
    <message>
        <source>The marked edge begins at the depth 5 and ends at 15. A brightness goes from 10 at its near end to 50 at its far end. How bright is it a quarter of the way in the picture, {0}?</source>
        <translation>Označeni brid počinje na dubini 5 i završava na 15. Svjetlina ide od 10 na bližem kraju do 50 na daljem. Kolika je na četvrtini puta na slici, {0}?</translation>
    </message>
    <message>
        <source>This mixes the brightness itself. In the picture only what is divided by the depth changes evenly: divide both ends by their depths, mix, and divide by the mixed {0}. Look at the two marks: half-way in the picture is not half-way along the edge.</source>
        <translation>Ovo miješa samu svjetlinu. Na slici se jednoliko mijenja samo ono što je podijeljeno dubinom: podijelite oba kraja njihovim dubinama, pomiješajte i podijelite s pomiješanim {0}. Pogledajte dvije oznake: polovica na slici nije polovica brida.</translation>
    </message>
    <message>
        <source>Divide both by their depths, mix, and divide by the mixed {0}: {1}.</source>
        <translation>Podijelite oboje njihovim dubinama, pomiješajte i podijelite s pomiješanim {0}: {1}.</translation>
    </message>
    <message>
        <source>First {0} at both ends, then {1} at both ends.</source>
        <translation>Najprije {0} na oba kraja, zatim {1} na oba kraja.</translation>
    </message>
    <message>
        <source>What is the depth of the point a quarter of the way in the picture?</source>
        <translation>Kolika je dubina točke na četvrtini puta na slici?</translation>
    </message>
    <message>
        <source>This mixes the depth itself. In the picture one over the depth changes evenly, not the depth. Look at the two marks: half-way in the picture is nearer than half-way along the edge.</source>
        <translation>Ovo miješa samu dubinu. Na slici se jednoliko mijenja jedan kroz dubinu, a ne dubina. Pogledajte dvije oznake: polovica na slici je bliže nego polovica brida.</translation>
    </message>
    <message>
        <source>Back to half-way</source>
        <translation>Natrag na polovicu</translation>
    </message>
    <message>
        <source>One half was tempting because the picture of a straight edge is straight, and its middle is easy to see. But the division by the depth is not even along the edge: at four times the depth, a piece is drawn a quarter as wide. So half of the picture shows only the nearest fifth. Interpolate the divided quantities, {0} and {1}, and then divide.</source>
        <translation>Polovica je bila primamljiva jer je slika ravnog brida ravna, a sredina joj se lako vidi. Ali dijeljenje s dubinom nije jednoliko duž brida: na četiri puta većoj dubini komad se crta u četvrtini širine. Zato polovica slike pokazuje samo najbližu petinu. Interpolirajte podijeljene veličine, {0} i {1}, a zatim dijelite.</translation>
    </message>
    <message>
        <source>Practise: a value on the way</source>
        <translation>Vježba: vrijednost na putu</translation>
    </message>
    <message>
        <source>Points 1 and 2 are the ends of an edge.</source>
        <translation>Točke 1 i 2 su krajevi brida.</translation>
    </message>
    <message>
        <source>Point 1 is {0} deep and has {1}. Point 2 is {2} deep and has {3}. What is {4} at the share {5} of the way from 1 to 2 in the picture?</source>
        <translation>Točka 1 je na dubini {0} i ima {1}. Točka 2 je na dubini {2} i ima {3}. Koliko je {4} na udjelu {5} puta od 1 do 2 na slici?</translation>
    </message>
    <message>
        <source>This mixes {0} itself. In the picture only the divided quantities change evenly: mix {1} and {2}, then divide. Look at the two marks: half-way in the picture is not half-way along the edge.</source>
        <translation>Ovo miješa sam {0}. Na slici se jednoliko mijenjaju samo podijeljene veličine: pomiješajte {1} i {2}, zatim dijelite. Pogledajte dvije oznake: polovica na slici nije polovica brida.</translation>
    </message>
    <message>
        <source>a/z is a</source>
        <translation>a/z je a</translation>
    </message>
    <message>
        <source>This is {0} at the place, not yet {1}. Divide it by {2} there. Look at the two marks: half-way in the picture is nearer, so {3} counts for more.</source>
        <translation>Ovo je {0} na tom mjestu, još ne {1}. Podijelite ga s {2} ondje. Pogledajte dvije oznake: polovica na slici je bliže, pa {3} vrijedi više.</translation>
    </message>
    <message>
        <source>First {0} and {1} at both ends.</source>
        <translation>Najprije {0} i {1} na oba kraja.</translation>
    </message>
    <message>
        <source>Mix each of them, with {0} at point 1 and {1} at point 2; then divide.</source>
        <translation>Pomiješajte svaki od njih, s {0} kod točke 1 i {1} kod točke 2; zatim dijelite.</translation>
    </message>
    <message>
        <source>Point 1 is nearer, so its value counts for more than its share of the way.</source>
        <translation>Točka 1 je bliža, pa njezina vrijednost vrijedi više od svojega udjela puta.</translation>
    </message>
    <message>
        <source>Practise: a depth on the way</source>
        <translation>Vježba: dubina na putu</translation>
    </message>
    <message>
        <source>A thin rod, drawn in colour, begins at point 1 and ends at point 2.</source>
        <translation>Tanak štap, nacrtan u boji, počinje u točki 1 i završava u točki 2.</translation>
    </message>
    <message>
        <source>Point 1 is {0} deep, point 2 is {1} deep. How deep is the place that is seen at the share {2} of the way from 1 to 2 in the picture?</source>
        <translation>Točka 1 je na dubini {0}, točka 2 na dubini {1}. Na kojoj je dubini mjesto koje se vidi na udjelu {2} puta od 1 do 2 na slici?</translation>
    </message>
    <message>
        <source>This mixes the depth itself. In the picture {0} changes evenly, not {1}. Look from above at point 3, half-way in the picture: it is closer to point 1 than to point 2.</source>
        <translation>Ovo miješa samu dubinu. Na slici se jednoliko mijenja {0}, a ne {1}. Pogledajte odozgo točku 3, na pola puta na slici: bliža je točki 1 nego točki 2.</translation>
    </message>
    <message>
        <source>The way begins at point 2</source>
        <translation>Put počinje u točki 2</translation>
    </message>
    <message>
        <source>This goes from point 2 to point 1: at {0} the place must be point 1. Look from above: point 1 is the nearer one.</source>
        <translation>Ovo ide od točke 2 do točke 1: kod {0} mjesto mora biti točka 1. Pogledajte odozgo: točka 1 je bliža.</translation>
    </message>
    <message>
        <source>What changes evenly in the picture is {0}.</source>
        <translation>Na slici se jednoliko mijenja {0}.</translation>
    </message>
    <message>
        <source>The place {0} of the way along the rod itself is deeper: {1}.</source>
        <translation>Mjesto na {0} puta po samom štapu je dublje: {1}.</translation>
    </message>
    <message>
        <source>Practise: the middle of a rod</source>
        <translation>Vježba: sredina štapa</translation>
    </message>
    <message>
        <source>Point 1 is {0} deep, point 2 is {1} deep. Mark where the picture shows the middle of the rod.</source>
        <translation>Točka 1 je na dubini {0}, točka 2 na dubini {1}. Označite gdje slika pokazuje sredinu štapa.</translation>
    </message>
    <message>
        <source>This is the middle of the picture of the rod. The far half of the rod is drawn shorter than the near half, so the middle of the rod is seen closer to point 2. Look from above at point 3, which you have marked: it is closer to point 1 than to point 2.</source>
        <translation>To je sredina slike štapa. Dalja polovica štapa crta se kraće od bliže, pa se sredina štapa vidi bliže točki 2. Pogledajte odozgo točku 3, koju ste označili: bliža je točki 1 nego točki 2.</translation>
    </message>
    <message>
        <source>The near half is the short one</source>
        <translation>Bliža polovica je kraća</translation>
    </message>
    <message>
        <source>This is as far from point 1 as the middle is from point 2. The near half of the rod is drawn longer, so the middle is seen closer to point 2. Look from above: point 1 is the nearer one.</source>
        <translation>Ovo je od točke 1 daleko koliko je sredina od točke 2. Bliža polovica štapa crta se dulje, pa se sredina vidi bliže točki 2. Pogledajte odozgo: točka 1 je bliža.</translation>
    </message>
    <message>
        <source>At the middle of the rod, {0} is {1}. At which share {2} of the way in the picture is that?</source>
        <translation>U sredini štapa {0} je {1}. Na kojem je udjelu {2} puta na slici to?</translation>
    </message>
    <message>
        <source>{0}, seen from point 1.</source>
        <translation>{0}, gledano od točke 1.</translation>
    </message>
    <message>
        <source>It is seen at the share {0} of the way from point 1.</source>
        <translation>Vidi se na udjelu {0} puta od točke 1.</translation>
    </message>
</context>
<context>
    <name>l19-planar-shadow</name>
    <message>
        <source>Where does the shadow fall?</source>
        <translation>Kamo pada sjena?</translation>
    </message>
    <message>
        <source>A lamp instead of the sun</source>
        <translation>Svjetiljka umjesto sunca</translation>
    </message>
    <message>
        <source>The sun is in the direction {0}. The corner {1} at the top of the F has its shadow at {2}.</source>
        <translation>Sunce je u smjeru {0}. Vrh {1} na gornjem dijelu slova F ima sjenu u {2}.</translation>
    </message>
    <message>
        <source>A lamp at the point {0} takes the place of the sun. At which {1} is the shadow of {2}?</source>
        <translation>Mjesto sunca zauzima svjetiljka u točki {0}. U kojem je {1} sjena točke {2}?</translation>
    </message>
    <message>
        <source>at 3, as before</source>
        <translation>u 3, kao prije</translation>
    </message>
    <message>
        <source>This takes the three numbers for a direction that all rays share, as the sun&apos;s are. Of a lamp they are a place: its ray through {0} runs from that place, flatter than the sun&apos;s. Look at the ray: it begins at the lamp.</source>
        <translation>Ovo uzima tri broja kao smjer koji dijele sve zrake, kao kod sunca. Kod svjetiljke oni su mjesto: njezina zraka kroz {0} polazi s tog mjesta, položitije od sunčeve. Pogledajte zraku: počinje u svjetiljci.</translation>
    </message>
    <message>
        <source>at 6</source>
        <translation>u 6</translation>
    </message>
    <message>
        <source>at 1.5, below P</source>
        <translation>u 1.5, ispod P</translation>
    </message>
    <message>
        <source>It would be there if the lamp were directly above {0}. This lamp is 4.5 to the left of {1}. Look at this lamp, which is directly above {2}.</source>
        <translation>Bila bi ondje da je svjetiljka točno iznad {0}. Ova je svjetiljka 4.5 lijevo od {1}. Pogledajte ovu svjetiljku, koja je točno iznad {2}.</translation>
    </message>
    <message>
        <source>From the lamp to {0} the ray goes 4.5 to the right and 5 down; to the ground it is 10 down, so 9 to the right.</source>
        <translation>Od svjetiljke do {0} zraka ide 4.5 udesno i 5 dolje; do tla je 10 dolje, dakle 9 udesno.</translation>
    </message>
    <message>
        <source>A projection from the light</source>
        <translation>Projekcija iz svjetla</translation>
    </message>
    <message>
        <source>A shadow is a projection: the light {0} is its centre, and the ground is its picture plane. The ray from {1} through {2} meets {3} at</source>
        <translation>Sjena je projekcija: svjetlo {0} je njezin centar, a tlo ravnina slike. Zraka iz {1} kroz {2} siječe {3} u</translation>
    </message>
    <message>
        <source>With {0} that is {1}, as the scene&apos;s numbers say. As a matrix it is {2} with the plane {3}, and the F is drawn once more under {4}, in one colour. For the sun {5} has {6} and the rays are parallel.</source>
        <translation>Uz {0} to je {1}, kako kažu brojevi scene. Kao matrica to je {2} s ravninom {3}, a F se crta još jednom pod {4}, u jednoj boji. Za sunce {5} ima {6} i zrake su paralelne.</translation>
    </message>
    <message>
        <source>Put the shadow there</source>
        <translation>Stavite sjenu onamo</translation>
    </message>
    <message>
        <source>Move the lamp until the shadow of {0} is at {1}. It must stay a lamp, and above {2}.</source>
        <translation>Pomičite svjetiljku dok sjena točke {0} ne bude u {1}. Mora ostati svjetiljka, i to iznad {2}.</translation>
    </message>
    <message>
        <source>Drag the lamp in the World pane, or type under Light L.</source>
        <translation>Povucite svjetiljku u oknu Svijet ili upišite pod Svjetlo L.</translation>
    </message>
    <message>
        <source>A higher lamp casts a shorter shadow. At {0} it must be 11.4 high.</source>
        <translation>Viša svjetiljka baca kraću sjenu. Kod {0} mora biti na visini 11.4.</translation>
    </message>
    <message>
        <source>Any lamp on a line from {0} through {1} will do.</source>
        <translation>Odgovara svaka svjetiljka na pravcu od {0} kroz {1}.</translation>
    </message>
    <message>
        <source>By the formula</source>
        <translation>Po formuli</translation>
    </message>
    <message>
        <source>You see the shadow that the *sun* casts from the direction {0}. Where, in {1}, would the shadow of {2} be with a *lamp* at the point {3}?</source>
        <translation>Vidite sjenu koju baca *sunce* iz smjera {0}. Gdje bi, po {1}, bila sjena točke {2} uz *svjetiljku* u točki {3}?</translation>
    </message>
    <message>
        <source>This is the sun&apos;s shadow, the one that you see. The lamp&apos;s ray has another direction: from the lamp to {0} it goes 7.5 to the right and 3 down. Look at the ray: it begins at the lamp.</source>
        <translation>To je sunčeva sjena, ona koju vidite. Zraka svjetiljke ima drugi smjer: od svjetiljke do {0} ide 7.5 udesno i 3 dolje. Pogledajte zraku: počinje u svjetiljci.</translation>
    </message>
    <message>
        <source>{0} is 7.5 to the right of {1} and 3 below it. How far down is the ground?</source>
        <translation>{0} je 7.5 desno od {1} i 3 ispod. Koliko je dolje tlo?</translation>
    </message>
    <message>
        <source>The plane moves down to {0}, so {1}. What is the cell of the lamp&apos;s matrix in row 1, column 1, {2}?</source>
        <translation>Ravnina se spušta na {0}, pa je {1}. Koja je ćelija matrice svjetiljke u retku 1, stupcu 1, {2}?</translation>
    </message>
    <message>
        <source>This is {0} of the sun, whose {1} is 0. A lamp has {2}, so the 2 of the plane counts too. Look at the lamp and the plane: the plane is 2 lower than before.</source>
        <translation>To je {0} sunca, čiji je {1} jednak 0. Svjetiljka ima {2}, pa se računa i 2 iz ravnine. Pogledajte svjetiljku i ravninu: ravnina je za 2 niže nego prije.</translation>
    </message>
    <message>
        <source>{0} is the height of the lamp above the plane. For the sun, with {1}, the height of the plane would not matter.</source>
        <translation>{0} je visina svjetiljke iznad ravnine. Za sunce, s {1}, visina ravnine ne bi bila važna.</translation>
    </message>
    <message>
        <source>Back to the lamp</source>
        <translation>Natrag na svjetiljku</translation>
    </message>
    <message>
        <source>The sun and the lamp had the same three numbers, so it was tempting to let the shadow stay. But the sun&apos;s numbers are a direction, the same for every point of the F. The lamp&apos;s numbers are a position, and the direction of a ray is {0}: the higher a point is, the flatter the ray and the longer its shadow. Change *Kind of light* and watch the top of the F, then its foot.</source>
        <translation>Sunce i svjetiljka imali su ista tri broja, pa je bilo primamljivo sjenu ostaviti na mjestu. Ali brojevi sunca su smjer, isti za svaku točku slova F. Brojevi svjetiljke su položaj, a smjer zrake je {0}: što je točka viša, to je zraka položitija i sjena dulja. Promijenite *Vrsta svjetla* i promatrajte vrh slova F, zatim njegovo podnožje.</translation>
    </message>
    <message>
        <source>Practise: a lamp&apos;s shadow</source>
        <translation>Vježba: sjena svjetiljke</translation>
    </message>
    <message>
        <source>A lamp {0} shines on {1}, the corner at the top right of the F. The ground is {2}.</source>
        <translation>Svjetiljka {0} obasjava {1}, gornji desni vrh slova F. Tlo je {2}.</translation>
    </message>
    <message>
        <source>The lamp is at {0}, and {1} is at {2}. At which {3} is the shadow of {4}?</source>
        <translation>Svjetiljka je u {0}, a {1} u {2}. U kojem je {3} sjena točke {4}?</translation>
    </message>
    <message>
        <source>This takes the lamp&apos;s place for the sun&apos;s direction. The ray through {0} begins at the lamp: its direction is {1}. Look at the sun&apos;s ray through {2}: it has another direction.</source>
        <translation>Ovo uzima mjesto svjetiljke kao smjer sunca. Zraka kroz {0} počinje u svjetiljci: smjer joj je {1}. Pogledajte sunčevu zraku kroz {2}: ima drugi smjer.</translation>
    </message>
    <message>
        <source>The ray begins at P</source>
        <translation>Zraka počinje u P</translation>
    </message>
    <message>
        <source>This begins at {0}. The ray begins at the lamp and comes down by the whole height of the lamp, so begin at {1}. Look at the ray: it begins at the lamp.</source>
        <translation>Ovo počinje u {0}. Zraka počinje u svjetiljci i spušta se za cijelu visinu svjetiljke, zato počnite od {1}. Pogledajte zraku: počinje u svjetiljci.</translation>
    </message>
    <message>
        <source>From {0} to {1} the ray comes down by {2}. By how much from {3} to the ground?</source>
        <translation>Od {0} do {1} zraka se spušta za {2}. Za koliko od {3} do tla?</translation>
    </message>
    <message>
        <source>To the right it goes {0} from {1} to {2}, and in proportion farther to the ground.</source>
        <translation>Udesno ide {0} od {1} do {2}, a razmjerno dalje do tla.</translation>
    </message>
    <message>
        <source>From {0} the ray goes on to the right by {1}, in the ratio of 5 to {2}.</source>
        <translation>Od {0} zraka ide dalje udesno za {1}, u omjeru 5 prema {2}.</translation>
    </message>
    <message>
        <source>Practise: a row of S</source>
        <translation>Vježba: redak matrice S</translation>
    </message>
    <message>
        <source>{0}, with the lamp {1} and the plane {2}.</source>
        <translation>{0}, sa svjetiljkom {1} i ravninom {2}.</translation>
    </message>
    <message>
        <source>The lamp is at {0} and the plane is {1}. What is the first row of {2}?</source>
        <translation>Svjetiljka je u {0}, a ravnina je {1}. Koji je prvi redak matrice {2}?</translation>
    </message>
    <message>
        <source>{0} holds for the sun, whose {1} is 0. A lamp has {2}, so {3}, its height above the plane. Look at the lamp and the plane: the plane is lower than {4}.</source>
        <translation>{0} vrijedi za sunce, čiji je {1} jednak 0. Svjetiljka ima {2}, pa je {3}, njezina visina iznad ravnine. Pogledajte svjetiljku i ravninu: ravnina je niže od {4}.</translation>
    </message>
    <message>
        <source>This takes {0} for {1}. The first row of {2} is {3} times {4}. Look at {5} and {6}: {7} of the shadow depends on the height of {8}.</source>
        <translation>Ovo uzima {0} umjesto {1}. Prvi redak od {2} je {3} puta {4}. Pogledajte {5} i {6}: {7} sjene ovisi o visini točke {8}.</translation>
    </message>
    <message>
        <source>The plane ends in h</source>
        <translation>Ravnina završava na h</translation>
    </message>
    <message>
        <source>This takes {0}. The plane {1} has {2}, so its last number is {3}. Look at the lamp and the plane: the plane is lower than {4}, so the lamp is higher above it.</source>
        <translation>Ovo uzima {0}. Ravnina {1} ima {2}, pa joj je posljednji broj {3}. Pogledajte svjetiljku i ravninu: ravnina je niže od {4}, pa je svjetiljka više iznad nje.</translation>
    </message>
    <message>
        <source>First {0}, which stands only in the first cell of this row of {1}.</source>
        <translation>Najprije {0}, koje stoji samo u prvoj ćeliji ovog retka od {1}.</translation>
    </message>
    <message>
        <source>Then subtract {0} times {1}.</source>
        <translation>Zatim oduzmite {0} puta {1}.</translation>
    </message>
    <message>
        <source>The first cell is the lamp&apos;s height above the plane.</source>
        <translation>Prva ćelija je visina svjetiljke iznad ravnine.</translation>
    </message>
    <message>
        <source>Practise: where on the ground?</source>
        <translation>Vježba: gdje na tlu?</translation>
    </message>
    <message>
        <source>You look down from above: {0} runs to the right, {1} runs down. The squares of the grid are 1 wide, the middle of the F is at {2}, {3}, and point 2 is at {4}.</source>
        <translation>Gledate odozgo: {0} ide udesno, {1} ide prema dolje. Kvadrati rešetke široki su 1, sredina slova F je u {2}, {3}, a točka 2 u {4}.</translation>
    </message>
    <message>
        <source>You see the shadow of the sun in the direction {0}. Mark where the shadow of point 1, {1}, is with a *lamp* at the point {2}.</source>
        <translation>Vidite sjenu sunca u smjeru {0}. Označite gdje je sjena točke 1, {1}, uz *svjetiljku* u točki {2}.</translation>
    </message>
    <message>
        <source>This is the sun&apos;s shadow, the one that you see. The lamp&apos;s ray through {0} begins at {1}: its direction is {2}. Look from the side: every ray begins at the lamp.</source>
        <translation>To je sunčeva sjena, ona koju vidite. Zraka svjetiljke kroz {0} počinje u {1}: smjer joj je {2}. Pogledajte sa strane: svaka zraka počinje u svjetiljci.</translation>
    </message>
    <message>
        <source>From {0} to {1} the ray comes down by {2}, to the ground by {3}.</source>
        <translation>Od {0} do {1} zraka se spušta za {2}, do tla za {3}.</translation>
    </message>
    <message>
        <source>The shadow is at {0}.</source>
        <translation>Sjena je u {0}.</translation>
    </message>
    <message>
        <source>The shadow is at {0}, {1}.</source>
        <translation>Sjena je u {0}, {1}.</translation>
    </message>
</context>
<context>
    <name>l20-zoom-or-walk</name>
    <message>
        <source>Zoom or walk?</source>
        <translation>Zumirati ili hodati?</translation>
    </message>
    <message>
        <source>Three times as far</source>
        <translation>Triput dalje</translation>
    </message>
    <message>
        <source>A wide lens, 29 mm, is close to a head. One unit is 10 cm, so the camera is 30 cm away. The two squares are equally large, one at the nearest part of the head and one at the farthest. In the picture the near one is 1.67 times as large as the far one.</source>
        <translation>Širokokutni objektiv, 29 mm, blizu je glave. Jedna jedinica je 10 cm, pa je kamera udaljena 30 cm. Dva su kvadrata jednako velika, jedan kod najbližeg dijela glave, a drugi kod najudaljenijeg. Na slici je bliži 1.67 puta veći od daljeg.</translation>
    </message>
    <message>
        <source>The camera goes back to three times the distance and zooms until the head is as high in the picture as before. How do the two squares compare then?</source>
        <translation>Kamera se odmiče na triput veću udaljenost i zumira dok glava na slici ne bude visoka kao prije. Kako se tada odnose dva kvadrata?</translation>
    </message>
    <message>
        <source>as before, 1.67 times: the head keeps its size</source>
        <translation>kao prije, 1.67 puta: glava zadržava veličinu</translation>
    </message>
    <message>
        <source>The zoom enlarges both squares by the same factor, so it does not change how they compare. Going back does: both are now 6 units deeper, and their depths are more alike. Look at the two squares in both pictures.</source>
        <translation>Zum povećava oba kvadrata istim faktorom, pa ne mijenja njihov odnos. Odmicanje ga mijenja: oba su sada za 6 jedinica dublje, a dubine su im sličnije. Pogledajte dva kvadrata na objema slikama.</translation>
    </message>
    <message>
        <source>30 cm</source>
        <translation>30 cm</translation>
    </message>
    <message>
        <source>90 cm</source>
        <translation>90 cm</translation>
    </message>
    <message>
        <source>the near one is less than 1.67 times as large</source>
        <translation>bliži je manje od 1.67 puta veći</translation>
    </message>
    <message>
        <source>the near one is more than 1.67 times as large</source>
        <translation>bliži je više od 1.67 puta veći</translation>
    </message>
    <message>
        <source>That happens when you go *nearer*: there the same difference in depth matters more. Look at the two squares from nearer by.</source>
        <translation>To se događa kad priđete *bliže*: ondje ista razlika u dubini više znači. Pogledajte dva kvadrata izbliza.</translation>
    </message>
    <message>
        <source>21 cm</source>
        <translation>21 cm</translation>
    </message>
    <message>
        <source>It is 1.19 times now. Both depths have grown by the same 6 units, so their ratio is closer to 1.</source>
        <translation>Sada je 1.19 puta. Obje su dubine porasle za istih 6 jedinica, pa im je omjer bliži 1.</translation>
    </message>
    <message>
        <source>Two photographs of one head</source>
        <translation>Dvije fotografije iste glave</translation>
    </message>
    <message>
        <source>The lecture photographs a cat at 29 mm from 30 cm, and at 105 mm. On the film a thing is {0} times its real size, so it keeps its size if</source>
        <translation>U predavanju se mačka fotografira objektivom od 29 mm s 30 cm i objektivom od 105 mm. Veličina stvari na filmu je {0} puta njezina prava veličina, pa ostaje ista ako je</translation>
    </message>
    <message>
        <source>From 360 cm it would be only 0.30 times as large and would have to be enlarged.</source>
        <translation>S 360 cm njezina bi veličina bila samo 0.30 te veličine, pa bi se morala povećati.</translation>
    </message>
    <message>
        <source>The squares are {0} cm apart. The near one is drawn {1} times as large as the far one, with its own distance {2}: from 30 cm {3} times, from 108.6 cm {4} times. This camera is at 108.6 cm; under *More numbers* its focal length is 105 mm.</source>
        <translation>Kvadrati su razmaknuti {0} cm. Bliži je nacrtan {1} puta veći od daljega, gdje je {2} njegova vlastita udaljenost: s 30 cm {3} puta, sa 108.6 cm {4} puta. Ova je kamera na 108.6 cm; pod *Još brojeva* žarišna joj je duljina 105 mm.</translation>
    </message>
    <message>
        <source>Walk, and keep the head</source>
        <translation>Hodajte i zadržite glavu</translation>
    </message>
    <message>
        <source>Go to three times the distance from the target, and keep the head as high in the picture as it is, 551 px.</source>
        <translation>Odmaknite se na triput veću udaljenost od cilja i zadržite visinu glave na slici, 551 px.</translation>
    </message>
    <message>
        <source>Sizes at the target are proportional to {0}.</source>
        <translation>Veličine kod cilja proporcionalne su s {0}.</translation>
    </message>
    <message>
        <source>The slider *Distance, relative to the preset* changes both at once; Distance and Field of view change one each.</source>
        <translation>Klizač *Udaljenost u odnosu na gotovu postavku* mijenja oboje odjednom; Udaljenost i Vidno polje mijenjaju svaki po jedno.</translation>
    </message>
    <message>
        <source>The head has kept its height, but its nose has not kept its size.</source>
        <translation>Glava je zadržala visinu, ali nos nije zadržao veličinu.</translation>
    </message>
    <message>
        <source>By the formula</source>
        <translation>Po formuli</translation>
    </message>
    <message>
        <source>A statue is photographed from 2 m with a 50-mm lens on film 36 mm wide. From how many metres is it as large with an 85-mm lens?</source>
        <translation>Kip je fotografiran s 2 m objektivom od 50 mm na film širok 36 mm. S koliko je metara jednako velik uz objektiv od 85 mm?</translation>
    </message>
    <message>
        <source>The angle is the size</source>
        <translation>Kut je veličina</translation>
    </message>
    <message>
        <source>This takes the angle of view for the size. On the film the statue&apos;s height is proportional to the focal length over the distance, to {0}; the angle is not proportional to {1}. Look at the two photographs: 105 mm are 3.62 times 29 mm, and from 3.62 times as far away the head is equally high.</source>
        <translation>Ovo uzima vidni kut kao veličinu. Na filmu je visina kipa proporcionalna omjeru žarišne duljine i udaljenosti, {0}; kut nije proporcionalan s {1}. Pogledajte dvije fotografije: 105 mm je 3.62 puta 29 mm, a s 3.62 puta veće udaljenosti glava je jednako visoka.</translation>
    </message>
    <message>
        <source>The image on the film is as large as before. What happened to {0}?</source>
        <translation>Slika na filmu velika je kao prije. Što se dogodilo s {0}?</translation>
    </message>
    <message>
        <source>Sizes are proportional to {0}, so {1} is proportional to {2}. The angles of view, 39.6° and 23.9°, are no measure of size.</source>
        <translation>Veličine su proporcionalne s {0}, pa je {1} proporcionalno s {2}. Vidni kutovi, 39.6° i 23.9°, nisu mjera veličine.</translation>
    </message>
    <message>
        <source>Another statue of the same height is 1 m behind the first. From 2 m the first looks 1.5 times as high as the second. How many times as high does it look from 5 m, with a zoom that keeps the size of the first?</source>
        <translation>Drugi kip iste visine je 1 m iza prvoga. S 2 m prvi izgleda 1.5 puta viši od drugoga. Koliko puta viši izgleda s 5 m, uz zum koji zadržava veličinu prvoga?</translation>
    </message>
    <message>
        <source>This keeps the ratio that was seen from 2 m. The zoom enlarges both statues alike; only their distances, 5 m and 6 m, decide how they compare. Look at the two squares in both pictures: they compare differently.</source>
        <translation>Ovo zadržava omjer koji se vidio s 2 m. Zum jednako povećava oba kipa; o njihovu odnosu odlučuju samo njihove udaljenosti, 5 m i 6 m. Pogledajte dva kvadrata na objema slikama: odnos im je različit.</translation>
    </message>
    <message>
        <source>The size of each statue is proportional to one over its own distance.</source>
        <translation>Veličina svakog kipa proporcionalna je s jedan kroz njegovu vlastitu udaljenost.</translation>
    </message>
    <message>
        <source>{0} with the new {1}. The zoom enlarges both by the same factor.</source>
        <translation>{0} s novim {1}. Zum oba povećava istim faktorom.</translation>
    </message>
    <message>
        <source>Back to the head</source>
        <translation>Natrag na glavu</translation>
    </message>
    <message>
        <source>It is tempting to say that nothing changes, because the head keeps its size, and a zoom is made for this. But the zoom keeps sizes at only one depth, the target&apos;s. In front of it and behind it, sizes are proportional to one over *their* distance, and walking has changed that. So a portrait from close by has a large nose with any lens: the distance determines the perspective; the lens only selects a part of it.</source>
        <translation>Primamljivo je reći da se ništa ne mijenja, jer glava zadržava veličinu, a zum je tome i namijenjen. Ali zum čuva veličine samo na jednoj dubini, dubini cilja. Ispred njega i iza njega veličine su proporcionalne s jedan kroz *svoju* udaljenost, a hodanje ju je promijenilo. Zato portret izbliza ima velik nos uz svaki objektiv: udaljenost određuje perspektivu; objektiv samo bira njezin dio.</translation>
    </message>
    <message>
        <source>Practise: as large with another lens</source>
        <translation>Vježba: jednako veliko drugim objektivom</translation>
    </message>
    <message>
        <source>The head is photographed from {0} cm with a lens of {1} mm, on film 36 mm wide. From how many cm is it as large with {2} mm?</source>
        <translation>Glava je fotografirana s {0} cm objektivom od {1} mm, na film širok 36 mm. S koliko je cm jednako velika uz {2} mm?</translation>
    </message>
    <message>
        <source>This takes the angle of view for the size. On the film the head is {0} times as large as it is; the angle of view is no measure of that. Look at the head from here with {1} mm: it is {2} times as large.</source>
        <translation>Ovo uzima vidni kut kao veličinu. Veličina glave na filmu je {0} puta njezina prava veličina; vidni kut nije mjera za to. Pogledajte glavu odavde s {1} mm: {2} puta je veća.</translation>
    </message>
    <message>
        <source>A longer lens goes nearer</source>
        <translation>Dulji objektiv ide bliže</translation>
    </message>
    <message>
        <source>From there the head would be larger still. A longer lens enlarges, so the camera must go back. Look at the head from here with {0} mm: it is larger already.</source>
        <translation>Odande bi glava bila još veća. Dulji objektiv povećava, pa se kamera mora odmaknuti. Pogledajte glavu odavde s {0} mm: već je veća.</translation>
    </message>
    <message>
        <source>On the film, the head is {0} times as large as it is.</source>
        <translation>Veličina glave na filmu je {0} puta njezina prava veličina.</translation>
    </message>
    <message>
        <source>{0} must be equal to {1}: a longer lens needs a distance longer by the same factor.</source>
        <translation>{0} mora biti jednako {1}: dulji objektiv treba za isti faktor veću udaljenost.</translation>
    </message>
    <message>
        <source>Practise: two squares</source>
        <translation>Vježba: dva kvadrata</translation>
    </message>
    <message>
        <source>The near square is {0} from the eye; the far one is as large and {1} behind it. So the near one is drawn {2} times as large. How many times as large is it drawn from {3}, with a zoom that keeps its size?</source>
        <translation>Bliži kvadrat je {0} od kamere; dalji je jednako velik i {1} iza njega. Zato je bliži nacrtan {2} puta veći od daljega. Koliko je puta veći nacrtan s {3}, uz zum koji zadržava njegovu veličinu?</translation>
    </message>
    <message>
        <source>This keeps the ratio that is seen from {0}. The zoom enlarges both squares alike; only their distances decide how they compare. Look from the side: the camera is now {1} from the near square.</source>
        <translation>Ovo zadržava omjer koji se vidi s {0}. Zum jednako povećava oba kvadrata; o njihovu odnosu odlučuju samo udaljenosti. Pogledajte sa strane: kamera je sada {1} od bližeg kvadrata.</translation>
    </message>
    <message>
        <source>The zoom makes them equal</source>
        <translation>Zum ih izjednačuje</translation>
    </message>
    <message>
        <source>They would look equal only from infinitely far away. The far one is always 1.2 farther away. Look from the side: the far one is still farther away.</source>
        <translation>Jednako bi izgledali samo s beskonačne udaljenosti. Dalji je uvijek 1.2 dalje. Pogledajte sa strane: dalji je i dalje udaljeniji.</translation>
    </message>
    <message>
        <source>Each square is drawn as large as one over its own distance.</source>
        <translation>Nacrtana veličina svakog kvadrata proporcionalna je s jedan kroz njegovu udaljenost.</translation>
    </message>
    <message>
        <source>The near one is now {0} away. And the far one?</source>
        <translation>Bliži je sada udaljen {0}. A dalji?</translation>
    </message>
    <message>
        <source>The zoom enlarges both by the same factor, so only the distances count.</source>
        <translation>Zum oba povećava istim faktorom, pa se računaju samo udaljenosti.</translation>
    </message>
    <message>
        <source>Practise: a chosen ratio</source>
        <translation>Vježba: zadani omjer</translation>
    </message>
    <message>
        <source>The near square is 0.64 in front of the target, the far square, as large, is 0.56 behind it.</source>
        <translation>Bliži kvadrat je 0.64 ispred cilja, a dalji, jednako velik, 0.56 iza njega.</translation>
    </message>
    <message>
        <source>Move the camera until the near square is drawn {0} times as large as the far one, and keep the head as high in the picture as it is now.</source>
        <translation>Pomičite kameru dok bliži kvadrat ne bude nacrtan {0} puta veći od daljega, i zadržite visinu glave na slici kakva je sada.</translation>
    </message>
    <message>
        <source>From the near square to the far one it is {0}. At the distance {1} of the near square, the ratio is {2}.</source>
        <translation>Od bližeg kvadrata do daljega je {0}. Na udaljenosti {1} bližeg kvadrata omjer je {2}.</translation>
    </message>
    <message>
        <source>So the near square must be at {0}, and the target 0.64 farther away.</source>
        <translation>Zato bliži kvadrat mora biti na {0}, a cilj 0.64 dalje.</translation>
    </message>
    <message>
        <source>The slider *Distance, relative to the preset* keeps the size of the head.</source>
        <translation>Klizač *Udaljenost u odnosu na gotovu postavku* zadržava veličinu glave.</translation>
    </message>
    <message>
        <source>{0} {1} {2} for the near square. The target is 0.64 farther: {3}.</source>
        <translation>{0} {1} {2} za bliži kvadrat. Cilj je 0.64 dalje: {3}.</translation>
    </message>
    <message>
        <source>A zoom enlarges both squares alike; only the distance changes how they compare. Look at both pictures: the squares compare in the same way.</source>
        <translation>Zum jednako povećava oba kvadrata; njihov odnos mijenja samo udaljenost. Pogledajte obje slike: odnos kvadrata je isti.</translation>
    </message>
    <message>
        <source>from here, 90°</source>
        <translation>odavde, 90°</translation>
    </message>
</context>
<context>
    <name>l21-camera-obscura</name>
    <message>
        <source>Why upside down?</source>
        <translation>Zašto naopačke?</translation>
    </message>
    <message>
        <source>Behind the eye</source>
        <translation>Iza kamere</translation>
    </message>
    <message>
        <source>The plane of projection is 4 units in front of the eye. The corner {0}, at the top of the F, is 2.472 above the axis and 9.601 deep; its image is 1.03 above the axis. The World pane shows it from the side.</source>
        <translation>Ravnina projekcije je 4 jedinice ispred kamere. Vrh {0}, na gornjem dijelu slova F, je 2.472 iznad osi i na dubini 9.601; njegova je slika 1.03 iznad osi. Okno Svijet pokazuje to sa strane.</translation>
    </message>
    <message>
        <source>The plane moves to the other side, 4 units *behind* the eye, like the film in a camera obscura. Where is the image of {0} on it, along {1}?</source>
        <translation>Ravnina se premješta na drugu stranu, 4 jedinice *iza* kamere, kao film u cameri obscuri. Gdje je na njoj slika točke {0}, duž {1}?</translation>
    </message>
    <message>
        <source>at 1.03: still above the axis</source>
        <translation>na 1.03: i dalje iznad osi</translation>
    </message>
    <message>
        <source>The film keeps up what is up</source>
        <translation>Na filmu gore ostaje gore</translation>
    </message>
    <message>
        <source>This keeps the sign of a plane in front. Light goes straight through the eye, so what is above the axis in front of it is below the axis behind it. Look at P&apos;, behind the eye: it is below the axis.</source>
        <translation>Ovo zadržava predznak ravnine ispred. Svjetlo ide ravno kroz kameru, pa je ono što je ispred nje iznad osi, iza nje ispod osi. Pogledajte P&apos;, iza kamere: ispod osi je.</translation>
    </message>
    <message>
        <source>at −1.03: below the axis</source>
        <translation>na −1.03: ispod osi</translation>
    </message>
    <message>
        <source>there is none: light does not go backwards</source>
        <translation>nema je: svjetlo ne ide unatrag</translation>
    </message>
    <message>
        <source>It goes straight on through the eye and meets the plane behind it. Look at the projector: it goes through the eye to P&apos;.</source>
        <translation>Ono ide ravno dalje kroz kameru i nailazi na ravninu iza nje. Pogledajte zraku projiciranja: ide kroz kameru do P&apos;.</translation>
    </message>
    <message>
        <source>The projector goes on through the eye, and crosses the axis there.</source>
        <translation>Zraka projiciranja ide dalje kroz kameru i ondje siječe os.</translation>
    </message>
    <message>
        <source>Two films</source>
        <translation>Dva filma</translation>
    </message>
    <message>
        <source>In the dark box, light goes through a hole, the centre of projection. The image of a thing of height {0} at the distance {1} in front of the hole has the height</source>
        <translation>U mračnoj kutiji svjetlo prolazi kroz rupicu, centar projekcije. Slika stvari visine {0} na udaljenosti {1} ispred rupice ima visinu</translation>
    </message>
    <message>
        <source>on the film, {0} behind the hole. Here {1}, {2} and {3}: {4}. The minus turns the image upside down and exchanges left and right. The lecture&apos;s synthetic camera has its film at the same distance in front of the centre. There the image is {5} high: as large, and upright.</source>
        <translation>na filmu, {0} iza rupice. Ovdje je {1}, {2} i {3}: {4}. Minus okreće sliku naopačke i zamjenjuje lijevo i desno. Sintetička kamera iz predavanja ima film na istoj udaljenosti ispred centra. Ondje je slika visoka {5}: jednako velika, i uspravna.</translation>
    </message>
    <message>
        <source>A quarter, upside down</source>
        <translation>Četvrtina, naopačke</translation>
    </message>
    <message>
        <source>Put the plane behind the eye so that the image of {0} is upside down and a quarter as far from the axis as {1} itself.</source>
        <translation>Stavite ravninu iza kamere tako da slika točke {0} bude naopačke i na četvrtini udaljenosti same točke {1} od osi.</translation>
    </message>
    <message>
        <source>The scale is {0}, and {1} is the depth of {2}.</source>
        <translation>Mjerilo je {0}, a {1} je dubina točke {2}.</translation>
    </message>
    <message>
        <source>Type a negative Plane distance d. A quarter of 9.601 is 2.4.</source>
        <translation>Upišite negativan broj u Udaljenost ravnine d. Četvrtina od 9.601 je 2.4.</translation>
    </message>
    <message>
        <source>The scale is −0.25: a quarter as large, and turned over by the minus.</source>
        <translation>Mjerilo je −0.25: četvrtina veličine, a minus je okreće.</translation>
    </message>
    <message>
        <source>By the formula</source>
        <translation>Po formuli</translation>
    </message>
    <message>
        <source>The arrow is 5 high and 9 in front of the hole. The film moves to 6 behind the hole. How high is the arrow&apos;s image on the film, with its sign?</source>
        <translation>Strelica je visoka 5 i stoji 9 ispred rupice. Film se pomiče na 6 iza rupice. Kolika je visina slike strelice na filmu, s predznakom?</translation>
    </message>
    <message>
        <source>This is the image on a film in front of the hole. Behind the hole the light has crossed the axis, so the sign changes. Look at both films: only the one in front has the arrow upright.</source>
        <translation>To je slika na filmu ispred rupice. Iza rupice svjetlo je prešlo os, pa se predznak mijenja. Pogledajte oba filma: samo je na onome ispred strelica uspravna.</translation>
    </message>
    <message>
        <source>This measures the arrow&apos;s distance from the film, {0}. The two triangles meet at the hole: measure both distances from there. Look at the hole: both triangles begin there.</source>
        <translation>Ovo mjeri udaljenost strelice od filma, {0}. Dva se trokuta dodiruju u rupici: obje udaljenosti mjerite odande. Pogledajte rupicu: oba trokuta ondje počinju.</translation>
    </message>
    <message>
        <source>Measure both lengths from the hole: {0}.</source>
        <translation>Obje duljine mjerite od rupice: {0}.</translation>
    </message>
    <message>
        <source>The triangles share the corner at the hole.</source>
        <translation>Trokuti imaju zajednički vrh u rupici.</translation>
    </message>
    <message>
        <source>How far behind the hole must the film be for the image to be a third as high as the arrow?</source>
        <translation>Koliko daleko iza rupice mora biti film da slika bude visoka trećinu strelice?</translation>
    </message>
    <message>
        <source>This measures the arrow&apos;s distance from the film, which is 9 and the film&apos;s own distance. The two triangles meet at the hole: measure both distances from there. Look at the film 4.5 behind the hole: the image is half as high as the arrow.</source>
        <translation>Ovo mjeri udaljenost strelice od filma, a to je 9 i udaljenost samog filma. Dva se trokuta dodiruju u rupici: obje udaljenosti mjerite odande. Pogledajte film 4.5 iza rupice: slika je upola niža od strelice.</translation>
    </message>
    <message>
        <source>{0}. If you measure {1} from the film, you get {2}.</source>
        <translation>{0}. Ako {1} mjerite od filma, dobivate {2}.</translation>
    </message>
    <message>
        <source>Back to the film</source>
        <translation>Natrag na film</translation>
    </message>
    <message>
        <source>It was tempting to keep the sign, because the triangles are the same. But the projector goes through the eye and crosses the axis there: what was above is now below. Our cameras put the plane in front, where nothing is turned over. A real camera has its film behind and turns the picture round afterwards; the numbers differ by the sign only.</source>
        <translation>Bilo je primamljivo zadržati predznak, jer su trokuti isti. Ali zraka projiciranja ide kroz kameru i ondje siječe os: što je bilo gore, sada je dolje. Naše kamere stavljaju ravninu ispred, gdje se ništa ne okreće. Prava kamera ima film iza i sliku poslije okreće; brojevi se razlikuju samo predznakom.</translation>
    </message>
    <message>
        <source>Practise: height on the film</source>
        <translation>Vježba: visina na filmu</translation>
    </message>
    <message>
        <source>An arrow, {0} high, stands before the hole of a dark box.</source>
        <translation>Strelica visine {0} stoji pred rupicom mračne kutije.</translation>
    </message>
    <message>
        <source>The arrow is {0} in front of the hole, the film {1} behind it. How high is the arrow&apos;s image on the film, with its sign?</source>
        <translation>Strelica je {0} ispred rupice, film {1} iza nje. Kolika je visina slike strelice na filmu, s predznakom?</translation>
    </message>
    <message>
        <source>What stands upright in front of the hole stands on its head behind it.</source>
        <translation>Što ispred rupice stoji uspravno, iza nje stoji na glavi.</translation>
    </message>
    <message>
        <source>The image is {0} times as high as the arrow, and upside down.</source>
        <translation>Visina slike je {0} puta visina strelice, i slika je naopačke.</translation>
    </message>
    <message>
        <source>Practise: a corner on the film</source>
        <translation>Vježba: vrh na filmu</translation>
    </message>
    <message>
        <source>The picture shows the plane 4 in front of the eye. A film stands behind the eye; lay it over the picture, its middle on the middle, without turning it: right stays right, up stays up.</source>
        <translation>Slika pokazuje ravninu 4 ispred kamere. Film stoji iza kamere; položite ga preko slike, sredinu na sredinu, bez okretanja: desno ostaje desno, gore ostaje gore.</translation>
    </message>
    <message>
        <source>The film is {0} behind the eye, and drawn to the same scale. Mark where, on it, the image of point 1 lies.</source>
        <translation>Film je {0} iza kamere i nacrtan u istom mjerilu. Označite gdje na njemu leži slika točke 1.</translation>
    </message>
    <message>
        <source>This is where the image lies on a plane {0} in front of the eye. Behind the eye the light has crossed the axis, so both coordinates change their signs. Look at both films of this dark box: behind the hole the image is upside down.</source>
        <translation>Ondje slika leži na ravnini {0} ispred kamere. Iza kamere svjetlo je prešlo os, pa obje koordinate mijenjaju predznak. Pogledajte oba filma ove mračne kutije: iza rupice slika je naopačke.</translation>
    </message>
    <message>
        <source>Only up and down change</source>
        <translation>Mijenjaju se samo gore i dolje</translation>
    </message>
    <message>
        <source>This turns the image upside down only. The light crosses the axis, so left and right are exchanged as well. Look from above at a film behind the eye: what is on the right comes to the left.</source>
        <translation>Ovo sliku okreće samo naopačke. Svjetlo prelazi os, pa se zamjenjuju i lijevo i desno. Pogledajte odozgo film iza kamere: što je desno, dolazi lijevo.</translation>
    </message>
    <message>
        <source>The axis goes through the middle of the picture. On the film everything is on the other side of it.</source>
        <translation>Os prolazi kroz sredinu slike. Na filmu je sve s druge njezine strane.</translation>
    </message>
    <message>
        <source>The scale is {0} of the one that you see.</source>
        <translation>Mjerilo je {0} onoga koje vidite.</translation>
    </message>
    <message>
        <source>On the other side of the middle, and {0} times as far from it.</source>
        <translation>Na drugoj je strani sredine, a njezina udaljenost od sredine je {0} puta udaljenost koju vidite.</translation>
    </message>
    <message>
        <source>Practise: the film for a size</source>
        <translation>Vježba: film za veličinu</translation>
    </message>
    <message>
        <source>{0} is {1} deep. Put the plane behind the eye so that the image of {2} is upside down and {3} times as far from the axis as {4}.</source>
        <translation>{0} je na dubini {1}. Stavite ravninu iza kamere tako da slika točke {2} bude naopačke, a njezina udaljenost od osi {3} puta udaljenost same točke {4}.</translation>
    </message>
    <message>
        <source>The image is {0} times as far from the axis as {1}. Measure both from the eye.</source>
        <translation>Udaljenost slike od osi je {0} puta udaljenost točke {1} od osi. Obje dubine mjerite od kamere.</translation>
    </message>
    <message>
        <source>Behind the eye {0} is negative: type it under Plane distance d.</source>
        <translation>Iza kamere {0} je negativan: upišite ga pod Udaljenost ravnine d.</translation>
    </message>
    <message>
        <source>{0}, with {1}</source>
        <translation>{0}, uz {1}</translation>
    </message>
    <message>
        <source>In front of the eye the image is upright. Look at P&apos;: it is above the axis. The plane must be behind the eye, at a negative {0}.</source>
        <translation>Ispred kamere slika je uspravna. Pogledajte P&apos;: iznad osi je. Ravnina mora biti iza kamere, na negativnom {0}.</translation>
    </message>
    <message>
        <source>This measures the depth of {0} from the plane. Both triangles begin at the eye. Look at P&apos;: it is less than {1} times as far from the axis as {2}.</source>
        <translation>Ovo mjeri dubinu točke {0} od ravnine. Oba trokuta počinju kod kamere. Pogledajte P&apos;: njezina je udaljenost od osi manja od {1} puta udaljenost točke {2}.</translation>
    </message>
</context>
<context>
    <name>l22-walk-round-the-f</name>
    <message>
        <source>What stays when the camera rises?</source>
        <translation>Što ostaje kad se kamera diže?</translation>
    </message>
    <message>
        <source>A camera that rises, level</source>
        <translation>Kamera koja se diže, horizontalna</translation>
    </message>
    <message>
        <source>The letter F of eight cubes stands on its grid. The camera looks level: its eye is as high as its target. The uprights of the F are parallel in the picture.</source>
        <translation>Slovo F od osam kocaka stoji na svojoj rešetki. Kamera gleda horizontalno: na istoj je visini kao njezin cilj. Uspravni bridovi slova F na slici su paralelni.</translation>
    </message>
    <message>
        <source>The camera rises to 5.5, above the F, and keeps looking level. What do the uprights do in the picture?</source>
        <translation>Kamera se diže na 5.5, iznad slova F, i dalje gleda horizontalno. Što na slici čine uspravni bridovi?</translation>
    </message>
    <message>
        <source>they lean together downwards: the camera is above them</source>
        <translation>stječu se prema dolje: kamera je iznad njih</translation>
    </message>
    <message>
        <source>From above, uprights lean</source>
        <translation>Odozgo se uspravni bridovi naginju</translation>
    </message>
    <message>
        <source>Standing high does not make uprights meet; looking down does. This camera looks level, so the uprights are parallel to the picture and have no vanishing point. Look at both pictures from this height: only where the camera looks down do the uprights lean.</source>
        <translation>Uspravni se bridovi ne stječu od stajanja na visini, nego od gledanja dolje. Ova kamera gleda horizontalno, pa su uspravni bridovi paralelni sa slikom i nemaju nedogled. Pogledajte obje slike s te visine: uspravni se bridovi naginju samo ondje gdje kamera gleda dolje.</translation>
    </message>
    <message>
        <source>level</source>
        <translation>horizontalno</translation>
    </message>
    <message>
        <source>looking down</source>
        <translation>gleda dolje</translation>
    </message>
    <message>
        <source>they stay parallel</source>
        <translation>ostaju paralelni</translation>
    </message>
    <message>
        <source>they lean together upwards</source>
        <translation>stječu se prema gore</translation>
    </message>
    <message>
        <source>That happens when the camera looks *up*, whatever its height. Look at the F from below: its uprights lean together upwards.</source>
        <translation>To se događa kad kamera gleda *gore*, na kojoj god visini bila. Pogledajte F odozdo: uspravni se bridovi stječu prema gore.</translation>
    </message>
    <message>
        <source>Only the direction of view decides whether uprights meet. It is still level, so {0} has no component along them.</source>
        <translation>Samo smjer gledanja odlučuje stječu li se uspravni bridovi. On je i dalje horizontalan, pa {0} nema komponentu duž njih.</translation>
    </message>
    <message>
        <source>Looking at the target</source>
        <translation>S pogledom prema cilju</translation>
    </message>
    <message>
        <source>Now the target stays at 2 and the camera looks down. With {0} of length 10,</source>
        <translation>Sada cilj ostaje na 2, a kamera gleda dolje. Uz {0} duljine 10 je</translation>
    </message>
    <message>
        <source>{0} is also the cell in row 2, column 2 of the view matrix. The uprights are no longer at a right angle to {1}, because {2}, so they have a vanishing point, far below.</source>
        <translation>{0} je i ćelija u retku 2, stupcu 2 matrice pogleda. Uspravni bridovi više nisu okomiti na {1}, jer je {2}, pa imaju nedogled, daleko dolje.</translation>
    </message>
    <message>
        <source>Level again</source>
        <translation>Opet horizontalno</translation>
    </message>
    <message>
        <source>Points 1 and 2 mark the foot and the top of the F.</source>
        <translation>Točke 1 i 2 označavaju podnožje i vrh slova F.</translation>
    </message>
    <message>
        <source>Make the camera look level, with its eye as high as its target and the whole F in the picture.</source>
        <translation>Neka kamera gleda horizontalno, s visine svojega cilja, a cijelo slovo F neka bude na slici.</translation>
    </message>
    <message>
        <source>Which angle in the dock says how steeply the camera looks down?</source>
        <translation>Koji kut na bočnoj ploči kaže koliko strmo kamera gleda dolje?</translation>
    </message>
    <message>
        <source>Elevation 0 is level.</source>
        <translation>Elevacija 0 je horizontalno.</translation>
    </message>
    <message>
        <source>The uprights are parallel again, whatever the azimuth.</source>
        <translation>Uspravni su bridovi opet paralelni, koliki god bio azimut.</translation>
    </message>
    <message>
        <source>By the formula</source>
        <translation>Po formuli</translation>
    </message>
    <message>
        <source>The eye is at {0}, the target at {1}, and up is {2}. What is {3}, the cell in row 2, column 2 of the view matrix?</source>
        <translation>Kamera je u {0}, cilj u {1}, a smjer prema gore je {2}. Koliko je {3}, ćelija u retku 2, stupcu 2 matrice pogleda?</translation>
    </message>
    <message>
        <source>This takes up itself for {0}. Up only has to point roughly upwards; {1} is at a right angle to the direction of view, so the more the camera looks down, the smaller {2} is. Look at up and {3}: they are not parallel.</source>
        <translation>Ovo uzima sam smjer prema gore kao {0}. On treba pokazivati samo otprilike gore; {1} je okomit na smjer gledanja, pa je {2} to manji što kamera više gleda dolje. Pogledajte smjer prema gore i {3}: nisu paralelni.</translation>
    </message>
    <message>
        <source>This leaves the first product, of up and {0}, as it is, only 0.6 long. Make it 1 long before the second product. Look at up and {1}: they are not at a right angle.</source>
        <translation>Ovo ostavlja prvi umnožak, smjera prema gore i {0}, kakav jest, duljine samo 0.6. Dovedite ga na duljinu 1 prije drugog umnoška. Pogledajte smjer prema gore i {1}: nisu okomiti.</translation>
    </message>
    <message>
        <source>{0}, so {1}.</source>
        <translation>{0}, pa je {1}.</translation>
    </message>
    <message>
        <source>{0} is 10 long.</source>
        <translation>{0} ima duljinu 10.</translation>
    </message>
    <message>
        <source>{0} is 0.6 long and must be made 1 long.</source>
        <translation>{0} ima duljinu 0.6 i mora se dovesti na duljinu 1.</translation>
    </message>
    <message>
        <source>How far away?</source>
        <translation>Koliko daleko?</translation>
    </message>
    <message>
        <source>The camera looks level from a height of 2.5, with a field of view of 60°. The top of the F is at 5. At which depth does it appear at {0}, half-way up to the edge?</source>
        <translation>Kamera gleda horizontalno s visine 2.5, uz vidno polje od 60°. Vrh slova F je na 5. Na kojoj se dubini pojavljuje u {0}, na pola puta do gornjeg ruba?</translation>
    </message>
    <message>
        <source>This takes the tangent of the whole 60°. The right-angled triangle lies between the axis and the upper edge of the picture and has half of the angle. Look at 90°: half the picture is as high as it is deep, {0}.</source>
        <translation>Ovo uzima tangens od cijelih 60°. Pravokutni trokut leži između osi i gornjeg ruba slike i ima polovicu kuta. Pogledajte 90°: polovica slike je visoka koliko i duboka, {0}.</translation>
    </message>
    <message>
        <source>This multiplies by near, which is 2. The image on the near plane does grow with near, but so does the window round it; near only decides what is cut. Look at both pictures: they are the same.</source>
        <translation>Ovo množi s udaljenošću bliske ravnine, koja je 2. Slika na bliskoj ravnini doista raste s njom, ali raste i prozor oko nje; bliska ravnina samo odlučuje što se odsijeca. Pogledajte obje slike: iste su.</translation>
    </message>
    <message>
        <source>near 1</source>
        <translation>bliska 1</translation>
    </message>
    <message>
        <source>near 2</source>
        <translation>bliska 2</translation>
    </message>
    <message>
        <source>At the depth {0} half of the picture is {1} high.</source>
        <translation>Na dubini {0} polovica slike visoka je {1}.</translation>
    </message>
    <message>
        <source>Back to the rising camera</source>
        <translation>Natrag na kameru koja se diže</translation>
    </message>
    <message>
        <source>From above you usually *look down*, and houses lean in photographs from towers, so it was tempting to let the uprights lean. But looking down makes them lean, not the height. If a camera rises and looks level, the F moves in the picture but its uprights stay parallel. If a camera turns down to its target, {0} and the uprights meet. Press play in the tool bar: the section Animation has both ways of looking.</source>
        <translation>Odozgo obično *gledate dolje*, a na fotografijama s tornjeva zgrade se naginju, pa je bilo primamljivo pustiti uspravne bridove da se nagnu. Ali naginje ih gledanje dolje, a ne visina. Ako se kamera diže i gleda horizontalno, F se na slici pomiče, ali uspravni bridovi ostaju paralelni. Ako se kamera okrene dolje prema cilju, {0} i uspravni bridovi se stječu. Pritisnite Pokreni na alatnoj traci: odjeljak Animacija ima oba načina gledanja.</translation>
    </message>
    <message>
        <source>Practise: the vector v</source>
        <translation>Vježba: vektor v</translation>
    </message>
    <message>
        <source>The eye is at {0}, the target at {1}, up is {2}, so {3}. What is the camera&apos;s {4}, the second row of the view matrix without its last number?</source>
        <translation>Kamera je u {0}, cilj u {1}, smjer prema gore je {2}, pa je {3}. Koji je {4} kamere, drugi redak matrice pogleda bez posljednjeg broja?</translation>
    </message>
    <message>
        <source>Up only has to point roughly upwards. {0} is at a right angle to the direction of view, so it tilts when the camera looks down. Look at up and {1}: they are not parallel.</source>
        <translation>Smjer prema gore treba pokazivati samo otprilike gore. {0} je okomit na smjer gledanja, pa se naginje kad kamera gleda dolje. Pogledajte smjer prema gore i {1}: nisu paralelni.</translation>
    </message>
    <message>
        <source>This uses {0}, which is shorter than 1, in place of {1}. Make it 1 long before the second product. Look at up and {2}: they are not at a right angle.</source>
        <translation>Ovo uzima {0}, koji je kraći od 1, umjesto {1}. Dovedite ga na duljinu 1 prije drugog umnoška. Pogledajte smjer prema gore i {2}: nisu okomiti.</translation>
    </message>
    <message>
        <source>{0}, then {1} along {2}, made 1 long; {3} is up.</source>
        <translation>{0}, zatim {1} duž {2}, doveden na duljinu 1; {3} je smjer prema gore.</translation>
    </message>
    <message>
        <source>{0}, and {1}.</source>
        <translation>{0}, a {1}.</translation>
    </message>
    <message>
        <source>The middle number is the cosine of the angle by which the camera looks down.</source>
        <translation>Srednji broj je kosinus kuta za koji kamera gleda dolje.</translation>
    </message>
    <message>
        <source>Practise: the least depth</source>
        <translation>Vježba: najmanja dubina</translation>
    </message>
    <message>
        <source>You look down on a camera that looks level. From above, the F is a bar with four corners.</source>
        <translation>Odozgo gledate na kameru koja gleda horizontalno. Odozgo je F traka s četiri vrha.</translation>
    </message>
    <message>
        <source>Mark the corner of the F that is least deep for this camera.</source>
        <translation>Označite vrh slova F koji je za ovu kameru na najmanjoj dubini.</translation>
    </message>
    <message>
        <source>This corner is nearest to the eye. Depth is measured along the direction of view only, from the line through the eye that is parallel to near. Look from above at near, moved out: it meets another corner first.</source>
        <translation>Ovaj je vrh najbliži kameri. Dubina se mjeri samo duž smjera gledanja, od pravca kroz kameru koji je paralelan s bliskom ravninom. Pogledajte odozgo odmaknutu blisku ravninu: prvo nailazi na drugi vrh.</translation>
    </message>
    <message>
        <source>Depth is measured along the direction of view, not straight to the point.</source>
        <translation>Dubina se mjeri duž smjera gledanja, a ne ravno do točke.</translation>
    </message>
    <message>
        <source>Move a line that is parallel to near away from the eye. Which corner does it meet first?</source>
        <translation>Pomičite pravac paralelan s bliskom ravninom od kamere. Na koji vrh prvo naiđe?</translation>
    </message>
    <message>
        <source>A line parallel to near, moved away from the eye, meets this corner first.</source>
        <translation>Pravac paralelan s bliskom ravninom, pomican od kamere, prvo nailazi na ovaj vrh.</translation>
    </message>
    <message>
        <source>Practise: level, at a height in the picture</source>
        <translation>Vježba: horizontalno, na visini na slici</translation>
    </message>
    <message>
        <source>Point 1, on the top of the F, is at height 5, right above the target.</source>
        <translation>Točka 1, na vrhu slova F, na visini je 5, točno iznad cilja.</translation>
    </message>
    <message>
        <source>The camera looks level from a height of 2.5, with a field of view of {0}°. Go nearer or back until point 1 appears at {1}.</source>
        <translation>Kamera gleda horizontalno s visine 2.5, uz vidno polje od {0}°. Približavajte se ili odmičite dok se točka 1 ne pojavi u {1}.</translation>
    </message>
    <message>
        <source>At the distance {0}, half of the picture is {1} high.</source>
        <translation>Na udaljenosti {0} polovica slike visoka je {1}.</translation>
    </message>
    <message>
        <source>Near does not count, and half of the angle does: {0}.</source>
        <translation>Bliska ravnina se ne računa, a polovica kuta da: {0}.</translation>
    </message>
    <message>
        <source>The triangle of eye, axis and edge has half of the angle at the eye. Look at 90°: half the picture is as high as it is deep, {0}.</source>
        <translation>Trokut između kamere, osi i ruba ima kod kamere polovicu kuta. Pogledajte 90°: polovica slike je visoka koliko i duboka, {0}.</translation>
    </message>
    <message>
        <source>The image on the near plane grows with near, and so does the window round it. Look at both pictures: they are the same.</source>
        <translation>Slika na bliskoj ravnini raste s njezinom udaljenošću, a tako i prozor oko nje. Pogledajte obje slike: iste su.</translation>
    </message>
</context>
<context>
    <name>l23-popping</name>
    <message>
        <source>Why does it pop?</source>
        <translation>Zašto iskače?</translation>
    </message>
    <message>
        <source>A tree at the side</source>
        <translation>Stablo sa strane</translation>
    </message>
    <message>
        <source>The camera stands beside an avenue and looks along it. Far is 30. Point 1, on the axis of a tree that is not drawn yet, is 38 ahead and 15 to the right.</source>
        <translation>Kamera stoji uz drvored i gleda duž njega. Daleka ravnina je na 30. Točka 1, na osi stabla koje još nije nacrtano, je 38 naprijed i 15 udesno.</translation>
    </message>
    <message>
        <source>Far moves out to 40. Is the trunk of that tree drawn then?</source>
        <translation>Daleka ravnina odmiče se na 40. Crta li se tada deblo tog stabla?</translation>
    </message>
    <message>
        <source>No: it is 40.85 away from the eye</source>
        <translation>Ne: udaljeno je 40.85 od kamere</translation>
    </message>
    <message>
        <source>This measures straight from the eye to the tree, as if far were a sphere. Far is a plane across the direction of view: only the 38 ahead count. Look from above: point 1 lies before far.</source>
        <translation>Ovo mjeri ravno od kamere do stabla, kao da je daleka ravnina sfera. Ona je ravnina okomita na smjer gledanja: računa se samo onih 38 naprijed. Pogledajte odozgo: točka 1 leži ispred daleke ravnine.</translation>
    </message>
    <message>
        <source>Yes: its depth is 38</source>
        <translation>Da: dubina mu je 38</translation>
    </message>
    <message>
        <source>No: you can see only half of far, up to 20</source>
        <translation>Ne: vidi se samo do polovice daleke ravnine, do 20</translation>
    </message>
    <message>
        <source>The whole distance up to far is visible, measured from the eye. Look from above: the pyramid reaches from the eye to far, and point 1 lies in it.</source>
        <translation>Vidi se cijela udaljenost do daleke ravnine, mjereno od kamere. Pogledajte odozgo: piramida seže od kamere do daleke ravnine, a točka 1 leži u njoj.</translation>
    </message>
    <message>
        <source>Far is a plane across the axis. What matters is how far ahead the tree is, not how far away.</source>
        <translation>Daleka ravnina je ravnina okomita na os. Važno je koliko je stablo naprijed, a ne koliko je udaljeno.</translation>
    </message>
    <message>
        <source>What passes the plane</source>
        <translation>Što prolazi kroz ravninu</translation>
    </message>
    <message>
        <source>Seen from above the far plane cuts straight across the avenue. A tree appears when its depth {0} is less than {1}. If you drive ahead by {2}, every depth shrinks by {3}, however far a tree is to the side: a tree 62 ahead appears at {4}.</source>
        <translation>Gledana odozgo, daleka ravnina siječe drvored ravno poprijeko. Stablo se pojavljuje kad je njegova dubina {0} manja od {1}. Ako vozite naprijed za {2}, svaka se dubina smanji za {3}, koliko god stablo bilo sa strane: stablo 62 naprijed pojavljuje se kod {4}.</translation>
    </message>
    <message>
        <source>The lecture has two remedies. Fog fades distant things, so you do not see them appear. Level of detail draws distant trees with fewer vertices, so far can be farther at the same cost.</source>
        <translation>Predavanje ima dva lijeka. Magla čini daleke stvari blijedima, pa ne vidite kako se pojavljuju. Razina detalja crta daleka stabla s manje vrhova, pa uz isti trošak daleka ravnina može biti dalje.</translation>
    </message>
    <message>
        <source>Just so many trees</source>
        <translation>Točno toliko stabala</translation>
    </message>
    <message>
        <source>Each tree has 272 vertices. Set far so that exactly 10 trees are drawn, 2720 vertices.</source>
        <translation>Svako stablo ima 272 vrha. Postavite daleku ravninu tako da se crta točno 10 stabala, 2720 vrhova.</translation>
    </message>
    <message>
        <source>A tree that the far plane cuts is drawn in part, and it counts.</source>
        <translation>Stablo koje daleka ravnina siječe crta se djelomično, i računa se.</translation>
    </message>
    <message>
        <source>The rows are 6 apart: to remove two trees, move far in by 6.</source>
        <translation>Redovi su razmaknuti 6: da uklonite dva stabla, primaknite daleku ravninu za 6.</translation>
    </message>
    <message>
        <source>Every six units another pair of trees reaches the far plane.</source>
        <translation>Svakih šest jedinica do daleke ravnine stiže novi par stabala.</translation>
    </message>
    <message>
        <source>By the formula</source>
        <translation>Po formuli</translation>
    </message>
    <message>
        <source>Point 1 is on the axis of a tree 44 ahead and 15 to the right. Far is 34. How far must the camera drive until the point is at the far plane?</source>
        <translation>Točka 1 je na osi stabla 44 naprijed i 15 udesno. Daleka ravnina je na 34. Koliko kamera mora prijeći dok točka ne dođe na daleku ravninu?</translation>
    </message>
    <message>
        <source>This waits until the tree is 34 away from the eye, measured straight. Far is a plane across the direction of view, so how far the tree is to the side does not matter. Look from above at far = 44: it goes through point 1, though the point is 46.5 away.</source>
        <translation>Ovo čeka da stablo bude 34 od kamere, mjereno ravno. Daleka ravnina je ravnina okomita na smjer gledanja, pa nije važno koliko je stablo sa strane. Pogledajte odozgo daleku ravninu na 44: prolazi kroz točku 1, premda je ona udaljena 46.5.</translation>
    </message>
    <message>
        <source>44 − 34. A tree at the side appears at the same time as one straight ahead.</source>
        <translation>44 − 34. Stablo sa strane pojavljuje se istodobno kad i ono ravno naprijed.</translation>
    </message>
    <message>
        <source>The Above view shows the plane.</source>
        <translation>Pogled Odozgo pokazuje ravninu.</translation>
    </message>
    <message>
        <source>A fog begins at 15 and hides everything from 66 on; between them the contrast falls evenly. What percentage of the contrast is left at the far plane?</source>
        <translation>Magla počinje na 15 i skriva sve od 66 nadalje; između kontrast pada jednoliko. Koliki postotak kontrasta ostaje na dalekoj ravnini?</translation>
    </message>
    <message>
        <source>32 of the 51 units are left. With this contrast a tree still pops in.</source>
        <translation>Ostaju 32 od 51 jedinice. S tim kontrastom stablo i dalje iskače.</translation>
    </message>
    <message>
        <source>Back to the tree</source>
        <translation>Natrag na stablo</translation>
    </message>
    <message>
        <source>The tree is 40.85 away, more than far, so it was tempting to leave it out. If far were a sphere, that would be right. But a matrix can only give planes, so near and far are planes: the tree is drawn because it is 38 *ahead*. When the camera turns, the plane turns with it, and trees at the edge of the picture come and go although nobody has driven. Drag the azimuth and watch them.</source>
        <translation>Stablo je udaljeno 40.85, dalje od daleke ravnine, pa ga je bilo primamljivo izostaviti. Da je daleka ravnina sfera, to bi bilo točno. Ali matrica može dati samo ravnine, pa su bliska i daleka ravnine: stablo se crta jer je 38 *naprijed*. Kad se kamera okreće, s njom se okreće i ravnina, i stabla na rubu slike dolaze i odlaze premda nitko nije vozio. Povucite azimut i promatrajte ih.</translation>
    </message>
    <message>
        <source>Practise: drive until it appears</source>
        <translation>Vježba: vozite dok se ne pojavi</translation>
    </message>
    <message>
        <source>Point 1 is {0} ahead and {1} to the right, and far is {2}. How far must the camera drive, straight ahead, until the point is at the far plane?</source>
        <translation>Točka 1 je {0} naprijed i {1} udesno, a daleka ravnina je na {2}. Koliko kamera mora prijeći, ravno naprijed, dok točka ne dođe na daleku ravninu?</translation>
    </message>
    <message>
        <source>This waits until the point is {0} away from the eye, measured straight. Far is a plane across the direction of view, so how far the point is to the side does not matter. Look from above at far = {1}: it goes through point 1, however far that is to the side.</source>
        <translation>Ovo čeka da točka bude {0} od kamere, mjereno ravno. Daleka ravnina je ravnina okomita na smjer gledanja, pa nije važno koliko je točka sa strane. Pogledajte odozgo daleku ravninu na {1}: prolazi kroz točku 1, koliko god ona bila sa strane.</translation>
    </message>
    <message>
        <source>The straight way counts</source>
        <translation>Računa se ravan put</translation>
    </message>
    <message>
        <source>This subtracts far from the straight distance to the point. Far is a plane across the direction of view: only how far the point is ahead counts. Look from above at far = {0}: it goes through point 1, however far that is to the side.</source>
        <translation>Ovo oduzima udaljenost daleke ravnine od ravne udaljenosti do točke. Daleka ravnina je ravnina okomita na smjer gledanja: računa se samo koliko je točka naprijed. Pogledajte odozgo daleku ravninu na {0}: prolazi kroz točku 1, koliko god ona bila sa strane.</translation>
    </message>
    <message>
        <source>The view from above shows the far plane. Which distance to it does the drive shorten?</source>
        <translation>Pogled odozgo pokazuje daleku ravninu. Koju udaljenost do nje vožnja skraćuje?</translation>
    </message>
    <message>
        <source>Driving shortens the depth alone. The point may be as far to the side as it likes.</source>
        <translation>Vožnja skraćuje samo dubinu. Točka može biti sa strane koliko hoće.</translation>
    </message>
    <message>
        <source>Practise: the last tree</source>
        <translation>Vježba: posljednje stablo</translation>
    </message>
    <message>
        <source>You look down on the avenue; in each row the trees are 6 apart.</source>
        <translation>Odozgo gledate na drvored; u svakom su redu stabla razmaknuta 6.</translation>
    </message>
    <message>
        <source>Far moves out by {0}, from {1} to {2}. In the row that is farther from the camera&apos;s way, mark the last tree whose trunk is then drawn.</source>
        <translation>Daleka ravnina odmiče se za {0}, od {1} do {2}. U redu koji je dalje od puta kamere označite posljednje stablo čije se deblo tada crta.</translation>
    </message>
    <message>
        <source>The tree behind this one is farther from the eye than far, but less deep, and only depth counts. Far is a plane across the direction of view, not a circle round the eye. Look from above at far, moved out.</source>
        <translation>Stablo iza ovoga dalje je od kamere nego daleka ravnina, ali je na manjoj dubini, a računa se samo dubina. Daleka ravnina je ravnina okomita na smjer gledanja, a ne kružnica oko kamere. Pogledajte odozgo odmaknutu daleku ravninu.</translation>
    </message>
    <message>
        <source>The far plane moves along the direction of view and stays across it.</source>
        <translation>Daleka ravnina pomiče se duž smjera gledanja i ostaje okomita na njega.</translation>
    </message>
    <message>
        <source>Trees are 6 apart. How many such distances fit into {0}?</source>
        <translation>Stabla su na razmaku 6. Koliko takvih razmaka stane u {0}?</translation>
    </message>
    <message>
        <source>This tree is {0} deep, the next one {1}; far is then {2}.</source>
        <translation>Ovo stablo je na dubini {0}, sljedeće na {1}; daleka ravnina je tada na {2}.</translation>
    </message>
    <message>
        <source>Practise: so many trees</source>
        <translation>Vježba: toliko stabala</translation>
    </message>
    <message>
        <source>The first two trees are {0} ahead of the camera, and each following pair 6 farther. Set far so that exactly {1} trees are drawn; a tree that far cuts counts.</source>
        <translation>Prva dva stabla su {0} ispred kamere, a svaki sljedeći par 6 dalje. Postavite daleku ravninu tako da se crta točno toliko stabala: {1}; stablo koje daleka ravnina siječe računa se.</translation>
    </message>
    <message>
        <source>How deep is pair number {0}? Far must lie just behind it.</source>
        <translation>Na kojoj je dubini par broj {0}? Daleka ravnina mora ležati tik iza njega.</translation>
    </message>
    <message>
        <source>Its depth is {0}. How far it is to the side does not count.</source>
        <translation>Dubina mu je {0}. Koliko je sa strane, ne računa se.</translation>
    </message>
    <message>
        <source>Pair number {0} is {1} deep, the next one {2}. A tree begins 1.5 nearer: far must be between the fronts of both pairs.</source>
        <translation>Par broj {0} je na dubini {1}, sljedeći na {2}. Stablo počinje 1.5 bliže: daleka ravnina mora biti između prednjih strana obaju parova.</translation>
    </message>
</context>
<context>
    <name>l24-focus</name>
    <message>
        <source>What is sharp?</source>
        <translation>Što je oštro?</translation>
    </message>
    <message>
        <source>Behind the focus</source>
        <translation>Iza ravnine izoštravanja</translation>
    </message>
    <message>
        <source>The lens of the synthetic camera is a point, and everything is sharp. A real lens draws a point as a disc. A disc of diameter {0} or less passes for a point. The lens here has a focal length of 50 mm and an aperture of {1}, and is focused at 2 m.</source>
        <translation>Objektiv sintetičke kamere je točka, i sve je oštro. Pravi objektiv crta točku kao krug. Krug promjera {0} ili manji prolazi kao točka. Objektiv ovdje ima žarišnu duljinu od 50 mm i otvor blende {1}, a izoštren je na 2 m.</translation>
    </message>
    <message>
        <source>The focus moves to 5 m. The sharp range begins at 4.287 m. At how many metres does it end?</source>
        <translation>Izoštravanje se pomiče na 5 m. Oštro područje počinje na 4.287 m. Na koliko metara završava?</translation>
    </message>
    <message>
        <source>5.713, as far behind the focus as in front</source>
        <translation>5.713, jednako daleko iza ravnine izoštravanja kao ispred</translation>
    </message>
    <message>
        <source>The disc grows more slowly behind the focus than in front of it. So the sharp range reaches farther behind. Look from above: from the focus it is 0.713 m to the near limit, and 0.998 m to the far one.</source>
        <translation>Krug iza ravnine izoštravanja raste sporije nego ispred nje. Zato oštro područje iza seže dalje. Pogledajte odozgo: od ravnine izoštravanja je 0.713 m do bliže granice, a 0.998 m do dalje.</translation>
    </message>
    <message>
        <source>Only there are points drawn as points, but discs up to {0} pass for points. Look from above: the sharp range goes on behind the focus.</source>
        <translation>Samo se ondje točke crtaju kao točke, ali krugovi do {0} prolaze kao točke. Pogledajte odozgo: oštro područje nastavlja se iza ravnine izoštravanja.</translation>
    </message>
    <message>
        <source>0.713 m in front of the focus, but 0.998 m behind it. The scene&apos;s numbers have both limits. Of the posts those at 5 m and 6 m are outlined as sharp: the front of each is 15 cm nearer than its middle.</source>
        <translation>0.713 m ispred ravnine izoštravanja, ali 0.998 m iza nje. Brojevi scene imaju obje granice. Od stupova su oni na 5 m i 6 m obrubljeni kao oštri: prednja strana svakoga 15 cm je bliže nego njegova sredina.</translation>
    </message>
    <message>
        <source>The two limits</source>
        <translation>Dvije granice</translation>
    </message>
    <message>
        <source>For the focal length {0}, the aperture {1}, the circle of confusion {2} and the focus at {3},</source>
        <translation>Za žarišnu duljinu {0}, otvor blende {1}, krug konfuzije {2} i izoštravanje na {3} je</translation>
    </message>
    <message>
        <source>and the picture is sharp from {0} to {1}.</source>
        <translation>a slika je oštra od {0} do {1}.</translation>
    </message>
    <message>
        <source>Here {0} m, {1}, and so from {2} to {3} m. The World pane shows the three planes from above.</source>
        <translation>Ovdje je {0} m, {1}, dakle od {2} do {3} m. Okno Svijet pokazuje te tri ravnine odozgo.</translation>
    </message>
    <message>
        <source>Sharp without end</source>
        <translation>Oštro bez kraja</translation>
    </message>
    <message>
        <source>Make everything far away sharp: move the far limit to infinity.</source>
        <translation>Neka sve daleko bude oštro: pomaknite dalju granicu u beskonačnost.</translation>
    </message>
    <message>
        <source>When does {0} become 0?</source>
        <translation>Kada {0} postaje 0?</translation>
    </message>
    <message>
        <source>Focus at the hyperfocal distance H or farther away, or stop the lens down with a larger N until H is nearer than the focus.</source>
        <translation>Izoštrite na hiperfokalnu udaljenost H ili dalje, ili zatvorite blendu većim N dok H ne bude bliže od ravnine izoštravanja.</translation>
    </message>
    <message>
        <source>From {0} on, {1} is 1 or more. If you focus exactly at {2}, everything from {3} on is sharp.</source>
        <translation>Od {0} nadalje {1} je 1 ili više. Ako izoštrite točno na {2}, oštro je sve od {3} nadalje.</translation>
    </message>
    <message>
        <source>By the formula</source>
        <translation>Po formuli</translation>
    </message>
    <message>
        <source>A 50-mm lens with {0} and {1} mm is focused at 4 m. Up to how many metres is it sharp?</source>
        <translation>Objektiv od 50 mm s {0} i {1} mm izoštren je na 4 m. Do koliko je metara oštar?</translation>
    </message>
    <message>
        <source>This is as far behind the focus as the near limit is in front of it. The disc grows more slowly behind the focus, so the far limit is farther away. Look from above: the far limit is farther from the focus than the near one.</source>
        <translation>Ovo je jednako daleko iza ravnine izoštravanja kao što je bliža granica ispred nje. Krug iza nje raste sporije, pa je dalja granica udaljenija. Pogledajte odozgo: dalja je granica od ravnine izoštravanja udaljenija nego bliža.</translation>
    </message>
    <message>
        <source>{0} m, {1}, and {2}.</source>
        <translation>{0} m, {1} i {2}.</translation>
    </message>
    <message>
        <source>First {0}, in metres.</source>
        <translation>Najprije {0}, u metrima.</translation>
    </message>
    <message>
        <source>Posts at 3 m and at 6 m are exactly at the two limits. At how many metres is the focus?</source>
        <translation>Stupovi na 3 m i na 6 m točno su na dvjema granicama. Na koliko je metara izoštreno?</translation>
    </message>
    <message>
        <source>This puts the focus half-way between the limits. The disc grows more slowly behind the focus, so the focus is closer to the near limit; what is half-way is one over the distance, between {0} and {1}. Look from above at the focus 4.5 with a near limit of 3: the far limit is 9, not 6.</source>
        <translation>Ovo stavlja ravninu izoštravanja na pola puta između granica. Krug iza nje raste sporije, pa je ona bliže bližoj granici; na pola puta je jedan kroz udaljenost, između {0} i {1}. Pogledajte odozgo izoštravanje na 4.5 s bližom granicom 3: dalja je 9, a ne 6.</translation>
    </message>
    <message>
        <source>{0} is the middle of {1} and {2}: {3}.</source>
        <translation>{0} je sredina između {1} i {2}: {3}.</translation>
    </message>
    <message>
        <source>Which number is as far from {0} as from {1}?</source>
        <translation>Koji je broj jednako udaljen od {0} i od {1}?</translation>
    </message>
    <message>
        <source>Back to the limits</source>
        <translation>Natrag na granice</translation>
    </message>
    <message>
        <source>Half in front and half behind was tempting, because the disc is 0 at the focus and grows on both sides. But it does not grow equally: it is proportional to {0}, and one over the distance changes more slowly the farther away you are. So the far limit is always farther from the focus than the near one, and from the hyperfocal distance on it is at infinity.</source>
        <translation>Pola ispred i pola iza bilo je primamljivo, jer je krug u ravnini izoštravanja 0 i raste na obje strane. Ali ne raste jednako: proporcionalan je s {0}, a jedan kroz udaljenost mijenja se to sporije što ste dalje. Zato je dalja granica od ravnine izoštravanja uvijek udaljenija nego bliža, a od hiperfokalne udaljenosti nadalje ona je u beskonačnosti.</translation>
    </message>
    <message>
        <source>Practise: the far limit</source>
        <translation>Vježba: dalja granica</translation>
    </message>
    <message>
        <source>With {0} and {1}, all in metres.</source>
        <translation>Uz {0} i {1}, sve u metrima.</translation>
    </message>
    <message>
        <source>A lens with {0} mm and {1} is focused at {2} m, with {3} mm. Up to how many metres is the picture sharp?</source>
        <translation>Objektiv s {0} mm i {1} izoštren je na {2} m, uz {3} mm. Do koliko je metara slika oštra?</translation>
    </message>
    <message>
        <source>This is as far behind the focus as the near limit is in front of it. The limits are {0} and {1}; the far one is farther from the focus. Look from above: it is farther from the focus than the near one.</source>
        <translation>Ovo je jednako daleko iza ravnine izoštravanja kao što je bliža granica ispred nje. Granice su {0} i {1}; dalja je udaljenija od ravnine izoštravanja. Pogledajte odozgo: dalja je granica od nje udaljenija nego bliža.</translation>
    </message>
    <message>
        <source>Both limits have a plus</source>
        <translation>Obje granice imaju plus</translation>
    </message>
    <message>
        <source>This is the near limit, {0}. Behind the focus it is {1}. Look from above: the far limit lies behind the focus.</source>
        <translation>To je bliža granica, {0}. Iza ravnine izoštravanja je {1}. Pogledajte odozgo: dalja granica leži iza ravnine izoštravanja.</translation>
    </message>
    <message>
        <source>First {0}, in metres: {1} mm are {2} m, and 0.03 mm are 0.00003 m.</source>
        <translation>Najprije {0}, u metrima: {1} mm je {2} m, a 0.03 mm je 0.00003 m.</translation>
    </message>
    <message>
        <source>Then {0}, and the far limit {1}.</source>
        <translation>Zatim {0} i dalja granica {1}.</translation>
    </message>
    <message>
        <source>Here {0} is {1} m, and {2} is {3}.</source>
        <translation>Ovdje je {0} jednako {1} m, a {2} je {3}.</translation>
    </message>
    <message>
        <source>Practise: where does it end?</source>
        <translation>Vježba: gdje završava?</translation>
    </message>
    <message>
        <source>You look down on the lens and the posts, which are 2, 3, 4, 5, 6, 8, 10, 12, 15 and 20 m away.</source>
        <translation>Odozgo gledate na objektiv i stupove, koji su udaljeni 2, 3, 4, 5, 6, 8, 10, 12, 15 i 20 m.</translation>
    </message>
    <message>
        <source>The lens has {0} mm and is focused at {1} m. It is stopped down to {2}, so that {3} m. Mark where on the axis, the middle line ahead of the eye, the sharp range now ends.</source>
        <translation>Objektiv ima {0} mm i izoštren je na {1} m. Blenda je zatvorena na {2}, pa je {3} m. Označite gdje na osi, srednjoj crti ispred kamere, sada završava oštro područje.</translation>
    </message>
    <message>
        <source>This is as far behind the focus as the near limit is in front of it. The far limit, {0}, is farther away. Look from above at both limits.</source>
        <translation>Ovo je jednako daleko iza ravnine izoštravanja kao što je bliža granica ispred nje. Dalja granica, {0}, je udaljenija. Pogledajte odozgo obje granice.</translation>
    </message>
    <message>
        <source>The far limit is {0}. Find its distance between the posts.</source>
        <translation>Dalja granica je {0}. Nađite njezinu udaljenost među stupovima.</translation>
    </message>
    <message>
        <source>{0}, so the range ends at {1} m.</source>
        <translation>{0}, pa područje završava na {1} m.</translation>
    </message>
    <message>
        <source>Practise: sharp from here to there</source>
        <translation>Vježba: oštro odavde donde</translation>
    </message>
    <message>
        <source>With {0} the picture is sharp from {1} to {2}.</source>
        <translation>Uz {0} slika je oštra od {1} do {2}.</translation>
    </message>
    <message>
        <source>This lens has {0} mm and {1} mm. Set its focal distance {2} and its aperture {3} so that the picture is sharp from {4} m to {5} m.</source>
        <translation>Ovaj objektiv ima {0} mm i {1} mm. Postavite njegovu udaljenost izoštravanja {2} i otvor blende {3} tako da slika bude oštra od {4} m do {5} m.</translation>
    </message>
    <message>
        <source>{0} is the middle of {1} and {2}, so {3}.</source>
        <translation>{0} je sredina između {1} i {2}, pa je {3}.</translation>
    </message>
    <message>
        <source>The focus at {0} m gives {1}.</source>
        <translation>Izoštravanje na {0} m daje {1}.</translation>
    </message>
    <message>
        <source>{0}, all in metres.</source>
        <translation>{0}, sve u metrima.</translation>
    </message>
    <message>
        <source>{0} {1} {2} m, from {3} m to {4} m; and {5} {6}, with {7}.</source>
        <translation>{0} {1} {2} m, od {3} m do {4} m; i {5} {6}, uz {7}.</translation>
    </message>
    <message>
        <source>The far limit is farther from the focus than the near one. Look from above at the focus {0} with a near limit of {1}: the far limit is beyond {2}.</source>
        <translation>Dalja je granica od ravnine izoštravanja udaljenija nego bliža. Pogledajte odozgo izoštravanje na {0} s bližom granicom {1}: dalja je iza {2}.</translation>
    </message>
</context>
<context>
    <name>l25-how-many-bits</name>
    <message>
        <source>How many bits does a picture need?</source>
        <translation>Koliko bitova treba slika?</translation>
    </message>
    <message>
        <source>More places than pixels</source>
        <translation>Više mjesta nego piksela</translation>
    </message>
    <message>
        <source>A coordinate of 16 bits has 65 536 places. Here they are spread over the scene&apos;s longest side, 8 units, and the picture is 320 pixels wide. Each arrow in **Image** runs from where a vertex belongs towards where it is drawn, enlarged 10 000 times. The dock says how far off a vertex of the picture is at most: 0.002 pixels.</source>
        <translation>Koordinata od 16 bitova ima 65 536 mjesta. Ovdje su raspoređena po najduljoj stranici scene, 8 jedinica, a slika je široka 320 piksela. Svaka strelica u oknu **Slika** ide od mjesta kojem vrh pripada prema mjestu gdje je nacrtan, povećana 10 000 puta. Bočna ploča kaže kolika je najveća pogreška vrha na slici: 0.002 piksela.</translation>
    </message>
    <message>
        <source>The camera comes up to a corner of the F, as near as 0.01 units. How far off is the corner now?</source>
        <translation>Kamera dolazi do vrha slova F, na samo 0.01 jedinica. Kolika je sada pogreška tog vrha?</translation>
    </message>
    <message>
        <source>Nothing that can be seen: 65 536 places are more than 320 pixels</source>
        <translation>Nikakva koja bi se vidjela: 65 536 mjesta više je od 320 piksela</translation>
    </message>
    <message>
        <source>The places are spread over the whole scene, and the picture now shows a small part of it. Look at the corner: from one place to the next are 3.3 pixels.</source>
        <translation>Mjesta su raspoređena po cijeloj sceni, a slika sada pokazuje njezin mali dio. Pogledajte vrh: od jednog mjesta do sljedećeg je 3.3 piksela.</translation>
    </message>
    <message>
        <source>0.002 pixels, as before: the vertex is stored as it was</source>
        <translation>0.002 piksela, kao prije: vrh je spremljen kao i dosad</translation>
    </message>
    <message>
        <source>The vertex is off by the same length, but here a unit fills 27 000 pixels. Look at the corner: it is off by more than a pixel.</source>
        <translation>Vrh je pomaknut za istu duljinu, ali ovdje jedinica zauzima 27 000 piksela. Pogledajte vrh: pogrešan je za više od piksela.</translation>
    </message>
    <message>
        <source>By up to 1.6 pixels across, and as much down</source>
        <translation>Do 1.6 piksela u širinu, i jednako toliko u visinu</translation>
    </message>
    <message>
        <source>The places are 0.00012 units apart wherever you look. At 0.01 units from the eye, a unit fills 27 000 pixels.</source>
        <translation>Mjesta su razmaknuta 0.00012 jedinica kamo god gledali. Na 0.01 jedinica od kamere jedinica zauzima 27 000 piksela.</translation>
    </message>
    <message>
        <source>From bits to pixels</source>
        <translation>Od bitova do piksela</translation>
    </message>
    <message>
        <source>With {0} bits over a side {1} the places are {2} apart. A coordinate goes to the nearest place, so it is off by half of that at most. At the depth {3} a picture {4} pixels high shows {5} units, and so</source>
        <translation>Uz {0} bitova na stranici {1} mjesta su razmaknuta {2}. Koordinata ide na najbliže mjesto, pa je pomaknuta za najviše pola toga. Na dubini {3} slika visoka {4} piksela pokazuje {5} jedinica, pa je</translation>
    </message>
    <message>
        <source>With 8 bits: {0} units. At the target, {1}, a unit fills {2} pixels, so one coordinate is off by up to 0.37 pixels. Three coordinates together, nearer to the eye, make a little more. The *predicted* number in the dock is such a bound: no error is larger.</source>
        <translation>Uz 8 bitova: {0} jedinica. Kod cilja, {1}, jedinica zauzima {2} piksela, pa je jedna koordinata pomaknuta za najviše 0.37 piksela. Tri koordinate zajedno, bliže kameri, daju malo više. *Predviđena* pogreška na bočnoj ploči takva je granica: nijedna pogreška nije veća.</translation>
    </message>
    <message>
        <source>With 12 bits instead of 8, over the same side of 8 units: by how many units is a coordinate off at most?</source>
        <translation>S 12 bitova umjesto 8, na istoj stranici od 8 jedinica: za koliko je jedinica koordinata najviše pomaknuta?</translation>
    </message>
    <message>
        <source>The gap is the error</source>
        <translation>Razmak je pogreška</translation>
    </message>
    <message>
        <source>This is the distance between two places. The coordinate goes to the nearer one, so it is off by half of it at most. Look at the picture with 12 bits, and at *predicted* in the panel.</source>
        <translation>To je udaljenost između dvaju mjesta. Koordinata ide na bliže, pa je pomaknuta za najviše pola toga. Pogledajte sliku s 12 bitova i *predviđenu* pogrešku na ploči.</translation>
    </message>
    <message>
        <source>{0} units from place to place, and half of that.</source>
        <translation>{0} jedinica od mjesta do mjesta, i pola toga.</translation>
    </message>
    <message>
        <source>12 bits have {0} places, and one gap less.</source>
        <translation>12 bitova ima {0} mjesta i jedan razmak manje.</translation>
    </message>
    <message>
        <source>Where you stand</source>
        <translation>Gdje stojite</translation>
    </message>
    <message>
        <source>Still 8 bits: nothing about the stored vertices changes in this step.</source>
        <translation>I dalje 8 bitova: u ovom se koraku ništa kod spremljenih vrhova ne mijenja.</translation>
    </message>
    <message>
        <source>Make the largest measured error smaller than 0.3 pixels, and leave the 8 bits as they are.</source>
        <translation>Neka najveća izmjerena pogreška bude manja od 0.3 piksela, a 8 bitova neka ostane kako jest.</translation>
    </message>
    <message>
        <source>What stands in the denominator of {0}?</source>
        <translation>Što stoji u nazivniku od {0}?</translation>
    </message>
    <message>
        <source>Move Distance to the right. A wider Field of view helps, too.</source>
        <translation>Pomaknite Udaljenost udesno. Pomaže i šire Vidno polje.</translation>
    </message>
    <message>
        <source>Fewer pixels for each unit, fewer pixels of error. A game may use 8 bits for a far mountain and 16 for the sword in your hand.</source>
        <translation>Manje piksela po jedinici, manje piksela pogreške. Igra može uzeti 8 bitova za daleku planinu, a 16 za mač u vašoj ruci.</translation>
    </message>
    <message>
        <source>A vertex at the depth 10 is 0.4 pixels off. The camera comes nearer, to the depth 5. How many pixels is it off now?</source>
        <translation>Vrh na dubini 10 pomaknut je za 0.4 piksela. Kamera dolazi bliže, na dubinu 5. Za koliko je piksela sada pomaknut?</translation>
    </message>
    <message>
        <source>The vertex is off by the same length, but at half the depth a unit has twice as many pixels. Look at the arrows from nearer by: they are longer.</source>
        <translation>Vrh je pomaknut za istu duljinu, ali na upola manjoj dubini jedinica ima dvostruko više piksela. Pogledajte strelice izbliza: dulje su.</translation>
    </message>
    <message>
        <source>{0} has {1} in its denominator: at half the depth every length, and every error, is drawn twice as long.</source>
        <translation>{0} u nazivniku ima {1}: na upola manjoj dubini svaka se duljina, pa i svaka pogreška, crta dvostruko dulja.</translation>
    </message>
    <message>
        <source>Far from the origin</source>
        <translation>Daleko od ishodišta</translation>
    </message>
    <message>
        <source>Now vertices and arithmetic are float32, about 7 decimal digits. The world&apos;s origin is moved 1 000 000 units away, and everything else stays where it is: camera and F are neighbours, far out. Their coordinates are now about 1 000 000, and the matrix subtracts them from each other.</source>
        <translation>Sada su vrhovi i aritmetika float32, oko 7 decimalnih znamenaka. Ishodište svijeta pomaknuto je 1 000 000 jedinica dalje, a sve drugo ostaje gdje jest: kamera i F su susjedi, daleko vani. Koordinate su im sada oko 1 000 000, a matrica ih oduzima jedne od drugih.</translation>
    </message>
    <message>
        <source>A float32 has 24 significant bits. How far apart are its numbers near 1 000 000, which lies between {0} and {1}?</source>
        <translation>Broj float32 ima 24 značajna bita. Koliko su razmaknuti njegovi brojevi blizu 1 000 000, koji leži između {0} i {1}?</translation>
    </message>
    <message>
        <source>A float32 keeps 24 bits, so its numbers near 1 000 000 are apart by what the last bit counts. Look at the F: its corners are at such places only.</source>
        <translation>Broj float32 čuva 24 bita, pa su brojevi blizu 1 000 000 razmaknuti koliko vrijedi posljednji bit. Pogledajte F: njegovi su vrhovi samo na takvim mjestima.</translation>
    </message>
    <message>
        <source>The first of 24 bits counts {0}, the last one {1}: one sixteenth of a unit.</source>
        <translation>Prvi od 24 bita vrijedi {0}, a posljednji {1}: šesnaestinu jedinice.</translation>
    </message>
    <message>
        <source>The first bit counts {0}, the second {1}. What does bit 24 count?</source>
        <translation>Prvi bit vrijedi {0}, drugi {1}. Koliko vrijedi bit 24?</translation>
    </message>
    <message>
        <source>A vertex is 10 units from the eye, measured along x, and is stored as the nearest float32. By how many per cent of these 10 units can it be off?</source>
        <translation>Vrh je 10 jedinica od kamere, mjereno duž x, i sprema se kao najbliži float32. Za koliko postotaka od tih 10 jedinica može biti pomaknut?</translation>
    </message>
    <message>
        <source>The seven digits belong to the coordinate, near 1 000 000. The subtraction takes the leading ones away, and the rounding stays. Look at the F: its corners are off by parts of a unit.</source>
        <translation>Sedam znamenaka pripada koordinati, blizu 1 000 000. Oduzimanje odnosi vodeće, a zaokruživanje ostaje. Pogledajte F: vrhovi su mu pomaknuti za dijelove jedinice.</translation>
    </message>
    <message>
        <source>Half a gap, 0.031 units, of 10. The subtraction leaves the error as it is and takes away the digits before it: from 7 digits 2 or 3 are left.</source>
        <translation>Pola razmaka, 0.031 jedinica, od 10. Oduzimanje ostavlja pogrešku kakva jest i odnosi znamenke ispred nje: od 7 znamenaka ostaju 2 ili 3.</translation>
    </message>
    <message>
        <source>Buy what you need</source>
        <translation>Kupite što trebate</translation>
    </message>
    <message>
        <source>A console of 1994 had no time for more: vertices were drawn at whole pixels, and textures were stretched over the screen without a divide. Turn the camera slowly and watch the corners of the F.</source>
        <translation>Konzola iz 1994. nije imala vremena za više: vrhovi su se crtali na cijelim pikselima, a teksture rastezale po ekranu bez dijeljenja. Polako okrećite kameru i promatrajte vrhove slova F.</translation>
    </message>
    <message>
        <source>Choose a hardware that stores a vertex in fewer than 5 bytes, with a largest measured error below 0.1 pixels in this picture.</source>
        <translation>Odaberite hardver koji vrh sprema u manje od 5 bajtova, s najvećom izmjerenom pogreškom ispod 0.1 piksela na ovoj slici.</translation>
    </message>
    <message>
        <source>8 bits take 3 bytes a vertex. Which others take fewer than 5?</source>
        <translation>8 bitova traži 3 bajta po vrhu. Koji još trebaju manje od 5?</translation>
    </message>
    <message>
        <source>12 bits: 4.5 bytes instead of float32&apos;s 12, and nobody sees the difference in a picture of 320 by 240.</source>
        <translation>12 bitova: 4.5 bajta umjesto 12 kod float32, a na slici od 320 puta 240 nitko ne vidi razliku.</translation>
    </message>
    <message>
        <source>Back to the corner</source>
        <translation>Natrag na vrh</translation>
    </message>
    <message>
        <source>65 536 places were tempting because no screen has so many columns. But the places belong to the scene, and the pixels to the picture: the number that matters is pixels per place, and you change it with every step. The two pictures draw the corner with 16 bits and with float64. So ask for the error in pixels from where you will stand, and buy the bits for that.</source>
        <translation>65 536 mjesta bilo je primamljivo jer nijedan ekran nema toliko stupaca. Ali mjesta pripadaju sceni, a pikseli slici: važan je broj piksela po mjestu, a njega mijenjate svakim korakom. Dvije slike crtaju vrh sa 16 bitova i s float64. Zato pitajte za pogrešku u pikselima odande gdje ćete stajati i za to kupite bitove.</translation>
    </message>
    <message>
        <source>16 bits</source>
        <translation>16 bitova</translation>
    </message>
    <message>
        <source>float64</source>
        <translation>float64</translation>
    </message>
    <message>
        <source>Practise: bits and pixels</source>
        <translation>Vježba: bitovi i pikseli</translation>
    </message>
    <message>
        <source>With {0} bits over a side {1} a coordinate is off by half of {2} at most. Here {3} units, the picture is 240 pixels high, and the field of view is 48°.</source>
        <translation>Uz {0} bitova na stranici {1} koordinata je pomaknuta za najviše pola od {2}. Ovdje je {3} jedinica, slika je visoka 240 piksela, a vidno polje je 48°.</translation>
    </message>
    <message>
        <source>A vertex is at the depth {0}, and its coordinates have {1} bits. By how many pixels is one of them off in the picture at most?</source>
        <translation>Vrh je na dubini {0}, a njegove koordinate imaju {1} bitova. Za koliko je piksela jedna od njih na slici najviše pomaknuta?</translation>
    </message>
    <message>
        <source>This is the distance between two places. The coordinate goes to the nearer one, so it is off by half of it at most. Look at the arrows: each corner goes to the nearer place.</source>
        <translation>To je udaljenost između dvaju mjesta. Koordinata ide na bliže, pa je pomaknuta za najviše pola toga. Pogledajte strelice: svaki vrh ide na bliže mjesto.</translation>
    </message>
    <message>
        <source>This takes the tangent of the whole field of view. Half the picture belongs to half of the angle. Look at the picture at 90°: it is {0} high; {1} would be infinite.</source>
        <translation>Ovo uzima tangens cijelog vidnog polja. Polovici slike pripada polovica kuta. Pogledajte sliku kod 90°: visoka je {0}; {1} bi bio beskonačan.</translation>
    </message>
    <message>
        <source>How many units is a coordinate off at most?</source>
        <translation>Za koliko je jedinica koordinata najviše pomaknuta?</translation>
    </message>
    <message>
        <source>At the depth {0} the picture shows {1} units, from bottom to top, in 240 pixels.</source>
        <translation>Na dubini {0} slika pokazuje {1} jedinica, odozdo do gore, u 240 piksela.</translation>
    </message>
    <message>
        <source>The coordinate is off by up to {0} units, and a unit at this depth has {1} pixels.</source>
        <translation>Koordinata je pomaknuta za najviše {0} jedinica, a jedinica na toj dubini ima {1} piksela.</translation>
    </message>
    <message>
        <source>Practise: far from the origin</source>
        <translation>Vježba: daleko od ishodišta</translation>
    </message>
    <message>
        <source>A float32 has 24 significant bits. The world&apos;s origin is moved away along x, so the coordinates of the F are about as large as the distance of the origin.</source>
        <translation>Broj float32 ima 24 značajna bita. Ishodište svijeta pomiče se duž x, pa su koordinate slova F velike otprilike kao udaljenost ishodišta.</translation>
    </message>
    <message>
        <source>The origin is {0} units away. This number lies between {1} and {2}, which are powers of 2. By how many units is a float32 near it off at most?</source>
        <translation>Udaljenost do ishodišta je {0}. Taj broj leži između {1} i {2}, koji su potencije od 2. Za koliko je jedinica float32 blizu njega najviše pomaknut?</translation>
    </message>
    <message>
        <source>This is the distance between two numbers. A coordinate becomes the nearer one, so it is off by half of it at most. Look at the arrows: each corner goes to the nearer number.</source>
        <translation>To je udaljenost između dvaju brojeva. Koordinata postaje bliži, pa je pomaknuta za najviše pola toga. Pogledajte strelice: svaki vrh ide na bliži broj.</translation>
    </message>
    <message>
        <source>A float32 has 24 bits, and its numbers lie as far apart as the last bit counts: a power of 2, not of 10. Look at the arrows: each corner goes to the nearer number.</source>
        <translation>Broj float32 ima 24 bita, a brojevi su razmaknuti koliko vrijedi posljednji bit: za potenciju od 2, a ne od 10. Pogledajte strelice: svaki vrh ide na bliži broj.</translation>
    </message>
    <message>
        <source>24 bits are 24 halvings</source>
        <translation>24 bita su 24 polovljenja</translation>
    </message>
    <message>
        <source>This counts 25 bits. The first of 24 bits counts {0}, so the last one counts {1}{2}: from the first to the last it is halved 23 times. Look at the arrows: each corner goes to the nearer number.</source>
        <translation>Ovo broji 25 bitova. Prvi od 24 bita vrijedi {0}, pa posljednji vrijedi {1}{2}: od prvog do posljednjeg polovi se 23 puta. Pogledajte strelice: svaki vrh ide na bliži broj.</translation>
    </message>
    <message>
        <source>The first bit counts {0}, the second half of that. What does bit 24 count?</source>
        <translation>Prvi bit vrijedi {0}, drugi pola toga. Koliko vrijedi bit 24?</translation>
    </message>
    <message>
        <source>The numbers are as far apart as bit 24 counts.</source>
        <translation>Brojevi su razmaknuti koliko vrijedi bit 24.</translation>
    </message>
    <message>
        <source>Bit 24 counts {0}{1}, and half of that is the largest error.</source>
        <translation>Bit 24 vrijedi {0}{1}, a pola toga je najveća pogreška.</translation>
    </message>
    <message>
        <source>Practise: stand where it is good enough</source>
        <translation>Vježba: stanite gdje je dovoljno dobro</translation>
    </message>
    <message>
        <source>With 8 bits over 8 units a coordinate is off by half of {0} at most. The field of view is 53.13°: at the depth {1} the picture is exactly {2} units high.</source>
        <translation>S 8 bitova na 8 jedinica koordinata je pomaknuta za najviše pola od {0}. Vidno polje je 53.13°: na dubini {1} slika je visoka točno {2} jedinica.</translation>
    </message>
    <message>
        <source>Keep the 8 bits and the {0} pixels of height, and move the camera until a coordinate of a vertex at the target is off by up to {1} pixels.</source>
        <translation>Zadržite 8 bitova i visinu od {0} piksela i pomičite kameru dok koordinata vrha kod cilja ne bude pomaknuta za najviše {1} piksela.</translation>
    </message>
    <message>
        <source>This takes the distance between two places for the error. The coordinate goes to the nearer place, so it is off by half of that at most. Look at the F from where you stand: it is smaller than it has to be.</source>
        <translation>Ovo uzima udaljenost između dvaju mjesta kao pogrešku. Koordinata ide na bliže, pa je pomaknuta za najviše pola toga. Pogledajte F odande gdje stojite: manji je nego što mora biti.</translation>
    </message>
    <message>
        <source>How many units is a coordinate off at most? And how many pixels has a unit at the target?</source>
        <translation>Za koliko je jedinica koordinata najviše pomaknuta? A koliko piksela ima jedinica kod cilja?</translation>
    </message>
    <message>
        <source>{0} must be {1}.</source>
        <translation>{0} mora biti {1}.</translation>
    </message>
</context>
<context>
    <name>l26-small-errors</name>
    <message>
        <source>Small errors that grow</source>
        <translation>Male pogreške koje rastu</translation>
    </message>
    <message>
        <source>Round and round</source>
        <translation>Ukrug i ukrug</translation>
    </message>
    <message>
        <source>A camera turns by 1° a frame: each frame multiplies its axes by the same matrix, in float32, and every product is rounded. After 360 frames it should be home. It is off by 0.003 pixels. In **Image** this is drawn 20 000 times as large, beside the pale true picture.</source>
        <translation>Kamera se okreće za 1° po kadru: svaki kadar množi njezine osi istom matricom, u float32, i svaki se umnožak zaokružuje. Nakon 360 kadrova trebala bi biti na početku. Pogreška je 0.003 piksela. U oknu **Slika** to je nacrtano 20 000 puta veće, uz blijedu pravu sliku.</translation>
    </message>
    <message>
        <source>Now the axes are made orthonormal every tenth frame, with a fast inverse square root that is off by up to 0.18 %. The numbers are still float32. How far off is the picture after one round?</source>
        <translation>Sada se osi svakih deset kadrova ortonormiraju, brzim inverznim korijenom koji griješi do 0.18 %. Brojevi su i dalje float32. Kolika je pogreška slike nakon jednog kruga?</translation>
    </message>
    <message>
        <source>0.003 pixels, as before: float32 has 7 digits, so a round of 360 steps keeps 5</source>
        <translation>0.003 piksela, kao prije: float32 ima 7 znamenaka, pa krug od 360 koraka čuva 5</translation>
    </message>
    <message>
        <source>The format has its 7 digits, but each step uses a root that has 3. Look at the two letters: they are 6 pixels apart.</source>
        <translation>Format ima svojih 7 znamenaka, ali svaki korak koristi korijen koji ih ima 3. Pogledajte dva slova: razmaknuta su 6 piksela.</translation>
    </message>
    <message>
        <source>Less than before: renormalising puts the axes right</source>
        <translation>Manja nego prije: renormiranje ispravlja osi</translation>
    </message>
    <message>
        <source>It puts their lengths right, not where they point to. Look at the two letters: they are farther apart than without it.</source>
        <translation>Ispravlja njihove duljine, a ne smjer u kojem pokazuju. Pogledajte dva slova: razmaknuta su više nego bez toga.</translation>
    </message>
    <message>
        <source>About 6 pixels</source>
        <translation>Oko 6 piksela</translation>
    </message>
    <message>
        <source>One axis comes out shorter than the others by 0.17 %. Each turn mixes the three, so each turn is a little too large or too small, always in the same direction.</source>
        <translation>Jedna os ispadne 0.17 % kraća od ostalih. Svaki zakret miješa sve tri, pa je svaki zakret malo prevelik ili premalen, uvijek u istom smjeru.</translation>
    </message>
    <message>
        <source>The same error again and again</source>
        <translation>Ista pogreška, opet i opet</translation>
    </message>
    <message>
        <source>Such an error is no chance. Each round adds about as much as the one before, and the errors of {0} rounds are {1} times as large. After one round the dock says that an axis leans by {2}.</source>
        <translation>Takva pogreška nije slučajna. Svaki krug dodaje otprilike koliko i prethodni, pa su pogreške nakon {0} krugova {1} puta veće. Nakon jednog kruga bočna ploča kaže da je os nagnuta za {2}.</translation>
    </message>
    <message>
        <source>Turn the camera until the picture is off by more than 50 pixels, with nothing else changed.</source>
        <translation>Okrećite kameru dok pogreška slike ne bude veća od 50 piksela, a ništa drugo ne mijenjajte.</translation>
    </message>
    <message>
        <source>How many rounds is that, at 6 pixels a round?</source>
        <translation>Koliko je to krugova, po 6 piksela na krug?</translation>
    </message>
    <message>
        <source>Move Rounds to the right.</source>
        <translation>Pomaknite klizač Krugova udesno.</translation>
    </message>
    <message>
        <source>9 or 10 rounds are enough: a minute at 60 frames a second.</source>
        <translation>Dovoljno je 9 ili 10 krugova: minuta pri 60 kadrova u sekundi.</translation>
    </message>
    <message>
        <source>An axis leans by 0.5° and the field of view is 40° in a picture of 720 lines. By how many pixels does that move what is in the middle of the picture, at most?</source>
        <translation>Os je nagnuta za 0.5°, a vidno polje je 40° na slici od 720 redaka. Za koliko piksela to najviše pomiče ono što je u sredini slike?</translation>
    </message>
    <message>
        <source>This gives every degree as many pixels. In the middle a degree has fewer of them than at the border. Look at the picture at 140°: there the difference is large.</source>
        <translation>Ovo svakom stupnju daje jednako mnogo piksela. U sredini ih stupanj ima manje nego na rubu. Pogledajte sliku kod 140°: ondje je razlika velika.</translation>
    </message>
    <message>
        <source>The middle is at the distance 1 on a plane that is {0} high and has 720 pixels, and it moves by {1}.</source>
        <translation>Sredina je na udaljenosti 1, na ravnini visokoj {0} sa 720 piksela, i pomiče se za {1}.</translation>
    </message>
    <message>
        <source>How high is a plane at the distance 1, and by how much does the middle move on it?</source>
        <translation>Koliko je visoka ravnina na udaljenosti 1 i za koliko se na njoj pomiče sredina?</translation>
    </message>
    <message>
        <source>Lengths come back, directions do not</source>
        <translation>Duljine se vraćaju, smjerovi ne</translation>
    </message>
    <message>
        <source>With exact roots, renormalising is worth something: it keeps the lengths to all digits. But nobody remembers where the axes should point to.</source>
        <translation>S točnim korijenima renormiranje nešto vrijedi: čuva duljine na sve znamenke. Ali nitko ne pamti kamo bi osi trebale pokazivati.</translation>
    </message>
    <message>
        <source>100 rounds of products alone make an axis too long or too short by 0.043 %. Make that less than 0.000001 %, and leave the rounds and the format as they are.</source>
        <translation>100 krugova samih umnožaka čini os predugom ili prekratkom za 0.043 %. Neka to bude manje od 0.000001 %, a krugove i format ostavite kakvi jesu.</translation>
    </message>
    <message>
        <source>That is another way: it makes the axes afresh from the angle of each frame, and multiplies nothing. Look at *Turned by*: one of the others keeps the products and mends the lengths.</source>
        <translation>To je drugi način: osi iznova računa iz kuta svakog kadra i ništa ne množi. Pogledajte *Okrenuto za*: jedan od ostalih zadržava umnoške i popravlja duljine.</translation>
    </message>
    <message>
        <source>Which way divides each axis by its length, and exactly?</source>
        <translation>Koji način dijeli svaku os njezinom duljinom, i to egzaktno?</translation>
    </message>
    <message>
        <source>The lengths are right to ten digits. But an axis still leans by 0.0008°: less than before, and not nothing.</source>
        <translation>Duljine su točne na deset znamenaka. Ali os je i dalje nagnuta za 0.0008°: manje nego prije, ali nije nula.</translation>
    </message>
    <message>
        <source>A step that is too small</source>
        <translation>Premalen korak</translation>
    </message>
    <message>
        <source>The eye moves to the right, by 1 mm a frame. A unit is 1 m, and the origin of the coordinates is 50 km away: the eye&apos;s x is 30 000. In **Image** each frame has its own line, from top to bottom: how far P has moved across, beside the smooth path.</source>
        <translation>Kamera se pomiče udesno, za 1 mm po kadru. Jedinica je 1 m, a ishodište koordinata udaljeno je 50 km: x kamere je 30 000. U oknu **Slika** svaki kadar ima svoju crtu, odozgo prema dolje: koliko se P pomaknula u širinu, uz glatki put.</translation>
    </message>
    <message>
        <source>x lies between {0} and {1}. How many millimetres are two neighbouring float32 apart there?</source>
        <translation>x leži između {0} i {1}. Koliko su milimetara ondje razmaknuta dva susjedna broja float32?</translation>
    </message>
    <message>
        <source>A float32 has 24 bits, and its numbers lie as far apart as the last of them counts: a power of 2. Look at the frames: P stands still in half of them, not in two of three.</source>
        <translation>Broj float32 ima 24 bita, a brojevi su razmaknuti koliko vrijedi posljednji od njih: za potenciju od 2. Pogledajte kadrove: P miruje u polovici njih, a ne u dva od tri.</translation>
    </message>
    <message>
        <source>The first of 24 bits counts {0} m, the last one {1} m: 1.95 mm. The eye moves by 1 mm, so it stands still in about every second frame.</source>
        <translation>Prvi od 24 bita vrijedi {0} m, posljednji {1} m: 1.95 mm. Kamera se pomiče za 1 mm, pa stoji otprilike u svakom drugom kadru.</translation>
    </message>
    <message>
        <source>The first bit counts {0}. What does bit 24 count?</source>
        <translation>Prvi bit vrijedi {0}. Koliko vrijedi bit 24?</translation>
    </message>
    <message>
        <source>From the middle of the Earth</source>
        <translation>Od središta Zemlje</translation>
    </message>
    <message>
        <source>Maps of the whole Earth measure from its middle, 6 371 km away.</source>
        <translation>Karte cijele Zemlje mjere od njezina središta, udaljenog 6 371 km.</translation>
    </message>
    <message>
        <source>The origin moves there. How far does P jump from one frame to the next, at most?</source>
        <translation>Ishodište se premješta onamo. Koliko P najviše skoči od jednog kadra do sljedećeg?</translation>
    </message>
    <message>
        <source>0.4 pixels, as from 50 km: the eye moves by a millimetre, and both numbers keep 7 digits</source>
        <translation>0.4 piksela, kao s 50 km: kamera se pomiče za milimetar, a oba broja čuvaju 7 znamenaka</translation>
    </message>
    <message>
        <source>The seven digits of 3 822 600 are all before the point. Look at the path: it stands still, and then jumps once.</source>
        <translation>Svih sedam znamenaka broja 3 822 600 ispred je zareza. Pogledajte put: miruje, zatim jednom skoči.</translation>
    </message>
    <message>
        <source>40 pixels</source>
        <translation>40 piksela</translation>
    </message>
    <message>
        <source>Not at all: the eye moves by less than the numbers can say</source>
        <translation>Nimalo: kamera se pomiče za manje nego što brojevi mogu reći</translation>
    </message>
    <message>
        <source>Too small a step never counts</source>
        <translation>Premalen korak nikad se ne računa</translation>
    </message>
    <message>
        <source>The eye is not where it was stored: it goes on, and at some frame another float32 is nearer. Look at the path: there it jumps by all that was missed.</source>
        <translation>Kamera nije ondje gdje je spremljena: ona ide dalje, i u nekom je kadru bliži drugi float32. Pogledajte put: ondje skoči za sve što je propušteno.</translation>
    </message>
    <message>
        <source>Neighbouring float32 are 0.25 m apart there, and 0.25 m at P fill 40 pixels.</source>
        <translation>Susjedni brojevi float32 ondje su razmaknuti 0.25 m, a 0.25 m kod P zauzima 40 piksela.</translation>
    </message>
    <message>
        <source>Subtract first</source>
        <translation>Najprije oduzmite</translation>
    </message>
    <message>
        <source>What is large is not needed: only the difference of vertex and eye is drawn. If both are measured from the object, or in two floats each, small differences stay small.</source>
        <translation>Ono što je veliko nije potrebno: crta se samo razlika vrha i kamere. Ako se oboje mjeri od objekta, ili svako u dva broja float, male razlike ostaju male.</translation>
    </message>
    <message>
        <source>Make P move smoothly, by less than 0.2 pixels in every frame, with the origin still in the middle of the Earth.</source>
        <translation>Neka se P pomiče glatko, za manje od 0.2 piksela u svakom kadru, a ishodište neka ostane u središtu Zemlje.</translation>
    </message>
    <message>
        <source>Which coordinates are large without need?</source>
        <translation>Koje su koordinate velike bez potrebe?</translation>
    </message>
    <message>
        <source>From the object it costs nothing: the same 12 bytes a vertex, and the same one subtraction. Two floats cost twice the bytes and three times the work, and need no object.</source>
        <translation>Od objekta ne stoji ništa: istih 12 bajtova po vrhu i isto jedno oduzimanje. Dva broja float stoje dvostruko više bajtova i triput više posla, a ne trebaju objekt.</translation>
    </message>
    <message>
        <source>Practise: from a lean to pixels</source>
        <translation>Vježba: od nagiba do piksela</translation>
    </message>
    <message>
        <source>A camera that leans by {0} moves the middle of a picture of {1} pixels by {2} at most.</source>
        <translation>Kamera nagnuta za {0} pomiče sredinu slike od {1} piksela za najviše {2}.</translation>
    </message>
    <message>
        <source>Each round adds {0}° to the lean, and the camera goes {1} rounds. The field of view is {2}°, and the picture is 720 pixels high. By how many pixels has its middle moved at most?</source>
        <translation>Svaki krug dodaje nagibu {0}°, a broj krugova je {1}. Vidno polje je {2}°, a slika je visoka 720 piksela. Za koliko se piksela njezina sredina najviše pomaknula?</translation>
    </message>
    <message>
        <source>A round is a round</source>
        <translation>Krug je krug</translation>
    </message>
    <message>
        <source>This is the drift of one round. The next round begins where this one ended, and adds its own. Look at the picture after {0} rounds: the letters are farther apart.</source>
        <translation>To je odlutavanje jednog kruga. Sljedeći krug počinje gdje je ovaj završio i dodaje svoje. Pogledajte sliku nakon {0}. kruga: slova su više razmaknuta.</translation>
    </message>
    <message>
        <source>This takes the tangent of the whole field of view. Half the picture belongs to half of the angle. Look at the picture at 90°: it is {0} high at the distance 1; {1} would be infinite.</source>
        <translation>Ovo uzima tangens cijelog vidnog polja. Polovici slike pripada polovica kuta. Pogledajte sliku kod 90°: na udaljenosti 1 visoka je {0}; {1} bi bio beskonačan.</translation>
    </message>
    <message>
        <source>By how many degrees does it lean after {0} rounds?</source>
        <translation>Za koliko je stupnjeva nagnuta nakon {0}. kruga?</translation>
    </message>
    <message>
        <source>At the distance 1 the picture is {0} high, and the middle moves by {1}.</source>
        <translation>Na udaljenosti 1 slika je visoka {0}, a sredina se pomiče za {1}.</translation>
    </message>
    <message>
        <source>It leans by {0}°, and {1} pixels lie between.</source>
        <translation>Nagnuta je za {0}°, a između je {1} piksela.</translation>
    </message>
    <message>
        <source>Practise: from a gap to pixels</source>
        <translation>Vježba: od razmaka do piksela</translation>
    </message>
    <message>
        <source>A float32 has 24 bits. Between {0} and {1} its numbers are {2} apart, and an eye that creeps along jumps by that much at a time.</source>
        <translation>Broj float32 ima 24 bita. Između {0} i {1} njegovi su brojevi razmaknuti {2}, a kamera koja se polako pomiče skače svaki put za toliko.</translation>
    </message>
    <message>
        <source>The eye&apos;s x lies between {0} m and {1} m, which are powers of 2, and it moves along x. By how many pixels does a vertex jump at a time, at the depth {2} m? The picture is 1080 pixels high, with a field of view of 40°.</source>
        <translation>x kamere leži između {0} m i {1} m, koji su potencije od 2, i ona se pomiče duž x. Za koliko piksela svaki put skoči vrh na dubini {2} m? Slika je visoka 1080 piksela, s vidnim poljem od 40°.</translation>
    </message>
    <message>
        <source>An eye is off by half a gap</source>
        <translation>Kamera je pomaknuta za pola razmaka</translation>
    </message>
    <message>
        <source>Half a gap is how far off the eye is at most, before and after. It goes from one float32 to the next one, by a whole gap. Look at the path: each jump goes from one side of the smooth path to the other.</source>
        <translation>Za pola razmaka kamera je najviše pomaknuta, prije i poslije. Od jednog broja float32 do sljedećeg ide za cijeli razmak. Pogledajte put: svaki skok ide s jedne strane glatkog puta na drugu.</translation>
    </message>
    <message>
        <source>24 bits are 23 halvings</source>
        <translation>24 bita su 23 polovljenja</translation>
    </message>
    <message>
        <source>This counts 23 bits. The first bit counts {0}, and from the first to the last it is halved 23 times. Look at the path: its jumps are half as wide.</source>
        <translation>Ovo broji 23 bita. Prvi bit vrijedi {0}, a od prvog do posljednjeg polovi se 23 puta. Pogledajte put: skokovi su mu upola manji.</translation>
    </message>
    <message>
        <source>What does the last of 24 bits count, if the first one counts {0}?</source>
        <translation>Koliko vrijedi posljednji od 24 bita ako prvi vrijedi {0}?</translation>
    </message>
    <message>
        <source>At the depth {0} a metre has {1} pixels.</source>
        <translation>Na dubini {0} metar ima {1} piksela.</translation>
    </message>
    <message>
        <source>The gap is {0}{1} m, and a metre has {2} pixels.</source>
        <translation>Razmak je {0}{1} m, a metar ima {2} piksela.</translation>
    </message>
</context>
<context>
    <name>l27-where-precision-goes</name>
    <message>
        <source>Where does precision go?</source>
        <translation>Kamo odlazi preciznost?</translation>
    </message>
    <message>
        <source>The floor behind the wall</source>
        <translation>Pod iza zida</translation>
    </message>
    <message>
        <source>A logarithmic depth has digits for every distance. Here it is computed at each vertex, as it is cheap there, and the floor from near to far is one piece. In **Image** you see the wall&apos;s foundation, which is below the floor: the floor is drawn behind it. The dock says how far off it is: up to 3.53 times too far.</source>
        <translation>Logaritamska dubina ima znamenke za svaku udaljenost. Ovdje se računa u svakom vrhu, jer je ondje jeftina, a pod od bliske do daleke ravnine jedan je komad. U oknu **Slika** vidite temelj zida, koji je ispod poda: pod se crta iza njega. Bočna ploča kaže kolika je pogreška: do 3.53 puta dalje nego što treba.</translation>
    </message>
    <message>
        <source>Far moves from 30 to 1000, and the floor with it, still one piece. Up to how many times too far is it drawn?</source>
        <translation>Daleka ravnina pomiče se s 30 na 1000, a s njom i pod, i dalje jedan komad. Koliko se puta dalje nego što treba tada najviše crta?</translation>
    </message>
    <message>
        <source>Still 3.5 times: that is what a logarithm is for</source>
        <translation>I dalje 3.5 puta: logaritam tome i služi</translation>
    </message>
    <message>
        <source>A logarithm would be right at each pixel, whatever far is. Between two vertices it is interpolated, and the error grows with the ratio of their distances. Look at the diagram: the curve stands far above the line in between.</source>
        <translation>U svakom pikselu logaritam bi bio točan, kolika god bila udaljenost daleke ravnine. Između dvaju vrhova on se interpolira, i pogreška raste s omjerom njihovih udaljenosti. Pogledajte dijagram: između je krivulja daleko iznad pravca.</translation>
    </message>
    <message>
        <source>53.6 times</source>
        <translation>53.6 puta</translation>
    </message>
    <message>
        <source>1.15 times: the digits are spread over a longer range, as evenly as before</source>
        <translation>1.15 puta: znamenke su raspoređene po duljem rasponu, jednoliko kao prije</translation>
    </message>
    <message>
        <source>The digits are not the trouble. Between its two ends the floor gets the depth that a straight line has, and the logarithm bends away from it. Look at the diagram: the curve stands far above the line in between.</source>
        <translation>Nevolja nije u znamenkama. Između svojih dvaju krajeva pod dobiva dubinu koju ima pravac, a logaritam se od njega otklanja. Pogledajte dijagram: između je krivulja daleko iznad pravca.</translation>
    </message>
    <message>
        <source>Only the two ends of the floor have the right depth. The nearest and the farthest vertex are now 1000 times as far apart as near is from the eye.</source>
        <translation>Ispravnu dubinu imaju samo dva kraja poda. Razmak najbližeg i najudaljenijeg vrha sada je 1000 puta veći od udaljenosti bliske ravnine od kamere.</translation>
    </message>
    <message>
        <source>One over w, and log w</source>
        <translation>Jedan kroz w i log w</translation>
    </message>
    <message>
        <source>On the screen {0} is linear along a face. A piece runs from the distance {1} to {2}. At the share {3} of it on the screen,</source>
        <translation>Na ekranu je {0} duž strane linearno. Komad ide od udaljenosti {1} do {2}. Na njegovu udjelu {3} na ekranu je</translation>
    </message>
    <message>
        <source>Interpolated linearly, the logarithms of {0} and {1} give {2} instead. That is too far by the factor</source>
        <translation>Linearno interpolirani, logaritmi od {0} i {1} daju umjesto toga {2}. To je predaleko za faktor</translation>
    </message>
    <message>
        <source>Half-way, that is {0}: with {1}, 2.83.</source>
        <translation>Na pola puta to je {0}: uz {1}, 2.83.</translation>
    </message>
    <message>
        <source>Near is 1 and far is 100. How many times too far is the floor drawn, half-way along it on the screen?</source>
        <translation>Bliska ravnina je na 1, daleka na 100. Koliko se puta dalje nego što treba crta pod, na pola puta na ekranu?</translation>
    </message>
    <message>
        <source>Half-way is half the distance</source>
        <translation>Na pola puta je pola udaljenosti</translation>
    </message>
    <message>
        <source>This takes half the distance, 50.5, for the true place. Half-way on the screen is much nearer: there {0} is half-way, and {1}. Look at the diagram: drawn is never nearer than true.</source>
        <translation>Ovo uzima pola udaljenosti, 50.5, kao pravo mjesto. Pola puta na ekranu mnogo je bliže: ondje je {0} na polovici, i {1}. Pogledajte dijagram: nacrtano nikad nije bliže od pravoga.</translation>
    </message>
    <message>
        <source>This would be right if {0} were linear on the screen. Only {1} is. Look at the foundation: the floor is drawn behind it.</source>
        <translation>To bi bilo točno kad bi {0} na ekranu bilo linearno. Linearno je samo {1}. Pogledajte temelj: pod se crta iza njega.</translation>
    </message>
    <message>
        <source>It is drawn at {0}, and lies at {1}.</source>
        <translation>Crta se na {0}, a leži na {1}.</translation>
    </message>
    <message>
        <source>Where is it drawn, and where does it lie?</source>
        <translation>Gdje se crta, a gdje leži?</translation>
    </message>
    <message>
        <source>Shorter pieces</source>
        <translation>Kraći komadi</translation>
    </message>
    <message>
        <source>The factor depends on the ratio {0} of a piece alone. In {1} pieces of equal length from 1 to 30 the nearest one has {2}, and it is the worst.</source>
        <translation>Faktor ovisi samo o omjeru {0} komada. Kod {1} jednako dugih komada od 1 do 30 najbliži ima {2}, i on je najgori.</translation>
    </message>
    <message>
        <source>Draw the floor nowhere more than 1.2 times too far, and still compute the logarithm at the vertices only.</source>
        <translation>Nacrtajte pod tako da nigdje nije više od 1.2 puta dalje nego što treba, a logaritam se i dalje računa samo u vrhovima.</translation>
    </message>
    <message>
        <source>What makes the ratio of the nearest piece small?</source>
        <translation>Što čini omjer najbližeg komada malim?</translation>
    </message>
    <message>
        <source>Move Pieces of the floor to the right.</source>
        <translation>Pomaknite klizač Komada poda udesno.</translation>
    </message>
    <message>
        <source>13 pieces are enough here. From 1 to 1000 it takes 419: the near pieces need to be short, and the far ones are shorter than they have to be.</source>
        <translation>Ovdje je dovoljno 13 komada. Od 1 do 1000 treba ih 419: bliski komadi moraju biti kratki, a daleki su kraći nego što moraju.</translation>
    </message>
    <message>
        <source>Light through the seam</source>
        <translation>Svjetlo kroz šav</translation>
    </message>
    <message>
        <source>Two meshes share a seam, vertex by vertex. Each stores its coordinates in 8 bits over its own box: the left one is 10 units wide, the right one 3. A vertex of the seam is rounded twice, to two places, and the light behind comes through.</source>
        <translation>Dvije mreže dijele šav, vrh po vrh. Svaka sprema svoje koordinate u 8 bitova nad vlastitim kvadrom: lijevi je širok 10 jedinica, desni 3. Vrh šava zaokružuje se dvaput, na dva mjesta, i svjetlo straga prolazi.</translation>
    </message>
    <message>
        <source>Now 12 bits instead of 8. To how much of it does the largest possible gap shrink?</source>
        <translation>Sada 12 bitova umjesto 8. Na koliki se svoj dio smanji najveći mogući procjep?</translation>
    </message>
    <message>
        <source>To 66.7 %</source>
        <translation>Na 66.7 %</translation>
    </message>
    <message>
        <source>This counts the bits. Each of them halves both steps, so 4 bits make the gap {0} times as narrow. Look at the seam with 12 bits: it is closed for your eye.</source>
        <translation>Ovo broji bitove. Svaki od njih prepolovi oba koraka, pa 4 bita čine procjep {0} puta užim. Pogledajte šav s 12 bitova: za vaše je oko zatvoren.</translation>
    </message>
    <message>
        <source>To 6.23 %</source>
        <translation>Na 6.23 %</translation>
    </message>
    <message>
        <source>To nothing: with 12 bits no error can be seen, so the seam is closed</source>
        <translation>Ni na što: s 12 bitova nijedna se pogreška ne vidi, pa je šav zatvoren</translation>
    </message>
    <message>
        <source>It is hardly seen from here, but it is there: 1.3 px at most. From ten times as near it would be 13 px. Look at the seam from nearer by.</source>
        <translation>Odavde se jedva vidi, ali postoji: najviše 1.3 px. S deset puta manje udaljenosti bio bi 13 px. Pogledajte šav izbliza.</translation>
    </message>
    <message>
        <source>A step is the box over {0}: with 4 bits more it is 16 times as short.</source>
        <translation>Korak je kvadar kroz {0}: s 4 bita više 16 puta je kraći.</translation>
    </message>
    <message>
        <source>Half a step, and half a step</source>
        <translation>Pola koraka i pola koraka</translation>
    </message>
    <message>
        <source>On a grid of step {0} a coordinate moves by at most {1}, on another of step {2} by {3}. If they move apart, the copies of the vertex are {4} apart along an axis, and {5} across both. With 8 bits {6} and {7}.</source>
        <translation>Na rešetki s korakom {0} koordinata se pomiče za najviše {1}, na drugoj s korakom {2} za {3}. Ako se pomaknu jedna od druge, kopije vrha razmaknute su {4} duž osi, a {5} po objema. Uz 8 bitova je {6} i {7}.</translation>
    </message>
    <message>
        <source>By how many units are the two copies of a vertex apart at most, along one axis, with 8 bits?</source>
        <translation>Koliko su jedinica dvije kopije vrha najviše razmaknute, duž jedne osi, uz 8 bitova?</translation>
    </message>
    <message>
        <source>Only the coarse one errs</source>
        <translation>Griješi samo gruba</translation>
    </message>
    <message>
        <source>This lets only the larger mesh round. The smaller one rounds, too, and may go the other way. Look at the diagram: some gaps are wider than yours.</source>
        <translation>Ovo pušta da zaokružuje samo veća mreža. Zaokružuje i manja, a može i na drugu stranu. Pogledajte dijagram: neki su procjepi širi od vašega.</translation>
    </message>
    <message>
        <source>The gap is the error</source>
        <translation>Razmak je pogreška</translation>
    </message>
    <message>
        <source>A coordinate goes to the nearer place, so each mesh is off by half a step at most. Look at the diagram: no gap reaches the line.</source>
        <translation>Koordinata ide na bliže mjesto, pa svaka mreža griješi za najviše pola koraka. Pogledajte dijagram: nijedan procjep ne doseže crtu.</translation>
    </message>
    <message>
        <source>{0}. From 1.6 units away, a picture of 1080 lines has 585 px a unit: 14.9 px along an axis, and 21.1 px across both.</source>
        <translation>{0}. S udaljenosti od 1.6 jedinica slika od 1080 redaka ima 585 px po jedinici: 14.9 px duž osi i 21.1 px po objema.</translation>
    </message>
    <message>
        <source>Each copy is off by half of its own step.</source>
        <translation>Svaka je kopija pomaknuta za pola vlastitog koraka.</translation>
    </message>
    <message>
        <source>More bits make the gap narrower and never close it. What would?</source>
        <translation>Više bitova sužava procjep i nikad ga ne zatvara. Što bi ga zatvorilo?</translation>
    </message>
    <message>
        <source>Close the seam, and keep the 3 bytes a vertex.</source>
        <translation>Zatvorite šav i zadržite 3 bajta po vrhu.</translation>
    </message>
    <message>
        <source>Why does the same vertex come to lie at two places?</source>
        <translation>Zašto isti vrh dospije na dva mjesta?</translation>
    </message>
    <message>
        <source>Let both meshes round to the same places.</source>
        <translation>Neka obje mreže zaokružuju na ista mjesta.</translation>
    </message>
    <message>
        <source>A common grid: the same vertex, the same grid, the same place. The smaller mesh pays: the vertices of its seam move more than four times as far as on a grid of its own.</source>
        <translation>Zajednička rešetka: isti vrh, ista rešetka, isto mjesto. Plaća manja mreža: vrhovi njezina šava pomiču se više od četiri puta dalje nego na vlastitoj rešetki.</translation>
    </message>
    <message>
        <source>Back from the picture</source>
        <translation>Natrag sa slike</translation>
    </message>
    <message>
        <source>A pixel and its depth lead back to the point P: multiply with the inverse of {0}. Everything is float32, and the world&apos;s origin is 1 unit from the eye.</source>
        <translation>Piksel i njegova dubina vode natrag do točke P: pomnožite s inverzom od {0}. Sve je float32, a ishodište svijeta je 1 jedinicu od kamere.</translation>
    </message>
    <message>
        <source>The origin moves to 100 000 units from the eye. How far from P is the point that the inverse leads back to?</source>
        <translation>Ishodište se premješta na 100 000 jedinica od kamere. Koliko je daleko od P točka do koje inverz vodi natrag?</translation>
    </message>
    <message>
        <source>Nowhere: an inverse undoes what the matrix did</source>
        <translation>Nimalo: inverz poništava ono što je matrica učinila</translation>
    </message>
    <message>
        <source>On paper it does. Here each product is rounded, and the eye&apos;s coordinates are 100 000: they hide the few units that you are after. Look at P and at the point that came back.</source>
        <translation>Na papiru da. Ovdje se svaki umnožak zaokružuje, a koordinate kamere su 100 000: one skrivaju onih nekoliko jedinica koje tražite. Pogledajte P i točku koja se vratila.</translation>
    </message>
    <message>
        <source>By a ten-millionth of its distance: a float32 keeps seven digits</source>
        <translation>Za desetmilijuntinu svoje udaljenosti: float32 čuva sedam znamenaka</translation>
    </message>
    <message>
        <source>The seven digits belong to the coordinates, near 100 000. What is left of P&apos;s distance, 8.3 units, has two. Look at P and at the point that came back.</source>
        <translation>Sedam znamenaka pripada koordinatama, blizu 100 000. Od udaljenosti točke P, 8.3 jedinice, preostale su dvije. Pogledajte P i točku koja se vratila.</translation>
    </message>
    <message>
        <source>By several per cent of its distance</source>
        <translation>Za nekoliko postotaka svoje udaljenosti</translation>
    </message>
    <message>
        <source>The inverse multiplies the eye&apos;s coordinates with {0}, a small difference of rounded numbers.</source>
        <translation>Inverz množi koordinate kamere s {0}, malom razlikom zaokruženih brojeva.</translation>
    </message>
    <message>
        <source>Bring the point to within 1 % of its distance, in float32 and with the origin where it is.</source>
        <translation>Dovedite točku na najviše 1 % njezine udaljenosti, u float32 i s ishodištem gdje jest.</translation>
    </message>
    <message>
        <source>Which way back does not multiply the eye with anything?</source>
        <translation>Koji put natrag ne množi položaj kamere ničim?</translation>
    </message>
    <message>
        <source>Choose *Ray times depth*.</source>
        <translation>Odaberite *Zraka puta dubina*.</translation>
    </message>
    <message>
        <source>The ray is multiplied with the depth, and the eye is added at the end: it is rounded once.</source>
        <translation>Zraka se množi dubinom, a položaj kamere pribraja se na kraju: zaokružuje se jednom.</translation>
    </message>
    <message>
        <source>Back to the floor</source>
        <translation>Natrag na pod</translation>
    </message>
    <message>
        <source>“Logarithmic depth is always better” is tempting: its digits are spread as distances need them. But digits are half of the story. A number is stored at some places, and used at others: depths between the vertices, positions in the grid of another mesh. Precision goes where two ways of rounding meet. Choose *each pixel* and watch the foundation disappear.</source>
        <translation>„Logaritamska dubina uvijek je bolja” zvuči primamljivo: znamenke su joj raspoređene kako ih udaljenosti trebaju. Ali znamenke su pola priče. Broj se sprema na jednim mjestima, a koristi na drugima: dubine između vrhova, položaji na rešetki druge mreže. Preciznost odlazi ondje gdje se sretnu dva načina zaokruživanja. Odaberite *svaki piksel* i promatrajte kako temelj nestaje.</translation>
    </message>
    <message>
        <source>Practise: half-way</source>
        <translation>Vježba: na pola puta</translation>
    </message>
    <message>
        <source>A floor is one piece from near to far. Its logarithmic depth is computed at the vertices, and between them the rasteriser interpolates it linearly on the screen.</source>
        <translation>Pod je jedan komad od bliske do daleke ravnine. Njegova se logaritamska dubina računa u vrhovima, a između njih rasterizator je interpolira linearno na ekranu.</translation>
    </message>
    <message>
        <source>Near is {0}, far is {1}. Half-way along the floor on the screen: how many times too far is it drawn?</source>
        <translation>Bliska ravnina je na {0}, daleka na {1}. Na pola puta po podu na ekranu: koliko se puta dalje nego što treba crta?</translation>
    </message>
    <message>
        <source>This takes half the distance for the true place. Half-way on the screen {0} is half-way, and {1} is much nearer. Look at the foundation: the floor is drawn behind it, not before it.</source>
        <translation>Ovo uzima pola udaljenosti kao pravo mjesto. Na pola puta na ekranu {0} je na polovici, a {1} je mnogo bliže. Pogledajte temelj: pod se crta iza njega, a ne ispred.</translation>
    </message>
    <message>
        <source>It lies at near</source>
        <translation>Leži na bliskoj ravnini</translation>
    </message>
    <message>
        <source>This is where it is drawn, over near. But it lies farther away than near: {0} is half-way between {1} and {2}. Look at the diagram: half-way on the screen is a little to the right of near.</source>
        <translation>Ovo je mjesto gdje se crta, kroz udaljenost bliske ravnine. Ali pod leži dalje od bliske ravnine: {0} je na pola puta između {1} i {2}. Pogledajte dijagram: pola puta na ekranu malo je desno od bliske ravnine.</translation>
    </message>
    <message>
        <source>It is drawn at {0}, half-way between the logarithms.</source>
        <translation>Crta se na {0}, na pola puta između logaritama.</translation>
    </message>
    <message>
        <source>It lies at {0}.</source>
        <translation>Leži na {0}.</translation>
    </message>
    <message>
        <source>Drawn at {0}, it lies at {1}.</source>
        <translation>Nacrtan na {0}, leži na {1}.</translation>
    </message>
    <message>
        <source>Practise: the widest gap</source>
        <translation>Vježba: najširi procjep</translation>
    </message>
    <message>
        <source>The field of view is 53.13°: at the distance {0} the picture is exactly {1} units high, so 1080 lines have {2} px a unit.</source>
        <translation>Vidno polje je 53.13°: na udaljenosti {0} slika je visoka točno {1} jedinica, pa 1080 redaka ima {2} px po jedinici.</translation>
    </message>
    <message>
        <source>Two meshes are {0} and {1} units wide and stored in 8 bits, each over its own box. You see the seam from {2} units away. By how many pixels are both copies of a vertex apart at most, across both axes?</source>
        <translation>Širine dviju mreža su {0} i {1}, a spremljene su u 8 bitova, svaka nad vlastitim kvadrom. Šav vidite s udaljenosti {2}. Koliko su piksela dvije kopije vrha najviše razmaknute, po objema osima?</translation>
    </message>
    <message>
        <source>This lets only the larger mesh round. The smaller one rounds, too, and may go the other way. Look at the seam: both edges are in steps.</source>
        <translation>Ovo pušta da zaokružuje samo veća mreža. Zaokružuje i manja, a može i na drugu stranu. Pogledajte šav: oba su ruba stepenasta.</translation>
    </message>
    <message>
        <source>A coordinate goes to the nearer place, so each mesh is off by half a step at most. Look at the seam: the gaps are narrower.</source>
        <translation>Koordinata ide na bliže mjesto, pa svaka mreža griješi za najviše pola koraka. Pogledajte šav: procjepi su uži.</translation>
    </message>
    <message>
        <source>One axis is all</source>
        <translation>Jedna os je sve</translation>
    </message>
    <message>
        <source>This is the gap along one axis. The vertex is rounded along both, so the widest gap is the diagonal of a square. Look at the seam: copies lie apart across and along it.</source>
        <translation>To je procjep duž jedne osi. Vrh se zaokružuje duž obiju, pa je najširi procjep dijagonala kvadrata. Pogledajte šav: kopije su razmaknute poprijeko i uzduž.</translation>
    </message>
    <message>
        <source>Half a step of each grid, together, along each axis.</source>
        <translation>Pola koraka svake rešetke, zajedno, duž svake osi.</translation>
    </message>
    <message>
        <source>Two equal errors at right angles make {0} of one.</source>
        <translation>Dvije jednake, međusobno okomite pogreške daju {0} od jedne.</translation>
    </message>
    <message>
        <source>{0} units with steps of a 255th, {1} of it across both axes, and {2} px a unit.</source>
        <translation>{0} jedinica s koracima od 255-ine, {1} toga po objema osima, i {2} px po jedinici.</translation>
    </message>
</context>
<context>
    <name>talk-000</name>
    <message>
        <source>Normalised coordinates and the perspective projection</source>
        <translation>Normalizirane koordinate i perspektivna projekcija</translation>
    </message>
    <message>
        <source>From similar triangles</source>
        <translation>Od sličnih trokuta</translation>
    </message>
    <message>
        <source>A point {0} in front of the camera comes to the plane at the distance {1} from the eye:</source>
        <translation>Točka {0} ispred kamere dolazi na ravninu na udaljenosti {1} od kamere:</translation>
    </message>
    <message>
        <source>P is 5 deep. The plane moves from d = 1 to d = 2. How many times as high is P&apos; now?</source>
        <translation>P je na dubini 5. Ravnina se pomiče s d = 1 na d = 2. Koliko je puta P&apos; sada viša?</translation>
    </message>
    <message>
        <source>The area of the image grows 4 times. Height and width are proportional to d.</source>
        <translation>Površina slike raste 4 puta. Visina i širina proporcionalne su s d.</translation>
    </message>
    <message>
        <source>Both triangles have a corner at the eye, and P is 5 deep, measured from there.</source>
        <translation>Oba trokuta imaju vrh kod kamere, a P je na dubini 5, mjereno odande.</translation>
    </message>
    <message>
        <source>World from the side: name the two triangles first, eye to P and eye to P&apos;. Read -z = 5, y = 2 and {0} off the picture. Let the class vote, then let the model move. Afterwards drag Plane distance d down to below 0: the film of a camera obscura, and the image turns over. This was derived earlier in the course; do not stay.</source>
        <translation>Svijet sa strane: najprije imenujte dva trokuta, od kamere do P i od kamere do P&apos;. Očitajte sa slike -z = 5, y = 2 i {0}. Neka studenti glasuju, zatim pustite da se model pomakne. Potom povucite Udaljenost ravnine d ispod 0: film camere obscure, i slika se okreće. To je izvedeno ranije na kolegiju; ne zadržavajte se.</translation>
    </message>
    <message>
        <source>The same as a matrix</source>
        <translation>Isto kao matrica</translation>
    </message>
    <message>
        <source>{0} goes to {1}, and divided by the last number to {2} (2):</source>
        <translation>{0} prelazi u {1}, a podijeljeno posljednjim brojem u {2} (2):</translation>
    </message>
    <message>
        <source>The matrix is in the dock too, with numbers: -1/d = -0.5. Under it P = (2, 2, -5) becomes (2, 2, -5, 2.5). Divide aloud: 0.8, 0.8, -2. Stress that all projection is in the last row, and that -z/d is positive for what is in front. Drag d and watch the one cell that changes.</source>
        <translation>Matrica je i na bočnoj ploči, s brojevima: -1/d = -0.5. Pod njom P = (2, 2, -5) postaje (2, 2, -5, 2.5). Podijelite naglas: 0.8, 0.8, -2. Naglasite da je sva projekcija u posljednjem retku i da je -z/d pozitivno za ono što je ispred. Povucite d i promatrajte jedinu ćeliju koja se mijenja.</translation>
    </message>
    <message>
        <source>A and λA are one transformation</source>
        <translation>A i λA ista su transformacija</translation>
    </message>
    <message>
        <source>Multiply every cell by {0}: the last number becomes {1}, and the quotients stay the same (3).</source>
        <translation>Pomnožite svaku ćeliju s {0}: posljednji broj postaje {1}, a kvocijenti ostaju isti (3).</translation>
    </message>
    <message>
        <source>last row</source>
        <translation>posljednji redak</translation>
    </message>
    <message>
        <source>of P = (2, 2, −5)</source>
        <translation>od P = (2, 2, −5)</translation>
    </message>
    <message>
        <source>divided</source>
        <translation>podijeljeno</translation>
    </message>
    <message>
        <source>Ask what else can be multiplied: any λ but 0. So the last row may as well be 0 0 -1 0, whatever d is, and w&apos; = -z is the depth itself. In the window -z = 5 stands in the dock, and as a length below the picture. All later matrices of the lecture have this last row.</source>
        <translation>Pitajte čime se još može množiti: bilo kojim λ osim 0. Zato posljednji redak može biti i 0 0 -1 0, koliki god bio d, a w&apos; = -z je sama dubina. U prozoru -z = 5 stoji na bočnoj ploči i kao duljina ispod slike. Taj posljednji redak imaju sve daljnje matrice predavanja.</translation>
    </message>
    <message>
        <source>WebGL: d is the distance to near</source>
        <translation>WebGL: d je udaljenost bliske ravnine</translation>
    </message>
    <message>
        <source>The scene is projected onto the near plane {0}, so {1} (4). **World** shows the picture on it.</source>
        <translation>Scena se projicira na blisku ravninu {0}, pa je {1} (4). **Svijet** na njoj pokazuje sliku.</translation>
    </message>
    <message>
        <source>Show the small F on the near plane in World: same projectors as before, and the plane is one of the walls of the frustum. Drag Near: the picture on the plane grows with it, and so does the plane; in Image nothing changes, until near cuts into the F. Near is a distance and positive; the plane is at {0}.</source>
        <translation>Pokažite mali F na bliskoj ravnini u oknu Svijet: iste zrake projiciranja kao prije, a ravnina je jedna od strana krnje piramide. Povucite Blisku ravninu: slika na ravnini raste s njom, a raste i ravnina; u oknu Slika ništa se ne mijenja dok bliska ravnina ne zareže u F. Bliska ravnina zadana je udaljenošću, i pozitivna je; ravnina je u {0}.</translation>
    </message>
    <message>
        <source>A segment to [-1, 1]</source>
        <translation>Segment u [-1, 1]</translation>
    </message>
    <message>
        <source>The orthographic projection drops {0}; only {1} must become {2} (5). Here it is {3}:</source>
        <translation>Ortogonalna projekcija zaboravlja {0}; samo {1} mora postati {2} (5). Ovdje je to {3}:</translation>
    </message>
    <message>
        <source>Try three values on the board: x = -3 gives -1, x = 5 gives 1, x = 1, the middle, gives 0. Point to the denominators of the two fractions: they differ in sign. In NDC the box has become the cube; the F lies left of the middle, because the axis came to -0.25. Drag Left and Right.</source>
        <translation>Na ploči isprobajte tri vrijednosti: x = -3 daje -1, x = 5 daje 1, x = 1, sredina, daje 0. Pokažite nazivnike dvaju razlomaka: razlikuju se predznakom. U NDC je kvadar postao kocka; F leži lijevo od sredine, jer je os došla u -0.25. Povucite Lijevi rub i Desni rub.</translation>
    </message>
    <message>
        <source>The same for {0} and {1}</source>
        <translation>Isto za {0} i {1}</translation>
    </message>
    <message>
        <source>Put {0} into (5) and write everything over {1} (6); likewise for {2} (8):</source>
        <translation>Uvrstite {0} u (5) i sve napišite nad {1} (6); isto tako za {2} (8):</translation>
    </message>
    <message>
        <source>The window moves to [-1, 3]. Which {0} has probe 1, straight ahead?</source>
        <translation>Prozor se pomiče na [-1, 3]. Koji {0} ima sonda 1, ravno naprijed?</translation>
    </message>
    <message>
        <source>Only in a window that reaches equally far to both sides is the axis in the middle.</source>
        <translation>Os je u sredini samo kad prozor seže jednako daleko na obje strane.</translation>
    </message>
    <message>
        <source>This moves the picture with its window. Look at the window that has moved to the left: only then is probe 1 at {0}.</source>
        <translation>Ovo pomiče sliku s prozorom. Pogledajte prozor koji se pomaknuo ulijevo: samo je tada sonda 1 u {0}.</translation>
    </message>
    <message>
        <source>{0}, and {1}.</source>
        <translation>{0}, i {1}.</translation>
    </message>
    <message>
        <source>Derive (6) line by line on the board. The trick is to multiply the second fraction by -z/-z, so that all has one denominator: it will be w&apos;. Its sign turns with it. Then the vote: many say +0.5, because the window goes to the right. After it, drag Left and Right and follow probe 1 in Image.</source>
        <translation>Na ploči izvedite (6) redak po redak. Trik je pomnožiti drugi razlomak s -z/-z, tako da sve ima jedan nazivnik: to će biti w&apos;. S njim se okreće i predznak. Zatim glasovanje: mnogi kažu +0.5, jer prozor ide udesno. Nakon toga povucite Lijevi rub i Desni rub i pratite sondu 1 u oknu Slika.</translation>
    </message>
    <message>
        <source>An affine z bends lines</source>
        <translation>Afini z savija pravce</translation>
    </message>
    <message>
        <source>With {0} the third homogeneous number would be {1} (9)-(11): no matrix.</source>
        <translation>Uz {0} treći bi homogeni broj bio {1} (9)-(11): nema matrice.</translation>
    </message>
    <message>
        <source>P comes nearer, to a third of Q&apos;s depth. What does {0} make of PQ?</source>
        <translation>P dolazi bliže, na trećinu dubine točke Q. Što {0} čini od PQ?</translation>
    </message>
    <message>
        <source>A straight segment</source>
        <translation>Ravnu dužinu</translation>
    </message>
    <message>
        <source>x and y are divided by {0}, z&apos; is not. Look at the bow between P and Q: only {1} is straight.</source>
        <translation>x i y dijele se s {0}, a z&apos; ne. Pogledajte luk između P i Q: ravno je samo {1}.</translation>
    </message>
    <message>
        <source>A bow</source>
        <translation>Luk</translation>
    </message>
    <message>
        <source>{0} and {1} are divided by {2}, {3} is not.</source>
        <translation>{0} i {1} dijele se s {2}, a {3} ne.</translation>
    </message>
    <message>
        <source>Go through (9), (10), (11): the same point three times, then all times -z. Nothing in the last line but -Az² - Bz is new. NDC shows both: A z + B is the bow, -A - B/z the straight line. After the vote drag P in World. Near and far change the bow too: try Near 0.3.</source>
        <translation>Prođite (9), (10), (11): ista točka triput, zatim sve puta -z. U posljednjem retku novo je samo -Az² - Bz. NDC pokazuje oboje: A z + B je luk, -A - B/z pravac. Nakon glasovanja povucite P u oknu Svijet. Luk mijenjaju i bliska i daleka ravnina: isprobajte blisku na 0.3.</translation>
    </message>
    <message>
        <source>What the depth buffer does with z</source>
        <translation>Što spremnik dubine radi sa z</translation>
    </message>
    <message>
        <source>Between a triangle&apos;s corners {0} is interpolated evenly over the pixels, and the smaller value wins. If lines are bent, or there are too few codes, the wrong surface is drawn.</source>
        <translation>Između vrhova trokuta {0} se interpolira jednoliko po pikselima, i pobjeđuje manja vrijednost. Ako su pravci savijeni ili je kodova premalo, crta se pogrešna ploha.</translation>
    </message>
    <message>
        <source>Say what goes wrong with a bent line: the value interpolated at a pixel is not the depth of what is there. What is seen here is the other trouble: a buffer of 16 bits, near at 0.01, surface 2 is 0.25 behind surface 1, and 63 % of the pixels are wrong. Ask what helps. Far from 200 to 60: 63 %. Near from 0.01 to 0.1: none. Most values lie just behind near.</source>
        <translation>Recite što pođe po zlu kad je linija savijena: vrijednost interpolirana u pikselu nije dubina onoga što je ondje. Ovdje se vidi druga nevolja: spremnik od 16 bitova, bliska ravnina na 0.01, ploha 2 je 0.25 iza plohe 1, i 63 % piksela je pogrešno. Pitajte što pomaže. Daleka ravnina sa 200 na 60: 63 %. Bliska s 0.01 na 0.1: nijedan. Većina vrijednosti leži odmah iza bliske ravnine.</translation>
    </message>
    <message>
        <source>Few bits for a vertex</source>
        <translation>Malo bitova za vrh</translation>
    </message>
    <message>
        <source>With {0} bits over a side {1} a coordinate is off by up to {2}: in pixels the more, the nearer.</source>
        <translation>Uz {0} bitova na stranici {1} koordinata je pomaknuta za najviše {2}: u pikselima to više što je bliže.</translation>
    </message>
    <message>
        <source>Depths are not the only numbers with few bits. 8 bits a coordinate: 3 bytes a vertex, and up to 0.5 pixels off in a picture of 320 by 240. The arrows are 50 times as long as the errors. Choose 12 and 16 bits: each bit halves the error. Then halve the distance: each error is twice as long. How many bits are enough depends on where you stand; lesson &quot;How many bits does a picture need?&quot;.</source>
        <translation>Dubine nisu jedini brojevi s malo bitova. 8 bitova po koordinati: 3 bajta po vrhu i pogreška do 0.5 piksela na slici od 320 puta 240. Strelice su 50 puta dulje od pogrešaka. Odaberite 12 i 16 bitova: svaki bit prepolovi pogrešku. Zatim prepolovite udaljenost: svaka je pogreška dvostruko dulja. Koliko je bitova dosta, ovisi o tome gdje stojite; lekcija „Koliko bitova treba slika?”.</translation>
    </message>
    <message>
        <source>{0} instead</source>
        <translation>Umjesto toga {0}</translation>
    </message>
    <message>
        <source>Divided by {0} as well, {1} stays linear in homogeneous coordinates (12). Near must come to -1, far to 1:</source>
        <translation>Kad se i on podijeli s {0}, {1} ostaje linearan u homogenim koordinatama (12). Bliska ravnina mora doći u -1, daleka u 1:</translation>
    </message>
    <message>
        <source>Solve the two equations on the board: {0} and {1}. Then NDC: the posts stand 6 apart in World, and crowd towards far in the cube. With near 9 and far 41 the middle of the cube, z&apos; = 0, is at a depth of only 14.8. Order is kept, and lines stay straight; that is all the depth buffer needs.</source>
        <translation>Riješite na ploči dvije jednadžbe: {0} i {1}. Zatim NDC: stupovi u oknu Svijet stoje razmaknuti 6, a u kocki se gomilaju prema dalekoj ravnini. S bliskom ravninom na 9 i dalekom na 41 sredina kocke, z&apos; = 0, na dubini je samo 14.8. Poredak se čuva i pravci ostaju pravci; spremnik dubine ne treba ništa više.</translation>
    </message>
    <message>
        <source>The whole matrix</source>
        <translation>Cijela matrica</translation>
    </message>
    <message>
        <source>{0}, and the six numbers of the frustum (13):</source>
        <translation>{0}, i šest brojeva krnje piramide (13):</translation>
    </message>
    <message>
        <source>Rows 1 and 2 are (6) and (8), row 3 is (12), row 4 is the division. In World left and right are written at the near plane. Ask for the cells with x from -1 to 3, near 2, far 19: 1 and 0.5 in row 1, -21/17 and -76/17 in row 3. Matrices in the drawer has them, and lights up what a control changes.</source>
        <translation>Retci 1 i 2 su (6) i (8), redak 3 je (12), redak 4 je dijeljenje. U oknu Svijet lijevo i desno napisani su uz blisku ravninu. Pitajte za ćelije s x od -1 do 3, bliskom ravninom 2 i dalekom 19: 1 i 0.5 u retku 1, -21/17 i -76/17 u retku 3. Matrice u ladici ih imaju i osvjetljavaju ono što kontrola mijenja.</translation>
    </message>
    <message>
        <source>Stretched</source>
        <translation>Rastegnuto</translation>
    </message>
    <message>
        <source>The window is {0}, but the canvas {1} is square. (13) does not prevent this: the letter is twice as high as it should be.</source>
        <translation>Prozor je {0}, ali je canvas {1} kvadratan. (13) to ne sprječava: slovo je dvaput više nego što treba biti.</translation>
    </message>
    <message>
        <source>NDC knows no proportions: the cube is the cube. The stretching happens where [-1, 1] becomes pixels, by different factors for x and y. For round circles the window must have the proportions of the canvas: {0}.</source>
        <translation>NDC ne zna za proporcije: kocka je kocka. Rasteže se ondje gdje [-1, 1] postaju pikseli, različitim faktorima za x i y. Za okrugle kružnice prozor mora imati proporcije canvasa: {0}.</translation>
    </message>
    <message>
        <source>Variant X: y is adjusted</source>
        <translation>Varijanta X: podešava se y</translation>
    </message>
    <message>
        <source>Image changes, the fields stay: Top still says 1, and the program calls the projection with {0} and {1}. Ask why there is a 2 under the fraction: k is put on at both ends. X is what is kept; students often read it as what is changed.</source>
        <translation>Slika se mijenja, polja ostaju: u polju Gornji rub i dalje piše 1, a program poziva projekciju s {0} i {1}. Pitajte zašto je pod razlomkom 2: k se dodaje na oba kraja. X je ono što se čuva; studenti često čitaju da se to mijenja.</translation>
    </message>
    <message>
        <source>Variant Y: x is adjusted</source>
        <translation>Varijanta Y: podešava se x</translation>
    </message>
    <message>
        <source>Here k is negative: the window becomes narrower, x from -1 to 1, and the F is larger. The last line of the handout has {0} for {1}; it must be {2}. Ask which variant a program should take when a window is made narrower by hand: with X the scene keeps its width, with Y its height.</source>
        <translation>Ovdje je k negativan: prozor postaje uži, x od -1 do 1, a F veći. Posljednji redak nastavnog materijala ima {0} umjesto {1}; mora biti {2}. Pitajte koju bi varijantu program trebao uzeti kad se prozor ručno suzi: s X scena zadržava širinu, s Y visinu.</translation>
    </message>
</context>
<context>
    <name>talk-001</name>
    <message>
        <source>The synthetic camera</source>
        <translation>Sintetička kamera</translation>
    </message>
    <message>
        <source>Eye, monitor, phone</source>
        <translation>Oko, monitor, telefon</translation>
    </message>
    <message>
        <source>How much of the world is in a picture? The eye sees 120°, without the blurred rim. A monitor fills 25° to 30°, a phone 5°.</source>
        <translation>Koliko je svijeta na slici? Oko vidi 120°, bez mutnog ruba. Monitor ispunjava 25° do 30°, telefon 5°.</translation>
    </message>
    <message>
        <source>eye 120°</source>
        <translation>oko 120°</translation>
    </message>
    <message>
        <source>monitor 30°</source>
        <translation>monitor 30°</translation>
    </message>
    <message>
        <source>phone 5°</source>
        <translation>telefon 5°</translation>
    </message>
    <message>
        <source>A camera takes a 3-D scene and puts it onto film or pixels; the synthetic camera imitates that. The three pictures hold the head at one size: the eye has to go very near, the phone far away. Read the angles under More numbers. Ask which picture looks natural, and from which distance one would have to look at it on the wall.</source>
        <translation>Kamera uzima 3D scenu i stavlja je na film ili u piksele; sintetička kamera to oponaša. Tri slike drže glavu jednako velikom: oko mora prići vrlo blizu, telefon se odmaknuti daleko. Kutove očitajte pod Još brojeva. Pitajte koja slika izgleda prirodno i s koje bi je udaljenosti trebalo gledati na zidu.</translation>
    </message>
    <message>
        <source>The view volume</source>
        <translation>Volumen pogleda</translation>
    </message>
    <message>
        <source>Only what lies in a volume is drawn: the eye&apos;s cone, the pyramid round it, or a box, the view from very far away.</source>
        <translation>Crta se samo ono što leži u volumenu: stožac oka, piramida oko njega ili kvadar, pogled s vrlo velike udaljenosti.</translation>
    </message>
    <message>
        <source>Begin with the cone: what an eye sees. Then choose Pyramid under View volume: pictures are rectangles, so the cone is cut off by four planes. Then Box. The letters are test points; grey ones lie outside. Ask before each change which come in and which go. The volume is given by its shape and its place.</source>
        <translation>Počnite sa stošcem: s onim što oko vidi. Zatim pod Volumen pogleda odaberite Piramidu: slike su pravokutnici, pa stožac odsijecaju četiri ravnine. Zatim Kvadar. Slova su testne točke; sive leže izvan. Prije svake promjene pitajte koje ulaze, a koje izlaze. Volumen je zadan oblikom i mjestom.</translation>
    </message>
    <message>
        <source>In, out, crossing</source>
        <translation>Unutra, izvan, presijeca</translation>
    </message>
    <message>
        <source>What is wholly outside is dropped. What crosses a plane is cut, plane by plane.</source>
        <translation>Što je cijelo izvan, odbacuje se. Što siječe ravninu, odsijeca se, ravninu po ravninu.</translation>
    </message>
    <message>
        <source>Cards that are whole inside, outside, and crossing. Step the planes on with the slider: near, far, left, right, bottom, top; each adds corners where an edge goes through. Why not pixel by pixel? To leave out whole triangles is cheap, to leave out fragments is dear. In the dock: corners before and after, and how many cards are whole.</source>
        <translation>Kartice koje su cijele unutra, kartice izvan volumena i kartice koje ga sijeku. Klizačem prolazite ravnine: bliska, daleka, lijeva, desna, donja, gornja; svaka dodaje vrhove gdje brid prolazi. Zašto ne piksel po piksel? Izostaviti cijele trokute je jeftino, izostaviti fragmente je skupo. Na bočnoj ploči: vrhovi prije i poslije, i koliko je kartica cijelih.</translation>
    </message>
    <message>
        <source>What a real camera also has</source>
        <translation>Što prava kamera još ima</translation>
    </message>
    <message>
        <source>A real camera has a focal distance, and a depth of field in front of it and behind it. The synthetic camera has neither: everything is sharp.</source>
        <translation>Prava kamera ima udaljenost izoštravanja te dubinsku oštrinu ispred nje i iza nje. Sintetička kamera nema ni jedno ni drugo: sve je oštro.</translation>
    </message>
    <message>
        <source>The camera&apos;s parameters: position, two vectors, two angles, two planes. A real one has a focal distance and an aperture too. Here a 50-mm lens at f/1, focused at 10 m: sharp from 8.933 to 11.36 m, the outlined post. Drag the focal distance to 5 m and back; then make N 16. Ask from where on everything far is sharp: from the hyperfocal distance.</source>
        <translation>Parametri kamere: položaj, dva vektora, dva kuta, dvije ravnine. Prava ima i udaljenost izoštravanja i otvor blende. Ovdje je objektiv od 50 mm pri f/1, izoštren na 10 m: oštro od 8.933 do 11.36 m, obrubljeni stup. Povucite udaljenost izoštravanja na 5 m i natrag; zatim postavite N na 16. Pitajte odakle je sve daleko oštro: od hiperfokalne udaljenosti.</translation>
    </message>
    <message>
        <source>Camera obscura</source>
        <translation>Camera obscura</translation>
    </message>
    <message>
        <source>A dark box with a hole: {0}, upside down. The synthetic camera has its plane in front of the hole.</source>
        <translation>Mračna kutija s rupicom: {0}, naopačke. Sintetička kamera ima ravninu ispred rupice.</translation>
    </message>
    <message>
        <source>The F is 5 high, the film 4 behind the hole. The F goes from 9 to 18. How high is its image?</source>
        <translation>F je visok 5, film je 4 iza rupice. F se pomiče s 9 na 18. Kolika je visina njegove slike?</translation>
    </message>
    <message>
        <source>This measures from the film, 18 + 4. Both triangles have their corner in the hole. Look at {0} and {1}: both begin there.</source>
        <translation>Ovo mjeri od filma, 18 + 4. Oba trokuta imaju vrh u rupici. Pogledajte {0} i {1}: oboje ondje počinje.</translation>
    </message>
    <message>
        <source>1.11, upright</source>
        <translation>1.11, uspravno</translation>
    </message>
    <message>
        <source>This is the image in front of the hole. Look at the film behind it: the light has crossed in the hole, so the image is upside down.</source>
        <translation>To je slika ispred rupice. Pogledajte film iza nje: svjetlo se u rupici križa, pa je slika naopačke.</translation>
    </message>
    <message>
        <source>Twice as far, half as high: {0}.</source>
        <translation>Dvostruko dalje, upola niže: {0}.</translation>
    </message>
    <message>
        <source>Light crosses in the hole, so the picture on the film is upside down and left for right; painters used it. Compare both films: equally large, only the sign differs. Centre of projection is the hole; for us it is the camera&apos;s position P, and the plane is between it and the object. Vote, then show; drag d as well.</source>
        <translation>Svjetlo se u rupici križa, pa je slika na filmu naopačke, a lijevo i desno su zamijenjeni; slikari su se time služili. Usporedite oba filma: jednako veliki, razlikuje se samo predznak. Centar projekcije je rupica; kod nas je to položaj kamere P, a ravnina je između njega i objekta. Neka glasuju, zatim pokažite; povucite i d.</translation>
    </message>
    <message>
        <source>Position, look, up</source>
        <translation>Položaj, smjer gledanja, smjer prema gore</translation>
    </message>
    <message>
        <source>{0} is the position of the camera, {1} its direction, and {2} says how it is turned about that.</source>
        <translation>{0} je položaj kamere, {1} njezin smjer, a {2} kaže kako je oko njega okrenuta.</translation>
    </message>
    <message>
        <source>Axes as on the screen: x right, y up, z towards us. look can be any vector, up any that does not lie along it; it need not be at a right angle. Slide Up from view in the panel: the picture stays while up keeps its plane. Bring it near 0 and nudge it by 0.1° to the side: the picture swings. At 0 the camera is refused.</source>
        <translation>Osi kao na ekranu: x udesno, y gore, z prema nama. Smjer gledanja može biti bilo koji vektor, smjer prema gore bilo koji koji ne leži duž njega; ne mora biti okomit. U ploči programa pomičite klizač Prema gore od pogleda: slika ostaje dok smjer prema gore ostaje u svojoj ravnini. Dovedite ga blizu 0 i pomaknite ga za 0.1° u stranu: slika se zakrene. Na 0 program kameru odbije.</translation>
    </message>
    <message>
        <source>The angles of view</source>
        <translation>Vidni kutovi</translation>
    </message>
    <message>
        <source>{0} and {1}, or one of them and the aspect. A narrow angle is almost a parallel view, a wide one exaggerates.</source>
        <translation>{0} i {1}, ili jedan od njih i omjer stranica. Uzak kut je gotovo paralelni pogled, širok pretjeruje.</translation>
    </message>
    <message>
        <source>The picture is 16:9 and {0} is 60°. How wide is {1}?</source>
        <translation>Slika je 16:9, a {0} je 60°. Koliko je širok {1}?</translation>
    </message>
    <message>
        <source>60°, one angle does for both</source>
        <translation>60°, jedan kut vrijedi za oba smjera</translation>
    </message>
    <message>
        <source>{0}. From above half of it is written at the eye: 45.75°.</source>
        <translation>{0}. Odozgo je kod kamere napisana polovica: 45.75°.</translation>
    </message>
    <message>
        <source>From the side {0} is written at the eye. Vote first; then the world is seen from above, with {1} at the eye and the half width on the far plane, f tan of it. Make the image 720 x 720 under Image and depth range: both angles are 60. A photographer does this when choosing a lens. Keep window and picture at one aspect, or everything is stretched.</source>
        <translation>Sa strane kod kamere piše {0}. Najprije glasovanje; zatim se svijet gleda odozgo, s {1} kod kamere i polovicom širine na dalekoj ravnini, f puta njegov tangens. Pod Slika i raspon dubine postavite sliku na 720 x 720: oba su kuta 60. Tako radi fotograf kad bira objektiv. Neka prozor i slika imaju isti omjer stranica, inače se sve rastegne.</translation>
    </message>
    <message>
        <source>29 mm and 105 mm</source>
        <translation>29 mm i 105 mm</translation>
    </message>
    <message>
        <source>With 29 mm from 30 cm and with 105 mm from 108.6 cm the head is equally large. With 105 mm from 360 cm it is 0.30 times as large.</source>
        <translation>Objektivom od 29 mm s udaljenosti od 30 cm i objektivom od 105 mm sa 108.6 cm glava je jednako velika. Objektivom od 105 mm s 360 cm visoka je samo 0.30 te veličine.</translation>
    </message>
    <message>
        <source>From 30 cm to 108.6 cm, the head kept at its size: what of the background?</source>
        <translation>S 30 cm na 108.6 cm, a glava iste veličine: što biva s pozadinom?</translation>
    </message>
    <message>
        <source>it stays as it was</source>
        <translation>ostaje kakva je bila</translation>
    </message>
    <message>
        <source>it grows, against the head</source>
        <translation>raste u odnosu na glavu</translation>
    </message>
    <message>
        <source>it shrinks, against the head</source>
        <translation>smanjuje se u odnosu na glavu</translation>
    </message>
    <message>
        <source>From 30 cm it was smaller than it is now: the nearer, the larger the difference.</source>
        <translation>S 30 cm bila je manja nego sada: što bliže, to veća razlika.</translation>
    </message>
    <message>
        <source>29 mm</source>
        <translation>29 mm</translation>
    </message>
    <message>
        <source>105 mm</source>
        <translation>105 mm</translation>
    </message>
    <message>
        <source>105 mm, enlarged 3.3 times</source>
        <translation>105 mm, povećano 3.3 puta</translation>
    </message>
    <message>
        <source>20 cm behind, it is 0.6 times as large as the head from 30 cm, and 0.84 times from 108.6 cm.</source>
        <translation>20 cm iza, njezina je veličina 0.6 veličine glave snimljene s 30 cm, a 0.84 snimljene sa 108.6 cm.</translation>
    </message>
    <message>
        <source>The lecture&apos;s cat. F over D decides the size: 105/29 times 30 cm is 108.6 cm. Vote, then both pictures are there. C brings &quot;Distance, relative to the preset&quot;: drag it for a dolly zoom, in which nose and ears move against the head. Back at 1 ×, choose 105 mm at 360 cm under Seen by, and untick Enlarge: 0.30 times as large, 129 px. The perspective comes from the distance alone.</source>
        <translation>Mačka iz predavanja. O veličini odlučuje F kroz D: 105/29 puta 30 cm je 108.6 cm. Glasovanje, zatim su tu obje slike. C donosi „Udaljenost u odnosu na gotovu postavku”: povucite je za dolly zoom, u kojem se nos i uši pomiču u odnosu na glavu. Natrag na 1 ×, pod Gleda odaberite 105 mm na 360 cm i isključite Povećaj: glava je tada 0.30 prijašnje veličine, 129 px. Perspektiva dolazi samo od udaljenosti.</translation>
    </message>
    <message>
        <source>Why near and far?</source>
        <translation>Čemu bliska i daleka ravnina?</translation>
    </message>
    <message>
        <source>Four rays run to infinity. Two planes across the axis cut them off, at the distances {0} and {1} from {2}.</source>
        <translation>Četiri zrake idu u beskonačnost. Odsijecaju ih dvije ravnine okomite na os, na udaljenostima {0} i {1} od {2}.</translation>
    </message>
    <message>
        <source>Near: what is too close hides all the rest, a speck of dust at the eye; what is behind the camera would come out upside down; and the depth buffer needs it. Far: what is far away costs time, and many parts fall into one pixel. Drag both through the F and see in the image what goes.</source>
        <translation>Bliska: što je preblizu, skriva sve ostalo, trun prašine na oku; što je iza kamere, ispalo bi naopačke; a treba je i spremnik dubine. Daleka: što je daleko, troši vrijeme, a mnogo dijelova pada u isti piksel. Povucite obje kroz F i pogledajte na slici što nestaje.</translation>
    </message>
    <message>
        <source>Depth has finitely many steps</source>
        <translation>Dubina ima konačno mnogo koraka</translation>
    </message>
    <message>
        <source>The nearer the near plane, the more of the depth values are used up just behind it.</source>
        <translation>Što je bliska ravnina bliže, više se vrijednosti dubine potroši odmah iza nje.</translation>
    </message>
    <message>
        <source>Which of the two cures the stripes?</source>
        <translation>Što od ovoga dvoga uklanja pruge?</translation>
    </message>
    <message>
        <source>near from 0.1 to 1</source>
        <translation>bliska s 0.1 na 1</translation>
    </message>
    <message>
        <source>far from 100 to 50</source>
        <translation>daleka sa 100 na 50</translation>
    </message>
    <message>
        <source>{0} is small already, so half of far hardly changes {1}. Look at the stripes: they stay.</source>
        <translation>{0} je ionako malo, pa prepolovljena daleka ravnina jedva mijenja {1}. Pogledajte pruge: ostaju.</translation>
    </message>
    <message>
        <source>neither of them</source>
        <translation>ništa od toga</translation>
    </message>
    <message>
        <source>One of them has a large effect on the gap, {0}.</source>
        <translation>Jedno od toga jako utječe na razmak, {0}.</translation>
    </message>
    <message>
        <source>The gap is proportional to {0}, and {1} is small already.</source>
        <translation>Razmak je proporcionalan s {0}, a {1} je ionako malo.</translation>
    </message>
    <message>
        <source>Two surfaces 0.05 apart, 16 bits. Where both get the same code the hidden one comes through. Vote, then show; afterwards put near back to 0.1 and try far 50: nothing is won. 24 bits do it as well. Rule: near as far out as the scene allows. Do not set near to 0 to be on the safe side.</source>
        <translation>Dvije plohe razmaknute 0.05, 16 bitova. Gdje obje dobiju isti kod, probija skrivena. Glasovanje, zatim pokažite; potom vratite blisku ravninu na 0.1 i isprobajte daleku na 50: ništa se ne dobiva. To rješavaju i 24 bita. Pravilo: bliska ravnina onoliko daleko koliko scena dopušta. Ne stavljajte je na 0 za svaki slučaj.</translation>
    </message>
    <message>
        <source>Popping</source>
        <translation>Iskakanje</translation>
    </message>
    <message>
        <source>As you drive, things appear at the far plane out of nothing. Fog used to hide this; now distant things have fewer vertices, so far can be farther.</source>
        <translation>Dok vozite, stvari se na dalekoj ravnini pojavljuju niotkuda. Prije je to skrivala magla; danas daleke stvari imaju manje vrhova, pa daleka ravnina može biti dalje.</translation>
    </message>
    <message>
        <source>Play Position and let them look at the end of the avenue: four trees a second. Choose linear fog, end it at 66: 12 per cent of the contrast are left where they pop. Then switch Level of detail on, and move far out: vertices drawn, with and without. Far is a plane, so trees at the side come at the same depth.</source>
        <translation>Pokrenite Položaj i pustite ih da gledaju kraj drvoreda: četiri stabla u sekundi. Odaberite linearnu maglu koja završava na 66: ondje gdje iskaču ostaje 12 posto kontrasta. Zatim uključite Razina detalja i odmaknite daleku ravninu: nacrtanih vrhova, s njom i bez nje. Daleka ravnina je ravnina, pa stabla sa strane dolaze na istoj dubini.</translation>
    </message>
    <message>
        <source>The parallel volume</source>
        <translation>Paralelni volumen</translation>
    </message>
    <message>
        <source>Width and height take the place of the angles. Things are drawn equally large at every distance.</source>
        <translation>Mjesto kutova zauzimaju širina i visina. Stvari se na svakoj udaljenosti crtaju jednako velikima.</translation>
    </message>
    <message>
        <source>Posts of one height, one behind the other. Change the lens to perspective and back. The box is simpler to clip against and to test, and no divide is needed: forget z. That is why the perspective volume is brought into this shape in the end. A box need not be upright: oblique is a parallelepiped.</source>
        <translation>Stupovi iste visine, jedan iza drugoga. Promijenite objektiv u perspektivni i natrag. Prema kvadru je lakše odsijecati i ispitivati, a dijeljenje nije potrebno: zaboravite z. Zato se perspektivni volumen na kraju dovodi u taj oblik. Kvadar ne mora biti uspravan: kosi je paralelepiped.</translation>
    </message>
    <message>
        <source>A camera at (4, 2, 0)</source>
        <translation>Kamera u (4, 2, 0)</translation>
    </message>
    <message>
        <source>It looks along {0}. To put it at the origin, looking along {1}, move the world by {2}, then rotate it about {3} by {4}.</source>
        <translation>Gleda duž {0}. Da je stavite u ishodište, s pogledom duž {1}, pomaknite svijet za {2}, zatim ga rotirajte oko {3} za {4}.</translation>
    </message>
    <message>
        <source>Which is this camera&apos;s {0}?</source>
        <translation>Koji je {0} ove kamere?</translation>
    </message>
    <message>
        <source>That would be the {0} of a camera that looks along {1}.</source>
        <translation>To bi bio {0} kamere koja gleda duž {1}.</translation>
    </message>
    <message>
        <source>{0} is opposite to the view direction: the third row begins with −1.</source>
        <translation>{0} je suprotan smjeru gledanja: treći redak počinje s −1.</translation>
    </message>
    <message>
        <source>The camera stays, the world is moved the opposite way: inverse transformations. The F has been put in front of the camera. In Matrices, view from world, press its factors open: rotation times translation, the translation at the right, so it acts first. On View of the strip the eye is the origin. Vote on w before you show it.</source>
        <translation>Kamera ostaje, a svijet se pomiče suprotno: inverzne transformacije. F je stavljen pred kameru. U ploči Matrice, kamera ← svijet, rasklopite faktore: rotacija puta translacija, translacija zdesna, pa djeluje prva. Na postaji Kamera trake kamera je u ishodištu. Neka glasuju o w prije nego što ga pokažete.</translation>
    </message>
    <message>
        <source>u, v, w</source>
        <translation>u, v, w</translation>
    </message>
    <message>
        <source>{0}, {1} is {2} without its component along {3}, normalised, and {4}.</source>
        <translation>{0}, {1} je {2} bez svoje komponente duž {3}, normiran, i {4}.</translation>
    </message>
    <message>
        <source>Camera frame builds it step by step: w, u, v. The program takes u from up cross w first and v from w cross u; it is the same v as the lecture&apos;s: up minus its projection on w, normed. R has u, v, w as columns; the camera is moved by the inverse, and that is the transpose: u, v, w as rows.</source>
        <translation>Koordinatni sustav kamere gradi ih korak po korak: w, u, v. Program najprije uzima u iz vektorskog umnoška gore i w, a v iz w i u; to je isti v kao u predavanju: smjer prema gore minus njegova projekcija na w, normiran. R ima u, v, w kao stupce; kameru pomiče inverz, a on je transponirana matrica: u, v, w kao retci.</translation>
    </message>
    <message>
        <source>A, B, C and the canonical pyramid</source>
        <translation>A, B, C i kanonska piramida</translation>
    </message>
    <message>
        <source>{0}, {1}, {2} go to {3}, {4}, {5}.</source>
        <translation>{0}, {1}, {2} prelaze u {3}, {4}, {5}.</translation>
    </message>
    <message>
        <source>{0}, {1}: where is near in the pyramid?</source>
        <translation>{0}, {1}: gdje je u piramidi bliska ravnina?</translation>
    </message>
    <message>
        <source>z = −1</source>
        <translation>z = −1</translation>
    </message>
    <message>
        <source>z = −0.1</source>
        <translation>z = −0.1</translation>
    </message>
    <message>
        <source>z = 0</source>
        <translation>z = 0</translation>
    </message>
    <message>
        <source>Then it would be in the eye. It comes to 0 in the next step, in the box.</source>
        <translation>Tada bi bila u kameri. U 0 dolazi u sljedećem koraku, u kvadru.</translation>
    </message>
    <message>
        <source>All is divided by {0}.</source>
        <translation>Sve se dijeli s {0}.</translation>
    </message>
    <message>
        <source>An affine transformation is fixed by four points: P, A, B, C. Here f = 10, {0} is 0.8 and {1} is 0.45, so B is 8 to the side and C 4.5 up. {2} = scale, rotation, translation: move P to the origin, turn u, v, w onto x, y, z, divide by f tan, f tan, f. The slide has the scale alone, for the view matrix has turned and moved before. Vote on the near plane, then the pyramid comes: distances along every ray from P are divided by f, too. Show the formulas in Matrices.</source>
        <translation>Afinu transformaciju određuju četiri točke: P, A, B, C. Ovdje je f = 10, {0} je 0.8, a {1} je 0.45, pa je B 8 u stranu, a C 4.5 gore. {2} = skaliranje, rotacija, translacija: pomaknite P u ishodište, okrenite u, v, w na x, y, z, podijelite s f tan, f tan, f. Slajd ima samo skaliranje, jer je matrica pogleda prije toga okrenula i pomaknula. Neka glasuju o bliskoj ravnini, zatim dolazi piramida: i udaljenosti duž svake zrake iz P dijele se s f. Pokažite formule u ploči Matrice.</translation>
    </message>
    <message>
        <source>From pyramid to box to cube</source>
        <translation>Od piramide do kvadra do kocke</translation>
    </message>
    <message>
        <source>{0} opens the pyramid between {1} and {2}, {3} brings {4} to {5}: {6}.</source>
        <translation>{0} otvara piramidu između {1} i {2}, {3} dovodi {4} u {5}: {6}.</translation>
    </message>
    <message>
        <source>Drag the strip slowly from Pyramid to Box: the rays to the origin turn into parallels to z, the order of depths is kept, straight lines stay straight. Check a corner: (-c, -c, c) goes to (1, 1, 0). Then NDC: {0} for OpenGL. Here w is 1 at far. Matrices multiplies by f, so that w is the distance and the product is the usual projection matrix; the picture is the same. Now clipping is against x, y, z = 1 and -1, for every camera.</source>
        <translation>Polako povlačite traku od Piramide do Kvadra: zrake u ishodište postaju paralele sa z, poredak dubina se čuva, pravci ostaju pravci. Provjerite jedan vrh: (-c, -c, c) prelazi u (1, 1, 0). Zatim NDC: {0} za OpenGL. Ovdje je w na dalekoj ravnini 1. Matrice množe s f, tako da je w udaljenost, a umnožak uobičajena matrica projekcije; slika je ista. Sada se odsijeca prema x, y, z = 1 i -1, za svaku kameru.</translation>
    </message>
</context>
<context>
    <name>talk-002</name>
    <message>
        <source>Projections, from the box to the shadow</source>
        <translation>Projekcije, od kvadra do sjene</translation>
    </message>
    <message>
        <source>Planar projections</source>
        <translation>Projekcije na ravninu</translation>
    </message>
    <message>
        <source>A planar geometric projection takes points of space to a plane along straight lines. The lines are parallel, or they meet in one point.</source>
        <translation>Ravninska geometrijska projekcija preslikava točke prostora na ravninu duž pravaca. Pravci su paralelni ili se sijeku u jednoj točki.</translation>
    </message>
    <message>
        <source>A projection can be anything: in linear algebra a map with no inverse, in geography the making of a map. Here it is a plane and straight lines. Walk through the tree from left to right and click each kind: cavalier, isometric, 2-point. Its box is framed and shows a cube in that projection. The sentence below the tree gives the condition for that kind. Ask which kinds keep equal lengths equal: the parallel ones.</source>
        <translation>Projekcija može biti bilo što: u linearnoj algebri preslikavanje bez inverza, u geografiji izrada karte. Ovdje su to ravnina i pravci. Prođite stablo slijeva nadesno i kliknite svaku vrstu: kavalirsku, izometrijsku, 2 nedogleda. Njezin se okvir istakne i prikazuje kocku u toj projekciji. Rečenica ispod stabla daje uvjet za tu vrstu. Pitajte koje vrste čuvaju jednakost jednakih duljina: paralelne.</translation>
    </message>
    <message>
        <source>Orthographic: drop z</source>
        <translation>Ortogonalna: zaboravite z</translation>
    </message>
    <message>
        <source>{0}. The screen is not infinite, so a clipping box bounds what is drawn.</source>
        <translation>{0}. Ekran nije beskonačan, pa kvadar odsijecanja omeđuje ono što se crta.</translation>
    </message>
    <message>
        <source>Of two equally high posts one is twice as far away as the other. How high does a box draw the far one, relative to the near one?</source>
        <translation>Od dvaju jednako visokih stupova jedan je dvostruko dalje od drugoga. Koliko visoko kvadar crta dalji, u odnosu na bliži?</translation>
    </message>
    <message>
        <source>1, equally high</source>
        <translation>1, jednako visoko</translation>
    </message>
    <message>
        <source>0.5, half as high</source>
        <translation>0.5, upola niže</translation>
    </message>
    <message>
        <source>The projectors are parallel: x and y do not depend on z.</source>
        <translation>Zrake projiciranja su paralelne: x i y ne ovise o z.</translation>
    </message>
    <message>
        <source>Start with the box and name its six planes: left, right, top, bottom, near, far. Go back to the pyramid once by the scene&apos;s View volume, and let the class say which test points come and go: B has room in the box, C has not. Then the question, by show of hands. The posts are drawn equally high; their numbers say which is which. Change Near and Far: what is cut changes, no size does.</source>
        <translation>Počnite s kvadrom i imenujte njegovih šest ravnina: lijeva, desna, gornja, donja, bliska, daleka. Jednom se vratite na piramidu pomoću Volumen pogleda i neka studenti kažu koje testne točke dolaze, a koje odlaze: B stane u kvadar, C ne stane. Zatim pitanje, dizanjem ruku. Stupovi su nacrtani jednako visoki; koji je koji, kažu im brojevi. Promijenite Blisku ravninu i Daleku ravninu: mijenja se ono što se odsijeca, veličine ne.</translation>
    </message>
    <message>
        <source>Normalised: the matrix of the box</source>
        <translation>Normalizirano: matrica kvadra</translation>
    </message>
    <message>
        <source>The clipping box becomes {0}. z is kept, because it decides what hides what.</source>
        <translation>Kvadar odsijecanja postaje {0}. z se čuva, jer odlučuje što će što sakriti.</translation>
    </message>
    <message>
        <source>Write {0} on the board: move the middle to 0, then scale. Switch the cells of Matrices to Formulas: the product has both terms. {1} and {2} are negative in this lecture, and z&apos; is 1 at near. Where is the middle of the box? At {3}, so the F is left of the middle. The points come to the screen by {4}.</source>
        <translation>Napišite na ploču {0}: pomaknite sredinu u 0, zatim skalirajte. Ćelije u ploči Matrice prebacite na Formule: umnožak ima oba člana. {1} i {2} u ovom su predavanju negativni, a z&apos; je 1 na bliskoj ravnini. Gdje je sredina kvadra? U {3}, pa je F lijevo od sredine. Točke dolaze na ekran po {4}.</translation>
    </message>
    <message>
        <source>Slanted projectors: H</source>
        <translation>Kose zrake projiciranja: H</translation>
    </message>
    <message>
        <source>{0}. From the side it is the same with {1} and {2}: {3}.</source>
        <translation>{0}. Sa strane je isto s {1} i {2}: {3}.</translation>
    </message>
    <message>
        <source>From above: the camera is left, near is the line at 5, and thin lines are the projectors. A corner at x is drawn at x&apos;. They are parallel, but they meet the near plane at {0}: a unit behind it lands a unit farther along u. A shear does that, H; points of the near plane stay. Turn α: at 90° the projectors are at a right angle to near. At 90° for both angles, H is 1 and the drawing orthographic.</source>
        <translation>Odozgo: kamera je lijevo, bliska ravnina je crta na 5, a tanke linije su zrake projiciranja. Vrh u x crta se u x&apos;. Paralelne su, ali sijeku blisku ravninu pod {0}: jedinica iza nje pada jedinicu dalje duž u. To čini smicanje, H; točke bliske ravnine ostaju. Okrećite α: pod 90° zrake projiciranja okomite su na blisku ravninu. Kad su oba kuta 90°, H je 1, a crtež ortogonalan.</translation>
    </message>
    <message>
        <source>The slanted box made straight</source>
        <translation>Kosi kvadar uspravljen</translation>
    </message>
    <message>
        <source>{0} makes the clipping box straight and shears the object; its image stays. The rest is known: {1}.</source>
        <translation>{0} uspravlja kvadar odsijecanja i smiče objekt; njegova slika ostaje. Ostalo je poznato: {1}.</translation>
    </message>
    <message>
        <source>A cavalier&apos;s projectors meet the picture at 45°. At which angle do those of a cabinet drawing, scale 1/2?</source>
        <translation>Kavalirske zrake projiciranja sijeku sliku pod 45°. Pod kojim kutom kabinetske, mjerilo 1/2?</translation>
    </message>
    <message>
        <source>The cotangent of the angle is the scale: {0}.</source>
        <translation>Kotangens kuta je mjerilo: {0}.</translation>
    </message>
    <message>
        <source>World from above has the slanted box with a cube in it. After H and {0} the box is the NDC cube, and the object is sheared. Which faces keep their shape? Those parallel to the picture. Then vote, and show. Open Matrices: H, {1} and their product stand side by side. Read from right to left: H first, which knows the slant alone, then {2}, which knows the box alone. In OpenGL it is glOrtho and one more matrix, multiplied from the right.</source>
        <translation>Svijet odozgo ima kosi kvadar s kockom u njemu. Nakon H i {0} kvadar je kocka NDC, a na objekt je primijenjeno smicanje. Koje strane zadržavaju oblik? One paralelne sa slikom. Zatim glasovanje, pa pokažite. Otvorite Matrice: H, {1} i njihov umnožak stoje jedan uz drugi. Čitajte zdesna nalijevo: najprije H, koji zna samo za nagib, zatim {2}, koji zna samo za kvadar. U OpenGL-u je to glOrtho i još jedna matrica, pomnožena zdesna.</translation>
    </message>
    <message>
        <source>Homogeneous coordinates</source>
        <translation>Homogene koordinate</translation>
    </message>
    <message>
        <source>{0} is the point {1}. With {2} it is not a point of space but a point at infinity.</source>
        <translation>{0} je točka {1}. Uz {2} to nije točka prostora, nego beskonačno daleka točka.</translation>
    </message>
    <message>
        <source>Until now w was 1 all the time. One point of space has infinitely many rows {0}: a line through the origin. Drag t towards 1: P runs along its edge, w goes to 0, and its image comes to rest in {1}. At 1 there is no longer a point of space, but there is still an image. Go on beyond 1: P comes from the other side. This is what makes perspective a matrix.</source>
        <translation>Dosad je w cijelo vrijeme bio 1. Jedna točka prostora ima beskonačno mnogo redaka {0}: pravac kroz ishodište. Povucite t prema 1: P ide po svojem bridu, w ide u 0, a njezina se slika smiruje u {1}. U 1 više nema točke prostora, ali slike još ima. Nastavite preko 1: P dolazi s druge strane. Zbog toga je perspektiva matrica.</translation>
    </message>
    <message>
        <source>Camera obscura, and ours</source>
        <translation>Camera obscura i naša kamera</translation>
    </message>
    <message>
        <source>The film is behind a hole, so the image is upside down. We put the plane in front of the centre of projection.</source>
        <translation>Film je iza rupice, pa je slika naopačke. Mi stavljamo ravninu ispred centra projekcije.</translation>
    </message>
    <message>
        <source>Follow the line from the top of the F through the hole: it comes to the film below. A real camera has a lens there, and the same geometry. Ours has the plane in front of the centre: same size, upright. Move the film: the height goes with it. Read both heights below the scene&apos;s controls: equal but for the sign.</source>
        <translation>Pratite crtu od vrha slova F kroz rupicu: dolazi na film dolje. Prava kamera ondje ima objektiv, i istu geometriju. Naša ima ravninu ispred centra: ista veličina, uspravno. Pomičite film: visina ide s njim. Očitajte obje visine ispod kontrola scene: jednake su do na predznak.</translation>
    </message>
    <message>
        <source>Onto the plane {0}</source>
        <translation>Na ravninu {0}</translation>
    </message>
    <message>
        <source>{0} with {1}: two triangles share the corner at the eye. As a row: {2}.</source>
        <translation>{0} uz {1}: dva trokuta imaju zajednički vrh kod kamere. Kao redak: {2}.</translation>
    </message>
    <message>
        <source>The two triangles of the side view: eye to the plane, eye to P. Both heights over both lengths. The lecture writes {0} for {1}, from above; from the side it is {2}. The plane is drawn with its distance d; here {3}, so {4} is positive in front. A 3 by 3 matrix cannot divide by z. Four coordinates can: the last row writes {5} into w, and the dividing comes afterwards. Move d behind the eye: camera obscura again.</source>
        <translation>Dva trokuta pogleda sa strane: od kamere do ravnine i od kamere do P. Obje visine kroz obje duljine. Predavanje piše {0} za {1}, odozgo; sa strane je to {2}. Ravnina je nacrtana na udaljenosti d; ovdje je {3}, pa je {4} ispred pozitivno. Matrica 3 puta 3 ne može dijeliti sa z. Četiri koordinate mogu: posljednji redak upisuje {5} u w, a dijeli se poslije. Pomaknite d iza kamere: opet camera obscura.</translation>
    </message>
    <message>
        <source>Frustum to cube</source>
        <translation>Krnja piramida u kocku</translation>
    </message>
    <message>
        <source>The visible part of space is now a frustum. It must become the same cube as before.</source>
        <translation>Vidljivi dio prostora sada je krnja piramida. Mora postati ista kocka kao prije.</translation>
    </message>
    <message>
        <source>The trick of the box once more: make it the cube, then leave z out. Let the strip run, slowly, from View over Pyramid and Box to NDC, and back. Ask what has become of straight lines: they are straight at every place of the strip. What has become of the F? The part nearer to the eye has grown. For x and y that is easily said: after dividing, the window is scaled to −1 to 1. z is the problem.</source>
        <translation>Još jednom trik s kvadrom: pretvorite je u kocku, zatim izostavite z. Pustite traku da polako ide od postaje Kamera preko Piramide i Kvadra do NDC, i natrag. Pitajte što je bilo s pravcima: ravni su na svakom mjestu trake. Što je bilo sa slovom F? Dio bliži kameri je narastao. Za x i y lako je reći: nakon dijeljenja prozor se skalira na −1 do 1. Problem je z.</translation>
    </message>
    <message>
        <source>What becomes of z?</source>
        <translation>Što biva sa z?</translation>
    </message>
    <message>
        <source>x and y are divided by z. May we simply keep z, only scaled and shifted?</source>
        <translation>x i y se dijele sa z. Smijemo li z jednostavno zadržati, samo skaliran i pomaknut?</translation>
    </message>
    <message>
        <source>x and y are divided, {0}. What is PQ in the cube?</source>
        <translation>x i y se dijele, {0}. Što je PQ u kocki?</translation>
    </message>
    <message>
        <source>Straight: every step keeps lines</source>
        <translation>Ravna: svaki korak čuva pravce</translation>
    </message>
    <message>
        <source>x and y are divided by z, z&apos; is not: that step keeps no lines. Look at the bow between P and Q.</source>
        <translation>x i y se dijele sa z, a z&apos; ne: taj korak ne čuva pravce. Pogledajte luk između P i Q.</translation>
    </message>
    <message>
        <source>Bent</source>
        <translation>Savijena</translation>
    </message>
    <message>
        <source>Only with {0} do all three change with 1/z.</source>
        <translation>Samo se uz {0} sva tri mijenjaju s 1/z.</translation>
    </message>
    <message>
        <source>Let them vote before the cube is seen. Then show: the bow, its chord, and the deviation in per cent of the length. The straight line beside it is A + B/z. Drag P towards the eye and the bow grows. Why does it matter? What lies between the ends is interpolated, and lines are clipped as lines. With B &lt; 0 the order of depth is kept in this lecture&apos;s signs. Near is 1, far is −1: two equations for A and B.</source>
        <translation>Neka glasuju prije nego što vide kocku. Zatim pokažite: luk, njegovu tetivu i odstupanje u postocima duljine. Pravac uz njega je A + B/z. Povucite P prema kameri, i luk raste. Zašto je to važno? Što leži između krajeva, interpolira se, a pravci se odsijecaju kao pravci. Uz B &lt; 0 u predznacima ovog predavanja čuva se poredak dubina. Bliska ravnina je 1, daleka −1: dvije jednadžbe za A i B.</translation>
    </message>
    <message>
        <source>The matrix of perspective</source>
        <translation>Matrica perspektive</translation>
    </message>
    <message>
        <source>{0}, and the last row is {1}.</source>
        <translation>{0}, a posljednji redak je {1}.</translation>
    </message>
    <message>
        <source>{0} is linear: a matrix. So it keeps lines. In Matrices look at clip ← view in Formulas: in these letters w is z, negative in front of the eye. OpenGL&apos;s matrix is this one times −1 with z&apos; reversed, since there the planes are positive distances. Numbers: {1}, {2}, {3}.</source>
        <translation>{0} je linearno: matrica. Zato čuva pravce. U ploči Matrice pogledajte odsijecanje ← kamera u Formulama: u ovim slovima w je z, ispred kamere negativan. OpenGL-ova matrica je ova puta −1 s obrnutim z&apos;, jer su ondje ravnine pozitivne udaljenosti. Brojevi: {1}, {2}, {3}.</translation>
    </message>
    <message>
        <source>A window off the axis</source>
        <translation>Prozor izvan osi</translation>
    </message>
    <message>
        <source>The window is not in the middle: {0} makes the slanted frustum straight first.</source>
        <translation>Prozor nije u sredini: {0} najprije uspravlja kosu krnju piramidu.</translation>
    </message>
    <message>
        <source>A wall of screens, or an eye beside the middle of its screen. Drag &quot;Eye right of the middle&quot;: the picture on the window stays right for that eye. H again, with cotangents from the window&apos;s middle. A slip of the lecture: with w = z the third column has a minus, {0}. Check it with the point in the window&apos;s middle, which must come to x&apos; = 0. glFrustum takes six numbers, gluPerspective four.</source>
        <translation>Zid od ekrana ili oko pokraj sredine svojega ekrana. Povucite „Kamera desno od sredine”: slika na prozoru ostaje ispravna za to oko. Opet H, s kotangensima iz sredine prozora. Omaška predavanja: uz w = z treći stupac ima minus, {0}. Provjerite to na točki u sredini prozora, koja mora doći u x&apos; = 0. glFrustum prima šest brojeva, gluPerspective četiri.</translation>
    </message>
    <message>
        <source>Field of view</source>
        <translation>Vidno polje</translation>
    </message>
    <message>
        <source>30° is a common angle. A wide angle draws near things much larger than far ones; a narrow angle is close to an orthographic picture.</source>
        <translation>30° je uobičajen kut. Širok kut crta bliske stvari mnogo većima od dalekih; uzak kut blizak je ortogonalnoj slici.</translation>
    </message>
    <message>
        <source>Three cameras, each as far away as it must be for the same size of the F: 95°, 30°, 7.5°. The first is what the lecture calls fish-eye, the last is nearly orthographic: look at the upright edges and at the top. Sizes are proportional to the tangent of half the angle. The angle alone only enlarges; the distance changes the perspective.</source>
        <translation>Tri kamere, svaka udaljena koliko mora biti za istu veličinu slova F: 95°, 30°, 7.5°. Prvu predavanje zove ribljim okom, posljednja je gotovo ortogonalna: pogledajte uspravne bridove i vrh. Veličine su proporcionalne tangensu polovice kuta. Sam kut samo povećava; perspektivu mijenja udaljenost.</translation>
    </message>
    <message>
        <source>Divide, then pixels</source>
        <translation>Dijeljenje, zatim pikseli</translation>
    </message>
    <message>
        <source>{0}, then {1}</source>
        <translation>{0}, zatim {1}</translation>
    </message>
    <message>
        <source>One point through all stages, row by row: world, view, clip, the divide, NDC, pixels. Width and height are the screen&apos;s, in pixels; the lecture writes w and h, but w is the fourth coordinate here. The screen&apos;s origin is the upper left corner, hence 1 - y. Drag point 1 in the picture to the upper left corner and read its row NDC: −1 and 1. That was the transform of the vertices; clipping and rasterising come after it.</source>
        <translation>Jedna točka kroz sve etape, redak po redak: svijet, kamera, odsijecanje, dijeljenje, NDC, pikseli. Širina i visina su ekranske, u pikselima; predavanje piše w i h, ali w je ovdje četvrta koordinata. Ishodište ekrana je gornji lijevi kut, zato 1 - y. Povucite točku 1 na slici u gornji lijevi kut i očitajte njezin redak NDC: −1 i 1. To je bila transformacija vrhova; odsijecanje i rasterizacija dolaze nakon nje.</translation>
    </message>
    <message>
        <source>Halfway in the picture</source>
        <translation>Na pola puta na slici</translation>
    </message>
    <message>
        <source>Linear on the screen is not linear in the world: {0}</source>
        <translation>Linearno na ekranu nije linearno u svijetu: {0}</translation>
    </message>
    <message>
        <source>The same board twice: once texture coordinates are interpolated as they are, once a/z and 1/z are, and then divided. Where is the middle of an edge whose ends are 2 and 8 away? A fifth of the way, seen from the near end. Colours forgive it, textures do not. Divide the board into more parts: the error goes down with their size, which is how old games hid it.</source>
        <translation>Ista ploča dvaput: jednom se koordinate teksture interpoliraju kakve jesu, a drugi put a/z i 1/z, pa se zatim dijeli. Gdje je sredina brida čiji su krajevi na 2 i 8? Na petini puta, gledano od bližeg kraja. Boje to opraštaju, teksture ne. Podijelite ploču na više dijelova: pogreška se smanjuje s njihovom veličinom, i tako su je stare igre skrivale.</translation>
    </message>
    <message>
        <source>What a console of 1994 saved</source>
        <translation>Što je štedjela konzola iz 1994.</translation>
    </message>
    <message>
        <source>Whole pixels for the vertices, no divide for the texture: quick, and seen at once.</source>
        <translation>Cijeli pikseli za vrhove, bez dijeljenja za teksturu: brzo, i odmah se vidi.</translation>
    </message>
    <message>
        <source>The picture called cheap: vertices at whole pixels, 1/w from a small table, a/z replaced by a. The arrows run from where a vertex belongs to where it is drawn, 20 times as long. Turn the camera slowly with Azimuth: the vertices jump, and the checks bend at each square&apos;s diagonal. The other picture is exact. No vertex is farther off than half a pixel across and half a pixel down; what is seen is that neighbours jump at different moments.</source>
        <translation>Slika zvana jeftino: vrhovi na cijelim pikselima, 1/w iz male tablice, a/z zamijenjeno s a. Strelice idu od mjesta kojem vrh pripada do mjesta gdje je nacrtan, 20 puta dulje. Polako okrećite kameru Azimutom: vrhovi skaču, a kvadratići se savijaju na dijagonali svakog kvadrata. Druga je slika egzaktna. Nijedan vrh nije pomaknut više od pola piksela u širinu i pola piksela u visinu; vidi se to što susjedi skaču u različitim trenucima.</translation>
    </message>
    <message>
        <source>Shadows</source>
        <translation>Sjene</translation>
    </message>
    <message>
        <source>A shadow is a projection from the lamp onto the ground: a matrix {0}, and {1}. Draw the object once more under it, in black.</source>
        <translation>Sjena je projekcija iz svjetiljke na tlo: matrica {0}, i {1}. Objekt nacrtajte pod njom još jednom, u crnoj boji.</translation>
    </message>
    <message>
        <source>The lamp is the centre of projection, the ground is the plane. No depth has to be kept, so the simplest matrix will do: More numbers has S. Draw the ground, draw the object, then in black the object under S. Drag the lamp lower, then choose Sun: the projection becomes a parallel one, w = 1. Close: orthographic, oblique and perspective are all matrices in homogeneous coordinates. Next time: clipping and hidden faces.</source>
        <translation>Svjetiljka je centar projekcije, a tlo ravnina. Dubina se ne mora čuvati, pa je dovoljna najjednostavnija matrica: S je pod Još brojeva. Nacrtajte tlo, nacrtajte objekt, zatim objekt pod S, crno. Spustite svjetiljku, zatim odaberite Sunce: projekcija postaje paralelna, w = 1. Završetak: ortogonalna, kosa i perspektivna projekcija u homogenim su koordinatama matrice. Idući put: odsijecanje i skrivene strane.</translation>
    </message>
</context>
<context>
    <name>talk-003</name>
    <message>
        <source>Coordinate systems and transformations</source>
        <translation>Koordinatni sustavi i transformacije</translation>
    </message>
    <message>
        <source>Three spaces</source>
        <translation>Tri sustava</translation>
    </message>
    <message>
        <source>Object space is where a thing is made, world space where it is placed, camera space where it is seen from.</source>
        <translation>Koordinatni sustav objekta je onaj u kojem se stvar radi, globalni onaj u koji se stavlja, a koordinatni sustav kamere onaj iz kojeg se gleda.</translation>
    </message>
    <message>
        <source>World: the grid&apos;s middle is the world&apos;s origin; the small axes at the F are its own, moved by 3 along x and -1 along z, and turned about y; u, v, n at the eye are the camera&apos;s. Each of the three questions, making, placing, looking, has a space of its own, so that each can be answered without the others. All three are right-handed. Take the F by its own origin and move it.</source>
        <translation>Svijet: sredina rešetke je ishodište svijeta; male osi uz F su njegove vlastite, pomaknute za 3 duž x i -1 duž z te okrenute oko y; u, v, n kod kamere pripadaju njoj. Svako od triju pitanja, izraditi, postaviti, pogledati, ima vlastiti sustav, pa se na svako može odgovoriti bez ostalih. Sva su tri desni sustavi. Uhvatite F za njegovo ishodište i pomaknite ga.</translation>
    </message>
    <message>
        <source>Columns are axes</source>
        <translation>Stupci su osi</translation>
    </message>
    <message>
        <source>Columns 1 to 3 of {0} are the object&apos;s axes, as the world sees them; column 4 is its origin:</source>
        <translation>Stupci 1 do 3 matrice {0} su osi objekta kako ih vidi svijet; stupac 4 je njegovo ishodište:</translation>
    </message>
    <message>
        <source>The object is turned by 90° about z, then moved by 3 along x. How high in y is its point (1, 0, 0) then?</source>
        <translation>Objekt se okreće za 90° oko z, zatim pomiče za 3 duž x. Koliko je tada po y visoko njegova točka (1, 0, 0)?</translation>
    </message>
    <message>
        <source>The move does not raise it, but the rotation takes x to y.</source>
        <translation>Pomak je ne podiže, ali rotacija prebacuje x u y.</translation>
    </message>
    <message>
        <source>Column 1 is (0, 1, 0), column 4 is (3, 0, 0), and together they are (3, 1, 0).</source>
        <translation>Stupac 1 je (0, 1, 0), stupac 4 je (3, 0, 0), a zajedno su (3, 1, 0).</translation>
    </message>
    <message>
        <source>Row x of the product is the sum on the board: how far each object axis reaches along the world&apos;s x, times the coordinate. Read by columns it says more: column 1 is where the object&apos;s x axis points. After the vote open Matrices and go over the columns of world ← object; the axis lights up in World. Then turn the object by hand, by its ring.</source>
        <translation>Redak x umnoška je zbroj na ploči: koliko daleko svaka os objekta seže duž globalne osi x, puta koordinata. Čitan po stupcima govori više: stupac 1 je ono kamo pokazuje os x objekta. Nakon glasovanja otvorite Matrice i prijeđite stupce matrice svijet ← objekt; os zasvijetli u oknu Svijet. Zatim rukom okrenite objekt, za njegov prsten.</translation>
    </message>
    <message>
        <source>From the object to the camera</source>
        <translation>Od objekta do kamere</translation>
    </message>
    <message>
        <source>Each factor leads from one space to the next: the strip stops at *Object*, *Ry*, *World* and *View*.</source>
        <translation>Svaki faktor vodi iz jednog koordinatnog sustava u sljedeći: traka ima postaje *Objekt*, *Ry*, *Svijet* i *Kamera*.</translation>
    </message>
    <message>
        <source>Exchange the two matrices: {0}. Where is the letter then?</source>
        <translation>Zamijenite dvije matrice: {0}. Gdje je tada slovo?</translation>
    </message>
    <message>
        <source>Elsewhere: it is turned and moved along the camera&apos;s axes</source>
        <translation>Drugdje: okrenuto je i pomaknuto po osima kamere</translation>
    </message>
    <message>
        <source>In the same place</source>
        <translation>Na istom mjestu</translation>
    </message>
    <message>
        <source>In the same place, but seen from elsewhere</source>
        <translation>Na istom mjestu, ali gledano s drugog mjesta</translation>
    </message>
    <message>
        <source>Both the place and the view have changed. The letter is turned about the eye and moved along u.</source>
        <translation>Promijenili su se i mjesto i pogled. Slovo je okrenuto oko kamere i pomaknuto duž u.</translation>
    </message>
    <message>
        <source>The matrix on the right acts first. The view takes the letter to the camera, and the move is then made along {0}, about the eye.</source>
        <translation>Matrica zdesna djeluje prva. Matrica pogleda prebacuje slovo u koordinatni sustav kamere, a pomak se zatim izvodi duž {0}, oko kamere.</translation>
    </message>
    <message>
        <source>The large pane shows camera space: the eye is at the origin, u to the right, v up, n towards it. Scrub the strip from Object to View: at Ry the letter is turned, at World it stands in its place, and from World to View everything moves and nothing changes its place against the rest. The rows of the view matrix are the camera&apos;s axes, because it is the inverse of the matrix whose columns they are. Then ask what the exchanged product does. Both matrices are multiplied once, not for every vertex.</source>
        <translation>Veliko okno pokazuje koordinatni sustav kamere: kamera je u ishodištu, u udesno, v gore, n prema njoj. Povlačite traku od postaje Objekt do Kamera: na Ry je slovo okrenuto, na Svijet stoji na svojem mjestu, a od Svijeta do Kamere sve se pomiče i ništa ne mijenja svoj položaj prema ostalome. Retci matrice pogleda su osi kamere, jer je ona inverz matrice čiji su to stupci. Zatim pitajte što čini umnožak sa zamijenjenim matricama. Obje se matrice množe jednom, a ne za svaki vrh.</translation>
    </message>
    <message>
        <source>Clip, divide, NDC</source>
        <translation>Odsijecanje, dijeljenje, NDC</translation>
    </message>
    <message>
        <source>First multiply by {0}, then divide by {1}. Probe 1 is at {2} in camera space, and {3}.</source>
        <translation>Najprije pomnožite s {0}, zatim podijelite s {1}. Sonda 1 je u {2} u koordinatnom sustavu kamere, a {3}.</translation>
    </message>
    <message>
        <source>x</source>
        <translation>x</translation>
    </message>
    <message>
        <source>y</source>
        <translation>y</translation>
    </message>
    <message>
        <source>z</source>
        <translation>z</translation>
    </message>
    <message>
        <source>w</source>
        <translation>w</translation>
    </message>
    <message>
        <source>clip</source>
        <translation>odsijecanje</translation>
    </message>
    <message>
        <source>NDC</source>
        <translation>NDC</translation>
    </message>
    <message>
        <source>Two steps: a matrix, and a division that no matrix can do. w is 5, the depth of the point. The table is the Probe panel&apos;s; NDC has the point in the cube. The handout calls the cube the clip space; here clip is what is before the division. The cube&apos;s z runs away from the reader: NDC is left-handed, the camera&apos;s space right-handed. Drag probe 1 in Image.</source>
        <translation>Dva koraka: matrica i dijeljenje koje nijedna matrica ne može. w je 5, dubina točke. Tablica je ona iz ploče Sonda; NDC ima točku u kocki. Nastavni materijal zove kocku prostorom odsijecanja; ovdje je odsijecanje ono što je prije dijeljenja. Os z kocke ide od čitatelja: NDC je lijevi sustav, koordinatni sustav kamere desni. Povucite sondu 1 u oknu Slika.</translation>
    </message>
    <message>
        <source>The view frustum</source>
        <translation>Krnja piramida pogleda</translation>
    </message>
    <message>
        <source>Six numbers: near and far, and left, right, bottom and top of the window on the near plane.</source>
        <translation>Šest brojeva: bliska i daleka ravnina te lijevi, desni, donji i gornji rub prozora na bliskoj ravnini.</translation>
    </message>
    <message>
        <source>World: the pyramid without its tip. What is inside is drawn, and all of it goes to the cube. Drag near, far and a corner by their handles. Here the window is symmetric, and its four numbers come from one angle and the proportions of the picture: that is the next step.</source>
        <translation>Svijet: piramida bez vrha. Što je unutra, crta se, i sve to ide u kocku. Povucite blisku ravninu, daleku ravninu i kut prozora za njihove ručice. Ovdje je prozor simetričan, a njegova četiri broja dolaze iz jednog kuta i proporcija slike: to je sljedeći korak.</translation>
    </message>
    <message>
        <source>Fields of view and e</source>
        <translation>Vidna polja i e</translation>
    </message>
    <message>
        <source>At {0} the picture reaches {1} in x and {2} in y, {3}; at near {4}, {5}.</source>
        <translation>Na {0} slika po x doseže {1}, a po y {2}, {3}; na bliskoj ravnini {4}, {5}.</translation>
    </message>
    <message>
        <source>Take β = 60° and a picture of 16:9. How large is α?</source>
        <translation>Neka je β = 60°, a slika 16:9. Koliko je α?</translation>
    </message>
    <message>
        <source>tan(α/2) = 16/9 · tan 30° = 1.026</source>
        <translation>tan(α/2) = 16/9 · tan 30° = 1.026</translation>
    </message>
    <message>
        <source>Draw the triangle eye, axis, edge: half the angle is in it. World is seen from above, with half of α at the eye. After the vote: 91.5°, not 106.7°. The tangents of the half angles are in the ratio 16 to 9, not the angles. The wider, the worse: type 120°, multiplied it would be 213°. More of the lens has Focal length e and the focal length of a 35-mm camera. β is not α, unless the picture is square.</source>
        <translation>Nacrtajte trokut kamera, os, rub: u njemu je polovica kuta. Svijet se gleda odozgo, s polovicom kuta α kod kamere. Nakon glasovanja: 91.5°, a ne 106.7°. U omjeru 16 prema 9 su tangensi polovica kutova, a ne kutovi. Što šire, to gore: upišite 120°, pomnožen bio bi 213°. Više o objektivu ima Žarišnu duljinu e i žarišnu duljinu za film od 35 mm. β nije α, osim ako je slika kvadratna.</translation>
    </message>
    <message>
        <source>Onto the near plane</source>
        <translation>Na blisku ravninu</translation>
    </message>
    <message>
        <source>By similar triangles, with the plane at {0}:</source>
        <translation>Po sličnim trokutima, s ravninom na {0}:</translation>
    </message>
    <message>
        <source>World from the side: the plane is the near plane, d = n = 2. P is 5 deep and 2 high, P&apos; is 0.8 high. Both coordinates go with 1/(-z), so {0}, the length below the picture, and the last row is 0 0 -1 0. The minus is there because what is seen has negative z. From above it is the same for x.</source>
        <translation>Svijet sa strane: ravnina je bliska ravnina, d = n = 2. P je na dubini 5 i visini 2, P&apos; na visini 0.8. Obje koordinate idu s 1/(-z), pa je {0}, duljina ispod slike, a posljednji redak 0 0 -1 0. Minus je tu jer ono što se vidi ima negativan z. Odozgo je isto za x.</translation>
    </message>
    <message>
        <source>[l, r] and [b, t]</source>
        <translation>[l, r] i [b, t]</translation>
    </message>
    <message>
        <source>{0}, and likewise for y with b and t.</source>
        <translation>{0}, a isto tako za y s b i t.</translation>
    </message>
    <message>
        <source>Check the ends: {0} gives {1}, {2} gives 1. In the proportion of the handout read {3} and (t - b). Probe 1 is straight ahead, x = 0; only the second fraction is left, and with l = -1, r = 3 it puts it at -0.5. The plus is right: it is multiplied by z, which is negative. Drag Left and Right.</source>
        <translation>Provjerite krajeve: {0} daje {1}, {2} daje 1. U razmjeru iz nastavnog materijala čitajte {3} i (t - b). Sonda 1 je ravno naprijed, x = 0; ostaje samo drugi razlomak, i uz l = -1, r = 3 stavlja je u -0.5. Plus je točan: množi se sa z, koji je negativan. Povucite Lijevi rub i Desni rub.</translation>
    </message>
    <message>
        <source>A and B</source>
        <translation>A i B</translation>
    </message>
    <message>
        <source>z does not depend on x and y: {0}, {1} at near and {2} at far:</source>
        <translation>z ne ovisi o x i y: {0}, {1} na bliskoj, a {2} na dalekoj ravnini:</translation>
    </message>
    <message>
        <source>Near is 1, far is 9. A point is 5 deep, halfway between them. Where is it in the cube, as {0}?</source>
        <translation>Bliska ravnina je na 1, daleka na 9. Točka je na dubini 5, na pola puta između njih. Gdje je u kocki, kao {0}?</translation>
    </message>
    <message>
        <source>This spreads the depth evenly between near and far. Look at the F in the cube: most of the depth lies close to far.</source>
        <translation>Ovo dubinu raspoređuje jednoliko između bliske i daleke ravnine. Pogledajte F u kocki: većina dubine leži blizu daleke ravnine.</translation>
    </message>
    <message>
        <source>This is {0}, before the division by {1}. Look at the point: it lies inside the cube, so {2} is at most 1.</source>
        <translation>To je {0}, prije dijeljenja s {1}. Pogledajte točku: leži unutar kocke, pa je {2} najviše 1.</translation>
    </message>
    <message>
        <source>{0}, {1}, and {2}.</source>
        <translation>{0}, {1} i {2}.</translation>
    </message>
    <message>
        <source>Solve for A and B with the two conditions. Why not just scale? Because then lines would be bent; the reason that the lecture gives is the next part: 1/z is what is linear on the screen. The vote: most say 0, the middle. Show the crowding: half of the cube is used up at 2nf/(n + f) = 1.8.</source>
        <translation>Izračunajte A i B iz dva uvjeta. Zašto ne samo skalirati? Zato što bi tada pravci bili savijeni; razlog koji daje predavanje dolazi u sljedećem dijelu: na ekranu je linearan 1/z. Glasovanje: većina kaže 0, sredina. Pokažite gomilanje: polovica kocke potrošena je kod 2nf/(n + f) = 1.8.</translation>
    </message>
    <message>
        <source>The matrix of glFrustum</source>
        <translation>Matrica iz glFrustum</translation>
    </message>
    <message>
        <source>Rows 1 and 2 come from the window, row 3 from {0} and {1}; row 4 divides. Framed is what {2} changes.</source>
        <translation>Retci 1 i 2 dolaze od prozora, redak 3 od {0} i {1}; redak 4 dijeli. Uokvireno je ono što mijenja {2}.</translation>
    </message>
    <message>
        <source>All of it has been derived: rows 1 and 2 from the window, row 3 from A and B, row 4 from the division. With the numbers here row 1 is 1, 0, 0.5, 0. For a symmetric window the two shears are 0, and 2n/(r - l) is e.</source>
        <translation>Sve je izvedeno: retci 1 i 2 iz prozora, redak 3 iz A i B, redak 4 iz dijeljenja. S brojevima odavde redak 1 je 1, 0, 0.5, 0. Za simetričan prozor oba su smicanja 0, a 2n/(r - l) je e.</translation>
    </message>
    <message>
        <source>1/z is linear on the screen</source>
        <translation>1/z je na ekranu linearan</translation>
    </message>
    <message>
        <source>An edge runs from the depth {0} to {1}. At {2} of the way on the screen: {3}</source>
        <translation>Brid ide od dubine {0} do {1}. Na dijelu puta {2} na ekranu: {3}</translation>
    </message>
    <message>
        <source>Image: halfway along the marked edge on the screen, and halfway along it in the world, are two places. The first is only 30 % of the way from the nearer end. On the board: depths 2 and 8, t = 1/2, so 1/z = (1/2 + 1/8)/2 and z = 3.2, not 5. Why: a straight edge has a linear equation in x and z. Divided by z it is one in x/z, the place on the screen, and 1/z, and that is all.</source>
        <translation>Slika: polovica označenog brida na ekranu i njegova polovica u svijetu dva su mjesta. Prvo je na samo 30 % puta od bližeg kraja. Na ploči: dubine 2 i 8, t = 1/2, pa je 1/z = (1/2 + 1/8)/2 i z = 3.2, a ne 5. Zašto: ravni brid ima linearnu jednadžbu u x i z. Podijeljena sa z, to je linearna jednadžba u x/z, mjestu na ekranu, i u 1/z, i to je sve.</translation>
    </message>
    <message>
        <source>Attributes: a/z</source>
        <translation>Atributi: a/z</translation>
    </message>
    <message>
        <source>Colours and texture coordinates are linear along the edge in space, so {0} is linear on the screen too:</source>
        <translation>Boje i koordinate teksture linearne su duž brida u prostoru, pa je {0} linearno i na ekranu:</translation>
    </message>
    <message>
        <source>Affine: the texture is bent along the diagonal, where the two triangles meet. Correct: a/z and 1/z are interpolated, and divided at each pixel. With depths 2 and 8 and a from 0 to 1, the middle has a = 0.2, not 0.5. Turn Azimuth: seen straight on both are alike. Parts a side makes the error smaller, not zero.</source>
        <translation>Afino: tekstura je savijena duž dijagonale, gdje se dva trokuta dodiruju. Točno: interpoliraju se a/z i 1/z i dijele u svakom pikselu. S dubinama 2 i 8 i a od 0 do 1 sredina ima a = 0.2, a ne 0.5. Okrećite Azimut: gledano ravno, obje izgledaju isto. Klizač Dijelova po stranici smanjuje pogrešku, ali ne na nulu.</translation>
    </message>
    <message>
        <source>The orthographic box</source>
        <translation>Kvadar ortogonalne projekcije</translation>
    </message>
    <message>
        <source>A box becomes a cube without a division: scale by {0} and {1}, and move the middle to 0.</source>
        <translation>Kvadar postaje kocka bez dijeljenja: skalirajte s {0} i {1} i pomaknite sredinu u 0.</translation>
    </message>
    <message>
        <source>The box has the same width at every depth: w is 1. The first cell of the handout has 2n/(r - l), a slip: nothing is brought to a near plane here, so there is no n. The shifts stand in column 4 now, not in column 3, because they are not multiplied by z. Compare with the frustum&apos;s matrix, in step 10.</source>
        <translation>Kvadar ima istu širinu na svakoj dubini: w je 1. Prva ćelija u nastavnom materijalu ima 2n/(r - l), omašku: ovdje se ništa ne dovodi na blisku ravninu, pa nema n. Pomaci sada stoje u stupcu 4, a ne u stupcu 3, jer se ne množe sa z. Usporedite s matricom krnje piramide, u koraku 10.</translation>
    </message>
    <message>
        <source>To pixels</source>
        <translation>Do piksela</translation>
    </message>
    <message>
        <source>{0} and, as rows count down, {1}. Probe 1: {2} to {3}.</source>
        <translation>{0}, a kako se retci broje prema dolje, {1}. Sonda 1: {2} prelazi u {3}.</translation>
    </message>
    <message>
        <source>The same probe as before, now to the end: 1280 by 720, origin at the upper left. Ask for the corners of the cube: (-1, 1) is (0, 0), (1, -1) is (1280, 720). y turns over here and nowhere else. Sum up the chain: object, world, camera, clip, NDC, pixels; Probe in the drawer has all of it for one point.</source>
        <translation>Ista sonda kao prije, sada do kraja: 1280 puta 720, ishodište gore lijevo. Pitajte za kutove kocke: (-1, 1) je (0, 0), (1, -1) je (1280, 720). y se okreće ovdje i nigdje drugdje. Sažmite lanac: objekt, svijet, kamera, odsijecanje, NDC, pikseli; Sonda u ladici ima sve to za jednu točku.</translation>
    </message>
</context>
<context>
    <name>talk-004</name>
    <message>
        <source>A camera for the letter F</source>
        <translation>Kamera za slovo F</translation>
    </message>
    <message>
        <source>The camera&apos;s axes</source>
        <translation>Osi kamere</translation>
    </message>
    <message>
        <source>{0}, {1} is the origin, {2}. What is {3}?</source>
        <translation>{0}, {1} je ishodište, {2}. Koliko je {3}?</translation>
    </message>
    <message>
        <source>1: {0} is up, so {1} is up</source>
        <translation>1: {0} je smjer prema gore, pa je i {1}</translation>
    </message>
    <message>
        <source>{0} and {1}, so {2}.</source>
        <translation>{0} i {1}, pa je {2}.</translation>
    </message>
    <message>
        <source>Build it step by step in Camera frame: eye and target, then N, n, U, u, v. N points back, from the target to the eye: the camera looks along {0}. Three unit vectors, each at right angles to the others, right-handed. Stop before v and let them vote: n is (0, 9, 3) over its length, 9.49. Then show v: it leans far away from V. What if V is parallel to N? Turn &quot;Up from view&quot; towards the end of its slider: |V × n| goes to 0, and U with it.</source>
        <translation>Izgradite ih korak po korak u ploči Koordinatni sustav kamere: položaj kamere i cilj, zatim N, n, U, u, v. N pokazuje unatrag, od cilja prema kameri: kamera gleda duž {0}. Tri jedinična vektora, međusobno okomita, desni sustav. Stanite prije v i neka glasuju: n je (0, 9, 3) kroz svoju duljinu, 9.49. Zatim pokažite v: jako je nagnut od V. Što ako je V paralelan s N? Pomičite „Prema gore od pogleda” prema kraju klizača: |V × n| ide u 0, a s njim i U.</translation>
    </message>
    <message>
        <source>The camera in the world</source>
        <translation>Kamera u svijetu</translation>
    </message>
    <message>
        <source>The camera is at {0}, and has {1}. It is to stand in the origin, with them along {2}.</source>
        <translation>Kamera je u {0}, i ima {1}. Treba stajati u ishodištu, s njima duž {2}.</translation>
    </message>
    <message>
        <source>x, y and z belong to the world and stand still in the next two steps; u, v and n are the camera&apos;s. Ask for two moves that bring them together, and in which order.</source>
        <translation>x, y i z pripadaju svijetu i u sljedeća dva koraka miruju; u, v i n pripadaju kameri. Pitajte za dva pomicanja koja ih dovode u poklapanje, i kojim redom.</translation>
    </message>
    <message>
        <source>First P</source>
        <translation>Najprije P</translation>
    </message>
    <message>
        <source>{0} moves the eye to the origin, and the whole scene with it. Nothing turns: {1} keep their directions.</source>
        <translation>{0} pomiče kameru u ishodište, a s njom i cijelu scenu. Ništa se ne okreće: {1} zadržavaju svoje smjerove.</translation>
    </message>
    <message>
        <source>Go on, and watch the camera come to the axes; back on the strip and once more. Nothing changes its shape, and nothing its place against the rest.</source>
        <translation>Idite dalje i promatrajte kako kamera dolazi do osi; natrag po traci i još jednom. Ništa ne mijenja oblik, ni svoj položaj prema ostalome.</translation>
    </message>
    <message>
        <source>Then R</source>
        <translation>Zatim R</translation>
    </message>
    <message>
        <source>{0} rotates about the origin, until {1} lie along {2}, the lecture&apos;s {3}.</source>
        <translation>{0} rotira oko ishodišta dok {1} ne legnu duž {2}, u predavanju {3}.</translation>
    </message>
    <message>
        <source>The camera looks along {0} now. R is hard to write down; its inverse is easy: the columns of {1} are u, v, n. R is orthogonal, so its inverse is its transpose, and its rows are u, v, n. Unfold the factors of view ← world: rotation and translation.</source>
        <translation>Kamera sada gleda duž {0}. R je teško zapisati; inverz je lak: stupci od {1} su u, v, n. R je ortogonalan operator, pa mu je inverz transponirana matrica, a retci su u, v, n. Rasklopite faktore matrice kamera ← svijet: rotacija i translacija.</translation>
    </message>
    <message>
        <source>R times P</source>
        <translation>R puta P</translation>
    </message>
    <message>
        <source>{0}, from the world&apos;s system (GKS) to the camera&apos;s (KSK); {1} acts first.</source>
        <translation>{0}, iz globalnog koordinatnog sustava (GKS) u koordinatni sustav kamere (KSK); {1} djeluje prva.</translation>
    </message>
    <message>
        <source>{0}, {1}. Which number is in row 3 of {2}&apos;s last column?</source>
        <translation>{0}, {1}. Koji je broj u retku 3 posljednjeg stupca od {2}?</translation>
    </message>
    <message>
        <source>−8: the eye&apos;s z with a minus</source>
        <translation>−8: z kamere s minusom</translation>
    </message>
    <message>
        <source>8: the eye&apos;s z</source>
        <translation>8: z kamere</translation>
    </message>
    <message>
        <source>{0}. {1} acts first, so {2} rotates the translation, too.</source>
        <translation>{0}. {1} djeluje prva, pa {2} rotira i translaciju.</translation>
    </message>
    <message>
        <source>Multiply it out on the board: the last column is minus the eye along u, v and n. In the other order the last column would be minus the eye. All objects are moved, the camera stands still afterwards; how they lie to each other does not change. GKS is the world&apos;s system, KSK the camera&apos;s.</source>
        <translation>Izmnožite na ploči: posljednji stupac je minus položaj kamere duž u, v i n. U drugom redoslijedu posljednji bi stupac bio minus položaj kamere. Pomiču se svi objekti, kamera poslije miruje; njihov međusobni položaj se ne mijenja. GKS je globalni koordinatni sustav, KSK koordinatni sustav kamere.</translation>
    </message>
    <message>
        <source>Why transform at all?</source>
        <translation>Zašto uopće transformirati?</translation>
    </message>
    <message>
        <source>A point behind the camera has {0}. A nearer point has a larger (less negative) z. Here point 1 has −7.5, point 2 has −12, point 3 has 2.</source>
        <translation>Točka iza kamere ima {0}. Bliža točka ima veći (manje negativan) z. Ovdje točka 1 ima −7.5, točka 2 ima −12, točka 3 ima 2.</translation>
    </message>
    <message>
        <source>Three points, and their z in the camera&apos;s system (the Probe panel has them). Which is behind the camera? Which hides which? One comparison each. In the world&apos;s coordinates the same questions need the camera every time. The projection plane is at a right angle to the z axis now, and orthogonal projection is: leave z out. Perspective is one division more.</source>
        <translation>Tri točke i njihov z u koordinatnom sustavu kamere (ima ih ploča Sonda). Koja je iza kamere? Koja skriva koju? Po jedna usporedba. U globalnim koordinatama ista pitanja svaki put trebaju kameru. Ravnina projekcije sada je okomita na os z, a ortogonalna projekcija glasi: ispustite z. Perspektivna je još jedno dijeljenje.</translation>
    </message>
    <message>
        <source>The letter F on its grid</source>
        <translation>Slovo F na svojoj rešetki</translation>
    </message>
    <message>
        <source>Eight cubes on the xz plane, drawn by orthogonal projection: {0}</source>
        <translation>Osam kocaka na xz-ravnini, nacrtanih ortogonalnom projekcijom: {0}</translation>
    </message>
    <message>
        <source>This is the exercise&apos;s class Ortho: every line of the grid and every edge of the cubes goes through R P, and z is forgotten. Parallel edges stay parallel: show three of them. Turn Azimuth: the letter turns, nothing grows or shrinks with distance. The exercise wants lines only; here faces are filled, so that what is in front is seen.</source>
        <translation>To je klasa Ortho iz vježbe: svaka linija rešetke i svaki brid kocaka prolazi kroz R P, a z se zaboravlja. Paralelni bridovi ostaju paralelni: pokažite tri. Okrećite Azimut: slovo se okreće, ništa s udaljenošću ne raste i ne smanjuje se. Vježba traži samo linije; ovdje su strane ispunjene, da se vidi što je ispred.</translation>
    </message>
    <message>
        <source>Round the F</source>
        <translation>Oko slova F</translation>
    </message>
    <message>
        <source>The camera circles the F. Its height changes smoothly, or in steps.</source>
        <translation>Kamera kruži oko slova F. Njezina se visina mijenja glatko ili u skokovima.</translation>
    </message>
    <message>
        <source>Press Play in the tool bar. Open Animation in the dock: let the height of the eye swing, then go in steps, and set the lowest and highest y. In every picture R and P are computed anew from the three vectors; the F itself does not move. Ask what changes in the World pane: only the camera and its frustum.</source>
        <translation>Pritisnite Pokreni na alatnoj traci. Otvorite Animaciju na bočnoj ploči: pustite da se visina kamere njiše, zatim da ide u skokovima, i postavite najniži i najviši y. Na svakoj se slici R i P iznova računaju iz triju vektora; sam F se ne pomiče. Pitajte što se mijenja u oknu Svijet: samo kamera i njezina krnja piramida.</translation>
    </message>
    <message>
        <source>Looking level</source>
        <translation>S horizontalnim pogledom</translation>
    </message>
    <message>
        <source>{0}: the camera looks level, and uprights stay parallel in the picture.</source>
        <translation>{0}: kamera gleda horizontalno, i uspravni bridovi ostaju na slici paralelni.</translation>
    </message>
    <message>
        <source>level</source>
        <translation>horizontalno</translation>
    </message>
    <message>
        <source>looking down</source>
        <translation>gleda dolje</translation>
    </message>
    <message>
        <source>In Animation choose Look: level, and play: the eye&apos;s height and the target&apos;s go together. Uprights are upright now, at any height; World shows both cameras. Change it back to the target: they run together. Then open More of the camera and set up to 1, 1, 0: the picture turns, the F does not. Only the direction of V counts, and only the part of it at a right angle to n.</source>
        <translation>U Animaciji odaberite Pogled: horizontalno, i pokrenite: visina kamere i visina cilja idu zajedno. Uspravni su bridovi sada uspravni, na svakoj visini; Svijet pokazuje obje kamere. Vratite na prema cilju: stječu se. Zatim otvorite Više o kameri i postavite smjer prema gore na 1, 1, 0: slika se okreće, F ne. Računa se samo smjer vektora V, i to samo njegov dio okomit na n.</translation>
    </message>
    <message>
        <source>Perspective</source>
        <translation>Perspektiva</translation>
    </message>
    <message>
        <source>{0}, by the matrix with {1} in its last row.</source>
        <translation>{0}, matricom s {1} u posljednjem retku.</translation>
    </message>
    <message>
        <source>Two similar triangles with the camera as their corner. z is negative in front, so {0} is positive. The matrix: 1, 1, 1 and −1/d; it makes {1}, and dividing by the last number gives {2}, {3} and {4}. Any multiple of the matrix does the same. Move the plane distance d: the picture on the plane grows with d.</source>
        <translation>Dva slična trokuta s vrhom u kameri. z je ispred negativan, pa je {0} pozitivno. Matrica: 1, 1, 1 i −1/d; ona daje {1}, a dijeljenje posljednjim brojem {2}, {3} i {4}. Isto čini svaki višekratnik matrice. Pomičite udaljenost ravnine d: slika na ravnini raste s d.</translation>
    </message>
    <message>
        <source>To the pixels</source>
        <translation>Do piksela</translation>
    </message>
    <message>
        <source>Natural coordinates to pixel coordinates: scale, then shift. {0} and {1} are the middle of the picture, 640 and 360; {2} is negative, since rows count downwards. With d = 1 and this lens {3}, and {4}. Check with point 1: view x = 1.5, z = −7.5, so {5}, and {6}. The Probe panel has it in the row image px.</source>
        <translation>Prirodne koordinate u piksel koordinate: skaliranje, zatim pomak. {0} i {1} su sredina slike, 640 i 360; {2} je negativan, jer se retci broje prema dolje. Uz d = 1 i ovaj objektiv {3}, i {4}. Provjerite na točki 1: u sustavu kamere x = 1.5, z = −7.5, pa je {5}, i {6}. Ploča Sonda to ima u retku slika px.</translation>
    </message>
    <message>
        <source>The F in perspective</source>
        <translation>F u perspektivi</translation>
    </message>
    <message>
        <source>These are the same lines, divided by their depth. A larger {0} only enlarges the picture.</source>
        <translation>To su iste linije, podijeljene svojom dubinom. Veći {0} samo povećava sliku.</translation>
    </message>
    <message>
        <source>d</source>
        <translation>d</translation>
    </message>
    <message>
        <source>2d</source>
        <translation>2d</translation>
    </message>
    <message>
        <source>Two pictures from the same eye: in the second one d is twice as large, and all is twice as large. In the program it is the field of view that does it: {0} from 1.73 to 3.46. Nothing moves against anything else. Then end the comparison and change Distance: now near parts grow faster than far ones. As long as the camera is on a wide enough circle, all is well.</source>
        <translation>Dvije slike iz iste kamere: na drugoj je d dvostruko veći, i sve je dvostruko veće. U programu to čini vidno polje: {0} od 1.73 do 3.46. Ništa se ne pomiče prema drugome. Zatim završite usporedbu i promijenite Udaljenost: sada bliski dijelovi rastu brže od dalekih. Dok je kamera na kružnici dovoljno velikog polumjera, sve je u redu.</translation>
    </message>
    <message>
        <source>Too close</source>
        <translation>Preblizu</translation>
    </message>
    <message>
        <source>The camera comes nearer to the F, and lines appear that nobody drew.</source>
        <translation>Kamera se približava slovu F, i pojavljuju se linije koje nitko nije nacrtao.</translation>
    </message>
    <message>
        <source>Change Distance to 8 first: a good picture. Then come nearer, slowly. As soon as an edge of the F reaches behind the camera, lines go astray. It is not the distance of the plane that does it: with d as small as you like the picture is right, as long as all is in front. The World pane shows the plane through the eye, marked z = 0. Which edges cross it?</source>
        <translation>Najprije promijenite Udaljenost na 8: dobra slika. Zatim se polako približavajte. Čim neki brid slova F seže iza kamere, linije zalutaju. Ne čini to udaljenost ravnine: s d koliko god malim slika je ispravna dok je sve ispred. Okno Svijet pokazuje ravninu kroz kameru, označenu z = 0. Koji je bridovi sijeku?</translation>
    </message>
    <message>
        <source>A line broken at {0}</source>
        <translation>Pravac razlomljen kod {0}</translation>
    </message>
    <message>
        <source>The projection takes the point at {0} to infinity, and the line&apos;s point at infinity to a finite point: the image is a line in two pieces.</source>
        <translation>Projekcija preslikava točku kod {0} u beskonačno daleku, a beskonačno daleku točku pravca u konačnu: slika je pravac u dva dijela.</translation>
    </message>
    <message>
        <source>In the KSK {0}, {1}, and {2}. Which {3} does the image of AB cover?</source>
        <translation>U KSK je {0}, {1}, a {2}. Koje {3} pokriva slika dužine AB?</translation>
    </message>
    <message>
        <source>From 0.5 to −0.5, from one image to the other</source>
        <translation>Od 0.5 do −0.5, od jedne slike do druge</translation>
    </message>
    <message>
        <source>From 0.5 to infinity</source>
        <translation>Od 0.5 do beskonačnosti</translation>
    </message>
    <message>
        <source>{0} grows without bound towards z = 0.</source>
        <translation>{0} prema z = 0 raste bez granice.</translation>
    </message>
    <message>
        <source>AB is straight and goes through the plane z = 0; half of it is behind the camera. Vote, then show: pink the image, orange what the naive program draws; dashed is the piece without an image. In projective geometry the line is a circle, closed by its point at infinity: open Explanation and diagrams for it. Joining A&apos; and B&apos; takes the wrong arc. And the pencil of lines through one point? The F has many parallel edges; their wrong parts all run through the edges&apos; vanishing point. One sentence of the lecture says &quot;plane of projection&quot; where it means z = 0.</source>
        <translation>AB je ravna i prolazi kroz ravninu z = 0; polovica joj je iza kamere. Glasovanje, zatim pokažite: ružičasta je slika, narančasto je ono što crta naivni program; crtkano je komad bez slike. U projektivnoj geometriji pravac je kružnica, zatvorena svojom beskonačno dalekom točkom: za to otvorite Objašnjenje i dijagrami. Spajanje A&apos; i B&apos; uzima pogrešan luk. A pramen pravaca kroz jednu točku? F ima mnogo paralelnih bridova; njihovi pogrešni dijelovi svi prolaze kroz nedogled tih bridova. Jedna rečenica predavanja kaže „ravnina projekcije” ondje gdje misli z = 0.</translation>
    </message>
    <message>
        <source>Four cases</source>
        <translation>Četiri slučaja</translation>
    </message>
    <message>
        <source>If both ends are in front, draw. If both are behind, do not draw. Otherwise cut first.</source>
        <translation>Ako su oba kraja ispred, crtajte. Ako su oba iza, ne crtajte. Inače najprije odsijecite.</translation>
    </message>
    <message>
        <source>1 in front</source>
        <translation>1 ispred</translation>
    </message>
    <message>
        <source>2 behind</source>
        <translation>2 iza</translation>
    </message>
    <message>
        <source>3 A behind</source>
        <translation>3 A iza</translation>
    </message>
    <message>
        <source>4 B behind</source>
        <translation>4 B iza</translation>
    </message>
    <message>
        <source>It begins as case 1, both ends in front. Drag B behind the plane z = 0: case 4. Drag A behind too: case 2, nothing is drawn. B in front again: case 3. The number below the scene&apos;s controls names the case each time. The program of the exercise must keep the last point in camera coordinates, as {0}, also where nothing was drawn.</source>
        <translation>Počinje kao slučaj 1, oba kraja ispred. Povucite B iza ravnine z = 0: slučaj 4. Povucite i A iza: slučaj 2, ništa se ne crta. B opet ispred: slučaj 3. Broj ispod kontrola scene svaki put imenuje slučaj. Program iz vježbe mora pamtiti posljednju točku u koordinatama kamere, kao {0}, i ondje gdje ništa nije nacrtano.</translation>
    </message>
    <message>
        <source>Cut at {0}</source>
        <translation>Odsijecanje kod {0}</translation>
    </message>
    <message>
        <source>{0}, and the point of the line at {1} takes the place of the end behind.</source>
        <translation>{0}, a točka pravca u {1} zauzima mjesto kraja koji je iza.</translation>
    </message>
    <message>
        <source>Not at 0, where the divide fails, but a little in front of it. The three pictures: divided without a cut, cut at z = −0.01, clipped. Dashed is the piece of AB without an image. The cut keeps all of AB in front of the plane, and its image runs out of the frame. Clipping keeps what is inside the pyramid, and the image ends at the frame. In Image they hardly differ: what differs is beside the picture, or at most a few pixels; &quot;More numbers&quot; has it as what the cut leaves out. Clipping in homogeneous coordinates needs no such number: it keeps {0} to {1} before the divide. With this the exercise is done: walk into the F.</source>
        <translation>Ne u 0, gdje dijeljenje zakaže, nego malo ispred. Tri slike: dijeljeno bez odsijecanja, odsječeno kod z = −0.01, odsječeno piramidom. Crtkano je komad dužine AB bez slike. To odsijecanje zadržava sve od AB ispred ravnine, i slika izlazi iz okvira. Odsijecanje piramidom zadržava ono što je unutar nje, i slika završava na okviru. U oknu Slika jedva se razlikuju: razlika je pokraj slike ili najviše nekoliko piksela; „Još brojeva” ima je kao ono što odsijecanje izostavlja. Odsijecanju u homogenim koordinatama takav broj ne treba: ono zadržava {0} do {1} prije dijeljenja. Time je vježba gotova: ušećite u F.</translation>
    </message>
</context>
<context>
    <name>tour</name>
    <message>
        <source>Two minutes with a camera</source>
        <translation>Dvije minute s kamerom</translation>
    </message>
    <message>
        <source>The near plane</source>
        <translation>Bliska ravnina</translation>
    </message>
    <message>
        <source>In the World pane a camera looks at the letter F. The ochre frame is its near plane.</source>
        <translation>U oknu Svijet kamera gleda slovo F. Okvir boje okera je njezina bliska ravnina.</translation>
    </message>
    <message>
        <source>Bring the near plane closer to the camera.</source>
        <translation>Primaknite blisku ravninu kameri.</translation>
    </message>
    <message>
        <source>Drag it in the World pane, by its face, an edge or its name, or move the slider *Near* in the dock to the left.</source>
        <translation>Povucite je u oknu Svijet za plohu, rub ili ime, ili pomaknite klizač *Bliska ravnina* na bočnoj ploči ulijevo.</translation>
    </message>
    <message>
        <source>The picture stays as it is; in the NDC cube everything has moved towards far.</source>
        <translation>Slika ostaje kakva jest; u kocki NDC sve se pomaknulo prema dalekoj ravnini.</translation>
    </message>
    <message>
        <source>From another side</source>
        <translation>S druge strane</translation>
    </message>
    <message>
        <source>You look at camera, frustum and picture from outside. Nothing changes when you walk round them.</source>
        <translation>Kameru, krnju piramidu i sliku gledate izvana. Kad ih obilazite, ništa se ne mijenja.</translation>
    </message>
    <message>
        <source>Turn the world: drag beside the frustum, or anywhere with the middle button.</source>
        <translation>Okrenite svijet: povucite pokraj krnje piramide ili bilo gdje srednjom tipkom.</translation>
    </message>
    <message>
        <source>On the planes a drag moves near or far. With the keyboard: Tab to the World pane, then arrows. The house in its title brings back the first view.</source>
        <translation>Na ravninama povlačenje pomiče blisku ili daleku. Tipkovnicom: Tab do okna Svijet, zatim strelice. Kućica u naslovu vraća prvi pogled.</translation>
    </message>
    <message>
        <source>Only your own view has turned. The image is the camera&apos;s.</source>
        <translation>Okrenuo se samo vaš vlastiti pogled. Slika pripada kameri.</translation>
    </message>
    <message>
        <source>The cube</source>
        <translation>Kocka</translation>
    </message>
    <message>
        <source>Everything between near and far is squeezed into one cube, whatever the lens. That is the NDC cube.</source>
        <translation>Sve između bliske i daleke ravnine stisne se u jednu kocku, kakav god bio objektiv. To je kocka NDC.</translation>
    </message>
    <message>
        <source>Make the cube the large pane.</source>
        <translation>Neka kocka bude veliko okno.</translation>
    </message>
    <message>
        <source>Double-click its title, *NDC cube*, or press Ctrl+2.</source>
        <translation>Dvaput kliknite njezin naslov, *Kocka NDC*, ili pritisnite Ctrl+2.</translation>
    </message>
    <message>
        <source>The small end of the frustum has become the front face.</source>
        <translation>Mali kraj krnje piramide postao je prednja strana.</translation>
    </message>
    <message>
        <source>On the way there</source>
        <translation>Na putu onamo</translation>
    </message>
    <message>
        <source>Each matrix on the way is a stop of the strip below the cube.</source>
        <translation>Svaka matrica na putu je postaja trake ispod kocke.</translation>
    </message>
    <message>
        <source>Go back to an earlier stop of the strip, and forwards again if you like.</source>
        <translation>Vratite se na raniju postaju trake, pa opet naprijed ako želite.</translation>
    </message>
    <message>
        <source>Drag the strip&apos;s slider to the left, or press *View*, *Pyramid* or *Box*; with the focus on it the arrow keys move it.</source>
        <translation>Povucite klizač trake ulijevo ili pritisnite *Kamera*, *Piramida* ili *Kvadar*; kad je fokus na njemu, pomiču ga strelice.</translation>
    </message>
    <message>
        <source>Lines stay straight all the way.</source>
        <translation>Pravci cijelim putem ostaju ravni.</translation>
    </message>
    <message>
        <source>The field of view</source>
        <translation>Vidno polje</translation>
    </message>
    <message>
        <source>How much of the world does the picture show?</source>
        <translation>Koliko svijeta pokazuje slika?</translation>
    </message>
    <message>
        <source>Change the field of view.</source>
        <translation>Promijenite vidno polje.</translation>
    </message>
    <message>
        <source>Move the slider *Field of view* in the dock, or type a number and press Enter.</source>
        <translation>Pomaknite klizač *Vidno polje* na bočnoj ploči ili upišite broj i pritisnite Enter.</translation>
    </message>
    <message>
        <source>The wider the angle, the more of the world you see, and the smaller everything is.</source>
        <translation>Što je kut širi, vidite više svijeta i sve je manje.</translation>
    </message>
    <message>
        <source>Another lens</source>
        <translation>Drugi objektiv</translation>
    </message>
    <message>
        <source>The rays of a parallel lens do not meet in an eye: what is far away is drawn as large as what is near.</source>
        <translation>Zrake paralelnog objektiva ne sijeku se u kameri: što je daleko, crta se jednako velikim kao ono što je blizu.</translation>
    </message>
    <message>
        <source>Choose the orthographic lens.</source>
        <translation>Odaberite ortogonalni objektiv.</translation>
    </message>
    <message>
        <source>*Lens*, in the dock, is a list: choose *orthographic* in it. From the keyboard press Tab until it has the focus, then Down until it is *orthographic*.</source>
        <translation>*Objektiv*, na bočnoj ploči, je popis: odaberite u njemu *ortogonalni*. Tipkovnicom pritišćite Tab dok ne dobije fokus, zatim strelicu dolje dok ne bude *ortogonalni*.</translation>
    </message>
    <message>
        <source>The frustum is a box. The list at the top left has a scene for each topic of the lectures.</source>
        <translation>Krnja piramida postala je kvadar. Popis gore lijevo ima scenu za svaku temu predavanja.</translation>
    </message>
</context>
</TS>
