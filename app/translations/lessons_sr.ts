<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="sr" sourcelanguage="en">
<context>
    <name>ideas</name>
    <message>
        <source>Wrong ideas, and what refutes them</source>
        <translation>Погрешне представе, и шта их побија</translation>
    </message>
    <message>
        <source>n is where I look</source>
        <translation>n је куда гледам</translation>
    </message>
    <message>
        <source>This takes the direction of view for {0}. The camera looks along {1}: {2} runs from the target back to the eye, so that with {3} to the right and {4} up the three axes are right-handed.</source>
        <translation>Овде је смер погледа узет за {0}. Камера гледа дуж {1}: {2} иде од циља назад ка позицији камере, тако да са {3} удесно и {4} нагоре три осе чине десни систем.</translation>
    </message>
    <message>
        <source>My up vector is v</source>
        <translation>Мој вектор нагоре је v</translation>
    </message>
    <message>
        <source>This takes the normalised up vector for {0}. Up only has to point roughly upwards; {1} is at a right angle to the view direction, so the more the camera looks down, the farther {2} tilts away from up.</source>
        <translation>Овде је нормирани вектор нагоре узет за {0}. Он треба само приближно да показује нагоре; {1} је под правим углом према смеру погледа, па што камера више гледа надоле, то се {2} више нагиње од вектора нагоре.</translation>
    </message>
    <message>
        <source>Unit times unit is a unit</source>
        <translation>Јединични пута јединични је јединични</translation>
    </message>
    <message>
        <source>This does not normalise the cross product of up and {0}, because both are unit vectors. But its length is the sine of the angle between them, so {1} is the product divided by that length; otherwise everything measured along {2} is too short.</source>
        <translation>Овде векторски производ вектора нагоре и {0} није нормиран, јер су оба вектора јединична. Али његова дужина је синус угла између њих, па је {1} производ подељен том дужином; иначе је све што се мери дуж {2} прекратко.</translation>
    </message>
    <message>
        <source>The view matrix puts the camera in its place</source>
        <translation>Матрица погледа ставља камеру на њено место</translation>
    </message>
    <message>
        <source>This writes down the inverse of the view matrix, which moves a camera from the origin to its place. The view matrix does the opposite: it moves the world until the eye is at the origin, so its last column is minus the eye along {0}, {1} and {2}, not the eye.</source>
        <translation>Овде је написан инверз матрице погледа, који камеру из координатног почетка помера на њено место. Матрица погледа чини супротно: помера свет док позиција камере не буде у координатном почетку, па је њена последња колона минус позиција камере дуж {0}, {1} и {2}, а не позиција камере.</translation>
    </message>
    <message>
        <source>Rows and columns may change places</source>
        <translation>Врсте и колоне могу да замене места</translation>
    </message>
    <message>
        <source>This reads the matrix with rows and columns exchanged. Points are columns here, {0}, so a cell {1} says how much of coordinate {2} goes into coordinate {3}, and the axes are the columns.</source>
        <translation>Овде се матрица чита са замењеним врстама и колонама. Тачке су овде колоне, {0}, па поље {1} каже колико координате {2} улази у координату {3}, а осе су колоне.</translation>
    </message>
    <message>
        <source>The order does not matter</source>
        <translation>Редослед није важан</translation>
    </message>
    <message>
        <source>This multiplies the factors in the opposite order. The factor on the right acts first. First rotating and then moving differs from first moving and then rotating, because the later rotation rotates the move as well.</source>
        <translation>Овде се чиниоци множе обрнутим редом. Десни чинилац делује први. Прво ротирати, па померити није исто што и прво померити, па ротирати, јер каснија ротација ротира и помак.</translation>
    </message>
    <message>
        <source>The function takes my degrees</source>
        <translation>Функција прима моје степене</translation>
    </message>
    <message>
        <source>This passes degrees to a function that expects radians. 60 degrees are {0} radians; 60 radians are nine and a half turns, so the result can be anything, even of the opposite sign, and the picture upside down.</source>
        <translation>Овде се степени предају функцији која очекује радијане. 60 степени је {0} радијана; 60 радијана је девет и по кругова, па резултат може бити било шта, чак и супротног предзнака, а слика наопачке.</translation>
    </message>
    <message>
        <source>The lens takes the whole angle</source>
        <translation>Објектив прима цео угао</translation>
    </message>
    <message>
        <source>This takes the tangent or cotangent of the whole field of view. The right-angled triangle lies between the axis and the edge of the picture and contains half of the angle: at 90° the lens has {0}, whereas {1} is 0.</source>
        <translation>Овде је узет тангенс или котангенс целог видног поља. Правоугли троугао лежи између осе и ивице слике и садржи половину угла: на 90° објектив има {0}, док је {1} једнако 0.</translation>
    </message>
    <message>
        <source>Twice the angle is twice the width</source>
        <translation>Двоструки угао је двострука ширина</translation>
    </message>
    <message>
        <source>This assumes that widths are proportional to angles. They are proportional to the tangent of half the angle: with 120° high and 16:9 that tangent is 1.73 upwards and 3.08 sideways, so the picture is 144.0° wide: 72.0° on each side, not 213°, which no picture can be.</source>
        <translation>Овде се претпоставља да су ширине сразмерне угловима. Оне су сразмерне тангенсу половине угла: са 120° у висину и 16:9 тај тангенс је 1.73 нагоре и 3.08 у страну, па је слика широка 144.0°: 72.0° на сваку страну, а не 213°, колико ниједна слика не може бити.</translation>
    </message>
    <message>
        <source>An angle is an angle</source>
        <translation>Угао је угао</translation>
    </message>
    <message>
        <source>This uses the vertical angle in place of the horizontal one. A picture that is wider than high reaches farther sideways than upwards, as width to height, and so does the tangent of half the angle; only then do circles stay round.</source>
        <translation>Овде је вертикални угао узет уместо хоризонталног. Слика шира него виша досеже у страну даље него нагоре, као ширина према висини, па тако и тангенс половине угла; само тада кругови остају округли.</translation>
    </message>
    <message>
        <source>I measure from the picture plane</source>
        <translation>Мерим од равни слике</translation>
    </message>
    <message>
        <source>This divides by the distance from the plane, {0}. The two similar triangles share the corner at the eye, so measure both depths from the eye: {1}.</source>
        <translation>Овде се дели растојањем од равни, {0}. Два слична троугла деле теме код камере, па обе дубине мерите одатле: {1}.</translation>
    </message>
    <message>
        <source>Dividing by z is enough</source>
        <translation>Довољно је делити са z</translation>
    </message>
    <message>
        <source>This has the sign for the wrong side of the eye: in front of it {0} is negative, and {1} is the result for a film *behind* the hole. A plane in front of the eye has {2} and an upright image; only a film behind it, at {3}, has it upside down.</source>
        <translation>Овде је предзнак за погрешну страну камере: испред ње је {0} негативно, а {1} је резултат за филм *иза* рупе. Раван испред камере има {2} и усправну слику; само филм иза ње, на {3}, има је наопачке.</translation>
    </message>
    <message>
        <source>Near enlarges</source>
        <translation>Предња раван увећава</translation>
    </message>
    <message>
        <source>This multiplies the picture by {0}. The image on the near plane does grow with {1}, but so does the window round it. {2} does not contain {3}: near only decides what is cut.</source>
        <translation>Овде се слика множи са {0}. Слика на предњој равни заиста расте са {1}, али расте и прозор око ње. {2} не садржи {3}: предња раван одлучује само о томе шта се одсеца.</translation>
    </message>
    <message>
        <source>near 1</source>
        <translation>предња раван 1</translation>
    </message>
    <message>
        <source>near 2</source>
        <translation>предња раван 2</translation>
    </message>
    <message>
        <source>Near is a z, so it is negative</source>
        <translation>Предња раван је z, дакле негативна</translation>
    </message>
    <message>
        <source>This uses a negative number where a length belongs. Near, far and the distance of a picture plane are lengths from the eye, and positive; the planes are at negative {0}, and the formulas already contain that minus.</source>
        <translation>Овде је негативан број употребљен тамо где треба дужина. Предња раван, задња раван и растојање равни слике су дужине од камере, и позитивне; равни су на негативном {0}, а формуле тај минус већ садрже.</translation>
    </message>
    <message>
        <source>n and f may change places</source>
        <translation>n и f могу да замене места</translation>
    </message>
    <message>
        <source>This swaps {0} and {1}, which changes the sign of {2} and of everything divided by it. The near plane would then be at {3}, where the far plane belongs, and all depths would run backwards.</source>
        <translation>Овде су {0} и {1} замењени, што мења предзнак за {2} и за све што се тиме дели. Предња раван би тада била у {3}, где припада задња, и све дубине би ишле уназад.</translation>
    </message>
    <message>
        <source>A window to the right moves the picture right</source>
        <translation>Прозор удесно помера слику удесно</translation>
    </message>
    <message>
        <source>This shifts the picture to the same side as the window. The window frames what you see: if its middle is right of the axis, the axis appears left of the picture&apos;s middle, at {0}. The matrix has a plus there because that cell is multiplied by {1}, which is negative.</source>
        <translation>Овде се слика помера на исту страну као прозор. Прозор уоквирује оно што видите: ако је његова средина десно од осе, оса се појављује лево од средине слике, у {0}. У матрици је тамо плус јер се то поље множи са {1}, што је негативно.</translation>
    </message>
    <message>
        <source>Cameras turn as eyes do</source>
        <translation>Камере се окрећу као очи</translation>
    </message>
    <message>
        <source>This toes the two cameras in, because eyes turn to what they look at. But each turned camera divides by the depth along its own axis, so points at the sides are not equally high in both pictures, and no pair of eyes can look up with one eye and down with the other: both cameras look straight ahead, and their windows move.</source>
        <translation>Овде су две камере закренуте ка средини, јер се очи окрећу ка ономе што гледају. Али свака окренута камера дели дубином дуж сопствене осе, па тачке са стране нису на обе слике на истој висини, а ниједан пар очију не може једним оком да гледа нагоре, а другим надоле: обе камере гледају право напред, а померају се њихови прозори.</translation>
    </message>
    <message>
        <source>Far is always small</source>
        <translation>Далеко је увек мало</translation>
    </message>
    <message>
        <source>This divides by the depth, although the projectors are parallel. A parallel lens divides every point by 1, so equal heights stay equal at every depth.</source>
        <translation>Овде се дели дубином, иако су зраци пројекције паралелни. Паралелни објектив сваку тачку дели са 1, па једнаке висине остају једнаке на свакој дубини.</translation>
    </message>
    <message>
        <source>Clip is NDC</source>
        <translation>Одсецање је NDC</translation>
    </message>
    <message>
        <source>This stops at the clip coordinates. The division by {0} is still to come, {1} and {2}; it makes far things small.</source>
        <translation>Овде се стало код координата одсецања. Дељење са {0} тек следи, {1} и {2}; оно чини далеке ствари малим.</translation>
    </message>
    <message>
        <source>z needs no divide</source>
        <translation>z не треба делити</translation>
    </message>
    <message>
        <source>This stops before the division. The depth is divided by {0} like {1} and {2}: only then does far come to 1, and only then do straight lines stay straight.</source>
        <translation>Овде се стало пре дељења. Дубина се дели са {0} као {1} и {2}: само тако задња раван долази у 1, и само тако праве остају праве.</translation>
    </message>
    <message>
        <source>Depth is the distance to the eye</source>
        <translation>Дубина је растојање до камере</translation>
    </message>
    <message>
        <source>This measures straight from the eye to the point. Depth is measured along the axis only, because near and far are planes, not spheres: a point at the side is farther away than it is deep.</source>
        <translation>Овде се мери право од камере до тачке. Дубина се мери само дуж осе, јер су предња и задња раван равни, а не сфере: тачка са стране је даља него што је дубока.</translation>
    </message>
    <message>
        <source>Depth runs evenly</source>
        <translation>Дубина тече равномерно</translation>
    </message>
    <message>
        <source>This spreads the depth evenly between near and far. But {0} changes with one over the depth, so the cube is filled fast at first: its middle is less than twice as deep as near.</source>
        <translation>Овде је дубина равномерно распоређена између предње и задње равни. Али {0} се мења са реципрочном вредношћу дубине, па се коцка у почетку брзо пуни: њена средина је на мање од двоструке дубине предње равни.</translation>
    </message>
    <message>
        <source>Near stays where it is in the pyramid</source>
        <translation>Предња раван у пирамиди остаје где јесте</translation>
    </message>
    <message>
        <source>This leaves the near plane at {0}. On the way into the canonical pyramid everything is divided by {1}, so far comes to {2} and near to {3}.</source>
        <translation>Овде је предња раван остављена на {0}. На путу у стандардну пирамиду све се дели са {1}, па задња раван долази у {2}, а предња у {3}.</translation>
    </message>
    <message>
        <source>NDC starts at 0</source>
        <translation>NDC почиње од 0</translation>
    </message>
    <message>
        <source>This takes an NDC coordinate for a share from 0 to 1. It runs from {0} to {1} with 0 in the middle, so first add 1 and then halve: {2} and depth {3}.</source>
        <translation>Овде је NDC координата узета за део од 0 до 1. Она иде од {0} до {1}, са 0 у средини, па прво додајте 1, а онда преполовите: {2} и дубина {3}.</translation>
    </message>
    <message>
        <source>Pixel rows count up</source>
        <translation>Редови пиксела броје се нагоре</translation>
    </message>
    <message>
        <source>This counts the rows of pixels upwards, like {0}. The image begins at its upper left corner and its rows count downwards: the higher a point is, the smaller is its row.</source>
        <translation>Овде се редови пиксела броје нагоре, као {0}. Слика почиње у горњем левом углу, а њени редови се броје надоле: што је тачка виша, то је њен ред мањи.</translation>
    </message>
    <message>
        <source>Pixel 100 is at 100</source>
        <translation>Пиксел 100 је на 100</translation>
    </message>
    <message>
        <source>This takes a pixel&apos;s number for the position of its centre. Pixel {0} reaches from {1} to {2}, so its centre is at {3}, so {4}: the outer centres of four pixels are at {5}, not at {6}.</source>
        <translation>Овде је број пиксела узет за положај његовог средишта. Пиксел {0} досеже од {1} до {2}, па му је средиште у {3}, дакле {4}: крајња средишта четири пиксела су у {5}, а не у {6}.</translation>
    </message>
    <message>
        <source>k makes up the difference</source>
        <translation>k надокнађује разлику</translation>
    </message>
    <message>
        <source>This adds the whole missing length at one end and again at the other. Both ends get the same share, so each gets half of what is missing.</source>
        <translation>Овде се цела дужина која недостаје додаје на једном крају, па још једном на другом. Оба краја добијају једнак део, дакле сваки половину онога што недостаје.</translation>
    </message>
    <message>
        <source>stretched</source>
        <translation>растегнуто</translation>
    </message>
    <message>
        <source>variant X</source>
        <translation>варијанта X</translation>
    </message>
    <message>
        <source>X adjusts x</source>
        <translation>X прилагођава x</translation>
    </message>
    <message>
        <source>This takes the letter for the coordinate that changes. Variant X *keeps* {0} and {1} and adjusts {2} until the window has the picture&apos;s proportions; variant Y keeps {3} and adjusts {4}.</source>
        <translation>Овде је слово узето за координату која се мења. Варијанта X *задржава* {0} и {1}, а прилагођава {2} док прозор не добије пропорције слике; варијанта Y задржава {3}, а прилагођава {4}.</translation>
    </message>
    <message>
        <source>variant Y</source>
        <translation>варијанта Y</translation>
    </message>
    <message>
        <source>The slant grows with alpha</source>
        <translation>Косина расте са углом алфа</translation>
    </message>
    <message>
        <source>This takes {0} for the slant. {1} is the angle between the projectors and the picture, so at 90° they meet it head-on and nothing is shifted. The formula is {2}; at 80° the shift is only 0.18 for each unit of depth.</source>
        <translation>Овде је {0} узето за косину. {1} је угао између зрака пројекције и слике, па је на 90° они секу под правим углом и ништа се не помера. Формула је {2}; на 80° помак је само 0.18 за сваку јединицу дубине.</translation>
    </message>
    <message>
        <source>Half the scale, half the slant</source>
        <translation>Половина размере, половина косине</translation>
    </message>
    <message>
        <source>This assumes that the angle is proportional to the scale. The scale is the cotangent of the angle, {0}, so a cabinet drawing with {1} has {2}, not 67.5°.</source>
        <translation>Овде се претпоставља да је угао сразмеран размери. Размера је котангенс угла, {0}, па цртеж кабинет са {1} има {2}, а не 67.5°.</translation>
    </message>
    <message>
        <source>Infinity is very far</source>
        <translation>Бесконачно је врло далеко</translation>
    </message>
    <message>
        <source>This takes a point that is very far away for the point at infinity. A direction has {0} and no starting point, so its image depends on the direction alone, {1}; every point on the way there falls short of it.</source>
        <translation>Овде је тачка која је врло далеко узета за бесконачно далеку тачку. Смер има {0} и нема почетну тачку, па његова слика зависи само од смера, {1}; свака тачка на путу до тамо не стиже до ње.</translation>
    </message>
    <message>
        <source>A box has three</source>
        <translation>Кутија их има три</translation>
    </message>
    <message>
        <source>This counts the directions of the box. Only a direction that is not parallel to the picture has a vanishing point, {0}; edges that are parallel to the picture stay parallel in it.</source>
        <translation>Овде су пребројани смерови кутије. Тачку недогледа има само смер који није паралелан слици, {0}; ивице паралелне слици остају на њој паралелне.</translation>
    </message>
    <message>
        <source>Join the two images</source>
        <translation>Спојите две слике</translation>
    </message>
    <message>
        <source>This divides both ends and joins the results. An end behind the eye has {0}, and its image is mirrored. The right image of the segment runs through infinity, not between the two, so cut the segment in front of the eye before dividing.</source>
        <translation>Овде се оба краја поделе, па се резултати споје. Крај иза камере има {0}, и његова слика је као у огледалу. Исправна слика дужи пролази кроз бесконачност, а не између њих двеју, па исеците дуж испред камере пре дељења.</translation>
    </message>
    <message>
        <source>The middle of the picture is the middle of the edge</source>
        <translation>Средина слике је средина ивице</translation>
    </message>
    <message>
        <source>This interpolates {0} itself on the screen. There {1} and {2} are linear, so {3}, and the middle of the picture shows a place that is closer to the nearer end.</source>
        <translation>Овде се на екрану интерполира сама величина {0}. Тамо су линеарни {1} и {2}, па је {3}, и средина слике показује место ближе ближем крају.</translation>
    </message>
    <message>
        <source>A lamp is a sun</source>
        <translation>Лампа је сунце</translation>
    </message>
    <message>
        <source>This takes the lamp&apos;s position for a direction that all rays share. From a lamp each ray has its own direction, {0}, and meets the ground at {1}; only the sun is so far away that all rays are parallel.</source>
        <translation>Овде је положај лампе узет за смер заједнички свим зрацима. Од лампе сваки зрак има свој смер, {0}, и сече тло у {1}; само је сунце толико далеко да су сви зраци паралелни.</translation>
    </message>
    <message>
        <source>As sharp behind as before</source>
        <translation>Иза је оштро колико и испред</translation>
    </message>
    <message>
        <source>This puts the far limit as far behind the focus as the near limit is in front of it. The limits are {0} and {1}. Their reciprocals are equally far from {2}, so the sharp range reaches farther behind than in front, and it has no end from {3} on.</source>
        <translation>Овде је даља граница стављена иза фокуса једнако далеко као ближа испред њега. Границе су {0} и {1}. Њихове реципрочне вредности једнако су далеко од {2}, па оштри опсег иза фокуса досеже даље него испред, а од {3} надаље нема краја.</translation>
    </message>
    <message>
        <source>Zooming is walking</source>
        <translation>Зумирање је ходање</translation>
    </message>
    <message>
        <source>This keeps the size ratio of the old place after a walk. A zoom enlarges the whole picture by one factor, but sizes are proportional to one over the distance. Walking therefore changes {0}, the size ratio of a thing and an equal one {1} behind it.</source>
        <translation>Овде је после ходања задржан однос величина са старог места. Зум целу слику увећава једним чиниоцем, а величине су сразмерне реципрочној вредности растојања. Зато ходање мења {0}, однос величина предмета и једнаког предмета {1} иза њега.</translation>
    </message>
    <message>
        <source>More places than pixels are enough</source>
        <translation>Довољно је више места него пиксела</translation>
    </message>
    <message>
        <source>This counts the places of a coordinate against the pixels of a picture. The places are spread over the whole scene, {0} apart, and a picture may show a small part of it: there the gap between two of 65 536 places can be wider than a pixel.</source>
        <translation>Овде се места једне координате броје према пикселима слике. Места су распоређена по целој сцени, на размаку {0}, а слика може показивати мали њен део: тамо размак између два од 65 536 места може бити шири од пиксела.</translation>
    </message>
    <message>
        <source>Seven digits, so seven are right</source>
        <translation>Седам цифара, дакле седам тачних</translation>
    </message>
    <message>
        <source>This takes the digits of a coordinate for those of the picture. A float32 keeps 24 bits of the whole number; when eye and vertex, both near 1 000 000, are subtracted, the leading digits go and the rounding stays, so two or three digits are left.</source>
        <translation>Овде су цифре координате узете за цифре слике. float32 чува 24 бита целог броја; када се позиција камере и теме, обоје око 1 000 000, одузму, водеће цифре нестану, а заокруживање остаје, па остају две или три цифре.</translation>
    </message>
    <message>
        <source>An error is the same everywhere</source>
        <translation>Грешка је свуда иста</translation>
    </message>
    <message>
        <source>This takes the error in the scene for the error in the picture. A vertex is stored wrong by a fixed length, but a length is drawn with {0} pixels a unit: twice as near, every error is twice as large.</source>
        <translation>Овде је грешка у сцени узета за грешку на слици. Теме је погрешно сачувано за сталну дужину, али дужина се црта са {0} пиксела по јединици: двапут ближе, свака грешка је двапут већа.</translation>
    </message>
    <message>
        <source>Seven digits, so 360 steps keep five</source>
        <translation>Седам цифара, дакле 360 корака задржи пет</translation>
    </message>
    <message>
        <source>This takes the digits of the format for those of the result. How much a step loses depends on what it does: with a fast inverse square root each renormalising is off by 0.17 %, and after one round two digits are left, in float32 and in float64.</source>
        <translation>Овде су цифре формата узете за цифре резултата. Колико корак губи, зависи од тога шта чини: са брзим инверзним кореном свако поновно нормирање греши за 0.17 %, и после једног круга остају две цифре, у float32 и у float64.</translation>
    </message>
    <message>
        <source>Renormalising repairs the direction</source>
        <translation>Поновно нормирање поправља смер</translation>
    </message>
    <message>
        <source>This expects of axes that are made orthonormal again that they point where they should. Renormalising knows the lengths, 1, and the angles between the axes, 90°. It does not know where the camera should look, so the drift of the direction stays.</source>
        <translation>Овде се од поново ортонормираних оса очекује да показују куда треба. Поновно нормирање познаје дужине, 1, и углове између оса, 90°. Не зна куда камера треба да гледа, па заношење смера остаје.</translation>
    </message>
    <message>
        <source>Logarithmic depth is always better</source>
        <translation>Логаритамска дубина је увек боља</translation>
    </message>
    <message>
        <source>This takes a better spread of digits for a better depth. A logarithm at each pixel is right everywhere; at the vertices it is interpolated linearly on the screen, where only {0} is linear. A piece whose far end is {1} times as far as its near end is drawn up to {2} times too far.</source>
        <translation>Овде је бољи распоред цифара узет за бољу дубину. Логаритам у сваком пикселу је свуда тачан; у теменима се он на екрану интерполира линеарно, а тамо је линеарно само {0}. Део чији је даљи крај {1} пута даље од ближег црта се и до {2} пута предалеко.</translation>
    </message>
    <message>
        <source>Fine enough is equal</source>
        <translation>Довољно фино је једнако</translation>
    </message>
    <message>
        <source>This takes a small error for none. Two grids put the same vertex at two places, however many bits they have: more bits make the gap narrower, and from near enough it is seen again. Only a common grid rounds both copies alike.</source>
        <translation>Овде је мала грешка узета за никакву. Две решетке стављају исто теме на два места, ма колико битова имале: више битова сужава процеп, а довољно изблиза он се опет види. Само заједничка решетка обе копије заокружује једнако.</translation>
    </message>
    <message>
        <source>The inverse undoes exactly</source>
        <translation>Инверз тачно поништава</translation>
    </message>
    <message>
        <source>This takes the inverse on paper for the one in the computer. Its cells are rounded, and so is each product. Far from the origin the eye&apos;s coordinates are large, and the inverse multiplies them with a small difference of rounded numbers: float32 misses a point by per cent of its distance.</source>
        <translation>Овде је инверз на папиру узет за онај у рачунару. Његова поља су заокружена, а тако и сваки производ. Далеко од координатног почетка координате позиције камере су велике, а инверз их множи малом разликом заокружених бројева: float32 промашује тачку за проценте њеног растојања.</translation>
    </message>
    <message>
        <source>First the move, then the turn</source>
        <translation>Прво помак, па окретање</translation>
    </message>
    <message>
        <source>This moves first and then turns. A rotation turns about the world&apos;s origin, so it carries the moved object along a circle: {0} turns it in its place, {1} swings it round.</source>
        <translation>Овде се прво помера, па окреће. Ротација окреће око координатног почетка света, па померени објекат носи по кружници: {0} га окреће на месту, а {1} га води у луку.</translation>
    </message>
    <message>
        <source>A scale leaves the move alone</source>
        <translation>Скалирање не дира помак</translation>
    </message>
    <message>
        <source>This moves first and then scales. A scale is about the world&apos;s origin, so it multiplies the move, too: with a factor of 2 a move by 3 ends at 6.</source>
        <translation>Овде се прво помера, па скалира. Скалира се од координатног почетка света, па се множи и помак: са чиниоцем 2 помак за 3 завршава у 6.</translation>
    </message>
    <message>
        <source>The mirror stands beside the object</source>
        <translation>Огледало стоји поред објекта</translation>
    </message>
    <message>
        <source>This moves first and then mirrors. The mirror is a plane through the world&apos;s origin, so it takes a move by 3 to the other side, to {0}.</source>
        <translation>Овде прво делује помак, па рефлексија. Огледало је раван кроз координатни почетак света, па помак за 3 преноси на другу страну, у {0}.</translation>
    </message>
    <message>
        <source>Scale and turn may change places</source>
        <translation>Скалирање и окретање могу да замене места</translation>
    </message>
    <message>
        <source>This turns first and then scales along the world&apos;s axes. With unequal factors the turned object loses its right angles. Scaled first, along its own axes, and then turned, it keeps them.</source>
        <translation>Овде се прво окреће, па скалира дуж оса света. Са неједнаким чиниоцима окренути објекат губи праве углове. Ако се прво скалира, дуж сопствених оса, па онда окрене, он их задржава.</translation>
    </message>
    <message>
        <source>Mirror and turn may change places</source>
        <translation>Рефлексија и окретање могу да замене места</translation>
    </message>
    <message>
        <source>This turns first and then mirrors. A mirror reverses the turns that were made before it, so the mirrored object is turned by minus the angle.</source>
        <translation>Овде прво делује окретање, па рефлексија. Она обрће смер окретања која су извршена пре ње, па је рефлектовани објекат окренут за минус тај угао.</translation>
    </message>
    <message>
        <source>Shear and turn may change places</source>
        <translation>Смицање и окретање могу да замене места</translation>
    </message>
    <message>
        <source>This turns first and then shears along the world&apos;s axes. Sheared first, the object has its slant along its own axes, and takes it along when it turns.</source>
        <translation>Овде се прво окреће, па смиче дуж оса света. Ако се прво смиче, косина објекта је дуж његових сопствених оса, и он је при окретању носи са собом.</translation>
    </message>
    <message>
        <source>Turns about two axes may change places</source>
        <translation>Окретања око двеју оса могу да замене места</translation>
    </message>
    <message>
        <source>This exchanges two rotations about different axes. Read from the right, each turns about an axis of the world, which stays fixed. Read from the left, each turns about an axis that the turns before have moved.</source>
        <translation>Овде су замењене две ротације око различитих оса. Читано здесна, свака окреће око осе света, која стоји на месту. Читано слева, свака окреће око осе коју су ранија окретања померила.</translation>
    </message>
    <message>
        <source>The camera turns before it moves</source>
        <translation>Камера се окреће пре него што се помери</translation>
    </message>
    <message>
        <source>This rotates before the eye is at the origin. The view matrix first moves the eye to the origin and then rotates about it, so the translation stands on the right of the rotation.</source>
        <translation>Овде се ротира пре него што је позиција камере у координатном почетку. Матрица погледа прво помера позицију камере у координатни почетак, а затим ротира око њега; зато транслација стоји десно од ротације.</translation>
    </message>
    <message>
        <source>The view comes before the object</source>
        <translation>Матрица погледа долази пре објекта</translation>
    </message>
    <message>
        <source>This puts the view matrix on the right of the object&apos;s moves. A point starts in object space: the object&apos;s matrix takes it to the world, and only then the view matrix takes it to the camera.</source>
        <translation>Овде је матрица погледа стављена десно од покрета објекта. Тачка полази из координатног система објекта: матрица објекта је преводи у свет, и тек онда је матрица погледа преводи у систем камере.</translation>
    </message>
    <message>
        <source>Project first, then look</source>
        <translation>Прво пројектовати, па гледати</translation>
    </message>
    <message>
        <source>This projects before the points are in camera space. The lens makes {0} of {1}, which is the depth only in camera space. Of a point of the world it takes the world&apos;s {2}, and {3} is no longer the depth.</source>
        <translation>Овде се пројектује пре него што су тачке у координатном систему камере. Објектив прави {0} од {1}, а то је дубина само у систему камере. Од тачке света он узима {2} у свету, и {3} више није дубина.</translation>
    </message>
    <message>
        <source>The depths are stretched first</source>
        <translation>Прво се растежу дубине</translation>
    </message>
    <message>
        <source>This puts {0} on the right of {1}. {2} stretches depths that run from 0 to {3}, and only {4} makes such depths.</source>
        <translation>Овде је {0} стављена десно од {1}. {2} растеже дубине које иду од 0 до {3}, а такве дубине прави само {4}.</translation>
    </message>
    <message>
        <source>The box needs no pyramid</source>
        <translation>Квадру не треба пирамида</translation>
    </message>
    <message>
        <source>This puts {0} on the right of {1}. {2} needs the canonical pyramid, with far at {3} and sides at {4}, and only {5} makes it.</source>
        <translation>Овде је {0} стављена десно од {1}. {2} тражи стандардну пирамиду, са задњом равни на {3} и странама на {4}, а њу прави само {5}.</translation>
    </message>
    <message>
        <source>Pixels before the divide</source>
        <translation>Пиксели пре дељења</translation>
    </message>
    <message>
        <source>This counts pixels before the division by {0}. The viewport needs {1} and {2} from {3} to 1, and only the division makes them: its shift to the middle of the picture would be divided, too.</source>
        <translation>Овде се пиксели броје пре дељења са {0}. Области приказа требају {1} и {2} од {3} до 1, а њих прави само дељење: иначе би се делио и њен помак у средину слике.</translation>
    </message>
    <message>
        <source>The divide is done twice</source>
        <translation>Дели се двапут</translation>
    </message>
    <message>
        <source>This divides {0}, {1} and {2} by {3} and keeps {4}, so the next division divides them again. Once divided, a point has {5}, and dividing by that changes nothing.</source>
        <translation>Овде се {0}, {1} и {2} деле са {3}, а {4} се задржава, па их следеће дељење дели још једном. Једном подељена тачка има {5}, и дељење тиме не мења ништа.</translation>
    </message>
    <message>
        <source>Clockwise is positive</source>
        <translation>У смеру казаљке на сату је позитивно</translation>
    </message>
    <message>
        <source>This turns by minus the angle. An angle is positive anticlockwise, seen from the tip of its axis: about z it turns x towards y.</source>
        <translation>Овде се окреће за минус тај угао. Угао је позитиван супротно од казаљке на сату, гледано са врха своје осе: око z он окреће x ка y.</translation>
    </message>
    <message>
        <source>Moves have the other sign</source>
        <translation>Помаци имају супротан предзнак</translation>
    </message>
    <message>
        <source>This moves by minus the numbers. A translation adds its numbers to the coordinates. The view matrix subtracts the eye, because it moves the world and not the camera.</source>
        <translation>Овде се помера за минус те бројеве. Транслација своје бројеве додаје координатама. Матрица погледа одузима позицију камере јер помера свет, а не камеру.</translation>
    </message>
    <message>
        <source>A scale divides</source>
        <translation>Скалирање дели</translation>
    </message>
    <message>
        <source>This divides by the factors of the scale. A factor of 2 makes the object twice as large; one half undoes that.</source>
        <translation>Овде се дели чиниоцима скалирања. Чинилац 2 чини објекат двапут већим; једна половина то поништава.</translation>
    </message>
    <message>
        <source>Any axis will do</source>
        <translation>Може било која оса</translation>
    </message>
    <message>
        <source>This turns about another axis. What lies on the axis of a rotation stays where it is: a turn about z changes x and y, and keeps z.</source>
        <translation>Овде се окреће око друге осе. Што лежи на оси ротације, остаје где јесте: окретање око z мења x и y, а задржава z.</translation>
    </message>
    <message>
        <source>The camera&apos;s axes are columns of R</source>
        <translation>Осе камере су колоне матрице R</translation>
    </message>
    <message>
        <source>This writes {0}, {1} and {2} into the columns of the rotation. That rotation places a camera. The view matrix needs its inverse, which is the transpose, so the axes are its rows.</source>
        <translation>Овде су {0}, {1} и {2} уписани у колоне ротације. Та ротација поставља камеру. Матрици погледа треба њен инверз, а то је транспонована матрица, па су осе њене врсте.</translation>
    </message>
    <message>
        <source>The move stands in the last row</source>
        <translation>Помак стоји у последњој врсти</translation>
    </message>
    <message>
        <source>This is a translation for row vectors. Here points are columns, {0}, so the move is the last column. In the last row its numbers would change {1}.</source>
        <translation>Ово је транслација за векторе врсте. Тачке су овде колоне, {0}, па је помак последња колона. У последњој врсти његови бројеви би мењали {1}.</translation>
    </message>
    <message>
        <source>One factor is enough</source>
        <translation>Довољан је један чинилац</translation>
    </message>
    <message>
        <source>This leaves a factor out. Each factor hands its points to the one on its left, and without it they arrive unchanged.</source>
        <translation>Овде је један чинилац изостављен. Сваки чинилац предаје своје тачке ономе са своје леве стране, а без њега оне стижу непромењене.</translation>
    </message>
    <message>
        <source>An inverse keeps the order</source>
        <translation>Инверз задржава редослед</translation>
    </message>
    <message>
        <source>This inverts each factor and keeps the order. An inverse undoes the last move first, so the order turns round: {0}.</source>
        <translation>Овде је инвертован сваки чинилац, а редослед је задржан. Инверз прво поништава последњи покрет, па се редослед обрће: {0}.</translation>
    </message>
    <message>
        <source>The inverse leads there, too</source>
        <translation>И инверз води тамо</translation>
    </message>
    <message>
        <source>This is the inverse of the chain, which leads back: from the world to the object, or from the camera to the world. The inverse undoes what the chain does.</source>
        <translation>Ово је инверз ланца, а он води назад: од света до објекта, или од камере до света. Инверз поништава оно што ланац чини.</translation>
    </message>
</context>
<context>
    <name>l01-camera-frame</name>
    <message>
        <source>The camera&apos;s own axes</source>
        <translation>Осе саме камере</translation>
    </message>
    <message>
        <source>Which way does n point?</source>
        <translation>Куда показује n?</translation>
    </message>
    <message>
        <source>A camera carries three unit vectors: {0} to its right, {1} upwards, and {2} along its line of sight. Lecture 001 puts the camera at {3} and lets it look along the world&apos;s {4} axis; the letter F stands 8 units ahead. **World** shows the eye {5}, the line of sight to the target {6}, and the up vector {7}. {8} is not there yet.</source>
        <translation>Камера носи три јединична вектора: {0} удесно, {1} нагоре, и {2} дуж правца погледа. Предавање 001 ставља камеру у {3} и пушта је да гледа дуж осе {4} света; слово F стоји 8 јединица испред. **Свет** показује позицију камере {5}, линију погледа до циља {6} и вектор нагоре {7}. {8} још није ту.</translation>
    </message>
    <message>
        <source>What is {0} of this camera?</source>
        <translation>Колико је {0} ове камере?</translation>
    </message>
    <message>
        <source>(1, 0, 0), the direction in which it looks</source>
        <translation>(1, 0, 0), смер у коме гледа</translation>
    </message>
    <message>
        <source>The camera looks along {0}: {1} runs from the target back to the eye. Look at its arrow: it points away from the F.</source>
        <translation>Камера гледа дуж {0}: {1} иде од циља назад ка позицији камере. Погледајте његову стрелицу: показује од слова F.</translation>
    </message>
    <message>
        <source>(-1, 0, 0), opposite to the direction in which it looks</source>
        <translation>(-1, 0, 0), супротно смеру у коме гледа</translation>
    </message>
    <message>
        <source>(0, 0, -1), as for every camera</source>
        <translation>(0, 0, -1), као код сваке камере</translation>
    </message>
    <message>
        <source>That is the direction in which it looks in its own coordinates, after the view matrix. In the world it looks along +x. Look at {0}: it lies along the world&apos;s x axis, not along z.</source>
        <translation>То је смер у коме гледа у сопственим координатама, после матрице погледа. У свету она гледа дуж +x. Погледајте {0}: лежи дуж осе x света, а не дуж z.</translation>
    </message>
    <message>
        <source>n runs from the target back to the eye. The camera looks along {0}.</source>
        <translation>n иде од циља назад ка позицији камере. Камера гледа дуж {0}.</translation>
    </message>
    <message>
        <source>Eye, target, up: then u, v, n</source>
        <translation>Позиција камере, циљ, вектор нагоре: па u, v, n</translation>
    </message>
    <message>
        <source>The eye {0} is at {1}, the target {2} at the origin, and {3}.</source>
        <translation>Позиција камере {0} је {1}, циљ {2} је координатни почетак, а {3}.</translation>
    </message>
    <message>
        <source>{0}; its length is 3, so {1}.</source>
        <translation>{0}; дужина му је 3, па је {1}.</translation>
    </message>
    <message>
        <source>{0}; its length is only 0.745, so it is divided too: {1}.</source>
        <translation>{0}; дужина му је само 0.745, па се и он дели: {1}.</translation>
    </message>
    <message>
        <source>{0}; {1} and {2} are unit vectors at a right angle, so {3} needs no division.</source>
        <translation>{0}; {1} и {2} су јединични вектори под правим углом, па {3} не треба делити.</translation>
    </message>
    <message>
        <source>In *Camera frame*, **Back** and **Next** build them one by one.</source>
        <translation>У панелу *Координатни систем камере* граде их један по један **Назад** и **Даље**.</translation>
    </message>
    <message>
        <source>V is not v</source>
        <translation>V није v</translation>
    </message>
    <message>
        <source>The up vector {0} only says roughly which way is up. Here it is {1}, and the camera looks slightly down.</source>
        <translation>Вектор нагоре {0} само приближно каже где је горе. Овде је {1}, а камера гледа мало надоле.</translation>
    </message>
    <message>
        <source>Turn {0} away from {1} until the angle between them is 30° or more.</source>
        <translation>Закрећите {0} од {1} док угао између њих не буде 30° или више.</translation>
    </message>
    <message>
        <source>v is always at a right angle to the line of sight. What tilts the line of sight?</source>
        <translation>v је увек под правим углом према правцу погледа. Шта нагиње правац погледа?</translation>
    </message>
    <message>
        <source>Raise the eye: Elevation in the dock.</source>
        <translation>Подигните камеру: „Елевација” у бочном панелу.</translation>
    </message>
    <message>
        <source>Right: v has the direction of the part of V at a right angle to the line of sight. Only for a camera that looks level are the two the same.</source>
        <translation>Тачно: v има смер компоненте вектора V управне на правац погледа. Само за камеру која гледа водоравно њих двоје је исто.</translation>
    </message>
    <message>
        <source>The length of a cross product</source>
        <translation>Дужина векторског производа</translation>
    </message>
    <message>
        <source>A cross product of two unit vectors has length 1 only if they are at a right angle to each other. {0} and {1} are seldom at a right angle.</source>
        <translation>Векторски производ два јединична вектора има дужину 1 само ако су они под правим углом. {0} и {1} су ретко под правим углом.</translation>
    </message>
    <message>
        <source>Eye (2, 3, 6), target at the origin, {0}. How large is {1}?</source>
        <translation>Позиција камере (2, 3, 6), циљ у координатном почетку, {0}. Колико је {1}?</translation>
    </message>
    <message>
        <source>This takes {0} itself for {1}. Look at the two arrows: {2} is at a right angle to {3}, and {4} is not.</source>
        <translation>Овде је сам {0} узет за {1}. Погледајте две стрелице: {2} је под правим углом према {3}, а {4} није.</translation>
    </message>
    <message>
        <source>{0} is shorter than 1, because {1} and {2} are not at a right angle. Look at them, and divide by the length before the second product.</source>
        <translation>{0} је краће од 1, јер {1} и {2} нису под правим углом. Погледајте их, и поделите дужином пре другог производа.</translation>
    </message>
    <message>
        <source>N = (2, 3, 6) is 7 long.</source>
        <translation>N = (2, 3, 6) је дужине 7.</translation>
    </message>
    <message>
        <source>{0}. Its length is not 1.</source>
        <translation>{0}. Дужина му није 1.</translation>
    </message>
    <message>
        <source>{0} is 0.904 long, so {1}, and {2}.</source>
        <translation>{0} је дужине 0.904, па је {1}, и {2}.</translation>
    </message>
    <message>
        <source>The last column of the view matrix</source>
        <translation>Последња колона матрице погледа</translation>
    </message>
    <message>
        <source>The view matrix first moves the eye to the origin, then rotates: {0}, where the rows of {1} are {2}, {3}, {4}. Its last column is therefore {5} times minus the eye.</source>
        <translation>Матрица погледа прво помера позицију камере у координатни почетак, па ротира: {0}, где су врсте матрице {1} вектори {2}, {3}, {4}. Њена последња колона је зато {5} пута минус позиција камере.</translation>
    </message>
    <message>
        <source>The same camera: eye (2, 3, 6), target at the origin. Which number stands in row 3, column 4 of the view matrix?</source>
        <translation>Иста камера: позиција (2, 3, 6), циљ у координатном почетку. Који број стоји у врсти 3, колони 4 матрице погледа?</translation>
    </message>
    <message>
        <source>This rotates first and then moves. The move acts first, so row {0} multiplies all its three numbers. Look at view space: the target, the world&apos;s origin, lies on the axis.</source>
        <translation>Овде се прво ротира, па помера. Помак делује први, па врста {0} множи сва његова три броја. Погледајте координатни систем камере: циљ, координатни почетак света, лежи на оси.</translation>
    </message>
    <message>
        <source>This puts the camera in its place. The view matrix moves the world until the eye is at the origin. Look at view space: the eye is at the origin, and the target in front of it.</source>
        <translation>Ово ставља камеру на њено место. Матрица погледа помера свет док позиција камере не буде у координатном почетку. Погледајте координатни систем камере: камера је у координатном почетку, а циљ испред ње.</translation>
    </message>
    <message>
        <source>This takes the direction of view for {0}. Look at view space: {1} points backwards, so the target, the world&apos;s origin, has a negative z.</source>
        <translation>Овде је смер погледа узет за {0}. Погледајте координатни систем камере: {1} показује уназад, па циљ, координатни почетак света, има негативно z.</translation>
    </message>
    <message>
        <source>Row 3 is n. What does it make of the moved origin, {0}?</source>
        <translation>Врста 3 је n. Шта она прави од помереног координатног почетка, {0}?</translation>
    </message>
    <message>
        <source>{0}. The world&apos;s origin is 7 units in front of the camera, so its z there is {1}.</source>
        <translation>{0}. Координатни почетак света је 7 јединица испред камере, па је његово z тамо {1}.</translation>
    </message>
    <message>
        <source>A camera for a given n</source>
        <translation>Камера за дато n</translation>
    </message>
    <message>
        <source>Now the other way round: find the camera for a given axis.</source>
        <translation>Сада обрнуто: нађите камеру за дату осу.</translation>
    </message>
    <message>
        <source>Give the camera {0}.</source>
        <translation>Дајте камери {0}.</translation>
    </message>
    <message>
        <source>n has no height: the camera looks level.</source>
        <translation>n нема висину: камера гледа водоравно.</translation>
    </message>
    <message>
        <source>From the target, go along n to the eye: 6 along x for every 8 along z. Then Elevation is 0 and Azimuth 36.87.</source>
        <translation>Од циља идите дуж n до позиције камере: 6 дуж x на сваких 8 дуж z. Тада је елевација 0, а азимут 36.87.</translation>
    </message>
    <message>
        <source>Right: any eye on the ray from the target along n will do. The distance does not matter.</source>
        <translation>Тачно: одговара свака позиција камере на полуправој из циља дуж n. Растојање није важно.</translation>
    </message>
    <message>
        <source>Back to the camera at (4, 2, 0)</source>
        <translation>Назад на камеру у (4, 2, 0)</translation>
    </message>
    <message>
        <source>It is tempting to take {0} as the direction in which the camera looks, {1}. But {2} to the right, {3} up and the third axis must make a right-handed system, so the third one comes out of the picture, towards the reader: {4}. Lecture 001 calls it {5} and writes {6}.</source>
        <translation>Примамљиво је за {0} узети смер у коме камера гледа, {1}. Али {2} удесно, {3} нагоре и трећа оса морају чинити десни систем, па трећа излази из слике, ка читаоцу: {4}. Предавање 001 је зове {5} и пише {6}.</translation>
    </message>
    <message>
        <source>That is why what is in front of a camera has a *negative* z in its coordinates: the F, 8 units ahead, is at {0}. In *Camera frame*, row 3 of the matrix begins with {1}.</source>
        <translation>Зато оно што је испред камере у њеним координатама има *негативно* z: слово F, 8 јединица испред, је у {0}. У панелу *Координатни систем камере* врста 3 матрице почиње са {1}.</translation>
    </message>
    <message>
        <source>Practise: how upright is v?</source>
        <translation>Вежба: колико је усправно v?</translation>
    </message>
    <message>
        <source>Eye {0} and target {1} are new each time; {2}.</source>
        <translation>Позиција камере {0} и циљ {1} сваки пут су нови; {2}.</translation>
    </message>
    <message>
        <source>The eye is at {0}, the target at {1}. How large is {2}?</source>
        <translation>Позиција камере је {0}, циљ је у {1}. Колико је {2}?</translation>
    </message>
    <message>
        <source>{0}, divided by its length, is {1}.</source>
        <translation>{0}, подељено својом дужином, је {1}.</translation>
    </message>
    <message>
        <source>{0} is shorter than 1. Divide it by its length before you form {1}.</source>
        <translation>{0} је краће од 1. Поделите га његовом дужином пре него што образујете {1}.</translation>
    </message>
    <message>
        <source>{0} is {1} long, {2} only {3}.</source>
        <translation>{0} је дужине {1}, {2} само {3}.</translation>
    </message>
    <message>
        <source>Practise: a row of the view matrix</source>
        <translation>Вежба: врста матрице погледа</translation>
    </message>
    <message>
        <source>The view matrix is {0}: {1} moves the eye {2} to the origin, and the rows of {3} are {4}, {5}, {6}.</source>
        <translation>Матрица погледа је {0}: {1} помера позицију камере {2} у координатни почетак, а врсте матрице {3} су {4}, {5}, {6}.</translation>
    </message>
    <message>
        <source>The eye is at {0}, the target at {1}. Which four numbers are in row 3 of the view matrix?</source>
        <translation>Позиција камере је {0}, циљ је у {1}. Која четири броја стоје у врсти 3 матрице погледа?</translation>
    </message>
    <message>
        <source>This rotates first and then moves. The move acts first, so {0} multiplies all three numbers of {1}. Look at view space: the eye is at the origin.</source>
        <translation>Овде се прво ротира, па помера. Помак делује први, па {0} множи сва три броја од {1}. Погледајте координатни систем камере: камера је у координатном почетку.</translation>
    </message>
    <message>
        <source>This puts the camera in its place. The view matrix moves the world until the eye is at the origin. Look at view space: the eye is there, and the target in front of it.</source>
        <translation>Ово ставља камеру на њено место. Матрица погледа помера свет док позиција камере не буде у координатном почетку. Погледајте координатни систем камере: камера је тамо, а циљ испред ње.</translation>
    </message>
    <message>
        <source>This takes the direction of view for {0}. Look at view space: {1} points backwards, away from the target.</source>
        <translation>Овде је смер погледа узет за {0}. Погледајте координатни систем камере: {1} показује уназад, од циља.</translation>
    </message>
    <message>
        <source>{0} is {1} long.</source>
        <translation>{0} је дужине {1}.</translation>
    </message>
    <message>
        <source>Row 3 of {0} is {1}. What does it make of the moved origin, {2}?</source>
        <translation>Врста 3 матрице {0} је {1}. Шта она прави од помереног координатног почетка, {2}?</translation>
    </message>
    <message>
        <source>{0} is {1} long. Row 3 begins with {2} and ends with {3}.</source>
        <translation>{0} је дужине {1}. Врста 3 почиње са {2}, а завршава се са {3}.</translation>
    </message>
    <message>
        <source>Practise: a camera for a given n</source>
        <translation>Вежба: камера за дато n</translation>
    </message>
    <message>
        <source>Use *Azimuth* and *Elevation* in the dock, drag the eye in **World**, or type its coordinates.</source>
        <translation>Користите *Азимут* и *Елевација* у бочном панелу, превуците позицију камере у приказу **Свет**, или унесите њене координате.</translation>
    </message>
    <message>
        <source>Give the camera an {0} in the direction of {1}.</source>
        <translation>Дајте камери {0} у смеру {1}.</translation>
    </message>
    <message>
        <source>{0} runs from the target to the eye.</source>
        <translation>{0} иде од циља ка позицији камере.</translation>
    </message>
    <message>
        <source>The tangent of the azimuth is {0}. The tangent of the elevation is {1}, divided by the length of {2}.</source>
        <translation>Тангенс азимута је {0}. Тангенс елевације је {1}, подељено дужином од {2}.</translation>
    </message>
    <message>
        <source>The eye is on the ray from the target along {0}: {1}. The distance does not matter.</source>
        <translation>Позиција камере је на полуправој из циља дуж {0}: {1}. Растојање није важно.</translation>
    </message>
    <message>
        <source>Your camera looks in the direction of {0}. Look at its {1}: it points the other way, from the target to the eye.</source>
        <translation>Ваша камера гледа у смеру {0}. Погледајте њено {1}: показује на другу страну, од циља ка позицији камере.</translation>
    </message>
    <message>
        <source>Practise: build the view matrix</source>
        <translation>Вежба: саставите матрицу погледа</translation>
    </message>
    <message>
        <source>Put the tiles in order, and leave out what does not belong.</source>
        <translation>Поређајте плочице и изоставите оно што ту не спада.</translation>
    </message>
    <message>
        <source>The eye is at {0}. The rows of {1} are {2}, {3}, {4}, and {5} moves by {6}. Which product is the view matrix?</source>
        <translation>Позиција камере је {0}. Врсте матрице {1} су {2}, {3}, {4}, а {5} помера за {6}. Који производ је матрица погледа?</translation>
    </message>
    <message>
        <source>{0} moves the eye to the origin, and {1} rotates about it. {2} moves the wrong way.</source>
        <translation>{0} помера позицију камере у координатни почетак, а {1} ротира око њега. {2} помера на погрешну страну.</translation>
    </message>
    <message>
        <source>A camera at the origin looks along {0}. It was turned about y by {1}°, then moved by {2}. Which product is its view matrix?</source>
        <translation>Камера у координатном почетку гледа дуж {0}. Окренута је око y за {1}°, па померена за {2}. Који производ је њена матрица погледа?</translation>
    </message>
    <message>
        <source>A camera was tilted about x by {0}°, turned about y by {1}°, and moved by {2}. Which product is its view matrix?</source>
        <translation>Камера је нагнута око x за {0}°, окренута око y за {1}° и померена за {2}. Који производ је њена матрица погледа?</translation>
    </message>
    <message>
        <source>Where is the eye after the view matrix?</source>
        <translation>Где је позиција камере после матрице погледа?</translation>
    </message>
    <message>
        <source>At the origin, so the factor that moves acts first. {0} moves by {1}.</source>
        <translation>У координатном почетку, па прво делује чинилац који помера. {0} помера за {1}.</translation>
    </message>
    <message>
        <source>The view matrix undoes both, the last one first.</source>
        <translation>Матрица погледа поништава и једно и друго, прво оно што је било последње.</translation>
    </message>
    <message>
        <source>The camera was placed by {0}. Its inverse is {1}: the move is undone first.</source>
        <translation>Камера је постављена производом {0}. Његов инверз је {1}: прво се поништава помак.</translation>
    </message>
    <message>
        <source>The camera was placed by {0}. What is undone first?</source>
        <translation>Камера је постављена производом {0}. Шта се прво поништава?</translation>
    </message>
    <message>
        <source>The move, then the turn, then the tilt.</source>
        <translation>Помак, па окретање, па нагињање.</translation>
    </message>
    <message>
        <source>{0}: an inverse turns the order round.</source>
        <translation>{0}: инверз обрће редослед.</translation>
    </message>
</context>
<context>
    <name>l02-columns</name>
    <message>
        <source>First rotate, then move</source>
        <translation>Прво ротирајте, па померите</translation>
    </message>
    <message>
        <source>An object has coordinates of its own; {0} takes them to the world. Here {1}: the object is turned by 90° about z, then moved by 3 along x. With column vectors the matrix on the right acts first. In **World** the letter F still stands where it was made.</source>
        <translation>Објекат има сопствене координате; {0} их преводи у свет. Овде је {1}: објекат је окренут за 90° око z, па померен за 3 дуж x. Са векторима-колонама десна матрица делује прва. У приказу **Свет** слово F и даље стоји где је направљено.</translation>
    </message>
    <message>
        <source>The object&apos;s point (1, 0, 0): how high above the ground, in y, does it end up in the world?</source>
        <translation>Тачка објекта (1, 0, 0): колико изнад тла, по y, на крају стоји у свету?</translation>
    </message>
    <message>
        <source>This moves first and then turns, which turns the move as well. Look at point 1: the object&apos;s point would come there, 4 high.</source>
        <translation>Овде се прво помера, па окреће, а тиме се окреће и помак. Погледајте тачку 1: тачка објекта би дошла тамо, на висину 4.</translation>
    </message>
    <message>
        <source>The move alone keeps it on the ground, but the turn by 90° takes x to y. Look at point 1: it is where the move alone takes the point, on the ground.</source>
        <translation>Сам помак је оставља на тлу, али окретање за 90° преводи x у y. Погледајте тачку 1: она је тамо где тачку доводи сам помак, на тлу.</translation>
    </message>
    <message>
        <source>The turn takes (1, 0, 0) to (0, 1, 0), and then the move takes that to (3, 1, 0): probe 1 in World.</source>
        <translation>Окретање преводи (1, 0, 0) у (0, 1, 0), а помак затим то у (3, 1, 0): сонда 1 у приказу „Свет”.</translation>
    </message>
    <message>
        <source>Read the matrix by columns</source>
        <translation>Читајте матрицу по колонама</translation>
    </message>
    <message>
        <source>In *Matrices*, world ← object holds the turn and the move:</source>
        <translation>У панелу *Матрице* „свет ← објекат” садржи окретање и помак:</translation>
    </message>
    <message>
        <source>x axis</source>
        <translation>оса x</translation>
    </message>
    <message>
        <source>y axis</source>
        <translation>оса y</translation>
    </message>
    <message>
        <source>z axis</source>
        <translation>оса z</translation>
    </message>
    <message>
        <source>origin</source>
        <translation>почетак</translation>
    </message>
    <message>
        <source>Column 1 says where the object&apos;s x axis points in the world: {0}, up. Column 2 is its y axis, column 3 its z axis, and column 4 is the position of its origin. So the point {1} lies at column 4 plus column 1: {2}. Point at a column with the mouse to highlight its axis in **World**.</source>
        <translation>Колона 1 каже куда у свету показује оса x објекта: {0}, нагоре. Колона 2 је његова оса y, колона 3 оса z, а колона 4 положај његовог координатног почетка. Зато тачка {1} лежи у колони 4 плус колона 1: {2}. Покажите мишем на колону да истакнете њену осу у приказу **Свет**.</translation>
    </message>
    <message>
        <source>Exchange the two tiles in *Chain*, in the dock, and play the strip again. How does the letter reach its place now?</source>
        <translation>Замените места двема плочицама у одељку *Ланац*, у бочном панелу, и поново пустите траку. Како слово сада стиже на своје место?</translation>
    </message>
    <message>
        <source>A point through T and R</source>
        <translation>Тачка кроз T и R</translation>
    </message>
    <message>
        <source>The letter is turned by 30° about z and then moved by 4 along x: {0}.</source>
        <translation>Слово је окренуто за 30° око z, па померено за 4 дуж x: {0}.</translation>
    </message>
    <message>
        <source>What is x of the object&apos;s point (2, 1, 0) in the world?</source>
        <translation>Колико је x тачке објекта (2, 1, 0) у свету?</translation>
    </message>
    <message>
        <source>This moves first and then turns, which turns the move as well. Look at point 1: it is where the object&apos;s point would come then.</source>
        <translation>Овде се прво помера, па окреће, а тиме се окреће и помак. Погледајте тачку 1: она је тамо где би тачка објекта тада дошла.</translation>
    </message>
    <message>
        <source>This reads rows for columns, as if the letter were turned by −30°. Look at point 1: it is where the object&apos;s point would come then.</source>
        <translation>Овде се врсте читају као колоне, као да је слово окренуто за −30°. Погледајте тачку 1: она је тамо где би тачка објекта тада дошла.</translation>
    </message>
    <message>
        <source>2 times column 1, plus 1 times column 2, plus column 4.</source>
        <translation>2 пута колона 1, плус 1 пут колона 2, плус колона 4.</translation>
    </message>
    <message>
        <source>cos 30° = 0.866, sin 30° = 0.5</source>
        <translation>cos 30° = 0.866, sin 30° = 0.5</translation>
    </message>
    <message>
        <source>Where must it move?</source>
        <translation>Куда мора да се помери?</translation>
    </message>
    <message>
        <source>The letter is turned by 90° about z. Probe 1 in **World** is at {0}.</source>
        <translation>Слово је окренуто за 90° око z. Сонда 1 у приказу **Свет** је у {0}.</translation>
    </message>
    <message>
        <source>Keep the turn, and move the object so that its point (1, 0, 0) comes to probe 1.</source>
        <translation>Задржите окретање и померите објекат тако да његова тачка (1, 0, 0) дође у сонду 1.</translation>
    </message>
    <message>
        <source>Where is the point now, when it is turned but not moved?</source>
        <translation>Где је тачка сада, када је окренута, а није померена?</translation>
    </message>
    <message>
        <source>It is at (0, 1, 0), and it must go to (2, 3, 0).</source>
        <translation>Она је у (0, 1, 0), а мора доћи у (2, 3, 0).</translation>
    </message>
    <message>
        <source>Right: column 1 plus column 4 is (2, 3, 0).</source>
        <translation>Тачно: колона 1 плус колона 4 је (2, 3, 0).</translation>
    </message>
    <message>
        <source>Back to the prediction</source>
        <translation>Назад на предвиђање</translation>
    </message>
    <message>
        <source>It is tempting to move first, from {0} to {1}, and then to rotate. But a rotation about the world&apos;s origin rotates the move as well: {2} goes to {3}, where probe 1 is. That is {4}, which this step shows: in *Chain* the rotation stands above the move, so it acts last.</source>
        <translation>Примамљиво је прво померити, из {0} у {1}, па онда ротирати. Али ротација око координатног почетка света ротира и помак: {2} иде у {3}, где је сонда 1. То је {4}, што овај корак показује: у одељку *Ланац* ротација стоји изнад помака, па делује последња.</translation>
    </message>
    <message>
        <source>The letter is turned about z by {0} and not moved yet. Its move is in *Chain*, in the dock.</source>
        <translation>Слово је окренуто око z за {0} и још није померено. Његов помак је у одељку *Ланац*, у бочном панелу.</translation>
    </message>
    <message>
        <source>The letter was turned about z by {0}° and then moved by {1} along x. Which product did that?</source>
        <translation>Слово је окренуто око z за {0}°, па померено за {1} дуж x. Који производ је то учинио?</translation>
    </message>
    <message>
        <source>The letter was made {0} times as wide, turned about z by {1}°, and moved by {2} along x. It kept its right angles. Which product did that?</source>
        <translation>Слово је растегнуто на {0} пута већу ширину, окренуто око z за {1}°, и померено за {2} дуж x. Задржало је праве углове. Који производ је то учинио?</translation>
    </message>
    <message>
        <source>Object, world, camera</source>
        <translation>Објекат, свет, камера</translation>
    </message>
    <message>
        <source>Each factor is a place</source>
        <translation>Сваки чинилац је једно место</translation>
    </message>
    <message>
        <source>The strip below the cube has a stop for each move: *Object*, *Rz* and *World*. At *Rz* the letter is turned and not yet moved; its other places are pale beside it. Play the strip from its beginning.</source>
        <translation>Трака испод коцке има станицу за сваки покрет: *Објекат*, *Rz* и *Свет*. На станици *Rz* слово је окренуто, а још није померено; његова остала места виде се бледо поред њега. Пустите траку од почетка.</translation>
    </message>
    <message>
        <source>The arrow beside *Play* reads the product the other way. **←** does the moves from right to left, each in the axes of the world. **→** does them from left to right, each in the axes that the moves before have moved: the letter goes 3 along x and is then turned about its own origin. Both ways end in the same place.</source>
        <translation>Стрелица поред дугмета *Пусти* чита производ на другу страну. **←** изводи покрете здесна налево, сваки у осама света. **→** их изводи слева надесно, сваки у осама које су ранији покрети померили: слово иде за 3 дуж x, па се окреће око сопственог координатног почетка. Оба пута завршавају се на истом месту.</translation>
    </message>
    <message>
        <source>Drag a tile by the grip at its left, or press the arrow keys there.</source>
        <translation>Превуците плочицу за ручицу на њеној левој страни, или тамо притисните тастере са стрелицама.</translation>
    </message>
    <message>
        <source>Now the move is turned as well: the letter swings about the world&apos;s origin, from {0} to {1}.</source>
        <translation>Сада се окреће и помак: слово описује лук око координатног почетка света, од {0} до {1}.</translation>
    </message>
    <message>
        <source>{0} has the turn on the left, so it acts last, about the world&apos;s origin.</source>
        <translation>{0} има окретање лево, па оно делује последње, око координатног почетка света.</translation>
    </message>
    <message>
        <source>From the world to the camera</source>
        <translation>Од света до камере</translation>
    </message>
    <message>
        <source>The camera has axes of its own, and {0} takes the world to them. It undoes how the camera was placed. For a point {1} of the letter both matrices are multiplied:</source>
        <translation>Камера има сопствене осе, и матрица {0} свет преводи у њих. Она поништава постављање камере. За тачку {1} слова множе се обе матрице:</translation>
    </message>
    <message>
        <source>Which chain takes a point of the letter to the camera&apos;s axes?</source>
        <translation>Који ланац преводи тачку слова у осе камере?</translation>
    </message>
    <message>
        <source>In which space does the point have its coordinates at first?</source>
        <translation>У ком систему су координате тачке на почетку?</translation>
    </message>
    <message>
        <source>The point starts in the letter&apos;s own space. The turn and the move take it to the world, and the view matrix takes it from there to the camera.</source>
        <translation>Тачка полази из координатног система слова. Окретање и помак је преводе у свет, а матрица погледа одатле у систем камере.</translation>
    </message>
    <message>
        <source>With {0} the letter is rotated in its place and then moved, and column 4 is the move as you typed it. With {1} column 4 is the move after the rotation, {2}.</source>
        <translation>Са {0} слово се ротира на месту, па помера, и колона 4 је помак како сте га унели. Са {1} колона 4 је помак после ротације, {2}.</translation>
    </message>
    <message>
        <source>Practise: the matrix of a turn</source>
        <translation>Вежба: матрица окретања</translation>
    </message>
    <message>
        <source>The letter is turned about z by an angle {0}. Seen from the tip of z, a positive angle turns it anticlockwise.</source>
        <translation>Слово је окренуто око z за угао {0}. Гледано са врха осе z, позитиван угао га окреће супротно од казаљке на сату.</translation>
    </message>
    <message>
        <source>Here {0}. Which numbers are in rows 1 and 2, columns 1 and 2 of {1}?</source>
        <translation>Овде је {0}. Који бројеви стоје у врстама 1 и 2, колонама 1 и 2 матрице {1}?</translation>
    </message>
    <message>
        <source>This has rows and columns exchanged, which turns the letter the other way. Look at its own axes: they are turned by {0}°.</source>
        <translation>Овде су врсте и колоне замењене, што слово окреће на другу страну. Погледајте његове осе: окренуте су за {0}°.</translation>
    </message>
    <message>
        <source>My degrees are radians</source>
        <translation>Моји степени су радијани</translation>
    </message>
    <message>
        <source>This takes {0}° for {1} radians. Look at the letter, turned by that many radians.</source>
        <translation>Овде је {0}° узето као {1} у радијанима. Погледајте слово окренуто за толико радијана.</translation>
    </message>
    <message>
        <source>Column 1 is the x axis of the turned letter, column 2 its y axis.</source>
        <translation>Колона 1 је оса x окренутог слова, колона 2 његова оса y.</translation>
    </message>
    <message>
        <source>Column 1 is where the x axis points after the turn, column 2 where the y axis points.</source>
        <translation>Колона 1 је куда после окретања показује оса x, колона 2 куда показује оса y.</translation>
    </message>
    <message>
        <source>Practise: turn, then move</source>
        <translation>Вежба: окрените, па померите</translation>
    </message>
    <message>
        <source>The letter is turned about z by {0}, then moved along x: {1}. Point 1 is where a point of the letter&apos;s own space comes to.</source>
        <translation>Слово је окренуто око z за {0}, па померено дуж x: {1}. Тачка 1 је место на које долази тачка из координатног система слова.</translation>
    </message>
    <message>
        <source>Here {0}, and the move is {1} along x. What is x of the object&apos;s point {2} in the world?</source>
        <translation>Овде је {0}, а помак је {1} дуж x. Колико је x тачке објекта {2} у свету?</translation>
    </message>
    <message>
        <source>This reads rows for columns, as if the letter were turned by {0}°. Look at point 1: it is where the object&apos;s point would come then.</source>
        <translation>Овде се врсте читају као колоне, као да је слово окренуто за {0}°. Погледајте тачку 1: она је тамо где би тачка објекта тада дошла.</translation>
    </message>
    <message>
        <source>{0} times column 1, plus {1} times column 2, plus column 4.</source>
        <translation>{0} пута колона 1, плус {1} пута колона 2, плус колона 4.</translation>
    </message>
    <message>
        <source>The x of column 1 is {0}, and the x of column 2 is {1}.</source>
        <translation>x колоне 1 је {0}, а x колоне 2 је {1}.</translation>
    </message>
    <message>
        <source>First the turn, then the move.</source>
        <translation>Прво окретање, па помак.</translation>
    </message>
    <message>
        <source>Practise: bring a point to its place</source>
        <translation>Вежба: доведите тачку на место</translation>
    </message>
    <message>
        <source>Keep the turn of {0}°, and move the letter so that its point {1} comes to probe 1, at {2}.</source>
        <translation>Задржите окретање од {0}° и померите слово тако да његова тачка {1} дође у сонду 1, у {2}.</translation>
    </message>
    <message>
        <source>Where does the turn alone take {0}?</source>
        <translation>Куда само окретање преводи {0}?</translation>
    </message>
    <message>
        <source>To {0}. The move adds to that.</source>
        <translation>У {0}. Помак се додаје на то.</translation>
    </message>
    <message>
        <source>Column 1 plus column 4 is {0}: {1} {2} and {3} {4}.</source>
        <translation>Колона 1 плус колона 4 је {0}: {1} {2} и {3} {4}.</translation>
    </message>
    <message>
        <source>This move is right if it acts before the turn. Look at the letter with the order R T S: only there does it bring the point to probe 1.</source>
        <translation>Овај помак је тачан ако делује пре окретања. Погледајте слово са редоследом R T S: само тамо он доводи тачку у сонду 1.</translation>
    </message>
    <message>
        <source>Practise: build the chain</source>
        <translation>Вежба: саставите ланац</translation>
    </message>
    <message>
        <source>Put the tiles in order, and leave out what does not belong.</source>
        <translation>Поређајте плочице и изоставите оно што ту не спада.</translation>
    </message>
    <message>
        <source>Which of the two acts first? It stands at the bottom.</source>
        <translation>Који од та два чиниоца делује први? Он стоји на дну.</translation>
    </message>
    <message>
        <source>{0}: the factor on the right acts first.</source>
        <translation>{0}: десни чинилац делује први.</translation>
    </message>
    <message>
        <source>A scale after the turn would bend the right angles.</source>
        <translation>Скалирање после окретања искривило би праве углове.</translation>
    </message>
    <message>
        <source>A scale after the move would multiply the move.</source>
        <translation>Скалирање после помака помножило би помак.</translation>
    </message>
    <message>
        <source>{0}: first the scale, along the letter&apos;s own axes, then the turn about its own origin, and the move last.</source>
        <translation>{0}: прво скалирање, дуж сопствених оса слова, па окретање око његовог координатног почетка, и на крају помак.</translation>
    </message>
    <message>
        <source>Give the tiles their numbers, and arrange them. Columns 1 and 4 of their product {0} must be {1} and {2}.</source>
        <translation>Дајте плочицама бројеве и поређајте их. Колоне 1 и 4 њиховог производа {0} морају бити {1} и {2}.</translation>
    </message>
    <message>
        <source>Column 4 is the move, if the move acts last.</source>
        <translation>Колона 4 је помак, ако помак делује последњи.</translation>
    </message>
    <message>
        <source>Column 1 is {0}.</source>
        <translation>Колона 1 је {0}.</translation>
    </message>
    <message>
        <source>Column 4 of {0} is the move itself, and columns 1 to 3 are those of the rotation.</source>
        <translation>Колона 4 производа {0} је сам помак, а колоне 1 до 3 су колоне ротације.</translation>
    </message>
</context>
<context>
    <name>l03-field-of-view</name>
    <message>
        <source>Which angle is the field of view?</source>
        <translation>Који је угао видно поље?</translation>
    </message>
    <message>
        <source>How wide is 60 degrees?</source>
        <translation>Колико је широко 60 степени?</translation>
    </message>
    <message>
        <source>The number in *Field of view* is the vertical angle, from the bottom of the picture to its top. The picture is 16 wide and 9 high. **World**, seen from *Above*, shows half of the horizontal angle at the eye: {0}.</source>
        <translation>Број у пољу *Видно поље* је вертикални угао, од доње до горње ивице слике. Слика је широка 16, а висока 9. **Свет**, гледан *Одозго*, показује код камере половину хоризонталног угла: {0}.</translation>
    </message>
    <message>
        <source>The vertical angle is set to 60°. How large is the horizontal one?</source>
        <translation>Вертикални угао је постављен на 60°. Колики је хоризонтални?</translation>
    </message>
    <message>
        <source>Widths are proportional to the tangent of half the angle. Look at 120° upwards: 16/9 times that would be 213°, more than half a turn; {0} is 72.0°.</source>
        <translation>Ширине су сразмерне тангенсу половине угла. Погледајте 120° по висини: 16/9 пута толико било би 213°, више од пола круга; {0} је 72.0°.</translation>
    </message>
    <message>
        <source>This takes the vertical angle for the horizontal one. Look at this square picture: only here both are 60°, and {0} is 30°.</source>
        <translation>Овде је вертикални угао узет за хоризонтални. Погледајте ову квадратну слику: само овде су оба 60°, а {0} је 30°.</translation>
    </message>
    <message>
        <source>The sides of the picture are in the ratio 16 to 9, and so are the tangents of the half angles: {0}.</source>
        <translation>Странице слике су у односу 16 према 9, па су у том односу и тангенси половина углова: {0}.</translation>
    </message>
    <message>
        <source>From one angle to the other</source>
        <translation>Од једног угла до другог</translation>
    </message>
    <message>
        <source>Lecture 003 has {0} for the horizontal angle, {1} for the vertical one, and {2} for the proportions, here {3}. At the distance {4} from the eye the picture reaches from {5} to {6}, and from {7} to {8}. So</source>
        <translation>Предавање 003 има {0} за хоризонтални угао, {1} за вертикални и {2} за пропорције, овде {3}. На растојању {4} од позиције камере слика досеже од {5} до {6} и од {7} до {8}. Дакле</translation>
    </message>
    <message>
        <source>With {0}: {1}, so {2} and {3}. The side of the near plane&apos;s window is {4} in x and {5} in y. In the dock, *More of the lens* has **Horizontal fov** and **Focal length e**.</source>
        <translation>За {0}: {1}, па је {2} и {3}. Страна прозора на предњој равни је {4} по x и {5} по y. У бочном панелу одељак *Још о објективу* има **Хоризонтално видно поље** и **Жижну даљину e**.</translation>
    </message>
    <message>
        <source>A right angle</source>
        <translation>Прав угао</translation>
    </message>
    <message>
        <source>The picture is still 16 by 9.</source>
        <translation>Слика је и даље 16 према 9.</translation>
    </message>
    <message>
        <source>Make the horizontal angle 90°.</source>
        <translation>Нека хоризонтални угао буде 90°.</translation>
    </message>
    <message>
        <source>At 90° the half angle is 45°, and its tangent is 1.</source>
        <translation>За 90° половина угла је 45°, а њен тангенс је 1.</translation>
    </message>
    <message>
        <source>Then e is 1, and the vertical half angle has the tangent a = 9/16.</source>
        <translation>Тада је e једнако 1, а половина вертикалног угла има тангенс a = 9/16.</translation>
    </message>
    <message>
        <source>Right: e is 1, and the vertical angle is 58.7°, if the picture is 16 by 9.</source>
        <translation>Тачно: e је 1, а вертикални угао је 58.7°, ако је слика 16 према 9.</translation>
    </message>
    <message>
        <source>A picture twice as wide as high</source>
        <translation>Слика двапут шира него виша</translation>
    </message>
    <message>
        <source>Now the picture is 1000 by 500 pixels, and the vertical angle is 40°.</source>
        <translation>Сада слика има 1000 пута 500 пиксела, а вертикални угао је 40°.</translation>
    </message>
    <message>
        <source>How large is the horizontal angle?</source>
        <translation>Колики је хоризонтални угао?</translation>
    </message>
    <message>
        <source>Widths are proportional to the tangent of half the angle. Look from above at 100° upwards: twice that would be 200°, more than half a turn; {0} is 67.2°.</source>
        <translation>Ширине су сразмерне тангенсу половине угла. Погледајте одозго 100° по висини: двоструко од тога било би 200°, више од пола круга; {0} је 67.2°.</translation>
    </message>
    <message>
        <source>This takes the vertical angle for the horizontal one. Look from above at a square picture: only here both are 40°, and {0} is 20°.</source>
        <translation>Овде је вертикални угао узет за хоризонтални. Погледајте одозго квадратну слику: само овде су оба 40°, а {0} је 20°.</translation>
    </message>
    <message>
        <source>Take the tangent of half the vertical angle.</source>
        <translation>Узмите тангенс половине вертикалног угла.</translation>
    </message>
    <message>
        <source>tan 20° = 0.364. What is twice that the tangent of?</source>
        <translation>tan 20° = 0.364. Ког угла је тангенс двоструко од тога?</translation>
    </message>
    <message>
        <source>tan(α/2) = 2·tan 20° = 0.728, so α/2 = 36.05° and α = 72.1°.</source>
        <translation>tan(α/2) = 2·tan 20° = 0.728, па је α/2 = 36.05° и α = 72.1°.</translation>
    </message>
    <message>
        <source>The focal length e</source>
        <translation>Жижна даљина e</translation>
    </message>
    <message>
        <source>Here the picture is square, so both angles are 50°.</source>
        <translation>Овде је слика квадратна, па су оба угла 50°.</translation>
    </message>
    <message>
        <source>How large is {0} for {1}?</source>
        <translation>Колико је {0} за {1}?</translation>
    </message>
    <message>
        <source>The triangle of eye, axis and edge has half of the angle at the eye. Look at {0}: the edge is as far from the axis as from the eye, so {1}; {2} would be 0.</source>
        <translation>Троугао који чине камера, оса и ивица има код камере половину угла. Погледајте {0}: ивица је од осе далеко колико и од камере, па је {1}; {2} би било 0.</translation>
    </message>
    <message>
        <source>The cotangent takes my 25</source>
        <translation>Котангенс прима мојих 25</translation>
    </message>
    <message>
        <source>This is the cotangent of 25 radians, almost four turns. Look at the angle: 25° is 0.436 radians.</source>
        <translation>Ово је котангенс од 25 радијана, скоро четири пуна круга. Погледајте угао: 25° је 0.436 радијана.</translation>
    </message>
    <message>
        <source>In the triangle between eye, axis and the picture&apos;s edge, the angle at the eye is α/2.</source>
        <translation>У троуглу између камере, осе и ивице слике угао код камере је α/2.</translation>
    </message>
    <message>
        <source>e = cot 25° = 2.145. The wider the angle, the smaller e.</source>
        <translation>e = cot 25° = 2.145. Што је угао шири, то је e мање.</translation>
    </message>
    <message>
        <source>A wide picture on purpose</source>
        <translation>Намерно широка слика</translation>
    </message>
    <message>
        <source>The picture is 1000 by 500 again.</source>
        <translation>Слика је поново 1000 пута 500.</translation>
    </message>
    <message>
        <source>Keep the picture twice as wide as high, and make the horizontal angle 100°.</source>
        <translation>Задржите слику двапут ширу него вишу и направите хоризонтални угао од 100°.</translation>
    </message>
    <message>
        <source>Half of 100° has the tangent 1.192.</source>
        <translation>Половина од 100° има тангенс 1.192.</translation>
    </message>
    <message>
        <source>The vertical half angle has half that tangent.</source>
        <translation>Половина вертикалног угла има половину тог тангенса.</translation>
    </message>
    <message>
        <source>Right: tan(β/2) = 1.192/2, so the vertical angle is 61.6°, not 50°.</source>
        <translation>Тачно: tan(β/2) = 1.192/2, па је вертикални угао 61.6°, а не 50°.</translation>
    </message>
    <message>
        <source>Back to the prediction</source>
        <translation>Назад на предвиђање</translation>
    </message>
    <message>
        <source>It is tempting to multiply the angle by 16/9, like the width: {0}. That would be right if the picture were bent round the eye. But the picture is flat: the tangent of the half angle grows evenly, and far from the axis a degree takes more and more of the picture.</source>
        <translation>Примамљиво је угао помножити са 16/9, као ширину: {0}. То би било исправно када би слика била савијена око камере. Али слика је равна: равномерно расте тангенс половине угла, и далеко од осе један степен заузима све већи део слике.</translation>
    </message>
    <message>
        <source>The wider the angle, the larger the error: here the vertical angle is 120°. Multiplied, it would be 213° across, more than half a turn. The model has 144°.</source>
        <translation>Што је угао шири, то је грешка већа: овде је вертикални угао 120°. Помножен, био би у ширину 213°, више од пола круга. Модел има 144°.</translation>
    </message>
    <message>
        <source>Practise: how wide?</source>
        <translation>Вежба: колико широко?</translation>
    </message>
    <message>
        <source>The field of view is the vertical angle {0}; {1} is the horizontal one.</source>
        <translation>Видно поље је вертикални угао {0}; {1} је хоризонтални.</translation>
    </message>
    <message>
        <source>The picture has {0} by {1} pixels, and {2}. How large is {3} then?</source>
        <translation>Слика има {0} пута {1} пиксела, и {2}. Колико је тада {3}?</translation>
    </message>
    <message>
        <source>Widths are proportional to the tangent of half the angle. Look at {0}: {1} times that would be {2}°, more than half a turn, but the pyramid stays narrower.</source>
        <translation>Ширине су сразмерне тангенсу половине угла. Погледајте {0}: {1} пута толико било би {2}°, више од пола круга, а пирамида ипак остаје ужа.</translation>
    </message>
    <message>
        <source>This takes the vertical angle for the horizontal one. Look at a square picture: only here both are {0}°, and the pyramid is narrower.</source>
        <translation>Овде је вертикални угао узет за хоризонтални. Погледајте квадратну слику: само овде су оба {0}°, и пирамида је ужа.</translation>
    </message>
    <message>
        <source>Half of the vertical angle has the tangent {0}.</source>
        <translation>Половина вертикалног угла има тангенс {0}.</translation>
    </message>
    <message>
        <source>The tangents of the half angles are in the ratio of the sides, {0} to {1}.</source>
        <translation>Тангенси половина углова су у односу страница, {0} према {1}.</translation>
    </message>
    <message>
        <source>Practise: the focal length e</source>
        <translation>Вежба: жижна даљина e</translation>
    </message>
    <message>
        <source>At the distance {0} from the eye the picture reaches from {1} to {2}.</source>
        <translation>На растојању {0} од позиције камере слика досеже од {1} до {2}.</translation>
    </message>
    <message>
        <source>The horizontal angle is {0}, and the picture is 16 by 9. How large is {1}?</source>
        <translation>Хоризонтални угао је {0}, а слика је 16 према 9. Колико је {1}?</translation>
    </message>
    <message>
        <source>The cotangent takes my degrees</source>
        <translation>Котангенс прима моје степене</translation>
    </message>
    <message>
        <source>This takes {0}° for {1} radians, which is more than a whole turn. Look at the angle: it is less than a quarter of one.</source>
        <translation>Овде је {0}° узето као {1} у радијанима, а то је више од целог круга. Погледајте угао: мањи је од четвртине круга.</translation>
    </message>
    <message>
        <source>This takes the vertical angle for the horizontal one. Look at a square picture with the same vertical angle: only here is it the horizontal one.</source>
        <translation>Овде је вертикални угао узет за хоризонтални. Погледајте квадратну слику са истим вертикалним углом: само ту је он једнак хоризонталном.</translation>
    </message>
    <message>
        <source>Draw the triangle of the eye, the axis, and the picture&apos;s right edge: {0} along the axis, 1 across it.</source>
        <translation>Нацртајте троугао који чине камера, оса и десна ивица слике: {0} дуж осе, 1 попреко.</translation>
    </message>
    <message>
        <source>Its angle at the eye is half of {0}.</source>
        <translation>Његов угао код камере је половина од {0}.</translation>
    </message>
    <message>
        <source>Practise: a wide picture on purpose</source>
        <translation>Вежба: намерно широка слика</translation>
    </message>
    <message>
        <source>Set the vertical angle in the dock; the picture keeps its pixels.</source>
        <translation>Поставите вертикални угао у бочном панелу; слика задржава своје пикселе.</translation>
    </message>
    <message>
        <source>The picture has {0} by 600 pixels. Make the horizontal angle {1}°.</source>
        <translation>Слика има {0} пута 600 пиксела. Нека хоризонтални угао буде {1}°.</translation>
    </message>
    <message>
        <source>Half of {0}° has the tangent {1}.</source>
        <translation>Половина од {0}° има тангенс {1}.</translation>
    </message>
    <message>
        <source>Half of the vertical angle has {0} of that tangent.</source>
        <translation>Половина вертикалног угла има {0} тог тангенса.</translation>
    </message>
    <message>
        <source>The field of view that you set is the vertical one. Look from above: the pyramid is wider than {0}°.</source>
        <translation>Видно поље које постављате је вертикално. Погледајте одозго: пирамида је шира од {0}°.</translation>
    </message>
    <message>
        <source>Angles are not in the ratio of the sides; the tangents of the half angles are. Look from above: the pyramid is narrower than {0}°.</source>
        <translation>У односу страница нису углови, него тангенси половина углова. Погледајте одозго: пирамида је ужа од {0}°.</translation>
    </message>
</context>
<context>
    <name>l04-view-volumes</name>
    <message>
        <source>What fits into the view volume?</source>
        <translation>Шта стаје у запремину погледа?</translation>
    </message>
    <message>
        <source>Twice as deep in the box</source>
        <translation>Двапут дубље у квадру</translation>
    </message>
    <message>
        <source>Only what lies in the view volume is drawn. Here it is a pyramid without its tip: **World** shows it, with five test cubes of one size, A to E. Cube B (probe 1) is 4 units deep, A (probe 2) is 8 units deep. B lies outside the pyramid, so its name is grey there. A box that contains both cubes will now replace the pyramid.</source>
        <translation>Црта се само оно што лежи у запремини погледа. Овде је то пирамида без врха: **Свет** је показује, са пет тест коцки исте величине, од A до E. Коцка B (сонда 1) је на дубини од 4 јединице, A (сонда 2) на дубини од 8. B лежи изван пирамиде, па је њено име тамо сиво. Квадар који садржи обе коцке сада ће заменити пирамиду.</translation>
    </message>
    <message>
        <source>In the picture of the box: how wide is cube A, as a multiple of cube B, which is half as deep?</source>
        <translation>На слици квадра: колико је пута коцка A шира од коцке B, која је на двапут мањој дубини?</translation>
    </message>
    <message>
        <source>This divides by the depth, as a pyramid does. Look at a pyramid wide enough for both: here A is half as wide as B, because its projectors meet. Those of the box do not.</source>
        <translation>Овде се дели дубином, као код пирамиде. Погледајте пирамиду довољно широку за обе: ту је A упола ужа од B, јер се њени зраци пројекције секу. Зраци квадра се не секу.</translation>
    </message>
    <message>
        <source>Nothing is larger for being farther away. Twice the depth would halve it in a pyramid. Look at the box: A and B are equally wide.</source>
        <translation>Ништа није веће зато што је даље. Двострука дубина би то у пирамиди преполовила. Погледајте квадар: A и B су једнако широке.</translation>
    </message>
    <message>
        <source>The projectors of a box are parallel. Everything is divided by the same w = 1, whatever its depth.</source>
        <translation>Зраци пројекције квадра су паралелни. Све се дели истим w = 1, ма колика била дубина.</translation>
    </message>
    <message>
        <source>The pyramid grows, the box does not</source>
        <translation>Пирамида расте, квадар не</translation>
    </message>
    <message>
        <source>With the vertical angle {0} the pyramid reaches, at the depth {1}, up to</source>
        <translation>Са вертикалним углом {0} пирамида на дубини {1} досеже до</translation>
    </message>
    <message>
        <source>above the axis, and {0} of that to the side. Here {1}.</source>
        <translation>изнад осе, а {0} од тога у страну. Овде је {1}.</translation>
    </message>
    <message>
        <source>depth</source>
        <translation>дубина</translation>
    </message>
    <message>
        <source>height</source>
        <translation>висина</translation>
    </message>
    <message>
        <source>to the side</source>
        <translation>у страну</translation>
    </message>
    <message>
        <source>4, cube B</source>
        <translation>4, коцка B</translation>
    </message>
    <message>
        <source>8, cube A</source>
        <translation>8, коцка A</translation>
    </message>
    <message>
        <source>12, cube C</source>
        <translation>12, коцка C</translation>
    </message>
    <message>
        <source>The box has, at every depth, the sides that the pyramid has at the target, 8 units away: 2.91 and 5.18. Cube B stands 3 to the side: outside 2.59, inside 5.18. **World**, seen from *Above*, shows the pyramid.</source>
        <translation>Квадар на свакој дубини има стране које пирамида има код циља, на 8 јединица: 2.91 и 5.18. Коцка B стоји 3 у страну: изван 2.59, унутар 5.18. **Свет**, гледан *Одозго*, показује пирамиду.</translation>
    </message>
    <message>
        <source>In the box, not in the pyramid</source>
        <translation>У квадру, а не у пирамиди</translation>
    </message>
    <message>
        <source>Now the volume is the box. Probe 1 is at cube A, in both volumes. Drag it in **Image**, or type {0}, {1}, {2} in the world in *Probe*. The eye is at {3} and looks along {4}.</source>
        <translation>Сада је запремина квадар. Сонда 1 је код коцке A, у обема запреминама. Превуците је у приказу **Слика**, или у панелу *Сонда* унесите {0}, {1}, {2} у свету. Позиција камере је {3}, а гледа дуж {4}.</translation>
    </message>
    <message>
        <source>Keep the box, and bring probe 1 to a place that is in the box but was outside the 40° pyramid.</source>
        <translation>Задржите квадар и доведите сонду 1 на место које је у квадру, а било је изван пирамиде од 40°.</translation>
    </message>
    <message>
        <source>Where is the pyramid narrower than the box?</source>
        <translation>Где је пирамида ужа од квадра?</translation>
    </message>
    <message>
        <source>Nearer to the eye than the target: there a point at the side of the box is beside the pyramid.</source>
        <translation>Ближе камери него што је циљ: тамо је тачка уз бочну страну квадра поред пирамиде.</translation>
    </message>
    <message>
        <source>Right: in front of the target the box is wider than the pyramid, behind it narrower.</source>
        <translation>Тачно: испред циља квадар је шири од пирамиде, иза њега ужи.</translation>
    </message>
    <message>
        <source>The other way round</source>
        <translation>Обрнуто</translation>
    </message>
    <message>
        <source>The pyramid again, with near at 3 and far at 13. A grey name in **World** is outside. In the dock, *View volume* switches between the box and the pyramid.</source>
        <translation>Поново пирамида, са предњом равни на 3 и задњом на 13. Сиво име у приказу **Свет** је изван. У бочном панелу *Запремина погледа* прелази са квадра на пирамиду и обратно.</translation>
    </message>
    <message>
        <source>Which cube is in the pyramid, but not in the box?</source>
        <translation>Која је коцка у пирамиди, а није у квадру?</translation>
    </message>
    <message>
        <source>B</source>
        <translation>B</translation>
    </message>
    <message>
        <source>B is the other way round: in the box, but beside the pyramid. Look at the box: B is inside.</source>
        <translation>Са B је обрнуто: у квадру је, али поред пирамиде. Погледајте квадар: B је унутра.</translation>
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
        <translation>E је у обе: дубоко је, али близу осе. Погледајте квадар: и E је унутра.</translation>
    </message>
    <message>
        <source>None: C is 13.9 from the eye, beyond far</source>
        <translation>Ниједна: C је 13.9 од камере, иза задње равни</translation>
    </message>
    <message>
        <source>Far is a plane across the axis: only the depth of 12 counts, not the 13.9. Look from above: C lies before far.</source>
        <translation>Задња раван је раван попреко на осу: рачуна се само дубина од 12, а не 13.9. Погледајте одозго: C лежи испред задње равни.</translation>
    </message>
    <message>
        <source>C is 12 deep and 7 to the side. There the pyramid reaches 7.76 to the side, the box only 5.18.</source>
        <translation>C је на дубини 12 и 7 у страну. Тамо пирамида досеже 7.76 у страну, а квадар само 5.18.</translation>
    </message>
    <message>
        <source>How high at depth 10?</source>
        <translation>Колико високо на дубини 10?</translation>
    </message>
    <message>
        <source>Now the angle is 50° and the depth is 10.</source>
        <translation>Сада је угао 50°, а дубина 10.</translation>
    </message>
    <message>
        <source>How far above the axis does the pyramid reach there?</source>
        <translation>Колико изнад осе пирамида тамо досеже?</translation>
    </message>
    <message>
        <source>The triangle of eye, axis and upper plane has half of the angle at the eye. Look at 90°: there the pyramid is as high as it is deep, {0}.</source>
        <translation>Троугао који чине камера, оса и горња раван има код камере половину угла. Погледајте 90°: тамо је пирамида висока колико је и дубока, {0}.</translation>
    </message>
    <message>
        <source>The tangent takes my 25</source>
        <translation>Тангенс прима мојих 25</translation>
    </message>
    <message>
        <source>This is the tangent of 25 radians, almost four turns. Look at the angle: 25° is 0.436 radians.</source>
        <translation>Ово је тангенс од 25 радијана, скоро четири пуна круга. Погледајте угао: 25° је 0.436 радијана.</translation>
    </message>
    <message>
        <source>The right-angled triangle between eye, axis and upper plane has half of the angle at the eye.</source>
        <translation>Правоугли троугао између камере, осе и горње равни има код камере половину угла.</translation>
    </message>
    <message>
        <source>h = 10·tan 25° = 4.66</source>
        <translation>h = 10·tan 25° = 4.66</translation>
    </message>
    <message>
        <source>Three to the side at depth 6</source>
        <translation>Три у страну на дубини 6</translation>
    </message>
    <message>
        <source>The picture is 16 by 9. **World** shows the pyramid from *Above*; the label at the eye gives half of the horizontal angle.</source>
        <translation>Слика је 16 према 9. **Свет** показује пирамиду *Одозго*; ознака код камере даје половину хоризонталног угла.</translation>
    </message>
    <message>
        <source>Keep the pyramid, and set the field of view so that it reaches 3 units to each side of the axis at depth 6.</source>
        <translation>Задржите пирамиду и поставите видно поље тако да на дубини 6 досеже 3 јединице на сваку страну осе.</translation>
    </message>
    <message>
        <source>Half of the horizontal angle has the tangent 3/6.</source>
        <translation>Половина хоризонталног угла има тангенс 3/6.</translation>
    </message>
    <message>
        <source>Half of the vertical one has 9/16 of that tangent: 0.281.</source>
        <translation>Половина вертикалног има 9/16 тог тангенса: 0.281.</translation>
    </message>
    <message>
        <source>Right: horizontally 53.1°, vertically 31.4° in this picture.</source>
        <translation>Тачно: на овој слици хоризонтално 53.1°, вертикално 31.4°.</translation>
    </message>
    <message>
        <source>Back to the prediction</source>
        <translation>Назад на предвиђање</translation>
    </message>
    <message>
        <source>It is tempting to expect the farther cube to be smaller: every picture of an eye or a camera shows it so, and it is true of the pyramid, whose section grows with the depth. A cube takes a smaller share of a larger section.</source>
        <translation>Примамљиво је очекивати да даља коцка буде мања: тако показује свака слика ока или камере, и за пирамиду је то истина, јер њен пресек расте са дубином. Коцка заузима мањи део већег пресека.</translation>
    </message>
    <message>
        <source>The section of the box does not grow. A cube takes the same share of it at every depth. The picture loses the impression of depth: in **Image** nothing says that B is the nearer one.</source>
        <translation>Пресек квадра не расте. Коцка заузима исти његов део на свакој дубини. Слика губи утисак дубине: у приказу **Слика** ништа не говори да је B ближа.</translation>
    </message>
    <message>
        <source>Practise: which point goes first?</source>
        <translation>Вежба: која тачка отпада прва?</translation>
    </message>
    <message>
        <source>You see the pyramid from above. Points 1, 2 and 3 are in it, at the height of the eye.</source>
        <translation>Пирамиду видите одозго. Тачке 1, 2 и 3 су у њој, на висини камере.</translation>
    </message>
    <message>
        <source>The far plane moves towards the eye. Mark the point that it cuts off first.</source>
        <translation>Задња раван се помера ка камери. Обележите тачку коју прву одсече.</translation>
    </message>
    <message>
        <source>Far is a plane, so the depth counts, not the distance from the eye. Look at far, moved in: it has cut off another point, and this one is still before it.</source>
        <translation>Задња раван је раван, па се рачуна дубина, а не растојање од камере. Погледајте примакнуту задњу раван: одсекла је другу тачку, а ова је још испред ње.</translation>
    </message>
    <message>
        <source>Far meets the nearest point first</source>
        <translation>Задња раван прво наилази на најближу тачку</translation>
    </message>
    <message>
        <source>The far plane reaches this point last: it is the one that is least deep. Look at far, moved in to just behind this point: the other two are cut off.</source>
        <translation>Задња раван до ове тачке стиже последње: она је на најмањој дубини. Погледајте задњу раван примакнуту одмах иза ове тачке: друге две су одсечене.</translation>
    </message>
    <message>
        <source>How does the far plane look from above?</source>
        <translation>Како задња раван изгледа одозго?</translation>
    </message>
    <message>
        <source>It is {0} deep, the one at the side {1}, and the third {2}.</source>
        <translation>Она је на дубини {0}, она са стране на {1}, а трећа на {2}.</translation>
    </message>
    <message>
        <source>Practise: how high?</source>
        <translation>Вежба: колико високо?</translation>
    </message>
    <message>
        <source>You see the pyramid from the side; {0} is its vertical angle.</source>
        <translation>Пирамиду видите са стране; {0} је њен вертикални угао.</translation>
    </message>
    <message>
        <source>Here {0}. How far above the axis does the pyramid reach at the depth {1}?</source>
        <translation>Овде је {0}. Колико изнад осе пирамида досеже на дубини {1}?</translation>
    </message>
    <message>
        <source>The tangent takes my degrees</source>
        <translation>Тангенс прима моје степене</translation>
    </message>
    <message>
        <source>This takes {0}° for {1} radians, which is more than a whole turn. Look at the angle: it is less than a quarter of one.</source>
        <translation>Овде је {0}° узето као {1} у радијанима, а то је више од целог круга. Погледајте угао: мањи је од четвртине круга.</translation>
    </message>
    <message>
        <source>In the triangle of eye, axis and upper plane, the angle at the eye is half of {0}.</source>
        <translation>У троуглу који чине камера, оса и горња раван угао код камере је половина од {0}.</translation>
    </message>
    <message>
        <source>Practise: how far to the side?</source>
        <translation>Вежба: колико у страну?</translation>
    </message>
    <message>
        <source>The picture is 16 by 9. **World** shows the pyramid from above.</source>
        <translation>Слика је 16 према 9. **Свет** показује пирамиду одозго.</translation>
    </message>
    <message>
        <source>Set the field of view so that the pyramid reaches {0} units to each side of the axis at the depth {1}.</source>
        <translation>Поставите видно поље тако да пирамида на дубини {1} досеже {0} на сваку страну осе.</translation>
    </message>
    <message>
        <source>Half of the horizontal angle has the tangent {0}/{1}.</source>
        <translation>Половина хоризонталног угла има тангенс {0}/{1}.</translation>
    </message>
    <message>
        <source>Half of the vertical angle has 9/16 of that tangent.</source>
        <translation>Половина вертикалног угла има 9/16 тог тангенса.</translation>
    </message>
    <message>
        <source>Half of the vertical angle has the tangent {0}, so the angle is {1} {2}.</source>
        <translation>Половина вертикалног угла има тангенс {0}, па је угао {1} {2}.</translation>
    </message>
    <message>
        <source>The triangle of eye, axis and side has half of the horizontal angle at the eye. Look from above: at the depth {0} the pyramid does not reach {1} to the side.</source>
        <translation>Троугао који чине камера, оса и бочна страна има код камере половину хоризонталног угла. Погледајте одозго: на дубини {0} пирамида не досеже {1} у страну.</translation>
    </message>
    <message>
        <source>The field of view is the vertical angle. Look from above: at the depth {0} the pyramid reaches {1} to the side.</source>
        <translation>Видно поље је вертикални угао. Погледајте одозго: на дубини {0} пирамида досеже {1} у страну.</translation>
    </message>
</context>
<context>
    <name>l05-similar-triangles</name>
    <message>
        <source>How big on the picture plane?</source>
        <translation>Колико је велико на равни слике?</translation>
    </message>
    <message>
        <source>The plane moves out</source>
        <translation>Раван се одмиче</translation>
    </message>
    <message>
        <source>The picture plane stands at the distance {0} in front of the eye. P is 5 units deep and 2 units above the axis. In **World**, from the *Side*, its projector runs to the eye and meets the plane at P&apos;, {1} above the axis. The plane will now move to {2}.</source>
        <translation>Раван слике стоји на растојању {0} испред камере. P је на дубини 5 и 2 јединице изнад осе. У приказу **Свет**, гледано *Са стране*, њен зрак пројекције иде ка камери и сече раван у P&apos;, {1} изнад осе. Раван ће се сада померити на {2}.</translation>
    </message>
    <message>
        <source>How many times as high as before is P&apos; above the axis then?</source>
        <translation>Колико је пута P&apos; тада више изнад осе него пре?</translation>
    </message>
    <message>
        <source>This measures from the plane to P. The two triangles share the corner at the eye. Look at {0}: from the eye P is 5 deep, wherever the plane is.</source>
        <translation>Овде се мери од равни до P. Два троугла деле теме код камере. Погледајте {0}: од камере је P на дубини 5, ма где била раван.</translation>
    </message>
    <message>
        <source>The area of an image grows 4 times. Its height and its width grow in proportion to d. Look at {0} and {1}: both are twice as long as before.</source>
        <translation>Површина слике порасте 4 пута. Њена висина и ширина расту сразмерно са d. Погледајте {0} и {1}: оба су двапут дужа него пре.</translation>
    </message>
    <message>
        <source>The height is proportional to d as long as P stays where it is.</source>
        <translation>Висина је сразмерна са d докле год P остаје где јесте.</translation>
    </message>
    <message>
        <source>Two similar triangles</source>
        <translation>Два слична троугла</translation>
    </message>
    <message>
        <source>The large triangle runs from the eye along the axis to the depth of P, and up to P: its sides are {0} and {1}. The small one runs along the axis to the plane, and up to P&apos;: {2} and {3}. Both have the same angle at the eye:</source>
        <translation>Велики троугао иде од камере дуж осе до дубине тачке P, па нагоре до P: његове странице су {0} и {1}. Мали иде дуж осе до равни, па нагоре до P&apos;: {2} и {3}. Оба имају исти угао код камере:</translation>
    </message>
    <message>
        <source>P is {0} in camera space. With {1}: {2}. The dock has the numbers and the matrix with {3}. It takes P to {4}; divided by the last number, that is {5}.</source>
        <translation>P је {0} у координатном систему камере. Са {1}: {2}. Бочни панел има бројеве и матрицу са {3}. Она преводи P у {4}; подељено последњим бројем, то је {5}.</translation>
    </message>
    <message>
        <source>Half as large as the thing itself</source>
        <translation>Упола мања од самог предмета</translation>
    </message>
    <message>
        <source>You can also use the triangles the other way round: how far away must the plane be?</source>
        <translation>Троуглове можете употребити и обрнуто: на ком растојању мора бити раван?</translation>
    </message>
    <message>
        <source>Make the image of P half as far from the axis as P itself: {0}, {1}.</source>
        <translation>Нека слика тачке P буде од осе упола ближа него сама P: {0}, {1}.</translation>
    </message>
    <message>
        <source>The scale is {0}. It is a number in the dock.</source>
        <translation>Размера је {0}. То је број у бочном панелу.</translation>
    </message>
    <message>
        <source>The plane must be halfway between the eye and the depth of P.</source>
        <translation>Раван мора бити на пола пута између камере и дубине тачке P.</translation>
    </message>
    <message>
        <source>Right: half way, half the size. Nothing else affects the scale.</source>
        <translation>Тачно: пола пута, пола величине. Ништа друго не утиче на размеру.</translation>
    </message>
    <message>
        <source>Another point</source>
        <translation>Друга тачка</translation>
    </message>
    <message>
        <source>Now P is at {0} in camera space, and the plane is at {1}. The numbers in the dock come back with your answer.</source>
        <translation>Сада је P у {0} у координатном систему камере, а раван је на {1}. Бројеви у бочном панелу враћају се са вашим одговором.</translation>
    </message>
    <message>
        <source>How large is {0}?</source>
        <translation>Колико је {0}?</translation>
    </message>
    <message>
        <source>This divides by the distance from the plane to P. Look at {0} and {1}: both begin at the eye, where the two triangles have their common corner.</source>
        <translation>Овде се дели растојањем од равни до P. Погледајте {0} и {1}: оба почињу код камере, где два троугла имају заједничко теме.</translation>
    </message>
    <message>
        <source>In front of the eye {0} is negative, so divide by {1}. Look at the plane behind the eye: only there is the image below the axis.</source>
        <translation>Испред камере је {0} негативно, па делите са {1}. Погледајте раван иза камере: само тамо је слика испод осе.</translation>
    </message>
    <message>
        <source>The ratio of {0} to {1} equals the ratio of {2} to the depth.</source>
        <translation>Однос {0} према {1} једнак је односу {2} према дубини.</translation>
    </message>
    <message>
        <source>The cell with d</source>
        <translation>Поље са d</translation>
    </message>
    <message>
        <source>As a matrix (000, formula 2) the projection leaves {0}, {1} and {2} as they are and makes the fourth coordinate {3}. The division does the rest.</source>
        <translation>Као матрица (000, формула 2) пројекција оставља {0}, {1} и {2} каква јесу, а за четврту координату даје {3}. Остало ради дељење.</translation>
    </message>
    <message>
        <source>The plane is at {0}. Which number is in row 4, column 3?</source>
        <translation>Раван је на {0}. Који број стоји у врсти 4, колони 3?</translation>
    </message>
    <message>
        <source>There is no minus in the matrix</source>
        <translation>У матрици нема минуса</translation>
    </message>
    <message>
        <source>Then the fourth coordinate would be {0}. For points in front of the eye {1} is negative, so {2} and {3} would change their signs. Look at the plane of this matrix: it is behind the eye, and the image is upside down.</source>
        <translation>Тада би четврта координата била {0}. За тачке испред камере {1} је негативно, па би {2} и {3} променили предзнак. Погледајте раван ове матрице: она је иза камере, а слика је наопачке.</translation>
    </message>
    <message>
        <source>This is row 3, column 4. Row 4 makes the fourth coordinate, {0}, and column 3 is the share of {1}. Look at {2} and {3}: their ratio is the divisor.</source>
        <translation>Ово је врста 3, колона 4. Врста 4 даје четврту координату, {0}, а колона 3 је удео од {1}. Погледајте {2} и {3}: њихов однос је делилац.</translation>
    </message>
    <message>
        <source>Row 4 times (x, y, z, 1) must equal {0}.</source>
        <translation>Врста 4 пута (x, y, z, 1) мора бити једнака {0}.</translation>
    </message>
    <message>
        <source>{0}. For points in front {1} is negative, and so {2} is positive.</source>
        <translation>{0}. За тачке испред камере {1} је негативно, па је {2} позитивно.</translation>
    </message>
    <message>
        <source>Set the plane</source>
        <translation>Поставите раван</translation>
    </message>
    <message>
        <source>P is at {0} in camera space again, and the plane is at {1}.</source>
        <translation>P је поново у {0} у координатном систему камере, а раван је на {1}.</translation>
    </message>
    <message>
        <source>Keep P in its place, and move the plane until the image of P is 1.5 above the axis.</source>
        <translation>Оставите P на месту и померајте раван док слика тачке P не буде 1.5 изнад осе.</translation>
    </message>
    <message>
        <source>1.5 is three quarters of 2.</source>
        <translation>1.5 је три четвртине од 2.</translation>
    </message>
    <message>
        <source>Right: three quarters of the height, three quarters of the way: d = 3.75.</source>
        <translation>Тачно: три четвртине висине, три четвртине пута: d = 3.75.</translation>
    </message>
    <message>
        <source>Back to the prediction</source>
        <translation>Назад на предвиђање</translation>
    </message>
    <message>
        <source>It is tempting to measure from the plane to P: 4 units before, 3 units after, so {0} against {1}, which is 2.67 times. But the two triangles share the corner at the eye. Measured from there, P stays 5 units deep wherever the plane is, and {2} grows from {3} to {4}.</source>
        <translation>Примамљиво је мерити од равни до P: 4 јединице пре, 3 јединице после, дакле {0} према {1}, што је 2.67 пута. Али два троугла деле теме код камере. Мерено одатле, P остаје на дубини 5 ма где била раван, а {2} расте од {3} на {4}.</translation>
    </message>
    <message>
        <source>This also says what happens to the *picture* when the plane moves: everything grows by the same factor, and nothing moves against the rest.</source>
        <translation>То говори и шта бива са *сликом* када се раван помера: све расте истим чиниоцем, и ништа се не помера у односу на остало.</translation>
    </message>
    <message>
        <source>Practise: how high is the image?</source>
        <translation>Вежба: колико је слика висока?</translation>
    </message>
    <message>
        <source>P is in camera space, and the picture plane is at the distance {0} from the eye.</source>
        <translation>P је у координатном систему камере, а раван слике је на растојању {0} од камере.</translation>
    </message>
    <message>
        <source>P is at {0}, and {1}. How large is {2}?</source>
        <translation>P је у {0}, и {1}. Колико је {2}?</translation>
    </message>
    <message>
        <source>The two similar triangles share the corner at the eye.</source>
        <translation>Два слична троугла деле теме код камере.</translation>
    </message>
    <message>
        <source>Practise: the matrix with -1/d</source>
        <translation>Вежба: матрица са -1/d</translation>
    </message>
    <message>
        <source>The matrix keeps {0}, {1} and {2}; its row 4 has {3} in column 3 and zeros elsewhere. The division comes afterwards.</source>
        <translation>Матрица задржава {0}, {1} и {2}; њена врста 4 има {3} у колони 3, а другде нуле. Дељење долази после.</translation>
    </message>
    <message>
        <source>The plane is at {0}. What does the matrix make of {1}?</source>
        <translation>Раван је на {0}. Шта матрица прави од {1}?</translation>
    </message>
    <message>
        <source>In front of the eye {0} is negative, so the division would change the signs of {1} and {2}. Look at the plane of this matrix: it is behind the eye, and the image is upside down.</source>
        <translation>Испред камере је {0} негативно, па би дељење променило предзнаке за {1} и {2}. Погледајте раван ове матрице: она је иза камере, а слика је наопачке.</translation>
    </message>
    <message>
        <source>This has {0} in row 3, column 4. Row 4 makes the fourth coordinate, and column 3 is the share of {1}. Look at {2} and {3}: their ratio is the divisor.</source>
        <translation>Овде је {0} у врсти 3, колони 4. Врста 4 даје четврту координату, а колона 3 је удео од {1}. Погледајте {2} и {3}: њихов однос је делилац.</translation>
    </message>
    <message>
        <source>Row 4 times {0} is {1} times {2}.</source>
        <translation>Врста 4 пута {0} је {1} пута {2}.</translation>
    </message>
    <message>
        <source>Divided by its last number, it is P&apos;: {0}.</source>
        <translation>Подељено својим последњим бројем, то је P&apos;: {0}.</translation>
    </message>
    <message>
        <source>Practise: set the plane</source>
        <translation>Вежба: поставите раван</translation>
    </message>
    <message>
        <source>The plane is at {0}. Drag it, or type {1} in the dock.</source>
        <translation>Раван је на {0}. Превуците је, или унесите {1} у бочном панелу.</translation>
    </message>
    <message>
        <source>P is {0} deep and {1} above the axis. Leave it there, and move the plane until the image P&apos; is {2} above the axis.</source>
        <translation>P је на дубини {0} и {1} изнад осе. Оставите је тамо и померајте раван док слика P&apos; не буде {2} изнад осе.</translation>
    </message>
    <message>
        <source>Your plane is behind the eye. Look at P&apos;: it is below the axis.</source>
        <translation>Ваша раван је иза камере. Погледајте P&apos;: она је испод осе.</translation>
    </message>
    <message>
        <source>This measures the depth of P from the plane. Both triangles begin at the eye. Look at P&apos;: it is less than {0} above the axis.</source>
        <translation>Овде се дубина тачке P мери од равни. Оба троугла почињу код камере. Погледајте P&apos;: она је мање од {0} изнад осе.</translation>
    </message>
</context>
<context>
    <name>l06-off-axis-frustum</name>
    <message>
        <source>Why six numbers?</source>
        <translation>Зашто шест бројева?</translation>
    </message>
    <message>
        <source>The window goes to the right</source>
        <translation>Прозор иде удесно</translation>
    </message>
    <message>
        <source>A frustum is given by six numbers: left, right, bottom and top of its window on the near plane, and near and far. The window here reaches from {0} to {1}; the point straight ahead of the eye, probe 1, is in the middle of **Image**. The eye stays where it is, and the window moves to the right: {2}, {3}.</source>
        <translation>Зарубљена пирамида се задаје са шест бројева: лево, десно, доле и горе за њен прозор на предњој равни, и предња и задња раван. Прозор овде досеже од {0} до {1}; тачка право испред камере, сонда 1, у средини је приказа **Слика**. Камера остаје где јесте, а прозор се помера удесно: {2}, {3}.</translation>
    </message>
    <message>
        <source>Where is probe 1 in the picture then? NDC has {0} at the left edge and {1} at the right one.</source>
        <translation>Где је тада сонда 1 на слици? NDC има {0} на левој ивици и {1} на десној.</translation>
    </message>
    <message>
        <source>Straight ahead is in the middle only if the window is as far to the left as to the right. Look at this window: it reaches 2 to each side, and probe 1 is in the middle.</source>
        <translation>Право испред је у средини само ако прозор улево досеже колико и удесно. Погледајте овај прозор: досеже 2 на обе стране, и сонда 1 је у средини.</translation>
    </message>
    <message>
        <source>This moves the picture with its window. Look at the window that has moved to the left: only then is probe 1 at {0}.</source>
        <translation>Овде се слика помера са својим прозором. Погледајте прозор померен улево: само тада је сонда 1 у {0}.</translation>
    </message>
    <message>
        <source>There is now 1 unit of window left of the axis, and 3 units right of it. So the axis is a quarter of the way across.</source>
        <translation>Сада је лево од осе 1 јединица прозора, а десно од ње 3 јединице. Зато је оса на четвртини ширине.</translation>
    </message>
    <message>
        <source>From the window to [-1, 1]</source>
        <translation>Од прозора до [-1, 1]</translation>
    </message>
    <message>
        <source>First the point comes to the near plane, by similar triangles: {0}. Then the range {1} becomes {2}:</source>
        <translation>Прво тачка долази на предњу раван, по сличности троуглова: {0}. Затим опсег {1} постаје {2}:</translation>
    </message>
    <message>
        <source>With {0}, {1}, {2} the cells are {3} and {4}. The second one stands in column 3: it is multiplied by {5}, which is negative, and so the axis comes to {6}.</source>
        <translation>Са {0}, {1}, {2} поља су {3} и {4}. Друго стоји у колони 3: множи се са {5}, што је негативно, и тако оса долази у {6}.</translation>
    </message>
    <message>
        <source>Bottom, top and y work the same way. *Matrices* shows the whole matrix as clip ← view. For {0} that cell is 0, as in gluPerspective.</source>
        <translation>Доле, горе и y раде на исти начин. *Матрице* показују целу матрицу као „одсецање ← камера”. За {0} то поље је 0, као код gluPerspective.</translation>
    </message>
    <message>
        <source>The axis on the other side</source>
        <translation>Оса на другој страни</translation>
    </message>
    <message>
        <source>Probe 1 still is straight ahead of the eye. *Probe*, below the pictures, has its {0} in the row NDC.</source>
        <translation>Сонда 1 је и даље право испред камере. *Сонда*, испод слика, има њено {0} у реду NDC.</translation>
    </message>
    <message>
        <source>Bring the axis to the right half of the picture, to x&apos; = 0.5.</source>
        <translation>Доведите осу у десну половину слике, на x&apos; = 0.5.</translation>
    </message>
    <message>
        <source>Which side must the window reach farther to?</source>
        <translation>На коју страну прозор мора да досеже даље?</translation>
    </message>
    <message>
        <source>Three times as far to the left as to the right: Left −3, Right 1.</source>
        <translation>Трипут даље улево него удесно: Лево −3, Десно 1.</translation>
    </message>
    <message>
        <source>Right: three quarters of the window are left of the axis.</source>
        <translation>Тачно: три четвртине прозора су лево од осе.</translation>
    </message>
    <message>
        <source>The cell beside 2n/(r-l)</source>
        <translation>Поље поред 2n/(r-l)</translation>
    </message>
    <message>
        <source>The window now reaches from {0} to {1} on the near plane at {2}.</source>
        <translation>Прозор сада на предњој равни на {2} досеже од {0} до {1}.</translation>
    </message>
    <message>
        <source>Which number is in row 1, column 3 of the frustum matrix?</source>
        <translation>Који број стоји у врсти 1, колони 3 матрице зарубљене пирамиде?</translation>
    </message>
    <message>
        <source>The cell is positive if the window reaches farther to the right; {0}, which is negative, turns the sign. Look at the window from −4 to 1: it is the one with −0.6.</source>
        <translation>Поље је позитивно ако прозор досеже даље удесно; {0}, које је негативно, мења предзнак. Погледајте прозор од −4 до 1: он је онај са −0.6.</translation>
    </message>
    <message>
        <source>This is row 3, column 1. Row 1 makes {0}, and its column 3 is the share of {1}. Look at a symmetric window: only there is this share 0.</source>
        <translation>Ово је врста 3, колона 1. Врста 1 даје {0}, а њена колона 3 је удео од {1}. Погледајте симетричан прозор: само тамо је овај удео 0.</translation>
    </message>
    <message>
        <source>r + l is 3, r - l is 5.</source>
        <translation>r + l је 3, r - l је 5.</translation>
    </message>
    <message>
        <source>(r + l)/(r - l) = 3/5. The cell is multiplied by z, which is negative; that turns the sign.</source>
        <translation>(r + l)/(r - l) = 3/5. Поље се множи са z, које је негативно; то мења предзнак.</translation>
    </message>
    <message>
        <source>The cell for the depth</source>
        <translation>Поље за дубину</translation>
    </message>
    <message>
        <source>Row 3 is {0} with {1} and {2}.</source>
        <translation>Врста 3 је {0} са {1} и {2}.</translation>
    </message>
    <message>
        <source>Near is 2 and far is 10. How large is {0}, in row 3, column 4?</source>
        <translation>Предња раван је 2, а задња 10. Колико је {0}, у врсти 3, колони 4?</translation>
    </message>
    <message>
        <source>This uses {0} and {1}, but near and far are lengths. Look at the planes: both are in front of the eye, at negative {2}, and the formula already contains that minus.</source>
        <translation>Овде се узима {0} и {1}, али предња и задња раван су дужине. Погледајте равни: обе су испред камере, на негативном {2}, а формула тај минус већ садржи.</translation>
    </message>
    <message>
        <source>This is row 4, column 3, which makes {0}. {1} is added to {2} in row 3. Look at near and far: {3} and {4} take them to {5} and {6}.</source>
        <translation>Ово је врста 4, колона 3, која даје {0}. {1} се додаје на {2} у врсти 3. Погледајте предњу и задњу раван: {3} и {4} их преводе у {5} и {6}.</translation>
    </message>
    <message>
        <source>n and f are distances, and positive.</source>
        <translation>n и f су растојања, и позитивни су.</translation>
    </message>
    <message>
        <source>Back to the prediction</source>
        <translation>Назад на предвиђање</translation>
    </message>
    <message>
        <source>It is tempting to move the picture with the window: to the right, {0}. But the window is the frame through which you see the scene. If you move a frame to the right, you see more of what is on the right, and what was in the middle is now left of the middle.</source>
        <translation>Примамљиво је померити слику са прозором: удесно, {0}. Али прозор је рам кроз који видите сцену. Ако рам померите удесно, видите више онога што је десно, а оно што је било у средини сада је лево од средине.</translation>
    </message>
    <message>
        <source>The plus in {0} does not contradict this. The cell is multiplied by {1}, and {2} is {3} at probe 1: {4}. Lecture 002 writes a plus where its own signs require a minus. So always try such a sign on a point.</source>
        <translation>Плус у {0} томе не противречи. Поље се множи са {1}, а {2} је код сонде 1 {3}: {4}. Предавање 002 пише плус тамо где његови предзнаци траже минус. Зато такав предзнак увек испробајте на једној тачки.</translation>
    </message>
    <message>
        <source>Two eyes, one window</source>
        <translation>Два ока, један прозор</translation>
    </message>
    <message>
        <source>A stereo pair needs two such frusta: both eyes look through one window, the screen plane at {0}. The right eye is {1} to the right, so its window on the near plane, at {2}, is {3} farther left. Both {4} and {5} are 0.2 less; only the cell {6} changes.</source>
        <translation>Стереопару су потребне две такве зарубљене пирамиде: оба ока гледају кроз један прозор, раван екрана на {0}. Десно око је {1} удесно, па је његов прозор на предњој равни, на {2}, {3} више улево. И {4} и {5} мањи су за 0.2; мења се само поље {6}.</translation>
    </message>
    <message>
        <source>{0}, below the middle and right of it, is equally high in both pictures. Now both cameras get a symmetric frustum and turn to the middle of the screen plane, as eyes turn.</source>
        <translation>{0}, испод средине и десно од ње, на обе је слике на истој висини. Сада обе камере добијају симетричну пирамиду и окрећу се ка средини равни екрана, као што се окрећу очи.</translation>
    </message>
    <message>
        <source>How high is {0} in the right picture then?</source>
        <translation>На којој је висини {0} тада на десној слици?</translation>
    </message>
    <message>
        <source>Lower than in the left one</source>
        <translation>Ниже него на левој</translation>
    </message>
    <message>
        <source>As high as in the left one</source>
        <translation>На истој висини као на левој</translation>
    </message>
    <message>
        <source>Each turned camera divides by the depth along its own axis, and no pair of eyes can look up with one eye and down with the other. Look at {0}: it is not equally high in both pictures.</source>
        <translation>Свака окренута камера дели дубином дуж сопствене осе, а ниједан пар очију не може једним оком да гледа нагоре, а другим надоле. Погледајте {0}: није на истој висини на обе слике.</translation>
    </message>
    <message>
        <source>Higher than in the left one</source>
        <translation>Више него на левој</translation>
    </message>
    <message>
        <source>The right camera turns left, so {0}, on the right, is less deep for it. It divides by less, and {1} is farther from the middle. Look at {2} in both pictures: in the right one it is lower.</source>
        <translation>Десна камера се окреће улево, па је за њу {0}, које је десно, на мањој дубини. Она дели мањим бројем, и {1} је даље од средине. Погледајте {2} на обе слике: на десној је ниже.</translation>
    </message>
    <message>
        <source>Each camera divides by the depth along its own axis: 5.06 for the left one, 4.96 for the right one. The right one divides by less, so {0} is 3.5 pixels lower there. Off the axis both divide by 5.</source>
        <translation>Свака камера дели дубином дуж сопствене осе: 5.06 за леву, 4.96 за десну. Десна дели мањим бројем, па је {0} тамо 3.5 пиксела ниже. Са пирамидама ван осе обе деле са 5.</translation>
    </message>
    <message>
        <source>Practise: the row with l and r</source>
        <translation>Вежба: врста са l и r</translation>
    </message>
    <message>
        <source>The window on the near plane, at the distance {0}, reaches from {1} to {2} in x.</source>
        <translation>Прозор на предњој равни, на растојању {0}, досеже по x од {1} до {2}.</translation>
    </message>
    <message>
        <source>Here {0}, {1} and {2}. Which four numbers are in row 1 of the frustum matrix?</source>
        <translation>Овде је {0}, {1} и {2}. Која четири броја стоје у врсти 1 матрице зарубљене пирамиде?</translation>
    </message>
    <message>
        <source>The cell is positive if the window reaches farther to the right; {0}, which is negative, turns the sign. Look at the mirrored window: it is the one with your row.</source>
        <translation>Поље је позитивно ако прозор досеже даље удесно; {0}, које је негативно, мења предзнак. Погледајте прозор као у огледалу: он је онај са вашом врстом.</translation>
    </message>
    <message>
        <source>Row 1 makes {0}, and its column 3 is the share of {1}. Look at a symmetric window: only there is this share 0.</source>
        <translation>Врста 1 даје {0}, а њена колона 3 је удео од {1}. Погледајте симетричан прозор: само тамо је овај удео 0.</translation>
    </message>
    <message>
        <source>Row 1 times {0} is {1}.</source>
        <translation>Врста 1 пута {0} је {1}.</translation>
    </message>
    <message>
        <source>The axis comes to {0}, because {1} is negative.</source>
        <translation>Оса долази у {0}, јер је {1} негативно.</translation>
    </message>
    <message>
        <source>Practise: two images in the screen plane</source>
        <translation>Вежба: две слике у равни екрана</translation>
    </message>
    <message>
        <source>Two eyes, {0} apart, look through the screen plane at the distance {1}. For each eye {2}, at the distance {3}, has an image there: {4} and {5}.</source>
        <translation>Два ока, на размаку {0}, гледају кроз раван екрана на растојању {1}. За свако око {2}, на растојању {3}, има тамо слику: {4} и {5}.</translation>
    </message>
    <message>
        <source>The eyes are {0} apart, the screen plane is at {1}, and {2} is at {3}. How far to the right of {4} is {5}, in the screen plane? If it is to the left, the number is negative.</source>
        <translation>Очи су на размаку {0}, раван екрана је на {1}, а {2} на {3}. Колико је десно од {4} слика {5}, у равни екрана? Ако је лево, број је негативан.</translation>
    </message>
    <message>
        <source>The screen&apos;s distance is the height</source>
        <translation>Растојање екрана је висина</translation>
    </message>
    <message>
        <source>This takes the screen&apos;s distance for the height of the large triangle. That one reaches from {0} to the eyes, and its height is {1}. Look at both triangles.</source>
        <translation>Овде је растојање екрана узето за висину великог троугла. Он досеже од {0} до очију, и његова висина је {1}. Погледајте оба троугла.</translation>
    </message>
    <message>
        <source>Two symmetric frusta will do</source>
        <translation>Довољне су две симетричне пирамиде</translation>
    </message>
    <message>
        <source>This is what two symmetric frusta side by side show: what is infinitely far away would lie in the screen plane. The windows move by {0} against each other, so add {1}. Look at {2} and {3}: {4} is behind the screen plane, and they are closer together than the eyes.</source>
        <translation>То показују две симетричне пирамиде једна поред друге: оно што је бесконачно далеко лежало би у равни екрана. Прозори се померају за {0} један према другом, па додајте {1}. Погледајте {2} и {3}: {4} је иза равни екрана, а оне су ближе једна другој него очи.</translation>
    </message>
    <message>
        <source>Both eyes and {0} are a triangle, {1}, {2} and {3} another one, similar to it.</source>
        <translation>Оба ока и {0} чине један троугао, а {1}, {2} и {3} други, њему сличан.</translation>
    </message>
    <message>
        <source>Their heights are {0} and {1}. Before the screen plane the second one stands upside down.</source>
        <translation>Њихове висине су {0} и {1}. Испред равни екрана други стоји наопачке.</translation>
    </message>
    <message>
        <source>The triangles are similar, so {0}. What lies in the screen plane has {1}, and nothing behind it reaches {2}.</source>
        <translation>Троуглови су слични, па је {0}. Оно што лежи у равни екрана има {1}, а ништа иза ње не достиже {2}.</translation>
    </message>
    <message>
        <source>Practise: move the window</source>
        <translation>Вежба: померите прозор</translation>
    </message>
    <message>
        <source>The window reaches from {0} to {1} on the near plane.</source>
        <translation>Прозор на предњој равни досеже од {0} до {1}.</translation>
    </message>
    <message>
        <source>Make the cell in row 1, column 3 of the frustum matrix equal to {0}, and leave the cell in row 1, column 1 at {1}.</source>
        <translation>Нека поље у врсти 1, колони 3 матрице зарубљене пирамиде буде {0}, а поље у врсти 1, колони 1 оставите на {1}.</translation>
    </message>
    <message>
        <source>The cells are {0} and {1}.</source>
        <translation>Поља су {0} и {1}.</translation>
    </message>
    <message>
        <source>If {0} stays at {1}, the width {2} stays 4.</source>
        <translation>Ако {0} остане {1}, ширина {2} остаје 4.</translation>
    </message>
    <message>
        <source>With {0} the width {1} stays {2}, and {3}. So {4} and {5}.</source>
        <translation>Са {0} ширина {1} остаје {2}, и {3}. Дакле {4} и {5}.</translation>
    </message>
    <message>
        <source>The cell has the sign of {0}. Look at your window: it reaches farther to the other side.</source>
        <translation>Поље има предзнак израза {0}. Погледајте свој прозор: досеже даље на другу страну.</translation>
    </message>
</context>
<context>
    <name>l07-proportions</name>
    <message>
        <source>A picture of another shape</source>
        <translation>Слика другог облика</translation>
    </message>
    <message>
        <source>A wide window in a square picture</source>
        <translation>Широк прозор у квадратној слици</translation>
    </message>
    <message>
        <source>The window on the near plane is 4 wide and 2 high: {0} from -2 to 2, {1} from -1 to 1. The picture has 720 by 720 pixels. Stretched into it, the letter F is twice as high as it should be. Lecture 000 has two remedies. Variant X replaces {2} by {3} (and {4} by {5}), so that the proportions are right.</source>
        <translation>Прозор на предњој равни широк је 4, а висок 2: {0} од -2 до 2, {1} од -1 до 1. Слика има 720 пута 720 пиксела. Растегнуто у њу, слово F је двапут више него што треба. Предавање 000 има два лека. Варијанта X замењује {2} са {3} (и {4} са {5}), тако да су пропорције исправне.</translation>
    </message>
    <message>
        <source>How large is {0}?</source>
        <translation>Колико је {0}?</translation>
    </message>
    <message>
        <source>Variant X *keeps* x. Look at variant Y: it is the one that leaves y as it is, and adjusts x.</source>
        <translation>Варијанта X *задржава* x. Погледајте варијанту Y: она је та која y оставља какво јесте, а прилагођава x.</translation>
    </message>
    <message>
        <source>This adds the whole missing length at each end. Look at the picture: the window is 6 high and 4 wide now, and the F is too low.</source>
        <translation>Овде се на сваком крају додаје цела дужина која недостаје. Погледајте слику: прозор је сада висок 6, а широк 4, и слово F је прениско.</translation>
    </message>
    <message>
        <source>The window must become as high as it is wide, 4. It grows equally at both ends: by 1 below and by 1 above.</source>
        <translation>Прозор мора постати висок колико је и широк, 4. Расте једнако на оба краја: за 1 доле и за 1 горе.</translation>
    </message>
    <message>
        <source>The number k</source>
        <translation>Број k</translation>
    </message>
    <message>
        <source>Only the proportions matter: circles stay round if</source>
        <translation>Важне су само пропорције: кругови остају округли ако је</translation>
    </message>
    <message>
        <source>Variant X keeps {0} and adds {1} at both ends of {2}:</source>
        <translation>Варијанта X задржава {0} и додаје {1} на оба краја опсега {2}:</translation>
    </message>
    <message>
        <source>Here {0}, so {1} goes from {2} to {3}. Variant Y keeps {4}: {5}, and {6} goes from {7} to {8}. **World** has {9}, {10} and {11} at the window. **Image** shows the three: stretched, variant Y, variant X. In the dock they are **Proportions**, in *More of the lens*.</source>
        <translation>Овде је {0}, па {1} иде од {2} до {3}. Варијанта Y задржава {4}: {5}, и {6} иде од {7} до {8}. **Свет** има {9}, {10} и {11} код прозора. **Слика** показује све три: растегнуто, варијанту Y, варијанту X. У бочном панелу то су **Пропорције**, у одељку *Још о објективу*.</translation>
    </message>
    <message>
        <source>stretched</source>
        <translation>растегнуто</translation>
    </message>
    <message>
        <source>variant Y</source>
        <translation>варијанта Y</translation>
    </message>
    <message>
        <source>variant X</source>
        <translation>варијанта X</translation>
    </message>
    <message>
        <source>Cubes that are cubes</source>
        <translation>Коцке које јесу коцке</translation>
    </message>
    <message>
        <source>The picture is stretched.</source>
        <translation>Слика је растегнута.</translation>
    </message>
    <message>
        <source>Give the picture its right proportions: choose keep x, fit y.</source>
        <translation>Дајте слици исправне пропорције: изаберите „задржи x, уклопи y”.</translation>
    </message>
    <message>
        <source>Find Proportions in the dock: More of the lens.</source>
        <translation>Нађите „Пропорције” у бочном панелу: „Још о објективу”.</translation>
    </message>
    <message>
        <source>Right: a unit of x has as many pixels as a unit of y. The fields still show the typed window.</source>
        <translation>Тачно: јединица по x има онолико пиксела колико и јединица по y. Поља и даље показују унети прозор.</translation>
    </message>
    <message>
        <source>A picture twice as wide as high</source>
        <translation>Слика двапут шира него виша</translation>
    </message>
    <message>
        <source>The window is {0} from -3 to 3, {1} from -1 to 1. The picture has 1000 by 500 pixels.</source>
        <translation>Прозор је {0} од -3 до 3, {1} од -1 до 1. Слика има 1000 пута 500 пиксела.</translation>
    </message>
    <message>
        <source>Variant X: how large is {0}?</source>
        <translation>Варијанта X: колико је {0}?</translation>
    </message>
    <message>
        <source>This adds the whole missing length at each end. Look at the picture: the window is 4 high and 6 wide now, not twice as wide as high, and the F is too low.</source>
        <translation>Овде се на сваком крају додаје цела дужина која недостаје. Погледајте слику: прозор је сада висок 4, а широк 6, што није двапут шире него више, и слово F је прениско.</translation>
    </message>
    <message>
        <source>How high must a window be that is 6 wide, for a picture of 1000 by 500?</source>
        <translation>Колико висок мора бити прозор широк 6, за слику од 1000 пута 500?</translation>
    </message>
    <message>
        <source>3 high, and it is 2 high now.</source>
        <translation>Висок 3, а сада је висок 2.</translation>
    </message>
    <message>
        <source>{0}, and so {1} goes from {2} to 1.5.</source>
        <translation>{0}, па {1} иде од {2} до 1.5.</translation>
    </message>
    <message>
        <source>Variant Y</source>
        <translation>Варијанта Y</translation>
    </message>
    <message>
        <source>Variant Y keeps {0} and adds {1} at both ends of {2}: {3}. (The last line of the handout has {4} there, which is a slip.)</source>
        <translation>Варијанта Y задржава {0} и додаје {1} на оба краја опсега {2}: {3}. (Последњи ред материјала тамо има {4}, што је омашка.)</translation>
    </message>
    <message>
        <source>The window is {0} from -1 to 3, {1} from -2 to 2, the picture 1000 by 500.</source>
        <translation>Прозор је {0} од -1 до 3, {1} од -2 до 2, а слика 1000 пута 500.</translation>
    </message>
    <message>
        <source>This adds the whole missing length at each end. Look at the picture: the window is 12 wide and 4 high now, not twice as wide as high, and the F is too narrow.</source>
        <translation>Овде се на сваком крају додаје цела дужина која недостаје. Погледајте слику: прозор је сада широк 12, а висок 4, што није двапут шире него више, и слово F је преуско.</translation>
    </message>
    <message>
        <source>Variant Y *keeps* y. Look at variant X: it is the one that leaves x as it is, and adjusts y.</source>
        <translation>Варијанта Y *задржава* y. Погледајте варијанту X: она је та која x оставља какво јесте, а прилагођава y.</translation>
    </message>
    <message>
        <source>The window must become 8 wide.</source>
        <translation>Прозор мора постати широк 8.</translation>
    </message>
    <message>
        <source>{0}, and so {1} goes from {2} to 5. Its middle is still 1.</source>
        <translation>{0}, па {1} иде од {2} до 5. Његова средина је и даље 1.</translation>
    </message>
    <message>
        <source>X by hand</source>
        <translation>X ручно</translation>
    </message>
    <message>
        <source>The picture is 720 by 720 and stretched; the window is {0} from -2 to 2, {1} from -1 to 1 again.</source>
        <translation>Слика је 720 пута 720 и растегнута; прозор је поново {0} од -2 до 2, {1} од -1 до 1.</translation>
    </message>
    <message>
        <source>Leave Proportions at stretch, and give Bottom and Top the values that variant X would.</source>
        <translation>Оставите „Пропорције” на „растегни” и дајте пољима „Доле” и „Горе” вредности које би дала варијанта X.</translation>
    </message>
    <message>
        <source>The window must be as high as it is wide.</source>
        <translation>Прозор мора бити висок колико је и широк.</translation>
    </message>
    <message>
        <source>Right: keep x does exactly this, and repeats it whenever the picture changes its shape.</source>
        <translation>Тачно: „задржи x” ради управо ово, и понавља га кад год слика промени облик.</translation>
    </message>
    <message>
        <source>Back to the prediction</source>
        <translation>Назад на предвиђање</translation>
    </message>
    <message>
        <source>Two answers are tempting. The answer 3 adds 2 units at each end, so the window would be 6 high instead of 4. {0} is *half* of what is missing, because it is added twice.</source>
        <translation>Два одговора су примамљива. Одговор 3 додаје 2 јединице на сваком крају, па би прозор био висок 6 уместо 4. {0} је *половина* онога што недостаје, јер се додаје двапут.</translation>
    </message>
    <message>
        <source>The answer 1 leaves {0} as it is: the name of the variant sounds as if X changed. But X is what it *keeps*. With the same letter F and the same eye, X shows more of the scene above and below; Y takes away at the sides.</source>
        <translation>Одговор 1 оставља {0} какво јесте: име варијанте звучи као да се X мења. Али X је оно што она *задржава*. Са истим словом F и истом позицијом камере, X показује више сцене горе и доле; Y одузима са страна.</translation>
    </message>
    <message>
        <source>Practise: how wide does Y make it?</source>
        <translation>Вежба: колико широко прави Y?</translation>
    </message>
    <message>
        <source>The picture is stretched. Variant Y keeps {0}, and makes the window as wide as the picture&apos;s proportions require.</source>
        <translation>Слика је растегнута. Варијанта Y задржава {0} и прави прозор онолико широк колико пропорције слике траже.</translation>
    </message>
    <message>
        <source>The window is {0} from {1} to {2}, {3} from {4} to {5}, the picture {6} by {7} pixels. How large is {8} in variant Y?</source>
        <translation>Прозор је {0} од {1} до {2}, {3} од {4} до {5}, а слика {6} пута {7} пиксела. Колико је {8} у варијанти Y?</translation>
    </message>
    <message>
        <source>Both ends get the same share, so each gets half of what is missing. Look at variant Y: the left end moves as far as the right one.</source>
        <translation>Оба краја добијају једнак део, дакле сваки половину онога што недостаје. Погледајте варијанту Y: леви крај се помера колико и десни.</translation>
    </message>
    <message>
        <source>How wide must the window be for a picture of {0} by {1}?</source>
        <translation>Колико широк мора бити прозор за слику од {0} пута {1}?</translation>
    </message>
    <message>
        <source>{0} wide; it is {1} wide now. Both ends get the same share.</source>
        <translation>Широк {0}; сада је широк {1}. Оба краја добијају једнак део.</translation>
    </message>
    <message>
        <source>Practise: where does X put it?</source>
        <translation>Вежба: где га ставља X?</translation>
    </message>
    <message>
        <source>The picture is that of variant X: {0} as given, {1} adjusted. Its frame has the numbers of the pixels.</source>
        <translation>Слика је слика варијанте X: {0} како је дато, {1} прилагођено. Њен рам има бројеве пиксела.</translation>
    </message>
    <message>
        <source>The given window is {0} from {1} to {2} and {3} from {4} to {5}. Mark where variant X puts the point with {6}, {7} of the near plane.</source>
        <translation>Дати прозор је {0} од {1} до {2} и {3} од {4} до {5}. Обележите где варијанта X ставља тачку са {6}, {7} на предњој равни.</translation>
    </message>
    <message>
        <source>Variant X *keeps* x. Look at variant Y: it is the one that leaves y as it is, and your place belongs to its picture.</source>
        <translation>Варијанта X *задржава* x. Погледајте варијанту Y: она је та која y оставља какво јесте, и ваше место припада њеној слици.</translation>
    </message>
    <message>
        <source>Rows are counted from the top. Look at the numbers beside the frame: 0 is at the top, so a positive {0} lies in the upper half.</source>
        <translation>Редови се броје одозго. Погледајте бројеве поред рама: 0 је на врху, па позитивно {0} лежи у горњој половини.</translation>
    </message>
    <message>
        <source>In variant X the window reaches from {0} to {1} in x. How far does it reach in y?</source>
        <translation>У варијанти X прозор по x досеже од {0} до {1}. Докле досеже по y?</translation>
    </message>
    <message>
        <source>Its height and width are as {0} to {1}, so {2}.</source>
        <translation>Његова висина и ширина су као {0} према {1}, па је {2}.</translation>
    </message>
    <message>
        <source>{0}. From the middle, the place is {1} of half the width to the right, and {2} of half the height up.</source>
        <translation>{0}. Од средине, место је {1} половине ширине удесно и {2} половине висине нагоре.</translation>
    </message>
    <message>
        <source>Practise: X by hand</source>
        <translation>Вежба: X ручно</translation>
    </message>
    <message>
        <source>*Proportions*, in *More of the lens*, stay at stretch.</source>
        <translation>*Пропорције*, у одељку *Још о објективу*, остају на „растегни”.</translation>
    </message>
    <message>
        <source>The picture has {0} by 600 pixels. Give *Bottom* and *Top* the values {1} and {2} of variant X.</source>
        <translation>Слика има {0} пута 600 пиксела. Дајте пољима *Доле* и *Горе* вредности {1} и {2} варијанте X.</translation>
    </message>
    <message>
        <source>How high must a window be that is {0} wide, for {1} by 600 pixels?</source>
        <translation>Колико висок мора бити прозор широк {0}, за {1} пута 600 пиксела?</translation>
    </message>
    <message>
        <source>{0} high; it is {1} high now. Both ends get the same share.</source>
        <translation>Висок {0}; сада је висок {1}. Оба краја добијају једнак део.</translation>
    </message>
    <message>
        <source>{0} {1}. Half of it goes to each end: {2} and {3}.</source>
        <translation>{0} {1}. Половина тога иде на сваки крај: {2} и {3}.</translation>
    </message>
    <message>
        <source>Both ends get the same share, so each gets half of what is missing. Look at variant X: the F has its proportions again.</source>
        <translation>Оба краја добијају једнак део, дакле сваки половину онога што недостаје. Погледајте варијанту X: слово F поново има своје пропорције.</translation>
    </message>
    <message>
        <source>Variant X *keeps* x, and you have changed it. Look at variant Y: it adjusts x as you did.</source>
        <translation>Варијанта X *задржава* x, а ви сте га променили. Погледајте варијанту Y: она прилагођава x као ви.</translation>
    </message>
</context>
<context>
    <name>l08-depth-not-affine</name>
    <message>
        <source>Why not Az + B for the depth?</source>
        <translation>Зашто за дубину не Az + B?</translation>
    </message>
    <message>
        <source>A straight segment in the cube</source>
        <translation>Права дуж у коцки</translation>
    </message>
    <message>
        <source>In space PQ is straight, and both ends are 6 units deep. {0} and {1} are divided by {2}. The depth could just be scaled and shifted, {3}, so that near comes to {4} and far to {5}. With both ends equally deep the segment is still straight in **NDC**: the deviation in the dock is 0 %. Now P will come nearer, to a depth of 2.</source>
        <translation>У простору је PQ права, и оба краја су на дубини 6. {0} и {1} се деле са {2}. Дубина би могла само да се скалира и помери, {3}, тако да предња раван дође у {4}, а задња у {5}. Када су оба краја једнако дубоко, дуж је и у приказу **NDC** права: одступање у бочном панелу је 0 %. Сада ће P прићи ближе, на дубину 2.</translation>
    </message>
    <message>
        <source>What does {0} make of the straight segment PQ then?</source>
        <translation>Шта тада {0} прави од праве дужи PQ?</translation>
    </message>
    <message>
        <source>A straight segment: scaling and shifting bend nothing</source>
        <translation>Праву дуж: скалирање и померање ништа не савијају</translation>
    </message>
    <message>
        <source>Az + B bends nothing</source>
        <translation>Az + B ништа не савија</translation>
    </message>
    <message>
        <source>They bend nothing in space. But {0} and {1} are divided by {2} and the depth is not, so halfway between the images of P and Q the depth is not halfway. Look at the line {3}: it is bent.</source>
        <translation>У простору не савијају ништа. Али {0} и {1} се деле са {2}, а дубина не, па на пола пута између слика тачака P и Q дубина није на пола пута. Погледајте линију {3}: савијена је.</translation>
    </message>
    <message>
        <source>A bow</source>
        <translation>Лук</translation>
    </message>
    <message>
        <source>A straight segment, but from other ends</source>
        <translation>Праву дуж, али од других крајева</translation>
    </message>
    <message>
        <source>The ends are right: near and far come to −1 and 1 either way. What changes lies between them. Look at the two lines: they have the same ends.</source>
        <translation>Крајеви су тачни: предња и задња раван у оба случаја долазе у −1 и 1. Мења се оно што је између. Погледајте две линије: имају исте крајеве.</translation>
    </message>
    <message>
        <source>x and y are divided, but z is not. Along the image of PQ the depth does not grow evenly.</source>
        <translation>x и y се деле, а z не. Дуж слике од PQ дубина не расте равномерно.</translation>
    </message>
    <message>
        <source>The middle of the picture</source>
        <translation>Средина слике</translation>
    </message>
    <message>
        <source>P is 2 deep, Q is 6 deep, {0}, {1}. Halfway between their images the depth is not 4. {2} changes evenly on the screen, so the depth there is {3}.</source>
        <translation>P је на дубини 2, Q на дубини 6, {0}, {1}. На пола пута између њихових слика дубина није 4. На екрану се равномерно мења {2}, па је тамо дубина {3}.</translation>
    </message>
    <message>
        <source>depth</source>
        <translation>дубина</translation>
    </message>
    <message>
        <source>middle of the ends</source>
        <translation>средина крајева</translation>
    </message>
    <message>
        <source>scaled and shifted</source>
        <translation>скалирано и померено</translation>
    </message>
    <message>
        <source>divided as well</source>
        <translation>и подељено</translation>
    </message>
    <message>
        <source>In the first row, 3 does not come to the middle of the ends; in the second it does:</source>
        <translation>У првом реду 3 не долази у средину између крајева; у другом долази:</translation>
    </message>
    <message>
        <source>with {0}, {1}.</source>
        <translation>са {0}, {1}.</translation>
    </message>
    <message>
        <source>Bend it</source>
        <translation>Савијте је</translation>
    </message>
    <message>
        <source>Both ends are 6 deep again. Drag P and Q in **World**, or type them.</source>
        <translation>Оба краја су поново на дубини 6. Превуците P и Q у приказу **Свет**, или их унесите.</translation>
    </message>
    <message>
        <source>Make the bow deviate by more than 5 % of its length.</source>
        <translation>Нека лук одступа за више од 5 % своје дужине.</translation>
    </message>
    <message>
        <source>If both ends are equally deep, nothing is bent.</source>
        <translation>Ако су оба краја једнако дубоко, ништа се не савија.</translation>
    </message>
    <message>
        <source>Bring P nearer to the eye: larger z.</source>
        <translation>Доведите P ближе камери: веће z.</translation>
    </message>
    <message>
        <source>Right: the larger the ratio of the two depths, the more the segment is bent.</source>
        <translation>Тачно: што је већи однос двеју дубина, то је дуж савијенија.</translation>
    </message>
    <message>
        <source>The depth of a point</source>
        <translation>Дубина тачке</translation>
    </message>
    <message>
        <source>Now the planes are {0} and {1}, and a point is 4 units deep, {2}.</source>
        <translation>Сада су равни {0} и {1}, а тачка је на дубини од 4 јединице, {2}.</translation>
    </message>
    <message>
        <source>How large is {0} of the perspective projection?</source>
        <translation>Колико је {0} перспективне пројекције?</translation>
    </message>
    <message>
        <source>This spreads the depth evenly between the planes. But {0} changes with {1}, fast just behind near. Look at point 1, 4 deep, in the cube: it is beyond the middle.</source>
        <translation>Овде је дубина равномерно распоређена између равни. Али {0} се мења са {1}, брзо одмах иза предње равни. Погледајте тачку 1, на дубини 4, у коцки: она је иза средине.</translation>
    </message>
    <message>
        <source>This stops before the division by {0}. Look at point 1, 4 deep, in the cube: it is inside, so its {1} is less than 1.</source>
        <translation>Овде се стало пре дељења са {0}. Погледајте тачку 1, на дубини 4, у коцки: унутра је, па је њено {1} мање од 1.</translation>
    </message>
    <message>
        <source>Az + B = 8/6. It is not yet divided.</source>
        <translation>Az + B = 8/6. То још није подељено.</translation>
    </message>
    <message>
        <source>The middle of the cube</source>
        <translation>Средина коцке</translation>
    </message>
    <message>
        <source>The planes are the same: {0}, {1}.</source>
        <translation>Равни су исте: {0}, {1}.</translation>
    </message>
    <message>
        <source>How deep is the point with {0}?</source>
        <translation>На којој је дубини тачка са {0}?</translation>
    </message>
    <message>
        <source>This is the middle in the world. Look at point 1, 5 deep, in the cube: it is beyond the middle.</source>
        <translation>Ово је средина у свету. Погледајте тачку 1, на дубини 5, у коцки: она је иза средине.</translation>
    </message>
    <message>
        <source>-A - B/z = 0</source>
        <translation>-A - B/z = 0</translation>
    </message>
    <message>
        <source>{0}, and its depth is {1}. The first half of the cube ends there.</source>
        <translation>{0}, а дубина јој је {1}. Тамо се завршава прва половина коцке.</translation>
    </message>
    <message>
        <source>Place the middle</source>
        <translation>Поставите средину</translation>
    </message>
    <message>
        <source>Probe 1 is 4 units deep; near is 1 and far is 9.</source>
        <translation>Сонда 1 је на дубини од 4 јединице; предња раван је на 1, а задња на 9.</translation>
    </message>
    <message>
        <source>Set near and far so that probe 1, at depth 4, comes to the middle of the cube: z&apos; = 0.</source>
        <translation>Поставите предњу и задњу раван тако да сонда 1, на дубини 4, дође у средину коцке: z&apos; = 0.</translation>
    </message>
    <message>
        <source>Use 1/z: 1/4 must be halfway between 1/near and 1/far.</source>
        <translation>Користите 1/z: 1/4 мора бити на пола пута између 1/near и 1/far.</translation>
    </message>
    <message>
        <source>With far at 9, near must be 2.57; with near at 3, far must be 6.</source>
        <translation>Са задњом равни на 9 предња мора бити на 2.57; са предњом на 3 задња мора бити на 6.</translation>
    </message>
    <message>
        <source>Right: 2nf/(n + f) = 4.</source>
        <translation>Тачно: 2nf/(n + f) = 4.</translation>
    </message>
    <message>
        <source>Back to the prediction</source>
        <translation>Назад на предвиђање</translation>
    </message>
    <message>
        <source>It is tempting to trust {0}, because in space it bends nothing. But after {1} and {2} are divided by {3}, equal steps along the picture are unequal steps of depth, and a straight line stays straight only if the depth is divided as well.</source>
        <translation>Примамљиво је веровати изразу {0}, јер у простору ништа не савија. Али пошто се {1} и {2} поделе са {3}, једнаки кораци по слици су неједнаки кораци по дубини, и права остаје права само ако се и дубина подели.</translation>
    </message>
    <message>
        <source>Bent lines would spoil the depth buffer: between the corners of a triangle, depths are interpolated evenly over the pixels. The computed depth would not be the true one, and a surface behind could be drawn in front.</source>
        <translation>Савијене линије би поквариле бафер дубине: између темена троугла дубине се равномерно интерполирају по пикселима. Израчуната дубина не би била стварна, и површ која је иза могла би да се нацрта испред.</translation>
    </message>
    <message>
        <source>Practise: the depth of a point</source>
        <translation>Вежба: дубина тачке</translation>
    </message>
    <message>
        <source>The planes are at the depths {0} and {1}. In the cube they come to {2} and {3}.</source>
        <translation>Равни су на дубинама {0} и {1}. У коцки долазе у {2} и {3}.</translation>
    </message>
    <message>
        <source>Here {0} and {1}. Point 1 is at {2}. How large is its {3}?</source>
        <translation>Овде је {0} и {1}. Тачка 1 је у {2}. Колико је њено {3}?</translation>
    </message>
    <message>
        <source>This spreads the depth evenly between the planes. But {0} changes with {1}, fast just behind near. Look at point 1, moved to where {2}: it is closer to near than to far.</source>
        <translation>Овде је дубина равномерно распоређена између равни. Али {0} се мења са {1}, брзо одмах иза предње равни. Погледајте тачку 1, померену тамо где је {2}: ближа је предњој равни него задњој.</translation>
    </message>
    <message>
        <source>This stops before the division by {0}. Look at point 1, moved to far: there {1} is {2}, and only the division makes it 1.</source>
        <translation>Овде се стало пре дељења са {0}. Погледајте тачку 1, померену на задњу раван: тамо је {1} једнако {2}, и тек га дељење чини 1.</translation>
    </message>
    <message>
        <source>{0}, with {1} and {2}.</source>
        <translation>{0}, са {1} и {2}.</translation>
    </message>
    <message>
        <source>Practise: the middle of the cube</source>
        <translation>Вежба: средина коцке</translation>
    </message>
    <message>
        <source>You see the segment PQ from the side. P is on the near plane, and Q on the far plane.</source>
        <translation>Дуж PQ видите са стране. P је на предњој равни, а Q на задњој.</translation>
    </message>
    <message>
        <source>Near is {0} and far is {1}. Which point of PQ comes to {2} in the cube? Mark it.</source>
        <translation>Предња раван је {0}, а задња {1}. Која тачка дужи PQ у коцки долази у {2}? Обележите је.</translation>
    </message>
    <message>
        <source>This is the middle of PQ in the world. But {0} changes with {1}, fast just behind near. Look at point 1: it is the place that you marked, and the cube&apos;s middle lies before it.</source>
        <translation>Ово је средина дужи PQ у свету. Али {0} се мења са {1}, брзо одмах иза предње равни. Погледајте тачку 1: то је место које сте обележили, а средина коцке лежи пре њега.</translation>
    </message>
    <message>
        <source>At which depth is {0}?</source>
        <translation>На којој дубини је {0}?</translation>
    </message>
    <message>
        <source>At {0}, which is {1} deep.</source>
        <translation>У {0}, што је на дубини {1}.</translation>
    </message>
    <message>
        <source>It is {0} deep.</source>
        <translation>Дубина је {0}.</translation>
    </message>
    <message>
        <source>Practise: place the middle</source>
        <translation>Вежба: поставите средину</translation>
    </message>
    <message>
        <source>**World** shows the planes and probe 1 from the side.</source>
        <translation>**Свет** показује равни и сонду 1 са стране.</translation>
    </message>
    <message>
        <source>Probe 1 is {0} deep. Leave far at {1}, and set near so that the depth {2} comes to {3}.</source>
        <translation>Сонда 1 је на дубини {0}. Оставите задњу раван на {1} и поставите предњу тако да дубина {2} дође у {3}.</translation>
    </message>
    <message>
        <source>The middle of the cube is {0} deep.</source>
        <translation>Средина коцке је на дубини {0}.</translation>
    </message>
    <message>
        <source>So {0} is halfway between {1} and {2}.</source>
        <translation>Дакле {0} је на пола пута између {1} и {2}.</translation>
    </message>
    <message>
        <source>{0}, so {1} {2} {3}, more than half of {4}.</source>
        <translation>{0}, па је {1} {2} {3}, више од половине од {4}.</translation>
    </message>
    <message>
        <source>This puts the point half-way between the planes in the world. But {0} changes with {1}. Look at the planes: the cube&apos;s middle is nearer to near than the point is.</source>
        <translation>Овде је тачка стављена на пола пута између равни у свету. Али {0} се мења са {1}. Погледајте равни: средина коцке је ближа предњој равни него тачка.</translation>
    </message>
</context>
<context>
    <name>l09-pyramid-to-cube</name>
    <message>
        <source>From the pyramid to the cube</source>
        <translation>Од пирамиде до коцке</translation>
    </message>
    <message>
        <source>Where does the near plane go?</source>
        <translation>Куда иде предња раван?</translation>
    </message>
    <message>
        <source>Every lens has a volume of its own. Lecture 001 brings them all into one pyramid first: {0} moves the far plane to {1} and the sides of the picture to {2}. Here {3} and {4}, and the strip under the large cube is at *View*.</source>
        <translation>Сваки објектив има своју запремину. Предавање 001 их прво све доводи у једну пирамиду: {0} помера задњу раван у {1}, а стране слике у {2}. Овде је {3} и {4}, а трака испод велике коцке је на станици *Камера*.</translation>
    </message>
    <message>
        <source>The strip goes on to *Pyramid*: the far plane moves from {0} to {1}. Where does the near plane go?</source>
        <translation>Трака иде даље на станицу *Пирамида*: задња раван се помера из {0} у {1}. Куда иде предња?</translation>
    </message>
    <message>
        <source>It stays at z = −1</source>
        <translation>Остаје на z = −1</translation>
    </message>
    <message>
        <source>{0} divides every depth by {1}, not only far&apos;s. Look at near: it is at −0.111, close to the eye.</source>
        <translation>{0} дели сваку дубину са {1}, а не само дубину задње равни. Погледајте предњу раван: она је на −0.111, близу камере.</translation>
    </message>
    <message>
        <source>At z = −0.111</source>
        <translation>На z = −0.111</translation>
    </message>
    <message>
        <source>At z = 0, with the eye</source>
        <translation>На z = 0, код камере</translation>
    </message>
    <message>
        <source>{0} is the eye. {1} only scales: a plane that is in front of the eye stays in front of it. Look at near and the eye: they are 0.111 apart.</source>
        <translation>{0} је позиција камере. {1} само скалира: раван која је испред камере остаје испред ње. Погледајте предњу раван и камеру: на размаку су од 0.111.</translation>
    </message>
    <message>
        <source>{0} only scales. All depths are divided by {1}, so the near plane is at {2}, and the eye stays at 0.</source>
        <translation>{0} само скалира. Све дубине се деле са {1}, па је предња раван на {2}, а камера остаје у 0.</translation>
    </message>
    <message>
        <source>The two factors</source>
        <translation>Два чиниоца</translation>
    </message>
    <message>
        <source>*Matrices* shows the chain in the lecture&apos;s letters and highlights the matrix of the strip&apos;s stop. {0} divides z by {1}: here {2}.</source>
        <translation>*Матрице* показују ланац у словима предавања и истичу матрицу станице на траци. {0} дели z са {1}: овде {2}.</translation>
    </message>
    <message>
        <source>{0} turns the pyramid into a box. Its third row ends in {1} and {2}, here 1.125 and 0.125, and its last row gives {3}. Try it on both planes:</source>
        <translation>{0} претвара пирамиду у квадар. Њена трећа врста завршава се са {1} и {2}, овде 1.125 и 0.125, а последња врста даје {3}. Испробајте је на обе равни:</translation>
    </message>
    <message>
        <source>z</source>
        <translation>z</translation>
    </message>
    <message>
        <source>numerator</source>
        <translation>бројилац</translation>
    </message>
    <message>
        <source>w</source>
        <translation>w</translation>
    </message>
    <message>
        <source>z of the box</source>
        <translation>z квадра</translation>
    </message>
    <message>
        <source>c</source>
        <translation>c</translation>
    </message>
    <message>
        <source>{0} takes 0 … −1 to OpenGL&apos;s −1 … 1: {1}. Click *Pyramid*, *Box* and *NDC* under the cube.</source>
        <translation>{0} преводи 0 … −1 у −1 … 1 за OpenGL: {1}. Кликните на *Пирамида*, *Квадар* и *NDC* испод коцке.</translation>
    </message>
    <message>
        <source>The product</source>
        <translation>Производ</translation>
    </message>
    <message>
        <source>Each stop of the strip is a place, and each factor leads from one to the next. A point {0} of view space goes through all of them: what it meets first stands on the right, next to it.</source>
        <translation>Свака станица траке је једно место, и сваки чинилац води са једног на следеће. Тачка {0} координатног система камере пролази кроз све: оно што прво среће стоји десно, одмах до ње.</translation>
    </message>
    <message>
        <source>Which volume does each factor start from: the lens&apos;s own, the pyramid or the box?</source>
        <translation>Од које запремине полази сваки чинилац: од запремине самог објектива, од пирамиде или од квадра?</translation>
    </message>
    <message>
        <source>{0} starts from the lens&apos;s own volume, {1} from the pyramid, and {2} from the box: {3}.</source>
        <translation>{0} полази од запремине самог објектива, {1} од пирамиде, а {2} од квадра: {3}.</translation>
    </message>
    <message>
        <source>Half-way through the box</source>
        <translation>На пола квадра</translation>
    </message>
    <message>
        <source>Probe 1 is pinned to a point of the F, 7.5 in front of the eye. {0} in the box is {1} in NDC; the Probe panel shows it.</source>
        <translation>Сонда 1 је закачена за тачку слова F, 7.5 испред камере. {0} у квадру је {1} у NDC; то показује панел „Сонда”.</translation>
    </message>
    <message>
        <source>Bring point 1 to z = −1/2 of the box, by near and far, by the camera, or by the point itself.</source>
        <translation>Доведите тачку 1 на z = −1/2 квадра, предњом и задњом равни, камером, или самом тачком.</translation>
    </message>
    <message>
        <source>With near = 6 the point is half-way between the planes in the world. Where is it in the box then?</source>
        <translation>Са предњом равни на 6 тачка је у свету на пола пута између равни. Где је тада у квадру?</translation>
    </message>
    <message>
        <source>{0} at the depth {1}, which is nearer to {2} than to {3}.</source>
        <translation>{0} на дубини {1}, што је ближе {2} него {3}.</translation>
    </message>
    <message>
        <source>The middle of the box is not the middle of the pyramid: the space close behind near fills half of the box.</source>
        <translation>Средина квадра није средина пирамиде: простор одмах иза предње равни испуњава половину квадра.</translation>
    </message>
    <message>
        <source>The cells of the chain</source>
        <translation>Поља ланца</translation>
    </message>
    <message>
        <source>Compute before you open *Matrices*. In this step {0} and {1}.</source>
        <translation>Рачунајте пре него што отворите *Матрице*. У овом кораку је {0} и {1}.</translation>
    </message>
    <message>
        <source>What is in row 3, column 4 of {0}?</source>
        <translation>Шта стоји у врсти 3, колони 4 матрице {0}?</translation>
    </message>
    <message>
        <source>This takes {0}. On the way into the pyramid every depth is divided by {1}. Look at near: it is closer to the eye, at {2}.</source>
        <translation>Овде се узима {0}. На путу у пирамиду свака дубина се дели са {1}. Погледајте предњу раван: ближа је камери, на {2}.</translation>
    </message>
    <message>
        <source>This swaps {0} and {1}. Look at the box: near comes to 0 and far to {2}; swapped, they would change places.</source>
        <translation>Овде су {0} и {1} замењени. Погледајте квадар: предња раван долази у 0, а задња у {2}; замењене, размениле би места.</translation>
    </message>
    <message>
        <source>{0} with {1}.</source>
        <translation>{0} са {1}.</translation>
    </message>
    <message>
        <source>{0}, here 0.5/8.5.</source>
        <translation>{0}, овде 0.5/8.5.</translation>
    </message>
    <message>
        <source>And in row 3, column 3 of the product {0}?</source>
        <translation>А у врсти 3, колони 3 производа {0}?</translation>
    </message>
    <message>
        <source>{0} acts first, so it stands on the right. Look at the box that it makes: only then does {1} stretch its depth from 0 … −1 to −1 … 1.</source>
        <translation>{0} делује прва, па стоји десно. Погледајте квадар који она прави: тек тада {1} растеже његову дубину са 0 … −1 на −1 … 1.</translation>
    </message>
    <message>
        <source>This swaps {0} and {1}. Look at the cube: near comes to {2} and far to 1; swapped, they would change places.</source>
        <translation>Овде су {0} и {1} замењени. Погледајте коцку: предња раван долази у {2}, а задња у 1; замењене, размениле би места.</translation>
    </message>
    <message>
        <source>Third row of {0} times third column of {1}: {2} times one cell, and {3} times another.</source>
        <translation>Трећа врста матрице {0} пута трећа колона матрице {1}: {2} пута једно поље, и {3} пута друго.</translation>
    </message>
    <message>
        <source>{0}. That is {1}, which other lectures derive in one step.</source>
        <translation>{0}. То је {1}, што друга предавања изводе у једном кораку.</translation>
    </message>
    <message>
        <source>A near plane of your choice</source>
        <translation>Предња раван по избору</translation>
    </message>
    <message>
        <source>The pyramid keeps its shape for every lens. Only {0} differs.</source>
        <translation>Пирамида за сваки објектив задржава облик. Разликује се само {0}.</translation>
    </message>
    <message>
        <source>Set near or far so that the near plane is at z = −0.2 in the pyramid.</source>
        <translation>Поставите предњу или задњу раван тако да предња у пирамиди буде на z = −0.2.</translation>
    </message>
    <message>
        <source>The title of the large pane shows {0}.</source>
        <translation>Наслов великог приказа показује {0}.</translation>
    </message>
    <message>
        <source>In {0} only the quotient matters: 1.8 to 9 gives the same pyramid as 1 to 5.</source>
        <translation>У {0} је важан само количник: 1.8 према 9 даје исту пирамиду као 1 према 5.</translation>
    </message>
    <message>
        <source>Back to the prediction</source>
        <translation>Назад на предвиђање</translation>
    </message>
    <message>
        <source>It is tempting to leave the near plane where it is, at {0}, because the step is about far. But a matrix that scales z moves every depth; if near stayed, it would lie on far. Only the quotient {1} of the two distances remains, and {2} is made of it. Let the strip run from *World* to *NDC* once more: in the pyramid the near plane is 0.111 from the eye, and in the end it is a whole face of the cube.</source>
        <translation>Примамљиво је предњу раван оставити где јесте, на {0}, јер се у кораку ради о задњој. Али матрица која скалира z помера сваку дубину; када би предња раван остала, лежала би на задњој. Остаје само количник {1} двају растојања, и од њега је састављена {2}. Пустите траку још једном од станице *Свет* до *NDC*: у пирамиди је предња раван на 0.111 од камере, а на крају је цела страна коцке.</translation>
    </message>
    <message>
        <source>Practise: from the pyramid to the box</source>
        <translation>Вежба: од пирамиде до квадра</translation>
    </message>
    <message>
        <source>{0} takes the pyramid, whose near plane is at {1} and whose far plane is at {2}, to a box from 0 to {3}.</source>
        <translation>{0} преводи пирамиду, чија је предња раван на {1}, а задња на {2}, у квадар од 0 до {3}.</translation>
    </message>
    <message>
        <source>The near plane is {0} in front of the eye, the far plane {1}. What is in row 3 of {2}?</source>
        <translation>Предња раван је {0} испред камере, задња {1}. Шта стоји у врсти 3 матрице {2}?</translation>
    </message>
    <message>
        <source>This takes {0}. On the way into the pyramid every depth is divided by {1}. Look at near: it is at {2}.</source>
        <translation>Овде се узима {0}. На путу у пирамиду свака дубина се дели са {1}. Погледајте предњу раван: она је на {2}.</translation>
    </message>
    <message>
        <source>The row ends in {0} and {1}.</source>
        <translation>Врста се завршава са {0} и {1}.</translation>
    </message>
    <message>
        <source>{0} and {1} with {2}: near comes to 0, and far to {3}.</source>
        <translation>{0} и {1} са {2}: предња раван долази у 0, а задња у {3}.</translation>
    </message>
    <message>
        <source>Practise: from the pyramid to the cube</source>
        <translation>Вежба: од пирамиде до коцке</translation>
    </message>
    <message>
        <source>{0} takes the box, from 0 to {1}, to OpenGL&apos;s depths from {2} to {3}: {4}, and {5} stays. {6} comes first.</source>
        <translation>{0} преводи квадар, од 0 до {1}, у дубине од {2} до {3} за OpenGL: {4}, а {5} остаје. {6} долази прва.</translation>
    </message>
    <message>
        <source>With {0} and {1}, what is in rows 3 and 4, columns 3 and 4 of the product {2}?</source>
        <translation>Са {0} и {1}, шта стоји у врстама 3 и 4, колонама 3 и 4 производа {2}?</translation>
    </message>
    <message>
        <source>{0} acts first, so it stands on the right. Look at the box that it makes: only then does {1} stretch its depth.</source>
        <translation>{0} делује прва, па стоји десно. Погледајте квадар који она прави: тек тада {1} растеже његову дубину.</translation>
    </message>
    <message>
        <source>In these rows and columns {0} is {1} above {2}.</source>
        <translation>У овим врстама и колонама {0} је {1} изнад {2}.</translation>
    </message>
    <message>
        <source>{0} is {1} above {2} there.</source>
        <translation>{0} је тамо {1} изнад {2}.</translation>
    </message>
    <message>
        <source>Row 3 of {0} takes {1} times row 3 of {2} and {3} times its row 4.</source>
        <translation>Врста 3 матрице {0} узима {1} пута врсту 3 матрице {2} и {3} пута њену врсту 4.</translation>
    </message>
    <message>
        <source>Practise: choose the pyramid</source>
        <translation>Вежба: изаберите пирамиду</translation>
    </message>
    <message>
        <source>In the canonical pyramid the far plane is at {0}. The lens decides where the near plane is.</source>
        <translation>У стандардној пирамиди задња раван је на {0}. О томе где је предња одлучује објектив.</translation>
    </message>
    <message>
        <source>Set near or far so that the near plane is at {0} in the pyramid.</source>
        <translation>Поставите предњу или задњу раван тако да предња у пирамиди буде на {0}.</translation>
    </message>
    <message>
        <source>All depths are divided by {0} on the way into the pyramid.</source>
        <translation>Све дубине се на путу у пирамиду деле са {0}.</translation>
    </message>
    <message>
        <source>{0}: only the quotient of the two distances matters. If far stays at {1}, near is {2}.</source>
        <translation>{0}: важан је само количник двају растојања. Ако задња раван остане на {1}, предња је на {2}.</translation>
    </message>
    <message>
        <source>This puts near {0} in front of the eye in the world. All depths are divided by {1} on the way into the pyramid. Look at near: it is far too close, at {2}/{3} in the pyramid.</source>
        <translation>Овде је предња раван у свету стављена {0} испред камере. Све дубине се на путу у пирамиду деле са {1}. Погледајте предњу раван: превише је близу, у пирамиди на {2}/{3}.</translation>
    </message>
    <message>
        <source>Practise: build the product</source>
        <translation>Вежба: саставите производ</translation>
    </message>
    <message>
        <source>Put the tiles in order, and leave out what does not belong.</source>
        <translation>Поређајте плочице и изоставите оно што ту не спада.</translation>
    </message>
    <message>
        <source>{0} and {1}. Which chain leads from view space to NDC?</source>
        <translation>{0} и {1}. Који ланац води из координатног система камере у NDC?</translation>
    </message>
    <message>
        <source>The box has near at {0} and far at {1}. Another program wants near at {2} and far at {3}. Which chain is its {4}?</source>
        <translation>Квадар има предњу раван на {0}, а задњу на {1}. Други програм тражи предњу на {2}, а задњу на {3}. Који ланац је његова матрица {4}?</translation>
    </message>
    <message>
        <source>The eye is at {0}, {1} and {2}. Which chain takes a point of the world to NDC, up to the division?</source>
        <translation>Позиција камере је {0}, а {1} и {2}. Који ланац преводи тачку света у NDC, све до дељења?</translation>
    </message>
    <message>
        <source>{0} takes the pyramid to the box. What makes the pyramid?</source>
        <translation>{0} преводи пирамиду у квадар. Шта прави пирамиду?</translation>
    </message>
    <message>
        <source>Which chain leads from *View* to *NDC*?</source>
        <translation>Који ланац води од станице *Камера* до станице *NDC*?</translation>
    </message>
    <message>
        <source>{0} makes the pyramid, {1} turns it into the box, and {2} stretches its depths.</source>
        <translation>{0} прави пирамиду, {1} је претвара у квадар, а {2} растеже његове дубине.</translation>
    </message>
    <message>
        <source>Where does near, at 0, come to? The scale leaves it at 0.</source>
        <translation>Куда долази предња раван, која је на 0? Скалирање је оставља на 0.</translation>
    </message>
    <message>
        <source>Far is at {0}: the scale takes it to minus its factor.</source>
        <translation>Задња раван је на {0}: скалирање је доводи у минус свој чинилац.</translation>
    </message>
    <message>
        <source>{0}: the scale acts first, and the move takes near from 0 to {1}.</source>
        <translation>{0}: скалирање делује прво, а помак доводи предњу раван са 0 на {1}.</translation>
    </message>
    <message>
        <source>The lens needs points in view space.</source>
        <translation>Објективу требају тачке у координатном систему камере.</translation>
    </message>
    <message>
        <source>The view matrix comes first, because the lens&apos;s matrices are made for view space.</source>
        <translation>Матрица погледа долази прва, јер су матрице објектива направљене за координатни систем камере.</translation>
    </message>
</context>
<context>
    <name>l10-parallel-lens</name>
    <message>
        <source>What does depth do in a parallel lens?</source>
        <translation>Шта чини дубина у паралелном објективу?</translation>
    </message>
    <message>
        <source>Twice as far away</source>
        <translation>Двапут даље</translation>
    </message>
    <message>
        <source>Post 1 is 5 units in front of the eye, post 2 is 9.8, and both are equally high. With the perspective lens, post 2 is drawn about half as high (0.51 times): look at *Image*.</source>
        <translation>Стуб 1 је 5 јединица испред камере, стуб 2 је 9.8, и оба су једнако висока. Са перспективним објективом стуб 2 се црта отприлике упола нижи (0.51 пута): погледајте приказ *Слика*.</translation>
    </message>
    <message>
        <source>The lens becomes orthographic; camera and posts stay. How many times as high as post 1 is post 2 drawn now?</source>
        <translation>Објектив постаје ортографски; камера и стубови остају. Колико је пута висок као стуб 1 сада нацртани стуб 2?</translation>
    </message>
    <message>
        <source>1 times: both are equally high</source>
        <translation>1 пут: оба су једнако висока</translation>
    </message>
    <message>
        <source>0.51 times, as before</source>
        <translation>0.51 пута, као пре</translation>
    </message>
    <message>
        <source>This divides by the depth, as the perspective lens does. The projectors of a parallel lens do not meet, so its pictures are not divided by anything: equal heights stay equal at every depth. Look at the two posts: they are equally high.</source>
        <translation>Овде се дели дубином, као код перспективног објектива. Зраци пројекције паралелног објектива се не секу, па се његове слике не деле ничим: једнаке висине остају једнаке на свакој дубини. Погледајте два стуба: једнако су висока.</translation>
    </message>
    <message>
        <source>More than half, but not as high</source>
        <translation>Више од половине, али не једнако високо</translation>
    </message>
    <message>
        <source>There is nothing in between: the lens either divides by the depth, or not. The orthographic one does not. Look at the two posts: they are equally high.</source>
        <translation>Ништа између не постоји: објектив или дели дубином, или не дели. Ортографски не дели. Погледајте два стуба: једнако су висока.</translation>
    </message>
    <message>
        <source>The projectors are parallel: nothing is divided by the depth, and the heights in the picture are those of the world.</source>
        <translation>Зраци пројекције су паралелни: ништа се не дели дубином, и висине на слици су оне из света.</translation>
    </message>
    <message>
        <source>The box becomes the cube</source>
        <translation>Квадар постаје коцка</translation>
    </message>
    <message>
        <source>A parallel lens has a box, from {0} to {1}, {2} to {3} and {4} to {5}. Each range is moved to the middle and scaled to length 2:</source>
        <translation>Паралелни објектив има квадар, од {0} до {1}, {2} до {3} и {4} до {5}. Сваки опсег се помера у средину и скалира на дужину 2:</translation>
    </message>
    <message>
        <source>Point 1 is at {0} in view space. With {1}, {2} it has {3}; its depth of 5 affects only {4}. The Probe panel shows every step: the division is by 1.</source>
        <translation>Тачка 1 је у {0} у координатном систему камере. Са {1}, {2} има {3}; њена дубина од 5 утиче само на {4}. Панел „Сонда” показује сваки корак: дељење је са 1.</translation>
    </message>
    <message>
        <source>The same height, by another lens</source>
        <translation>Иста висина, другим објективом</translation>
    </message>
    <message>
        <source>The lens is perspective again, and point 1 is at {0} in view space: its {1} is less than {2}.</source>
        <translation>Објектив је опет перспективни, а тачка 1 је у {0} у координатном систему камере: њено {1} је мање од {2}.</translation>
    </message>
    <message>
        <source>Bring point 1 to {0} with an orthographic lens.</source>
        <translation>Доведите тачку 1 у {0} ортографским објективом.</translation>
    </message>
    <message>
        <source>Choose *orthographic* for the lens, then set bottom and top.</source>
        <translation>Изаберите *ортографски* објектив, па поставите доњу и горњу границу.</translation>
    </message>
    <message>
        <source>Move the camera back and forth. What happens to {0}?</source>
        <translation>Померајте камеру напред-назад. Шта бива са {0}?</translation>
    </message>
    <message>
        <source>Only the height of the window matters. The distance of the point does not.</source>
        <translation>Важна је само висина прозора. Растојање тачке није.</translation>
    </message>
    <message>
        <source>Cells and coordinates</source>
        <translation>Поља и координате</translation>
    </message>
    <message>
        <source>This box is not in the middle: {0}, {1}, {2}, {3}, from 1 to 9. The window is stretched to the picture.</source>
        <translation>Овај квадар није у средини: {0}, {1}, {2}, {3}, од 1 до 9. Прозор је растегнут на слику.</translation>
    </message>
    <message>
        <source>What is in row 1, column 4 of clip ← view?</source>
        <translation>Шта стоји у врсти 1, колони 4 матрице „одсецање ← камера”?</translation>
    </message>
    <message>
        <source>This moves the middle of the box farther out. The cell is added to {0}; it must take the middle, {1}, to {2}. Look from above: the middle of the box is to the right of the eye&apos;s axis.</source>
        <translation>Ово помера средину квадра још даље. Поље се додаје на {0}; оно мора средину, {1}, да доведе у {2}. Погледајте одозго: средина квадра је десно од осе камере.</translation>
    </message>
    <message>
        <source>This is row 4, column 1. Row 1 computes {0} from x, y, z and 1; its last cell is what is added. Look from above: the box reaches farther to the right, so something must be added to {1}.</source>
        <translation>Ово је врста 4, колона 1. Врста 1 рачуна {0} из x, y, z и 1; њено последње поље је оно што се додаје. Погледајте одозго: квадар досеже даље удесно, па на {1} нешто мора да се дода.</translation>
    </message>
    <message>
        <source>The middle of the box, {0}, must come to {1}.</source>
        <translation>Средина квадра, {0}, мора доћи у {1}.</translation>
    </message>
    <message>
        <source>{0}: the middle of the box is right of the axis, so it is moved to the left.</source>
        <translation>{0}: средина квадра је десно од осе, па се помера улево.</translation>
    </message>
    <message>
        <source>What is {0} of the point (1, 1, −5) in view space?</source>
        <translation>Колико је {0} тачке (1, 1, −5) у координатном систему камере?</translation>
    </message>
    <message>
        <source>This divides by the depth of 5. The projectors of a parallel lens do not meet: {0} does not contain z. Look at points 1 and 2, 5 and 8 deep: they are equally high in the picture.</source>
        <translation>Овде се дели дубином од 5. Зраци пројекције паралелног објектива се не секу: {0} не садржи z. Погледајте тачке 1 и 2, на дубинама 5 и 8: на слици су на истој висини.</translation>
    </message>
    <message>
        <source>{0}, and {1}: there is nothing to divide by.</source>
        <translation>{0}, и {1}: нема чиме да се дели.</translation>
    </message>
    <message>
        <source>Back to the prediction</source>
        <translation>Назад на предвиђање</translation>
    </message>
    <message>
        <source>Far things look small to an eye, and to every lens whose projectors meet in a point. It is tempting to take this for a law of pictures. In a box the projectors never meet: the last row of the matrix is 0, 0, 0, 1, so {0} at every depth, and x and y do not depend on z. The depth is not lost: {1} keeps it and decides what hides what. That is why the posts are drawn equally high, side by side.</source>
        <translation>Далеке ствари изгледају мале оку, и сваком објективу чији се зраци пројекције секу у једној тачки. Примамљиво је то сматрати законом слика. У квадру се зраци пројекције никада не секу: последња врста матрице је 0, 0, 0, 1, па је {0} на свакој дубини, а x и y не зависе од z. Дубина није изгубљена: чува је {1}, које одлучује шта шта заклања. Зато су стубови нацртани једнако високи, један поред другог.</translation>
    </message>
    <message>
        <source>Practise: the first row</source>
        <translation>Вежба: прва врста</translation>
    </message>
    <message>
        <source>A parallel lens takes its box, from {0} to {1} in x, to {2} from {3} to {4}.</source>
        <translation>Паралелни објектив свој квадар, по x од {0} до {1}, преводи у {2} од {3} до {4}.</translation>
    </message>
    <message>
        <source>The box reaches from {0} to {1}. What is in row 1 of clip ← view?</source>
        <translation>Квадар досеже од {0} до {1}. Шта стоји у врсти 1 матрице „одсецање ← камера”?</translation>
    </message>
    <message>
        <source>This moves the middle of the box farther out. The row&apos;s last cell is added to {0}, so it must be {1}: then the middle, {2}, comes to {3}. Look from above: the middle of the box is not on the eye&apos;s axis.</source>
        <translation>Ово помера средину квадра још даље. Последње поље врсте додаје се на {0}, па мора бити {1}: тада средина, {2}, долази у {3}. Погледајте одозго: средина квадра није на оси камере.</translation>
    </message>
    <message>
        <source>This is column 1. Row 1 computes {0} from x, y, z and 1, so what is added to x stands in its last cell. Look from above: the box reaches farther to one side, so something must be added to {1}.</source>
        <translation>Ово је колона 1. Врста 1 рачуна {0} из x, y, z и 1, па оно што се додаје на x стоји у њеном последњем пољу. Погледајте одозго: квадар досеже даље на једну страну, па на {1} нешто мора да се дода.</translation>
    </message>
    <message>
        <source>{0} is {1} plus a number that brings the middle of the box to 0.</source>
        <translation>{0} је {1} плус број који средину квадра доводи у 0.</translation>
    </message>
    <message>
        <source>The middle of the box, {0}, comes to {1}, and its width {2} to 2.</source>
        <translation>Средина квадра, {0}, долази у {1}, а његова ширина {2} у 2.</translation>
    </message>
    <message>
        <source>Practise: a point in a parallel lens</source>
        <translation>Вежба: тачка у паралелном објективу</translation>
    </message>
    <message>
        <source>A parallel lens has a box from {0} to {1} in y.</source>
        <translation>Паралелни објектив има квадар по y од {0} до {1}.</translation>
    </message>
    <message>
        <source>The box reaches from {0} to {1}. Point 1 is at {2} in view space, {3} in front of the eye. What is its {4}?</source>
        <translation>Квадар досеже од {0} до {1}. Тачка 1 је у {2} у координатном систему камере, {3} испред камере. Колико је њено {4}?</translation>
    </message>
    <message>
        <source>This divides by the depth of {0}. The projectors of a parallel lens do not meet: {1} does not contain z. Look at points 1 and 2: they have the same {2} at two depths, and the same {3}.</source>
        <translation>Овде се дели дубином од {0}. Зраци пројекције паралелног објектива се не секу: {1} не садржи z. Погледајте тачке 1 и 2: имају исто {2} на двема дубинама, и исто {3}.</translation>
    </message>
    <message>
        <source>The middle moves out</source>
        <translation>Средина иде напоље</translation>
    </message>
    <message>
        <source>This moves the middle of the box farther out instead of to 0: from {0} the lens subtracts {1}. Look at point 2, at {2}: it is in the middle of the picture, where {3}.</source>
        <translation>Ово помера средину квадра још даље уместо у 0: од {0} објектив одузима {1}. Погледајте тачку 2, у {2}: она је у средини слике, где је {3}.</translation>
    </message>
    <message>
        <source>{0} comes to {1} and {2} to {3}. What does the depth change?</source>
        <translation>{0} долази у {1}, а {2} у {3}. Шта мења дубина?</translation>
    </message>
    <message>
        <source>The depth of {0} does not matter: the division is by {1}.</source>
        <translation>Дубина од {0} није важна: дели се са {1}.</translation>
    </message>
    <message>
        <source>Practise: a height in the picture</source>
        <translation>Вежба: висина на слици</translation>
    </message>
    <message>
        <source>Point 1 is seen by a parallel lens. Its box reaches from {0} to {1} in y.</source>
        <translation>Тачку 1 види паралелни објектив. Његов квадар по y досеже од {0} до {1}.</translation>
    </message>
    <message>
        <source>Point 1 is at {0} in view space, {1} in front of the eye. Keep the lens parallel and bring the point to {2}.</source>
        <translation>Тачка 1 је у {0} у координатном систему камере, {1} испред камере. Нека објектив остане паралелан, а тачку доведите у {2}.</translation>
    </message>
    <message>
        <source>With {0}, {1}.</source>
        <translation>Са {0}, {1}.</translation>
    </message>
    <message>
        <source>{0} {1}, and {2}. The depth of {3} has no part in it.</source>
        <translation>{0} {1}, и {2}. Дубина од {3} у томе нема удела.</translation>
    </message>
    <message>
        <source>A parallel lens divides by nothing but the half height of its box. Look at a box with {0}, twice as high as the point: there the point is at {1}, whatever its depth.</source>
        <translation>Паралелни објектив не дели ничим осим половином висине свог квадра. Погледајте квадар са {0}, двапут вишим од тачке: тамо је тачка у {1}, ма колика јој била дубина.</translation>
    </message>
</context>
<context>
    <name>l11-oblique-drawing</name>
    <message>
        <source>Where receding edges go</source>
        <translation>Куда иду ивице по дубини</translation>
    </message>
    <message>
        <source>Half the scale</source>
        <translation>Половина размере</translation>
    </message>
    <message>
        <source>The front of this body is parallel to the picture, so it keeps its shape. If the projectors slant, edges along n are drawn too. A cavalier drawing shows them at full length; its projectors meet the picture at 45°. A cabinet drawing shows them half as long.</source>
        <translation>Предња страна овог тела је паралелна слици, па задржава облик. Ако су зраци пројекције коси, цртају се и ивице дуж n. Цртеж кавалјер их показује у пуној дужини; његови зраци секу слику под 45°. Цртеж кабинет их показује упола краће.</translation>
    </message>
    <message>
        <source>At which angle do the projectors of a cabinet drawing meet the picture?</source>
        <translation>Под којим углом зраци пројекције цртежа кабинет секу слику?</translation>
    </message>
    <message>
        <source>67.5°: half the scale is half the slant</source>
        <translation>67.5°: половина размере је половина косине</translation>
    </message>
    <message>
        <source>This assumes that the angle is proportional to the scale. One unit of depth and half a unit along the picture are the legs of a right triangle: the angle between projector and picture has the tangent 2, and is 63.4°. Look from above at the lines to the near plane: they go 2 deep for 1 to the side.</source>
        <translation>Овде се претпоставља да је угао сразмеран размери. Једна јединица дубине и пола јединице по слици су катете правоуглог троугла: угао између зрака и слике има тангенс 2, и износи 63.4°. Погледајте одозго линије до предње равни: иду 2 у дубину за 1 у страну.</translation>
    </message>
    <message>
        <source>45°, as in every oblique drawing</source>
        <translation>45°, као у сваком косом цртежу</translation>
    </message>
    <message>
        <source>At 45° a projector goes as far along the picture as into the depth, so edges along n are drawn at full length. That is the cavalier drawing. Look from above at its lines to the near plane: they go 1 deep for 1 to the side.</source>
        <translation>Под 45° зрак пројекције иде по слици колико и у дубину, па се ивице дуж n цртају у пуној дужини. То је цртеж кавалјер. Погледајте одозго његове линије до предње равни: иду 1 у дубину за 1 у страну.</translation>
    </message>
    <message>
        <source>A projector that goes 1 unit deep moves by the scale {0} along the picture: {1}, and {2} is the angle with {3}.</source>
        <translation>Зрак пројекције који иде 1 јединицу у дубину помери се по слици за размеру {0}: {1}, а {2} је угао са {3}.</translation>
    </message>
    <message>
        <source>The matrix H</source>
        <translation>Матрица H</translation>
    </message>
    <message>
        <source>A projector that meets the near plane at {0} (seen from above) and {1} (from the side) moves a point by</source>
        <translation>Зрак пројекције који предњу раван сече под {0} (гледано одозго) и {1} (са стране) помера тачку за</translation>
    </message>
    <message>
        <source>That is a shear: the matrix {0}, which leaves the near plane as it is. Here {1}, {2} and {3}: one unit behind the near plane {4}, and x moves by {5}. *Matrices* shows it as *sheared ← view*. After {6} the slanted box is straight, so {7}; the three matrices stand side by side.</source>
        <translation>То је смицање: матрица {0}, која предњу раван оставља каква јесте. Овде је {1}, {2} и {3}: једну јединицу иза предње равни {4}, и x се помера за {5}. *Матрице* је показују као *после смицања ← камера*. После {6} коси паралелепипед је прав, па је {7}; три матрице стоје једна поред друге.</translation>
    </message>
    <message>
        <source>Make it a cabinet drawing</source>
        <translation>Направите цртеж кабинет</translation>
    </message>
    <message>
        <source>The scale of receding edges is {0}; their direction in the picture is free.</source>
        <translation>Размера ивица по дубини је {0}; њихов смер на слици је слободан.</translation>
    </message>
    <message>
        <source>Set the lens so that {0}, in any direction.</source>
        <translation>Поставите објектив тако да буде {0}, у било ком смеру.</translation>
    </message>
    <message>
        <source>The numbers below the scene&apos;s controls give the drawn scale.</source>
        <translation>Бројеви испод контрола сцене дају нацртану размеру.</translation>
    </message>
    <message>
        <source>The scale is 1/2 then.</source>
        <translation>Размера је тада 1/2.</translation>
    </message>
    <message>
        <source>A unit of depth is drawn half as long, in whatever direction it recedes.</source>
        <translation>Јединица дубине црта се упола краће, ма у ком смеру ишла.</translation>
    </message>
    <message>
        <source>How far H moves</source>
        <translation>Колико H помера</translation>
    </message>
    <message>
        <source>The letter F with an oblique lens: {0}, {1}, and the near plane is 2 in front of the eye, so {2}.</source>
        <translation>Слово F са косим објективом: {0}, {1}, а предња раван је 2 испред камере, па је {2}.</translation>
    </message>
    <message>
        <source>What is in row 1, column 4 of H, {0}?</source>
        <translation>Шта стоји у врсти 1, колони 4 матрице H, {0}?</translation>
    </message>
    <message>
        <source>This takes {0} for the slant. At {1} the projectors are straight and shift nothing, so the slant is {2}. Look from above at {3}: the box is almost straight, {4}.</source>
        <translation>Овде је {0} узето за косину. За {1} зраци пројекције су управни и ништа не померају, па је косина {2}. Погледајте одозго {3}: паралелепипед је скоро прав, {4}.</translation>
    </message>
    <message>
        <source>The near plane is at z = 2</source>
        <translation>Предња раван је на z = 2</translation>
    </message>
    <message>
        <source>{0} is {1}, so {2} is positive. With this cell, points of the near plane would move. Look from above: the box slants away from near, and near stays where it is.</source>
        <translation>{0} је {1}, па је {2} позитивно. Са овим пољем померале би се тачке предње равни. Погледајте одозго: паралелепипед се накоси од предње равни даље, а предња раван остаје где јесте.</translation>
    </message>
    <message>
        <source>{0} itself is negative here.</source>
        <translation>Овде је {0} и само негативно.</translation>
    </message>
    <message>
        <source>{0}. With {1} it is 0: the projectors are straight then.</source>
        <translation>{0}. Са {1} је 0: зраци пројекције су тада управни.</translation>
    </message>
    <message>
        <source>By how much does H change x of a point 3 units behind the near plane?</source>
        <translation>За колико H мења x тачке која је 3 јединице иза предње равни?</translation>
    </message>
    <message>
        <source>What recedes goes to the right</source>
        <translation>Што се удаљава, иде удесно</translation>
    </message>
    <message>
        <source>The size is right. Behind the near plane {0} is positive, and the formula subtracts it: x becomes smaller. Look from above at the sides of the box: they lean to the right, and H moves them back to the left.</source>
        <translation>Величина је тачна. Иза предње равни {0} је позитивно, а формула га одузима: x постаје мање. Погледајте одозго бочне стране паралелепипеда: нагињу се удесно, а H их враћа улево.</translation>
    </message>
    <message>
        <source>{0} with {1}.</source>
        <translation>{0} са {1}.</translation>
    </message>
    <message>
        <source>{0}: receding points move to the left.</source>
        <translation>{0}: тачке које се удаљавају померају се улево.</translation>
    </message>
    <message>
        <source>Projectors at 70°</source>
        <translation>Зраци пројекције под 70°</translation>
    </message>
    <message>
        <source>Between the cabinet drawing and the orthographic one the projectors are even steeper.</source>
        <translation>Између цртежа кабинет и ортографског зраци пројекције су још стрмији.</translation>
    </message>
    <message>
        <source>Draw with projectors that meet the picture at 70°, within 1 %.</source>
        <translation>Цртајте зрацима пројекције који слику секу под 70°, са тачношћу од 1 %.</translation>
    </message>
    <message>
        <source>Which scale belongs to this angle? It is {0}.</source>
        <translation>Која размера припада овом углу? То је {0}.</translation>
    </message>
    <message>
        <source>The scale is 0.364 there.</source>
        <translation>Размера је тамо 0.364.</translation>
    </message>
    <message>
        <source>Back to the prediction</source>
        <translation>Назад на предвиђање</translation>
    </message>
    <message>
        <source>Scale 0 belongs to 90°, scale 1 to 45°, so it is tempting to take the middle, 67.5°, for scale 1/2. But the angle does not change evenly with the scale. One unit of depth and {0} units along the picture are the legs of a right triangle, and {1}: for 1/2 that is 63.4°. Look at *World* from above, with the lines from the corners of the body to the near plane.</source>
        <translation>Размера 0 припада углу 90°, размера 1 углу 45°, па је за размеру 1/2 примамљиво узети средину, 67.5°. Али угао се не мења равномерно са размером. Једна јединица дубине и {0} јединица по слици су катете правоуглог троугла, и {1}: за 1/2 то је 63.4°. Погледајте *Свет* одозго, са линијама од темена тела до предње равни.</translation>
    </message>
    <message>
        <source>Practise: the first row of H</source>
        <translation>Вежба: прва врста матрице H</translation>
    </message>
    <message>
        <source>{0} takes x along the projectors to the near plane, which is at {1}. {2} is its matrix.</source>
        <translation>{0} преноси x дуж зрака пројекције на предњу раван, која је на {1}. {2} је његова матрица.</translation>
    </message>
    <message>
        <source>The projectors will slant, with {0}. The near plane is {1} in front of the eye: {2}. What is in row 1 of {3}?</source>
        <translation>Зраци пројекције ће бити коси, са {0}. Предња раван је {1} испред камере: {2}. Шта стоји у врсти 1 матрице {3}?</translation>
    </message>
    <message>
        <source>The near plane is at a positive z</source>
        <translation>Предња раван је на позитивном z</translation>
    </message>
    <message>
        <source>The last cell is {0}, and {1} is negative itself. With this row, points of the near plane would move. Look from above: the box slants away from near, and near stays where it is.</source>
        <translation>Последње поље је {0}, а {1} је и само негативно. Са овом врстом померале би се тачке предње равни. Погледајте одозго: паралелепипед се накоси од предње равни даље, а предња раван остаје где јесте.</translation>
    </message>
    <message>
        <source>Multiply out: how often is z in {0}, and what is left without x and z?</source>
        <translation>Измножите: колико пута {0} садржи z, и шта остаје без x и z?</translation>
    </message>
    <message>
        <source>{0}: points of the near plane stay where they are.</source>
        <translation>{0}: тачке предње равни остају где јесу.</translation>
    </message>
    <message>
        <source>Practise: a far corner</source>
        <translation>Вежба: далеко теме</translation>
    </message>
    <message>
        <source>Points that are {0} behind the front of the cube move by {1} in x and by {2} in y. The front stays.</source>
        <translation>Тачке које су {0} иза предње стране коцке померају се за {1} по x и за {2} по y. Предња страна остаје.</translation>
    </message>
    <message>
        <source>The picture shows a cube, 1 unit wide, from straight in front. With {0} and {1}, where will the corner of its back be drawn that is at {2}, {3} from the middle?</source>
        <translation>Слика показује коцку ширине 1 јединице, право спреда. Са {0} и {1}, где ће се нацртати теме њене задње стране које је {2}, {3} од средине?</translation>
    </message>
    <message>
        <source>This moves the corner by {0} and {1}. At 90° the projectors are straight and move nothing, so it is {2} and {3}. Look at the cube with 80° and 80°: its back has moved very little.</source>
        <translation>Ово помера теме за {0} и {1}. Под 90° зраци пројекције су управни и ништа не померају, па је {2} и {3}. Погледајте коцку са 80° и 80°: њена задња страна се померила врло мало.</translation>
    </message>
    <message>
        <source>What recedes goes to the right and up</source>
        <translation>Што се удаљава, иде удесно и нагоре</translation>
    </message>
    <message>
        <source>This moves the corner the opposite way. An angle below 90° moves what is behind the front to the left, or down; one above 90° to the right, or up. Look at the cube with 60° and 60°: its back has moved to the left and down.</source>
        <translation>Ово помера теме у супротном смеру. Угао испод 90° помера оно што је иза предње стране улево, или надоле; угао изнад 90° удесно, или нагоре. Погледајте коцку са 60° и 60°: њена задња страна се померила улево и надоле.</translation>
    </message>
    <message>
        <source>What recedes goes up</source>
        <translation>Што се удаљава, иде нагоре</translation>
    </message>
    <message>
        <source>x is right. But y was moved the opposite way: {0} below 90° moves the back down, above 90° up. Look at the cube with 60° and 60°: its back has moved to the left and down.</source>
        <translation>x је тачно. Али y је померено у супротном смеру: {0} испод 90° помера задњу страну надоле, изнад 90° нагоре. Погледајте коцку са 60° и 60°: њена задња страна се померила улево и надоле.</translation>
    </message>
    <message>
        <source>Which way is {0} here, and how many widths of the cube is it?</source>
        <translation>На коју страну је овде {0}, и колико је то ширина коцке?</translation>
    </message>
    <message>
        <source>The edges that lead to the back are all drawn alike, {0} to the right and {1} up. The picture is 8 units wide and 4.5 high.</source>
        <translation>Све ивице које воде позади цртају се једнако, {0} удесно и {1} нагоре. Слика је широка 8 јединица, а висока 4.5.</translation>
    </message>
    <message>
        <source>Practise: an angle of your choice</source>
        <translation>Вежба: угао по избору</translation>
    </message>
    <message>
        <source>The projectors of this drawing meet the picture at the angle {0}. Edges that recede are drawn {1} times as long as they are.</source>
        <translation>Зраци пројекције овог цртежа секу слику под углом {0}. Ивице које се удаљавају цртају се {1} пута онолико дугачке колико јесу.</translation>
    </message>
    <message>
        <source>Make {0}, to within 1 %. The direction of the receding edges is free.</source>
        <translation>Нека буде {0}, са тачношћу од 1 %. Смер ивица по дубини је слободан.</translation>
    </message>
    <message>
        <source>Choose *Free scale*. Which scale belongs to this angle?</source>
        <translation>Изаберите *Слободна размера*. Која размера припада овом углу?</translation>
    </message>
    <message>
        <source>A projector goes {0} along the picture for 1 unit of depth. Draw the right triangle with the angle {1}.</source>
        <translation>Зрак пројекције иде {0} по слици за 1 јединицу дубине. Нацртајте правоугли троугао са углом {1}.</translation>
    </message>
    <message>
        <source>The angle is not proportional to the scale: {0}. Look from above at the lines to the near plane: they are flatter than {1}°.</source>
        <translation>Угао није сразмеран размери: {0}. Погледајте одозго линије до предње равни: положеније су од {1}°.</translation>
    </message>
    <message>
        <source>The scale is the cotangent of the angle. Look from above at the lines to the near plane: they meet it at {0}°.</source>
        <translation>Размера је котангенс угла. Погледајте одозго линије до предње равни: секу је под {0}°.</translation>
    </message>
</context>
<context>
    <name>l12-vanishing-points</name>
    <message>
        <source>How many vanishing points?</source>
        <translation>Колико тачака недогледа?</translation>
    </message>
    <message>
        <source>A box, turned</source>
        <translation>Окренута кутија</translation>
    </message>
    <message>
        <source>A box has edges in three directions. With the camera straight in front of it, the edges that lead away from you meet in one point of the picture, {0}. This is a 1-point perspective.</source>
        <translation>Кутија има ивице у три смера. Када је камера право испред ње, ивице које воде од вас секу се у једној тачки слике, {0}. Ово је перспектива са 1 недогледом.</translation>
    </message>
    <message>
        <source>The camera stays level and goes round the box by 30°. How many vanishing points do the box&apos;s edges have now?</source>
        <translation>Камера остаје водоравна и обилази кутију за 30°. Колико тачака недогледа сада имају ивице кутије?</translation>
    </message>
    <message>
        <source>Still one</source>
        <translation>И даље једну</translation>
    </message>
    <message>
        <source>One belongs to a camera that looks straight at a side of the box. Turned by 30°, it sees two directions of level edges lead away. Look at the horizon: {0} and {1} lie on it.</source>
        <translation>Једна припада камери која гледа право у страну кутије. Окренута за 30°, она види два смера водоравних ивица који воде од ње. Погледајте хоризонт: {0} и {1} леже на њему.</translation>
    </message>
    <message>
        <source>Two</source>
        <translation>Две</translation>
    </message>
    <message>
        <source>Three: a box has three directions</source>
        <translation>Три: кутија има три смера</translation>
    </message>
    <message>
        <source>This counts the directions of the box. Edges that are parallel to the picture stay parallel in it and meet nowhere; the uprights are, because the camera is level. Look at the uprights: they are parallel in the picture.</source>
        <translation>Овде су пребројани смерови кутије. Ивице паралелне слици остају на њој паралелне и нигде се не секу; такве су усправне, јер је камера водоравна. Погледајте усправне ивице: на слици су паралелне.</translation>
    </message>
    <message>
        <source>A direction has a vanishing point if it is not parallel to the picture plane, {0}. Uprights are parallel to the picture plane of a level camera and stay parallel in the picture.</source>
        <translation>Смер има тачку недогледа ако није паралелан равни слике, {0}. Усправне ивице су паралелне равни слике водоравне камере и на слици остају паралелне.</translation>
    </message>
    <message>
        <source>A point that runs to infinity</source>
        <translation>Тачка која одлази у бесконачност</translation>
    </message>
    <message>
        <source>{0} runs along an edge. At {1} its {2} is 0: it is no longer a point of space but the direction {3}. Its image is the point that it was heading for all the time.</source>
        <translation>{0} иде дуж ивице. У {1} њено {2} је 0: више није тачка простора, него смер {3}. Њена слика је тачка ка којој је све време ишла.</translation>
    </message>
    <message>
        <source>For a direction {0} in view space the image on a plane at distance {1} is {2}, the same formula as for a point. The start of a line does not matter, so all lines in this direction meet there.</source>
        <translation>За смер {0} у координатном систему камере слика на равни на растојању {1} је {2}, иста формула као за тачку. Почетак праве није важан, па се све праве овог смера тамо секу.</translation>
    </message>
    <message>
        <source>Drag *t* to 1 and beyond: P returns from the other side.</source>
        <translation>Превуците *t* на 1 и преко: P се враћа са друге стране.</translation>
    </message>
    <message>
        <source>Just one</source>
        <translation>Само једна</translation>
    </message>
    <message>
        <source>The camera looks down on the box: three directions, three vanishing points.</source>
        <translation>Камера гледа на кутију одозго: три смера, три тачке недогледа.</translation>
    </message>
    <message>
        <source>Turn the camera until the picture has just one vanishing point, by any axis of the box.</source>
        <translation>Окрените камеру тако да слика има само једну тачку недогледа, по било којој оси кутије.</translation>
    </message>
    <message>
        <source>Elevation 0 removes the vanishing point of the uprights. What next?</source>
        <translation>Елевација 0 уклања тачку недогледа усправних ивица. Шта даље?</translation>
    </message>
    <message>
        <source>The camera&apos;s {0} must be one of the axes.</source>
        <translation>{0} камере мора бити једна од оса.</translation>
    </message>
    <message>
        <source>Two of the three directions are parallel to the picture now; only the third one leads away.</source>
        <translation>Два од три смера су сада паралелна слици; само трећи води од вас.</translation>
    </message>
    <message>
        <source>Where, and how many</source>
        <translation>Где, и колико</translation>
    </message>
    <message>
        <source>Here the camera stands in front of the cube and looks down by 30°.</source>
        <translation>Овде камера стоји испред коцке и гледа надоле под 30°.</translation>
    </message>
    <message>
        <source>How many of the cube&apos;s three directions have a vanishing point?</source>
        <translation>Колико од три смера коцке има тачку недогледа?</translation>
    </message>
    <message>
        <source>That would be a camera that looks along an axis of the cube. This one looks down: the edges along y and those along z both lead away. Look at the edges along y: they run together downwards.</source>
        <translation>То би била камера која гледа дуж осе коцке. Ова гледа надоле: и ивице дуж y и ивице дуж z воде од вас. Погледајте ивице дуж y: надоле се примичу једна другој.</translation>
    </message>
    <message>
        <source>This counts the directions of the cube. The camera is straight in front of it, so the edges along x are parallel to the picture and stay parallel in it. Look at the edges along x: they are parallel in the picture.</source>
        <translation>Овде су пребројани смерови коцке. Камера је право испред ње, па су ивице дуж x паралелне слици и остају на њој паралелне. Погледајте ивице дуж x: на слици су паралелне.</translation>
    </message>
    <message>
        <source>Which edges are parallel to the picture?</source>
        <translation>Које ивице су паралелне слици?</translation>
    </message>
    <message>
        <source>{0}: its x is 0, so edges along x stay parallel. The other two directions have one vanishing point each.</source>
        <translation>{0}: његово x је 0, па ивице дуж x остају паралелне. Друга два смера имају по једну тачку недогледа.</translation>
    </message>
    <message>
        <source>Lines run along {0} in view space, one of them through {1}. At which x on the plane {2} do they meet?</source>
        <translation>Праве иду дуж {0} у координатном систему камере, једна од њих кроз {1}. На ком x у равни {2} се секу?</translation>
    </message>
    <message>
        <source>This is a point ten steps along the line, which falls short of the point where all lines meet. That point depends on the direction alone. Look at P on an edge of this box: as long as {0} is less than 1, it has not reached its vanishing point.</source>
        <translation>Ово је тачка десет корака дуж праве, а она не стиже до тачке где се све праве секу. Та тачка зависи само од смера. Погледајте P на ивици ове кутије: докле год је {0} мање од 1, она није стигла до своје тачке недогледа.</translation>
    </message>
    <message>
        <source>The lines meet in front of the eye, where z is negative: divide by {0}, which is positive. Look at P on an edge of this box: the edge leads away from you, and P has come to its vanishing point on the same side.</source>
        <translation>Праве се секу испред камере, где је z негативно: делите са {0}, што је позитивно. Погледајте P на ивици ове кутије: ивица води од вас, и P је до своје тачке недогледа стигла на истој страни.</translation>
    </message>
    <message>
        <source>The image of the direction itself: {0}.</source>
        <translation>Слика самог смера: {0}.</translation>
    </message>
    <message>
        <source>{0}. After ten steps along the line you are at 0.571; the vanishing point is the limit.</source>
        <translation>{0}. После десет корака дуж праве сте на 0.571; тачка недогледа је граница.</translation>
    </message>
    <message>
        <source>Three, with one below</source>
        <translation>Три, са једном доле</translation>
    </message>
    <message>
        <source>Photographs of high houses are often taken from below, or from a tower.</source>
        <translation>Фотографије високих кућа често се снимају одоздо, или са торња.</translation>
    </message>
    <message>
        <source>Make a 3-point perspective whose {0} lies below the picture.</source>
        <translation>Направите перспективу са 3 недогледа, чије {0} лежи испод слике.</translation>
    </message>
    <message>
        <source>Change the elevation. On which side does {0} appear?</source>
        <translation>Промените елевацију. На којој страни се појављује {0}?</translation>
    </message>
    <message>
        <source>A camera that looks down sees uprights run together below.</source>
        <translation>Камера која гледа надоле види да се усправне ивице доле примичу једна другој.</translation>
    </message>
    <message>
        <source>Back to the prediction</source>
        <translation>Назад на предвиђање</translation>
    </message>
    <message>
        <source>A box has three directions, and everybody knows the name 3-point perspective, so three is tempting. But the number depends on the camera, not on the box. Each axis of the box that is parallel to the picture, {0}, has its vanishing point at infinity, and its edges stay parallel. A level camera keeps uprights upright, which is why architects keep it level. *Kinds of projection* has all of them as small pictures.</source>
        <translation>Кутија има три смера, а назив „перспектива са 3 недогледа” свима је познат, па је три примамљиво. Али број зависи од камере, а не од кутије. Свака оса кутије паралелна слици, {0}, има тачку недогледа у бесконачности, и њене ивице остају паралелне. Водоравна камера усправно оставља усправним, и зато је архитекте држе водоравно. *Врсте пројекција* имају их све као мале слике.</translation>
    </message>
    <message>
        <source>Practise: where lines meet</source>
        <translation>Вежба: где се праве секу</translation>
    </message>
    <message>
        <source>All lines in one direction {0} of view space meet in one point of the picture, which lies on the plane {1}.</source>
        <translation>Све праве једног смера {0} координатног система камере секу се у једној тачки слике, која лежи у равни {1}.</translation>
    </message>
    <message>
        <source>The edges of the box that lead away run along {0} in view space. One more line of this direction starts at {1}. At which {2} do they all meet if {3}?</source>
        <translation>Ивице кутије које воде од вас иду дуж {0} у координатном систему камере. Још једна права овог смера почиње у {1}. У ком {2} се све секу ако је {3}?</translation>
    </message>
    <message>
        <source>This is a point ten steps along the line, which is still before the point where the lines meet. That depends on the direction alone: {0}. Look at P, which runs along such an edge: before {1} it has not reached {2}.</source>
        <translation>Ово је тачка десет корака дуж праве, која је још пре тачке где се праве секу. Она зависи само од смера: {0}. Погледајте P, која иде дуж такве ивице: пре {1} није стигла до {2}.</translation>
    </message>
    <message>
        <source>The line ends where it starts</source>
        <translation>Права се завршава где и почиње</translation>
    </message>
    <message>
        <source>This is the image of the point where the line starts. Where it starts does not matter, only its direction: {0}. Look at P at the start of its edge: it is not at {1}.</source>
        <translation>Ово је слика тачке у којој права почиње. Није важно где почиње, важан је само њен смер: {0}. Погледајте P на почетку њене ивице: није у {1}.</translation>
    </message>
    <message>
        <source>The lines meet in front of the eye, where z is negative: divide by {0}, which is positive. Look at P at {1}: it has come to {2} on the side to which the edges lead.</source>
        <translation>Праве се секу испред камере, где је z негативно: делите са {0}, што је позитивно. Погледајте P у {1}: дошла је у {2} на страни ка којој ивице воде.</translation>
    </message>
    <message>
        <source>The formula for a point&apos;s image, {0}, holds for a direction too.</source>
        <translation>Формула за слику тачке, {0}, важи и за смер.</translation>
    </message>
    <message>
        <source>The start of a line does not matter.</source>
        <translation>Почетак праве није важан.</translation>
    </message>
    <message>
        <source>Practise: find the point</source>
        <translation>Вежба: нађите тачку</translation>
    </message>
    <message>
        <source>The grid&apos;s lines along z meet in one point of the picture, {0}.</source>
        <translation>Линије решетке дуж z секу се у једној тачки слике, {0}.</translation>
    </message>
    <message>
        <source>The camera&apos;s azimuth is {0}°, its elevation {1}°, and the field of view {2}°. Mark {3}.</source>
        <translation>Азимут камере је {0}°, њена елевација {1}°, а видно поље {2}°. Обележите {3}.</translation>
    </message>
    <message>
        <source>This is the end of the middle line of the grid. The grid ends, but the directions of its lines meet farther up: extend two of them. Look at the level lines: the farther away they are, the closer together they lie.</source>
        <translation>Ово је крај средње линије решетке. Решетка се завршава, али смерови њених линија секу се више горе: продужите две. Погледајте водоравне линије: што су даље, то су ближе једна другој.</translation>
    </message>
    <message>
        <source>Rows are counted from the top. The camera looks down, so level lines meet above the middle of the picture. Look at the lines of the grid: they run together upwards.</source>
        <translation>Редови се броје одозго. Камера гледа надоле, па се водоравне праве секу изнад средине слике. Погледајте линије решетке: нагоре се примичу једна другој.</translation>
    </message>
    <message>
        <source>The lines meet on the other side</source>
        <translation>Праве се секу на другој страни</translation>
    </message>
    <message>
        <source>The height is right, the side is not: extend two lines along z, and look on which side of the middle they meet. Look at two of them: the gap between them closes towards one side.</source>
        <translation>Висина је тачна, страна није: продужите две линије дуж z и погледајте на којој страни од средине се секу. Погледајте две од њих: размак између њих се затвара ка једној страни.</translation>
    </message>
    <message>
        <source>Two of the lines are enough; extend them with a ruler, or compute.</source>
        <translation>Две линије су довољне; продужите их лењиром, или рачунајте.</translation>
    </message>
    <message>
        <source>The direction {0} is {1} in view space, with {2}, the elevation, and {3}, the azimuth.</source>
        <translation>Смер {0} је {1} у координатном систему камере, где је {2} елевација, а {3} азимут.</translation>
    </message>
    <message>
        <source>{0} and {1}, with the elevation {2} and the azimuth {3}.</source>
        <translation>{0} и {1}, где је {2} елевација, а {3} азимут.</translation>
    </message>
    <message>
        <source>Practise: as many as asked</source>
        <translation>Вежба: колико се тражи</translation>
    </message>
    <message>
        <source>A direction of the cube has a vanishing point if it is not parallel to the picture.</source>
        <translation>Смер коцке има тачку недогледа ако није паралелан слици.</translation>
    </message>
    <message>
        <source>The cube is turned by {0}° about y. Set the camera so that exactly {1} of its three directions have a vanishing point.</source>
        <translation>Коцка има три смера и окренута је за {0}° око y. Поставите камеру тако да број смерова са тачком недогледа буде тачно {1}.</translation>
    </message>
    <message>
        <source>Which elevation makes the uprights parallel to the picture?</source>
        <translation>Која елевација чини усправне ивице паралелним слици?</translation>
    </message>
    <message>
        <source>Azimuth {0}° looks straight at one side of the cube.</source>
        <translation>Азимут {0}° гледа право у једну страну коцке.</translation>
    </message>
    <message>
        <source>The uprights are parallel to the picture if the camera looks level. From azimuth {0}° one more direction is; from another azimuth two have a vanishing point.</source>
        <translation>Усправне ивице су паралелне слици ако камера гледа водоравно. Из азимута {0}° паралелан јој је још један смер; из другог азимута тачку недогледа имају два.</translation>
    </message>
</context>
<context>
    <name>l13-homogeneous</name>
    <message>
        <source>What w is for</source>
        <translation>Чему служи w</translation>
    </message>
    <message>
        <source>Four numbers for a point</source>
        <translation>Четири броја за тачку</translation>
    </message>
    <message>
        <source>A point can be written with a fourth coordinate, {0}. Many such rows of numbers stand for the same point. With them, matrices can do what they cannot do with three numbers: translate and divide.</source>
        <translation>Тачка може да се запише са четвртом координатом, {0}. Исту тачку означава много таквих врста бројева. Са њима матрице могу оно што са три броја не могу: да транслирају и да деле.</translation>
    </message>
    <message>
        <source>Which point of space is {0}?</source>
        <translation>Која је тачка простора {0}?</translation>
    </message>
    <message>
        <source>(2, 4, −6); the 2 is dropped</source>
        <translation>(2, 4, −6); 2 се изоставља</translation>
    </message>
    <message>
        <source>The fourth number is an extra</source>
        <translation>Четврти број је додатак</translation>
    </message>
    <message>
        <source>The fourth number is not an extra: it is the divisor of the other three. Only if {0} can it be dropped. Look at points 1 and 2: {1} is another place than {2}.</source>
        <translation>Четврти број није додатак: он је делилац осталих трију. Може да се изостави само ако је {0}. Погледајте тачке 1 и 2: {1} је друго место, а не {2}.</translation>
    </message>
    <message>
        <source>None: four numbers are not a point of space</source>
        <translation>Ниједна: четири броја нису тачка простора</translation>
    </message>
    <message>
        <source>They stand for one: divide the first three by the fourth. Many rows of four numbers stand for the same point. Look at point 1: it is the point that they stand for.</source>
        <translation>Означавају једну: поделите прва три четвртим. Много врста од по четири броја означава исту тачку. Погледајте тачку 1: то је тачка коју означавају.</translation>
    </message>
    <message>
        <source>{0} is the point {1}. Type 2, 4, −6 and w = 2 in the Probe panel: it becomes point 1.</source>
        <translation>{0} је тачка {1}. Унесите 2, 4, −6 и w = 2 у панелу „Сонда”: постаје тачка 1.</translation>
    </message>
    <message>
        <source>The w of the lens</source>
        <translation>w објектива</translation>
    </message>
    <message>
        <source>Point 1 is at {0} in view space. The last row of the lens&apos;s matrix is {1}, so {2}, the depth. In clip space nothing is divided yet:</source>
        <translation>Тачка 1 је у {0} у координатном систему камере. Последња врста матрице објектива је {1}, па је {2}, дубина. У простору одсецања још ништа није подељено:</translation>
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
        <translation>одсецање</translation>
    </message>
    <message>
        <source>NDC</source>
        <translation>NDC</translation>
    </message>
    <message>
        <source>The matrix keeps straight lines straight. The division by {0}, which is not a matrix, makes far things small. *Probe* shows each in a row of its own.</source>
        <translation>Матрица чува праве. Дељење са {0}, које није матрица, чини далеке ствари малим. *Сонда* показује свако у посебном реду.</translation>
    </message>
    <message>
        <source>Without a w</source>
        <translation>Без w</translation>
    </message>
    <message>
        <source>If {0}, the division is impossible.</source>
        <translation>Ако је {0}, дељење је немогуће.</translation>
    </message>
    <message>
        <source>Move the camera, or point 1, until the point&apos;s w in clip space is 0, within 0.05.</source>
        <translation>Померајте камеру, или тачку 1, док w те тачке у простору одсецања не буде 0, са тачношћу од 0.05.</translation>
    </message>
    <message>
        <source>{0} is the depth in front of the eye, here 5.</source>
        <translation>{0} је дубина испред камере, овде 5.</translation>
    </message>
    <message>
        <source>The distance is 8, and the point is 3 in front of the target.</source>
        <translation>Растојање је 8, а тачка је 3 испред циља.</translation>
    </message>
    <message>
        <source>The point lies beside the eye, in the eye plane: its image is at infinity, in no pixel.</source>
        <translation>Тачка лежи поред камере, у равни камере: њена слика је у бесконачности, ни у једном пикселу.</translation>
    </message>
    <message>
        <source>Computing with w</source>
        <translation>Рачунање са w</translation>
    </message>
    <message>
        <source>Each question is about a point {0} after the lens&apos;s matrix, or about such a matrix.</source>
        <translation>Свако питање је о тачки {0} после матрице објектива, или о таквој матрици.</translation>
    </message>
    <message>
        <source>A point comes out of the matrix as {0}. What is its {1} in NDC?</source>
        <translation>Тачка излази из матрице као {0}. Колико је њено {1} у NDC?</translation>
    </message>
    <message>
        <source>This is still the first number of the row. In NDC it is divided by the last one, {0}. Look at point 1, which has {1} and {2} in clip space: it is inside the cube, where {3} is at most 1.</source>
        <translation>Ово је још увек први број у врсти. У NDC се он дели последњим, {0}. Погледајте тачку 1, која у простору одсецања има {1} и {2}: она је унутар коцке, где је {3} највише 1.</translation>
    </message>
    <message>
        <source>w has the sign of z</source>
        <translation>w има предзнак од z</translation>
    </message>
    <message>
        <source>The sign has changed: {0} already is the positive depth {1}, so divide by {2} itself. Look at point 1, which has {3} and {4} in clip space: it is in the right half of the picture.</source>
        <translation>Предзнак се променио: {0} је већ позитивна дубина {1}, па делите самим {2}. Погледајте тачку 1, која у простору одсецања има {3} и {4}: она је у десној половини слике.</translation>
    </message>
    <message>
        <source>NDC is the result of the division.</source>
        <translation>NDC је резултат дељења.</translation>
    </message>
    <message>
        <source>{0}. The same w divides y and z.</source>
        <translation>{0}. Исто w дели y и z.</translation>
    </message>
    <message>
        <source>Lecture 000: with {0} in row 4, column 3 the matrix has 1 in row 1, column 1. Multiply the matrix by the {1} that makes row 4, column 3 equal to {2}; let {3}. What is in row 1, column 1 then?</source>
        <translation>Предавање 000: са {0} у врсти 4, колони 3 матрица има 1 у врсти 1, колони 1. Помножите матрицу оним {1} које у врсти 4, колони 3 даје {2}; нека је {3}. Шта тада стоји у врсти 1, колони 1?</translation>
    </message>
    <message>
        <source>One minus is left over</source>
        <translation>Један минус остаје</translation>
    </message>
    <message>
        <source>{0} makes {1}, which is positive: both sides have a minus. Look at {2} in the lecture&apos;s scene: {3} is this length.</source>
        <translation>{0} даје {1}, што је позитивно: обе стране имају минус. Погледајте {2} у сцени предавања: {3} је ова дужина.</translation>
    </message>
    <message>
        <source>{0} and {1} take a point to the same point. Multiply every cell.</source>
        <translation>{0} и {1} преводе тачку у исту тачку. Помножите свако поље.</translation>
    </message>
    <message>
        <source>{0}. All four resulting coordinates are four times as large, and their quotients are the same.</source>
        <translation>{0}. Све четири добијене координате су четири пута веће, а њихови количници исти.</translation>
    </message>
    <message>
        <source>w = 0 before the lens</source>
        <translation>w = 0 пре објектива</translation>
    </message>
    <message>
        <source>{0} is not a point but a direction: a *point at infinity*. A matrix takes it like any other row, and a translation leaves it unchanged. Here P is at {1} along z: its {2} is 0 in the world, yet it has an image, because its w in clip space is not 0.</source>
        <translation>{0} није тачка, него смер: *бесконачно далека тачка*. Матрица га преводи као и сваку другу врсту, а транслација га не мења. Овде је P у {1} дуж z: њено {2} је у свету 0, а ипак има слику, јер њено w у простору одсецања није 0.</translation>
    </message>
    <message>
        <source>The image is 720 high and the field of view 70°. In which row is the image of the direction {0} in view space? Its {1} is {2}.</source>
        <translation>Слика је висока 720, а видно поље је 70°. У ком је реду слика смера {0} у координатном систему камере? Његово {1} је {2}.</translation>
    </message>
    <message>
        <source>Rows are counted from the top. {0} is positive, so the row is above the middle, 360. Look at the numbers beside the frame: 0 is at the top.</source>
        <translation>Редови се броје одозго. {0} је позитивно, па је ред изнад средине, 360. Погледајте бројеве поред рама: 0 је на врху.</translation>
    </message>
    <message>
        <source>This is a point ten steps along a line in this direction. The point at infinity depends on the direction alone: {0}. Look at P at {1}: it has not reached its vanishing point.</source>
        <translation>Ово је тачка десет корака дуж праве овог смера. Бесконачно далека тачка зависи само од смера: {0}. Погледајте P у {1}: није стигла до своје тачке недогледа.</translation>
    </message>
    <message>
        <source>Row {0}.</source>
        <translation>Ред {0}.</translation>
    </message>
    <message>
        <source>{0}, so row 102.9. All lines in this direction meet there.</source>
        <translation>{0}, дакле ред 102.9. Све праве овог смера тамо се секу.</translation>
    </message>
    <message>
        <source>Back to the prediction</source>
        <translation>Назад на предвиђање</translation>
    </message>
    <message>
        <source>It is tempting to read the fourth number as an extra and to drop it. But it is the divisor of the other three. {0} and {1} lie on one line through the origin of four-dimensional space, and this line stands for one point. That is why a matrix can divide: it writes the divisor into {2}. And if {3} is 0, the line stands for a direction, not for a point.</source>
        <translation>Примамљиво је четврти број читати као додатак и изоставити га. Али он је делилац осталих трију. {0} и {1} леже на једној правој кроз координатни почетак четвородимензионог простора, и та права означава једну тачку. Зато матрица може да дели: она делилац уписује у {2}. А ако је {3} једнако 0, права означава смер, а не тачку.</translation>
    </message>
    <message>
        <source>Practise: divide</source>
        <translation>Вежба: делите</translation>
    </message>
    <message>
        <source>Point 1 comes out of the lens&apos;s matrix as {0}.</source>
        <translation>Тачка 1 излази из матрице објектива као {0}.</translation>
    </message>
    <message>
        <source>Its row of numbers is {0}. What is its {1} in NDC?</source>
        <translation>Њена врста бројева је {0}. Колико је њено {1} у NDC?</translation>
    </message>
    <message>
        <source>This is still the first number of the row. In NDC it is divided by the last one, {0}. Look at point 1 in the cube: its {1} is between −1 and 1.</source>
        <translation>Ово је још увек први број у врсти. У NDC се он дели последњим, {0}. Погледајте тачку 1 у коцки: њено {1} је између −1 и 1.</translation>
    </message>
    <message>
        <source>The sign has changed: {0} already is the positive depth {1}, so divide by {2} itself. Look at point 1 in the picture: it is on the side that the sign of {3} says.</source>
        <translation>Предзнак се променио: {0} је већ позитивна дубина {1}, па делите самим {2}. Погледајте тачку 1 на слици: она је на страни коју каже предзнак од {3}.</translation>
    </message>
    <message>
        <source>The third number divides</source>
        <translation>Дели трећи број</translation>
    </message>
    <message>
        <source>This divides by the third number of the row. The divisor is the fourth one, {0}, which the matrix made of the depth. Look at point 1 in the cube: its {1} is between −1 and 1.</source>
        <translation>Овде се дели трећим бројем у врсти. Делилац је четврти, {0}, који је матрица направила од дубине. Погледајте тачку 1 у коцки: њено {1} је између −1 и 1.</translation>
    </message>
    <message>
        <source>Which of the four numbers is the divisor?</source>
        <translation>Који је од четири броја делилац?</translation>
    </message>
    <message>
        <source>The same {0} divides the first three numbers.</source>
        <translation>Исто {0} дели прва три броја.</translation>
    </message>
    <message>
        <source>Practise: the same matrix, multiplied</source>
        <translation>Вежба: иста матрица, помножена</translation>
    </message>
    <message>
        <source>Lecture 000 projects onto the plane {0} by a matrix {1} with 1, 1, 1, 0 on its diagonal, {2} in row 4, column 3, and 0 elsewhere. {3} and {4} take every point to the same point.</source>
        <translation>Предавање 000 пројектује на раван {0} матрицом {1} са 1, 1, 1, 0 на дијагонали, {2} у врсти 4, колони 3, и 0 другде. {3} и {4} преводе сваку тачку у исту тачку.</translation>
    </message>
    <message>
        <source>{0}. Which {1} has {2} in row 4, column 3? Give its rows 3 and 4, columns 3 and 4.</source>
        <translation>{0}. Која {1} има {2} у врсти 4, колони 3? Дајте њене врсте 3 и 4, колоне 3 и 4.</translation>
    </message>
    <message>
        <source>{0} makes {1}, which is positive: both sides have a minus. Look at {2}: {3} is this length.</source>
        <translation>{0} даје {1}, што је позитивно: обе стране имају минус. Погледајте {2}: {3} је ова дужина.</translation>
    </message>
    <message>
        <source>One cell is enough</source>
        <translation>Једно поље је довољно</translation>
    </message>
    <message>
        <source>This changes one cell only. {0} multiplies every cell of the matrix, the ones on the diagonal too. Look at {1}: only for this plane is 1 right.</source>
        <translation>Овде је промењено само једно поље. {0} множи свако поље матрице, и она на дијагонали. Погледајте {1}: само за ову раван је 1 тачно.</translation>
    </message>
    <message>
        <source>The diagonal is divided</source>
        <translation>Дијагонала се дели</translation>
    </message>
    <message>
        <source>This multiplies the diagonal by {0}, but the last row by {1}. All cells have the same factor. Look at {2}: only for this plane are {3} and {4} the same.</source>
        <translation>Овде се дијагонала множи са {0}, а последња врста са {1}. Сва поља имају исти чинилац. Погледајте {2}: само за ову раван су {3} и {4} исто.</translation>
    </message>
    <message>
        <source>By what is {0} multiplied to become {1}?</source>
        <translation>Чиме се множи {0} да постане {1}?</translation>
    </message>
    <message>
        <source>{0}. All four numbers of a point are {1} times as large, and their quotients are the same.</source>
        <translation>{0}. Сва четири броја тачке су {1} пута већа, а њихови количници исти.</translation>
    </message>
    <message>
        <source>Practise: a direction in the picture</source>
        <translation>Вежба: смер на слици</translation>
    </message>
    <message>
        <source>Lines in one direction of view space run to one point of the picture: the image of {0}.</source>
        <translation>Праве једног смера координатног система камере иду ка једној тачки слике: слици од {0}.</translation>
    </message>
    <message>
        <source>A line starts at {0} in view space and runs along {1}. The field of view is {2}°. Mark the image of the line&apos;s point at infinity.</source>
        <translation>Права почиње у {0} у координатном систему камере и иде дуж {1}. Видно поље је {2}°. Обележите слику бесконачно далеке тачке те праве.</translation>
    </message>
    <message>
        <source>This is a point five steps along the line. At infinity {0}, and the start has no part in the image: only the direction counts. Look at point 1, 60 steps along the line: it has moved on.</source>
        <translation>Ово је тачка пет корака дуж праве. У бесконачности је {0}, и почетак нема удела у слици: рачуна се само смер. Погледајте тачку 1, 60 корака дуж праве: отишла је даље.</translation>
    </message>
    <message>
        <source>The column is right, but the rows are counted from the top: a direction that leads up ends in the upper half of the picture. Look at point 1, 60 steps along the line.</source>
        <translation>Колона је тачна, али редови се броје одозго: смер који води нагоре завршава у горњој половини слике. Погледајте тачку 1, 60 корака дуж праве.</translation>
    </message>
    <message>
        <source>{0}, where *aspect* is 16/9.</source>
        <translation>{0}, где је *aspect* једнако 16/9.</translation>
    </message>
    <message>
        <source>{0} is the middle of the picture and {1} its right edge; {2} is its top.</source>
        <translation>{0} је средина слике, а {1} њена десна ивица; {2} је њен врх.</translation>
    </message>
    <message>
        <source>The direction takes the place of a point: {0} and {1} are its clip coordinates divided by their {2}.</source>
        <translation>Смер заузима место тачке: {0} и {1} су његове координате одсецања подељене својим {2}.</translation>
    </message>
    <message>
        <source>Practise: where the divide belongs</source>
        <translation>Вежба: где је место дељењу</translation>
    </message>
    <message>
        <source>Put the tiles in order, and leave out what does not belong.</source>
        <translation>Поређајте плочице и изоставите оно што ту не спада.</translation>
    </message>
    <message>
        <source>The letter was turned about y by {0}° and moved by {1} along x; the eye is at {2}. Which chain takes a point of the letter to NDC?</source>
        <translation>Слово је окренуто око y за {0}° и померено за {1} дуж x; позиција камере је {2}. Који ланац преводи тачку слова у NDC?</translation>
    </message>
    <message>
        <source>A point {0} is scaled by {1}, then moved by {2}, then divided. Which chain is that?</source>
        <translation>Тачка {0} се скалира са {1}, па се помера за {2}, па се дели. Који је то ланац?</translation>
    </message>
    <message>
        <source>The viewport needs numbers from −1 to 1.</source>
        <translation>Области приказа требају бројеви од −1 до 1.</translation>
    </message>
    <message>
        <source>Which chain leads from view space to {0} by 400 pixels?</source>
        <translation>Који ланац води из координатног система камере до слике од {0} пута 400 пиксела?</translation>
    </message>
    <message>
        <source>Only one division makes them. Which one leaves {0}?</source>
        <translation>Такве бројеве прави само једно дељење. После којег остаје {0}?</translation>
    </message>
    <message>
        <source>The lens&apos;s matrix writes the divisor into {0}, the division makes {1} and {2}, and the viewport makes pixels of these.</source>
        <translation>Матрица објектива уписује делилац у {0}, дељење прави {1} и {2}, а област приказа од њих прави пикселе.</translation>
    </message>
    <message>
        <source>Begin at the letter: which matrix takes its points to the world?</source>
        <translation>Почните од слова: која матрица његове тачке преводи у свет?</translation>
    </message>
    <message>
        <source>From the letter to the world, to the camera, through the lens, and at last the division.</source>
        <translation>Од слова до света, до камере, кроз објектив, и на крају дељење.</translation>
    </message>
    <message>
        <source>What acts first stands at the bottom.</source>
        <translation>Што делује прво, стоји на дну.</translation>
    </message>
    <message>
        <source>The scale acts first, so it does not change the move. The division may stand anywhere: neither matrix changes {0}.</source>
        <translation>Скалирање делује прво, па не мења помак. Дељење може стајати било где: ниједна од тих двеју матрица не мења {0}.</translation>
    </message>
</context>
<context>
    <name>l14-to-pixels</name>
    <message>
        <source>From NDC to pixels</source>
        <translation>Од NDC до пиксела</translation>
    </message>
    <message>
        <source>Which row is the top?</source>
        <translation>Који је ред на врху?</translation>
    </message>
    <message>
        <source>The picture is 1280 × 720 pixels. NDC goes from −1 to 1 in x and y, with y upwards.</source>
        <translation>Слика има 1280 × 720 пиксела. NDC иде од −1 до 1 по x и y, са y нагоре.</translation>
    </message>
    <message>
        <source>A point has {0}. At which y of the image is it?</source>
        <translation>Тачка има {0}. На ком је y слике?</translation>
    </message>
    <message>
        <source>In NDC y runs upwards, but the rows of an image are counted from the top, as you read. 720 is the lower edge. Look at point 1, at {0}, and at the numbers beside the frame: 720 is at the bottom.</source>
        <translation>У NDC y иде нагоре, али редови слике се броје одозго, како се и чита. 720 је доња ивица. Погледајте тачку 1, у {0}, и бројеве поред рама: 720 је доле.</translation>
    </message>
    <message>
        <source>360, in the middle</source>
        <translation>360, у средини</translation>
    </message>
    <message>
        <source>The middle is at {0}, because NDC goes from −1 to 1. {1} is an edge of the picture. Look at point 1, at {2}: it is in the middle.</source>
        <translation>Средина је у {0}, јер NDC иде од −1 до 1. {1} је ивица слике. Погледајте тачку 1, у {2}: она је у средини.</translation>
    </message>
    <message>
        <source>The rows of an image are counted from the top, as you read. {0} reverses y.</source>
        <translation>Редови слике се броје одозго, како се и чита. {0} обрће y.</translation>
    </message>
    <message>
        <source>The viewport transform</source>
        <translation>Трансформација области приказа</translation>
    </message>
    <message>
        <source>where {0} and {1} are the image&apos;s width and height. Point 1 has {2} and {3}:</source>
        <translation>где су {0} и {1} ширина и висина слике. Тачка 1 има {2} и {3}:</translation>
    </message>
    <message>
        <source>The Probe panel shows both, in the rows *NDC* and *image px*. A whole number is an edge between pixels: the first pixel goes from 0 to 1, and its centre is at 0.5.</source>
        <translation>Панел „Сонда” показује обоје, у редовима *NDC* и *слика px*. Цео број је ивица између пиксела: први пиксел иде од 0 до 1, а средиште му је у 0.5.</translation>
    </message>
    <message>
        <source>Into the corner</source>
        <translation>У угао</translation>
    </message>
    <message>
        <source>Point 1 is a corner of the F.</source>
        <translation>Тачка 1 је теме слова F.</translation>
    </message>
    <message>
        <source>Bring point 1 within one pixel of (0, 0).</source>
        <translation>Доведите тачку 1 на највише један пиксел од (0, 0).</translation>
    </message>
    <message>
        <source>Drag its mark in *Image*, or move the camera.</source>
        <translation>Превуците њену ознаку у приказу *Слика*, или померите камеру.</translation>
    </message>
    <message>
        <source>In NDC it must come to {0}.</source>
        <translation>У NDC мора доћи у {0}.</translation>
    </message>
    <message>
        <source>(0, 0) is the upper left corner of the picture: x&apos; is −1 there, and y&apos; is 1.</source>
        <translation>(0, 0) је горњи леви угао слике: тамо је x&apos; једнако −1, а y&apos; једнако 1.</translation>
    </message>
    <message>
        <source>By the formula</source>
        <translation>По формули</translation>
    </message>
    <message>
        <source>The image has 1280 × 720 pixels.</source>
        <translation>Слика има 1280 × 720 пиксела.</translation>
    </message>
    <message>
        <source>What is in row 2, column 2 of image ← NDC?</source>
        <translation>Шта стоји у врсти 2, колони 2 матрице „слика ← NDC”?</translation>
    </message>
    <message>
        <source>With this cell, {0} would come to the lowest row. Rows are counted from the top, so {1} changes its sign. Look at point 1, at {2}: it is at the top, in row 0.</source>
        <translation>Са овим пољем {0} би дошло у најнижи ред. Редови се броје одозго, па {1} мења предзнак. Погледајте тачку 1, у {2}: она је на врху, у реду 0.</translation>
    </message>
    <message>
        <source>This takes {0} to run from 0 to 1. It runs from −1 to 1, over a length of 2, so each unit of {1} is half the height. Look at point 1, at {2}: it is in the middle of the picture, and only half the height is left above it.</source>
        <translation>Овде се узима да {0} иде од 0 до 1. Оно иде од −1 до 1, на дужини 2, па је свака јединица од {1} половина висине. Погледајте тачку 1, у {2}: она је у средини слике, и изнад ње остаје само половина висине.</translation>
    </message>
    <message>
        <source>It is the factor of {0}.</source>
        <translation>То је чинилац уз {0}.</translation>
    </message>
    <message>
        <source>{0}: half the height, because NDC is 2 high, and negative, because y is reversed.</source>
        <translation>{0}: половина висине, јер је NDC високо 2, и негативно, јер се y обрће.</translation>
    </message>
    <message>
        <source>This counts the rows upwards, like {0}. They are counted from the top, so a point above the middle has a y below 360. Look at point 1: it is above the middle of the picture.</source>
        <translation>Овде се редови броје нагоре, као {0}. Они се броје одозго, па тачка изнад средине има y мање од 360. Погледајте тачку 1: она је изнад средине слике.</translation>
    </message>
    <message>
        <source>This takes {0} to run from 0 to 1. It runs from −1 to 1 and is 0 in the middle of the picture. Look at point 1: it is above the middle, so its row is less than 360.</source>
        <translation>Овде се узима да {0} иде од 0 до 1. Оно иде од −1 до 1, а у средини слике је 0. Погледајте тачку 1: она је изнад средине, па је њен ред мањи од 360.</translation>
    </message>
    <message>
        <source>Four pixels wide</source>
        <translation>Четири пиксела у ширину</translation>
    </message>
    <message>
        <source>This image has 4 × 2 pixels, counted from 0.</source>
        <translation>Ова слика има 4 × 2 пиксела, који се броје од 0.</translation>
    </message>
    <message>
        <source>At which {0} is the centre of pixel 1?</source>
        <translation>На ком {0} је средиште пиксела 1?</translation>
    </message>
    <message>
        <source>This is the left edge of pixel 1. Its centre is half a pixel farther. Look at the numbers beside the frame, from 0 to 4: pixel 1 reaches from 1 to 2, and its centre is at 1.5.</source>
        <translation>Ово је лева ивица пиксела 1. Његово средиште је пола пиксела даље. Погледајте бројеве поред рама, од 0 до 4: пиксел 1 досеже од 1 до 2, а средиште му је у 1.5.</translation>
    </message>
    <message>
        <source>This is the share of the width, from 0 to 1. {0} runs from −1 to 1. Look at the numbers beside the frame, from 0 to 4: 1.5 is left of the middle, where {1} is negative.</source>
        <translation>Ово је део ширине, од 0 до 1. {0} иде од −1 до 1. Погледајте бројеве поред рама, од 0 до 4: 1.5 је лево од средине, где је {1} негативно.</translation>
    </message>
    <message>
        <source>Pixel 1 goes from 1 to 2 along the image.</source>
        <translation>Пиксел 1 иде дуж слике од 1 до 2.</translation>
    </message>
    <message>
        <source>{0}. The outermost centres are at {1}, not at {2}.</source>
        <translation>{0}. Крајња средишта су у {1}, а не у {2}.</translation>
    </message>
    <message>
        <source>Back to the prediction</source>
        <translation>Назад на предвиђање</translation>
    </message>
    <message>
        <source>In a diagram y goes up, and in NDC too, so 720 is tempting for the top. But an image is stored row by row from the top, and y of the image counts these rows. The minus in {0} does all the work. If you forget it, the picture is upside down, and you notice. If you forget the half pixel, the picture is shifted by half a pixel, and you do not notice.</source>
        <translation>На графику y иде нагоре, и у NDC такође, па је за врх примамљиво рећи 720. Али слика се чува ред по ред одозго, и y слике броји те редове. Минус у {0} обавља сав посао. Ако га заборавите, слика је наопачке, и то приметите. Ако заборавите пола пиксела, слика је померена за пола пиксела, и то не приметите.</translation>
    </message>
    <message>
        <source>Practise: the viewport as a matrix</source>
        <translation>Вежба: област приказа као матрица</translation>
    </message>
    <message>
        <source>The viewport transform takes {0} to {1} by two rows of three numbers.</source>
        <translation>Трансформација области приказа преводи {0} у {1} помоћу две врсте од по три броја.</translation>
    </message>
    <message>
        <source>The image has {0} × {1} pixels. Write down the two rows.</source>
        <translation>Слика има {0} × {1} пиксела. Напишите те две врсте.</translation>
    </message>
    <message>
        <source>With this, {0} comes to the lowest row. Rows are counted from the top: {1}. Look at point 1, at {2}: it is at the top, in row 0.</source>
        <translation>Са овим {0} долази у најнижи ред. Редови се броје одозго: {1}. Погледајте тачку 1, у {2}: она је на врху, у реду 0.</translation>
    </message>
    <message>
        <source>This takes {0} and {1} to run from 0 to 1. They run from {2} to {3}, over a length of 2, with 0 in the middle of the picture. Look at point 1, at {4}: it is in the middle of the picture.</source>
        <translation>Овде се узима да {0} и {1} иду од 0 до 1. Они иду од {2} до {3}, на дужини 2, са 0 у средини слике. Погледајте тачку 1, у {4}: она је у средини слике.</translation>
    </message>
    <message>
        <source>0 is the corner</source>
        <translation>0 је угао</translation>
    </message>
    <message>
        <source>The factors are right. But {0} is the middle of the picture, at {1}, and this takes it to the corner. Look at point 1, at {2}: it is in the middle of the picture.</source>
        <translation>Чиниоци су тачни. Али {0} је средина слике, у {1}, а ово је преводи у угао. Погледајте тачку 1, у {2}: она је у средини слике.</translation>
    </message>
    <message>
        <source>Where do {0} and {1} come to? And {2}?</source>
        <translation>Куда долазе {0} и {1}? А {2}?</translation>
    </message>
    <message>
        <source>{0} and {1}.</source>
        <translation>{0} и {1}.</translation>
    </message>
    <message>
        <source>Practise: find a point</source>
        <translation>Вежба: нађите тачку</translation>
    </message>
    <message>
        <source>{0} and {1} run from {2} to {3} in the picture.</source>
        <translation>{0} и {1} иду на слици од {2} до {3}.</translation>
    </message>
    <message>
        <source>Mark where a point with {0} and {1} is.</source>
        <translation>Обележите где је тачка са {0} и {1}.</translation>
    </message>
    <message>
        <source>The column is right. But {0} runs upwards: {1} is the top of the picture. Look at point 1, at {2}: it is close to the top.</source>
        <translation>Колона је тачна. Али {0} иде нагоре: {1} је врх слике. Погледајте тачку 1, у {2}: она је близу врха.</translation>
    </message>
    <message>
        <source>This takes {0} and {1} for shares of the picture from 0 to 1. Both are 0 in the middle of the picture, and {2} at its left and lower edges. Look at point 1, at {3}.</source>
        <translation>Овде се {0} и {1} узимају за делове слике од 0 до 1. Оба су у средини слике 0, а {2} на њеној левој и доњој ивици. Погледајте тачку 1, у {3}.</translation>
    </message>
    <message>
        <source>Where is {0}, and where {1}?</source>
        <translation>Где је {0}, а где {1}?</translation>
    </message>
    <message>
        <source>{0} and {1}, where {2} and {3} are the image&apos;s width and height.</source>
        <translation>{0} и {1}, где су {2} и {3} ширина и висина слике.</translation>
    </message>
    <message>
        <source>Practise: the centre of a pixel</source>
        <translation>Вежба: средиште пиксела</translation>
    </message>
    <message>
        <source>The pixels of a row are counted from 0. {0} runs from {1} at the left edge of the picture to {2} at the right.</source>
        <translation>Пиксели једног реда броје се од 0. {0} иде од {1} на левој ивици слике до {2} на десној.</translation>
    </message>
    <message>
        <source>The image is {0} pixels wide. At which {1} is the centre of pixel {2}?</source>
        <translation>Ширина слике је {0} px. На ком {1} је средиште пиксела {2}?</translation>
    </message>
    <message>
        <source>This is the left edge of the pixel. Its centre is half a pixel farther, at {0}. Look at the numbers beside the frame, from 0 to {1}: pixel {2} reaches from {3} to {4}.</source>
        <translation>Ово је лева ивица пиксела. Његово средиште је пола пиксела даље, у {0}. Погледајте бројеве поред рама, од 0 до {1}: пиксел {2} досеже од {3} до {4}.</translation>
    </message>
    <message>
        <source>This is its share of the width, from 0 to 1. {0} runs from {1} to {2}: take it twice and subtract 1. Look at the numbers beside the frame, from 0 to {3}: half-way is {4}, not {5}.</source>
        <translation>Ово је његов део ширине, од 0 до 1. {0} иде од {1} до {2}: узмите га двапут и одузмите 1. Погледајте бројеве поред рама, од 0 до {3}: пола пута је {4}, а не {5}.</translation>
    </message>
    <message>
        <source>The outermost centres are at the edges</source>
        <translation>Крајња средишта су на ивицама</translation>
    </message>
    <message>
        <source>This puts the centres of the outermost pixels at {0} and {1}. These are the edges of the picture; the outermost centres are half a pixel inside. Look at the numbers beside the frame, from 0 to {2}: the first centre is at 0.5.</source>
        <translation>Овде су средишта крајњих пиксела стављена у {0} и {1}. То су ивице слике; крајња средишта су пола пиксела унутра. Погледајте бројеве поред рама, од 0 до {2}: прво средиште је у 0.5.</translation>
    </message>
    <message>
        <source>Pixel {0} reaches from {1} to {2} along the row.</source>
        <translation>Пиксел {0} досеже дуж реда од {1} до {2}.</translation>
    </message>
    <message>
        <source>The centre is at {0}, and {1} pixels are 2 wide in {2}.</source>
        <translation>Средиште је у {0}, а ред од {1} пиксела има ширину 2 по {2}.</translation>
    </message>
</context>
<context>
    <name>l15-clipping</name>
    <message>
        <source>What is cut, and when?</source>
        <translation>Шта се сече, и када?</translation>
    </message>
    <message>
        <source>Behind, and in the middle</source>
        <translation>Иза, а у средини</translation>
    </message>
    <message>
        <source>The eye looks along {0}. A point lies behind it, at {1} in view space. If you divide by its {2} anyway, {3} and {4} are between −1 and 1.</source>
        <translation>Камера гледа дуж {0}. Једна тачка лежи иза ње, у {1} у координатном систему камере. Ако ипак поделите њеним {2}, {3} и {4} су између −1 и 1.</translation>
    </message>
    <message>
        <source>Is the point drawn?</source>
        <translation>Да ли се тачка црта?</translation>
    </message>
    <message>
        <source>No</source>
        <translation>Не</translation>
    </message>
    <message>
        <source>Yes: its {0} and {1} are within the picture</source>
        <translation>Да: њени {0} и {1} су унутар слике</translation>
    </message>
    <message>
        <source>What is in the picture is in front</source>
        <translation>Што је на слици, то је испред</translation>
    </message>
    <message>
        <source>After the division it looks like a point of the picture, but {0} says that it is behind the eye. The test comes before the division, while the sign of {1} is still there. Look from above: point 1 is behind the eye.</source>
        <translation>После дељења изгледа као тачка слике, али {0} каже да је иза камере. Тест долази пре дељења, док је предзнак од {1} још ту. Погледајте одозго: тачка 1 је иза камере.</translation>
    </message>
    <message>
        <source>Yes, but upside down</source>
        <translation>Да, али наопачке</translation>
    </message>
    <message>
        <source>A camera is a dark box</source>
        <translation>Камера је мрачна кутија</translation>
    </message>
    <message>
        <source>The division would draw it mirrored, as on a film behind a hole. But a camera draws only what is in front of it: the point is removed before the division. Look from above: point 1 is behind the eye, and nothing of the pyramid is there.</source>
        <translation>Дељење би је нацртало као у огледалу, као на филму иза рупе. Али камера црта само оно што је испред ње: тачка се уклања пре дељења. Погледајте одозго: тачка 1 је иза камере, а тамо нема ничега од пирамиде.</translation>
    </message>
    <message>
        <source>A point is kept if {0}. No point with a negative w satisfies this. The test comes before the division.</source>
        <translation>Тачка се задржава ако је {0}. Ниједна тачка са негативним w то не испуњава. Тест долази пре дељења.</translation>
    </message>
    <message>
        <source>Six planes</source>
        <translation>Шест равни</translation>
    </message>
    <message>
        <source>Before the division the six planes of every lens are the same: {0}. What is wholly inside is drawn, what is wholly beyond one of them is not, and what crosses a plane is cut. An edge from {1} to {2} meets {3} at</source>
        <translation>Пре дељења шест равни је исто за сваки објектив: {0}. Што је цело унутра, црта се, што је цело преко неке од њих, не црта се, а што раван пресеца, сече се. Ивица од {1} до {2} сече {3} у</translation>
    </message>
    <message>
        <source>From {0} to {1}: {2}.</source>
        <translation>Од {0} до {1}: {2}.</translation>
    </message>
    <message>
        <source>Step through *Planes that have cut*: each plane cuts what the plane before it has left, and adds two new corners where it crosses. The highlighted face of the cube is the plane of the step.</source>
        <translation>Прођите кроз *Равни које су одсекле*: свака раван сече оно што је претходна оставила, и додаје два нова темена где сече ивице. Истакнута страна коцке је раван тог корака.</translation>
    </message>
    <message>
        <source>One edge, two planes</source>
        <translation>Једна ивица, две равни</translation>
    </message>
    <message>
        <source>Points 1 and 2 are the ends of an edge: one is 4 units in front of the eye, the other 12. Both are inside.</source>
        <translation>Тачке 1 и 2 су крајеви једне ивице: једна је 4 јединице испред камере, друга 12. Обе су унутра.</translation>
    </message>
    <message>
        <source>Let the edge cross near and far, so that both planes cut it.</source>
        <translation>Нека ивица сече и предњу и задњу раван, тако да је обе одсеку.</translation>
    </message>
    <message>
        <source>Near must lie beyond point 1, far in front of point 2.</source>
        <translation>Предња раван мора лежати иза тачке 1, а задња испред тачке 2.</translation>
    </message>
    <message>
        <source>The planes cut the edge into three pieces; the piece between them is drawn.</source>
        <translation>Равни секу ивицу на три дела; црта се део између њих.</translation>
    </message>
    <message>
        <source>Where it is cut</source>
        <translation>Где се сече</translation>
    </message>
    <message>
        <source>Here are the test points A to E. The eye is at {0} and looks along {1}; far is 11. C is at {2}.</source>
        <translation>Ево пробних тачака од A до E. Камера је у {0} и гледа дуж {1}; задња раван је на 11. C је у {2}.</translation>
    </message>
    <message>
        <source>An edge runs from {0} to {1} in clip space. At which t does it meet {2}?</source>
        <translation>Ивица иде од {0} до {1} у простору одсецања. За које t сече {2}?</translation>
    </message>
    <message>
        <source>This looks for {0}. Before the division the plane is {1}, and {2} changes along the edge as well. Look from above at the side of the pyramid: it slants, because there {3}.</source>
        <translation>Овде се тражи {0}. Пре дељења раван је {1}, а дуж ивице се мења и {2}. Погледајте одозго бочну страну пирамиде: коса је, јер је тамо {3}.</translation>
    </message>
    <message>
        <source>The share in the picture is the share of the edge</source>
        <translation>Део на слици је део ивице</translation>
    </message>
    <message>
        <source>This is the place in the picture, after the division. Along the edge itself {0} changes evenly, {1} does not. Look from above at the side of the pyramid: an edge is cut there, in the world, before it is drawn.</source>
        <translation>Ово је место на слици, после дељења. Дуж саме ивице равномерно се мења {0}, а {1} не. Погледајте одозго бочну страну пирамиде: ивица се сече тамо, у свету, пре него што се нацрта.</translation>
    </message>
    <message>
        <source>{0} is 1 at one end and −5 at the other. Where is it 0?</source>
        <translation>{0} је на једном крају 1, а на другом −5. Где је једнако 0?</translation>
    </message>
    <message>
        <source>{0}. Both x and w change along the edge; in NDC the same place is at 4/9.</source>
        <translation>{0}. Дуж ивице се мењају и x и w; у NDC је исто место на 4/9.</translation>
    </message>
    <message>
        <source>From which value of far on is C inside?</source>
        <translation>Од које вредности задње равни надаље је C унутра?</translation>
    </message>
    <message>
        <source>This measures straight from the eye to C. The far plane is a plane, not a sphere: only the depth along the axis counts. Look from above at far = 12.5: C is inside, though it is 13.9 away.</source>
        <translation>Овде се мери право од камере до C. Задња раван је раван, а не сфера: рачуна се само дубина дуж осе. Погледајте одозго задњу раван на 12.5: C је унутра, иако је на растојању 13.9.</translation>
    </message>
    <message>
        <source>The far plane is a plane: only the depth matters.</source>
        <translation>Задња раван је раван: важна је само дубина.</translation>
    </message>
    <message>
        <source>{0}, however far C is to the side.</source>
        <translation>{0}, ма колико C било у страну.</translation>
    </message>
    <message>
        <source>Just four</source>
        <translation>Само четири</translation>
    </message>
    <message>
        <source>A test point with a grey name is outside.</source>
        <translation>Пробна тачка са сивим именом је изван.</translation>
    </message>
    <message>
        <source>With near and far alone, make exactly four of the five test points lie inside.</source>
        <translation>Само помоћу предње и задње равни нека тачно четири од пет пробних тачака буду унутра.</translation>
    </message>
    <message>
        <source>Which points lie outside because of their depth, and which are beyond a side?</source>
        <translation>Које су тачке изван због своје дубине, а које су преко бочне стране?</translation>
    </message>
    <message>
        <source>Take far back, and watch *test points inside*.</source>
        <translation>Вратите задњу раван назад и пратите *пробне тачке унутра*.</translation>
    </message>
    <message>
        <source>Neither near nor far brings back what the sides cut off.</source>
        <translation>Ни предња ни задња раван не враћају оно што одсецају бочне.</translation>
    </message>
    <message>
        <source>Back to the prediction</source>
        <translation>Назад на предвиђање</translation>
    </message>
    <message>
        <source>&quot;Its {0} is between −1 and 1, so it is in the picture&quot;: that is tempting, because after the division no other test is left. But the division has lost the sign of {1}. A point behind the eye then looks like one in front of it, upside down and on the other side. So clip before the division, by {2}; the near plane removes everything without a positive {3}.</source>
        <translation>„Њено {0} је између −1 и 1, дакле на слици је”: то је примамљиво, јер после дељења није остао ниједан други тест. Али дељење је изгубило предзнак од {1}. Тачка иза камере тада изгледа као тачка испред ње, наопачке и на другој страни. Зато одсецајте пре дељења, са {2}; предња раван уклања све што нема позитивно {3}.</translation>
    </message>
    <message>
        <source>Practise: where an edge leaves</source>
        <translation>Вежба: где ивица излази</translation>
    </message>
    <message>
        <source>The edge from point 1 to point 2 leaves the view volume at the plane {0}. It is cut before the division.</source>
        <translation>Ивица од тачке 1 до тачке 2 излази из запремине погледа кроз раван {0}. Сече се пре дељења.</translation>
    </message>
    <message>
        <source>In clip space point 1 has {0}, {1} and point 2 has {2}, {3}. At which {4}, from point 1 to point 2, does the edge meet {5}?</source>
        <translation>У простору одсецања тачка 1 има {0}, {1}, а тачка 2 има {2}, {3}. За које {4}, од тачке 1 до тачке 2, ивица сече {5}?</translation>
    </message>
    <message>
        <source>This is the place in the picture, after the division. Along the edge itself {0} changes evenly, {1} does not. Look from above at the edge from 1 to 2: it is cut there, not in the picture.</source>
        <translation>Ово је место на слици, после дељења. Дуж саме ивице равномерно се мења {0}, а {1} не. Погледајте одозго ивицу од 1 до 2: сече се тамо, а не на слици.</translation>
    </message>
    <message>
        <source>{0} changes evenly along the edge. How large is it at point 1, and at point 2?</source>
        <translation>{0} се дуж ивице мења равномерно. Колико је у тачки 1, а колико у тачки 2?</translation>
    </message>
    <message>
        <source>{0} is {1} at point 1 and negative at point 2; at {2} it is 0.</source>
        <translation>{0} је {1} у тачки 1, а негативно у тачки 2; за {2} је 0.</translation>
    </message>
    <message>
        <source>Practise: cut by near</source>
        <translation>Вежба: предња раван сече</translation>
    </message>
    <message>
        <source>Point 1 is in front of the camera, point 2 behind it. The near plane cuts the edge between them.</source>
        <translation>Тачка 1 је испред камере, тачка 2 иза ње. Предња раван сече ивицу између њих.</translation>
    </message>
    <message>
        <source>In view space point 1 is at {0}, point 2 at {1}, and near is {2}. In this picture {3}. Mark where the image of the edge ends.</source>
        <translation>У координатном систему камере тачка 1 је у {0}, тачка 2 у {1}, а предња раван је {2}. На овој слици је {3}. Обележите где се слика ивице завршава.</translation>
    </message>
    <message>
        <source>This divides point 2, which is behind the camera: its image is mirrored. First cut the edge at {0}, then divide. Look from above: point 2 is behind the eye, and near cuts the edge before it comes there.</source>
        <translation>Овде се дели тачка 2, која је иза камере: њена слика је као у огледалу. Прво исеците ивицу на {0}, па поделите. Погледајте одозго: тачка 2 је иза камере, а предња раван сече ивицу пре него што она тамо стигне.</translation>
    </message>
    <message>
        <source>This goes from one image to the other by the right {0}. Cut the edge in view space: take {1} at this {2}, then divide. Look from above: near cuts the edge in the world.</source>
        <translation>Овде се са тачним {0} иде од једне слике до друге. Исеците ивицу у координатном систему камере: узмите {1} за ово {2}, па поделите. Погледајте одозго: предња раван сече ивицу у свету.</translation>
    </message>
    <message>
        <source>At which {0} is {1}? Go from {2} to {3}.</source>
        <translation>За које {0} је {1}? Идите од {2} до {3}.</translation>
    </message>
    <message>
        <source>{0} at the cut is {1}; {2} is the right edge of the picture.</source>
        <translation>{0} у пресеку је {1}; {2} је десна ивица слике.</translation>
    </message>
    <message>
        <source>{0}, and the x there is divided by its depth {1}.</source>
        <translation>{0}, а тамошње x се дели дубином {1}.</translation>
    </message>
    <message>
        <source>Practise: cut by far</source>
        <translation>Вежба: задња раван сече</translation>
    </message>
    <message>
        <source>The far plane cuts the edge from point 1 to point 2; {0} is 0 at point 1 and 1 at point 2.</source>
        <translation>Задња раван сече ивицу од тачке 1 до тачке 2; {0} је 0 у тачки 1, а 1 у тачки 2.</translation>
    </message>
    <message>
        <source>In view space point 1 is at {0} and point 2 at {1}. Set far so that it cuts the edge at {2}.</source>
        <translation>У координатном систему камере тачка 1 је у {0}, а тачка 2 у {1}. Поставите задњу раван тако да ивицу сече за {2}.</translation>
    </message>
    <message>
        <source>Which depth does the edge have at {0}? It changes evenly from {1} to {2}.</source>
        <translation>Коју дубину ивица има за {0}? Она се мења равномерно од {1} до {2}.</translation>
    </message>
    <message>
        <source>{0} {1} {2}. How far the points are to the side does not matter.</source>
        <translation>{0} {1} {2}. Није важно колико су тачке у страну.</translation>
    </message>
    <message>
        <source>This measures straight from the eye. Far is a plane across the axis, and only the depth counts. Look from above: your far cuts the edge too far out.</source>
        <translation>Овде се мери право од камере. Задња раван је раван попреко на осу, и рачуна се само дубина. Погледајте одозго: ваша задња раван сече ивицу предалеко.</translation>
    </message>
</context>
<context>
    <name>l16-eye-plane</name>
    <message>
        <source>A line through the eye plane</source>
        <translation>Права кроз раван камере</translation>
    </message>
    <message>
        <source>Both ends have an image</source>
        <translation>Оба краја имају слику</translation>
    </message>
    <message>
        <source>In camera space point 1 is A, at {0}, and point 2 is B, at {1}, behind the camera. With {2} the division gives {3} for each: 0.5 for A and −0.5 for B.</source>
        <translation>У координатном систему камере тачка 1 је A, у {0}, а тачка 2 је B, у {1}, иза камере. Са {2} дељење сваком крају даје {3}: 0.5 за A и −0.5 за B.</translation>
    </message>
    <message>
        <source>Which {0} does the image of the segment AB cover?</source>
        <translation>Које {0} покрива слика дужи AB?</translation>
    </message>
    <message>
        <source>From 0.5 to −0.5, the way from one to the other</source>
        <translation>Од 0.5 до −0.5, пут од једног до другог</translation>
    </message>
    <message>
        <source>This divides both ends and joins the results. B is behind the camera, so its image is mirrored. On the way from A, {0} goes to 0 and {1} beyond every bound: the image runs through infinity, not from 0.5 to −0.5. Look at A&apos; and B&apos;: the line that joins them is wrong.</source>
        <translation>Овде се оба краја поделе, па се резултати споје. B је иза камере, па је његова слика као у огледалу. На путу од A {0} иде у 0, а {1} преко сваке границе: слика пролази кроз бесконачност, а не од 0.5 до −0.5. Погледајте A&apos; и B&apos;: права која их спаја је погрешна.</translation>
    </message>
    <message>
        <source>From 0.5 to infinity</source>
        <translation>Од 0.5 до бесконачности</translation>
    </message>
    <message>
        <source>Just 0.5: B is behind the camera and does not count</source>
        <translation>Само 0.5: B је иза камере и не рачуна се</translation>
    </message>
    <message>
        <source>A is only one end. The half of AB between A and the plane {0} is in front of the camera, and every point of it has an image. Look at the image: it begins at A&apos; and leaves the picture on the right.</source>
        <translation>A је само један крај. Део дужи AB између A и равни {0} је испред камере, и свака његова тачка има слику. Погледајте слику: почиње у A&apos; и излази са слике десно.</translation>
    </message>
    <message>
        <source>From A the segment approaches the eye plane {0}; x stays 1, so {1} grows beyond every bound. The part behind the eye plane has no image.</source>
        <translation>Од A дуж се приближава равни камере {0}; x остаје 1, па {1} расте преко сваке границе. Део иза равни камере нема слику.</translation>
    </message>
    <message>
        <source>Cut before the divide</source>
        <translation>Исеците пре дељења</translation>
    </message>
    <message>
        <source>Lecture 004 cuts the segment at {0} before dividing:</source>
        <translation>Предавање 004 пре дељења сече дуж на {0}:</translation>
    </message>
    <message>
        <source>The scene&apos;s controls have A and B in world coordinates, {0} and {1}; the eye is at {2} and looks along the world&apos;s {3}, so in camera space they are {4} and {5}.</source>
        <translation>Контроле сцене имају A и B у координатама света, {0} и {1}; позиција камере је {2}, а гледа дуж {3} света, па су у координатном систему камере {4} и {5}.</translation>
    </message>
    <message>
        <source>At the cut {0} and {1}, with {2}: far outside the picture, on the right. The naive division goes to {3} instead, on the left.</source>
        <translation>У пресеку је {0} и {1}, са {2}: далеко изван слике, десно. Наивно дељење уместо тога иде у {3}, лево.</translation>
    </message>
    <message>
        <source>*Image* shows the three ways: *naive*, divided without a cut; *cut*, at {0}; and *clipped*, in homogeneous coordinates, which need no such number.</source>
        <translation>*Слика* показује три начина: *наивно*, подељено без сечења; *исечено*, на {0}; и *одсечено*, у хомогеним координатама, којима такав број није потребан.</translation>
    </message>
    <message>
        <source>Case 4</source>
        <translation>Случај 4</translation>
    </message>
    <message>
        <source>The lecture distinguishes four cases by which ends lie in front of the camera. Now both are in front: case 1.</source>
        <translation>Предавање разликује четири случаја, према томе који крајеви леже испред камере. Сада су оба испред: случај 1.</translation>
    </message>
    <message>
        <source>Make it case 4: A in front of the camera, B behind it. (The controls are in world coordinates; the eye is at z = 4.)</source>
        <translation>Направите случај 4: A испред камере, B иза ње. (Контроле су у координатама света; позиција камере је на z = 4.)</translation>
    </message>
    <message>
        <source>Move the camera nearer, or drag B in *World*.</source>
        <translation>Приближите камеру, или превуците B у приказу *Свет*.</translation>
    </message>
    <message>
        <source>B must go behind the plane marked {0}.</source>
        <translation>B мора отићи иза равни означене са {0}.</translation>
    </message>
    <message>
        <source>Now the image of AB leaves the picture and goes on to infinity.</source>
        <translation>Сада слика дужи AB излази са слике и иде у бесконачност.</translation>
    </message>
    <message>
        <source>At the cut</source>
        <translation>У пресеку</translation>
    </message>
    <message>
        <source>In this segment A is at {0} in camera space and B at {1}. It is cut at {2}.</source>
        <translation>У овој дужи A је у {0} у координатном систему камере, а B у {1}. Сече се на {2}.</translation>
    </message>
    <message>
        <source>At which t, from A to B, is the cut?</source>
        <translation>За које t, од A до B, је пресек?</translation>
    </message>
    <message>
        <source>The cut is at the eye plane</source>
        <translation>Пресек је у равни камере</translation>
    </message>
    <message>
        <source>This is where {0}, in the eye plane, where the division is by 0. The lecture cuts a little before it, at {1}. Look at the plane {2}: it goes through the eye, where nothing has an image.</source>
        <translation>Ово је место где је {0}, у равни камере, где се дели са 0. Предавање сече мало пре ње, на {1}. Погледајте раван {2}: она пролази кроз позицију камере, где ништа нема слику.</translation>
    </message>
    <message>
        <source>Put {0} into {1}.</source>
        <translation>Уврстите {0} у {1}.</translation>
    </message>
    <message>
        <source>{0}, a little before the middle.</source>
        <translation>{0}, мало пре средине.</translation>
    </message>
    <message>
        <source>At which {0} is the image of the cut, with {1}?</source>
        <translation>У ком {0} је слика пресека, са {1}?</translation>
    </message>
    <message>
        <source>This divides B, which is behind the camera. Only the part in front of {0} has an image, and it ends at the cut. Look at A&apos; and B&apos;: the line that joins them is wrong.</source>
        <translation>Овде се дели B, које је иза камере. Слику има само део испред {0}, а он се завршава у пресеку. Погледајте A&apos; и B&apos;: права која их спаја је погрешна.</translation>
    </message>
    <message>
        <source>The side is wrong: at the cut {0} is positive, so {1} has the sign of x. Look at the image: it leaves the picture on the right.</source>
        <translation>Страна је погрешна: у пресеку је {0} позитивно, па {1} има предзнак од x. Погледајте слику: излази са слике десно.</translation>
    </message>
    <message>
        <source>First x at the cut, {0}.</source>
        <translation>Прво x у пресеку, {0}.</translation>
    </message>
    <message>
        <source>{0}, so {1}: the line runs out of the picture on the right.</source>
        <translation>{0}, па је {1}: права излази са слике десно.</translation>
    </message>
    <message>
        <source>Case 2</source>
        <translation>Случај 2</translation>
    </message>
    <message>
        <source>If both ends are behind the camera, nothing is drawn. The naive division draws the segment anyway, mirrored.</source>
        <translation>Ако су оба краја иза камере, ништа се не црта. Наивно дељење ипак црта дуж, као у огледалу.</translation>
    </message>
    <message>
        <source>Make it case 2, with B where it is.</source>
        <translation>Направите случај 2, а B оставите где јесте.</translation>
    </message>
    <message>
        <source>A must go behind the plane {0} too.</source>
        <translation>И A мора отићи иза равни {0}.</translation>
    </message>
    <message>
        <source>In this case the lecture only remembers the end point and draws no line.</source>
        <translation>У овом случају предавање само памти крајњу тачку и не црта линију.</translation>
    </message>
    <message>
        <source>Back to the prediction</source>
        <translation>Назад на предвиђање</translation>
    </message>
    <message>
        <source>Two ends, two images, and a line between them: every segment in front of the camera is drawn like this, so it is tempting here too. But the segment crosses the plane {0}, and that point has no image. The image runs to infinity on one side, and the mirrored rest comes back from the other. Joining A&apos; and B&apos; draws exactly the part of the line that is *not* the image of AB. So cut first, then divide.</source>
        <translation>Два краја, две слике, и линија између њих: тако се црта свака дуж испред камере, па је и овде примамљиво. Али дуж пролази кроз раван {0}, а та тачка нема слику. Слика на једној страни одлази у бесконачност, а остатак се као у огледалу враћа са друге. Спајање A&apos; и B&apos; црта управо онај део праве који *није* слика дужи AB. Зато прво исеците, па делите.</translation>
    </message>
    <message>
        <source>Practise: cut, then divide</source>
        <translation>Вежба: исеците, па делите</translation>
    </message>
    <message>
        <source>AB is cut at {0} in camera space, and then divided: {1} with {2}.</source>
        <translation>AB се сече на {0} у координатном систему камере, па се дели: {1} са {2}.</translation>
    </message>
    <message>
        <source>In camera space A is at {0}, {1} and B at {2}, {3}; {4} is 0. At which {5} is the image of the cut?</source>
        <translation>У координатном систему камере A је у {0}, {1}, а B у {2}, {3}; {4} је 0. У ком {5} је слика пресека?</translation>
    </message>
    <message>
        <source>This divides B, which is behind the camera. Only the part of AB in front of {0} has an image, and it ends at the cut. Look from above: B is behind the plane {1}.</source>
        <translation>Овде се дели B, које је иза камере. Слику има само део дужи AB испред {0}, а он се завршава у пресеку. Погледајте одозго: B је иза равни {1}.</translation>
    </message>
    <message>
        <source>The side is wrong: at the cut {0} is positive, so {1} has the sign of {2}. Look from above: the cut, just before the plane {3}, is on the side of its {4}.</source>
        <translation>Страна је погрешна: у пресеку је {0} позитивно, па {1} има предзнак од {2}. Погледајте одозго: пресек, тик пре равни {3}, на страни је свог {4}.</translation>
    </message>
    <message>
        <source>At which {0} from A to B is {1}? There {2}.</source>
        <translation>За које {0} од A до B је {1}? Тамо је {2}.</translation>
    </message>
    <message>
        <source>{0}; the {1} there is divided by 0.01.</source>
        <translation>{0}; тамошње {1} се дели са 0.01.</translation>
    </message>
    <message>
        <source>Practise: the right piece</source>
        <translation>Вежба: исправан део</translation>
    </message>
    <message>
        <source>A is in front of the camera, B behind it. The picture joins their images A&apos; and B&apos;, as the division alone does.</source>
        <translation>A је испред камере, B иза ње. Слика спаја њихове слике A&apos; и B&apos;, као што чини дељење само по себи.</translation>
    </message>
    <message>
        <source>Mark where the right image of AB leaves the picture.</source>
        <translation>Обележите где исправна слика дужи AB излази са слике.</translation>
    </message>
    <message>
        <source>This is B&apos;, the mirrored image of a point behind the camera. The right image never comes there. Look at the world: B is behind the plane {0}.</source>
        <translation>Ово је B&apos;, слика као у огледалу за тачку иза камере. Исправна слика тамо никада не стиже. Погледајте свет: B је иза равни {0}.</translation>
    </message>
    <message>
        <source>Through B&apos; and on</source>
        <translation>Кроз B&apos; и даље</translation>
    </message>
    <message>
        <source>This goes from A&apos; through B&apos; and on. B&apos; is mirrored, so the right image starts at A&apos; in the opposite direction. Look at the world: on the way from A to the plane {0} the edge leaves the pyramid on one side.</source>
        <translation>Ово иде од A&apos; кроз B&apos; и даље. B&apos; је као у огледалу, па исправна слика почиње у A&apos; у супротном смеру. Погледајте свет: на путу од A до равни {0} ивица излази из пирамиде на једној страни.</translation>
    </message>
    <message>
        <source>It lies on the same line. On which side of A&apos;?</source>
        <translation>Лежи на истој правој. На којој страни од A&apos;?</translation>
    </message>
    <message>
        <source>It starts at A&apos; and goes away from B&apos;. In {0} and {1}, {2}, {3}, and the edge of the picture is at {4}.</source>
        <translation>Почиње у A&apos; и удаљава се од B&apos;. По {0} и {1}, {2}, {3}, а ивица слике је у {4}.</translation>
    </message>
    <message>
        <source>Practise: the four cases</source>
        <translation>Вежба: четири случаја</translation>
    </message>
    <message>
        <source>Case 1: both ends are in front of the camera. Case 2: both are behind it. Case 3: only A is behind it. Case 4: only B is.</source>
        <translation>Случај 1: оба краја су испред камере. Случај 2: оба су иза ње. Случај 3: само A је иза ње. Случај 4: само B.</translation>
    </message>
    <message>
        <source>Make it case {0}. Leave A and B where they are.</source>
        <translation>Направите случај {0}. Оставите A и B где јесу.</translation>
    </message>
    <message>
        <source>What is behind the camera lies beyond the plane marked {0}. Move the camera, or turn it.</source>
        <translation>Што је иза камере, лежи преко равни означене са {0}. Померите камеру, или је окрените.</translation>
    </message>
    <message>
        <source>In camera space the ends behind the camera have {0}. So it is with the eye at {1}, if it looks towards {2}.</source>
        <translation>У координатном систему камере крајеви иза камере имају {0}. Тако је са позицијом камере {1}, ако гледа ка {2}.</translation>
    </message>
</context>
<context>
    <name>l17-depth-buffer</name>
    <message>
        <source>What eats the depth buffer?</source>
        <translation>Шта троши бафер дубине?</translation>
    </message>
    <message>
        <source>Half of the range gone</source>
        <translation>Пола опсега мање</translation>
    </message>
    <message>
        <source>A depth buffer keeps one code for each pixel, here of 16 bits. Surface 2 lies behind surface 1. Where both get the same code, you see the one drawn last; this makes the stripes at the far end of the ramp. The scene&apos;s numbers say how large a gap at the target, 20 units away, is certain to be resolved.</source>
        <translation>Бафер дубине за сваки пиксел чува један код, овде од 16 бита. Површ 2 лежи иза површи 1. Где обе добију исти код, видите ону која је нацртана последња; отуда пруге на даљем крају рампе. Бројеви сцене кажу колики се размак код циља, на 20 јединица, сигурно разликује.</translation>
    </message>
    <message>
        <source>Far moves in from 100 to 50. By how much does the gap needed at 20 units shrink?</source>
        <translation>Задња раван се примиче са 100 на 50. За колико се смањи размак потребан на 20 јединица?</translation>
    </message>
    <message>
        <source>by 50 %</source>
        <translation>за 50 %</translation>
    </message>
    <message>
        <source>This spreads the codes evenly from near to far, so that half of the range would need half as many. Most codes lie just behind near; the part from 50 to 100 had hardly any to give. Look at both pictures: as much of the ramp is striped, though single stripes move.</source>
        <translation>Овде су кодови равномерно распоређени од предње до задње равни, па би половини опсега требало упола мање кодова. Већина кодова лежи одмах иза предње равни; део од 50 до 100 једва да је неки имао да уступи. Погледајте обе слике: пругаст је једнако велик део рампе, мада се поједине пруге померају.</translation>
    </message>
    <message>
        <source>far 100</source>
        <translation>задња раван 100</translation>
    </message>
    <message>
        <source>far 50</source>
        <translation>задња раван 50</translation>
    </message>
    <message>
        <source>by 0.1 %</source>
        <translation>за 0.1 %</translation>
    </message>
    <message>
        <source>by 75 %</source>
        <translation>за 75 %</translation>
    </message>
    <message>
        <source>The square belongs to the distance {0} of the surfaces, which has not changed; far enters as {1}. Look at both pictures: as much of the ramp is striped, though single stripes move.</source>
        <translation>Квадрат припада растојању {0} површи, које се није променило; задња раван улази као {1}. Погледајте обе слике: пругаст је једнако велик део рампе, мада се поједине пруге померају.</translation>
    </message>
    <message>
        <source>Depth depends on {0}, and {1} has only become {2}. (Single stripes move with every change of the codes, and with the size of the picture; the gap does not depend on it.)</source>
        <translation>Дубина зависи од {0}, а {1} је само постало {2}. (Поједине пруге се померају са сваком променом кодова, и са величином слике; размак од тога не зависи.)</translation>
    </message>
    <message>
        <source>Where the codes are</source>
        <translation>Где су кодови</translation>
    </message>
    <message>
        <source>The buffer stores a number from 0 at near to 1 at far. At the distance {0} it is</source>
        <translation>Бафер чува број од 0 на предњој равни до 1 на задњој. На растојању {0} то је</translation>
    </message>
    <message>
        <source>Here {0}, {1}, and point 1 lies at {2}: {3}, as in the row *depth* of the Probe panel. The first two fifths of the way use 97 % of the codes. A step of {4} in {5} is therefore long in the world:</source>
        <translation>Овде је {0}, {1}, а тачка 1 лежи у {2}: {3}, као у реду *дубина* панела „Сонда”. Прве две петине пута троше 97 % кодова. Корак од {4} у {5} зато је у свету дугачак:</translation>
    </message>
    <message>
        <source>With 16 bits {0}, and the gap is 0.00598. As {1} is so small, the gap grows with {2}, and a near plane ten times as close makes it ten times as large.</source>
        <translation>Са 16 бита {0}, а размак је 0.00598. Пошто је {1} тако мало, размак расте са {2}, а десет пута ближа предња раван чини га десет пута већим.</translation>
    </message>
    <message>
        <source>Make it sure</source>
        <translation>Нека буде сигурно</translation>
    </message>
    <message>
        <source>At the start near is 0.1, and the gap that is certain at the target is 0.061.</source>
        <translation>На почетку је предња раван 0.1, а размак који је код циља сигуран је 0.061.</translation>
    </message>
    <message>
        <source>Make that gap smaller than 0.01, with the whole ramp still between near and far. The ramp begins 3.35 units from the eye and ends at 47.75.</source>
        <translation>Нека тај размак буде мањи од 0.01, а да цела рампа и даље буде између предње и задње равни. Рампа почиње 3.35 јединица од камере, а завршава се на 47.75.</translation>
    </message>
    <message>
        <source>Which of near and far stands alone in the denominator of the gap?</source>
        <translation>Која од предње и задње равни стоји сама у имениоцу размака?</translation>
    </message>
    <message>
        <source>Move Near outwards, to 1 or more. More bits, under Format, also work.</source>
        <translation>Удаљите предњу раван, на 1 или више. Помаже и више битова, под „Формат”.</translation>
    </message>
    <message>
        <source>The stripes are gone. Near matters, and so does the number of bits; far hardly does.</source>
        <translation>Пруге су нестале. Важна је предња раван, и број битова; задња једва.</translation>
    </message>
    <message>
        <source>How deep is it stored?</source>
        <translation>Колико дубоко се чува?</translation>
    </message>
    <message>
        <source>Near is 2 and far is 50. Which number from 0 to 1 is stored for a point at the distance 10?</source>
        <translation>Предња раван је 2, а задња 50. Који број од 0 до 1 се чува за тачку на растојању 10?</translation>
    </message>
    <message>
        <source>This spreads the stored numbers evenly from near to far. They change with one over the distance, fast just behind near and hardly at all before far. Look at point 1, 10 away, in the cube: it is close to far.</source>
        <translation>Овде су сачувани бројеви равномерно распоређени од предње до задње равни. Они се мењају са реципрочном вредношћу растојања, брзо одмах иза предње равни, а једва нешто пред задњом. Погледајте тачку 1, на растојању 10, у коцки: близу је задње равни.</translation>
    </message>
    <message>
        <source>The buffer holds z&apos;</source>
        <translation>Бафер садржи z&apos;</translation>
    </message>
    <message>
        <source>This is the depth from −1 to 1 of NDC. The buffer begins with 0 at near: add 1, then halve. Look at point 1, 10 away, in the cube: its {0} is your number.</source>
        <translation>Ово је дубина од −1 до 1 из NDC. Бафер почиње са 0 на предњој равни: додајте 1, па преполовите. Погледајте тачку 1, на растојању 10, у коцки: њено {0} је ваш број.</translation>
    </message>
    <message>
        <source>This leaves out a division by the distance 10. No stored number is larger than 1, which is the far plane&apos;s. Look at point 1, 10 away, in the cube: it lies before far.</source>
        <translation>Овде недостаје дељење растојањем 10. Ниједан сачувани број није већи од 1, а то је број задње равни. Погледајте тачку 1, на растојању 10, у коцки: лежи испред задње равни.</translation>
    </message>
    <message>
        <source>{0}: the first sixth of the way takes five sixths of the codes.</source>
        <translation>{0}: прва шестина пута узима пет шестина кодова.</translation>
    </message>
    <message>
        <source>The formula for {0} is in step 2.</source>
        <translation>Формула за {0} је у кораку 2.</translation>
    </message>
    <message>
        <source>How far apart must two surfaces be at the distance 40, with a buffer of 16 bits?</source>
        <translation>Колико морају бити размакнуте две површи на растојању 40, са бафером од 16 бита?</translation>
    </message>
    <message>
        <source>This makes the gap the same at every distance. It would be if the codes were spread evenly, but most of them lie just behind near; at the distance {0} the gap is proportional to {1}. Look at the stripes with near = 0.1: they begin far out and widen with the distance.</source>
        <translation>Овде је размак исти на сваком растојању. Био би када би кодови били равномерно распоређени, али већина их лежи одмах иза предње равни; на растојању {0} размак је сразмеран са {1}. Погледајте пруге са предњом равни на 0.1: почињу далеко и шире се са растојањем.</translation>
    </message>
    <message>
        <source>The gap grows with {0}: it is a little more than four times the scene&apos;s number for the target, at the distance 20.</source>
        <translation>Размак расте са {0}: нешто је више него четири пута већи од броја сцене за циљ, на растојању 20.</translation>
    </message>
    <message>
        <source>Back to far</source>
        <translation>Назад на задњу раван</translation>
    </message>
    <message>
        <source>With far at 50 instead of 100 the range is half as long, so it is tempting to expect codes twice as close. They would be if depth changed evenly. But it changes with {0}, so most codes lie just behind near. The space from 50 to 100 had hardly any, and giving them up gains nothing. Now move *Near* a little and watch the stripes.</source>
        <translation>Са задњом равни на 50 уместо на 100 опсег је упола краћи, па је примамљиво очекивати двоструко гушће кодове. Били би када би се дубина мењала равномерно. Али она се мења са {0}, па већина кодова лежи одмах иза предње равни. Простор од 50 до 100 једва да их је имао, и ништа се не добија ако га се одрекнете. Сада мало померите *Предњу раван* и пратите пруге.</translation>
    </message>
    <message>
        <source>Practise: a stored depth</source>
        <translation>Вежба: сачувана дубина</translation>
    </message>
    <message>
        <source>Near is {0}, far is {1}, and point 1 is at the distance {2}, straight ahead. Which number from 0 to 1 is stored for it?</source>
        <translation>Предња раван је {0}, задња {1}, а тачка 1 је на растојању {2}, право напред. Који број од 0 до 1 се за њу чува?</translation>
    </message>
    <message>
        <source>This spreads the stored numbers evenly from near to far. They change with {0}, fast just behind near and hardly at all before far. Look at point 1 in the cube: it is closer to far than in the world.</source>
        <translation>Овде су сачувани бројеви равномерно распоређени од предње до задње равни. Они се мењају са {0}, брзо одмах иза предње равни, а једва нешто пред задњом. Погледајте тачку 1 у коцки: ближа је задњој равни него у свету.</translation>
    </message>
    <message>
        <source>This is the depth from −1 to 1 of NDC. The buffer begins with 0 at near: add 1, then halve. Look at point 1 in the cube: its {0} is your number.</source>
        <translation>Ово је дубина од −1 до 1 из NDC. Бафер почиње са 0 на предњој равни: додајте 1, па преполовите. Погледајте тачку 1 у коцки: њено {0} је ваш број.</translation>
    </message>
    <message>
        <source>This leaves out a division by {0}. No stored number is larger than 1, which is the far plane&apos;s. Look at point 1 in the cube: it lies before far.</source>
        <translation>Овде недостаје дељење са {0}. Ниједан сачувани број није већи од 1, а то је број задње равни. Погледајте тачку 1 у коцки: лежи испред задње равни.</translation>
    </message>
    <message>
        <source>It must be 0 for {0} and 1 for {1}.</source>
        <translation>Мора бити 0 за {0} и 1 за {1}.</translation>
    </message>
    <message>
        <source>Only {0} is spread evenly, so the formula divides by {1}.</source>
        <translation>Равномерно је распоређено само {0}, па формула дели са {1}.</translation>
    </message>
    <message>
        <source>Of the way from near to far, the point has come {0} %.</source>
        <translation>Од пута од предње до задње равни тачка је прешла {0} %.</translation>
    </message>
    <message>
        <source>Practise: the gap that is certain</source>
        <translation>Вежба: размак који је сигуран</translation>
    </message>
    <message>
        <source>Near is {0}, far is {1}, and the buffer has 16 bits. Point 1 on the ramp is at the distance {2}. How far behind it must another surface be to be certain of a code of its own?</source>
        <translation>Предња раван је {0}, задња {1}, а бафер има 16 бита. Тачка 1 на рампи је на растојању {2}. Колико иза ње мора бити друга површ да би сигурно имала сопствени код?</translation>
    </message>
    <message>
        <source>This makes the gap the same at every distance. It would be if the codes were spread evenly, but most of them lie just behind near; the gap is proportional to {0}. Look at the stripes with near = 0.1: they begin far out and widen with the distance.</source>
        <translation>Овде је размак исти на сваком растојању. Био би када би кодови били равномерно распоређени, али већина их лежи одмах иза предње равни; размак је сразмеран са {0}. Погледајте пруге са предњом равни на 0.1: почињу далеко и шире се са растојањем.</translation>
    </message>
    <message>
        <source>Twice as far, twice the gap</source>
        <translation>Двапут даље, двапут већи размак</translation>
    </message>
    <message>
        <source>This makes the gap proportional to {0}. The stored number changes with {1}, whose slope is {2}: twice as far needs four times the gap. Look at the stripes with near = 0.1: they widen faster than the distance grows.</source>
        <translation>Овде је размак сразмеран са {0}. Сачувани број се мења са {1}, чији је нагиб {2}: двапут даље тражи четири пута већи размак. Погледајте пруге са предњом равни на 0.1: шире се брже него што растојање расте.</translation>
    </message>
    <message>
        <source>The 16 bits have {0} steps.</source>
        <translation>16 бита имају {0} корака.</translation>
    </message>
    <message>
        <source>Share {0} among them: that is {1}, and the gap is {2}.</source>
        <translation>Поделите {0} на њих: то је {1}, а размак је {2}.</translation>
    </message>
    <message>
        <source>With near twice as far out, the gap would be about half as large.</source>
        <translation>Са двапут даљом предњом равни размак би био отприлике упола мањи.</translation>
    </message>
    <message>
        <source>Practise: near for a depth</source>
        <translation>Вежба: предња раван за дубину</translation>
    </message>
    <message>
        <source>Far is {0}, and point 1 is at the distance {1}. Move near until {2} is stored for the point, on the scale from 0 to 1.</source>
        <translation>Задња раван је {0}, а тачка 1 је на растојању {1}. Померајте предњу раван док се за тачку не чува {2}, на скали од 0 до 1.</translation>
    </message>
    <message>
        <source>Solve {0} for {1}; here {2}, {3}, {4}.</source>
        <translation>Решите {0} по {1}; овде је {2}, {3}, {4}.</translation>
    </message>
    <message>
        <source>{0}. Then type it under Near.</source>
        <translation>{0}. Затим то унесите под „Предња раван”.</translation>
    </message>
    <message>
        <source>You have set {0} to {1}. The buffer begins with 0 at near: it stores {2}. Look at point 1 in the cube: it is at {3}.</source>
        <translation>Поставили сте {0} на {1}. Бафер почиње са 0 на предњој равни: чува {2}. Погледајте тачку 1 у коцки: она је у {3}.</translation>
    </message>
</context>
<context>
    <name>l18-interpolation</name>
    <message>
        <source>What is half-way?</source>
        <translation>Шта је пола пута?</translation>
    </message>
    <message>
        <source>Half-way in the picture</source>
        <translation>Пола пута на слици</translation>
    </message>
    <message>
        <source>A rasteriser knows a quantity {0}, such as a colour or a texture coordinate, at the ends of an edge. It must find {1} at the pixels between. In the Image pane the left edge of the board is marked.</source>
        <translation>Растеризатор познаје величину {0}, као што је боја или координата текстуре, на крајевима ивице. Мора да нађе {1} у пикселима између. У приказу „Слика” обележена је лева ивица табле.</translation>
    </message>
    <message>
        <source>The camera goes down until the far end of the marked edge is four times as deep as the near end. Along the edge, {0} grows evenly from 0 at the near end to 1. What is {1} half-way between the two ends in the *picture*?</source>
        <translation>Камера се спушта док даљи крај обележене ивице не буде на четири пута већој дубини од ближег. Дуж ивице {0} расте равномерно од 0 на ближем крају до 1. Колико је {1} на пола пута између два краја на *слици*?</translation>
    </message>
    <message>
        <source>This spreads {0} evenly over the picture. The far half of the edge is drawn much shorter than the near half, so the middle of the picture shows a place closer to the near end. Look at the two marks: half-way in the picture is the nearer one.</source>
        <translation>Овде је {0} равномерно распоређено по слици. Даља половина ивице црта се много краће од ближе, па средина слике показује место ближе предњем крају. Погледајте две ознаке: пола пута на слици је ближа.</translation>
    </message>
    <message>
        <source>The middle of the *edge* is seen there, four fifths of the way in the picture. The question is about half-way in the picture. Look at the two marks: half-way in the world is the farther one.</source>
        <translation>Тамо се види средина *ивице*, на четири петине пута на слици. Питање је о пола пута на слици. Погледајте две ознаке: пола пута у свету је даља.</translation>
    </message>
    <message>
        <source>The last of the scene&apos;s numbers says 20 %. The far parts are drawn shorter, so four fifths of the edge share the far half of its picture.</source>
        <translation>Последњи од бројева сцене каже 20 %. Даљи делови се цртају краће, па четири петине ивице деле даљу половину њене слике.</translation>
    </message>
    <message>
        <source>One over the depth</source>
        <translation>Реципрочна вредност дубине</translation>
    </message>
    <message>
        <source>Two points have depths {0}, {1} and values {2}, {3}. At the share {4} of the way in the picture,</source>
        <translation>Две тачке имају дубине {0}, {1} и вредности {2}, {3}. На делу {4} пута на слици је</translation>
    </message>
    <message>
        <source>The edge now begins at 5 and ends at 15. Half-way in the picture {0}, so the place is at the depth 7.5, and {1}. Both diagrams below show straight lines: {2} and the depth {3} may be interpolated directly on the screen.</source>
        <translation>Ивица сада почиње на 5, а завршава се на 15. На пола пута на слици је {0}, па је место на дубини 7.5, и {1}. Оба дијаграма испод показују праве: {2} и дубина {3} могу се интерполирати директно на екрану.</translation>
    </message>
    <message>
        <source>A quarter off</source>
        <translation>Грешка од четвртине</translation>
    </message>
    <message>
        <source>Now the board is drawn *affine*: {0} itself is interpolated, and the checks bend at the diagonal.</source>
        <translation>Сада се табла црта *афино*: интерполира се сама величина {0}, и шаховница се прелама на дијагонали.</translation>
    </message>
    <message>
        <source>Move the camera until the point half-way in the picture of the marked edge is at most 25 % along the edge. Then affine is wrong by a quarter of the edge. The edge must stay beyond the near plane.</source>
        <translation>Померајте камеру док тачка на пола пута на слици обележене ивице не буде на највише 25 % ивице. Тада афино греши за четвртину ивице. Ивица мора остати иза предње равни.</translation>
    </message>
    <message>
        <source>One end must be at least three times as deep as the other.</source>
        <translation>Један крај мора бити на бар трипут већој дубини од другог.</translation>
    </message>
    <message>
        <source>Go nearer with Distance, or lower with Elevation. If the board reaches behind near, make Near smaller.</source>
        <translation>Приђите ближе помоћу „Растојање”, или ниже помоћу „Елевација”. Ако табла залази иза предње равни, смањите „Предња раван”.</translation>
    </message>
    <message>
        <source>The deeper the edge leads, the larger the error. Choose *correct* under Interpolation and see what moves.</source>
        <translation>Што ивица води дубље, то је грешка већа. Изаберите *исправно* под „Интерполација” и погледајте шта се помера.</translation>
    </message>
    <message>
        <source>By the formula</source>
        <translation>По формули</translation>
    </message>
    <message>
        <source>The marked edge begins at the depth 5 and ends at 15. A brightness goes from 10 at its near end to 50 at its far end. How bright is it a quarter of the way in the picture, {0}?</source>
        <translation>Обележена ивица почиње на дубини 5, а завршава се на 15. Осветљеност иде од 10 на ближем крају до 50 на даљем. Колика је на четвртини пута на слици, {0}?</translation>
    </message>
    <message>
        <source>This mixes the brightness itself. In the picture only what is divided by the depth changes evenly: divide both ends by their depths, mix, and divide by the mixed {0}. Look at the two marks: half-way in the picture is not half-way along the edge.</source>
        <translation>Овде се меша сама осветљеност. На слици се равномерно мења само оно што је подељено дубином: поделите оба краја њиховим дубинама, помешајте, па поделите помешаним {0}. Погледајте две ознаке: пола пута на слици није пола пута дуж ивице.</translation>
    </message>
    <message>
        <source>Divide both by their depths, mix, and divide by the mixed {0}: {1}.</source>
        <translation>Поделите оба краја њиховим дубинама, помешајте, па поделите помешаним {0}: {1}.</translation>
    </message>
    <message>
        <source>First {0} at both ends, then {1} at both ends.</source>
        <translation>Прво {0} на оба краја, затим {1} на оба краја.</translation>
    </message>
    <message>
        <source>What is the depth of the point a quarter of the way in the picture?</source>
        <translation>Колика је дубина тачке на четвртини пута на слици?</translation>
    </message>
    <message>
        <source>This mixes the depth itself. In the picture one over the depth changes evenly, not the depth. Look at the two marks: half-way in the picture is nearer than half-way along the edge.</source>
        <translation>Овде се меша сама дубина. На слици се равномерно мења реципрочна вредност дубине, а не дубина. Погледајте две ознаке: пола пута на слици је ближе него пола пута дуж ивице.</translation>
    </message>
    <message>
        <source>Back to half-way</source>
        <translation>Назад на пола пута</translation>
    </message>
    <message>
        <source>One half was tempting because the picture of a straight edge is straight, and its middle is easy to see. But the division by the depth is not even along the edge: at four times the depth, a piece is drawn a quarter as wide. So half of the picture shows only the nearest fifth. Interpolate the divided quantities, {0} and {1}, and then divide.</source>
        <translation>Једна половина била је примамљива, јер је слика праве ивице права, а њена средина се лако види. Али дељење дубином није дуж ивице равномерно: на четири пута већој дубини део се црта четири пута краће. Зато половина слике показује само најближу петину. Интерполирајте подељене величине, {0} и {1}, па онда делите.</translation>
    </message>
    <message>
        <source>Practise: a value on the way</source>
        <translation>Вежба: вредност успут</translation>
    </message>
    <message>
        <source>Points 1 and 2 are the ends of an edge.</source>
        <translation>Тачке 1 и 2 су крајеви једне ивице.</translation>
    </message>
    <message>
        <source>Point 1 is {0} deep and has {1}. Point 2 is {2} deep and has {3}. What is {4} at the share {5} of the way from 1 to 2 in the picture?</source>
        <translation>Тачка 1 је на дубини {0} и има {1}. Тачка 2 је на дубини {2} и има {3}. Колико је {4} на делу {5} пута од 1 до 2 на слици?</translation>
    </message>
    <message>
        <source>This mixes {0} itself. In the picture only the divided quantities change evenly: mix {1} and {2}, then divide. Look at the two marks: half-way in the picture is not half-way along the edge.</source>
        <translation>Овде се меша сама величина {0}. На слици се равномерно мењају само подељене величине: помешајте {1} и {2}, па поделите. Погледајте две ознаке: пола пута на слици није пола пута дуж ивице.</translation>
    </message>
    <message>
        <source>a/z is a</source>
        <translation>a/z је a</translation>
    </message>
    <message>
        <source>This is {0} at the place, not yet {1}. Divide it by {2} there. Look at the two marks: half-way in the picture is nearer, so {3} counts for more.</source>
        <translation>Ово је {0} на том месту, а још није {1}. Поделите га тамошњим {2}. Погледајте две ознаке: пола пута на слици је ближе, па {3} вреди више.</translation>
    </message>
    <message>
        <source>First {0} and {1} at both ends.</source>
        <translation>Прво {0} и {1} на оба краја.</translation>
    </message>
    <message>
        <source>Mix each of them, with {0} at point 1 and {1} at point 2; then divide.</source>
        <translation>Помешајте свако од њих, са {0} у тачки 1 и {1} у тачки 2; затим поделите.</translation>
    </message>
    <message>
        <source>Point 1 is nearer, so its value counts for more than its share of the way.</source>
        <translation>Тачка 1 је ближа, па њена вредност вреди више од њеног дела пута.</translation>
    </message>
    <message>
        <source>Practise: a depth on the way</source>
        <translation>Вежба: дубина успут</translation>
    </message>
    <message>
        <source>A thin rod, drawn in colour, begins at point 1 and ends at point 2.</source>
        <translation>Танак штап, нацртан у боји, почиње у тачки 1, а завршава се у тачки 2.</translation>
    </message>
    <message>
        <source>Point 1 is {0} deep, point 2 is {1} deep. How deep is the place that is seen at the share {2} of the way from 1 to 2 in the picture?</source>
        <translation>Тачка 1 је на дубини {0}, тачка 2 на дубини {1}. На којој је дубини место које се на слици види на делу {2} пута од 1 до 2?</translation>
    </message>
    <message>
        <source>This mixes the depth itself. In the picture {0} changes evenly, not {1}. Look from above at point 3, half-way in the picture: it is closer to point 1 than to point 2.</source>
        <translation>Овде се меша сама дубина. На слици се равномерно мења {0}, а не {1}. Погледајте одозго тачку 3, на пола пута на слици: ближа је тачки 1 него тачки 2.</translation>
    </message>
    <message>
        <source>The way begins at point 2</source>
        <translation>Пут почиње у тачки 2</translation>
    </message>
    <message>
        <source>This goes from point 2 to point 1: at {0} the place must be point 1. Look from above: point 1 is the nearer one.</source>
        <translation>Ово иде од тачке 2 до тачке 1: за {0} место мора бити тачка 1. Погледајте одозго: тачка 1 је ближа.</translation>
    </message>
    <message>
        <source>What changes evenly in the picture is {0}.</source>
        <translation>Оно што се на слици равномерно мења је {0}.</translation>
    </message>
    <message>
        <source>The place {0} of the way along the rod itself is deeper: {1}.</source>
        <translation>Место на делу {0} пута дуж самог штапа је дубље: {1}.</translation>
    </message>
    <message>
        <source>Practise: the middle of a rod</source>
        <translation>Вежба: средина штапа</translation>
    </message>
    <message>
        <source>Point 1 is {0} deep, point 2 is {1} deep. Mark where the picture shows the middle of the rod.</source>
        <translation>Тачка 1 је на дубини {0}, тачка 2 на дубини {1}. Обележите где слика показује средину штапа.</translation>
    </message>
    <message>
        <source>This is the middle of the picture of the rod. The far half of the rod is drawn shorter than the near half, so the middle of the rod is seen closer to point 2. Look from above at point 3, which you have marked: it is closer to point 1 than to point 2.</source>
        <translation>Ово је средина слике штапа. Даља половина штапа црта се краће од ближе, па се средина штапа види ближе тачки 2. Погледајте одозго тачку 3, коју сте обележили: ближа је тачки 1 него тачки 2.</translation>
    </message>
    <message>
        <source>The near half is the short one</source>
        <translation>Ближа половина је краћа</translation>
    </message>
    <message>
        <source>This is as far from point 1 as the middle is from point 2. The near half of the rod is drawn longer, so the middle is seen closer to point 2. Look from above: point 1 is the nearer one.</source>
        <translation>Ово је од тачке 1 далеко колико и средина од тачке 2. Ближа половина штапа црта се дуже, па се средина види ближе тачки 2. Погледајте одозго: тачка 1 је ближа.</translation>
    </message>
    <message>
        <source>At the middle of the rod, {0} is {1}. At which share {2} of the way in the picture is that?</source>
        <translation>У средини штапа {0} је {1}. На ком делу {2} пута на слици је то?</translation>
    </message>
    <message>
        <source>{0}, seen from point 1.</source>
        <translation>{0}, гледано из тачке 1.</translation>
    </message>
    <message>
        <source>It is seen at the share {0} of the way from point 1.</source>
        <translation>Види се на делу {0} пута од тачке 1.</translation>
    </message>
</context>
<context>
    <name>l19-planar-shadow</name>
    <message>
        <source>Where does the shadow fall?</source>
        <translation>Где пада сенка?</translation>
    </message>
    <message>
        <source>A lamp instead of the sun</source>
        <translation>Лампа уместо сунца</translation>
    </message>
    <message>
        <source>The sun is in the direction {0}. The corner {1} at the top of the F has its shadow at {2}.</source>
        <translation>Сунце је у смеру {0}. Теме {1} на врху слова F има сенку у {2}.</translation>
    </message>
    <message>
        <source>A lamp at the point {0} takes the place of the sun. At which {1} is the shadow of {2}?</source>
        <translation>Лампа у тачки {0} заузима место сунца. У ком {1} је сенка од {2}?</translation>
    </message>
    <message>
        <source>at 3, as before</source>
        <translation>у 3, као пре</translation>
    </message>
    <message>
        <source>This takes the three numbers for a direction that all rays share, as the sun&apos;s are. Of a lamp they are a place: its ray through {0} runs from that place, flatter than the sun&apos;s. Look at the ray: it begins at the lamp.</source>
        <translation>Овде се три броја узимају за смер заједнички свим зрацима, као код сунца. Код лампе су они место: њен зрак кроз {0} полази са тог места, положеније од сунчевог. Погледајте зрак: почиње код лампе.</translation>
    </message>
    <message>
        <source>at 6</source>
        <translation>у 6</translation>
    </message>
    <message>
        <source>at 1.5, below P</source>
        <translation>у 1.5, испод P</translation>
    </message>
    <message>
        <source>It would be there if the lamp were directly above {0}. This lamp is 4.5 to the left of {1}. Look at this lamp, which is directly above {2}.</source>
        <translation>Тамо би била када би лампа била тачно изнад {0}. Ова лампа је 4.5 лево од {1}. Погледајте ову лампу, која је тачно изнад {2}.</translation>
    </message>
    <message>
        <source>From the lamp to {0} the ray goes 4.5 to the right and 5 down; to the ground it is 10 down, so 9 to the right.</source>
        <translation>Од лампе до {0} зрак иде 4.5 удесно и 5 надоле; до тла је 10 надоле, дакле 9 удесно.</translation>
    </message>
    <message>
        <source>A projection from the light</source>
        <translation>Пројекција из светла</translation>
    </message>
    <message>
        <source>A shadow is a projection: the light {0} is its centre, and the ground is its picture plane. The ray from {1} through {2} meets {3} at</source>
        <translation>Сенка је пројекција: светло {0} је њен центар, а тло њена раван слике. Зрак из {1} кроз {2} сече {3} у</translation>
    </message>
    <message>
        <source>With {0} that is {1}, as the scene&apos;s numbers say. As a matrix it is {2} with the plane {3}, and the F is drawn once more under {4}, in one colour. For the sun {5} has {6} and the rays are parallel.</source>
        <translation>Са {0} то је {1}, као што кажу бројеви сцене. Као матрица то је {2} са равни {3}, и слово F се под {4} црта још једном, једном бојом. За сунце {5} има {6} и зраци су паралелни.</translation>
    </message>
    <message>
        <source>Put the shadow there</source>
        <translation>Ставите сенку тамо</translation>
    </message>
    <message>
        <source>Move the lamp until the shadow of {0} is at {1}. It must stay a lamp, and above {2}.</source>
        <translation>Померајте лампу док сенка од {0} не буде у {1}. Мора остати лампа, и изнад {2}.</translation>
    </message>
    <message>
        <source>Drag the lamp in the World pane, or type under Light L.</source>
        <translation>Превуците лампу у приказу „Свет”, или унесите бројеве под „Светло L”.</translation>
    </message>
    <message>
        <source>A higher lamp casts a shorter shadow. At {0} it must be 11.4 high.</source>
        <translation>Виша лампа баца краћу сенку. За {0} мора бити на висини 11.4.</translation>
    </message>
    <message>
        <source>Any lamp on a line from {0} through {1} will do.</source>
        <translation>Одговара свака лампа на правој од {0} кроз {1}.</translation>
    </message>
    <message>
        <source>By the formula</source>
        <translation>По формули</translation>
    </message>
    <message>
        <source>You see the shadow that the *sun* casts from the direction {0}. Where, in {1}, would the shadow of {2} be with a *lamp* at the point {3}?</source>
        <translation>Видите сенку коју баца *сунце* из смера {0}. Где би, у {1}, била сенка од {2} са *лампом* у тачки {3}?</translation>
    </message>
    <message>
        <source>This is the sun&apos;s shadow, the one that you see. The lamp&apos;s ray has another direction: from the lamp to {0} it goes 7.5 to the right and 3 down. Look at the ray: it begins at the lamp.</source>
        <translation>Ово је сунчева сенка, она коју видите. Зрак лампе има други смер: од лампе до {0} иде 7.5 удесно и 3 надоле. Погледајте зрак: почиње код лампе.</translation>
    </message>
    <message>
        <source>{0} is 7.5 to the right of {1} and 3 below it. How far down is the ground?</source>
        <translation>{0} је 7.5 десно од {1} и 3 испод ње. Колико је до тла?</translation>
    </message>
    <message>
        <source>The plane moves down to {0}, so {1}. What is the cell of the lamp&apos;s matrix in row 1, column 1, {2}?</source>
        <translation>Раван се спушта на {0}, па је {1}. Колико је поље матрице лампе у врсти 1, колони 1, {2}?</translation>
    </message>
    <message>
        <source>This is {0} of the sun, whose {1} is 0. A lamp has {2}, so the 2 of the plane counts too. Look at the lamp and the plane: the plane is 2 lower than before.</source>
        <translation>Ово је {0} сунца, чије је {1} једнако 0. Лампа има {2}, па се рачуна и 2 од равни. Погледајте лампу и раван: раван је за 2 нижа него пре.</translation>
    </message>
    <message>
        <source>{0} is the height of the lamp above the plane. For the sun, with {1}, the height of the plane would not matter.</source>
        <translation>{0} је висина лампе изнад равни. За сунце, са {1}, висина равни не би била важна.</translation>
    </message>
    <message>
        <source>Back to the lamp</source>
        <translation>Назад на лампу</translation>
    </message>
    <message>
        <source>The sun and the lamp had the same three numbers, so it was tempting to let the shadow stay. But the sun&apos;s numbers are a direction, the same for every point of the F. The lamp&apos;s numbers are a position, and the direction of a ray is {0}: the higher a point is, the flatter the ray and the longer its shadow. Change *Kind of light* and watch the top of the F, then its foot.</source>
        <translation>Сунце и лампа имали су иста три броја, па је било примамљиво да сенка остане где јесте. Али сунчеви бројеви су смер, исти за сваку тачку слова F. Бројеви лампе су положај, а смер зрака је {0}: што је тачка виша, то је зрак положенији, а сенка дужа. Промените *Врсту светла* и пратите врх слова F, па његову стопу.</translation>
    </message>
    <message>
        <source>Practise: a lamp&apos;s shadow</source>
        <translation>Вежба: сенка од лампе</translation>
    </message>
    <message>
        <source>A lamp {0} shines on {1}, the corner at the top right of the F. The ground is {2}.</source>
        <translation>Лампа {0} обасјава {1}, теме горе десно на слову F. Тло је {2}.</translation>
    </message>
    <message>
        <source>The lamp is at {0}, and {1} is at {2}. At which {3} is the shadow of {4}?</source>
        <translation>Лампа је у {0}, а {1} је у {2}. У ком {3} је сенка од {4}?</translation>
    </message>
    <message>
        <source>This takes the lamp&apos;s place for the sun&apos;s direction. The ray through {0} begins at the lamp: its direction is {1}. Look at the sun&apos;s ray through {2}: it has another direction.</source>
        <translation>Овде је место лампе узето за смер сунца. Зрак кроз {0} почиње код лампе: његов смер је {1}. Погледајте сунчев зрак кроз {2}: он има други смер.</translation>
    </message>
    <message>
        <source>The ray begins at P</source>
        <translation>Зрак почиње у P</translation>
    </message>
    <message>
        <source>This begins at {0}. The ray begins at the lamp and comes down by the whole height of the lamp, so begin at {1}. Look at the ray: it begins at the lamp.</source>
        <translation>Овде се почиње у {0}. Зрак почиње код лампе и спушта се за целу њену висину, па почните у {1}. Погледајте зрак: почиње код лампе.</translation>
    </message>
    <message>
        <source>From {0} to {1} the ray comes down by {2}. By how much from {3} to the ground?</source>
        <translation>Од {0} до {1} зрак се спушта за {2}. За колико од {3} до тла?</translation>
    </message>
    <message>
        <source>To the right it goes {0} from {1} to {2}, and in proportion farther to the ground.</source>
        <translation>Удесно иде {0} од {1} до {2}, и сразмерно даље до тла.</translation>
    </message>
    <message>
        <source>From {0} the ray goes on to the right by {1}, in the ratio of 5 to {2}.</source>
        <translation>Од {0} зрак иде даље удесно за {1}, у односу 5 према {2}.</translation>
    </message>
    <message>
        <source>Practise: a row of S</source>
        <translation>Вежба: врста матрице S</translation>
    </message>
    <message>
        <source>{0}, with the lamp {1} and the plane {2}.</source>
        <translation>{0}, са лампом {1} и равни {2}.</translation>
    </message>
    <message>
        <source>The lamp is at {0} and the plane is {1}. What is the first row of {2}?</source>
        <translation>Лампа је у {0}, а раван је {1}. Која је прва врста матрице {2}?</translation>
    </message>
    <message>
        <source>{0} holds for the sun, whose {1} is 0. A lamp has {2}, so {3}, its height above the plane. Look at the lamp and the plane: the plane is lower than {4}.</source>
        <translation>{0} важи за сунце, чије је {1} једнако 0. Лампа има {2}, па је {3}, њена висина изнад равни. Погледајте лампу и раван: раван је нижа од {4}.</translation>
    </message>
    <message>
        <source>This takes {0} for {1}. The first row of {2} is {3} times {4}. Look at {5} and {6}: {7} of the shadow depends on the height of {8}.</source>
        <translation>Овде је {0} узето за {1}. Прва врста матрице {2} је {3} пута {4}. Погледајте {5} и {6}: {7} сенке зависи од висине тачке {8}.</translation>
    </message>
    <message>
        <source>The plane ends in h</source>
        <translation>Раван се завршава са h</translation>
    </message>
    <message>
        <source>This takes {0}. The plane {1} has {2}, so its last number is {3}. Look at the lamp and the plane: the plane is lower than {4}, so the lamp is higher above it.</source>
        <translation>Овде се узима {0}. Раван {1} има {2}, па је њен последњи број {3}. Погледајте лампу и раван: раван је нижа од {4}, па је лампа више изнад ње.</translation>
    </message>
    <message>
        <source>First {0}, which stands only in the first cell of this row of {1}.</source>
        <translation>Прво {0}, што у овој врсти матрице {1} стоји само у првом пољу.</translation>
    </message>
    <message>
        <source>Then subtract {0} times {1}.</source>
        <translation>Затим одузмите {0} пута {1}.</translation>
    </message>
    <message>
        <source>The first cell is the lamp&apos;s height above the plane.</source>
        <translation>Прво поље је висина лампе изнад равни.</translation>
    </message>
    <message>
        <source>Practise: where on the ground?</source>
        <translation>Вежба: где на тлу?</translation>
    </message>
    <message>
        <source>You look down from above: {0} runs to the right, {1} runs down. The squares of the grid are 1 wide, the middle of the F is at {2}, {3}, and point 2 is at {4}.</source>
        <translation>Гледате надоле одозго: {0} иде удесно, {1} иде надоле. Квадрати решетке су широки 1, средина слова F је у {2}, {3}, а тачка 2 је у {4}.</translation>
    </message>
    <message>
        <source>You see the shadow of the sun in the direction {0}. Mark where the shadow of point 1, {1}, is with a *lamp* at the point {2}.</source>
        <translation>Видите сунчеву сенку у смеру {0}. Обележите где је сенка тачке 1, {1}, са *лампом* у тачки {2}.</translation>
    </message>
    <message>
        <source>This is the sun&apos;s shadow, the one that you see. The lamp&apos;s ray through {0} begins at {1}: its direction is {2}. Look from the side: every ray begins at the lamp.</source>
        <translation>Ово је сунчева сенка, она коју видите. Зрак лампе кроз {0} почиње у {1}: његов смер је {2}. Погледајте са стране: сваки зрак почиње код лампе.</translation>
    </message>
    <message>
        <source>From {0} to {1} the ray comes down by {2}, to the ground by {3}.</source>
        <translation>Од {0} до {1} зрак се спушта за {2}, до тла за {3}.</translation>
    </message>
    <message>
        <source>The shadow is at {0}.</source>
        <translation>Сенка је у {0}.</translation>
    </message>
    <message>
        <source>The shadow is at {0}, {1}.</source>
        <translation>Сенка је у {0}, {1}.</translation>
    </message>
</context>
<context>
    <name>l20-zoom-or-walk</name>
    <message>
        <source>Zoom or walk?</source>
        <translation>Зумирати или прићи?</translation>
    </message>
    <message>
        <source>Three times as far</source>
        <translation>Трипут даље</translation>
    </message>
    <message>
        <source>A wide lens, 29 mm, is close to a head. One unit is 10 cm, so the camera is 30 cm away. The two squares are equally large, one at the nearest part of the head and one at the farthest. In the picture the near one is 1.67 times as large as the far one.</source>
        <translation>Широкоугаони објектив, 29 mm, близу је главе. Једна јединица је 10 cm, па је камера на 30 cm. Два квадрата су једнако велика, један код најближег дела главе, други код најдаљег. На слици је ближи 1.67 пута већи од даљег.</translation>
    </message>
    <message>
        <source>The camera goes back to three times the distance and zooms until the head is as high in the picture as before. How do the two squares compare then?</source>
        <translation>Камера се враћа на трипут веће растојање и зумира док глава на слици не буде висока као пре. Како се тада односе два квадрата?</translation>
    </message>
    <message>
        <source>as before, 1.67 times: the head keeps its size</source>
        <translation>као пре, 1.67 пута: глава задржава величину</translation>
    </message>
    <message>
        <source>The zoom enlarges both squares by the same factor, so it does not change how they compare. Going back does: both are now 6 units deeper, and their depths are more alike. Look at the two squares in both pictures.</source>
        <translation>Зум увећава оба квадрата истим чиниоцем, па не мења њихов однос. Враћање га мења: оба су сада 6 јединица дубље, и дубине су им сличније. Погледајте два квадрата на обе слике.</translation>
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
        <translation>ближи је мање од 1.67 пута већи</translation>
    </message>
    <message>
        <source>the near one is more than 1.67 times as large</source>
        <translation>ближи је више од 1.67 пута већи</translation>
    </message>
    <message>
        <source>That happens when you go *nearer*: there the same difference in depth matters more. Look at the two squares from nearer by.</source>
        <translation>То бива када идете *ближе*: тамо иста разлика у дубини значи више. Погледајте два квадрата изближа.</translation>
    </message>
    <message>
        <source>21 cm</source>
        <translation>21 cm</translation>
    </message>
    <message>
        <source>It is 1.19 times now. Both depths have grown by the same 6 units, so their ratio is closer to 1.</source>
        <translation>Сада је 1.19 пута. Обе дубине порасле су за истих 6 јединица, па је њихов однос ближи 1.</translation>
    </message>
    <message>
        <source>Two photographs of one head</source>
        <translation>Две фотографије једне главе</translation>
    </message>
    <message>
        <source>The lecture photographs a cat at 29 mm from 30 cm, and at 105 mm. On the film a thing is {0} times its real size, so it keeps its size if</source>
        <translation>Предавање снима мачку објективом од 29 mm са 30 cm, и од 105 mm. На филму је предмет {0} пута своје стварне величине, па задржава величину ако је</translation>
    </message>
    <message>
        <source>From 360 cm it would be only 0.30 times as large and would have to be enlarged.</source>
        <translation>Са 360 cm био би велик само 0.30 пута толико и морао би да се увећа.</translation>
    </message>
    <message>
        <source>The squares are {0} cm apart. The near one is drawn {1} times as large as the far one, with its own distance {2}: from 30 cm {3} times, from 108.6 cm {4} times. This camera is at 108.6 cm; under *More numbers* its focal length is 105 mm.</source>
        <translation>Квадрати су на размаку {0} cm. Ближи се црта {1} пута већи од даљег, са сопственим растојањем {2}: са 30 cm {3} пута, са 108.6 cm {4} пута. Ова камера је на 108.6 cm; под *Још бројева* жижна даљина јој је 105 mm.</translation>
    </message>
    <message>
        <source>Walk, and keep the head</source>
        <translation>Идите, а задржите главу</translation>
    </message>
    <message>
        <source>Go to three times the distance from the target, and keep the head as high in the picture as it is, 551 px.</source>
        <translation>Идите на трипут веће растојање од циља, а глава на слици нека остане висока колико јесте, 551 px.</translation>
    </message>
    <message>
        <source>Sizes at the target are proportional to {0}.</source>
        <translation>Величине код циља су сразмерне са {0}.</translation>
    </message>
    <message>
        <source>The slider *Distance, relative to the preset* changes both at once; Distance and Field of view change one each.</source>
        <translation>Клизач *Растојање у односу на предложак* мења обоје одједном; „Растојање” и „Видно поље” мењају по једно.</translation>
    </message>
    <message>
        <source>The head has kept its height, but its nose has not kept its size.</source>
        <translation>Глава је задржала висину, али њен нос није задржао величину.</translation>
    </message>
    <message>
        <source>By the formula</source>
        <translation>По формули</translation>
    </message>
    <message>
        <source>A statue is photographed from 2 m with a 50-mm lens on film 36 mm wide. From how many metres is it as large with an 85-mm lens?</source>
        <translation>Статуа се снима са 2 m објективом од 50 mm на филм ширине 36 mm. Са колико метара је једнако велика са објективом од 85 mm?</translation>
    </message>
    <message>
        <source>The angle is the size</source>
        <translation>Угао је величина</translation>
    </message>
    <message>
        <source>This takes the angle of view for the size. On the film the statue&apos;s height is proportional to the focal length over the distance, to {0}; the angle is not proportional to {1}. Look at the two photographs: 105 mm are 3.62 times 29 mm, and from 3.62 times as far away the head is equally high.</source>
        <translation>Овде је видни угао узет за величину. На филму је висина статуе сразмерна жижној даљини подељеној растојањем, дакле са {0}; угао није сразмеран са {1}. Погледајте две фотографије: 105 mm је 3.62 пута 29 mm, и са 3.62 пута већег растојања глава је једнако висока.</translation>
    </message>
    <message>
        <source>The image on the film is as large as before. What happened to {0}?</source>
        <translation>Слика на филму је велика као пре. Шта је било са {0}?</translation>
    </message>
    <message>
        <source>Sizes are proportional to {0}, so {1} is proportional to {2}. The angles of view, 39.6° and 23.9°, are no measure of size.</source>
        <translation>Величине су сразмерне са {0}, па је {1} сразмерно са {2}. Видни углови, 39.6° и 23.9°, нису мера величине.</translation>
    </message>
    <message>
        <source>Another statue of the same height is 1 m behind the first. From 2 m the first looks 1.5 times as high as the second. How many times as high does it look from 5 m, with a zoom that keeps the size of the first?</source>
        <translation>Друга статуа исте висине је 1 m иза прве. Са 2 m прва изгледа 1.5 пута виша од друге. Колико пута виша изгледа са 5 m, са зумом који задржава величину прве?</translation>
    </message>
    <message>
        <source>This keeps the ratio that was seen from 2 m. The zoom enlarges both statues alike; only their distances, 5 m and 6 m, decide how they compare. Look at the two squares in both pictures: they compare differently.</source>
        <translation>Ово задржава однос виђен са 2 m. Зум обе статуе увећава једнако; о њиховом односу одлучују само растојања, 5 m и 6 m. Погледајте два квадрата на обе слике: односе се друкчије.</translation>
    </message>
    <message>
        <source>The size of each statue is proportional to one over its own distance.</source>
        <translation>Величина сваке статуе сразмерна је реципрочној вредности њеног растојања.</translation>
    </message>
    <message>
        <source>{0} with the new {1}. The zoom enlarges both by the same factor.</source>
        <translation>{0} са новим {1}. Зум обе увећава истим чиниоцем.</translation>
    </message>
    <message>
        <source>Back to the head</source>
        <translation>Назад на главу</translation>
    </message>
    <message>
        <source>It is tempting to say that nothing changes, because the head keeps its size, and a zoom is made for this. But the zoom keeps sizes at only one depth, the target&apos;s. In front of it and behind it, sizes are proportional to one over *their* distance, and walking has changed that. So a portrait from close by has a large nose with any lens: the distance determines the perspective; the lens only selects a part of it.</source>
        <translation>Примамљиво је рећи да се ништа не мења, јер глава задржава величину, а зум за то и служи. Али зум задржава величине само на једној дубини, на дубини циља. Испред њега и иза њега величине су сразмерне реципрочној вредности *свог* растојања, а њега је ходање променило. Зато портрет изблиза има велик нос са било којим објективом: растојање одређује перспективу; објектив само бира њен део.</translation>
    </message>
    <message>
        <source>Practise: as large with another lens</source>
        <translation>Вежба: једнако велико другим објективом</translation>
    </message>
    <message>
        <source>The head is photographed from {0} cm with a lens of {1} mm, on film 36 mm wide. From how many cm is it as large with {2} mm?</source>
        <translation>Глава се снима са {0} cm објективом од {1} mm, на филм ширине 36 mm. Са колико cm је једнако велика са {2} mm?</translation>
    </message>
    <message>
        <source>This takes the angle of view for the size. On the film the head is {0} times as large as it is; the angle of view is no measure of that. Look at the head from here with {1} mm: it is {2} times as large.</source>
        <translation>Овде је видни угао узет за величину. На филму је глава {0} пута своје величине; видни угао томе није мера. Погледајте главу одавде са {1} mm: велика је {2} пута толико.</translation>
    </message>
    <message>
        <source>A longer lens goes nearer</source>
        <translation>Дужи објектив иде ближе</translation>
    </message>
    <message>
        <source>From there the head would be larger still. A longer lens enlarges, so the camera must go back. Look at the head from here with {0} mm: it is larger already.</source>
        <translation>Одатле би глава била још већа. Дужи објектив увећава, па камера мора назад. Погледајте главу одавде са {0} mm: већ је већа.</translation>
    </message>
    <message>
        <source>On the film, the head is {0} times as large as it is.</source>
        <translation>На филму је глава {0} пута своје величине.</translation>
    </message>
    <message>
        <source>{0} must be equal to {1}: a longer lens needs a distance longer by the same factor.</source>
        <translation>{0} мора бити једнако {1}: дужем објективу треба растојање веће истим чиниоцем.</translation>
    </message>
    <message>
        <source>Practise: two squares</source>
        <translation>Вежба: два квадрата</translation>
    </message>
    <message>
        <source>The near square is {0} from the eye; the far one is as large and {1} behind it. So the near one is drawn {2} times as large. How many times as large is it drawn from {3}, with a zoom that keeps its size?</source>
        <translation>Ближи квадрат је {0} од камере; даљи је једнако велик и {1} иза њега. Зато се ближи црта {2} пута већи. Колико пута већи се црта са {3}, са зумом који му задржава величину?</translation>
    </message>
    <message>
        <source>This keeps the ratio that is seen from {0}. The zoom enlarges both squares alike; only their distances decide how they compare. Look from the side: the camera is now {1} from the near square.</source>
        <translation>Ово задржава однос који се види са {0}. Зум оба квадрата увећава једнако; о њиховом односу одлучују само растојања. Погледајте са стране: камера је сада {1} од ближег квадрата.</translation>
    </message>
    <message>
        <source>The zoom makes them equal</source>
        <translation>Зум их изједначава</translation>
    </message>
    <message>
        <source>They would look equal only from infinitely far away. The far one is always 1.2 farther away. Look from the side: the far one is still farther away.</source>
        <translation>Једнаки би изгледали само са бесконачне удаљености. Даљи је увек 1.2 даље. Погледајте са стране: даљи је и сада даље.</translation>
    </message>
    <message>
        <source>Each square is drawn as large as one over its own distance.</source>
        <translation>Сваки квадрат се црта велик као реципрочна вредност свог растојања.</translation>
    </message>
    <message>
        <source>The near one is now {0} away. And the far one?</source>
        <translation>Ближи је сада на {0}. А даљи?</translation>
    </message>
    <message>
        <source>The zoom enlarges both by the same factor, so only the distances count.</source>
        <translation>Зум оба увећава истим чиниоцем, па се рачунају само растојања.</translation>
    </message>
    <message>
        <source>Practise: a chosen ratio</source>
        <translation>Вежба: изабрани однос</translation>
    </message>
    <message>
        <source>The near square is 0.64 in front of the target, the far square, as large, is 0.56 behind it.</source>
        <translation>Ближи квадрат је 0.64 испред циља, а даљи, једнако велик, 0.56 иза њега.</translation>
    </message>
    <message>
        <source>Move the camera until the near square is drawn {0} times as large as the far one, and keep the head as high in the picture as it is now.</source>
        <translation>Померајте камеру док се ближи квадрат не црта {0} пута већи од даљег, а глава на слици нека остане висока као сада.</translation>
    </message>
    <message>
        <source>From the near square to the far one it is {0}. At the distance {1} of the near square, the ratio is {2}.</source>
        <translation>Од ближег квадрата до даљег је {0}. На растојању {1} ближег квадрата однос је {2}.</translation>
    </message>
    <message>
        <source>So the near square must be at {0}, and the target 0.64 farther away.</source>
        <translation>Дакле ближи квадрат мора бити на {0}, а циљ 0.64 даље.</translation>
    </message>
    <message>
        <source>The slider *Distance, relative to the preset* keeps the size of the head.</source>
        <translation>Клизач *Растојање у односу на предложак* задржава величину главе.</translation>
    </message>
    <message>
        <source>{0} {1} {2} for the near square. The target is 0.64 farther: {3}.</source>
        <translation>{0} {1} {2} за ближи квадрат. Циљ је 0.64 даље: {3}.</translation>
    </message>
    <message>
        <source>A zoom enlarges both squares alike; only the distance changes how they compare. Look at both pictures: the squares compare in the same way.</source>
        <translation>Зум оба квадрата увећава једнако; њихов однос мења само растојање. Погледајте обе слике: квадрати се односе на исти начин.</translation>
    </message>
    <message>
        <source>from here, 90°</source>
        <translation>одавде, 90°</translation>
    </message>
</context>
<context>
    <name>l21-camera-obscura</name>
    <message>
        <source>Why upside down?</source>
        <translation>Зашто наопачке?</translation>
    </message>
    <message>
        <source>Behind the eye</source>
        <translation>Иза камере</translation>
    </message>
    <message>
        <source>The plane of projection is 4 units in front of the eye. The corner {0}, at the top of the F, is 2.472 above the axis and 9.601 deep; its image is 1.03 above the axis. The World pane shows it from the side.</source>
        <translation>Раван пројектовања је 4 јединице испред камере. Теме {0}, на врху слова F, је 2.472 изнад осе и на дубини 9.601; његова слика је 1.03 изнад осе. Приказ „Свет” показује то са стране.</translation>
    </message>
    <message>
        <source>The plane moves to the other side, 4 units *behind* the eye, like the film in a camera obscura. Where is the image of {0} on it, along {1}?</source>
        <translation>Раван прелази на другу страну, 4 јединице *иза* камере, као филм у камери опскури. Где је на њој слика од {0}, дуж {1}?</translation>
    </message>
    <message>
        <source>at 1.03: still above the axis</source>
        <translation>у 1.03: и даље изнад осе</translation>
    </message>
    <message>
        <source>The film keeps up what is up</source>
        <translation>Филм задржава горе оно што је горе</translation>
    </message>
    <message>
        <source>This keeps the sign of a plane in front. Light goes straight through the eye, so what is above the axis in front of it is below the axis behind it. Look at P&apos;, behind the eye: it is below the axis.</source>
        <translation>Ово задржава предзнак равни испред. Светлост иде право кроз позицију камере, па је оно што је испред ње изнад осе иза ње испод осе. Погледајте P&apos;, иза камере: она је испод осе.</translation>
    </message>
    <message>
        <source>at −1.03: below the axis</source>
        <translation>у −1.03: испод осе</translation>
    </message>
    <message>
        <source>there is none: light does not go backwards</source>
        <translation>нема је: светлост не иде уназад</translation>
    </message>
    <message>
        <source>It goes straight on through the eye and meets the plane behind it. Look at the projector: it goes through the eye to P&apos;.</source>
        <translation>Она иде право даље кроз позицију камере и сече раван иза ње. Погледајте зрак пројекције: иде кроз позицију камере до P&apos;.</translation>
    </message>
    <message>
        <source>The projector goes on through the eye, and crosses the axis there.</source>
        <translation>Зрак пројекције иде даље кроз позицију камере, и ту прелази преко осе.</translation>
    </message>
    <message>
        <source>Two films</source>
        <translation>Два филма</translation>
    </message>
    <message>
        <source>In the dark box, light goes through a hole, the centre of projection. The image of a thing of height {0} at the distance {1} in front of the hole has the height</source>
        <translation>У мрачној кутији светлост пролази кроз рупу, центар пројекције. Слика предмета висине {0} на растојању {1} испред рупе има висину</translation>
    </message>
    <message>
        <source>on the film, {0} behind the hole. Here {1}, {2} and {3}: {4}. The minus turns the image upside down and exchanges left and right. The lecture&apos;s synthetic camera has its film at the same distance in front of the centre. There the image is {5} high: as large, and upright.</source>
        <translation>на филму, {0} иза рупе. Овде је {1}, {2} и {3}: {4}. Минус окреће слику наопачке и замењује лево и десно. Синтетичка камера из предавања има филм на истом растојању испред центра. Тамо је слика висока {5}: једнако велика, и усправна.</translation>
    </message>
    <message>
        <source>A quarter, upside down</source>
        <translation>Четвртина, наопачке</translation>
    </message>
    <message>
        <source>Put the plane behind the eye so that the image of {0} is upside down and a quarter as far from the axis as {1} itself.</source>
        <translation>Ставите раван иза камере тако да слика од {0} буде наопачке и од осе четири пута ближа него само {1}.</translation>
    </message>
    <message>
        <source>The scale is {0}, and {1} is the depth of {2}.</source>
        <translation>Размера је {0}, а {1} је дубина од {2}.</translation>
    </message>
    <message>
        <source>Type a negative Plane distance d. A quarter of 9.601 is 2.4.</source>
        <translation>Унесите негативно „Растојање равни d”. Четвртина од 9.601 је 2.4.</translation>
    </message>
    <message>
        <source>The scale is −0.25: a quarter as large, and turned over by the minus.</source>
        <translation>Размера је −0.25: четвртина величине, а минус преокреће.</translation>
    </message>
    <message>
        <source>By the formula</source>
        <translation>По формули</translation>
    </message>
    <message>
        <source>The arrow is 5 high and 9 in front of the hole. The film moves to 6 behind the hole. How high is the arrow&apos;s image on the film, with its sign?</source>
        <translation>Стрелица је висока 5 и 9 испред рупе. Филм се помера на 6 иза рупе. Колико је висока слика стрелице на филму, са предзнаком?</translation>
    </message>
    <message>
        <source>This is the image on a film in front of the hole. Behind the hole the light has crossed the axis, so the sign changes. Look at both films: only the one in front has the arrow upright.</source>
        <translation>Ово је слика на филму испред рупе. Иза рупе је светлост прешла преко осе, па се предзнак мења. Погледајте оба филма: само је на ономе испред стрелица усправна.</translation>
    </message>
    <message>
        <source>This measures the arrow&apos;s distance from the film, {0}. The two triangles meet at the hole: measure both distances from there. Look at the hole: both triangles begin there.</source>
        <translation>Овде се растојање стрелице мери од филма, {0}. Два троугла се сусрећу код рупе: оба растојања мерите одатле. Погледајте рупу: ту почињу оба троугла.</translation>
    </message>
    <message>
        <source>Measure both lengths from the hole: {0}.</source>
        <translation>Обе дужине мерите од рупе: {0}.</translation>
    </message>
    <message>
        <source>The triangles share the corner at the hole.</source>
        <translation>Троуглови деле теме код рупе.</translation>
    </message>
    <message>
        <source>How far behind the hole must the film be for the image to be a third as high as the arrow?</source>
        <translation>Колико иза рупе мора бити филм да би слика била трипут нижа од стрелице?</translation>
    </message>
    <message>
        <source>This measures the arrow&apos;s distance from the film, which is 9 and the film&apos;s own distance. The two triangles meet at the hole: measure both distances from there. Look at the film 4.5 behind the hole: the image is half as high as the arrow.</source>
        <translation>Овде се растојање стрелице мери од филма, што је 9 и растојање самог филма. Два троугла се сусрећу код рупе: оба растојања мерите одатле. Погледајте филм 4.5 иза рупе: слика је упола нижа од стрелице.</translation>
    </message>
    <message>
        <source>{0}. If you measure {1} from the film, you get {2}.</source>
        <translation>{0}. Ако {1} мерите од филма, добијате {2}.</translation>
    </message>
    <message>
        <source>Back to the film</source>
        <translation>Назад на филм</translation>
    </message>
    <message>
        <source>It was tempting to keep the sign, because the triangles are the same. But the projector goes through the eye and crosses the axis there: what was above is now below. Our cameras put the plane in front, where nothing is turned over. A real camera has its film behind and turns the picture round afterwards; the numbers differ by the sign only.</source>
        <translation>Било је примамљиво задржати предзнак, јер су троуглови исти. Али зрак пројекције иде кроз позицију камере и ту прелази преко осе: што је било горе, сада је доле. Наше камере стављају раван испред, где се ништа не преокреће. Права камера има филм иза и слику накнадно окрене; бројеви се разликују само по предзнаку.</translation>
    </message>
    <message>
        <source>Practise: height on the film</source>
        <translation>Вежба: висина на филму</translation>
    </message>
    <message>
        <source>An arrow, {0} high, stands before the hole of a dark box.</source>
        <translation>Стрелица, висока {0}, стоји пред рупом мрачне кутије.</translation>
    </message>
    <message>
        <source>The arrow is {0} in front of the hole, the film {1} behind it. How high is the arrow&apos;s image on the film, with its sign?</source>
        <translation>Стрелица је {0} испред рупе, а филм {1} иза ње. Колико је висока слика стрелице на филму, са предзнаком?</translation>
    </message>
    <message>
        <source>What stands upright in front of the hole stands on its head behind it.</source>
        <translation>Што испред рупе стоји усправно, иза ње стоји на глави.</translation>
    </message>
    <message>
        <source>The image is {0} times as high as the arrow, and upside down.</source>
        <translation>Слика је {0} пута висине стрелице, и наопачке.</translation>
    </message>
    <message>
        <source>Practise: a corner on the film</source>
        <translation>Вежба: теме на филму</translation>
    </message>
    <message>
        <source>The picture shows the plane 4 in front of the eye. A film stands behind the eye; lay it over the picture, its middle on the middle, without turning it: right stays right, up stays up.</source>
        <translation>Слика показује раван 4 испред камере. Филм стоји иза камере; положите га преко слике, средину на средину, без окретања: десно остаје десно, горе остаје горе.</translation>
    </message>
    <message>
        <source>The film is {0} behind the eye, and drawn to the same scale. Mark where, on it, the image of point 1 lies.</source>
        <translation>Филм је {0} иза камере, и нацртан у истој размери. Обележите где на њему лежи слика тачке 1.</translation>
    </message>
    <message>
        <source>This is where the image lies on a plane {0} in front of the eye. Behind the eye the light has crossed the axis, so both coordinates change their signs. Look at both films of this dark box: behind the hole the image is upside down.</source>
        <translation>Ту слика лежи на равни {0} испред камере. Иза камере је светлост прешла преко осе, па обе координате мењају предзнак. Погледајте оба филма ове мрачне кутије: иза рупе је слика наопачке.</translation>
    </message>
    <message>
        <source>Only up and down change</source>
        <translation>Мењају се само горе и доле</translation>
    </message>
    <message>
        <source>This turns the image upside down only. The light crosses the axis, so left and right are exchanged as well. Look from above at a film behind the eye: what is on the right comes to the left.</source>
        <translation>Ово само окреће слику наопачке. Светлост прелази преко осе, па се замењују и лево и десно. Погледајте одозго филм иза камере: што је десно, долази лево.</translation>
    </message>
    <message>
        <source>The axis goes through the middle of the picture. On the film everything is on the other side of it.</source>
        <translation>Оса пролази кроз средину слике. На филму је све са друге њене стране.</translation>
    </message>
    <message>
        <source>The scale is {0} of the one that you see.</source>
        <translation>Размера је {0} оне коју видите.</translation>
    </message>
    <message>
        <source>On the other side of the middle, and {0} times as far from it.</source>
        <translation>Са друге стране средине, и {0} пута толико далеко од ње.</translation>
    </message>
    <message>
        <source>Practise: the film for a size</source>
        <translation>Вежба: филм за величину</translation>
    </message>
    <message>
        <source>{0} is {1} deep. Put the plane behind the eye so that the image of {2} is upside down and {3} times as far from the axis as {4}.</source>
        <translation>{0} је на дубини {1}. Ставите раван иза камере тако да слика од {2} буде наопачке и од осе {3} пута толико далеко колико {4}.</translation>
    </message>
    <message>
        <source>The image is {0} times as far from the axis as {1}. Measure both from the eye.</source>
        <translation>Слика је од осе {0} пута толико далеко колико {1}. Обоје мерите од камере.</translation>
    </message>
    <message>
        <source>Behind the eye {0} is negative: type it under Plane distance d.</source>
        <translation>Иза камере је {0} негативно: унесите га под „Растојање равни d”.</translation>
    </message>
    <message>
        <source>{0}, with {1}</source>
        <translation>{0}, са {1}</translation>
    </message>
    <message>
        <source>In front of the eye the image is upright. Look at P&apos;: it is above the axis. The plane must be behind the eye, at a negative {0}.</source>
        <translation>Испред камере слика је усправна. Погледајте P&apos;: она је изнад осе. Раван мора бити иза камере, на негативном {0}.</translation>
    </message>
    <message>
        <source>This measures the depth of {0} from the plane. Both triangles begin at the eye. Look at P&apos;: it is less than {1} times as far from the axis as {2}.</source>
        <translation>Овде се дубина од {0} мери од равни. Оба троугла почињу код камере. Погледајте P&apos;: од осе је мање од {1} пута толико далеко колико {2}.</translation>
    </message>
</context>
<context>
    <name>l22-walk-round-the-f</name>
    <message>
        <source>What stays when the camera rises?</source>
        <translation>Шта остаје када се камера подигне?</translation>
    </message>
    <message>
        <source>A camera that rises, level</source>
        <translation>Камера која се подиже, водоравно</translation>
    </message>
    <message>
        <source>The letter F of eight cubes stands on its grid. The camera looks level: its eye is as high as its target. The uprights of the F are parallel in the picture.</source>
        <translation>Слово F од осам коцки стоји на својој решетки. Камера гледа водоравно: висока је колико и њен циљ. Усправне ивице слова F на слици су паралелне.</translation>
    </message>
    <message>
        <source>The camera rises to 5.5, above the F, and keeps looking level. What do the uprights do in the picture?</source>
        <translation>Камера се подиже на 5.5, изнад слова F, и даље гледа водоравно. Шта на слици раде усправне ивице?</translation>
    </message>
    <message>
        <source>they lean together downwards: the camera is above them</source>
        <translation>нагињу се једна другој надоле: камера је изнад њих</translation>
    </message>
    <message>
        <source>From above, uprights lean</source>
        <translation>Одозго се усправне ивице нагињу</translation>
    </message>
    <message>
        <source>Standing high does not make uprights meet; looking down does. This camera looks level, so the uprights are parallel to the picture and have no vanishing point. Look at both pictures from this height: only where the camera looks down do the uprights lean.</source>
        <translation>Усправне ивице се не секу зато што се стоји високо, него зато што се гледа надоле. Ова камера гледа водоравно, па су усправне ивице паралелне слици и немају тачку недогледа. Погледајте обе слике са ове висине: усправне ивице се нагињу само тамо где камера гледа надоле.</translation>
    </message>
    <message>
        <source>level</source>
        <translation>водоравно</translation>
    </message>
    <message>
        <source>looking down</source>
        <translation>гледа надоле</translation>
    </message>
    <message>
        <source>they stay parallel</source>
        <translation>остају паралелне</translation>
    </message>
    <message>
        <source>they lean together upwards</source>
        <translation>нагињу се једна другој нагоре</translation>
    </message>
    <message>
        <source>That happens when the camera looks *up*, whatever its height. Look at the F from below: its uprights lean together upwards.</source>
        <translation>То бива када камера гледа *нагоре*, ма колика била њена висина. Погледајте слово F одоздо: његове усправне ивице нагињу се једна другој нагоре.</translation>
    </message>
    <message>
        <source>Only the direction of view decides whether uprights meet. It is still level, so {0} has no component along them.</source>
        <translation>О томе да ли се усправне ивице секу одлучује само смер погледа. Он је и даље водораван, па {0} нема компоненту дуж њих.</translation>
    </message>
    <message>
        <source>Looking at the target</source>
        <translation>Са погледом у циљ</translation>
    </message>
    <message>
        <source>Now the target stays at 2 and the camera looks down. With {0} of length 10,</source>
        <translation>Сада циљ остаје на 2, а камера гледа надоле. Са {0} дужине 10,</translation>
    </message>
    <message>
        <source>{0} is also the cell in row 2, column 2 of the view matrix. The uprights are no longer at a right angle to {1}, because {2}, so they have a vanishing point, far below.</source>
        <translation>{0} је и поље у врсти 2, колони 2 матрице погледа. Усправне ивице више нису под правим углом према {1}, јер је {2}, па имају тачку недогледа, далеко доле.</translation>
    </message>
    <message>
        <source>Level again</source>
        <translation>Поново водоравно</translation>
    </message>
    <message>
        <source>Points 1 and 2 mark the foot and the top of the F.</source>
        <translation>Тачке 1 и 2 обележавају стопу и врх слова F.</translation>
    </message>
    <message>
        <source>Make the camera look level, with its eye as high as its target and the whole F in the picture.</source>
        <translation>Нека камера гледа водоравно, висока колико и њен циљ, са целим словом F на слици.</translation>
    </message>
    <message>
        <source>Which angle in the dock says how steeply the camera looks down?</source>
        <translation>Који угао у бочном панелу каже колико стрмо камера гледа надоле?</translation>
    </message>
    <message>
        <source>Elevation 0 is level.</source>
        <translation>Елевација 0 је водоравно.</translation>
    </message>
    <message>
        <source>The uprights are parallel again, whatever the azimuth.</source>
        <translation>Усправне ивице су поново паралелне, ма какав био азимут.</translation>
    </message>
    <message>
        <source>By the formula</source>
        <translation>По формули</translation>
    </message>
    <message>
        <source>The eye is at {0}, the target at {1}, and up is {2}. What is {3}, the cell in row 2, column 2 of the view matrix?</source>
        <translation>Позиција камере је {0}, циљ је у {1}, а вектор нагоре је {2}. Колико је {3}, поље у врсти 2, колони 2 матрице погледа?</translation>
    </message>
    <message>
        <source>This takes up itself for {0}. Up only has to point roughly upwards; {1} is at a right angle to the direction of view, so the more the camera looks down, the smaller {2} is. Look at up and {3}: they are not parallel.</source>
        <translation>Овде је сам вектор нагоре узет за {0}. Он треба само приближно да показује нагоре; {1} је под правим углом према смеру погледа, па је {2} тим мање што камера више гледа надоле. Погледајте вектор нагоре и {3}: нису паралелни.</translation>
    </message>
    <message>
        <source>This leaves the first product, of up and {0}, as it is, only 0.6 long. Make it 1 long before the second product. Look at up and {1}: they are not at a right angle.</source>
        <translation>Овде је први производ, вектора нагоре и {0}, остављен какав јесте, дугачак само 0.6. Сведите га на дужину 1 пре другог производа. Погледајте вектор нагоре и {1}: нису под правим углом.</translation>
    </message>
    <message>
        <source>{0}, so {1}.</source>
        <translation>{0}, па је {1}.</translation>
    </message>
    <message>
        <source>{0} is 10 long.</source>
        <translation>{0} је дужине 10.</translation>
    </message>
    <message>
        <source>{0} is 0.6 long and must be made 1 long.</source>
        <translation>{0} је дужине 0.6 и мора се свести на дужину 1.</translation>
    </message>
    <message>
        <source>How far away?</source>
        <translation>Колико далеко?</translation>
    </message>
    <message>
        <source>The camera looks level from a height of 2.5, with a field of view of 60°. The top of the F is at 5. At which depth does it appear at {0}, half-way up to the edge?</source>
        <translation>Камера гледа водоравно са висине 2.5, са видним пољем од 60°. Врх слова F је на 5. На којој дубини се он појављује у {0}, на пола пута до горње ивице?</translation>
    </message>
    <message>
        <source>This takes the tangent of the whole 60°. The right-angled triangle lies between the axis and the upper edge of the picture and has half of the angle. Look at 90°: half the picture is as high as it is deep, {0}.</source>
        <translation>Овде је узет тангенс целих 60°. Правоугли троугао лежи између осе и горње ивице слике и има половину угла. Погледајте 90°: половина слике је висока колико је и дубина, {0}.</translation>
    </message>
    <message>
        <source>This multiplies by near, which is 2. The image on the near plane does grow with near, but so does the window round it; near only decides what is cut. Look at both pictures: they are the same.</source>
        <translation>Овде се множи предњом равни, која је 2. Слика на предњој равни заиста расте са њом, али расте и прозор око ње; предња раван одлучује само о томе шта се одсеца. Погледајте обе слике: исте су.</translation>
    </message>
    <message>
        <source>near 1</source>
        <translation>предња раван 1</translation>
    </message>
    <message>
        <source>near 2</source>
        <translation>предња раван 2</translation>
    </message>
    <message>
        <source>At the depth {0} half of the picture is {1} high.</source>
        <translation>На дубини {0} половина слике је висока {1}.</translation>
    </message>
    <message>
        <source>Back to the rising camera</source>
        <translation>Назад на камеру која се подиже</translation>
    </message>
    <message>
        <source>From above you usually *look down*, and houses lean in photographs from towers, so it was tempting to let the uprights lean. But looking down makes them lean, not the height. If a camera rises and looks level, the F moves in the picture but its uprights stay parallel. If a camera turns down to its target, {0} and the uprights meet. Press play in the tool bar: the section Animation has both ways of looking.</source>
        <translation>Одозго обично *гледате надоле*, и куће се на фотографијама са торњева нагињу, па је било примамљиво пустити да се усправне ивице нагну. Али нагиње их поглед надоле, а не висина. Ако се камера подигне и гледа водоравно, слово F се на слици помери, али његове усправне ивице остају паралелне. Ако се камера окрене надоле ка свом циљу, {0} и усправне ивице се секу. Притисните „Пусти” на траци са алаткама: одељак „Анимација” има оба начина гледања.</translation>
    </message>
    <message>
        <source>Practise: the vector v</source>
        <translation>Вежба: вектор v</translation>
    </message>
    <message>
        <source>The eye is at {0}, the target at {1}, up is {2}, so {3}. What is the camera&apos;s {4}, the second row of the view matrix without its last number?</source>
        <translation>Позиција камере је {0}, циљ је у {1}, вектор нагоре је {2}, па је {3}. Колико је {4} камере, друга врста матрице погледа без последњег броја?</translation>
    </message>
    <message>
        <source>Up only has to point roughly upwards. {0} is at a right angle to the direction of view, so it tilts when the camera looks down. Look at up and {1}: they are not parallel.</source>
        <translation>Вектор нагоре треба само приближно да показује нагоре. {0} је под правим углом према смеру погледа, па се нагиње када камера гледа надоле. Погледајте вектор нагоре и {1}: нису паралелни.</translation>
    </message>
    <message>
        <source>This uses {0}, which is shorter than 1, in place of {1}. Make it 1 long before the second product. Look at up and {2}: they are not at a right angle.</source>
        <translation>Овде је употребљено {0}, што је краће од 1, уместо {1}. Сведите га на дужину 1 пре другог производа. Погледајте вектор нагоре и {2}: нису под правим углом.</translation>
    </message>
    <message>
        <source>{0}, then {1} along {2}, made 1 long; {3} is up.</source>
        <translation>{0}, затим {1} дуж {2}, сведено на дужину 1; {3} је вектор нагоре.</translation>
    </message>
    <message>
        <source>{0}, and {1}.</source>
        <translation>{0}, и {1}.</translation>
    </message>
    <message>
        <source>The middle number is the cosine of the angle by which the camera looks down.</source>
        <translation>Средњи број је косинус угла под којим камера гледа надоле.</translation>
    </message>
    <message>
        <source>Practise: the least depth</source>
        <translation>Вежба: најмања дубина</translation>
    </message>
    <message>
        <source>You look down on a camera that looks level. From above, the F is a bar with four corners.</source>
        <translation>Одозго гледате на камеру која гледа водоравно. Одозго је слово F правоугаоник са четири темена.</translation>
    </message>
    <message>
        <source>Mark the corner of the F that is least deep for this camera.</source>
        <translation>Обележите теме слова F које је за ову камеру на најмањој дубини.</translation>
    </message>
    <message>
        <source>This corner is nearest to the eye. Depth is measured along the direction of view only, from the line through the eye that is parallel to near. Look from above at near, moved out: it meets another corner first.</source>
        <translation>Ово теме је најближе камери. Дубина се мери само дуж смера погледа, од праве кроз позицију камере паралелне предњој равни. Погледајте одозго одмакнуту предњу раван: прво наилази на друго теме.</translation>
    </message>
    <message>
        <source>Depth is measured along the direction of view, not straight to the point.</source>
        <translation>Дубина се мери дуж смера погледа, а не право до тачке.</translation>
    </message>
    <message>
        <source>Move a line that is parallel to near away from the eye. Which corner does it meet first?</source>
        <translation>Померајте праву паралелну предњој равни од камере. На које теме прво наилази?</translation>
    </message>
    <message>
        <source>A line parallel to near, moved away from the eye, meets this corner first.</source>
        <translation>Права паралелна предњој равни, померана од камере, прво наилази на ово теме.</translation>
    </message>
    <message>
        <source>Practise: level, at a height in the picture</source>
        <translation>Вежба: водоравно, на висини на слици</translation>
    </message>
    <message>
        <source>Point 1, on the top of the F, is at height 5, right above the target.</source>
        <translation>Тачка 1, на врху слова F, на висини је 5, тачно изнад циља.</translation>
    </message>
    <message>
        <source>The camera looks level from a height of 2.5, with a field of view of {0}°. Go nearer or back until point 1 appears at {1}.</source>
        <translation>Камера гледа водоравно са висине 2.5, са видним пољем од {0}°. Идите ближе или назад док се тачка 1 не појави у {1}.</translation>
    </message>
    <message>
        <source>At the distance {0}, half of the picture is {1} high.</source>
        <translation>На растојању {0} половина слике је висока {1}.</translation>
    </message>
    <message>
        <source>Near does not count, and half of the angle does: {0}.</source>
        <translation>Предња раван се не рачуна, а половина угла да: {0}.</translation>
    </message>
    <message>
        <source>The triangle of eye, axis and edge has half of the angle at the eye. Look at 90°: half the picture is as high as it is deep, {0}.</source>
        <translation>Троугао који чине камера, оса и ивица има код камере половину угла. Погледајте 90°: половина слике је висока колико је и дубина, {0}.</translation>
    </message>
    <message>
        <source>The image on the near plane grows with near, and so does the window round it. Look at both pictures: they are the same.</source>
        <translation>Слика на предњој равни расте са њом, а расте и прозор око ње. Погледајте обе слике: исте су.</translation>
    </message>
</context>
<context>
    <name>l23-popping</name>
    <message>
        <source>Why does it pop?</source>
        <translation>Зашто искаче?</translation>
    </message>
    <message>
        <source>A tree at the side</source>
        <translation>Дрво са стране</translation>
    </message>
    <message>
        <source>The camera stands beside an avenue and looks along it. Far is 30. Point 1, on the axis of a tree that is not drawn yet, is 38 ahead and 15 to the right.</source>
        <translation>Камера стоји поред алеје и гледа дуж ње. Задња раван је на 30. Тачка 1, на оси дрвета које још није нацртано, је 38 испред и 15 удесно.</translation>
    </message>
    <message>
        <source>Far moves out to 40. Is the trunk of that tree drawn then?</source>
        <translation>Задња раван се одмиче на 40. Да ли се тада црта стабло тог дрвета?</translation>
    </message>
    <message>
        <source>No: it is 40.85 away from the eye</source>
        <translation>Не: од камере је на 40.85</translation>
    </message>
    <message>
        <source>This measures straight from the eye to the tree, as if far were a sphere. Far is a plane across the direction of view: only the 38 ahead count. Look from above: point 1 lies before far.</source>
        <translation>Овде се мери право од камере до дрвета, као да је задња раван сфера. Задња раван је раван попреко на смер погледа: рачуна се само 38 унапред. Погледајте одозго: тачка 1 лежи испред задње равни.</translation>
    </message>
    <message>
        <source>Yes: its depth is 38</source>
        <translation>Да: дубина му је 38</translation>
    </message>
    <message>
        <source>No: you can see only half of far, up to 20</source>
        <translation>Не: види се само половина до задње равни, до 20</translation>
    </message>
    <message>
        <source>The whole distance up to far is visible, measured from the eye. Look from above: the pyramid reaches from the eye to far, and point 1 lies in it.</source>
        <translation>Види се цело растојање до задње равни, мерено од камере. Погледајте одозго: пирамида досеже од камере до задње равни, и тачка 1 лежи у њој.</translation>
    </message>
    <message>
        <source>Far is a plane across the axis. What matters is how far ahead the tree is, not how far away.</source>
        <translation>Задња раван је раван попреко на осу. Важно је колико је дрво испред, а не колико је далеко.</translation>
    </message>
    <message>
        <source>What passes the plane</source>
        <translation>Шта пролази кроз раван</translation>
    </message>
    <message>
        <source>Seen from above the far plane cuts straight across the avenue. A tree appears when its depth {0} is less than {1}. If you drive ahead by {2}, every depth shrinks by {3}, however far a tree is to the side: a tree 62 ahead appears at {4}.</source>
        <translation>Гледано одозго, задња раван сече алеју право попреко. Дрво се појављује када је његова дубина {0} мања од {1}. Ако се унапред возите за {2}, свака дубина се смањи за {3}, ма колико дрво било у страну: дрво 62 испред појављује се на {4}.</translation>
    </message>
    <message>
        <source>The lecture has two remedies. Fog fades distant things, so you do not see them appear. Level of detail draws distant trees with fewer vertices, so far can be farther at the same cost.</source>
        <translation>Предавање има два лека. Од магле далеке ствари бледе, па не видите како се појављују. Нивои детаљности цртају далеко дрвеће са мање темена, па задња раван може бити даље по истој цени.</translation>
    </message>
    <message>
        <source>Just so many trees</source>
        <translation>Тачно толико стабала</translation>
    </message>
    <message>
        <source>Each tree has 272 vertices. Set far so that exactly 10 trees are drawn, 2720 vertices.</source>
        <translation>Свако дрво има 272 темена. Поставите задњу раван тако да се црта тачно 10 стабала, 2720 темена.</translation>
    </message>
    <message>
        <source>A tree that the far plane cuts is drawn in part, and it counts.</source>
        <translation>Дрво које задња раван сече црта се делимично, и рачуна се.</translation>
    </message>
    <message>
        <source>The rows are 6 apart: to remove two trees, move far in by 6.</source>
        <translation>Редови су на размаку од 6: да уклоните два дрвета, приближите задњу раван за 6.</translation>
    </message>
    <message>
        <source>Every six units another pair of trees reaches the far plane.</source>
        <translation>На сваких шест јединица још један пар дрвећа стиже до задње равни.</translation>
    </message>
    <message>
        <source>By the formula</source>
        <translation>По формули</translation>
    </message>
    <message>
        <source>Point 1 is on the axis of a tree 44 ahead and 15 to the right. Far is 34. How far must the camera drive until the point is at the far plane?</source>
        <translation>Тачка 1 је на оси дрвета које је 44 испред и 15 удесно. Задња раван је на 34. Колико камера мора да се вози док тачка не буде на задњој равни?</translation>
    </message>
    <message>
        <source>This waits until the tree is 34 away from the eye, measured straight. Far is a plane across the direction of view, so how far the tree is to the side does not matter. Look from above at far = 44: it goes through point 1, though the point is 46.5 away.</source>
        <translation>Овде се чека док дрво не буде на 34 од камере, мерено право. Задња раван је раван попреко на смер погледа, па није важно колико је дрво у страну. Погледајте одозго задњу раван на 44: пролази кроз тачку 1, иако је тачка на растојању 46.5.</translation>
    </message>
    <message>
        <source>44 − 34. A tree at the side appears at the same time as one straight ahead.</source>
        <translation>44 − 34. Дрво са стране појављује се у исто време као и оно право испред.</translation>
    </message>
    <message>
        <source>The Above view shows the plane.</source>
        <translation>Поглед „Одозго” показује раван.</translation>
    </message>
    <message>
        <source>A fog begins at 15 and hides everything from 66 on; between them the contrast falls evenly. What percentage of the contrast is left at the far plane?</source>
        <translation>Магла почиње на 15 и од 66 надаље скрива све; између контраст равномерно опада. Колики проценат контраста остаје на задњој равни?</translation>
    </message>
    <message>
        <source>32 of the 51 units are left. With this contrast a tree still pops in.</source>
        <translation>Преостало је 32 од 51 јединице. Са тим контрастом дрво и даље искаче.</translation>
    </message>
    <message>
        <source>Back to the tree</source>
        <translation>Назад на дрво</translation>
    </message>
    <message>
        <source>The tree is 40.85 away, more than far, so it was tempting to leave it out. If far were a sphere, that would be right. But a matrix can only give planes, so near and far are planes: the tree is drawn because it is 38 *ahead*. When the camera turns, the plane turns with it, and trees at the edge of the picture come and go although nobody has driven. Drag the azimuth and watch them.</source>
        <translation>Дрво је на растојању 40.85, више од задње равни, па је било примамљиво изоставити га. Када би задња раван била сфера, то би било исправно. Али матрица може да да само равни, па су предња и задња равни: дрво се црта јер је 38 *испред*. Када се камера окрене, раван се окреће са њом, и дрвеће на ивици слике долази и одлази иако се нико није возио. Превуците азимут и гледајте га.</translation>
    </message>
    <message>
        <source>Practise: drive until it appears</source>
        <translation>Вежба: возите док се не појави</translation>
    </message>
    <message>
        <source>Point 1 is {0} ahead and {1} to the right, and far is {2}. How far must the camera drive, straight ahead, until the point is at the far plane?</source>
        <translation>Тачка 1 је {0} испред и {1} удесно, а задња раван је на {2}. Колико камера мора да се вози, право напред, док тачка не буде на задњој равни?</translation>
    </message>
    <message>
        <source>This waits until the point is {0} away from the eye, measured straight. Far is a plane across the direction of view, so how far the point is to the side does not matter. Look from above at far = {1}: it goes through point 1, however far that is to the side.</source>
        <translation>Овде се чека док тачка не буде на {0} од камере, мерено право. Задња раван је раван попреко на смер погледа, па није важно колико је тачка у страну. Погледајте одозго задњу раван на {1}: пролази кроз тачку 1, ма колико она била у страну.</translation>
    </message>
    <message>
        <source>The straight way counts</source>
        <translation>Рачуна се пут право до тачке</translation>
    </message>
    <message>
        <source>This subtracts far from the straight distance to the point. Far is a plane across the direction of view: only how far the point is ahead counts. Look from above at far = {0}: it goes through point 1, however far that is to the side.</source>
        <translation>Овде се растојање задње равни одузима од растојања право до тачке. Задња раван је раван попреко на смер погледа: рачуна се само колико је тачка испред. Погледајте одозго задњу раван на {0}: пролази кроз тачку 1, ма колико она била у страну.</translation>
    </message>
    <message>
        <source>The view from above shows the far plane. Which distance to it does the drive shorten?</source>
        <translation>Поглед одозго показује задњу раван. Које растојање до ње вожња скраћује?</translation>
    </message>
    <message>
        <source>Driving shortens the depth alone. The point may be as far to the side as it likes.</source>
        <translation>Вожња скраћује само дубину. Тачка може бити у страну колико хоће.</translation>
    </message>
    <message>
        <source>Practise: the last tree</source>
        <translation>Вежба: последње дрво</translation>
    </message>
    <message>
        <source>You look down on the avenue; in each row the trees are 6 apart.</source>
        <translation>Одозго гледате на алеју; у сваком реду дрвеће је на размаку од 6.</translation>
    </message>
    <message>
        <source>Far moves out by {0}, from {1} to {2}. In the row that is farther from the camera&apos;s way, mark the last tree whose trunk is then drawn.</source>
        <translation>Задња раван се одмиче за {0}, са {1} на {2}. У реду који је даље од пута камере обележите последње дрво чије се стабло тада црта.</translation>
    </message>
    <message>
        <source>The tree behind this one is farther from the eye than far, but less deep, and only depth counts. Far is a plane across the direction of view, not a circle round the eye. Look from above at far, moved out.</source>
        <translation>Дрво иза овог даље је од камере него задња раван, али је на мањој дубини, а рачуна се само дубина. Задња раван је раван попреко на смер погледа, а не круг око камере. Погледајте одозго одмакнуту задњу раван.</translation>
    </message>
    <message>
        <source>The far plane moves along the direction of view and stays across it.</source>
        <translation>Задња раван се помера дуж смера погледа и остаје попреко на њега.</translation>
    </message>
    <message>
        <source>Trees are 6 apart. How many such distances fit into {0}?</source>
        <translation>Дрвеће је на размаку 6. Колико таквих размака стане у {0}?</translation>
    </message>
    <message>
        <source>This tree is {0} deep, the next one {1}; far is then {2}.</source>
        <translation>Ово дрво је на дубини {0}, следеће на {1}; задња раван је тада на {2}.</translation>
    </message>
    <message>
        <source>Practise: so many trees</source>
        <translation>Вежба: толико стабала</translation>
    </message>
    <message>
        <source>The first two trees are {0} ahead of the camera, and each following pair 6 farther. Set far so that exactly {1} trees are drawn; a tree that far cuts counts.</source>
        <translation>Прва два дрвета су {0} испред камере, а сваки следећи пар 6 даље. Поставите задњу раван тако да се црта тачно толико стабала: {1}; дрво које задња раван сече рачуна се.</translation>
    </message>
    <message>
        <source>How deep is pair number {0}? Far must lie just behind it.</source>
        <translation>На којој је дубини пар број {0}? Задња раван мора лежати одмах иза њега.</translation>
    </message>
    <message>
        <source>Its depth is {0}. How far it is to the side does not count.</source>
        <translation>Његова дубина је {0}. Није важно колико је у страну.</translation>
    </message>
    <message>
        <source>Pair number {0} is {1} deep, the next one {2}. A tree begins 1.5 nearer: far must be between the fronts of both pairs.</source>
        <translation>Пар број {0} је на дубини {1}, следећи на {2}. Дрво почиње 1.5 ближе: задња раван мора бити између предњих страна оба пара.</translation>
    </message>
</context>
<context>
    <name>l24-focus</name>
    <message>
        <source>What is sharp?</source>
        <translation>Шта је оштро?</translation>
    </message>
    <message>
        <source>Behind the focus</source>
        <translation>Иза фокуса</translation>
    </message>
    <message>
        <source>The lens of the synthetic camera is a point, and everything is sharp. A real lens draws a point as a disc. A disc of diameter {0} or less passes for a point. The lens here has a focal length of 50 mm and an aperture of {1}, and is focused at 2 m.</source>
        <translation>Објектив синтетичке камере је тачка, и све је оштро. Прави објектив тачку црта као диск. Диск пречника {0} или мањег пролази као тачка. Објектив овде има жижну даљину 50 mm и бленду {1}, а фокусиран је на 2 m.</translation>
    </message>
    <message>
        <source>The focus moves to 5 m. The sharp range begins at 4.287 m. At how many metres does it end?</source>
        <translation>Фокус се помера на 5 m. Оштри опсег почиње на 4.287 m. На колико метара се завршава?</translation>
    </message>
    <message>
        <source>5.713, as far behind the focus as in front</source>
        <translation>5.713, једнако далеко иза фокуса као испред њега</translation>
    </message>
    <message>
        <source>The disc grows more slowly behind the focus than in front of it. So the sharp range reaches farther behind. Look from above: from the focus it is 0.713 m to the near limit, and 0.998 m to the far one.</source>
        <translation>Диск иза фокуса расте спорије него испред њега. Зато оштри опсег досеже даље позади. Погледајте одозго: од фокуса је 0.713 m до ближе границе, а 0.998 m до даље.</translation>
    </message>
    <message>
        <source>Only there are points drawn as points, but discs up to {0} pass for points. Look from above: the sharp range goes on behind the focus.</source>
        <translation>Само се тамо тачке цртају као тачке, али и дискови до {0} пролазе као тачке. Погледајте одозго: оштри опсег се наставља иза фокуса.</translation>
    </message>
    <message>
        <source>0.713 m in front of the focus, but 0.998 m behind it. The scene&apos;s numbers have both limits. Of the posts those at 5 m and 6 m are outlined as sharp: the front of each is 15 cm nearer than its middle.</source>
        <translation>0.713 m испред фокуса, али 0.998 m иза њега. Бројеви сцене имају обе границе. Од стубова су као оштри уоквирени они на 5 m и 6 m: предња страна сваког је 15 cm ближе него његова средина.</translation>
    </message>
    <message>
        <source>The two limits</source>
        <translation>Две границе</translation>
    </message>
    <message>
        <source>For the focal length {0}, the aperture {1}, the circle of confusion {2} and the focus at {3},</source>
        <translation>За жижну даљину {0}, бленду {1}, кружић неоштрине {2} и фокус на {3},</translation>
    </message>
    <message>
        <source>and the picture is sharp from {0} to {1}.</source>
        <translation>а слика је оштра од {0} до {1}.</translation>
    </message>
    <message>
        <source>Here {0} m, {1}, and so from {2} to {3} m. The World pane shows the three planes from above.</source>
        <translation>Овде је {0} m, {1}, па од {2} до {3} m. Приказ „Свет” показује три равни одозго.</translation>
    </message>
    <message>
        <source>Sharp without end</source>
        <translation>Оштро без краја</translation>
    </message>
    <message>
        <source>Make everything far away sharp: move the far limit to infinity.</source>
        <translation>Нека све далеко буде оштро: померите даљу границу у бесконачност.</translation>
    </message>
    <message>
        <source>When does {0} become 0?</source>
        <translation>Када {0} постаје 0?</translation>
    </message>
    <message>
        <source>Focus at the hyperfocal distance H or farther away, or stop the lens down with a larger N until H is nearer than the focus.</source>
        <translation>Фокусирајте на хиперфокално растојање H или даље, или затворите бленду већим N док H не буде ближе од фокуса.</translation>
    </message>
    <message>
        <source>From {0} on, {1} is 1 or more. If you focus exactly at {2}, everything from {3} on is sharp.</source>
        <translation>Од {0} надаље {1} је 1 или више. Ако фокусирате тачно на {2}, све од {3} надаље је оштро.</translation>
    </message>
    <message>
        <source>By the formula</source>
        <translation>По формули</translation>
    </message>
    <message>
        <source>A 50-mm lens with {0} and {1} mm is focused at 4 m. Up to how many metres is it sharp?</source>
        <translation>Објектив од 50 mm са {0} и {1} mm фокусиран је на 4 m. До колико метара је оштар?</translation>
    </message>
    <message>
        <source>This is as far behind the focus as the near limit is in front of it. The disc grows more slowly behind the focus, so the far limit is farther away. Look from above: the far limit is farther from the focus than the near one.</source>
        <translation>Ово је иза фокуса једнако далеко као ближа граница испред њега. Диск иза фокуса расте спорије, па је даља граница удаљенија. Погледајте одозго: даља граница је даље од фокуса него ближа.</translation>
    </message>
    <message>
        <source>{0} m, {1}, and {2}.</source>
        <translation>{0} m, {1}, и {2}.</translation>
    </message>
    <message>
        <source>First {0}, in metres.</source>
        <translation>Прво {0}, у метрима.</translation>
    </message>
    <message>
        <source>Posts at 3 m and at 6 m are exactly at the two limits. At how many metres is the focus?</source>
        <translation>Стубови на 3 m и на 6 m тачно су на двема границама. На колико метара је фокус?</translation>
    </message>
    <message>
        <source>This puts the focus half-way between the limits. The disc grows more slowly behind the focus, so the focus is closer to the near limit; what is half-way is one over the distance, between {0} and {1}. Look from above at the focus 4.5 with a near limit of 3: the far limit is 9, not 6.</source>
        <translation>Овде је фокус стављен на пола пута између граница. Диск иза фокуса расте спорије, па је фокус ближе ближој граници; на пола пута је реципрочна вредност растојања, између {0} и {1}. Погледајте одозго фокус 4.5 са ближом границом 3: даља граница је 9, а не 6.</translation>
    </message>
    <message>
        <source>{0} is the middle of {1} and {2}: {3}.</source>
        <translation>{0} је средина између {1} и {2}: {3}.</translation>
    </message>
    <message>
        <source>Which number is as far from {0} as from {1}?</source>
        <translation>Који је број од {0} далеко колико и од {1}?</translation>
    </message>
    <message>
        <source>Back to the limits</source>
        <translation>Назад на границе</translation>
    </message>
    <message>
        <source>Half in front and half behind was tempting, because the disc is 0 at the focus and grows on both sides. But it does not grow equally: it is proportional to {0}, and one over the distance changes more slowly the farther away you are. So the far limit is always farther from the focus than the near one, and from the hyperfocal distance on it is at infinity.</source>
        <translation>Пола испред, а пола иза било је примамљиво, јер је диск у фокусу 0 и расте на обе стране. Али не расте једнако: сразмеран је са {0}, а реципрочна вредност растојања мења се све спорије што сте даље. Зато је даља граница увек даље од фокуса него ближа, а од хиперфокалног растојања надаље је у бесконачности.</translation>
    </message>
    <message>
        <source>Practise: the far limit</source>
        <translation>Вежба: даља граница</translation>
    </message>
    <message>
        <source>With {0} and {1}, all in metres.</source>
        <translation>Са {0} и {1}, све у метрима.</translation>
    </message>
    <message>
        <source>A lens with {0} mm and {1} is focused at {2} m, with {3} mm. Up to how many metres is the picture sharp?</source>
        <translation>Објектив са {0} mm и {1} фокусиран је на {2} m, са {3} mm. До колико метара је слика оштра?</translation>
    </message>
    <message>
        <source>This is as far behind the focus as the near limit is in front of it. The limits are {0} and {1}; the far one is farther from the focus. Look from above: it is farther from the focus than the near one.</source>
        <translation>Ово је иза фокуса једнако далеко као ближа граница испред њега. Границе су {0} и {1}; даља је даље од фокуса. Погледајте одозго: даље је од фокуса него ближа.</translation>
    </message>
    <message>
        <source>Both limits have a plus</source>
        <translation>Обе границе имају плус</translation>
    </message>
    <message>
        <source>This is the near limit, {0}. Behind the focus it is {1}. Look from above: the far limit lies behind the focus.</source>
        <translation>Ово је ближа граница, {0}. Иза фокуса је {1}. Погледајте одозго: даља граница лежи иза фокуса.</translation>
    </message>
    <message>
        <source>First {0}, in metres: {1} mm are {2} m, and 0.03 mm are 0.00003 m.</source>
        <translation>Прво {0}, у метрима: {1} mm је {2} m, а 0.03 mm је 0.00003 m.</translation>
    </message>
    <message>
        <source>Then {0}, and the far limit {1}.</source>
        <translation>Затим {0}, и даља граница {1}.</translation>
    </message>
    <message>
        <source>Here {0} is {1} m, and {2} is {3}.</source>
        <translation>Овде је {0} једнако {1} m, а {2} је {3}.</translation>
    </message>
    <message>
        <source>Practise: where does it end?</source>
        <translation>Вежба: где се завршава?</translation>
    </message>
    <message>
        <source>You look down on the lens and the posts, which are 2, 3, 4, 5, 6, 8, 10, 12, 15 and 20 m away.</source>
        <translation>Одозго гледате на објектив и стубове, који су на 2, 3, 4, 5, 6, 8, 10, 12, 15 и 20 m.</translation>
    </message>
    <message>
        <source>The lens has {0} mm and is focused at {1} m. It is stopped down to {2}, so that {3} m. Mark where on the axis, the middle line ahead of the eye, the sharp range now ends.</source>
        <translation>Објектив има {0} mm и фокусиран је на {1} m. Бленда је затворена на {2}, тако да је {3} m. Обележите где се на оси, средњој линији испред камере, оштри опсег сада завршава.</translation>
    </message>
    <message>
        <source>This is as far behind the focus as the near limit is in front of it. The far limit, {0}, is farther away. Look from above at both limits.</source>
        <translation>Ово је иза фокуса једнако далеко као ближа граница испред њега. Даља граница, {0}, је удаљенија. Погледајте одозго обе границе.</translation>
    </message>
    <message>
        <source>The far limit is {0}. Find its distance between the posts.</source>
        <translation>Даља граница је {0}. Нађите њено растојање међу стубовима.</translation>
    </message>
    <message>
        <source>{0}, so the range ends at {1} m.</source>
        <translation>{0}, па се опсег завршава на {1} m.</translation>
    </message>
    <message>
        <source>Practise: sharp from here to there</source>
        <translation>Вежба: оштро одавде довде</translation>
    </message>
    <message>
        <source>With {0} the picture is sharp from {1} to {2}.</source>
        <translation>Са {0} слика је оштра од {1} до {2}.</translation>
    </message>
    <message>
        <source>This lens has {0} mm and {1} mm. Set its focal distance {2} and its aperture {3} so that the picture is sharp from {4} m to {5} m.</source>
        <translation>Овај објектив има {0} mm и {1} mm. Поставите његово растојање фокуса {2} и бленду {3} тако да слика буде оштра од {4} m до {5} m.</translation>
    </message>
    <message>
        <source>{0} is the middle of {1} and {2}, so {3}.</source>
        <translation>{0} је средина између {1} и {2}, па је {3}.</translation>
    </message>
    <message>
        <source>The focus at {0} m gives {1}.</source>
        <translation>Фокус на {0} m даје {1}.</translation>
    </message>
    <message>
        <source>{0}, all in metres.</source>
        <translation>{0}, све у метрима.</translation>
    </message>
    <message>
        <source>{0} {1} {2} m, from {3} m to {4} m; and {5} {6}, with {7}.</source>
        <translation>{0} {1} {2} m, од {3} m до {4} m; и {5} {6}, са {7}.</translation>
    </message>
    <message>
        <source>The far limit is farther from the focus than the near one. Look from above at the focus {0} with a near limit of {1}: the far limit is beyond {2}.</source>
        <translation>Даља граница је даље од фокуса него ближа. Погледајте одозго фокус {0} са ближом границом {1}: даља граница је иза {2}.</translation>
    </message>
</context>
<context>
    <name>l25-how-many-bits</name>
    <message>
        <source>How many bits does a picture need?</source>
        <translation>Колико је битова потребно слици?</translation>
    </message>
    <message>
        <source>More places than pixels</source>
        <translation>Више места него пиксела</translation>
    </message>
    <message>
        <source>A coordinate of 16 bits has 65 536 places. Here they are spread over the scene&apos;s longest side, 8 units, and the picture is 320 pixels wide. Each arrow in **Image** runs from where a vertex belongs towards where it is drawn, enlarged 10 000 times. The dock says how far off a vertex of the picture is at most: 0.002 pixels.</source>
        <translation>Координата од 16 бита има 65 536 места. Овде су она распоређена по најдужој страни сцене, 8 јединица, а слика је широка 320 пиксела. Свака стрелица у приказу **Слика** иде од места где темену припада да буде ка месту где је нацртано, увећана 10 000 пута. Бочни панел каже колико теме слике највише одступа: 0.002 пиксела.</translation>
    </message>
    <message>
        <source>The camera comes up to a corner of the F, as near as 0.01 units. How far off is the corner now?</source>
        <translation>Камера прилази темену слова F, на само 0.01 јединица. Колико сада то теме одступа?</translation>
    </message>
    <message>
        <source>Nothing that can be seen: 65 536 places are more than 320 pixels</source>
        <translation>Ништа што би се видело: 65 536 места је више од 320 пиксела</translation>
    </message>
    <message>
        <source>The places are spread over the whole scene, and the picture now shows a small part of it. Look at the corner: from one place to the next are 3.3 pixels.</source>
        <translation>Места су распоређена по целој сцени, а слика сада показује мали њен део. Погледајте теме: од једног места до следећег је 3.3 пиксела.</translation>
    </message>
    <message>
        <source>0.002 pixels, as before: the vertex is stored as it was</source>
        <translation>0.002 пиксела, као пре: теме је сачувано како је и било</translation>
    </message>
    <message>
        <source>The vertex is off by the same length, but here a unit fills 27 000 pixels. Look at the corner: it is off by more than a pixel.</source>
        <translation>Теме одступа за исту дужину, али овде јединица испуњава 27 000 пиксела. Погледајте теме: одступа за више од пиксела.</translation>
    </message>
    <message>
        <source>By up to 1.6 pixels across, and as much down</source>
        <translation>До 1.6 пиксела у ширину, и исто толико у висину</translation>
    </message>
    <message>
        <source>The places are 0.00012 units apart wherever you look. At 0.01 units from the eye, a unit fills 27 000 pixels.</source>
        <translation>Места су размакнута 0.00012 јединица ма где гледали. На 0.01 јединица од камере јединица испуњава 27 000 пиксела.</translation>
    </message>
    <message>
        <source>From bits to pixels</source>
        <translation>Од битова до пиксела</translation>
    </message>
    <message>
        <source>With {0} bits over a side {1} the places are {2} apart. A coordinate goes to the nearest place, so it is off by half of that at most. At the depth {3} a picture {4} pixels high shows {5} units, and so</source>
        <translation>Са {0} бита на страни {1} места су размакнута {2}. Координата иде на најближе место, па одступа највише за половину тога. На дубини {3} слика висине {4} пиксела показује {5} јединица, па је</translation>
    </message>
    <message>
        <source>With 8 bits: {0} units. At the target, {1}, a unit fills {2} pixels, so one coordinate is off by up to 0.37 pixels. Three coordinates together, nearer to the eye, make a little more. The *predicted* number in the dock is such a bound: no error is larger.</source>
        <translation>Са 8 бита: {0} јединица. Код циља, {1}, јединица испуњава {2} пиксела, па једна координата одступа до 0.37 пиксела. Три координате заједно, ближе камери, дају нешто више. *Предвиђени* број у бочном панелу је таква граница: ниједна грешка није већа.</translation>
    </message>
    <message>
        <source>With 12 bits instead of 8, over the same side of 8 units: by how many units is a coordinate off at most?</source>
        <translation>Са 12 бита уместо 8, на истој страни од 8 јединица: за колико јединица координата највише одступа?</translation>
    </message>
    <message>
        <source>The gap is the error</source>
        <translation>Размак је грешка</translation>
    </message>
    <message>
        <source>This is the distance between two places. The coordinate goes to the nearer one, so it is off by half of it at most. Look at the picture with 12 bits, and at *predicted* in the panel.</source>
        <translation>Ово је растојање између два места. Координата иде на ближе од њих, па одступа највише за половину тога. Погледајте слику са 12 бита, и *предвиђено* у панелу.</translation>
    </message>
    <message>
        <source>{0} units from place to place, and half of that.</source>
        <translation>{0} јединица од места до места, и половина тога.</translation>
    </message>
    <message>
        <source>12 bits have {0} places, and one gap less.</source>
        <translation>12 бита имају {0} места, и један размак мање.</translation>
    </message>
    <message>
        <source>Where you stand</source>
        <translation>Где стојите</translation>
    </message>
    <message>
        <source>Still 8 bits: nothing about the stored vertices changes in this step.</source>
        <translation>И даље 8 бита: у овом кораку се на сачуваним теменима ништа не мења.</translation>
    </message>
    <message>
        <source>Make the largest measured error smaller than 0.3 pixels, and leave the 8 bits as they are.</source>
        <translation>Нека највећа измерена грешка буде мања од 0.3 пиксела, а 8 бита оставите.</translation>
    </message>
    <message>
        <source>What stands in the denominator of {0}?</source>
        <translation>Шта стоји у имениоцу од {0}?</translation>
    </message>
    <message>
        <source>Move Distance to the right. A wider Field of view helps, too.</source>
        <translation>Померите „Растојање” удесно. Помаже и шире „Видно поље”.</translation>
    </message>
    <message>
        <source>Fewer pixels for each unit, fewer pixels of error. A game may use 8 bits for a far mountain and 16 for the sword in your hand.</source>
        <translation>Мање пиксела по јединици, мање пиксела грешке. Игра може да користи 8 бита за далеку планину, а 16 за мач у вашој руци.</translation>
    </message>
    <message>
        <source>A vertex at the depth 10 is 0.4 pixels off. The camera comes nearer, to the depth 5. How many pixels is it off now?</source>
        <translation>Теме на дубини 10 одступа 0.4 пиксела. Камера прилази, на дубину 5. За колико пиксела сада одступа?</translation>
    </message>
    <message>
        <source>The vertex is off by the same length, but at half the depth a unit has twice as many pixels. Look at the arrows from nearer by: they are longer.</source>
        <translation>Теме одступа за исту дужину, али на упола мањој дубини јединица има двапут више пиксела. Погледајте стрелице изближа: дуже су.</translation>
    </message>
    <message>
        <source>{0} has {1} in its denominator: at half the depth every length, and every error, is drawn twice as long.</source>
        <translation>{0} има {1} у имениоцу: на упола мањој дубини свака дужина, и свака грешка, црта се двапут дужа.</translation>
    </message>
    <message>
        <source>Far from the origin</source>
        <translation>Далеко од координатног почетка</translation>
    </message>
    <message>
        <source>Now vertices and arithmetic are float32, about 7 decimal digits. The world&apos;s origin is moved 1 000 000 units away, and everything else stays where it is: camera and F are neighbours, far out. Their coordinates are now about 1 000 000, and the matrix subtracts them from each other.</source>
        <translation>Сада су темена и аритметика float32, око 7 децималних цифара. Координатни почетак света је померен 1 000 000 јединица далеко, а све остало стоји где јесте: камера и слово F су суседи, далеко напољу. Њихове координате су сада око 1 000 000, и матрица их одузима једне од других.</translation>
    </message>
    <message>
        <source>A float32 has 24 significant bits. How far apart are its numbers near 1 000 000, which lies between {0} and {1}?</source>
        <translation>float32 има 24 значајна бита. Колико су размакнути његови бројеви око 1 000 000, који лежи између {0} и {1}?</translation>
    </message>
    <message>
        <source>A float32 keeps 24 bits, so its numbers near 1 000 000 are apart by what the last bit counts. Look at the F: its corners are at such places only.</source>
        <translation>float32 чува 24 бита, па су његови бројеви око 1 000 000 размакнути онолико колико вреди последњи бит. Погледајте слово F: његова темена су само на таквим местима.</translation>
    </message>
    <message>
        <source>The first of 24 bits counts {0}, the last one {1}: one sixteenth of a unit.</source>
        <translation>Први од 24 бита вреди {0}, последњи {1}: једна шеснаестина јединице.</translation>
    </message>
    <message>
        <source>The first bit counts {0}, the second {1}. What does bit 24 count?</source>
        <translation>Први бит вреди {0}, други {1}. Колико вреди бит 24?</translation>
    </message>
    <message>
        <source>A vertex is 10 units from the eye, measured along x, and is stored as the nearest float32. By how many per cent of these 10 units can it be off?</source>
        <translation>Теме је 10 јединица од камере, мерено дуж x, и чува се као најближи float32. За колико процената од ових 10 јединица може да одступа?</translation>
    </message>
    <message>
        <source>The seven digits belong to the coordinate, near 1 000 000. The subtraction takes the leading ones away, and the rounding stays. Look at the F: its corners are off by parts of a unit.</source>
        <translation>Седам цифара припада координати, око 1 000 000. Одузимање однесе водеће, а заокруживање остаје. Погледајте слово F: његова темена одступају за делове јединице.</translation>
    </message>
    <message>
        <source>Half a gap, 0.031 units, of 10. The subtraction leaves the error as it is and takes away the digits before it: from 7 digits 2 or 3 are left.</source>
        <translation>Пола размака, 0.031 јединица, од 10. Одузимање оставља грешку каква јесте, а односи цифре испред ње: од 7 цифара остају 2 или 3.</translation>
    </message>
    <message>
        <source>Buy what you need</source>
        <translation>Купите онолико колико треба</translation>
    </message>
    <message>
        <source>A console of 1994 had no time for more: vertices were drawn at whole pixels, and textures were stretched over the screen without a divide. Turn the camera slowly and watch the corners of the F.</source>
        <translation>Конзола из 1994. није имала времена за више: темена су се цртала на целим пикселима, а текстуре растезале по екрану без дељења. Полако окрећите камеру и гледајте темена слова F.</translation>
    </message>
    <message>
        <source>Choose a hardware that stores a vertex in fewer than 5 bytes, with a largest measured error below 0.1 pixels in this picture.</source>
        <translation>Изаберите хардвер који теме чува у мање од 5 бајтова, са највећом измереном грешком испод 0.1 пиксела на овој слици.</translation>
    </message>
    <message>
        <source>8 bits take 3 bytes a vertex. Which others take fewer than 5?</source>
        <translation>8 бита је 3 бајта по темену. Који други заузимају мање од 5?</translation>
    </message>
    <message>
        <source>12 bits: 4.5 bytes instead of float32&apos;s 12, and nobody sees the difference in a picture of 320 by 240.</source>
        <translation>12 бита: 4.5 бајта уместо 12 код float32, и нико не види разлику на слици од 320 пута 240.</translation>
    </message>
    <message>
        <source>Back to the corner</source>
        <translation>Назад на теме</translation>
    </message>
    <message>
        <source>65 536 places were tempting because no screen has so many columns. But the places belong to the scene, and the pixels to the picture: the number that matters is pixels per place, and you change it with every step. The two pictures draw the corner with 16 bits and with float64. So ask for the error in pixels from where you will stand, and buy the bits for that.</source>
        <translation>65 536 места било је примамљиво, јер ниједан екран нема толико колона. Али места припадају сцени, а пиксели слици: важан је број пиксела по месту, а њега мењате сваким кораком. Две слике цртају теме са 16 бита и у float64. Зато тражите грешку у пикселима одатле где ћете стајати, и битове купујте према њој.</translation>
    </message>
    <message>
        <source>16 bits</source>
        <translation>16 бита</translation>
    </message>
    <message>
        <source>float64</source>
        <translation>float64</translation>
    </message>
    <message>
        <source>Practise: bits and pixels</source>
        <translation>Вежба: битови и пиксели</translation>
    </message>
    <message>
        <source>With {0} bits over a side {1} a coordinate is off by half of {2} at most. Here {3} units, the picture is 240 pixels high, and the field of view is 48°.</source>
        <translation>Са {0} бита на страни {1} координата одступа највише за половину од {2}. Овде је {3} јединица, слика је висока 240 пиксела, а видно поље је 48°.</translation>
    </message>
    <message>
        <source>A vertex is at the depth {0}, and its coordinates have {1} bits. By how many pixels is one of them off in the picture at most?</source>
        <translation>Теме је на дубини {0}, а његове координате имају {1} бита. За колико пиксела једна од њих на слици највише одступа?</translation>
    </message>
    <message>
        <source>This is the distance between two places. The coordinate goes to the nearer one, so it is off by half of it at most. Look at the arrows: each corner goes to the nearer place.</source>
        <translation>Ово је растојање између два места. Координата иде на ближе од њих, па одступа највише за половину тога. Погледајте стрелице: свако теме иде на ближе место.</translation>
    </message>
    <message>
        <source>This takes the tangent of the whole field of view. Half the picture belongs to half of the angle. Look at the picture at 90°: it is {0} high; {1} would be infinite.</source>
        <translation>Овде је узет тангенс целог видног поља. Половини слике припада половина угла. Погледајте слику на 90°: висока је {0}; {1} било би бесконачно.</translation>
    </message>
    <message>
        <source>How many units is a coordinate off at most?</source>
        <translation>За колико јединица координата највише одступа?</translation>
    </message>
    <message>
        <source>At the depth {0} the picture shows {1} units, from bottom to top, in 240 pixels.</source>
        <translation>На дубини {0} слика показује {1} јединица, од доње до горње ивице, у 240 пиксела.</translation>
    </message>
    <message>
        <source>The coordinate is off by up to {0} units, and a unit at this depth has {1} pixels.</source>
        <translation>Координата одступа до {0} јединица, а јединица на овој дубини има {1} пиксела.</translation>
    </message>
    <message>
        <source>Practise: far from the origin</source>
        <translation>Вежба: далеко од координатног почетка</translation>
    </message>
    <message>
        <source>A float32 has 24 significant bits. The world&apos;s origin is moved away along x, so the coordinates of the F are about as large as the distance of the origin.</source>
        <translation>float32 има 24 значајна бита. Координатни почетак света је одмакнут дуж x, па су координате слова F велике отприлике колико растојање координатног почетка.</translation>
    </message>
    <message>
        <source>The origin is {0} units away. This number lies between {1} and {2}, which are powers of 2. By how many units is a float32 near it off at most?</source>
        <translation>Растојање до координатног почетка је {0}. Овај број лежи између {1} и {2}, а то су степени броја 2. За колико јединица float32 око њега највише одступа?</translation>
    </message>
    <message>
        <source>This is the distance between two numbers. A coordinate becomes the nearer one, so it is off by half of it at most. Look at the arrows: each corner goes to the nearer number.</source>
        <translation>Ово је растојање између два броја. Координата постаје ближи од њих, па одступа највише за половину тога. Погледајте стрелице: свако теме иде на ближи број.</translation>
    </message>
    <message>
        <source>A float32 has 24 bits, and its numbers lie as far apart as the last bit counts: a power of 2, not of 10. Look at the arrows: each corner goes to the nearer number.</source>
        <translation>float32 има 24 бита, и његови бројеви су размакнути колико вреди последњи бит: степен броја 2, а не 10. Погледајте стрелице: свако теме иде на ближи број.</translation>
    </message>
    <message>
        <source>24 bits are 24 halvings</source>
        <translation>24 бита су 24 преполовљавања</translation>
    </message>
    <message>
        <source>This counts 25 bits. The first of 24 bits counts {0}, so the last one counts {1}{2}: from the first to the last it is halved 23 times. Look at the arrows: each corner goes to the nearer number.</source>
        <translation>Овде је пребројано 25 бита. Први од 24 бита вреди {0}, па последњи вреди {1}{2}: од првог до последњег преполови се 23 пута. Погледајте стрелице: свако теме иде на ближи број.</translation>
    </message>
    <message>
        <source>The first bit counts {0}, the second half of that. What does bit 24 count?</source>
        <translation>Први бит вреди {0}, други половину тога. Колико вреди бит 24?</translation>
    </message>
    <message>
        <source>The numbers are as far apart as bit 24 counts.</source>
        <translation>Бројеви су размакнути колико вреди бит 24.</translation>
    </message>
    <message>
        <source>Bit 24 counts {0}{1}, and half of that is the largest error.</source>
        <translation>Бит 24 вреди {0}{1}, а половина тога је највећа грешка.</translation>
    </message>
    <message>
        <source>Practise: stand where it is good enough</source>
        <translation>Вежба: станите где је довољно добро</translation>
    </message>
    <message>
        <source>With 8 bits over 8 units a coordinate is off by half of {0} at most. The field of view is 53.13°: at the depth {1} the picture is exactly {2} units high.</source>
        <translation>Са 8 бита на 8 јединица координата одступа највише за половину од {0}. Видно поље је 53.13°: на дубини {1} слика је висока тачно {2} јединица.</translation>
    </message>
    <message>
        <source>Keep the 8 bits and the {0} pixels of height, and move the camera until a coordinate of a vertex at the target is off by up to {1} pixels.</source>
        <translation>Задржите 8 бита и {0} пиксела висине, и померајте камеру док координата темена код циља не одступа до {1} пиксела.</translation>
    </message>
    <message>
        <source>This takes the distance between two places for the error. The coordinate goes to the nearer place, so it is off by half of that at most. Look at the F from where you stand: it is smaller than it has to be.</source>
        <translation>Овде је растојање између два места узето за грешку. Координата иде на ближе место, па одступа највише за половину тога. Погледајте слово F одатле где стојите: мање је него што мора бити.</translation>
    </message>
    <message>
        <source>How many units is a coordinate off at most? And how many pixels has a unit at the target?</source>
        <translation>За колико јединица координата највише одступа? А колико пиксела има јединица код циља?</translation>
    </message>
    <message>
        <source>{0} must be {1}.</source>
        <translation>{0} мора бити {1}.</translation>
    </message>
</context>
<context>
    <name>l26-small-errors</name>
    <message>
        <source>Small errors that grow</source>
        <translation>Мале грешке које расту</translation>
    </message>
    <message>
        <source>Round and round</source>
        <translation>У круг и у круг</translation>
    </message>
    <message>
        <source>A camera turns by 1° a frame: each frame multiplies its axes by the same matrix, in float32, and every product is rounded. After 360 frames it should be home. It is off by 0.003 pixels. In **Image** this is drawn 20 000 times as large, beside the pale true picture.</source>
        <translation>Камера се окреће за 1° по кадру: сваки кадар множи њене осе истом матрицом, у float32, и сваки производ се заокружује. После 360 кадрова требало би да буде тамо где је почела. Одступа за 0.003 пиксела. У приказу **Слика** то је нацртано 20 000 пута веће, поред бледе тачне слике.</translation>
    </message>
    <message>
        <source>Now the axes are made orthonormal every tenth frame, with a fast inverse square root that is off by up to 0.18 %. The numbers are still float32. How far off is the picture after one round?</source>
        <translation>Сада се осе сваки десети кадар ортонормирају, брзим инверзним кореном који греши до 0.18 %. Бројеви су и даље float32. Колико слика одступа после једног круга?</translation>
    </message>
    <message>
        <source>0.003 pixels, as before: float32 has 7 digits, so a round of 360 steps keeps 5</source>
        <translation>0.003 пиксела, као пре: float32 има 7 цифара, па круг од 360 корака задржи 5</translation>
    </message>
    <message>
        <source>The format has its 7 digits, but each step uses a root that has 3. Look at the two letters: they are 6 pixels apart.</source>
        <translation>Формат има својих 7 цифара, али сваки корак користи корен који их има 3. Погледајте два слова: размакнута су 6 пиксела.</translation>
    </message>
    <message>
        <source>Less than before: renormalising puts the axes right</source>
        <translation>Мање него пре: поновно нормирање исправља осе</translation>
    </message>
    <message>
        <source>It puts their lengths right, not where they point to. Look at the two letters: they are farther apart than without it.</source>
        <translation>Исправља њихове дужине, а не смер. Погледајте два слова: размакнутија су него без њега.</translation>
    </message>
    <message>
        <source>About 6 pixels</source>
        <translation>Око 6 пиксела</translation>
    </message>
    <message>
        <source>One axis comes out shorter than the others by 0.17 %. Each turn mixes the three, so each turn is a little too large or too small, always in the same direction.</source>
        <translation>Једна оса испадне краћа од осталих за 0.17 %. Свако окретање меша све три, па је свако окретање мало превелико или премало, увек у истом смеру.</translation>
    </message>
    <message>
        <source>The same error again and again</source>
        <translation>Иста грешка изнова</translation>
    </message>
    <message>
        <source>Such an error is no chance. Each round adds about as much as the one before, and the errors of {0} rounds are {1} times as large. After one round the dock says that an axis leans by {2}.</source>
        <translation>Таква грешка није случај. Сваки круг дода отприлике колико и претходни, и грешке {0} кругова су {1} пута толике. После једног круга бочни панел каже да се једна оса нагиње за {2}.</translation>
    </message>
    <message>
        <source>Turn the camera until the picture is off by more than 50 pixels, with nothing else changed.</source>
        <translation>Окрећите камеру док слика не одступа више од 50 пиксела, а да се ништа друго не промени.</translation>
    </message>
    <message>
        <source>How many rounds is that, at 6 pixels a round?</source>
        <translation>Колико је то кругова, по 6 пиксела на круг?</translation>
    </message>
    <message>
        <source>Move Rounds to the right.</source>
        <translation>Померите „Кругови” удесно.</translation>
    </message>
    <message>
        <source>9 or 10 rounds are enough: a minute at 60 frames a second.</source>
        <translation>9 или 10 кругова је довољно: минут са 60 кадрова у секунди.</translation>
    </message>
    <message>
        <source>An axis leans by 0.5° and the field of view is 40° in a picture of 720 lines. By how many pixels does that move what is in the middle of the picture, at most?</source>
        <translation>Оса се нагиње за 0.5°, а видно поље је 40° на слици од 720 редова. За колико пиксела то највише помера оно што је у средини слике?</translation>
    </message>
    <message>
        <source>This gives every degree as many pixels. In the middle a degree has fewer of them than at the border. Look at the picture at 140°: there the difference is large.</source>
        <translation>Овде сваки степен добија једнако пиксела. У средини степен их има мање него на рубу. Погледајте слику на 140°: тамо је разлика велика.</translation>
    </message>
    <message>
        <source>The middle is at the distance 1 on a plane that is {0} high and has 720 pixels, and it moves by {1}.</source>
        <translation>Средина је на растојању 1 у равни која је висока {0} и има 720 пиксела, и помера се за {1}.</translation>
    </message>
    <message>
        <source>How high is a plane at the distance 1, and by how much does the middle move on it?</source>
        <translation>Колико је висока раван на растојању 1, и за колико се средина на њој помера?</translation>
    </message>
    <message>
        <source>Lengths come back, directions do not</source>
        <translation>Дужине се враћају, смерови не</translation>
    </message>
    <message>
        <source>With exact roots, renormalising is worth something: it keeps the lengths to all digits. But nobody remembers where the axes should point to.</source>
        <translation>Са тачним коренима поновно нормирање нешто вреди: чува дужине на све цифре. Али нико не памти куда осе треба да показују.</translation>
    </message>
    <message>
        <source>100 rounds of products alone make an axis too long or too short by 0.043 %. Make that less than 0.000001 %, and leave the rounds and the format as they are.</source>
        <translation>100 кругова само производима чини осу предугачком или прекратком за 0.043 %. Нека то буде мање од 0.000001 %, а кругове и формат оставите какви јесу.</translation>
    </message>
    <message>
        <source>That is another way: it makes the axes afresh from the angle of each frame, and multiplies nothing. Look at *Turned by*: one of the others keeps the products and mends the lengths.</source>
        <translation>То је други начин: осе прави изнова из угла сваког кадра, и ништа не множи. Погледајте *Окретање*: један од осталих начина задржава производе и поправља дужине.</translation>
    </message>
    <message>
        <source>Which way divides each axis by its length, and exactly?</source>
        <translation>Који начин дели сваку осу њеном дужином, и то тачно?</translation>
    </message>
    <message>
        <source>The lengths are right to ten digits. But an axis still leans by 0.0008°: less than before, and not nothing.</source>
        <translation>Дужине су тачне на десет цифара. Али оса се и даље нагиње за 0.0008°: мање него пре, а не нимало.</translation>
    </message>
    <message>
        <source>A step that is too small</source>
        <translation>Премали корак</translation>
    </message>
    <message>
        <source>The eye moves to the right, by 1 mm a frame. A unit is 1 m, and the origin of the coordinates is 50 km away: the eye&apos;s x is 30 000. In **Image** each frame has its own line, from top to bottom: how far P has moved across, beside the smooth path.</source>
        <translation>Камера се помера удесно, за 1 mm по кадру. Јединица је 1 m, а координатни почетак је на 50 km: x позиције камере је 30 000. У приказу **Слика** сваки кадар има свој ред, одозго надоле: колико се P померила попреко, поред глатке путање.</translation>
    </message>
    <message>
        <source>x lies between {0} and {1}. How many millimetres are two neighbouring float32 apart there?</source>
        <translation>x лежи између {0} и {1}. Колико су милиметара тамо размакнута два суседна броја float32?</translation>
    </message>
    <message>
        <source>A float32 has 24 bits, and its numbers lie as far apart as the last of them counts: a power of 2. Look at the frames: P stands still in half of them, not in two of three.</source>
        <translation>float32 има 24 бита, и његови бројеви су размакнути колико вреди последњи од њих: степен броја 2. Погледајте кадрове: P мирује у половини њих, а не у два од три.</translation>
    </message>
    <message>
        <source>The first of 24 bits counts {0} m, the last one {1} m: 1.95 mm. The eye moves by 1 mm, so it stands still in about every second frame.</source>
        <translation>Први од 24 бита вреди {0} m, последњи {1} m: 1.95 mm. Камера се помера за 1 mm, па отприлике у сваком другом кадру мирује.</translation>
    </message>
    <message>
        <source>The first bit counts {0}. What does bit 24 count?</source>
        <translation>Први бит вреди {0}. Колико вреди бит 24?</translation>
    </message>
    <message>
        <source>From the middle of the Earth</source>
        <translation>Од средишта Земље</translation>
    </message>
    <message>
        <source>Maps of the whole Earth measure from its middle, 6 371 km away.</source>
        <translation>Карте целе Земље мере од њеног средишта, на 6 371 km.</translation>
    </message>
    <message>
        <source>The origin moves there. How far does P jump from one frame to the next, at most?</source>
        <translation>Координатни почетак се помера тамо. Колико P највише скочи од једног кадра до следећег?</translation>
    </message>
    <message>
        <source>0.4 pixels, as from 50 km: the eye moves by a millimetre, and both numbers keep 7 digits</source>
        <translation>0.4 пиксела, као са 50 km: камера се помера за милиметар, и оба броја задржавају 7 цифара</translation>
    </message>
    <message>
        <source>The seven digits of 3 822 600 are all before the point. Look at the path: it stands still, and then jumps once.</source>
        <translation>Седам цифара броја 3 822 600 све су пре децималне тачке. Погледајте путању: мирује, па једном скочи.</translation>
    </message>
    <message>
        <source>40 pixels</source>
        <translation>40 пиксела</translation>
    </message>
    <message>
        <source>Not at all: the eye moves by less than the numbers can say</source>
        <translation>Нимало: камера се помера за мање него што бројеви могу да кажу</translation>
    </message>
    <message>
        <source>Too small a step never counts</source>
        <translation>Премали корак се никада не рачуна</translation>
    </message>
    <message>
        <source>The eye is not where it was stored: it goes on, and at some frame another float32 is nearer. Look at the path: there it jumps by all that was missed.</source>
        <translation>Камера није тамо где је сачувана: она иде даље, и у неком кадру ближи је други float32. Погледајте путању: тамо скочи за све што је пропуштено.</translation>
    </message>
    <message>
        <source>Neighbouring float32 are 0.25 m apart there, and 0.25 m at P fill 40 pixels.</source>
        <translation>Суседни бројеви float32 тамо су размакнути 0.25 m, а 0.25 m код P испуњава 40 пиксела.</translation>
    </message>
    <message>
        <source>Subtract first</source>
        <translation>Прво одузмите</translation>
    </message>
    <message>
        <source>What is large is not needed: only the difference of vertex and eye is drawn. If both are measured from the object, or in two floats each, small differences stay small.</source>
        <translation>Оно што је велико није потребно: црта се само разлика темена и позиције камере. Ако се обоје мере од објекта, или свако са два броја у покретном зарезу, мале разлике остају мале.</translation>
    </message>
    <message>
        <source>Make P move smoothly, by less than 0.2 pixels in every frame, with the origin still in the middle of the Earth.</source>
        <translation>Нека се P креће глатко, за мање од 0.2 пиксела у сваком кадру, а координатни почетак нека остане у средишту Земље.</translation>
    </message>
    <message>
        <source>Which coordinates are large without need?</source>
        <translation>Које су координате непотребно велике?</translation>
    </message>
    <message>
        <source>From the object it costs nothing: the same 12 bytes a vertex, and the same one subtraction. Two floats cost twice the bytes and three times the work, and need no object.</source>
        <translation>Од објекта не кошта ништа: истих 12 бајтова по темену, и исто једно одузимање. Два броја коштају двапут више бајтова и трипут више рада, а није им потребан објекат.</translation>
    </message>
    <message>
        <source>Practise: from a lean to pixels</source>
        <translation>Вежба: од нагиба до пиксела</translation>
    </message>
    <message>
        <source>A camera that leans by {0} moves the middle of a picture of {1} pixels by {2} at most.</source>
        <translation>Камера која се нагиње за {0} помера средину слике од {1} пиксела највише за {2}.</translation>
    </message>
    <message>
        <source>Each round adds {0}° to the lean, and the camera goes {1} rounds. The field of view is {2}°, and the picture is 720 pixels high. By how many pixels has its middle moved at most?</source>
        <translation>Сваки круг нагибу дода {0}°, а камера направи кругова {1}. Видно поље је {2}°, а слика је висока 720 пиксела. За колико се пиксела највише померила њена средина?</translation>
    </message>
    <message>
        <source>A round is a round</source>
        <translation>Круг је круг</translation>
    </message>
    <message>
        <source>This is the drift of one round. The next round begins where this one ended, and adds its own. Look at the picture after {0} rounds: the letters are farther apart.</source>
        <translation>Ово је заношење једног круга. Следећи круг почиње где се овај завршио, и додаје своје. Погледајте слику после {0}. круга: слова су размакнутија.</translation>
    </message>
    <message>
        <source>This takes the tangent of the whole field of view. Half the picture belongs to half of the angle. Look at the picture at 90°: it is {0} high at the distance 1; {1} would be infinite.</source>
        <translation>Овде је узет тангенс целог видног поља. Половини слике припада половина угла. Погледајте слику на 90°: на растојању 1 висока је {0}; {1} било би бесконачно.</translation>
    </message>
    <message>
        <source>By how many degrees does it lean after {0} rounds?</source>
        <translation>За колико се степени нагиње после {0}. круга?</translation>
    </message>
    <message>
        <source>At the distance 1 the picture is {0} high, and the middle moves by {1}.</source>
        <translation>На растојању 1 слика је висока {0}, а средина се помера за {1}.</translation>
    </message>
    <message>
        <source>It leans by {0}°, and {1} pixels lie between.</source>
        <translation>Нагиње се за {0}°, а између лежи {1} пиксела.</translation>
    </message>
    <message>
        <source>Practise: from a gap to pixels</source>
        <translation>Вежба: од размака до пиксела</translation>
    </message>
    <message>
        <source>A float32 has 24 bits. Between {0} and {1} its numbers are {2} apart, and an eye that creeps along jumps by that much at a time.</source>
        <translation>float32 има 24 бита. Између {0} и {1} његови бројеви су размакнути {2}, и камера која се полако помера сваки пут скочи за толико.</translation>
    </message>
    <message>
        <source>The eye&apos;s x lies between {0} m and {1} m, which are powers of 2, and it moves along x. By how many pixels does a vertex jump at a time, at the depth {2} m? The picture is 1080 pixels high, with a field of view of 40°.</source>
        <translation>Координата x позиције камере лежи између {0} m и {1} m, а то су степени броја 2; камера се помера дуж x. За колико пиксела теме сваки пут скочи, на дубини {2} m? Слика је висока 1080 пиксела, са видним пољем од 40°.</translation>
    </message>
    <message>
        <source>An eye is off by half a gap</source>
        <translation>Камера одступа за пола размака</translation>
    </message>
    <message>
        <source>Half a gap is how far off the eye is at most, before and after. It goes from one float32 to the next one, by a whole gap. Look at the path: each jump goes from one side of the smooth path to the other.</source>
        <translation>Пола размака је колико камера највише одступа, пре и после. Од једног броја float32 до следећег она иде за цео размак. Погледајте путању: сваки скок иде са једне стране глатке путање на другу.</translation>
    </message>
    <message>
        <source>24 bits are 23 halvings</source>
        <translation>24 бита су 23 преполовљавања</translation>
    </message>
    <message>
        <source>This counts 23 bits. The first bit counts {0}, and from the first to the last it is halved 23 times. Look at the path: its jumps are half as wide.</source>
        <translation>Овде је пребројано 23 бита. Први бит вреди {0}, а од првог до последњег преполови се 23 пута. Погледајте путању: њени скокови су упола ужи.</translation>
    </message>
    <message>
        <source>What does the last of 24 bits count, if the first one counts {0}?</source>
        <translation>Колико вреди последњи од 24 бита, ако први вреди {0}?</translation>
    </message>
    <message>
        <source>At the depth {0} a metre has {1} pixels.</source>
        <translation>На дубини {0} метар има {1} пиксела.</translation>
    </message>
    <message>
        <source>The gap is {0}{1} m, and a metre has {2} pixels.</source>
        <translation>Размак је {0}{1} m, а метар има {2} пиксела.</translation>
    </message>
</context>
<context>
    <name>l27-where-precision-goes</name>
    <message>
        <source>Where does precision go?</source>
        <translation>Куда одлази прецизност?</translation>
    </message>
    <message>
        <source>The floor behind the wall</source>
        <translation>Под иза зида</translation>
    </message>
    <message>
        <source>A logarithmic depth has digits for every distance. Here it is computed at each vertex, as it is cheap there, and the floor from near to far is one piece. In **Image** you see the wall&apos;s foundation, which is below the floor: the floor is drawn behind it. The dock says how far off it is: up to 3.53 times too far.</source>
        <translation>Логаритамска дубина има цифре за свако растојање. Овде се рачуна у сваком темену, јер је тамо јефтина, а под од предње до задње равни је један део. У приказу **Слика** видите темељ зида, који је испод пода: под се црта иза њега. Бочни панел каже колико одступа: до 3.53 пута предалеко.</translation>
    </message>
    <message>
        <source>Far moves from 30 to 1000, and the floor with it, still one piece. Up to how many times too far is it drawn?</source>
        <translation>Задња раван се помера са 30 на 1000, и под са њом, и даље из једног дела. До колико пута предалеко се црта?</translation>
    </message>
    <message>
        <source>Still 3.5 times: that is what a logarithm is for</source>
        <translation>И даље 3.5 пута: томе логаритам и служи</translation>
    </message>
    <message>
        <source>A logarithm would be right at each pixel, whatever far is. Between two vertices it is interpolated, and the error grows with the ratio of their distances. Look at the diagram: the curve stands far above the line in between.</source>
        <translation>Логаритам би био тачан у сваком пикселу, ма каква била задња раван. Између два темена он се интерполира, и грешка расте са односом њихових растојања. Погледајте дијаграм: крива између стоји високо изнад праве.</translation>
    </message>
    <message>
        <source>53.6 times</source>
        <translation>53.6 пута</translation>
    </message>
    <message>
        <source>1.15 times: the digits are spread over a longer range, as evenly as before</source>
        <translation>1.15 пута: цифре су распоређене по дужем опсегу, равномерно као пре</translation>
    </message>
    <message>
        <source>The digits are not the trouble. Between its two ends the floor gets the depth that a straight line has, and the logarithm bends away from it. Look at the diagram: the curve stands far above the line in between.</source>
        <translation>Невоља није у цифрама. Између два краја под добија дубину коју има права, а логаритам се од ње савија. Погледајте дијаграм: крива између стоји високо изнад праве.</translation>
    </message>
    <message>
        <source>Only the two ends of the floor have the right depth. The nearest and the farthest vertex are now 1000 times as far apart as near is from the eye.</source>
        <translation>Исправну дубину имају само два краја пода. Најближе и најдаље теме сада су размакнути 1000 пута више него што је предња раван од камере.</translation>
    </message>
    <message>
        <source>One over w, and log w</source>
        <translation>Реципрочна вредност w, и log w</translation>
    </message>
    <message>
        <source>On the screen {0} is linear along a face. A piece runs from the distance {1} to {2}. At the share {3} of it on the screen,</source>
        <translation>На екрану је {0} дуж стране линеарно. Један део иде од растојања {1} до {2}. На његовом делу {3} на екрану,</translation>
    </message>
    <message>
        <source>Interpolated linearly, the logarithms of {0} and {1} give {2} instead. That is too far by the factor</source>
        <translation>Линеарно интерполирани, логаритми од {0} и {1} уместо тога дају {2}. То је предалеко, а чинилац је</translation>
    </message>
    <message>
        <source>Half-way, that is {0}: with {1}, 2.83.</source>
        <translation>На пола пута то је {0}: са {1}, 2.83.</translation>
    </message>
    <message>
        <source>Near is 1 and far is 100. How many times too far is the floor drawn, half-way along it on the screen?</source>
        <translation>Предња раван је 1, а задња 100. Колико пута предалеко се под црта, на пола пута дуж њега на екрану?</translation>
    </message>
    <message>
        <source>Half-way is half the distance</source>
        <translation>Пола пута је пола растојања</translation>
    </message>
    <message>
        <source>This takes half the distance, 50.5, for the true place. Half-way on the screen is much nearer: there {0} is half-way, and {1}. Look at the diagram: drawn is never nearer than true.</source>
        <translation>Овде је за стварно место узета половина растојања, 50.5. Пола пута на екрану је много ближе: тамо је {0} на пола пута, и {1}. Погледајте дијаграм: нацртано никада није ближе од стварног.</translation>
    </message>
    <message>
        <source>This would be right if {0} were linear on the screen. Only {1} is. Look at the foundation: the floor is drawn behind it.</source>
        <translation>То би било исправно када би {0} на екрану било линеарно. Такво је само {1}. Погледајте темељ: под се црта иза њега.</translation>
    </message>
    <message>
        <source>It is drawn at {0}, and lies at {1}.</source>
        <translation>Црта се на {0}, а лежи на {1}.</translation>
    </message>
    <message>
        <source>Where is it drawn, and where does it lie?</source>
        <translation>Где се црта, а где лежи?</translation>
    </message>
    <message>
        <source>Shorter pieces</source>
        <translation>Краћи делови</translation>
    </message>
    <message>
        <source>The factor depends on the ratio {0} of a piece alone. In {1} pieces of equal length from 1 to 30 the nearest one has {2}, and it is the worst.</source>
        <translation>Чинилац зависи само од односа {0} једног дела. Са {1} делова једнаке дужине од 1 до 30 најближи има {2}, и он је најгори.</translation>
    </message>
    <message>
        <source>Draw the floor nowhere more than 1.2 times too far, and still compute the logarithm at the vertices only.</source>
        <translation>Нека се под нигде не црта више од 1.2 пута предалеко, а логаритам нека се и даље рачуна само у теменима.</translation>
    </message>
    <message>
        <source>What makes the ratio of the nearest piece small?</source>
        <translation>Шта чини однос најближег дела малим?</translation>
    </message>
    <message>
        <source>Move Pieces of the floor to the right.</source>
        <translation>Померите „Делови пода” удесно.</translation>
    </message>
    <message>
        <source>13 pieces are enough here. From 1 to 1000 it takes 419: the near pieces need to be short, and the far ones are shorter than they have to be.</source>
        <translation>Овде је довољно 13 делова. Од 1 до 1000 потребно их је 419: ближи делови морају бити кратки, а даљи су краћи него што морају.</translation>
    </message>
    <message>
        <source>Light through the seam</source>
        <translation>Светлост кроз шав</translation>
    </message>
    <message>
        <source>Two meshes share a seam, vertex by vertex. Each stores its coordinates in 8 bits over its own box: the left one is 10 units wide, the right one 3. A vertex of the seam is rounded twice, to two places, and the light behind comes through.</source>
        <translation>Две мреже деле шав, теме по теме. Свака своје координате чува у 8 бита у сопственом оквиру: лева је широка 10 јединица, десна 3. Теме шава заокружи се двапут, на два места, и светлост иза пролази.</translation>
    </message>
    <message>
        <source>Now 12 bits instead of 8. To how much of it does the largest possible gap shrink?</source>
        <translation>Сада 12 бита уместо 8. На колики свој део се смањи највећи могући процеп?</translation>
    </message>
    <message>
        <source>To 66.7 %</source>
        <translation>На 66.7 %</translation>
    </message>
    <message>
        <source>This counts the bits. Each of them halves both steps, so 4 bits make the gap {0} times as narrow. Look at the seam with 12 bits: it is closed for your eye.</source>
        <translation>Овде су пребројани битови. Сваки од њих преполови оба корака, па 4 бита сузе процеп {0} пута. Погледајте шав са 12 бита: за ваше око је затворен.</translation>
    </message>
    <message>
        <source>To 6.23 %</source>
        <translation>На 6.23 %</translation>
    </message>
    <message>
        <source>To nothing: with 12 bits no error can be seen, so the seam is closed</source>
        <translation>На ништа: са 12 бита ниједна грешка се не види, дакле шав је затворен</translation>
    </message>
    <message>
        <source>It is hardly seen from here, but it is there: 1.3 px at most. From ten times as near it would be 13 px. Look at the seam from nearer by.</source>
        <translation>Одавде се једва види, али постоји: највише 1.3 px. Са десет пута мањег растојања био би 13 px. Погледајте шав изближа.</translation>
    </message>
    <message>
        <source>A step is the box over {0}: with 4 bits more it is 16 times as short.</source>
        <translation>Корак је ширина оквира подељена са {0}: са 4 бита више он је 16 пута краћи.</translation>
    </message>
    <message>
        <source>Half a step, and half a step</source>
        <translation>Пола корака, и пола корака</translation>
    </message>
    <message>
        <source>On a grid of step {0} a coordinate moves by at most {1}, on another of step {2} by {3}. If they move apart, the copies of the vertex are {4} apart along an axis, and {5} across both. With 8 bits {6} and {7}.</source>
        <translation>На решетки корака {0} координата се помери највише за {1}, на другој, корака {2}, за {3}. Ако се размичу, копије темена су размакнуте {4} дуж једне осе, а {5} преко обе. Са 8 бита {6} и {7}.</translation>
    </message>
    <message>
        <source>By how many units are the two copies of a vertex apart at most, along one axis, with 8 bits?</source>
        <translation>За колико јединица су две копије темена највише размакнуте, дуж једне осе, са 8 бита?</translation>
    </message>
    <message>
        <source>Only the coarse one errs</source>
        <translation>Греши само груба</translation>
    </message>
    <message>
        <source>This lets only the larger mesh round. The smaller one rounds, too, and may go the other way. Look at the diagram: some gaps are wider than yours.</source>
        <translation>Овде заокружује само већа мрежа. Заокружује и мања, и може отићи на другу страну. Погледајте дијаграм: неки процепи су шири од вашег.</translation>
    </message>
    <message>
        <source>The gap is the error</source>
        <translation>Размак је грешка</translation>
    </message>
    <message>
        <source>A coordinate goes to the nearer place, so each mesh is off by half a step at most. Look at the diagram: no gap reaches the line.</source>
        <translation>Координата иде на ближе место, па свака мрежа одступа највише за пола корака. Погледајте дијаграм: ниједан процеп не достиже праву.</translation>
    </message>
    <message>
        <source>{0}. From 1.6 units away, a picture of 1080 lines has 585 px a unit: 14.9 px along an axis, and 21.1 px across both.</source>
        <translation>{0}. Са 1.6 јединица слика од 1080 редова има 585 px по јединици: 14.9 px дуж једне осе, а 21.1 px преко обе.</translation>
    </message>
    <message>
        <source>Each copy is off by half of its own step.</source>
        <translation>Свака копија одступа за пола сопственог корака.</translation>
    </message>
    <message>
        <source>More bits make the gap narrower and never close it. What would?</source>
        <translation>Више битова сужава процеп, а никада га не затвара. Шта би га затворило?</translation>
    </message>
    <message>
        <source>Close the seam, and keep the 3 bytes a vertex.</source>
        <translation>Затворите шав, а задржите 3 бајта по темену.</translation>
    </message>
    <message>
        <source>Why does the same vertex come to lie at two places?</source>
        <translation>Зашто исто теме лежи на два места?</translation>
    </message>
    <message>
        <source>Let both meshes round to the same places.</source>
        <translation>Нека обе мреже заокружују на иста места.</translation>
    </message>
    <message>
        <source>A common grid: the same vertex, the same grid, the same place. The smaller mesh pays: the vertices of its seam move more than four times as far as on a grid of its own.</source>
        <translation>Заједничка решетка: исто теме, иста решетка, исто место. Плаћа мања мрежа: темена њеног шава померају се више од четири пута даље него на сопственој решетки.</translation>
    </message>
    <message>
        <source>Back from the picture</source>
        <translation>Назад од слике</translation>
    </message>
    <message>
        <source>A pixel and its depth lead back to the point P: multiply with the inverse of {0}. Everything is float32, and the world&apos;s origin is 1 unit from the eye.</source>
        <translation>Пиксел и његова дубина воде назад до тачке P: помножите инверзом од {0}. Све је float32, а координатни почетак света је 1 јединицу од камере.</translation>
    </message>
    <message>
        <source>The origin moves to 100 000 units from the eye. How far from P is the point that the inverse leads back to?</source>
        <translation>Координатни почетак се помера на 100 000 јединица од камере. Колико је од P тачка до које инверз води назад?</translation>
    </message>
    <message>
        <source>Nowhere: an inverse undoes what the matrix did</source>
        <translation>Нимало: инверз поништава оно што је матрица учинила</translation>
    </message>
    <message>
        <source>On paper it does. Here each product is rounded, and the eye&apos;s coordinates are 100 000: they hide the few units that you are after. Look at P and at the point that came back.</source>
        <translation>На папиру поништава. Овде се сваки производ заокружује, а координате позиције камере су 100 000: скривају оних неколико јединица које тражите. Погледајте P и тачку која се вратила.</translation>
    </message>
    <message>
        <source>By a ten-millionth of its distance: a float32 keeps seven digits</source>
        <translation>За десетомилионити део њеног растојања: float32 задржава седам цифара</translation>
    </message>
    <message>
        <source>The seven digits belong to the coordinates, near 100 000. What is left of P&apos;s distance, 8.3 units, has two. Look at P and at the point that came back.</source>
        <translation>Седам цифара припада координатама, око 100 000. Ономе што је остало од растојања тачке P, 8.3 јединице, припадају две. Погледајте P и тачку која се вратила.</translation>
    </message>
    <message>
        <source>By several per cent of its distance</source>
        <translation>За неколико процената њеног растојања</translation>
    </message>
    <message>
        <source>The inverse multiplies the eye&apos;s coordinates with {0}, a small difference of rounded numbers.</source>
        <translation>Инверз множи координате позиције камере са {0}, малом разликом заокружених бројева.</translation>
    </message>
    <message>
        <source>Bring the point to within 1 % of its distance, in float32 and with the origin where it is.</source>
        <translation>Доведите тачку на највише 1 % њеног растојања, у float32 и са координатним почетком где јесте.</translation>
    </message>
    <message>
        <source>Which way back does not multiply the eye with anything?</source>
        <translation>Који пут назад позицију камере не множи ничим?</translation>
    </message>
    <message>
        <source>Choose *Ray times depth*.</source>
        <translation>Изаберите *Зрак пута дубина*.</translation>
    </message>
    <message>
        <source>The ray is multiplied with the depth, and the eye is added at the end: it is rounded once.</source>
        <translation>Зрак се множи дубином, а позиција камере се додаје на крају: заокружује се једном.</translation>
    </message>
    <message>
        <source>Back to the floor</source>
        <translation>Назад на под</translation>
    </message>
    <message>
        <source>“Logarithmic depth is always better” is tempting: its digits are spread as distances need them. But digits are half of the story. A number is stored at some places, and used at others: depths between the vertices, positions in the grid of another mesh. Precision goes where two ways of rounding meet. Choose *each pixel* and watch the foundation disappear.</source>
        <translation>„Логаритамска дубина је увек боља” је примамљиво: њене цифре су распоређене како растојања траже. Али цифре су пола приче. Број се чува на једним местима, а користи на другим: дубине између темена, положаји у решетки друге мреже. Прецизност одлази тамо где се сусрећу два начина заокруживања. Изаберите *сваки пиксел* и гледајте како темељ нестаје.</translation>
    </message>
    <message>
        <source>Practise: half-way</source>
        <translation>Вежба: пола пута</translation>
    </message>
    <message>
        <source>A floor is one piece from near to far. Its logarithmic depth is computed at the vertices, and between them the rasteriser interpolates it linearly on the screen.</source>
        <translation>Под је од предње до задње равни један део. Његова логаритамска дубина рачуна се у теменима, а између њих је растеризатор на екрану интерполира линеарно.</translation>
    </message>
    <message>
        <source>Near is {0}, far is {1}. Half-way along the floor on the screen: how many times too far is it drawn?</source>
        <translation>Предња раван је {0}, задња {1}. На пола пута дуж пода на екрану: колико пута предалеко се црта?</translation>
    </message>
    <message>
        <source>This takes half the distance for the true place. Half-way on the screen {0} is half-way, and {1} is much nearer. Look at the foundation: the floor is drawn behind it, not before it.</source>
        <translation>Овде је за стварно место узета половина растојања. На пола пута на екрану {0} је на пола пута, и {1} је много ближе. Погледајте темељ: под се црта иза њега, а не испред њега.</translation>
    </message>
    <message>
        <source>It lies at near</source>
        <translation>Лежи на предњој равни</translation>
    </message>
    <message>
        <source>This is where it is drawn, over near. But it lies farther away than near: {0} is half-way between {1} and {2}. Look at the diagram: half-way on the screen is a little to the right of near.</source>
        <translation>Ово је место где се црта, подељено растојањем предње равни. Али под лежи даље од предње равни: {0} је на пола пута између {1} и {2}. Погледајте дијаграм: пола пута на екрану је мало десно од предње равни.</translation>
    </message>
    <message>
        <source>It is drawn at {0}, half-way between the logarithms.</source>
        <translation>Црта се на {0}, на пола пута између логаритама.</translation>
    </message>
    <message>
        <source>It lies at {0}.</source>
        <translation>Лежи на {0}.</translation>
    </message>
    <message>
        <source>Drawn at {0}, it lies at {1}.</source>
        <translation>Нацртан је на {0}, а лежи на {1}.</translation>
    </message>
    <message>
        <source>Practise: the widest gap</source>
        <translation>Вежба: најшири процеп</translation>
    </message>
    <message>
        <source>The field of view is 53.13°: at the distance {0} the picture is exactly {1} units high, so 1080 lines have {2} px a unit.</source>
        <translation>Видно поље је 53.13°: на растојању {0} слика је висока тачно {1} јединица, па 1080 редова има {2} px по јединици.</translation>
    </message>
    <message>
        <source>Two meshes are {0} and {1} units wide and stored in 8 bits, each over its own box. You see the seam from {2} units away. By how many pixels are both copies of a vertex apart at most, across both axes?</source>
        <translation>Ширине двеју мрежа су {0} и {1}, а чувају се у 8 бита, свака у сопственом оквиру. Шав видите са растојања {2}. За колико пиксела су обе копије темена највише размакнуте, преко обе осе?</translation>
    </message>
    <message>
        <source>This lets only the larger mesh round. The smaller one rounds, too, and may go the other way. Look at the seam: both edges are in steps.</source>
        <translation>Овде заокружује само већа мрежа. Заокружује и мања, и може отићи на другу страну. Погледајте шав: обе ивице су степенасте.</translation>
    </message>
    <message>
        <source>A coordinate goes to the nearer place, so each mesh is off by half a step at most. Look at the seam: the gaps are narrower.</source>
        <translation>Координата иде на ближе место, па свака мрежа одступа највише за пола корака. Погледајте шав: процепи су ужи.</translation>
    </message>
    <message>
        <source>One axis is all</source>
        <translation>Једна оса је све</translation>
    </message>
    <message>
        <source>This is the gap along one axis. The vertex is rounded along both, so the widest gap is the diagonal of a square. Look at the seam: copies lie apart across and along it.</source>
        <translation>Ово је процеп дуж једне осе. Теме се заокружује дуж обе, па је најшири процеп дијагонала квадрата. Погледајте шав: копије су размакнуте и попреко и дуж њега.</translation>
    </message>
    <message>
        <source>Half a step of each grid, together, along each axis.</source>
        <translation>Пола корака сваке решетке, заједно, дуж сваке осе.</translation>
    </message>
    <message>
        <source>Two equal errors at right angles make {0} of one.</source>
        <translation>Две једнаке грешке под правим углом чине {0} једне.</translation>
    </message>
    <message>
        <source>{0} units with steps of a 255th, {1} of it across both axes, and {2} px a unit.</source>
        <translation>{0} јединица са корацима од 255. дела, {1} тога преко обе осе, и {2} px по јединици.</translation>
    </message>
</context>
<context>
    <name>talk-000</name>
    <message>
        <source>Normalised coordinates and the perspective projection</source>
        <translation>Нормализоване координате и перспективна пројекција</translation>
    </message>
    <message>
        <source>From similar triangles</source>
        <translation>Из сличности троуглова</translation>
    </message>
    <message>
        <source>A point {0} in front of the camera comes to the plane at the distance {1} from the eye:</source>
        <translation>Тачка {0} испред камере долази на раван на растојању {1} од камере:</translation>
    </message>
    <message>
        <source>P is 5 deep. The plane moves from d = 1 to d = 2. How many times as high is P&apos; now?</source>
        <translation>P је на дубини 5. Раван се помера са d = 1 на d = 2. Колико је пута сада P&apos; више?</translation>
    </message>
    <message>
        <source>The area of the image grows 4 times. Height and width are proportional to d.</source>
        <translation>Површина слике порасте 4 пута. Висина и ширина су сразмерне са d.</translation>
    </message>
    <message>
        <source>Both triangles have a corner at the eye, and P is 5 deep, measured from there.</source>
        <translation>Оба троугла имају теме код камере, и P је на дубини 5, мерено одатле.</translation>
    </message>
    <message>
        <source>World from the side: name the two triangles first, eye to P and eye to P&apos;. Read -z = 5, y = 2 and {0} off the picture. Let the class vote, then let the model move. Afterwards drag Plane distance d down to below 0: the film of a camera obscura, and the image turns over. This was derived earlier in the course; do not stay.</source>
        <translation>Свет са стране: прво именујте два троугла, од камере до P и од камере до P&apos;. Са слике прочитајте -z = 5, y = 2 и {0}. Нека студенти гласају, па нека се модел помери. После тога превуците „Растојање равни d” надоле испод 0: филм камере опскуре, и слика се преокреће. Ово је изведено раније у курсу; не задржавајте се.</translation>
    </message>
    <message>
        <source>The same as a matrix</source>
        <translation>Исто као матрица</translation>
    </message>
    <message>
        <source>{0} goes to {1}, and divided by the last number to {2} (2):</source>
        <translation>{0} иде у {1}, а подељено последњим бројем у {2} (2):</translation>
    </message>
    <message>
        <source>The matrix is in the dock too, with numbers: -1/d = -0.5. Under it P = (2, 2, -5) becomes (2, 2, -5, 2.5). Divide aloud: 0.8, 0.8, -2. Stress that all projection is in the last row, and that -z/d is positive for what is in front. Drag d and watch the one cell that changes.</source>
        <translation>Матрица је и у бочном панелу, са бројевима: -1/d = -0.5. Под њом P = (2, 2, -5) постаје (2, 2, -5, 2.5). Делите наглас: 0.8, 0.8, -2. Нагласите да је цела пројекција у последњој врсти, и да је -z/d позитивно за оно што је испред. Превуците d и гледајте једино поље које се мења.</translation>
    </message>
    <message>
        <source>A and λA are one transformation</source>
        <translation>A и λA су једна трансформација</translation>
    </message>
    <message>
        <source>Multiply every cell by {0}: the last number becomes {1}, and the quotients stay the same (3).</source>
        <translation>Помножите свако поље са {0}: последњи број постаје {1}, а количници остају исти (3).</translation>
    </message>
    <message>
        <source>last row</source>
        <translation>последња врста</translation>
    </message>
    <message>
        <source>of P = (2, 2, −5)</source>
        <translation>од P = (2, 2, −5)</translation>
    </message>
    <message>
        <source>divided</source>
        <translation>подељено</translation>
    </message>
    <message>
        <source>Ask what else can be multiplied: any λ but 0. So the last row may as well be 0 0 -1 0, whatever d is, and w&apos; = -z is the depth itself. In the window -z = 5 stands in the dock, and as a length below the picture. All later matrices of the lecture have this last row.</source>
        <translation>Питајте чиме се још може множити: било којим λ осим 0. Дакле последња врста може бити и 0 0 -1 0, ма колико било d, и w&apos; = -z је сама дубина. У прозору -z = 5 стоји у бочном панелу, а као дужина испод слике. Све касније матрице предавања имају ову последњу врсту.</translation>
    </message>
    <message>
        <source>WebGL: d is the distance to near</source>
        <translation>WebGL: d је растојање предње равни</translation>
    </message>
    <message>
        <source>The scene is projected onto the near plane {0}, so {1} (4). **World** shows the picture on it.</source>
        <translation>Сцена се пројектује на предњу раван {0}, па је {1} (4). **Свет** показује слику на њој.</translation>
    </message>
    <message>
        <source>Show the small F on the near plane in World: same projectors as before, and the plane is one of the walls of the frustum. Drag Near: the picture on the plane grows with it, and so does the plane; in Image nothing changes, until near cuts into the F. Near is a distance and positive; the plane is at {0}.</source>
        <translation>Покажите у свету мало слово F на предњој равни: исти зраци пројекције као пре, а раван је једна од страна зарубљене пирамиде. Превуците „Предња раван”: слика на равни расте са њом, а расте и раван; у приказу „Слика” се ништа не мења док предња раван не засече слово F. Предња раван је растојање и позитивна; сама раван је на {0}.</translation>
    </message>
    <message>
        <source>A segment to [-1, 1]</source>
        <translation>Дуж у [-1, 1]</translation>
    </message>
    <message>
        <source>The orthographic projection drops {0}; only {1} must become {2} (5). Here it is {3}:</source>
        <translation>Ортографска пројекција изоставља {0}; само {1} мора постати {2} (5). Овде је {3}:</translation>
    </message>
    <message>
        <source>Try three values on the board: x = -3 gives -1, x = 5 gives 1, x = 1, the middle, gives 0. Point to the denominators of the two fractions: they differ in sign. In NDC the box has become the cube; the F lies left of the middle, because the axis came to -0.25. Drag Left and Right.</source>
        <translation>Испробајте на табли три вредности: x = -3 даје -1, x = 5 даје 1, x = 1, средина, даје 0. Покажите имениоце двају разломака: разликују се по предзнаку. У NDC је квадар постао коцка; слово F лежи лево од средине, јер је оса дошла у -0.25. Превуците „Лево” и „Десно”.</translation>
    </message>
    <message>
        <source>The same for {0} and {1}</source>
        <translation>Исто за {0} и {1}</translation>
    </message>
    <message>
        <source>Put {0} into (5) and write everything over {1} (6); likewise for {2} (8):</source>
        <translation>Уврстите {0} у (5) и напишите све са имениоцем {1} (6); исто и за {2} (8):</translation>
    </message>
    <message>
        <source>The window moves to [-1, 3]. Which {0} has probe 1, straight ahead?</source>
        <translation>Прозор се помера на [-1, 3]. Које {0} има сонда 1, право испред?</translation>
    </message>
    <message>
        <source>Only in a window that reaches equally far to both sides is the axis in the middle.</source>
        <translation>Оса је у средини само у прозору који на обе стране досеже једнако далеко.</translation>
    </message>
    <message>
        <source>This moves the picture with its window. Look at the window that has moved to the left: only then is probe 1 at {0}.</source>
        <translation>Овде се слика помера са својим прозором. Погледајте прозор померен улево: само тада је сонда 1 у {0}.</translation>
    </message>
    <message>
        <source>{0}, and {1}.</source>
        <translation>{0}, и {1}.</translation>
    </message>
    <message>
        <source>Derive (6) line by line on the board. The trick is to multiply the second fraction by -z/-z, so that all has one denominator: it will be w&apos;. Its sign turns with it. Then the vote: many say +0.5, because the window goes to the right. After it, drag Left and Right and follow probe 1 in Image.</source>
        <translation>Изведите (6) на табли, ред по ред. Трик је помножити други разломак са -z/-z, тако да све има један именилац: то ће бити w&apos;. Са њим се окреће и предзнак. Затим гласање: многи кажу +0.5, јер прозор иде удесно. После тога превуците „Лево” и „Десно” и пратите сонду 1 у приказу „Слика”.</translation>
    </message>
    <message>
        <source>An affine z bends lines</source>
        <translation>Афино z савија праве</translation>
    </message>
    <message>
        <source>With {0} the third homogeneous number would be {1} (9)-(11): no matrix.</source>
        <translation>Са {0} трећи хомогени број био би {1} (9)-(11): то није матрица.</translation>
    </message>
    <message>
        <source>P comes nearer, to a third of Q&apos;s depth. What does {0} make of PQ?</source>
        <translation>P прилази, на трећину дубине тачке Q. Шта {0} прави од PQ?</translation>
    </message>
    <message>
        <source>A straight segment</source>
        <translation>Праву дуж</translation>
    </message>
    <message>
        <source>x and y are divided by {0}, z&apos; is not. Look at the bow between P and Q: only {1} is straight.</source>
        <translation>x и y се деле са {0}, а z&apos; не. Погледајте лук између P и Q: права је само {1}.</translation>
    </message>
    <message>
        <source>A bow</source>
        <translation>Лук</translation>
    </message>
    <message>
        <source>{0} and {1} are divided by {2}, {3} is not.</source>
        <translation>{0} и {1} се деле са {2}, {3} не.</translation>
    </message>
    <message>
        <source>Go through (9), (10), (11): the same point three times, then all times -z. Nothing in the last line but -Az² - Bz is new. NDC shows both: A z + B is the bow, -A - B/z the straight line. After the vote drag P in World. Near and far change the bow too: try Near 0.3.</source>
        <translation>Прођите кроз (9), (10), (11): трипут иста тачка, па све пута -z. У последњем реду ново је само -Az² - Bz. NDC показује обоје: A z + B је лук, -A - B/z права. После гласања превуците P у свету. И предња и задња раван мењају лук: пробајте предњу раван на 0.3.</translation>
    </message>
    <message>
        <source>What the depth buffer does with z</source>
        <translation>Шта бафер дубине ради са z</translation>
    </message>
    <message>
        <source>Between a triangle&apos;s corners {0} is interpolated evenly over the pixels, and the smaller value wins. If lines are bent, or there are too few codes, the wrong surface is drawn.</source>
        <translation>Између темена троугла {0} се равномерно интерполира по пикселима, и побеђује мања вредност. Ако су линије савијене, или је кодова премало, црта се погрешна површ.</translation>
    </message>
    <message>
        <source>Say what goes wrong with a bent line: the value interpolated at a pixel is not the depth of what is there. What is seen here is the other trouble: a buffer of 16 bits, near at 0.01, surface 2 is 0.25 behind surface 1, and 63 % of the pixels are wrong. Ask what helps. Far from 200 to 60: 63 %. Near from 0.01 to 0.1: none. Most values lie just behind near.</source>
        <translation>Реците шта је лоше код савијене линије: вредност интерполирана у пикселу није дубина онога што је тамо. Овде се види друга невоља: бафер од 16 бита, предња раван на 0.01, површ 2 је 0.25 иза површи 1, и 63 % пиксела је погрешно. Питајте шта помаже. Задња раван са 200 на 60: 63 %. Предња раван са 0.01 на 0.1: ниједан. Већина вредности лежи одмах иза предње равни.</translation>
    </message>
    <message>
        <source>Few bits for a vertex</source>
        <translation>Мало битова за теме</translation>
    </message>
    <message>
        <source>With {0} bits over a side {1} a coordinate is off by up to {2}: in pixels the more, the nearer.</source>
        <translation>Са {0} бита на страни {1} координата одступа до {2}: у пикселима тим више што је ближа.</translation>
    </message>
    <message>
        <source>Depths are not the only numbers with few bits. 8 bits a coordinate: 3 bytes a vertex, and up to 0.5 pixels off in a picture of 320 by 240. The arrows are 50 times as long as the errors. Choose 12 and 16 bits: each bit halves the error. Then halve the distance: each error is twice as long. How many bits are enough depends on where you stand; lesson &quot;How many bits does a picture need?&quot;.</source>
        <translation>Дубине нису једини бројеви са мало битова. 8 бита по координати: 3 бајта по темену, и одступање до 0.5 пиксела на слици од 320 пута 240. Стрелице су 50 пута дуже од грешака. Изаберите 12 и 16 бита: сваки бит преполови грешку. Затим преполовите растојање: свака грешка је двапут дужа. Колико је битова довољно, зависи од тога где стојите; лекција „Колико је битова потребно слици?”.</translation>
    </message>
    <message>
        <source>{0} instead</source>
        <translation>Уместо тога {0}</translation>
    </message>
    <message>
        <source>Divided by {0} as well, {1} stays linear in homogeneous coordinates (12). Near must come to -1, far to 1:</source>
        <translation>Пошто се и {1} подели са {0}, оно остаје линеарно у хомогеним координатама (12). Предња раван мора доћи у -1, задња у 1:</translation>
    </message>
    <message>
        <source>Solve the two equations on the board: {0} and {1}. Then NDC: the posts stand 6 apart in World, and crowd towards far in the cube. With near 9 and far 41 the middle of the cube, z&apos; = 0, is at a depth of only 14.8. Order is kept, and lines stay straight; that is all the depth buffer needs.</source>
        <translation>Решите две једначине на табли: {0} и {1}. Затим NDC: стубови у свету стоје на размаку 6, а у коцки се гомилају ка задњој равни. Са предњом равни на 9 и задњом на 41 средина коцке, z&apos; = 0, на дубини је од само 14.8. Редослед је сачуван, и праве остају праве; то је све што је баферу дубине потребно.</translation>
    </message>
    <message>
        <source>The whole matrix</source>
        <translation>Цела матрица</translation>
    </message>
    <message>
        <source>{0}, and the six numbers of the frustum (13):</source>
        <translation>{0}, и шест бројева зарубљене пирамиде (13):</translation>
    </message>
    <message>
        <source>Rows 1 and 2 are (6) and (8), row 3 is (12), row 4 is the division. In World left and right are written at the near plane. Ask for the cells with x from -1 to 3, near 2, far 19: 1 and 0.5 in row 1, -21/17 and -76/17 in row 3. Matrices in the drawer has them, and lights up what a control changes.</source>
        <translation>Врсте 1 и 2 су (6) и (8), врста 3 је (12), врста 4 је дељење. У свету су лево и десно исписани на предњој равни. Тражите поља за x од -1 до 3, предњу раван 2, задњу 19: 1 и 0.5 у врсти 1, -21/17 и -76/17 у врсти 3. Има их панел „Матрице” доле, и у њему засветли оно што контрола мења.</translation>
    </message>
    <message>
        <source>Stretched</source>
        <translation>Растегнуто</translation>
    </message>
    <message>
        <source>The window is {0}, but the canvas {1} is square. (13) does not prevent this: the letter is twice as high as it should be.</source>
        <translation>Прозор је {0}, али је платно {1} квадратно. (13) то не спречава: слово је двапут више него што треба.</translation>
    </message>
    <message>
        <source>NDC knows no proportions: the cube is the cube. The stretching happens where [-1, 1] becomes pixels, by different factors for x and y. For round circles the window must have the proportions of the canvas: {0}.</source>
        <translation>NDC не зна за пропорције: коцка је коцка. Растезање настаје тамо где [-1, 1] постају пиксели, различитим чиниоцима за x и y. Да би кругови били округли, прозор мора имати пропорције платна: {0}.</translation>
    </message>
    <message>
        <source>Variant X: y is adjusted</source>
        <translation>Варијанта X: прилагођава се y</translation>
    </message>
    <message>
        <source>Image changes, the fields stay: Top still says 1, and the program calls the projection with {0} and {1}. Ask why there is a 2 under the fraction: k is put on at both ends. X is what is kept; students often read it as what is changed.</source>
        <translation>„Слика” се мења, поља остају: „Горе” и даље каже 1, а програм пројекцију позива са {0} и {1}. Питајте зашто је под разломком 2: k се додаје на оба краја. X је оно што се задржава; студенти то често читају као оно што се мења.</translation>
    </message>
    <message>
        <source>Variant Y: x is adjusted</source>
        <translation>Варијанта Y: прилагођава се x</translation>
    </message>
    <message>
        <source>Here k is negative: the window becomes narrower, x from -1 to 1, and the F is larger. The last line of the handout has {0} for {1}; it must be {2}. Ask which variant a program should take when a window is made narrower by hand: with X the scene keeps its width, with Y its height.</source>
        <translation>Овде је k негативно: прозор постаје ужи, x од -1 до 1, а слово F је веће. Последњи ред материјала има {0} за {1}; мора бити {2}. Питајте коју варијанту програм треба да узме када се прозор ручно сузи: са X сцена задржава ширину, са Y висину.</translation>
    </message>
</context>
<context>
    <name>talk-001</name>
    <message>
        <source>The synthetic camera</source>
        <translation>Синтетичка камера</translation>
    </message>
    <message>
        <source>Eye, monitor, phone</source>
        <translation>Око, монитор, телефон</translation>
    </message>
    <message>
        <source>How much of the world is in a picture? The eye sees 120°, without the blurred rim. A monitor fills 25° to 30°, a phone 5°.</source>
        <translation>Колики је део света на слици? Око види 120°, без замућеног руба. Монитор испуњава 25° до 30°, телефон 5°.</translation>
    </message>
    <message>
        <source>eye 120°</source>
        <translation>људско око 120°</translation>
    </message>
    <message>
        <source>monitor 30°</source>
        <translation>монитор 30°</translation>
    </message>
    <message>
        <source>phone 5°</source>
        <translation>телефон 5°</translation>
    </message>
    <message>
        <source>A camera takes a 3-D scene and puts it onto film or pixels; the synthetic camera imitates that. The three pictures hold the head at one size: the eye has to go very near, the phone far away. Read the angles under More numbers. Ask which picture looks natural, and from which distance one would have to look at it on the wall.</source>
        <translation>Камера узима 3D сцену и смешта је на филм или у пикселе; синтетичка камера то опонаша. Три слике држе главу на једној величини: око мора прићи врло близу, телефон далеко. Углове прочитајте под „Још бројева”. Питајте која слика изгледа природно, и са ког би се растојања морала гледати на зиду.</translation>
    </message>
    <message>
        <source>The view volume</source>
        <translation>Запремина погледа</translation>
    </message>
    <message>
        <source>Only what lies in a volume is drawn: the eye&apos;s cone, the pyramid round it, or a box, the view from very far away.</source>
        <translation>Црта се само оно што лежи у запремини: у купи ока, у пирамиди око ње, или у квадру, погледу са веома велике удаљености.</translation>
    </message>
    <message>
        <source>Begin with the cone: what an eye sees. Then choose Pyramid under View volume: pictures are rectangles, so the cone is cut off by four planes. Then Box. The letters are test points; grey ones lie outside. Ask before each change which come in and which go. The volume is given by its shape and its place.</source>
        <translation>Почните са купом: оним што види око. Затим под „Запремина погледа” изаберите пирамиду: слике су правоугаоници, па је купа одсечена са четири равни. Затим квадар. Слова су пробне тачке; сива леже изван. Пре сваке промене питајте које улазе, а које излазе. Запремина је одређена обликом и положајем.</translation>
    </message>
    <message>
        <source>In, out, crossing</source>
        <translation>Унутра, изван, на граници</translation>
    </message>
    <message>
        <source>What is wholly outside is dropped. What crosses a plane is cut, plane by plane.</source>
        <translation>Што је цело изван, одбацује се. Што раван пресеца, сече се, раван по раван.</translation>
    </message>
    <message>
        <source>Cards that are whole inside, outside, and crossing. Step the planes on with the slider: near, far, left, right, bottom, top; each adds corners where an edge goes through. Why not pixel by pixel? To leave out whole triangles is cheap, to leave out fragments is dear. In the dock: corners before and after, and how many cards are whole.</source>
        <translation>Картице које су целе унутра, изван, и на граници. Померајте равни клизачем: предња, задња, лева, десна, доња, горња; свака додаје темена где ивица кроз њу пролази. Зашто не пиксел по пиксел? Изоставити целе троуглове је јефтино, изоставити фрагменте је скупо. У бочном панелу: темена пре и после, и колико је картица цело.</translation>
    </message>
    <message>
        <source>What a real camera also has</source>
        <translation>Шта права камера још има</translation>
    </message>
    <message>
        <source>A real camera has a focal distance, and a depth of field in front of it and behind it. The synthetic camera has neither: everything is sharp.</source>
        <translation>Права камера има растојање фокуса и дубину видног поља испред и иза њега. Синтетичка камера нема ни једно ни друго: све је оштро.</translation>
    </message>
    <message>
        <source>The camera&apos;s parameters: position, two vectors, two angles, two planes. A real one has a focal distance and an aperture too. Here a 50-mm lens at f/1, focused at 10 m: sharp from 8.933 to 11.36 m, the outlined post. Drag the focal distance to 5 m and back; then make N 16. Ask from where on everything far is sharp: from the hyperfocal distance.</source>
        <translation>Параметри камере: позиција, два вектора, два угла, две равни. Права има и растојање фокуса и бленду. Овде објектив од 50 mm на f/1, фокусиран на 10 m: оштро од 8.933 до 11.36 m, уоквирени стуб. Превуците растојање фокуса на 5 m и назад; затим поставите N на 16. Питајте одакле је надаље све далеко оштро: од хиперфокалног растојања.</translation>
    </message>
    <message>
        <source>Camera obscura</source>
        <translation>Камера опскура</translation>
    </message>
    <message>
        <source>A dark box with a hole: {0}, upside down. The synthetic camera has its plane in front of the hole.</source>
        <translation>Мрачна кутија са рупом: {0}, наопачке. Синтетичка камера има раван испред рупе.</translation>
    </message>
    <message>
        <source>The F is 5 high, the film 4 behind the hole. The F goes from 9 to 18. How high is its image?</source>
        <translation>Слово F је високо 5, филм је 4 иза рупе. Слово F иде са 9 на 18. Колико је висока његова слика?</translation>
    </message>
    <message>
        <source>This measures from the film, 18 + 4. Both triangles have their corner in the hole. Look at {0} and {1}: both begin there.</source>
        <translation>Овде се мери од филма, 18 + 4. Оба троугла имају теме у рупи. Погледајте {0} и {1}: оба почињу тамо.</translation>
    </message>
    <message>
        <source>1.11, upright</source>
        <translation>1.11, усправно</translation>
    </message>
    <message>
        <source>This is the image in front of the hole. Look at the film behind it: the light has crossed in the hole, so the image is upside down.</source>
        <translation>Ово је слика испред рупе. Погледајте филм иза ње: светлост се у рупи укрстила, па је слика наопачке.</translation>
    </message>
    <message>
        <source>Twice as far, half as high: {0}.</source>
        <translation>Двапут даље, упола ниже: {0}.</translation>
    </message>
    <message>
        <source>Light crosses in the hole, so the picture on the film is upside down and left for right; painters used it. Compare both films: equally large, only the sign differs. Centre of projection is the hole; for us it is the camera&apos;s position P, and the plane is between it and the object. Vote, then show; drag d as well.</source>
        <translation>Светлост се у рупи укршта, па је слика на филму наопачке и са замењеним лево и десно; камеру опскуру су користили сликари. Упоредите оба филма: једнако велики, разликује се само предзнак. Центар пројекције је рупа; за нас је то позиција камере P, а раван је између ње и објекта. Гласајте, па покажите; превуците и d.</translation>
    </message>
    <message>
        <source>Position, look, up</source>
        <translation>Позиција, вектор погледа, вектор нагоре</translation>
    </message>
    <message>
        <source>{0} is the position of the camera, {1} its direction, and {2} says how it is turned about that.</source>
        <translation>{0} је позиција камере, {1} њен смер, а {2} каже како је око њега окренута.</translation>
    </message>
    <message>
        <source>Axes as on the screen: x right, y up, z towards us. look can be any vector, up any that does not lie along it; it need not be at a right angle. Slide Up from view in the panel: the picture stays while up keeps its plane. Bring it near 0 and nudge it by 0.1° to the side: the picture swings. At 0 the camera is refused.</source>
        <translation>Осе као на екрану: x удесно, y нагоре, z ка нама. look може бити било који вектор, up било који који не лежи дуж њега; не мора бити под правим углом. Померајте клизач „Нагоре од погледа” у панелу: слика остаје докле год up задржава своју раван. Доведите га близу 0 и гурните за 0.1° у страну: слика се закрене. На 0 програм камеру не прихвата.</translation>
    </message>
    <message>
        <source>The angles of view</source>
        <translation>Углови видног поља</translation>
    </message>
    <message>
        <source>{0} and {1}, or one of them and the aspect. A narrow angle is almost a parallel view, a wide one exaggerates.</source>
        <translation>{0} и {1}, или један од њих и однос ширине и висине. Узак угао је скоро паралелан поглед, широк преувеличава.</translation>
    </message>
    <message>
        <source>The picture is 16:9 and {0} is 60°. How wide is {1}?</source>
        <translation>Слика је 16:9, а {0} је 60°. Колико је широк {1}?</translation>
    </message>
    <message>
        <source>60°, one angle does for both</source>
        <translation>60°, исти угао важи за оба смера</translation>
    </message>
    <message>
        <source>{0}. From above half of it is written at the eye: 45.75°.</source>
        <translation>{0}. Одозго је код камере исписана половина: 45.75°.</translation>
    </message>
    <message>
        <source>From the side {0} is written at the eye. Vote first; then the world is seen from above, with {1} at the eye and the half width on the far plane, f tan of it. Make the image 720 x 720 under Image and depth range: both angles are 60. A photographer does this when choosing a lens. Keep window and picture at one aspect, or everything is stretched.</source>
        <translation>Са стране је код камере исписан {0}. Прво гласајте; затим се свет види одозго, са {1} код камере и половином ширине на задњој равни, f пута тангенс тог угла. Под „Слика и опсег дубине” поставите слику на 720 x 720: оба угла су 60. То ради фотограф када бира објектив. Држите прозор и слику на истом односу ширине и висине, иначе се све растеже.</translation>
    </message>
    <message>
        <source>29 mm and 105 mm</source>
        <translation>29 mm и 105 mm</translation>
    </message>
    <message>
        <source>With 29 mm from 30 cm and with 105 mm from 108.6 cm the head is equally large. With 105 mm from 360 cm it is 0.30 times as large.</source>
        <translation>Са 29 mm са 30 cm и са 105 mm са 108.6 cm глава је једнако велика. Са 105 mm са 360 cm велика је 0.30 пута толико.</translation>
    </message>
    <message>
        <source>From 30 cm to 108.6 cm, the head kept at its size: what of the background?</source>
        <translation>Са 30 cm на 108.6 cm, уз исту величину главе: шта бива са позадином?</translation>
    </message>
    <message>
        <source>it stays as it was</source>
        <translation>остаје каква је била</translation>
    </message>
    <message>
        <source>it grows, against the head</source>
        <translation>расте у односу на главу</translation>
    </message>
    <message>
        <source>it shrinks, against the head</source>
        <translation>смањује се у односу на главу</translation>
    </message>
    <message>
        <source>From 30 cm it was smaller than it is now: the nearer, the larger the difference.</source>
        <translation>Са 30 cm била је мања него што је сада: што ближе, то је разлика већа.</translation>
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
        <translation>105 mm, увећано 3.3 пута</translation>
    </message>
    <message>
        <source>20 cm behind, it is 0.6 times as large as the head from 30 cm, and 0.84 times from 108.6 cm.</source>
        <translation>20 cm иза главе велика је 0.6 пута колико глава са 30 cm, а 0.84 пута са 108.6 cm.</translation>
    </message>
    <message>
        <source>The lecture&apos;s cat. F over D decides the size: 105/29 times 30 cm is 108.6 cm. Vote, then both pictures are there. C brings &quot;Distance, relative to the preset&quot;: drag it for a dolly zoom, in which nose and ears move against the head. Back at 1 ×, choose 105 mm at 360 cm under Seen by, and untick Enlarge: 0.30 times as large, 129 px. The perspective comes from the distance alone.</source>
        <translation>Мачка из предавања. О величини одлучује F кроз D: 105/29 пута 30 cm је 108.6 cm. Гласајте, па су ту обе слике. C доноси „Растојање у односу на предложак”: превуците га за доли-зум, у коме се нос и уши померају у односу на главу. Када се вратите на 1 ×, изаберите под „Чиме се гледа” 105 mm са 360 cm и искључите „Увећај”: 0.30 пута толико, 129 px. Перспектива потиче само од растојања.</translation>
    </message>
    <message>
        <source>Why near and far?</source>
        <translation>Зашто предња и задња раван?</translation>
    </message>
    <message>
        <source>Four rays run to infinity. Two planes across the axis cut them off, at the distances {0} and {1} from {2}.</source>
        <translation>Четири зрака иду у бесконачност. Две равни попреко на осу их одсецају, на растојањима {0} и {1} од {2}.</translation>
    </message>
    <message>
        <source>Near: what is too close hides all the rest, a speck of dust at the eye; what is behind the camera would come out upside down; and the depth buffer needs it. Far: what is far away costs time, and many parts fall into one pixel. Drag both through the F and see in the image what goes.</source>
        <translation>Предња: оно што је преблизу заклања све остало, као зрно прашине уз око; оно што је иза камере испало би наопачке; а потребна је и баферу дубине. Задња: оно што је далеко кошта време, и много делова пада у један пиксел. Провуците обе кроз слово F и погледајте на слици шта нестаје.</translation>
    </message>
    <message>
        <source>Depth has finitely many steps</source>
        <translation>Дубина има коначно много корака</translation>
    </message>
    <message>
        <source>The nearer the near plane, the more of the depth values are used up just behind it.</source>
        <translation>Што је предња раван ближа, то се више вредности дубине потроши одмах иза ње.</translation>
    </message>
    <message>
        <source>Which of the two cures the stripes?</source>
        <translation>Шта од ово двоје уклања пруге?</translation>
    </message>
    <message>
        <source>near from 0.1 to 1</source>
        <translation>предња раван са 0.1 на 1</translation>
    </message>
    <message>
        <source>far from 100 to 50</source>
        <translation>задња раван са 100 на 50</translation>
    </message>
    <message>
        <source>{0} is small already, so half of far hardly changes {1}. Look at the stripes: they stay.</source>
        <translation>{0} је већ мало, па упола ближа задња раван једва мења {1}. Погледајте пруге: остају.</translation>
    </message>
    <message>
        <source>neither of them</source>
        <translation>ни једно ни друго</translation>
    </message>
    <message>
        <source>One of them has a large effect on the gap, {0}.</source>
        <translation>Једно од тога има велик утицај на размак, {0}.</translation>
    </message>
    <message>
        <source>The gap is proportional to {0}, and {1} is small already.</source>
        <translation>Размак је сразмеран са {0}, а {1} је већ мало.</translation>
    </message>
    <message>
        <source>Two surfaces 0.05 apart, 16 bits. Where both get the same code the hidden one comes through. Vote, then show; afterwards put near back to 0.1 and try far 50: nothing is won. 24 bits do it as well. Rule: near as far out as the scene allows. Do not set near to 0 to be on the safe side.</source>
        <translation>Две површи на размаку 0.05, 16 бита. Где обе добију исти код, пробија скривена. Гласајте, па покажите; после тога вратите предњу раван на 0.1 и пробајте задњу на 50: ништа се не добија. Помаже и 24 бита. Правило: предња раван толико далеко колико сцена дозвољава. Не стављајте је на 0 за сваки случај.</translation>
    </message>
    <message>
        <source>Popping</source>
        <translation>Искакање</translation>
    </message>
    <message>
        <source>As you drive, things appear at the far plane out of nothing. Fog used to hide this; now distant things have fewer vertices, so far can be farther.</source>
        <translation>Док се возите, ствари се на задњој равни појављују ни из чега. Некада је то скривала магла; данас далеке ствари имају мање темена, па задња раван може бити даље.</translation>
    </message>
    <message>
        <source>Play Position and let them look at the end of the avenue: four trees a second. Choose linear fog, end it at 66: 12 per cent of the contrast are left where they pop. Then switch Level of detail on, and move far out: vertices drawn, with and without. Far is a plane, so trees at the side come at the same depth.</source>
        <translation>Пустите „Позиција” и нека студенти гледају крај алеје: четири стабла у секунди. Изаберите линеарну маглу, завршите је на 66: тамо где искачу остаје 12 процената контраста. Затим укључите „Ниво детаљности” и одмакните задњу раван: нацртана темена, са њим и без њега. Задња раван је раван, па дрвеће са стране долази на истој дубини.</translation>
    </message>
    <message>
        <source>The parallel volume</source>
        <translation>Паралелна запремина</translation>
    </message>
    <message>
        <source>Width and height take the place of the angles. Things are drawn equally large at every distance.</source>
        <translation>Место углова заузимају ширина и висина. Ствари се на сваком растојању цртају једнако велике.</translation>
    </message>
    <message>
        <source>Posts of one height, one behind the other. Change the lens to perspective and back. The box is simpler to clip against and to test, and no divide is needed: forget z. That is why the perspective volume is brought into this shape in the end. A box need not be upright: oblique is a parallelepiped.</source>
        <translation>Стубови једне висине, један иза другог. Промените објектив у перспективни и назад. Према квадру је једноставније одсецати и испитивати, и дељење није потребно: заборавите z. Зато се перспективна запремина на крају доводи у тај облик. Не мора бити квадар: код косе пројекције то је паралелепипед.</translation>
    </message>
    <message>
        <source>A camera at (4, 2, 0)</source>
        <translation>Камера у (4, 2, 0)</translation>
    </message>
    <message>
        <source>It looks along {0}. To put it at the origin, looking along {1}, move the world by {2}, then rotate it about {3} by {4}.</source>
        <translation>Гледа дуж {0}. Да дође у координатни почетак и гледа дуж {1}, померите свет за {2}, па га заротирајте око {3} за {4}.</translation>
    </message>
    <message>
        <source>Which is this camera&apos;s {0}?</source>
        <translation>Које је {0} ове камере?</translation>
    </message>
    <message>
        <source>That would be the {0} of a camera that looks along {1}.</source>
        <translation>То би било {0} камере која гледа дуж {1}.</translation>
    </message>
    <message>
        <source>{0} is opposite to the view direction: the third row begins with −1.</source>
        <translation>{0} је супротно смеру погледа: трећа врста почиње са −1.</translation>
    </message>
    <message>
        <source>The camera stays, the world is moved the opposite way: inverse transformations. The F has been put in front of the camera. In Matrices, view from world, press its factors open: rotation times translation, the translation at the right, so it acts first. On View of the strip the eye is the origin. Vote on w before you show it.</source>
        <translation>Камера стоји, а свет се помера супротно: инверзне трансформације. Слово F је стављено испред камере. У панелу „Матрице”, код „камера ← свет”, отворите чиниоце: ротација пута транслација, транслација десно, па делује прва. На станици „Камера” траке камера је у координатном почетку. Гласајте о w пре него што га покажете.</translation>
    </message>
    <message>
        <source>u, v, w</source>
        <translation>u, v, w</translation>
    </message>
    <message>
        <source>{0}, {1} is {2} without its component along {3}, normalised, and {4}.</source>
        <translation>{0}, {1} је {2} без своје компоненте дуж {3}, нормирано, а {4}.</translation>
    </message>
    <message>
        <source>Camera frame builds it step by step: w, u, v. The program takes u from up cross w first and v from w cross u; it is the same v as the lecture&apos;s: up minus its projection on w, normed. R has u, v, w as columns; the camera is moved by the inverse, and that is the transpose: u, v, w as rows.</source>
        <translation>„Координатни систем камере” гради га корак по корак: w, u, v. Програм прво узима u као up × w, па v као w × u; то је исто v као у предавању: up минус његова пројекција на w, нормирано. R има u, v, w као колоне; камера се помера инверзом, а то је транспонована матрица: u, v, w као врсте.</translation>
    </message>
    <message>
        <source>A, B, C and the canonical pyramid</source>
        <translation>A, B, C и стандардна пирамида</translation>
    </message>
    <message>
        <source>{0}, {1}, {2} go to {3}, {4}, {5}.</source>
        <translation>{0}, {1}, {2} иду у {3}, {4}, {5}.</translation>
    </message>
    <message>
        <source>{0}, {1}: where is near in the pyramid?</source>
        <translation>{0}, {1}: где је предња раван у пирамиди?</translation>
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
        <translation>Тада би била у позицији камере. У 0 долази у следећем кораку, у квадру.</translation>
    </message>
    <message>
        <source>All is divided by {0}.</source>
        <translation>Све се дели са {0}.</translation>
    </message>
    <message>
        <source>An affine transformation is fixed by four points: P, A, B, C. Here f = 10, {0} is 0.8 and {1} is 0.45, so B is 8 to the side and C 4.5 up. {2} = scale, rotation, translation: move P to the origin, turn u, v, w onto x, y, z, divide by f tan, f tan, f. The slide has the scale alone, for the view matrix has turned and moved before. Vote on the near plane, then the pyramid comes: distances along every ray from P are divided by f, too. Show the formulas in Matrices.</source>
        <translation>Афину трансформацију одређују четири тачке: P, A, B, C. Овде је f = 10, {0} је 0.8, а {1} је 0.45, па је B 8 у страну, а C 4.5 нагоре. {2} = скалирање, ротација, транслација: померите P у координатни почетак, окрените u, v, w на x, y, z, поделите са f tan, f tan, f. На слајду је само скалирање, јер је матрица погледа пре тога окренула и померила. Гласајте о предњој равни, па долази пирамида: и растојања дуж сваког зрака из P деле се са f. Покажите формуле у панелу „Матрице”.</translation>
    </message>
    <message>
        <source>From pyramid to box to cube</source>
        <translation>Од пирамиде преко квадра до коцке</translation>
    </message>
    <message>
        <source>{0} opens the pyramid between {1} and {2}, {3} brings {4} to {5}: {6}.</source>
        <translation>{0} отвара пирамиду између {1} и {2}, {3} доводи {4} у {5}: {6}.</translation>
    </message>
    <message>
        <source>Drag the strip slowly from Pyramid to Box: the rays to the origin turn into parallels to z, the order of depths is kept, straight lines stay straight. Check a corner: (-c, -c, c) goes to (1, 1, 0). Then NDC: {0} for OpenGL. Here w is 1 at far. Matrices multiplies by f, so that w is the distance and the product is the usual projection matrix; the picture is the same. Now clipping is against x, y, z = 1 and -1, for every camera.</source>
        <translation>Полако вуците траку од станице „Пирамида” до станице „Квадар”: зраци ка координатном почетку постају паралелни са z, редослед дубина је сачуван, праве остају праве. Проверите једно теме: (-c, -c, c) иде у (1, 1, 0). Затим NDC: {0} за OpenGL. Овде је w једнако 1 на задњој равни. „Матрице” множе са f, тако да је w растојање, а производ уобичајена матрица пројекције; слика је иста. Сада се одсеца према x, y, z = 1 и -1, за сваку камеру.</translation>
    </message>
</context>
<context>
    <name>talk-002</name>
    <message>
        <source>Projections, from the box to the shadow</source>
        <translation>Пројекције, од квадра до сенке</translation>
    </message>
    <message>
        <source>Planar projections</source>
        <translation>Равнинске пројекције</translation>
    </message>
    <message>
        <source>A planar geometric projection takes points of space to a plane along straight lines. The lines are parallel, or they meet in one point.</source>
        <translation>Равнинска геометријска пројекција преноси тачке простора на раван дуж правих. Праве су паралелне, или се секу у једној тачки.</translation>
    </message>
    <message>
        <source>A projection can be anything: in linear algebra a map with no inverse, in geography the making of a map. Here it is a plane and straight lines. Walk through the tree from left to right and click each kind: cavalier, isometric, 2-point. Its box is framed and shows a cube in that projection. The sentence below the tree gives the condition for that kind. Ask which kinds keep equal lengths equal: the parallel ones.</source>
        <translation>Пројекција може бити свашта: у линеарној алгебри пресликавање без инверза, у географији израда карте. Овде су то раван и праве. Прођите кроз стабло слева надесно и кликните на сваку врсту: кавалјер, изометрија, 2 недогледа. Њен оквир се истакне и приказује коцку у тој пројекцији. Реченица испод стабла даје услов за ту врсту. Питајте које врсте једнаким дужинама чувају једнакост: паралелне.</translation>
    </message>
    <message>
        <source>Orthographic: drop z</source>
        <translation>Ортографска: изоставите z</translation>
    </message>
    <message>
        <source>{0}. The screen is not infinite, so a clipping box bounds what is drawn.</source>
        <translation>{0}. Екран није бесконачан, па квадар одсецања ограничава оно што се црта.</translation>
    </message>
    <message>
        <source>Of two equally high posts one is twice as far away as the other. How high does a box draw the far one, relative to the near one?</source>
        <translation>Од два једнако висока стуба један је двапут даље од другог. Колико високо квадар црта даљи, у односу на ближи?</translation>
    </message>
    <message>
        <source>1, equally high</source>
        <translation>1, једнако високо</translation>
    </message>
    <message>
        <source>0.5, half as high</source>
        <translation>0.5, упола ниже</translation>
    </message>
    <message>
        <source>The projectors are parallel: x and y do not depend on z.</source>
        <translation>Зраци пројекције су паралелни: x и y не зависе од z.</translation>
    </message>
    <message>
        <source>Start with the box and name its six planes: left, right, top, bottom, near, far. Go back to the pyramid once by the scene&apos;s View volume, and let the class say which test points come and go: B has room in the box, C has not. Then the question, by show of hands. The posts are drawn equally high; their numbers say which is which. Change Near and Far: what is cut changes, no size does.</source>
        <translation>Почните са квадром и именујте његових шест равни: лева, десна, горња, доња, предња, задња. Вратите се једном на пирамиду помоћу „Запремина погледа” у сцени, и нека студенти кажу које пробне тачке долазе, а које одлазе: B има места у квадру, C нема. Затим питање, дизањем руку. Стубови се цртају једнако високи; бројеви кажу који је који. Промените „Предња раван” и „Задња раван”: мења се оно што се одсеца, а ниједна величина.</translation>
    </message>
    <message>
        <source>Normalised: the matrix of the box</source>
        <translation>Нормализовано: матрица квадра</translation>
    </message>
    <message>
        <source>The clipping box becomes {0}. z is kept, because it decides what hides what.</source>
        <translation>Квадар одсецања постаје {0}. z се задржава, јер одлучује шта шта заклања.</translation>
    </message>
    <message>
        <source>Write {0} on the board: move the middle to 0, then scale. Switch the cells of Matrices to Formulas: the product has both terms. {1} and {2} are negative in this lecture, and z&apos; is 1 at near. Where is the middle of the box? At {3}, so the F is left of the middle. The points come to the screen by {4}.</source>
        <translation>Напишите {0} на табли: померите средину у 0, па скалирајте. У панелу „Матрице” пребаците „Поља” на „Формуле”: производ има оба члана. {1} и {2} су у овом предавању негативни, а z&apos; је на предњој равни 1. Где је средина квадра? У {3}, па је слово F лево од средине. Тачке на екран долазе са {4}.</translation>
    </message>
    <message>
        <source>Slanted projectors: H</source>
        <translation>Коси зраци пројекције: H</translation>
    </message>
    <message>
        <source>{0}. From the side it is the same with {1} and {2}: {3}.</source>
        <translation>{0}. Са стране је исто, са {1} и {2}: {3}.</translation>
    </message>
    <message>
        <source>From above: the camera is left, near is the line at 5, and thin lines are the projectors. A corner at x is drawn at x&apos;. They are parallel, but they meet the near plane at {0}: a unit behind it lands a unit farther along u. A shear does that, H; points of the near plane stay. Turn α: at 90° the projectors are at a right angle to near. At 90° for both angles, H is 1 and the drawing orthographic.</source>
        <translation>Одозго: камера је лево, предња раван је линија на 5, а танке линије су зраци пројекције. Теме у x црта се у x&apos;. Паралелни су, али предњу раван секу под {0}: јединица иза ње пада за јединицу даље дуж u. То ради смицање, H; тачке предње равни остају. Мењајте α: на 90° зраци су управни на предњу раван. На 90° за оба угла H је 1, а цртеж ортографски.</translation>
    </message>
    <message>
        <source>The slanted box made straight</source>
        <translation>Исправљени коси паралелепипед</translation>
    </message>
    <message>
        <source>{0} makes the clipping box straight and shears the object; its image stays. The rest is known: {1}.</source>
        <translation>{0} исправља запремину одсецања, а објекат смиче; његова слика остаје. Остало је познато: {1}.</translation>
    </message>
    <message>
        <source>A cavalier&apos;s projectors meet the picture at 45°. At which angle do those of a cabinet drawing, scale 1/2?</source>
        <translation>Зраци пројекције цртежа кавалјер секу слику под 45°. Под којим углом је секу зраци цртежа кабинет, размера 1/2?</translation>
    </message>
    <message>
        <source>The cotangent of the angle is the scale: {0}.</source>
        <translation>Котангенс угла је размера: {0}.</translation>
    </message>
    <message>
        <source>World from above has the slanted box with a cube in it. After H and {0} the box is the NDC cube, and the object is sheared. Which faces keep their shape? Those parallel to the picture. Then vote, and show. Open Matrices: H, {1} and their product stand side by side. Read from right to left: H first, which knows the slant alone, then {2}, which knows the box alone. In OpenGL it is glOrtho and one more matrix, multiplied from the right.</source>
        <translation>Свет одозго има коси паралелепипед са коцком у њему. После H и {0} паралелепипед је NDC коцка, а објекат је смакнут. Које стране задржавају облик? Оне паралелне слици. Затим гласајте, и покажите. Отворите „Матрице”: H, {1} и њихов производ стоје један поред другог. Читајте здесна налево: прво H, која познаје само косину, па {2}, која познаје само квадар. У OpenGL то је glOrtho и још једна матрица, помножена здесна.</translation>
    </message>
    <message>
        <source>Homogeneous coordinates</source>
        <translation>Хомогене координате</translation>
    </message>
    <message>
        <source>{0} is the point {1}. With {2} it is not a point of space but a point at infinity.</source>
        <translation>{0} је тачка {1}. Са {2} то није тачка простора, него бесконачно далека тачка.</translation>
    </message>
    <message>
        <source>Until now w was 1 all the time. One point of space has infinitely many rows {0}: a line through the origin. Drag t towards 1: P runs along its edge, w goes to 0, and its image comes to rest in {1}. At 1 there is no longer a point of space, but there is still an image. Go on beyond 1: P comes from the other side. This is what makes perspective a matrix.</source>
        <translation>Досад је w све време било 1. Једна тачка простора има бесконачно много врста {0}: праву кроз координатни почетак. Превуците t ка 1: P иде дуж своје ивице, w тежи 0, а њена слика се смирује у {1}. На 1 више нема тачке простора, али слика и даље постоји. Идите преко 1: P долази са друге стране. То је оно што перспективу чини матрицом.</translation>
    </message>
    <message>
        <source>Camera obscura, and ours</source>
        <translation>Камера опскура, и наша</translation>
    </message>
    <message>
        <source>The film is behind a hole, so the image is upside down. We put the plane in front of the centre of projection.</source>
        <translation>Филм је иза рупе, па је слика наопачке. Ми раван стављамо испред центра пројекције.</translation>
    </message>
    <message>
        <source>Follow the line from the top of the F through the hole: it comes to the film below. A real camera has a lens there, and the same geometry. Ours has the plane in front of the centre: same size, upright. Move the film: the height goes with it. Read both heights below the scene&apos;s controls: equal but for the sign.</source>
        <translation>Пратите праву од врха слова F кроз рупу: она стиже на филм доле. Права камера тамо има сочиво, а геометрија је иста. Наша има раван испред центра: иста величина, усправно. Померајте филм: висина иде са њим. Прочитајте обе висине испод контрола сцене: једнаке су до на предзнак.</translation>
    </message>
    <message>
        <source>Onto the plane {0}</source>
        <translation>На раван {0}</translation>
    </message>
    <message>
        <source>{0} with {1}: two triangles share the corner at the eye. As a row: {2}.</source>
        <translation>{0} са {1}: два троугла деле теме код камере. Као врста: {2}.</translation>
    </message>
    <message>
        <source>The two triangles of the side view: eye to the plane, eye to P. Both heights over both lengths. The lecture writes {0} for {1}, from above; from the side it is {2}. The plane is drawn with its distance d; here {3}, so {4} is positive in front. A 3 by 3 matrix cannot divide by z. Four coordinates can: the last row writes {5} into w, and the dividing comes afterwards. Move d behind the eye: camera obscura again.</source>
        <translation>Два троугла погледа са стране: од камере до равни, од камере до P. Обе висине поделите обема дужинама. Предавање пише {0} за {1}, одозго; са стране је то {2}. Раван је нацртана са својим растојањем d; овде је {3}, па је {4} испред позитивно. Матрица 3 пута 3 не може да дели са z. Четири координате могу: последња врста уписује {5} у w, а дељење долази после. Померите d иза камере: опет камера опскура.</translation>
    </message>
    <message>
        <source>Frustum to cube</source>
        <translation>Од зарубљене пирамиде до коцке</translation>
    </message>
    <message>
        <source>The visible part of space is now a frustum. It must become the same cube as before.</source>
        <translation>Видљиви део простора сада је зарубљена пирамида. Мора постати иста коцка као пре.</translation>
    </message>
    <message>
        <source>The trick of the box once more: make it the cube, then leave z out. Let the strip run, slowly, from View over Pyramid and Box to NDC, and back. Ask what has become of straight lines: they are straight at every place of the strip. What has become of the F? The part nearer to the eye has grown. For x and y that is easily said: after dividing, the window is scaled to −1 to 1. z is the problem.</source>
        <translation>Још једном трик са квадром: направите од ње коцку, па изоставите z. Пустите траку да полако иде од станице „Камера” преко станица „Пирамида” и „Квадар” до NDC, и назад. Питајте шта је било са правама: остају праве на сваком месту траке. А са словом F? Део ближи камери је порастао. За x и y се то лако каже: после дељења прозор се скалира на −1 до 1. Невоља је z.</translation>
    </message>
    <message>
        <source>What becomes of z?</source>
        <translation>Шта бива са z?</translation>
    </message>
    <message>
        <source>x and y are divided by z. May we simply keep z, only scaled and shifted?</source>
        <translation>x и y се деле са z. Смемо ли z једноставно да задржимо, само скалирано и померено?</translation>
    </message>
    <message>
        <source>x and y are divided, {0}. What is PQ in the cube?</source>
        <translation>x и y се деле, {0}. Шта је PQ у коцки?</translation>
    </message>
    <message>
        <source>Straight: every step keeps lines</source>
        <translation>Права дуж: сваки корак чува праве</translation>
    </message>
    <message>
        <source>x and y are divided by z, z&apos; is not: that step keeps no lines. Look at the bow between P and Q.</source>
        <translation>x и y се деле са z, а z&apos; не: тај корак не чува праве. Погледајте лук између P и Q.</translation>
    </message>
    <message>
        <source>Bent</source>
        <translation>Савијена дуж</translation>
    </message>
    <message>
        <source>Only with {0} do all three change with 1/z.</source>
        <translation>Само са {0} све три се мењају са 1/z.</translation>
    </message>
    <message>
        <source>Let them vote before the cube is seen. Then show: the bow, its chord, and the deviation in per cent of the length. The straight line beside it is A + B/z. Drag P towards the eye and the bow grows. Why does it matter? What lies between the ends is interpolated, and lines are clipped as lines. With B &lt; 0 the order of depth is kept in this lecture&apos;s signs. Near is 1, far is −1: two equations for A and B.</source>
        <translation>Нека гласају пре него што се види коцка. Затим покажите: лук, његову тетиву, и одступање у процентима дужине. Права поред њега је A + B/z. Превуците P ка камери, и лук расте. Зашто је то важно? Оно што лежи између крајева интерполира се, и праве се одсецају као праве. Са B &lt; 0 редослед дубина је сачуван у предзнацима овог предавања. Предња раван је 1, задња −1: две једначине за A и B.</translation>
    </message>
    <message>
        <source>The matrix of perspective</source>
        <translation>Матрица перспективе</translation>
    </message>
    <message>
        <source>{0}, and the last row is {1}.</source>
        <translation>{0}, а последња врста је {1}.</translation>
    </message>
    <message>
        <source>{0} is linear: a matrix. So it keeps lines. In Matrices look at clip ← view in Formulas: in these letters w is z, negative in front of the eye. OpenGL&apos;s matrix is this one times −1 with z&apos; reversed, since there the planes are positive distances. Numbers: {1}, {2}, {3}.</source>
        <translation>{0} је линеарно: матрица. Зато чува праве. У панелу „Матрице” погледајте „одсецање ← камера” са избором „Формуле”: у овим словима w је z, негативно испред камере. Матрица у OpenGL је ова пута −1, са обрнутим z&apos;, јер су тамо равни позитивна растојања. Бројеви: {1}, {2}, {3}.</translation>
    </message>
    <message>
        <source>A window off the axis</source>
        <translation>Прозор ван осе</translation>
    </message>
    <message>
        <source>The window is not in the middle: {0} makes the slanted frustum straight first.</source>
        <translation>Прозор није у средини: {0} прво исправља накошену зарубљену пирамиду.</translation>
    </message>
    <message>
        <source>A wall of screens, or an eye beside the middle of its screen. Drag &quot;Eye right of the middle&quot;: the picture on the window stays right for that eye. H again, with cotangents from the window&apos;s middle. A slip of the lecture: with w = z the third column has a minus, {0}. Check it with the point in the window&apos;s middle, which must come to x&apos; = 0. glFrustum takes six numbers, gluPerspective four.</source>
        <translation>Зид од екрана, или камера поред средине свог екрана. Превуците „Камера десно од средине”: слика на прозору остаје исправна из те позиције. Опет H, са котангенсима од средине прозора. Омашка у предавању: са w = z трећа колона има минус, {0}. Проверите на тачки у средини прозора, која мора доћи у x&apos; = 0. glFrustum прима шест бројева, gluPerspective четири.</translation>
    </message>
    <message>
        <source>Field of view</source>
        <translation>Видно поље</translation>
    </message>
    <message>
        <source>30° is a common angle. A wide angle draws near things much larger than far ones; a narrow angle is close to an orthographic picture.</source>
        <translation>30° је уобичајен угао. Широк угао црта ближе ствари много веће од даљих; узак је близак ортографској слици.</translation>
    </message>
    <message>
        <source>Three cameras, each as far away as it must be for the same size of the F: 95°, 30°, 7.5°. The first is what the lecture calls fish-eye, the last is nearly orthographic: look at the upright edges and at the top. Sizes are proportional to the tangent of half the angle. The angle alone only enlarges; the distance changes the perspective.</source>
        <translation>Три камере, свака онолико далеко колико мора за исту величину слова F: 95°, 30°, 7.5°. Прва је оно што предавање зове рибље око, последња је скоро ортографска: погледајте усправне ивице и врх. Величине су сразмерне тангенсу половине угла. Сам угао само увећава; растојање мења перспективу.</translation>
    </message>
    <message>
        <source>Divide, then pixels</source>
        <translation>Поделите, па у пикселе</translation>
    </message>
    <message>
        <source>{0}, then {1}</source>
        <translation>{0}, па {1}</translation>
    </message>
    <message>
        <source>One point through all stages, row by row: world, view, clip, the divide, NDC, pixels. Width and height are the screen&apos;s, in pixels; the lecture writes w and h, but w is the fourth coordinate here. The screen&apos;s origin is the upper left corner, hence 1 - y. Drag point 1 in the picture to the upper left corner and read its row NDC: −1 and 1. That was the transform of the vertices; clipping and rasterising come after it.</source>
        <translation>Једна тачка кроз све фазе, ред по ред: свет, камера, одсецање, дељење, NDC, пиксели. Ширина и висина су од екрана, у пикселима; предавање пише w и h, али w је овде четврта координата. Координатни почетак екрана је горњи леви угао, отуда 1 - y. Превуците тачку 1 на слици у горњи леви угао и прочитајте њен ред NDC: −1 и 1. То је била трансформација темена; одсецање и растеризација долазе после ње.</translation>
    </message>
    <message>
        <source>Halfway in the picture</source>
        <translation>Пола пута на слици</translation>
    </message>
    <message>
        <source>Linear on the screen is not linear in the world: {0}</source>
        <translation>Линеарно на екрану није линеарно у свету: {0}</translation>
    </message>
    <message>
        <source>The same board twice: once texture coordinates are interpolated as they are, once a/z and 1/z are, and then divided. Where is the middle of an edge whose ends are 2 and 8 away? A fifth of the way, seen from the near end. Colours forgive it, textures do not. Divide the board into more parts: the error goes down with their size, which is how old games hid it.</source>
        <translation>Иста табла двапут: једном се координате текстуре интерполирају какве јесу, једном a/z и 1/z, па се деле. Где је средина ивице чији су крајеви на 2 и 8? На петини пута, гледано од ближег краја. Боје то опраштају, текстуре не. Поделите таблу на више делова: грешка опада са њиховом величином, а тако су је старе игре скривале.</translation>
    </message>
    <message>
        <source>What a console of 1994 saved</source>
        <translation>Шта је уштедела конзола из 1994</translation>
    </message>
    <message>
        <source>Whole pixels for the vertices, no divide for the texture: quick, and seen at once.</source>
        <translation>Цели пиксели за темена, без дељења за текстуру: брзо, и одмах се види.</translation>
    </message>
    <message>
        <source>The picture called cheap: vertices at whole pixels, 1/w from a small table, a/z replaced by a. The arrows run from where a vertex belongs to where it is drawn, 20 times as long. Turn the camera slowly with Azimuth: the vertices jump, and the checks bend at each square&apos;s diagonal. The other picture is exact. No vertex is farther off than half a pixel across and half a pixel down; what is seen is that neighbours jump at different moments.</source>
        <translation>Слика названа „јефтино”: темена на целим пикселима, 1/w из мале табеле, a/z замењено са a. Стрелице иду од места где темену припада да буде до места где је нацртано, 20 пута дуже. Полако окрећите камеру помоћу „Азимут”: темена скачу, а шаховница се прелама на дијагонали сваког квадрата. Друга слика је тачна. Ниједно теме не одступа више од пола пиксела у ширину и пола пиксела у висину; види се то што суседи скачу у различитим тренуцима.</translation>
    </message>
    <message>
        <source>Shadows</source>
        <translation>Сенке</translation>
    </message>
    <message>
        <source>A shadow is a projection from the lamp onto the ground: a matrix {0}, and {1}. Draw the object once more under it, in black.</source>
        <translation>Сенка је пројекција из лампе на тло: матрица {0}, и {1}. Нацртајте објекат под њом још једном, црном бојом.</translation>
    </message>
    <message>
        <source>The lamp is the centre of projection, the ground is the plane. No depth has to be kept, so the simplest matrix will do: More numbers has S. Draw the ground, draw the object, then in black the object under S. Drag the lamp lower, then choose Sun: the projection becomes a parallel one, w = 1. Close: orthographic, oblique and perspective are all matrices in homogeneous coordinates. Next time: clipping and hidden faces.</source>
        <translation>Лампа је центар пројекције, тло је раван. Дубину не треба чувати, па је довољна најједноставнија матрица: S је под „Још бројева”. Нацртајте тло, нацртајте објекат, па црном бојом објекат под S. Превуците лампу ниже, затим изаберите „Сунце”: пројекција постаје паралелна, w = 1. За крај: ортографска, коса и перспективна све су матрице у хомогеним координатама. Следећи пут: одсецање и скривене стране.</translation>
    </message>
</context>
<context>
    <name>talk-003</name>
    <message>
        <source>Coordinate systems and transformations</source>
        <translation>Координатни системи и трансформације</translation>
    </message>
    <message>
        <source>Three spaces</source>
        <translation>Три простора</translation>
    </message>
    <message>
        <source>Object space is where a thing is made, world space where it is placed, camera space where it is seen from.</source>
        <translation>Координатни систем објекта је где се предмет прави, координатни систем света где се распоређује, а координатни систем камере одакле се посматра.</translation>
    </message>
    <message>
        <source>World: the grid&apos;s middle is the world&apos;s origin; the small axes at the F are its own, moved by 3 along x and -1 along z, and turned about y; u, v, n at the eye are the camera&apos;s. Each of the three questions, making, placing, looking, has a space of its own, so that each can be answered without the others. All three are right-handed. Take the F by its own origin and move it.</source>
        <translation>Свет: средина решетке је координатни почетак света; мале осе код слова F су његове сопствене, померене за 3 дуж x и за -1 дуж z, и окренуте око y; u, v, n код камере припадају камери. Свако од три питања, прављење, распоређивање, посматрање, има свој координатни систем, да би се на свако могло одговорити без осталих. Сва три су десна. Ухватите слово F за његов координатни почетак и померите га.</translation>
    </message>
    <message>
        <source>Columns are axes</source>
        <translation>Колоне су осе</translation>
    </message>
    <message>
        <source>Columns 1 to 3 of {0} are the object&apos;s axes, as the world sees them; column 4 is its origin:</source>
        <translation>Колоне 1 до 3 матрице {0} су осе објекта како их види свет; колона 4 је његов координатни почетак:</translation>
    </message>
    <message>
        <source>The object is turned by 90° about z, then moved by 3 along x. How high in y is its point (1, 0, 0) then?</source>
        <translation>Објекат је окренут за 90° око z, па померен за 3 дуж x. Колико је тада по y висока његова тачка (1, 0, 0)?</translation>
    </message>
    <message>
        <source>The move does not raise it, but the rotation takes x to y.</source>
        <translation>Помак је не подиже, али ротација преводи x у y.</translation>
    </message>
    <message>
        <source>Column 1 is (0, 1, 0), column 4 is (3, 0, 0), and together they are (3, 1, 0).</source>
        <translation>Колона 1 је (0, 1, 0), колона 4 је (3, 0, 0), а заједно су (3, 1, 0).</translation>
    </message>
    <message>
        <source>Row x of the product is the sum on the board: how far each object axis reaches along the world&apos;s x, times the coordinate. Read by columns it says more: column 1 is where the object&apos;s x axis points. After the vote open Matrices and go over the columns of world ← object; the axis lights up in World. Then turn the object by hand, by its ring.</source>
        <translation>Врста x производа је збир са табле: колико свака оса објекта досеже дуж осе x света, пута координата. Читана по колонама каже више: колона 1 је куда показује оса x објекта. После гласања отворите „Матрице” и прођите колоне матрице „свет ← објекат”; у приказу „Свет” засветли оса. Затим окрените објекат ручно, за његов прстен.</translation>
    </message>
    <message>
        <source>From the object to the camera</source>
        <translation>Од објекта до камере</translation>
    </message>
    <message>
        <source>Each factor leads from one space to the next: the strip stops at *Object*, *Ry*, *World* and *View*.</source>
        <translation>Сваки чинилац води из једног координатног система у следећи: трака има станице *Објекат*, *Ry*, *Свет* и *Камера*.</translation>
    </message>
    <message>
        <source>Exchange the two matrices: {0}. Where is the letter then?</source>
        <translation>Замените места тим двема матрицама: {0}. Где је тада слово?</translation>
    </message>
    <message>
        <source>Elsewhere: it is turned and moved along the camera&apos;s axes</source>
        <translation>Другде: окренуто је и померено дуж оса камере</translation>
    </message>
    <message>
        <source>In the same place</source>
        <translation>На истом месту</translation>
    </message>
    <message>
        <source>In the same place, but seen from elsewhere</source>
        <translation>На истом месту, али гледано са другог места</translation>
    </message>
    <message>
        <source>Both the place and the view have changed. The letter is turned about the eye and moved along u.</source>
        <translation>Променили су се и место и поглед. Слово је окренуто око позиције камере и померено дуж u.</translation>
    </message>
    <message>
        <source>The matrix on the right acts first. The view takes the letter to the camera, and the move is then made along {0}, about the eye.</source>
        <translation>Десна матрица делује прва. Матрица погледа преводи слово у систем камере, а покрет се онда изводи дуж {0} и око позиције камере.</translation>
    </message>
    <message>
        <source>The large pane shows camera space: the eye is at the origin, u to the right, v up, n towards it. Scrub the strip from Object to View: at Ry the letter is turned, at World it stands in its place, and from World to View everything moves and nothing changes its place against the rest. The rows of the view matrix are the camera&apos;s axes, because it is the inverse of the matrix whose columns they are. Then ask what the exchanged product does. Both matrices are multiplied once, not for every vertex.</source>
        <translation>Велики приказ показује координатни систем камере: камера је у координатном почетку, u удесно, v нагоре, n ка њој. Вуците траку од станице „Објекат” до станице „Камера”: на станици Ry слово је окренуто, на станици „Свет” стоји на свом месту, а од станице „Свет” до станице „Камера” све се помера, а ништа не мења положај према осталом. Врсте матрице погледа су осе камере, јер је она инверз матрице чије су оне колоне. Затим питајте шта чини производ са замењеним матрицама. Обе матрице се множе једном, а не за свако теме.</translation>
    </message>
    <message>
        <source>Clip, divide, NDC</source>
        <translation>Одсецање, дељење, NDC</translation>
    </message>
    <message>
        <source>First multiply by {0}, then divide by {1}. Probe 1 is at {2} in camera space, and {3}.</source>
        <translation>Прво помножите са {0}, па поделите са {1}. Сонда 1 је у {2} у координатном систему камере, и {3}.</translation>
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
        <translation>одсецање</translation>
    </message>
    <message>
        <source>NDC</source>
        <translation>NDC</translation>
    </message>
    <message>
        <source>Two steps: a matrix, and a division that no matrix can do. w is 5, the depth of the point. The table is the Probe panel&apos;s; NDC has the point in the cube. The handout calls the cube the clip space; here clip is what is before the division. The cube&apos;s z runs away from the reader: NDC is left-handed, the camera&apos;s space right-handed. Drag probe 1 in Image.</source>
        <translation>Два корака: матрица, и дељење које ниједна матрица не може. w је 5, дубина тачке. Табела је из панела „Сонда”; у NDC је тачка у коцки. Материјал коцку назива простором одсецања; овде је „одсецање” оно што је пре дељења. z коцке иде од читаоца: NDC је леви систем, а систем камере десни. Превуците сонду 1 у приказу „Слика”.</translation>
    </message>
    <message>
        <source>The view frustum</source>
        <translation>Видљив простор</translation>
    </message>
    <message>
        <source>Six numbers: near and far, and left, right, bottom and top of the window on the near plane.</source>
        <translation>Шест бројева: предња и задња раван, и лево, десно, доле и горе за прозор на предњој равни.</translation>
    </message>
    <message>
        <source>World: the pyramid without its tip. What is inside is drawn, and all of it goes to the cube. Drag near, far and a corner by their handles. Here the window is symmetric, and its four numbers come from one angle and the proportions of the picture: that is the next step.</source>
        <translation>Свет: пирамида без врха. Што је унутра, црта се, и све то иде у коцку. Превуците предњу раван, задњу раван и један угао за њихове ручице. Овде је прозор симетричан, и његова четири броја долазе од једног угла и пропорција слике: то је следећи корак.</translation>
    </message>
    <message>
        <source>Fields of view and e</source>
        <translation>Видна поља и e</translation>
    </message>
    <message>
        <source>At {0} the picture reaches {1} in x and {2} in y, {3}; at near {4}, {5}.</source>
        <translation>На {0} слика досеже {1} по x и {2} по y, {3}; на предњој равни {4}, {5}.</translation>
    </message>
    <message>
        <source>Take β = 60° and a picture of 16:9. How large is α?</source>
        <translation>Нека је β = 60°, а слика 16:9. Колико је α?</translation>
    </message>
    <message>
        <source>tan(α/2) = 16/9 · tan 30° = 1.026</source>
        <translation>tan(α/2) = 16/9 · tan 30° = 1.026</translation>
    </message>
    <message>
        <source>Draw the triangle eye, axis, edge: half the angle is in it. World is seen from above, with half of α at the eye. After the vote: 91.5°, not 106.7°. The tangents of the half angles are in the ratio 16 to 9, not the angles. The wider, the worse: type 120°, multiplied it would be 213°. More of the lens has Focal length e and the focal length of a 35-mm camera. β is not α, unless the picture is square.</source>
        <translation>Нацртајте троугао камера, оса, ивица: у њему је половина угла. Свет се види одозго, са половином угла α код камере. После гласања: 91.5°, а не 106.7°. У односу 16 према 9 су тангенси половина углова, а не углови. Што шире, то горе: унесите 120°, помножено то би било 213°. „Још о објективу” има „Жижна даљина e” и жижну даљину фотоапарата за филм од 35 mm. β није α, осим ако је слика квадратна.</translation>
    </message>
    <message>
        <source>Onto the near plane</source>
        <translation>На предњу раван</translation>
    </message>
    <message>
        <source>By similar triangles, with the plane at {0}:</source>
        <translation>По сличности троуглова, са равни на {0}:</translation>
    </message>
    <message>
        <source>World from the side: the plane is the near plane, d = n = 2. P is 5 deep and 2 high, P&apos; is 0.8 high. Both coordinates go with 1/(-z), so {0}, the length below the picture, and the last row is 0 0 -1 0. The minus is there because what is seen has negative z. From above it is the same for x.</source>
        <translation>Свет са стране: раван је предња раван, d = n = 2. P је на дубини 5 и висини 2, P&apos; је на висини 0.8. Обе координате иду са 1/(-z), па је {0}, дужина испод слике, а последња врста је 0 0 -1 0. Минус је ту јер оно што се види има негативно z. Одозго је исто за x.</translation>
    </message>
    <message>
        <source>[l, r] and [b, t]</source>
        <translation>[l, r] и [b, t]</translation>
    </message>
    <message>
        <source>{0}, and likewise for y with b and t.</source>
        <translation>{0}, и исто тако за y са b и t.</translation>
    </message>
    <message>
        <source>Check the ends: {0} gives {1}, {2} gives 1. In the proportion of the handout read {3} and (t - b). Probe 1 is straight ahead, x = 0; only the second fraction is left, and with l = -1, r = 3 it puts it at -0.5. The plus is right: it is multiplied by z, which is negative. Drag Left and Right.</source>
        <translation>Проверите крајеве: {0} даје {1}, {2} даје 1. У пропорцији из материјала читајте {3} и (t - b). Сонда 1 је право испред, x = 0; остаје само други разломак, и са l = -1, r = 3 он је доводи у -0.5. Плус је исправан: множи се са z, које је негативно. Превуците „Лево” и „Десно”.</translation>
    </message>
    <message>
        <source>A and B</source>
        <translation>A и B</translation>
    </message>
    <message>
        <source>z does not depend on x and y: {0}, {1} at near and {2} at far:</source>
        <translation>z не зависи од x и y: {0}, {1} на предњој равни и {2} на задњој:</translation>
    </message>
    <message>
        <source>Near is 1, far is 9. A point is 5 deep, halfway between them. Where is it in the cube, as {0}?</source>
        <translation>Предња раван је 1, а задња 9. Тачка је на дубини 5, на пола пута између њих. Где је у коцки, као {0}?</translation>
    </message>
    <message>
        <source>This spreads the depth evenly between near and far. Look at the F in the cube: most of the depth lies close to far.</source>
        <translation>Овде је дубина равномерно распоређена између предње и задње равни. Погледајте слово F у коцки: већина дубине лежи близу задње равни.</translation>
    </message>
    <message>
        <source>This is {0}, before the division by {1}. Look at the point: it lies inside the cube, so {2} is at most 1.</source>
        <translation>Ово је {0}, пре дељења са {1}. Погледајте тачку: лежи унутар коцке, па је {2} највише 1.</translation>
    </message>
    <message>
        <source>{0}, {1}, and {2}.</source>
        <translation>{0}, {1}, и {2}.</translation>
    </message>
    <message>
        <source>Solve for A and B with the two conditions. Why not just scale? Because then lines would be bent; the reason that the lecture gives is the next part: 1/z is what is linear on the screen. The vote: most say 0, the middle. Show the crowding: half of the cube is used up at 2nf/(n + f) = 1.8.</source>
        <translation>Решите по A и B помоћу два услова. Зашто не само скалирати? Зато што би се праве тада савиле; разлог који даје предавање је следећи део: на екрану је линеарно 1/z. Гласање: већина каже 0, средина. Покажите гомилање: половина коцке се потроши до 2nf/(n + f) = 1.8.</translation>
    </message>
    <message>
        <source>The matrix of glFrustum</source>
        <translation>Матрица glFrustum</translation>
    </message>
    <message>
        <source>Rows 1 and 2 come from the window, row 3 from {0} and {1}; row 4 divides. Framed is what {2} changes.</source>
        <translation>Врсте 1 и 2 долазе од прозора, врста 3 од {0} и {1}; врста 4 дели. Уоквирено је оно што мења {2}.</translation>
    </message>
    <message>
        <source>All of it has been derived: rows 1 and 2 from the window, row 3 from A and B, row 4 from the division. With the numbers here row 1 is 1, 0, 0.5, 0. For a symmetric window the two shears are 0, and 2n/(r - l) is e.</source>
        <translation>Све је изведено: врсте 1 и 2 од прозора, врста 3 од A и B, врста 4 од дељења. Са овдашњим бројевима врста 1 је 1, 0, 0.5, 0. За симетричан прозор два смицања су 0, а 2n/(r - l) је e.</translation>
    </message>
    <message>
        <source>1/z is linear on the screen</source>
        <translation>1/z је на екрану линеарно</translation>
    </message>
    <message>
        <source>An edge runs from the depth {0} to {1}. At {2} of the way on the screen: {3}</source>
        <translation>Ивица иде од дубине {0} до {1}. На делу пута {2} на екрану: {3}</translation>
    </message>
    <message>
        <source>Image: halfway along the marked edge on the screen, and halfway along it in the world, are two places. The first is only 30 % of the way from the nearer end. On the board: depths 2 and 8, t = 1/2, so 1/z = (1/2 + 1/8)/2 and z = 3.2, not 5. Why: a straight edge has a linear equation in x and z. Divided by z it is one in x/z, the place on the screen, and 1/z, and that is all.</source>
        <translation>Слика: пола пута дуж обележене ивице на екрану и пола пута дуж ње у свету два су места. Прво је само на 30 % пута од ближег краја. На табли: дубине 2 и 8, t = 1/2, па је 1/z = (1/2 + 1/8)/2 и z = 3.2, а не 5. Зашто: права ивица има линеарну једначину по x и z. Подељена са z, то је линеарна једначина по x/z, месту на екрану, и по 1/z, и то је све.</translation>
    </message>
    <message>
        <source>Attributes: a/z</source>
        <translation>Атрибути: a/z</translation>
    </message>
    <message>
        <source>Colours and texture coordinates are linear along the edge in space, so {0} is linear on the screen too:</source>
        <translation>Боје и координате текстуре су дуж ивице у простору линеарне, па је и {0} на екрану линеарно:</translation>
    </message>
    <message>
        <source>Affine: the texture is bent along the diagonal, where the two triangles meet. Correct: a/z and 1/z are interpolated, and divided at each pixel. With depths 2 and 8 and a from 0 to 1, the middle has a = 0.2, not 0.5. Turn Azimuth: seen straight on both are alike. Parts a side makes the error smaller, not zero.</source>
        <translation>Афино: текстура се прелама дуж дијагонале, где се два троугла сусрећу. Исправно: интерполирају се a/z и 1/z, па се у сваком пикселу деле. Са дубинама 2 и 8 и a од 0 до 1, средина има a = 0.2, а не 0.5. Мењајте „Азимут”: гледано право спреда, оба су једнака. „Делова по страници” чини грешку мањом, а не нулом.</translation>
    </message>
    <message>
        <source>The orthographic box</source>
        <translation>Ортографски квадар</translation>
    </message>
    <message>
        <source>A box becomes a cube without a division: scale by {0} and {1}, and move the middle to 0.</source>
        <translation>Квадар постаје коцка без дељења: скалирајте са {0} и {1}, и померите средину у 0.</translation>
    </message>
    <message>
        <source>The box has the same width at every depth: w is 1. The first cell of the handout has 2n/(r - l), a slip: nothing is brought to a near plane here, so there is no n. The shifts stand in column 4 now, not in column 3, because they are not multiplied by z. Compare with the frustum&apos;s matrix, in step 10.</source>
        <translation>Квадар је на свакој дубини једнако широк: w је 1. Прво поље у материјалу има 2n/(r - l), што је омашка: овде се ништа не доводи на предњу раван, па n нема. Помаци сада стоје у колони 4, а не у колони 3, јер се не множе са z. Упоредите са матрицом зарубљене пирамиде, у кораку 10.</translation>
    </message>
    <message>
        <source>To pixels</source>
        <translation>До пиксела</translation>
    </message>
    <message>
        <source>{0} and, as rows count down, {1}. Probe 1: {2} to {3}.</source>
        <translation>{0} и, пошто се редови броје надоле, {1}. Сонда 1: {2} у {3}.</translation>
    </message>
    <message>
        <source>The same probe as before, now to the end: 1280 by 720, origin at the upper left. Ask for the corners of the cube: (-1, 1) is (0, 0), (1, -1) is (1280, 720). y turns over here and nowhere else. Sum up the chain: object, world, camera, clip, NDC, pixels; Probe in the drawer has all of it for one point.</source>
        <translation>Иста сонда као пре, сада до краја: 1280 пута 720, координатни почетак горе лево. Питајте за углове коцке: (-1, 1) је (0, 0), (1, -1) је (1280, 720). y се преокреће овде и нигде другде. Сажмите ланац: објекат, свет, камера, одсецање, NDC, пиксели; „Сонда” доле има све то за једну тачку.</translation>
    </message>
</context>
<context>
    <name>talk-004</name>
    <message>
        <source>A camera for the letter F</source>
        <translation>Камера за слово F</translation>
    </message>
    <message>
        <source>The camera&apos;s axes</source>
        <translation>Осе камере</translation>
    </message>
    <message>
        <source>{0}, {1} is the origin, {2}. What is {3}?</source>
        <translation>{0}, {1} је координатни почетак, {2}. Колико је {3}?</translation>
    </message>
    <message>
        <source>1: {0} is up, so {1} is up</source>
        <translation>1: {0} је нагоре, па је и {1} нагоре</translation>
    </message>
    <message>
        <source>{0} and {1}, so {2}.</source>
        <translation>{0} и {1}, па је {2}.</translation>
    </message>
    <message>
        <source>Build it step by step in Camera frame: eye and target, then N, n, U, u, v. N points back, from the target to the eye: the camera looks along {0}. Three unit vectors, each at right angles to the others, right-handed. Stop before v and let them vote: n is (0, 9, 3) over its length, 9.49. Then show v: it leans far away from V. What if V is parallel to N? Turn &quot;Up from view&quot; towards the end of its slider: |V × n| goes to 0, and U with it.</source>
        <translation>Градите га корак по корак у панелу „Координатни систем камере”: позиција камере и циљ, па N, n, U, u, v. N показује уназад, од циља ка позицији камере: камера гледа дуж {0}. Три јединична вектора, сваки под правим углом према осталима, десни систем. Станите пре v и нека гласају: n је (0, 9, 3) кроз своју дужину, 9.49. Затим покажите v: нагиње се далеко од V. А ако је V паралелно са N? Померајте „Нагоре од погледа” ка крају клизача: |V × n| тежи 0, а са њим и U.</translation>
    </message>
    <message>
        <source>The camera in the world</source>
        <translation>Камера у свету</translation>
    </message>
    <message>
        <source>The camera is at {0}, and has {1}. It is to stand in the origin, with them along {2}.</source>
        <translation>Камера је у {0}, и има {1}. Треба да стоји у координатном почетку, са њима дуж {2}.</translation>
    </message>
    <message>
        <source>x, y and z belong to the world and stand still in the next two steps; u, v and n are the camera&apos;s. Ask for two moves that bring them together, and in which order.</source>
        <translation>x, y и z припадају свету и стоје у следећа два корака; u, v и n припадају камери. Питајте која два покрета их доводе заједно, и којим редом.</translation>
    </message>
    <message>
        <source>First P</source>
        <translation>Прво P</translation>
    </message>
    <message>
        <source>{0} moves the eye to the origin, and the whole scene with it. Nothing turns: {1} keep their directions.</source>
        <translation>{0} помера позицију камере у координатни почетак, а са њом и целу сцену. Ништа се не окреће: {1} задржавају своје смерове.</translation>
    </message>
    <message>
        <source>Go on, and watch the camera come to the axes; back on the strip and once more. Nothing changes its shape, and nothing its place against the rest.</source>
        <translation>Идите даље и гледајте како камера долази на осе; траком назад, и још једном. Ништа не мења облик, нити свој положај према осталом.</translation>
    </message>
    <message>
        <source>Then R</source>
        <translation>Затим R</translation>
    </message>
    <message>
        <source>{0} rotates about the origin, until {1} lie along {2}, the lecture&apos;s {3}.</source>
        <translation>{0} ротира око координатног почетка док {1} не легну дуж {2}, у предавању {3}.</translation>
    </message>
    <message>
        <source>The camera looks along {0} now. R is hard to write down; its inverse is easy: the columns of {1} are u, v, n. R is orthogonal, so its inverse is its transpose, and its rows are u, v, n. Unfold the factors of view ← world: rotation and translation.</source>
        <translation>Камера сада гледа дуж {0}. R је тешко написати; њен инверз је лак: колоне од {1} су u, v, n. R је ортогонална, па је њен инверз транспонована матрица, и њене врсте су u, v, n. Расклопите чиниоце код „камера ← свет”: ротација и транслација.</translation>
    </message>
    <message>
        <source>R times P</source>
        <translation>R пута P</translation>
    </message>
    <message>
        <source>{0}, from the world&apos;s system (GKS) to the camera&apos;s (KSK); {1} acts first.</source>
        <translation>{0}, из система света (GKS) у систем камере (KSK); {1} делује прва.</translation>
    </message>
    <message>
        <source>{0}, {1}. Which number is in row 3 of {2}&apos;s last column?</source>
        <translation>{0}, {1}. Који број стоји у врсти 3 последње колоне матрице {2}?</translation>
    </message>
    <message>
        <source>−8: the eye&apos;s z with a minus</source>
        <translation>−8: z позиције камере са минусом</translation>
    </message>
    <message>
        <source>8: the eye&apos;s z</source>
        <translation>8: z позиције камере</translation>
    </message>
    <message>
        <source>{0}. {1} acts first, so {2} rotates the translation, too.</source>
        <translation>{0}. {1} делује прва, па {2} ротира и транслацију.</translation>
    </message>
    <message>
        <source>Multiply it out on the board: the last column is minus the eye along u, v and n. In the other order the last column would be minus the eye. All objects are moved, the camera stands still afterwards; how they lie to each other does not change. GKS is the world&apos;s system, KSK the camera&apos;s.</source>
        <translation>Измножите на табли: последња колона је минус позиција камере дуж u, v и n. Обрнутим редом последња колона била би минус позиција камере. Померају се сви објекти, а камера после тога стоји; како су они међусобно распоређени, то се не мења. GKS је систем света, KSK систем камере.</translation>
    </message>
    <message>
        <source>Why transform at all?</source>
        <translation>Чему уопште трансформација?</translation>
    </message>
    <message>
        <source>A point behind the camera has {0}. A nearer point has a larger (less negative) z. Here point 1 has −7.5, point 2 has −12, point 3 has 2.</source>
        <translation>Тачка иза камере има {0}. Ближа тачка има веће (мање негативно) z. Овде тачка 1 има −7.5, тачка 2 има −12, тачка 3 има 2.</translation>
    </message>
    <message>
        <source>Three points, and their z in the camera&apos;s system (the Probe panel has them). Which is behind the camera? Which hides which? One comparison each. In the world&apos;s coordinates the same questions need the camera every time. The projection plane is at a right angle to the z axis now, and orthogonal projection is: leave z out. Perspective is one division more.</source>
        <translation>Три тачке, и њихово z у систему камере (има их панел „Сонда”). Која је иза камере? Која коју заклања? По једно поређење за свако питање. У координатама света за иста питања сваки пут треба камера. Раван пројектовања је сада управна на осу z, и ортогонална пројекција гласи: изоставите z. Перспектива је још једно дељење.</translation>
    </message>
    <message>
        <source>The letter F on its grid</source>
        <translation>Слово F на својој решетки</translation>
    </message>
    <message>
        <source>Eight cubes on the xz plane, drawn by orthogonal projection: {0}</source>
        <translation>Осам коцки на равни xz, нацртано ортогоналном пројекцијом: {0}</translation>
    </message>
    <message>
        <source>This is the exercise&apos;s class Ortho: every line of the grid and every edge of the cubes goes through R P, and z is forgotten. Parallel edges stay parallel: show three of them. Turn Azimuth: the letter turns, nothing grows or shrinks with distance. The exercise wants lines only; here faces are filled, so that what is in front is seen.</source>
        <translation>Ово је класа Ortho из задатка: свака линија решетке и свака ивица коцки пролази кроз R P, а z се заборавља. Паралелне ивице остају паралелне: покажите три. Мењајте „Азимут”: слово се окреће, ништа не расте нити се смањује са растојањем. Задатак тражи само линије; овде су стране попуњене, да се види шта је испред.</translation>
    </message>
    <message>
        <source>Round the F</source>
        <translation>Око слова F</translation>
    </message>
    <message>
        <source>The camera circles the F. Its height changes smoothly, or in steps.</source>
        <translation>Камера кружи око слова F. Њена висина се мења глатко, или у скоковима.</translation>
    </message>
    <message>
        <source>Press Play in the tool bar. Open Animation in the dock: let the height of the eye swing, then go in steps, and set the lowest and highest y. In every picture R and P are computed anew from the three vectors; the F itself does not move. Ask what changes in the World pane: only the camera and its frustum.</source>
        <translation>Притисните „Пусти” на траци са алаткама. Отворите „Анимација” у бочном панелу: нека се висина камере њише, затим нека иде у скоковима, и поставите најмање и највеће y. На свакој слици R и P се рачунају изнова из три вектора; само слово F се не помера. Питајте шта се мења у приказу „Свет”: само камера и њена зарубљена пирамида.</translation>
    </message>
    <message>
        <source>Looking level</source>
        <translation>Водораван поглед</translation>
    </message>
    <message>
        <source>{0}: the camera looks level, and uprights stay parallel in the picture.</source>
        <translation>{0}: камера гледа водоравно, и усправне ивице на слици остају паралелне.</translation>
    </message>
    <message>
        <source>level</source>
        <translation>водоравно</translation>
    </message>
    <message>
        <source>looking down</source>
        <translation>гледа надоле</translation>
    </message>
    <message>
        <source>In Animation choose Look: level, and play: the eye&apos;s height and the target&apos;s go together. Uprights are upright now, at any height; World shows both cameras. Change it back to the target: they run together. Then open More of the camera and set up to 1, 1, 0: the picture turns, the F does not. Only the direction of V counts, and only the part of it at a right angle to n.</source>
        <translation>У одељку „Анимација” изаберите „Поглед”: „водоравно”, и пустите: висине камере и циља иду заједно. Усправне ивице су сада усправне, на свакој висини; „Свет” показује обе камере. Вратите на „у циљ”: примичу се једна другој. Затим отворите „Још о камери” и поставите вектор нагоре на 1, 1, 0: слика се окреће, слово F не. Важан је само смер вектора V, и то само његов део управан на n.</translation>
    </message>
    <message>
        <source>Perspective</source>
        <translation>Перспектива</translation>
    </message>
    <message>
        <source>{0}, by the matrix with {1} in its last row.</source>
        <translation>{0}, матрицом са {1} у последњој врсти.</translation>
    </message>
    <message>
        <source>Two similar triangles with the camera as their corner. z is negative in front, so {0} is positive. The matrix: 1, 1, 1 and −1/d; it makes {1}, and dividing by the last number gives {2}, {3} and {4}. Any multiple of the matrix does the same. Move the plane distance d: the picture on the plane grows with d.</source>
        <translation>Два слична троугла са теменом у камери. z је испред негативно, па је {0} позитивно. Матрица: 1, 1, 1 и −1/d; она даје {1}, а дељење последњим бројем {2}, {3} и {4}. Сваки умножак матрице чини исто. Померајте растојање равни d: слика на равни расте са d.</translation>
    </message>
    <message>
        <source>To the pixels</source>
        <translation>До пиксела</translation>
    </message>
    <message>
        <source>Natural coordinates to pixel coordinates: scale, then shift. {0} and {1} are the middle of the picture, 640 and 360; {2} is negative, since rows count downwards. With d = 1 and this lens {3}, and {4}. Check with point 1: view x = 1.5, z = −7.5, so {5}, and {6}. The Probe panel has it in the row image px.</source>
        <translation>Од природних координата до координата пиксела: скалирање, па померање. {0} и {1} су средина слике, 640 и 360; {2} је негативно, јер се редови броје надоле. Са d = 1 и овим објективом {3}, и {4}. Проверите на тачки 1: у систему камере x = 1.5, z = −7.5, па је {5}, и {6}. Панел „Сонда” има то у реду „слика px”.</translation>
    </message>
    <message>
        <source>The F in perspective</source>
        <translation>Слово F у перспективи</translation>
    </message>
    <message>
        <source>These are the same lines, divided by their depth. A larger {0} only enlarges the picture.</source>
        <translation>То су исте линије, подељене својом дубином. Веће {0} слику само увећава.</translation>
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
        <translation>Две слике из исте позиције камере: на другој је d двапут веће, и све је двапут веће. У програму то чини видно поље: {0} са 1.73 на 3.46. Ништа се не помера у односу на друго. Затим завршите поређење и промените „Растојање”: сада ближи делови расту брже од даљих. Докле год је камера на довољно широком кругу, све је у реду.</translation>
    </message>
    <message>
        <source>Too close</source>
        <translation>Преблизу</translation>
    </message>
    <message>
        <source>The camera comes nearer to the F, and lines appear that nobody drew.</source>
        <translation>Камера прилази слову F, и појављују се линије које нико није нацртао.</translation>
    </message>
    <message>
        <source>Change Distance to 8 first: a good picture. Then come nearer, slowly. As soon as an edge of the F reaches behind the camera, lines go astray. It is not the distance of the plane that does it: with d as small as you like the picture is right, as long as all is in front. The World pane shows the plane through the eye, marked z = 0. Which edges cross it?</source>
        <translation>Прво промените „Растојање” на 8: добра слика. Затим прилазите, полако. Чим ивица слова F досегне иза камере, линије залутају. Не чини то растојање равни: са колико год малим d слика је исправна, докле год је све испред. Приказ „Свет” показује раван кроз позицију камере, означену са z = 0. Које је ивице секу?</translation>
    </message>
    <message>
        <source>A line broken at {0}</source>
        <translation>Права прекинута на {0}</translation>
    </message>
    <message>
        <source>The projection takes the point at {0} to infinity, and the line&apos;s point at infinity to a finite point: the image is a line in two pieces.</source>
        <translation>Пројекција тачку на {0} шаље у бесконачност, а бесконачно далеку тачку праве у коначну тачку: слика је права у два дела.</translation>
    </message>
    <message>
        <source>In the KSK {0}, {1}, and {2}. Which {3} does the image of AB cover?</source>
        <translation>У KSK {0}, {1}, и {2}. Које {3} покрива слика дужи AB?</translation>
    </message>
    <message>
        <source>From 0.5 to −0.5, from one image to the other</source>
        <translation>Од 0.5 до −0.5, од једне слике до друге</translation>
    </message>
    <message>
        <source>From 0.5 to infinity</source>
        <translation>Од 0.5 до бесконачности</translation>
    </message>
    <message>
        <source>{0} grows without bound towards z = 0.</source>
        <translation>{0} ка z = 0 расте без граница.</translation>
    </message>
    <message>
        <source>AB is straight and goes through the plane z = 0; half of it is behind the camera. Vote, then show: pink the image, orange what the naive program draws; dashed is the piece without an image. In projective geometry the line is a circle, closed by its point at infinity: open Explanation and diagrams for it. Joining A&apos; and B&apos; takes the wrong arc. And the pencil of lines through one point? The F has many parallel edges; their wrong parts all run through the edges&apos; vanishing point. One sentence of the lecture says &quot;plane of projection&quot; where it means z = 0.</source>
        <translation>AB је права дуж и пролази кроз раван z = 0; половина је иза камере. Гласајте, па покажите: ружичасто је слика, наранџасто оно што црта наивни програм; испрекидан је део без слике. У пројективној геометрији права је кружница, затворена својом бесконачно далеком тачком: за то отворите „Објашњење и дијаграми”. Спајање A&apos; и B&apos; узима погрешан лук. А прамен правих кроз једну тачку? Слово F има много паралелних ивица; њихови погрешни делови сви пролазе кроз тачку недогледа тих ивица. Једна реченица предавања каже „раван пројекције” где мисли z = 0.</translation>
    </message>
    <message>
        <source>Four cases</source>
        <translation>Четири случаја</translation>
    </message>
    <message>
        <source>If both ends are in front, draw. If both are behind, do not draw. Otherwise cut first.</source>
        <translation>Ако су оба краја испред, цртајте. Ако су оба иза, не цртајте. Иначе прво исеците.</translation>
    </message>
    <message>
        <source>1 in front</source>
        <translation>1 испред</translation>
    </message>
    <message>
        <source>2 behind</source>
        <translation>2 иза</translation>
    </message>
    <message>
        <source>3 A behind</source>
        <translation>3 A иза</translation>
    </message>
    <message>
        <source>4 B behind</source>
        <translation>4 B иза</translation>
    </message>
    <message>
        <source>It begins as case 1, both ends in front. Drag B behind the plane z = 0: case 4. Drag A behind too: case 2, nothing is drawn. B in front again: case 3. The number below the scene&apos;s controls names the case each time. The program of the exercise must keep the last point in camera coordinates, as {0}, also where nothing was drawn.</source>
        <translation>Почиње као случај 1, оба краја испред. Превуците B иза равни z = 0: случај 4. Превуците и A иза: случај 2, ништа се не црта. B опет испред: случај 3. Број испод контрола сцене сваки пут именује случај. Програм из задатка мора да памти последњу тачку у координатама камере, као {0}, и тамо где ништа није нацртано.</translation>
    </message>
    <message>
        <source>Cut at {0}</source>
        <translation>Сечење на {0}</translation>
    </message>
    <message>
        <source>{0}, and the point of the line at {1} takes the place of the end behind.</source>
        <translation>{0}, а место краја који је иза заузима тачка праве на {1}.</translation>
    </message>
    <message>
        <source>Not at 0, where the divide fails, but a little in front of it. The three pictures: divided without a cut, cut at z = −0.01, clipped. Dashed is the piece of AB without an image. The cut keeps all of AB in front of the plane, and its image runs out of the frame. Clipping keeps what is inside the pyramid, and the image ends at the frame. In Image they hardly differ: what differs is beside the picture, or at most a few pixels; &quot;More numbers&quot; has it as what the cut leaves out. Clipping in homogeneous coordinates needs no such number: it keeps {0} to {1} before the divide. With this the exercise is done: walk into the F.</source>
        <translation>Не на 0, где дељење не успева, него мало испред. Три слике: подељено без сечења, исечено на z = −0.01, одсечено. Испрекидан је део дужи AB без слике. Сечење задржава све од AB испред равни, и слика излази из рама. Одсецање задржава оно што је унутар пирамиде, и слика се завршава на раму. У приказу „Слика” једва се разликују: разлика је поред слике, или највише неколико пиксела; „Још бројева” је има као оно што сечење изоставља. Одсецању у хомогеним координатама такав број није потребан: оно пре дељења задржава од {0} до {1}. Тиме је задатак готов: уђите у слово F.</translation>
    </message>
</context>
<context>
    <name>tour</name>
    <message>
        <source>Two minutes with a camera</source>
        <translation>Два минута са камером</translation>
    </message>
    <message>
        <source>The near plane</source>
        <translation>Предња раван</translation>
    </message>
    <message>
        <source>In the World pane a camera looks at the letter F. The ochre frame is its near plane.</source>
        <translation>У приказу „Свет” камера гледа у слово F. Окер рам је њена предња раван.</translation>
    </message>
    <message>
        <source>Bring the near plane closer to the camera.</source>
        <translation>Приближите предњу раван камери.</translation>
    </message>
    <message>
        <source>Drag it in the World pane, by its face, an edge or its name, or move the slider *Near* in the dock to the left.</source>
        <translation>Превуците је у приказу „Свет” за саму страну, ивицу или име, или померите клизач *Предња раван* у бочном панелу улево.</translation>
    </message>
    <message>
        <source>The picture stays as it is; in the NDC cube everything has moved towards far.</source>
        <translation>Слика остаје каква јесте; у NDC коцки све се померило ка задњој равни.</translation>
    </message>
    <message>
        <source>From another side</source>
        <translation>Са неке друге стране</translation>
    </message>
    <message>
        <source>You look at camera, frustum and picture from outside. Nothing changes when you walk round them.</source>
        <translation>Камеру, зарубљену пирамиду и слику гледате споља. Ништа се не мења када их обиђете.</translation>
    </message>
    <message>
        <source>Turn the world: drag beside the frustum, or anywhere with the middle button.</source>
        <translation>Окрените свет: превлачите поред зарубљене пирамиде, или било где средњим дугметом.</translation>
    </message>
    <message>
        <source>On the planes a drag moves near or far. With the keyboard: Tab to the World pane, then arrows. The house in its title brings back the first view.</source>
        <translation>На равнима превлачење помера предњу или задњу раван. Са тастатуре: Tab до приказа „Свет”, па стрелице. Кућица у његовом наслову враћа први поглед.</translation>
    </message>
    <message>
        <source>Only your own view has turned. The image is the camera&apos;s.</source>
        <translation>Окренуо се само ваш поглед. Слика припада камери.</translation>
    </message>
    <message>
        <source>The cube</source>
        <translation>Коцка</translation>
    </message>
    <message>
        <source>Everything between near and far is squeezed into one cube, whatever the lens. That is the NDC cube.</source>
        <translation>Све између предње и задње равни сабијено је у једну коцку, ма какав био објектив. То је NDC коцка.</translation>
    </message>
    <message>
        <source>Make the cube the large pane.</source>
        <translation>Нека коцка буде велики приказ.</translation>
    </message>
    <message>
        <source>Double-click its title, *NDC cube*, or press Ctrl+2.</source>
        <translation>Двапут кликните на њен наслов, *NDC коцка*, или притисните Ctrl+2.</translation>
    </message>
    <message>
        <source>The small end of the frustum has become the front face.</source>
        <translation>Мањи крај зарубљене пирамиде постао је предња страна.</translation>
    </message>
    <message>
        <source>On the way there</source>
        <translation>На путу тамо</translation>
    </message>
    <message>
        <source>Each matrix on the way is a stop of the strip below the cube.</source>
        <translation>Свака матрица на путу је једна станица траке испод коцке.</translation>
    </message>
    <message>
        <source>Go back to an earlier stop of the strip, and forwards again if you like.</source>
        <translation>Вратите се на неку ранију станицу траке, и ако желите поново напред.</translation>
    </message>
    <message>
        <source>Drag the strip&apos;s slider to the left, or press *View*, *Pyramid* or *Box*; with the focus on it the arrow keys move it.</source>
        <translation>Превуците клизач траке улево, или притисните *Камера*, *Пирамида* или *Квадар*; када је у фокусу, померају га стрелице.</translation>
    </message>
    <message>
        <source>Lines stay straight all the way.</source>
        <translation>Праве све време остају праве.</translation>
    </message>
    <message>
        <source>The field of view</source>
        <translation>Видно поље</translation>
    </message>
    <message>
        <source>How much of the world does the picture show?</source>
        <translation>Колики део света слика показује?</translation>
    </message>
    <message>
        <source>Change the field of view.</source>
        <translation>Промените видно поље.</translation>
    </message>
    <message>
        <source>Move the slider *Field of view* in the dock, or type a number and press Enter.</source>
        <translation>Померите клизач *Видно поље* у бочном панелу, или унесите број и притисните Enter.</translation>
    </message>
    <message>
        <source>The wider the angle, the more of the world you see, and the smaller everything is.</source>
        <translation>Што је угао шири, то више света видите, и све је мање.</translation>
    </message>
    <message>
        <source>Another lens</source>
        <translation>Други објектив</translation>
    </message>
    <message>
        <source>The rays of a parallel lens do not meet in an eye: what is far away is drawn as large as what is near.</source>
        <translation>Зраци паралелног објектива се не секу у позицији камере: што је далеко, црта се велико као и оно што је близу.</translation>
    </message>
    <message>
        <source>Choose the orthographic lens.</source>
        <translation>Изаберите ортографски објектив.</translation>
    </message>
    <message>
        <source>*Lens*, in the dock, is a list: choose *orthographic* in it. From the keyboard press Tab until it has the focus, then Down until it is *orthographic*.</source>
        <translation>*Објектив*, у бочном панелу, је списак: изаберите у њему *ортографски*. Са тастатуре притискајте Tab док не дође у фокус, па стрелицу надоле док не буде *ортографски*.</translation>
    </message>
    <message>
        <source>The frustum is a box. The list at the top left has a scene for each topic of the lectures.</source>
        <translation>Зарубљена пирамида је сада квадар. Списак горе лево има сцену за сваку тему из предавања.</translation>
    </message>
</context>
</TS>
