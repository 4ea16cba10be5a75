<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="et" sourcelanguage="en">
<context>
    <name>ideas</name>
    <message>
        <source>Wrong ideas, and what refutes them</source>
        <translation>Väärarusaamad ja mis need ümber lükkab</translation>
    </message>
    <message>
        <source>n is where I look</source>
        <translation>n on see, kuhu ma vaatan</translation>
    </message>
    <message>
        <source>This takes the direction of view for {0}. The camera looks along {1}: {2} runs from the target back to the eye, so that with {3} to the right and {4} up the three axes are right-handed.</source>
        <translation>Nii võetakse vektoriks {0} vaate suund. Kaamera vaatab suunas {1}: {2} on suunatud sihtpunktist tagasi silma, nii et koos vektoriga {3} paremale ja vektoriga {4} üles on kolm telge paremakäelised.</translation>
    </message>
    <message>
        <source>My up vector is v</source>
        <translation>Minu ülesvektor on v</translation>
    </message>
    <message>
        <source>This takes the normalised up vector for {0}. Up only has to point roughly upwards; {1} is at a right angle to the view direction, so the more the camera looks down, the farther {2} tilts away from up.</source>
        <translation>Nii võetakse vektoriks {0} normeeritud ülesvektor. Ülesvektor peab ainult ligikaudu üles näitama; {1} on vaate suunaga risti, nii et mida rohkem kaamera alla vaatab, seda kaugemale kaldub {2} ülesvektorist.</translation>
    </message>
    <message>
        <source>Unit times unit is a unit</source>
        <translation>Ühik korda ühik on ühik</translation>
    </message>
    <message>
        <source>This does not normalise the cross product of up and {0}, because both are unit vectors. But its length is the sine of the angle between them, so {1} is the product divided by that length; otherwise everything measured along {2} is too short.</source>
        <translation>Nii jäetakse ülesvektori ja vektori {0} vektorkorrutis normeerimata, sest mõlemad on ühikvektorid. Aga selle pikkus on nendevahelise nurga siinus, seega on {1} korrutis jagatud selle pikkusega; muidu on kõik, mida piki telge {2} mõõdetakse, liiga lühike.</translation>
    </message>
    <message>
        <source>The view matrix puts the camera in its place</source>
        <translation>Vaatemaatriks paneb kaamera oma kohale</translation>
    </message>
    <message>
        <source>This writes down the inverse of the view matrix, which moves a camera from the origin to its place. The view matrix does the opposite: it moves the world until the eye is at the origin, so its last column is minus the eye along {0}, {1} and {2}, not the eye.</source>
        <translation>Nii kirjutatakse vaatemaatriksi pöördmaatriks, mis viib kaamera alguspunktist oma kohale. Vaatemaatriks teeb vastupidist: see liigutab maailma, kuni silm on alguspunktis, nii et selle viimane veerg on miinus silm piki telgi {0}, {1} ja {2}, mitte silm.</translation>
    </message>
    <message>
        <source>Rows and columns may change places</source>
        <translation>Read ja veerud võivad kohad vahetada</translation>
    </message>
    <message>
        <source>This reads the matrix with rows and columns exchanged. Points are columns here, {0}, so a cell {1} says how much of coordinate {2} goes into coordinate {3}, and the axes are the columns.</source>
        <translation>Nii loetakse maatriksit, mille read ja veerud on vahetuses. Punktid on siin veerud, {0}, nii et lahter {1} ütleb, kui palju koordinaadist {2} läheb koordinaati {3}, ja teljed on veerud.</translation>
    </message>
    <message>
        <source>The order does not matter</source>
        <translation>Järjekord ei loe</translation>
    </message>
    <message>
        <source>This multiplies the factors in the opposite order. The factor on the right acts first. First rotating and then moving differs from first moving and then rotating, because the later rotation rotates the move as well.</source>
        <translation>Nii korrutatakse tegureid vastupidises järjekorras. Esimesena mõjub parempoolne tegur. Enne pöörata ja siis nihutada ei ole sama mis enne nihutada ja siis pöörata, sest hilisem pööre pöörab ka nihet.</translation>
    </message>
    <message>
        <source>The function takes my degrees</source>
        <translation>Funktsioonile kõlbavad minu kraadid</translation>
    </message>
    <message>
        <source>This passes degrees to a function that expects radians. 60 degrees are {0} radians; 60 radians are nine and a half turns, so the result can be anything, even of the opposite sign, and the picture upside down.</source>
        <translation>Nii antakse kraadid funktsioonile, mis ootab radiaane. 60 kraadi on {0} radiaani; 60 radiaani on üheksa ja pool pööret, nii et tulemus võib olla mis tahes, isegi vastupidise märgiga, ja pilt tagurpidi.</translation>
    </message>
    <message>
        <source>The lens takes the whole angle</source>
        <translation>Objektiiv võtab kogu nurga</translation>
    </message>
    <message>
        <source>This takes the tangent or cotangent of the whole field of view. The right-angled triangle lies between the axis and the edge of the picture and contains half of the angle: at 90° the lens has {0}, whereas {1} is 0.</source>
        <translation>Nii võetakse kogu frustumi nurga tangens või kootangens. Täisnurkne kolmnurk on telje ja pildi serva vahel ning selles on pool nurka: 90° korral on objektiivil {0}, aga {1} on 0.</translation>
    </message>
    <message>
        <source>Twice the angle is twice the width</source>
        <translation>Kahekordne nurk on kahekordne laius</translation>
    </message>
    <message>
        <source>This assumes that widths are proportional to angles. They are proportional to the tangent of half the angle: with 120° high and 16:9 that tangent is 1.73 upwards and 3.08 sideways, so the picture is 144.0° wide: 72.0° on each side, not 213°, which no picture can be.</source>
        <translation>Nii eeldatakse, et laiused on võrdelised nurkadega. Need on võrdelised poole nurga tangensiga: kui vertikaalne nurk on 120° ja pilt 16:9, on see tangens üles 1.73 ja kõrvale 3.08, nii et pildi laius on 144.0°: kummalgi pool 72.0°, mitte 213°, mida ühelgi pildil olla ei saa.</translation>
    </message>
    <message>
        <source>An angle is an angle</source>
        <translation>Nurk on nurk</translation>
    </message>
    <message>
        <source>This uses the vertical angle in place of the horizontal one. A picture that is wider than high reaches farther sideways than upwards, as width to height, and so does the tangent of half the angle; only then do circles stay round.</source>
        <translation>Nii kasutatakse horisontaalse nurga asemel vertikaalset. Pilt, mis on laiem kui kõrge, ulatub kõrvale kaugemale kui üles, nagu laius kõrguse suhtes, ja niisamuti poole nurga tangens; ainult siis jäävad ringid ümaraks.</translation>
    </message>
    <message>
        <source>I measure from the picture plane</source>
        <translation>Mõõdan pilditasandist</translation>
    </message>
    <message>
        <source>This divides by the distance from the plane, {0}. The two similar triangles share the corner at the eye, so measure both depths from the eye: {1}.</source>
        <translation>Nii jagatakse kaugusega tasandist, {0}. Kahel sarnasel kolmnurgal on ühine nurk silma juures, seega mõõtke mõlemat sügavust silmast: {1}.</translation>
    </message>
    <message>
        <source>Dividing by z is enough</source>
        <translation>z-iga jagamisest piisab</translation>
    </message>
    <message>
        <source>This has the sign for the wrong side of the eye: in front of it {0} is negative, and {1} is the result for a film *behind* the hole. A plane in front of the eye has {2} and an upright image; only a film behind it, at {3}, has it upside down.</source>
        <translation>Siin on silma vale poole märk: silma ees on {0} negatiivne ja {1} on tulemus filmi jaoks, mis on ava *taga*. Silma ees oleval tasandil on {2} ja püstine kujutis; tagurpidi on see ainult taga oleval filmil, kohal {3}.</translation>
    </message>
    <message>
        <source>Near enlarges</source>
        <translation>Lähitasand suurendab</translation>
    </message>
    <message>
        <source>This multiplies the picture by {0}. The image on the near plane does grow with {1}, but so does the window round it. {2} does not contain {3}: near only decides what is cut.</source>
        <translation>Nii korrutatakse pilti suurusega {0}. Kujutis lähitasandil tõesti kasvab koos suurusega {1}, aga kasvab ka aken selle ümber. Avaldises {2} ei ole suurust {3}: lähitasand otsustab ainult, mis ära lõigatakse.</translation>
    </message>
    <message>
        <source>near 1</source>
        <translation>lähitasand 1</translation>
    </message>
    <message>
        <source>near 2</source>
        <translation>lähitasand 2</translation>
    </message>
    <message>
        <source>Near is a z, so it is negative</source>
        <translation>Lähitasand on z, seega negatiivne</translation>
    </message>
    <message>
        <source>This uses a negative number where a length belongs. Near, far and the distance of a picture plane are lengths from the eye, and positive; the planes are at negative {0}, and the formulas already contain that minus.</source>
        <translation>Nii kasutatakse negatiivset arvu seal, kus on vaja pikkust. Lähitasandi, kaugtasandi ja pilditasandi kaugused on pikkused silmast ja positiivsed; tasandid on seal, kus {0} on negatiivne, ja valemites on see miinus juba olemas.</translation>
    </message>
    <message>
        <source>n and f may change places</source>
        <translation>n ja f võivad kohad vahetada</translation>
    </message>
    <message>
        <source>This swaps {0} and {1}, which changes the sign of {2} and of everything divided by it. The near plane would then be at {3}, where the far plane belongs, and all depths would run backwards.</source>
        <translation>Nii vahetatakse {0} ja {1}, mis muudab suuruse {2} ja kõige sellega jagatu märki. Lähitasand oleks siis kohal {3}, kuhu kuulub kaugtasand, ja kõik sügavused jookseksid tagurpidi.</translation>
    </message>
    <message>
        <source>A window to the right moves the picture right</source>
        <translation>Aken paremale viib pildi paremale</translation>
    </message>
    <message>
        <source>This shifts the picture to the same side as the window. The window frames what you see: if its middle is right of the axis, the axis appears left of the picture&apos;s middle, at {0}. The matrix has a plus there because that cell is multiplied by {1}, which is negative.</source>
        <translation>Nii nihutatakse pilti samale poole kui akent. Aken raamib seda, mida te näete: kui selle keskkoht on teljest paremal, paistab telg pildi keskkohast vasakul, kohal {0}. Maatriksis on seal pluss, sest see lahter korrutatakse suurusega {1}, mis on negatiivne.</translation>
    </message>
    <message>
        <source>Cameras turn as eyes do</source>
        <translation>Kaamerad pöörduvad nagu silmad</translation>
    </message>
    <message>
        <source>This toes the two cameras in, because eyes turn to what they look at. But each turned camera divides by the depth along its own axis, so points at the sides are not equally high in both pictures, and no pair of eyes can look up with one eye and down with the other: both cameras look straight ahead, and their windows move.</source>
        <translation>Nii pööratakse kaks kaamerat kokku, sest silmad pöörduvad selle poole, mida vaatavad. Aga kumbki pööratud kaamera jagab sügavusega piki omaenda telge, nii et äärtes olevad punktid ei ole mõlemal pildil ühel kõrgusel, ja ükski silmapaar ei saa ühe silmaga üles ja teisega alla vaadata: mõlemad kaamerad vaatavad otse ette ja liiguvad nende aknad.</translation>
    </message>
    <message>
        <source>Far is always small</source>
        <translation>Kauge on alati väike</translation>
    </message>
    <message>
        <source>This divides by the depth, although the projectors are parallel. A parallel lens divides every point by 1, so equal heights stay equal at every depth.</source>
        <translation>Nii jagatakse sügavusega, kuigi projektsioonikiired on paralleelsed. Paralleelne objektiiv jagab iga punkti 1-ga, nii et võrdsed kõrgused jäävad igal sügavusel võrdseks.</translation>
    </message>
    <message>
        <source>Clip is NDC</source>
        <translation>Kärperuum on NDC</translation>
    </message>
    <message>
        <source>This stops at the clip coordinates. The division by {0} is still to come, {1} and {2}; it makes far things small.</source>
        <translation>Nii jäädakse pooleli kärperuumi koordinaatide juures. Jagamine suurusega {0} on veel ees, {1} ja {2}; see teeb kauged asjad väikeseks.</translation>
    </message>
    <message>
        <source>z needs no divide</source>
        <translation>z ei vaja jagamist</translation>
    </message>
    <message>
        <source>This stops before the division. The depth is divided by {0} like {1} and {2}: only then does far come to 1, and only then do straight lines stay straight.</source>
        <translation>Nii jäädakse pooleli enne jagamist. Sügavus jagatakse suurusega {0} nagu {1} ja {2}: alles siis satub kaugtasand kohale 1 ja alles siis jäävad sirged sirgeks.</translation>
    </message>
    <message>
        <source>Depth is the distance to the eye</source>
        <translation>Sügavus on kaugus silmani</translation>
    </message>
    <message>
        <source>This measures straight from the eye to the point. Depth is measured along the axis only, because near and far are planes, not spheres: a point at the side is farther away than it is deep.</source>
        <translation>Nii mõõdetakse silmast otse punktini. Sügavust mõõdetakse ainult piki telge, sest lähi- ja kaugtasand on tasandid, mitte kerad: kõrval oleva punkti kaugus on suurem kui selle sügavus.</translation>
    </message>
    <message>
        <source>Depth runs evenly</source>
        <translation>Sügavus kasvab ühtlaselt</translation>
    </message>
    <message>
        <source>This spreads the depth evenly between near and far. But {0} changes with one over the depth, so the cube is filled fast at first: its middle is less than twice as deep as near.</source>
        <translation>Nii jaotatakse sügavus lähi- ja kaugtasandi vahel ühtlaselt. Aga {0} muutub koos sügavuse pöördarvuga, nii et alguses täitub kuup kiiresti: selle keskkoha sügavus on vähem kui kaks korda lähitasandi oma.</translation>
    </message>
    <message>
        <source>Near stays where it is in the pyramid</source>
        <translation>Lähitasand jääb püramiidis oma kohale</translation>
    </message>
    <message>
        <source>This leaves the near plane at {0}. On the way into the canonical pyramid everything is divided by {1}, so far comes to {2} and near to {3}.</source>
        <translation>Nii jäetakse lähitasand kohale {0}. Teel kanoonilisse püramiidi jagatakse kõik suurusega {1}, nii et kaugtasand satub kohale {2} ja lähitasand kohale {3}.</translation>
    </message>
    <message>
        <source>NDC starts at 0</source>
        <translation>NDC algab 0-st</translation>
    </message>
    <message>
        <source>This takes an NDC coordinate for a share from 0 to 1. It runs from {0} to {1} with 0 in the middle, so first add 1 and then halve: {2} and depth {3}.</source>
        <translation>Nii võetakse NDC koordinaat osaks 0-st 1-ni. See on kohast {0} kohani {1} ja keskel 0, seega liitke enne 1 ja võtke siis pool: {2} ja sügavus {3}.</translation>
    </message>
    <message>
        <source>Pixel rows count up</source>
        <translation>Pikslite ridu loetakse alt üles</translation>
    </message>
    <message>
        <source>This counts the rows of pixels upwards, like {0}. The image begins at its upper left corner and its rows count downwards: the higher a point is, the smaller is its row.</source>
        <translation>Nii loetakse pikslite ridu alt üles, nagu kasvab {0}. Pilt algab ülemisest vasakust nurgast ja selle ridu loetakse ülalt alla: mida kõrgemal punkt on, seda väiksem on selle rida.</translation>
    </message>
    <message>
        <source>Pixel 100 is at 100</source>
        <translation>Piksel 100 on kohal 100</translation>
    </message>
    <message>
        <source>This takes a pixel&apos;s number for the position of its centre. Pixel {0} reaches from {1} to {2}, so its centre is at {3}, so {4}: the outer centres of four pixels are at {5}, not at {6}.</source>
        <translation>Nii võetakse piksli keskpunkti kohaks piksli number. Piksel {0} ulatub kohast {1} kohani {2}, seega on selle keskpunkt kohal {3}, seega {4}: nelja piksli äärmised keskpunktid on kohtadel {5}, mitte kohtadel {6}.</translation>
    </message>
    <message>
        <source>k makes up the difference</source>
        <translation>k on kogu vahe</translation>
    </message>
    <message>
        <source>This adds the whole missing length at one end and again at the other. Both ends get the same share, so each gets half of what is missing.</source>
        <translation>Nii liidetakse kogu puuduv pikkus ühes otsas ja siis veel kord teises. Mõlemad otsad saavad sama palju, seega kumbki pool sellest, mis puudub.</translation>
    </message>
    <message>
        <source>stretched</source>
        <translation>venitatud</translation>
    </message>
    <message>
        <source>variant X</source>
        <translation>variant X</translation>
    </message>
    <message>
        <source>X adjusts x</source>
        <translation>X kohandab x-i</translation>
    </message>
    <message>
        <source>This takes the letter for the coordinate that changes. Variant X *keeps* {0} and {1} and adjusts {2} until the window has the picture&apos;s proportions; variant Y keeps {3} and adjusts {4}.</source>
        <translation>Nii peetakse tähte selleks koordinaadiks, mis muutub. Variant X *säilitab* {0} ja {1} ning kohandab koordinaati {2}, kuni aknal on pildi proportsioonid; variant Y säilitab {3} ja kohandab {4}.</translation>
    </message>
    <message>
        <source>variant Y</source>
        <translation>variant Y</translation>
    </message>
    <message>
        <source>The slant grows with alpha</source>
        <translation>Kalle kasvab koos alfaga</translation>
    </message>
    <message>
        <source>This takes {0} for the slant. {1} is the angle between the projectors and the picture, so at 90° they meet it head-on and nothing is shifted. The formula is {2}; at 80° the shift is only 0.18 for each unit of depth.</source>
        <translation>Nii võetakse kaldeks {0}. {1} on projektsioonikiirte ja pildi vaheline nurk, nii et 90° korral kohtavad need pilti otse ja midagi ei nihku. Valem on {2}; 80° korral on nihe ainult 0.18 sügavuse ühiku kohta.</translation>
    </message>
    <message>
        <source>Half the scale, half the slant</source>
        <translation>Pool mastaapi, pool kallet</translation>
    </message>
    <message>
        <source>This assumes that the angle is proportional to the scale. The scale is the cotangent of the angle, {0}, so a cabinet drawing with {1} has {2}, not 67.5°.</source>
        <translation>Nii eeldatakse, et nurk on mastaabiga võrdeline. Mastaap on nurga kootangens, {0}, nii et cabinet-joonisel, mille {1}, on {2}, mitte 67.5°.</translation>
    </message>
    <message>
        <source>Infinity is very far</source>
        <translation>Lõpmatus on väga kaugel</translation>
    </message>
    <message>
        <source>This takes a point that is very far away for the point at infinity. A direction has {0} and no starting point, so its image depends on the direction alone, {1}; every point on the way there falls short of it.</source>
        <translation>Nii võetakse lõpmatuspunktiks väga kaugel olev punkt. Suunal on {0} ja alguspunkti ei ole, nii et selle kujutis sõltub ainult suunast, {1}; ükski punkt teel sinna ei küüni selleni.</translation>
    </message>
    <message>
        <source>A box has three</source>
        <translation>Risttahukal on neid kolm</translation>
    </message>
    <message>
        <source>This counts the directions of the box. Only a direction that is not parallel to the picture has a vanishing point, {0}; edges that are parallel to the picture stay parallel in it.</source>
        <translation>Nii loetakse risttahuka suundi. Koondumispunkt on ainult suunal, mis ei ole pildiga paralleelne, {0}; pildiga paralleelsed servad jäävad sellel paralleelseks.</translation>
    </message>
    <message>
        <source>Join the two images</source>
        <translation>Ühendage kaks kujutist</translation>
    </message>
    <message>
        <source>This divides both ends and joins the results. An end behind the eye has {0}, and its image is mirrored. The right image of the segment runs through infinity, not between the two, so cut the segment in front of the eye before dividing.</source>
        <translation>Nii jagatakse mõlemat otsa ja ühendatakse tulemused. Silma taga oleval otsal on {0} ja selle kujutis on peegeldatud. Lõigu õige kujutis läheb läbi lõpmatuse, mitte nende kahe vahelt, seepärast lõigake lõik enne jagamist silma eest läbi.</translation>
    </message>
    <message>
        <source>The middle of the picture is the middle of the edge</source>
        <translation>Pildi keskkoht on serva keskkoht</translation>
    </message>
    <message>
        <source>This interpolates {0} itself on the screen. There {1} and {2} are linear, so {3}, and the middle of the picture shows a place that is closer to the nearer end.</source>
        <translation>Nii interpoleeritakse ekraanil {0} ise. Seal on lineaarsed {1} ja {2}, seega {3}, ja pildi keskkoht näitab kohta, mis on lähemale otsale lähemal.</translation>
    </message>
    <message>
        <source>A lamp is a sun</source>
        <translation>Lamp on päike</translation>
    </message>
    <message>
        <source>This takes the lamp&apos;s position for a direction that all rays share. From a lamp each ray has its own direction, {0}, and meets the ground at {1}; only the sun is so far away that all rays are parallel.</source>
        <translation>Nii võetakse lambi asukoht suunaks, mis on kõigil kiirtel ühine. Lambist on igal kiirel oma suund, {0}, ja see kohtab maad kohas {1}; ainult päike on nii kaugel, et kõik kiired on paralleelsed.</translation>
    </message>
    <message>
        <source>As sharp behind as before</source>
        <translation>Taga sama terav kui ees</translation>
    </message>
    <message>
        <source>This puts the far limit as far behind the focus as the near limit is in front of it. The limits are {0} and {1}. Their reciprocals are equally far from {2}, so the sharp range reaches farther behind than in front, and it has no end from {3} on.</source>
        <translation>Nii pannakse kaugem piir fookuse taha sama kaugele, kui lähem piir on selle ees. Piirid on {0} ja {1}. Nende pöördarvud on arvust {2} võrdsel kaugusel, nii et terav vahemik ulatub taga kaugemale kui ees, ja alates {3} ei ole sellel lõppu.</translation>
    </message>
    <message>
        <source>Zooming is walking</source>
        <translation>Suumimine on kõndimine</translation>
    </message>
    <message>
        <source>This keeps the size ratio of the old place after a walk. A zoom enlarges the whole picture by one factor, but sizes are proportional to one over the distance. Walking therefore changes {0}, the size ratio of a thing and an equal one {1} behind it.</source>
        <translation>Nii jäetakse pärast kõndimist alles vana koha suuruste suhe. Suum suurendab kogu pilti sama arv kordi, aga suurused on võrdelised kauguse pöördarvuga. Kõndimine muudab seepärast suurust {0}, mis on asja ja sellest {1} tagapool oleva võrdse asja suuruste suhe.</translation>
    </message>
    <message>
        <source>More places than pixels are enough</source>
        <translation>Piisab, kui kohti on rohkem kui piksleid</translation>
    </message>
    <message>
        <source>This counts the places of a coordinate against the pixels of a picture. The places are spread over the whole scene, {0} apart, and a picture may show a small part of it: there the gap between two of 65 536 places can be wider than a pixel.</source>
        <translation>Nii võrreldakse koordinaadi kohtade arvu pildi pikslite arvuga. Kohad on jaotatud üle kogu stseeni, vahega {0}, ja pilt võib näidata sellest väikest osa: seal võib kahe koha vahe, olgugi kohti 65 536, olla pikslist laiem.</translation>
    </message>
    <message>
        <source>Seven digits, so seven are right</source>
        <translation>Seitse numbrit, seega on õiged seitse</translation>
    </message>
    <message>
        <source>This takes the digits of a coordinate for those of the picture. A float32 keeps 24 bits of the whole number; when eye and vertex, both near 1 000 000, are subtracted, the leading digits go and the rounding stays, so two or three digits are left.</source>
        <translation>Nii võetakse pildi numbriteks koordinaadi numbrid. float32 hoiab kogu arvust 24 bitti; kui silm ja tipp, mõlemad 1 000 000 lähedal, lahutatakse, kaovad esimesed numbrid ja ümardusviga jääb, nii et järele jääb kaks või kolm numbrit.</translation>
    </message>
    <message>
        <source>An error is the same everywhere</source>
        <translation>Viga on kõikjal sama</translation>
    </message>
    <message>
        <source>This takes the error in the scene for the error in the picture. A vertex is stored wrong by a fixed length, but a length is drawn with {0} pixels a unit: twice as near, every error is twice as large.</source>
        <translation>Nii võetakse veaks pildil viga stseenis. Tipp on salvestatud kindla pikkusega veaga, aga pikkus joonistatakse nii, et ühikus on {0} pikslit: kaks korda lähemal on iga viga kaks korda suurem.</translation>
    </message>
    <message>
        <source>Seven digits, so 360 steps keep five</source>
        <translation>Seitse numbrit, seega jääb 360 sammuga alles viis</translation>
    </message>
    <message>
        <source>This takes the digits of the format for those of the result. How much a step loses depends on what it does: with a fast inverse square root each renormalising is off by 0.17 %, and after one round two digits are left, in float32 and in float64.</source>
        <translation>Nii võetakse tulemuse numbriteks vormingu numbrid. Kui palju samm kaotab, sõltub sellest, mida see teeb: kiire pöördruutjuurega on iga uuesti normeerimise viga 0.17 % ja pärast üht ringi jääb järele kaks numbrit, nii float32-s kui ka float64-s.</translation>
    </message>
    <message>
        <source>Renormalising repairs the direction</source>
        <translation>Uuesti normeerimine parandab suuna</translation>
    </message>
    <message>
        <source>This expects of axes that are made orthonormal again that they point where they should. Renormalising knows the lengths, 1, and the angles between the axes, 90°. It does not know where the camera should look, so the drift of the direction stays.</source>
        <translation>Nii oodatakse telgedelt, mis on jälle ortonormeeritud, et need näitavad sinna, kuhu peaksid. Uuesti normeerimine teab pikkusi, 1, ja telgede vahelisi nurki, 90°. See ei tea, kuhu kaamera vaatama peaks, nii et suuna triiv jääb.</translation>
    </message>
    <message>
        <source>Logarithmic depth is always better</source>
        <translation>Logaritmiline sügavus on alati parem</translation>
    </message>
    <message>
        <source>This takes a better spread of digits for a better depth. A logarithm at each pixel is right everywhere; at the vertices it is interpolated linearly on the screen, where only {0} is linear. A piece whose far end is {1} times as far as its near end is drawn up to {2} times too far.</source>
        <translation>Nii peetakse numbrikohtade paremat jaotust paremaks sügavuseks. Logaritm igas pikslis on kõikjal õige; tippudes arvutatuna interpoleeritakse seda ekraanil lineaarselt, kus lineaarne on ainult {0}. Tükk, mille kaugem ots on {1} korda nii kaugel kui lähem, joonistatakse kuni {2} korda liiga kaugele.</translation>
    </message>
    <message>
        <source>Fine enough is equal</source>
        <translation>Piisavalt peen on võrdne</translation>
    </message>
    <message>
        <source>This takes a small error for none. Two grids put the same vertex at two places, however many bits they have: more bits make the gap narrower, and from near enough it is seen again. Only a common grid rounds both copies alike.</source>
        <translation>Nii peetakse väikest viga olematuks. Kaks ruudustikku panevad sama tipu kahte kohta, olgu bitte kui palju tahes: rohkem bitte teeb pilu kitsamaks ja piisavalt lähedalt on seda jälle näha. Ainult ühine ruudustik ümardab mõlemat koopiat ühtemoodi.</translation>
    </message>
    <message>
        <source>The inverse undoes exactly</source>
        <translation>Pöördmaatriks võtab täpselt tagasi</translation>
    </message>
    <message>
        <source>This takes the inverse on paper for the one in the computer. Its cells are rounded, and so is each product. Far from the origin the eye&apos;s coordinates are large, and the inverse multiplies them with a small difference of rounded numbers: float32 misses a point by per cent of its distance.</source>
        <translation>Nii peetakse paberil olevat pöördmaatriksit arvutis olevaks. Selle lahtrid on ümardatud ja ümardatud on ka iga korrutis. Alguspunktist kaugel on silma koordinaadid suured ja pöördmaatriks korrutab need ümardatud arvude väikese vahega: float32 läheb punktist mööda protsentide võrra selle kaugusest.</translation>
    </message>
    <message>
        <source>First the move, then the turn</source>
        <translation>Enne nihe, siis pööre</translation>
    </message>
    <message>
        <source>This moves first and then turns. A rotation turns about the world&apos;s origin, so it carries the moved object along a circle: {0} turns it in its place, {1} swings it round.</source>
        <translation>Nii nihutatakse enne ja pööratakse siis. Pööratakse ümber maailma alguspunkti, nii et nihutatud objekt liigub mööda ringjoont kaasa: {0} pöörab seda paigal, {1} viib selle kaarega mujale.</translation>
    </message>
    <message>
        <source>A scale leaves the move alone</source>
        <translation>Skaleerimine nihet ei muuda</translation>
    </message>
    <message>
        <source>This moves first and then scales. A scale is about the world&apos;s origin, so it multiplies the move, too: with a factor of 2 a move by 3 ends at 6.</source>
        <translation>Nii nihutatakse enne ja skaleeritakse siis. Skaleeritakse maailma alguspunkti suhtes, nii et korrutatakse ka nihe: kordajaga 2 jõuab nihe 3 võrra kohta 6.</translation>
    </message>
    <message>
        <source>The mirror stands beside the object</source>
        <translation>Peegel seisab objekti kõrval</translation>
    </message>
    <message>
        <source>This moves first and then mirrors. The mirror is a plane through the world&apos;s origin, so it takes a move by 3 to the other side, to {0}.</source>
        <translation>Nii nihutatakse enne ja peegeldatakse siis. Peegel on tasand läbi maailma alguspunkti, nii et nihe 3 võrra satub teisele poole, kohta {0}.</translation>
    </message>
    <message>
        <source>Scale and turn may change places</source>
        <translation>Skaleerimine ja pööre võivad kohad vahetada</translation>
    </message>
    <message>
        <source>This turns first and then scales along the world&apos;s axes. With unequal factors the turned object loses its right angles. Scaled first, along its own axes, and then turned, it keeps them.</source>
        <translation>Nii pööratakse enne ja skaleeritakse siis piki maailma telgi. Kui kordajad ei ole võrdsed, kaotab pööratud objekt oma täisnurgad. Kui objekti enne omaenda telgede sihis skaleerida ja siis pöörata, jäävad need alles.</translation>
    </message>
    <message>
        <source>Mirror and turn may change places</source>
        <translation>Peegeldus ja pööre võivad kohad vahetada</translation>
    </message>
    <message>
        <source>This turns first and then mirrors. A mirror reverses the turns that were made before it, so the mirrored object is turned by minus the angle.</source>
        <translation>Nii pööratakse enne ja peegeldatakse siis. Peegeldus muudab enne seda tehtud pöörded vastassuunalisteks, nii et peegeldatud objekt on pööratud miinus nurga võrra.</translation>
    </message>
    <message>
        <source>Shear and turn may change places</source>
        <translation>Kaldnihe ja pööre võivad kohad vahetada</translation>
    </message>
    <message>
        <source>This turns first and then shears along the world&apos;s axes. Sheared first, the object has its slant along its own axes, and takes it along when it turns.</source>
        <translation>Nii pööratakse enne ja tehakse siis kaldnihe piki maailma telgi. Kui kaldnihe teha enne, on kalle objekti enda telgede sihis ja objekt võtab selle pöördudes kaasa.</translation>
    </message>
    <message>
        <source>Turns about two axes may change places</source>
        <translation>Pöörded ümber kahe telje võivad kohad vahetada</translation>
    </message>
    <message>
        <source>This exchanges two rotations about different axes. Read from the right, each turns about an axis of the world, which stays fixed. Read from the left, each turns about an axis that the turns before have moved.</source>
        <translation>Nii vahetatakse omavahel kaks pööret, mille teljed on erinevad. Paremalt lugedes toimub iga pööre ümber maailma telje, mis jääb paigale. Vasakult lugedes toimub iga pööre ümber telje, mida eelmised pöörded on liigutanud.</translation>
    </message>
    <message>
        <source>The camera turns before it moves</source>
        <translation>Kaamerat pööratakse enne nihutamist</translation>
    </message>
    <message>
        <source>This rotates before the eye is at the origin. The view matrix first moves the eye to the origin and then rotates about it, so the translation stands on the right of the rotation.</source>
        <translation>Nii pööratakse, enne kui silm on alguspunktis. Vaatemaatriks viib enne silma alguspunkti ja pöörab siis selle ümber, nii et nihe on pöördest paremal.</translation>
    </message>
    <message>
        <source>The view comes before the object</source>
        <translation>Vaade tuleb enne objekti</translation>
    </message>
    <message>
        <source>This puts the view matrix on the right of the object&apos;s moves. A point starts in object space: the object&apos;s matrix takes it to the world, and only then the view matrix takes it to the camera.</source>
        <translation>Nii pannakse vaatemaatriks objekti teisendustest paremale. Punkt alustab objekti ruumist: objekti maatriks viib selle maailma ja alles siis viib vaatemaatriks selle kaamerani.</translation>
    </message>
    <message>
        <source>Project first, then look</source>
        <translation>Enne projitseerida, siis vaadata</translation>
    </message>
    <message>
        <source>This projects before the points are in camera space. The lens makes {0} of {1}, which is the depth only in camera space. Of a point of the world it takes the world&apos;s {2}, and {3} is no longer the depth.</source>
        <translation>Nii projitseeritakse, enne kui punktid on kaamerafreimis. Objektiiv teeb suuruse {0} suurusest {1}, mis on sügavus ainult kaamerafreimis. Maailma punktilt võtab see maailma {2} ja {3} ei ole enam sügavus.</translation>
    </message>
    <message>
        <source>The depths are stretched first</source>
        <translation>Sügavused venitatakse enne</translation>
    </message>
    <message>
        <source>This puts {0} on the right of {1}. {2} stretches depths that run from 0 to {3}, and only {4} makes such depths.</source>
        <translation>Nii pannakse {0} maatriksist {1} paremale. {2} venitab sügavusi, mis on 0 ja {3} vahel, aga selliseid sügavusi teeb ainult {4}.</translation>
    </message>
    <message>
        <source>The box needs no pyramid</source>
        <translation>Risttahukas püramiidi ei vaja</translation>
    </message>
    <message>
        <source>This puts {0} on the right of {1}. {2} needs the canonical pyramid, with far at {3} and sides at {4}, and only {5} makes it.</source>
        <translation>Nii pannakse {0} maatriksist {1} paremale. {2} vajab kanoonilist püramiidi, mille kaugtasand on kohal {3} ja küljed kohtadel {4}, aga selle teeb ainult {5}.</translation>
    </message>
    <message>
        <source>Pixels before the divide</source>
        <translation>Pikslid enne jagamist</translation>
    </message>
    <message>
        <source>This counts pixels before the division by {0}. The viewport needs {1} and {2} from {3} to 1, and only the division makes them: its shift to the middle of the picture would be divided, too.</source>
        <translation>Nii loetakse piksleid enne jagamist suurusega {0}. Viewport vajab, et {1} ja {2} oleksid {3} ja 1 vahel, aga sellised teeb need ainult jagamine: muidu jagataks ka viewport-teisenduse nihe pildi keskkohta.</translation>
    </message>
    <message>
        <source>The divide is done twice</source>
        <translation>Jagatakse kaks korda</translation>
    </message>
    <message>
        <source>This divides {0}, {1} and {2} by {3} and keeps {4}, so the next division divides them again. Once divided, a point has {5}, and dividing by that changes nothing.</source>
        <translation>Nii jagatakse {0}, {1} ja {2} suurusega {3} ning {4} jäetakse samaks, nii et järgmine jagamine jagab need veel kord. Kord jagatud punktil on {5} ja sellega jagamine ei muuda midagi.</translation>
    </message>
    <message>
        <source>Clockwise is positive</source>
        <translation>Päripäeva on positiivne</translation>
    </message>
    <message>
        <source>This turns by minus the angle. An angle is positive anticlockwise, seen from the tip of its axis: about z it turns x towards y.</source>
        <translation>Nii pööratakse miinus nurga võrra. Nurk on positiivne vastupäeva, vaadates telje otsast: ümber z-telje pöörab see x-telje y-telje poole.</translation>
    </message>
    <message>
        <source>Moves have the other sign</source>
        <translation>Nihetel on teine märk</translation>
    </message>
    <message>
        <source>This moves by minus the numbers. A translation adds its numbers to the coordinates. The view matrix subtracts the eye, because it moves the world and not the camera.</source>
        <translation>Nii nihutatakse miinus nende arvude võrra. Nihe liidab oma arvud koordinaatidele. Vaatemaatriks lahutab silma, sest see liigutab maailma ja mitte kaamerat.</translation>
    </message>
    <message>
        <source>A scale divides</source>
        <translation>Skaleerimine jagab</translation>
    </message>
    <message>
        <source>This divides by the factors of the scale. A factor of 2 makes the object twice as large; one half undoes that.</source>
        <translation>Nii jagatakse skaleerimise kordajatega. Kordaja 2 teeb objekti kaks korda suuremaks; kordaja pool võtab selle tagasi.</translation>
    </message>
    <message>
        <source>Any axis will do</source>
        <translation>Sobib mis tahes telg</translation>
    </message>
    <message>
        <source>This turns about another axis. What lies on the axis of a rotation stays where it is: a turn about z changes x and y, and keeps z.</source>
        <translation>Nii pööratakse ümber teise telje. Mis on pöörde teljel, jääb oma kohale: pööre ümber z-telje muudab x-i ja y-it ning säilitab z-i.</translation>
    </message>
    <message>
        <source>The camera&apos;s axes are columns of R</source>
        <translation>Kaamera teljed on R-i veerud</translation>
    </message>
    <message>
        <source>This writes {0}, {1} and {2} into the columns of the rotation. That rotation places a camera. The view matrix needs its inverse, which is the transpose, so the axes are its rows.</source>
        <translation>Nii kirjutatakse {0}, {1} ja {2} pöörde veergudesse. Selline pööre paigutab kaamera. Vaatemaatriks vajab selle pöördmaatriksit, milleks on transponeeritud maatriks, nii et teljed on selle read.</translation>
    </message>
    <message>
        <source>The move stands in the last row</source>
        <translation>Nihe on viimases reas</translation>
    </message>
    <message>
        <source>This is a translation for row vectors. Here points are columns, {0}, so the move is the last column. In the last row its numbers would change {1}.</source>
        <translation>See on reavektorite nihe. Siin on punktid veerud, {0}, nii et nihe on viimane veerg. Viimases reas muudaksid selle arvud suurust {1}.</translation>
    </message>
    <message>
        <source>One factor is enough</source>
        <translation>Ühest tegurist piisab</translation>
    </message>
    <message>
        <source>This leaves a factor out. Each factor hands its points to the one on its left, and without it they arrive unchanged.</source>
        <translation>Nii jäetakse üks tegur välja. Iga tegur annab oma punktid edasi endast vasakul olevale tegurile ja ilma selleta jõuavad need sinna muutmata.</translation>
    </message>
    <message>
        <source>An inverse keeps the order</source>
        <translation>Pöördmaatriks säilitab järjekorra</translation>
    </message>
    <message>
        <source>This inverts each factor and keeps the order. An inverse undoes the last move first, so the order turns round: {0}.</source>
        <translation>Nii võetakse iga teguri pöördmaatriks ja säilitatakse järjekord. Pöördmaatriks võtab viimase teisenduse tagasi esimesena, nii et järjekord pöördub ümber: {0}.</translation>
    </message>
    <message>
        <source>The inverse leads there, too</source>
        <translation>Sinna viib ka pöördmaatriks</translation>
    </message>
    <message>
        <source>This is the inverse of the chain, which leads back: from the world to the object, or from the camera to the world. The inverse undoes what the chain does.</source>
        <translation>See on ahela pöördmaatriks, mis viib tagasi: maailmast objektini või kaamerast maailma. Pöördmaatriks võtab tagasi selle, mida ahel teeb.</translation>
    </message>
</context>
<context>
    <name>l01-camera-frame</name>
    <message>
        <source>The camera&apos;s own axes</source>
        <translation>Kaamera enda teljed</translation>
    </message>
    <message>
        <source>Which way does n point?</source>
        <translation>Kuhu näitab n?</translation>
    </message>
    <message>
        <source>A camera carries three unit vectors: {0} to its right, {1} upwards, and {2} along its line of sight. Lecture 001 puts the camera at {3} and lets it look along the world&apos;s {4} axis; the letter F stands 8 units ahead. **World** shows the eye {5}, the line of sight to the target {6}, and the up vector {7}. {8} is not there yet.</source>
        <translation>Kaameral on kolm ühikvektorit: {0} näitab paremale, {1} üles ja {2} on vaatekiire sihis. Loeng 001 paneb kaamera kohale {3} ja laseb sel vaadata piki maailma {4}-telge; F-täht on 8 ühikut eespool. **Maailm** näitab silma {5}, vaatekiirt sihtpunkti {6} ja ülesvektorit {7}. Vektorit {8} veel ei ole.</translation>
    </message>
    <message>
        <source>What is {0} of this camera?</source>
        <translation>Milline on selle kaamera {0}?</translation>
    </message>
    <message>
        <source>(1, 0, 0), the direction in which it looks</source>
        <translation>(1, 0, 0), suund, milles see vaatab</translation>
    </message>
    <message>
        <source>The camera looks along {0}: {1} runs from the target back to the eye. Look at its arrow: it points away from the F.</source>
        <translation>Kaamera vaatab suunas {0}: {1} on suunatud sihtpunktist tagasi silma. Vaadake selle noolt: see näitab F-ist eemale.</translation>
    </message>
    <message>
        <source>(-1, 0, 0), opposite to the direction in which it looks</source>
        <translation>(-1, 0, 0), vastupidine suunale, milles see vaatab</translation>
    </message>
    <message>
        <source>(0, 0, -1), as for every camera</source>
        <translation>(0, 0, -1), nagu igal kaameral</translation>
    </message>
    <message>
        <source>That is the direction in which it looks in its own coordinates, after the view matrix. In the world it looks along +x. Look at {0}: it lies along the world&apos;s x axis, not along z.</source>
        <translation>See on suund, milles see vaatab omaenda koordinaatides, pärast vaatemaatriksit. Maailmas vaatab see suunas +x. Vaadake vektorit {0}: see on piki maailma x-telge, mitte piki z-telge.</translation>
    </message>
    <message>
        <source>n runs from the target back to the eye. The camera looks along {0}.</source>
        <translation>n on suunatud sihtpunktist tagasi silma. Kaamera vaatab suunas {0}.</translation>
    </message>
    <message>
        <source>Eye, target, up: then u, v, n</source>
        <translation>Silm, siht, üles: siis u, v, n</translation>
    </message>
    <message>
        <source>The eye {0} is at {1}, the target {2} at the origin, and {3}.</source>
        <translation>Silm {0} on kohal {1}, sihtpunkt {2} alguspunktis ja {3}.</translation>
    </message>
    <message>
        <source>{0}; its length is 3, so {1}.</source>
        <translation>{0}; selle pikkus on 3, seega {1}.</translation>
    </message>
    <message>
        <source>{0}; its length is only 0.745, so it is divided too: {1}.</source>
        <translation>{0}; selle pikkus on ainult 0.745, nii et ka see jagatakse: {1}.</translation>
    </message>
    <message>
        <source>{0}; {1} and {2} are unit vectors at a right angle, so {3} needs no division.</source>
        <translation>{0}; {1} ja {2} on teineteisega risti olevad ühikvektorid, nii et {3} jagamist ei vaja.</translation>
    </message>
    <message>
        <source>In *Camera frame*, **Back** and **Next** build them one by one.</source>
        <translation>Paneelis *Kaamerafreim* ehitavad **Tagasi** ja **Edasi** need ükshaaval.</translation>
    </message>
    <message>
        <source>V is not v</source>
        <translation>V ei ole v</translation>
    </message>
    <message>
        <source>The up vector {0} only says roughly which way is up. Here it is {1}, and the camera looks slightly down.</source>
        <translation>Ülesvektor {0} ütleb ainult ligikaudu, kus on üles. Siin on see {1} ja kaamera vaatab veidi alla.</translation>
    </message>
    <message>
        <source>Turn {0} away from {1} until the angle between them is 30° or more.</source>
        <translation>Pöörake {0} vektorist {1} eemale, kuni nendevaheline nurk on 30° või rohkem.</translation>
    </message>
    <message>
        <source>v is always at a right angle to the line of sight. What tilts the line of sight?</source>
        <translation>v on alati vaatekiirega risti. Mis kallutab vaatekiirt?</translation>
    </message>
    <message>
        <source>Raise the eye: Elevation in the dock.</source>
        <translation>Tõstke silma: Tõusunurk külgribal.</translation>
    </message>
    <message>
        <source>Right: v has the direction of the part of V at a right angle to the line of sight. Only for a camera that looks level are the two the same.</source>
        <translation>Õige: v suund on see osa V-st, mis on vaatekiirega risti. Ainult horisontaalselt vaatava kaamera puhul on need kaks samad.</translation>
    </message>
    <message>
        <source>The length of a cross product</source>
        <translation>Vektorkorrutise pikkus</translation>
    </message>
    <message>
        <source>A cross product of two unit vectors has length 1 only if they are at a right angle to each other. {0} and {1} are seldom at a right angle.</source>
        <translation>Kahe ühikvektori vektorkorrutise pikkus on 1 ainult siis, kui need on teineteisega risti. {0} ja {1} on harva risti.</translation>
    </message>
    <message>
        <source>Eye (2, 3, 6), target at the origin, {0}. How large is {1}?</source>
        <translation>Silm (2, 3, 6), sihtpunkt alguspunktis, {0}. Kui suur on {1}?</translation>
    </message>
    <message>
        <source>This takes {0} itself for {1}. Look at the two arrows: {2} is at a right angle to {3}, and {4} is not.</source>
        <translation>Nii võetakse vektoriks {1} vektor {0} ise. Vaadake kaht noolt: {2} on vektoriga {3} risti, aga {4} mitte.</translation>
    </message>
    <message>
        <source>{0} is shorter than 1, because {1} and {2} are not at a right angle. Look at them, and divide by the length before the second product.</source>
        <translation>{0} on 1-st lühem, sest {1} ja {2} ei ole risti. Vaadake neid ja jagage pikkusega enne teist korrutist.</translation>
    </message>
    <message>
        <source>N = (2, 3, 6) is 7 long.</source>
        <translation>N = (2, 3, 6), pikkusega 7.</translation>
    </message>
    <message>
        <source>{0}. Its length is not 1.</source>
        <translation>{0}. Selle pikkus ei ole 1.</translation>
    </message>
    <message>
        <source>{0} is 0.904 long, so {1}, and {2}.</source>
        <translation>{0} pikkus on 0.904, seega {1} ja {2}.</translation>
    </message>
    <message>
        <source>The last column of the view matrix</source>
        <translation>Vaatemaatriksi viimane veerg</translation>
    </message>
    <message>
        <source>The view matrix first moves the eye to the origin, then rotates: {0}, where the rows of {1} are {2}, {3}, {4}. Its last column is therefore {5} times minus the eye.</source>
        <translation>Vaatemaatriks viib enne silma alguspunkti ja pöörab siis: {0}, kus maatriksi {1} read on {2}, {3}, {4}. Selle viimane veerg on seepärast {5} korda miinus silm.</translation>
    </message>
    <message>
        <source>The same camera: eye (2, 3, 6), target at the origin. Which number stands in row 3, column 4 of the view matrix?</source>
        <translation>Sama kaamera: silm (2, 3, 6), sihtpunkt alguspunktis. Milline arv on vaatemaatriksi reas 3 ja veerus 4?</translation>
    </message>
    <message>
        <source>This rotates first and then moves. The move acts first, so row {0} multiplies all its three numbers. Look at view space: the target, the world&apos;s origin, lies on the axis.</source>
        <translation>Nii pööratakse enne ja nihutatakse siis. Nihe mõjub esimesena, nii et rida {0} korrutab kõiki kolme selle arvu. Vaadake kaamerafreimi: sihtpunkt, maailma alguspunkt, on teljel.</translation>
    </message>
    <message>
        <source>This puts the camera in its place. The view matrix moves the world until the eye is at the origin. Look at view space: the eye is at the origin, and the target in front of it.</source>
        <translation>Nii pannakse kaamera oma kohale. Vaatemaatriks liigutab maailma, kuni silm on alguspunktis. Vaadake kaamerafreimi: silm on alguspunktis ja sihtpunkt selle ees.</translation>
    </message>
    <message>
        <source>This takes the direction of view for {0}. Look at view space: {1} points backwards, so the target, the world&apos;s origin, has a negative z.</source>
        <translation>Nii võetakse vektoriks {0} vaate suund. Vaadake kaamerafreimi: {1} näitab tahapoole, seega on sihtpunktil, mis on maailma alguspunkt, negatiivne z.</translation>
    </message>
    <message>
        <source>Row 3 is n. What does it make of the moved origin, {0}?</source>
        <translation>Rida 3 on n. Mis saab sellega nihutatud alguspunktist {0}?</translation>
    </message>
    <message>
        <source>{0}. The world&apos;s origin is 7 units in front of the camera, so its z there is {1}.</source>
        <translation>{0}. Maailma alguspunkt on kaamerast 7 ühikut eespool, seega on selle z seal {1}.</translation>
    </message>
    <message>
        <source>A camera for a given n</source>
        <translation>Kaamera antud n-i jaoks</translation>
    </message>
    <message>
        <source>Now the other way round: find the camera for a given axis.</source>
        <translation>Nüüd vastupidi: leidke kaamera antud telje jaoks.</translation>
    </message>
    <message>
        <source>Give the camera {0}.</source>
        <translation>Andke kaamerale {0}.</translation>
    </message>
    <message>
        <source>n has no height: the camera looks level.</source>
        <translation>n-il kõrguse komponenti ei ole: kaamera vaatab horisontaalselt.</translation>
    </message>
    <message>
        <source>From the target, go along n to the eye: 6 along x for every 8 along z. Then Elevation is 0 and Azimuth 36.87.</source>
        <translation>Minge sihtpunktist piki n-i silma: 6 piki x-telge iga 8 kohta piki z-telge. Siis on Tõusunurk 0 ja Asimuut 36.87.</translation>
    </message>
    <message>
        <source>Right: any eye on the ray from the target along n will do. The distance does not matter.</source>
        <translation>Õige: sobib iga silm kiirel sihtpunktist piki n-i. Kaugus ei loe.</translation>
    </message>
    <message>
        <source>Back to the camera at (4, 2, 0)</source>
        <translation>Tagasi kaamera juurde kohal (4, 2, 0)</translation>
    </message>
    <message>
        <source>It is tempting to take {0} as the direction in which the camera looks, {1}. But {2} to the right, {3} up and the third axis must make a right-handed system, so the third one comes out of the picture, towards the reader: {4}. Lecture 001 calls it {5} and writes {6}.</source>
        <translation>Ahvatlev on võtta vektoriks {0} suund, milles kaamera vaatab, {1}. Aga {2} paremale, {3} üles ja kolmas telg peavad moodustama paremakäelise süsteemi, nii et kolmas tuleb pildist välja, lugeja poole: {4}. Loeng 001 nimetab selle {5} ja kirjutab {6}.</translation>
    </message>
    <message>
        <source>That is why what is in front of a camera has a *negative* z in its coordinates: the F, 8 units ahead, is at {0}. In *Camera frame*, row 3 of the matrix begins with {1}.</source>
        <translation>Seepärast on sellel, mis on kaamera ees, kaamera koordinaatides *negatiivne* z: F, 8 ühikut eespool, on kohal {0}. Paneelis *Kaamerafreim* on maatriksi rea 3 alguses {1}.</translation>
    </message>
    <message>
        <source>Practise: how upright is v?</source>
        <translation>Harjutus: kui püsti on v?</translation>
    </message>
    <message>
        <source>Eye {0} and target {1} are new each time; {2}.</source>
        <translation>Silm {0} ja sihtpunkt {1} on iga kord uued; {2}.</translation>
    </message>
    <message>
        <source>The eye is at {0}, the target at {1}. How large is {2}?</source>
        <translation>Silm on kohal {0}, sihtpunkt kohal {1}. Kui suur on {2}?</translation>
    </message>
    <message>
        <source>{0}, divided by its length, is {1}.</source>
        <translation>{0}, jagatuna oma pikkusega, on {1}.</translation>
    </message>
    <message>
        <source>{0} is shorter than 1. Divide it by its length before you form {1}.</source>
        <translation>{0} on 1-st lühem. Jagage see oma pikkusega, enne kui moodustate {1}.</translation>
    </message>
    <message>
        <source>{0} is {1} long, {2} only {3}.</source>
        <translation>{0} pikkus on {1}, {2} pikkus ainult {3}.</translation>
    </message>
    <message>
        <source>Practise: a row of the view matrix</source>
        <translation>Harjutus: vaatemaatriksi rida</translation>
    </message>
    <message>
        <source>The view matrix is {0}: {1} moves the eye {2} to the origin, and the rows of {3} are {4}, {5}, {6}.</source>
        <translation>Vaatemaatriks on {0}: {1} viib silma {2} alguspunkti ja maatriksi {3} read on {4}, {5}, {6}.</translation>
    </message>
    <message>
        <source>The eye is at {0}, the target at {1}. Which four numbers are in row 3 of the view matrix?</source>
        <translation>Silm on kohal {0}, sihtpunkt kohal {1}. Millised neli arvu on vaatemaatriksi reas 3?</translation>
    </message>
    <message>
        <source>This rotates first and then moves. The move acts first, so {0} multiplies all three numbers of {1}. Look at view space: the eye is at the origin.</source>
        <translation>Nii pööratakse enne ja nihutatakse siis. Nihe mõjub esimesena, nii et {0} korrutab vektori {1} kõiki kolme arvu. Vaadake kaamerafreimi: silm on alguspunktis.</translation>
    </message>
    <message>
        <source>This puts the camera in its place. The view matrix moves the world until the eye is at the origin. Look at view space: the eye is there, and the target in front of it.</source>
        <translation>Nii pannakse kaamera oma kohale. Vaatemaatriks liigutab maailma, kuni silm on alguspunktis. Vaadake kaamerafreimi: silm on seal ja sihtpunkt selle ees.</translation>
    </message>
    <message>
        <source>This takes the direction of view for {0}. Look at view space: {1} points backwards, away from the target.</source>
        <translation>Nii võetakse vektoriks {0} vaate suund. Vaadake kaamerafreimi: {1} näitab tahapoole, sihtpunktist eemale.</translation>
    </message>
    <message>
        <source>{0} is {1} long.</source>
        <translation>{0} pikkus on {1}.</translation>
    </message>
    <message>
        <source>Row 3 of {0} is {1}. What does it make of the moved origin, {2}?</source>
        <translation>Maatriksi {0} rida 3 on {1}. Mis saab sellega nihutatud alguspunktist {2}?</translation>
    </message>
    <message>
        <source>{0} is {1} long. Row 3 begins with {2} and ends with {3}.</source>
        <translation>{0} pikkus on {1}. Rea 3 alguses on {2} ja lõpus {3}.</translation>
    </message>
    <message>
        <source>Practise: a camera for a given n</source>
        <translation>Harjutus: kaamera antud n-i jaoks</translation>
    </message>
    <message>
        <source>Use *Azimuth* and *Elevation* in the dock, drag the eye in **World**, or type its coordinates.</source>
        <translation>Kasutage külgriba sätteid *Asimuut* ja *Tõusunurk*, lohistage silma paanis **Maailm** või sisestage selle koordinaadid.</translation>
    </message>
    <message>
        <source>Give the camera an {0} in the direction of {1}.</source>
        <translation>Andke kaamerale selline {0}, mille suund on {1}.</translation>
    </message>
    <message>
        <source>{0} runs from the target to the eye.</source>
        <translation>{0} on suunatud sihtpunktist silma.</translation>
    </message>
    <message>
        <source>The tangent of the azimuth is {0}. The tangent of the elevation is {1}, divided by the length of {2}.</source>
        <translation>Asimuudi tangens on {0}. Tõusunurga tangens on {1}, jagatud vektori {2} pikkusega.</translation>
    </message>
    <message>
        <source>The eye is on the ray from the target along {0}: {1}. The distance does not matter.</source>
        <translation>Silm on kiirel sihtpunktist suunas {0}: {1}. Kaugus ei loe.</translation>
    </message>
    <message>
        <source>Your camera looks in the direction of {0}. Look at its {1}: it points the other way, from the target to the eye.</source>
        <translation>Teie kaamera vaatab suunas {0}. Vaadake selle vektorit {1}: see näitab teisele poole, sihtpunktist silma.</translation>
    </message>
    <message>
        <source>Practise: build the view matrix</source>
        <translation>Harjutus: pange vaatemaatriks kokku</translation>
    </message>
    <message>
        <source>Put the tiles in order, and leave out what does not belong.</source>
        <translation>Seadke lülid järjekorda ja jätke välja see, mis sinna ei kuulu.</translation>
    </message>
    <message>
        <source>The eye is at {0}. The rows of {1} are {2}, {3}, {4}, and {5} moves by {6}. Which product is the view matrix?</source>
        <translation>Silm on kohal {0}. Maatriksi {1} read on {2}, {3}, {4} ja {5} nihutab vektori {6} võrra. Milline korrutis on vaatemaatriks?</translation>
    </message>
    <message>
        <source>{0} moves the eye to the origin, and {1} rotates about it. {2} moves the wrong way.</source>
        <translation>{0} viib silma alguspunkti ja {1} pöörab selle ümber. {2} nihutab vales suunas.</translation>
    </message>
    <message>
        <source>A camera at the origin looks along {0}. It was turned about y by {1}°, then moved by {2}. Which product is its view matrix?</source>
        <translation>Alguspunktis olev kaamera vaatab suunas {0}. Seda pöörati ümber y-telje {1}° ja nihutati siis vektori {2} võrra. Milline korrutis on selle vaatemaatriks?</translation>
    </message>
    <message>
        <source>A camera was tilted about x by {0}°, turned about y by {1}°, and moved by {2}. Which product is its view matrix?</source>
        <translation>Kaamerat kallutati ümber x-telje {0}°, pöörati ümber y-telje {1}° ja nihutati vektori {2} võrra. Milline korrutis on selle vaatemaatriks?</translation>
    </message>
    <message>
        <source>Where is the eye after the view matrix?</source>
        <translation>Kus on silm pärast vaatemaatriksit?</translation>
    </message>
    <message>
        <source>At the origin, so the factor that moves acts first. {0} moves by {1}.</source>
        <translation>Alguspunktis, seega mõjub nihutav tegur esimesena. {0} nihutab vektori {1} võrra.</translation>
    </message>
    <message>
        <source>The view matrix undoes both, the last one first.</source>
        <translation>Vaatemaatriks võtab mõlemad tagasi, viimase esimesena.</translation>
    </message>
    <message>
        <source>The camera was placed by {0}. Its inverse is {1}: the move is undone first.</source>
        <translation>Kaamera paigutati korrutisega {0}. Selle pöördmaatriks on {1}: nihe võetakse tagasi esimesena.</translation>
    </message>
    <message>
        <source>The camera was placed by {0}. What is undone first?</source>
        <translation>Kaamera paigutati korrutisega {0}. Mis võetakse tagasi esimesena?</translation>
    </message>
    <message>
        <source>The move, then the turn, then the tilt.</source>
        <translation>Nihe, siis pööre, siis kalle.</translation>
    </message>
    <message>
        <source>{0}: an inverse turns the order round.</source>
        <translation>{0}: pöördmaatriks pöörab järjekorra ümber.</translation>
    </message>
</context>
<context>
    <name>l02-columns</name>
    <message>
        <source>First rotate, then move</source>
        <translation>Enne pööre, siis nihe</translation>
    </message>
    <message>
        <source>An object has coordinates of its own; {0} takes them to the world. Here {1}: the object is turned by 90° about z, then moved by 3 along x. With column vectors the matrix on the right acts first. In **World** the letter F still stands where it was made.</source>
        <translation>Objektil on omad koordinaadid; {0} viib need maailma. Siin {1}: objekti pööratakse 90° ümber z-telje ja nihutatakse siis 3 võrra piki x-telge. Veeruvektorite puhul mõjub esimesena parempoolne maatriks. Paanis **Maailm** on F-täht veel seal, kus see tehti.</translation>
    </message>
    <message>
        <source>The object&apos;s point (1, 0, 0): how high above the ground, in y, does it end up in the world?</source>
        <translation>Kui kõrgele maapinnast, y-sihis, satub objekti punkt (1, 0, 0) maailmas?</translation>
    </message>
    <message>
        <source>This moves first and then turns, which turns the move as well. Look at point 1: the object&apos;s point would come there, 4 high.</source>
        <translation>Nii nihutatakse enne ja pööratakse siis, mis pöörab ka nihet. Vaadake punkti 1: objekti punkt satuks sinna, kõrgusele 4.</translation>
    </message>
    <message>
        <source>The move alone keeps it on the ground, but the turn by 90° takes x to y. Look at point 1: it is where the move alone takes the point, on the ground.</source>
        <translation>Nihe üksi jätab selle maapinnale, aga 90° pööre viib x-i y-iks. Vaadake punkti 1: see on seal, kuhu nihe üksi punkti viib, maapinnal.</translation>
    </message>
    <message>
        <source>The turn takes (1, 0, 0) to (0, 1, 0), and then the move takes that to (3, 1, 0): probe 1 in World.</source>
        <translation>Pööre viib punkti (1, 0, 0) punktiks (0, 1, 0) ja siis viib nihe selle punktiks (3, 1, 0): sond 1 paanis Maailm.</translation>
    </message>
    <message>
        <source>Read the matrix by columns</source>
        <translation>Lugege maatriksit veergude kaupa</translation>
    </message>
    <message>
        <source>In *Matrices*, world ← object holds the turn and the move:</source>
        <translation>Paneelis *Maatriksid* sisaldab maailm ← objekt pööret ja nihet:</translation>
    </message>
    <message>
        <source>x axis</source>
        <translation>x-telg</translation>
    </message>
    <message>
        <source>y axis</source>
        <translation>y-telg</translation>
    </message>
    <message>
        <source>z axis</source>
        <translation>z-telg</translation>
    </message>
    <message>
        <source>origin</source>
        <translation>alguspunkt</translation>
    </message>
    <message>
        <source>Column 1 says where the object&apos;s x axis points in the world: {0}, up. Column 2 is its y axis, column 3 its z axis, and column 4 is the position of its origin. So the point {1} lies at column 4 plus column 1: {2}. Point at a column with the mouse to highlight its axis in **World**.</source>
        <translation>Veerg 1 ütleb, kuhu objekti x-telg maailmas näitab: {0}, üles. Veerg 2 on selle y-telg, veerg 3 z-telg ja veerg 4 alguspunkti asukoht. Seega on punkt {1} kohal, mis on veerg 4 pluss veerg 1: {2}. Osutage veerule hiirega, et selle telg paanis **Maailm** esile tõsta.</translation>
    </message>
    <message>
        <source>Exchange the two tiles in *Chain*, in the dock, and play the strip again. How does the letter reach its place now?</source>
        <translation>Vahetage külgribal jaotises *Ahel* kaks lüli omavahel ja laske ribal uuesti joosta. Kuidas jõuab täht nüüd oma kohale?</translation>
    </message>
    <message>
        <source>A point through T and R</source>
        <translation>Punkt läbi T ja R</translation>
    </message>
    <message>
        <source>The letter is turned by 30° about z and then moved by 4 along x: {0}.</source>
        <translation>Tähte pööratakse 30° ümber z-telje ja nihutatakse siis 4 võrra piki x-telge: {0}.</translation>
    </message>
    <message>
        <source>What is x of the object&apos;s point (2, 1, 0) in the world?</source>
        <translation>Kui suur on objekti punkti (2, 1, 0) x maailmas?</translation>
    </message>
    <message>
        <source>This moves first and then turns, which turns the move as well. Look at point 1: it is where the object&apos;s point would come then.</source>
        <translation>Nii nihutatakse enne ja pööratakse siis, mis pöörab ka nihet. Vaadake punkti 1: see on seal, kuhu objekti punkt siis satuks.</translation>
    </message>
    <message>
        <source>This reads rows for columns, as if the letter were turned by −30°. Look at point 1: it is where the object&apos;s point would come then.</source>
        <translation>Nii loetakse veergude asemel ridu, nagu oleks tähte pööratud −30°. Vaadake punkti 1: see on seal, kuhu objekti punkt siis satuks.</translation>
    </message>
    <message>
        <source>2 times column 1, plus 1 times column 2, plus column 4.</source>
        <translation>2 korda veerg 1, pluss 1 kord veerg 2, pluss veerg 4.</translation>
    </message>
    <message>
        <source>cos 30° = 0.866, sin 30° = 0.5</source>
        <translation>cos 30° = 0.866, sin 30° = 0.5</translation>
    </message>
    <message>
        <source>Where must it move?</source>
        <translation>Kuhu see nihkuma peab?</translation>
    </message>
    <message>
        <source>The letter is turned by 90° about z. Probe 1 in **World** is at {0}.</source>
        <translation>Tähte on pööratud 90° ümber z-telje. Sond 1 paanis **Maailm** on kohal {0}.</translation>
    </message>
    <message>
        <source>Keep the turn, and move the object so that its point (1, 0, 0) comes to probe 1.</source>
        <translation>Jätke pööre samaks ja nihutage objekti nii, et selle punkt (1, 0, 0) langeb kokku sondiga 1.</translation>
    </message>
    <message>
        <source>Where is the point now, when it is turned but not moved?</source>
        <translation>Kus on see punkt praegu, kui seda on pööratud, aga mitte nihutatud?</translation>
    </message>
    <message>
        <source>It is at (0, 1, 0), and it must go to (2, 3, 0).</source>
        <translation>See on kohal (0, 1, 0) ja peab minema kohta (2, 3, 0).</translation>
    </message>
    <message>
        <source>Right: column 1 plus column 4 is (2, 3, 0).</source>
        <translation>Õige: veerg 1 pluss veerg 4 on (2, 3, 0).</translation>
    </message>
    <message>
        <source>Back to the prediction</source>
        <translation>Tagasi ennustuse juurde</translation>
    </message>
    <message>
        <source>It is tempting to move first, from {0} to {1}, and then to rotate. But a rotation about the world&apos;s origin rotates the move as well: {2} goes to {3}, where probe 1 is. That is {4}, which this step shows: in *Chain* the rotation stands above the move, so it acts last.</source>
        <translation>Ahvatlev on enne nihutada, punktist {0} punkti {1}, ja siis pöörata. Aga pööre ümber maailma alguspunkti pöörab ka nihet: {2} läheb punktiks {3}, kus on sond 1. See on {4}, mida näitab see samm: jaotises *Ahel* on pööre nihkest ülalpool, nii et see mõjub viimasena.</translation>
    </message>
    <message>
        <source>The letter is turned about z by {0} and not moved yet. Its move is in *Chain*, in the dock.</source>
        <translation>Tähte on pööratud ümber z-telje nurga {0} võrra ja seda pole veel nihutatud. Selle nihe on külgribal jaotises *Ahel*.</translation>
    </message>
    <message>
        <source>The letter was turned about z by {0}° and then moved by {1} along x. Which product did that?</source>
        <translation>Tähte pöörati ümber z-telje {0}° ja nihutati siis {1} võrra piki x-telge. Milline korrutis seda tegi?</translation>
    </message>
    <message>
        <source>The letter was made {0} times as wide, turned about z by {1}°, and moved by {2} along x. It kept its right angles. Which product did that?</source>
        <translation>Täht tehti {0} korda laiemaks, seda pöörati ümber z-telje {1}° ja nihutati {2} võrra piki x-telge. Selle täisnurgad jäid alles. Milline korrutis seda tegi?</translation>
    </message>
    <message>
        <source>Object, world, camera</source>
        <translation>Objekt, maailm, kaamera</translation>
    </message>
    <message>
        <source>Each factor is a place</source>
        <translation>Iga tegur on koht</translation>
    </message>
    <message>
        <source>The strip below the cube has a stop for each move: *Object*, *Rz* and *World*. At *Rz* the letter is turned and not yet moved; its other places are pale beside it. Play the strip from its beginning.</source>
        <translation>Kuubi all oleval ribal on peatus iga teisenduse jaoks: *Objekt*, *Rz* ja *Maailm*. Peatuses *Rz* on tähte pööratud, aga veel mitte nihutatud; selle teised kohad on kahvatult kõrval. Laske ribal algusest peale joosta.</translation>
    </message>
    <message>
        <source>The arrow beside *Play* reads the product the other way. **←** does the moves from right to left, each in the axes of the world. **→** does them from left to right, each in the axes that the moves before have moved: the letter goes 3 along x and is then turned about its own origin. Both ways end in the same place.</source>
        <translation>Nupu *Esita* kõrval olev nool loeb korrutist teistpidi. **←** teeb teisendused paremalt vasakule, igaühe maailma telgedes. **→** teeb need vasakult paremale, igaühe telgedes, mida eelmised teisendused on liigutanud: täht läheb 3 võrra piki x-telge ja pöördub siis ümber omaenda alguspunkti. Mõlemal viisil jõuab see samasse kohta.</translation>
    </message>
    <message>
        <source>Drag a tile by the grip at its left, or press the arrow keys there.</source>
        <translation>Lohistage lüli selle vasakus servas olevast pidemest või vajutage seal nooleklahve.</translation>
    </message>
    <message>
        <source>Now the move is turned as well: the letter swings about the world&apos;s origin, from {0} to {1}.</source>
        <translation>Nüüd pööratakse ka nihet: täht läheb kaarega ümber maailma alguspunkti, punktist {0} punkti {1}.</translation>
    </message>
    <message>
        <source>{0} has the turn on the left, so it acts last, about the world&apos;s origin.</source>
        <translation>Korrutises {0} on pööre vasakul, nii et see mõjub viimasena, ümber maailma alguspunkti.</translation>
    </message>
    <message>
        <source>From the world to the camera</source>
        <translation>Maailmast kaamerani</translation>
    </message>
    <message>
        <source>The camera has axes of its own, and {0} takes the world to them. It undoes how the camera was placed. For a point {1} of the letter both matrices are multiplied:</source>
        <translation>Kaameral on omad teljed ja {0} viib maailma nendesse. See võtab kaamera paigutamise tagasi. Tähe punkti {1} jaoks korrutatakse mõlemad maatriksid:</translation>
    </message>
    <message>
        <source>Which chain takes a point of the letter to the camera&apos;s axes?</source>
        <translation>Milline ahel viib tähe punkti kaamera teljestikku?</translation>
    </message>
    <message>
        <source>In which space does the point have its coordinates at first?</source>
        <translation>Millises ruumis on punkti koordinaadid alguses?</translation>
    </message>
    <message>
        <source>The point starts in the letter&apos;s own space. The turn and the move take it to the world, and the view matrix takes it from there to the camera.</source>
        <translation>Punkt alustab tähe enda ruumist. Pööre ja nihe viivad selle maailma ja vaatemaatriks viib selle sealt kaamerani.</translation>
    </message>
    <message>
        <source>With {0} the letter is rotated in its place and then moved, and column 4 is the move as you typed it. With {1} column 4 is the move after the rotation, {2}.</source>
        <translation>Korrutisega {0} pööratakse tähte paigal ja nihutatakse siis ning veerg 4 on nihe nii, nagu te selle sisestasite. Korrutisega {1} on veerg 4 nihe pärast pööret, {2}.</translation>
    </message>
    <message>
        <source>Practise: the matrix of a turn</source>
        <translation>Harjutus: pöörde maatriks</translation>
    </message>
    <message>
        <source>The letter is turned about z by an angle {0}. Seen from the tip of z, a positive angle turns it anticlockwise.</source>
        <translation>Tähte pööratakse ümber z-telje nurga {0} võrra. z-telje otsast vaadates pöörab positiivne nurk seda vastupäeva.</translation>
    </message>
    <message>
        <source>Here {0}. Which numbers are in rows 1 and 2, columns 1 and 2 of {1}?</source>
        <translation>Siin {0}. Millised arvud on maatriksi {1} ridades 1 ja 2, veergudes 1 ja 2?</translation>
    </message>
    <message>
        <source>This has rows and columns exchanged, which turns the letter the other way. Look at its own axes: they are turned by {0}°.</source>
        <translation>Siin on read ja veerud vahetuses, mis pöörab tähte teistpidi. Vaadake selle enda telgi: neid on pööratud {0}°.</translation>
    </message>
    <message>
        <source>My degrees are radians</source>
        <translation>Minu kraadid on radiaanid</translation>
    </message>
    <message>
        <source>This takes {0}° for {1} radians. Look at the letter, turned by that many radians.</source>
        <translation>Nii võetakse {0}° asemel {1} radiaani. Vaadake tähte, mida on pööratud nii palju radiaane.</translation>
    </message>
    <message>
        <source>Column 1 is the x axis of the turned letter, column 2 its y axis.</source>
        <translation>Veerg 1 on pööratud tähe x-telg, veerg 2 selle y-telg.</translation>
    </message>
    <message>
        <source>Column 1 is where the x axis points after the turn, column 2 where the y axis points.</source>
        <translation>Veerg 1 on see, kuhu x-telg pärast pööret näitab, veerg 2 see, kuhu näitab y-telg.</translation>
    </message>
    <message>
        <source>Practise: turn, then move</source>
        <translation>Harjutus: pööre, siis nihe</translation>
    </message>
    <message>
        <source>The letter is turned about z by {0}, then moved along x: {1}. Point 1 is where a point of the letter&apos;s own space comes to.</source>
        <translation>Tähte pööratakse ümber z-telje nurga {0} võrra ja nihutatakse siis piki x-telge: {1}. Punkt 1 on seal, kuhu satub tähe enda ruumi punkt.</translation>
    </message>
    <message>
        <source>Here {0}, and the move is {1} along x. What is x of the object&apos;s point {2} in the world?</source>
        <translation>Siin {0} ja nihe on {1} piki x-telge. Kui suur on objekti punkti {2} x maailmas?</translation>
    </message>
    <message>
        <source>This reads rows for columns, as if the letter were turned by {0}°. Look at point 1: it is where the object&apos;s point would come then.</source>
        <translation>Nii loetakse veergude asemel ridu, nagu oleks tähte pööratud {0}°. Vaadake punkti 1: see on seal, kuhu objekti punkt siis satuks.</translation>
    </message>
    <message>
        <source>{0} times column 1, plus {1} times column 2, plus column 4.</source>
        <translation>{0} korda veerg 1, pluss {1} korda veerg 2, pluss veerg 4.</translation>
    </message>
    <message>
        <source>The x of column 1 is {0}, and the x of column 2 is {1}.</source>
        <translation>Veeru 1 x on {0} ja veeru 2 x on {1}.</translation>
    </message>
    <message>
        <source>First the turn, then the move.</source>
        <translation>Enne pööre, siis nihe.</translation>
    </message>
    <message>
        <source>Practise: bring a point to its place</source>
        <translation>Harjutus: viige punkt oma kohale</translation>
    </message>
    <message>
        <source>Keep the turn of {0}°, and move the letter so that its point {1} comes to probe 1, at {2}.</source>
        <translation>Jätke pööre {0}° samaks ja nihutage tähte nii, et selle punkt {1} langeb kokku sondiga 1, mis on kohal {2}.</translation>
    </message>
    <message>
        <source>Where does the turn alone take {0}?</source>
        <translation>Kuhu viib pööre üksi punkti {0}?</translation>
    </message>
    <message>
        <source>To {0}. The move adds to that.</source>
        <translation>Punktiks {0}. Nihe liidetakse sellele.</translation>
    </message>
    <message>
        <source>Column 1 plus column 4 is {0}: {1} {2} and {3} {4}.</source>
        <translation>Veerg 1 pluss veerg 4 on {0}: {1} {2} ja {3} {4}.</translation>
    </message>
    <message>
        <source>This move is right if it acts before the turn. Look at the letter with the order R T S: only there does it bring the point to probe 1.</source>
        <translation>See nihe on õige, kui see mõjub enne pööret. Vaadake tähte järjekorraga R T S: ainult seal viib see punkti kokku sondiga 1.</translation>
    </message>
    <message>
        <source>Practise: build the chain</source>
        <translation>Harjutus: pange ahel kokku</translation>
    </message>
    <message>
        <source>Put the tiles in order, and leave out what does not belong.</source>
        <translation>Seadke lülid järjekorda ja jätke välja see, mis sinna ei kuulu.</translation>
    </message>
    <message>
        <source>Which of the two acts first? It stands at the bottom.</source>
        <translation>Kumb neist mõjub esimesena? See on all.</translation>
    </message>
    <message>
        <source>{0}: the factor on the right acts first.</source>
        <translation>{0}: parempoolne tegur mõjub esimesena.</translation>
    </message>
    <message>
        <source>A scale after the turn would bend the right angles.</source>
        <translation>Skaleerimine pärast pööret muudaks täisnurgad viltuseks.</translation>
    </message>
    <message>
        <source>A scale after the move would multiply the move.</source>
        <translation>Skaleerimine pärast nihet korrutaks ka nihke.</translation>
    </message>
    <message>
        <source>{0}: first the scale, along the letter&apos;s own axes, then the turn about its own origin, and the move last.</source>
        <translation>{0}: enne skaleerimine piki tähe enda telgi, siis pööre ümber selle enda alguspunkti ja viimasena nihe.</translation>
    </message>
    <message>
        <source>Give the tiles their numbers, and arrange them. Columns 1 and 4 of their product {0} must be {1} and {2}.</source>
        <translation>Andke lülidele arvud ja seadke need järjekorda. Nende korrutise {0} 1. ja 4. veerg peavad olema {1} ja {2}.</translation>
    </message>
    <message>
        <source>Column 4 is the move, if the move acts last.</source>
        <translation>Veerg 4 on nihe, kui nihe mõjub viimasena.</translation>
    </message>
    <message>
        <source>Column 1 is {0}.</source>
        <translation>Veerg 1 on {0}.</translation>
    </message>
    <message>
        <source>Column 4 of {0} is the move itself, and columns 1 to 3 are those of the rotation.</source>
        <translation>Korrutise {0} veerg 4 on nihe ise ning veerud 1 kuni 3 on pöörde omad.</translation>
    </message>
</context>
<context>
    <name>l03-field-of-view</name>
    <message>
        <source>Which angle is the field of view?</source>
        <translation>Milline nurk on frustumi nurk?</translation>
    </message>
    <message>
        <source>How wide is 60 degrees?</source>
        <translation>Kui lai on 60 kraadi?</translation>
    </message>
    <message>
        <source>The number in *Field of view* is the vertical angle, from the bottom of the picture to its top. The picture is 16 wide and 9 high. **World**, seen from *Above*, shows half of the horizontal angle at the eye: {0}.</source>
        <translation>Väljal *Frustumi nurk* olev arv on vertikaalne nurk, pildi alumisest servast ülemiseni. Pildi laius on 16 ja kõrgus 9. **Maailm**, vaadatuna *Ülalt*, näitab silma juures poolt horisontaalsest nurgast: {0}.</translation>
    </message>
    <message>
        <source>The vertical angle is set to 60°. How large is the horizontal one?</source>
        <translation>Vertikaalseks nurgaks seatakse 60°. Kui suur on horisontaalne?</translation>
    </message>
    <message>
        <source>Widths are proportional to the tangent of half the angle. Look at 120° upwards: 16/9 times that would be 213°, more than half a turn; {0} is 72.0°.</source>
        <translation>Laiused on võrdelised poole nurga tangensiga. Vaadake 120° püstsihis: 16/9 korda see oleks 213°, rohkem kui pool pööret; {0} on 72.0°.</translation>
    </message>
    <message>
        <source>This takes the vertical angle for the horizontal one. Look at this square picture: only here both are 60°, and {0} is 30°.</source>
        <translation>Nii võetakse horisontaalse nurga asemel vertikaalne. Vaadake seda ruudukujulist pilti: ainult siin on mõlemad 60° ja {0} on 30°.</translation>
    </message>
    <message>
        <source>The sides of the picture are in the ratio 16 to 9, and so are the tangents of the half angles: {0}.</source>
        <translation>Pildi küljed on suhtes 16 ja 9, ning sama suhe on poolte nurkade tangensitel: {0}.</translation>
    </message>
    <message>
        <source>From one angle to the other</source>
        <translation>Ühest nurgast teiseni</translation>
    </message>
    <message>
        <source>Lecture 003 has {0} for the horizontal angle, {1} for the vertical one, and {2} for the proportions, here {3}. At the distance {4} from the eye the picture reaches from {5} to {6}, and from {7} to {8}. So</source>
        <translation>Loengus 003 on horisontaalne nurk {0}, vertikaalne {1} ja proportsioonid {2}, siin {3}. Kaugusel {4} silmast ulatub pilt kohast {5} kohani {6} ja kohast {7} kohani {8}. Järelikult</translation>
    </message>
    <message>
        <source>With {0}: {1}, so {2} and {3}. The side of the near plane&apos;s window is {4} in x and {5} in y. In the dock, *More of the lens* has **Horizontal fov** and **Focal length e**.</source>
        <translation>Kui {0}: {1}, seega {2} ja {3}. Lähitasandi akna külg on x-sihis {4} ja y-sihis {5}. Külgriba jaotises *Veel objektiivist* on **Horisontaalne FOV** ja **Fookuskaugus e**.</translation>
    </message>
    <message>
        <source>A right angle</source>
        <translation>Täisnurk</translation>
    </message>
    <message>
        <source>The picture is still 16 by 9.</source>
        <translation>Pilt on endiselt 16 korda 9.</translation>
    </message>
    <message>
        <source>Make the horizontal angle 90°.</source>
        <translation>Tehke horisontaalseks nurgaks 90°.</translation>
    </message>
    <message>
        <source>At 90° the half angle is 45°, and its tangent is 1.</source>
        <translation>90° korral on pool nurka 45° ja selle tangens on 1.</translation>
    </message>
    <message>
        <source>Then e is 1, and the vertical half angle has the tangent a = 9/16.</source>
        <translation>Siis on e 1 ja vertikaalse poolnurga tangens on a = 9/16.</translation>
    </message>
    <message>
        <source>Right: e is 1, and the vertical angle is 58.7°, if the picture is 16 by 9.</source>
        <translation>Õige: e on 1 ja vertikaalne nurk on 58.7°, kui pilt on 16 korda 9.</translation>
    </message>
    <message>
        <source>A picture twice as wide as high</source>
        <translation>Pilt, mille laius on kahekordne kõrgus</translation>
    </message>
    <message>
        <source>Now the picture is 1000 by 500 pixels, and the vertical angle is 40°.</source>
        <translation>Nüüd on pilt 1000 korda 500 pikslit ja vertikaalne nurk on 40°.</translation>
    </message>
    <message>
        <source>How large is the horizontal angle?</source>
        <translation>Kui suur on horisontaalne nurk?</translation>
    </message>
    <message>
        <source>Widths are proportional to the tangent of half the angle. Look from above at 100° upwards: twice that would be 200°, more than half a turn; {0} is 67.2°.</source>
        <translation>Laiused on võrdelised poole nurga tangensiga. Vaadake ülalt 100° püstsihis: kaks korda see oleks 200°, rohkem kui pool pööret; {0} on 67.2°.</translation>
    </message>
    <message>
        <source>This takes the vertical angle for the horizontal one. Look from above at a square picture: only here both are 40°, and {0} is 20°.</source>
        <translation>Nii võetakse horisontaalse nurga asemel vertikaalne. Vaadake ülalt ruudukujulist pilti: ainult siin on mõlemad 40° ja {0} on 20°.</translation>
    </message>
    <message>
        <source>Take the tangent of half the vertical angle.</source>
        <translation>Võtke poole vertikaalse nurga tangens.</translation>
    </message>
    <message>
        <source>tan 20° = 0.364. What is twice that the tangent of?</source>
        <translation>tan 20° = 0.364. Mille tangens on sellest kaks korda suurem?</translation>
    </message>
    <message>
        <source>tan(α/2) = 2·tan 20° = 0.728, so α/2 = 36.05° and α = 72.1°.</source>
        <translation>tan(α/2) = 2·tan 20° = 0.728, seega α/2 = 36.05° ja α = 72.1°.</translation>
    </message>
    <message>
        <source>The focal length e</source>
        <translation>Fookuskaugus e</translation>
    </message>
    <message>
        <source>Here the picture is square, so both angles are 50°.</source>
        <translation>Siin on pilt ruudukujuline, nii et mõlemad nurgad on 50°.</translation>
    </message>
    <message>
        <source>How large is {0} for {1}?</source>
        <translation>Kui suur on {0}, kui {1}?</translation>
    </message>
    <message>
        <source>The triangle of eye, axis and edge has half of the angle at the eye. Look at {0}: the edge is as far from the axis as from the eye, so {1}; {2} would be 0.</source>
        <translation>Silma, telje ja serva kolmnurgas on silma juures pool nurka. Vaadake juhtu {0}: serv on teljest sama kaugel kui silmast, seega {1}; {2} oleks 0.</translation>
    </message>
    <message>
        <source>The cotangent takes my 25</source>
        <translation>Kootangensile kõlbab minu 25</translation>
    </message>
    <message>
        <source>This is the cotangent of 25 radians, almost four turns. Look at the angle: 25° is 0.436 radians.</source>
        <translation>See on 25 radiaani kootangens, peaaegu neli pööret. Vaadake nurka: 25° on 0.436 radiaani.</translation>
    </message>
    <message>
        <source>In the triangle between eye, axis and the picture&apos;s edge, the angle at the eye is α/2.</source>
        <translation>Silma, telje ja pildi serva vahelises kolmnurgas on nurk silma juures α/2.</translation>
    </message>
    <message>
        <source>e = cot 25° = 2.145. The wider the angle, the smaller e.</source>
        <translation>e = cot 25° = 2.145. Mida laiem nurk, seda väiksem e.</translation>
    </message>
    <message>
        <source>A wide picture on purpose</source>
        <translation>Meelega lai pilt</translation>
    </message>
    <message>
        <source>The picture is 1000 by 500 again.</source>
        <translation>Pilt on jälle 1000 korda 500.</translation>
    </message>
    <message>
        <source>Keep the picture twice as wide as high, and make the horizontal angle 100°.</source>
        <translation>Jätke pildi laiuseks kahekordne kõrgus ja tehke horisontaalseks nurgaks 100°.</translation>
    </message>
    <message>
        <source>Half of 100° has the tangent 1.192.</source>
        <translation>Poole 100° tangens on 1.192.</translation>
    </message>
    <message>
        <source>The vertical half angle has half that tangent.</source>
        <translation>Vertikaalse poolnurga tangens on sellest pool.</translation>
    </message>
    <message>
        <source>Right: tan(β/2) = 1.192/2, so the vertical angle is 61.6°, not 50°.</source>
        <translation>Õige: tan(β/2) = 1.192/2, seega on vertikaalne nurk 61.6°, mitte 50°.</translation>
    </message>
    <message>
        <source>Back to the prediction</source>
        <translation>Tagasi ennustuse juurde</translation>
    </message>
    <message>
        <source>It is tempting to multiply the angle by 16/9, like the width: {0}. That would be right if the picture were bent round the eye. But the picture is flat: the tangent of the half angle grows evenly, and far from the axis a degree takes more and more of the picture.</source>
        <translation>Ahvatlev on korrutada nurk 16/9-ga nagu laius: {0}. See oleks õige, kui pilt oleks ümber silma painutatud. Aga pilt on tasane: ühtlaselt kasvab poole nurga tangens ja teljest kaugel võtab üks kraad pildist aina suurema osa.</translation>
    </message>
    <message>
        <source>The wider the angle, the larger the error: here the vertical angle is 120°. Multiplied, it would be 213° across, more than half a turn. The model has 144°.</source>
        <translation>Mida laiem nurk, seda suurem viga: siin on vertikaalne nurk 120°. Korrutatuna oleks see rõhtsihis 213°, rohkem kui pool pööret. Mudelis on 144°.</translation>
    </message>
    <message>
        <source>Practise: how wide?</source>
        <translation>Harjutus: kui lai?</translation>
    </message>
    <message>
        <source>The field of view is the vertical angle {0}; {1} is the horizontal one.</source>
        <translation>Frustumi nurk on vertikaalne nurk {0}; {1} on horisontaalne.</translation>
    </message>
    <message>
        <source>The picture has {0} by {1} pixels, and {2}. How large is {3} then?</source>
        <translation>Pildis on {0} korda {1} pikslit ja {2}. Kui suur on siis {3}?</translation>
    </message>
    <message>
        <source>Widths are proportional to the tangent of half the angle. Look at {0}: {1} times that would be {2}°, more than half a turn, but the pyramid stays narrower.</source>
        <translation>Laiused on võrdelised poole nurga tangensiga. Vaadake juhtu {0}: {1} korda see oleks {2}°, rohkem kui pool pööret, aga püramiid jääb kitsamaks.</translation>
    </message>
    <message>
        <source>This takes the vertical angle for the horizontal one. Look at a square picture: only here both are {0}°, and the pyramid is narrower.</source>
        <translation>Nii võetakse horisontaalse nurga asemel vertikaalne. Vaadake ruudukujulist pilti: ainult siin on mõlemad {0}° ja püramiid on kitsam.</translation>
    </message>
    <message>
        <source>Half of the vertical angle has the tangent {0}.</source>
        <translation>Poole vertikaalse nurga tangens on {0}.</translation>
    </message>
    <message>
        <source>The tangents of the half angles are in the ratio of the sides, {0} to {1}.</source>
        <translation>Poolte nurkade tangensid on samas suhtes kui küljed: {0} ja {1}.</translation>
    </message>
    <message>
        <source>Practise: the focal length e</source>
        <translation>Harjutus: fookuskaugus e</translation>
    </message>
    <message>
        <source>At the distance {0} from the eye the picture reaches from {1} to {2}.</source>
        <translation>Kaugusel {0} silmast ulatub pilt kohast {1} kohani {2}.</translation>
    </message>
    <message>
        <source>The horizontal angle is {0}, and the picture is 16 by 9. How large is {1}?</source>
        <translation>Horisontaalne nurk on {0} ja pilt on 16 korda 9. Kui suur on {1}?</translation>
    </message>
    <message>
        <source>The cotangent takes my degrees</source>
        <translation>Kootangensile kõlbavad minu kraadid</translation>
    </message>
    <message>
        <source>This takes {0}° for {1} radians, which is more than a whole turn. Look at the angle: it is less than a quarter of one.</source>
        <translation>Nii võetakse {0}° asemel {1} radiaani, mis on rohkem kui terve pööre. Vaadake nurka: see on väiksem kui veerandpööre.</translation>
    </message>
    <message>
        <source>This takes the vertical angle for the horizontal one. Look at a square picture with the same vertical angle: only here is it the horizontal one.</source>
        <translation>Nii võetakse horisontaalse nurga asemel vertikaalne. Vaadake sama vertikaalse nurgaga ruudukujulist pilti: ainult siin on see ka horisontaalne nurk.</translation>
    </message>
    <message>
        <source>Draw the triangle of the eye, the axis, and the picture&apos;s right edge: {0} along the axis, 1 across it.</source>
        <translation>Joonistage kolmnurk silma, telje ja pildi parema serva vahele: {0} piki telge, 1 sellega risti.</translation>
    </message>
    <message>
        <source>Its angle at the eye is half of {0}.</source>
        <translation>Selle nurk silma juures on pool nurgast {0}.</translation>
    </message>
    <message>
        <source>Practise: a wide picture on purpose</source>
        <translation>Harjutus: meelega lai pilt</translation>
    </message>
    <message>
        <source>Set the vertical angle in the dock; the picture keeps its pixels.</source>
        <translation>Seadke vertikaalne nurk külgribal; pilt säilitab oma pikslid.</translation>
    </message>
    <message>
        <source>The picture has {0} by 600 pixels. Make the horizontal angle {1}°.</source>
        <translation>Pildis on {0} korda 600 pikslit. Tehke horisontaalseks nurgaks {1}°.</translation>
    </message>
    <message>
        <source>Half of {0}° has the tangent {1}.</source>
        <translation>Poole {0}° tangens on {1}.</translation>
    </message>
    <message>
        <source>Half of the vertical angle has {0} of that tangent.</source>
        <translation>Poole vertikaalse nurga tangens on sellest {0}.</translation>
    </message>
    <message>
        <source>The field of view that you set is the vertical one. Look from above: the pyramid is wider than {0}°.</source>
        <translation>Frustumi nurk, mille te seate, on vertikaalne. Vaadake ülalt: püramiid on laiem kui {0}°.</translation>
    </message>
    <message>
        <source>Angles are not in the ratio of the sides; the tangents of the half angles are. Look from above: the pyramid is narrower than {0}°.</source>
        <translation>Külgede suhtes ei ole nurgad, vaid poolte nurkade tangensid. Vaadake ülalt: püramiid on kitsam kui {0}°.</translation>
    </message>
</context>
<context>
    <name>l04-view-volumes</name>
    <message>
        <source>What fits into the view volume?</source>
        <translation>Mis mahub nähtavasse ruumi?</translation>
    </message>
    <message>
        <source>Twice as deep in the box</source>
        <translation>Kaks korda sügavamal risttahukas</translation>
    </message>
    <message>
        <source>Only what lies in the view volume is drawn. Here it is a pyramid without its tip: **World** shows it, with five test cubes of one size, A to E. Cube B (probe 1) is 4 units deep, A (probe 2) is 8 units deep. B lies outside the pyramid, so its name is grey there. A box that contains both cubes will now replace the pyramid.</source>
        <translation>Joonistatakse ainult see, mis on nähtavas ruumis. Siin on selleks püramiid, millel ei ole tippu: seda näitab **Maailm** koos viie ühesuuruse katsekuubiga A kuni E. Kuubi B (sond 1) sügavus on 4 ühikut, kuubil A (sond 2) 8 ühikut. B on püramiidist väljas, seepärast on selle nimi seal hall. Nüüd asendab püramiidi risttahukas, kuhu mahuvad mõlemad kuubid.</translation>
    </message>
    <message>
        <source>In the picture of the box: how wide is cube A, as a multiple of cube B, which is half as deep?</source>
        <translation>Kui lai on risttahuka pildil kuup A, võrreldes kuubiga B, mille sügavus on sellest pool?</translation>
    </message>
    <message>
        <source>This divides by the depth, as a pyramid does. Look at a pyramid wide enough for both: here A is half as wide as B, because its projectors meet. Those of the box do not.</source>
        <translation>Nii jagatakse sügavusega, nagu teeb püramiid. Vaadake püramiidi, mis on mõlema jaoks piisavalt lai: siin on A poole kitsam kui B, sest projektsioonikiired kohtuvad. Risttahuka kiired ei kohtu.</translation>
    </message>
    <message>
        <source>Nothing is larger for being farther away. Twice the depth would halve it in a pyramid. Look at the box: A and B are equally wide.</source>
        <translation>Miski ei ole suurem sellepärast, et ta on kaugemal. Püramiidis jääks kahekordse sügavuse korral suurus pooleks. Vaadake risttahukat: A ja B on ühelaiused.</translation>
    </message>
    <message>
        <source>The projectors of a box are parallel. Everything is divided by the same w = 1, whatever its depth.</source>
        <translation>Risttahuka projektsioonikiired on paralleelsed. Kõik jagatakse sama arvuga w = 1, sügavusest olenemata.</translation>
    </message>
    <message>
        <source>The pyramid grows, the box does not</source>
        <translation>Püramiid kasvab, risttahukas mitte</translation>
    </message>
    <message>
        <source>With the vertical angle {0} the pyramid reaches, at the depth {1}, up to</source>
        <translation>Vertikaalse nurga {0} korral ulatub püramiid sügavusel {1} kuni kõrguseni</translation>
    </message>
    <message>
        <source>above the axis, and {0} of that to the side. Here {1}.</source>
        <translation>teljest ülespoole ja {0} sellest kõrvale. Siin {1}.</translation>
    </message>
    <message>
        <source>depth</source>
        <translation>sügavus</translation>
    </message>
    <message>
        <source>height</source>
        <translation>kõrgus</translation>
    </message>
    <message>
        <source>to the side</source>
        <translation>kõrvale</translation>
    </message>
    <message>
        <source>4, cube B</source>
        <translation>4, kuup B</translation>
    </message>
    <message>
        <source>8, cube A</source>
        <translation>8, kuup A</translation>
    </message>
    <message>
        <source>12, cube C</source>
        <translation>12, kuup C</translation>
    </message>
    <message>
        <source>The box has, at every depth, the sides that the pyramid has at the target, 8 units away: 2.91 and 5.18. Cube B stands 3 to the side: outside 2.59, inside 5.18. **World**, seen from *Above*, shows the pyramid.</source>
        <translation>Risttahukal on igal sügavusel need küljed, mis püramiidil on sihtpunkti juures, 8 ühiku kaugusel: 2.91 ja 5.18. Kuup B on 3 võrra kõrval: väljaspool arvu 2.59, seespool arvu 5.18. **Maailm**, vaadatuna *Ülalt*, näitab püramiidi.</translation>
    </message>
    <message>
        <source>In the box, not in the pyramid</source>
        <translation>Risttahukas, aga mitte püramiidis</translation>
    </message>
    <message>
        <source>Now the volume is the box. Probe 1 is at cube A, in both volumes. Drag it in **Image**, or type {0}, {1}, {2} in the world in *Probe*. The eye is at {3} and looks along {4}.</source>
        <translation>Nüüd on nähtav ruum risttahukas. Sond 1 on kuubis A, mõlemas nähtavas ruumis. Lohistage seda paanis **Pilt** või sisestage paneelis *Sond* maailma {0}, {1}, {2}. Silm on kohal {3} ja vaatab suunas {4}.</translation>
    </message>
    <message>
        <source>Keep the box, and bring probe 1 to a place that is in the box but was outside the 40° pyramid.</source>
        <translation>Jätke risttahukas alles ja viige sond 1 kohta, mis on risttahuka sees, aga oli väljaspool 40° püramiidi.</translation>
    </message>
    <message>
        <source>Where is the pyramid narrower than the box?</source>
        <translation>Kus on püramiid risttahukast kitsam?</translation>
    </message>
    <message>
        <source>Nearer to the eye than the target: there a point at the side of the box is beside the pyramid.</source>
        <translation>Silmale lähemal kui sihtpunkt: seal on punkt risttahuka ääres püramiidi kõrval.</translation>
    </message>
    <message>
        <source>Right: in front of the target the box is wider than the pyramid, behind it narrower.</source>
        <translation>Õige: sihtpunkti ees on risttahukas püramiidist laiem, selle taga kitsam.</translation>
    </message>
    <message>
        <source>The other way round</source>
        <translation>Vastupidi</translation>
    </message>
    <message>
        <source>The pyramid again, with near at 3 and far at 13. A grey name in **World** is outside. In the dock, *View volume* switches between the box and the pyramid.</source>
        <translation>Jälle püramiid, lähitasand kaugusel 3 ja kaugtasand kaugusel 13. Hall nimi paanis **Maailm** tähendab, et kuup on väljas. Külgribal vahetab *Nähtav ruum* risttahuka ja püramiidi.</translation>
    </message>
    <message>
        <source>Which cube is in the pyramid, but not in the box?</source>
        <translation>Milline kuup on püramiidi, aga mitte risttahuka sees?</translation>
    </message>
    <message>
        <source>B</source>
        <translation>B</translation>
    </message>
    <message>
        <source>B is the other way round: in the box, but beside the pyramid. Look at the box: B is inside.</source>
        <translation>B-ga on vastupidi: see on risttahuka sees, aga püramiidi kõrval. Vaadake risttahukat: B on sees.</translation>
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
        <translation>E on mõlemas: see on sügaval, aga telje lähedal. Vaadake risttahukat: ka E on sees.</translation>
    </message>
    <message>
        <source>None: C is 13.9 from the eye, beyond far</source>
        <translation>Mitte ükski: C on silmast 13.9 kaugusel, kaugtasandist kaugemal</translation>
    </message>
    <message>
        <source>Far is a plane across the axis: only the depth of 12 counts, not the 13.9. Look from above: C lies before far.</source>
        <translation>Kaugtasand on teljega risti olev tasand: loeb ainult sügavus 12, mitte 13.9. Vaadake ülalt: C on kaugtasandi ees.</translation>
    </message>
    <message>
        <source>C is 12 deep and 7 to the side. There the pyramid reaches 7.76 to the side, the box only 5.18.</source>
        <translation>C sügavus on 12 ja see on 7 võrra kõrval. Seal ulatub püramiid kõrvale 7.76, risttahukas ainult 5.18.</translation>
    </message>
    <message>
        <source>How high at depth 10?</source>
        <translation>Kui kõrgel sügavusel 10?</translation>
    </message>
    <message>
        <source>Now the angle is 50° and the depth is 10.</source>
        <translation>Nüüd on nurk 50° ja sügavus 10.</translation>
    </message>
    <message>
        <source>How far above the axis does the pyramid reach there?</source>
        <translation>Kui kõrgele teljest ulatub püramiid seal?</translation>
    </message>
    <message>
        <source>The triangle of eye, axis and upper plane has half of the angle at the eye. Look at 90°: there the pyramid is as high as it is deep, {0}.</source>
        <translation>Silma, telje ja ülemise tasandi kolmnurgas on silma juures pool nurka. Vaadake 90°: seal on püramiid sama kõrge kui sügav, {0}.</translation>
    </message>
    <message>
        <source>The tangent takes my 25</source>
        <translation>Tangensile kõlbab minu 25</translation>
    </message>
    <message>
        <source>This is the tangent of 25 radians, almost four turns. Look at the angle: 25° is 0.436 radians.</source>
        <translation>See on 25 radiaani tangens, peaaegu neli pööret. Vaadake nurka: 25° on 0.436 radiaani.</translation>
    </message>
    <message>
        <source>The right-angled triangle between eye, axis and upper plane has half of the angle at the eye.</source>
        <translation>Silma, telje ja ülemise tasandi vahelises täisnurkses kolmnurgas on silma juures pool nurka.</translation>
    </message>
    <message>
        <source>h = 10·tan 25° = 4.66</source>
        <translation>h = 10·tan 25° = 4.66</translation>
    </message>
    <message>
        <source>Three to the side at depth 6</source>
        <translation>Kolm kõrvale sügavusel 6</translation>
    </message>
    <message>
        <source>The picture is 16 by 9. **World** shows the pyramid from *Above*; the label at the eye gives half of the horizontal angle.</source>
        <translation>Pilt on 16 korda 9. **Maailm** näitab püramiidi *Ülalt*; silt silma juures annab poole horisontaalsest nurgast.</translation>
    </message>
    <message>
        <source>Keep the pyramid, and set the field of view so that it reaches 3 units to each side of the axis at depth 6.</source>
        <translation>Jätke püramiid ja seadke frustumi nurk nii, et see ulatuks sügavusel 6 teljest kummalegi poole 3 ühikut.</translation>
    </message>
    <message>
        <source>Half of the horizontal angle has the tangent 3/6.</source>
        <translation>Poole horisontaalse nurga tangens on 3/6.</translation>
    </message>
    <message>
        <source>Half of the vertical one has 9/16 of that tangent: 0.281.</source>
        <translation>Poole vertikaalse nurga tangens on sellest 9/16: 0.281.</translation>
    </message>
    <message>
        <source>Right: horizontally 53.1°, vertically 31.4° in this picture.</source>
        <translation>Õige: sellel pildil horisontaalselt 53.1°, vertikaalselt 31.4°.</translation>
    </message>
    <message>
        <source>Back to the prediction</source>
        <translation>Tagasi ennustuse juurde</translation>
    </message>
    <message>
        <source>It is tempting to expect the farther cube to be smaller: every picture of an eye or a camera shows it so, and it is true of the pyramid, whose section grows with the depth. A cube takes a smaller share of a larger section.</source>
        <translation>Ahvatlev on oodata, et kaugem kuup on väiksem: iga silma või kaamera pilt näitab seda nii ja püramiidi kohta see kehtib, sest selle ristlõige kasvab sügavusega. Kuup võtab suuremast ristlõikest väiksema osa.</translation>
    </message>
    <message>
        <source>The section of the box does not grow. A cube takes the same share of it at every depth. The picture loses the impression of depth: in **Image** nothing says that B is the nearer one.</source>
        <translation>Risttahuka ristlõige ei kasva. Kuup võtab sellest igal sügavusel sama suure osa. Pilt kaotab sügavuse mulje: paanis **Pilt** ei ütle miski, et B on lähem.</translation>
    </message>
    <message>
        <source>Practise: which point goes first?</source>
        <translation>Harjutus: milline punkt kaob esimesena?</translation>
    </message>
    <message>
        <source>You see the pyramid from above. Points 1, 2 and 3 are in it, at the height of the eye.</source>
        <translation>Näete püramiidi ülalt. Punktid 1, 2 ja 3 on selle sees, silma kõrgusel.</translation>
    </message>
    <message>
        <source>The far plane moves towards the eye. Mark the point that it cuts off first.</source>
        <translation>Kaugtasand liigub silma poole. Märkige punkt, mille see esimesena ära lõikab.</translation>
    </message>
    <message>
        <source>Far is a plane, so the depth counts, not the distance from the eye. Look at far, moved in: it has cut off another point, and this one is still before it.</source>
        <translation>Kaugtasand on tasand, seega loeb sügavus, mitte kaugus silmast. Vaadake lähemale toodud kaugtasandit: see on ära lõiganud teise punkti ja see siin on endiselt tasandi ees.</translation>
    </message>
    <message>
        <source>Far meets the nearest point first</source>
        <translation>Kaugtasand jõuab esimesena lähima punktini</translation>
    </message>
    <message>
        <source>The far plane reaches this point last: it is the one that is least deep. Look at far, moved in to just behind this point: the other two are cut off.</source>
        <translation>Selle punktini jõuab kaugtasand viimasena: selle sügavus on kõige väiksem. Vaadake kaugtasandit, mis on toodud kohe selle punkti taha: teised kaks on ära lõigatud.</translation>
    </message>
    <message>
        <source>How does the far plane look from above?</source>
        <translation>Kuidas kaugtasand ülalt paistab?</translation>
    </message>
    <message>
        <source>It is {0} deep, the one at the side {1}, and the third {2}.</source>
        <translation>Selle sügavus on {0}, kõrval oleval {1} ja kolmandal {2}.</translation>
    </message>
    <message>
        <source>Practise: how high?</source>
        <translation>Harjutus: kui kõrgele?</translation>
    </message>
    <message>
        <source>You see the pyramid from the side; {0} is its vertical angle.</source>
        <translation>Näete püramiidi küljelt; {0} on selle vertikaalne nurk.</translation>
    </message>
    <message>
        <source>Here {0}. How far above the axis does the pyramid reach at the depth {1}?</source>
        <translation>Siin {0}. Kui kõrgele teljest ulatub püramiid sügavusel {1}?</translation>
    </message>
    <message>
        <source>The tangent takes my degrees</source>
        <translation>Tangensile kõlbavad minu kraadid</translation>
    </message>
    <message>
        <source>This takes {0}° for {1} radians, which is more than a whole turn. Look at the angle: it is less than a quarter of one.</source>
        <translation>Nii võetakse {0}° asemel {1} radiaani, mis on rohkem kui terve pööre. Vaadake nurka: see on väiksem kui veerandpööre.</translation>
    </message>
    <message>
        <source>In the triangle of eye, axis and upper plane, the angle at the eye is half of {0}.</source>
        <translation>Silma, telje ja ülemise tasandi kolmnurgas on nurk silma juures pool nurgast {0}.</translation>
    </message>
    <message>
        <source>Practise: how far to the side?</source>
        <translation>Harjutus: kui kaugele kõrvale?</translation>
    </message>
    <message>
        <source>The picture is 16 by 9. **World** shows the pyramid from above.</source>
        <translation>Pilt on 16 korda 9. **Maailm** näitab püramiidi ülalt.</translation>
    </message>
    <message>
        <source>Set the field of view so that the pyramid reaches {0} units to each side of the axis at the depth {1}.</source>
        <translation>Seadke frustumi nurk nii, et püramiid ulatuks sügavusel {1} teljest kummalegi poole {0} ühikut.</translation>
    </message>
    <message>
        <source>Half of the horizontal angle has the tangent {0}/{1}.</source>
        <translation>Poole horisontaalse nurga tangens on {0}/{1}.</translation>
    </message>
    <message>
        <source>Half of the vertical angle has 9/16 of that tangent.</source>
        <translation>Poole vertikaalse nurga tangens on sellest 9/16.</translation>
    </message>
    <message>
        <source>Half of the vertical angle has the tangent {0}, so the angle is {1} {2}.</source>
        <translation>Poole vertikaalse nurga tangens on {0}, seega on nurk {1} {2}.</translation>
    </message>
    <message>
        <source>The triangle of eye, axis and side has half of the horizontal angle at the eye. Look from above: at the depth {0} the pyramid does not reach {1} to the side.</source>
        <translation>Silma, telje ja külje kolmnurgas on silma juures pool horisontaalsest nurgast. Vaadake ülalt: sügavusel {0} ei ulatu püramiid kõrvale nii kaugele kui {1}.</translation>
    </message>
    <message>
        <source>The field of view is the vertical angle. Look from above: at the depth {0} the pyramid reaches {1} to the side.</source>
        <translation>Frustumi nurk on vertikaalne nurk. Vaadake ülalt: sügavusel {0} ulatub püramiid kõrvale {1}.</translation>
    </message>
</context>
<context>
    <name>l05-similar-triangles</name>
    <message>
        <source>How big on the picture plane?</source>
        <translation>Kui suurelt pilditasandil?</translation>
    </message>
    <message>
        <source>The plane moves out</source>
        <translation>Tasand nihkub kaugemale</translation>
    </message>
    <message>
        <source>The picture plane stands at the distance {0} in front of the eye. P is 5 units deep and 2 units above the axis. In **World**, from the *Side*, its projector runs to the eye and meets the plane at P&apos;, {1} above the axis. The plane will now move to {2}.</source>
        <translation>Pilditasand on silma ees kaugusel {0}. P sügavus on 5 ühikut ja see on teljest 2 ühikut kõrgemal. Paanis **Maailm**, vaadatuna *Küljelt*, läheb selle projektsioonikiir silma ja kohtab tasandit punktis P&apos;, mis on teljest {1} kõrgemal. Tasand nihkub nüüd kaugusele {2}.</translation>
    </message>
    <message>
        <source>How many times as high as before is P&apos; above the axis then?</source>
        <translation>Mitu korda kõrgemal teljest kui enne on siis P&apos;?</translation>
    </message>
    <message>
        <source>This measures from the plane to P. The two triangles share the corner at the eye. Look at {0}: from the eye P is 5 deep, wherever the plane is.</source>
        <translation>Nii mõõdetakse tasandist P-ni. Kahel kolmnurgal on ühine nurk silma juures. Vaadake suurust {0}: silmast on P sügavus 5, ükskõik kus tasand on.</translation>
    </message>
    <message>
        <source>The area of an image grows 4 times. Its height and its width grow in proportion to d. Look at {0} and {1}: both are twice as long as before.</source>
        <translation>Kujutise pindala kasvab 4 korda. Selle kõrgus ja laius kasvavad võrdeliselt d-ga. Vaadake suurusi {0} ja {1}: mõlemad on kaks korda pikemad kui enne.</translation>
    </message>
    <message>
        <source>The height is proportional to d as long as P stays where it is.</source>
        <translation>Kõrgus on võrdeline d-ga, kuni P jääb oma kohale.</translation>
    </message>
    <message>
        <source>Two similar triangles</source>
        <translation>Kaks sarnast kolmnurka</translation>
    </message>
    <message>
        <source>The large triangle runs from the eye along the axis to the depth of P, and up to P: its sides are {0} and {1}. The small one runs along the axis to the plane, and up to P&apos;: {2} and {3}. Both have the same angle at the eye:</source>
        <translation>Suur kolmnurk ulatub silmast piki telge P sügavuseni ja sealt üles P-ni: selle küljed on {0} ja {1}. Väike ulatub piki telge tasandini ja sealt üles P&apos;-ni: {2} ja {3}. Mõlemal on silma juures sama nurk:</translation>
    </message>
    <message>
        <source>P is {0} in camera space. With {1}: {2}. The dock has the numbers and the matrix with {3}. It takes P to {4}; divided by the last number, that is {5}.</source>
        <translation>P on kaamerafreimis {0}. Kui {1}: {2}. Külgribal on arvud ja maatriks, milles on {3}. See teisendab P punktiks {4}; jagatuna viimase arvuga on see {5}.</translation>
    </message>
    <message>
        <source>Half as large as the thing itself</source>
        <translation>Poole väiksem kui asi ise</translation>
    </message>
    <message>
        <source>You can also use the triangles the other way round: how far away must the plane be?</source>
        <translation>Kolmnurki saab kasutada ka vastupidi: kui kaugel peab tasand olema?</translation>
    </message>
    <message>
        <source>Make the image of P half as far from the axis as P itself: {0}, {1}.</source>
        <translation>Tehke nii, et P kujutis on teljest poole lähemal kui P ise: {0}, {1}.</translation>
    </message>
    <message>
        <source>The scale is {0}. It is a number in the dock.</source>
        <translation>Mastaap on {0}. See on üks külgriba arvudest.</translation>
    </message>
    <message>
        <source>The plane must be halfway between the eye and the depth of P.</source>
        <translation>Tasand peab olema silma ja P sügavuse vahel poolel teel.</translation>
    </message>
    <message>
        <source>Right: half way, half the size. Nothing else affects the scale.</source>
        <translation>Õige: pool teed, pool suurust. Miski muu mastaapi ei mõjuta.</translation>
    </message>
    <message>
        <source>Another point</source>
        <translation>Teine punkt</translation>
    </message>
    <message>
        <source>Now P is at {0} in camera space, and the plane is at {1}. The numbers in the dock come back with your answer.</source>
        <translation>Nüüd on P kaamerafreimis {0} ja tasandi kaugus on {1}. Külgriba arvud tulevad tagasi koos teie vastusega.</translation>
    </message>
    <message>
        <source>How large is {0}?</source>
        <translation>Kui suur on {0}?</translation>
    </message>
    <message>
        <source>This divides by the distance from the plane to P. Look at {0} and {1}: both begin at the eye, where the two triangles have their common corner.</source>
        <translation>Nii jagatakse kaugusega tasandist P-ni. Vaadake suurusi {0} ja {1}: mõlemad algavad silmast, kus on kahe kolmnurga ühine nurk.</translation>
    </message>
    <message>
        <source>In front of the eye {0} is negative, so divide by {1}. Look at the plane behind the eye: only there is the image below the axis.</source>
        <translation>Silma ees on {0} negatiivne, seega jagage arvuga {1}. Vaadake tasandit silma taga: ainult seal on kujutis teljest allpool.</translation>
    </message>
    <message>
        <source>The ratio of {0} to {1} equals the ratio of {2} to the depth.</source>
        <translation>Suuruste {0} ja {1} suhe on sama mis suuruse {2} ja sügavuse suhe.</translation>
    </message>
    <message>
        <source>The cell with d</source>
        <translation>Lahter, kus on d</translation>
    </message>
    <message>
        <source>As a matrix (000, formula 2) the projection leaves {0}, {1} and {2} as they are and makes the fourth coordinate {3}. The division does the rest.</source>
        <translation>Maatriksina (000, valem 2) jätab projektsioon {0}, {1} ja {2} samaks ning teeb neljandaks koordinaadiks {3}. Ülejäänu teeb jagamine.</translation>
    </message>
    <message>
        <source>The plane is at {0}. Which number is in row 4, column 3?</source>
        <translation>Tasandi kaugus on {0}. Milline arv on reas 4 ja veerus 3?</translation>
    </message>
    <message>
        <source>There is no minus in the matrix</source>
        <translation>Maatriksis ei ole miinust</translation>
    </message>
    <message>
        <source>Then the fourth coordinate would be {0}. For points in front of the eye {1} is negative, so {2} and {3} would change their signs. Look at the plane of this matrix: it is behind the eye, and the image is upside down.</source>
        <translation>Siis oleks neljas koordinaat {0}. Silma ees olevate punktide {1} on negatiivne, seega vahetaksid {2} ja {3} märki. Vaadake selle maatriksi tasandit: see on silma taga ja kujutis on tagurpidi.</translation>
    </message>
    <message>
        <source>This is row 3, column 4. Row 4 makes the fourth coordinate, {0}, and column 3 is the share of {1}. Look at {2} and {3}: their ratio is the divisor.</source>
        <translation>See on rida 3, veerg 4. Neljanda koordinaadi {0} annab rida 4 ja veerg 3 on suuruse {1} osa. Vaadake suurusi {2} ja {3}: nende suhe on jagaja.</translation>
    </message>
    <message>
        <source>Row 4 times (x, y, z, 1) must equal {0}.</source>
        <translation>Rida 4 korda (x, y, z, 1) peab olema võrdne: {0}.</translation>
    </message>
    <message>
        <source>{0}. For points in front {1} is negative, and so {2} is positive.</source>
        <translation>{0}. Silma ees olevate punktide {1} on negatiivne, seega on {2} positiivne.</translation>
    </message>
    <message>
        <source>Set the plane</source>
        <translation>Seadke tasand</translation>
    </message>
    <message>
        <source>P is at {0} in camera space again, and the plane is at {1}.</source>
        <translation>P on kaamerafreimis jälle {0} ja tasandi kaugus on {1}.</translation>
    </message>
    <message>
        <source>Keep P in its place, and move the plane until the image of P is 1.5 above the axis.</source>
        <translation>Jätke P oma kohale ja nihutage tasandit, kuni P kujutis on teljest 1.5 kõrgemal.</translation>
    </message>
    <message>
        <source>1.5 is three quarters of 2.</source>
        <translation>1.5 on kolmveerand arvust 2.</translation>
    </message>
    <message>
        <source>Right: three quarters of the height, three quarters of the way: d = 3.75.</source>
        <translation>Õige: kolmveerand kõrgusest, kolmveerand teest: d = 3.75.</translation>
    </message>
    <message>
        <source>Back to the prediction</source>
        <translation>Tagasi ennustuse juurde</translation>
    </message>
    <message>
        <source>It is tempting to measure from the plane to P: 4 units before, 3 units after, so {0} against {1}, which is 2.67 times. But the two triangles share the corner at the eye. Measured from there, P stays 5 units deep wherever the plane is, and {2} grows from {3} to {4}.</source>
        <translation>Ahvatlev on mõõta tasandist P-ni: enne 4 ühikut, pärast 3 ühikut, seega {0} võrreldes arvuga {1}, mis teeb 2.67 korda. Aga kahel kolmnurgal on ühine nurk silma juures. Sealt mõõdetuna jääb P sügavuseks 5 ühikut, ükskõik kus tasand on, ja {2} kasvab arvust {3} arvuni {4}.</translation>
    </message>
    <message>
        <source>This also says what happens to the *picture* when the plane moves: everything grows by the same factor, and nothing moves against the rest.</source>
        <translation>See ütleb ka, mis juhtub *pildiga*, kui tasand liigub: kõik kasvab sama arv kordi ja miski ei nihku ülejäänu suhtes.</translation>
    </message>
    <message>
        <source>Practise: how high is the image?</source>
        <translation>Harjutus: kui kõrgel on kujutis?</translation>
    </message>
    <message>
        <source>P is in camera space, and the picture plane is at the distance {0} from the eye.</source>
        <translation>P on antud kaamerafreimis ja pilditasandi kaugus silmast on {0}.</translation>
    </message>
    <message>
        <source>P is at {0}, and {1}. How large is {2}?</source>
        <translation>P on kohal {0} ja {1}. Kui suur on {2}?</translation>
    </message>
    <message>
        <source>The two similar triangles share the corner at the eye.</source>
        <translation>Kahel sarnasel kolmnurgal on ühine nurk silma juures.</translation>
    </message>
    <message>
        <source>Practise: the matrix with -1/d</source>
        <translation>Harjutus: maatriks, milles on -1/d</translation>
    </message>
    <message>
        <source>The matrix keeps {0}, {1} and {2}; its row 4 has {3} in column 3 and zeros elsewhere. The division comes afterwards.</source>
        <translation>Maatriks säilitab {0}, {1} ja {2}; selle rea 4 veerus 3 on {3} ja mujal nullid. Jagamine tuleb hiljem.</translation>
    </message>
    <message>
        <source>The plane is at {0}. What does the matrix make of {1}?</source>
        <translation>Tasandi kaugus on {0}. Mis saab maatriksiga korrutades punktist {1}?</translation>
    </message>
    <message>
        <source>In front of the eye {0} is negative, so the division would change the signs of {1} and {2}. Look at the plane of this matrix: it is behind the eye, and the image is upside down.</source>
        <translation>Silma ees on {0} negatiivne, seega muudaks jagamine koordinaatide {1} ja {2} märgid. Vaadake selle maatriksi tasandit: see on silma taga ja kujutis on tagurpidi.</translation>
    </message>
    <message>
        <source>This has {0} in row 3, column 4. Row 4 makes the fourth coordinate, and column 3 is the share of {1}. Look at {2} and {3}: their ratio is the divisor.</source>
        <translation>Siin on {0} reas 3 ja veerus 4. Neljanda koordinaadi annab rida 4 ja veerg 3 on suuruse {1} osa. Vaadake suurusi {2} ja {3}: nende suhe on jagaja.</translation>
    </message>
    <message>
        <source>Row 4 times {0} is {1} times {2}.</source>
        <translation>Rida 4 korda {0} on {1} korda {2}.</translation>
    </message>
    <message>
        <source>Divided by its last number, it is P&apos;: {0}.</source>
        <translation>Jagatuna viimase arvuga on see P&apos;: {0}.</translation>
    </message>
    <message>
        <source>Practise: set the plane</source>
        <translation>Harjutus: seadke tasand</translation>
    </message>
    <message>
        <source>The plane is at {0}. Drag it, or type {1} in the dock.</source>
        <translation>Tasandi kaugus on {0}. Lohistage seda või sisestage {1} külgribal.</translation>
    </message>
    <message>
        <source>P is {0} deep and {1} above the axis. Leave it there, and move the plane until the image P&apos; is {2} above the axis.</source>
        <translation>P sügavus on {0} ja see on teljest {1} kõrgemal. Jätke see sinna ja nihutage tasandit, kuni kujutis P&apos; on teljest {2} kõrgemal.</translation>
    </message>
    <message>
        <source>Your plane is behind the eye. Look at P&apos;: it is below the axis.</source>
        <translation>Teie tasand on silma taga. Vaadake punkti P&apos;: see on teljest allpool.</translation>
    </message>
    <message>
        <source>This measures the depth of P from the plane. Both triangles begin at the eye. Look at P&apos;: it is less than {0} above the axis.</source>
        <translation>Nii mõõdetakse P sügavust tasandist. Mõlemad kolmnurgad algavad silmast. Vaadake punkti P&apos;: see on teljest vähem kui {0} kõrgemal.</translation>
    </message>
</context>
<context>
    <name>l06-off-axis-frustum</name>
    <message>
        <source>Why six numbers?</source>
        <translation>Miks kuus arvu?</translation>
    </message>
    <message>
        <source>The window goes to the right</source>
        <translation>Aken läheb paremale</translation>
    </message>
    <message>
        <source>A frustum is given by six numbers: left, right, bottom and top of its window on the near plane, and near and far. The window here reaches from {0} to {1}; the point straight ahead of the eye, probe 1, is in the middle of **Image**. The eye stays where it is, and the window moves to the right: {2}, {3}.</source>
        <translation>Frustumi määravad kuus arvu: selle lähitasandil oleva akna vasak, parem, alumine ja ülemine serv ning lähi- ja kaugtasand. Siin ulatub aken kohast {0} kohani {1}; punkt otse silma ees, sond 1, on paani **Pilt** keskel. Silm jääb paigale ja aken liigub paremale: {2}, {3}.</translation>
    </message>
    <message>
        <source>Where is probe 1 in the picture then? NDC has {0} at the left edge and {1} at the right one.</source>
        <translation>Kus on siis sond 1 pildil? NDC-s on vasakul serval {0} ja paremal {1}.</translation>
    </message>
    <message>
        <source>Straight ahead is in the middle only if the window is as far to the left as to the right. Look at this window: it reaches 2 to each side, and probe 1 is in the middle.</source>
        <translation>Otse ees olev on keskel ainult siis, kui aken ulatub vasakule sama kaugele kui paremale. Vaadake seda akent: see ulatub kummalegi poole 2 ja sond 1 on keskel.</translation>
    </message>
    <message>
        <source>This moves the picture with its window. Look at the window that has moved to the left: only then is probe 1 at {0}.</source>
        <translation>Nii liigutatakse pilti koos selle aknaga. Vaadake akent, mis on liikunud vasakule: ainult siis on sond 1 kohal {0}.</translation>
    </message>
    <message>
        <source>There is now 1 unit of window left of the axis, and 3 units right of it. So the axis is a quarter of the way across.</source>
        <translation>Nüüd on teljest vasakul 1 ühik akent ja paremal 3 ühikut. Seega on telg veerandi peal akna laiusest.</translation>
    </message>
    <message>
        <source>From the window to [-1, 1]</source>
        <translation>Aknast vahemikku [-1, 1]</translation>
    </message>
    <message>
        <source>First the point comes to the near plane, by similar triangles: {0}. Then the range {1} becomes {2}:</source>
        <translation>Kõigepealt viiakse punkt lähitasandile, sarnaste kolmnurkade järgi: {0}. Siis saab vahemikust {1} vahemik {2}:</translation>
    </message>
    <message>
        <source>With {0}, {1}, {2} the cells are {3} and {4}. The second one stands in column 3: it is multiplied by {5}, which is negative, and so the axis comes to {6}.</source>
        <translation>Kui {0}, {1}, {2}, on lahtrid {3} ja {4}. Teine neist on veerus 3: see korrutatakse suurusega {5}, mis on negatiivne, ja nii satub telg kohale {6}.</translation>
    </message>
    <message>
        <source>Bottom, top and y work the same way. *Matrices* shows the whole matrix as clip ← view. For {0} that cell is 0, as in gluPerspective.</source>
        <translation>Alumise ja ülemise serva ning y-iga käib kõik samamoodi. *Maatriksid* näitab kogu maatriksit nimega kärperuum ← vaade. Kui {0}, on see lahter 0, nagu gluPerspective&apos;is.</translation>
    </message>
    <message>
        <source>The axis on the other side</source>
        <translation>Telg teisel pool</translation>
    </message>
    <message>
        <source>Probe 1 still is straight ahead of the eye. *Probe*, below the pictures, has its {0} in the row NDC.</source>
        <translation>Sond 1 on endiselt otse silma ees. Piltide all olevas paneelis *Sond* on selle {0} reas NDC.</translation>
    </message>
    <message>
        <source>Bring the axis to the right half of the picture, to x&apos; = 0.5.</source>
        <translation>Viige telg pildi paremasse poolde, kohta x&apos; = 0.5.</translation>
    </message>
    <message>
        <source>Which side must the window reach farther to?</source>
        <translation>Kummale poole peab aken kaugemale ulatuma?</translation>
    </message>
    <message>
        <source>Three times as far to the left as to the right: Left −3, Right 1.</source>
        <translation>Vasakule kolm korda kaugemale kui paremale: Vasak −3, Parem 1.</translation>
    </message>
    <message>
        <source>Right: three quarters of the window are left of the axis.</source>
        <translation>Õige: kolmveerand aknast on teljest vasakul.</translation>
    </message>
    <message>
        <source>The cell beside 2n/(r-l)</source>
        <translation>Lahter 2n/(r-l) kõrval</translation>
    </message>
    <message>
        <source>The window now reaches from {0} to {1} on the near plane at {2}.</source>
        <translation>Nüüd ulatub aken lähitasandil, kus {2}, kohast {0} kohani {1}.</translation>
    </message>
    <message>
        <source>Which number is in row 1, column 3 of the frustum matrix?</source>
        <translation>Milline arv on frustumi maatriksi reas 1 ja veerus 3?</translation>
    </message>
    <message>
        <source>The cell is positive if the window reaches farther to the right; {0}, which is negative, turns the sign. Look at the window from −4 to 1: it is the one with −0.6.</source>
        <translation>Lahter on positiivne, kui aken ulatub kaugemale paremale; märgi pöörab {0}, mis on negatiivne. Vaadake akent −4-st 1-ni: see on see, mille lahter on −0.6.</translation>
    </message>
    <message>
        <source>This is row 3, column 1. Row 1 makes {0}, and its column 3 is the share of {1}. Look at a symmetric window: only there is this share 0.</source>
        <translation>See on rida 3, veerg 1. Suuruse {0} annab rida 1 ja selle veerg 3 on suuruse {1} osa. Vaadake sümmeetrilist akent: ainult seal on see osa 0.</translation>
    </message>
    <message>
        <source>r + l is 3, r - l is 5.</source>
        <translation>r + l on 3, r - l on 5.</translation>
    </message>
    <message>
        <source>(r + l)/(r - l) = 3/5. The cell is multiplied by z, which is negative; that turns the sign.</source>
        <translation>(r + l)/(r - l) = 3/5. Lahter korrutatakse z-iga, mis on negatiivne; see pöörab märgi.</translation>
    </message>
    <message>
        <source>The cell for the depth</source>
        <translation>Sügavuse lahter</translation>
    </message>
    <message>
        <source>Row 3 is {0} with {1} and {2}.</source>
        <translation>Rida 3 on {0}, kus {1} ja {2}.</translation>
    </message>
    <message>
        <source>Near is 2 and far is 10. How large is {0}, in row 3, column 4?</source>
        <translation>Lähitasand on 2 ja kaugtasand 10. Kui suur on {0}, mis on reas 3 ja veerus 4?</translation>
    </message>
    <message>
        <source>This uses {0} and {1}, but near and far are lengths. Look at the planes: both are in front of the eye, at negative {2}, and the formula already contains that minus.</source>
        <translation>Siin kasutatakse {0} ja {1}, aga lähi- ja kaugtasand on pikkused. Vaadake tasandeid: mõlemad on silma ees, kus {2} on negatiivne, ja valemis on see miinus juba olemas.</translation>
    </message>
    <message>
        <source>This is row 4, column 3, which makes {0}. {1} is added to {2} in row 3. Look at near and far: {3} and {4} take them to {5} and {6}.</source>
        <translation>See on rida 4, veerg 3, mis annab {0}. {1} liidetakse suurusele {2} reas 3. Vaadake lähi- ja kaugtasandit: {3} ja {4} viivad need kohtadele {5} ja {6}.</translation>
    </message>
    <message>
        <source>n and f are distances, and positive.</source>
        <translation>n ja f on kaugused ja positiivsed.</translation>
    </message>
    <message>
        <source>Back to the prediction</source>
        <translation>Tagasi ennustuse juurde</translation>
    </message>
    <message>
        <source>It is tempting to move the picture with the window: to the right, {0}. But the window is the frame through which you see the scene. If you move a frame to the right, you see more of what is on the right, and what was in the middle is now left of the middle.</source>
        <translation>Ahvatlev on pilti liigutada koos aknaga: paremale, {0}. Aga aken on raam, mille kaudu te stseeni näete. Kui te raami paremale nihutate, näete rohkem sellest, mis on paremal, ja mis oli keskel, on nüüd keskkohast vasakul.</translation>
    </message>
    <message>
        <source>The plus in {0} does not contradict this. The cell is multiplied by {1}, and {2} is {3} at probe 1: {4}. Lecture 002 writes a plus where its own signs require a minus. So always try such a sign on a point.</source>
        <translation>Plussmärk avaldises {0} ei räägi sellele vastu. Lahter korrutatakse suurusega {1}, ja sondi 1 juures on {2} võrdne arvuga {3}: {4}. Loeng 002 kirjutab plussi kohta, kus tema enda märgid nõuavad miinust. Proovige seepärast sellist märki alati mõne punktiga.</translation>
    </message>
    <message>
        <source>Two eyes, one window</source>
        <translation>Kaks silma, üks aken</translation>
    </message>
    <message>
        <source>A stereo pair needs two such frusta: both eyes look through one window, the screen plane at {0}. The right eye is {1} to the right, so its window on the near plane, at {2}, is {3} farther left. Both {4} and {5} are 0.2 less; only the cell {6} changes.</source>
        <translation>Stereopaar vajab kahte sellist frustumit: mõlemad silmad vaatavad läbi ühe akna, milleks on ekraanitasand kaugusel {0}. Parem silm on {1} võrra paremal, nii et selle aken lähitasandil, kus {2}, on {3} võrra vasakul. Nii {4} kui ka {5} on 0.2 võrra väiksemad; muutub ainult lahter {6}.</translation>
    </message>
    <message>
        <source>{0}, below the middle and right of it, is equally high in both pictures. Now both cameras get a symmetric frustum and turn to the middle of the screen plane, as eyes turn.</source>
        <translation>{0}, mis on keskkohast allpool ja paremal, on mõlemal pildil ühel kõrgusel. Nüüd saavad mõlemad kaamerad sümmeetrilise frustumi ja pöörduvad ekraanitasandi keskkoha poole, nagu silmad pöörduvad.</translation>
    </message>
    <message>
        <source>How high is {0} in the right picture then?</source>
        <translation>Kui kõrgel on siis {0} parempoolsel pildil?</translation>
    </message>
    <message>
        <source>Lower than in the left one</source>
        <translation>Madalamal kui vasakpoolsel</translation>
    </message>
    <message>
        <source>As high as in the left one</source>
        <translation>Sama kõrgel kui vasakpoolsel</translation>
    </message>
    <message>
        <source>Each turned camera divides by the depth along its own axis, and no pair of eyes can look up with one eye and down with the other. Look at {0}: it is not equally high in both pictures.</source>
        <translation>Kumbki pööratud kaamera jagab sügavusega piki omaenda telge ja ükski silmapaar ei saa ühe silmaga üles ja teisega alla vaadata. Vaadake punkti {0}: see ei ole mõlemal pildil ühel kõrgusel.</translation>
    </message>
    <message>
        <source>Higher than in the left one</source>
        <translation>Kõrgemal kui vasakpoolsel</translation>
    </message>
    <message>
        <source>The right camera turns left, so {0}, on the right, is less deep for it. It divides by less, and {1} is farther from the middle. Look at {2} in both pictures: in the right one it is lower.</source>
        <translation>Parem kaamera pöördub vasakule, nii et paremal oleva punkti {0} sügavus on selle jaoks väiksem. See jagab väiksema arvuga ja {1} on keskkohast kaugemal. Vaadake punkti {2} mõlemal pildil: parempoolsel on see madalamal.</translation>
    </message>
    <message>
        <source>Each camera divides by the depth along its own axis: 5.06 for the left one, 4.96 for the right one. The right one divides by less, so {0} is 3.5 pixels lower there. Off the axis both divide by 5.</source>
        <translation>Kumbki kaamera jagab sügavusega piki omaenda telge: vasak arvuga 5.06, parem arvuga 4.96. Parem jagab väiksema arvuga, nii et {0} on seal 3.5 pikslit madalamal. Teljeväliselt jagavad mõlemad arvuga 5.</translation>
    </message>
    <message>
        <source>Practise: the row with l and r</source>
        <translation>Harjutus: rida, kus on l ja r</translation>
    </message>
    <message>
        <source>The window on the near plane, at the distance {0}, reaches from {1} to {2} in x.</source>
        <translation>Aken lähitasandil, kaugusel {0}, ulatub x-sihis kohast {1} kohani {2}.</translation>
    </message>
    <message>
        <source>Here {0}, {1} and {2}. Which four numbers are in row 1 of the frustum matrix?</source>
        <translation>Siin {0}, {1} ja {2}. Millised neli arvu on frustumi maatriksi reas 1?</translation>
    </message>
    <message>
        <source>The cell is positive if the window reaches farther to the right; {0}, which is negative, turns the sign. Look at the mirrored window: it is the one with your row.</source>
        <translation>Lahter on positiivne, kui aken ulatub kaugemale paremale; märgi pöörab {0}, mis on negatiivne. Vaadake peegeldatud akent: see on see, millel on teie rida.</translation>
    </message>
    <message>
        <source>Row 1 makes {0}, and its column 3 is the share of {1}. Look at a symmetric window: only there is this share 0.</source>
        <translation>Suuruse {0} annab rida 1 ja selle veerg 3 on suuruse {1} osa. Vaadake sümmeetrilist akent: ainult seal on see osa 0.</translation>
    </message>
    <message>
        <source>Row 1 times {0} is {1}.</source>
        <translation>Rida 1 korda {0} on {1}.</translation>
    </message>
    <message>
        <source>The axis comes to {0}, because {1} is negative.</source>
        <translation>Telg satub kohale {0}, sest {1} on negatiivne.</translation>
    </message>
    <message>
        <source>Practise: two images in the screen plane</source>
        <translation>Harjutus: kaks kujutist ekraanitasandil</translation>
    </message>
    <message>
        <source>Two eyes, {0} apart, look through the screen plane at the distance {1}. For each eye {2}, at the distance {3}, has an image there: {4} and {5}.</source>
        <translation>Kaks silma vahekaugusega {0} vaatavad läbi ekraanitasandi, mille kaugus on {1}. Punktil {2} kaugusega {3} on kummagi silma jaoks seal kujutis: {4} ja {5}.</translation>
    </message>
    <message>
        <source>The eyes are {0} apart, the screen plane is at {1}, and {2} is at {3}. How far to the right of {4} is {5}, in the screen plane? If it is to the left, the number is negative.</source>
        <translation>Silmade vahe on {0}, ekraanitasandi kaugus {1} ja punkti {2} kaugus {3}. Kui palju on ekraanitasandil {5} punktist {4} paremal? Kui see on vasakul, on arv negatiivne.</translation>
    </message>
    <message>
        <source>The screen&apos;s distance is the height</source>
        <translation>Ekraani kaugus on kõrgus</translation>
    </message>
    <message>
        <source>This takes the screen&apos;s distance for the height of the large triangle. That one reaches from {0} to the eyes, and its height is {1}. Look at both triangles.</source>
        <translation>Nii võetakse suure kolmnurga kõrguseks ekraani kaugus. See kolmnurk ulatub punktist {0} silmadeni ja selle kõrgus on {1}. Vaadake mõlemat kolmnurka.</translation>
    </message>
    <message>
        <source>Two symmetric frusta will do</source>
        <translation>Piisab kahest sümmeetrilisest frustumist</translation>
    </message>
    <message>
        <source>This is what two symmetric frusta side by side show: what is infinitely far away would lie in the screen plane. The windows move by {0} against each other, so add {1}. Look at {2} and {3}: {4} is behind the screen plane, and they are closer together than the eyes.</source>
        <translation>Seda näitavad kaks kõrvuti sümmeetrilist frustumit: lõpmata kaugel olev oleks ekraanitasandil. Aknad on üksteise suhtes nihkes, nihe on {0}; seega liitke {1}. Vaadake punkte {2} ja {3}: {4} on ekraanitasandi taga ja need on teineteisele lähemal kui silmad.</translation>
    </message>
    <message>
        <source>Both eyes and {0} are a triangle, {1}, {2} and {3} another one, similar to it.</source>
        <translation>Mõlemad silmad ja {0} moodustavad ühe kolmnurga, {1}, {2} ja {3} teise, mis on sellega sarnane.</translation>
    </message>
    <message>
        <source>Their heights are {0} and {1}. Before the screen plane the second one stands upside down.</source>
        <translation>Nende kõrgused on {0} ja {1}. Ekraanitasandi ees on teine tagurpidi.</translation>
    </message>
    <message>
        <source>The triangles are similar, so {0}. What lies in the screen plane has {1}, and nothing behind it reaches {2}.</source>
        <translation>Kolmnurgad on sarnased, seega {0}. Ekraanitasandil oleva punkti puhul {1}, ja ükski selle taga olev ei küüni väärtuseni {2}.</translation>
    </message>
    <message>
        <source>Practise: move the window</source>
        <translation>Harjutus: nihutage akent</translation>
    </message>
    <message>
        <source>The window reaches from {0} to {1} on the near plane.</source>
        <translation>Aken ulatub lähitasandil kohast {0} kohani {1}.</translation>
    </message>
    <message>
        <source>Make the cell in row 1, column 3 of the frustum matrix equal to {0}, and leave the cell in row 1, column 1 at {1}.</source>
        <translation>Tehke frustumi maatriksi rea 1 ja veeru 3 lahter võrdseks arvuga {0} ning jätke rea 1 ja veeru 1 lahtriks {1}.</translation>
    </message>
    <message>
        <source>The cells are {0} and {1}.</source>
        <translation>Lahtrid on {0} ja {1}.</translation>
    </message>
    <message>
        <source>If {0} stays at {1}, the width {2} stays 4.</source>
        <translation>Kui {0} on ikka {1}, on laius {2} ikka 4.</translation>
    </message>
    <message>
        <source>With {0} the width {1} stays {2}, and {3}. So {4} and {5}.</source>
        <translation>Kui {0}, jääb laius {1} samaks: {2}, ja {3}. Seega {4} ja {5}.</translation>
    </message>
    <message>
        <source>The cell has the sign of {0}. Look at your window: it reaches farther to the other side.</source>
        <translation>Lahtril on sama märk kui avaldisel {0}. Vaadake oma akent: see ulatub kaugemale teisele poole.</translation>
    </message>
</context>
<context>
    <name>l07-proportions</name>
    <message>
        <source>A picture of another shape</source>
        <translation>Teise kujuga pilt</translation>
    </message>
    <message>
        <source>A wide window in a square picture</source>
        <translation>Lai aken ruudukujulisel pildil</translation>
    </message>
    <message>
        <source>The window on the near plane is 4 wide and 2 high: {0} from -2 to 2, {1} from -1 to 1. The picture has 720 by 720 pixels. Stretched into it, the letter F is twice as high as it should be. Lecture 000 has two remedies. Variant X replaces {2} by {3} (and {4} by {5}), so that the proportions are right.</source>
        <translation>Akna laius lähitasandil on 4 ja kõrgus 2: {0} -2-st 2-ni, {1} -1-st 1-ni. Pildis on 720 korda 720 pikslit. Sellesse venitatult on F-täht kaks korda kõrgem, kui see olema peaks. Loengus 000 on kaks abinõu. Variant X asendab suuruse {2} suurusega {3} (ja {4} suurusega {5}), nii et proportsioonid on õiged.</translation>
    </message>
    <message>
        <source>How large is {0}?</source>
        <translation>Kui suur on {0}?</translation>
    </message>
    <message>
        <source>Variant X *keeps* x. Look at variant Y: it is the one that leaves y as it is, and adjusts x.</source>
        <translation>Variant X *säilitab* x-i. Vaadake varianti Y: see on see, mis jätab y samaks ja kohandab x-i.</translation>
    </message>
    <message>
        <source>This adds the whole missing length at each end. Look at the picture: the window is 6 high and 4 wide now, and the F is too low.</source>
        <translation>Nii liidetakse kummaski otsas kogu puuduv pikkus. Vaadake pilti: akna kõrgus on nüüd 6 ja laius 4 ning F on liiga madal.</translation>
    </message>
    <message>
        <source>The window must become as high as it is wide, 4. It grows equally at both ends: by 1 below and by 1 above.</source>
        <translation>Aken peab saama sama kõrgeks, kui see on lai, 4. See kasvab mõlemas otsas võrdselt: 1 võrra all ja 1 võrra üleval.</translation>
    </message>
    <message>
        <source>The number k</source>
        <translation>Arv k</translation>
    </message>
    <message>
        <source>Only the proportions matter: circles stay round if</source>
        <translation>Loevad ainult proportsioonid: ringid jäävad ümaraks, kui</translation>
    </message>
    <message>
        <source>Variant X keeps {0} and adds {1} at both ends of {2}:</source>
        <translation>Variant X säilitab {0} ja liidab {1} suuruse {2} mõlemas otsas:</translation>
    </message>
    <message>
        <source>Here {0}, so {1} goes from {2} to {3}. Variant Y keeps {4}: {5}, and {6} goes from {7} to {8}. **World** has {9}, {10} and {11} at the window. **Image** shows the three: stretched, variant Y, variant X. In the dock they are **Proportions**, in *More of the lens*.</source>
        <translation>Siin {0}, seega ulatub {1} kohast {2} kohani {3}. Variant Y säilitab {4}: {5}, ja {6} ulatub kohast {7} kohani {8}. Paanis **Maailm** on akna juures {9}, {10} ja {11}. **Pilt** näitab kolme: venitatud, variant Y, variant X. Külgribal on need **Proportsioonid** jaotises *Veel objektiivist*.</translation>
    </message>
    <message>
        <source>stretched</source>
        <translation>venitatud</translation>
    </message>
    <message>
        <source>variant Y</source>
        <translation>variant Y</translation>
    </message>
    <message>
        <source>variant X</source>
        <translation>variant X</translation>
    </message>
    <message>
        <source>Cubes that are cubes</source>
        <translation>Kuubid, mis on kuubid</translation>
    </message>
    <message>
        <source>The picture is stretched.</source>
        <translation>Pilt on venitatud.</translation>
    </message>
    <message>
        <source>Give the picture its right proportions: choose keep x, fit y.</source>
        <translation>Andke pildile õiged proportsioonid: valige säilita x, sobita y.</translation>
    </message>
    <message>
        <source>Find Proportions in the dock: More of the lens.</source>
        <translation>Otsige külgribalt Proportsioonid: Veel objektiivist.</translation>
    </message>
    <message>
        <source>Right: a unit of x has as many pixels as a unit of y. The fields still show the typed window.</source>
        <translation>Õige: ühes x-i ühikus on sama palju piksleid kui ühes y-i ühikus. Väljad näitavad endiselt sisestatud akent.</translation>
    </message>
    <message>
        <source>A picture twice as wide as high</source>
        <translation>Pilt, mille laius on kahekordne kõrgus</translation>
    </message>
    <message>
        <source>The window is {0} from -3 to 3, {1} from -1 to 1. The picture has 1000 by 500 pixels.</source>
        <translation>Aken on {0} -3-st 3-ni, {1} -1-st 1-ni. Pildis on 1000 korda 500 pikslit.</translation>
    </message>
    <message>
        <source>Variant X: how large is {0}?</source>
        <translation>Variant X: kui suur on {0}?</translation>
    </message>
    <message>
        <source>This adds the whole missing length at each end. Look at the picture: the window is 4 high and 6 wide now, not twice as wide as high, and the F is too low.</source>
        <translation>Nii liidetakse kummaski otsas kogu puuduv pikkus. Vaadake pilti: akna kõrgus on nüüd 4 ja laius 6, mis ei ole kahekordne kõrgus, ning F on liiga madal.</translation>
    </message>
    <message>
        <source>How high must a window be that is 6 wide, for a picture of 1000 by 500?</source>
        <translation>Kui kõrge peab olema aken laiusega 6, kui pilt on 1000 korda 500?</translation>
    </message>
    <message>
        <source>3 high, and it is 2 high now.</source>
        <translation>Kõrgus peab olema 3, aga praegu on see 2.</translation>
    </message>
    <message>
        <source>{0}, and so {1} goes from {2} to 1.5.</source>
        <translation>{0}, seega ulatub {1} kohast {2} kohani 1.5.</translation>
    </message>
    <message>
        <source>Variant Y</source>
        <translation>Variant Y</translation>
    </message>
    <message>
        <source>Variant Y keeps {0} and adds {1} at both ends of {2}: {3}. (The last line of the handout has {4} there, which is a slip.)</source>
        <translation>Variant Y säilitab {0} ja liidab {1} suuruse {2} mõlemas otsas: {3}. (Jaotusmaterjali viimasel real on seal {4}, mis on näpuviga.)</translation>
    </message>
    <message>
        <source>The window is {0} from -1 to 3, {1} from -2 to 2, the picture 1000 by 500.</source>
        <translation>Aken on {0} -1-st 3-ni, {1} -2-st 2-ni, pilt 1000 korda 500.</translation>
    </message>
    <message>
        <source>This adds the whole missing length at each end. Look at the picture: the window is 12 wide and 4 high now, not twice as wide as high, and the F is too narrow.</source>
        <translation>Nii liidetakse kummaski otsas kogu puuduv pikkus. Vaadake pilti: akna kõrgus on nüüd 4 ja laius 12, mis ei ole kahekordne kõrgus, ning F on liiga kitsas.</translation>
    </message>
    <message>
        <source>Variant Y *keeps* y. Look at variant X: it is the one that leaves x as it is, and adjusts y.</source>
        <translation>Variant Y *säilitab* y-i. Vaadake varianti X: see on see, mis jätab x-i samaks ja kohandab y-it.</translation>
    </message>
    <message>
        <source>The window must become 8 wide.</source>
        <translation>Akna laiuseks peab saama 8.</translation>
    </message>
    <message>
        <source>{0}, and so {1} goes from {2} to 5. Its middle is still 1.</source>
        <translation>{0}, seega ulatub {1} kohast {2} kohani 5. Selle keskkoht on endiselt 1.</translation>
    </message>
    <message>
        <source>X by hand</source>
        <translation>X käsitsi</translation>
    </message>
    <message>
        <source>The picture is 720 by 720 and stretched; the window is {0} from -2 to 2, {1} from -1 to 1 again.</source>
        <translation>Pilt on 720 korda 720 ja venitatud; aken on jälle {0} -2-st 2-ni, {1} -1-st 1-ni.</translation>
    </message>
    <message>
        <source>Leave Proportions at stretch, and give Bottom and Top the values that variant X would.</source>
        <translation>Jätke Proportsioonid valikule venita ning andke väljadele Alumine ja Ülemine need väärtused, mille annaks variant X.</translation>
    </message>
    <message>
        <source>The window must be as high as it is wide.</source>
        <translation>Aken peab olema sama kõrge, kui see on lai.</translation>
    </message>
    <message>
        <source>Right: keep x does exactly this, and repeats it whenever the picture changes its shape.</source>
        <translation>Õige: säilita x teeb täpselt seda ja kordab seda iga kord, kui pildi kuju muutub.</translation>
    </message>
    <message>
        <source>Back to the prediction</source>
        <translation>Tagasi ennustuse juurde</translation>
    </message>
    <message>
        <source>Two answers are tempting. The answer 3 adds 2 units at each end, so the window would be 6 high instead of 4. {0} is *half* of what is missing, because it is added twice.</source>
        <translation>Ahvatlevad on kaks vastust. Vastus 3 liidab kummaski otsas 2 ühikut, nii et akna kõrgus oleks 4 asemel 6. {0} on *pool* sellest, mis puudub, sest see liidetakse kaks korda.</translation>
    </message>
    <message>
        <source>The answer 1 leaves {0} as it is: the name of the variant sounds as if X changed. But X is what it *keeps*. With the same letter F and the same eye, X shows more of the scene above and below; Y takes away at the sides.</source>
        <translation>Vastus 1 jätab {0} samaks: variandi nimi kõlab, nagu X muutuks. Aga X on see, mida ta *säilitab*. Sama F-tähe ja sama silmaga näitab X stseenist rohkem ülal ja all; Y võtab külgedelt ära.</translation>
    </message>
    <message>
        <source>Practise: how wide does Y make it?</source>
        <translation>Harjutus: kui laiaks Y selle teeb?</translation>
    </message>
    <message>
        <source>The picture is stretched. Variant Y keeps {0}, and makes the window as wide as the picture&apos;s proportions require.</source>
        <translation>Pilt on venitatud. Variant Y säilitab {0} ja teeb akna nii laiaks, kui pildi proportsioonid nõuavad.</translation>
    </message>
    <message>
        <source>The window is {0} from {1} to {2}, {3} from {4} to {5}, the picture {6} by {7} pixels. How large is {8} in variant Y?</source>
        <translation>Aken on {0} kohast {1} kohani {2}, {3} kohast {4} kohani {5}, pilt {6} korda {7} pikslit. Kui suur on variandis Y {8}?</translation>
    </message>
    <message>
        <source>Both ends get the same share, so each gets half of what is missing. Look at variant Y: the left end moves as far as the right one.</source>
        <translation>Mõlemad otsad saavad sama palju, seega kumbki pool sellest, mis puudub. Vaadake varianti Y: vasak ots liigub sama kaugele kui parem.</translation>
    </message>
    <message>
        <source>How wide must the window be for a picture of {0} by {1}?</source>
        <translation>Kui lai peab aken olema, kui pilt on {0} korda {1}?</translation>
    </message>
    <message>
        <source>{0} wide; it is {1} wide now. Both ends get the same share.</source>
        <translation>Laius peab olema {0}; praegu on see {1}. Mõlemad otsad saavad sama palju.</translation>
    </message>
    <message>
        <source>Practise: where does X put it?</source>
        <translation>Harjutus: kuhu X selle paneb?</translation>
    </message>
    <message>
        <source>The picture is that of variant X: {0} as given, {1} adjusted. Its frame has the numbers of the pixels.</source>
        <translation>Pilt on variandi X pilt: {0} nagu antud, {1} kohandatud. Selle raamil on pikslite numbrid.</translation>
    </message>
    <message>
        <source>The given window is {0} from {1} to {2} and {3} from {4} to {5}. Mark where variant X puts the point with {6}, {7} of the near plane.</source>
        <translation>Antud aken on {0} kohast {1} kohani {2} ja {3} kohast {4} kohani {5}. Märkige, kuhu variant X paneb lähitasandi punkti, mille {6}, {7}.</translation>
    </message>
    <message>
        <source>Variant X *keeps* x. Look at variant Y: it is the one that leaves y as it is, and your place belongs to its picture.</source>
        <translation>Variant X *säilitab* x-i. Vaadake varianti Y: see on see, mis jätab y samaks, ja teie koht kuulub selle pildile.</translation>
    </message>
    <message>
        <source>Rows are counted from the top. Look at the numbers beside the frame: 0 is at the top, so a positive {0} lies in the upper half.</source>
        <translation>Ridu loetakse ülalt. Vaadake numbreid raami kõrval: 0 on üleval, nii et positiivne {0} on ülemises pooles.</translation>
    </message>
    <message>
        <source>In variant X the window reaches from {0} to {1} in x. How far does it reach in y?</source>
        <translation>Variandis X ulatub aken x-sihis kohast {0} kohani {1}. Kui kaugele see y-sihis ulatub?</translation>
    </message>
    <message>
        <source>Its height and width are as {0} to {1}, so {2}.</source>
        <translation>Selle kõrguse ja laiuse suhe on {0} ja {1}, seega {2}.</translation>
    </message>
    <message>
        <source>{0}. From the middle, the place is {1} of half the width to the right, and {2} of half the height up.</source>
        <translation>{0}. Keskkohast on see koht paremale {1} poolest laiusest ja üles {2} poolest kõrgusest.</translation>
    </message>
    <message>
        <source>Practise: X by hand</source>
        <translation>Harjutus: X käsitsi</translation>
    </message>
    <message>
        <source>*Proportions*, in *More of the lens*, stay at stretch.</source>
        <translation>*Proportsioonid* jaotises *Veel objektiivist* jäävad valikule venita.</translation>
    </message>
    <message>
        <source>The picture has {0} by 600 pixels. Give *Bottom* and *Top* the values {1} and {2} of variant X.</source>
        <translation>Pildis on {0} korda 600 pikslit. Andke väljadele *Alumine* ja *Ülemine* variandi X väärtused {1} ja {2}.</translation>
    </message>
    <message>
        <source>How high must a window be that is {0} wide, for {1} by 600 pixels?</source>
        <translation>Kui kõrge peab olema aken laiusega {0}, kui piksleid on {1} korda 600?</translation>
    </message>
    <message>
        <source>{0} high; it is {1} high now. Both ends get the same share.</source>
        <translation>Kõrgus peab olema {0}; praegu on see {1}. Mõlemad otsad saavad sama palju.</translation>
    </message>
    <message>
        <source>{0} {1}. Half of it goes to each end: {2} and {3}.</source>
        <translation>{0} {1}. Pool sellest läheb kumbagi otsa: {2} ja {3}.</translation>
    </message>
    <message>
        <source>Both ends get the same share, so each gets half of what is missing. Look at variant X: the F has its proportions again.</source>
        <translation>Mõlemad otsad saavad sama palju, seega kumbki pool sellest, mis puudub. Vaadake varianti X: F-il on jälle õiged proportsioonid.</translation>
    </message>
    <message>
        <source>Variant X *keeps* x, and you have changed it. Look at variant Y: it adjusts x as you did.</source>
        <translation>Variant X *säilitab* x-i, aga te olete seda muutnud. Vaadake varianti Y: see kohandab x-i nii, nagu teie tegite.</translation>
    </message>
</context>
<context>
    <name>l08-depth-not-affine</name>
    <message>
        <source>Why not Az + B for the depth?</source>
        <translation>Miks mitte Az + B sügavuse jaoks?</translation>
    </message>
    <message>
        <source>A straight segment in the cube</source>
        <translation>Sirge lõik kuubis</translation>
    </message>
    <message>
        <source>In space PQ is straight, and both ends are 6 units deep. {0} and {1} are divided by {2}. The depth could just be scaled and shifted, {3}, so that near comes to {4} and far to {5}. With both ends equally deep the segment is still straight in **NDC**: the deviation in the dock is 0 %. Now P will come nearer, to a depth of 2.</source>
        <translation>Ruumis on PQ sirge ja mõlema otsa sügavus on 6 ühikut. {0} ja {1} jagatakse suurusega {2}. Sügavust võiks ainult skaleerida ja nihutada, {3}, nii et lähitasand satub kohale {4} ja kaugtasand kohale {5}. Kui mõlemad otsad on ühel sügavusel, on lõik paanis **NDC** endiselt sirge: kõrvalekalle külgribal on 0 %. Nüüd tuleb P lähemale, sügavusele 2.</translation>
    </message>
    <message>
        <source>What does {0} make of the straight segment PQ then?</source>
        <translation>Mille teeb {0} siis sirgest lõigust PQ?</translation>
    </message>
    <message>
        <source>A straight segment: scaling and shifting bend nothing</source>
        <translation>Sirge lõigu: skaleerimine ja nihutamine ei kõverda midagi</translation>
    </message>
    <message>
        <source>Az + B bends nothing</source>
        <translation>Az + B ei kõverda midagi</translation>
    </message>
    <message>
        <source>They bend nothing in space. But {0} and {1} are divided by {2} and the depth is not, so halfway between the images of P and Q the depth is not halfway. Look at the line {3}: it is bent.</source>
        <translation>Ruumis need ei kõverda midagi. Aga {0} ja {1} jagatakse suurusega {2} ja sügavust ei jagata, nii et P ja Q kujutiste vahel poolel teel ei ole sügavus poolel teel. Vaadake joont {3}: see on kõver.</translation>
    </message>
    <message>
        <source>A bow</source>
        <translation>Kaare</translation>
    </message>
    <message>
        <source>A straight segment, but from other ends</source>
        <translation>Sirge lõigu, aga teistest otstest</translation>
    </message>
    <message>
        <source>The ends are right: near and far come to −1 and 1 either way. What changes lies between them. Look at the two lines: they have the same ends.</source>
        <translation>Otsad on õiged: lähi- ja kaugtasand satuvad mõlemal juhul kohtadele −1 ja 1. Muutub see, mis on nende vahel. Vaadake kaht joont: neil on samad otsad.</translation>
    </message>
    <message>
        <source>x and y are divided, but z is not. Along the image of PQ the depth does not grow evenly.</source>
        <translation>x ja y jagatakse, aga z-i mitte. Piki PQ kujutist ei kasva sügavus ühtlaselt.</translation>
    </message>
    <message>
        <source>The middle of the picture</source>
        <translation>Pildi keskkoht</translation>
    </message>
    <message>
        <source>P is 2 deep, Q is 6 deep, {0}, {1}. Halfway between their images the depth is not 4. {2} changes evenly on the screen, so the depth there is {3}.</source>
        <translation>P sügavus on 2, Q sügavus 6, {0}, {1}. Nende kujutiste vahel poolel teel ei ole sügavus 4. Ekraanil muutub ühtlaselt {2}, seega on sügavus seal {3}.</translation>
    </message>
    <message>
        <source>depth</source>
        <translation>sügavus</translation>
    </message>
    <message>
        <source>middle of the ends</source>
        <translation>otste keskkoht</translation>
    </message>
    <message>
        <source>scaled and shifted</source>
        <translation>skaleeritud ja nihutatud</translation>
    </message>
    <message>
        <source>divided as well</source>
        <translation>ka jagatud</translation>
    </message>
    <message>
        <source>In the first row, 3 does not come to the middle of the ends; in the second it does:</source>
        <translation>Esimeses reas ei satu 3 otste keskkohta; teises satub:</translation>
    </message>
    <message>
        <source>with {0}, {1}.</source>
        <translation>kus {0}, {1}.</translation>
    </message>
    <message>
        <source>Bend it</source>
        <translation>Kõverdage seda</translation>
    </message>
    <message>
        <source>Both ends are 6 deep again. Drag P and Q in **World**, or type them.</source>
        <translation>Mõlema otsa sügavus on jälle 6. Lohistage P ja Q paanis **Maailm** või sisestage need.</translation>
    </message>
    <message>
        <source>Make the bow deviate by more than 5 % of its length.</source>
        <translation>Tehke nii, et kaar kaldub kõrvale rohkem kui 5 % oma pikkusest.</translation>
    </message>
    <message>
        <source>If both ends are equally deep, nothing is bent.</source>
        <translation>Kui mõlemad otsad on ühel sügavusel, ei kõverdu midagi.</translation>
    </message>
    <message>
        <source>Bring P nearer to the eye: larger z.</source>
        <translation>Tooge P silmale lähemale: suurem z.</translation>
    </message>
    <message>
        <source>Right: the larger the ratio of the two depths, the more the segment is bent.</source>
        <translation>Õige: mida suurem on kahe sügavuse suhe, seda rohkem lõik kõverdub.</translation>
    </message>
    <message>
        <source>The depth of a point</source>
        <translation>Punkti sügavus</translation>
    </message>
    <message>
        <source>Now the planes are {0} and {1}, and a point is 4 units deep, {2}.</source>
        <translation>Nüüd on tasandid {0} ja {1} ning ühe punkti sügavus on 4 ühikut, {2}.</translation>
    </message>
    <message>
        <source>How large is {0} of the perspective projection?</source>
        <translation>Kui suur on perspektiivse projektsiooni {0}?</translation>
    </message>
    <message>
        <source>This spreads the depth evenly between the planes. But {0} changes with {1}, fast just behind near. Look at point 1, 4 deep, in the cube: it is beyond the middle.</source>
        <translation>Nii jaotatakse sügavus tasandite vahel ühtlaselt. Aga {0} muutub koos suurusega {1}, kohe lähitasandi taga kiiresti. Vaadake kuubis punkti 1, mille sügavus on 4: see on keskkohast kaugemal.</translation>
    </message>
    <message>
        <source>This stops before the division by {0}. Look at point 1, 4 deep, in the cube: it is inside, so its {1} is less than 1.</source>
        <translation>Nii jäädakse pooleli enne jagamist: {0}. Vaadake kuubis punkti 1, mille sügavus on 4: see on sees, seega on selle {1} väiksem kui 1.</translation>
    </message>
    <message>
        <source>Az + B = 8/6. It is not yet divided.</source>
        <translation>Az + B = 8/6. See ei ole veel jagatud.</translation>
    </message>
    <message>
        <source>The middle of the cube</source>
        <translation>Kuubi keskkoht</translation>
    </message>
    <message>
        <source>The planes are the same: {0}, {1}.</source>
        <translation>Tasandid on samad: {0}, {1}.</translation>
    </message>
    <message>
        <source>How deep is the point with {0}?</source>
        <translation>Kui sügaval on punkt, mille {0}?</translation>
    </message>
    <message>
        <source>This is the middle in the world. Look at point 1, 5 deep, in the cube: it is beyond the middle.</source>
        <translation>See on keskkoht maailmas. Vaadake kuubis punkti 1, mille sügavus on 5: see on keskkohast kaugemal.</translation>
    </message>
    <message>
        <source>-A - B/z = 0</source>
        <translation>-A - B/z = 0</translation>
    </message>
    <message>
        <source>{0}, and its depth is {1}. The first half of the cube ends there.</source>
        <translation>{0} ja selle sügavus on {1}. Seal lõpeb kuubi esimene pool.</translation>
    </message>
    <message>
        <source>Place the middle</source>
        <translation>Paigutage keskkoht</translation>
    </message>
    <message>
        <source>Probe 1 is 4 units deep; near is 1 and far is 9.</source>
        <translation>Sondi 1 sügavus on 4 ühikut; lähitasand on 1 ja kaugtasand 9.</translation>
    </message>
    <message>
        <source>Set near and far so that probe 1, at depth 4, comes to the middle of the cube: z&apos; = 0.</source>
        <translation>Seadke lähi- ja kaugtasand nii, et sond 1, mille sügavus on 4, satub kuubi keskele: z&apos; = 0.</translation>
    </message>
    <message>
        <source>Use 1/z: 1/4 must be halfway between 1/near and 1/far.</source>
        <translation>Kasutage suurust 1/z: 1/4 peab olema poolel teel 1/near ja 1/far vahel.</translation>
    </message>
    <message>
        <source>With far at 9, near must be 2.57; with near at 3, far must be 6.</source>
        <translation>Kui kaugtasand on 9, peab lähitasand olema 2.57; kui lähitasand on 3, peab kaugtasand olema 6.</translation>
    </message>
    <message>
        <source>Right: 2nf/(n + f) = 4.</source>
        <translation>Õige: 2nf/(n + f) = 4.</translation>
    </message>
    <message>
        <source>Back to the prediction</source>
        <translation>Tagasi ennustuse juurde</translation>
    </message>
    <message>
        <source>It is tempting to trust {0}, because in space it bends nothing. But after {1} and {2} are divided by {3}, equal steps along the picture are unequal steps of depth, and a straight line stays straight only if the depth is divided as well.</source>
        <translation>Ahvatlev on usaldada avaldist {0}, sest ruumis see midagi ei kõverda. Aga kui {1} ja {2} on jagatud suurusega {3}, on võrdsed sammud piki pilti ebavõrdsed sügavuse sammud ja sirge jääb sirgeks ainult siis, kui ka sügavus jagatakse.</translation>
    </message>
    <message>
        <source>Bent lines would spoil the depth buffer: between the corners of a triangle, depths are interpolated evenly over the pixels. The computed depth would not be the true one, and a surface behind could be drawn in front.</source>
        <translation>Kõverad jooned rikuksid sügavuspuhvri: kolmnurga nurkade vahel interpoleeritakse sügavusi pikslite kaupa ühtlaselt. Arvutatud sügavus ei oleks õige ja taga olev pind võidaks joonistada ette.</translation>
    </message>
    <message>
        <source>Practise: the depth of a point</source>
        <translation>Harjutus: punkti sügavus</translation>
    </message>
    <message>
        <source>The planes are at the depths {0} and {1}. In the cube they come to {2} and {3}.</source>
        <translation>Tasandid on sügavustel {0} ja {1}. Kuubis satuvad need kohtadele {2} ja {3}.</translation>
    </message>
    <message>
        <source>Here {0} and {1}. Point 1 is at {2}. How large is its {3}?</source>
        <translation>Siin {0} ja {1}. Punkt 1 on kohal {2}. Kui suur on selle {3}?</translation>
    </message>
    <message>
        <source>This spreads the depth evenly between the planes. But {0} changes with {1}, fast just behind near. Look at point 1, moved to where {2}: it is closer to near than to far.</source>
        <translation>Nii jaotatakse sügavus tasandite vahel ühtlaselt. Aga {0} muutub koos suurusega {1}, kohe lähitasandi taga kiiresti. Vaadake punkti 1, mis on viidud kohta, kus {2}: see on lähitasandile lähemal kui kaugtasandile.</translation>
    </message>
    <message>
        <source>This stops before the division by {0}. Look at point 1, moved to far: there {1} is {2}, and only the division makes it 1.</source>
        <translation>Nii jäädakse pooleli enne jagamist suurusega {0}. Vaadake punkti 1, mis on viidud kaugtasandile: seal on {1} võrdne arvuga {2} ja alles jagamine teeb sellest 1.</translation>
    </message>
    <message>
        <source>{0}, with {1} and {2}.</source>
        <translation>{0}, kus {1} ja {2}.</translation>
    </message>
    <message>
        <source>Practise: the middle of the cube</source>
        <translation>Harjutus: kuubi keskkoht</translation>
    </message>
    <message>
        <source>You see the segment PQ from the side. P is on the near plane, and Q on the far plane.</source>
        <translation>Näete lõiku PQ küljelt. P on lähitasandil ja Q kaugtasandil.</translation>
    </message>
    <message>
        <source>Near is {0} and far is {1}. Which point of PQ comes to {2} in the cube? Mark it.</source>
        <translation>Lähitasand on {0} ja kaugtasand {1}. Milline PQ punkt satub kuubis kohale {2}? Märkige see.</translation>
    </message>
    <message>
        <source>This is the middle of PQ in the world. But {0} changes with {1}, fast just behind near. Look at point 1: it is the place that you marked, and the cube&apos;s middle lies before it.</source>
        <translation>See on PQ keskkoht maailmas. Aga {0} muutub koos suurusega {1}, kohe lähitasandi taga kiiresti. Vaadake punkti 1: see on teie märgitud koht ja kuubi keskkoht jääb sellest ettepoole.</translation>
    </message>
    <message>
        <source>At which depth is {0}?</source>
        <translation>Millisel sügavusel kehtib {0}?</translation>
    </message>
    <message>
        <source>At {0}, which is {1} deep.</source>
        <translation>Kohal {0}, mille sügavus on {1}.</translation>
    </message>
    <message>
        <source>It is {0} deep.</source>
        <translation>Selle sügavus on {0}.</translation>
    </message>
    <message>
        <source>Practise: place the middle</source>
        <translation>Harjutus: paigutage keskkoht</translation>
    </message>
    <message>
        <source>**World** shows the planes and probe 1 from the side.</source>
        <translation>**Maailm** näitab tasandeid ja sondi 1 küljelt.</translation>
    </message>
    <message>
        <source>Probe 1 is {0} deep. Leave far at {1}, and set near so that the depth {2} comes to {3}.</source>
        <translation>Sondi 1 sügavus on {0}. Jätke kaugtasandiks {1} ja seadke lähitasand nii, et sügavus {2} satub kohale {3}.</translation>
    </message>
    <message>
        <source>The middle of the cube is {0} deep.</source>
        <translation>Kuubi keskkoha sügavus on {0}.</translation>
    </message>
    <message>
        <source>So {0} is halfway between {1} and {2}.</source>
        <translation>Seega on {0} poolel teel {1} ja {2} vahel.</translation>
    </message>
    <message>
        <source>{0}, so {1} {2} {3}, more than half of {4}.</source>
        <translation>{0}, seega {1} {2} {3}, rohkem kui pool arvust {4}.</translation>
    </message>
    <message>
        <source>This puts the point half-way between the planes in the world. But {0} changes with {1}. Look at the planes: the cube&apos;s middle is nearer to near than the point is.</source>
        <translation>Nii satub punkt maailmas tasandite vahel poolele teele. Aga {0} muutub koos suurusega {1}. Vaadake tasandeid: kuubi keskkoht on lähitasandile lähemal kui punkt.</translation>
    </message>
</context>
<context>
    <name>l09-pyramid-to-cube</name>
    <message>
        <source>From the pyramid to the cube</source>
        <translation>Püramiidist kuubiks</translation>
    </message>
    <message>
        <source>Where does the near plane go?</source>
        <translation>Kuhu läheb lähitasand?</translation>
    </message>
    <message>
        <source>Every lens has a volume of its own. Lecture 001 brings them all into one pyramid first: {0} moves the far plane to {1} and the sides of the picture to {2}. Here {3} and {4}, and the strip under the large cube is at *View*.</source>
        <translation>Igal objektiivil on oma nähtav ruum. Loeng 001 viib need kõik enne ühte püramiidi: {0} viib kaugtasandi kohta {1} ja pildi küljed kohta {2}. Siin {3} ja {4} ning suure kuubi all olev riba on peatuses *Vaade*.</translation>
    </message>
    <message>
        <source>The strip goes on to *Pyramid*: the far plane moves from {0} to {1}. Where does the near plane go?</source>
        <translation>Riba läheb edasi peatusse *Püramiid*: kaugtasand liigub kohast {0} kohta {1}. Kuhu läheb lähitasand?</translation>
    </message>
    <message>
        <source>It stays at z = −1</source>
        <translation>See jääb kohale z = −1</translation>
    </message>
    <message>
        <source>{0} divides every depth by {1}, not only far&apos;s. Look at near: it is at −0.111, close to the eye.</source>
        <translation>{0} jagab arvuga {1} iga sügavuse, mitte ainult kaugtasandi oma. Vaadake lähitasandit: see on kohal −0.111, silma lähedal.</translation>
    </message>
    <message>
        <source>At z = −0.111</source>
        <translation>Kohale z = −0.111</translation>
    </message>
    <message>
        <source>At z = 0, with the eye</source>
        <translation>Kohale z = 0, silma</translation>
    </message>
    <message>
        <source>{0} is the eye. {1} only scales: a plane that is in front of the eye stays in front of it. Look at near and the eye: they are 0.111 apart.</source>
        <translation>{0} on silm. {1} ainult skaleerib: silma ees olev tasand jääb selle ette. Vaadake lähitasandit ja silma: nende vahe on 0.111.</translation>
    </message>
    <message>
        <source>{0} only scales. All depths are divided by {1}, so the near plane is at {2}, and the eye stays at 0.</source>
        <translation>{0} ainult skaleerib. Kõik sügavused jagatakse suurusega {1}, seega on lähitasand kohal {2} ja silm jääb kohale 0.</translation>
    </message>
    <message>
        <source>The two factors</source>
        <translation>Kaks tegurit</translation>
    </message>
    <message>
        <source>*Matrices* shows the chain in the lecture&apos;s letters and highlights the matrix of the strip&apos;s stop. {0} divides z by {1}: here {2}.</source>
        <translation>*Maatriksid* näitab ahelat loengu tähtedega ja tõstab esile riba peatuse maatriksi. {0} jagab z-i suurusega {1}: siin {2}.</translation>
    </message>
    <message>
        <source>{0} turns the pyramid into a box. Its third row ends in {1} and {2}, here 1.125 and 0.125, and its last row gives {3}. Try it on both planes:</source>
        <translation>{0} teeb püramiidist risttahuka. Selle kolmanda rea lõpus on {1} ja {2}, siin 1.125 ja 0.125, ning viimane rida annab {3}. Proovige mõlema tasandiga:</translation>
    </message>
    <message>
        <source>z</source>
        <translation>z</translation>
    </message>
    <message>
        <source>numerator</source>
        <translation>lugeja</translation>
    </message>
    <message>
        <source>w</source>
        <translation>w</translation>
    </message>
    <message>
        <source>z of the box</source>
        <translation>risttahuka z</translation>
    </message>
    <message>
        <source>c</source>
        <translation>c</translation>
    </message>
    <message>
        <source>{0} takes 0 … −1 to OpenGL&apos;s −1 … 1: {1}. Click *Pyramid*, *Box* and *NDC* under the cube.</source>
        <translation>{0} viib vahemiku 0 … −1 OpenGL-i vahemikku −1 … 1: {1}. Klõpsake kuubi all *Püramiid*, *Risttahukas* ja *NDC*.</translation>
    </message>
    <message>
        <source>The product</source>
        <translation>Korrutis</translation>
    </message>
    <message>
        <source>Each stop of the strip is a place, and each factor leads from one to the next. A point {0} of view space goes through all of them: what it meets first stands on the right, next to it.</source>
        <translation>Riba iga peatus on koht ja iga tegur viib ühest järgmisse. Kaamerafreimi punkt {0} läbib need kõik: millega see kohtub esimesena, on paremal, selle kõrval.</translation>
    </message>
    <message>
        <source>Which volume does each factor start from: the lens&apos;s own, the pyramid or the box?</source>
        <translation>Millisest ruumist iga tegur alustab: objektiivi enda nähtavast ruumist, püramiidist või risttahukast?</translation>
    </message>
    <message>
        <source>{0} starts from the lens&apos;s own volume, {1} from the pyramid, and {2} from the box: {3}.</source>
        <translation>{0} alustab objektiivi enda nähtavast ruumist, {1} püramiidist ja {2} risttahukast: {3}.</translation>
    </message>
    <message>
        <source>Half-way through the box</source>
        <translation>Risttahuka sees poolel teel</translation>
    </message>
    <message>
        <source>Probe 1 is pinned to a point of the F, 7.5 in front of the eye. {0} in the box is {1} in NDC; the Probe panel shows it.</source>
        <translation>Sond 1 on fikseeritud F-i punktis, mis on silmast 7.5 eespool. {0} risttahuka sees on NDC-s {1}; seda näitab paneel Sond.</translation>
    </message>
    <message>
        <source>Bring point 1 to z = −1/2 of the box, by near and far, by the camera, or by the point itself.</source>
        <translation>Viige punkt 1 risttahuka sees kohta z = −1/2: lähi- ja kaugtasandiga, kaameraga või punkti endaga.</translation>
    </message>
    <message>
        <source>With near = 6 the point is half-way between the planes in the world. Where is it in the box then?</source>
        <translation>Kui lähitasand = 6, on punkt maailmas tasandite vahel poolel teel. Kus on see siis risttahuka sees?</translation>
    </message>
    <message>
        <source>{0} at the depth {1}, which is nearer to {2} than to {3}.</source>
        <translation>{0} on sügavusel {1}, mis on suurusele {2} lähemal kui suurusele {3}.</translation>
    </message>
    <message>
        <source>The middle of the box is not the middle of the pyramid: the space close behind near fills half of the box.</source>
        <translation>Risttahuka keskkoht ei ole püramiidi keskkoht: ruum kohe lähitasandi taga täidab poole risttahukast.</translation>
    </message>
    <message>
        <source>The cells of the chain</source>
        <translation>Ahela lahtrid</translation>
    </message>
    <message>
        <source>Compute before you open *Matrices*. In this step {0} and {1}.</source>
        <translation>Arvutage, enne kui avate *Maatriksid*. Selles sammus {0} ja {1}.</translation>
    </message>
    <message>
        <source>What is in row 3, column 4 of {0}?</source>
        <translation>Mis on maatriksi {0} reas 3 ja veerus 4?</translation>
    </message>
    <message>
        <source>This takes {0}. On the way into the pyramid every depth is divided by {1}. Look at near: it is closer to the eye, at {2}.</source>
        <translation>Nii võetakse {0}. Teel püramiidi jagatakse iga sügavus suurusega {1}. Vaadake lähitasandit: see on silmale lähemal, kohal {2}.</translation>
    </message>
    <message>
        <source>This swaps {0} and {1}. Look at the box: near comes to 0 and far to {2}; swapped, they would change places.</source>
        <translation>Nii vahetatakse {0} ja {1}. Vaadake risttahukat: lähitasand satub kohale 0 ja kaugtasand kohale {2}; vahetatult oleksid need vastupidi.</translation>
    </message>
    <message>
        <source>{0} with {1}.</source>
        <translation>{0}, kus {1}.</translation>
    </message>
    <message>
        <source>{0}, here 0.5/8.5.</source>
        <translation>{0}, siin 0.5/8.5.</translation>
    </message>
    <message>
        <source>And in row 3, column 3 of the product {0}?</source>
        <translation>Ja korrutise {0} reas 3 ja veerus 3?</translation>
    </message>
    <message>
        <source>{0} acts first, so it stands on the right. Look at the box that it makes: only then does {1} stretch its depth from 0 … −1 to −1 … 1.</source>
        <translation>{0} mõjub esimesena, seega on see paremal. Vaadake risttahukat, mille see teeb: alles siis venitab {1} selle sügavuse vahemikust 0 … −1 vahemikku −1 … 1.</translation>
    </message>
    <message>
        <source>This swaps {0} and {1}. Look at the cube: near comes to {2} and far to 1; swapped, they would change places.</source>
        <translation>Nii vahetatakse {0} ja {1}. Vaadake kuupi: lähitasand satub kohale {2} ja kaugtasand kohale 1; vahetatult oleksid need vastupidi.</translation>
    </message>
    <message>
        <source>Third row of {0} times third column of {1}: {2} times one cell, and {3} times another.</source>
        <translation>Maatriksi {0} kolmas rida korda maatriksi {1} kolmas veerg: {2} korda üks lahter ja {3} korda teine.</translation>
    </message>
    <message>
        <source>{0}. That is {1}, which other lectures derive in one step.</source>
        <translation>{0}. See on {1}, mille teised loengud tuletavad ühe sammuga.</translation>
    </message>
    <message>
        <source>A near plane of your choice</source>
        <translation>Lähitasand teie valikul</translation>
    </message>
    <message>
        <source>The pyramid keeps its shape for every lens. Only {0} differs.</source>
        <translation>Püramiid säilitab oma kuju iga objektiivi jaoks. Erineb ainult {0}.</translation>
    </message>
    <message>
        <source>Set near or far so that the near plane is at z = −0.2 in the pyramid.</source>
        <translation>Seadke lähi- või kaugtasand nii, et lähitasand on püramiidis kohal z = −0.2.</translation>
    </message>
    <message>
        <source>The title of the large pane shows {0}.</source>
        <translation>Suure paani pealkiri näitab {0}.</translation>
    </message>
    <message>
        <source>In {0} only the quotient matters: 1.8 to 9 gives the same pyramid as 1 to 5.</source>
        <translation>Avaldises {0} loeb ainult jagatis: 1.8 ja 9 annavad sama püramiidi mis 1 ja 5.</translation>
    </message>
    <message>
        <source>Back to the prediction</source>
        <translation>Tagasi ennustuse juurde</translation>
    </message>
    <message>
        <source>It is tempting to leave the near plane where it is, at {0}, because the step is about far. But a matrix that scales z moves every depth; if near stayed, it would lie on far. Only the quotient {1} of the two distances remains, and {2} is made of it. Let the strip run from *World* to *NDC* once more: in the pyramid the near plane is 0.111 from the eye, and in the end it is a whole face of the cube.</source>
        <translation>Ahvatlev on jätta lähitasand oma kohale {0}, sest see samm käib kaugtasandi kohta. Aga maatriks, mis z-i skaleerib, liigutab iga sügavust; kui lähitasand paigale jääks, oleks see kaugtasandil. Alles jääb ainult kahe kauguse jagatis {1} ja sellest koosneb {2}. Laske ribal veel kord peatusest *Maailm* peatuseni *NDC* joosta: püramiidis on lähitasand silmast 0.111 kaugusel ja lõpus on see terve kuubi tahk.</translation>
    </message>
    <message>
        <source>Practise: from the pyramid to the box</source>
        <translation>Harjutus: püramiidist risttahukaks</translation>
    </message>
    <message>
        <source>{0} takes the pyramid, whose near plane is at {1} and whose far plane is at {2}, to a box from 0 to {3}.</source>
        <translation>{0} teeb püramiidist, mille lähitasand on kohal {1} ja kaugtasand kohal {2}, risttahuka kohast 0 kohani {3}.</translation>
    </message>
    <message>
        <source>The near plane is {0} in front of the eye, the far plane {1}. What is in row 3 of {2}?</source>
        <translation>Lähitasand on silmast {0} eespool, kaugtasand {1}. Mis on maatriksi {2} reas 3?</translation>
    </message>
    <message>
        <source>This takes {0}. On the way into the pyramid every depth is divided by {1}. Look at near: it is at {2}.</source>
        <translation>Nii võetakse {0}. Teel püramiidi jagatakse iga sügavus suurusega {1}. Vaadake lähitasandit: see on kohal {2}.</translation>
    </message>
    <message>
        <source>The row ends in {0} and {1}.</source>
        <translation>Rea lõpus on {0} ja {1}.</translation>
    </message>
    <message>
        <source>{0} and {1} with {2}: near comes to 0, and far to {3}.</source>
        <translation>{0} ja {1}, kus {2}: lähitasand satub kohale 0 ja kaugtasand kohale {3}.</translation>
    </message>
    <message>
        <source>Practise: from the pyramid to the cube</source>
        <translation>Harjutus: püramiidist kuubiks</translation>
    </message>
    <message>
        <source>{0} takes the box, from 0 to {1}, to OpenGL&apos;s depths from {2} to {3}: {4}, and {5} stays. {6} comes first.</source>
        <translation>{0} viib risttahuka kohast 0 kohani {1} OpenGL-i sügavustele kohast {2} kohani {3}: {4}, ja {5} jääb samaks. Esimesena tuleb {6}.</translation>
    </message>
    <message>
        <source>With {0} and {1}, what is in rows 3 and 4, columns 3 and 4 of the product {2}?</source>
        <translation>Kui {0} ja {1}, mis on korrutise {2} ridades 3 ja 4, veergudes 3 ja 4?</translation>
    </message>
    <message>
        <source>{0} acts first, so it stands on the right. Look at the box that it makes: only then does {1} stretch its depth.</source>
        <translation>{0} mõjub esimesena, seega on see paremal. Vaadake risttahukat, mille see teeb: alles siis venitab {1} selle sügavust.</translation>
    </message>
    <message>
        <source>In these rows and columns {0} is {1} above {2}.</source>
        <translation>Nendes ridades ja veergudes on {0} {1} ja selle all {2}.</translation>
    </message>
    <message>
        <source>{0} is {1} above {2} there.</source>
        <translation>{0} on seal {1} ja selle all {2}.</translation>
    </message>
    <message>
        <source>Row 3 of {0} takes {1} times row 3 of {2} and {3} times its row 4.</source>
        <translation>Maatriksi {0} rida 3 võtab {1} korda maatriksi {2} rida 3 ja {3} korda selle rida 4.</translation>
    </message>
    <message>
        <source>Practise: choose the pyramid</source>
        <translation>Harjutus: valige püramiid</translation>
    </message>
    <message>
        <source>In the canonical pyramid the far plane is at {0}. The lens decides where the near plane is.</source>
        <translation>Kanoonilises püramiidis on kaugtasand kohal {0}. Kus on lähitasand, otsustab objektiiv.</translation>
    </message>
    <message>
        <source>Set near or far so that the near plane is at {0} in the pyramid.</source>
        <translation>Seadke lähi- või kaugtasand nii, et lähitasand on püramiidis kohal {0}.</translation>
    </message>
    <message>
        <source>All depths are divided by {0} on the way into the pyramid.</source>
        <translation>Teel püramiidi jagatakse kõik sügavused suurusega {0}.</translation>
    </message>
    <message>
        <source>{0}: only the quotient of the two distances matters. If far stays at {1}, near is {2}.</source>
        <translation>{0}: loeb ainult kahe kauguse jagatis. Kui kaugtasandiks jääb {1}, on lähitasand {2}.</translation>
    </message>
    <message>
        <source>This puts near {0} in front of the eye in the world. All depths are divided by {1} on the way into the pyramid. Look at near: it is far too close, at {2}/{3} in the pyramid.</source>
        <translation>Nii on lähitasand maailmas silmast {0} eespool. Teel püramiidi jagatakse kõik sügavused suurusega {1}. Vaadake lähitasandit: see on palju liiga lähedal, püramiidis kohal {2}/{3}.</translation>
    </message>
    <message>
        <source>Practise: build the product</source>
        <translation>Harjutus: pange korrutis kokku</translation>
    </message>
    <message>
        <source>Put the tiles in order, and leave out what does not belong.</source>
        <translation>Seadke lülid järjekorda ja jätke välja see, mis sinna ei kuulu.</translation>
    </message>
    <message>
        <source>{0} and {1}. Which chain leads from view space to NDC?</source>
        <translation>{0} ja {1}. Milline ahel viib kaamerafreimist NDC-sse?</translation>
    </message>
    <message>
        <source>The box has near at {0} and far at {1}. Another program wants near at {2} and far at {3}. Which chain is its {4}?</source>
        <translation>Risttahuka lähitasand on kohal {0} ja kaugtasand kohal {1}. Teine programm tahab lähitasandit kohale {2} ja kaugtasandit kohale {3}. Milline ahel on selle {4}?</translation>
    </message>
    <message>
        <source>The eye is at {0}, {1} and {2}. Which chain takes a point of the world to NDC, up to the division?</source>
        <translation>Silm on kohal {0}, {1} ja {2}. Milline ahel viib maailma punkti NDC-sse, kuni jagamiseni?</translation>
    </message>
    <message>
        <source>{0} takes the pyramid to the box. What makes the pyramid?</source>
        <translation>{0} teeb püramiidist risttahuka. Mis teeb püramiidi?</translation>
    </message>
    <message>
        <source>Which chain leads from *View* to *NDC*?</source>
        <translation>Milline ahel viib peatusest *Vaade* peatusse *NDC*?</translation>
    </message>
    <message>
        <source>{0} makes the pyramid, {1} turns it into the box, and {2} stretches its depths.</source>
        <translation>{0} teeb püramiidi, {1} teeb sellest risttahuka ja {2} venitab selle sügavusi.</translation>
    </message>
    <message>
        <source>Where does near, at 0, come to? The scale leaves it at 0.</source>
        <translation>Kuhu satub lähitasand, mis on kohal 0? Skaleerimine jätab selle kohale 0.</translation>
    </message>
    <message>
        <source>Far is at {0}: the scale takes it to minus its factor.</source>
        <translation>Kaugtasand on kohal {0}: skaleerimine viib selle kohta, mis on miinus kordaja.</translation>
    </message>
    <message>
        <source>{0}: the scale acts first, and the move takes near from 0 to {1}.</source>
        <translation>{0}: skaleerimine mõjub esimesena ja nihe viib lähitasandi kohast 0 kohta {1}.</translation>
    </message>
    <message>
        <source>The lens needs points in view space.</source>
        <translation>Objektiiv vajab punkte kaamerafreimis.</translation>
    </message>
    <message>
        <source>The view matrix comes first, because the lens&apos;s matrices are made for view space.</source>
        <translation>Vaatemaatriks tuleb esimesena, sest objektiivi maatriksid on tehtud kaamerafreimi jaoks.</translation>
    </message>
</context>
<context>
    <name>l10-parallel-lens</name>
    <message>
        <source>What does depth do in a parallel lens?</source>
        <translation>Mida teeb sügavus paralleelses objektiivis?</translation>
    </message>
    <message>
        <source>Twice as far away</source>
        <translation>Kaks korda kaugemal</translation>
    </message>
    <message>
        <source>Post 1 is 5 units in front of the eye, post 2 is 9.8, and both are equally high. With the perspective lens, post 2 is drawn about half as high (0.51 times): look at *Image*.</source>
        <translation>Post 1 on silmast 5 ühikut eespool, post 2 9.8, ja mõlemad on ühekõrgused. Perspektiivne objektiiv joonistab posti 2 umbes poole madalamana (0.51 korda): vaadake paani *Pilt*.</translation>
    </message>
    <message>
        <source>The lens becomes orthographic; camera and posts stay. How many times as high as post 1 is post 2 drawn now?</source>
        <translation>Objektiivist saab ortograafiline; kaamera ja postid jäävad paigale. Mitu korda kõrgemana kui post 1 joonistatakse nüüd post 2?</translation>
    </message>
    <message>
        <source>1 times: both are equally high</source>
        <translation>1 kord: mõlemad on ühekõrgused</translation>
    </message>
    <message>
        <source>0.51 times, as before</source>
        <translation>0.51 korda, nagu enne</translation>
    </message>
    <message>
        <source>This divides by the depth, as the perspective lens does. The projectors of a parallel lens do not meet, so its pictures are not divided by anything: equal heights stay equal at every depth. Look at the two posts: they are equally high.</source>
        <translation>Nii jagatakse sügavusega, nagu teeb perspektiivne objektiiv. Paralleelse objektiivi projektsioonikiired ei kohtu, seepärast ei jagata selle pilte millegagi: võrdsed kõrgused jäävad igal sügavusel võrdseks. Vaadake kaht posti: need on ühekõrgused.</translation>
    </message>
    <message>
        <source>More than half, but not as high</source>
        <translation>Rohkem kui pool, aga mitte sama kõrge</translation>
    </message>
    <message>
        <source>There is nothing in between: the lens either divides by the depth, or not. The orthographic one does not. Look at the two posts: they are equally high.</source>
        <translation>Vahepealset ei ole: objektiiv kas jagab sügavusega või ei jaga. Ortograafiline ei jaga. Vaadake kaht posti: need on ühekõrgused.</translation>
    </message>
    <message>
        <source>The projectors are parallel: nothing is divided by the depth, and the heights in the picture are those of the world.</source>
        <translation>Projektsioonikiired on paralleelsed: sügavusega ei jagata midagi ja kõrgused pildil on samad mis maailmas.</translation>
    </message>
    <message>
        <source>The box becomes the cube</source>
        <translation>Risttahukast saab kuup</translation>
    </message>
    <message>
        <source>A parallel lens has a box, from {0} to {1}, {2} to {3} and {4} to {5}. Each range is moved to the middle and scaled to length 2:</source>
        <translation>Paralleelsel objektiivil on risttahukas {0} kuni {1}, {2} kuni {3} ja {4} kuni {5}. Iga vahemik nihutatakse keskele ja skaleeritakse pikkuseks 2:</translation>
    </message>
    <message>
        <source>Point 1 is at {0} in view space. With {1}, {2} it has {3}; its depth of 5 affects only {4}. The Probe panel shows every step: the division is by 1.</source>
        <translation>Punkt 1 on kaamerafreimis {0}. Kui {1}, {2}, siis {3}; selle sügavus 5 mõjutab ainult suurust {4}. Paneel Sond näitab iga sammu: jagatakse 1-ga.</translation>
    </message>
    <message>
        <source>The same height, by another lens</source>
        <translation>Sama kõrgus teise objektiiviga</translation>
    </message>
    <message>
        <source>The lens is perspective again, and point 1 is at {0} in view space: its {1} is less than {2}.</source>
        <translation>Objektiiv on jälle perspektiivne ja punkt 1 on kaamerafreimis {0}: selle {1} on väiksem kui {2}.</translation>
    </message>
    <message>
        <source>Bring point 1 to {0} with an orthographic lens.</source>
        <translation>Viige punkt 1 ortograafilise objektiiviga kohta {0}.</translation>
    </message>
    <message>
        <source>Choose *orthographic* for the lens, then set bottom and top.</source>
        <translation>Valige objektiiviks *ortograafiline*, siis seadke alumine ja ülemine.</translation>
    </message>
    <message>
        <source>Move the camera back and forth. What happens to {0}?</source>
        <translation>Liigutage kaamerat edasi-tagasi. Mis juhtub suurusega {0}?</translation>
    </message>
    <message>
        <source>Only the height of the window matters. The distance of the point does not.</source>
        <translation>Loeb ainult akna kõrgus. Punkti kaugus ei loe.</translation>
    </message>
    <message>
        <source>Cells and coordinates</source>
        <translation>Lahtrid ja koordinaadid</translation>
    </message>
    <message>
        <source>This box is not in the middle: {0}, {1}, {2}, {3}, from 1 to 9. The window is stretched to the picture.</source>
        <translation>See risttahukas ei ole keskel: {0}, {1}, {2}, {3}, sügavus 1 kuni 9. Aken on venitatud pildi järgi.</translation>
    </message>
    <message>
        <source>What is in row 1, column 4 of clip ← view?</source>
        <translation>Mis on maatriksi kärperuum ← vaade reas 1 ja veerus 4?</translation>
    </message>
    <message>
        <source>This moves the middle of the box farther out. The cell is added to {0}; it must take the middle, {1}, to {2}. Look from above: the middle of the box is to the right of the eye&apos;s axis.</source>
        <translation>Nii nihutatakse risttahuka keskkohta kaugemale välja. Lahter liidetakse suurusele {0}; see peab viima keskkoha {1} kohta {2}. Vaadake ülalt: risttahuka keskkoht on silma teljest paremal.</translation>
    </message>
    <message>
        <source>This is row 4, column 1. Row 1 computes {0} from x, y, z and 1; its last cell is what is added. Look from above: the box reaches farther to the right, so something must be added to {1}.</source>
        <translation>See on rida 4, veerg 1. Suuruse {0} arvutab x-ist, y-ist, z-ist ja 1-st rida 1; selle viimane lahter on see, mis liidetakse. Vaadake ülalt: risttahukas ulatub kaugemale paremale, seega tuleb suurusele {1} midagi liita.</translation>
    </message>
    <message>
        <source>The middle of the box, {0}, must come to {1}.</source>
        <translation>Risttahuka keskkoht {0} peab sattuma kohale {1}.</translation>
    </message>
    <message>
        <source>{0}: the middle of the box is right of the axis, so it is moved to the left.</source>
        <translation>{0}: risttahuka keskkoht on teljest paremal, seega nihutatakse see vasakule.</translation>
    </message>
    <message>
        <source>What is {0} of the point (1, 1, −5) in view space?</source>
        <translation>Kui suur on {0} kaamerafreimi punktil (1, 1, −5)?</translation>
    </message>
    <message>
        <source>This divides by the depth of 5. The projectors of a parallel lens do not meet: {0} does not contain z. Look at points 1 and 2, 5 and 8 deep: they are equally high in the picture.</source>
        <translation>Nii jagatakse sügavusega 5. Paralleelse objektiivi projektsioonikiired ei kohtu: suuruses {0} ei ole z-i. Vaadake punkte 1 ja 2 sügavustel 5 ja 8: need on pildil ühel kõrgusel.</translation>
    </message>
    <message>
        <source>{0}, and {1}: there is nothing to divide by.</source>
        <translation>{0} ja {1}: ei ole, millega jagada.</translation>
    </message>
    <message>
        <source>Back to the prediction</source>
        <translation>Tagasi ennustuse juurde</translation>
    </message>
    <message>
        <source>Far things look small to an eye, and to every lens whose projectors meet in a point. It is tempting to take this for a law of pictures. In a box the projectors never meet: the last row of the matrix is 0, 0, 0, 1, so {0} at every depth, and x and y do not depend on z. The depth is not lost: {1} keeps it and decides what hides what. That is why the posts are drawn equally high, side by side.</source>
        <translation>Kauged asjad paistavad väikesed silmale ja igale objektiivile, mille projektsioonikiired ühes punktis kohtuvad. Ahvatlev on pidada seda kõigi piltide seaduseks. Risttahukas ei kohtu projektsioonikiired kunagi: maatriksi viimane rida on 0, 0, 0, 1, seega on igal sügavusel {0} ning x ja y ei sõltu z-ist. Sügavus ei ole kadunud: {1} säilitab selle ja otsustab, mis mida varjab. Seepärast joonistatakse postid ühekõrgustena, kõrvuti.</translation>
    </message>
    <message>
        <source>Practise: the first row</source>
        <translation>Harjutus: esimene rida</translation>
    </message>
    <message>
        <source>A parallel lens takes its box, from {0} to {1} in x, to {2} from {3} to {4}.</source>
        <translation>Paralleelne objektiiv viib oma risttahuka, x-sihis kohast {0} kohani {1}, suuruseks {2} kohast {3} kohani {4}.</translation>
    </message>
    <message>
        <source>The box reaches from {0} to {1}. What is in row 1 of clip ← view?</source>
        <translation>Risttahukas ulatub kohast {0} kohani {1}. Mis on maatriksi kärperuum ← vaade reas 1?</translation>
    </message>
    <message>
        <source>This moves the middle of the box farther out. The row&apos;s last cell is added to {0}, so it must be {1}: then the middle, {2}, comes to {3}. Look from above: the middle of the box is not on the eye&apos;s axis.</source>
        <translation>Nii nihutatakse risttahuka keskkohta kaugemale välja. Rea viimane lahter liidetakse suurusele {0}, seega peab see olema {1}: siis satub keskkoht {2} kohale {3}. Vaadake ülalt: risttahuka keskkoht ei ole silma teljel.</translation>
    </message>
    <message>
        <source>This is column 1. Row 1 computes {0} from x, y, z and 1, so what is added to x stands in its last cell. Look from above: the box reaches farther to one side, so something must be added to {1}.</source>
        <translation>See on veerg 1. Rida 1 arvutab suuruse {0} x-ist, y-ist, z-ist ja 1-st, seega on x-ile liidetav selle viimases lahtris. Vaadake ülalt: risttahukas ulatub ühele poole kaugemale, seega tuleb suurusele {1} midagi liita.</translation>
    </message>
    <message>
        <source>{0} is {1} plus a number that brings the middle of the box to 0.</source>
        <translation>{0} on {1} pluss arv, mis viib risttahuka keskkoha kohta 0.</translation>
    </message>
    <message>
        <source>The middle of the box, {0}, comes to {1}, and its width {2} to 2.</source>
        <translation>Risttahuka keskkoht {0} satub kohale {1} ja selle laiusest {2} saab 2.</translation>
    </message>
    <message>
        <source>Practise: a point in a parallel lens</source>
        <translation>Harjutus: punkt paralleelses objektiivis</translation>
    </message>
    <message>
        <source>A parallel lens has a box from {0} to {1} in y.</source>
        <translation>Paralleelse objektiivi risttahukas ulatub y-sihis kohast {0} kohani {1}.</translation>
    </message>
    <message>
        <source>The box reaches from {0} to {1}. Point 1 is at {2} in view space, {3} in front of the eye. What is its {4}?</source>
        <translation>Risttahukas ulatub kohast {0} kohani {1}. Punkt 1 on kaamerafreimis kohal {2}, silmast {3} eespool. Kui suur on selle {4}?</translation>
    </message>
    <message>
        <source>This divides by the depth of {0}. The projectors of a parallel lens do not meet: {1} does not contain z. Look at points 1 and 2: they have the same {2} at two depths, and the same {3}.</source>
        <translation>Nii jagatakse sügavusega {0}. Paralleelse objektiivi projektsioonikiired ei kohtu: suuruses {1} ei ole z-i. Vaadake punkte 1 ja 2: neil on kahel sügavusel sama {2} ja sama {3}.</translation>
    </message>
    <message>
        <source>The middle moves out</source>
        <translation>Keskkoht nihkub välja</translation>
    </message>
    <message>
        <source>This moves the middle of the box farther out instead of to 0: from {0} the lens subtracts {1}. Look at point 2, at {2}: it is in the middle of the picture, where {3}.</source>
        <translation>Nii nihutatakse risttahuka keskkohta kaugemale välja, mitte kohta 0: suurusest {0} lahutab objektiiv avaldise {1}. Vaadake punkti 2 kohal {2}: see on pildi keskel, kus {3}.</translation>
    </message>
    <message>
        <source>{0} comes to {1} and {2} to {3}. What does the depth change?</source>
        <translation>{0} satub kohale {1} ja {2} kohale {3}. Mida muudab sügavus?</translation>
    </message>
    <message>
        <source>The depth of {0} does not matter: the division is by {1}.</source>
        <translation>Sügavus {0} ei loe: jagatakse arvuga {1}.</translation>
    </message>
    <message>
        <source>Practise: a height in the picture</source>
        <translation>Harjutus: kõrgus pildil</translation>
    </message>
    <message>
        <source>Point 1 is seen by a parallel lens. Its box reaches from {0} to {1} in y.</source>
        <translation>Punkti 1 näeb paralleelne objektiiv. Selle risttahukas ulatub y-sihis kohast {0} kohani {1}.</translation>
    </message>
    <message>
        <source>Point 1 is at {0} in view space, {1} in front of the eye. Keep the lens parallel and bring the point to {2}.</source>
        <translation>Punkt 1 on kaamerafreimis kohal {0}, silmast {1} eespool. Jätke objektiiv paralleelseks ja viige punkt kohta {2}.</translation>
    </message>
    <message>
        <source>With {0}, {1}.</source>
        <translation>Kui {0}, siis {1}.</translation>
    </message>
    <message>
        <source>{0} {1}, and {2}. The depth of {3} has no part in it.</source>
        <translation>{0} {1} ja {2}. Sügavus {3} ei puutu asjasse.</translation>
    </message>
    <message>
        <source>A parallel lens divides by nothing but the half height of its box. Look at a box with {0}, twice as high as the point: there the point is at {1}, whatever its depth.</source>
        <translation>Paralleelne objektiiv ei jaga millegi muuga kui poole oma risttahuka kõrgusega. Vaadake risttahukat, mille {0}, kaks korda kõrgem kui punkt: seal on punkt kohal {1}, olgu sügavus milline tahes.</translation>
    </message>
</context>
<context>
    <name>l11-oblique-drawing</name>
    <message>
        <source>Where receding edges go</source>
        <translation>Kuhu lähevad sügavusse minevad servad</translation>
    </message>
    <message>
        <source>Half the scale</source>
        <translation>Pool mastaapi</translation>
    </message>
    <message>
        <source>The front of this body is parallel to the picture, so it keeps its shape. If the projectors slant, edges along n are drawn too. A cavalier drawing shows them at full length; its projectors meet the picture at 45°. A cabinet drawing shows them half as long.</source>
        <translation>Selle keha esikülg on pildiga paralleelne, seepärast säilitab see oma kuju. Kui projektsioonikiired on kaldu, joonistatakse ka n-sihilised servad. Cavalier-joonis näitab neid täispikkuses; selle projektsioonikiired lõikavad pilti 45° nurga all. Cabinet-joonis näitab neid poole lühematena.</translation>
    </message>
    <message>
        <source>At which angle do the projectors of a cabinet drawing meet the picture?</source>
        <translation>Millise nurga all lõikavad pilti cabinet-joonise projektsioonikiired?</translation>
    </message>
    <message>
        <source>67.5°: half the scale is half the slant</source>
        <translation>67.5°: pool mastaapi on pool kallet</translation>
    </message>
    <message>
        <source>This assumes that the angle is proportional to the scale. One unit of depth and half a unit along the picture are the legs of a right triangle: the angle between projector and picture has the tangent 2, and is 63.4°. Look from above at the lines to the near plane: they go 2 deep for 1 to the side.</source>
        <translation>Nii eeldatakse, et nurk on mastaabiga võrdeline. Üks ühik sügavust ja pool ühikut piki pilti on täisnurkse kolmnurga kaatetid: projektsioonikiire ja pildi vahelise nurga tangens on 2 ja nurk ise 63.4°. Vaadake ülalt jooni lähitasandini: need lähevad 2 sügavusse, kui 1 kõrvale.</translation>
    </message>
    <message>
        <source>45°, as in every oblique drawing</source>
        <translation>45°, nagu igal kaldnurgalisel joonisel</translation>
    </message>
    <message>
        <source>At 45° a projector goes as far along the picture as into the depth, so edges along n are drawn at full length. That is the cavalier drawing. Look from above at its lines to the near plane: they go 1 deep for 1 to the side.</source>
        <translation>45° korral läheb projektsioonikiir piki pilti sama kaugele kui sügavusse, nii et n-sihilised servad joonistatakse täispikkuses. See on cavalier-joonis. Vaadake ülalt selle jooni lähitasandini: need lähevad 1 sügavusse ja 1 kõrvale.</translation>
    </message>
    <message>
        <source>A projector that goes 1 unit deep moves by the scale {0} along the picture: {1}, and {2} is the angle with {3}.</source>
        <translation>Projektsioonikiir, mis läheb 1 ühiku sügavusse, nihkub piki pilti mastaabi {0} võrra: {1}, ja {2} on nurk, mille {3}.</translation>
    </message>
    <message>
        <source>The matrix H</source>
        <translation>Maatriks H</translation>
    </message>
    <message>
        <source>A projector that meets the near plane at {0} (seen from above) and {1} (from the side) moves a point by</source>
        <translation>Projektsioonikiir, mis lõikab lähitasandit nurga {0} (ülalt vaadatuna) ja {1} (küljelt) all, nihutab punkti nii:</translation>
    </message>
    <message>
        <source>That is a shear: the matrix {0}, which leaves the near plane as it is. Here {1}, {2} and {3}: one unit behind the near plane {4}, and x moves by {5}. *Matrices* shows it as *sheared ← view*. After {6} the slanted box is straight, so {7}; the three matrices stand side by side.</source>
        <translation>See on kaldnihe: maatriks {0}, mis jätab lähitasandi samaks. Siin {1}, {2} ja {3}: üks ühik lähitasandi taga {4}, ja x nihkub {5} võrra. *Maatriksid* näitab seda nimega *kaldnihkega ← vaade*. Pärast maatriksit {6} on rööptahukas sirge, seega {7}; need kolm maatriksit on kõrvuti.</translation>
    </message>
    <message>
        <source>Make it a cabinet drawing</source>
        <translation>Tehke sellest cabinet-joonis</translation>
    </message>
    <message>
        <source>The scale of receding edges is {0}; their direction in the picture is free.</source>
        <translation>Sügavusse minevate servade mastaap on {0}; nende suund pildil on vaba.</translation>
    </message>
    <message>
        <source>Set the lens so that {0}, in any direction.</source>
        <translation>Seadke objektiiv nii, et {0}, mis tahes suunas.</translation>
    </message>
    <message>
        <source>The numbers below the scene&apos;s controls give the drawn scale.</source>
        <translation>Arvud stseeni juhtelementide all annavad joonise mastaabi.</translation>
    </message>
    <message>
        <source>The scale is 1/2 then.</source>
        <translation>Mastaap on siis 1/2.</translation>
    </message>
    <message>
        <source>A unit of depth is drawn half as long, in whatever direction it recedes.</source>
        <translation>Sügavuse ühik joonistatakse poole lühemana, ükskõik mis suunas see sügavusse läheb.</translation>
    </message>
    <message>
        <source>How far H moves</source>
        <translation>Kui palju H nihutab</translation>
    </message>
    <message>
        <source>The letter F with an oblique lens: {0}, {1}, and the near plane is 2 in front of the eye, so {2}.</source>
        <translation>F-täht kaldnurgalise objektiiviga: {0}, {1} ja lähitasand on silmast 2 eespool, seega {2}.</translation>
    </message>
    <message>
        <source>What is in row 1, column 4 of H, {0}?</source>
        <translation>Mis on maatriksi H reas 1 ja veerus 4: {0}?</translation>
    </message>
    <message>
        <source>This takes {0} for the slant. At {1} the projectors are straight and shift nothing, so the slant is {2}. Look from above at {3}: the box is almost straight, {4}.</source>
        <translation>Nii võetakse kaldeks {0}. Kui {1}, on projektsioonikiired sirged ja ei nihuta midagi, seega on kalle {2}. Vaadake ülalt juhtu {3}: rööptahukas on peaaegu sirge, {4}.</translation>
    </message>
    <message>
        <source>The near plane is at z = 2</source>
        <translation>Lähitasand on kohal z = 2</translation>
    </message>
    <message>
        <source>{0} is {1}, so {2} is positive. With this cell, points of the near plane would move. Look from above: the box slants away from near, and near stays where it is.</source>
        <translation>{0} on {1}, seega on {2} positiivne. Sellise lahtriga nihkuksid lähitasandi punktid. Vaadake ülalt: rööptahukas kaldub lähitasandist eemale ja lähitasand jääb oma kohale.</translation>
    </message>
    <message>
        <source>{0} itself is negative here.</source>
        <translation>{0} ise on siin negatiivne.</translation>
    </message>
    <message>
        <source>{0}. With {1} it is 0: the projectors are straight then.</source>
        <translation>{0}. Kui {1}, on see 0: siis on projektsioonikiired sirged.</translation>
    </message>
    <message>
        <source>By how much does H change x of a point 3 units behind the near plane?</source>
        <translation>Kui palju muudab H punkti x-i, kui punkt on 3 ühikut lähitasandi taga?</translation>
    </message>
    <message>
        <source>What recedes goes to the right</source>
        <translation>Sügavusse minev läheb paremale</translation>
    </message>
    <message>
        <source>The size is right. Behind the near plane {0} is positive, and the formula subtracts it: x becomes smaller. Look from above at the sides of the box: they lean to the right, and H moves them back to the left.</source>
        <translation>Suurus on õige. Lähitasandi taga on {0} positiivne ja valem lahutab selle: x väheneb. Vaadake ülalt rööptahuka külgi: need on paremale kaldu ja H viib need vasakule tagasi.</translation>
    </message>
    <message>
        <source>{0} with {1}.</source>
        <translation>{0}, kus {1}.</translation>
    </message>
    <message>
        <source>{0}: receding points move to the left.</source>
        <translation>{0}: sügavusse minevad punktid nihkuvad vasakule.</translation>
    </message>
    <message>
        <source>Projectors at 70°</source>
        <translation>Projektsioonikiired 70° all</translation>
    </message>
    <message>
        <source>Between the cabinet drawing and the orthographic one the projectors are even steeper.</source>
        <translation>Cabinet-joonise ja ortograafilise joonise vahel on projektsioonikiired veel järsemad.</translation>
    </message>
    <message>
        <source>Draw with projectors that meet the picture at 70°, within 1 %.</source>
        <translation>Joonistage projektsioonikiirtega, mis lõikavad pilti 70° nurga all, täpsusega 1 %.</translation>
    </message>
    <message>
        <source>Which scale belongs to this angle? It is {0}.</source>
        <translation>Milline mastaap kuulub selle nurga juurde? See on {0}.</translation>
    </message>
    <message>
        <source>The scale is 0.364 there.</source>
        <translation>Seal on mastaap 0.364.</translation>
    </message>
    <message>
        <source>Back to the prediction</source>
        <translation>Tagasi ennustuse juurde</translation>
    </message>
    <message>
        <source>Scale 0 belongs to 90°, scale 1 to 45°, so it is tempting to take the middle, 67.5°, for scale 1/2. But the angle does not change evenly with the scale. One unit of depth and {0} units along the picture are the legs of a right triangle, and {1}: for 1/2 that is 63.4°. Look at *World* from above, with the lines from the corners of the body to the near plane.</source>
        <translation>Mastaap 0 kuulub 90° juurde, mastaap 1 45° juurde, nii et ahvatlev on võtta mastaabi 1/2 jaoks keskkoht, 67.5°. Aga nurk ei muutu mastaabiga ühtlaselt. Üks ühik sügavust ja {0} ühikut piki pilti on täisnurkse kolmnurga kaatetid ning {1}: 1/2 puhul on see 63.4°. Vaadake paani *Maailm* ülalt, koos joontega keha nurkadest lähitasandini.</translation>
    </message>
    <message>
        <source>Practise: the first row of H</source>
        <translation>Harjutus: H esimene rida</translation>
    </message>
    <message>
        <source>{0} takes x along the projectors to the near plane, which is at {1}. {2} is its matrix.</source>
        <translation>{0} viib x-i piki projektsioonikiiri lähitasandile, mis on kohal {1}. {2} on selle maatriks.</translation>
    </message>
    <message>
        <source>The projectors will slant, with {0}. The near plane is {1} in front of the eye: {2}. What is in row 1 of {3}?</source>
        <translation>Projektsioonikiired lähevad kaldu nii, et {0}. Lähitasand on silmast {1} eespool: {2}. Mis on maatriksi {3} reas 1?</translation>
    </message>
    <message>
        <source>The near plane is at a positive z</source>
        <translation>Lähitasandi z on positiivne</translation>
    </message>
    <message>
        <source>The last cell is {0}, and {1} is negative itself. With this row, points of the near plane would move. Look from above: the box slants away from near, and near stays where it is.</source>
        <translation>Viimane lahter on {0} ja {1} on ise negatiivne. Sellise reaga nihkuksid lähitasandi punktid. Vaadake ülalt: rööptahukas kaldub lähitasandist eemale ja lähitasand jääb oma kohale.</translation>
    </message>
    <message>
        <source>Multiply out: how often is z in {0}, and what is left without x and z?</source>
        <translation>Korrutage läbi: mitu korda on avaldises {0} z ja mis jääb ilma x-i ja z-ita üle?</translation>
    </message>
    <message>
        <source>{0}: points of the near plane stay where they are.</source>
        <translation>{0}: lähitasandi punktid jäävad oma kohale.</translation>
    </message>
    <message>
        <source>Practise: a far corner</source>
        <translation>Harjutus: kauge nurk</translation>
    </message>
    <message>
        <source>Points that are {0} behind the front of the cube move by {1} in x and by {2} in y. The front stays.</source>
        <translation>Punktid, mis on kuubi esikülje taga {0} kaugusel, nihkuvad x-sihis {1} ja y-sihis {2}. Esikülg jääb paigale.</translation>
    </message>
    <message>
        <source>The picture shows a cube, 1 unit wide, from straight in front. With {0} and {1}, where will the corner of its back be drawn that is at {2}, {3} from the middle?</source>
        <translation>Pilt näitab kuupi, mille laius on 1 ühik, otse eest. Kui {0} ja {1}, siis kuhu joonistatakse tagakülje nurk, mis on keskkohast {2}, {3}?</translation>
    </message>
    <message>
        <source>This moves the corner by {0} and {1}. At 90° the projectors are straight and move nothing, so it is {2} and {3}. Look at the cube with 80° and 80°: its back has moved very little.</source>
        <translation>Nii nihutatakse nurka {0} ja {1} võrra. 90° korral on projektsioonikiired sirged ja ei nihuta midagi, seega on õiged {2} ja {3}. Vaadake kuupi, mille nurgad on 80° ja 80°: selle tagakülg on nihkunud väga vähe.</translation>
    </message>
    <message>
        <source>What recedes goes to the right and up</source>
        <translation>Sügavusse minev läheb paremale ja üles</translation>
    </message>
    <message>
        <source>This moves the corner the opposite way. An angle below 90° moves what is behind the front to the left, or down; one above 90° to the right, or up. Look at the cube with 60° and 60°: its back has moved to the left and down.</source>
        <translation>Nii nihutatakse nurka vastupidises suunas. Alla 90° nurk nihutab esikülje taga oleva vasakule või alla; üle 90° nurk paremale või üles. Vaadake kuupi, mille nurgad on 60° ja 60°: selle tagakülg on nihkunud vasakule ja alla.</translation>
    </message>
    <message>
        <source>What recedes goes up</source>
        <translation>Sügavusse minev läheb üles</translation>
    </message>
    <message>
        <source>x is right. But y was moved the opposite way: {0} below 90° moves the back down, above 90° up. Look at the cube with 60° and 60°: its back has moved to the left and down.</source>
        <translation>x on õige. Aga y nihutati vastupidises suunas: {0} alla 90° nihutab tagakülje alla, üle 90° üles. Vaadake kuupi, mille nurgad on 60° ja 60°: selle tagakülg on nihkunud vasakule ja alla.</translation>
    </message>
    <message>
        <source>Which way is {0} here, and how many widths of the cube is it?</source>
        <translation>Kuhu poole on siin {0} ja mitu kuubi laiust see on?</translation>
    </message>
    <message>
        <source>The edges that lead to the back are all drawn alike, {0} to the right and {1} up. The picture is 8 units wide and 4.5 high.</source>
        <translation>Servad, mis viivad tagaküljeni, joonistatakse kõik ühtemoodi, {0} paremale ja {1} üles. Pildi laius on 8 ühikut ja kõrgus 4.5.</translation>
    </message>
    <message>
        <source>Practise: an angle of your choice</source>
        <translation>Harjutus: nurk teie valikul</translation>
    </message>
    <message>
        <source>The projectors of this drawing meet the picture at the angle {0}. Edges that recede are drawn {1} times as long as they are.</source>
        <translation>Selle joonise projektsioonikiired lõikavad pilti nurga {0} all. Sügavusse minevad servad joonistatakse {1} korda nii pikana, kui need on.</translation>
    </message>
    <message>
        <source>Make {0}, to within 1 %. The direction of the receding edges is free.</source>
        <translation>Tehke nii, et {0}, täpsusega 1 %. Sügavusse minevate servade suund on vaba.</translation>
    </message>
    <message>
        <source>Choose *Free scale*. Which scale belongs to this angle?</source>
        <translation>Valige *Vaba mastaap*. Milline mastaap kuulub selle nurga juurde?</translation>
    </message>
    <message>
        <source>A projector goes {0} along the picture for 1 unit of depth. Draw the right triangle with the angle {1}.</source>
        <translation>Projektsioonikiir läheb 1 ühiku sügavuse kohta piki pilti {0}. Joonistage täisnurkne kolmnurk nurgaga {1}.</translation>
    </message>
    <message>
        <source>The angle is not proportional to the scale: {0}. Look from above at the lines to the near plane: they are flatter than {1}°.</source>
        <translation>Nurk ei ole mastaabiga võrdeline: {0}. Vaadake ülalt jooni lähitasandini: need on laugemad kui {1}°.</translation>
    </message>
    <message>
        <source>The scale is the cotangent of the angle. Look from above at the lines to the near plane: they meet it at {0}°.</source>
        <translation>Mastaap on nurga kootangens. Vaadake ülalt jooni lähitasandini: need lõikavad seda {0}° nurga all.</translation>
    </message>
</context>
<context>
    <name>l12-vanishing-points</name>
    <message>
        <source>How many vanishing points?</source>
        <translation>Mitu koondumispunkti?</translation>
    </message>
    <message>
        <source>A box, turned</source>
        <translation>Pööratud risttahukas</translation>
    </message>
    <message>
        <source>A box has edges in three directions. With the camera straight in front of it, the edges that lead away from you meet in one point of the picture, {0}. This is a 1-point perspective.</source>
        <translation>Risttahuka servad on kolmes suunas. Kui kaamera on otse selle ees, kohtuvad teist eemale suunduvad servad pildi ühes punktis, {0}. See on 1-punkti perspektiiv.</translation>
    </message>
    <message>
        <source>The camera stays level and goes round the box by 30°. How many vanishing points do the box&apos;s edges have now?</source>
        <translation>Kaamera jääb horisontaalseks ja käib 30° ümber risttahuka. Mitu koondumispunkti on nüüd risttahuka servadel?</translation>
    </message>
    <message>
        <source>Still one</source>
        <translation>Endiselt üks</translation>
    </message>
    <message>
        <source>One belongs to a camera that looks straight at a side of the box. Turned by 30°, it sees two directions of level edges lead away. Look at the horizon: {0} and {1} lie on it.</source>
        <translation>Üks kuulub kaamerale, mis vaatab otse risttahuka külge. 30° pööratuna näeb see horisontaalseid servi eemale suundumas kahes suunas. Vaadake horisonti: {0} ja {1} on sellel.</translation>
    </message>
    <message>
        <source>Two</source>
        <translation>Kaks</translation>
    </message>
    <message>
        <source>Three: a box has three directions</source>
        <translation>Kolm: risttahukal on kolm suunda</translation>
    </message>
    <message>
        <source>This counts the directions of the box. Edges that are parallel to the picture stay parallel in it and meet nowhere; the uprights are, because the camera is level. Look at the uprights: they are parallel in the picture.</source>
        <translation>Nii loetakse risttahuka suundi. Pildiga paralleelsed servad jäävad sellel paralleelseks ega kohtu kusagil; püstservad on sellised, sest kaamera on horisontaalne. Vaadake püstservi: need on pildil paralleelsed.</translation>
    </message>
    <message>
        <source>A direction has a vanishing point if it is not parallel to the picture plane, {0}. Uprights are parallel to the picture plane of a level camera and stay parallel in the picture.</source>
        <translation>Suunal on koondumispunkt, kui see ei ole pilditasandiga paralleelne, {0}. Püstsirged on horisontaalse kaamera pilditasandiga paralleelsed ja jäävad pildil paralleelseks.</translation>
    </message>
    <message>
        <source>A point that runs to infinity</source>
        <translation>Punkt, mis jookseb lõpmatusse</translation>
    </message>
    <message>
        <source>{0} runs along an edge. At {1} its {2} is 0: it is no longer a point of space but the direction {3}. Its image is the point that it was heading for all the time.</source>
        <translation>{0} jookseb mööda serva. Kui {1}, on selle {2} 0: see ei ole enam ruumi punkt, vaid suund {3}. Selle kujutis on punkt, mille poole see kogu aeg läks.</translation>
    </message>
    <message>
        <source>For a direction {0} in view space the image on a plane at distance {1} is {2}, the same formula as for a point. The start of a line does not matter, so all lines in this direction meet there.</source>
        <translation>Kaamerafreimi suuna {0} kujutis tasandil kaugusega {1} on {2}, sama valem mis punktil. Sirge alguspunkt ei loe, nii et kõik selle suuna sirged kohtuvad seal.</translation>
    </message>
    <message>
        <source>Drag *t* to 1 and beyond: P returns from the other side.</source>
        <translation>Lohistage *t* väärtuseni 1 ja kaugemale: P tuleb tagasi teiselt poolt.</translation>
    </message>
    <message>
        <source>Just one</source>
        <translation>Ainult üks</translation>
    </message>
    <message>
        <source>The camera looks down on the box: three directions, three vanishing points.</source>
        <translation>Kaamera vaatab risttahukale ülalt: kolm suunda, kolm koondumispunkti.</translation>
    </message>
    <message>
        <source>Turn the camera until the picture has just one vanishing point, by any axis of the box.</source>
        <translation>Pöörake kaamerat, kuni pildil on ainult üks koondumispunkt, risttahuka mis tahes telje oma.</translation>
    </message>
    <message>
        <source>Elevation 0 removes the vanishing point of the uprights. What next?</source>
        <translation>Tõusunurk 0 kaotab püstservade koondumispunkti. Mis edasi?</translation>
    </message>
    <message>
        <source>The camera&apos;s {0} must be one of the axes.</source>
        <translation>Kaamera {0} peab olema üks telgedest.</translation>
    </message>
    <message>
        <source>Two of the three directions are parallel to the picture now; only the third one leads away.</source>
        <translation>Kolmest suunast kaks on nüüd pildiga paralleelsed; ainult kolmas suundub eemale.</translation>
    </message>
    <message>
        <source>Where, and how many</source>
        <translation>Kus, ja mitu</translation>
    </message>
    <message>
        <source>Here the camera stands in front of the cube and looks down by 30°.</source>
        <translation>Siin on kaamera kuubi ees ja vaatab 30° alla.</translation>
    </message>
    <message>
        <source>How many of the cube&apos;s three directions have a vanishing point?</source>
        <translation>Mitmel kuubi kolmest suunast on koondumispunkt?</translation>
    </message>
    <message>
        <source>That would be a camera that looks along an axis of the cube. This one looks down: the edges along y and those along z both lead away. Look at the edges along y: they run together downwards.</source>
        <translation>See oleks kaamera, mis vaatab piki kuubi telge. See siin vaatab alla: eemale suunduvad nii y-sihilised kui ka z-sihilised servad. Vaadake y-sihilisi servi: need koonduvad allapoole.</translation>
    </message>
    <message>
        <source>This counts the directions of the cube. The camera is straight in front of it, so the edges along x are parallel to the picture and stay parallel in it. Look at the edges along x: they are parallel in the picture.</source>
        <translation>Nii loetakse kuubi suundi. Kaamera on otse selle ees, nii et x-sihilised servad on pildiga paralleelsed ja jäävad sellel paralleelseks. Vaadake x-sihilisi servi: need on pildil paralleelsed.</translation>
    </message>
    <message>
        <source>Which edges are parallel to the picture?</source>
        <translation>Millised servad on pildiga paralleelsed?</translation>
    </message>
    <message>
        <source>{0}: its x is 0, so edges along x stay parallel. The other two directions have one vanishing point each.</source>
        <translation>{0}: selle x on 0, seega jäävad x-sihilised servad paralleelseks. Teistel kahel suunal on kummalgi üks koondumispunkt.</translation>
    </message>
    <message>
        <source>Lines run along {0} in view space, one of them through {1}. At which x on the plane {2} do they meet?</source>
        <translation>Sirged kulgevad kaamerafreimis suunas {0}, üks neist läbi punkti {1}. Millise x-iga kohtuvad need tasandil {2}?</translation>
    </message>
    <message>
        <source>This is a point ten steps along the line, which falls short of the point where all lines meet. That point depends on the direction alone. Look at P on an edge of this box: as long as {0} is less than 1, it has not reached its vanishing point.</source>
        <translation>See on punkt kümme sammu mööda sirget, mis ei küüni punktini, kus kõik sirged kohtuvad. See punkt sõltub ainult suunast. Vaadake punkti P selle risttahuka serval: kuni {0} on väiksem kui 1, ei ole see oma koondumispunkti jõudnud.</translation>
    </message>
    <message>
        <source>The lines meet in front of the eye, where z is negative: divide by {0}, which is positive. Look at P on an edge of this box: the edge leads away from you, and P has come to its vanishing point on the same side.</source>
        <translation>Sirged kohtuvad silma ees, kus z on negatiivne: jagage suurusega {0}, mis on positiivne. Vaadake punkti P selle risttahuka serval: serv suundub teist eemale ja P on jõudnud oma koondumispunkti samal pool.</translation>
    </message>
    <message>
        <source>The image of the direction itself: {0}.</source>
        <translation>Suuna enda kujutis: {0}.</translation>
    </message>
    <message>
        <source>{0}. After ten steps along the line you are at 0.571; the vanishing point is the limit.</source>
        <translation>{0}. Pärast kümmet sammu mööda sirget olete kohal 0.571; koondumispunkt on piirväärtus.</translation>
    </message>
    <message>
        <source>Three, with one below</source>
        <translation>Kolm, üks neist all</translation>
    </message>
    <message>
        <source>Photographs of high houses are often taken from below, or from a tower.</source>
        <translation>Kõrgeid maju pildistatakse sageli alt või mõnest tornist.</translation>
    </message>
    <message>
        <source>Make a 3-point perspective whose {0} lies below the picture.</source>
        <translation>Tehke 3-punkti perspektiiv, mille {0} on pildist allpool.</translation>
    </message>
    <message>
        <source>Change the elevation. On which side does {0} appear?</source>
        <translation>Muutke tõusunurka. Kummale poole ilmub {0}?</translation>
    </message>
    <message>
        <source>A camera that looks down sees uprights run together below.</source>
        <translation>Alla vaatav kaamera näeb püstservi all kokku jooksmas.</translation>
    </message>
    <message>
        <source>Back to the prediction</source>
        <translation>Tagasi ennustuse juurde</translation>
    </message>
    <message>
        <source>A box has three directions, and everybody knows the name 3-point perspective, so three is tempting. But the number depends on the camera, not on the box. Each axis of the box that is parallel to the picture, {0}, has its vanishing point at infinity, and its edges stay parallel. A level camera keeps uprights upright, which is why architects keep it level. *Kinds of projection* has all of them as small pictures.</source>
        <translation>Risttahukal on kolm suunda ja nime 3-punkti perspektiiv teavad kõik, nii et ahvatlev on kolm. Aga arv sõltub kaamerast, mitte risttahukast. Igal risttahuka teljel, mis on pildiga paralleelne, {0}, on koondumispunkt lõpmatuses ja selle servad jäävad paralleelseks. Horisontaalne kaamera jätab püstjooned püsti, seepärast hoiavad arhitektid seda horisontaalselt. *Projektsioonide liigid* sisaldab neid kõiki väikeste piltidena.</translation>
    </message>
    <message>
        <source>Practise: where lines meet</source>
        <translation>Harjutus: kus sirged kohtuvad</translation>
    </message>
    <message>
        <source>All lines in one direction {0} of view space meet in one point of the picture, which lies on the plane {1}.</source>
        <translation>Kõik kaamerafreimi suuna {0} sirged kohtuvad pildi ühes punktis; pilt asub tasandil {1}.</translation>
    </message>
    <message>
        <source>The edges of the box that lead away run along {0} in view space. One more line of this direction starts at {1}. At which {2} do they all meet if {3}?</source>
        <translation>Risttahuka eemale suunduvad servad kulgevad kaamerafreimis suunas {0}. Veel üks selle suuna sirge algab punktist {1}. Millise {2} juures kohtuvad need kõik, kui {3}?</translation>
    </message>
    <message>
        <source>This is a point ten steps along the line, which is still before the point where the lines meet. That depends on the direction alone: {0}. Look at P, which runs along such an edge: before {1} it has not reached {2}.</source>
        <translation>See on punkt kümme sammu mööda sirget, mis on alles enne seda punkti, kus sirged kohtuvad. Too sõltub ainult suunast: {0}. Vaadake punkti P, mis jookseb mööda sellist serva: enne kui {1}, ei ole see jõudnud punkti {2}.</translation>
    </message>
    <message>
        <source>The line ends where it starts</source>
        <translation>Sirge lõpeb seal, kus algab</translation>
    </message>
    <message>
        <source>This is the image of the point where the line starts. Where it starts does not matter, only its direction: {0}. Look at P at the start of its edge: it is not at {1}.</source>
        <translation>See on sirge alguspunkti kujutis. Kust sirge algab, ei loe, loeb ainult selle suund: {0}. Vaadake punkti P oma serva alguses: see ei ole punktis {1}.</translation>
    </message>
    <message>
        <source>The lines meet in front of the eye, where z is negative: divide by {0}, which is positive. Look at P at {1}: it has come to {2} on the side to which the edges lead.</source>
        <translation>Sirged kohtuvad silma ees, kus z on negatiivne: jagage suurusega {0}, mis on positiivne. Vaadake punkti P, kui {1}: see on jõudnud punkti {2} sellel pool, kuhu servad suunduvad.</translation>
    </message>
    <message>
        <source>The formula for a point&apos;s image, {0}, holds for a direction too.</source>
        <translation>Punkti kujutise valem {0} kehtib ka suuna kohta.</translation>
    </message>
    <message>
        <source>The start of a line does not matter.</source>
        <translation>Sirge alguspunkt ei loe.</translation>
    </message>
    <message>
        <source>Practise: find the point</source>
        <translation>Harjutus: leidke punkt</translation>
    </message>
    <message>
        <source>The grid&apos;s lines along z meet in one point of the picture, {0}.</source>
        <translation>Ruudustiku z-sihilised jooned kohtuvad pildi ühes punktis, {0}.</translation>
    </message>
    <message>
        <source>The camera&apos;s azimuth is {0}°, its elevation {1}°, and the field of view {2}°. Mark {3}.</source>
        <translation>Kaamera asimuut on {0}°, tõusunurk {1}° ja frustumi nurk {2}°. Märkige {3}.</translation>
    </message>
    <message>
        <source>This is the end of the middle line of the grid. The grid ends, but the directions of its lines meet farther up: extend two of them. Look at the level lines: the farther away they are, the closer together they lie.</source>
        <translation>See on ruudustiku keskmise joone lõpp. Ruudustik lõpeb, aga selle joonte suunad kohtuvad ülalpool: pikendage kaht neist. Vaadake horisontaalseid jooni: mida kaugemal need on, seda tihedamalt need asuvad.</translation>
    </message>
    <message>
        <source>Rows are counted from the top. The camera looks down, so level lines meet above the middle of the picture. Look at the lines of the grid: they run together upwards.</source>
        <translation>Ridu loetakse ülalt. Kaamera vaatab alla, seega kohtuvad horisontaalsed jooned pildi keskkohast kõrgemal. Vaadake ruudustiku jooni: need koonduvad ülespoole.</translation>
    </message>
    <message>
        <source>The lines meet on the other side</source>
        <translation>Jooned kohtuvad teisel pool</translation>
    </message>
    <message>
        <source>The height is right, the side is not: extend two lines along z, and look on which side of the middle they meet. Look at two of them: the gap between them closes towards one side.</source>
        <translation>Kõrgus on õige, pool ei ole: pikendage kaht z-sihilist joont ja vaadake, kummal pool keskkohta need kohtuvad. Vaadake kaht neist: nende vahe sulgub ühele poole.</translation>
    </message>
    <message>
        <source>Two of the lines are enough; extend them with a ruler, or compute.</source>
        <translation>Kahest joonest piisab; pikendage neid joonlauaga või arvutage.</translation>
    </message>
    <message>
        <source>The direction {0} is {1} in view space, with {2}, the elevation, and {3}, the azimuth.</source>
        <translation>Suund {0} on kaamerafreimis {1}, kus {2} on tõusunurk ja {3} asimuut.</translation>
    </message>
    <message>
        <source>{0} and {1}, with the elevation {2} and the azimuth {3}.</source>
        <translation>{0} ja {1}, kus {2} on tõusunurk ja {3} asimuut.</translation>
    </message>
    <message>
        <source>Practise: as many as asked</source>
        <translation>Harjutus: nii palju, kui küsitud</translation>
    </message>
    <message>
        <source>A direction of the cube has a vanishing point if it is not parallel to the picture.</source>
        <translation>Kuubi suunal on koondumispunkt, kui see ei ole pildiga paralleelne.</translation>
    </message>
    <message>
        <source>The cube is turned by {0}° about y. Set the camera so that exactly {1} of its three directions have a vanishing point.</source>
        <translation>Kuupi on pööratud {0}° ümber y-telje. Seadke kaamera nii, et selle kolme suuna seas oleks koondumispunktiga suundi täpselt {1}.</translation>
    </message>
    <message>
        <source>Which elevation makes the uprights parallel to the picture?</source>
        <translation>Millise tõusunurga korral on püstservad pildiga paralleelsed?</translation>
    </message>
    <message>
        <source>Azimuth {0}° looks straight at one side of the cube.</source>
        <translation>Asimuudilt {0}° vaatab kaamera otse kuubi üht külge.</translation>
    </message>
    <message>
        <source>The uprights are parallel to the picture if the camera looks level. From azimuth {0}° one more direction is; from another azimuth two have a vanishing point.</source>
        <translation>Püstservad on pildiga paralleelsed, kui kaamera vaatab horisontaalselt. Asimuudilt {0}° on seda veel üks suund; teiselt asimuudilt on koondumispunkt kahel.</translation>
    </message>
</context>
<context>
    <name>l13-homogeneous</name>
    <message>
        <source>What w is for</source>
        <translation>Milleks on w</translation>
    </message>
    <message>
        <source>Four numbers for a point</source>
        <translation>Neli arvu ühe punkti jaoks</translation>
    </message>
    <message>
        <source>A point can be written with a fourth coordinate, {0}. Many such rows of numbers stand for the same point. With them, matrices can do what they cannot do with three numbers: translate and divide.</source>
        <translation>Punkti võib kirjutada neljanda koordinaadiga {0}. Sama punkti esindab palju selliseid arvuridu. Nendega saavad maatriksid teha seda, mida kolme arvuga ei saa: nihutada ja jagada.</translation>
    </message>
    <message>
        <source>Which point of space is {0}?</source>
        <translation>Milline ruumi punkt on {0}?</translation>
    </message>
    <message>
        <source>(2, 4, −6); the 2 is dropped</source>
        <translation>(2, 4, −6); 2 jäetakse ära</translation>
    </message>
    <message>
        <source>The fourth number is an extra</source>
        <translation>Neljas arv on lisand</translation>
    </message>
    <message>
        <source>The fourth number is not an extra: it is the divisor of the other three. Only if {0} can it be dropped. Look at points 1 and 2: {1} is another place than {2}.</source>
        <translation>Neljas arv ei ole lisand: sellega jagatakse teised kolm. Ainult siis, kui {0}, võib selle ära jätta. Vaadake punkte 1 ja 2: {1} on teine koht kui {2}.</translation>
    </message>
    <message>
        <source>None: four numbers are not a point of space</source>
        <translation>Mitte ükski: neli arvu ei ole ruumi punkt</translation>
    </message>
    <message>
        <source>They stand for one: divide the first three by the fourth. Many rows of four numbers stand for the same point. Look at point 1: it is the point that they stand for.</source>
        <translation>Need esindavad üht punkti: jagage esimesed kolm neljandaga. Sama punkti esindab palju neljaarvulisi ridu. Vaadake punkti 1: see on punkt, mida need esindavad.</translation>
    </message>
    <message>
        <source>{0} is the point {1}. Type 2, 4, −6 and w = 2 in the Probe panel: it becomes point 1.</source>
        <translation>{0} on punkt {1}. Sisestage paneelis Sond 2, 4, −6 ja w = 2: sellest saab punkt 1.</translation>
    </message>
    <message>
        <source>The w of the lens</source>
        <translation>Objektiivi w</translation>
    </message>
    <message>
        <source>Point 1 is at {0} in view space. The last row of the lens&apos;s matrix is {1}, so {2}, the depth. In clip space nothing is divided yet:</source>
        <translation>Punkt 1 on kaamerafreimis {0}. Objektiivi maatriksi viimane rida on {1}, seega {2}, mis on sügavus. Kärperuumis ei ole veel midagi jagatud:</translation>
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
        <translation>kärperuum</translation>
    </message>
    <message>
        <source>NDC</source>
        <translation>NDC</translation>
    </message>
    <message>
        <source>The matrix keeps straight lines straight. The division by {0}, which is not a matrix, makes far things small. *Probe* shows each in a row of its own.</source>
        <translation>Maatriks jätab sirged sirgeks. Jagamine suurusega {0}, mis ei ole maatriks, teeb kauged asjad väikeseks. *Sond* näitab kumbagi omas reas.</translation>
    </message>
    <message>
        <source>Without a w</source>
        <translation>Ilma w-ta</translation>
    </message>
    <message>
        <source>If {0}, the division is impossible.</source>
        <translation>Kui {0}, ei saa jagada.</translation>
    </message>
    <message>
        <source>Move the camera, or point 1, until the point&apos;s w in clip space is 0, within 0.05.</source>
        <translation>Liigutage kaamerat või punkti 1, kuni punkti w on kärperuumis 0, täpsusega 0.05.</translation>
    </message>
    <message>
        <source>{0} is the depth in front of the eye, here 5.</source>
        <translation>{0} on sügavus silma ees, siin 5.</translation>
    </message>
    <message>
        <source>The distance is 8, and the point is 3 in front of the target.</source>
        <translation>Kaugus on 8 ja punkt on sihtpunktist 3 eespool.</translation>
    </message>
    <message>
        <source>The point lies beside the eye, in the eye plane: its image is at infinity, in no pixel.</source>
        <translation>Punkt on silma kõrval, silmatasandil: selle kujutis on lõpmatuses ega ole üheski pikslis.</translation>
    </message>
    <message>
        <source>Computing with w</source>
        <translation>Arvutamine w-ga</translation>
    </message>
    <message>
        <source>Each question is about a point {0} after the lens&apos;s matrix, or about such a matrix.</source>
        <translation>Iga küsimus on punkti {0} kohta pärast objektiivi maatriksit või sellise maatriksi kohta.</translation>
    </message>
    <message>
        <source>A point comes out of the matrix as {0}. What is its {1} in NDC?</source>
        <translation>Maatriksist tuleb välja punkt {0}. Kui suur on selle {1} NDC-s?</translation>
    </message>
    <message>
        <source>This is still the first number of the row. In NDC it is divided by the last one, {0}. Look at point 1, which has {1} and {2} in clip space: it is inside the cube, where {3} is at most 1.</source>
        <translation>See on alles rea esimene arv. NDC-s jagatakse see viimasega, {0}. Vaadake punkti 1, millel on kärperuumis {1} ja {2}: see on kuubi sees, kus {3} on ülimalt 1.</translation>
    </message>
    <message>
        <source>w has the sign of z</source>
        <translation>w-l on z-i märk</translation>
    </message>
    <message>
        <source>The sign has changed: {0} already is the positive depth {1}, so divide by {2} itself. Look at point 1, which has {3} and {4} in clip space: it is in the right half of the picture.</source>
        <translation>Märk on muutunud: {0} juba ongi positiivne sügavus {1}, seega jagage suurusega {2} endaga. Vaadake punkti 1, millel on kärperuumis {3} ja {4}: see on pildi paremas pooles.</translation>
    </message>
    <message>
        <source>NDC is the result of the division.</source>
        <translation>NDC on jagamise tulemus.</translation>
    </message>
    <message>
        <source>{0}. The same w divides y and z.</source>
        <translation>{0}. Sama w jagab ka y-i ja z-i.</translation>
    </message>
    <message>
        <source>Lecture 000: with {0} in row 4, column 3 the matrix has 1 in row 1, column 1. Multiply the matrix by the {1} that makes row 4, column 3 equal to {2}; let {3}. What is in row 1, column 1 then?</source>
        <translation>Loeng 000: kui reas 4 ja veerus 3 on {0}, on maatriksi reas 1 ja veerus 1 1. Korrutage maatriks sellise arvuga {1}, et rea 4 ja veeru 3 lahtriks saab {2}; olgu {3}. Mis on siis reas 1 ja veerus 1?</translation>
    </message>
    <message>
        <source>One minus is left over</source>
        <translation>Üks miinus jääb üle</translation>
    </message>
    <message>
        <source>{0} makes {1}, which is positive: both sides have a minus. Look at {2} in the lecture&apos;s scene: {3} is this length.</source>
        <translation>{0} annab {1}, mis on positiivne: miinus on mõlemal pool. Vaadake loengu stseenis suurust {2}: {3} on see pikkus.</translation>
    </message>
    <message>
        <source>{0} and {1} take a point to the same point. Multiply every cell.</source>
        <translation>{0} ja {1} viivad punkti samaks punktiks. Korrutage iga lahter.</translation>
    </message>
    <message>
        <source>{0}. All four resulting coordinates are four times as large, and their quotients are the same.</source>
        <translation>{0}. Kõik neli tulemuse koordinaati on neli korda suuremad ja nende jagatised on samad.</translation>
    </message>
    <message>
        <source>w = 0 before the lens</source>
        <translation>w = 0 enne objektiivi</translation>
    </message>
    <message>
        <source>{0} is not a point but a direction: a *point at infinity*. A matrix takes it like any other row, and a translation leaves it unchanged. Here P is at {1} along z: its {2} is 0 in the world, yet it has an image, because its w in clip space is not 0.</source>
        <translation>{0} ei ole punkt, vaid suund: *lõpmatuspunkt*. Maatriks teisendab seda nagu iga teist rida ja nihe jätab selle samaks. Siin on P kohal {1} piki z-telge: selle {2} on maailmas 0, ometi on sellel kujutis, sest selle w kärperuumis ei ole 0.</translation>
    </message>
    <message>
        <source>The image is 720 high and the field of view 70°. In which row is the image of the direction {0} in view space? Its {1} is {2}.</source>
        <translation>Pildi kõrgus on 720 ja frustumi nurk 70°. Millises reas on kaamerafreimi suuna {0} kujutis? Selle {1} on {2}.</translation>
    </message>
    <message>
        <source>Rows are counted from the top. {0} is positive, so the row is above the middle, 360. Look at the numbers beside the frame: 0 is at the top.</source>
        <translation>Ridu loetakse ülalt. {0} on positiivne, seega on rida keskkohast 360 kõrgemal. Vaadake numbreid raami kõrval: 0 on üleval.</translation>
    </message>
    <message>
        <source>This is a point ten steps along a line in this direction. The point at infinity depends on the direction alone: {0}. Look at P at {1}: it has not reached its vanishing point.</source>
        <translation>See on punkt kümme sammu mööda selle suuna sirget. Lõpmatuspunkt sõltub ainult suunast: {0}. Vaadake punkti P, kui {1}: see ei ole oma koondumispunkti jõudnud.</translation>
    </message>
    <message>
        <source>Row {0}.</source>
        <translation>Rida {0}.</translation>
    </message>
    <message>
        <source>{0}, so row 102.9. All lines in this direction meet there.</source>
        <translation>{0}, seega rida 102.9. Kõik selle suuna sirged kohtuvad seal.</translation>
    </message>
    <message>
        <source>Back to the prediction</source>
        <translation>Tagasi ennustuse juurde</translation>
    </message>
    <message>
        <source>It is tempting to read the fourth number as an extra and to drop it. But it is the divisor of the other three. {0} and {1} lie on one line through the origin of four-dimensional space, and this line stands for one point. That is why a matrix can divide: it writes the divisor into {2}. And if {3} is 0, the line stands for a direction, not for a point.</source>
        <translation>Ahvatlev on lugeda neljandat arvu lisandiks ja see ära jätta. Aga sellega jagatakse teised kolm. {0} ja {1} on ühel sirgel läbi neljamõõtmelise ruumi alguspunkti ja see sirge esindab üht punkti. Seepärast saab maatriks jagada: see kirjutab jagaja suurusesse {2}. Ja kui {3} on 0, esindab sirge suunda, mitte punkti.</translation>
    </message>
    <message>
        <source>Practise: divide</source>
        <translation>Harjutus: jagage</translation>
    </message>
    <message>
        <source>Point 1 comes out of the lens&apos;s matrix as {0}.</source>
        <translation>Punkt 1 tuleb objektiivi maatriksist välja kujul {0}.</translation>
    </message>
    <message>
        <source>Its row of numbers is {0}. What is its {1} in NDC?</source>
        <translation>Selle arvurida on {0}. Kui suur on selle {1} NDC-s?</translation>
    </message>
    <message>
        <source>This is still the first number of the row. In NDC it is divided by the last one, {0}. Look at point 1 in the cube: its {1} is between −1 and 1.</source>
        <translation>See on alles rea esimene arv. NDC-s jagatakse see viimasega, {0}. Vaadake kuubis punkti 1: selle {1} on −1 ja 1 vahel.</translation>
    </message>
    <message>
        <source>The sign has changed: {0} already is the positive depth {1}, so divide by {2} itself. Look at point 1 in the picture: it is on the side that the sign of {3} says.</source>
        <translation>Märk on muutunud: {0} juba ongi positiivne sügavus {1}, seega jagage suurusega {2} endaga. Vaadake punkti 1 pildil: see on sellel pool, mida ütleb {3} märk.</translation>
    </message>
    <message>
        <source>The third number divides</source>
        <translation>Jagab kolmas arv</translation>
    </message>
    <message>
        <source>This divides by the third number of the row. The divisor is the fourth one, {0}, which the matrix made of the depth. Look at point 1 in the cube: its {1} is between −1 and 1.</source>
        <translation>Nii jagatakse rea kolmanda arvuga. Jagaja on neljas, {0}, mille maatriks tegi sügavusest. Vaadake kuubis punkti 1: selle {1} on −1 ja 1 vahel.</translation>
    </message>
    <message>
        <source>Which of the four numbers is the divisor?</source>
        <translation>Milline neljast arvust on jagaja?</translation>
    </message>
    <message>
        <source>The same {0} divides the first three numbers.</source>
        <translation>Esimesed kolm arvu jagab sama {0}.</translation>
    </message>
    <message>
        <source>Practise: the same matrix, multiplied</source>
        <translation>Harjutus: sama maatriks, korrutatud</translation>
    </message>
    <message>
        <source>Lecture 000 projects onto the plane {0} by a matrix {1} with 1, 1, 1, 0 on its diagonal, {2} in row 4, column 3, and 0 elsewhere. {3} and {4} take every point to the same point.</source>
        <translation>Loeng 000 projitseerib tasandile {0} maatriksiga {1}, mille diagonaalil on 1, 1, 1, 0, reas 4 ja veerus 3 on {2} ja mujal 0. {3} ja {4} viivad iga punkti samaks punktiks.</translation>
    </message>
    <message>
        <source>{0}. Which {1} has {2} in row 4, column 3? Give its rows 3 and 4, columns 3 and 4.</source>
        <translation>{0}. Millisel maatriksil {1} on reas 4 ja veerus 3 {2}? Kirjutage selle read 3 ja 4, veerud 3 ja 4.</translation>
    </message>
    <message>
        <source>{0} makes {1}, which is positive: both sides have a minus. Look at {2}: {3} is this length.</source>
        <translation>{0} annab {1}, mis on positiivne: miinus on mõlemal pool. Vaadake suurust {2}: {3} on see pikkus.</translation>
    </message>
    <message>
        <source>One cell is enough</source>
        <translation>Ühest lahtrist piisab</translation>
    </message>
    <message>
        <source>This changes one cell only. {0} multiplies every cell of the matrix, the ones on the diagonal too. Look at {1}: only for this plane is 1 right.</source>
        <translation>Nii muudetakse ainult üht lahtrit. {0} korrutab maatriksi iga lahtrit, ka ühtesid diagonaalil. Vaadake juhtu {1}: ainult selle tasandi jaoks on 1 õige.</translation>
    </message>
    <message>
        <source>The diagonal is divided</source>
        <translation>Diagonaal jagatakse</translation>
    </message>
    <message>
        <source>This multiplies the diagonal by {0}, but the last row by {1}. All cells have the same factor. Look at {2}: only for this plane are {3} and {4} the same.</source>
        <translation>Nii korrutatakse diagonaal suurusega {0}, aga viimane rida suurusega {1}. Kõigil lahtritel on sama kordaja. Vaadake juhtu {2}: ainult selle tasandi jaoks on {3} ja {4} samad.</translation>
    </message>
    <message>
        <source>By what is {0} multiplied to become {1}?</source>
        <translation>Millega korrutada {0}, et saada {1}?</translation>
    </message>
    <message>
        <source>{0}. All four numbers of a point are {1} times as large, and their quotients are the same.</source>
        <translation>{0}. Kõik neli punkti arvu on {1} korda suuremad ja nende jagatised on samad.</translation>
    </message>
    <message>
        <source>Practise: a direction in the picture</source>
        <translation>Harjutus: suund pildil</translation>
    </message>
    <message>
        <source>Lines in one direction of view space run to one point of the picture: the image of {0}.</source>
        <translation>Kaamerafreimi ühe suuna sirged jooksevad pildi ühte punkti, milleks on suuna {0} kujutis.</translation>
    </message>
    <message>
        <source>A line starts at {0} in view space and runs along {1}. The field of view is {2}°. Mark the image of the line&apos;s point at infinity.</source>
        <translation>Sirge algab kaamerafreimis punktist {0} ja kulgeb suunas {1}. Frustumi nurk on {2}°. Märkige sirge lõpmatuspunkti kujutis.</translation>
    </message>
    <message>
        <source>This is a point five steps along the line. At infinity {0}, and the start has no part in the image: only the direction counts. Look at point 1, 60 steps along the line: it has moved on.</source>
        <translation>See on punkt viis sammu mööda sirget. Lõpmatuses {0} ja alguspunktil ei ole kujutises osa: loeb ainult suund. Vaadake punkti 1, 60 sammu mööda sirget: see on edasi liikunud.</translation>
    </message>
    <message>
        <source>The column is right, but the rows are counted from the top: a direction that leads up ends in the upper half of the picture. Look at point 1, 60 steps along the line.</source>
        <translation>Veerg on õige, aga ridu loetakse ülalt: ülespoole viiv suund lõpeb pildi ülemises pooles. Vaadake punkti 1, 60 sammu mööda sirget.</translation>
    </message>
    <message>
        <source>{0}, where *aspect* is 16/9.</source>
        <translation>{0}, kus *aspect* on 16/9.</translation>
    </message>
    <message>
        <source>{0} is the middle of the picture and {1} its right edge; {2} is its top.</source>
        <translation>{0} on pildi keskkoht ja {1} selle parem serv; {2} on ülemine.</translation>
    </message>
    <message>
        <source>The direction takes the place of a point: {0} and {1} are its clip coordinates divided by their {2}.</source>
        <translation>Punkti asemele tuleb suund: {0} ja {1} on selle kärperuumi koordinaadid, jagatud nende suurusega {2}.</translation>
    </message>
    <message>
        <source>Practise: where the divide belongs</source>
        <translation>Harjutus: kuhu kuulub jagamine</translation>
    </message>
    <message>
        <source>Put the tiles in order, and leave out what does not belong.</source>
        <translation>Seadke lülid järjekorda ja jätke välja see, mis sinna ei kuulu.</translation>
    </message>
    <message>
        <source>The letter was turned about y by {0}° and moved by {1} along x; the eye is at {2}. Which chain takes a point of the letter to NDC?</source>
        <translation>Tähte pöörati ümber y-telje {0}° ja nihutati {1} võrra piki x-telge; silm on kohal {2}. Milline ahel viib tähe punkti NDC-sse?</translation>
    </message>
    <message>
        <source>A point {0} is scaled by {1}, then moved by {2}, then divided. Which chain is that?</source>
        <translation>Punkti {0} skaleeritakse arvuga {1}, nihutatakse siis vektori {2} võrra ja jagatakse siis. Milline ahel see on?</translation>
    </message>
    <message>
        <source>The viewport needs numbers from −1 to 1.</source>
        <translation>Viewport vajab arve −1-st 1-ni.</translation>
    </message>
    <message>
        <source>Which chain leads from view space to {0} by 400 pixels?</source>
        <translation>Milline ahel viib kaamerafreimist pildile, milles on {0} korda 400 pikslit?</translation>
    </message>
    <message>
        <source>Only one division makes them. Which one leaves {0}?</source>
        <translation>Sellised teeb ainult üks jagamine. Kumma jagamise järel on {0}?</translation>
    </message>
    <message>
        <source>The lens&apos;s matrix writes the divisor into {0}, the division makes {1} and {2}, and the viewport makes pixels of these.</source>
        <translation>Objektiivi maatriks kirjutab jagaja suurusesse {0}, jagamine teeb {1} ja {2} ning viewport teeb neist pikslid.</translation>
    </message>
    <message>
        <source>Begin at the letter: which matrix takes its points to the world?</source>
        <translation>Alustage tähest: milline maatriks viib selle punktid maailma?</translation>
    </message>
    <message>
        <source>From the letter to the world, to the camera, through the lens, and at last the division.</source>
        <translation>Tähest maailma, kaamerani, läbi objektiivi ja lõpuks jagamine.</translation>
    </message>
    <message>
        <source>What acts first stands at the bottom.</source>
        <translation>Mis mõjub esimesena, on all.</translation>
    </message>
    <message>
        <source>The scale acts first, so it does not change the move. The division may stand anywhere: neither matrix changes {0}.</source>
        <translation>Skaleerimine mõjub esimesena, nii et see nihet ei muuda. Jagamine võib olla kus tahes: kumbki maatriks ei muuda suurust {0}.</translation>
    </message>
</context>
<context>
    <name>l14-to-pixels</name>
    <message>
        <source>From NDC to pixels</source>
        <translation>NDC-st piksliteni</translation>
    </message>
    <message>
        <source>Which row is the top?</source>
        <translation>Milline rida on ülemine?</translation>
    </message>
    <message>
        <source>The picture is 1280 × 720 pixels. NDC goes from −1 to 1 in x and y, with y upwards.</source>
        <translation>Pilt on 1280 × 720 pikslit. NDC x ja y on −1-st 1-ni, y suunaga üles.</translation>
    </message>
    <message>
        <source>A point has {0}. At which y of the image is it?</source>
        <translation>Ühel punktil on {0}. Millise y-i kohal on see pildil?</translation>
    </message>
    <message>
        <source>In NDC y runs upwards, but the rows of an image are counted from the top, as you read. 720 is the lower edge. Look at point 1, at {0}, and at the numbers beside the frame: 720 is at the bottom.</source>
        <translation>NDC-s kasvab y ülespoole, aga pildi ridu loetakse ülalt, nagu te loete. 720 on alumine serv. Vaadake punkti 1, mille {0}, ja numbreid raami kõrval: 720 on all.</translation>
    </message>
    <message>
        <source>360, in the middle</source>
        <translation>360, keskel</translation>
    </message>
    <message>
        <source>The middle is at {0}, because NDC goes from −1 to 1. {1} is an edge of the picture. Look at point 1, at {2}: it is in the middle.</source>
        <translation>Keskkohas on {0}, sest NDC on −1-st 1-ni. {1} on pildi serv. Vaadake punkti 1, mille {2}: see on keskel.</translation>
    </message>
    <message>
        <source>The rows of an image are counted from the top, as you read. {0} reverses y.</source>
        <translation>Pildi ridu loetakse ülalt, nagu te loete. {0} pöörab y-i ümber.</translation>
    </message>
    <message>
        <source>The viewport transform</source>
        <translation>Viewport-teisendus</translation>
    </message>
    <message>
        <source>where {0} and {1} are the image&apos;s width and height. Point 1 has {2} and {3}:</source>
        <translation>kus {0} ja {1} on pildi laius ja kõrgus. Punktil 1 on {2} ja {3}:</translation>
    </message>
    <message>
        <source>The Probe panel shows both, in the rows *NDC* and *image px*. A whole number is an edge between pixels: the first pixel goes from 0 to 1, and its centre is at 0.5.</source>
        <translation>Paneel Sond näitab mõlemat ridades *NDC* ja *pilt px*. Täisarv on serv pikslite vahel: esimene piksel on 0-st 1-ni ja selle keskpunkt on kohal 0.5.</translation>
    </message>
    <message>
        <source>Into the corner</source>
        <translation>Nurka</translation>
    </message>
    <message>
        <source>Point 1 is a corner of the F.</source>
        <translation>Punkt 1 on üks F-i nurk.</translation>
    </message>
    <message>
        <source>Bring point 1 within one pixel of (0, 0).</source>
        <translation>Viige punkt 1 kohast (0, 0) vähem kui ühe piksli kaugusele.</translation>
    </message>
    <message>
        <source>Drag its mark in *Image*, or move the camera.</source>
        <translation>Lohistage selle märki paanis *Pilt* või liigutage kaamerat.</translation>
    </message>
    <message>
        <source>In NDC it must come to {0}.</source>
        <translation>NDC-s peab see sattuma kohale {0}.</translation>
    </message>
    <message>
        <source>(0, 0) is the upper left corner of the picture: x&apos; is −1 there, and y&apos; is 1.</source>
        <translation>(0, 0) on pildi ülemine vasak nurk: seal on x&apos; −1 ja y&apos; 1.</translation>
    </message>
    <message>
        <source>By the formula</source>
        <translation>Valemi järgi</translation>
    </message>
    <message>
        <source>The image has 1280 × 720 pixels.</source>
        <translation>Pildil on 1280 × 720 pikslit.</translation>
    </message>
    <message>
        <source>What is in row 2, column 2 of image ← NDC?</source>
        <translation>Mis on maatriksi pilt ← NDC reas 2 ja veerus 2?</translation>
    </message>
    <message>
        <source>With this cell, {0} would come to the lowest row. Rows are counted from the top, so {1} changes its sign. Look at point 1, at {2}: it is at the top, in row 0.</source>
        <translation>Sellise lahtriga satuks {0} kõige alumisse ritta. Ridu loetakse ülalt, nii et {1} vahetab märki. Vaadake punkti 1, mille {2}: see on üleval, real 0.</translation>
    </message>
    <message>
        <source>This takes {0} to run from 0 to 1. It runs from −1 to 1, over a length of 2, so each unit of {1} is half the height. Look at point 1, at {2}: it is in the middle of the picture, and only half the height is left above it.</source>
        <translation>Nii eeldatakse, et {0} on 0-st 1-ni. See on −1-st 1-ni, pikkusega 2, nii et iga {1} ühik on pool kõrgusest. Vaadake punkti 1, mille {2}: see on pildi keskel ja sellest ülespoole jääb ainult pool kõrgusest.</translation>
    </message>
    <message>
        <source>It is the factor of {0}.</source>
        <translation>See on kordaja suuruse {0} ees.</translation>
    </message>
    <message>
        <source>{0}: half the height, because NDC is 2 high, and negative, because y is reversed.</source>
        <translation>{0}: pool kõrgusest, sest NDC kõrgus on 2, ja negatiivne, sest y on ümber pööratud.</translation>
    </message>
    <message>
        <source>This counts the rows upwards, like {0}. They are counted from the top, so a point above the middle has a y below 360. Look at point 1: it is above the middle of the picture.</source>
        <translation>Nii loetakse ridu alt üles, nagu kasvab {0}. Neid loetakse ülalt, nii et keskkohast kõrgemal oleva punkti y on väiksem kui 360. Vaadake punkti 1: see on pildi keskkohast kõrgemal.</translation>
    </message>
    <message>
        <source>This takes {0} to run from 0 to 1. It runs from −1 to 1 and is 0 in the middle of the picture. Look at point 1: it is above the middle, so its row is less than 360.</source>
        <translation>Nii eeldatakse, et {0} on 0-st 1-ni. See on −1-st 1-ni ja pildi keskel 0. Vaadake punkti 1: see on keskkohast kõrgemal, seega on selle rida väiksem kui 360.</translation>
    </message>
    <message>
        <source>Four pixels wide</source>
        <translation>Nelja piksli laiune</translation>
    </message>
    <message>
        <source>This image has 4 × 2 pixels, counted from 0.</source>
        <translation>Selles pildis on 4 × 2 pikslit, loetud alates 0-st.</translation>
    </message>
    <message>
        <source>At which {0} is the centre of pixel 1?</source>
        <translation>Millise {0} juures on piksli 1 keskpunkt?</translation>
    </message>
    <message>
        <source>This is the left edge of pixel 1. Its centre is half a pixel farther. Look at the numbers beside the frame, from 0 to 4: pixel 1 reaches from 1 to 2, and its centre is at 1.5.</source>
        <translation>See on piksli 1 vasak serv. Selle keskpunkt on poole piksli võrra edasi. Vaadake numbreid raami kõrval, 0-st 4-ni: piksel 1 ulatub 1-st 2-ni ja selle keskpunkt on kohal 1.5.</translation>
    </message>
    <message>
        <source>This is the share of the width, from 0 to 1. {0} runs from −1 to 1. Look at the numbers beside the frame, from 0 to 4: 1.5 is left of the middle, where {1} is negative.</source>
        <translation>See on osa laiusest, 0-st 1-ni. {0} on −1-st 1-ni. Vaadake numbreid raami kõrval, 0-st 4-ni: 1.5 on keskkohast vasakul, kus {1} on negatiivne.</translation>
    </message>
    <message>
        <source>Pixel 1 goes from 1 to 2 along the image.</source>
        <translation>Piksel 1 on piki pilti 1-st 2-ni.</translation>
    </message>
    <message>
        <source>{0}. The outermost centres are at {1}, not at {2}.</source>
        <translation>{0}. Kõige äärmised keskpunktid on kohtadel {1}, mitte kohtadel {2}.</translation>
    </message>
    <message>
        <source>Back to the prediction</source>
        <translation>Tagasi ennustuse juurde</translation>
    </message>
    <message>
        <source>In a diagram y goes up, and in NDC too, so 720 is tempting for the top. But an image is stored row by row from the top, and y of the image counts these rows. The minus in {0} does all the work. If you forget it, the picture is upside down, and you notice. If you forget the half pixel, the picture is shifted by half a pixel, and you do not notice.</source>
        <translation>Diagrammil kasvab y ülespoole ja NDC-s samuti, nii et ülemise serva jaoks on ahvatlev 720. Aga pilt salvestatakse ridade kaupa ülalt alates ja pildi y loeb neid ridu. Avaldises {0} teeb kogu töö miinus. Kui te selle unustate, on pilt tagurpidi ja te märkate seda. Kui te unustate poole piksli, on pilt poole piksli võrra nihkes ja te ei märka seda.</translation>
    </message>
    <message>
        <source>Practise: the viewport as a matrix</source>
        <translation>Harjutus: viewport maatriksina</translation>
    </message>
    <message>
        <source>The viewport transform takes {0} to {1} by two rows of three numbers.</source>
        <translation>Viewport-teisendus viib {0} punktiks {1} kahe reaga, milles on kolm arvu.</translation>
    </message>
    <message>
        <source>The image has {0} × {1} pixels. Write down the two rows.</source>
        <translation>Pildis on {0} × {1} pikslit. Kirjutage need kaks rida.</translation>
    </message>
    <message>
        <source>With this, {0} comes to the lowest row. Rows are counted from the top: {1}. Look at point 1, at {2}: it is at the top, in row 0.</source>
        <translation>Nii satub {0} kõige alumisse ritta. Ridu loetakse ülalt: {1}. Vaadake punkti 1, mille {2}: see on üleval, real 0.</translation>
    </message>
    <message>
        <source>This takes {0} and {1} to run from 0 to 1. They run from {2} to {3}, over a length of 2, with 0 in the middle of the picture. Look at point 1, at {4}: it is in the middle of the picture.</source>
        <translation>Nii eeldatakse, et {0} ja {1} on 0-st 1-ni. Need on kohast {2} kohani {3}, pikkusega 2, ja pildi keskel on 0. Vaadake punkti 1, mille {4}: see on pildi keskel.</translation>
    </message>
    <message>
        <source>0 is the corner</source>
        <translation>0 on nurk</translation>
    </message>
    <message>
        <source>The factors are right. But {0} is the middle of the picture, at {1}, and this takes it to the corner. Look at point 1, at {2}: it is in the middle of the picture.</source>
        <translation>Kordajad on õiged. Aga {0} on pildi keskkoht, kohal {1}, ja nii satub see nurka. Vaadake punkti 1, mille {2}: see on pildi keskel.</translation>
    </message>
    <message>
        <source>Where do {0} and {1} come to? And {2}?</source>
        <translation>Kuhu satuvad {0} ja {1}? Ja {2}?</translation>
    </message>
    <message>
        <source>{0} and {1}.</source>
        <translation>{0} ja {1}.</translation>
    </message>
    <message>
        <source>Practise: find a point</source>
        <translation>Harjutus: leidke punkt</translation>
    </message>
    <message>
        <source>{0} and {1} run from {2} to {3} in the picture.</source>
        <translation>{0} ja {1} on pildil kohast {2} kohani {3}.</translation>
    </message>
    <message>
        <source>Mark where a point with {0} and {1} is.</source>
        <translation>Märkige, kus on punkt, mille {0} ja {1}.</translation>
    </message>
    <message>
        <source>The column is right. But {0} runs upwards: {1} is the top of the picture. Look at point 1, at {2}: it is close to the top.</source>
        <translation>Veerg on õige. Aga {0} kasvab ülespoole: {1} on pildi ülemine serv. Vaadake punkti 1, mille {2}: see on ülemise serva lähedal.</translation>
    </message>
    <message>
        <source>This takes {0} and {1} for shares of the picture from 0 to 1. Both are 0 in the middle of the picture, and {2} at its left and lower edges. Look at point 1, at {3}.</source>
        <translation>Nii võetakse {0} ja {1} pildi osadeks 0-st 1-ni. Mõlemad on pildi keskel 0 ning selle vasakul ja alumisel serval {2}. Vaadake punkti 1, mille {3}.</translation>
    </message>
    <message>
        <source>Where is {0}, and where {1}?</source>
        <translation>Kus on {0} ja kus {1}?</translation>
    </message>
    <message>
        <source>{0} and {1}, where {2} and {3} are the image&apos;s width and height.</source>
        <translation>{0} ja {1}, kus {2} ja {3} on pildi laius ja kõrgus.</translation>
    </message>
    <message>
        <source>Practise: the centre of a pixel</source>
        <translation>Harjutus: piksli keskpunkt</translation>
    </message>
    <message>
        <source>The pixels of a row are counted from 0. {0} runs from {1} at the left edge of the picture to {2} at the right.</source>
        <translation>Rea piksleid loetakse alates 0-st. {0} kasvab väärtusest {1} pildi vasakul serval väärtuseni {2} paremal.</translation>
    </message>
    <message>
        <source>The image is {0} pixels wide. At which {1} is the centre of pixel {2}?</source>
        <translation>Pildi laius on {0} pikslit. Millise {1} juures on piksli {2} keskpunkt?</translation>
    </message>
    <message>
        <source>This is the left edge of the pixel. Its centre is half a pixel farther, at {0}. Look at the numbers beside the frame, from 0 to {1}: pixel {2} reaches from {3} to {4}.</source>
        <translation>See on piksli vasak serv. Selle keskpunkt on poole piksli võrra edasi, kohal {0}. Vaadake numbreid raami kõrval, 0-st kuni {1}: piksel {2} ulatub kohast {3} kohani {4}.</translation>
    </message>
    <message>
        <source>This is its share of the width, from 0 to 1. {0} runs from {1} to {2}: take it twice and subtract 1. Look at the numbers beside the frame, from 0 to {3}: half-way is {4}, not {5}.</source>
        <translation>See on osa laiusest, 0-st 1-ni. {0} kasvab väärtusest {1} väärtuseni {2}: võtke see kaks korda ja lahutage 1. Vaadake numbreid raami kõrval, 0-st kuni {3}: poolel teel on {4}, mitte {5}.</translation>
    </message>
    <message>
        <source>The outermost centres are at the edges</source>
        <translation>Kõige äärmised keskpunktid on servadel</translation>
    </message>
    <message>
        <source>This puts the centres of the outermost pixels at {0} and {1}. These are the edges of the picture; the outermost centres are half a pixel inside. Look at the numbers beside the frame, from 0 to {2}: the first centre is at 0.5.</source>
        <translation>Nii satuvad äärmiste pikslite keskpunktid kohtadele {0} ja {1}. Need on pildi servad; äärmised keskpunktid on poole piksli võrra seespool. Vaadake numbreid raami kõrval, 0-st kuni {2}: esimene keskpunkt on kohal 0.5.</translation>
    </message>
    <message>
        <source>Pixel {0} reaches from {1} to {2} along the row.</source>
        <translation>Piksel {0} ulatub piki rida kohast {1} kohani {2}.</translation>
    </message>
    <message>
        <source>The centre is at {0}, and {1} pixels are 2 wide in {2}.</source>
        <translation>Keskpunkt on kohal {0} ja pikslite arvu {1} laius on suuruses {2} kokku 2.</translation>
    </message>
</context>
<context>
    <name>l15-clipping</name>
    <message>
        <source>What is cut, and when?</source>
        <translation>Mida lõigatakse ja millal?</translation>
    </message>
    <message>
        <source>Behind, and in the middle</source>
        <translation>Taga ja ometi keskel</translation>
    </message>
    <message>
        <source>The eye looks along {0}. A point lies behind it, at {1} in view space. If you divide by its {2} anyway, {3} and {4} are between −1 and 1.</source>
        <translation>Silm vaatab suunas {0}. Üks punkt on selle taga, kaamerafreimis kohal {1}. Kui te jagate sellest hoolimata arvuga {2}, on {3} ja {4} −1 ja 1 vahel.</translation>
    </message>
    <message>
        <source>Is the point drawn?</source>
        <translation>Kas see punkt joonistatakse?</translation>
    </message>
    <message>
        <source>No</source>
        <translation>Ei</translation>
    </message>
    <message>
        <source>Yes: its {0} and {1} are within the picture</source>
        <translation>Jah: selle {0} ja {1} on pildi piires</translation>
    </message>
    <message>
        <source>What is in the picture is in front</source>
        <translation>Mis on pildil, on ees</translation>
    </message>
    <message>
        <source>After the division it looks like a point of the picture, but {0} says that it is behind the eye. The test comes before the division, while the sign of {1} is still there. Look from above: point 1 is behind the eye.</source>
        <translation>Pärast jagamist näeb see välja nagu pildi punkt, aga {0} ütleb, et see on silma taga. Kontrollitakse enne jagamist, kui {1} märk on veel alles. Vaadake ülalt: punkt 1 on silma taga.</translation>
    </message>
    <message>
        <source>Yes, but upside down</source>
        <translation>Jah, aga tagurpidi</translation>
    </message>
    <message>
        <source>A camera is a dark box</source>
        <translation>Kaamera on pime kast</translation>
    </message>
    <message>
        <source>The division would draw it mirrored, as on a film behind a hole. But a camera draws only what is in front of it: the point is removed before the division. Look from above: point 1 is behind the eye, and nothing of the pyramid is there.</source>
        <translation>Jagamine joonistaks selle peegeldatult, nagu ava taga olevale filmile. Aga kaamera joonistab ainult seda, mis on selle ees: punkt eemaldatakse enne jagamist. Vaadake ülalt: punkt 1 on silma taga ja seal ei ole püramiidist midagi.</translation>
    </message>
    <message>
        <source>A point is kept if {0}. No point with a negative w satisfies this. The test comes before the division.</source>
        <translation>Punkt jääb alles, kui {0}. Ükski negatiivse w-ga punkt seda ei rahulda. Kontrollitakse enne jagamist.</translation>
    </message>
    <message>
        <source>Six planes</source>
        <translation>Kuus tasandit</translation>
    </message>
    <message>
        <source>Before the division the six planes of every lens are the same: {0}. What is wholly inside is drawn, what is wholly beyond one of them is not, and what crosses a plane is cut. An edge from {1} to {2} meets {3} at</source>
        <translation>Enne jagamist on iga objektiivi kuus tasandit samad: {0}. Mis on tervenisti sees, joonistatakse, mis on tervenisti mõne tasandi taga, mitte, ja mis tasandit läbib, lõigatakse läbi. Serv punktist {1} punkti {2} kohtab tasandit {3} kohal</translation>
    </message>
    <message>
        <source>From {0} to {1}: {2}.</source>
        <translation>Punktist {0} punkti {1}: {2}.</translation>
    </message>
    <message>
        <source>Step through *Planes that have cut*: each plane cuts what the plane before it has left, and adds two new corners where it crosses. The highlighted face of the cube is the plane of the step.</source>
        <translation>Minge samm-sammult läbi *Tasandid, mis on lõiganud*: iga tasand lõikab seda, mille eelmine tasand on alles jätnud, ja lisab kaks uut nurka sinna, kus piiri läbib. Esile tõstetud kuubi tahk on selle sammu tasand.</translation>
    </message>
    <message>
        <source>One edge, two planes</source>
        <translation>Üks serv, kaks tasandit</translation>
    </message>
    <message>
        <source>Points 1 and 2 are the ends of an edge: one is 4 units in front of the eye, the other 12. Both are inside.</source>
        <translation>Punktid 1 ja 2 on serva otsad: üks on silmast 4 ühikut eespool, teine 12. Mõlemad on sees.</translation>
    </message>
    <message>
        <source>Let the edge cross near and far, so that both planes cut it.</source>
        <translation>Tehke nii, et serv läbib lähi- ja kaugtasandi ja mõlemad tasandid lõikavad seda.</translation>
    </message>
    <message>
        <source>Near must lie beyond point 1, far in front of point 2.</source>
        <translation>Lähitasand peab olema punkti 1 taga, kaugtasand punkti 2 ees.</translation>
    </message>
    <message>
        <source>The planes cut the edge into three pieces; the piece between them is drawn.</source>
        <translation>Tasandid lõikavad serva kolmeks tükiks; nende vahel olev tükk joonistatakse.</translation>
    </message>
    <message>
        <source>Where it is cut</source>
        <translation>Kust see lõigatakse</translation>
    </message>
    <message>
        <source>Here are the test points A to E. The eye is at {0} and looks along {1}; far is 11. C is at {2}.</source>
        <translation>Siin on katsepunktid A kuni E. Silm on kohal {0} ja vaatab suunas {1}; kaugtasand on 11. C on kohal {2}.</translation>
    </message>
    <message>
        <source>An edge runs from {0} to {1} in clip space. At which t does it meet {2}?</source>
        <translation>Serv läheb kärperuumis punktist {0} punkti {1}. Millise t juures kohtab see tasandit {2}?</translation>
    </message>
    <message>
        <source>This looks for {0}. Before the division the plane is {1}, and {2} changes along the edge as well. Look from above at the side of the pyramid: it slants, because there {3}.</source>
        <translation>Nii otsitakse kohta {0}. Enne jagamist on tasandiks {1} ja ka {2} muutub piki serva. Vaadake ülalt püramiidi külge: see on kaldu, sest seal {3}.</translation>
    </message>
    <message>
        <source>The share in the picture is the share of the edge</source>
        <translation>Osa pildil on osa servast</translation>
    </message>
    <message>
        <source>This is the place in the picture, after the division. Along the edge itself {0} changes evenly, {1} does not. Look from above at the side of the pyramid: an edge is cut there, in the world, before it is drawn.</source>
        <translation>See on koht pildil, pärast jagamist. Piki serva ennast muutub ühtlaselt {0}, mitte {1}. Vaadake ülalt püramiidi külge: serv lõigatakse seal, maailmas, enne kui see joonistatakse.</translation>
    </message>
    <message>
        <source>{0} is 1 at one end and −5 at the other. Where is it 0?</source>
        <translation>{0} on ühes otsas 1 ja teises −5. Kus on see 0?</translation>
    </message>
    <message>
        <source>{0}. Both x and w change along the edge; in NDC the same place is at 4/9.</source>
        <translation>{0}. Piki serva muutuvad nii x kui ka w; NDC-s on sama koht 4/9 peal.</translation>
    </message>
    <message>
        <source>From which value of far on is C inside?</source>
        <translation>Millisest kaugtasandi väärtusest alates on C sees?</translation>
    </message>
    <message>
        <source>This measures straight from the eye to C. The far plane is a plane, not a sphere: only the depth along the axis counts. Look from above at far = 12.5: C is inside, though it is 13.9 away.</source>
        <translation>Nii mõõdetakse silmast otse C-ni. Kaugtasand on tasand, mitte kera: loeb ainult sügavus piki telge. Vaadake ülalt, kui kaugtasand = 12.5: C on sees, kuigi see on 13.9 kaugusel.</translation>
    </message>
    <message>
        <source>The far plane is a plane: only the depth matters.</source>
        <translation>Kaugtasand on tasand: loeb ainult sügavus.</translation>
    </message>
    <message>
        <source>{0}, however far C is to the side.</source>
        <translation>{0}, ükskõik kui kaugel kõrval C on.</translation>
    </message>
    <message>
        <source>Just four</source>
        <translation>Ainult neli</translation>
    </message>
    <message>
        <source>A test point with a grey name is outside.</source>
        <translation>Halli nimega katsepunkt on väljas.</translation>
    </message>
    <message>
        <source>With near and far alone, make exactly four of the five test points lie inside.</source>
        <translation>Tehke ainult lähi- ja kaugtasandiga nii, et viiest katsepunktist oleks sees täpselt neli.</translation>
    </message>
    <message>
        <source>Which points lie outside because of their depth, and which are beyond a side?</source>
        <translation>Millised punktid on väljas oma sügavuse tõttu ja millised jäävad mõnest küljest väljapoole?</translation>
    </message>
    <message>
        <source>Take far back, and watch *test points inside*.</source>
        <translation>Viige kaugtasand kaugemale ja jälgige arvu *katsepunkte sees*.</translation>
    </message>
    <message>
        <source>Neither near nor far brings back what the sides cut off.</source>
        <translation>Seda, mille küljed ära lõikavad, ei too tagasi ei lähi- ega kaugtasand.</translation>
    </message>
    <message>
        <source>Back to the prediction</source>
        <translation>Tagasi ennustuse juurde</translation>
    </message>
    <message>
        <source>&quot;Its {0} is between −1 and 1, so it is in the picture&quot;: that is tempting, because after the division no other test is left. But the division has lost the sign of {1}. A point behind the eye then looks like one in front of it, upside down and on the other side. So clip before the division, by {2}; the near plane removes everything without a positive {3}.</source>
        <translation>„Selle {0} on −1 ja 1 vahel, seega on see pildil“: see on ahvatlev, sest pärast jagamist ei ole enam muud kontrolli. Aga jagamine on kaotanud {1} märgi. Silma taga olev punkt näeb siis välja nagu ees olev, tagurpidi ja teisel pool. Seepärast kärpige enne jagamist, tingimusega {2}; lähitasand eemaldab kõik, mille {3} ei ole positiivne.</translation>
    </message>
    <message>
        <source>Practise: where an edge leaves</source>
        <translation>Harjutus: kus serv väljub</translation>
    </message>
    <message>
        <source>The edge from point 1 to point 2 leaves the view volume at the plane {0}. It is cut before the division.</source>
        <translation>Serv punktist 1 punkti 2 väljub nähtavast ruumist tasandil {0}. See lõigatakse enne jagamist.</translation>
    </message>
    <message>
        <source>In clip space point 1 has {0}, {1} and point 2 has {2}, {3}. At which {4}, from point 1 to point 2, does the edge meet {5}?</source>
        <translation>Kärperuumis on punktil 1 {0}, {1} ja punktil 2 {2}, {3}. Millise {4} juures, punktist 1 punkti 2, kohtab serv tasandit {5}?</translation>
    </message>
    <message>
        <source>This is the place in the picture, after the division. Along the edge itself {0} changes evenly, {1} does not. Look from above at the edge from 1 to 2: it is cut there, not in the picture.</source>
        <translation>See on koht pildil, pärast jagamist. Piki serva ennast muutub ühtlaselt {0}, mitte {1}. Vaadake ülalt serva 1-st 2-ni: see lõigatakse seal, mitte pildil.</translation>
    </message>
    <message>
        <source>{0} changes evenly along the edge. How large is it at point 1, and at point 2?</source>
        <translation>{0} muutub piki serva ühtlaselt. Kui suur on see punktis 1 ja punktis 2?</translation>
    </message>
    <message>
        <source>{0} is {1} at point 1 and negative at point 2; at {2} it is 0.</source>
        <translation>{0} võrdub punktis 1 suurusega {1} ja on punktis 2 negatiivne; kohal {2} on see 0.</translation>
    </message>
    <message>
        <source>Practise: cut by near</source>
        <translation>Harjutus: lõikab lähitasand</translation>
    </message>
    <message>
        <source>Point 1 is in front of the camera, point 2 behind it. The near plane cuts the edge between them.</source>
        <translation>Punkt 1 on kaamera ees, punkt 2 selle taga. Lähitasand lõikab nendevahelist serva.</translation>
    </message>
    <message>
        <source>In view space point 1 is at {0}, point 2 at {1}, and near is {2}. In this picture {3}. Mark where the image of the edge ends.</source>
        <translation>Kaamerafreimis on punkt 1 kohal {0}, punkt 2 kohal {1} ja lähitasand on {2}. Sellel pildil {3}. Märkige, kus serva kujutis lõpeb.</translation>
    </message>
    <message>
        <source>This divides point 2, which is behind the camera: its image is mirrored. First cut the edge at {0}, then divide. Look from above: point 2 is behind the eye, and near cuts the edge before it comes there.</source>
        <translation>Nii jagatakse punkti 2, mis on kaamera taga: selle kujutis on peegeldatud. Enne lõigake serv kohal {0}, siis jagage. Vaadake ülalt: punkt 2 on silma taga ja lähitasand lõikab serva, enne kui see sinna jõuab.</translation>
    </message>
    <message>
        <source>This goes from one image to the other by the right {0}. Cut the edge in view space: take {1} at this {2}, then divide. Look from above: near cuts the edge in the world.</source>
        <translation>Nii minnakse ühest kujutisest teiseni õige {0} võrra. Lõigake serv kaamerafreimis: võtke selle {2} juures {1}, siis jagage. Vaadake ülalt: lähitasand lõikab serva maailmas.</translation>
    </message>
    <message>
        <source>At which {0} is {1}? Go from {2} to {3}.</source>
        <translation>Millise {0} juures on {1}? Minge väärtusest {2} väärtuseni {3}.</translation>
    </message>
    <message>
        <source>{0} at the cut is {1}; {2} is the right edge of the picture.</source>
        <translation>{0} on lõikekohas {1}; {2} on pildi parem serv.</translation>
    </message>
    <message>
        <source>{0}, and the x there is divided by its depth {1}.</source>
        <translation>{0} ja sealne x jagatakse selle sügavusega {1}.</translation>
    </message>
    <message>
        <source>Practise: cut by far</source>
        <translation>Harjutus: lõikab kaugtasand</translation>
    </message>
    <message>
        <source>The far plane cuts the edge from point 1 to point 2; {0} is 0 at point 1 and 1 at point 2.</source>
        <translation>Kaugtasand lõikab serva punktist 1 punkti 2; {0} on 0 punktis 1 ja 1 punktis 2.</translation>
    </message>
    <message>
        <source>In view space point 1 is at {0} and point 2 at {1}. Set far so that it cuts the edge at {2}.</source>
        <translation>Kaamerafreimis on punkt 1 kohal {0} ja punkt 2 kohal {1}. Seadke kaugtasand nii, et see lõikab serva kohal {2}.</translation>
    </message>
    <message>
        <source>Which depth does the edge have at {0}? It changes evenly from {1} to {2}.</source>
        <translation>Milline on serva sügavus kohal {0}? See muutub ühtlaselt väärtusest {1} väärtuseni {2}.</translation>
    </message>
    <message>
        <source>{0} {1} {2}. How far the points are to the side does not matter.</source>
        <translation>{0} {1} {2}. Kui kaugel kõrval punktid on, ei loe.</translation>
    </message>
    <message>
        <source>This measures straight from the eye. Far is a plane across the axis, and only the depth counts. Look from above: your far cuts the edge too far out.</source>
        <translation>Nii mõõdetakse otse silmast. Kaugtasand on teljega risti olev tasand ja loeb ainult sügavus. Vaadake ülalt: teie kaugtasand lõikab serva liiga kaugel.</translation>
    </message>
</context>
<context>
    <name>l16-eye-plane</name>
    <message>
        <source>A line through the eye plane</source>
        <translation>Lõik läbi silmatasandi</translation>
    </message>
    <message>
        <source>Both ends have an image</source>
        <translation>Mõlemal otsal on kujutis</translation>
    </message>
    <message>
        <source>In camera space point 1 is A, at {0}, and point 2 is B, at {1}, behind the camera. With {2} the division gives {3} for each: 0.5 for A and −0.5 for B.</source>
        <translation>Kaamerafreimis on punkt 1 A, kohal {0}, ja punkt 2 B, kohal {1}, kaamera taga. Kui {2}, annab jagamine kummagi jaoks {3}: A jaoks 0.5 ja B jaoks −0.5.</translation>
    </message>
    <message>
        <source>Which {0} does the image of the segment AB cover?</source>
        <translation>Milliseid {0} väärtusi katab lõigu AB kujutis?</translation>
    </message>
    <message>
        <source>From 0.5 to −0.5, the way from one to the other</source>
        <translation>0.5-st −0.5-ni, ühest teiseni</translation>
    </message>
    <message>
        <source>This divides both ends and joins the results. B is behind the camera, so its image is mirrored. On the way from A, {0} goes to 0 and {1} beyond every bound: the image runs through infinity, not from 0.5 to −0.5. Look at A&apos; and B&apos;: the line that joins them is wrong.</source>
        <translation>Nii jagatakse mõlema otsa koordinaadid ja ühendatakse tulemused. B on kaamera taga, seega on selle kujutis peegeldatud. Teel A-st läheneb {0} arvule 0 ja {1} kasvab tõkestamatult: kujutis läheb läbi lõpmatuse, mitte 0.5-st −0.5-ni. Vaadake punkte A&apos; ja B&apos;: joon, mis neid ühendab, on vale.</translation>
    </message>
    <message>
        <source>From 0.5 to infinity</source>
        <translation>0.5-st lõpmatuseni</translation>
    </message>
    <message>
        <source>Just 0.5: B is behind the camera and does not count</source>
        <translation>Ainult 0.5: B on kaamera taga ega loe</translation>
    </message>
    <message>
        <source>A is only one end. The half of AB between A and the plane {0} is in front of the camera, and every point of it has an image. Look at the image: it begins at A&apos; and leaves the picture on the right.</source>
        <translation>A on ainult üks ots. See pool lõigust AB, mis on A ja tasandi {0} vahel, on kaamera ees ja selle igal punktil on kujutis. Vaadake pilti: kujutis algab punktist A&apos; ja väljub pildilt paremalt.</translation>
    </message>
    <message>
        <source>From A the segment approaches the eye plane {0}; x stays 1, so {1} grows beyond every bound. The part behind the eye plane has no image.</source>
        <translation>A-st alates läheneb lõik silmatasandile {0}; x jääb 1, nii et {1} kasvab tõkestamatult. Silmatasandi taga oleval osal kujutist ei ole.</translation>
    </message>
    <message>
        <source>Cut before the divide</source>
        <translation>Lõigake enne jagamist</translation>
    </message>
    <message>
        <source>Lecture 004 cuts the segment at {0} before dividing:</source>
        <translation>Loeng 004 lõikab lõigu enne jagamist läbi kohal {0}:</translation>
    </message>
    <message>
        <source>The scene&apos;s controls have A and B in world coordinates, {0} and {1}; the eye is at {2} and looks along the world&apos;s {3}, so in camera space they are {4} and {5}.</source>
        <translation>Stseeni juhtelementides on A ja B maailma koordinaatides, {0} ja {1}; silm on kohal {2} ja vaatab maailma suunas {3}, seega on need kaamerafreimis {4} ja {5}.</translation>
    </message>
    <message>
        <source>At the cut {0} and {1}, with {2}: far outside the picture, on the right. The naive division goes to {3} instead, on the left.</source>
        <translation>Lõikekohas on {0} ja {1}, kui {2}: kaugel pildist väljas, paremal. Naiivne jagamine läheb hoopis kohale {3}, vasakul.</translation>
    </message>
    <message>
        <source>*Image* shows the three ways: *naive*, divided without a cut; *cut*, at {0}; and *clipped*, in homogeneous coordinates, which need no such number.</source>
        <translation>*Pilt* näitab kolme viisi: *naiivne*, jagatud ilma lõiketa; *lõigatud*, kohal {0}; ja *kärbitud*, homogeensetes koordinaatides, mis sellist arvu ei vaja.</translation>
    </message>
    <message>
        <source>Case 4</source>
        <translation>Juhtum 4</translation>
    </message>
    <message>
        <source>The lecture distinguishes four cases by which ends lie in front of the camera. Now both are in front: case 1.</source>
        <translation>Loeng eristab nelja juhtumit selle järgi, kumb ots on kaamera ees. Praegu on ees mõlemad: juhtum 1.</translation>
    </message>
    <message>
        <source>Make it case 4: A in front of the camera, B behind it. (The controls are in world coordinates; the eye is at z = 4.)</source>
        <translation>Tehke sellest juhtum 4: A kaamera ees, B selle taga. (Juhtelemendid on maailma koordinaatides; silm on kohal z = 4.)</translation>
    </message>
    <message>
        <source>Move the camera nearer, or drag B in *World*.</source>
        <translation>Viige kaamera lähemale või lohistage B-d paanis *Maailm*.</translation>
    </message>
    <message>
        <source>B must go behind the plane marked {0}.</source>
        <translation>B peab minema tasandi taha, millel on märk {0}.</translation>
    </message>
    <message>
        <source>Now the image of AB leaves the picture and goes on to infinity.</source>
        <translation>Nüüd väljub AB kujutis pildilt ja läheb edasi lõpmatusse.</translation>
    </message>
    <message>
        <source>At the cut</source>
        <translation>Lõikekohas</translation>
    </message>
    <message>
        <source>In this segment A is at {0} in camera space and B at {1}. It is cut at {2}.</source>
        <translation>Selles lõigus on A kaamerafreimis kohal {0} ja B kohal {1}. See lõigatakse läbi kohal {2}.</translation>
    </message>
    <message>
        <source>At which t, from A to B, is the cut?</source>
        <translation>Millise t juures, A-st B-ni, on lõikekoht?</translation>
    </message>
    <message>
        <source>The cut is at the eye plane</source>
        <translation>Lõikekoht on silmatasandil</translation>
    </message>
    <message>
        <source>This is where {0}, in the eye plane, where the division is by 0. The lecture cuts a little before it, at {1}. Look at the plane {2}: it goes through the eye, where nothing has an image.</source>
        <translation>See on koht, kus {0}, silmatasandil, kus jagatakse 0-ga. Loeng lõikab natuke enne seda, kohal {1}. Vaadake tasandit {2}: see läbib silma, kus millelgi ei ole kujutist.</translation>
    </message>
    <message>
        <source>Put {0} into {1}.</source>
        <translation>Pange {0} võrrandisse {1}.</translation>
    </message>
    <message>
        <source>{0}, a little before the middle.</source>
        <translation>{0}, natuke enne keskkohta.</translation>
    </message>
    <message>
        <source>At which {0} is the image of the cut, with {1}?</source>
        <translation>Millise {0} juures on lõikekoha kujutis, kui {1}?</translation>
    </message>
    <message>
        <source>This divides B, which is behind the camera. Only the part in front of {0} has an image, and it ends at the cut. Look at A&apos; and B&apos;: the line that joins them is wrong.</source>
        <translation>Nii jagatakse B-d, mis on kaamera taga. Kujutis on ainult sellel osal, mis on kohast {0} eespool, ja see lõpeb lõikekohas. Vaadake punkte A&apos; ja B&apos;: joon, mis neid ühendab, on vale.</translation>
    </message>
    <message>
        <source>The side is wrong: at the cut {0} is positive, so {1} has the sign of x. Look at the image: it leaves the picture on the right.</source>
        <translation>Pool on vale: lõikekohas on {0} positiivne, seega on suurusel {1} sama märk mis x-il. Vaadake pilti: kujutis väljub pildilt paremalt.</translation>
    </message>
    <message>
        <source>First x at the cut, {0}.</source>
        <translation>Enne x lõikekohas: {0}.</translation>
    </message>
    <message>
        <source>{0}, so {1}: the line runs out of the picture on the right.</source>
        <translation>{0}, seega {1}: joon väljub pildilt paremalt.</translation>
    </message>
    <message>
        <source>Case 2</source>
        <translation>Juhtum 2</translation>
    </message>
    <message>
        <source>If both ends are behind the camera, nothing is drawn. The naive division draws the segment anyway, mirrored.</source>
        <translation>Kui mõlemad otsad on kaamera taga, ei joonistata midagi. Naiivne jagamine joonistab lõigu ometi, peegeldatult.</translation>
    </message>
    <message>
        <source>Make it case 2, with B where it is.</source>
        <translation>Tehke sellest juhtum 2 ja jätke B oma kohale.</translation>
    </message>
    <message>
        <source>A must go behind the plane {0} too.</source>
        <translation>Ka A peab minema tasandi {0} taha.</translation>
    </message>
    <message>
        <source>In this case the lecture only remembers the end point and draws no line.</source>
        <translation>Selles juhtumis jätab loeng ainult lõpp-punkti meelde ega joonista joont.</translation>
    </message>
    <message>
        <source>Back to the prediction</source>
        <translation>Tagasi ennustuse juurde</translation>
    </message>
    <message>
        <source>Two ends, two images, and a line between them: every segment in front of the camera is drawn like this, so it is tempting here too. But the segment crosses the plane {0}, and that point has no image. The image runs to infinity on one side, and the mirrored rest comes back from the other. Joining A&apos; and B&apos; draws exactly the part of the line that is *not* the image of AB. So cut first, then divide.</source>
        <translation>Kaks otsa, kaks kujutist ja nende vahel joon: iga kaamera ees olev lõik joonistatakse nii, seega on see ahvatlev ka siin. Aga lõik läbib tasandi {0} ja sellel punktil kujutist ei ole. Kujutis läheb ühel pool lõpmatusse ja peegeldatud ülejääk tuleb teiselt poolt tagasi. A&apos; ja B&apos; ühendamine joonistab täpselt selle osa sirgest, mis *ei ole* AB kujutis. Seepärast enne lõigake, siis jagage.</translation>
    </message>
    <message>
        <source>Practise: cut, then divide</source>
        <translation>Harjutus: lõigake, siis jagage</translation>
    </message>
    <message>
        <source>AB is cut at {0} in camera space, and then divided: {1} with {2}.</source>
        <translation>AB lõigatakse kaamerafreimis läbi kohal {0} ja jagatakse siis: {1}, kus {2}.</translation>
    </message>
    <message>
        <source>In camera space A is at {0}, {1} and B at {2}, {3}; {4} is 0. At which {5} is the image of the cut?</source>
        <translation>Kaamerafreimis on A kohal {0}, {1} ja B kohal {2}, {3}; {4} on 0. Millise {5} juures on lõikekoha kujutis?</translation>
    </message>
    <message>
        <source>This divides B, which is behind the camera. Only the part of AB in front of {0} has an image, and it ends at the cut. Look from above: B is behind the plane {1}.</source>
        <translation>Nii jagatakse B-d, mis on kaamera taga. Kujutis on ainult sellel AB osal, mis on kohast {0} eespool, ja see lõpeb lõikekohas. Vaadake ülalt: B on tasandi {1} taga.</translation>
    </message>
    <message>
        <source>The side is wrong: at the cut {0} is positive, so {1} has the sign of {2}. Look from above: the cut, just before the plane {3}, is on the side of its {4}.</source>
        <translation>Pool on vale: lõikekohas on {0} positiivne, seega on suurusel {1} sama märk mis suurusel {2}. Vaadake ülalt: lõikekoht, kohe tasandi {3} ees, on samal pool kui selle {4}.</translation>
    </message>
    <message>
        <source>At which {0} from A to B is {1}? There {2}.</source>
        <translation>Millise {0} juures A-st B-ni on {1}? Seal {2}.</translation>
    </message>
    <message>
        <source>{0}; the {1} there is divided by 0.01.</source>
        <translation>{0}; sealne {1} jagatakse arvuga 0.01.</translation>
    </message>
    <message>
        <source>Practise: the right piece</source>
        <translation>Harjutus: õige tükk</translation>
    </message>
    <message>
        <source>A is in front of the camera, B behind it. The picture joins their images A&apos; and B&apos;, as the division alone does.</source>
        <translation>A on kaamera ees, B selle taga. Pildil on nende kujutised A&apos; ja B&apos; ühendatud, nagu teeb jagamine üksi.</translation>
    </message>
    <message>
        <source>Mark where the right image of AB leaves the picture.</source>
        <translation>Märkige, kus AB õige kujutis pildilt väljub.</translation>
    </message>
    <message>
        <source>This is B&apos;, the mirrored image of a point behind the camera. The right image never comes there. Look at the world: B is behind the plane {0}.</source>
        <translation>See on B&apos;, kaamera taga oleva punkti peegeldatud kujutis. Õige kujutis ei jõua kunagi sinna. Vaadake maailma: B on tasandi {0} taga.</translation>
    </message>
    <message>
        <source>Through B&apos; and on</source>
        <translation>Läbi B&apos; ja edasi</translation>
    </message>
    <message>
        <source>This goes from A&apos; through B&apos; and on. B&apos; is mirrored, so the right image starts at A&apos; in the opposite direction. Look at the world: on the way from A to the plane {0} the edge leaves the pyramid on one side.</source>
        <translation>Nii minnakse A&apos;-st läbi B&apos; ja edasi. B&apos; on peegeldatud, seega läheb õige kujutis A&apos;-st vastassuunas. Vaadake maailma: teel A-st tasandini {0} väljub serv püramiidist ühelt poolt.</translation>
    </message>
    <message>
        <source>It lies on the same line. On which side of A&apos;?</source>
        <translation>See on samal sirgel. Kummal pool punkti A&apos;?</translation>
    </message>
    <message>
        <source>It starts at A&apos; and goes away from B&apos;. In {0} and {1}, {2}, {3}, and the edge of the picture is at {4}.</source>
        <translation>See algab punktist A&apos; ja läheb punktist B&apos; eemale. Suurustes {0} ja {1} on {2}, {3} ja pildi serv on kohal {4}.</translation>
    </message>
    <message>
        <source>Practise: the four cases</source>
        <translation>Harjutus: neli juhtumit</translation>
    </message>
    <message>
        <source>Case 1: both ends are in front of the camera. Case 2: both are behind it. Case 3: only A is behind it. Case 4: only B is.</source>
        <translation>Juhtum 1: mõlemad otsad on kaamera ees. Juhtum 2: mõlemad on selle taga. Juhtum 3: taga on ainult A. Juhtum 4: taga on ainult B.</translation>
    </message>
    <message>
        <source>Make it case {0}. Leave A and B where they are.</source>
        <translation>Tehke sellest juhtum {0}. Jätke A ja B oma kohale.</translation>
    </message>
    <message>
        <source>What is behind the camera lies beyond the plane marked {0}. Move the camera, or turn it.</source>
        <translation>Mis on kaamera taga, on teisel pool tasandit, millel on märk {0}. Liigutage kaamerat või pöörake seda.</translation>
    </message>
    <message>
        <source>In camera space the ends behind the camera have {0}. So it is with the eye at {1}, if it looks towards {2}.</source>
        <translation>Kaamerafreimis on kaamera taga olevatel otstel {0}. Nii on see, kui silm on kohal {1} ja vaatab koha {2} poole.</translation>
    </message>
</context>
<context>
    <name>l17-depth-buffer</name>
    <message>
        <source>What eats the depth buffer?</source>
        <translation>Mis sööb sügavuspuhvrit?</translation>
    </message>
    <message>
        <source>Half of the range gone</source>
        <translation>Pool vahemikust kadunud</translation>
    </message>
    <message>
        <source>A depth buffer keeps one code for each pixel, here of 16 bits. Surface 2 lies behind surface 1. Where both get the same code, you see the one drawn last; this makes the stripes at the far end of the ramp. The scene&apos;s numbers say how large a gap at the target, 20 units away, is certain to be resolved.</source>
        <translation>Sügavuspuhver hoiab iga piksli jaoks üht koodi, siin 16-bitist. Pind 2 on pinna 1 taga. Kus mõlemad saavad sama koodi, näete seda, mis joonistati viimasena; sellest on triibud kaldtee kaugemas otsas. Stseeni arvud ütlevad, kui suur peab vahe sihtpunkti juures, 20 ühiku kaugusel, olema, et seda kindlasti eristataks.</translation>
    </message>
    <message>
        <source>Far moves in from 100 to 50. By how much does the gap needed at 20 units shrink?</source>
        <translation>Kaugtasand tuuakse lähemale, 100-lt 50-le. Kui palju väheneb 20 ühiku kaugusel vajalik vahe?</translation>
    </message>
    <message>
        <source>by 50 %</source>
        <translation>50 %</translation>
    </message>
    <message>
        <source>This spreads the codes evenly from near to far, so that half of the range would need half as many. Most codes lie just behind near; the part from 50 to 100 had hardly any to give. Look at both pictures: as much of the ramp is striped, though single stripes move.</source>
        <translation>Nii jaotatakse koodid lähitasandist kaugtasandini ühtlaselt, nii et pool vahemikku vajaks poole vähem. Enamik koode on kohe lähitasandi taga; osal 50-st 100-ni ei olnud peaaegu midagi ära anda. Vaadake mõlemat pilti: kaldteest on triibuline sama suur osa, kuigi üksikud triibud nihkuvad.</translation>
    </message>
    <message>
        <source>far 100</source>
        <translation>kaugtasand 100</translation>
    </message>
    <message>
        <source>far 50</source>
        <translation>kaugtasand 50</translation>
    </message>
    <message>
        <source>by 0.1 %</source>
        <translation>0.1 %</translation>
    </message>
    <message>
        <source>by 75 %</source>
        <translation>75 %</translation>
    </message>
    <message>
        <source>The square belongs to the distance {0} of the surfaces, which has not changed; far enters as {1}. Look at both pictures: as much of the ramp is striped, though single stripes move.</source>
        <translation>Ruut kuulub pindade kauguse {0} juurde, mis ei ole muutunud; kaugtasand on valemis kujul {1}. Vaadake mõlemat pilti: kaldteest on triibuline sama suur osa, kuigi üksikud triibud nihkuvad.</translation>
    </message>
    <message>
        <source>Depth depends on {0}, and {1} has only become {2}. (Single stripes move with every change of the codes, and with the size of the picture; the gap does not depend on it.)</source>
        <translation>Sügavus sõltub suurusest {0}, ja väärtusest {1} on saanud ainult {2}. (Üksikud triibud nihkuvad iga koodide muutusega ja pildi suurusega; vahe sellest ei sõltu.)</translation>
    </message>
    <message>
        <source>Where the codes are</source>
        <translation>Kus koodid on</translation>
    </message>
    <message>
        <source>The buffer stores a number from 0 at near to 1 at far. At the distance {0} it is</source>
        <translation>Puhver salvestab arvu, mis on lähitasandil 0 ja kaugtasandil 1. Kaugusel {0} on see</translation>
    </message>
    <message>
        <source>Here {0}, {1}, and point 1 lies at {2}: {3}, as in the row *depth* of the Probe panel. The first two fifths of the way use 97 % of the codes. A step of {4} in {5} is therefore long in the world:</source>
        <translation>Siin {0}, {1} ja punkti 1 kaugus on {2}: {3}, nagu paneeli Sond reas *sügavus*. Kaks esimest viiendikku teest võtavad 97 % koodidest. Samm {4} suuruses {5} on seepärast maailmas pikk:</translation>
    </message>
    <message>
        <source>With 16 bits {0}, and the gap is 0.00598. As {1} is so small, the gap grows with {2}, and a near plane ten times as close makes it ten times as large.</source>
        <translation>16 biti korral {0} ja vahe on 0.00598. Kuna {1} on nii väike, kasvab vahe nagu {2}, ja kümme korda lähem lähitasand teeb selle kümme korda suuremaks.</translation>
    </message>
    <message>
        <source>Make it sure</source>
        <translation>Et see oleks kindel</translation>
    </message>
    <message>
        <source>At the start near is 0.1, and the gap that is certain at the target is 0.061.</source>
        <translation>Alguses on lähitasand 0.1 ja sihtpunkti juures kindel vahe 0.061.</translation>
    </message>
    <message>
        <source>Make that gap smaller than 0.01, with the whole ramp still between near and far. The ramp begins 3.35 units from the eye and ends at 47.75.</source>
        <translation>Tehke see vahe väiksemaks kui 0.01 nii, et kogu kaldtee jääb lähi- ja kaugtasandi vahele. Kaldtee algab silmast 3.35 ühiku kaugusel ja lõpeb 47.75 kaugusel.</translation>
    </message>
    <message>
        <source>Which of near and far stands alone in the denominator of the gap?</source>
        <translation>Kumb, kas lähi- või kaugtasand, on vahe valemis nimetajas üksi?</translation>
    </message>
    <message>
        <source>Move Near outwards, to 1 or more. More bits, under Format, also work.</source>
        <translation>Viige lähitasand kaugemale, 1 või rohkem. Mõjub ka rohkem bitte valikus Vorming.</translation>
    </message>
    <message>
        <source>The stripes are gone. Near matters, and so does the number of bits; far hardly does.</source>
        <translation>Triibud on kadunud. Lähitasand loeb ja loeb ka bittide arv; kaugtasand peaaegu ei loe.</translation>
    </message>
    <message>
        <source>How deep is it stored?</source>
        <translation>Mis sügavusena see salvestatakse?</translation>
    </message>
    <message>
        <source>Near is 2 and far is 50. Which number from 0 to 1 is stored for a point at the distance 10?</source>
        <translation>Lähitasand on 2 ja kaugtasand 50. Milline arv 0-st 1-ni salvestatakse punkti jaoks kaugusel 10?</translation>
    </message>
    <message>
        <source>This spreads the stored numbers evenly from near to far. They change with one over the distance, fast just behind near and hardly at all before far. Look at point 1, 10 away, in the cube: it is close to far.</source>
        <translation>Nii jaotatakse salvestatud arvud lähitasandist kaugtasandini ühtlaselt. Need muutuvad koos kauguse pöördarvuga, kohe lähitasandi taga kiiresti ja enne kaugtasandit peaaegu üldse mitte. Vaadake kuubis punkti 1 kaugusega 10: see on kaugtasandi lähedal.</translation>
    </message>
    <message>
        <source>The buffer holds z&apos;</source>
        <translation>Puhvris on z&apos;</translation>
    </message>
    <message>
        <source>This is the depth from −1 to 1 of NDC. The buffer begins with 0 at near: add 1, then halve. Look at point 1, 10 away, in the cube: its {0} is your number.</source>
        <translation>See on NDC sügavus −1-st 1-ni. Puhver algab lähitasandil 0-ga: liitke 1 ja võtke pool. Vaadake kuubis punkti 1 kaugusega 10: teie arv on selle {0}.</translation>
    </message>
    <message>
        <source>This leaves out a division by the distance 10. No stored number is larger than 1, which is the far plane&apos;s. Look at point 1, 10 away, in the cube: it lies before far.</source>
        <translation>Siin on jäänud ära jagamine kaugusega 10. Ükski salvestatud arv ei ole suurem kui 1, mis on kaugtasandi oma. Vaadake kuubis punkti 1 kaugusega 10: see on kaugtasandi ees.</translation>
    </message>
    <message>
        <source>{0}: the first sixth of the way takes five sixths of the codes.</source>
        <translation>{0}: esimene kuuendik teest võtab viis kuuendikku koodidest.</translation>
    </message>
    <message>
        <source>The formula for {0} is in step 2.</source>
        <translation>Suuruse {0} valem on sammus 2.</translation>
    </message>
    <message>
        <source>How far apart must two surfaces be at the distance 40, with a buffer of 16 bits?</source>
        <translation>Kui suur peab olema kahe pinna vahe kaugusel 40, kui puhver on 16-bitine?</translation>
    </message>
    <message>
        <source>This makes the gap the same at every distance. It would be if the codes were spread evenly, but most of them lie just behind near; at the distance {0} the gap is proportional to {1}. Look at the stripes with near = 0.1: they begin far out and widen with the distance.</source>
        <translation>Nii on vahe igal kaugusel ühesugune. See oleks nii, kui koodid oleksid jaotatud ühtlaselt, aga enamik neist on kohe lähitasandi taga; kaugusel {0} on vahe võrdeline suurusega {1}. Vaadake triipe, kui lähitasand = 0.1: need algavad kaugel ja laienevad koos kaugusega.</translation>
    </message>
    <message>
        <source>The gap grows with {0}: it is a little more than four times the scene&apos;s number for the target, at the distance 20.</source>
        <translation>Vahe kasvab nagu {0}: see on natuke rohkem kui neli korda stseeni arv sihtpunkti jaoks, mille kaugus on 20.</translation>
    </message>
    <message>
        <source>Back to far</source>
        <translation>Tagasi kaugtasandi juurde</translation>
    </message>
    <message>
        <source>With far at 50 instead of 100 the range is half as long, so it is tempting to expect codes twice as close. They would be if depth changed evenly. But it changes with {0}, so most codes lie just behind near. The space from 50 to 100 had hardly any, and giving them up gains nothing. Now move *Near* a little and watch the stripes.</source>
        <translation>Kui kaugtasand on 100 asemel 50, on vahemik poole lühem, nii et ahvatlev on oodata kaks korda tihedamaid koode. Nii see oleks, kui sügavus muutuks ühtlaselt. Aga see muutub koos suurusega {0}, seega on enamik koode kohe lähitasandi taga. Vahemikus 50-st 100-ni ei olnud neid peaaegu üldse ja selle äraandmine ei too midagi. Nihutage nüüd natuke liugurit *Lähitasand* ja jälgige triipe.</translation>
    </message>
    <message>
        <source>Practise: a stored depth</source>
        <translation>Harjutus: salvestatud sügavus</translation>
    </message>
    <message>
        <source>Near is {0}, far is {1}, and point 1 is at the distance {2}, straight ahead. Which number from 0 to 1 is stored for it?</source>
        <translation>Lähitasand on {0}, kaugtasand {1} ja punkt 1 on kaugusel {2}, otse ees. Milline arv 0-st 1-ni selle jaoks salvestatakse?</translation>
    </message>
    <message>
        <source>This spreads the stored numbers evenly from near to far. They change with {0}, fast just behind near and hardly at all before far. Look at point 1 in the cube: it is closer to far than in the world.</source>
        <translation>Nii jaotatakse salvestatud arvud lähitasandist kaugtasandini ühtlaselt. Need muutuvad koos suurusega {0}, kohe lähitasandi taga kiiresti ja enne kaugtasandit peaaegu üldse mitte. Vaadake kuubis punkti 1: see on kaugtasandile lähemal kui maailmas.</translation>
    </message>
    <message>
        <source>This is the depth from −1 to 1 of NDC. The buffer begins with 0 at near: add 1, then halve. Look at point 1 in the cube: its {0} is your number.</source>
        <translation>See on NDC sügavus −1-st 1-ni. Puhver algab lähitasandil 0-ga: liitke 1 ja võtke pool. Vaadake kuubis punkti 1: teie arv on selle {0}.</translation>
    </message>
    <message>
        <source>This leaves out a division by {0}. No stored number is larger than 1, which is the far plane&apos;s. Look at point 1 in the cube: it lies before far.</source>
        <translation>Siin on jäänud ära jagamine suurusega {0}. Ükski salvestatud arv ei ole suurem kui 1, mis on kaugtasandi oma. Vaadake kuubis punkti 1: see on kaugtasandi ees.</translation>
    </message>
    <message>
        <source>It must be 0 for {0} and 1 for {1}.</source>
        <translation>See peab olema 0, kui {0}, ja 1, kui {1}.</translation>
    </message>
    <message>
        <source>Only {0} is spread evenly, so the formula divides by {1}.</source>
        <translation>Ühtlaselt jaguneb ainult {0}, seega jagab valem suurusega {1}.</translation>
    </message>
    <message>
        <source>Of the way from near to far, the point has come {0} %.</source>
        <translation>Lähitasandist kaugtasandini on punkt läbinud {0} % teest.</translation>
    </message>
    <message>
        <source>Practise: the gap that is certain</source>
        <translation>Harjutus: kindel vahe</translation>
    </message>
    <message>
        <source>Near is {0}, far is {1}, and the buffer has 16 bits. Point 1 on the ramp is at the distance {2}. How far behind it must another surface be to be certain of a code of its own?</source>
        <translation>Lähitasand on {0}, kaugtasand {1} ja puhver on 16-bitine. Punkt 1 kaldteel on kaugusel {2}. Kui kaugel selle taga peab teine pind olema, et saada kindlasti omaette kood?</translation>
    </message>
    <message>
        <source>This makes the gap the same at every distance. It would be if the codes were spread evenly, but most of them lie just behind near; the gap is proportional to {0}. Look at the stripes with near = 0.1: they begin far out and widen with the distance.</source>
        <translation>Nii on vahe igal kaugusel ühesugune. See oleks nii, kui koodid oleksid jaotatud ühtlaselt, aga enamik neist on kohe lähitasandi taga; vahe on võrdeline suurusega {0}. Vaadake triipe, kui lähitasand = 0.1: need algavad kaugel ja laienevad koos kaugusega.</translation>
    </message>
    <message>
        <source>Twice as far, twice the gap</source>
        <translation>Kaks korda kaugemal, kaks korda suurem vahe</translation>
    </message>
    <message>
        <source>This makes the gap proportional to {0}. The stored number changes with {1}, whose slope is {2}: twice as far needs four times the gap. Look at the stripes with near = 0.1: they widen faster than the distance grows.</source>
        <translation>Nii on vahe võrdeline suurusega {0}. Salvestatud arv muutub koos suurusega {1}, mille tõus on {2}: kaks korda kaugemal on vaja neli korda suuremat vahet. Vaadake triipe, kui lähitasand = 0.1: need laienevad kiiremini, kui kaugus kasvab.</translation>
    </message>
    <message>
        <source>The 16 bits have {0} steps.</source>
        <translation>16 bitil on {0} sammu.</translation>
    </message>
    <message>
        <source>Share {0} among them: that is {1}, and the gap is {2}.</source>
        <translation>Jagage nende vahel {0}: see on {1} ja vahe on {2}.</translation>
    </message>
    <message>
        <source>With near twice as far out, the gap would be about half as large.</source>
        <translation>Kui lähitasand oleks kaks korda kaugemal, oleks vahe umbes poole väiksem.</translation>
    </message>
    <message>
        <source>Practise: near for a depth</source>
        <translation>Harjutus: lähitasand sügavuse järgi</translation>
    </message>
    <message>
        <source>Far is {0}, and point 1 is at the distance {1}. Move near until {2} is stored for the point, on the scale from 0 to 1.</source>
        <translation>Kaugtasand on {0} ja punkt 1 on kaugusel {1}. Nihutage lähitasandit, kuni punkti jaoks salvestatakse {2}, skaalal 0-st 1-ni.</translation>
    </message>
    <message>
        <source>Solve {0} for {1}; here {2}, {3}, {4}.</source>
        <translation>Avaldage võrrandist {0} suurus {1}; siin {2}, {3}, {4}.</translation>
    </message>
    <message>
        <source>{0}. Then type it under Near.</source>
        <translation>{0}. Sisestage see siis väljale Lähitasand.</translation>
    </message>
    <message>
        <source>You have set {0} to {1}. The buffer begins with 0 at near: it stores {2}. Look at point 1 in the cube: it is at {3}.</source>
        <translation>Teie seatud {0} on {1}. Puhver algab lähitasandil 0-ga: see salvestab {2}. Vaadake kuubis punkti 1: see on kohal {3}.</translation>
    </message>
</context>
<context>
    <name>l18-interpolation</name>
    <message>
        <source>What is half-way?</source>
        <translation>Mis on poolel teel?</translation>
    </message>
    <message>
        <source>Half-way in the picture</source>
        <translation>Pildil poolel teel</translation>
    </message>
    <message>
        <source>A rasteriser knows a quantity {0}, such as a colour or a texture coordinate, at the ends of an edge. It must find {1} at the pixels between. In the Image pane the left edge of the board is marked.</source>
        <translation>Rasterdaja teab mingit suurust {0}, näiteks värvi või tekstuuri koordinaati, serva otstes. Suurus {1} tuleb leida vahepealsetes pikslites. Paanis Pilt on märgitud laua vasak serv.</translation>
    </message>
    <message>
        <source>The camera goes down until the far end of the marked edge is four times as deep as the near end. Along the edge, {0} grows evenly from 0 at the near end to 1. What is {1} half-way between the two ends in the *picture*?</source>
        <translation>Kaamera läheb alla, kuni märgitud serva kaugema otsa sügavus on neli korda lähema otsa sügavus. Piki serva kasvab {0} ühtlaselt, lähemas otsas on see 0 ja kaugemas 1. Kui suur on {1} kahe otsa vahel poolel teel *pildil*?</translation>
    </message>
    <message>
        <source>This spreads {0} evenly over the picture. The far half of the edge is drawn much shorter than the near half, so the middle of the picture shows a place closer to the near end. Look at the two marks: half-way in the picture is the nearer one.</source>
        <translation>Nii jaotatakse {0} pildil ühtlaselt. Serva kaugem pool joonistatakse palju lühemana kui lähem, nii et pildi keskkoht näitab kohta, mis on lähemale otsale lähemal. Vaadake kaht märki: pildil poolel teel on lähem märk.</translation>
    </message>
    <message>
        <source>The middle of the *edge* is seen there, four fifths of the way in the picture. The question is about half-way in the picture. Look at the two marks: half-way in the world is the farther one.</source>
        <translation>Seal on näha *serva* keskkohta, pildil nelja viiendiku peal. Küsitakse pildil poolel teel olevat. Vaadake kaht märki: maailmas poolel teel on kaugem märk.</translation>
    </message>
    <message>
        <source>The last of the scene&apos;s numbers says 20 %. The far parts are drawn shorter, so four fifths of the edge share the far half of its picture.</source>
        <translation>Viimane stseeni arvudest ütleb 20 %. Kaugemad osad joonistatakse lühemana, nii et neli viiendikku servast jagavad selle pildi kaugemat poolt.</translation>
    </message>
    <message>
        <source>One over the depth</source>
        <translation>Sügavuse pöördarv</translation>
    </message>
    <message>
        <source>Two points have depths {0}, {1} and values {2}, {3}. At the share {4} of the way in the picture,</source>
        <translation>Kahel punktil on sügavused {0}, {1} ja väärtused {2}, {3}. Kui pildil on läbitud osa {4} teest, siis</translation>
    </message>
    <message>
        <source>The edge now begins at 5 and ends at 15. Half-way in the picture {0}, so the place is at the depth 7.5, and {1}. Both diagrams below show straight lines: {2} and the depth {3} may be interpolated directly on the screen.</source>
        <translation>Serv algab nüüd sügavusel 5 ja lõpeb sügavusel 15. Pildil poolel teel on {0}, nii et selle koha sügavus on 7.5, ja {1}. Mõlemad all olevad diagrammid näitavad sirgeid: suurusi {2} ja sügavust {3} võib ekraanil otse interpoleerida.</translation>
    </message>
    <message>
        <source>A quarter off</source>
        <translation>Veerandi võrra mööda</translation>
    </message>
    <message>
        <source>Now the board is drawn *affine*: {0} itself is interpolated, and the checks bend at the diagonal.</source>
        <translation>Nüüd joonistatakse laud *afiinselt*: interpoleeritakse {0} ise ja ruudud murduvad diagonaalil.</translation>
    </message>
    <message>
        <source>Move the camera until the point half-way in the picture of the marked edge is at most 25 % along the edge. Then affine is wrong by a quarter of the edge. The edge must stay beyond the near plane.</source>
        <translation>Liigutage kaamerat, kuni märgitud serva pildil poolel teel olev punkt on serval endal ülimalt 25 % peal. Siis eksib afiinne veerandi serva võrra. Serv peab jääma lähitasandi taha.</translation>
    </message>
    <message>
        <source>One end must be at least three times as deep as the other.</source>
        <translation>Ühe otsa sügavus peab olema vähemalt kolm korda teise oma.</translation>
    </message>
    <message>
        <source>Go nearer with Distance, or lower with Elevation. If the board reaches behind near, make Near smaller.</source>
        <translation>Minge lähemale sättega Kaugus või madalamale sättega Tõusunurk. Kui laud ulatub lähitasandi taha, vähendage lähitasandi väärtust.</translation>
    </message>
    <message>
        <source>The deeper the edge leads, the larger the error. Choose *correct* under Interpolation and see what moves.</source>
        <translation>Mida sügavamale serv viib, seda suurem on viga. Valige sättes Interpoleerimine *korrektne* ja vaadake, mis liigub.</translation>
    </message>
    <message>
        <source>By the formula</source>
        <translation>Valemi järgi</translation>
    </message>
    <message>
        <source>The marked edge begins at the depth 5 and ends at 15. A brightness goes from 10 at its near end to 50 at its far end. How bright is it a quarter of the way in the picture, {0}?</source>
        <translation>Märgitud serv algab sügavusel 5 ja lõpeb sügavusel 15. Heledus on lähemas otsas 10 ja kaugemas 50. Kui suur on see siis, kui pildil on läbitud veerand teest, {0}?</translation>
    </message>
    <message>
        <source>This mixes the brightness itself. In the picture only what is divided by the depth changes evenly: divide both ends by their depths, mix, and divide by the mixed {0}. Look at the two marks: half-way in the picture is not half-way along the edge.</source>
        <translation>Nii segatakse heledust ennast. Pildil muutub ühtlaselt ainult see, mis on sügavusega jagatud: jagage mõlemad otsad oma sügavusega, segage ja jagage segatud suurusega {0}. Vaadake kaht märki: pildil poolel teel ei ole servas poolel teel.</translation>
    </message>
    <message>
        <source>Divide both by their depths, mix, and divide by the mixed {0}: {1}.</source>
        <translation>Jagage mõlemad oma sügavusega, segage ja jagage segatud suurusega {0}: {1}.</translation>
    </message>
    <message>
        <source>First {0} at both ends, then {1} at both ends.</source>
        <translation>Enne {0} mõlemas otsas, siis {1} mõlemas otsas.</translation>
    </message>
    <message>
        <source>What is the depth of the point a quarter of the way in the picture?</source>
        <translation>Milline on selle punkti sügavus, kus pildil on läbitud veerand teest?</translation>
    </message>
    <message>
        <source>This mixes the depth itself. In the picture one over the depth changes evenly, not the depth. Look at the two marks: half-way in the picture is nearer than half-way along the edge.</source>
        <translation>Nii segatakse sügavust ennast. Pildil muutub ühtlaselt sügavuse pöördarv, mitte sügavus. Vaadake kaht märki: pildil poolel teel on lähemal kui servas poolel teel.</translation>
    </message>
    <message>
        <source>Back to half-way</source>
        <translation>Tagasi poole tee juurde</translation>
    </message>
    <message>
        <source>One half was tempting because the picture of a straight edge is straight, and its middle is easy to see. But the division by the depth is not even along the edge: at four times the depth, a piece is drawn a quarter as wide. So half of the picture shows only the nearest fifth. Interpolate the divided quantities, {0} and {1}, and then divide.</source>
        <translation>Pool oli ahvatlev, sest sirge serva pilt on sirge ja selle keskkohta on kerge näha. Aga sügavusega jagamine ei ole piki serva ühtlane: neli korda suuremal sügavusel joonistatakse tükk neli korda lühemana. Nii näitab pool pilti ainult lähimat viiendikku. Interpoleerige jagatud suurusi {0} ja {1} ning jagage siis.</translation>
    </message>
    <message>
        <source>Practise: a value on the way</source>
        <translation>Harjutus: vahepealne väärtus</translation>
    </message>
    <message>
        <source>Points 1 and 2 are the ends of an edge.</source>
        <translation>Punktid 1 ja 2 on serva otsad.</translation>
    </message>
    <message>
        <source>Point 1 is {0} deep and has {1}. Point 2 is {2} deep and has {3}. What is {4} at the share {5} of the way from 1 to 2 in the picture?</source>
        <translation>Punkti 1 sügavus on {0} ja sellel on {1}. Punkti 2 sügavus on {2} ja sellel on {3}. Kui suur on {4} kohas, kus pildil on punktist 1 punkti 2 läbitud osa {5}?</translation>
    </message>
    <message>
        <source>This mixes {0} itself. In the picture only the divided quantities change evenly: mix {1} and {2}, then divide. Look at the two marks: half-way in the picture is not half-way along the edge.</source>
        <translation>Nii segatakse suurust {0} ennast. Pildil muutuvad ühtlaselt ainult jagatud suurused: segage {1} ja {2}, siis jagage. Vaadake kaht märki: pildil poolel teel ei ole servas poolel teel.</translation>
    </message>
    <message>
        <source>a/z is a</source>
        <translation>a/z on a</translation>
    </message>
    <message>
        <source>This is {0} at the place, not yet {1}. Divide it by {2} there. Look at the two marks: half-way in the picture is nearer, so {3} counts for more.</source>
        <translation>See on selle koha {0}, mitte veel {1}. Jagage see sealse suurusega {2}. Vaadake kaht märki: pildil poolel teel on lähemal, seega on suurusel {3} suurem kaal.</translation>
    </message>
    <message>
        <source>First {0} and {1} at both ends.</source>
        <translation>Enne {0} ja {1} mõlemas otsas.</translation>
    </message>
    <message>
        <source>Mix each of them, with {0} at point 1 and {1} at point 2; then divide.</source>
        <translation>Segage kumbki, kaaluga {0} punktis 1 ja {1} punktis 2; siis jagage.</translation>
    </message>
    <message>
        <source>Point 1 is nearer, so its value counts for more than its share of the way.</source>
        <translation>Punkt 1 on lähemal, seega on selle väärtusel suurem kaal kui tema osa teest.</translation>
    </message>
    <message>
        <source>Practise: a depth on the way</source>
        <translation>Harjutus: vahepealne sügavus</translation>
    </message>
    <message>
        <source>A thin rod, drawn in colour, begins at point 1 and ends at point 2.</source>
        <translation>Peenike värviline varras algab punktis 1 ja lõpeb punktis 2.</translation>
    </message>
    <message>
        <source>Point 1 is {0} deep, point 2 is {1} deep. How deep is the place that is seen at the share {2} of the way from 1 to 2 in the picture?</source>
        <translation>Punkti 1 sügavus on {0}, punkti 2 sügavus {1}. Kui sügaval on see, mida on näha kohas, kus pildil on punktist 1 punkti 2 läbitud osa {2}?</translation>
    </message>
    <message>
        <source>This mixes the depth itself. In the picture {0} changes evenly, not {1}. Look from above at point 3, half-way in the picture: it is closer to point 1 than to point 2.</source>
        <translation>Nii segatakse sügavust ennast. Pildil muutub ühtlaselt {0}, mitte {1}. Vaadake ülalt punkti 3, mis on pildil poolel teel: see on punktile 1 lähemal kui punktile 2.</translation>
    </message>
    <message>
        <source>The way begins at point 2</source>
        <translation>Tee algab punktist 2</translation>
    </message>
    <message>
        <source>This goes from point 2 to point 1: at {0} the place must be point 1. Look from above: point 1 is the nearer one.</source>
        <translation>Nii minnakse punktist 2 punkti 1: kui {0}, peab see koht olema punkt 1. Vaadake ülalt: lähem on punkt 1.</translation>
    </message>
    <message>
        <source>What changes evenly in the picture is {0}.</source>
        <translation>Pildil muutub ühtlaselt {0}.</translation>
    </message>
    <message>
        <source>The place {0} of the way along the rod itself is deeper: {1}.</source>
        <translation>Koht, kus varda endal on läbitud osa {0}, on sügavamal: {1}.</translation>
    </message>
    <message>
        <source>Practise: the middle of a rod</source>
        <translation>Harjutus: varda keskkoht</translation>
    </message>
    <message>
        <source>Point 1 is {0} deep, point 2 is {1} deep. Mark where the picture shows the middle of the rod.</source>
        <translation>Punkti 1 sügavus on {0}, punkti 2 sügavus {1}. Märkige, kus pilt näitab varda keskkohta.</translation>
    </message>
    <message>
        <source>This is the middle of the picture of the rod. The far half of the rod is drawn shorter than the near half, so the middle of the rod is seen closer to point 2. Look from above at point 3, which you have marked: it is closer to point 1 than to point 2.</source>
        <translation>See on varda pildi keskkoht. Varda kaugem pool joonistatakse lühemana kui lähem, nii et varda keskkohta on näha punktile 2 lähemal. Vaadake ülalt punkti 3, mille te märkisite: see on punktile 1 lähemal kui punktile 2.</translation>
    </message>
    <message>
        <source>The near half is the short one</source>
        <translation>Lähem pool on lühem</translation>
    </message>
    <message>
        <source>This is as far from point 1 as the middle is from point 2. The near half of the rod is drawn longer, so the middle is seen closer to point 2. Look from above: point 1 is the nearer one.</source>
        <translation>See on punktist 1 sama kaugel, kui keskkoht on punktist 2. Varda lähem pool joonistatakse pikemana, nii et keskkohta on näha punktile 2 lähemal. Vaadake ülalt: lähem on punkt 1.</translation>
    </message>
    <message>
        <source>At the middle of the rod, {0} is {1}. At which share {2} of the way in the picture is that?</source>
        <translation>Varda keskkohas on {0} võrdne suurusega {1}. Kui suur osa {2} teest on siis pildil läbitud?</translation>
    </message>
    <message>
        <source>{0}, seen from point 1.</source>
        <translation>{0}, punktist 1 vaadates.</translation>
    </message>
    <message>
        <source>It is seen at the share {0} of the way from point 1.</source>
        <translation>Seda on näha kohas, kus punktist 1 on läbitud osa {0}.</translation>
    </message>
</context>
<context>
    <name>l19-planar-shadow</name>
    <message>
        <source>Where does the shadow fall?</source>
        <translation>Kuhu langeb vari?</translation>
    </message>
    <message>
        <source>A lamp instead of the sun</source>
        <translation>Lamp päikese asemel</translation>
    </message>
    <message>
        <source>The sun is in the direction {0}. The corner {1} at the top of the F has its shadow at {2}.</source>
        <translation>Päike on suunas {0}. F-i ülaosa nurga {1} vari on kohal {2}.</translation>
    </message>
    <message>
        <source>A lamp at the point {0} takes the place of the sun. At which {1} is the shadow of {2}?</source>
        <translation>Päikese asemele tuleb lamp punktis {0}. Millise {1} juures on punkti {2} vari?</translation>
    </message>
    <message>
        <source>at 3, as before</source>
        <translation>kohal 3, nagu enne</translation>
    </message>
    <message>
        <source>This takes the three numbers for a direction that all rays share, as the sun&apos;s are. Of a lamp they are a place: its ray through {0} runs from that place, flatter than the sun&apos;s. Look at the ray: it begins at the lamp.</source>
        <translation>Nii võetakse need kolm arvu suunaks, mis on kõigil kiirtel ühine, nagu päikesel. Lambil on need asukoht: selle kiir läbi punkti {0} algab sellest kohast ja on laugem kui päikese oma. Vaadake kiirt: see algab lambist.</translation>
    </message>
    <message>
        <source>at 6</source>
        <translation>kohal 6</translation>
    </message>
    <message>
        <source>at 1.5, below P</source>
        <translation>kohal 1.5, P all</translation>
    </message>
    <message>
        <source>It would be there if the lamp were directly above {0}. This lamp is 4.5 to the left of {1}. Look at this lamp, which is directly above {2}.</source>
        <translation>Seal oleks see siis, kui lamp oleks otse punkti {0} kohal. See lamp on punktist {1} 4.5 võrra vasakul. Vaadake seda lampi, mis on otse punkti {2} kohal.</translation>
    </message>
    <message>
        <source>From the lamp to {0} the ray goes 4.5 to the right and 5 down; to the ground it is 10 down, so 9 to the right.</source>
        <translation>Lambist punktini {0} läheb kiir 4.5 paremale ja 5 alla; maani on 10 alla, seega 9 paremale.</translation>
    </message>
    <message>
        <source>A projection from the light</source>
        <translation>Projektsioon valgusallikast</translation>
    </message>
    <message>
        <source>A shadow is a projection: the light {0} is its centre, and the ground is its picture plane. The ray from {1} through {2} meets {3} at</source>
        <translation>Vari on projektsioon: valgusallikas {0} on selle keskpunkt ja maa selle pilditasand. Kiir punktist {1} läbi punkti {2} kohtab tasandit {3} punktis</translation>
    </message>
    <message>
        <source>With {0} that is {1}, as the scene&apos;s numbers say. As a matrix it is {2} with the plane {3}, and the F is drawn once more under {4}, in one colour. For the sun {5} has {6} and the rays are parallel.</source>
        <translation>Kui {0}, on see {1}, nagu ütlevad stseeni arvud. Maatriksina on see {2} tasandiga {3} ja F joonistatakse maatriksiga {4} veel kord, ühe värviga. Päikese {5} puhul {6} ja kiired on paralleelsed.</translation>
    </message>
    <message>
        <source>Put the shadow there</source>
        <translation>Pange vari sinna</translation>
    </message>
    <message>
        <source>Move the lamp until the shadow of {0} is at {1}. It must stay a lamp, and above {2}.</source>
        <translation>Liigutage lampi, kuni punkti {0} vari on kohal {1}. See peab jääma lambiks ja olema punktist {2} kõrgemal.</translation>
    </message>
    <message>
        <source>Drag the lamp in the World pane, or type under Light L.</source>
        <translation>Lohistage lampi paanis Maailm või sisestage see väljale Valgus L.</translation>
    </message>
    <message>
        <source>A higher lamp casts a shorter shadow. At {0} it must be 11.4 high.</source>
        <translation>Kõrgem lamp heidab lühema varju. Kui {0}, peab selle kõrgus olema 11.4.</translation>
    </message>
    <message>
        <source>Any lamp on a line from {0} through {1} will do.</source>
        <translation>Sobib iga lamp sirgel, mis läheb punktist {0} läbi punkti {1}.</translation>
    </message>
    <message>
        <source>By the formula</source>
        <translation>Valemi järgi</translation>
    </message>
    <message>
        <source>You see the shadow that the *sun* casts from the direction {0}. Where, in {1}, would the shadow of {2} be with a *lamp* at the point {3}?</source>
        <translation>Näete varju, mille heidab *päike* suunast {0}. Kus oleks suuruses {1} punkti {2} vari, kui punktis {3} oleks *lamp*?</translation>
    </message>
    <message>
        <source>This is the sun&apos;s shadow, the one that you see. The lamp&apos;s ray has another direction: from the lamp to {0} it goes 7.5 to the right and 3 down. Look at the ray: it begins at the lamp.</source>
        <translation>See on päikese vari, mida te näete. Lambi kiirel on teine suund: lambist punktini {0} läheb see 7.5 paremale ja 3 alla. Vaadake kiirt: see algab lambist.</translation>
    </message>
    <message>
        <source>{0} is 7.5 to the right of {1} and 3 below it. How far down is the ground?</source>
        <translation>{0} on punktist {1} 7.5 võrra paremal ja 3 võrra allpool. Kui palju on maani?</translation>
    </message>
    <message>
        <source>The plane moves down to {0}, so {1}. What is the cell of the lamp&apos;s matrix in row 1, column 1, {2}?</source>
        <translation>Tasand läheb alla kohani {0}, seega {1}. Mis on lambi maatriksi reas 1 ja veerus 1: {2}?</translation>
    </message>
    <message>
        <source>This is {0} of the sun, whose {1} is 0. A lamp has {2}, so the 2 of the plane counts too. Look at the lamp and the plane: the plane is 2 lower than before.</source>
        <translation>See on päikese {0}, mille {1} on 0. Lambil on {2}, seega loeb ka tasandi 2. Vaadake lampi ja tasandit: tasand on enne olnust 2 võrra madalamal.</translation>
    </message>
    <message>
        <source>{0} is the height of the lamp above the plane. For the sun, with {1}, the height of the plane would not matter.</source>
        <translation>{0} on lambi kõrgus tasandist. Päikese puhul, kus {1}, tasandi kõrgus ei loeks.</translation>
    </message>
    <message>
        <source>Back to the lamp</source>
        <translation>Tagasi lambi juurde</translation>
    </message>
    <message>
        <source>The sun and the lamp had the same three numbers, so it was tempting to let the shadow stay. But the sun&apos;s numbers are a direction, the same for every point of the F. The lamp&apos;s numbers are a position, and the direction of a ray is {0}: the higher a point is, the flatter the ray and the longer its shadow. Change *Kind of light* and watch the top of the F, then its foot.</source>
        <translation>Päikesel ja lambil olid samad kolm arvu, nii et ahvatlev oli jätta vari samaks. Aga päikese arvud on suund, F-i iga punkti jaoks sama. Lambi arvud on asukoht ja kiire suund on {0}: mida kõrgem on punkt, seda laugem on kiir ja seda pikem vari. Muutke sätet *Valguse liik* ja jälgige F-i ülemist otsa, siis alumist.</translation>
    </message>
    <message>
        <source>Practise: a lamp&apos;s shadow</source>
        <translation>Harjutus: lambi vari</translation>
    </message>
    <message>
        <source>A lamp {0} shines on {1}, the corner at the top right of the F. The ground is {2}.</source>
        <translation>Lamp {0} valgustab punkti {1}, mis on F-i ülemine parem nurk. Maa on {2}.</translation>
    </message>
    <message>
        <source>The lamp is at {0}, and {1} is at {2}. At which {3} is the shadow of {4}?</source>
        <translation>Lamp on kohal {0} ja {1} kohal {2}. Millise {3} juures on punkti {4} vari?</translation>
    </message>
    <message>
        <source>This takes the lamp&apos;s place for the sun&apos;s direction. The ray through {0} begins at the lamp: its direction is {1}. Look at the sun&apos;s ray through {2}: it has another direction.</source>
        <translation>Nii võetakse päikese suunaks lambi asukoht. Kiir läbi punkti {0} algab lambist: selle suund on {1}. Vaadake päikese kiirt läbi punkti {2}: sellel on teine suund.</translation>
    </message>
    <message>
        <source>The ray begins at P</source>
        <translation>Kiir algab punktist P</translation>
    </message>
    <message>
        <source>This begins at {0}. The ray begins at the lamp and comes down by the whole height of the lamp, so begin at {1}. Look at the ray: it begins at the lamp.</source>
        <translation>Nii alustatakse punktist {0}. Kiir algab lambist ja laskub kogu lambi kõrguse võrra, seega alustage kohast {1}. Vaadake kiirt: see algab lambist.</translation>
    </message>
    <message>
        <source>From {0} to {1} the ray comes down by {2}. By how much from {3} to the ground?</source>
        <translation>Punktist {0} punkti {1} laskub kiir {2} võrra. Kui palju punktist {3} maani?</translation>
    </message>
    <message>
        <source>To the right it goes {0} from {1} to {2}, and in proportion farther to the ground.</source>
        <translation>Paremale läheb see punktist {1} punkti {2} {0} võrra ja maani võrdeliselt kaugemale.</translation>
    </message>
    <message>
        <source>From {0} the ray goes on to the right by {1}, in the ratio of 5 to {2}.</source>
        <translation>Punktist {0} läheb kiir paremale edasi {1} võrra, suhtes 5 ja {2}.</translation>
    </message>
    <message>
        <source>Practise: a row of S</source>
        <translation>Harjutus: S-i rida</translation>
    </message>
    <message>
        <source>{0}, with the lamp {1} and the plane {2}.</source>
        <translation>{0}, kus lamp on {1} ja tasand {2}.</translation>
    </message>
    <message>
        <source>The lamp is at {0} and the plane is {1}. What is the first row of {2}?</source>
        <translation>Lamp on kohal {0} ja tasand on {1}. Mis on maatriksi {2} esimene rida?</translation>
    </message>
    <message>
        <source>{0} holds for the sun, whose {1} is 0. A lamp has {2}, so {3}, its height above the plane. Look at the lamp and the plane: the plane is lower than {4}.</source>
        <translation>{0} kehtib päikese kohta, mille {1} on 0. Lambil on {2}, seega {3}, mis on selle kõrgus tasandist. Vaadake lampi ja tasandit: tasand on madalamal kui {4}.</translation>
    </message>
    <message>
        <source>This takes {0} for {1}. The first row of {2} is {3} times {4}. Look at {5} and {6}: {7} of the shadow depends on the height of {8}.</source>
        <translation>Nii võetakse {1} asemel {0}. Maatriksi {2} esimene rida on {3} korda {4}. Vaadake punkte {5} ja {6}: varju {7} sõltub punkti {8} kõrgusest.</translation>
    </message>
    <message>
        <source>The plane ends in h</source>
        <translation>Tasandi lõpus on h</translation>
    </message>
    <message>
        <source>This takes {0}. The plane {1} has {2}, so its last number is {3}. Look at the lamp and the plane: the plane is lower than {4}, so the lamp is higher above it.</source>
        <translation>Nii võetakse {0}. Tasandil {1} on {2}, seega on selle viimane arv {3}. Vaadake lampi ja tasandit: tasand on madalamal kui {4}, seega on lamp sellest rohkem kõrgemal.</translation>
    </message>
    <message>
        <source>First {0}, which stands only in the first cell of this row of {1}.</source>
        <translation>Enne {0}, mis on maatriksi {1} selles reas ainult esimeses lahtris.</translation>
    </message>
    <message>
        <source>Then subtract {0} times {1}.</source>
        <translation>Siis lahutage {0} korda {1}.</translation>
    </message>
    <message>
        <source>The first cell is the lamp&apos;s height above the plane.</source>
        <translation>Esimene lahter on lambi kõrgus tasandist.</translation>
    </message>
    <message>
        <source>Practise: where on the ground?</source>
        <translation>Harjutus: kus maapinnal?</translation>
    </message>
    <message>
        <source>You look down from above: {0} runs to the right, {1} runs down. The squares of the grid are 1 wide, the middle of the F is at {2}, {3}, and point 2 is at {4}.</source>
        <translation>Vaatate ülalt alla: {0} kasvab paremale, {1} alla. Ruudustiku ruutude külg on 1, F-i keskkoht on {2}, {3} ja punkt 2 on kohal {4}.</translation>
    </message>
    <message>
        <source>You see the shadow of the sun in the direction {0}. Mark where the shadow of point 1, {1}, is with a *lamp* at the point {2}.</source>
        <translation>Näete päikese varju suunast {0}. Märkige, kus on punkti 1, {1}, vari, kui punktis {2} on *lamp*.</translation>
    </message>
    <message>
        <source>This is the sun&apos;s shadow, the one that you see. The lamp&apos;s ray through {0} begins at {1}: its direction is {2}. Look from the side: every ray begins at the lamp.</source>
        <translation>See on päikese vari, mida te näete. Lambi kiir läbi punkti {0} algab kohast {1}: selle suund on {2}. Vaadake küljelt: iga kiir algab lambist.</translation>
    </message>
    <message>
        <source>From {0} to {1} the ray comes down by {2}, to the ground by {3}.</source>
        <translation>Punktist {0} punkti {1} laskub kiir {2} võrra, maani {3} võrra.</translation>
    </message>
    <message>
        <source>The shadow is at {0}.</source>
        <translation>Vari on kohal {0}.</translation>
    </message>
    <message>
        <source>The shadow is at {0}, {1}.</source>
        <translation>Vari on kohal {0}, {1}.</translation>
    </message>
</context>
<context>
    <name>l20-zoom-or-walk</name>
    <message>
        <source>Zoom or walk?</source>
        <translation>Suumida või kõndida?</translation>
    </message>
    <message>
        <source>Three times as far</source>
        <translation>Kolm korda kaugemal</translation>
    </message>
    <message>
        <source>A wide lens, 29 mm, is close to a head. One unit is 10 cm, so the camera is 30 cm away. The two squares are equally large, one at the nearest part of the head and one at the farthest. In the picture the near one is 1.67 times as large as the far one.</source>
        <translation>Lainurkobjektiiv, 29 mm, on pea lähedal. Üks ühik on 10 cm, nii et kaamera on 30 cm kaugusel. Kaks ruutu on võrdse suurusega, üks pea lähimas ja teine kaugeimas osas. Pildil on lähem kaugemast 1.67 korda suurem.</translation>
    </message>
    <message>
        <source>The camera goes back to three times the distance and zooms until the head is as high in the picture as before. How do the two squares compare then?</source>
        <translation>Kaamera läheb tagasi kolm korda kaugemale ja suumib, kuni pea on pildil sama kõrge kui enne. Kuidas on siis kahe ruudu vahekord?</translation>
    </message>
    <message>
        <source>as before, 1.67 times: the head keeps its size</source>
        <translation>nagu enne, 1.67 korda: pea säilitab oma suuruse</translation>
    </message>
    <message>
        <source>The zoom enlarges both squares by the same factor, so it does not change how they compare. Going back does: both are now 6 units deeper, and their depths are more alike. Look at the two squares in both pictures.</source>
        <translation>Suum suurendab mõlemat ruutu sama arv kordi, nii et nende vahekorda see ei muuda. Tagasiminek muudab: mõlemad on nüüd 6 ühikut sügavamal ja nende sügavused erinevad vähem. Vaadake kaht ruutu mõlemal pildil.</translation>
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
        <translation>lähem on vähem kui 1.67 korda suurem</translation>
    </message>
    <message>
        <source>the near one is more than 1.67 times as large</source>
        <translation>lähem on rohkem kui 1.67 korda suurem</translation>
    </message>
    <message>
        <source>That happens when you go *nearer*: there the same difference in depth matters more. Look at the two squares from nearer by.</source>
        <translation>Nii juhtub, kui te lähete *lähemale*: seal loeb sama sügavuste vahe rohkem. Vaadake kaht ruutu lähemalt.</translation>
    </message>
    <message>
        <source>21 cm</source>
        <translation>21 cm</translation>
    </message>
    <message>
        <source>It is 1.19 times now. Both depths have grown by the same 6 units, so their ratio is closer to 1.</source>
        <translation>Nüüd on see 1.19 korda. Mõlemad sügavused on kasvanud sama 6 ühiku võrra, nii et nende suhe on 1-le lähemal.</translation>
    </message>
    <message>
        <source>Two photographs of one head</source>
        <translation>Kaks fotot ühest peast</translation>
    </message>
    <message>
        <source>The lecture photographs a cat at 29 mm from 30 cm, and at 105 mm. On the film a thing is {0} times its real size, so it keeps its size if</source>
        <translation>Loeng pildistab kassi 29 mm-ga 30 cm kauguselt ja 105 mm-ga. Filmil on asja suurus {0} korda tegelik suurus, nii et see jääb samaks, kui</translation>
    </message>
    <message>
        <source>From 360 cm it would be only 0.30 times as large and would have to be enlarged.</source>
        <translation>360 cm kauguselt oleks see ainult 0.30 korda nii suur ja seda tuleks suurendada.</translation>
    </message>
    <message>
        <source>The squares are {0} cm apart. The near one is drawn {1} times as large as the far one, with its own distance {2}: from 30 cm {3} times, from 108.6 cm {4} times. This camera is at 108.6 cm; under *More numbers* its focal length is 105 mm.</source>
        <translation>Ruutude vahe on {0} cm. Lähem joonistatakse kaugemast {1} korda suuremana, kus {2} on selle enda kaugus: 30 cm kauguselt {3} korda, 108.6 cm kauguselt {4} korda. See kaamera on 108.6 cm kaugusel; jaotise *Veel arve* järgi on selle fookuskaugus 105 mm.</translation>
    </message>
    <message>
        <source>Walk, and keep the head</source>
        <translation>Kõndige ja säilitage pea</translation>
    </message>
    <message>
        <source>Go to three times the distance from the target, and keep the head as high in the picture as it is, 551 px.</source>
        <translation>Minge sihtpunktist kolm korda kaugemale ja jätke pea pildil sama kõrgeks, kui see on, 551 px.</translation>
    </message>
    <message>
        <source>Sizes at the target are proportional to {0}.</source>
        <translation>Suurused sihtpunkti kaugusel on võrdelised suurusega {0}.</translation>
    </message>
    <message>
        <source>The slider *Distance, relative to the preset* changes both at once; Distance and Field of view change one each.</source>
        <translation>Liugur *Kaugus, valmisväärtuse suhtes* muudab mõlemat korraga; Kaugus ja Frustumi nurk muudavad kumbki üht.</translation>
    </message>
    <message>
        <source>The head has kept its height, but its nose has not kept its size.</source>
        <translation>Pea on säilitanud oma kõrguse, aga nina ei ole säilitanud oma suurust.</translation>
    </message>
    <message>
        <source>By the formula</source>
        <translation>Valemi järgi</translation>
    </message>
    <message>
        <source>A statue is photographed from 2 m with a 50-mm lens on film 36 mm wide. From how many metres is it as large with an 85-mm lens?</source>
        <translation>Kuju pildistatakse 2 m kauguselt 50-mm objektiiviga, filmi laius on 36 mm. Mitme meetri kauguselt on see 85-mm objektiiviga sama suur?</translation>
    </message>
    <message>
        <source>The angle is the size</source>
        <translation>Nurk on suurus</translation>
    </message>
    <message>
        <source>This takes the angle of view for the size. On the film the statue&apos;s height is proportional to the focal length over the distance, to {0}; the angle is not proportional to {1}. Look at the two photographs: 105 mm are 3.62 times 29 mm, and from 3.62 times as far away the head is equally high.</source>
        <translation>Nii võetakse suuruseks vaatenurk. Filmil on kuju kõrgus võrdeline fookuskauguse ja kauguse suhtega {0}; nurk ei ole võrdeline suurusega {1}. Vaadake kaht fotot: 105 mm on 3.62 korda 29 mm ja 3.62 korda kaugemalt on pea kõrgus sama.</translation>
    </message>
    <message>
        <source>The image on the film is as large as before. What happened to {0}?</source>
        <translation>Kujutis filmil on sama suur kui enne. Mis juhtus suurusega {0}?</translation>
    </message>
    <message>
        <source>Sizes are proportional to {0}, so {1} is proportional to {2}. The angles of view, 39.6° and 23.9°, are no measure of size.</source>
        <translation>Suurused on võrdelised suhtega {0}, seega on {1} võrdeline suurusega {2}. Vaatenurgad, 39.6° ja 23.9°, suurust ei mõõda.</translation>
    </message>
    <message>
        <source>Another statue of the same height is 1 m behind the first. From 2 m the first looks 1.5 times as high as the second. How many times as high does it look from 5 m, with a zoom that keeps the size of the first?</source>
        <translation>Teine sama kõrge kuju on esimesest 1 m tagapool. 2 m kauguselt paistab esimene teisest 1.5 korda kõrgem. Mitu korda kõrgem paistab see 5 m kauguselt, kui suum säilitab esimese suuruse?</translation>
    </message>
    <message>
        <source>This keeps the ratio that was seen from 2 m. The zoom enlarges both statues alike; only their distances, 5 m and 6 m, decide how they compare. Look at the two squares in both pictures: they compare differently.</source>
        <translation>Nii jäetakse alles suhe, mida nähti 2 m kauguselt. Suum suurendab mõlemat kuju ühtemoodi; nende vahekorra määravad ainult nende kaugused, 5 m ja 6 m. Vaadake kaht ruutu mõlemal pildil: nende vahekord on erinev.</translation>
    </message>
    <message>
        <source>The size of each statue is proportional to one over its own distance.</source>
        <translation>Kummagi kuju suurus on võrdeline tema enda kauguse pöördarvuga.</translation>
    </message>
    <message>
        <source>{0} with the new {1}. The zoom enlarges both by the same factor.</source>
        <translation>{0} uue suurusega {1}. Suum suurendab mõlemat sama arv kordi.</translation>
    </message>
    <message>
        <source>Back to the head</source>
        <translation>Tagasi pea juurde</translation>
    </message>
    <message>
        <source>It is tempting to say that nothing changes, because the head keeps its size, and a zoom is made for this. But the zoom keeps sizes at only one depth, the target&apos;s. In front of it and behind it, sizes are proportional to one over *their* distance, and walking has changed that. So a portrait from close by has a large nose with any lens: the distance determines the perspective; the lens only selects a part of it.</source>
        <translation>Ahvatlev on öelda, et midagi ei muutu, sest pea säilitab oma suuruse ja suum on selleks tehtud. Aga suum säilitab suurused ainult ühel sügavusel, sihtpunkti omal. Selle ees ja taga on suurused võrdelised *omaenda* kauguse pöördarvuga ja kõndimine on seda muutnud. Nii on lähedalt tehtud portreel suur nina iga objektiiviga: perspektiivi määrab kaugus; objektiiv valib sellest ainult osa.</translation>
    </message>
    <message>
        <source>Practise: as large with another lens</source>
        <translation>Harjutus: sama suur teise objektiiviga</translation>
    </message>
    <message>
        <source>The head is photographed from {0} cm with a lens of {1} mm, on film 36 mm wide. From how many cm is it as large with {2} mm?</source>
        <translation>Pead pildistatakse {0} cm kauguselt {1} mm objektiiviga, filmi laius on 36 mm. Mitme sentimeetri kauguselt on see {2} mm-ga sama suur?</translation>
    </message>
    <message>
        <source>This takes the angle of view for the size. On the film the head is {0} times as large as it is; the angle of view is no measure of that. Look at the head from here with {1} mm: it is {2} times as large.</source>
        <translation>Nii võetakse suuruseks vaatenurk. Filmil on pea suurus {0} korda tegelik suurus; vaatenurk seda ei mõõda. Vaadake pead siit objektiiviga {1} mm: see on {2} korda nii suur.</translation>
    </message>
    <message>
        <source>A longer lens goes nearer</source>
        <translation>Pikem objektiiv läheb lähemale</translation>
    </message>
    <message>
        <source>From there the head would be larger still. A longer lens enlarges, so the camera must go back. Look at the head from here with {0} mm: it is larger already.</source>
        <translation>Sealt oleks pea veel suurem. Pikem objektiiv suurendab, seega peab kaamera tagasi minema. Vaadake pead siit objektiiviga {0} mm: see on juba suurem.</translation>
    </message>
    <message>
        <source>On the film, the head is {0} times as large as it is.</source>
        <translation>Filmil on pea suurus {0} korda tegelik suurus.</translation>
    </message>
    <message>
        <source>{0} must be equal to {1}: a longer lens needs a distance longer by the same factor.</source>
        <translation>{0} peab olema võrdne suurusega {1}: pikem objektiiv vajab sama arv kordi pikemat kaugust.</translation>
    </message>
    <message>
        <source>Practise: two squares</source>
        <translation>Harjutus: kaks ruutu</translation>
    </message>
    <message>
        <source>The near square is {0} from the eye; the far one is as large and {1} behind it. So the near one is drawn {2} times as large. How many times as large is it drawn from {3}, with a zoom that keeps its size?</source>
        <translation>Lähem ruut on silmast {0} kaugusel; kaugem on sama suur ja {1} selle taga. Seega joonistatakse lähem {2} korda suuremana. Mitu korda suuremana joonistatakse see kauguselt {3}, kui suum säilitab selle suuruse?</translation>
    </message>
    <message>
        <source>This keeps the ratio that is seen from {0}. The zoom enlarges both squares alike; only their distances decide how they compare. Look from the side: the camera is now {1} from the near square.</source>
        <translation>Nii jäetakse alles suhe, mida nähti kauguselt {0}. Suum suurendab mõlemat ruutu ühtemoodi; nende vahekorra määravad ainult nende kaugused. Vaadake küljelt: kaamera on nüüd lähemast ruudust {1} kaugusel.</translation>
    </message>
    <message>
        <source>The zoom makes them equal</source>
        <translation>Suum teeb need võrdseks</translation>
    </message>
    <message>
        <source>They would look equal only from infinitely far away. The far one is always 1.2 farther away. Look from the side: the far one is still farther away.</source>
        <translation>Võrdsed paistaksid need ainult lõpmata kaugelt. Kaugem on alati 1.2 võrra kaugemal. Vaadake küljelt: kaugem on endiselt kaugemal.</translation>
    </message>
    <message>
        <source>Each square is drawn as large as one over its own distance.</source>
        <translation>Kumbki ruut joonistatakse nii suurena, kui on tema enda kauguse pöördarv.</translation>
    </message>
    <message>
        <source>The near one is now {0} away. And the far one?</source>
        <translation>Lähem on nüüd {0} kaugusel. Ja kaugem?</translation>
    </message>
    <message>
        <source>The zoom enlarges both by the same factor, so only the distances count.</source>
        <translation>Suum suurendab mõlemat sama arv kordi, nii et loevad ainult kaugused.</translation>
    </message>
    <message>
        <source>Practise: a chosen ratio</source>
        <translation>Harjutus: valitud suhe</translation>
    </message>
    <message>
        <source>The near square is 0.64 in front of the target, the far square, as large, is 0.56 behind it.</source>
        <translation>Lähem ruut on sihtpunktist 0.64 eespool, sama suur kaugem ruut 0.56 tagapool.</translation>
    </message>
    <message>
        <source>Move the camera until the near square is drawn {0} times as large as the far one, and keep the head as high in the picture as it is now.</source>
        <translation>Liigutage kaamerat, kuni lähem ruut joonistatakse kaugemast {0} korda suuremana, ja jätke pea pildil sama kõrgeks, kui see praegu on.</translation>
    </message>
    <message>
        <source>From the near square to the far one it is {0}. At the distance {1} of the near square, the ratio is {2}.</source>
        <translation>Lähemast ruudust kaugemani on {0}. Kui lähema ruudu kaugus on {1}, on suhe {2}.</translation>
    </message>
    <message>
        <source>So the near square must be at {0}, and the target 0.64 farther away.</source>
        <translation>Seega peab lähem ruut olema kaugusel {0} ja sihtpunkt 0.64 kaugemal.</translation>
    </message>
    <message>
        <source>The slider *Distance, relative to the preset* keeps the size of the head.</source>
        <translation>Liugur *Kaugus, valmisväärtuse suhtes* säilitab pea suuruse.</translation>
    </message>
    <message>
        <source>{0} {1} {2} for the near square. The target is 0.64 farther: {3}.</source>
        <translation>{0} {1} {2} lähema ruudu jaoks. Sihtpunkt on 0.64 kaugemal: {3}.</translation>
    </message>
    <message>
        <source>A zoom enlarges both squares alike; only the distance changes how they compare. Look at both pictures: the squares compare in the same way.</source>
        <translation>Suum suurendab mõlemat ruutu ühtemoodi; nende vahekorda muudab ainult kaugus. Vaadake mõlemat pilti: ruutude vahekord on sama.</translation>
    </message>
    <message>
        <source>from here, 90°</source>
        <translation>siit, 90°</translation>
    </message>
</context>
<context>
    <name>l21-camera-obscura</name>
    <message>
        <source>Why upside down?</source>
        <translation>Miks tagurpidi?</translation>
    </message>
    <message>
        <source>Behind the eye</source>
        <translation>Silma taga</translation>
    </message>
    <message>
        <source>The plane of projection is 4 units in front of the eye. The corner {0}, at the top of the F, is 2.472 above the axis and 9.601 deep; its image is 1.03 above the axis. The World pane shows it from the side.</source>
        <translation>Projektsiooni tasand on silmast 4 ühikut eespool. F-i ülaosa nurk {0} on teljest 2.472 kõrgemal ja selle sügavus on 9.601; selle kujutis on teljest 1.03 kõrgemal. Paan Maailm näitab seda küljelt.</translation>
    </message>
    <message>
        <source>The plane moves to the other side, 4 units *behind* the eye, like the film in a camera obscura. Where is the image of {0} on it, along {1}?</source>
        <translation>Tasand läheb teisele poole, silmast 4 ühikut *tahapoole*, nagu film camera obscuras. Kus on sellel punkti {0} kujutis piki telge {1}?</translation>
    </message>
    <message>
        <source>at 1.03: still above the axis</source>
        <translation>kohal 1.03: endiselt teljest kõrgemal</translation>
    </message>
    <message>
        <source>The film keeps up what is up</source>
        <translation>Film jätab ülemise üles</translation>
    </message>
    <message>
        <source>This keeps the sign of a plane in front. Light goes straight through the eye, so what is above the axis in front of it is below the axis behind it. Look at P&apos;, behind the eye: it is below the axis.</source>
        <translation>Nii jäetakse alles ees oleva tasandi märk. Valgus läheb sirgelt läbi silma, nii et mis on selle ees teljest kõrgemal, on selle taga teljest allpool. Vaadake punkti P&apos; silma taga: see on teljest allpool.</translation>
    </message>
    <message>
        <source>at −1.03: below the axis</source>
        <translation>kohal −1.03: teljest allpool</translation>
    </message>
    <message>
        <source>there is none: light does not go backwards</source>
        <translation>seda ei ole: valgus ei lähe tagurpidi</translation>
    </message>
    <message>
        <source>It goes straight on through the eye and meets the plane behind it. Look at the projector: it goes through the eye to P&apos;.</source>
        <translation>Valgus läheb silmast sirgelt läbi ja kohtab selle taga olevat tasandit. Vaadake projektsioonikiirt: see läheb läbi silma punkti P&apos;.</translation>
    </message>
    <message>
        <source>The projector goes on through the eye, and crosses the axis there.</source>
        <translation>Projektsioonikiir läheb läbi silma edasi ja lõikab seal telge.</translation>
    </message>
    <message>
        <source>Two films</source>
        <translation>Kaks filmi</translation>
    </message>
    <message>
        <source>In the dark box, light goes through a hole, the centre of projection. The image of a thing of height {0} at the distance {1} in front of the hole has the height</source>
        <translation>Pimedas kastis tuleb valgus läbi ava, mis on projektsiooni keskpunkt. Kui asja kõrgus on {0} ja see on avast kaugusel {1} eespool, on selle kujutise kõrgus</translation>
    </message>
    <message>
        <source>on the film, {0} behind the hole. Here {1}, {2} and {3}: {4}. The minus turns the image upside down and exchanges left and right. The lecture&apos;s synthetic camera has its film at the same distance in front of the centre. There the image is {5} high: as large, and upright.</source>
        <translation>filmil, mis on avast {0} tagapool. Siin {1}, {2} ja {3}: {4}. Miinus pöörab kujutise tagurpidi ning vahetab vasaku ja parema. Loengu sünteetilise kaamera film on keskpunkti ees samal kaugusel. Seal on kujutise kõrgus {5}: sama suur ja püstine.</translation>
    </message>
    <message>
        <source>A quarter, upside down</source>
        <translation>Veerand, tagurpidi</translation>
    </message>
    <message>
        <source>Put the plane behind the eye so that the image of {0} is upside down and a quarter as far from the axis as {1} itself.</source>
        <translation>Pange tasand silma taha nii, et punkti {0} kujutis on tagurpidi ja teljest neli korda lähemal kui {1} ise.</translation>
    </message>
    <message>
        <source>The scale is {0}, and {1} is the depth of {2}.</source>
        <translation>Mastaap on {0} ja {1} on punkti {2} sügavus.</translation>
    </message>
    <message>
        <source>Type a negative Plane distance d. A quarter of 9.601 is 2.4.</source>
        <translation>Sisestage sättele Tasandi kaugus d negatiivne arv. Veerand arvust 9.601 on 2.4.</translation>
    </message>
    <message>
        <source>The scale is −0.25: a quarter as large, and turned over by the minus.</source>
        <translation>Mastaap on −0.25: neli korda väiksem ja miinusega ümber pööratud.</translation>
    </message>
    <message>
        <source>By the formula</source>
        <translation>Valemi järgi</translation>
    </message>
    <message>
        <source>The arrow is 5 high and 9 in front of the hole. The film moves to 6 behind the hole. How high is the arrow&apos;s image on the film, with its sign?</source>
        <translation>Noole kõrgus on 5 ja see on avast 9 eespool. Film läheb avast 6 tahapoole. Kui kõrge, märgiga arvuna, on noole kujutis filmil?</translation>
    </message>
    <message>
        <source>This is the image on a film in front of the hole. Behind the hole the light has crossed the axis, so the sign changes. Look at both films: only the one in front has the arrow upright.</source>
        <translation>See on kujutis filmil, mis on ava ees. Ava taga on valgus telge lõiganud, nii et märk muutub. Vaadake mõlemat filmi: nool on püsti ainult ees oleval.</translation>
    </message>
    <message>
        <source>This measures the arrow&apos;s distance from the film, {0}. The two triangles meet at the hole: measure both distances from there. Look at the hole: both triangles begin there.</source>
        <translation>Nii mõõdetakse noole kaugust filmist, {0}. Kaks kolmnurka kohtuvad avas: mõõtke mõlemat kaugust sealt. Vaadake ava: mõlemad kolmnurgad algavad seal.</translation>
    </message>
    <message>
        <source>Measure both lengths from the hole: {0}.</source>
        <translation>Mõõtke mõlemat pikkust avast: {0}.</translation>
    </message>
    <message>
        <source>The triangles share the corner at the hole.</source>
        <translation>Kolmnurkadel on ühine nurk avas.</translation>
    </message>
    <message>
        <source>How far behind the hole must the film be for the image to be a third as high as the arrow?</source>
        <translation>Kui kaugel ava taga peab film olema, et kujutise kõrgus oleks kolmandik noole kõrgusest?</translation>
    </message>
    <message>
        <source>This measures the arrow&apos;s distance from the film, which is 9 and the film&apos;s own distance. The two triangles meet at the hole: measure both distances from there. Look at the film 4.5 behind the hole: the image is half as high as the arrow.</source>
        <translation>Nii mõõdetakse noole kaugust filmist, mis on 9 pluss filmi enda kaugus. Kaks kolmnurka kohtuvad avas: mõõtke mõlemat kaugust sealt. Vaadake filmi, mis on avast 4.5 tagapool: kujutis on noolest poole madalam.</translation>
    </message>
    <message>
        <source>{0}. If you measure {1} from the film, you get {2}.</source>
        <translation>{0}. Kui mõõta {1} filmist, saab {2}.</translation>
    </message>
    <message>
        <source>Back to the film</source>
        <translation>Tagasi filmi juurde</translation>
    </message>
    <message>
        <source>It was tempting to keep the sign, because the triangles are the same. But the projector goes through the eye and crosses the axis there: what was above is now below. Our cameras put the plane in front, where nothing is turned over. A real camera has its film behind and turns the picture round afterwards; the numbers differ by the sign only.</source>
        <translation>Ahvatlev oli märk samaks jätta, sest kolmnurgad on samad. Aga projektsioonikiir läheb läbi silma ja lõikab seal telge: mis oli üleval, on nüüd all. Meie kaamerad panevad tasandi ette, kus midagi ümber ei pöördu. Tegeliku kaamera film on taga ja pilt pööratakse hiljem õigeks; arvud erinevad ainult märgi poolest.</translation>
    </message>
    <message>
        <source>Practise: height on the film</source>
        <translation>Harjutus: kõrgus filmil</translation>
    </message>
    <message>
        <source>An arrow, {0} high, stands before the hole of a dark box.</source>
        <translation>Nool kõrgusega {0} seisab pimeda kasti ava ees.</translation>
    </message>
    <message>
        <source>The arrow is {0} in front of the hole, the film {1} behind it. How high is the arrow&apos;s image on the film, with its sign?</source>
        <translation>Nool on avast {0} eespool, film {1} tagapool. Kui kõrge, märgiga arvuna, on noole kujutis filmil?</translation>
    </message>
    <message>
        <source>What stands upright in front of the hole stands on its head behind it.</source>
        <translation>Mis seisab ava ees püsti, seisab selle taga pea peal.</translation>
    </message>
    <message>
        <source>The image is {0} times as high as the arrow, and upside down.</source>
        <translation>Kujutise kõrgus on {0} korda noole kõrgus, ja kujutis on tagurpidi.</translation>
    </message>
    <message>
        <source>Practise: a corner on the film</source>
        <translation>Harjutus: nurk filmil</translation>
    </message>
    <message>
        <source>The picture shows the plane 4 in front of the eye. A film stands behind the eye; lay it over the picture, its middle on the middle, without turning it: right stays right, up stays up.</source>
        <translation>Pilt näitab tasandit, mis on silmast 4 eespool. Film on silma taga; pange see pildile, keskkoht keskkohale, ilma pööramata: parem jääb paremale, ülemine üles.</translation>
    </message>
    <message>
        <source>The film is {0} behind the eye, and drawn to the same scale. Mark where, on it, the image of point 1 lies.</source>
        <translation>Film on silmast {0} tagapool ja joonistatud samas mõõtkavas. Märkige, kus on sellel punkti 1 kujutis.</translation>
    </message>
    <message>
        <source>This is where the image lies on a plane {0} in front of the eye. Behind the eye the light has crossed the axis, so both coordinates change their signs. Look at both films of this dark box: behind the hole the image is upside down.</source>
        <translation>Seal on kujutis tasandil, mis on silmast {0} eespool. Silma taga on valgus telge lõiganud, nii et mõlemad koordinaadid vahetavad märki. Vaadake selle pimeda kasti mõlemat filmi: ava taga on kujutis tagurpidi.</translation>
    </message>
    <message>
        <source>Only up and down change</source>
        <translation>Vahetuvad ainult ülemine ja alumine</translation>
    </message>
    <message>
        <source>This turns the image upside down only. The light crosses the axis, so left and right are exchanged as well. Look from above at a film behind the eye: what is on the right comes to the left.</source>
        <translation>Nii pööratakse kujutis ainult tagurpidi. Valgus lõikab telge, nii et vahetuvad ka vasak ja parem. Vaadake ülalt silma taga olevat filmi: mis on paremal, satub vasakule.</translation>
    </message>
    <message>
        <source>The axis goes through the middle of the picture. On the film everything is on the other side of it.</source>
        <translation>Telg läbib pildi keskkohta. Filmil on kõik sellest teisel pool.</translation>
    </message>
    <message>
        <source>The scale is {0} of the one that you see.</source>
        <translation>Mastaap on {0} sellest, mida te näete.</translation>
    </message>
    <message>
        <source>On the other side of the middle, and {0} times as far from it.</source>
        <translation>Keskkohast teisel pool ja sellest {0} korda nii kaugel.</translation>
    </message>
    <message>
        <source>Practise: the film for a size</source>
        <translation>Harjutus: film suuruse järgi</translation>
    </message>
    <message>
        <source>{0} is {1} deep. Put the plane behind the eye so that the image of {2} is upside down and {3} times as far from the axis as {4}.</source>
        <translation>Punkti {0} sügavus on {1}. Pange tasand silma taha nii, et punkti {2} kujutis on tagurpidi ja teljest {3} korda nii kaugel kui {4}.</translation>
    </message>
    <message>
        <source>The image is {0} times as far from the axis as {1}. Measure both from the eye.</source>
        <translation>Kujutis on teljest {0} korda nii kaugel kui {1}. Mõõtke mõlemat silmast.</translation>
    </message>
    <message>
        <source>Behind the eye {0} is negative: type it under Plane distance d.</source>
        <translation>Silma taga on {0} negatiivne: sisestage see sättele Tasandi kaugus d.</translation>
    </message>
    <message>
        <source>{0}, with {1}</source>
        <translation>{0}, kus {1}</translation>
    </message>
    <message>
        <source>In front of the eye the image is upright. Look at P&apos;: it is above the axis. The plane must be behind the eye, at a negative {0}.</source>
        <translation>Silma ees on kujutis püstine. Vaadake punkti P&apos;: see on teljest kõrgemal. Tasand peab olema silma taga, negatiivse {0} juures.</translation>
    </message>
    <message>
        <source>This measures the depth of {0} from the plane. Both triangles begin at the eye. Look at P&apos;: it is less than {1} times as far from the axis as {2}.</source>
        <translation>Nii mõõdetakse punkti {0} sügavust tasandist. Mõlemad kolmnurgad algavad silmast. Vaadake punkti P&apos;: see on teljest vähem kui {1} korda nii kaugel kui {2}.</translation>
    </message>
</context>
<context>
    <name>l22-walk-round-the-f</name>
    <message>
        <source>What stays when the camera rises?</source>
        <translation>Mis jääb samaks, kui kaamera tõuseb?</translation>
    </message>
    <message>
        <source>A camera that rises, level</source>
        <translation>Kaamera tõuseb horisontaalselt</translation>
    </message>
    <message>
        <source>The letter F of eight cubes stands on its grid. The camera looks level: its eye is as high as its target. The uprights of the F are parallel in the picture.</source>
        <translation>Kaheksast kuubist F-täht seisab oma ruudustikul. Kaamera vaatab horisontaalselt: selle silm on sihtpunktiga ühel kõrgusel. F-i püstservad on pildil paralleelsed.</translation>
    </message>
    <message>
        <source>The camera rises to 5.5, above the F, and keeps looking level. What do the uprights do in the picture?</source>
        <translation>Kaamera tõuseb kõrgusele 5.5, F-ist kõrgemale, ja vaatab endiselt horisontaalselt. Mida teevad püstservad pildil?</translation>
    </message>
    <message>
        <source>they lean together downwards: the camera is above them</source>
        <translation>need koonduvad allapoole: kaamera on neist kõrgemal</translation>
    </message>
    <message>
        <source>From above, uprights lean</source>
        <translation>Ülalt vaadates on püstservad kaldu</translation>
    </message>
    <message>
        <source>Standing high does not make uprights meet; looking down does. This camera looks level, so the uprights are parallel to the picture and have no vanishing point. Look at both pictures from this height: only where the camera looks down do the uprights lean.</source>
        <translation>Püstservad ei koondu mitte kõrgel seismisest, vaid alla vaatamisest. See kaamera vaatab horisontaalselt, nii et püstservad on pildiga paralleelsed ja neil ei ole koondumispunkti. Vaadake mõlemat pilti sellelt kõrguselt: püstservad on kaldu ainult seal, kus kaamera vaatab alla.</translation>
    </message>
    <message>
        <source>level</source>
        <translation>horisontaalselt</translation>
    </message>
    <message>
        <source>looking down</source>
        <translation>alla vaadates</translation>
    </message>
    <message>
        <source>they stay parallel</source>
        <translation>need jäävad paralleelseks</translation>
    </message>
    <message>
        <source>they lean together upwards</source>
        <translation>need koonduvad ülespoole</translation>
    </message>
    <message>
        <source>That happens when the camera looks *up*, whatever its height. Look at the F from below: its uprights lean together upwards.</source>
        <translation>Nii juhtub, kui kaamera vaatab *üles*, ükskõik mis kõrguselt. Vaadake F-i alt: selle püstservad koonduvad ülespoole.</translation>
    </message>
    <message>
        <source>Only the direction of view decides whether uprights meet. It is still level, so {0} has no component along them.</source>
        <translation>Kas püstservad kohtuvad, otsustab ainult vaate suund. See on endiselt horisontaalne, nii et vektoril {0} ei ole nende sihis komponenti.</translation>
    </message>
    <message>
        <source>Looking at the target</source>
        <translation>Sihtpunkti vaadates</translation>
    </message>
    <message>
        <source>Now the target stays at 2 and the camera looks down. With {0} of length 10,</source>
        <translation>Nüüd jääb sihtpunkt kõrgusele 2 ja kaamera vaatab alla. Kui {0}, mille pikkus on 10, siis</translation>
    </message>
    <message>
        <source>{0} is also the cell in row 2, column 2 of the view matrix. The uprights are no longer at a right angle to {1}, because {2}, so they have a vanishing point, far below.</source>
        <translation>{0} on ka vaatemaatriksi lahter reas 2 ja veerus 2. Püstservad ei ole enam vektoriga {1} risti, sest {2}, nii et neil on koondumispunkt, kaugel all.</translation>
    </message>
    <message>
        <source>Level again</source>
        <translation>Jälle horisontaalselt</translation>
    </message>
    <message>
        <source>Points 1 and 2 mark the foot and the top of the F.</source>
        <translation>Punktid 1 ja 2 märgivad F-i alumist ja ülemist otsa.</translation>
    </message>
    <message>
        <source>Make the camera look level, with its eye as high as its target and the whole F in the picture.</source>
        <translation>Tehke nii, et kaamera vaatab horisontaalselt, silm on sihtpunktiga ühel kõrgusel ja kogu F on pildil.</translation>
    </message>
    <message>
        <source>Which angle in the dock says how steeply the camera looks down?</source>
        <translation>Milline nurk külgribal ütleb, kui järsult kaamera alla vaatab?</translation>
    </message>
    <message>
        <source>Elevation 0 is level.</source>
        <translation>Tõusunurk 0 on horisontaalne.</translation>
    </message>
    <message>
        <source>The uprights are parallel again, whatever the azimuth.</source>
        <translation>Püstservad on jälle paralleelsed, olgu asimuut milline tahes.</translation>
    </message>
    <message>
        <source>By the formula</source>
        <translation>Valemi järgi</translation>
    </message>
    <message>
        <source>The eye is at {0}, the target at {1}, and up is {2}. What is {3}, the cell in row 2, column 2 of the view matrix?</source>
        <translation>Silm on kohal {0}, sihtpunkt kohal {1} ja ülesvektor on {2}. Kui suur on {3}, vaatemaatriksi lahter reas 2 ja veerus 2?</translation>
    </message>
    <message>
        <source>This takes up itself for {0}. Up only has to point roughly upwards; {1} is at a right angle to the direction of view, so the more the camera looks down, the smaller {2} is. Look at up and {3}: they are not parallel.</source>
        <translation>Nii võetakse vektoriks {0} ülesvektor ise. Ülesvektor peab ainult ligikaudu üles näitama; {1} on vaate suunaga risti, nii et mida rohkem kaamera alla vaatab, seda väiksem on {2}. Vaadake ülesvektorit ja vektorit {3}: need ei ole paralleelsed.</translation>
    </message>
    <message>
        <source>This leaves the first product, of up and {0}, as it is, only 0.6 long. Make it 1 long before the second product. Look at up and {1}: they are not at a right angle.</source>
        <translation>Nii jäetakse esimene korrutis, ülesvektori ja vektori {0} oma, nii nagu see on, pikkusega ainult 0.6. Enne teist korrutist tehke selle pikkuseks 1. Vaadake ülesvektorit ja vektorit {1}: need ei ole risti.</translation>
    </message>
    <message>
        <source>{0}, so {1}.</source>
        <translation>{0}, seega {1}.</translation>
    </message>
    <message>
        <source>{0} is 10 long.</source>
        <translation>Vektori {0} pikkus on 10.</translation>
    </message>
    <message>
        <source>{0} is 0.6 long and must be made 1 long.</source>
        <translation>Vektori {0} pikkus on 0.6 ja see tuleb teha 1 pikkuseks.</translation>
    </message>
    <message>
        <source>How far away?</source>
        <translation>Kui kaugel?</translation>
    </message>
    <message>
        <source>The camera looks level from a height of 2.5, with a field of view of 60°. The top of the F is at 5. At which depth does it appear at {0}, half-way up to the edge?</source>
        <translation>Kaamera vaatab horisontaalselt kõrguselt 2.5, frustumi nurk on 60°. F-i ülemine ots on kõrgusel 5. Millisel sügavusel paistab see kohal {0}, poolel teel üles servani?</translation>
    </message>
    <message>
        <source>This takes the tangent of the whole 60°. The right-angled triangle lies between the axis and the upper edge of the picture and has half of the angle. Look at 90°: half the picture is as high as it is deep, {0}.</source>
        <translation>Nii võetakse kogu 60° tangens. Täisnurkne kolmnurk on telje ja pildi ülemise serva vahel ning selles on pool nurka. Vaadake 90°: pool pilti on sama kõrge kui sügav, {0}.</translation>
    </message>
    <message>
        <source>This multiplies by near, which is 2. The image on the near plane does grow with near, but so does the window round it; near only decides what is cut. Look at both pictures: they are the same.</source>
        <translation>Nii korrutatakse lähitasandi kaugusega, mis on 2. Kujutis lähitasandil tõesti kasvab koos lähitasandi kaugusega, aga kasvab ka aken selle ümber; lähitasand otsustab ainult, mis ära lõigatakse. Vaadake mõlemat pilti: need on ühesugused.</translation>
    </message>
    <message>
        <source>near 1</source>
        <translation>lähitasand 1</translation>
    </message>
    <message>
        <source>near 2</source>
        <translation>lähitasand 2</translation>
    </message>
    <message>
        <source>At the depth {0} half of the picture is {1} high.</source>
        <translation>Sügavusel {0} on poole pildi kõrgus {1}.</translation>
    </message>
    <message>
        <source>Back to the rising camera</source>
        <translation>Tagasi tõusva kaamera juurde</translation>
    </message>
    <message>
        <source>From above you usually *look down*, and houses lean in photographs from towers, so it was tempting to let the uprights lean. But looking down makes them lean, not the height. If a camera rises and looks level, the F moves in the picture but its uprights stay parallel. If a camera turns down to its target, {0} and the uprights meet. Press play in the tool bar: the section Animation has both ways of looking.</source>
        <translation>Ülalt tavaliselt *vaadatakse alla* ja tornist tehtud fotodel on majad kaldu, nii et ahvatlev oli panna püstservad kaldu. Aga kaldu teeb need alla vaatamine, mitte kõrgus. Kui kaamera tõuseb ja vaatab horisontaalselt, liigub F pildil, aga selle püstservad jäävad paralleelseks. Kui kaamera pöördub alla oma sihtpunkti poole, siis {0} ja püstservad kohtuvad. Vajutage tööriistaribal Esita: jaotises Animatsioon on mõlemad vaatamise viisid.</translation>
    </message>
    <message>
        <source>Practise: the vector v</source>
        <translation>Harjutus: vektor v</translation>
    </message>
    <message>
        <source>The eye is at {0}, the target at {1}, up is {2}, so {3}. What is the camera&apos;s {4}, the second row of the view matrix without its last number?</source>
        <translation>Silm on kohal {0}, sihtpunkt kohal {1}, ülesvektor on {2}, seega {3}. Milline on kaamera {4}, vaatemaatriksi teine rida ilma viimase arvuta?</translation>
    </message>
    <message>
        <source>Up only has to point roughly upwards. {0} is at a right angle to the direction of view, so it tilts when the camera looks down. Look at up and {1}: they are not parallel.</source>
        <translation>Ülesvektor peab ainult ligikaudu üles näitama. {0} on vaate suunaga risti, nii et see kaldub, kui kaamera vaatab alla. Vaadake ülesvektorit ja vektorit {1}: need ei ole paralleelsed.</translation>
    </message>
    <message>
        <source>This uses {0}, which is shorter than 1, in place of {1}. Make it 1 long before the second product. Look at up and {2}: they are not at a right angle.</source>
        <translation>Nii kasutatakse vektorit {0}, mis on 1-st lühem, vektori {1} asemel. Enne teist korrutist tehke selle pikkuseks 1. Vaadake ülesvektorit ja vektorit {2}: need ei ole risti.</translation>
    </message>
    <message>
        <source>{0}, then {1} along {2}, made 1 long; {3} is up.</source>
        <translation>{0}, siis {1} piki vektorit {2}, tehtud 1 pikkuseks; {3} on ülesvektor.</translation>
    </message>
    <message>
        <source>{0}, and {1}.</source>
        <translation>{0} ja {1}.</translation>
    </message>
    <message>
        <source>The middle number is the cosine of the angle by which the camera looks down.</source>
        <translation>Keskmine arv on selle nurga koosinus, mille võrra kaamera alla vaatab.</translation>
    </message>
    <message>
        <source>Practise: the least depth</source>
        <translation>Harjutus: väikseim sügavus</translation>
    </message>
    <message>
        <source>You look down on a camera that looks level. From above, the F is a bar with four corners.</source>
        <translation>Vaatate ülalt kaamerat, mis vaatab horisontaalselt. Ülalt on F nelja nurgaga riba.</translation>
    </message>
    <message>
        <source>Mark the corner of the F that is least deep for this camera.</source>
        <translation>Märkige F-i nurk, mille sügavus selle kaamera jaoks on kõige väiksem.</translation>
    </message>
    <message>
        <source>This corner is nearest to the eye. Depth is measured along the direction of view only, from the line through the eye that is parallel to near. Look from above at near, moved out: it meets another corner first.</source>
        <translation>See nurk on silmale kõige lähemal. Sügavust mõõdetakse ainult piki vaate suunda, silma läbivast sirgest, mis on lähitasandiga paralleelne. Vaadake ülalt kaugemale viidud lähitasandit: see jõuab enne teise nurgani.</translation>
    </message>
    <message>
        <source>Depth is measured along the direction of view, not straight to the point.</source>
        <translation>Sügavust mõõdetakse piki vaate suunda, mitte otse punktini.</translation>
    </message>
    <message>
        <source>Move a line that is parallel to near away from the eye. Which corner does it meet first?</source>
        <translation>Nihutage lähitasandiga paralleelset sirget silmast eemale. Millise nurgani jõuab see esimesena?</translation>
    </message>
    <message>
        <source>A line parallel to near, moved away from the eye, meets this corner first.</source>
        <translation>Lähitasandiga paralleelne sirge, mida silmast eemale nihutada, jõuab esimesena selle nurgani.</translation>
    </message>
    <message>
        <source>Practise: level, at a height in the picture</source>
        <translation>Harjutus: horisontaalselt, kõrgusel pildil</translation>
    </message>
    <message>
        <source>Point 1, on the top of the F, is at height 5, right above the target.</source>
        <translation>Punkt 1, F-i ülemises otsas, on kõrgusel 5, otse sihtpunkti kohal.</translation>
    </message>
    <message>
        <source>The camera looks level from a height of 2.5, with a field of view of {0}°. Go nearer or back until point 1 appears at {1}.</source>
        <translation>Kaamera vaatab horisontaalselt kõrguselt 2.5, frustumi nurk on {0}°. Minge lähemale või tagasi, kuni punkt 1 paistab kohal {1}.</translation>
    </message>
    <message>
        <source>At the distance {0}, half of the picture is {1} high.</source>
        <translation>Kaugusel {0} on poole pildi kõrgus {1}.</translation>
    </message>
    <message>
        <source>Near does not count, and half of the angle does: {0}.</source>
        <translation>Lähitasand ei loe, pool nurka loeb: {0}.</translation>
    </message>
    <message>
        <source>The triangle of eye, axis and edge has half of the angle at the eye. Look at 90°: half the picture is as high as it is deep, {0}.</source>
        <translation>Silma, telje ja serva kolmnurgas on silma juures pool nurka. Vaadake 90°: pool pilti on sama kõrge kui sügav, {0}.</translation>
    </message>
    <message>
        <source>The image on the near plane grows with near, and so does the window round it. Look at both pictures: they are the same.</source>
        <translation>Kujutis lähitasandil kasvab koos lähitasandi kaugusega ja kasvab ka aken selle ümber. Vaadake mõlemat pilti: need on ühesugused.</translation>
    </message>
</context>
<context>
    <name>l23-popping</name>
    <message>
        <source>Why does it pop?</source>
        <translation>Miks see hüppeliselt ilmub?</translation>
    </message>
    <message>
        <source>A tree at the side</source>
        <translation>Puu kõrval</translation>
    </message>
    <message>
        <source>The camera stands beside an avenue and looks along it. Far is 30. Point 1, on the axis of a tree that is not drawn yet, is 38 ahead and 15 to the right.</source>
        <translation>Kaamera seisab allee kõrval ja vaatab piki seda. Kaugtasand on 30. Punkt 1, mis on ühe veel joonistamata puu teljel, on 38 eespool ja 15 paremal.</translation>
    </message>
    <message>
        <source>Far moves out to 40. Is the trunk of that tree drawn then?</source>
        <translation>Kaugtasand viiakse 40 peale. Kas selle puu tüvi siis joonistatakse?</translation>
    </message>
    <message>
        <source>No: it is 40.85 away from the eye</source>
        <translation>Ei: see on silmast 40.85 kaugusel</translation>
    </message>
    <message>
        <source>This measures straight from the eye to the tree, as if far were a sphere. Far is a plane across the direction of view: only the 38 ahead count. Look from above: point 1 lies before far.</source>
        <translation>Nii mõõdetakse silmast otse puuni, nagu kaugtasand oleks kera. Kaugtasand on vaate suunaga risti olev tasand: loeb ainult 38 ettepoole. Vaadake ülalt: punkt 1 on kaugtasandi ees.</translation>
    </message>
    <message>
        <source>Yes: its depth is 38</source>
        <translation>Jah: selle sügavus on 38</translation>
    </message>
    <message>
        <source>No: you can see only half of far, up to 20</source>
        <translation>Ei: näete ainult poolt kaugtasandist, kuni 20</translation>
    </message>
    <message>
        <source>The whole distance up to far is visible, measured from the eye. Look from above: the pyramid reaches from the eye to far, and point 1 lies in it.</source>
        <translation>Nähtav on kogu kaugus kaugtasandini, silmast mõõdetuna. Vaadake ülalt: püramiid ulatub silmast kaugtasandini ja punkt 1 on selle sees.</translation>
    </message>
    <message>
        <source>Far is a plane across the axis. What matters is how far ahead the tree is, not how far away.</source>
        <translation>Kaugtasand on teljega risti olev tasand. Loeb, kui palju puu on eespool, mitte kui kaugel see on.</translation>
    </message>
    <message>
        <source>What passes the plane</source>
        <translation>Mis tasandit läbib</translation>
    </message>
    <message>
        <source>Seen from above the far plane cuts straight across the avenue. A tree appears when its depth {0} is less than {1}. If you drive ahead by {2}, every depth shrinks by {3}, however far a tree is to the side: a tree 62 ahead appears at {4}.</source>
        <translation>Ülalt vaadatuna lõikab kaugtasand alleed otse risti. Puu ilmub, kui selle sügavus {0} on väiksem kui {1}. Kui te sõidate {2} edasi, väheneb iga sügavus {3} võrra, ükskõik kui kaugel kõrval puu on: puu, mis on 62 eespool, ilmub siis, kui {4}.</translation>
    </message>
    <message>
        <source>The lecture has two remedies. Fog fades distant things, so you do not see them appear. Level of detail draws distant trees with fewer vertices, so far can be farther at the same cost.</source>
        <translation>Loengus on kaks abinõu. Udu tuhmistab kaugeid asju, nii et te ei näe neid ilmumas. Detailsus joonistab kauged puud vähemate tippudega, nii et kaugtasand võib sama kulu juures olla kaugemal.</translation>
    </message>
    <message>
        <source>Just so many trees</source>
        <translation>Täpselt nii palju puid</translation>
    </message>
    <message>
        <source>Each tree has 272 vertices. Set far so that exactly 10 trees are drawn, 2720 vertices.</source>
        <translation>Igal puul on 272 tippu. Seadke kaugtasand nii, et joonistatakse täpselt 10 puud, 2720 tippu.</translation>
    </message>
    <message>
        <source>A tree that the far plane cuts is drawn in part, and it counts.</source>
        <translation>Puu, mida kaugtasand lõikab, joonistatakse osaliselt ja läheb arvesse.</translation>
    </message>
    <message>
        <source>The rows are 6 apart: to remove two trees, move far in by 6.</source>
        <translation>Read on 6 vahega: kahe puu eemaldamiseks tooge kaugtasand 6 võrra lähemale.</translation>
    </message>
    <message>
        <source>Every six units another pair of trees reaches the far plane.</source>
        <translation>Iga kuue ühiku järel jõuab kaugtasandini järgmine paar puid.</translation>
    </message>
    <message>
        <source>By the formula</source>
        <translation>Valemi järgi</translation>
    </message>
    <message>
        <source>Point 1 is on the axis of a tree 44 ahead and 15 to the right. Far is 34. How far must the camera drive until the point is at the far plane?</source>
        <translation>Punkt 1 on puu teljel, mis on 44 eespool ja 15 paremal. Kaugtasand on 34. Kui kaugele peab kaamera sõitma, kuni punkt on kaugtasandil?</translation>
    </message>
    <message>
        <source>This waits until the tree is 34 away from the eye, measured straight. Far is a plane across the direction of view, so how far the tree is to the side does not matter. Look from above at far = 44: it goes through point 1, though the point is 46.5 away.</source>
        <translation>Nii oodatakse, kuni puu on silmast otse mõõdetuna 34 kaugusel. Kaugtasand on vaate suunaga risti olev tasand, nii et ei loe, kui kaugel kõrval puu on. Vaadake ülalt, kui kaugtasand = 44: see läbib punkti 1, kuigi see punkt on 46.5 kaugusel.</translation>
    </message>
    <message>
        <source>44 − 34. A tree at the side appears at the same time as one straight ahead.</source>
        <translation>44 − 34. Kõrval olev puu ilmub samal ajal kui otse ees olev.</translation>
    </message>
    <message>
        <source>The Above view shows the plane.</source>
        <translation>Vaade Ülalt näitab seda tasandit.</translation>
    </message>
    <message>
        <source>A fog begins at 15 and hides everything from 66 on; between them the contrast falls evenly. What percentage of the contrast is left at the far plane?</source>
        <translation>Udu algab kohal 15 ja peidab kõik alates kohast 66; nende vahel langeb kontrast ühtlaselt. Mitu protsenti kontrastist on kaugtasandil alles?</translation>
    </message>
    <message>
        <source>32 of the 51 units are left. With this contrast a tree still pops in.</source>
        <translation>51 ühikust on alles 32. Sellise kontrastiga ilmub puu endiselt hüppeliselt.</translation>
    </message>
    <message>
        <source>Back to the tree</source>
        <translation>Tagasi puu juurde</translation>
    </message>
    <message>
        <source>The tree is 40.85 away, more than far, so it was tempting to leave it out. If far were a sphere, that would be right. But a matrix can only give planes, so near and far are planes: the tree is drawn because it is 38 *ahead*. When the camera turns, the plane turns with it, and trees at the edge of the picture come and go although nobody has driven. Drag the azimuth and watch them.</source>
        <translation>Puu on 40.85 kaugusel, kaugemal kui kaugtasand, nii et ahvatlev oli see välja jätta. Kui kaugtasand oleks kera, oleks see õige. Aga maatriks annab ainult tasandeid, seega on lähi- ja kaugtasand tasandid: puu joonistatakse, sest see on 38 *eespool*. Kui kaamera pöördub, pöördub tasand koos sellega ja pildi servas olevad puud tulevad ja lähevad, kuigi keegi ei ole sõitnud. Lohistage asimuuti ja jälgige neid.</translation>
    </message>
    <message>
        <source>Practise: drive until it appears</source>
        <translation>Harjutus: sõitke, kuni see ilmub</translation>
    </message>
    <message>
        <source>Point 1 is {0} ahead and {1} to the right, and far is {2}. How far must the camera drive, straight ahead, until the point is at the far plane?</source>
        <translation>Punkt 1 on {0} eespool ja {1} paremal ning kaugtasand on {2}. Kui kaugele peab kaamera otse edasi sõitma, kuni punkt on kaugtasandil?</translation>
    </message>
    <message>
        <source>This waits until the point is {0} away from the eye, measured straight. Far is a plane across the direction of view, so how far the point is to the side does not matter. Look from above at far = {1}: it goes through point 1, however far that is to the side.</source>
        <translation>Nii oodatakse, kuni punkt on silmast otse mõõdetuna {0} kaugusel. Kaugtasand on vaate suunaga risti olev tasand, nii et ei loe, kui kaugel kõrval punkt on. Vaadake ülalt, kui kaugtasand = {1}: see läbib punkti 1, ükskõik kui kaugel kõrval see on.</translation>
    </message>
    <message>
        <source>The straight way counts</source>
        <translation>Loeb otsetee</translation>
    </message>
    <message>
        <source>This subtracts far from the straight distance to the point. Far is a plane across the direction of view: only how far the point is ahead counts. Look from above at far = {0}: it goes through point 1, however far that is to the side.</source>
        <translation>Nii lahutatakse kaugtasand otsesest kaugusest punktini. Kaugtasand on vaate suunaga risti olev tasand: loeb ainult, kui palju punkt on eespool. Vaadake ülalt, kui kaugtasand = {0}: see läbib punkti 1, ükskõik kui kaugel kõrval see on.</translation>
    </message>
    <message>
        <source>The view from above shows the far plane. Which distance to it does the drive shorten?</source>
        <translation>Vaade ülalt näitab kaugtasandit. Millist kaugust selleni sõit lühendab?</translation>
    </message>
    <message>
        <source>Driving shortens the depth alone. The point may be as far to the side as it likes.</source>
        <translation>Sõit lühendab ainult sügavust. Punkt võib olla kõrval nii kaugel kui tahes.</translation>
    </message>
    <message>
        <source>Practise: the last tree</source>
        <translation>Harjutus: viimane puu</translation>
    </message>
    <message>
        <source>You look down on the avenue; in each row the trees are 6 apart.</source>
        <translation>Vaatate alleed ülalt; igas reas on puud 6 vahega.</translation>
    </message>
    <message>
        <source>Far moves out by {0}, from {1} to {2}. In the row that is farther from the camera&apos;s way, mark the last tree whose trunk is then drawn.</source>
        <translation>Kaugtasand viiakse {0} võrra kaugemale, kohast {1} kohani {2}. Märkige reas, mis on kaamera teest kaugemal, viimane puu, mille tüvi siis joonistatakse.</translation>
    </message>
    <message>
        <source>The tree behind this one is farther from the eye than far, but less deep, and only depth counts. Far is a plane across the direction of view, not a circle round the eye. Look from above at far, moved out.</source>
        <translation>Selle taga olev puu on silmast kaugemal kui kaugtasand, aga selle sügavus on kaugtasandi omast väiksem, ja loeb ainult sügavus. Kaugtasand on vaate suunaga risti olev tasand, mitte ring ümber silma. Vaadake ülalt kaugemale viidud kaugtasandit.</translation>
    </message>
    <message>
        <source>The far plane moves along the direction of view and stays across it.</source>
        <translation>Kaugtasand liigub piki vaate suunda ja jääb sellega risti.</translation>
    </message>
    <message>
        <source>Trees are 6 apart. How many such distances fit into {0}?</source>
        <translation>Puude vahe on 6. Mitu sellist vahet mahub pikkusele {0}?</translation>
    </message>
    <message>
        <source>This tree is {0} deep, the next one {1}; far is then {2}.</source>
        <translation>Selle puu sügavus on {0}, järgmisel {1}; kaugtasand on siis {2}.</translation>
    </message>
    <message>
        <source>Practise: so many trees</source>
        <translation>Harjutus: nii palju puid</translation>
    </message>
    <message>
        <source>The first two trees are {0} ahead of the camera, and each following pair 6 farther. Set far so that exactly {1} trees are drawn; a tree that far cuts counts.</source>
        <translation>Esimesed kaks puud on kaamerast {0} eespool ja iga järgmine paar 6 kaugemal. Seadke kaugtasand nii, et joonistatakse täpselt {1} puud; puu, mida kaugtasand lõikab, läheb arvesse.</translation>
    </message>
    <message>
        <source>How deep is pair number {0}? Far must lie just behind it.</source>
        <translation>Kui sügaval on paar number {0}? Kaugtasand peab olema kohe selle taga.</translation>
    </message>
    <message>
        <source>Its depth is {0}. How far it is to the side does not count.</source>
        <translation>Selle sügavus on {0}. Kui kaugel kõrval see on, ei loe.</translation>
    </message>
    <message>
        <source>Pair number {0} is {1} deep, the next one {2}. A tree begins 1.5 nearer: far must be between the fronts of both pairs.</source>
        <translation>Paari number {0} sügavus on {1}, järgmisel {2}. Puu algab 1.5 lähemal: kaugtasand peab olema mõlema paari esikülgede vahel.</translation>
    </message>
</context>
<context>
    <name>l24-focus</name>
    <message>
        <source>What is sharp?</source>
        <translation>Mis on terav?</translation>
    </message>
    <message>
        <source>Behind the focus</source>
        <translation>Fookuse taga</translation>
    </message>
    <message>
        <source>The lens of the synthetic camera is a point, and everything is sharp. A real lens draws a point as a disc. A disc of diameter {0} or less passes for a point. The lens here has a focal length of 50 mm and an aperture of {1}, and is focused at 2 m.</source>
        <translation>Sünteetilise kaamera objektiiv on punkt ja kõik on terav. Tegelik objektiiv joonistab punkti kettana. Ketast, mille läbimõõt on {0} või vähem, peetakse punktiks. Siinse objektiivi fookuskaugus on 50 mm ja diafragma {1}, ning see on teravustatud 2 m peale.</translation>
    </message>
    <message>
        <source>The focus moves to 5 m. The sharp range begins at 4.287 m. At how many metres does it end?</source>
        <translation>Fookus viiakse 5 m peale. Terav vahemik algab 4.287 m kauguselt. Mitme meetri kaugusel see lõpeb?</translation>
    </message>
    <message>
        <source>5.713, as far behind the focus as in front</source>
        <translation>5.713, fookuse taga sama kaugel kui ees</translation>
    </message>
    <message>
        <source>The disc grows more slowly behind the focus than in front of it. So the sharp range reaches farther behind. Look from above: from the focus it is 0.713 m to the near limit, and 0.998 m to the far one.</source>
        <translation>Fookuse taga kasvab ketas aeglasemalt kui selle ees. Seepärast ulatub terav vahemik taga kaugemale. Vaadake ülalt: fookusest lähema piirini on 0.713 m ja kaugemani 0.998 m.</translation>
    </message>
    <message>
        <source>Only there are points drawn as points, but discs up to {0} pass for points. Look from above: the sharp range goes on behind the focus.</source>
        <translation>Ainult seal joonistatakse punktid punktidena, aga kettaid kuni {0} peetakse punktideks. Vaadake ülalt: terav vahemik jätkub fookuse taga.</translation>
    </message>
    <message>
        <source>0.713 m in front of the focus, but 0.998 m behind it. The scene&apos;s numbers have both limits. Of the posts those at 5 m and 6 m are outlined as sharp: the front of each is 15 cm nearer than its middle.</source>
        <translation>Fookuse ees 0.713 m, aga taga 0.998 m. Mõlemad piirid on stseeni arvudes. Postidest on teravana kontuuriga need, mis on 5 m ja 6 m kaugusel: kummagi esikülg on 15 cm lähemal kui selle keskkoht.</translation>
    </message>
    <message>
        <source>The two limits</source>
        <translation>Kaks piiri</translation>
    </message>
    <message>
        <source>For the focal length {0}, the aperture {1}, the circle of confusion {2} and the focus at {3},</source>
        <translation>Kui fookuskaugus on {0}, diafragma {1}, hajumisring {2} ja fookus kaugusel {3}, siis</translation>
    </message>
    <message>
        <source>and the picture is sharp from {0} to {1}.</source>
        <translation>ja pilt on terav kaugusest {0} kauguseni {1}.</translation>
    </message>
    <message>
        <source>Here {0} m, {1}, and so from {2} to {3} m. The World pane shows the three planes from above.</source>
        <translation>Siin {0} m, {1}, seega kaugusest {2} kauguseni {3} m. Paan Maailm näitab kolme tasandit ülalt.</translation>
    </message>
    <message>
        <source>Sharp without end</source>
        <translation>Lõputult terav</translation>
    </message>
    <message>
        <source>Make everything far away sharp: move the far limit to infinity.</source>
        <translation>Tehke kõik kaugel olev teravaks: viige kaugem piir lõpmatusse.</translation>
    </message>
    <message>
        <source>When does {0} become 0?</source>
        <translation>Millal saab {0} nulliks 0?</translation>
    </message>
    <message>
        <source>Focus at the hyperfocal distance H or farther away, or stop the lens down with a larger N until H is nearer than the focus.</source>
        <translation>Teravustage hüperfokaalsele kaugusele H või kaugemale või suurendage diafragmat N, kuni H on fookusest lähemal.</translation>
    </message>
    <message>
        <source>From {0} on, {1} is 1 or more. If you focus exactly at {2}, everything from {3} on is sharp.</source>
        <translation>Alates {0} on {1} 1 või rohkem. Kui teravustate täpselt kaugusele {2}, on kõik alates kaugusest {3} terav.</translation>
    </message>
    <message>
        <source>By the formula</source>
        <translation>Valemi järgi</translation>
    </message>
    <message>
        <source>A 50-mm lens with {0} and {1} mm is focused at 4 m. Up to how many metres is it sharp?</source>
        <translation>50-mm objektiiv, mille {0} ja {1} mm, on teravustatud 4 m peale. Mitme meetrini on see terav?</translation>
    </message>
    <message>
        <source>This is as far behind the focus as the near limit is in front of it. The disc grows more slowly behind the focus, so the far limit is farther away. Look from above: the far limit is farther from the focus than the near one.</source>
        <translation>See on fookuse taga sama kaugel, kui lähem piir on selle ees. Fookuse taga kasvab ketas aeglasemalt, seega on kaugem piir kaugemal. Vaadake ülalt: kaugem piir on fookusest kaugemal kui lähem.</translation>
    </message>
    <message>
        <source>{0} m, {1}, and {2}.</source>
        <translation>{0} m, {1} ja {2}.</translation>
    </message>
    <message>
        <source>First {0}, in metres.</source>
        <translation>Enne {0}, meetrites.</translation>
    </message>
    <message>
        <source>Posts at 3 m and at 6 m are exactly at the two limits. At how many metres is the focus?</source>
        <translation>Postid 3 m ja 6 m kaugusel on täpselt kahel piiril. Mitme meetri kaugusel on fookus?</translation>
    </message>
    <message>
        <source>This puts the focus half-way between the limits. The disc grows more slowly behind the focus, so the focus is closer to the near limit; what is half-way is one over the distance, between {0} and {1}. Look from above at the focus 4.5 with a near limit of 3: the far limit is 9, not 6.</source>
        <translation>Nii pannakse fookus piiride vahel poolele teele. Fookuse taga kasvab ketas aeglasemalt, seega on fookus lähemale piirile lähemal; poolel teel on kauguse pöördarv, {0} ja {1} vahel. Vaadake ülalt fookust 4.5, mille lähem piir on 3: kaugem piir on 9, mitte 6.</translation>
    </message>
    <message>
        <source>{0} is the middle of {1} and {2}: {3}.</source>
        <translation>{0} on {1} ja {2} keskkoht: {3}.</translation>
    </message>
    <message>
        <source>Which number is as far from {0} as from {1}?</source>
        <translation>Milline arv on suurusest {0} sama kaugel kui suurusest {1}?</translation>
    </message>
    <message>
        <source>Back to the limits</source>
        <translation>Tagasi piiride juurde</translation>
    </message>
    <message>
        <source>Half in front and half behind was tempting, because the disc is 0 at the focus and grows on both sides. But it does not grow equally: it is proportional to {0}, and one over the distance changes more slowly the farther away you are. So the far limit is always farther from the focus than the near one, and from the hyperfocal distance on it is at infinity.</source>
        <translation>Pool ees ja pool taga oli ahvatlev, sest ketas on fookuses 0 ja kasvab mõlemal pool. Aga see ei kasva võrdselt: see on võrdeline suurusega {0}, ja kauguse pöördarv muutub seda aeglasemalt, mida kaugemal te olete. Seepärast on kaugem piir fookusest alati kaugemal kui lähem ja alates hüperfokaalsest kaugusest on see lõpmatuses.</translation>
    </message>
    <message>
        <source>Practise: the far limit</source>
        <translation>Harjutus: kaugem piir</translation>
    </message>
    <message>
        <source>With {0} and {1}, all in metres.</source>
        <translation>Siin {0} ja {1}, kõik meetrites.</translation>
    </message>
    <message>
        <source>A lens with {0} mm and {1} is focused at {2} m, with {3} mm. Up to how many metres is the picture sharp?</source>
        <translation>Objektiiv, mille {0} mm ja {1}, on teravustatud kaugusele {2} m, kui {3} mm. Mitme meetrini on pilt terav?</translation>
    </message>
    <message>
        <source>This is as far behind the focus as the near limit is in front of it. The limits are {0} and {1}; the far one is farther from the focus. Look from above: it is farther from the focus than the near one.</source>
        <translation>See on fookuse taga sama kaugel, kui lähem piir on selle ees. Piirid on {0} ja {1}; kaugem neist on fookusest kaugemal. Vaadake ülalt: see on fookusest kaugemal kui lähem piir.</translation>
    </message>
    <message>
        <source>Both limits have a plus</source>
        <translation>Mõlemal piiril on pluss</translation>
    </message>
    <message>
        <source>This is the near limit, {0}. Behind the focus it is {1}. Look from above: the far limit lies behind the focus.</source>
        <translation>See on lähem piir, {0}. Fookuse taga on see {1}. Vaadake ülalt: kaugem piir on fookuse taga.</translation>
    </message>
    <message>
        <source>First {0}, in metres: {1} mm are {2} m, and 0.03 mm are 0.00003 m.</source>
        <translation>Enne {0}, meetrites: {1} mm on {2} m ja 0.03 mm on 0.00003 m.</translation>
    </message>
    <message>
        <source>Then {0}, and the far limit {1}.</source>
        <translation>Siis {0} ja kaugem piir {1}.</translation>
    </message>
    <message>
        <source>Here {0} is {1} m, and {2} is {3}.</source>
        <translation>{0} on siin {1} m ja {2} on {3}.</translation>
    </message>
    <message>
        <source>Practise: where does it end?</source>
        <translation>Harjutus: kus see lõpeb?</translation>
    </message>
    <message>
        <source>You look down on the lens and the posts, which are 2, 3, 4, 5, 6, 8, 10, 12, 15 and 20 m away.</source>
        <translation>Vaatate ülalt objektiivi ja poste, mis on 2, 3, 4, 5, 6, 8, 10, 12, 15 ja 20 m kaugusel.</translation>
    </message>
    <message>
        <source>The lens has {0} mm and is focused at {1} m. It is stopped down to {2}, so that {3} m. Mark where on the axis, the middle line ahead of the eye, the sharp range now ends.</source>
        <translation>Objektiivil on {0} mm ja see on teravustatud {1} m peale. Diafragmaks on seatud {2}, nii et {3} m. Märkige, kus teljel, mis on keskmine joon silma ees, terav vahemik nüüd lõpeb.</translation>
    </message>
    <message>
        <source>This is as far behind the focus as the near limit is in front of it. The far limit, {0}, is farther away. Look from above at both limits.</source>
        <translation>See on fookuse taga sama kaugel, kui lähem piir on selle ees. Kaugem piir, {0}, on kaugemal. Vaadake ülalt mõlemat piiri.</translation>
    </message>
    <message>
        <source>The far limit is {0}. Find its distance between the posts.</source>
        <translation>Kaugem piir on {0}. Leidke selle kaugus postide vahelt.</translation>
    </message>
    <message>
        <source>{0}, so the range ends at {1} m.</source>
        <translation>{0}, seega lõpeb vahemik kaugusel {1} m.</translation>
    </message>
    <message>
        <source>Practise: sharp from here to there</source>
        <translation>Harjutus: terav siit sinna</translation>
    </message>
    <message>
        <source>With {0} the picture is sharp from {1} to {2}.</source>
        <translation>Kui {0}, on pilt terav kaugusest {1} kauguseni {2}.</translation>
    </message>
    <message>
        <source>This lens has {0} mm and {1} mm. Set its focal distance {2} and its aperture {3} so that the picture is sharp from {4} m to {5} m.</source>
        <translation>Sellel objektiivil on {0} mm ja {1} mm. Seadke selle teravustamiskaugus {2} ja diafragma {3} nii, et pilt on terav kaugusest {4} m kauguseni {5} m.</translation>
    </message>
    <message>
        <source>{0} is the middle of {1} and {2}, so {3}.</source>
        <translation>{0} on {1} ja {2} keskkoht, seega {3}.</translation>
    </message>
    <message>
        <source>The focus at {0} m gives {1}.</source>
        <translation>Fookus kaugusel {0} m annab {1}.</translation>
    </message>
    <message>
        <source>{0}, all in metres.</source>
        <translation>{0}, kõik meetrites.</translation>
    </message>
    <message>
        <source>{0} {1} {2} m, from {3} m to {4} m; and {5} {6}, with {7}.</source>
        <translation>{0} {1} {2} m, kaugusest {3} m kauguseni {4} m; ja {5} {6}, kus {7}.</translation>
    </message>
    <message>
        <source>The far limit is farther from the focus than the near one. Look from above at the focus {0} with a near limit of {1}: the far limit is beyond {2}.</source>
        <translation>Kaugem piir on fookusest kaugemal kui lähem. Vaadake ülalt fookust {0}, mille lähem piir on {1}: kaugem piir on kaugemal kui {2}.</translation>
    </message>
</context>
<context>
    <name>l25-how-many-bits</name>
    <message>
        <source>How many bits does a picture need?</source>
        <translation>Mitu bitti pilt vajab?</translation>
    </message>
    <message>
        <source>More places than pixels</source>
        <translation>Rohkem kohti kui piksleid</translation>
    </message>
    <message>
        <source>A coordinate of 16 bits has 65 536 places. Here they are spread over the scene&apos;s longest side, 8 units, and the picture is 320 pixels wide. Each arrow in **Image** runs from where a vertex belongs towards where it is drawn, enlarged 10 000 times. The dock says how far off a vertex of the picture is at most: 0.002 pixels.</source>
        <translation>16-bitisel koordinaadil on 65 536 kohta. Siin on need jaotatud üle stseeni pikima külje, 8 ühiku, ja pildi laius on 320 pikslit. Iga nool paanis **Pilt** osutab sellest kohast, kuhu tipp kuulub, selle poole, kuhu see joonistatakse, suurendatud 10 000 korda. Külgriba ütleb, kui suur on pildi tipu viga kõige rohkem: 0.002 pikslit.</translation>
    </message>
    <message>
        <source>The camera comes up to a corner of the F, as near as 0.01 units. How far off is the corner now?</source>
        <translation>Kaamera tuleb F-i ühe nurga juurde, kuni 0.01 ühiku kaugusele. Kui suur on nüüd selle nurga viga?</translation>
    </message>
    <message>
        <source>Nothing that can be seen: 65 536 places are more than 320 pixels</source>
        <translation>Midagi ei ole näha: 65 536 kohta on rohkem kui 320 pikslit</translation>
    </message>
    <message>
        <source>The places are spread over the whole scene, and the picture now shows a small part of it. Look at the corner: from one place to the next are 3.3 pixels.</source>
        <translation>Kohad on jaotatud üle kogu stseeni ja pilt näitab nüüd sellest väikest osa. Vaadake nurka: ühest kohast teiseni on 3.3 pikslit.</translation>
    </message>
    <message>
        <source>0.002 pixels, as before: the vertex is stored as it was</source>
        <translation>0.002 pikslit, nagu enne: tipp on salvestatud nii, nagu see oli</translation>
    </message>
    <message>
        <source>The vertex is off by the same length, but here a unit fills 27 000 pixels. Look at the corner: it is off by more than a pixel.</source>
        <translation>Tipu viga on sama pikk, aga siin täidab ühik 27 000 pikslit. Vaadake nurka: selle viga on rohkem kui üks piksel.</translation>
    </message>
    <message>
        <source>By up to 1.6 pixels across, and as much down</source>
        <translation>Kuni 1.6 pikslit kõrvale ja sama palju alla</translation>
    </message>
    <message>
        <source>The places are 0.00012 units apart wherever you look. At 0.01 units from the eye, a unit fills 27 000 pixels.</source>
        <translation>Kohtade vahe on 0.00012 ühikut, ükskõik kuhu te vaatate. 0.01 ühiku kaugusel silmast täidab ühik 27 000 pikslit.</translation>
    </message>
    <message>
        <source>From bits to pixels</source>
        <translation>Bittidest piksliteni</translation>
    </message>
    <message>
        <source>With {0} bits over a side {1} the places are {2} apart. A coordinate goes to the nearest place, so it is off by half of that at most. At the depth {3} a picture {4} pixels high shows {5} units, and so</source>
        <translation>Kui küljel {1} on {0} bitti, on kohtade vahe {2}. Koordinaat läheb lähimasse kohta, nii et selle viga on ülimalt pool sellest. Sügavusel {3} näitab {4} piksli kõrgune pilt {5} ühikut, seega</translation>
    </message>
    <message>
        <source>With 8 bits: {0} units. At the target, {1}, a unit fills {2} pixels, so one coordinate is off by up to 0.37 pixels. Three coordinates together, nearer to the eye, make a little more. The *predicted* number in the dock is such a bound: no error is larger.</source>
        <translation>8 bitiga: {0} ühikut. Sihtpunkti kaugusel, {1}, täidab ühik {2} pikslit, nii et ühe koordinaadi viga on kuni 0.37 pikslit. Kolm koordinaati koos, silmale lähemal, annavad natuke rohkem. Külgribal *ennustatud* arv on selline tõke: ükski viga ei ole sellest suurem.</translation>
    </message>
    <message>
        <source>With 12 bits instead of 8, over the same side of 8 units: by how many units is a coordinate off at most?</source>
        <translation>12 bitiga 8 asemel, üle sama 8 ühiku pikkuse külje: mitu ühikut on koordinaadi viga kõige rohkem?</translation>
    </message>
    <message>
        <source>The gap is the error</source>
        <translation>Vahe on viga</translation>
    </message>
    <message>
        <source>This is the distance between two places. The coordinate goes to the nearer one, so it is off by half of it at most. Look at the picture with 12 bits, and at *predicted* in the panel.</source>
        <translation>See on kahe koha vahe. Koordinaat läheb lähemasse, nii et selle viga on ülimalt pool sellest. Vaadake 12-bitist pilti ja paneelil arvu *ennustatud*.</translation>
    </message>
    <message>
        <source>{0} units from place to place, and half of that.</source>
        <translation>{0} ühikut kohast kohani, ja pool sellest.</translation>
    </message>
    <message>
        <source>12 bits have {0} places, and one gap less.</source>
        <translation>12 bitil on {0} kohta ja vahesid ühe võrra vähem.</translation>
    </message>
    <message>
        <source>Where you stand</source>
        <translation>Kus te seisate</translation>
    </message>
    <message>
        <source>Still 8 bits: nothing about the stored vertices changes in this step.</source>
        <translation>Endiselt 8 bitti: salvestatud tippude juures ei muutu selles sammus midagi.</translation>
    </message>
    <message>
        <source>Make the largest measured error smaller than 0.3 pixels, and leave the 8 bits as they are.</source>
        <translation>Tehke suurim mõõdetud viga väiksemaks kui 0.3 pikslit ja jätke 8 bitti nii, nagu need on.</translation>
    </message>
    <message>
        <source>What stands in the denominator of {0}?</source>
        <translation>Mis on suuruse {0} nimetajas?</translation>
    </message>
    <message>
        <source>Move Distance to the right. A wider Field of view helps, too.</source>
        <translation>Nihutage Kaugust paremale. Aitab ka laiem Frustumi nurk.</translation>
    </message>
    <message>
        <source>Fewer pixels for each unit, fewer pixels of error. A game may use 8 bits for a far mountain and 16 for the sword in your hand.</source>
        <translation>Vähem piksleid ühiku kohta, vähem piksleid viga. Mäng võib kasutada 8 bitti kauge mäe jaoks ja 16 mõõga jaoks teie käes.</translation>
    </message>
    <message>
        <source>A vertex at the depth 10 is 0.4 pixels off. The camera comes nearer, to the depth 5. How many pixels is it off now?</source>
        <translation>Tipu viga sügavusel 10 on 0.4 pikslit. Kaamera tuleb lähemale, sügavusele 5. Mitu pikslit on viga nüüd?</translation>
    </message>
    <message>
        <source>The vertex is off by the same length, but at half the depth a unit has twice as many pixels. Look at the arrows from nearer by: they are longer.</source>
        <translation>Tipu viga on sama pikk, aga poole väiksemal sügavusel on ühikus kaks korda rohkem piksleid. Vaadake nooli lähemalt: need on pikemad.</translation>
    </message>
    <message>
        <source>{0} has {1} in its denominator: at half the depth every length, and every error, is drawn twice as long.</source>
        <translation>Suuruse {0} nimetajas on {1}: poole väiksemal sügavusel joonistatakse iga pikkus ja iga viga kaks korda pikemana.</translation>
    </message>
    <message>
        <source>Far from the origin</source>
        <translation>Alguspunktist kaugel</translation>
    </message>
    <message>
        <source>Now vertices and arithmetic are float32, about 7 decimal digits. The world&apos;s origin is moved 1 000 000 units away, and everything else stays where it is: camera and F are neighbours, far out. Their coordinates are now about 1 000 000, and the matrix subtracts them from each other.</source>
        <translation>Nüüd on tipud ja aritmeetika float32, umbes 7 kümnendnumbrit. Maailma alguspunkt viiakse 1 000 000 ühiku kaugusele ja kõik muu jääb oma kohale: kaamera ja F on naabrid, kaugel väljas. Nende koordinaadid on nüüd umbes 1 000 000 ja maatriks lahutab need teineteisest.</translation>
    </message>
    <message>
        <source>A float32 has 24 significant bits. How far apart are its numbers near 1 000 000, which lies between {0} and {1}?</source>
        <translation>float32-l on 24 tüvebitti. Kui suur on selle arvude vahe arvu 1 000 000 lähedal, mis on {0} ja {1} vahel?</translation>
    </message>
    <message>
        <source>A float32 keeps 24 bits, so its numbers near 1 000 000 are apart by what the last bit counts. Look at the F: its corners are at such places only.</source>
        <translation>float32 hoiab alles 24 bitti, nii et arvu 1 000 000 lähedal on selle arvude vahe nii suur, kui on väärt viimane bitt. Vaadake F-i: selle nurgad on ainult sellistel kohtadel.</translation>
    </message>
    <message>
        <source>The first of 24 bits counts {0}, the last one {1}: one sixteenth of a unit.</source>
        <translation>Esimene bitt 24-st on väärt {0}, viimane {1}: kuueteistkümnendik ühikust.</translation>
    </message>
    <message>
        <source>The first bit counts {0}, the second {1}. What does bit 24 count?</source>
        <translation>Esimene bitt on väärt {0}, teine {1}. Kui palju on väärt bitt 24?</translation>
    </message>
    <message>
        <source>A vertex is 10 units from the eye, measured along x, and is stored as the nearest float32. By how many per cent of these 10 units can it be off?</source>
        <translation>Tipp on silmast piki x-telge mõõdetuna 10 ühiku kaugusel ja salvestatakse lähima float32-na. Mitu protsenti nendest 10 ühikust võib selle viga olla?</translation>
    </message>
    <message>
        <source>The seven digits belong to the coordinate, near 1 000 000. The subtraction takes the leading ones away, and the rounding stays. Look at the F: its corners are off by parts of a unit.</source>
        <translation>Need seitse numbrit kuuluvad koordinaadile, mis on 1 000 000 lähedal. Lahutamine võtab esimesed ära ja ümardusviga jääb. Vaadake F-i: selle nurkade viga on osa ühikust.</translation>
    </message>
    <message>
        <source>Half a gap, 0.031 units, of 10. The subtraction leaves the error as it is and takes away the digits before it: from 7 digits 2 or 3 are left.</source>
        <translation>Pool vahet, 0.031 ühikut, 10-st. Lahutamine jätab vea samaks ja võtab ära numbrid selle eest: 7 numbrist jääb järele 2 või 3.</translation>
    </message>
    <message>
        <source>Buy what you need</source>
        <translation>Ostke, mida vajate</translation>
    </message>
    <message>
        <source>A console of 1994 had no time for more: vertices were drawn at whole pixels, and textures were stretched over the screen without a divide. Turn the camera slowly and watch the corners of the F.</source>
        <translation>1994. aasta mängukonsoolil rohkemaks aega ei olnud: tipud joonistati täispiksliteks ja tekstuurid venitati ekraanile ilma jagamata. Pöörake kaamerat aeglaselt ja jälgige F-i nurki.</translation>
    </message>
    <message>
        <source>Choose a hardware that stores a vertex in fewer than 5 bytes, with a largest measured error below 0.1 pixels in this picture.</source>
        <translation>Valige riistvara, mis salvestab tipu vähem kui 5 baidiga ja mille suurim mõõdetud viga on sellel pildil alla 0.1 piksli.</translation>
    </message>
    <message>
        <source>8 bits take 3 bytes a vertex. Which others take fewer than 5?</source>
        <translation>8 bitti võtab 3 baiti tipu kohta. Millised teised võtavad vähem kui 5?</translation>
    </message>
    <message>
        <source>12 bits: 4.5 bytes instead of float32&apos;s 12, and nobody sees the difference in a picture of 320 by 240.</source>
        <translation>12 bitti: 4.5 baiti float32-arvude 12 baidi asemel, ja keegi ei näe vahet 320 korda 240 piksliga pildil.</translation>
    </message>
    <message>
        <source>Back to the corner</source>
        <translation>Tagasi nurga juurde</translation>
    </message>
    <message>
        <source>65 536 places were tempting because no screen has so many columns. But the places belong to the scene, and the pixels to the picture: the number that matters is pixels per place, and you change it with every step. The two pictures draw the corner with 16 bits and with float64. So ask for the error in pixels from where you will stand, and buy the bits for that.</source>
        <translation>65 536 kohta olid ahvatlevad, sest nii palju veerge ei ole ühelgi ekraanil. Aga kohad kuuluvad stseenile ja pikslid pildile: loeb see, mitu pikslit on koha kohta, ja seda muudate te iga sammuga. Need kaks pilti joonistavad nurga 16 bitiga ja float64-ga. Küsige seepärast viga pikslites sealt, kus te seisma hakkate, ja ostke bitid selle jaoks.</translation>
    </message>
    <message>
        <source>16 bits</source>
        <translation>16 bitti</translation>
    </message>
    <message>
        <source>float64</source>
        <translation>float64</translation>
    </message>
    <message>
        <source>Practise: bits and pixels</source>
        <translation>Harjutus: bitid ja pikslid</translation>
    </message>
    <message>
        <source>With {0} bits over a side {1} a coordinate is off by half of {2} at most. Here {3} units, the picture is 240 pixels high, and the field of view is 48°.</source>
        <translation>Kui küljel {1} on {0} bitti, on koordinaadi viga ülimalt pool suurusest {2}. Siin on {3} ühikut, pildi kõrgus on 240 pikslit ja frustumi nurk 48°.</translation>
    </message>
    <message>
        <source>A vertex is at the depth {0}, and its coordinates have {1} bits. By how many pixels is one of them off in the picture at most?</source>
        <translation>Tipp on sügavusel {0} ja selle koordinaatidel on {1} bitti. Mitu pikslit on neist ühe viga pildil kõige rohkem?</translation>
    </message>
    <message>
        <source>This is the distance between two places. The coordinate goes to the nearer one, so it is off by half of it at most. Look at the arrows: each corner goes to the nearer place.</source>
        <translation>See on kahe koha vahe. Koordinaat läheb lähemasse, nii et selle viga on ülimalt pool sellest. Vaadake nooli: iga nurk läheb lähemasse kohta.</translation>
    </message>
    <message>
        <source>This takes the tangent of the whole field of view. Half the picture belongs to half of the angle. Look at the picture at 90°: it is {0} high; {1} would be infinite.</source>
        <translation>Nii võetakse kogu frustumi nurga tangens. Pool pilti kuulub poole nurga juurde. Vaadake pilti 90° juures: selle kõrgus on {0}; {1} oleks lõpmatu.</translation>
    </message>
    <message>
        <source>How many units is a coordinate off at most?</source>
        <translation>Mitu ühikut on koordinaadi viga kõige rohkem?</translation>
    </message>
    <message>
        <source>At the depth {0} the picture shows {1} units, from bottom to top, in 240 pixels.</source>
        <translation>Sügavusel {0} näitab pilt alt üles {1} ühikut 240 pikslis.</translation>
    </message>
    <message>
        <source>The coordinate is off by up to {0} units, and a unit at this depth has {1} pixels.</source>
        <translation>Koordinaadi viga on kuni {0} ühikut ja ühikus on sellel sügavusel {1} pikslit.</translation>
    </message>
    <message>
        <source>Practise: far from the origin</source>
        <translation>Harjutus: alguspunktist kaugel</translation>
    </message>
    <message>
        <source>A float32 has 24 significant bits. The world&apos;s origin is moved away along x, so the coordinates of the F are about as large as the distance of the origin.</source>
        <translation>float32-l on 24 tüvebitti. Maailma alguspunkt on piki x-telge kaugele viidud, nii et F-i koordinaadid on umbes sama suured kui alguspunkti kaugus.</translation>
    </message>
    <message>
        <source>The origin is {0} units away. This number lies between {1} and {2}, which are powers of 2. By how many units is a float32 near it off at most?</source>
        <translation>Alguspunkt on {0} ühiku kaugusel. See arv on {1} ja {2} vahel, mis on 2 astmed. Mitu ühikut on selle lähedal float32 viga kõige rohkem?</translation>
    </message>
    <message>
        <source>This is the distance between two numbers. A coordinate becomes the nearer one, so it is off by half of it at most. Look at the arrows: each corner goes to the nearer number.</source>
        <translation>See on kahe arvu vahe. Koordinaadist saab lähem neist, nii et selle viga on ülimalt pool sellest. Vaadake nooli: iga nurk läheb lähema arvu juurde.</translation>
    </message>
    <message>
        <source>A float32 has 24 bits, and its numbers lie as far apart as the last bit counts: a power of 2, not of 10. Look at the arrows: each corner goes to the nearer number.</source>
        <translation>float32-l on 24 bitti ja selle arvude vahe on nii suur, kui on väärt viimane bitt: see on 2 aste, mitte 10 aste. Vaadake nooli: iga nurk läheb lähema arvu juurde.</translation>
    </message>
    <message>
        <source>24 bits are 24 halvings</source>
        <translation>24 bitti on 24 poolitamist</translation>
    </message>
    <message>
        <source>This counts 25 bits. The first of 24 bits counts {0}, so the last one counts {1}{2}: from the first to the last it is halved 23 times. Look at the arrows: each corner goes to the nearer number.</source>
        <translation>Nii loetakse 25 bitti. Esimene bitt 24-st on väärt {0}, seega on viimane väärt {1}{2}: esimesest viimaseni poolitatakse seda 23 korda. Vaadake nooli: iga nurk läheb lähema arvu juurde.</translation>
    </message>
    <message>
        <source>The first bit counts {0}, the second half of that. What does bit 24 count?</source>
        <translation>Esimene bitt on väärt {0}, teine poole sellest. Kui palju on väärt bitt 24?</translation>
    </message>
    <message>
        <source>The numbers are as far apart as bit 24 counts.</source>
        <translation>Arvude vahe on nii suur, kui on väärt bitt 24.</translation>
    </message>
    <message>
        <source>Bit 24 counts {0}{1}, and half of that is the largest error.</source>
        <translation>Bitt 24 on väärt {0}{1} ja pool sellest on suurim viga.</translation>
    </message>
    <message>
        <source>Practise: stand where it is good enough</source>
        <translation>Harjutus: seiske seal, kus sellest piisab</translation>
    </message>
    <message>
        <source>With 8 bits over 8 units a coordinate is off by half of {0} at most. The field of view is 53.13°: at the depth {1} the picture is exactly {2} units high.</source>
        <translation>Kui 8 ühikul on 8 bitti, on koordinaadi viga ülimalt pool suurusest {0}. Frustumi nurk on 53.13°: sügavusel {1} on pildi kõrgus täpselt {2} ühikut.</translation>
    </message>
    <message>
        <source>Keep the 8 bits and the {0} pixels of height, and move the camera until a coordinate of a vertex at the target is off by up to {1} pixels.</source>
        <translation>Jätke 8 bitti ja pildi kõrguseks {0} pikslit ning liigutage kaamerat, kuni sihtpunkti juures oleva tipu koordinaadi viga on kuni {1} pikslit.</translation>
    </message>
    <message>
        <source>This takes the distance between two places for the error. The coordinate goes to the nearer place, so it is off by half of that at most. Look at the F from where you stand: it is smaller than it has to be.</source>
        <translation>Nii võetakse veaks kahe koha vahe. Koordinaat läheb lähemasse kohta, nii et selle viga on ülimalt pool sellest. Vaadake F-i sealt, kus te seisate: see on väiksem, kui vaja.</translation>
    </message>
    <message>
        <source>How many units is a coordinate off at most? And how many pixels has a unit at the target?</source>
        <translation>Mitu ühikut on koordinaadi viga kõige rohkem? Ja mitu pikslit on sihtpunkti kaugusel ühikus?</translation>
    </message>
    <message>
        <source>{0} must be {1}.</source>
        <translation>{0} peab olema {1}.</translation>
    </message>
</context>
<context>
    <name>l26-small-errors</name>
    <message>
        <source>Small errors that grow</source>
        <translation>Väikesed vead, mis kasvavad</translation>
    </message>
    <message>
        <source>Round and round</source>
        <translation>Ringi ja ringi</translation>
    </message>
    <message>
        <source>A camera turns by 1° a frame: each frame multiplies its axes by the same matrix, in float32, and every product is rounded. After 360 frames it should be home. It is off by 0.003 pixels. In **Image** this is drawn 20 000 times as large, beside the pale true picture.</source>
        <translation>Kaamera pöördub iga kaadriga 1°: iga kaader korrutab selle teljed sama maatriksiga, float32-s, ja iga korrutis ümardatakse. Pärast 360 kaadrit peaks see olema lähtekohas tagasi. Selle viga on 0.003 pikslit. Paanis **Pilt** on see joonistatud 20 000 korda suuremana, kahvatu õige pildi kõrvale.</translation>
    </message>
    <message>
        <source>Now the axes are made orthonormal every tenth frame, with a fast inverse square root that is off by up to 0.18 %. The numbers are still float32. How far off is the picture after one round?</source>
        <translation>Nüüd tehakse teljed iga kümnenda kaadriga ortonormeerituks kiire pöördruutjuurega, mille viga on kuni 0.18 %. Arvud on endiselt float32. Kui suur on pildi viga pärast üht ringi?</translation>
    </message>
    <message>
        <source>0.003 pixels, as before: float32 has 7 digits, so a round of 360 steps keeps 5</source>
        <translation>0.003 pikslit, nagu enne: float32-l on 7 numbrit, nii et 360 sammuga ring jätab alles 5</translation>
    </message>
    <message>
        <source>The format has its 7 digits, but each step uses a root that has 3. Look at the two letters: they are 6 pixels apart.</source>
        <translation>Vormingul on oma 7 numbrit, aga iga samm kasutab juurt, millel on neid 3. Vaadake kaht tähte: nende vahe on 6 pikslit.</translation>
    </message>
    <message>
        <source>Less than before: renormalising puts the axes right</source>
        <translation>Väiksem kui enne: uuesti normeerimine seab teljed õigeks</translation>
    </message>
    <message>
        <source>It puts their lengths right, not where they point to. Look at the two letters: they are farther apart than without it.</source>
        <translation>See seab õigeks nende pikkused, mitte selle, kuhu need näitavad. Vaadake kaht tähte: nende vahe on suurem kui ilma selleta.</translation>
    </message>
    <message>
        <source>About 6 pixels</source>
        <translation>Umbes 6 pikslit</translation>
    </message>
    <message>
        <source>One axis comes out shorter than the others by 0.17 %. Each turn mixes the three, so each turn is a little too large or too small, always in the same direction.</source>
        <translation>Üks telg tuleb teistest 0.17 % lühem. Iga pööre segab kõiki kolme, nii et iga pööre on natuke liiga suur või liiga väike, alati samas suunas.</translation>
    </message>
    <message>
        <source>The same error again and again</source>
        <translation>Sama viga ikka ja jälle</translation>
    </message>
    <message>
        <source>Such an error is no chance. Each round adds about as much as the one before, and the errors of {0} rounds are {1} times as large. After one round the dock says that an axis leans by {2}.</source>
        <translation>Selline viga ei ole juhus. Iga ring lisab umbes sama palju kui eelmine ja pärast {0} ringi on viga {1} korda suurem. Pärast üht ringi ütleb külgriba, et telg on {2} viltu.</translation>
    </message>
    <message>
        <source>Turn the camera until the picture is off by more than 50 pixels, with nothing else changed.</source>
        <translation>Pöörake kaamerat, kuni pildi viga on rohkem kui 50 pikslit, midagi muud muutmata.</translation>
    </message>
    <message>
        <source>How many rounds is that, at 6 pixels a round?</source>
        <translation>Mitu ringi see on, kui ring lisab 6 pikslit?</translation>
    </message>
    <message>
        <source>Move Rounds to the right.</source>
        <translation>Nihutage Ringe paremale.</translation>
    </message>
    <message>
        <source>9 or 10 rounds are enough: a minute at 60 frames a second.</source>
        <translation>9 või 10 ringist piisab: minut, kui sekundis on 60 kaadrit.</translation>
    </message>
    <message>
        <source>An axis leans by 0.5° and the field of view is 40° in a picture of 720 lines. By how many pixels does that move what is in the middle of the picture, at most?</source>
        <translation>Telg on 0.5° viltu ja frustumi nurk on 40° pildil, millel on 720 rida. Mitu pikslit nihutab see kõige rohkem seda, mis on pildi keskel?</translation>
    </message>
    <message>
        <source>This gives every degree as many pixels. In the middle a degree has fewer of them than at the border. Look at the picture at 140°: there the difference is large.</source>
        <translation>Nii antakse igale kraadile sama palju piksleid. Keskel on kraadis neid vähem kui servas. Vaadake pilti 140° juures: seal on vahe suur.</translation>
    </message>
    <message>
        <source>The middle is at the distance 1 on a plane that is {0} high and has 720 pixels, and it moves by {1}.</source>
        <translation>Keskkoht on kaugusel 1 tasandil, mille kõrgus on {0} ja millel on 720 pikslit, ning see nihkub {1} võrra.</translation>
    </message>
    <message>
        <source>How high is a plane at the distance 1, and by how much does the middle move on it?</source>
        <translation>Kui kõrge on tasand kaugusel 1 ja kui palju keskkoht sellel nihkub?</translation>
    </message>
    <message>
        <source>Lengths come back, directions do not</source>
        <translation>Pikkused tulevad tagasi, suunad mitte</translation>
    </message>
    <message>
        <source>With exact roots, renormalising is worth something: it keeps the lengths to all digits. But nobody remembers where the axes should point to.</source>
        <translation>Täpsete juurtega on uuesti normeerimisest kasu: see hoiab pikkused kõigi numbrikohtadeni õiged. Aga kuhu teljed näitama peaksid, ei mäleta keegi.</translation>
    </message>
    <message>
        <source>100 rounds of products alone make an axis too long or too short by 0.043 %. Make that less than 0.000001 %, and leave the rounds and the format as they are.</source>
        <translation>100 ringi ainult korrutistega teevad telje 0.043 % liiga pikaks või liiga lühikeseks. Tehke see väiksemaks kui 0.000001 % ning jätke ringid ja vorming nii, nagu need on.</translation>
    </message>
    <message>
        <source>That is another way: it makes the axes afresh from the angle of each frame, and multiplies nothing. Look at *Turned by*: one of the others keeps the products and mends the lengths.</source>
        <translation>See on teistsugune viis: see teeb teljed iga kaadri nurgast uuesti ega korruta midagi. Vaadake sätet *Pööramine*: üks teistest jätab korrutised alles ja parandab pikkused.</translation>
    </message>
    <message>
        <source>Which way divides each axis by its length, and exactly?</source>
        <translation>Milline viis jagab iga telje tema pikkusega, ja täpselt?</translation>
    </message>
    <message>
        <source>The lengths are right to ten digits. But an axis still leans by 0.0008°: less than before, and not nothing.</source>
        <translation>Pikkused on kümne numbrini õiged. Aga telg on endiselt 0.0008° viltu: vähem kui enne, kuid mitte null.</translation>
    </message>
    <message>
        <source>A step that is too small</source>
        <translation>Liiga väike samm</translation>
    </message>
    <message>
        <source>The eye moves to the right, by 1 mm a frame. A unit is 1 m, and the origin of the coordinates is 50 km away: the eye&apos;s x is 30 000. In **Image** each frame has its own line, from top to bottom: how far P has moved across, beside the smooth path.</source>
        <translation>Silm liigub paremale, iga kaadriga 1 mm. Ühik on 1 m ja koordinaatide alguspunkt on 50 km kaugusel: silma x on 30 000. Paanis **Pilt** on igal kaadril ülalt alla oma joon: kui palju on P kõrvale liikunud, sujuva tee kõrval.</translation>
    </message>
    <message>
        <source>x lies between {0} and {1}. How many millimetres are two neighbouring float32 apart there?</source>
        <translation>x on {0} ja {1} vahel. Mitu millimeetrit on seal kahe naabruses oleva float32 vahe?</translation>
    </message>
    <message>
        <source>A float32 has 24 bits, and its numbers lie as far apart as the last of them counts: a power of 2. Look at the frames: P stands still in half of them, not in two of three.</source>
        <translation>float32-l on 24 bitti ja selle arvude vahe on nii suur, kui on väärt viimane neist: see on 2 aste. Vaadake kaadreid: P seisab paigal pooltes neist, mitte kahes kolmest.</translation>
    </message>
    <message>
        <source>The first of 24 bits counts {0} m, the last one {1} m: 1.95 mm. The eye moves by 1 mm, so it stands still in about every second frame.</source>
        <translation>Esimene bitt 24-st on väärt {0} m, viimane {1} m: 1.95 mm. Silm liigub 1 mm, nii et see seisab paigal umbes igas teises kaadris.</translation>
    </message>
    <message>
        <source>The first bit counts {0}. What does bit 24 count?</source>
        <translation>Esimene bitt on väärt {0}. Kui palju on väärt bitt 24?</translation>
    </message>
    <message>
        <source>From the middle of the Earth</source>
        <translation>Maakera keskpunktist</translation>
    </message>
    <message>
        <source>Maps of the whole Earth measure from its middle, 6 371 km away.</source>
        <translation>Kogu Maa kaardid mõõdavad selle keskpunktist, mis on 6 371 km kaugusel.</translation>
    </message>
    <message>
        <source>The origin moves there. How far does P jump from one frame to the next, at most?</source>
        <translation>Alguspunkt viiakse sinna. Kui kaugele hüppab P ühest kaadrist teise kõige rohkem?</translation>
    </message>
    <message>
        <source>0.4 pixels, as from 50 km: the eye moves by a millimetre, and both numbers keep 7 digits</source>
        <translation>0.4 pikslit, nagu 50 km kauguselt: silm liigub millimeetri ja mõlemad arvud hoiavad 7 numbrit</translation>
    </message>
    <message>
        <source>The seven digits of 3 822 600 are all before the point. Look at the path: it stands still, and then jumps once.</source>
        <translation>Arvu 3 822 600 kõik seitse numbrit on enne koma. Vaadake teed: see seisab paigal ja hüppab siis ühe korra.</translation>
    </message>
    <message>
        <source>40 pixels</source>
        <translation>40 pikslit</translation>
    </message>
    <message>
        <source>Not at all: the eye moves by less than the numbers can say</source>
        <translation>Üldse mitte: silm liigub vähem, kui arvud suudavad öelda</translation>
    </message>
    <message>
        <source>Too small a step never counts</source>
        <translation>Liiga väike samm ei loe kunagi</translation>
    </message>
    <message>
        <source>The eye is not where it was stored: it goes on, and at some frame another float32 is nearer. Look at the path: there it jumps by all that was missed.</source>
        <translation>Silm ei ole seal, kuhu see salvestati: see läheb edasi ja mõnes kaadris on teine float32 lähemal. Vaadake teed: seal hüppab see kõige vahele jäänu võrra.</translation>
    </message>
    <message>
        <source>Neighbouring float32 are 0.25 m apart there, and 0.25 m at P fill 40 pixels.</source>
        <translation>Naabruses olevate float32 vahe on seal 0.25 m ja 0.25 m punkti P juures täidab 40 pikslit.</translation>
    </message>
    <message>
        <source>Subtract first</source>
        <translation>Enne lahutage</translation>
    </message>
    <message>
        <source>What is large is not needed: only the difference of vertex and eye is drawn. If both are measured from the object, or in two floats each, small differences stay small.</source>
        <translation>Seda, mis on suur, ei ole vaja: joonistatakse ainult tipu ja silma vahe. Kui mõlemat mõõta objektist või kumbagi kahe ujukomaarvuga, jäävad väikesed vahed väikeseks.</translation>
    </message>
    <message>
        <source>Make P move smoothly, by less than 0.2 pixels in every frame, with the origin still in the middle of the Earth.</source>
        <translation>Tehke nii, et P liigub sujuvalt, igas kaadris vähem kui 0.2 pikslit, alguspunkt ikka Maa keskpunktis.</translation>
    </message>
    <message>
        <source>Which coordinates are large without need?</source>
        <translation>Millised koordinaadid on asjata suured?</translation>
    </message>
    <message>
        <source>From the object it costs nothing: the same 12 bytes a vertex, and the same one subtraction. Two floats cost twice the bytes and three times the work, and need no object.</source>
        <translation>Objektist mõõtmine ei maksa midagi: samad 12 baiti tipu kohta ja sama üks lahutamine. Kaks ujukomaarvu maksavad kaks korda rohkem baite ja kolm korda rohkem tööd ning ei vaja objekti.</translation>
    </message>
    <message>
        <source>Practise: from a lean to pixels</source>
        <translation>Harjutus: kaldest piksliteni</translation>
    </message>
    <message>
        <source>A camera that leans by {0} moves the middle of a picture of {1} pixels by {2} at most.</source>
        <translation>Kaamera, mis on {0} viltu, nihutab {1} piksli kõrguse pildi keskkohta ülimalt {2}.</translation>
    </message>
    <message>
        <source>Each round adds {0}° to the lean, and the camera goes {1} rounds. The field of view is {2}°, and the picture is 720 pixels high. By how many pixels has its middle moved at most?</source>
        <translation>Iga ring lisab kaldele {0}° ja kaamera teeb {1} ringi. Frustumi nurk on {2}° ja pildi kõrgus 720 pikslit. Mitu pikslit on selle keskkoht kõige rohkem nihkunud?</translation>
    </message>
    <message>
        <source>A round is a round</source>
        <translation>Ring on ring</translation>
    </message>
    <message>
        <source>This is the drift of one round. The next round begins where this one ended, and adds its own. Look at the picture after {0} rounds: the letters are farther apart.</source>
        <translation>See on ühe ringi triiv. Järgmine ring algab seal, kus see lõppes, ja lisab oma. Vaadake pilti pärast {0} ringi: tähtede vahe on suurem.</translation>
    </message>
    <message>
        <source>This takes the tangent of the whole field of view. Half the picture belongs to half of the angle. Look at the picture at 90°: it is {0} high at the distance 1; {1} would be infinite.</source>
        <translation>Nii võetakse kogu frustumi nurga tangens. Pool pilti kuulub poole nurga juurde. Vaadake pilti 90° juures: kaugusel 1 on selle kõrgus {0}; {1} oleks lõpmatu.</translation>
    </message>
    <message>
        <source>By how many degrees does it lean after {0} rounds?</source>
        <translation>Mitu kraadi on see pärast {0} ringi viltu?</translation>
    </message>
    <message>
        <source>At the distance 1 the picture is {0} high, and the middle moves by {1}.</source>
        <translation>Kaugusel 1 on pildi kõrgus {0} ja keskkoht nihkub {1} võrra.</translation>
    </message>
    <message>
        <source>It leans by {0}°, and {1} pixels lie between.</source>
        <translation>See on {0}° viltu ja vahele jääb {1} pikslit.</translation>
    </message>
    <message>
        <source>Practise: from a gap to pixels</source>
        <translation>Harjutus: vahest piksliteni</translation>
    </message>
    <message>
        <source>A float32 has 24 bits. Between {0} and {1} its numbers are {2} apart, and an eye that creeps along jumps by that much at a time.</source>
        <translation>float32-l on 24 bitti. {0} ja {1} vahel on selle arvude vahe {2} ja vaikselt edasi nihkuv silm hüppab nii palju korraga.</translation>
    </message>
    <message>
        <source>The eye&apos;s x lies between {0} m and {1} m, which are powers of 2, and it moves along x. By how many pixels does a vertex jump at a time, at the depth {2} m? The picture is 1080 pixels high, with a field of view of 40°.</source>
        <translation>Silma x on {0} m ja {1} m vahel, mis on 2 astmed, ja silm liigub piki x-telge. Mitu pikslit hüppab tipp sügavusel {2} m korraga? Pildi kõrgus on 1080 pikslit ja frustumi nurk 40°.</translation>
    </message>
    <message>
        <source>An eye is off by half a gap</source>
        <translation>Silma viga on pool vahet</translation>
    </message>
    <message>
        <source>Half a gap is how far off the eye is at most, before and after. It goes from one float32 to the next one, by a whole gap. Look at the path: each jump goes from one side of the smooth path to the other.</source>
        <translation>Pool vahet on silma viga kõige rohkem, enne ja pärast. See läheb ühest float32-st järgmisse, terve vahe võrra. Vaadake teed: iga hüpe läheb sujuva tee ühelt poolt teisele.</translation>
    </message>
    <message>
        <source>24 bits are 23 halvings</source>
        <translation>24 bitti on 23 poolitamist</translation>
    </message>
    <message>
        <source>This counts 23 bits. The first bit counts {0}, and from the first to the last it is halved 23 times. Look at the path: its jumps are half as wide.</source>
        <translation>Nii loetakse 23 bitti. Esimene bitt on väärt {0} ja esimesest viimaseni poolitatakse seda 23 korda. Vaadake teed: selle hüpped on poole väiksemad.</translation>
    </message>
    <message>
        <source>What does the last of 24 bits count, if the first one counts {0}?</source>
        <translation>Kui palju on väärt viimane bitt 24-st, kui esimene on väärt {0}?</translation>
    </message>
    <message>
        <source>At the depth {0} a metre has {1} pixels.</source>
        <translation>Sügavusel {0} on meetris {1} pikslit.</translation>
    </message>
    <message>
        <source>The gap is {0}{1} m, and a metre has {2} pixels.</source>
        <translation>Vahe on {0}{1} m ja meetris on {2} pikslit.</translation>
    </message>
</context>
<context>
    <name>l27-where-precision-goes</name>
    <message>
        <source>Where does precision go?</source>
        <translation>Kuhu kaob täpsus?</translation>
    </message>
    <message>
        <source>The floor behind the wall</source>
        <translation>Põrand seina taga</translation>
    </message>
    <message>
        <source>A logarithmic depth has digits for every distance. Here it is computed at each vertex, as it is cheap there, and the floor from near to far is one piece. In **Image** you see the wall&apos;s foundation, which is below the floor: the floor is drawn behind it. The dock says how far off it is: up to 3.53 times too far.</source>
        <translation>Logaritmilisel sügavusel jätkub numbrikohti igale kaugusele. Siin arvutatakse see igas tipus, sest seal on see odav, ja põrand on lähedalt kaugele ühes tükis. Paanis **Pilt** näete seina alusmüüri, mis on põrandast allpool: põrand joonistatakse selle taha. Külgriba ütleb, kui suur on viga: kuni 3.53 korda liiga kaugele.</translation>
    </message>
    <message>
        <source>Far moves from 30 to 1000, and the floor with it, still one piece. Up to how many times too far is it drawn?</source>
        <translation>Kaugtasand viiakse 30-st 1000-ni ja põrand koos sellega, endiselt ühes tükis. Mitu korda liiga kaugele see kõige rohkem joonistatakse?</translation>
    </message>
    <message>
        <source>Still 3.5 times: that is what a logarithm is for</source>
        <translation>Endiselt 3.5 korda: selleks logaritm ongi</translation>
    </message>
    <message>
        <source>A logarithm would be right at each pixel, whatever far is. Between two vertices it is interpolated, and the error grows with the ratio of their distances. Look at the diagram: the curve stands far above the line in between.</source>
        <translation>Igas pikslis oleks logaritm õige, olgu kaugtasand milline tahes. Kahe tipu vahel see interpoleeritakse ja viga kasvab koos nende kauguste suhtega. Vaadake diagrammi: vahepeal on kõver joonest palju kõrgemal.</translation>
    </message>
    <message>
        <source>53.6 times</source>
        <translation>53.6 korda</translation>
    </message>
    <message>
        <source>1.15 times: the digits are spread over a longer range, as evenly as before</source>
        <translation>1.15 korda: numbrikohad on jaotatud pikemale vahemikule, sama ühtlaselt kui enne</translation>
    </message>
    <message>
        <source>The digits are not the trouble. Between its two ends the floor gets the depth that a straight line has, and the logarithm bends away from it. Look at the diagram: the curve stands far above the line in between.</source>
        <translation>Häda ei ole numbrikohtades. Kahe otsa vahel saab põrand sügavuse, mis on sirgel, ja logaritm kõverdub sellest eemale. Vaadake diagrammi: vahepeal on kõver joonest palju kõrgemal.</translation>
    </message>
    <message>
        <source>Only the two ends of the floor have the right depth. The nearest and the farthest vertex are now 1000 times as far apart as near is from the eye.</source>
        <translation>Õige sügavus on ainult põranda kahel otsal. Lähim ja kaugeim tipp on nüüd teineteisest 1000 korda nii kaugel, kui on lähitasand silmast.</translation>
    </message>
    <message>
        <source>One over w, and log w</source>
        <translation>Pöördarv w-st ja log w</translation>
    </message>
    <message>
        <source>On the screen {0} is linear along a face. A piece runs from the distance {1} to {2}. At the share {3} of it on the screen,</source>
        <translation>Ekraanil on {0} piki tahku lineaarne. Tükk ulatub kauguselt {1} kauguseni {2}. Kui sellest on ekraanil läbitud osa {3}, siis</translation>
    </message>
    <message>
        <source>Interpolated linearly, the logarithms of {0} and {1} give {2} instead. That is too far by the factor</source>
        <translation>Lineaarselt interpoleerides annavad suuruste {0} ja {1} logaritmid hoopis {2}. See on liiga kaugel, kordajaga</translation>
    </message>
    <message>
        <source>Half-way, that is {0}: with {1}, 2.83.</source>
        <translation>Poolel teel on see {0}: kui {1}, siis 2.83.</translation>
    </message>
    <message>
        <source>Near is 1 and far is 100. How many times too far is the floor drawn, half-way along it on the screen?</source>
        <translation>Lähitasand on 1 ja kaugtasand 100. Mitu korda liiga kaugele joonistatakse põrand, kui ekraanil on sellest läbitud pool?</translation>
    </message>
    <message>
        <source>Half-way is half the distance</source>
        <translation>Poolel teel on pool kaugust</translation>
    </message>
    <message>
        <source>This takes half the distance, 50.5, for the true place. Half-way on the screen is much nearer: there {0} is half-way, and {1}. Look at the diagram: drawn is never nearer than true.</source>
        <translation>Nii võetakse õigeks kohaks pool kaugust, 50.5. Ekraanil poolel teel on palju lähemal: seal on poolel teel {0}, ja {1}. Vaadake diagrammi: joonistatu ei ole kunagi õigest lähemal.</translation>
    </message>
    <message>
        <source>This would be right if {0} were linear on the screen. Only {1} is. Look at the foundation: the floor is drawn behind it.</source>
        <translation>See oleks õige, kui ekraanil oleks lineaarne {0}. Lineaarne on ainult {1}. Vaadake alusmüüri: põrand joonistatakse selle taha.</translation>
    </message>
    <message>
        <source>It is drawn at {0}, and lies at {1}.</source>
        <translation>See joonistatakse kohale {0}, aga asub kohal {1}.</translation>
    </message>
    <message>
        <source>Where is it drawn, and where does it lie?</source>
        <translation>Kuhu see joonistatakse ja kus see asub?</translation>
    </message>
    <message>
        <source>Shorter pieces</source>
        <translation>Lühemad tükid</translation>
    </message>
    <message>
        <source>The factor depends on the ratio {0} of a piece alone. In {1} pieces of equal length from 1 to 30 the nearest one has {2}, and it is the worst.</source>
        <translation>Kordaja sõltub ainult tüki suhtest {0}. Kui võrdse pikkusega tükke on 1-st 30-ni {1}, on lähimal {2}, ja see on kõige halvem.</translation>
    </message>
    <message>
        <source>Draw the floor nowhere more than 1.2 times too far, and still compute the logarithm at the vertices only.</source>
        <translation>Joonistage põrand nii, et see ei ole kusagil rohkem kui 1.2 korda liiga kaugel, ja arvutage logaritm endiselt ainult tippudes.</translation>
    </message>
    <message>
        <source>What makes the ratio of the nearest piece small?</source>
        <translation>Mis teeb lähima tüki suhte väikeseks?</translation>
    </message>
    <message>
        <source>Move Pieces of the floor to the right.</source>
        <translation>Nihutage liugurit Põranda tükid paremale.</translation>
    </message>
    <message>
        <source>13 pieces are enough here. From 1 to 1000 it takes 419: the near pieces need to be short, and the far ones are shorter than they have to be.</source>
        <translation>Siin piisab 13 tükist. 1-st 1000-ni läheb neid vaja 419: lähedased tükid peavad olema lühikesed ja kauged on lühemad, kui vaja.</translation>
    </message>
    <message>
        <source>Light through the seam</source>
        <translation>Valgus läbi õmbluse</translation>
    </message>
    <message>
        <source>Two meshes share a seam, vertex by vertex. Each stores its coordinates in 8 bits over its own box: the left one is 10 units wide, the right one 3. A vertex of the seam is rounded twice, to two places, and the light behind comes through.</source>
        <translation>Kahel võrgul on ühine õmblus, tipp tipu kaupa. Kumbki salvestab oma koordinaadid 8 bitiga üle omaenda risttahuka: vasaku laius on 10 ühikut, parema 3. Õmbluse tipp ümardatakse kaks korda, kahte kohta, ja tagant paistab valgus läbi.</translation>
    </message>
    <message>
        <source>Now 12 bits instead of 8. To how much of it does the largest possible gap shrink?</source>
        <translation>Nüüd 12 bitti 8 asemel. Kui suureks osaks kahaneb suurim võimalik pilu?</translation>
    </message>
    <message>
        <source>To 66.7 %</source>
        <translation>66.7 %-ni</translation>
    </message>
    <message>
        <source>This counts the bits. Each of them halves both steps, so 4 bits make the gap {0} times as narrow. Look at the seam with 12 bits: it is closed for your eye.</source>
        <translation>Nii loetakse bitte. Igaüks neist poolitab mõlemad astmed, nii et 4 bitti teevad pilu {0} korda kitsamaks. Vaadake õmblust 12 bitiga: teie silma jaoks on see suletud.</translation>
    </message>
    <message>
        <source>To 6.23 %</source>
        <translation>6.23 %-ni</translation>
    </message>
    <message>
        <source>To nothing: with 12 bits no error can be seen, so the seam is closed</source>
        <translation>Olematuks: 12 bitiga ei ole ühtki viga näha, seega on õmblus suletud</translation>
    </message>
    <message>
        <source>It is hardly seen from here, but it is there: 1.3 px at most. From ten times as near it would be 13 px. Look at the seam from nearer by.</source>
        <translation>Siit seda peaaegu ei näe, aga see on olemas: ülimalt 1.3 px. Kümme korda lähemalt oleks see 13 px. Vaadake õmblust lähemalt.</translation>
    </message>
    <message>
        <source>A step is the box over {0}: with 4 bits more it is 16 times as short.</source>
        <translation>Aste on risttahukas jagatud arvuga {0}: 4 bitiga rohkem on see 16 korda lühem.</translation>
    </message>
    <message>
        <source>Half a step, and half a step</source>
        <translation>Pool astet ja veel pool astet</translation>
    </message>
    <message>
        <source>On a grid of step {0} a coordinate moves by at most {1}, on another of step {2} by {3}. If they move apart, the copies of the vertex are {4} apart along an axis, and {5} across both. With 8 bits {6} and {7}.</source>
        <translation>Ruudustikul, mille aste on {0}, nihkub koordinaat ülimalt {1}, teisel, mille aste on {2}, ülimalt {3}. Kui need nihkuvad lahku, on tipu koopiate vahe piki üht telge {4} ja mõlema telje peale kokku {5}. 8 bitiga on {6} ja {7}.</translation>
    </message>
    <message>
        <source>By how many units are the two copies of a vertex apart at most, along one axis, with 8 bits?</source>
        <translation>Mitu ühikut on 8 bitiga tipu kahe koopia vahe piki üht telge kõige rohkem?</translation>
    </message>
    <message>
        <source>Only the coarse one errs</source>
        <translation>Eksib ainult jämedam</translation>
    </message>
    <message>
        <source>This lets only the larger mesh round. The smaller one rounds, too, and may go the other way. Look at the diagram: some gaps are wider than yours.</source>
        <translation>Nii ümardab ainult suurem võrk. Väiksem ümardab ka ja võib minna teisele poole. Vaadake diagrammi: mõned pilud on teie omast laiemad.</translation>
    </message>
    <message>
        <source>The gap is the error</source>
        <translation>Vahe on viga</translation>
    </message>
    <message>
        <source>A coordinate goes to the nearer place, so each mesh is off by half a step at most. Look at the diagram: no gap reaches the line.</source>
        <translation>Koordinaat läheb lähemasse kohta, nii et kummagi võrgu viga on ülimalt pool astet. Vaadake diagrammi: ükski pilu ei ulatu jooneni.</translation>
    </message>
    <message>
        <source>{0}. From 1.6 units away, a picture of 1080 lines has 585 px a unit: 14.9 px along an axis, and 21.1 px across both.</source>
        <translation>{0}. 1.6 ühiku kauguselt on 1080-realisel pildil 585 px ühiku kohta: piki telge 14.9 px ja mõlema telje peale 21.1 px.</translation>
    </message>
    <message>
        <source>Each copy is off by half of its own step.</source>
        <translation>Kummagi koopia viga on pool tema enda astmest.</translation>
    </message>
    <message>
        <source>More bits make the gap narrower and never close it. What would?</source>
        <translation>Rohkem bitte teeb pilu kitsamaks, aga ei sulge seda kunagi. Mis sulgeks?</translation>
    </message>
    <message>
        <source>Close the seam, and keep the 3 bytes a vertex.</source>
        <translation>Sulgege õmblus ja jätke tipu kohta 3 baiti.</translation>
    </message>
    <message>
        <source>Why does the same vertex come to lie at two places?</source>
        <translation>Miks satub sama tipp kahte kohta?</translation>
    </message>
    <message>
        <source>Let both meshes round to the same places.</source>
        <translation>Laske mõlemal võrgul ümardada samadesse kohtadesse.</translation>
    </message>
    <message>
        <source>A common grid: the same vertex, the same grid, the same place. The smaller mesh pays: the vertices of its seam move more than four times as far as on a grid of its own.</source>
        <translation>Ühine ruudustik: sama tipp, sama ruudustik, sama koht. Maksab väiksem võrk: selle õmbluse tipud nihkuvad rohkem kui neli korda nii kaugele kui omaenda ruudustikul.</translation>
    </message>
    <message>
        <source>Back from the picture</source>
        <translation>Pildilt tagasi</translation>
    </message>
    <message>
        <source>A pixel and its depth lead back to the point P: multiply with the inverse of {0}. Everything is float32, and the world&apos;s origin is 1 unit from the eye.</source>
        <translation>Piksel ja selle sügavus viivad tagasi punktini P: korrutage {0} pöördmaatriksiga. Kõik on float32 ja maailma alguspunkt on silmast 1 ühiku kaugusel.</translation>
    </message>
    <message>
        <source>The origin moves to 100 000 units from the eye. How far from P is the point that the inverse leads back to?</source>
        <translation>Alguspunkt viiakse silmast 100 000 ühiku kaugusele. Kui kaugel on punktist P see punkt, milleni pöördmaatriks tagasi viib?</translation>
    </message>
    <message>
        <source>Nowhere: an inverse undoes what the matrix did</source>
        <translation>Samas kohas: pöördmaatriks võtab tagasi, mida maatriks tegi</translation>
    </message>
    <message>
        <source>On paper it does. Here each product is rounded, and the eye&apos;s coordinates are 100 000: they hide the few units that you are after. Look at P and at the point that came back.</source>
        <translation>Paberil võtab. Siin ümardatakse iga korrutis ja silma koordinaadid on 100 000: need peidavad need paar ühikut, mida te otsite. Vaadake punkti P ja tagasi tulnud punkti.</translation>
    </message>
    <message>
        <source>By a ten-millionth of its distance: a float32 keeps seven digits</source>
        <translation>Kümnemiljondiku võrra oma kaugusest: float32 hoiab seitset numbrit</translation>
    </message>
    <message>
        <source>The seven digits belong to the coordinates, near 100 000. What is left of P&apos;s distance, 8.3 units, has two. Look at P and at the point that came back.</source>
        <translation>Seitse numbrit kuuluvad koordinaatidele, mis on 100 000 lähedal. P kaugusele, 8.3 ühikut, jääb neid kaks. Vaadake punkti P ja tagasi tulnud punkti.</translation>
    </message>
    <message>
        <source>By several per cent of its distance</source>
        <translation>Mitme protsendi võrra oma kaugusest</translation>
    </message>
    <message>
        <source>The inverse multiplies the eye&apos;s coordinates with {0}, a small difference of rounded numbers.</source>
        <translation>Pöördmaatriks korrutab silma koordinaate suurusega {0}, mis on ümardatud arvude väike vahe.</translation>
    </message>
    <message>
        <source>Bring the point to within 1 % of its distance, in float32 and with the origin where it is.</source>
        <translation>Tehke nii, et punkt tuleb tagasi veaga alla 1 % oma kaugusest, float32-s ja alguspunkt seal, kus see on.</translation>
    </message>
    <message>
        <source>Which way back does not multiply the eye with anything?</source>
        <translation>Milline tagasitee ei korruta silma millegagi?</translation>
    </message>
    <message>
        <source>Choose *Ray times depth*.</source>
        <translation>Valige *Kiir korda sügavus*.</translation>
    </message>
    <message>
        <source>The ray is multiplied with the depth, and the eye is added at the end: it is rounded once.</source>
        <translation>Kiir korrutatakse sügavusega ja silm liidetakse lõpus: see ümardatakse üks kord.</translation>
    </message>
    <message>
        <source>Back to the floor</source>
        <translation>Tagasi põranda juurde</translation>
    </message>
    <message>
        <source>“Logarithmic depth is always better” is tempting: its digits are spread as distances need them. But digits are half of the story. A number is stored at some places, and used at others: depths between the vertices, positions in the grid of another mesh. Precision goes where two ways of rounding meet. Choose *each pixel* and watch the foundation disappear.</source>
        <translation>„Logaritmiline sügavus on alati parem“ on ahvatlev: selle numbrikohad on jaotatud nii, nagu kaugused neid vajavad. Aga numbrikohad on pool lugu. Arv salvestatakse ühtedes kohtades ja seda kasutatakse teistes: sügavused tippude vahel, asukohad teise võrgu ruudustikul. Täpsus kaob seal, kus kohtuvad kaks ümardamise viisi. Valige *iga piksel* ja vaadake, kuidas alusmüür kaob.</translation>
    </message>
    <message>
        <source>Practise: half-way</source>
        <translation>Harjutus: poolel teel</translation>
    </message>
    <message>
        <source>A floor is one piece from near to far. Its logarithmic depth is computed at the vertices, and between them the rasteriser interpolates it linearly on the screen.</source>
        <translation>Põrand on lähedalt kaugele ühes tükis. Selle logaritmiline sügavus arvutatakse tippudes ja nende vahel interpoleerib rasterdaja seda ekraanil lineaarselt.</translation>
    </message>
    <message>
        <source>Near is {0}, far is {1}. Half-way along the floor on the screen: how many times too far is it drawn?</source>
        <translation>Lähitasand on {0}, kaugtasand {1}. Ekraanil on põrandast läbitud pool: mitu korda liiga kaugele see joonistatakse?</translation>
    </message>
    <message>
        <source>This takes half the distance for the true place. Half-way on the screen {0} is half-way, and {1} is much nearer. Look at the foundation: the floor is drawn behind it, not before it.</source>
        <translation>Nii võetakse õigeks kohaks pool kaugust. Ekraanil poolel teel on poolel teel {0}, ja {1} on palju lähemal. Vaadake alusmüüri: põrand joonistatakse selle taha, mitte ette.</translation>
    </message>
    <message>
        <source>It lies at near</source>
        <translation>See asub lähitasandil</translation>
    </message>
    <message>
        <source>This is where it is drawn, over near. But it lies farther away than near: {0} is half-way between {1} and {2}. Look at the diagram: half-way on the screen is a little to the right of near.</source>
        <translation>See on joonistatud koht jagatud lähitasandi kaugusega. Aga põrand asub lähitasandist kaugemal: {0} on poolel teel {1} ja {2} vahel. Vaadake diagrammi: ekraanil poolel teel on lähitasandist natuke paremal.</translation>
    </message>
    <message>
        <source>It is drawn at {0}, half-way between the logarithms.</source>
        <translation>See joonistatakse kohale {0}, logaritmide vahel poolele teele.</translation>
    </message>
    <message>
        <source>It lies at {0}.</source>
        <translation>See asub kohal {0}.</translation>
    </message>
    <message>
        <source>Drawn at {0}, it lies at {1}.</source>
        <translation>Joonistatud kohale {0}, asub see kohal {1}.</translation>
    </message>
    <message>
        <source>Practise: the widest gap</source>
        <translation>Harjutus: kõige laiem pilu</translation>
    </message>
    <message>
        <source>The field of view is 53.13°: at the distance {0} the picture is exactly {1} units high, so 1080 lines have {2} px a unit.</source>
        <translation>Frustumi nurk on 53.13°: kaugusel {0} on pildi kõrgus täpselt {1} ühikut, nii et 1080 reas on {2} px ühiku kohta.</translation>
    </message>
    <message>
        <source>Two meshes are {0} and {1} units wide and stored in 8 bits, each over its own box. You see the seam from {2} units away. By how many pixels are both copies of a vertex apart at most, across both axes?</source>
        <translation>Kahe võrgu laiused on {0} ja {1} ühikut ning need on salvestatud 8 bitiga, kumbki üle omaenda risttahuka. Näete õmblust {2} ühiku kauguselt. Mitu pikslit on tipu kahe koopia vahe mõlema telje peale kokku kõige rohkem?</translation>
    </message>
    <message>
        <source>This lets only the larger mesh round. The smaller one rounds, too, and may go the other way. Look at the seam: both edges are in steps.</source>
        <translation>Nii ümardab ainult suurem võrk. Väiksem ümardab ka ja võib minna teisele poole. Vaadake õmblust: mõlemad servad on astmelised.</translation>
    </message>
    <message>
        <source>A coordinate goes to the nearer place, so each mesh is off by half a step at most. Look at the seam: the gaps are narrower.</source>
        <translation>Koordinaat läheb lähemasse kohta, nii et kummagi võrgu viga on ülimalt pool astet. Vaadake õmblust: pilud on kitsamad.</translation>
    </message>
    <message>
        <source>One axis is all</source>
        <translation>Üks telg on kõik</translation>
    </message>
    <message>
        <source>This is the gap along one axis. The vertex is rounded along both, so the widest gap is the diagonal of a square. Look at the seam: copies lie apart across and along it.</source>
        <translation>See on pilu piki üht telge. Tipp ümardatakse piki mõlemat, nii et kõige laiem pilu on ruudu diagonaal. Vaadake õmblust: koopiad on lahus nii risti kui ka piki õmblust.</translation>
    </message>
    <message>
        <source>Half a step of each grid, together, along each axis.</source>
        <translation>Pool kummagi ruudustiku astmest, kokku, piki iga telge.</translation>
    </message>
    <message>
        <source>Two equal errors at right angles make {0} of one.</source>
        <translation>Kaks võrdset viga täisnurga all annavad {0} ühest.</translation>
    </message>
    <message>
        <source>{0} units with steps of a 255th, {1} of it across both axes, and {2} px a unit.</source>
        <translation>{0} ühikut, kui astmeid on 255, {1} sellest mõlema telje peale ja {2} px ühiku kohta.</translation>
    </message>
</context>
<context>
    <name>talk-000</name>
    <message>
        <source>Normalised coordinates and the perspective projection</source>
        <translation>Normaliseeritud koordinaadid ja perspektiivne projektsioon</translation>
    </message>
    <message>
        <source>From similar triangles</source>
        <translation>Sarnastest kolmnurkadest</translation>
    </message>
    <message>
        <source>A point {0} in front of the camera comes to the plane at the distance {1} from the eye:</source>
        <translation>Kaamera ees olev punkt {0} satub silmast kaugusel {1} olevale tasandile:</translation>
    </message>
    <message>
        <source>P is 5 deep. The plane moves from d = 1 to d = 2. How many times as high is P&apos; now?</source>
        <translation>P sügavus on 5. Tasand nihkub kohast d = 1 kohta d = 2. Mitu korda kõrgemal on nüüd P&apos;?</translation>
    </message>
    <message>
        <source>The area of the image grows 4 times. Height and width are proportional to d.</source>
        <translation>Kujutise pindala kasvab 4 korda. Kõrgus ja laius on võrdelised d-ga.</translation>
    </message>
    <message>
        <source>Both triangles have a corner at the eye, and P is 5 deep, measured from there.</source>
        <translation>Mõlemal kolmnurgal on nurk silma juures ja sealt mõõdetuna on P sügavus 5.</translation>
    </message>
    <message>
        <source>World from the side: name the two triangles first, eye to P and eye to P&apos;. Read -z = 5, y = 2 and {0} off the picture. Let the class vote, then let the model move. Afterwards drag Plane distance d down to below 0: the film of a camera obscura, and the image turns over. This was derived earlier in the course; do not stay.</source>
        <translation>Maailm küljelt: nimetage enne kaks kolmnurka, silmast P-ni ja silmast P&apos;-ni. Lugege pildilt -z = 5, y = 2 ja {0}. Laske klassil hääletada, siis laske mudelil liikuda. Pärast lohistage Tasandi kaugust d kuni alla 0: camera obscura film, ja pilt pöördub ümber. See tuletati kursusel juba varem; ärge siia pikemalt jääge.</translation>
    </message>
    <message>
        <source>The same as a matrix</source>
        <translation>Sama maatriksina</translation>
    </message>
    <message>
        <source>{0} goes to {1}, and divided by the last number to {2} (2):</source>
        <translation>{0} läheb punktiks {1} ja jagatuna viimase arvuga punktiks {2} (2):</translation>
    </message>
    <message>
        <source>The matrix is in the dock too, with numbers: -1/d = -0.5. Under it P = (2, 2, -5) becomes (2, 2, -5, 2.5). Divide aloud: 0.8, 0.8, -2. Stress that all projection is in the last row, and that -z/d is positive for what is in front. Drag d and watch the one cell that changes.</source>
        <translation>Maatriks on ka külgribal, arvudega: -1/d = -0.5. Sellega saab punktist P = (2, 2, -5) punkt (2, 2, -5, 2.5). Jagage kuuldavalt: 0.8, 0.8, -2. Rõhutage, et kogu projektsioon on viimases reas ja et -z/d on ees oleva jaoks positiivne. Lohistage d-d ja jälgige seda ühte lahtrit, mis muutub.</translation>
    </message>
    <message>
        <source>A and λA are one transformation</source>
        <translation>A ja λA on üks teisendus</translation>
    </message>
    <message>
        <source>Multiply every cell by {0}: the last number becomes {1}, and the quotients stay the same (3).</source>
        <translation>Korrutage iga lahter suurusega {0}: viimaseks arvuks saab {1} ja jagatised jäävad samaks (3).</translation>
    </message>
    <message>
        <source>last row</source>
        <translation>viimane rida</translation>
    </message>
    <message>
        <source>of P = (2, 2, −5)</source>
        <translation>punktist P = (2, 2, −5)</translation>
    </message>
    <message>
        <source>divided</source>
        <translation>jagatud</translation>
    </message>
    <message>
        <source>Ask what else can be multiplied: any λ but 0. So the last row may as well be 0 0 -1 0, whatever d is, and w&apos; = -z is the depth itself. In the window -z = 5 stands in the dock, and as a length below the picture. All later matrices of the lecture have this last row.</source>
        <translation>Küsige, millega veel võib korrutada: mis tahes λ-ga peale 0. Seega võib viimane rida sama hästi olla 0 0 -1 0, ükskõik mis d on, ja w&apos; = -z on sügavus ise. Aknas on -z = 5 külgribal ja pikkusena pildi all. Kõigil loengu hilisematel maatriksitel on see viimane rida.</translation>
    </message>
    <message>
        <source>WebGL: d is the distance to near</source>
        <translation>WebGL: d on kaugus lähitasandini</translation>
    </message>
    <message>
        <source>The scene is projected onto the near plane {0}, so {1} (4). **World** shows the picture on it.</source>
        <translation>Stseen projitseeritakse lähitasandile {0}, seega {1} (4). **Maailm** näitab sellel pilti.</translation>
    </message>
    <message>
        <source>Show the small F on the near plane in World: same projectors as before, and the plane is one of the walls of the frustum. Drag Near: the picture on the plane grows with it, and so does the plane; in Image nothing changes, until near cuts into the F. Near is a distance and positive; the plane is at {0}.</source>
        <translation>Näidake paanis Maailm väikest F-i lähitasandil: samad projektsioonikiired mis enne ja tasand on üks frustumi seintest. Lohistage lähitasandit: pilt sellel kasvab ja kasvab ka tasand; paanis Pilt ei muutu midagi, kuni lähitasand F-i lõikab. Lähitasand on kaugus ja positiivne; tasand on kohal {0}.</translation>
    </message>
    <message>
        <source>A segment to [-1, 1]</source>
        <translation>Lõik vahemikku [-1, 1]</translation>
    </message>
    <message>
        <source>The orthographic projection drops {0}; only {1} must become {2} (5). Here it is {3}:</source>
        <translation>Ortograafiline projektsioon jätab {0} ära; ainult vahemikust {1} peab saama {2} (5). Siin on see {3}:</translation>
    </message>
    <message>
        <source>Try three values on the board: x = -3 gives -1, x = 5 gives 1, x = 1, the middle, gives 0. Point to the denominators of the two fractions: they differ in sign. In NDC the box has become the cube; the F lies left of the middle, because the axis came to -0.25. Drag Left and Right.</source>
        <translation>Proovige tahvlil kolme väärtust: x = -3 annab -1, x = 5 annab 1, x = 1, keskkoht, annab 0. Näidake kahe murru nimetajaid: need erinevad märgi poolest. NDC-s on risttahukast saanud kuup; F on keskkohast vasakul, sest telg sattus kohale -0.25. Lohistage välju Vasak ja Parem.</translation>
    </message>
    <message>
        <source>The same for {0} and {1}</source>
        <translation>Sama suuruste {0} ja {1} jaoks</translation>
    </message>
    <message>
        <source>Put {0} into (5) and write everything over {1} (6); likewise for {2} (8):</source>
        <translation>Pange {0} valemisse (5) ja kirjutage kõik nimetajaga {1} (6); samamoodi {2} (8):</translation>
    </message>
    <message>
        <source>The window moves to [-1, 3]. Which {0} has probe 1, straight ahead?</source>
        <translation>Aken nihkub kohta [-1, 3]. Milline {0} on sondil 1, otse ees?</translation>
    </message>
    <message>
        <source>Only in a window that reaches equally far to both sides is the axis in the middle.</source>
        <translation>Ainult siis, kui aken ulatub mõlemale poole võrdselt kaugele, on telg keskel.</translation>
    </message>
    <message>
        <source>This moves the picture with its window. Look at the window that has moved to the left: only then is probe 1 at {0}.</source>
        <translation>Nii liigutatakse pilti koos selle aknaga. Vaadake akent, mis on liikunud vasakule: ainult siis on sond 1 kohal {0}.</translation>
    </message>
    <message>
        <source>{0}, and {1}.</source>
        <translation>{0} ja {1}.</translation>
    </message>
    <message>
        <source>Derive (6) line by line on the board. The trick is to multiply the second fraction by -z/-z, so that all has one denominator: it will be w&apos;. Its sign turns with it. Then the vote: many say +0.5, because the window goes to the right. After it, drag Left and Right and follow probe 1 in Image.</source>
        <translation>Tuletage (6) tahvlil rida-realt. Nipp on korrutada teine murd avaldisega -z/-z, nii et kõigel on üks nimetaja: sellest saab w&apos;. Selle märk pöördub kaasa. Siis hääletus: paljud ütlevad +0.5, sest aken läheb paremale. Pärast seda lohistage välju Vasak ja Parem ning jälgige paanis Pilt sondi 1.</translation>
    </message>
    <message>
        <source>An affine z bends lines</source>
        <translation>Afiinne z kõverdab sirgeid</translation>
    </message>
    <message>
        <source>With {0} the third homogeneous number would be {1} (9)-(11): no matrix.</source>
        <translation>Kui {0}, oleks kolmas homogeenne arv {1} (9)-(11): maatriksit ei ole.</translation>
    </message>
    <message>
        <source>P comes nearer, to a third of Q&apos;s depth. What does {0} make of PQ?</source>
        <translation>P tuleb lähemale, kolmandikule Q sügavusest. Mille teeb {0} lõigust PQ?</translation>
    </message>
    <message>
        <source>A straight segment</source>
        <translation>Sirge lõigu</translation>
    </message>
    <message>
        <source>x and y are divided by {0}, z&apos; is not. Look at the bow between P and Q: only {1} is straight.</source>
        <translation>x ja y jagatakse suurusega {0}, z&apos; mitte. Vaadake kaart P ja Q vahel: sirge on ainult {1}.</translation>
    </message>
    <message>
        <source>A bow</source>
        <translation>Kaare</translation>
    </message>
    <message>
        <source>{0} and {1} are divided by {2}, {3} is not.</source>
        <translation>{0} ja {1} jagatakse suurusega {2}, {3} mitte.</translation>
    </message>
    <message>
        <source>Go through (9), (10), (11): the same point three times, then all times -z. Nothing in the last line but -Az² - Bz is new. NDC shows both: A z + B is the bow, -A - B/z the straight line. After the vote drag P in World. Near and far change the bow too: try Near 0.3.</source>
        <translation>Käige läbi (9), (10), (11): sama punkt kolm korda, siis kõik korda -z. Viimases reas on uus ainult -Az² - Bz. NDC näitab mõlemat: A z + B on kaar, -A - B/z sirge. Pärast hääletust lohistage P-d paanis Maailm. Ka lähi- ja kaugtasand muudavad kaart: proovige lähitasandit 0.3.</translation>
    </message>
    <message>
        <source>What the depth buffer does with z</source>
        <translation>Mida sügavuspuhver z-iga teeb</translation>
    </message>
    <message>
        <source>Between a triangle&apos;s corners {0} is interpolated evenly over the pixels, and the smaller value wins. If lines are bent, or there are too few codes, the wrong surface is drawn.</source>
        <translation>Kolmnurga nurkade vahel interpoleeritakse {0} pikslite kaupa ühtlaselt ja väiksem väärtus võidab. Kui sirged on kõverad või koode on liiga vähe, joonistatakse vale pind.</translation>
    </message>
    <message>
        <source>Say what goes wrong with a bent line: the value interpolated at a pixel is not the depth of what is there. What is seen here is the other trouble: a buffer of 16 bits, near at 0.01, surface 2 is 0.25 behind surface 1, and 63 % of the pixels are wrong. Ask what helps. Far from 200 to 60: 63 %. Near from 0.01 to 0.1: none. Most values lie just behind near.</source>
        <translation>Öelge, mis läheb kõvera joonega valesti: pikslis interpoleeritud väärtus ei ole seal oleva sügavus. Siin on näha teist häda: 16-bitine puhver, lähitasand 0.01, pind 2 on pinnast 1 0.25 tagapool ja 63 % pikslitest on valed. Küsige, mis aitab. Kaugtasand 200-lt 60-le: 63 %. Lähitasand 0.01-lt 0.1-le: mitte ühtki. Enamik väärtusi on kohe lähitasandi taga.</translation>
    </message>
    <message>
        <source>Few bits for a vertex</source>
        <translation>Vähe bitte tipu jaoks</translation>
    </message>
    <message>
        <source>With {0} bits over a side {1} a coordinate is off by up to {2}: in pixels the more, the nearer.</source>
        <translation>Kui küljel {1} on {0} bitti, on koordinaadi viga kuni {2}: pikslites seda rohkem, mida lähemal.</translation>
    </message>
    <message>
        <source>Depths are not the only numbers with few bits. 8 bits a coordinate: 3 bytes a vertex, and up to 0.5 pixels off in a picture of 320 by 240. The arrows are 50 times as long as the errors. Choose 12 and 16 bits: each bit halves the error. Then halve the distance: each error is twice as long. How many bits are enough depends on where you stand; lesson &quot;How many bits does a picture need?&quot;.</source>
        <translation>Sügavused ei ole ainsad väheste bittidega arvud. 8 bitti koordinaadi kohta: 3 baiti tipu kohta ja viga kuni 0.5 pikslit pildil, mis on 320 korda 240. Nooled on vigadest 50 korda pikemad. Valige 12 ja 16 bitti: iga bitt teeb vea poole väiksemaks. Siis tooge kaugus pooleks: iga viga on kaks korda pikem. Mitmest bitist piisab, sõltub sellest, kus te seisate; õppetund „Mitu bitti pilt vajab?“.</translation>
    </message>
    <message>
        <source>{0} instead</source>
        <translation>Selle asemel {0}</translation>
    </message>
    <message>
        <source>Divided by {0} as well, {1} stays linear in homogeneous coordinates (12). Near must come to -1, far to 1:</source>
        <translation>Ka suurusega {0} jagatuna jääb {1} homogeensetes koordinaatides lineaarseks (12). Lähitasand peab sattuma kohale -1, kaugtasand kohale 1:</translation>
    </message>
    <message>
        <source>Solve the two equations on the board: {0} and {1}. Then NDC: the posts stand 6 apart in World, and crowd towards far in the cube. With near 9 and far 41 the middle of the cube, z&apos; = 0, is at a depth of only 14.8. Order is kept, and lines stay straight; that is all the depth buffer needs.</source>
        <translation>Lahendage tahvlil kaks võrrandit: {0} ja {1}. Siis NDC: postide vahe on paanis Maailm 6, aga kuubis tihenevad need kaugtasandi poole. Kui lähitasand on 9 ja kaugtasand 41, on kuubi keskkoht, z&apos; = 0, ainult sügavusel 14.8. Järjekord säilib ja sirged jäävad sirgeks; rohkemat sügavuspuhver ei vaja.</translation>
    </message>
    <message>
        <source>The whole matrix</source>
        <translation>Kogu maatriks</translation>
    </message>
    <message>
        <source>{0}, and the six numbers of the frustum (13):</source>
        <translation>{0} ja frustumi kuus arvu (13):</translation>
    </message>
    <message>
        <source>Rows 1 and 2 are (6) and (8), row 3 is (12), row 4 is the division. In World left and right are written at the near plane. Ask for the cells with x from -1 to 3, near 2, far 19: 1 and 0.5 in row 1, -21/17 and -76/17 in row 3. Matrices in the drawer has them, and lights up what a control changes.</source>
        <translation>Read 1 ja 2 on (6) ja (8), rida 3 on (12), rida 4 on jagamine. Paanis Maailm on vasak ja parem kirjutatud lähitasandi juurde. Küsige lahtreid, kui x on -1-st 3-ni, lähitasand 2, kaugtasand 19: reas 1 on 1 ja 0.5, reas 3 -21/17 ja -76/17. Sahtli paneelis Maatriksid on need olemas ja see, mida juhtelement muudab, süttib.</translation>
    </message>
    <message>
        <source>Stretched</source>
        <translation>Venitatud</translation>
    </message>
    <message>
        <source>The window is {0}, but the canvas {1} is square. (13) does not prevent this: the letter is twice as high as it should be.</source>
        <translation>Aken on {0}, aga lõuend {1} on ruudukujuline. (13) seda ei takista: täht on kaks korda kõrgem, kui see olema peaks.</translation>
    </message>
    <message>
        <source>NDC knows no proportions: the cube is the cube. The stretching happens where [-1, 1] becomes pixels, by different factors for x and y. For round circles the window must have the proportions of the canvas: {0}.</source>
        <translation>NDC proportsioone ei tunne: kuup on kuup. Venitatakse seal, kus vahemikust [-1, 1] saavad pikslid, x ja y jaoks eri kordajatega. Ümarate ringide jaoks peavad aknal olema lõuendi proportsioonid: {0}.</translation>
    </message>
    <message>
        <source>Variant X: y is adjusted</source>
        <translation>Variant X: kohandatakse y-it</translation>
    </message>
    <message>
        <source>Image changes, the fields stay: Top still says 1, and the program calls the projection with {0} and {1}. Ask why there is a 2 under the fraction: k is put on at both ends. X is what is kept; students often read it as what is changed.</source>
        <translation>Pilt muutub, väljad jäävad: Ülemine on endiselt 1, aga programm kutsub projektsiooni välja väärtustega {0} ja {1}. Küsige, miks on murru all 2: k liidetakse mõlemas otsas. X on see, mida säilitatakse; üliõpilased loevad seda sageli kui seda, mida muudetakse.</translation>
    </message>
    <message>
        <source>Variant Y: x is adjusted</source>
        <translation>Variant Y: kohandatakse x-i</translation>
    </message>
    <message>
        <source>Here k is negative: the window becomes narrower, x from -1 to 1, and the F is larger. The last line of the handout has {0} for {1}; it must be {2}. Ask which variant a program should take when a window is made narrower by hand: with X the scene keeps its width, with Y its height.</source>
        <translation>Siin on k negatiivne: aken läheb kitsamaks, x -1-st 1-ni, ja F on suurem. Jaotusmaterjali viimasel real on {0} suuruse {1} jaoks; peab olema {2}. Küsige, kumma variandi peaks programm võtma, kui akent käsitsi kitsamaks tehakse: X-iga säilitab stseen laiuse, Y-iga kõrguse.</translation>
    </message>
</context>
<context>
    <name>talk-001</name>
    <message>
        <source>The synthetic camera</source>
        <translation>Sünteetiline kaamera</translation>
    </message>
    <message>
        <source>Eye, monitor, phone</source>
        <translation>Silm, monitor, telefon</translation>
    </message>
    <message>
        <source>How much of the world is in a picture? The eye sees 120°, without the blurred rim. A monitor fills 25° to 30°, a phone 5°.</source>
        <translation>Kui suur osa maailmast on pildil? Silm näeb 120°, ilma häguse ääreta. Monitor täidab 25° kuni 30°, telefon 5°.</translation>
    </message>
    <message>
        <source>eye 120°</source>
        <translation>silm 120°</translation>
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
        <translation>Kaamera võtab 3-D stseeni ja paneb selle filmile või pikslitesse; sünteetiline kaamera jäljendab seda. Kõigil kolmel pildil on pea suurus sama: silm peab minema väga lähedale, telefon kaugele. Nurgad lugege jaotisest Veel arve. Küsige, milline pilt tundub loomulik ja kui kaugelt peaks seda seinal vaatama.</translation>
    </message>
    <message>
        <source>The view volume</source>
        <translation>Nähtav ruum</translation>
    </message>
    <message>
        <source>Only what lies in a volume is drawn: the eye&apos;s cone, the pyramid round it, or a box, the view from very far away.</source>
        <translation>Joonistatakse ainult see, mis on teatud ruumis: silma koonuses, selle ümber olevas püramiidis või risttahukas, mis on vaade väga kaugelt.</translation>
    </message>
    <message>
        <source>Begin with the cone: what an eye sees. Then choose Pyramid under View volume: pictures are rectangles, so the cone is cut off by four planes. Then Box. The letters are test points; grey ones lie outside. Ask before each change which come in and which go. The volume is given by its shape and its place.</source>
        <translation>Alustage koonusest: mida silm näeb. Siis valige sättes Nähtav ruum Püramiid: pildid on ristkülikud, seega lõikavad koonust neli tasandit. Siis Risttahukas. Tähed on katsepunktid; hallid on väljas. Küsige enne iga muutust, millised tulevad sisse ja millised lähevad välja. Nähtava ruumi määravad selle kuju ja koht.</translation>
    </message>
    <message>
        <source>In, out, crossing</source>
        <translation>Sees, väljas, piiril</translation>
    </message>
    <message>
        <source>What is wholly outside is dropped. What crosses a plane is cut, plane by plane.</source>
        <translation>Mis on tervenisti väljas, jäetakse ära. Mis tasandit läbib, lõigatakse läbi, tasand tasandi järel.</translation>
    </message>
    <message>
        <source>Cards that are whole inside, outside, and crossing. Step the planes on with the slider: near, far, left, right, bottom, top; each adds corners where an edge goes through. Why not pixel by pixel? To leave out whole triangles is cheap, to leave out fragments is dear. In the dock: corners before and after, and how many cards are whole.</source>
        <translation>Kaardid, mis on tervenisti sees, väljas ja piiril. Viige tasandeid liuguriga edasi: lähitasand, kaugtasand, vasak, parem, alumine, ülemine; igaüks lisab nurki sinna, kus serv läbi läheb. Miks mitte piksel piksli haaval? Tervete kolmnurkade ärajätmine on odav, fragmentide ärajätmine kallis. Külgribal: nurki enne ja pärast ning mitu kaarti on tervenisti sees.</translation>
    </message>
    <message>
        <source>What a real camera also has</source>
        <translation>Mis tegelikul kaameral veel on</translation>
    </message>
    <message>
        <source>A real camera has a focal distance, and a depth of field in front of it and behind it. The synthetic camera has neither: everything is sharp.</source>
        <translation>Tegelikul kaameral on teravustamiskaugus ning selle ees ja taga teravussügavus. Sünteetilisel kaameral ei ole kumbagi: kõik on terav.</translation>
    </message>
    <message>
        <source>The camera&apos;s parameters: position, two vectors, two angles, two planes. A real one has a focal distance and an aperture too. Here a 50-mm lens at f/1, focused at 10 m: sharp from 8.933 to 11.36 m, the outlined post. Drag the focal distance to 5 m and back; then make N 16. Ask from where on everything far is sharp: from the hyperfocal distance.</source>
        <translation>Kaamera parameetrid: asukoht, kaks vektorit, kaks nurka, kaks tasandit. Tegelikul on veel teravustamiskaugus ja diafragma. Siin on 50-mm objektiiv avaga f/1, teravustatud 10 m peale: terav 8.933 kuni 11.36 m, kontuuriga post. Lohistage teravustamiskaugus 5 m peale ja tagasi; siis tehke N väärtuseks 16. Küsige, kust alates on kõik kaugel olev terav: hüperfokaalsest kaugusest alates.</translation>
    </message>
    <message>
        <source>Camera obscura</source>
        <translation>Camera obscura</translation>
    </message>
    <message>
        <source>A dark box with a hole: {0}, upside down. The synthetic camera has its plane in front of the hole.</source>
        <translation>Pime kast avaga: {0}, tagurpidi. Sünteetilise kaamera tasand on ava ees.</translation>
    </message>
    <message>
        <source>The F is 5 high, the film 4 behind the hole. The F goes from 9 to 18. How high is its image?</source>
        <translation>F-i kõrgus on 5 ja film on avast 4 tagapool. F läheb kauguselt 9 kaugusele 18. Kui kõrge on selle kujutis?</translation>
    </message>
    <message>
        <source>This measures from the film, 18 + 4. Both triangles have their corner in the hole. Look at {0} and {1}: both begin there.</source>
        <translation>Nii mõõdetakse filmist, 18 + 4. Mõlemal kolmnurgal on nurk avas. Vaadake suurusi {0} ja {1}: mõlemad algavad seal.</translation>
    </message>
    <message>
        <source>1.11, upright</source>
        <translation>1.11, püstine</translation>
    </message>
    <message>
        <source>This is the image in front of the hole. Look at the film behind it: the light has crossed in the hole, so the image is upside down.</source>
        <translation>See on kujutis ava ees. Vaadake filmi selle taga: valgus on avas ristunud, nii et kujutis on tagurpidi.</translation>
    </message>
    <message>
        <source>Twice as far, half as high: {0}.</source>
        <translation>Kaks korda kaugemal, poole madalam: {0}.</translation>
    </message>
    <message>
        <source>Light crosses in the hole, so the picture on the film is upside down and left for right; painters used it. Compare both films: equally large, only the sign differs. Centre of projection is the hole; for us it is the camera&apos;s position P, and the plane is between it and the object. Vote, then show; drag d as well.</source>
        <translation>Valgus ristub avas, nii et pilt filmil on tagurpidi ja vasak on paremal; maalikunstnikud kasutasid seda. Võrrelge mõlemat filmi: võrdse suurusega, erineb ainult märk. Projektsiooni keskpunkt on ava; meil on see kaamera positsioon P ja tasand on selle ja objekti vahel. Hääletage, siis näidake; lohistage ka d-d.</translation>
    </message>
    <message>
        <source>Position, look, up</source>
        <translation>Positsioon, vaate suund, üles</translation>
    </message>
    <message>
        <source>{0} is the position of the camera, {1} its direction, and {2} says how it is turned about that.</source>
        <translation>{0} on kaamera positsioon, {1} selle suund ja {2} ütleb, kuidas see on selle suuna ümber pööratud.</translation>
    </message>
    <message>
        <source>Axes as on the screen: x right, y up, z towards us. look can be any vector, up any that does not lie along it; it need not be at a right angle. Slide Up from view in the panel: the picture stays while up keeps its plane. Bring it near 0 and nudge it by 0.1° to the side: the picture swings. At 0 the camera is refused.</source>
        <translation>Teljed nagu ekraanil: x paremale, y üles, z meie poole. look võib olla mis tahes vektor, up mis tahes vektor, mis ei ole sellega samasihiline; risti see olema ei pea. Nihutage paneelil liugurit Üles, nurk vaatega: pilt jääb samaks, kuni ülesvektor jääb oma tasandisse. Viige see 0 lähedale ja nihutage 0.1° kõrvale: pilt kaldub järsult. Väärtusel 0 lükatakse kaamera tagasi.</translation>
    </message>
    <message>
        <source>The angles of view</source>
        <translation>Vaatenurgad</translation>
    </message>
    <message>
        <source>{0} and {1}, or one of them and the aspect. A narrow angle is almost a parallel view, a wide one exaggerates.</source>
        <translation>{0} ja {1}, või üks neist ja kuvasuhe. Kitsas nurk on peaaegu paralleelne vaade, lai liialdab.</translation>
    </message>
    <message>
        <source>The picture is 16:9 and {0} is 60°. How wide is {1}?</source>
        <translation>Pilt on 16:9 ja {0} on 60°. Kui lai on {1}?</translation>
    </message>
    <message>
        <source>60°, one angle does for both</source>
        <translation>60°, ühest nurgast piisab mõlema jaoks</translation>
    </message>
    <message>
        <source>{0}. From above half of it is written at the eye: 45.75°.</source>
        <translation>{0}. Ülalt vaadates on silma juurde kirjutatud sellest pool: 45.75°.</translation>
    </message>
    <message>
        <source>From the side {0} is written at the eye. Vote first; then the world is seen from above, with {1} at the eye and the half width on the far plane, f tan of it. Make the image 720 x 720 under Image and depth range: both angles are 60. A photographer does this when choosing a lens. Keep window and picture at one aspect, or everything is stretched.</source>
        <translation>Küljelt vaadates on silma juurde kirjutatud {0}. Enne hääletage; siis nähakse maailma ülalt, kus silma juures on {1} ja kaugtasandil pool laiust, f tan sellest. Tehke jaotises Pilt ja sügavusvahemik pildi suuruseks 720 x 720: mõlemad nurgad on 60. Fotograaf teeb seda objektiivi valides. Hoidke aken ja pilt ühe kuvasuhtega, muidu venib kõik välja.</translation>
    </message>
    <message>
        <source>29 mm and 105 mm</source>
        <translation>29 mm ja 105 mm</translation>
    </message>
    <message>
        <source>With 29 mm from 30 cm and with 105 mm from 108.6 cm the head is equally large. With 105 mm from 360 cm it is 0.30 times as large.</source>
        <translation>29 mm-ga 30 cm kauguselt ja 105 mm-ga 108.6 cm kauguselt on pea suurus sama. 105 mm-ga 360 cm kauguselt on see 0.30 korda nii suur.</translation>
    </message>
    <message>
        <source>From 30 cm to 108.6 cm, the head kept at its size: what of the background?</source>
        <translation>30 cm-lt 108.6 cm-le, pea jääb sama suureks: mis saab taustast?</translation>
    </message>
    <message>
        <source>it stays as it was</source>
        <translation>see jääb samaks</translation>
    </message>
    <message>
        <source>it grows, against the head</source>
        <translation>see kasvab, peaga võrreldes</translation>
    </message>
    <message>
        <source>it shrinks, against the head</source>
        <translation>see kahaneb, peaga võrreldes</translation>
    </message>
    <message>
        <source>From 30 cm it was smaller than it is now: the nearer, the larger the difference.</source>
        <translation>30 cm kauguselt oli see praegusest väiksem: mida lähemal, seda suurem on erinevus.</translation>
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
        <translation>105 mm, suurendatud 3.3 korda</translation>
    </message>
    <message>
        <source>20 cm behind, it is 0.6 times as large as the head from 30 cm, and 0.84 times from 108.6 cm.</source>
        <translation>Mis on peast 20 cm tagapool, paistab 30 cm kauguselt 0.6 ja 108.6 cm kauguselt 0.84 korda nii suur kui pea.</translation>
    </message>
    <message>
        <source>The lecture&apos;s cat. F over D decides the size: 105/29 times 30 cm is 108.6 cm. Vote, then both pictures are there. C brings &quot;Distance, relative to the preset&quot;: drag it for a dolly zoom, in which nose and ears move against the head. Back at 1 ×, choose 105 mm at 360 cm under Seen by, and untick Enlarge: 0.30 times as large, 129 px. The perspective comes from the distance alone.</source>
        <translation>Loengu kass. Suuruse määrab F jagatud D-ga: 105/29 korda 30 cm on 108.6 cm. Hääletage, siis on mõlemad pildid olemas. C toob esile sätte „Kaugus, valmisväärtuse suhtes“: lohistage seda, et saada dolly zoom, kus nina ja kõrvad liiguvad pea suhtes. Jälle 1 × juures valige sättes Vaataja 105 mm 360 cm kauguselt ja võtke linnuke sättelt Suurenda ära: 0.30 korda nii suur, 129 px. Perspektiiv tuleb ainult kaugusest.</translation>
    </message>
    <message>
        <source>Why near and far?</source>
        <translation>Miks lähi- ja kaugtasand?</translation>
    </message>
    <message>
        <source>Four rays run to infinity. Two planes across the axis cut them off, at the distances {0} and {1} from {2}.</source>
        <translation>Neli kiirt lähevad lõpmatusse. Need lõikavad läbi kaks teljega risti olevat tasandit, kaugustel {0} ja {1} punktist {2}.</translation>
    </message>
    <message>
        <source>Near: what is too close hides all the rest, a speck of dust at the eye; what is behind the camera would come out upside down; and the depth buffer needs it. Far: what is far away costs time, and many parts fall into one pixel. Drag both through the F and see in the image what goes.</source>
        <translation>Lähitasand: liiga lähedane peidab kõik ülejäänu, nagu tolmukübe silma ees; mis on kaamera taga, tuleks välja tagurpidi; ja sügavuspuhver vajab seda. Kaugtasand: kauge maksab aega ja palju osi langeb ühte pikslisse. Lohistage mõlemad läbi F-i ja vaadake pildilt, mis kaob.</translation>
    </message>
    <message>
        <source>Depth has finitely many steps</source>
        <translation>Sügavusel on lõplik arv astmeid</translation>
    </message>
    <message>
        <source>The nearer the near plane, the more of the depth values are used up just behind it.</source>
        <translation>Mida lähemal on lähitasand, seda suurem osa sügavuse väärtustest kulub kohe selle taha.</translation>
    </message>
    <message>
        <source>Which of the two cures the stripes?</source>
        <translation>Kumb neist kahest ravib triibud välja?</translation>
    </message>
    <message>
        <source>near from 0.1 to 1</source>
        <translation>lähitasand 0.1-lt 1-le</translation>
    </message>
    <message>
        <source>far from 100 to 50</source>
        <translation>kaugtasand 100-lt 50-le</translation>
    </message>
    <message>
        <source>{0} is small already, so half of far hardly changes {1}. Look at the stripes: they stay.</source>
        <translation>{0} on niigi väike, nii et kaugtasandi poolitamine peaaegu ei muuda suurust {1}. Vaadake triipe: need jäävad.</translation>
    </message>
    <message>
        <source>neither of them</source>
        <translation>kumbki mitte</translation>
    </message>
    <message>
        <source>One of them has a large effect on the gap, {0}.</source>
        <translation>Üks neist mõjutab vahet {0} palju.</translation>
    </message>
    <message>
        <source>The gap is proportional to {0}, and {1} is small already.</source>
        <translation>Vahe on võrdeline suurusega {0}, ja {1} on niigi väike.</translation>
    </message>
    <message>
        <source>Two surfaces 0.05 apart, 16 bits. Where both get the same code the hidden one comes through. Vote, then show; afterwards put near back to 0.1 and try far 50: nothing is won. 24 bits do it as well. Rule: near as far out as the scene allows. Do not set near to 0 to be on the safe side.</source>
        <translation>Kaks pinda vahega 0.05, 16 bitti. Kus mõlemad saavad sama koodi, paistab varjatud pind läbi. Hääletage, siis näidake; pärast viige lähitasand tagasi 0.1 peale ja proovige kaugtasandit 50: midagi ei võideta. Sama hästi aitab 24 bitti. Reegel: lähitasand nii kaugele, kui stseen lubab. Ärge pange lähitasandit kindluse mõttes 0 peale.</translation>
    </message>
    <message>
        <source>Popping</source>
        <translation>Hüppeline ilmumine</translation>
    </message>
    <message>
        <source>As you drive, things appear at the far plane out of nothing. Fog used to hide this; now distant things have fewer vertices, so far can be farther.</source>
        <translation>Sõites ilmuvad asjad kaugtasandil eikuskilt. Varem peitis seda udu; nüüd on kaugetel asjadel vähem tippe, nii et kaugtasand võib olla kaugemal.</translation>
    </message>
    <message>
        <source>Play Position and let them look at the end of the avenue: four trees a second. Choose linear fog, end it at 66: 12 per cent of the contrast are left where they pop. Then switch Level of detail on, and move far out: vertices drawn, with and without. Far is a plane, so trees at the side come at the same depth.</source>
        <translation>Vajutage sätte Asukoht juures Esita ja laske neil vaadata allee lõppu: neli puud sekundis. Valige lineaarne udu lõpuga 66: ilmumise kohas on kontrastist alles 12 protsenti. Siis lülitage Detailsus sisse ja viige kaugtasand kaugemale: joonistatud tipud, sellega ja selleta. Kaugtasand on tasand, nii et kõrval olevad puud ilmuvad samal sügavusel.</translation>
    </message>
    <message>
        <source>The parallel volume</source>
        <translation>Paralleelne nähtav ruum</translation>
    </message>
    <message>
        <source>Width and height take the place of the angles. Things are drawn equally large at every distance.</source>
        <translation>Nurkade asemele tulevad laius ja kõrgus. Asjad joonistatakse igal kaugusel sama suurena.</translation>
    </message>
    <message>
        <source>Posts of one height, one behind the other. Change the lens to perspective and back. The box is simpler to clip against and to test, and no divide is needed: forget z. That is why the perspective volume is brought into this shape in the end. A box need not be upright: oblique is a parallelepiped.</source>
        <translation>Ühekõrgused postid üksteise taga. Vahetage objektiiv perspektiivseks ja tagasi. Risttahukat on lihtsam kärpida ja kontrollida ning jagada ei ole vaja: unustage z. Seepärast viiakse perspektiivne ruum lõpuks selle kujule. Risttahukas ei pea olema püstine: kaldnurgaline on rööptahukas.</translation>
    </message>
    <message>
        <source>A camera at (4, 2, 0)</source>
        <translation>Kaamera kohal (4, 2, 0)</translation>
    </message>
    <message>
        <source>It looks along {0}. To put it at the origin, looking along {1}, move the world by {2}, then rotate it about {3} by {4}.</source>
        <translation>See vaatab suunas {0}. Et viia see alguspunkti, vaatega suunas {1}, nihutage maailma {2} võrra, siis pöörake seda ümber telje {3} nurga {4} võrra.</translation>
    </message>
    <message>
        <source>Which is this camera&apos;s {0}?</source>
        <translation>Milline on selle kaamera {0}?</translation>
    </message>
    <message>
        <source>That would be the {0} of a camera that looks along {1}.</source>
        <translation>See oleks kaamera {0}, mis vaatab suunas {1}.</translation>
    </message>
    <message>
        <source>{0} is opposite to the view direction: the third row begins with −1.</source>
        <translation>{0} on vaate suunale vastupidine: kolmas rida algab arvuga −1.</translation>
    </message>
    <message>
        <source>The camera stays, the world is moved the opposite way: inverse transformations. The F has been put in front of the camera. In Matrices, view from world, press its factors open: rotation times translation, the translation at the right, so it acts first. On View of the strip the eye is the origin. Vote on w before you show it.</source>
        <translation>Kaamera jääb paigale, maailma liigutatakse vastupidises suunas: pöördteisendused. F on pandud kaamera ette. Paneelis Maatriksid, vaade ← maailm, avage selle tegurid: pööre korda nihe, nihe paremal, nii et see mõjub esimesena. Riba peatuses Vaade on silm alguspunktis. Hääletage w üle, enne kui te seda näitate.</translation>
    </message>
    <message>
        <source>u, v, w</source>
        <translation>u, v, w</translation>
    </message>
    <message>
        <source>{0}, {1} is {2} without its component along {3}, normalised, and {4}.</source>
        <translation>{0}, {1} on {2} ilma oma komponendita telje {3} sihis, normeeritud, ja {4}.</translation>
    </message>
    <message>
        <source>Camera frame builds it step by step: w, u, v. The program takes u from up cross w first and v from w cross u; it is the same v as the lecture&apos;s: up minus its projection on w, normed. R has u, v, w as columns; the camera is moved by the inverse, and that is the transpose: u, v, w as rows.</source>
        <translation>Kaamerafreim ehitab selle samm-sammult: w, u, v. Programm võtab enne u vektorkorrutisest üles × w ja siis v vektorkorrutisest w × u; see on sama v mis loengus: ülesvektor miinus selle projektsioon w-le, normeeritud. R-i veerud on u, v, w; kaamerat liigutab pöördteisendus, ja see on transponeeritud maatriks: u, v, w ridadena.</translation>
    </message>
    <message>
        <source>A, B, C and the canonical pyramid</source>
        <translation>A, B, C ja kanooniline püramiid</translation>
    </message>
    <message>
        <source>{0}, {1}, {2} go to {3}, {4}, {5}.</source>
        <translation>{0}, {1}, {2} lähevad punktideks {3}, {4}, {5}.</translation>
    </message>
    <message>
        <source>{0}, {1}: where is near in the pyramid?</source>
        <translation>{0}, {1}: kus on püramiidis lähitasand?</translation>
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
        <translation>Siis oleks see silmas. Kohale 0 satub see järgmises sammus, risttahukas.</translation>
    </message>
    <message>
        <source>All is divided by {0}.</source>
        <translation>Kõik jagatakse suurusega {0}.</translation>
    </message>
    <message>
        <source>An affine transformation is fixed by four points: P, A, B, C. Here f = 10, {0} is 0.8 and {1} is 0.45, so B is 8 to the side and C 4.5 up. {2} = scale, rotation, translation: move P to the origin, turn u, v, w onto x, y, z, divide by f tan, f tan, f. The slide has the scale alone, for the view matrix has turned and moved before. Vote on the near plane, then the pyramid comes: distances along every ray from P are divided by f, too. Show the formulas in Matrices.</source>
        <translation>Afiinse teisenduse määravad neli punkti: P, A, B, C. Siin f = 10, {0} on 0.8 ja {1} on 0.45, seega on B 8 kõrval ja C 4.5 kõrgemal. {2} = skaleerimine, pööre, nihe: viige P alguspunkti, pöörake u, v, w telgedele x, y, z, jagage suurustega f tan, f tan, f. Slaidil on ainult skaleerimine, sest vaatemaatriks on juba pööranud ja nihutanud. Hääletage lähitasandi üle, siis tuleb püramiid: ka kaugused piki iga kiirt punktist P jagatakse f-iga. Näidake valemeid paneelis Maatriksid.</translation>
    </message>
    <message>
        <source>From pyramid to box to cube</source>
        <translation>Püramiidist risttahukaks ja kuubiks</translation>
    </message>
    <message>
        <source>{0} opens the pyramid between {1} and {2}, {3} brings {4} to {5}: {6}.</source>
        <translation>{0} avab püramiidi {1} ja {2} vahel, {3} viib vahemiku {4} vahemikku {5}: {6}.</translation>
    </message>
    <message>
        <source>Drag the strip slowly from Pyramid to Box: the rays to the origin turn into parallels to z, the order of depths is kept, straight lines stay straight. Check a corner: (-c, -c, c) goes to (1, 1, 0). Then NDC: {0} for OpenGL. Here w is 1 at far. Matrices multiplies by f, so that w is the distance and the product is the usual projection matrix; the picture is the same. Now clipping is against x, y, z = 1 and -1, for every camera.</source>
        <translation>Lohistage riba aeglaselt Püramiidist Risttahukani: alguspunkti minevatest kiirtest saavad z-iga paralleelsed, sügavuste järjekord säilib, sirged jäävad sirgeks. Kontrollige üht nurka: (-c, -c, c) läheb punktiks (1, 1, 0). Siis NDC: {0} OpenGL-i jaoks. Siin on w kaugtasandil 1. Paneel Maatriksid korrutab f-iga, nii et w on kaugus ja korrutis on tavaline projektsiooni maatriks; pilt on sama. Nüüd kärbitakse tasanditega x, y, z = 1 ja -1, iga kaamera jaoks.</translation>
    </message>
</context>
<context>
    <name>talk-002</name>
    <message>
        <source>Projections, from the box to the shadow</source>
        <translation>Projektsioonid, risttahukast varjuni</translation>
    </message>
    <message>
        <source>Planar projections</source>
        <translation>Planaarsed projektsioonid</translation>
    </message>
    <message>
        <source>A planar geometric projection takes points of space to a plane along straight lines. The lines are parallel, or they meet in one point.</source>
        <translation>Planaarne geomeetriline projektsioon viib ruumi punkte tasandile sirgjoonte abil. Sirged on paralleelsed või kohtuvad ühes punktis.</translation>
    </message>
    <message>
        <source>A projection can be anything: in linear algebra a map with no inverse, in geography the making of a map. Here it is a plane and straight lines. Walk through the tree from left to right and click each kind: cavalier, isometric, 2-point. Its box is framed and shows a cube in that projection. The sentence below the tree gives the condition for that kind. Ask which kinds keep equal lengths equal: the parallel ones.</source>
        <translation>Projektsioon võib olla mis tahes: lineaaralgebras mittepööratav teisendus, geograafias kaardi tegemine. Siin on see tasand ja sirged. Käige puu vasakult paremale läbi ja klõpsake igal liigil: cavalier, isomeetriline, 2-punkti. Selle liigi kast tõstetakse esile; seal on kuup selles projektsioonis. Lause puu all annab selle liigi tingimuse. Küsige, millised liigid jätavad võrdsed pikkused võrdseks: paralleelsed.</translation>
    </message>
    <message>
        <source>Orthographic: drop z</source>
        <translation>Ortograafiline: jätke z ära</translation>
    </message>
    <message>
        <source>{0}. The screen is not infinite, so a clipping box bounds what is drawn.</source>
        <translation>{0}. Ekraan ei ole lõpmatu, nii et joonistatavat piirab pügamisristtahukas.</translation>
    </message>
    <message>
        <source>Of two equally high posts one is twice as far away as the other. How high does a box draw the far one, relative to the near one?</source>
        <translation>Kahest ühekõrgusest postist on üks kaks korda kaugemal kui teine. Kui kõrgena joonistab risttahukas kaugema, lähemaga võrreldes?</translation>
    </message>
    <message>
        <source>1, equally high</source>
        <translation>1, ühekõrgused</translation>
    </message>
    <message>
        <source>0.5, half as high</source>
        <translation>0.5, poole madalam</translation>
    </message>
    <message>
        <source>The projectors are parallel: x and y do not depend on z.</source>
        <translation>Projektsioonikiired on paralleelsed: x ja y ei sõltu z-ist.</translation>
    </message>
    <message>
        <source>Start with the box and name its six planes: left, right, top, bottom, near, far. Go back to the pyramid once by the scene&apos;s View volume, and let the class say which test points come and go: B has room in the box, C has not. Then the question, by show of hands. The posts are drawn equally high; their numbers say which is which. Change Near and Far: what is cut changes, no size does.</source>
        <translation>Alustage risttahukast ja nimetage selle kuus tasandit: left, right, top, bottom, near, far. Minge üks kord stseeni sättega Nähtav ruum püramiidi juurde tagasi ja laske klassil öelda, millised katsepunktid tulevad ja lähevad: B mahub risttahukasse, C mitte. Siis küsimus, käetõstmisega. Postid joonistatakse ühekõrgustena; nende numbrid ütlevad, kumb on kumb. Muutke lähi- ja kaugtasandit: muutub see, mida lõigatakse, mitte ükski suurus.</translation>
    </message>
    <message>
        <source>Normalised: the matrix of the box</source>
        <translation>Normaliseeritult: risttahuka maatriks</translation>
    </message>
    <message>
        <source>The clipping box becomes {0}. z is kept, because it decides what hides what.</source>
        <translation>Pügamisristtahukast saab {0}. z jäetakse alles, sest see otsustab, mis mida varjab.</translation>
    </message>
    <message>
        <source>Write {0} on the board: move the middle to 0, then scale. Switch the cells of Matrices to Formulas: the product has both terms. {1} and {2} are negative in this lecture, and z&apos; is 1 at near. Where is the middle of the box? At {3}, so the F is left of the middle. The points come to the screen by {4}.</source>
        <translation>Kirjutage tahvlile {0}: nihutage keskkoht kohta 0, siis skaleerige. Valige paneelis Maatriksid lahtritesse Valemid: korrutises on mõlemad liikmed. {1} ja {2} on selles loengus negatiivsed ja z&apos; on lähitasandil 1. Kus on risttahuka keskkoht? Kohal {3}, nii et F on keskkohast vasakul. Punktid satuvad ekraanile teisendusega {4}.</translation>
    </message>
    <message>
        <source>Slanted projectors: H</source>
        <translation>Kaldu projektsioonikiired: H</translation>
    </message>
    <message>
        <source>{0}. From the side it is the same with {1} and {2}: {3}.</source>
        <translation>{0}. Küljelt vaadatuna on sama suurustega {1} ja {2}: {3}.</translation>
    </message>
    <message>
        <source>From above: the camera is left, near is the line at 5, and thin lines are the projectors. A corner at x is drawn at x&apos;. They are parallel, but they meet the near plane at {0}: a unit behind it lands a unit farther along u. A shear does that, H; points of the near plane stay. Turn α: at 90° the projectors are at a right angle to near. At 90° for both angles, H is 1 and the drawing orthographic.</source>
        <translation>Ülalt: kaamera on vasakul, lähitasand on joon kohal 5 ja peenikesed jooned on projektsioonikiired. Nurk kohal x joonistatakse kohale x&apos;. Need on paralleelsed, aga lõikavad lähitasandit nurga {0} all: ühik selle taga satub ühiku võrra edasi piki u-telge. Seda teeb kaldnihe H; lähitasandi punktid jäävad paigale. Pöörake α-t: 90° juures on projektsioonikiired lähitasandiga risti. Kui mõlemad nurgad on 90°, on H 1 ja joonis ortograafiline.</translation>
    </message>
    <message>
        <source>The slanted box made straight</source>
        <translation>Rööptahukas muutub risttahukaks</translation>
    </message>
    <message>
        <source>{0} makes the clipping box straight and shears the object; its image stays. The rest is known: {1}.</source>
        <translation>{0} teeb pügamisrööptahukast risttahuka ja annab objektile kaldnihke; selle kujutis jääb samaks. Ülejäänu on teada: {1}.</translation>
    </message>
    <message>
        <source>A cavalier&apos;s projectors meet the picture at 45°. At which angle do those of a cabinet drawing, scale 1/2?</source>
        <translation>Cavalier-joonise projektsioonikiired lõikavad pilti 45° all. Millise nurga all lõikavad seda cabinet-joonise omad, mille mastaap on 1/2?</translation>
    </message>
    <message>
        <source>The cotangent of the angle is the scale: {0}.</source>
        <translation>Nurga kootangens on mastaap: {0}.</translation>
    </message>
    <message>
        <source>World from above has the slanted box with a cube in it. After H and {0} the box is the NDC cube, and the object is sheared. Which faces keep their shape? Those parallel to the picture. Then vote, and show. Open Matrices: H, {1} and their product stand side by side. Read from right to left: H first, which knows the slant alone, then {2}, which knows the box alone. In OpenGL it is glOrtho and one more matrix, multiplied from the right.</source>
        <translation>Maailm ülalt näitab rööptahukat, milles on kuup. Pärast H-d ja {0} on rööptahukast saanud NDC kuup ja objekt on kaldu nihutatud. Millised tahud säilitavad oma kuju? Need, mis on pildiga paralleelsed. Siis hääletage ja näidake. Avage Maatriksid: H, {1} ja nende korrutis on kõrvuti. Lugege paremalt vasakule: enne H, mis teab ainult kallet, siis {2}, mis teab ainult risttahukat. OpenGL-is on see glOrtho ja veel üks maatriks, paremalt korrutatud.</translation>
    </message>
    <message>
        <source>Homogeneous coordinates</source>
        <translation>Homogeensed koordinaadid</translation>
    </message>
    <message>
        <source>{0} is the point {1}. With {2} it is not a point of space but a point at infinity.</source>
        <translation>{0} on punkt {1}. Kui {2}, ei ole see ruumi punkt, vaid lõpmatuspunkt.</translation>
    </message>
    <message>
        <source>Until now w was 1 all the time. One point of space has infinitely many rows {0}: a line through the origin. Drag t towards 1: P runs along its edge, w goes to 0, and its image comes to rest in {1}. At 1 there is no longer a point of space, but there is still an image. Go on beyond 1: P comes from the other side. This is what makes perspective a matrix.</source>
        <translation>Seni oli w kogu aeg 1. Ühele ruumi punktile vastab lõpmata palju ridu {0}: sirge läbi alguspunkti. Lohistage t 1 poole: P jookseb mööda oma serva, w läheneb nullile 0 ja selle kujutis jääb seisma punktis {1}. Väärtusel 1 ei ole enam ruumi punkti, aga kujutis on endiselt olemas. Minge 1-st kaugemale: P tuleb teiselt poolt. See teebki perspektiivist maatriksi.</translation>
    </message>
    <message>
        <source>Camera obscura, and ours</source>
        <translation>Camera obscura ja meie oma</translation>
    </message>
    <message>
        <source>The film is behind a hole, so the image is upside down. We put the plane in front of the centre of projection.</source>
        <translation>Film on ava taga, seega on kujutis tagurpidi. Meie paneme tasandi projektsiooni keskpunkti ette.</translation>
    </message>
    <message>
        <source>Follow the line from the top of the F through the hole: it comes to the film below. A real camera has a lens there, and the same geometry. Ours has the plane in front of the centre: same size, upright. Move the film: the height goes with it. Read both heights below the scene&apos;s controls: equal but for the sign.</source>
        <translation>Jälgige sirget F-i ülemisest otsast läbi ava: filmile satub see alla. Tegelikul kaameral on seal objektiiv ja sama geomeetria. Meie oma tasand on keskpunkti ees: sama suur, püstine. Nihutage filmi: kõrgus muutub kaasa. Lugege mõlemad kõrgused stseeni juhtelementide alt: võrdsed, kui märk välja arvata.</translation>
    </message>
    <message>
        <source>Onto the plane {0}</source>
        <translation>Tasandile {0}</translation>
    </message>
    <message>
        <source>{0} with {1}: two triangles share the corner at the eye. As a row: {2}.</source>
        <translation>{0}, kus {1}: kahel kolmnurgal on ühine nurk silma juures. Reana: {2}.</translation>
    </message>
    <message>
        <source>The two triangles of the side view: eye to the plane, eye to P. Both heights over both lengths. The lecture writes {0} for {1}, from above; from the side it is {2}. The plane is drawn with its distance d; here {3}, so {4} is positive in front. A 3 by 3 matrix cannot divide by z. Four coordinates can: the last row writes {5} into w, and the dividing comes afterwards. Move d behind the eye: camera obscura again.</source>
        <translation>Külgvaate kaks kolmnurka: silmast tasandini, silmast P-ni. Mõlemad kõrgused jagatud mõlema pikkusega. Loeng kirjutab {1} asemel {0}, ülalt vaadatuna; küljelt on see {2}. Tasand on joonistatud oma kaugusega d; siin {3}, nii et {4} on ees positiivne. 3 korda 3 maatriks ei saa z-iga jagada. Nelja koordinaadiga saab: viimane rida kirjutab w-sse {5} ja jagatakse hiljem. Viige d silma taha: jälle camera obscura.</translation>
    </message>
    <message>
        <source>Frustum to cube</source>
        <translation>Frustumist kuubiks</translation>
    </message>
    <message>
        <source>The visible part of space is now a frustum. It must become the same cube as before.</source>
        <translation>Nähtav ruumi ala on nüüd frustum. Sellest peab saama sama kuup mis enne.</translation>
    </message>
    <message>
        <source>The trick of the box once more: make it the cube, then leave z out. Let the strip run, slowly, from View over Pyramid and Box to NDC, and back. Ask what has become of straight lines: they are straight at every place of the strip. What has become of the F? The part nearer to the eye has grown. For x and y that is easily said: after dividing, the window is scaled to −1 to 1. z is the problem.</source>
        <translation>Veel kord sama nipp mis risttahuka puhul: tehke sellest kuup ja jätke siis z ära. Laske ribal aeglaselt joosta Vaatest läbi Püramiidi ja Risttahuka NDC-ni ja tagasi. Küsige, mis sai sirgetest: riba igas kohas on need sirged. Mis sai F-ist? Silmale lähem osa on kasvanud. x ja y jaoks on see kergesti öeldud: pärast jagamist skaleeritakse aken vahemikku −1 kuni 1. Häda on z-iga.</translation>
    </message>
    <message>
        <source>What becomes of z?</source>
        <translation>Mis saab z-ist?</translation>
    </message>
    <message>
        <source>x and y are divided by z. May we simply keep z, only scaled and shifted?</source>
        <translation>x ja y jagatakse z-iga. Kas z-i võib lihtsalt alles jätta, ainult skaleeritult ja nihutatult?</translation>
    </message>
    <message>
        <source>x and y are divided, {0}. What is PQ in the cube?</source>
        <translation>x ja y jagatakse, {0}. Mis on kuubis PQ?</translation>
    </message>
    <message>
        <source>Straight: every step keeps lines</source>
        <translation>Sirge: iga samm säilitab sirgeid</translation>
    </message>
    <message>
        <source>x and y are divided by z, z&apos; is not: that step keeps no lines. Look at the bow between P and Q.</source>
        <translation>x ja y jagatakse z-iga, z&apos; mitte: see samm ei säilita sirgeid. Vaadake kaart P ja Q vahel.</translation>
    </message>
    <message>
        <source>Bent</source>
        <translation>Kõver</translation>
    </message>
    <message>
        <source>Only with {0} do all three change with 1/z.</source>
        <translation>Ainult siis, kui {0}, muutuvad kõik kolm koos suurusega 1/z.</translation>
    </message>
    <message>
        <source>Let them vote before the cube is seen. Then show: the bow, its chord, and the deviation in per cent of the length. The straight line beside it is A + B/z. Drag P towards the eye and the bow grows. Why does it matter? What lies between the ends is interpolated, and lines are clipped as lines. With B &lt; 0 the order of depth is kept in this lecture&apos;s signs. Near is 1, far is −1: two equations for A and B.</source>
        <translation>Laske neil hääletada, enne kui kuupi näha on. Siis näidake: kaar, selle kõõl ja kõrvalekalle protsentides pikkusest. Sirge joon selle kõrval on A + B/z. Lohistage P-d silma poole ja kaar kasvab. Miks see loeb? Mis on otste vahel, interpoleeritakse, ja sirgeid kärbitakse nagu sirgeid. Kui B &lt; 0, säilib selle loengu märkidega sügavuste järjekord. Lähitasand on 1, kaugtasand −1: kaks võrrandit A ja B jaoks.</translation>
    </message>
    <message>
        <source>The matrix of perspective</source>
        <translation>Perspektiivi maatriks</translation>
    </message>
    <message>
        <source>{0}, and the last row is {1}.</source>
        <translation>{0} ja viimane rida on {1}.</translation>
    </message>
    <message>
        <source>{0} is linear: a matrix. So it keeps lines. In Matrices look at clip ← view in Formulas: in these letters w is z, negative in front of the eye. OpenGL&apos;s matrix is this one times −1 with z&apos; reversed, since there the planes are positive distances. Numbers: {1}, {2}, {3}.</source>
        <translation>{0} on lineaarne: maatriks. Seega säilitab see sirgeid. Vaadake paneelis Maatriksid maatriksit kärperuum ← vaade Valemitena: nendes tähtedes on w z, silma ees negatiivne. OpenGL-i maatriks on see siin korda −1 ja ümber pööratud z&apos;-ga, sest seal on tasandid positiivsed kaugused. Arvud: {1}, {2}, {3}.</translation>
    </message>
    <message>
        <source>A window off the axis</source>
        <translation>Teljeväline aken</translation>
    </message>
    <message>
        <source>The window is not in the middle: {0} makes the slanted frustum straight first.</source>
        <translation>Aken ei ole keskel: {0} teeb kaldus frustumi enne sirgeks.</translation>
    </message>
    <message>
        <source>A wall of screens, or an eye beside the middle of its screen. Drag &quot;Eye right of the middle&quot;: the picture on the window stays right for that eye. H again, with cotangents from the window&apos;s middle. A slip of the lecture: with w = z the third column has a minus, {0}. Check it with the point in the window&apos;s middle, which must come to x&apos; = 0. glFrustum takes six numbers, gluPerspective four.</source>
        <translation>Ekraanidest sein või silm oma ekraani keskkoha kõrval. Lohistage sätet „Silm keskkohast paremal“: pilt aknal jääb selle silma jaoks õigeks. Jälle H, kootangensid akna keskkoha järgi. Loengu näpuviga: kui w = z, on kolmandas veerus miinus, {0}. Kontrollige seda akna keskkoha punktiga, mis peab sattuma kohale x&apos; = 0. glFrustum võtab kuus arvu, gluPerspective neli.</translation>
    </message>
    <message>
        <source>Field of view</source>
        <translation>Frustumi nurk</translation>
    </message>
    <message>
        <source>30° is a common angle. A wide angle draws near things much larger than far ones; a narrow angle is close to an orthographic picture.</source>
        <translation>30° on tavaline nurk. Lai nurk joonistab lähedased asjad palju suuremana kui kauged; kitsas nurk on lähedal ortograafilisele pildile.</translation>
    </message>
    <message>
        <source>Three cameras, each as far away as it must be for the same size of the F: 95°, 30°, 7.5°. The first is what the lecture calls fish-eye, the last is nearly orthographic: look at the upright edges and at the top. Sizes are proportional to the tangent of half the angle. The angle alone only enlarges; the distance changes the perspective.</source>
        <translation>Kolm kaamerat, igaüks nii kaugel, kui peab, et F oleks sama suur: 95°, 30°, 7.5°. Esimest nimetab loeng fish-eye efektiks, viimane on peaaegu ortograafiline: vaadake püstservi ja ülemist otsa. Suurused on võrdelised poole nurga tangensiga. Nurk üksi ainult suurendab; perspektiivi muudab kaugus.</translation>
    </message>
    <message>
        <source>Divide, then pixels</source>
        <translation>Jagamine, siis pikslid</translation>
    </message>
    <message>
        <source>{0}, then {1}</source>
        <translation>{0}, siis {1}</translation>
    </message>
    <message>
        <source>One point through all stages, row by row: world, view, clip, the divide, NDC, pixels. Width and height are the screen&apos;s, in pixels; the lecture writes w and h, but w is the fourth coordinate here. The screen&apos;s origin is the upper left corner, hence 1 - y. Drag point 1 in the picture to the upper left corner and read its row NDC: −1 and 1. That was the transform of the vertices; clipping and rasterising come after it.</source>
        <translation>Üks punkt läbi kõigi etappide, rida-realt: maailm, vaade, kärperuum, jagamine, NDC, pikslid. Laius ja kõrgus on ekraani omad, pikslites; loeng kirjutab w ja h, aga siin on w neljas koordinaat. Ekraani alguspunkt on ülemine vasak nurk, sellest 1 - y. Lohistage punkt 1 pildil ülemisse vasakusse nurka ja lugege selle rida NDC: −1 ja 1. See oli tippude teisendus; kärpimine ja rasterdamine tulevad pärast seda.</translation>
    </message>
    <message>
        <source>Halfway in the picture</source>
        <translation>Pildil poolel teel</translation>
    </message>
    <message>
        <source>Linear on the screen is not linear in the world: {0}</source>
        <translation>Ekraanil lineaarne ei ole maailmas lineaarne: {0}</translation>
    </message>
    <message>
        <source>The same board twice: once texture coordinates are interpolated as they are, once a/z and 1/z are, and then divided. Where is the middle of an edge whose ends are 2 and 8 away? A fifth of the way, seen from the near end. Colours forgive it, textures do not. Divide the board into more parts: the error goes down with their size, which is how old games hid it.</source>
        <translation>Sama laud kaks korda: ühel korral interpoleeritakse tekstuuri koordinaate nii, nagu need on, teisel korral a/z ja 1/z ning jagatakse siis. Kus on keskkoht serval, mille otsad on 2 ja 8 kaugusel? Viiendiku peal, lähemast otsast vaadates. Värvid andestavad selle, tekstuurid mitte. Jagage laud rohkemateks osadeks: viga väheneb koos nende suurusega, nii peitsid seda vanad mängud.</translation>
    </message>
    <message>
        <source>What a console of 1994 saved</source>
        <translation>Mida 1994. aasta mängukonsool säästis</translation>
    </message>
    <message>
        <source>Whole pixels for the vertices, no divide for the texture: quick, and seen at once.</source>
        <translation>Tippudele täispikslid, tekstuurile ei mingit jagamist: kiire ja kohe näha.</translation>
    </message>
    <message>
        <source>The picture called cheap: vertices at whole pixels, 1/w from a small table, a/z replaced by a. The arrows run from where a vertex belongs to where it is drawn, 20 times as long. Turn the camera slowly with Azimuth: the vertices jump, and the checks bend at each square&apos;s diagonal. The other picture is exact. No vertex is farther off than half a pixel across and half a pixel down; what is seen is that neighbours jump at different moments.</source>
        <translation>Pilt nimega odav: tipud täispikslitel, 1/w väikesest tabelist, a/z asemel a. Nooled osutavad sealt, kuhu tipp kuulub, sinna, kuhu see joonistatakse, 20 korda pikemana. Pöörake kaamerat aeglaselt sättega Asimuut: tipud hüppavad ja ruudud murduvad iga ruudu diagonaalil. Teine pilt on täpne. Ühegi tipu viga ei ole suurem kui pool pikslit kõrvale ja pool pikslit alla; näha on see, et naabrid hüppavad eri hetkedel.</translation>
    </message>
    <message>
        <source>Shadows</source>
        <translation>Varjud</translation>
    </message>
    <message>
        <source>A shadow is a projection from the lamp onto the ground: a matrix {0}, and {1}. Draw the object once more under it, in black.</source>
        <translation>Vari on projektsioon lambist maapinnale: maatriks {0} ja {1}. Joonistage objekt sellega veel kord, mustalt.</translation>
    </message>
    <message>
        <source>The lamp is the centre of projection, the ground is the plane. No depth has to be kept, so the simplest matrix will do: More numbers has S. Draw the ground, draw the object, then in black the object under S. Drag the lamp lower, then choose Sun: the projection becomes a parallel one, w = 1. Close: orthographic, oblique and perspective are all matrices in homogeneous coordinates. Next time: clipping and hidden faces.</source>
        <translation>Lamp on projektsiooni keskpunkt, maa on tasand. Sügavust ei ole vaja säilitada, nii et piisab kõige lihtsamast maatriksist: S on jaotises Veel arve. Joonistage maa, joonistage objekt, siis mustalt objekt maatriksiga S. Lohistage lampi allapoole, siis valige Päike: projektsioonist saab paralleelne, w = 1. Lõpetuseks: ortograafiline, kaldnurgaline ja perspektiivne on kõik homogeensetes koordinaatides maatriksid. Järgmine kord: kärpimine ja peidetud tahud.</translation>
    </message>
</context>
<context>
    <name>talk-003</name>
    <message>
        <source>Coordinate systems and transformations</source>
        <translation>Koordinaatsüsteemid ja teisendused</translation>
    </message>
    <message>
        <source>Three spaces</source>
        <translation>Kolm ruumi</translation>
    </message>
    <message>
        <source>Object space is where a thing is made, world space where it is placed, camera space where it is seen from.</source>
        <translation>Objekti ruumis asi tehakse, maailmas see paigutatakse ja kaamerafreimist seda vaadatakse.</translation>
    </message>
    <message>
        <source>World: the grid&apos;s middle is the world&apos;s origin; the small axes at the F are its own, moved by 3 along x and -1 along z, and turned about y; u, v, n at the eye are the camera&apos;s. Each of the three questions, making, placing, looking, has a space of its own, so that each can be answered without the others. All three are right-handed. Take the F by its own origin and move it.</source>
        <translation>Maailm: ruudustiku keskkoht on maailma alguspunkt; väikesed teljed F-i juures on selle omad, nihutatud 3 piki x-telge ja -1 piki z-telge ning pööratud ümber y-telje; u, v, n silma juures on kaamera omad. Igal kolmest küsimusest, tegemine, paigutamine, vaatamine, on oma ruum, et igaühele saaks vastata ilma teisteta. Kõik kolm on paremakäelised. Haarake F selle enda alguspunktist ja liigutage seda.</translation>
    </message>
    <message>
        <source>Columns are axes</source>
        <translation>Veerud on teljed</translation>
    </message>
    <message>
        <source>Columns 1 to 3 of {0} are the object&apos;s axes, as the world sees them; column 4 is its origin:</source>
        <translation>Maatriksi {0} veerud 1 kuni 3 on objekti teljed nii, nagu maailm neid näeb; veerg 4 on selle alguspunkt:</translation>
    </message>
    <message>
        <source>The object is turned by 90° about z, then moved by 3 along x. How high in y is its point (1, 0, 0) then?</source>
        <translation>Objekti pööratakse 90° ümber z-telje ja nihutatakse siis 3 võrra piki x-telge. Kui kõrgel, y-sihis, on siis selle punkt (1, 0, 0)?</translation>
    </message>
    <message>
        <source>The move does not raise it, but the rotation takes x to y.</source>
        <translation>Nihe seda ei tõsta, aga pööre viib x-i y-iks.</translation>
    </message>
    <message>
        <source>Column 1 is (0, 1, 0), column 4 is (3, 0, 0), and together they are (3, 1, 0).</source>
        <translation>Veerg 1 on (0, 1, 0), veerg 4 on (3, 0, 0) ja kokku on need (3, 1, 0).</translation>
    </message>
    <message>
        <source>Row x of the product is the sum on the board: how far each object axis reaches along the world&apos;s x, times the coordinate. Read by columns it says more: column 1 is where the object&apos;s x axis points. After the vote open Matrices and go over the columns of world ← object; the axis lights up in World. Then turn the object by hand, by its ring.</source>
        <translation>Korrutise rida x on tahvlil olev summa: kui kaugele iga objekti telg maailma x-sihis ulatub, korda koordinaat. Veergude kaupa lugedes ütleb see rohkem: veerg 1 on see, kuhu objekti x-telg näitab. Pärast hääletust avage Maatriksid ja käige läbi maatriksi maailm ← objekt veerud; telg süttib paanis Maailm. Siis pöörake objekti käsitsi, selle rõngast.</translation>
    </message>
    <message>
        <source>From the object to the camera</source>
        <translation>Objektist kaamerani</translation>
    </message>
    <message>
        <source>Each factor leads from one space to the next: the strip stops at *Object*, *Ry*, *World* and *View*.</source>
        <translation>Iga tegur viib ühest ruumist järgmisse: riba peatused on *Objekt*, *Ry*, *Maailm* ja *Vaade*.</translation>
    </message>
    <message>
        <source>Exchange the two matrices: {0}. Where is the letter then?</source>
        <translation>Vahetage kaks maatriksit omavahel: {0}. Kus on täht siis?</translation>
    </message>
    <message>
        <source>Elsewhere: it is turned and moved along the camera&apos;s axes</source>
        <translation>Mujal: seda pööratakse ja nihutatakse piki kaamera telgi</translation>
    </message>
    <message>
        <source>In the same place</source>
        <translation>Samas kohas</translation>
    </message>
    <message>
        <source>In the same place, but seen from elsewhere</source>
        <translation>Samas kohas, aga mujalt nähtuna</translation>
    </message>
    <message>
        <source>Both the place and the view have changed. The letter is turned about the eye and moved along u.</source>
        <translation>Muutunud on nii koht kui ka vaade. Tähte pööratakse ümber silma ja nihutatakse piki u-telge.</translation>
    </message>
    <message>
        <source>The matrix on the right acts first. The view takes the letter to the camera, and the move is then made along {0}, about the eye.</source>
        <translation>Esimesena mõjub parempoolne maatriks. Vaade viib tähe kaamerani ja alles siis pööratakse seda ümber silma ja nihutatakse piki telge {0}.</translation>
    </message>
    <message>
        <source>The large pane shows camera space: the eye is at the origin, u to the right, v up, n towards it. Scrub the strip from Object to View: at Ry the letter is turned, at World it stands in its place, and from World to View everything moves and nothing changes its place against the rest. The rows of the view matrix are the camera&apos;s axes, because it is the inverse of the matrix whose columns they are. Then ask what the exchanged product does. Both matrices are multiplied once, not for every vertex.</source>
        <translation>Suur paan näitab kaamerafreimi: silm on alguspunktis, u paremale, v üles, n silma poole. Lohistage etapiriba liugurit Objektist Vaateni: peatuses Ry on tähte pööratud, peatuses Maailm on see oma kohal ning Maailmast Vaateni liigub kõik ja mitte millegi koht ülejäänu suhtes ei muutu. Vaatemaatriksi read on kaamera teljed, sest see on selle maatriksi pöördmaatriks, mille veerud need on. Siis küsige, mida teeb vahetatud korrutis. Mõlemad maatriksid korrutatakse ühe korra, mitte iga tipu jaoks.</translation>
    </message>
    <message>
        <source>Clip, divide, NDC</source>
        <translation>Kärperuum, jagamine, NDC</translation>
    </message>
    <message>
        <source>First multiply by {0}, then divide by {1}. Probe 1 is at {2} in camera space, and {3}.</source>
        <translation>Enne korrutage maatriksiga {0}, siis jagage suurusega {1}. Sond 1 on kaamerafreimis {2} ja {3}.</translation>
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
        <translation>kärperuum</translation>
    </message>
    <message>
        <source>NDC</source>
        <translation>NDC</translation>
    </message>
    <message>
        <source>Two steps: a matrix, and a division that no matrix can do. w is 5, the depth of the point. The table is the Probe panel&apos;s; NDC has the point in the cube. The handout calls the cube the clip space; here clip is what is before the division. The cube&apos;s z runs away from the reader: NDC is left-handed, the camera&apos;s space right-handed. Drag probe 1 in Image.</source>
        <translation>Kaks sammu: maatriks ja jagamine, mida ükski maatriks teha ei saa. w on 5, punkti sügavus. Tabel on paneelist Sond; NDC näitab punkti kuubis. Jaotusmaterjal nimetab kärperuumiks kuupi; siin on kärperuum see, mis on enne jagamist. Kuubi z on suunatud lugejast eemale: NDC on vasakukäeline, kaamerafreim paremakäeline. Lohistage paanis Pilt sondi 1.</translation>
    </message>
    <message>
        <source>The view frustum</source>
        <translation>Nähtav ruum: frustum</translation>
    </message>
    <message>
        <source>Six numbers: near and far, and left, right, bottom and top of the window on the near plane.</source>
        <translation>Kuus arvu: lähi- ja kaugtasand ning lähitasandil oleva akna vasak, parem, alumine ja ülemine serv.</translation>
    </message>
    <message>
        <source>World: the pyramid without its tip. What is inside is drawn, and all of it goes to the cube. Drag near, far and a corner by their handles. Here the window is symmetric, and its four numbers come from one angle and the proportions of the picture: that is the next step.</source>
        <translation>Maailm: püramiid ilma tiputa. Mis on selle sees, joonistatakse, ja see kõik läheb kuupi. Lohistage lähitasandit, kaugtasandit ja üht nurka nende pidemetest. Siin on aken sümmeetriline ja selle neli arvu tulevad ühest nurgast ja pildi proportsioonidest: see on järgmine samm.</translation>
    </message>
    <message>
        <source>Fields of view and e</source>
        <translation>Frustumi nurgad ja e</translation>
    </message>
    <message>
        <source>At {0} the picture reaches {1} in x and {2} in y, {3}; at near {4}, {5}.</source>
        <translation>Kohal {0} ulatub pilt x-sihis {1} ja y-sihis {2}, {3}; lähitasandil {4}, {5}.</translation>
    </message>
    <message>
        <source>Take β = 60° and a picture of 16:9. How large is α?</source>
        <translation>Olgu β = 60° ja pilt 16:9. Kui suur on α?</translation>
    </message>
    <message>
        <source>tan(α/2) = 16/9 · tan 30° = 1.026</source>
        <translation>tan(α/2) = 16/9 · tan 30° = 1.026</translation>
    </message>
    <message>
        <source>Draw the triangle eye, axis, edge: half the angle is in it. World is seen from above, with half of α at the eye. After the vote: 91.5°, not 106.7°. The tangents of the half angles are in the ratio 16 to 9, not the angles. The wider, the worse: type 120°, multiplied it would be 213°. More of the lens has Focal length e and the focal length of a 35-mm camera. β is not α, unless the picture is square.</source>
        <translation>Joonistage kolmnurk silm, telg, serv: selles on pool nurka. Maailma nähakse ülalt, silma juures on pool α-st. Pärast hääletust: 91.5°, mitte 106.7°. Suhtes 16 ja 9 on poolte nurkade tangensid, mitte nurgad. Mida laiem, seda hullem: sisestage 120°, korrutatuna oleks see 213°. Jaotises Veel objektiivist on Fookuskaugus e ja 35-mm kaamera fookuskaugus. β ei ole α, kui pilt ei ole ruudukujuline.</translation>
    </message>
    <message>
        <source>Onto the near plane</source>
        <translation>Lähitasandile</translation>
    </message>
    <message>
        <source>By similar triangles, with the plane at {0}:</source>
        <translation>Sarnaste kolmnurkade järgi, kui tasand on kohal {0}:</translation>
    </message>
    <message>
        <source>World from the side: the plane is the near plane, d = n = 2. P is 5 deep and 2 high, P&apos; is 0.8 high. Both coordinates go with 1/(-z), so {0}, the length below the picture, and the last row is 0 0 -1 0. The minus is there because what is seen has negative z. From above it is the same for x.</source>
        <translation>Maailm küljelt: tasand on lähitasand, d = n = 2. P sügavus on 5 ja kõrgus 2, P&apos; kõrgus on 0.8. Mõlemad koordinaadid on võrdelised suurusega 1/(-z), seega {0}, pikkus pildi all, ja viimane rida on 0 0 -1 0. Miinus on seal sellepärast, et nähtaval on negatiivne z. Ülalt vaadates on x-iga samamoodi.</translation>
    </message>
    <message>
        <source>[l, r] and [b, t]</source>
        <translation>[l, r] ja [b, t]</translation>
    </message>
    <message>
        <source>{0}, and likewise for y with b and t.</source>
        <translation>{0}, samamoodi y-i jaoks b ja t-ga.</translation>
    </message>
    <message>
        <source>Check the ends: {0} gives {1}, {2} gives 1. In the proportion of the handout read {3} and (t - b). Probe 1 is straight ahead, x = 0; only the second fraction is left, and with l = -1, r = 3 it puts it at -0.5. The plus is right: it is multiplied by z, which is negative. Drag Left and Right.</source>
        <translation>Kontrollige otsi: {0} annab {1}, {2} annab 1. Jaotusmaterjali võrdes lugege {3} ja (t - b). Sond 1 on otse ees, x = 0; alles on ainult teine murd ja kui l = -1, r = 3, viib see selle kohta -0.5. Pluss on õige: see korrutatakse z-iga, mis on negatiivne. Lohistage välju Vasak ja Parem.</translation>
    </message>
    <message>
        <source>A and B</source>
        <translation>A ja B</translation>
    </message>
    <message>
        <source>z does not depend on x and y: {0}, {1} at near and {2} at far:</source>
        <translation>z ei sõltu x-ist ja y-ist: {0}, {1} lähitasandil ja {2} kaugtasandil:</translation>
    </message>
    <message>
        <source>Near is 1, far is 9. A point is 5 deep, halfway between them. Where is it in the cube, as {0}?</source>
        <translation>Lähitasand on 1, kaugtasand 9. Punkti sügavus on 5, nende vahel poolel teel. Kus on see kuubis, suurusena {0}?</translation>
    </message>
    <message>
        <source>This spreads the depth evenly between near and far. Look at the F in the cube: most of the depth lies close to far.</source>
        <translation>Nii jaotatakse sügavus lähi- ja kaugtasandi vahel ühtlaselt. Vaadake kuubis F-i: suurem osa sügavusest on kaugtasandi lähedal.</translation>
    </message>
    <message>
        <source>This is {0}, before the division by {1}. Look at the point: it lies inside the cube, so {2} is at most 1.</source>
        <translation>See on {0}, enne jagamist suurusega {1}. Vaadake punkti: see on kuubi sees, seega on {2} ülimalt 1.</translation>
    </message>
    <message>
        <source>{0}, {1}, and {2}.</source>
        <translation>{0}, {1} ja {2}.</translation>
    </message>
    <message>
        <source>Solve for A and B with the two conditions. Why not just scale? Because then lines would be bent; the reason that the lecture gives is the next part: 1/z is what is linear on the screen. The vote: most say 0, the middle. Show the crowding: half of the cube is used up at 2nf/(n + f) = 1.8.</source>
        <translation>Avaldage kahest tingimusest A ja B. Miks mitte lihtsalt skaleerida? Sest siis oleksid sirged kõverad; põhjus, mille annab loeng, on järgmine osa: ekraanil on lineaarne 1/z. Hääletus: enamik ütleb 0, keskkoht. Näidake tihenemist: pool kuubist on ära kasutatud kohal 2nf/(n + f) = 1.8.</translation>
    </message>
    <message>
        <source>The matrix of glFrustum</source>
        <translation>glFrustumi maatriks</translation>
    </message>
    <message>
        <source>Rows 1 and 2 come from the window, row 3 from {0} and {1}; row 4 divides. Framed is what {2} changes.</source>
        <translation>Read 1 ja 2 tulevad aknast, rida 3 suurustest {0} ja {1}; rida 4 jagab. Raamis on see, mida {2} muudab.</translation>
    </message>
    <message>
        <source>All of it has been derived: rows 1 and 2 from the window, row 3 from A and B, row 4 from the division. With the numbers here row 1 is 1, 0, 0.5, 0. For a symmetric window the two shears are 0, and 2n/(r - l) is e.</source>
        <translation>Kõik see on tuletatud: read 1 ja 2 aknast, rida 3 A-st ja B-st, rida 4 jagamisest. Siinsete arvudega on rida 1 1, 0, 0.5, 0. Sümmeetrilise akna puhul on kaks kaldnihet 0 ja 2n/(r - l) on e.</translation>
    </message>
    <message>
        <source>1/z is linear on the screen</source>
        <translation>1/z on ekraanil lineaarne</translation>
    </message>
    <message>
        <source>An edge runs from the depth {0} to {1}. At {2} of the way on the screen: {3}</source>
        <translation>Serv läheb sügavuselt {0} sügavusele {1}. Kui ekraanil on läbitud osa {2}: {3}</translation>
    </message>
    <message>
        <source>Image: halfway along the marked edge on the screen, and halfway along it in the world, are two places. The first is only 30 % of the way from the nearer end. On the board: depths 2 and 8, t = 1/2, so 1/z = (1/2 + 1/8)/2 and z = 3.2, not 5. Why: a straight edge has a linear equation in x and z. Divided by z it is one in x/z, the place on the screen, and 1/z, and that is all.</source>
        <translation>Pilt: ekraanil poolel teel mööda märgitud serva ja maailmas poolel teel on kaks eri kohta. Esimeseni on lähemast otsast ainult 30 % teest. Tahvlil: sügavused 2 ja 8, t = 1/2, seega 1/z = (1/2 + 1/8)/2 ja z = 3.2, mitte 5. Miks: sirgel serval on lineaarne võrrand x ja z suhtes. Kui see jagada z-iga, on see lineaarne x/z, ekraanikoha, ja 1/z suhtes, ja see ongi kõik.</translation>
    </message>
    <message>
        <source>Attributes: a/z</source>
        <translation>Atribuudid: a/z</translation>
    </message>
    <message>
        <source>Colours and texture coordinates are linear along the edge in space, so {0} is linear on the screen too:</source>
        <translation>Värvid ja tekstuuri koordinaadid on ruumis piki serva lineaarsed, seega on ekraanil lineaarne ka {0}:</translation>
    </message>
    <message>
        <source>Affine: the texture is bent along the diagonal, where the two triangles meet. Correct: a/z and 1/z are interpolated, and divided at each pixel. With depths 2 and 8 and a from 0 to 1, the middle has a = 0.2, not 0.5. Turn Azimuth: seen straight on both are alike. Parts a side makes the error smaller, not zero.</source>
        <translation>Afiinne: tekstuur murdub diagonaalil, kus kaks kolmnurka kohtuvad. Korrektne: interpoleeritakse a/z ja 1/z ning jagatakse igas pikslis. Kui sügavused on 2 ja 8 ning a on 0-st 1-ni, on keskel a = 0.2, mitte 0.5. Pöörake asimuuti: otse vaadates on mõlemad ühesugused. Osi küljel teeb vea väiksemaks, mitte nulliks.</translation>
    </message>
    <message>
        <source>The orthographic box</source>
        <translation>Ortograafiline risttahukas</translation>
    </message>
    <message>
        <source>A box becomes a cube without a division: scale by {0} and {1}, and move the middle to 0.</source>
        <translation>Risttahukast saab kuup ilma jagamata: skaleerige arvudega {0} ja {1} ning nihutage keskkoht kohta 0.</translation>
    </message>
    <message>
        <source>The box has the same width at every depth: w is 1. The first cell of the handout has 2n/(r - l), a slip: nothing is brought to a near plane here, so there is no n. The shifts stand in column 4 now, not in column 3, because they are not multiplied by z. Compare with the frustum&apos;s matrix, in step 10.</source>
        <translation>Risttahukas on igal sügavusel ühelaiune: w on 1. Jaotusmaterjali esimeses lahtris on 2n/(r - l), mis on näpuviga: siin ei viida midagi lähitasandile, seega ei ole n-i. Nihked on nüüd veerus 4, mitte veerus 3, sest neid ei korrutata z-iga. Võrrelge frustumi maatriksiga sammus 10.</translation>
    </message>
    <message>
        <source>To pixels</source>
        <translation>Pikslitesse</translation>
    </message>
    <message>
        <source>{0} and, as rows count down, {1}. Probe 1: {2} to {3}.</source>
        <translation>{0} ja, sest ridu loetakse ülalt alla, {1}. Sond 1: {2} läheb kohta {3}.</translation>
    </message>
    <message>
        <source>The same probe as before, now to the end: 1280 by 720, origin at the upper left. Ask for the corners of the cube: (-1, 1) is (0, 0), (1, -1) is (1280, 720). y turns over here and nowhere else. Sum up the chain: object, world, camera, clip, NDC, pixels; Probe in the drawer has all of it for one point.</source>
        <translation>Sama sond mis enne, nüüd lõpuni: 1280 korda 720, alguspunkt üleval vasakul. Küsige kuubi nurki: (-1, 1) on (0, 0), (1, -1) on (1280, 720). y pöördub ümber siin ja mitte kusagil mujal. Võtke ahel kokku: objekt, maailm, kaamera, kärperuum, NDC, pikslid; sahtli paneelis Sond on see kõik ühe punkti jaoks.</translation>
    </message>
</context>
<context>
    <name>talk-004</name>
    <message>
        <source>A camera for the letter F</source>
        <translation>Kaamera F-tähe jaoks</translation>
    </message>
    <message>
        <source>The camera&apos;s axes</source>
        <translation>Kaamera teljed</translation>
    </message>
    <message>
        <source>{0}, {1} is the origin, {2}. What is {3}?</source>
        <translation>{0}, {1} on alguspunkt, {2}. Kui suur on {3}?</translation>
    </message>
    <message>
        <source>1: {0} is up, so {1} is up</source>
        <translation>1: {0} on üles, seega on {1} üles</translation>
    </message>
    <message>
        <source>{0} and {1}, so {2}.</source>
        <translation>{0} ja {1}, seega {2}.</translation>
    </message>
    <message>
        <source>Build it step by step in Camera frame: eye and target, then N, n, U, u, v. N points back, from the target to the eye: the camera looks along {0}. Three unit vectors, each at right angles to the others, right-handed. Stop before v and let them vote: n is (0, 9, 3) over its length, 9.49. Then show v: it leans far away from V. What if V is parallel to N? Turn &quot;Up from view&quot; towards the end of its slider: |V × n| goes to 0, and U with it.</source>
        <translation>Ehitage see paneelis Kaamerafreim samm-sammult: silm ja sihtpunkt, siis N, n, U, u, v. N näitab tahapoole, sihtpunktist silma: kaamera vaatab suunas {0}. Kolm ühikvektorit, igaüks teistega risti, paremakäeliselt. Peatuge enne v-d ja laske neil hääletada: n on (0, 9, 3) jagatud oma pikkusega, 9.49. Siis näidake v-d: see kaldub V-st kaugele. Mis siis, kui V on N-iga paralleelne? Pöörake „Üles, nurk vaatega“ liuguri otsa poole: |V × n| läheneb nullile 0 ja U koos sellega.</translation>
    </message>
    <message>
        <source>The camera in the world</source>
        <translation>Kaamera maailmas</translation>
    </message>
    <message>
        <source>The camera is at {0}, and has {1}. It is to stand in the origin, with them along {2}.</source>
        <translation>Kaamera on kohal {0} ja sellel on {1}. See peab seisma alguspunktis nii, et need on piki telgi {2}.</translation>
    </message>
    <message>
        <source>x, y and z belong to the world and stand still in the next two steps; u, v and n are the camera&apos;s. Ask for two moves that bring them together, and in which order.</source>
        <translation>x, y ja z kuuluvad maailmale ja seisavad järgmises kahes sammus paigal; u, v ja n on kaamera omad. Küsige kaht liigutust, mis viivad need kokku, ja mis järjekorras.</translation>
    </message>
    <message>
        <source>First P</source>
        <translation>Enne P</translation>
    </message>
    <message>
        <source>{0} moves the eye to the origin, and the whole scene with it. Nothing turns: {1} keep their directions.</source>
        <translation>{0} viib silma alguspunkti ja kogu stseeni koos sellega. Miski ei pöördu: {1} säilitavad oma suunad.</translation>
    </message>
    <message>
        <source>Go on, and watch the camera come to the axes; back on the strip and once more. Nothing changes its shape, and nothing its place against the rest.</source>
        <translation>Minge edasi ja vaadake, kuidas kaamera telgede juurde tuleb; ribal tagasi ja veel kord. Millegi kuju ei muutu ega ka koht ülejäänu suhtes.</translation>
    </message>
    <message>
        <source>Then R</source>
        <translation>Siis R</translation>
    </message>
    <message>
        <source>{0} rotates about the origin, until {1} lie along {2}, the lecture&apos;s {3}.</source>
        <translation>{0} pöörab ümber alguspunkti, kuni {1} on piki telgi {2}, mis loengus on {3}.</translation>
    </message>
    <message>
        <source>The camera looks along {0} now. R is hard to write down; its inverse is easy: the columns of {1} are u, v, n. R is orthogonal, so its inverse is its transpose, and its rows are u, v, n. Unfold the factors of view ← world: rotation and translation.</source>
        <translation>Kaamera vaatab nüüd suunas {0}. R-i on raske kirja panna; selle pöördmaatriksit on kerge: maatriksi {1} veerud on u, v, n. R on ortogonaalne, nii et selle pöördmaatriks on transponeeritud maatriks ja selle read on u, v, n. Voldige lahti maatriksi vaade ← maailm tegurid: pööre ja nihe.</translation>
    </message>
    <message>
        <source>R times P</source>
        <translation>R korda P</translation>
    </message>
    <message>
        <source>{0}, from the world&apos;s system (GKS) to the camera&apos;s (KSK); {1} acts first.</source>
        <translation>{0}, maailma süsteemist (GKS) kaamera omasse (KSK); {1} mõjub esimesena.</translation>
    </message>
    <message>
        <source>{0}, {1}. Which number is in row 3 of {2}&apos;s last column?</source>
        <translation>{0}, {1}. Milline arv on maatriksi {2} viimase veeru reas 3?</translation>
    </message>
    <message>
        <source>−8: the eye&apos;s z with a minus</source>
        <translation>−8: silma z miinusega</translation>
    </message>
    <message>
        <source>8: the eye&apos;s z</source>
        <translation>8: silma z</translation>
    </message>
    <message>
        <source>{0}. {1} acts first, so {2} rotates the translation, too.</source>
        <translation>{0}. {1} mõjub esimesena, nii et {2} pöörab ka nihet.</translation>
    </message>
    <message>
        <source>Multiply it out on the board: the last column is minus the eye along u, v and n. In the other order the last column would be minus the eye. All objects are moved, the camera stands still afterwards; how they lie to each other does not change. GKS is the world&apos;s system, KSK the camera&apos;s.</source>
        <translation>Korrutage see tahvlil läbi: viimane veerg on miinus silm piki telgi u, v ja n. Teises järjekorras oleks viimane veerg miinus silm. Kõiki objekte liigutatakse, kaamera seisab pärast paigal; objektide paiknemine üksteise suhtes ei muutu. GKS on maailma süsteem, KSK kaamera oma.</translation>
    </message>
    <message>
        <source>Why transform at all?</source>
        <translation>Milleks üldse teisendada?</translation>
    </message>
    <message>
        <source>A point behind the camera has {0}. A nearer point has a larger (less negative) z. Here point 1 has −7.5, point 2 has −12, point 3 has 2.</source>
        <translation>Kaamera taga oleval punktil on {0}. Lähemal punktil on suurem (vähem negatiivne) z. Siin on punktil 1 −7.5, punktil 2 −12 ja punktil 3 2.</translation>
    </message>
    <message>
        <source>Three points, and their z in the camera&apos;s system (the Probe panel has them). Which is behind the camera? Which hides which? One comparison each. In the world&apos;s coordinates the same questions need the camera every time. The projection plane is at a right angle to the z axis now, and orthogonal projection is: leave z out. Perspective is one division more.</source>
        <translation>Kolm punkti ja nende z kaamera süsteemis (need on paneelis Sond). Milline on kaamera taga? Milline varjab millist? Kumbki küsimus on üks võrdlus. Maailma koordinaatides vajavad samad küsimused iga kord kaamerat. Projektsiooni tasand on nüüd z-teljega risti ja ortograafiline projektsioon on: jätke z ära. Perspektiiv on üks jagamine lisaks.</translation>
    </message>
    <message>
        <source>The letter F on its grid</source>
        <translation>F-täht oma ruudustikul</translation>
    </message>
    <message>
        <source>Eight cubes on the xz plane, drawn by orthogonal projection: {0}</source>
        <translation>Kaheksa kuupi xz-tasandil, joonistatud ortograafilise projektsiooniga: {0}</translation>
    </message>
    <message>
        <source>This is the exercise&apos;s class Ortho: every line of the grid and every edge of the cubes goes through R P, and z is forgotten. Parallel edges stay parallel: show three of them. Turn Azimuth: the letter turns, nothing grows or shrinks with distance. The exercise wants lines only; here faces are filled, so that what is in front is seen.</source>
        <translation>See on ülesande klass Ortho: iga ruudustiku joon ja iga kuubi serv läheb läbi R P ja z unustatakse. Paralleelsed servad jäävad paralleelseks: näidake kolme neist. Pöörake asimuuti: täht pöördub, miski ei kasva ega kahane kaugusega. Ülesanne tahab ainult jooni; siin on tahud täidetud, et oleks näha, mis on ees.</translation>
    </message>
    <message>
        <source>Round the F</source>
        <translation>Ümber F-i</translation>
    </message>
    <message>
        <source>The camera circles the F. Its height changes smoothly, or in steps.</source>
        <translation>Kaamera tiirleb ümber F-i. Selle kõrgus muutub sujuvalt või astmeti.</translation>
    </message>
    <message>
        <source>Press Play in the tool bar. Open Animation in the dock: let the height of the eye swing, then go in steps, and set the lowest and highest y. In every picture R and P are computed anew from the three vectors; the F itself does not move. Ask what changes in the World pane: only the camera and its frustum.</source>
        <translation>Vajutage tööriistaribal Esita. Avage külgribal Animatsioon: laske silma kõrgusel kõikuda, siis minna astmeti, ning seadke madalaim ja kõrgeim y. Igal pildil arvutatakse R ja P kolmest vektorist uuesti; F ise ei liigu. Küsige, mis muutub paanis Maailm: ainult kaamera ja selle frustum.</translation>
    </message>
    <message>
        <source>Looking level</source>
        <translation>Horisontaalne vaade</translation>
    </message>
    <message>
        <source>{0}: the camera looks level, and uprights stay parallel in the picture.</source>
        <translation>{0}: kaamera vaatab horisontaalselt ja püstservad jäävad pildil paralleelseks.</translation>
    </message>
    <message>
        <source>level</source>
        <translation>horisontaalselt</translation>
    </message>
    <message>
        <source>looking down</source>
        <translation>alla vaadates</translation>
    </message>
    <message>
        <source>In Animation choose Look: level, and play: the eye&apos;s height and the target&apos;s go together. Uprights are upright now, at any height; World shows both cameras. Change it back to the target: they run together. Then open More of the camera and set up to 1, 1, 0: the picture turns, the F does not. Only the direction of V counts, and only the part of it at a right angle to n.</source>
        <translation>Valige jaotises Animatsioon Vaade: horisontaalselt ja esitage: silma ja sihtpunkti kõrgus käivad koos. Püstservad on nüüd püsti, igal kõrgusel; Maailm näitab mõlemat kaamerat. Valige jälle sihtpunkti: need koonduvad. Siis avage Veel kaamerast ja tehke ülesvektoriks 1, 1, 0: pilt pöördub, F mitte. Loeb ainult V suund ja sellestki ainult see osa, mis on n-iga risti.</translation>
    </message>
    <message>
        <source>Perspective</source>
        <translation>Perspektiiv</translation>
    </message>
    <message>
        <source>{0}, by the matrix with {1} in its last row.</source>
        <translation>{0}, maatriksiga, mille viimases reas on {1}.</translation>
    </message>
    <message>
        <source>Two similar triangles with the camera as their corner. z is negative in front, so {0} is positive. The matrix: 1, 1, 1 and −1/d; it makes {1}, and dividing by the last number gives {2}, {3} and {4}. Any multiple of the matrix does the same. Move the plane distance d: the picture on the plane grows with d.</source>
        <translation>Kaks sarnast kolmnurka, mille nurk on kaameras. Ees on z negatiivne, seega on {0} positiivne. Maatriks: 1, 1, 1 ja −1/d; see annab {1}, ja jagamine viimase arvuga annab {2}, {3} ja {4}. Sama teeb maatriksi iga kordne. Muutke tasandi kaugust d: pilt tasandil kasvab koos d-ga.</translation>
    </message>
    <message>
        <source>To the pixels</source>
        <translation>Pikslitesse</translation>
    </message>
    <message>
        <source>Natural coordinates to pixel coordinates: scale, then shift. {0} and {1} are the middle of the picture, 640 and 360; {2} is negative, since rows count downwards. With d = 1 and this lens {3}, and {4}. Check with point 1: view x = 1.5, z = −7.5, so {5}, and {6}. The Probe panel has it in the row image px.</source>
        <translation>Loomulikest koordinaatidest piksli koordinaatidesse: skaleerimine, siis nihe. {0} ja {1} on pildi keskkoht, 640 ja 360; {2} on negatiivne, sest ridu loetakse ülalt alla. Kui d = 1, on selle objektiiviga {3} ja {4}. Kontrollige punktiga 1: vaates x = 1.5, z = −7.5, seega {5} ja {6}. Paneelis Sond on see reas pilt px.</translation>
    </message>
    <message>
        <source>The F in perspective</source>
        <translation>F perspektiivis</translation>
    </message>
    <message>
        <source>These are the same lines, divided by their depth. A larger {0} only enlarges the picture.</source>
        <translation>Need on samad jooned, jagatud oma sügavusega. Suurem {0} ainult suurendab pilti.</translation>
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
        <translation>Kaks pilti samast silmast: teisel on d kaks korda suurem ja kõik on kaks korda suurem. Programmis teeb seda frustumi nurk: {0} 1.73-lt 3.46-le. Miski ei liigu millegi suhtes. Siis lõpetage võrdlus ja muutke Kaugust: nüüd kasvavad lähedased osad kiiremini kui kauged. Kuni kaamera on piisavalt laial ringil, on kõik hästi.</translation>
    </message>
    <message>
        <source>Too close</source>
        <translation>Liiga lähedal</translation>
    </message>
    <message>
        <source>The camera comes nearer to the F, and lines appear that nobody drew.</source>
        <translation>Kaamera tuleb F-ile lähemale ja ilmuvad jooned, mida keegi ei joonistanud.</translation>
    </message>
    <message>
        <source>Change Distance to 8 first: a good picture. Then come nearer, slowly. As soon as an edge of the F reaches behind the camera, lines go astray. It is not the distance of the plane that does it: with d as small as you like the picture is right, as long as all is in front. The World pane shows the plane through the eye, marked z = 0. Which edges cross it?</source>
        <translation>Muutke enne Kauguseks 8: hea pilt. Siis tulge aeglaselt lähemale. Niipea kui mõni F-i serv ulatub kaamera taha, lähevad jooned valesti. Süüdi ei ole tasandi kaugus: kui tahes väikese d-ga on pilt õige, kuni kõik on ees. Paan Maailm näitab tasandit läbi silma, märgiga z = 0. Millised servad seda läbivad?</translation>
    </message>
    <message>
        <source>A line broken at {0}</source>
        <translation>Kohal {0} katkev sirge</translation>
    </message>
    <message>
        <source>The projection takes the point at {0} to infinity, and the line&apos;s point at infinity to a finite point: the image is a line in two pieces.</source>
        <translation>Projektsioon viib kohal {0} oleva punkti lõpmatusse ja sirge lõpmatuspunkti lõplikku punkti: kujutis on kahes tükis sirge.</translation>
    </message>
    <message>
        <source>In the KSK {0}, {1}, and {2}. Which {3} does the image of AB cover?</source>
        <translation>KSK-s on {0}, {1} ja {2}. Milliseid {3} väärtusi katab AB kujutis?</translation>
    </message>
    <message>
        <source>From 0.5 to −0.5, from one image to the other</source>
        <translation>0.5-st −0.5-ni, ühest kujutisest teiseni</translation>
    </message>
    <message>
        <source>From 0.5 to infinity</source>
        <translation>0.5-st lõpmatuseni</translation>
    </message>
    <message>
        <source>{0} grows without bound towards z = 0.</source>
        <translation>{0} kasvab tõkestamatult, kui läheneda kohale z = 0.</translation>
    </message>
    <message>
        <source>AB is straight and goes through the plane z = 0; half of it is behind the camera. Vote, then show: pink the image, orange what the naive program draws; dashed is the piece without an image. In projective geometry the line is a circle, closed by its point at infinity: open Explanation and diagrams for it. Joining A&apos; and B&apos; takes the wrong arc. And the pencil of lines through one point? The F has many parallel edges; their wrong parts all run through the edges&apos; vanishing point. One sentence of the lecture says &quot;plane of projection&quot; where it means z = 0.</source>
        <translation>AB on sirge ja läbib tasandi z = 0; pool sellest on kaamera taga. Hääletage, siis näidake: roosa on kujutis, oranž see, mida joonistab naiivne programm; katkendlik on kujutiseta tükk. Projektiivgeomeetrias on sirge ring, mille sulgeb selle lõpmatuspunkt: avage selleks Selgitus ja diagrammid. A&apos; ja B&apos; ühendamine võtab vale kaare. Ja ühte punkti läbiv sirgete kimp? F-il on palju paralleelseid servi; nende valed osad läbivad kõik servade koondumispunkti. Ühes loengu lauses on „projektsiooni tasand“ seal, kus mõeldud on z = 0.</translation>
    </message>
    <message>
        <source>Four cases</source>
        <translation>Neli juhtumit</translation>
    </message>
    <message>
        <source>If both ends are in front, draw. If both are behind, do not draw. Otherwise cut first.</source>
        <translation>Kui mõlemad otsad on ees, joonistage. Kui mõlemad on taga, ärge joonistage. Muidu lõigake enne.</translation>
    </message>
    <message>
        <source>1 in front</source>
        <translation>1 ees</translation>
    </message>
    <message>
        <source>2 behind</source>
        <translation>2 taga</translation>
    </message>
    <message>
        <source>3 A behind</source>
        <translation>3 A taga</translation>
    </message>
    <message>
        <source>4 B behind</source>
        <translation>4 B taga</translation>
    </message>
    <message>
        <source>It begins as case 1, both ends in front. Drag B behind the plane z = 0: case 4. Drag A behind too: case 2, nothing is drawn. B in front again: case 3. The number below the scene&apos;s controls names the case each time. The program of the exercise must keep the last point in camera coordinates, as {0}, also where nothing was drawn.</source>
        <translation>Alguses on see juhtum 1, mõlemad otsad ees. Lohistage B tasandi z = 0 taha: juhtum 4. Lohistage ka A taha: juhtum 2, midagi ei joonistata. B jälle ette: juhtum 3. Arv stseeni juhtelementide all nimetab iga kord juhtumi. Ülesande programm peab viimast punkti kaamera koordinaatides, {0}, meeles hoidma ka seal, kus midagi ei joonistatud.</translation>
    </message>
    <message>
        <source>Cut at {0}</source>
        <translation>Lõige kohal {0}</translation>
    </message>
    <message>
        <source>{0}, and the point of the line at {1} takes the place of the end behind.</source>
        <translation>{0} ja taga oleva otsa asemele tuleb sirge punkt kohal {1}.</translation>
    </message>
    <message>
        <source>Not at 0, where the divide fails, but a little in front of it. The three pictures: divided without a cut, cut at z = −0.01, clipped. Dashed is the piece of AB without an image. The cut keeps all of AB in front of the plane, and its image runs out of the frame. Clipping keeps what is inside the pyramid, and the image ends at the frame. In Image they hardly differ: what differs is beside the picture, or at most a few pixels; &quot;More numbers&quot; has it as what the cut leaves out. Clipping in homogeneous coordinates needs no such number: it keeps {0} to {1} before the divide. With this the exercise is done: walk into the F.</source>
        <translation>Mitte kohal 0, kus jagada ei saa, vaid natuke selle ees. Kolm pilti: jagatud ilma lõiketa, lõigatud kohal z = −0.01, kärbitud. Katkendlik on AB kujutiseta tükk. Lõige jätab alles kogu AB, mis on tasandi ees, ja selle kujutis jookseb raamist välja. Kärpimine jätab alles selle, mis on püramiidis, ja kujutis lõpeb raamil. Pildil need peaaegu ei erine: erinevus on pildi kõrval või ülimalt mõni piksel; jaotises „Veel arve“ on see kui osa, mille lõige ära jätab. Kärpimine homogeensetes koordinaatides sellist arvu ei vaja: see jätab enne jagamist alles {0} kuni {1}. Sellega on ülesanne lahendatud: kõndige F-i sisse.</translation>
    </message>
</context>
<context>
    <name>tour</name>
    <message>
        <source>Two minutes with a camera</source>
        <translation>Kaks minutit kaameraga</translation>
    </message>
    <message>
        <source>The near plane</source>
        <translation>Lähitasand</translation>
    </message>
    <message>
        <source>In the World pane a camera looks at the letter F. The ochre frame is its near plane.</source>
        <translation>Paanis Maailm vaatab kaamera F-tähte. Ookrivärvi raam on selle lähitasand.</translation>
    </message>
    <message>
        <source>Bring the near plane closer to the camera.</source>
        <translation>Tooge lähitasand kaamerale lähemale.</translation>
    </message>
    <message>
        <source>Drag it in the World pane, by its face, an edge or its name, or move the slider *Near* in the dock to the left.</source>
        <translation>Lohistage seda paanis Maailm tahust, servast või nimest või nihutage külgribal liugurit *Lähitasand* vasakule.</translation>
    </message>
    <message>
        <source>The picture stays as it is; in the NDC cube everything has moved towards far.</source>
        <translation>Pilt jääb samaks; NDC kuubis on kõik liikunud kaugtasandi poole.</translation>
    </message>
    <message>
        <source>From another side</source>
        <translation>Teiselt poolt</translation>
    </message>
    <message>
        <source>You look at camera, frustum and picture from outside. Nothing changes when you walk round them.</source>
        <translation>Vaatate kaamerat, frustumit ja pilti väljastpoolt. Miski ei muutu, kui te nende ümber käite.</translation>
    </message>
    <message>
        <source>Turn the world: drag beside the frustum, or anywhere with the middle button.</source>
        <translation>Pöörake maailma: lohistage frustumi kõrval või keskmise nupuga ükskõik kus.</translation>
    </message>
    <message>
        <source>On the planes a drag moves near or far. With the keyboard: Tab to the World pane, then arrows. The house in its title brings back the first view.</source>
        <translation>Tasanditel nihutab lohistamine lähi- või kaugtasandit. Klaviatuuriga: Tab paanile Maailm, siis nooled. Maja selle pealkirjas toob esimese vaate tagasi.</translation>
    </message>
    <message>
        <source>Only your own view has turned. The image is the camera&apos;s.</source>
        <translation>Pöördunud on ainult teie enda vaade. Pilt on kaamera oma.</translation>
    </message>
    <message>
        <source>The cube</source>
        <translation>Kuup</translation>
    </message>
    <message>
        <source>Everything between near and far is squeezed into one cube, whatever the lens. That is the NDC cube.</source>
        <translation>Kõik, mis on lähi- ja kaugtasandi vahel, surutakse ühte kuupi, olgu objektiiv milline tahes. See on NDC kuup.</translation>
    </message>
    <message>
        <source>Make the cube the large pane.</source>
        <translation>Tehke kuubist suur paan.</translation>
    </message>
    <message>
        <source>Double-click its title, *NDC cube*, or press Ctrl+2.</source>
        <translation>Tehke topeltklõps selle pealkirjal *NDC kuup* või vajutage Ctrl+2.</translation>
    </message>
    <message>
        <source>The small end of the frustum has become the front face.</source>
        <translation>Frustumi väiksemast otsast on saanud esitahk.</translation>
    </message>
    <message>
        <source>On the way there</source>
        <translation>Teel sinna</translation>
    </message>
    <message>
        <source>Each matrix on the way is a stop of the strip below the cube.</source>
        <translation>Iga maatriks sellel teel on peatus kuubi all oleval ribal.</translation>
    </message>
    <message>
        <source>Go back to an earlier stop of the strip, and forwards again if you like.</source>
        <translation>Minge ribal tagasi mõne varasema peatuse juurde ja, kui soovite, jälle edasi.</translation>
    </message>
    <message>
        <source>Drag the strip&apos;s slider to the left, or press *View*, *Pyramid* or *Box*; with the focus on it the arrow keys move it.</source>
        <translation>Lohistage riba liugurit vasakule või vajutage *Vaade*, *Püramiid* või *Risttahukas*; kui fookus on sellel, liigutavad seda nooleklahvid.</translation>
    </message>
    <message>
        <source>Lines stay straight all the way.</source>
        <translation>Sirged jäävad kogu tee sirgeks.</translation>
    </message>
    <message>
        <source>The field of view</source>
        <translation>Frustumi nurk</translation>
    </message>
    <message>
        <source>How much of the world does the picture show?</source>
        <translation>Kui suurt osa maailmast pilt näitab?</translation>
    </message>
    <message>
        <source>Change the field of view.</source>
        <translation>Muutke frustumi nurka.</translation>
    </message>
    <message>
        <source>Move the slider *Field of view* in the dock, or type a number and press Enter.</source>
        <translation>Nihutage külgribal liugurit *Frustumi nurk* või sisestage arv ja vajutage Enter.</translation>
    </message>
    <message>
        <source>The wider the angle, the more of the world you see, and the smaller everything is.</source>
        <translation>Mida laiem nurk, seda rohkem maailma te näete ja seda väiksem on kõik.</translation>
    </message>
    <message>
        <source>Another lens</source>
        <translation>Teine objektiiv</translation>
    </message>
    <message>
        <source>The rays of a parallel lens do not meet in an eye: what is far away is drawn as large as what is near.</source>
        <translation>Paralleelse objektiivi kiired ei kohtu silmas: kauge joonistatakse sama suurena kui lähedane.</translation>
    </message>
    <message>
        <source>Choose the orthographic lens.</source>
        <translation>Valige ortograafiline objektiiv.</translation>
    </message>
    <message>
        <source>*Lens*, in the dock, is a list: choose *orthographic* in it. From the keyboard press Tab until it has the focus, then Down until it is *orthographic*.</source>
        <translation>*Objektiiv* külgribal on loend: valige sellest *ortograafiline*. Klaviatuuril vajutage Tab, kuni fookus on sellel, siis allanoolt, kuni see on *ortograafiline*.</translation>
    </message>
    <message>
        <source>The frustum is a box. The list at the top left has a scene for each topic of the lectures.</source>
        <translation>Frustum on risttahukas. Üleval vasakul olevas loendis on stseen loengute iga teema jaoks.</translation>
    </message>
</context>
</TS>
