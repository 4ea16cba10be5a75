<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="et" sourcelanguage="en">
<context>
    <name>Actions</name>
    <message>
        <source>Scene</source>
        <translation>Stseen</translation>
    </message>
    <message>
        <source>The scene in front of the camera</source>
        <translation>Stseen kaamera ees</translation>
    </message>
    <message>
        <source>Tools</source>
        <translation>Tööriistad</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Paus</translation>
    </message>
    <message>
        <source>Play</source>
        <translation>Esita</translation>
    </message>
    <message>
        <source>&amp;About Frustum Lab</source>
        <translation>&amp;Frustum Labist</translation>
    </message>
    <message>
        <source>&amp;Blank the screen</source>
        <translation>&amp;Must ekraan</translation>
    </message>
    <message>
        <source>&amp;Camera</source>
        <translation>&amp;Kaamera</translation>
    </message>
    <message>
        <source>&amp;Close the lesson</source>
        <translation>Sul&amp;ge õppetund</translation>
    </message>
    <message>
        <source>&amp;Controls</source>
        <translation>&amp;Juhtelemendid</translation>
    </message>
    <message>
        <source>&amp;Conventions</source>
        <translation>K&amp;okkulepped</translation>
    </message>
    <message>
        <source>&amp;Copy picture</source>
        <translation>&amp;Kopeeri pilt</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>&amp;Redigeeri</translation>
    </message>
    <message>
        <source>&amp;Export picture…</source>
        <translation>&amp;Ekspordi pilt…</translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation>&amp;Fail</translation>
    </message>
    <message>
        <source>&amp;Find a control</source>
        <translation>&amp;Otsi juhtelementi</translation>
    </message>
    <message>
        <source>&amp;Freely</source>
        <translation>&amp;Vabalt</translation>
    </message>
    <message>
        <source>&amp;Frustum</source>
        <translation>&amp;Frustum</translation>
    </message>
    <message>
        <source>&amp;Full screen</source>
        <translation>Täisek&amp;raan</translation>
    </message>
    <message>
        <source>&amp;Grid</source>
        <translation>R&amp;uudustik</translation>
    </message>
    <message>
        <source>&amp;Handles</source>
        <translation>&amp;Pidemed</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>A&amp;bi</translation>
    </message>
    <message>
        <source>&amp;Hint</source>
        <translation>Vi&amp;hje</translation>
    </message>
    <message>
        <source>&amp;Keys and mouse</source>
        <translation>Klahvid ja &amp;hiir</translation>
    </message>
    <message>
        <source>&amp;Labels</source>
        <translation>&amp;Sildid</translation>
    </message>
    <message>
        <source>&amp;Layers</source>
        <translation>Ki&amp;hid</translation>
    </message>
    <message>
        <source>&amp;Lessons</source>
        <translation>Õ&amp;ppetunnid</translation>
    </message>
    <message>
        <source>&amp;Next step</source>
        <translation>&amp;Järgmine samm</translation>
    </message>
    <message>
        <source>&amp;Open a lesson…</source>
        <translation>Ava &amp;õppetund…</translation>
    </message>
    <message>
        <source>&amp;Open…</source>
        <translation>&amp;Ava…</translation>
    </message>
    <message>
        <source>&amp;Picture on the near plane</source>
        <translation>P&amp;ilt lähitasandil</translation>
    </message>
    <message>
        <source>&amp;Present</source>
        <translation>&amp;Esitle</translation>
    </message>
    <message>
        <source>&amp;Previous step</source>
        <translation>&amp;Eelmine samm</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>&amp;Välju</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>&amp;Tee uuesti</translation>
    </message>
    <message>
        <source>&amp;Reset the panes&apos; own views</source>
        <translation>L&amp;ähtesta paanide oma vaated</translation>
    </message>
    <message>
        <source>&amp;Review</source>
        <translation>&amp;Kordamine</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>&amp;Salvesta</translation>
    </message>
    <message>
        <source>&amp;Scenes</source>
        <translation>&amp;Stseenid</translation>
    </message>
    <message>
        <source>&amp;Show cost</source>
        <translation>Näita &amp;kulu</translation>
    </message>
    <message>
        <source>&amp;Show the step again</source>
        <translation>Näita &amp;sammu uuesti</translation>
    </message>
    <message>
        <source>&amp;Start card</source>
        <translation>Ava&amp;kaart</translation>
    </message>
    <message>
        <source>&amp;Theme</source>
        <translation>K&amp;ujundus</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Võta tagasi</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>&amp;Vaade</translation>
    </message>
    <message>
        <source>All &amp;digits</source>
        <translation>Kõik &amp;numbrikohad</translation>
    </message>
    <message>
        <source>Along the a&amp;xis</source>
        <translation>Piki &amp;telge</translation>
    </message>
    <message>
        <source>As the s&amp;ystem</source>
        <translation>Nagu &amp;süsteemis</translation>
    </message>
    <message>
        <source>As the system</source>
        <translation>Nagu süsteemis</translation>
    </message>
    <message>
        <source>Back to &amp;all panes</source>
        <translation>&amp;Tagasi kõigi paanide juurde</translation>
    </message>
    <message>
        <source>Begin the lesson a&amp;gain</source>
        <translation>Alusta õppetundi &amp;uuesti</translation>
    </message>
    <message>
        <source>Chec&amp;k the lesson</source>
        <translation>K&amp;ontrolli õppetundi</translation>
    </message>
    <message>
        <source>Co&amp;ntrols of the slide</source>
        <translation>Slai&amp;di juhtelemendid</translation>
    </message>
    <message>
        <source>Compare s&amp;ide by side or overlaid</source>
        <translation>Võrdle kõrvuti või &amp;ülestikku</translation>
    </message>
    <message>
        <source>Compare wit&amp;h this picture</source>
        <translation>Võrdle &amp;selle pildiga</translation>
    </message>
    <message>
        <source>Controls</source>
        <translation>Juhtelemendid</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Kopeeri</translation>
    </message>
    <message>
        <source>Copy the three panes to the clipboard, including the document</source>
        <translation>Kopeerib kolm paani lõikelauale, koos dokumendiga</translation>
    </message>
    <message>
        <source>Dark</source>
        <translation>Tume</translation>
    </message>
    <message>
        <source>Every topic with its exercises, as you solved them</source>
        <translation>Kõik teemad oma ülesannetega, nii nagu te need lahendasite</translation>
    </message>
    <message>
        <source>Exercises of topics that you choose, without help</source>
        <translation>Ülesanded teie valitud teemadest, ilma abita</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>Eksport</translation>
    </message>
    <message>
        <source>Export panes as PNG, SVG, PDF or TikZ; a PNG contains the document</source>
        <translation>Ekspordib paanid PNG-, SVG-, PDF- või TikZ-failina; PNG sisaldab dokumenti</translation>
    </message>
    <message>
        <source>Find a control by its name, its letter or what it does</source>
        <translation>Otsib juhtelementi nime, tähe või toime järgi</translation>
    </message>
    <message>
        <source>From &amp;above</source>
        <translation>Ü&amp;lalt</translation>
    </message>
    <message>
        <source>From the &amp;eye</source>
        <translation>&amp;Silmast</translation>
    </message>
    <message>
        <source>From the &amp;side</source>
        <translation>&amp;Küljelt</translation>
    </message>
    <message>
        <source>Go on with the t&amp;est</source>
        <translation>Jätka test&amp;i</translation>
    </message>
    <message>
        <source>Help</source>
        <translation>Abi</translation>
    </message>
    <message>
        <source>Hold the current picture and compare it with later ones, or end the comparison</source>
        <translation>Jätab praeguse pildi meelde ja võrdleb seda hilisematega, või lõpetab võrdluse</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>Keel</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>Hele</translation>
    </message>
    <message>
        <source>Look at the &amp;world</source>
        <translation>Maailma v&amp;aatepunkt</translation>
    </message>
    <message>
        <source>Measure the cost of every step: the model, each pane&apos;s matrices and repaint</source>
        <translation>Mõõdab iga sammu kulu: mudel, iga paani maatriksid ja ümberjoonistamine</translation>
    </message>
    <message>
        <source>Name e&amp;verything</source>
        <translation>Nimeta k&amp;õik</translation>
    </message>
    <message>
        <source>Name everything in the pictures, not only what the scene is about</source>
        <translation>Nimetab piltidel kõik, mitte ainult selle, millest stseen räägib</translation>
    </message>
    <message>
        <source>O&amp;verview…</source>
        <translation>Üle&amp;vaade…</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Ava</translation>
    </message>
    <message>
        <source>Open &amp;recent</source>
        <translation>Ava &amp;hiljutine</translation>
    </message>
    <message>
        <source>Open a &amp;mesh…</source>
        <translation>Ava &amp;võrk…</translation>
    </message>
    <message>
        <source>Open a document, a lesson, a mesh, a camera or an exported picture</source>
        <translation>Avab dokumendi, õppetunni, võrgu, kaamera või eksporditud pildi</translation>
    </message>
    <message>
        <source>Open a lesson or a talk from its file</source>
        <translation>Avab õppetunni või ettekande failist</translation>
    </message>
    <message>
        <source>P&amp;en</source>
        <translation>&amp;Pliiats</translation>
    </message>
    <message>
        <source>P&amp;ointer in all panes</source>
        <translation>&amp;Osuti kõigis paanides</translation>
    </message>
    <message>
        <source>Panes in col&amp;umns</source>
        <translation>Paanid &amp;veergudes</translation>
    </message>
    <message>
        <source>Play or pause the camera&apos;s orbit</source>
        <translation>Paneb kaamera tiirlemise käima või seisma</translation>
    </message>
    <message>
        <source>Present</source>
        <translation>Esitle</translation>
    </message>
    <message>
        <source>Present from the beginnin&amp;g</source>
        <translation>Esitle al&amp;gusest</translation>
    </message>
    <message>
        <source>Present the open talk from its first step</source>
        <translation>Esitleb avatud ettekannet esimesest sammust alates</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>Tee uuesti</translation>
    </message>
    <message>
        <source>Reduce &amp;motion</source>
        <translation>Vähem li&amp;ikumist</translation>
    </message>
    <message>
        <source>Remove the &amp;probe</source>
        <translation>Eemalda &amp;sond</translation>
    </message>
    <message>
        <source>Remove the chosen probe from the panes</source>
        <translation>Eemaldab valitud sondi paanidest</translation>
    </message>
    <message>
        <source>Reset</source>
        <translation>Lähtesta</translation>
    </message>
    <message>
        <source>Reset &amp;all</source>
        <translation>&amp;Lähtesta kõik</translation>
    </message>
    <message>
        <source>Reset camera, lens, image and settings to how the scene opens</source>
        <translation>Lähtestab kaamera, objektiivi, pildi ja sätted nii, nagu stseen avaneb</translation>
    </message>
    <message>
        <source>S&amp;peed and accuracy</source>
        <translation>Kii&amp;rus ja täpsus</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Salvesta</translation>
    </message>
    <message>
        <source>Save &amp;as…</source>
        <translation>Salvesta &amp;nimega…</translation>
    </message>
    <message>
        <source>Show all digits of every number, not only four</source>
        <translation>Näitab kõigi arvude kõiki numbrikohti, mitte ainult nelja</translation>
    </message>
    <message>
        <source>Show the class a black screen, or the panes again</source>
        <translation>Näitab klassile musta ekraani või jälle paane</translation>
    </message>
    <message>
        <source>Show the next step of a lesson or a talk at once, without a transition</source>
        <translation>Näitab õppetunni või ettekande järgmist sammu kohe, ilma üleminekuta</translation>
    </message>
    <message>
        <source>Show the pane in the large slot; choose it again to fill the window</source>
        <translation>Näitab paani suurel kohal; veel kord valides täidab see akna</translation>
    </message>
    <message>
        <source>Show the panes and the essential controls on the full screen, for a class</source>
        <translation>Näitab paane ja olulisi juhtelemente täisekraanil, klassile</translation>
    </message>
    <message>
        <source>Show the step as the lesson&apos;s file has it, without your changes</source>
        <translation>Näitab sammu nii, nagu see on õppetunni failis, ilma teie muudatusteta</translation>
    </message>
    <message>
        <source>T&amp;alks</source>
        <translation>E&amp;ttekanded</translation>
    </message>
    <message>
        <source>Test &amp;yourself…</source>
        <translation>Kontrolli en&amp;nast…</translation>
    </message>
    <message>
        <source>The scenes as pictures, lessons, talks, and recent files</source>
        <translation>Stseenid piltidena, õppetunnid, ettekanded ja hiljutised failid</translation>
    </message>
    <message>
        <source>Try everything in the lesson&apos;s file</source>
        <translation>Proovib läbi kõik, mis õppetunni failis on</translation>
    </message>
    <message>
        <source>Two-minute &amp;tour</source>
        <translation>Kahe&amp;minutiline ringkäik</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Võta tagasi</translation>
    </message>
    <message>
        <source>What a renderer gives up to be fast: trades as pictures, measured</source>
        <translation>Millest renderdaja kiiruse nimel loobub: kompromissid piltidena, mõõdetult</translation>
    </message>
    <message>
        <source>What you did not solve alone comes back after 1, 3 and 7 days</source>
        <translation>Mida te ise ei lahendanud, tuleb tagasi 1, 3 ja 7 päeva pärast</translation>
    </message>
    <message>
        <source>While presenting, draw on the slide, or put the pen away</source>
        <translation>Esitluse ajal: joonistab slaidile või paneb pliiatsi ära</translation>
    </message>
    <message>
        <source>While presenting, mark in all panes the point under the mouse</source>
        <translation>Esitluse ajal: märgib kõigis paanides punkti, mis on hiire all</translation>
    </message>
    <message>
        <source>While presenting, show the controls of the slide below it, or hide them</source>
        <translation>Esitluse ajal: näitab slaidi all selle juhtelemente või peidab need</translation>
    </message>
    <message>
        <source>{0} in large</source>
        <translation>{0} suurelt</translation>
    </message>
    <message>
        <source>Speaker&apos;s &amp;window</source>
        <translation>Esineja &amp;aken</translation>
    </message>
    <message>
        <source>Open it when a talk is presente&amp;d</source>
        <translation>Ava see ettekande esit&amp;lemisel</translation>
    </message>
    <message>
        <source>Add th&amp;is state as a step…</source>
        <translation>Lisa p&amp;raegune olek sammuna…</translation>
    </message>
    <message>
        <source>A new talk fro&amp;m here…</source>
        <translation>Uus ettekanne siit e&amp;dasi…</translation>
    </message>
</context>
<context>
    <name>Adaptive</name>
    <message>
        <source>Making coarser versions of the scene</source>
        <translation>Stseenist tehakse jämedamad variandid</translation>
    </message>
</context>
<context>
    <name>AnimationBar</name>
    <message>
        <source>Play</source>
        <translation>Esita</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Kiirus</translation>
    </message>
    <message>
        <source>Angle per second of the walk round the vertical through the target; below 0 the camera walks the other way.</source>
        <translation>Nurk sekundis ringkäigul ümber püstsirge, mis läbib sihtpunkti; alla 0 käib kaamera teistpidi.</translation>
    </message>
    <message>
        <source>°/s</source>
        <translation>°/s</translation>
    </message>
    <message>
        <source>degrees per second</source>
        <translation>kraadi sekundis</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Kõrgus</translation>
    </message>
    <message>
        <source>How the eye&apos;s y changes during the walk (the exercise of lecture 004).</source>
        <translation>Kuidas silma y ringkäigul muutub (loengu 004 ülesanne).</translation>
    </message>
    <message>
        <source>fixed</source>
        <translation>muutumatu</translation>
    </message>
    <message>
        <source>The eye keeps its y.</source>
        <translation>Silma y jääb samaks.</translation>
    </message>
    <message>
        <source>swinging smoothly</source>
        <translation>kõigub sujuvalt</translation>
    </message>
    <message>
        <source>The eye&apos;s y swings between the lowest and the highest value.</source>
        <translation>Silma y kõigub väikseima ja suurima väärtuse vahel.</translation>
    </message>
    <message>
        <source>in steps</source>
        <translation>astmeti</translation>
    </message>
    <message>
        <source>The eye&apos;s y jumps to the next of four values every 2 seconds.</source>
        <translation>Silma y hüppab iga 2 sekundi järel järgmisele väärtusele neljast.</translation>
    </message>
    <message>
        <source>units</source>
        <translation>ühikut</translation>
    </message>
    <message>
        <source>world units</source>
        <translation>maailma ühikut</translation>
    </message>
    <message>
        <source>Lowest</source>
        <translation>Madalaim</translation>
    </message>
    <message>
        <source>The lowest y of the eye while its height changes.</source>
        <translation>Silma väikseim y, kui selle kõrgus muutub.</translation>
    </message>
    <message>
        <source>Highest</source>
        <translation>Kõrgeim</translation>
    </message>
    <message>
        <source>The highest y of the eye while its height changes.</source>
        <translation>Silma suurim y, kui selle kõrgus muutub.</translation>
    </message>
    <message>
        <source>Look</source>
        <translation>Vaade</translation>
    </message>
    <message>
        <source>Where the camera looks during the walk.</source>
        <translation>Kuhu kaamera ringkäigu ajal vaatab.</translation>
    </message>
    <message>
        <source>at the target</source>
        <translation>sihtpunkti</translation>
    </message>
    <message>
        <source>The target stays in place.</source>
        <translation>Sihtpunkt jääb paigale.</translation>
    </message>
    <message>
        <source>level</source>
        <translation>horisontaalselt</translation>
    </message>
    <message>
        <source>The target gets the eye&apos;s y: the camera looks horizontally.</source>
        <translation>Sihtpunkt saab silma y: kaamera vaatab horisontaalselt.</translation>
    </message>
    <message>
        <source>The camera is straight below the target and cannot look level.</source>
        <translation>Kaamera on otse sihtpunkti all ega saa horisontaalselt vaadata.</translation>
    </message>
    <message>
        <source>The camera stands straight above the target and cannot look level.</source>
        <translation>Kaamera on otse sihtpunkti kohal ega saa horisontaalselt vaadata.</translation>
    </message>
    <message>
        <source>The camera is at the target and cannot look at it.</source>
        <translation>Kaamera on sihtpunktis ega saa seda vaadata.</translation>
    </message>
    <message>
        <source>The camera would look along its own up vector.</source>
        <translation>Kaamera vaataks piki omaenda ülesvektorit.</translation>
    </message>
    <message>
        <source>Walk round the target, as in the exercise of lecture 004.</source>
        <translation>Käige ümber sihtpunkti, nagu loengu 004 ülesandes.</translation>
    </message>
    <message>
        <source>Pause here; playing continues from here.</source>
        <translation>Peatab siin; esitamine jätkub siit.</translation>
    </message>
    <message>
        <source>Stopped.</source>
        <translation>Peatatud.</translation>
    </message>
</context>
<context>
    <name>BlockView</name>
    <message>
        <source>Hand it &amp;in</source>
        <translation>Esita vast&amp;us</translation>
    </message>
    <message>
        <source>This is my answer; there is one try (Enter)</source>
        <translation>See on minu vastus; katseid on üks (Enter)</translation>
    </message>
    <message>
        <source>Chec&amp;k</source>
        <translation>&amp;Kontrolli</translation>
    </message>
    <message>
        <source>Enter</source>
        <translation>Sisesta</translation>
    </message>
    <message>
        <source>Kept</source>
        <translation>Salvestatud</translation>
    </message>
    <message>
        <source>Your answer is kept until the end.</source>
        <translation>Teie vastust hoitakse lõpuni alles.</translation>
    </message>
    <message>
        <source>Hint {0}:</source>
        <translation>Vihje {0}:</translation>
    </message>
    <message>
        <source>Hint:</source>
        <translation>Vihje:</translation>
    </message>
    <message>
        <source>Show the right answer, and why it is right (Alt+A)</source>
        <translation>Näitab õiget vastust ja põhjendab seda (Alt+A)</translation>
    </message>
    <message>
        <source>Show the &amp;answer</source>
        <translation>Näita v&amp;astust</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>Õige</translation>
    </message>
    <message>
        <source>Right.</source>
        <translation>Õige.</translation>
    </message>
    <message>
        <source>The idea behind it: “{0}”.</source>
        <translation>Mõte selle taga: „{0}“.</translation>
    </message>
    <message>
        <source>Wrong</source>
        <translation>Vale</translation>
    </message>
    <message>
        <source>That is not it.</source>
        <translation>See ei ole õige.</translation>
    </message>
    <message>
        <source>Show a state that makes it visible (Alt+W)</source>
        <translation>Näitab olekut, kus see näha on (Alt+D)</translation>
    </message>
    <message>
        <source>Sho&amp;w it</source>
        <translation>Näita se&amp;da</translation>
    </message>
    <message>
        <source>Show the picture with your number beside that with the model&apos;s (Alt+M)</source>
        <translation>Näitab teie arvuga pilti mudeli arvuga pildi kõrval (Alt+M)</translation>
    </message>
    <message>
        <source>Your idea beside the &amp;model</source>
        <translation>Teie mõte &amp;mudeli kõrval</translation>
    </message>
</context>
<context>
    <name>CellWords</name>
    <message>
        <source>It depends on no control.</source>
        <translation>See ei sõltu ühestki juhtelemendist.</translation>
    </message>
    <message>
        <source>It depends on: {0}.</source>
        <translation>See sõltub järgmisest: {0}.</translation>
    </message>
    <message>
        <source>row {0}, column {1}</source>
        <translation>rida {0}, veerg {1}</translation>
    </message>
    <message>
        <source>Double-click or press Enter to type another number, or a fraction such as 1/3.</source>
        <translation>Teise arvu või murru, näiteks 1/3, sisestamiseks tehke topeltklõps või vajutage Enter.</translation>
    </message>
    <message>
        <source>The world&apos;s {1} component of the camera&apos;s axis {0}: it adds {3} times {1} to {2}.</source>
        <translation>Kaamera telje {0} komponent maailma {1}-sihis: see liidab suurusele {2} arvuga {3} korrutatud suuruse {1}.</translation>
    </message>
    <message>
        <source>The {0} of the eye, where view space has its origin.</source>
        <translation>Silma {0}; silmas on kaamerafreimi alguspunkt.</translation>
    </message>
    <message>
        <source>The world&apos;s {1} component of the camera&apos;s axis {0}.</source>
        <translation>Kaamera telje {0} komponent maailma {1}-sihis.</translation>
    </message>
    <message>
        <source>It scales {0} by {2}.</source>
        <translation>See korrutab suurust {0} arvuga {2}.</translation>
    </message>
    <message>
        <source>It leaves the scale of {0} unchanged.</source>
        <translation>See jätab suuruse {0} mastaabi samaks.</translation>
    </message>
    <message>
        <source>It scales {0} by {2}, which reverses its direction.</source>
        <translation>See korrutab suurust {0} arvuga {2} ja pöörab seega selle suuna ümber.</translation>
    </message>
    <message>
        <source>It adds {2} times {1} to {0}: a shear.</source>
        <translation>See liidab suurusele {0} arvuga {2} korrutatud suuruse {1}: kaldnihe.</translation>
    </message>
    <message>
        <source>{0} does not depend on {1}.</source>
        <translation>{0} ei sõltu suurusest {1}.</translation>
    </message>
    <message>
        <source>It does not shift {0}.</source>
        <translation>See ei nihuta suurust {0}.</translation>
    </message>
    <message>
        <source>It shifts {0} by {2}.</source>
        <translation>See nihutab suurust {0} arvu {2} võrra.</translation>
    </message>
    <message>
        <source>It adds {2} to {0} before the divide, and so {2}/w to the quotient.</source>
        <translation>See liidab suurusele {0} enne jagamist arvu {2}, seega jagatisele {2}/w.</translation>
    </message>
    <message>
        <source>It adds {1} times {0} to w, the divisor.</source>
        <translation>See liidab jagajale w arvuga {1} korrutatud suuruse {0}.</translation>
    </message>
    <message>
        <source>w does not depend on {0}.</source>
        <translation>w ei sõltu suurusest {0}.</translation>
    </message>
    <message>
        <source>It scales w, the divisor, by {1}.</source>
        <translation>See korrutab jagajat w arvuga {1}.</translation>
    </message>
    <message>
        <source>It leaves w unchanged.</source>
        <translation>See jätab w muutmata.</translation>
    </message>
    <message>
        <source>It makes w, the divisor, the distance −z: perspective.</source>
        <translation>See teeb jagajast w kauguse −z: perspektiiv.</translation>
    </message>
    <message>
        <source>It adds {1} to w, the divisor.</source>
        <translation>See liidab jagajale w arvu {1}.</translation>
    </message>
    <message>
        <source>the incoming w</source>
        <translation>sisendi w</translation>
    </message>
</context>
<context>
    <name>ChainEditor</name>
    <message>
        <source>View: the camera&apos;s moves undone</source>
        <translation>Vaade: kaamera liikumised tagasi võetud</translation>
    </message>
    <message>
        <source>The view as R T, or as the inverse of each move</source>
        <translation>Vaade kujul R T või iga liikumise pöördteisendusena</translation>
    </message>
    <message>
        <source>Add a tile</source>
        <translation>Lisa lüli</translation>
    </message>
    <message>
        <source>It acts last: left of the others</source>
        <translation>See mõjub viimasena: teistest vasakul</translation>
    </message>
    <message>
        <source>Letters</source>
        <translation>Tähed</translation>
    </message>
    <message>
        <source>Row vectors</source>
        <translation>Reavektorid</translation>
    </message>
    <message>
        <source>Show its factors in Matrices</source>
        <translation>Näita selle tegureid paneelis Maatriksid</translation>
    </message>
    <message>
        <source>The tile at the bottom acts first.</source>
        <translation>Esimesena mõjub kõige alumine lüli.</translation>
    </message>
    <message>
        <source>Show the scene after this factor</source>
        <translation>Näita stseeni pärast seda tegurit</translation>
    </message>
</context>
<context>
    <name>ChoiceView</name>
    <message>
        <source>&amp;Commit</source>
        <translation>&amp;Kinnita</translation>
    </message>
    <message>
        <source>This is my prediction (Enter)</source>
        <translation>See on minu ennustus (Enter)</translation>
    </message>
    <message>
        <source>Choose one first: with the arrow keys, or a click.</source>
        <translation>Valige enne üks: nooleklahvidega või klõpsuga.</translation>
    </message>
    <message>
        <source>The answer is {0}.</source>
        <translation>Vastus on {0}.</translation>
    </message>
    <message>
        <source>The model&apos;s answer</source>
        <translation>Mudeli vastus</translation>
    </message>
    <message>
        <source>Your choice</source>
        <translation>Teie valik</translation>
    </message>
    <message>
        <source>You said {0}; the model says {1}.</source>
        <translation>Teie vastus: {0}; mudeli vastus: {1}.</translation>
    </message>
    <message>
        <source>Show what happens</source>
        <translation>Näita, mis juhtub</translation>
    </message>
    <message>
        <source>Show the model&apos;s answer once more</source>
        <translation>Näitab mudeli vastust veel kord</translation>
    </message>
</context>
<context>
    <name>ClickView</name>
    <message>
        <source>world</source>
        <translation>maailm</translation>
    </message>
    <message>
        <source>NDC cube</source>
        <translation>NDC kuup</translation>
    </message>
    <message>
        <source>image</source>
        <translation>pilt</translation>
    </message>
    <message>
        <source>Click in the picture: {0}</source>
        <translation>Klõpsake pildil: {0}</translation>
    </message>
    <message>
        <source>Click there; or here, then move the crosshair with the arrow keys (Enter)</source>
        <translation>Klõpsake seal; või siin, siis liigutage niitristi nooleklahvidega (Enter)</translation>
    </message>
    <message>
        <source>The picture shows something else now.</source>
        <translation>Pildil on nüüd midagi muud.</translation>
    </message>
    <message>
        <source>Show it a&amp;gain</source>
        <translation>&amp;Näita uuesti</translation>
    </message>
    <message>
        <source>Show the state of the question</source>
        <translation>Näitab küsimuse olekut</translation>
    </message>
</context>
<context>
    <name>Command</name>
    <message>
        <source>, or in .html for a page</source>
        <translation>, või .html lehe jaoks</translation>
    </message>
    <message>
        <source>--batch = {0!r}: has no documents (.json, .md) and no meshes.</source>
        <translation>--batch = {0!r}: selles ei ole dokumente (.json, .md) ega võrke.</translation>
    </message>
    <message>
        <source>--batch: takes one name, the folder of the figures.</source>
        <translation>--batch: võtab ühe nime, jooniste kausta.</translation>
    </message>
    <message>
        <source>--chart = {0!r}: must end in {1}.</source>
        <translation>--chart = {0!r}: lõpp peab olema {1}.</translation>
    </message>
    <message>
        <source>--csv: is an option of lesson results, not of lesson {0}.</source>
        <translation>--csv: on käsu lesson results valik, mitte käsu lesson {0} oma.</translation>
    </message>
    <message>
        <source>--for: needs --handout OUT.pdf.</source>
        <translation>--for: vajab valikut --handout OUT.pdf.</translation>
    </message>
    <message>
        <source>--format: is for a folder or a lesson; in a list the endings decide.</source>
        <translation>--format: on kausta või õppetunni jaoks; loendis otsustavad failinimede lõpud.</translation>
    </message>
    <message>
        <source>--handout = {0!r}: must end in .pdf or .html.</source>
        <translation>--handout = {0!r}: lõpp peab olema .pdf või .html.</translation>
    </message>
    <message>
        <source>--hidden: is for .svg, .pdf, .tex and .html, whose lines are shapes.</source>
        <translation>--hidden: on vormingute .svg, .pdf, .tex ja .html jaoks, kus jooned on kujundid.</translation>
    </message>
    <message>
        <source>--letters: is an option of lesson check and print, not of lesson {0}.</source>
        <translation>--letters: on käskude lesson check ja print valik, mitte käsu lesson {0} oma.</translation>
    </message>
    <message>
        <source>--orbit = {0:g}: must be from -{1:g} to {1:g} degrees, not 0.</source>
        <translation>--orbit = {0:g}: peab olema -{1:g} kuni {1:g} kraadi, aga mitte 0.</translation>
    </message>
    <message>
        <source>--orbit: needs the pane world, and --panes = {0!r}.</source>
        <translation>--orbit: vajab paani world, aga --panes = {0!r}.</translation>
    </message>
    <message>
        <source>--out = {0!r}: cannot be made a folder: {1}.</source>
        <translation>--out = {0!r}: sellest ei saa kausta teha: {1}.</translation>
    </message>
    <message>
        <source>--panes = {0!r}: must be a row or a column, not both.</source>
        <translation>--panes = {0!r}: peab olema rida või veerg, mitte mõlemad.</translation>
    </message>
    <message>
        <source>--scale: is for .png; shapes are as fine at every scale.</source>
        <translation>--scale: on vormingu .png jaoks; kujundid on igas mastaabis ühtviisi teravad.</translation>
    </message>
    <message>
        <source>--screenshot = {0!r}: must end in .png.</source>
        <translation>--screenshot = {0!r}: lõpp peab olema .png.</translation>
    </message>
    <message>
        <source>--seeds = {0!r}: has {1} variants; the limit is {2}.</source>
        <translation>--seeds = {0!r}: variante on {1}; piir on {2}.</translation>
    </message>
    <message>
        <source>--seeds = {0!r}: must be FIRST:LAST, such as 1:30, from 1 to {1}.</source>
        <translation>--seeds = {0!r}: peab olema FIRST:LAST, näiteks 1:30, arvudega 1 kuni {1}.</translation>
    </message>
    <message>
        <source>--set scene: the steps of a lesson have scenes of their own.</source>
        <translation>--set scene: õppetunni sammudel on omad stseenid.</translation>
    </message>
    <message>
        <source>--set {0}: {1} is a lesson, whose steps set what is shown.</source>
        <translation>--set {0}: {1} on õppetund, mille sammud määravad, mida näidatakse.</translation>
    </message>
    <message>
        <source>--size = {0!r}: must be WIDTHxHEIGHT in pixels, such as 1800x600.</source>
        <translation>--size = {0!r}: peab olema WIDTHxHEIGHT pikslites, näiteks 1800x600.</translation>
    </message>
    <message>
        <source>       … and {0} more; --csv has them all</source>
        <translation>       … ja veel {0}; --csv-s on kõik</translation>
    </message>
    <message>
        <source>  installing packages: {0}</source>
        <translation>  paigaldan pakette: {0}</translation>
    </message>
    <message>
        <source> (cancelled)</source>
        <translation> (katkestatud)</translation>
    </message>
    <message>
        <source> failed</source>
        <translation> ebaõnnestus</translation>
    </message>
    <message>
        <source> is there already</source>
        <translation> on juba olemas</translation>
    </message>
    <message>
        <source>, or have one number such as %03d</source>
        <translation>, või olgu nimes üks arv nagu %03d</translation>
    </message>
    <message>
        <source>--size, --width and --text-size: need --chart.</source>
        <translation>--size, --width ja --text-size: vajavad valikut --chart.</translation>
    </message>
    <message>
        <source>--stages: needs the pane ndc, and --panes = {0!r}.</source>
        <translation>--stages: vajab paani ndc, aga --panes = {0!r}.</translation>
    </message>
    <message>
        <source>--step = {0!r}: must be a number from 1 to {1}, or the name of a step{2}.</source>
        <translation>--step = {0!r}: peab olema arv 1 kuni {1} või sammu nimi{2}.</translation>
    </message>
    <message>
        <source>--step: is a column of the list of --batch.</source>
        <translation>--step: on valiku --batch loendi veerg.</translation>
    </message>
    <message>
        <source>--step: needs a lesson or a talk as FILE.</source>
        <translation>--step: vajab õppetundi või ettekannet (FILE).</translation>
    </message>
    <message>
        <source>--sweep {0} = &apos;&apos;: must be LOW:HIGH, such as 0.001:10.</source>
        <translation>--sweep {0} = &apos;&apos;: peab olema LOW:HIGH, näiteks 0.001:10.</translation>
    </message>
    <message>
        <source>--sweep {0} = {1!r}: must be LOW:HIGH, such as 0.001:10.</source>
        <translation>--sweep {0} = {1!r}: peab olema LOW:HIGH, näiteks 0.001:10.</translation>
    </message>
    <message>
        <source>--sweep {0} = {1!r}: must have LOW below HIGH, both from {2:g} to {3:.15g}.</source>
        <translation>--sweep {0} = {1!r}: LOW peab olema väiksem kui HIGH ja mõlemad {2:g} kuni {3:.15g}.</translation>
    </message>
    <message>
        <source>--topics = {0!r}: has no exercise that can be solved on paper.</source>
        <translation>--topics = {0!r}: ei sisalda ühtki ülesannet, mida saab paberil lahendada.</translation>
    </message>
    <message>
        <source>--topics = {0!r}: must be topics from L1 to L{1}, or files of lessons, separated by commas.</source>
        <translation>--topics = {0!r}: peavad olema teemad L1 kuni L{1} või õppetundide failid, eraldatud komadega.</translation>
    </message>
    <message>
        <source>--topics = {0!r}: names {1} twice.</source>
        <translation>--topics = {0!r}: nimetab {1} kaks korda.</translation>
    </message>
    <message>
        <source>--transition: needs a lesson or a talk as FILE, and --step.</source>
        <translation>--transition: vajab õppetundi või ettekannet (FILE) ja valikut --step.</translation>
    </message>
    <message>
        <source>--transition: no step comes before --step {0}.</source>
        <translation>--transition: enne valikut --step {0} ei ole ühtki sammu.</translation>
    </message>
    <message>
        <source>--transition: step {0} shows another scene or another kind of lens than the step before; nothing moves from one to the other.</source>
        <translation>--transition: samm {0} näitab teist stseeni või teist liiki objektiivi kui eelmine samm; ühest teise ei liigu midagi.</translation>
    </message>
    <message>
        <source>--transition: step {0} shows the same as the step before.</source>
        <translation>--transition: samm {0} näitab sama mis eelmine samm.</translation>
    </message>
    <message>
        <source>--transparent: {0} has {1}; write .apng or .webp.</source>
        <translation>--transparent: {0}: {1}; kirjutage .apng või .webp.</translation>
    </message>
    <message>
        <source>--vectors: needs --convention.</source>
        <translation>--vectors: vajab valikut --convention.</translation>
    </message>
    <message>
        <source>--width = {0!r}: must be a length in {1} from {2}pt to {3}pt, such as 84mm.</source>
        <translation>--width = {0!r}: peab olema pikkus ühikutes {1}, vahemikus {2}pt kuni {3}pt, näiteks 84mm.</translation>
    </message>
    <message>
        <source>--width: is cropped, and its height is free; leave out --size and --crop.</source>
        <translation>--width: joonis kärbitakse ja selle kõrgus on vaba; jätke --size ja --crop ära.</translation>
    </message>
    <message>
        <source>--width: its height is free; leave out --size.</source>
        <translation>--width: kõrgus on vaba; jätke --size ära.</translation>
    </message>
    <message>
        <source>--{0}: cannot be used with --{1}.</source>
        <translation>--{0}: ei saa kasutada koos valikuga --{1}.</translation>
    </message>
    <message>
        <source>--{0}: frames of a film have one size; set --size.</source>
        <translation>--{0}: filmi kaadrid on ühesuurused; seadke --size.</translation>
    </message>
    <message>
        <source>--{0}: is an option of lesson print, not of lesson {1}.</source>
        <translation>--{0}: on käsu lesson print valik, mitte käsu lesson {1} oma.</translation>
    </message>
    <message>
        <source>--{0}: is for single figures; frames of a film have one size.</source>
        <translation>--{0}: on üksikute jooniste jaoks; filmi kaadrid on ühesuurused.</translation>
    </message>
    <message>
        <source>--{0}: is not for .html, whose pictures change under a slider.</source>
        <translation>--{0}: ei ole vormingu .html jaoks, mille pildid muutuvad liuguriga.</translation>
    </message>
    <message>
        <source>--{0}: needs --format latex.</source>
        <translation>--{0}: vajab valikut --format latex.</translation>
    </message>
    <message>
        <source>--{0}: needs --sweep.</source>
        <translation>--{0}: vajab valikut --sweep.</translation>
    </message>
    <message>
        <source>--{0}: needs {1}.</source>
        <translation>--{0}: vajab valikut {1}.</translation>
    </message>
    <message>
        <source>--{0}: stands alone, and needs --format text or json.</source>
        <translation>--{0}: kasutatakse üksinda ja vajab valikut --format text või json.</translation>
    </message>
    <message>
        <source>; for a film add --sweep, --orbit, --stages or --transition</source>
        <translation>; filmi jaoks lisage --sweep, --orbit, --stages või --transition</translation>
    </message>
    <message>
        <source>; needs the network</source>
        <translation>; vajab võrku</translation>
    </message>
    <message>
        <source>; the nearest is {0}</source>
        <translation>; lähim on {0}</translation>
    </message>
    <message>
        <source>A library cannot be loaded ({0}); {1} doctor says more.</source>
        <translation>Teeki ei saa laadida ({0}); rohkem ütleb {1} doctor.</translation>
    </message>
    <message>
        <source>Display</source>
        <translation>Kuva</translation>
    </message>
    <message>
        <source>Environment</source>
        <translation>Keskkond</translation>
    </message>
    <message>
        <source>Everything needed is here.</source>
        <translation>Kõik vajalik on olemas.</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>Eksport</translation>
    </message>
    <message>
        <source>Left out, because it is done in the window: {0}.</source>
        <translation>Välja jäetud, sest seda tehakse aknas: {0}.</translation>
    </message>
    <message>
        <source>Log folder</source>
        <translation>Logikaust</translation>
    </message>
    <message>
        <source>No OpenGL could be started, and 3.2 is needed. {0}</source>
        <translation>OpenGL-i ei saanud käivitada, aga vaja on versiooni 3.2. {0}</translation>
    </message>
    <message>
        <source>No idea explains (answers; lesson, exercise, variant; what was typed; right):</source>
        <translation>Ükski väärarusaam ei seleta (vastuseid; õppetund, ülesanne, variant; mis sisestati; õige):</translation>
    </message>
    <message>
        <source>OUT = {0!r}: .mp4 has even sides in pixels, not {1}; set --size.</source>
        <translation>OUT = {0!r}: vormingus .mp4 on küljed paarisarv piksleid, mitte {1}; seadke --size.</translation>
    </message>
    <message>
        <source>OUT = {0!r}: .webp has at most {1} pixels along each side.</source>
        <translation>OUT = {0!r}: vormingus .webp on kummalgi küljel ülimalt {1} pikslit.</translation>
    </message>
    <message>
        <source>OUT = {0!r}: must be a folder, for the figures.</source>
        <translation>OUT = {0!r}: peab olema kaust jooniste jaoks.</translation>
    </message>
    <message>
        <source>OUT = {0!r}: must end in {1}{2}.</source>
        <translation>OUT = {0!r}: lõpp peab olema {1}{2}.</translation>
    </message>
    <message>
        <source>Only OpenGL ES is offered here ({0}), not OpenGL 3.2. {1}</source>
        <translation>Siin on ainult OpenGL ES ({0}), mitte OpenGL 3.2. {1}</translation>
    </message>
    <message>
        <source>OpenGL {0}.{1} is too old ({2}): 3.2 is needed. {3}</source>
        <translation>OpenGL {0}.{1} on liiga vana ({2}): vaja on versiooni 3.2. {3}</translation>
    </message>
    <message>
        <source>P does not say near, far and the size of the image</source>
        <translation>P ei ütle lähi- ja kaugtasandit ega pildi suurust</translation>
    </message>
    <message>
        <source>P has w &gt; 0 behind the camera: perhaps y points up in its image</source>
        <translation>P-l on w &gt; 0 kaamera taga: võib-olla on y selle pildil suunatud üles</translation>
    </message>
    <message>
        <source>POINTS = {0!r}: must be a CSV file, or - for standard input; for a point: echo {1} | {2} project -.</source>
        <translation>POINTS = {0!r}: peab olema CSV-fail või - standardsisendi jaoks; ühe punkti jaoks: echo {1} | {2} project -.</translation>
    </message>
    <message>
        <source>POINTS is missing: {0} gives the camera only.</source>
        <translation>POINTS puudub: {0} annab ainult kaamera.</translation>
    </message>
    <message>
        <source>Panes</source>
        <translation>Paanid</translation>
    </message>
    <message>
        <source>Platform</source>
        <translation>Platvorm</translation>
    </message>
    <message>
        <source>PyInstaller ended with status {0}.</source>
        <translation>PyInstaller lõppes olekuga {0}.</translation>
    </message>
    <message>
        <source>Python {0}, {1} bits, {2},</source>
        <translation>Python {0}, {1} bitti, {2},</translation>
    </message>
    <message>
        <source>QT_QPA_PLATFORM = {0}: must be one of {1}; unset it.</source>
        <translation>QT_QPA_PLATFORM = {0}: peab olema üks järgmistest: {1}; eemaldage see muutuja.</translation>
    </message>
    <message>
        <source>Qt cannot reach the X server, because a system library is missing ({0}); {1} doctor says which package provides it.</source>
        <translation>Qt ei saa ühendust X-serveriga, sest süsteemi teek puudub ({0}); {1} doctor ütleb, millises paketis see on.</translation>
    </message>
    <message>
        <source>Qt&apos;s platform {0} shows no OpenGL windows. {1}</source>
        <translation>Qt platvorm {0} ei näita OpenGL-i aknaid. {1}</translation>
    </message>
    <message>
        <source>Recovery folder</source>
        <translation>Taastekaust</translation>
    </message>
    <message>
        <source>Screen</source>
        <translation>Ekraan</translation>
    </message>
    <message>
        <source>Set aside</source>
        <translation>Kõrvale jäetud</translation>
    </message>
    <message>
        <source>Settings folder</source>
        <translation>Sätete kaust</translation>
    </message>
    <message>
        <source>Standard input</source>
        <translation>Standardsisend</translation>
    </message>
    <message>
        <source>Standard output cannot be written: {0}.</source>
        <translation>Standardväljundisse ei saa kirjutada: {0}.</translation>
    </message>
    <message>
        <source>Standard output is closed.</source>
        <translation>Standardväljund on suletud.</translation>
    </message>
    <message>
        <source>System libraries</source>
        <translation>Süsteemi teegid</translation>
    </message>
    <message>
        <source>The X server DISPLAY = {0} does not answer or does not let this user in</source>
        <translation>X-server DISPLAY = {0} ei vasta või ei lase seda kasutajat sisse</translation>
    </message>
    <message>
        <source>The other states need scripts.</source>
        <translation>Teiste olekute jaoks on vaja skripte.</translation>
    </message>
    <message>
        <source>The settings cannot be deleted: {0}.</source>
        <translation>Sätteid ei saa kustutada: {0}.</translation>
    </message>
    <message>
        <source>The window</source>
        <translation>Aken</translation>
    </message>
    <message>
        <source>There is no screen to open a window on ({0} names none)</source>
        <translation>Pole ekraani, kus akent avada ({0} ei nimeta ühtegi)</translation>
    </message>
    <message>
        <source>This is missing:</source>
        <translation>Puudub:</translation>
    </message>
    <message>
        <source>This page does not keep what you type; print it to keep it.</source>
        <translation>See leht ei säilita, mida sisestate; säilitamiseks printige see.</translation>
    </message>
    <message>
        <source>Update the graphics driver; on Linux install Mesa (libgl1-mesa-dri) or start with LIBGL_ALWAYS_SOFTWARE=1, and over a remote desktop use one that offers OpenGL.</source>
        <translation>Uuendage graafikadraiverit; Linuxis paigaldage Mesa (libgl1-mesa-dri) või käivitage muutujaga LIBGL_ALWAYS_SOFTWARE=1, ja kaugtöölaual kasutage sellist, mis pakub OpenGL-i.</translation>
    </message>
    <message>
        <source>WIDTHxHEIGHT in {0}, such as 120mmx80mm or 1800x600</source>
        <translation>WIDTHxHEIGHT ühikutes {0}, näiteks 120mmx80mm või 1800x600</translation>
    </message>
    <message>
        <source>Window</source>
        <translation>Aken</translation>
    </message>
    <message>
        <source>Wrong ideas (answers, students):</source>
        <translation>Väärarusaamad (vastuseid, tudengeid):</translation>
    </message>
    <message>
        <source>Your answer</source>
        <translation>Teie vastus</translation>
    </message>
    <message>
        <source>a finite number</source>
        <translation>lõplik arv</translation>
    </message>
    <message>
        <source>a font</source>
        <translation>font</translation>
    </message>
    <message>
        <source>a length in {0}, such as 84mm</source>
        <translation>pikkus ühikutes {0}, näiteks 84mm</translation>
    </message>
    <message>
        <source>a number of degrees</source>
        <translation>kraadide arv</translation>
    </message>
    <message>
        <source>a number of points</source>
        <translation>punktide arv</translation>
    </message>
    <message>
        <source>a part</source>
        <translation>osa</translation>
    </message>
    <message>
        <source>a whole number</source>
        <translation>täisarv</translation>
    </message>
    <message>
        <source>a whole number from 1 to 17</source>
        <translation>täisarv 1 kuni 17</translation>
    </message>
    <message>
        <source>a x + b y + c z + d &gt;= 0 in the view volume, in world space</source>
        <translation>a x + b y + c z + d &gt;= 0 nähtavas ruumis, maailma koordinaatides</translation>
    </message>
    <message>
        <source>all here</source>
        <translation>kõik olemas</translation>
    </message>
    <message>
        <source>and {0} more</source>
        <translation>ja veel {0}</translation>
    </message>
    <message>
        <source>angle = {0}°</source>
        <translation>nurk = {0}°</translation>
    </message>
    <message>
        <source>another start is setting up Frustum Lab; waiting for it to finish</source>
        <translation>teine käivitus seab parajasti Frustum Labi üles; ootan, kuni see lõpetab</translation>
    </message>
    <message>
        <source>apt-get failed ({0}); try: {1}</source>
        <translation>apt-get ebaõnnestus ({0}); proovige: {1}</translation>
    </message>
    <message>
        <source>argument %(argument_name)s: %(message)s</source>
        <translation>%(argument_name)s: %(message)s</translation>
    </message>
    <message>
        <source>at infinity</source>
        <translation>lõpmatuses</translation>
    </message>
    <message>
        <source>bringing {0} up to date</source>
        <translation>ajakohastan: {0}</translation>
    </message>
    <message>
        <source>bundle needs PyInstaller, which is not installed; run: {0}</source>
        <translation>bundle vajab programmi PyInstaller, mis ei ole paigaldatud; käivitage: {0}</translation>
    </message>
    <message>
        <source>bundle: this program has no folder of its code to make one of.</source>
        <translation>bundle: sellel programmil ei ole lähtekoodi kausta, millest seda teha.</translation>
    </message>
    <message>
        <source>cannot be loaded: {0}</source>
        <translation>ei saa laadida: {0}</translation>
    </message>
    <message>
        <source>capitals are {0:.1%} of the screen&apos;s height; must be from {1:.1%} to {2:.1%}.</source>
        <translation>suurtähtede kõrgus on {0:.1%} ekraani kõrgusest; peab olema {1:.1%} kuni {2:.1%}.</translation>
    </message>
    <message>
        <source>check the network and run again: {again}</source>
        <translation>kontrollige võrku ja käivitage uuesti: {again}</translation>
    </message>
    <message>
        <source>close all windows of Frustum Lab and run again: {again}</source>
        <translation>sulgege kõik Frustum Labi aknad ja käivitage uuesti: {again}</translation>
    </message>
    <message>
        <source>column vectors, M p</source>
        <translation>veeruvektorid, M p</translation>
    </message>
    <message>
        <source>commands are {0}</source>
        <translation>käsud on {0}</translation>
    </message>
    <message>
        <source>computed in {0}; errors are below: {1}</source>
        <translation>arvutatud: {0}; vead on väiksemad kui: {1}</translation>
    </message>
    <message>
        <source>does not answer within {0:g} s</source>
        <translation>ei vasta {0:g} s jooksul</translation>
    </message>
    <message>
        <source>drawn in the window by OpenGL</source>
        <translation>aknas joonistab OpenGL</translation>
    </message>
    <message>
        <source>drawn off-screen and painted as pixels</source>
        <translation>joonistatakse ekraaniväliselt ja näidatakse pikslitena</translation>
    </message>
    <message>
        <source>exit status {0}</source>
        <translation>väljumisolek {0}</translation>
    </message>
    <message>
        <source>expected one argument</source>
        <translation>vaja on ühte argumenti</translation>
    </message>
    <message>
        <source>file = {0!r}: is a lesson; name its step in a column step, or write a number such as %02d in out = {1!r}.</source>
        <translation>file = {0!r}: on õppetund; nimetage selle samm veerus step või kirjutage number, näiteks %02d, väljale out = {1!r}.</translation>
    </message>
    <message>
        <source>first start: setting up {0} (once{1})</source>
        <translation>esimene käivitus: sean üles {0} (üks kord{1})</translation>
    </message>
    <message>
        <source>float32 cannot hold its numbers</source>
        <translation>float32 ei mahuta selle arve</translation>
    </message>
    <message>
        <source>for x right, y down, z forward; pixels from the centre of the first one</source>
        <translation>kui x on paremale, y alla ja z ette; pikslid esimese piksli keskpunktist</translation>
    </message>
    <message>
        <source>frame {0}/{1}</source>
        <translation>kaader {0}/{1}</translation>
    </message>
    <message>
        <source>going on with the installed packages</source>
        <translation>jätkan paigaldatud pakettidega</translation>
    </message>
    <message>
        <source>going on with the installed packages, which do not meet {0}</source>
        <translation>jätkan paigaldatud pakettidega, mis ei vasta nõudele {0}</translation>
    </message>
    <message>
        <source>graphics card</source>
        <translation>graafikakaart</translation>
    </message>
    <message>
        <source>has {0} columns, but the first row names {1}.</source>
        <translation>veerge on {0}, aga esimene rida nimetab neid {1}.</translation>
    </message>
    <message>
        <source>ignored explicit argument %r</source>
        <translation>ei võta väärtust %r</translation>
    </message>
    <message>
        <source>inside</source>
        <translation>sees</translation>
    </message>
    <message>
        <source>install Mesa (libegl1 libegl-mesa0 libgl1-mesa-dri), or update the driver</source>
        <translation>paigaldage Mesa (libegl1 libegl-mesa0 libgl1-mesa-dri) või uuendage draiverit</translation>
    </message>
    <message>
        <source>installing system packages: {0}</source>
        <translation>paigaldan süsteemi pakette: {0}</translation>
    </message>
    <message>
        <source>it is a device, neither a file nor a pipe</source>
        <translation>see on seade, mitte fail ega toru</translation>
    </message>
    <message>
        <source>it is closed</source>
        <translation>see on suletud</translation>
    </message>
    <message>
        <source>it is larger than {0} MiB</source>
        <translation>see on suurem kui {0} MiB</translation>
    </message>
    <message>
        <source>its view coordinates are at infinity</source>
        <translation>selle koordinaadid kaamerafreimis on lõpmatuses</translation>
    </message>
    <message>
        <source>key</source>
        <translation>vastusevõti</translation>
    </message>
    <message>
        <source>largest error in px</source>
        <translation>suurim viga pikslites</translation>
    </message>
    <message>
        <source>left-handed world: z reversed; the view looks along -z, y up (worldToCameraMatrix)</source>
        <translation>vasaku käe maailm: z vastupidine; kaamera vaatab piki -z, y üles (worldToCameraMatrix)</translation>
    </message>
    <message>
        <source>left-handed: world z reversed; looks along +z, y up</source>
        <translation>vasaku käe süsteem: maailma z vastupidine; vaatab piki +z, y üles</translation>
    </message>
    <message>
        <source>lens.kind = matrix: a free matrix has no near, no far and no angle to measure; it must be one of {0}.</source>
        <translation>lens.kind = matrix: vabal maatriksil ei ole lähitasandit, kaugtasandit ega nurka, mida mõõta; peab olema üks järgmistest: {0}.</translation>
    </message>
    <message>
        <source>lesson</source>
        <translation>õppetund</translation>
    </message>
    <message>
        <source>lesson = {0!r}: must be one of {1}; {2} {0} opens the lesson.</source>
        <translation>lesson = {0!r}: peab olema üks järgmistest: {1}; {2} {0} avab õppetunni.</translation>
    </message>
    <message>
        <source>lesson print needs --{0}.</source>
        <translation>lesson print vajab valikut --{0}.</translation>
    </message>
    <message>
        <source>lesson print takes no FILE such as {0!r}: use --topics.</source>
        <translation>lesson print ei võta faili (FILE) nagu {0!r}: kasutage valikut --topics.</translation>
    </message>
    <message>
        <source>lesson results needs a FILE.</source>
        <translation>lesson results vajab faili (FILE).</translation>
    </message>
    <message>
        <source>line</source>
        <translation>rida</translation>
    </message>
    <message>
        <source>looks along -z, y up</source>
        <translation>vaatab piki -z, y üles</translation>
    </message>
    <message>
        <source>looks along -z; y of clip down</source>
        <translation>vaatab piki -z; kärperuumi y alla</translation>
    </message>
    <message>
        <source>make {0} a folder that you may write to</source>
        <translation>tehke nii, et {0} oleks kaust, kuhu tohite kirjutada</translation>
    </message>
    <message>
        <source>missing</source>
        <translation>puudub</translation>
    </message>
    <message>
        <source>missing: {0}</source>
        <translation>puudub: {0}</translation>
    </message>
    <message>
        <source>nearest command is {0}</source>
        <translation>lähim käsk on {0}</translation>
    </message>
    <message>
        <source>no names</source>
        <translation>null nime</translation>
    </message>
    <message>
        <source>no package server could be reached</source>
        <translation>ühegi paketiserveriga ei saanud ühendust</translation>
    </message>
    <message>
        <source>no smooth edges then</source>
        <translation>siis ei ole servad sujuvad</translation>
    </message>
    <message>
        <source>no tested version of {0} here: trying others</source>
        <translation>siin pole paketi {0} testitud versiooni: proovin teisi</translation>
    </message>
    <message>
        <source>no transparency</source>
        <translation>läbipaistvust ei ole</translation>
    </message>
    <message>
        <source>no version fits {python} on this machine; use another Python</source>
        <translation>selles arvutis on {python} millega ei sobi ükski versioon; kasutage teist Pythonit</translation>
    </message>
    <message>
        <source>none</source>
        <translation>pole</translation>
    </message>
    <message>
        <source>none for windows: {0}</source>
        <translation>akende jaoks pole: {0}</translation>
    </message>
    <message>
        <source>none: {0}</source>
        <translation>pole: {0}</translation>
    </message>
    <message>
        <source>not set up yet</source>
        <translation>veel üles seadmata</translation>
    </message>
    <message>
        <source>not without ffmpeg; .webp needs none</source>
        <translation>mitte ilma ffmpeg-ita; .webp seda ei vaja</translation>
    </message>
    <message>
        <source>options</source>
        <translation>valikud</translation>
    </message>
    <message>
        <source>out = {0!r}: is a link, which may lead out of {1}.</source>
        <translation>out = {0!r}: on nimeviit, mis võib kaustast {1} välja viia.</translation>
    </message>
    <message>
        <source>out = {0!r}: is written by {1}.</source>
        <translation>out = {0!r}: selle kirjutab juba {1}.</translation>
    </message>
    <message>
        <source>out = {0!r}: must be a file name without a folder.</source>
        <translation>out = {0!r}: peab olema failinimi ilma kaustata.</translation>
    </message>
    <message>
        <source>outside of</source>
        <translation>väljaspool:</translation>
    </message>
    <message>
        <source>overwritten</source>
        <translation>üle kirjutatud</translation>
    </message>
    <message>
        <source>packages</source>
        <translation>mõni pakett</translation>
    </message>
    <message>
        <source>part of the text is only in the speaker&apos;s notes: {0}</source>
        <translation>osa tekstist on ainult esineja märkmetes: {0}</translation>
    </message>
    <message>
        <source>pip does not find all packages for {0}, Python {1}.</source>
        <translation>pip ei leia kõiki pakette: {0}, Python {1}.</translation>
    </message>
    <message>
        <source>point {0}</source>
        <translation>punkt {0}</translation>
    </message>
    <message>
        <source>positional arguments</source>
        <translation>argumendid</translation>
    </message>
    <message>
        <source>put Frustum Lab into a folder that you may write to</source>
        <translation>pange Frustum Lab kausta, kuhu tohite kirjutada</translation>
    </message>
    <message>
        <source>row vectors, p M</source>
        <translation>reavektorid, p M</translation>
    </message>
    <message>
        <source>run again: {again}; {program} doctor says more</source>
        <translation>käivitage uuesti: {again}; rohkem ütleb {program} doctor</translation>
    </message>
    <message>
        <source>scale = {0} is free, and so is its sign</source>
        <translation>scale = {0} on vaba ja märk samuti</translation>
    </message>
    <message>
        <source>see Window</source>
        <translation>vt Aken</translation>
    </message>
    <message>
        <source>see the system libraries above</source>
        <translation>vt süsteemi teeke eespool</translation>
    </message>
    <message>
        <source>set up in {0:.0f} s</source>
        <translation>üles seatud, aeg {0:.0f} s</translation>
    </message>
    <message>
        <source>show this help message and exit</source>
        <translation>näita seda abi ja lõpeta</translation>
    </message>
    <message>
        <source>smallest gap in world units</source>
        <translation>väikseim vahe maailma ühikutes</translation>
    </message>
    <message>
        <source>so far</source>
        <translation>seni</translation>
    </message>
    <message>
        <source>software, without a graphics card</source>
        <translation>tarkvaraline, ilma graafikakaardita</translation>
    </message>
    <message>
        <source>talk</source>
        <translation>ettekanne</translation>
    </message>
    <message>
        <source>talk needs --check or --handout OUT.pdf; {0} {1} opens the talk.</source>
        <translation>talk vajab valikut --check või --handout OUT.pdf; {0} {1} avab ettekande.</translation>
    </message>
    <message>
        <source>the Python packages could not be installed</source>
        <translation>Pythoni pakette ei saanud paigaldada</translation>
    </message>
    <message>
        <source>the camera looks along +z, y down; K is in pixels, the first pixel&apos;s centre at 0, 0</source>
        <translation>kaamera vaatab piki +z, y alla; K on pikslites, esimese piksli keskpunkt on 0, 0</translation>
    </message>
    <message>
        <source>the driver crashed (signal {0})</source>
        <translation>draiver jooksis kokku (signaal {0})</translation>
    </message>
    <message>
        <source>the first start sets it up, which needs the network: {0}</source>
        <translation>selle seab üles esimene käivitus, milleks on vaja võrku: {0}</translation>
    </message>
    <message>
        <source>the following arguments are required: %s</source>
        <translation>puuduvad argumendid: %s</translation>
    </message>
    <message>
        <source>the package server does not answer; trying again</source>
        <translation>paketiserver ei vasta; proovin uuesti</translation>
    </message>
    <message>
        <source>the package {0} is damaged ({1}); replace it, and start again: {2}</source>
        <translation>pakett {0} on rikutud ({1}); asendage see ja käivitage uuesti: {2}</translation>
    </message>
    <message>
        <source>the path {folder} is too long: move the folder of the code nearer to the drive&apos;s root</source>
        <translation>tee {folder} on liiga pikk: viige koodi kaust ketta juurkaustale lähemale</translation>
    </message>
    <message>
        <source>the picture is at infinity too: w = 0, and lines of this direction stay parallel</source>
        <translation>ka kujutis on lõpmatuses: w = 0, ja selle suuna sirged jäävad paralleelseks</translation>
    </message>
    <message>
        <source>the point at infinity is behind the eye; the opposite direction has a picture</source>
        <translation>lõpmatuspunkt on silma taga; vastassuunal on kujutis</translation>
    </message>
    <message>
        <source>the point is in front of the eye; its pixel is larger than float64 can hold</source>
        <translation>punkt on silma ees; selle piksel on suurem, kui float64 mahutab</translation>
    </message>
    <message>
        <source>the point is not in front of the eye</source>
        <translation>punkt pole silma ees</translation>
    </message>
    <message>
        <source>the rightmost factor acts first</source>
        <translation>kõige parempoolne tegur mõjub esimesena</translation>
    </message>
    <message>
        <source>the set-up failed</source>
        <translation>ülesseadmine ebaõnnestus</translation>
    </message>
    <message>
        <source>the set-up was stopped; to go on: {0}</source>
        <translation>ülesseadmine katkestati; jätkamiseks: {0}</translation>
    </message>
    <message>
        <source>the skew {0:.1g} of K is left out: so many px at 45 degrees above or below</source>
        <translation>K kalle {0:.1g} on välja jäetud: teljest 45 kraadi üles- või allapoole on viga nii mitu pikslit</translation>
    </message>
    <message>
        <source>the text is longer or higher than the two lines above the picture.</source>
        <translation>tekst on pikem või kõrgem kui kaks rida pildi kohal.</translation>
    </message>
    <message>
        <source>the view volume</source>
        <translation>nähtav ruum</translation>
    </message>
    <message>
        <source>the window</source>
        <translation>aken</translation>
    </message>
    <message>
        <source>there is no room</source>
        <translation>ruumi pole</translation>
    </message>
    <message>
        <source>this machine&apos;s rules forbid programs in {folder}; ask who set it up</source>
        <translation>selle arvuti reeglid keelavad programmid kaustas {folder}; küsige arvuti ülesseadjalt</translation>
    </message>
    <message>
        <source>this system lacks {0}; install what provides them, and start again</source>
        <translation>selles süsteemis puudub: {0}; paigaldage vajalik ja käivitage uuesti</translation>
    </message>
    <message>
        <source>this system lacks {0}; run: {1}</source>
        <translation>selles süsteemis puudub: {0}; käivitage: {1}</translation>
    </message>
    <message>
        <source>through {0}</source>
        <translation>vahend: {0}</translation>
    </message>
    <message>
        <source>too little space is left: free {space} GB beside {folder}, or set TMPDIR if the folder of temporary files is full, and run again: {again}</source>
        <translation>ruumi on liiga vähe: vabastage {space} GB kettal, kus on {folder}, või määrake TMPDIR, kui ajutiste failide kaust on täis, ja käivitage uuesti: {again}</translation>
    </message>
    <message>
        <source>unrecognized arguments: %s</source>
        <translation>tundmatud argumendid: %s</translation>
    </message>
    <message>
        <source>update the graphics driver, or start with LIBGL_ALWAYS_SOFTWARE=1</source>
        <translation>uuendage graafikadraiverit või käivitage muutujaga LIBGL_ALWAYS_SOFTWARE=1</translation>
    </message>
    <message>
        <source>usage: </source>
        <translation>kasutus: </translation>
    </message>
    <message>
        <source>view.names has {0}, which no pane draws here.</source>
        <translation>view.names sisaldab {0}, mida siin ükski paan ei joonista.</translation>
    </message>
    <message>
        <source>way = {0} %</source>
        <translation>tee = {0} %</translation>
    </message>
    <message>
        <source>what is drawn covers {0:.0%} of the width and {1:.0%} of the height; at least {2:.0%} of one of them, and below {3:.0%} also {4:.0%} of the area.</source>
        <translation>joonistatu katab {0:.0%} laiusest ja {1:.0%} kõrgusest; vähemalt ühest peab katma {2:.0%}, ja kui see on alla {3:.0%}, siis ka {4:.0%} pindalast.</translation>
    </message>
    <message>
        <source>without a display through {0}, {1}</source>
        <translation>ilma kuvata, vahend: {0}, {1}</translation>
    </message>
    <message>
        <source>written</source>
        <translation>kirjutatud</translation>
    </message>
    <message>
        <source>x, y and z divided by w</source>
        <translation>x, y ja z jagatud w-ga</translation>
    </message>
    <message>
        <source>{0!r} is in the current folder, which was deleted.</source>
        <translation>{0!r} on praeguses kaustas, mis on kustutatud.</translation>
    </message>
    <message>
        <source>{0!r} is not a name that a file can have.</source>
        <translation>{0!r} ei sobi faili nimeks.</translation>
    </message>
    <message>
        <source>{0} (needed: {1})</source>
        <translation>{0} (vajalik: {1})</translation>
    </message>
    <message>
        <source>{0} = {1!r}: has a character NUL.</source>
        <translation>{0} = {1!r}: sisaldab märki NUL.</translation>
    </message>
    <message>
        <source>{0} = {1!r}: is a folder.</source>
        <translation>{0} = {1!r}: on kaust.</translation>
    </message>
    <message>
        <source>{0} = {1!r}: is a pipe or a device, not a regular file.</source>
        <translation>{0} = {1!r}: on toru või seade, mitte tavaline fail.</translation>
    </message>
    <message>
        <source>{0} = {1!r}: is read by this command; write to another file.</source>
        <translation>{0} = {1!r}: seda faili loeb see käsk; kirjutage mõnda teise faili.</translation>
    </message>
    <message>
        <source>{0} = {1!r}: may not be written.</source>
        <translation>{0} = {1!r}: kirjutamine ei ole lubatud.</translation>
    </message>
    <message>
        <source>{0} = {1!r}: must be one of {2}.</source>
        <translation>{0} = {1!r}: peab olema üks järgmistest: {2}.</translation>
    </message>
    <message>
        <source>{0} = {1!r}: must be true or false.</source>
        <translation>{0} = {1!r}: peab olema true või false.</translation>
    </message>
    <message>
        <source>{0} = {1!r}: must be {2}.</source>
        <translation>{0} = {1!r}: peab olema {2}.</translation>
    </message>
    <message>
        <source>{0} = {1!r}: there is no folder {2}.</source>
        <translation>{0} = {1!r}: kausta {2} ei ole.</translation>
    </message>
    <message>
        <source>{0} Not measured: {1}.</source>
        <translation>{0} Mõõtmata: {1}.</translation>
    </message>
    <message>
        <source>{0} cannot be read: {1}.</source>
        <translation>{0}: ei saa lugeda: {1}.</translation>
    </message>
    <message>
        <source>{0} could not be removed ({1}); close the programs that run in it and run again: {2}</source>
        <translation>{0}: ei saanud eemaldada ({1}); sulgege programmid, mis selles töötavad, ja käivitage uuesti: {2}</translation>
    </message>
    <message>
        <source>{0} failed</source>
        <translation>{0} ebaõnnestus</translation>
    </message>
    <message>
        <source>{0} has no bound</source>
        <translation>{0}: tõke puudub</translation>
    </message>
    <message>
        <source>{0} has no figures: its first row names columns, the others are one.</source>
        <translation>Loendis {0} ei ole jooniseid: selle esimene rida nimetab veerud, iga järgmine on üks joonis.</translation>
    </message>
    <message>
        <source>{0} has no points: it must have rows of x,y,z.</source>
        <translation>Failis {0} ei ole punkte: selles peavad olema read x,y,z.</translation>
    </message>
    <message>
        <source>{0} has {1} kB, and a page for phones should have at most {2} kB: ask for fewer {3}.</source>
        <translation>{0} on {1} kB, aga telefonile mõeldud leht võiks olla kõige rohkem {2} kB: küsige vähem, valik: {3}.</translation>
    </message>
    <message>
        <source>{0} in {1}</source>
        <translation>{0}, kaust {1}</translation>
    </message>
    <message>
        <source>{0} is a command and must come first: {1} {0} ...</source>
        <translation>{0} on käsk ja peab olema esimene: {1} {0} ...</translation>
    </message>
    <message>
        <source>{0} is a scene: write --set scene={0}.</source>
        <translation>{0} on stseen: kirjutage --set scene={0}.</translation>
    </message>
    <message>
        <source>{0} is not a folder; rename or remove it, and run again: {1}</source>
        <translation>{0} ei ole kaust; nimetage see ümber või eemaldage ja käivitage uuesti: {1}</translation>
    </message>
    <message>
        <source>{0} is not an option of {1}; the nearest is {2}.</source>
        <translation>{0} ei ole valik, mida tunneb {1}; lähim on {2}.</translation>
    </message>
    <message>
        <source>{0} lacks {1} although pip installed them; remove it and start again: {2}</source>
        <translation>{0}: puudub {1}, kuigi pip selle paigaldas; eemaldage kaust ja käivitage uuesti: {2}</translation>
    </message>
    <message>
        <source>{0} lacks {1}; start again: {2}</source>
        <translation>{0}: puudub {1}; käivitage uuesti: {2}</translation>
    </message>
    <message>
        <source>{0} left out: already in these files</source>
        <translation>Välja jäetud: {0}; juba nendes failides</translation>
    </message>
    <message>
        <source>{0} must go to different files.</source>
        <translation>{0} peavad minema eri failidesse.</translation>
    </message>
    <message>
        <source>{0} not as in the files</source>
        <translation>{0} teisiti kui failides</translation>
    </message>
    <message>
        <source>{0} of {1}</source>
        <translation>{0}/{1}</translation>
    </message>
    <message>
        <source>{0} or {1}</source>
        <translation>{0} või {1}</translation>
    </message>
    <message>
        <source>{0} takes {1}, and was given {2}.</source>
        <translation>{0} võtab {1}, aga anti {2}.</translation>
    </message>
    <message>
        <source>{0} was given an empty name.</source>
        <translation>{0} sai tühja nime.</translation>
    </message>
    <message>
        <source>{0} was made by another program and lacks {1}; complete it with that program, or remove it and start again: {2}</source>
        <translation>{0} on teise programmi tehtud ja seal puudub: {1}; täiendage seda selle programmiga, või eemaldage ja käivitage uuesti: {2}</translation>
    </message>
    <message>
        <source>{0} wrong</source>
        <translation>valesid: {0}</translation>
    </message>
    <message>
        <source>{0}, line {1}: is not CSV ({2}).</source>
        <translation>{0}, rida {1}: ei ole CSV ({2}).</translation>
    </message>
    <message>
        <source>{0}, step {1}</source>
        <translation>{0}, samm {1}</translation>
    </message>
    <message>
        <source>{0}, {1} crowded, {2} empty, {3} hidden, {4} cut of {5}</source>
        <translation>{0}, ülekoormatuid: {1}, tühje: {2}, peidetuid: {3}, äralõigatuid: {4}; kokku: {5}</translation>
    </message>
    <message>
        <source>{0}, {1}: {2} right, {3} wrong, {4} shown, {5} not marked</source>
        <translation>{0}, {1}: õigeid {2}, valesid {3}, näidatuid {4}, hindamata {5}</translation>
    </message>
    <message>
        <source>{0}: has no column out, for the names of the figures.</source>
        <translation>{0}: puudub veerg out jooniste nimede jaoks.</translation>
    </message>
    <message>
        <source>{0}: has two columns of the same name.</source>
        <translation>{0}: kahel veerul on sama nimi.</translation>
    </message>
    <message>
        <source>{0}: has two columns {1}.</source>
        <translation>{0}: veerge {1} on kaks.</translation>
    </message>
    <message>
        <source>{0}: {1} drawn, {2} wrong</source>
        <translation>{0}: joonistatud: {1}, valesid: {2}</translation>
    </message>
    <message>
        <source>{0}: {1} x {2} at scale {3:g}</source>
        <translation>{0}: {1} x {2}, mastaap {3:g}</translation>
    </message>
    <message>
        <source>{0}; Frustum Lab prefers its own packages</source>
        <translation>{0}; Frustum Lab eelistab oma pakette</translation>
    </message>
    <message>
        <source>{0}; at most {1}.</source>
        <translation>{0}; kõige rohkem {1}.</translation>
    </message>
    <message>
        <source>“{0}” has an underscore that is not typeset.</source>
        <translation>„{0}“: alakriips, mida pole indeksina laotud.</translation>
    </message>
    <message>
        <source>“{0}” is cut off at the border.</source>
        <translation>„{0}“ on serval ära lõigatud.</translation>
    </message>
    <message>
        <source>“{0}” is named and not drawn: there is no place for it.</source>
        <translation>„{0}“ on nimetatud, aga joonistamata: selle jaoks pole kohta.</translation>
    </message>
    <message>
        <source>“{0}” lies behind the viewer.</source>
        <translation>„{0}“ asub vaataja taga.</translation>
    </message>
    <message>
        <source>“{0}” lies on the point that “{1}” names.</source>
        <translation>„{0}“ asub punktil, mida nimetab „{1}“.</translation>
    </message>
    <message>
        <source>“{0}” lies outside the pane by {1:.1%} of its height.</source>
        <translation>„{0}“ ulatub paanist välja {1:.1%} paani kõrgusest.</translation>
    </message>
    <message>
        <source>“{0}” overlaps “{1}”.</source>
        <translation>„{0}“ ja „{1}“ kattuvad.</translation>
    </message>
    <message>
        <source>{0}: has {1} columns, must have three: x,y,z, or w too; name other columns in a first row: x,y,z,name.</source>
        <translation>{0}: veerge on {1}, aga peab olema kolm: x,y,z, või ka w; muud veerud nimetage esimeses reas: x,y,z,name.</translation>
    </message>
    <message>
        <source>{0!r} is neither a file, a lesson nor a command; the {1}.</source>
        <translation>{0!r} ei ole fail, õppetund ega käsk; {1}.</translation>
    </message>
    <message>
        <source>{0}: has {1}, must have three: x,y,z, or w too.</source>
        <translation>{0}: on {1}, aga peab olema kolm: x,y,z, või ka w.</translation>
    </message>
    <message>
        <source>{0}: is there already; remove it, or choose another folder.</source>
        <translation>{0}: on juba olemas; eemaldage see või valige teine kaust.</translation>
    </message>
    <message>
        <source>{0}: line {1}, step {2} ({3})</source>
        <translation>{0}: rida {1}, samm {2} ({3})</translation>
    </message>
    <message>
        <source>{0}: must name columns x, y and z, or hold a point.</source>
        <translation>{0}: peab nimetama veerud x, y ja z või sisaldama punkti.</translation>
    </message>
    <message>
        <source>{0}: not writable</source>
        <translation>{0}: ei saa kirjutada</translation>
    </message>
    <message>
        <source>{0}: start the program in a desktop session, over ssh with -X, or with xvfb-run -s &apos;+extension GLX&apos;{1} in front; “export”, “project”, “matrices”, “measure”, “lesson”, “talk --check”, “talk --handout” and “doctor” need no screen.</source>
        <translation>{0}: käivitage programm töölauaseansis, ssh kaudu valikuga -X või nii, et käsu ees on xvfb-run -s &apos;+extension GLX&apos;{1}; „export“, „project“, „matrices“, „measure“, „lesson“, „talk --check“, „talk --handout“ ja „doctor“ ekraani ei vaja.</translation>
    </message>
    <message>
        <source>{0}: {1!r} is not a column; the nearest is {2}.</source>
        <translation>{0}: {1!r} ei ole veerg; lähim on {2}.</translation>
    </message>
    <message>
        <source>{0}: {1!r} is one column; they are separated by commas.</source>
        <translation>{0}: {1!r} on üks veerg; veerud eraldatakse komadega.</translation>
    </message>
    <message>
        <source>{0}: {1} = {2}: must lie within ±{3}.</source>
        <translation>{0}: {1} = {2}: peab olema vahemikus ±{3}.</translation>
    </message>
    <message>
        <source>There are no settings to delete: {0}</source>
        <translation>Kustutatavaid sätteid pole: {0}</translation>
    </message>
    <message>
        <source>Settings deleted: {0}</source>
        <translation>Sätted on kustutatud: {0}</translation>
    </message>
    <message>
        <source>it is a pipe or a device, not a regular file</source>
        <translation>see on toru või seade, mitte tavaline fail</translation>
    </message>
    <message>
        <source>it is larger than {0} GiB</source>
        <translation>see on suurem kui {0} GiB</translation>
    </message>
    <message>
        <source>it is not a regular file</source>
        <translation>see pole tavaline fail</translation>
    </message>
    <message>
        <source>is neither UTF-8 nor UTF-16 text, and is read as Latin-1; some letters may be wrong</source>
        <translation>ei ole UTF-8 ega UTF-16 tekst ja loetakse Latin-1-na; mõni täht võib olla vale</translation>
    </message>
    <message>
        <source>is damaged UTF-16 or UTF-32 text; what cannot be read is shown as �</source>
        <translation>on vigane UTF-16 või UTF-32 tekst; loetamatu asemel on �</translation>
    </message>
    <message>
        <source>a question or a task</source>
        <translation>küsimus või tegevus</translation>
    </message>
    <message>
        <source>“value:”, “count:”, “matrix:”, “click:”, “order:”, or choices</source>
        <translation>„value:“, „count:“, „matrix:“, „click:“, „order:“ või valikvastused</translation>
    </message>
    <message>
        <source>{0} and choices</source>
        <translation>{0} ja valikvastused</translation>
    </message>
    <message>
        <source>the end</source>
        <translation>lõpp</translation>
    </message>
    <message>
        <source>There is no OpenGL 3.2 to draw with: update the graphics driver; on Linux install Mesa (libegl1 libegl-mesa0 libgl1-mesa-dri) or start with LIBGL_ALWAYS_SOFTWARE=1.</source>
        <translation>Joonistamiseks puudub OpenGL 3.2: uuendage graafikadraiverit; Linuxis paigaldage Mesa (libegl1 libegl-mesa0 libgl1-mesa-dri) või käivitage muutujaga LIBGL_ALWAYS_SOFTWARE=1.</translation>
    </message>
    <message>
        <source>the whole numbers from 0 to {0}</source>
        <translation>täisarvud 0 kuni {0}</translation>
    </message>
    <message>
        <source>the opposite of the segment&apos;s other end</source>
        <translation>(lõigu teise otsa vastandpunkt)</translation>
    </message>
    <message>
        <source>change a value of the document, such as lens.far=inf; may be repeated; the names are {0} and settings.NAME for a setting of the scene</source>
        <translation>muuda dokumendi väärtust, näiteks lens.far=inf; võib korrata; nimed on {0} ja stseeni sätte jaoks settings.NAME</translation>
    </message>
    <message>
        <source>commands, each with its own --help:</source>
        <translation>käsud, igaühel oma --help:</translation>
    </message>
    <message>
        <source>language of messages, lessons and figures (default: the system&apos;s)</source>
        <translation>teadete, õppetundide ja jooniste keel (vaikimisi: süsteemi oma)</translation>
    </message>
    <message>
        <source>{0} and {1}</source>
        <translation>{0} ja {1}</translation>
    </message>
    <message>
        <source>Qt has no OpenGL here: VTK draws the panes off the screen.</source>
        <translation>Qt-l ei ole siin OpenGL-i: VTK joonistab paanid väljaspool ekraani.</translation>
    </message>
    <message>
        <source>world</source>
        <translation>maailm</translation>
    </message>
    <message>
        <source>view</source>
        <translation>vaade</translation>
    </message>
    <message>
        <source>clip</source>
        <translation>kärperuum</translation>
    </message>
    <message>
        <source>image px</source>
        <translation>pilt px</translation>
    </message>
    <message>
        <source>depth</source>
        <translation>sügavus</translation>
    </message>
</context>
<context>
    <name>Compare</name>
    <message>
        <source>Differences between the pictures</source>
        <translation>Piltide erinevused</translation>
    </message>
    <message>
        <source>End the comparison (Esc)</source>
        <translation>Lõpeta võrdlus (Esc)</translation>
    </message>
    <message>
        <source>End the comparison</source>
        <translation>Lõpeta võrdlus</translation>
    </message>
    <message>
        <source>Over each other</source>
        <translation>Ülestikku</translation>
    </message>
    <message>
        <source>Lay the pictures over each other, with a divider that you can drag</source>
        <translation>Paneb pildid ülestikku; nende vahel on eraldusjoon, mida saab lohistada</translation>
    </message>
    <message>
        <source>Side by side</source>
        <translation>Kõrvuti</translation>
    </message>
    <message>
        <source>Show every picture whole, beside the others</source>
        <translation>Näitab iga pilti tervikuna teiste kõrval</translation>
    </message>
    <message>
        <source>held</source>
        <translation>meelde jäetud</translation>
    </message>
    <message>
        <source>no difference yet: change something</source>
        <translation>erinevust veel ei ole: muutke midagi</translation>
    </message>
    <message>
        <source>different shapes: side by side, at equal heights</source>
        <translation>eri kujuga: kõrvuti, ühekõrgustena</translation>
    </message>
</context>
<context>
    <name>Comparing</name>
    <message>
        <source>Compare</source>
        <translation>Võrdlus</translation>
    </message>
</context>
<context>
    <name>Controls</name>
    <message>
        <source>Controls</source>
        <translation>Juhtelemendid</translation>
    </message>
    <message>
        <source>Camera</source>
        <translation>Kaamera</translation>
    </message>
    <message>
        <source>More of the lens</source>
        <translation>Veel objektiivist</translation>
    </message>
    <message>
        <source>More of the camera</source>
        <translation>Veel kaamerast</translation>
    </message>
    <message>
        <source>Image and depth range</source>
        <translation>Pilt ja sügavusvahemik</translation>
    </message>
    <message>
        <source>Chain</source>
        <translation>Ahel</translation>
    </message>
    <message>
        <source>Animation</source>
        <translation>Animatsioon</translation>
    </message>
    <message>
        <source>The objects of this scene are fixed, because its numbers depend on them. You can move those of the letter F, the cube, the posts and any mesh.</source>
        <translation>Selle stseeni objektid ei liigu, sest stseeni arvud sõltuvad neist. Liigutada saate F-tähe, kuubi, postide ja mis tahes võrgu objekte.</translation>
    </message>
    <message>
        <source>Calibrated camera (OpenCV K)</source>
        <translation>Kalibreeritud kaamera (OpenCV K)</translation>
    </message>
    <message>
        <source>No camera has the typed view matrix: undo, or choose a lens.</source>
        <translation>Sisestatud vaatemaatriks ei sobi ühelegi kaamerale: võtke tagasi või valige objektiiv.</translation>
    </message>
    <message>
        <source>animation play walk turn</source>
        <translation>animatsioon esita käi pööra</translation>
    </message>
    <message>
        <source>{0}: only with the lens “{1}”.</source>
        <translation>{0}: ainult objektiiviga „{1}“.</translation>
    </message>
    <message>
        <source>No control has this name.</source>
        <translation>Sellise nimega juhtelementi ei ole.</translation>
    </message>
</context>
<context>
    <name>Count</name>
    <message numerus="yes">
        <source>%n answers</source>
        <translation>
            <numerusform>%n vastus</numerusform>
            <numerusform>%n vastust</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n checks</source>
        <translation>
            <numerusform>%n kontroll</numerusform>
            <numerusform>%n kontrolli</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n columns</source>
        <translation>
            <numerusform>%n veerg</numerusform>
            <numerusform>%n veergu</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n files</source>
        <translation>
            <numerusform>%n fail</numerusform>
            <numerusform>%n faili</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n labels</source>
        <translation>
            <numerusform>%n silt</numerusform>
            <numerusform>%n silti</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n lessons</source>
        <translation>
            <numerusform>%n õppetund</numerusform>
            <numerusform>%n õppetundi</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n marks</source>
        <translation>
            <numerusform>%n hinnang</numerusform>
            <numerusform>%n hinnangut</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n names</source>
        <translation>
            <numerusform>%n nimi</numerusform>
            <numerusform>%n nime</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n overlaps</source>
        <translation>
            <numerusform>%n kattumine</numerusform>
            <numerusform>%n kattumist</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n steps</source>
        <translation>
            <numerusform>%n samm</numerusform>
            <numerusform>%n sammu</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n talks</source>
        <translation>
            <numerusform>%n ettekanne</numerusform>
            <numerusform>%n ettekannet</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n warnings</source>
        <translation>
            <numerusform>%n hoiatus</numerusform>
            <numerusform>%n hoiatust</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n exercises</source>
        <translation>
            <numerusform>%n ülesanne</numerusform>
            <numerusform>%n ülesannet</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n minutes</source>
        <translation>
            <numerusform>%n minut</numerusform>
            <numerusform>%n minutit</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n samples</source>
        <translation>
            <numerusform>%n valim</numerusform>
            <numerusform>%n valimit</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>CoverCard</name>
    <message>
        <source>Close</source>
        <translation>Sulge</translation>
    </message>
</context>
<context>
    <name>Cursor</name>
    <message>
        <source>No other vertex is visible</source>
        <translation>Ühtki teist tippu ei ole näha</translation>
    </message>
    <message>
        <source>There is nothing else to drag</source>
        <translation>Midagi muud lohistada ei ole</translation>
    </message>
    <message>
        <source>There is nothing to drag here</source>
        <translation>Siin ei ole midagi lohistada</translation>
    </message>
    <message>
        <source>Point {0} ({1})</source>
        <translation>Punkt {0} ({1})</translation>
    </message>
    <message>
        <source>Vertex ({0})</source>
        <translation>Tipp ({0})</translation>
    </message>
</context>
<context>
    <name>Description</name>
    <message>
        <source>All of the scene&apos;s objects lie inside the view volume.</source>
        <translation>Kõik stseeni objektid on nähtavas ruumis.</translation>
    </message>
    <message>
        <source>Cube: the scene in {0} coordinates.</source>
        <translation>Kuup: stseen {0} koordinaatides.</translation>
    </message>
    <message>
        <source>Cube: the scene on its way from {0} to {1} coordinates.</source>
        <translation>Kuup: stseen teel {0} koordinaatidest {1} koordinaatidesse.</translation>
    </message>
    <message>
        <source>Equation: {0}.</source>
        <translation>Võrrand: {0}.</translation>
    </message>
    <message>
        <source>Image: the picture, {0} by {1} pixels.</source>
        <translation>Pilt: laius ja kõrgus pikslites {0} ja {1}.</translation>
    </message>
    <message>
        <source>Lens: {0}, near {1}, far {2}.</source>
        <translation>Objektiiv: {0}, lähitasand {1}, kaugtasand {2}.</translation>
    </message>
    <message>
        <source>Lens: {0}.</source>
        <translation>Objektiiv: {0}.</translation>
    </message>
    <message>
        <source>Parts of the scene&apos;s objects lie behind the eye, where a point has no picture.</source>
        <translation>Osa stseeni objektidest jääb silma taha, kus punktil kujutist ei ole.</translation>
    </message>
    <message>
        <source>Parts of the scene&apos;s objects lie outside of these planes: {0}.</source>
        <translation>Osa stseeni objektidest jääb väljapoole järgmisi tasandeid: {0}.</translation>
    </message>
    <message>
        <source>Point {0} at ({1}) has its picture at the pixel ({2}).</source>
        <translation>Punkti {0} asukohaga ({1}) kujutis on pikslis ({2}).</translation>
    </message>
    <message>
        <source>Point {0} has no picture.</source>
        <translation>Punktil {0} kujutist ei ole.</translation>
    </message>
    <message>
        <source>Point {0}, at infinity in the direction ({1}), has its picture at ({2}).</source>
        <translation>Lõpmatuspunkti {0} suunaga ({1}) kujutis on kohal ({2}).</translation>
    </message>
    <message>
        <source>The eye is at ({0}) and looks at ({1}).</source>
        <translation>Silm on kohal ({0}) ja vaatab punkti ({1}).</translation>
    </message>
    <message>
        <source>The file is drawn with triangles: {0}, lines: {1}, points: {2}.</source>
        <translation>Failist joonistatakse kolmnurki: {0}, jooni: {1}, punkte: {2}.</translation>
    </message>
    <message>
        <source>The vertical field of view is {0}°.</source>
        <translation>Vertikaalne frustumi nurk on {0}°.</translation>
    </message>
    <message>
        <source>World: the scene along the camera&apos;s axis, in parallel projection.</source>
        <translation>Maailm: stseen piki kaamera telge, paralleelses projektsioonis.</translation>
    </message>
    <message>
        <source>World: the scene as the camera sees it.</source>
        <translation>Maailm: stseen nii, nagu kaamera seda näeb.</translation>
    </message>
    <message>
        <source>World: the scene from a free viewpoint.</source>
        <translation>Maailm: stseen vabalt valitud vaatepunktist.</translation>
    </message>
    <message>
        <source>World: the scene from above the camera, in parallel projection.</source>
        <translation>Maailm: stseen kaamera kohalt, paralleelses projektsioonis.</translation>
    </message>
    <message>
        <source>World: the scene from the camera&apos;s side, in parallel projection.</source>
        <translation>Maailm: stseen kaamera küljelt, paralleelses projektsioonis.</translation>
    </message>
    <message>
        <source>canonical parallel</source>
        <translation>kanoonilise paralleelse ruumi</translation>
    </message>
    <message>
        <source>canonical perspective</source>
        <translation>kanoonilise perspektiivse ruumi</translation>
    </message>
    <message>
        <source>image</source>
        <translation>pildi</translation>
    </message>
    <message>
        <source>normalized device</source>
        <translation>normaliseeritud</translation>
    </message>
    <message>
        <source>view</source>
        <translation>kaamerafreimi</translation>
    </message>
    <message>
        <source>world</source>
        <translation>maailma</translation>
    </message>
    <message>
        <source>{0} pictures are compared.</source>
        <translation>Võrreldavaid pilte: {0}.</translation>
    </message>
</context>
<context>
    <name>DiagramView</name>
    <message>
        <source>Copy this diagram</source>
        <translation>Kopeeri see diagramm</translation>
    </message>
    <message>
        <source>Export this diagram…</source>
        <translation>Ekspordi see diagramm…</translation>
    </message>
</context>
<context>
    <name>Divider</name>
    <message>
        <source>Divider between two pictures</source>
        <translation>Kahe pildi vaheline eraldusjoon</translation>
    </message>
    <message>
        <source>Drag it, or press ← → (with Shift for finer steps), Home or End; Esc ends the comparison</source>
        <translation>Lohistage seda või vajutage ← → (peenemate sammude jaoks koos klahviga Shift), Home või End; Esc lõpetab võrdluse</translation>
    </message>
</context>
<context>
    <name>DrawnQuality</name>
    <message>
        <source>A pane cannot draw with {0}: it uses its default smoothing</source>
        <translation>Üks paan ei saa kasutada silumist {0}: see kasutab oma tavalist silumist</translation>
    </message>
    <message>
        <source>The scene has too few triangles to leave any out</source>
        <translation>Stseenis on kolmnurki liiga vähe, et neid ära jätta</translation>
    </message>
    <message>
        <source>A textured surface can be drawn in float32 only</source>
        <translation>Tekstuuriga pinda saab joonistada ainult float32-s</translation>
    </message>
    <message>
        <source>The image uses the ordinary depth buffer: {0}</source>
        <translation>Pilt kasutab tavalist sügavuspuhvrit: {0}</translation>
    </message>
    <message>
        <source>A picture takes {0} ms to draw, so dragging stutters; a smaller window is smoother</source>
        <translation>Pildi joonistamine võtab {0} ms, seetõttu lohistamine hakib; väiksemas aknas on see sujuvam</translation>
    </message>
    <message>
        <source>This computer&apos;s OpenGL gives {0} per pixel instead of {1}</source>
        <translation>Selle arvuti OpenGL-is on piksli kohta {0}, mitte {1}</translation>
    </message>
</context>
<context>
    <name>EquationSlide</name>
    <message>
        <source>turns</source>
        <translation>pöörab</translation>
    </message>
    <message>
        <source>moves</source>
        <translation>nihutab</translation>
    </message>
</context>
<context>
    <name>ErrorReport</name>
    <message>
        <source>Something went wrong</source>
        <translation>Midagi läks valesti</translation>
    </message>
    <message>
        <source>Copy details</source>
        <translation>Kopeeri üksikasjad</translation>
    </message>
    <message>
        <source>Copies the details that a developer needs</source>
        <translation>Kopeerib üksikasjad, mida arendajal on vaja</translation>
    </message>
    <message>
        <source>An error in the program: {0}. Your work is still there.</source>
        <translation>Viga programmis: {0}. Teie töö on alles.</translation>
    </message>
    <message>
        <source>Another error followed it.</source>
        <translation>Sellele järgnes veel üks viga.</translation>
    </message>
    <message>
        <source>{0} more errors followed it.</source>
        <translation>Sellele järgnenud vigu: {0}.</translation>
    </message>
    <message>
        <source>There is no log, because it could not be written.</source>
        <translation>Logi ei ole, sest seda ei saanud kirjutada.</translation>
    </message>
    <message>
        <source>The log: {0}</source>
        <translation>Logi: {0}</translation>
    </message>
</context>
<context>
    <name>Exam</name>
    <message>
        <source>Test: {0}</source>
        <translation>Test: {0}</translation>
    </message>
    <message>
        <source>{0}, variant {1}</source>
        <translation>{0}, variant {1}</translation>
    </message>
    <message>
        <source>Key: {0}</source>
        <translation>Võti: {0}</translation>
    </message>
    <message>
        <source>Variant {0}</source>
        <translation>Variant {0}</translation>
    </message>
    <message>
        <source>Wrong ideas:</source>
        <translation>Väärarusaamad:</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Nimi</translation>
    </message>
    <message>
        <source>Date</source>
        <translation>Kuupäev</translation>
    </message>
    <message>
        <source>A sketch, not to scale.</source>
        <translation>Visand, ei ole mõõtkavas.</translation>
    </message>
    <message>
        <source>Mark the place in the picture with a cross.</source>
        <translation>Märkige koht pildil ristiga.</translation>
    </message>
    <message>
        <source>Answer:</source>
        <translation>Vastus:</translation>
    </message>
    <message>
        <source>Write the letters of the tiles as a product: what stands on the right acts first.</source>
        <translation>Kirjutage lülide tähed korrutisena: esimesena mõjub parempoolne.</translation>
    </message>
</context>
<context>
    <name>ExerciseView</name>
    <message>
        <source>Number of the variant</source>
        <translation>Variandi number</translation>
    </message>
    <message>
        <source>The same number gives the same exercise to everyone (Enter)</source>
        <translation>Sama number annab kõigile sama ülesande (Enter)</translation>
    </message>
    <message>
        <source>Be&amp;gin</source>
        <translation>Al&amp;usta</translation>
    </message>
    <message>
        <source>Draw the numbers, and show their state</source>
        <translation>Loosi arvud ja näita nende olekut</translation>
    </message>
    <message>
        <source>Another &amp;one</source>
        <translation>Veel &amp;üks</translation>
    </message>
    <message>
        <source>The same exercise with new numbers</source>
        <translation>Sama ülesanne uute arvudega</translation>
    </message>
    <message>
        <source>Exercise</source>
        <translation>Ülesanne</translation>
    </message>
    <message>
        <source>Variant</source>
        <translation>Variant</translation>
    </message>
</context>
<context>
    <name>ExportDialog</name>
    <message>
        <source>Export a picture</source>
        <translation>Pildi eksportimine</translation>
    </message>
    <message>
        <source>Height of the letters in points, 72 to an inch; at scale 1 an inch has {0} pixels</source>
        <translation>Tähtede kõrgus punktides, 72 punkti tollis; mastaabis 1 on tollis {0} pikslit</translation>
    </message>
    <message>
        <source>Width of the picture</source>
        <translation>Pildi laius</translation>
    </message>
    <message>
        <source>Height of the picture</source>
        <translation>Pildi kõrgus</translation>
    </message>
    <message>
        <source>Height of the letters in points</source>
        <translation>Tähtede kõrgus punktides</translation>
    </message>
    <message>
        <source>The file&apos;s format; SVG, PDF and TEX (TikZ) have shapes and text, no pixels. Films and many at once: the command “export”</source>
        <translation>Faili vorming; SVG, PDF ja TEX (TikZ) koosnevad kujunditest ja tekstist, mitte pikslitest. Filmid ja palju pilte korraga: käsk „export“</translation>
    </message>
    <message>
        <source>&amp;Format</source>
        <translation>&amp;Vorming</translation>
    </message>
    <message>
        <source>Panes</source>
        <translation>Paanid</translation>
    </message>
    <message>
        <source>Whether the panes stand beside or below each other</source>
        <translation>Kas paanid on kõrvuti või üksteise all</translation>
    </message>
    <message>
        <source>in a row</source>
        <translation>reas</translation>
    </message>
    <message>
        <source>in a column</source>
        <translation>veerus</translation>
    </message>
    <message>
        <source>&amp;Arranged</source>
        <translation>&amp;Paigutus</translation>
    </message>
    <message>
        <source>Unit of the size; a picture has {0} pixels an inch</source>
        <translation>Suuruse ühik; pildi tollis on {0} pikslit</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Suurus</translation>
    </message>
    <message>
        <source>&amp;Letters (pt)</source>
        <translation>&amp;Tähed (pt)</translation>
    </message>
    <message>
        <source>In print, faces and lines that differ in colour differ in grey, too</source>
        <translation>Trükis erinevad ka halltoonilt need tahud ja jooned, mis erinevad värvilt</translation>
    </message>
    <message>
        <source>as on the screen</source>
        <translation>nagu ekraanil</translation>
    </message>
    <message>
        <source>for print</source>
        <translation>trükiks</translation>
    </message>
    <message>
        <source>dark</source>
        <translation>tume</translation>
    </message>
    <message>
        <source>most contrast</source>
        <translation>suurim kontrast</translation>
    </message>
    <message>
        <source>C&amp;olours</source>
        <translation>Vä&amp;rvid</translation>
    </message>
    <message>
        <source>What becomes of lines behind faces, in SVG, PDF and TEX</source>
        <translation>Mis saab tahkude taga olevatest joontest SVG-, PDF- ja TEX-failis</translation>
    </message>
    <message>
        <source>left out</source>
        <translation>jäetakse ära</translation>
    </message>
    <message>
        <source>dashed</source>
        <translation>katkendlikud</translation>
    </message>
    <message>
        <source>grey</source>
        <translation>hallid</translation>
    </message>
    <message>
        <source>&amp;Hidden lines</source>
        <translation>P&amp;eidetud jooned</translation>
    </message>
    <message>
        <source>Draws the same PNG with more pixels; text and lines scale with it</source>
        <translation>Joonistab sama PNG rohkemate pikslitega; tekst ja jooned suurenevad kaasa</translation>
    </message>
    <message>
        <source>Scal&amp;e</source>
        <translation>&amp;Mastaap</translation>
    </message>
    <message>
        <source>What is behind the picture</source>
        <translation>Mis on pildi taga</translation>
    </message>
    <message>
        <source>filled</source>
        <translation>täidetud</translation>
    </message>
    <message>
        <source>transparent</source>
        <translation>läbipaistev</translation>
    </message>
    <message>
        <source>&amp;Background</source>
        <translation>Tau&amp;st</translation>
    </message>
    <message>
        <source>C&amp;rop to the content</source>
        <translation>Kär&amp;bi sisu järgi</translation>
    </message>
    <message>
        <source>Leaves a margin of 2 mm around what is drawn</source>
        <translation>Jätab joonistatu ümber 2 mm serva</translation>
    </message>
    <message>
        <source>Preview</source>
        <translation>Eelvaade</translation>
    </message>
    <message>
        <source>Letters</source>
        <translation>Tähed</translation>
    </message>
    <message>
        <source>Choose at least one pane.</source>
        <translation>Valige vähemalt üks paan.</translation>
    </message>
    <message>
        <source>Width and height must be whole numbers.</source>
        <translation>Laius ja kõrgus peavad olema täisarvud.</translation>
    </message>
    <message>
        <source>Drawing the preview</source>
        <translation>Joonistatakse eelvaadet</translation>
    </message>
</context>
<context>
    <name>Factor</name>
    <message>
        <source>division by w</source>
        <translation>jagamine w-ga</translation>
    </message>
    <message>
        <source>mirror</source>
        <translation>peegeldus</translation>
    </message>
    <message>
        <source>rotation</source>
        <translation>pööre</translation>
    </message>
    <message>
        <source>rotation about x</source>
        <translation>pööre ümber x-telje</translation>
    </message>
    <message>
        <source>rotation about y</source>
        <translation>pööre ümber y-telje</translation>
    </message>
    <message>
        <source>rotation about z</source>
        <translation>pööre ümber z-telje</translation>
    </message>
    <message>
        <source>scale</source>
        <translation>skaleerimine</translation>
    </message>
    <message>
        <source>shear</source>
        <translation>kaldnihe</translation>
    </message>
    <message>
        <source>translation</source>
        <translation>nihe</translation>
    </message>
    <message>
        <source>typed matrix</source>
        <translation>sisestatud maatriks</translation>
    </message>
    <message>
        <source>x, y, z divided by w</source>
        <translation>x, y, z jagatud w-ga</translation>
    </message>
</context>
<context>
    <name>Field</name>
    <message>
        <source>Image</source>
        <translation>Pilt</translation>
    </message>
    <message>
        <source>Answer</source>
        <translation>Vastus</translation>
    </message>
    <message>
        <source>{0} {1}</source>
        <translation>{0} {1}</translation>
    </message>
    <message>
        <source>degrees</source>
        <translation>kraadi</translation>
    </message>
    <message>
        <source>units</source>
        <translation>ühikut</translation>
    </message>
    <message>
        <source>world units</source>
        <translation>maailma ühikut</translation>
    </message>
    <message>
        <source>mm</source>
        <translation>mm</translation>
    </message>
    <message>
        <source>millimetres</source>
        <translation>millimeetrit</translation>
    </message>
    <message>
        <source>px</source>
        <translation>px</translation>
    </message>
    <message>
        <source>pixels</source>
        <translation>pikslit</translation>
    </message>
    <message>
        <source>×</source>
        <translation>×</translation>
    </message>
    <message>
        <source>times</source>
        <translation>korda</translation>
    </message>
    <message>
        <source>16:9</source>
        <translation>16:9</translation>
    </message>
    <message>
        <source>1:1</source>
        <translation>1:1</translation>
    </message>
    <message>
        <source>4:3</source>
        <translation>4:3</translation>
    </message>
    <message>
        <source>Adds a multiple of one coordinate to another: shear xy slides x along with y.</source>
        <translation>Liidab ühele koordinaadile teise kordse: kaldnihe xy nihutab x-i koos y-ga.</translation>
    </message>
    <message>
        <source>Alpha</source>
        <translation>Alfa</translation>
    </message>
    <message>
        <source>Angle between the bottom and the top of the frustum, as seen from the eye.</source>
        <translation>Frustumi ülemise ja alumise külje vaheline nurk silmast vaadates.</translation>
    </message>
    <message>
        <source>Angle between the left and the right of the frustum, as seen from the eye: the vertical field of view and the aspect in one number.</source>
        <translation>Frustumi vasaku ja parema külje vaheline nurk silmast vaadates: vertikaalne frustumi nurk ja kuvasuhe ühes arvus.</translation>
    </message>
    <message>
        <source>Angle of the projectors with the x axis, seen from above: H of lecture 002 adds (z + near) cot(alpha) to x. Points on the near plane do not move.</source>
        <translation>Projektsioonikiirte nurk x-teljega ülalt vaadatuna: loengu 002 H liidab x-ile (z + lähitasand) cot(alfa). Lähitasandi punktid ei liigu.</translation>
    </message>
    <message>
        <source>Angle of the projectors with the y axis, seen from the side: H of lecture 002 adds (z + near) cot(beta) to y. Points on the near plane do not move.</source>
        <translation>Projektsioonikiirte nurk y-teljega küljelt vaadatuna: loengu 002 H liidab y-ile (z + lähitasand) cot(beeta). Lähitasandi punktid ei liigu.</translation>
    </message>
    <message>
        <source>Any four by four matrix with an inverse that leaves w alone.</source>
        <translation>Mis tahes neli korda neli maatriks, millel on pöördmaatriks ja mis ei muuda w-d.</translation>
    </message>
    <message>
        <source>Aspect</source>
        <translation>Kuvasuhe</translation>
    </message>
    <message>
        <source>Azimuth</source>
        <translation>Asimuut</translation>
    </message>
    <message>
        <source>Beta</source>
        <translation>Beeta</translation>
    </message>
    <message>
        <source>Bottom</source>
        <translation>Alumine</translation>
    </message>
    <message>
        <source>Bottom edge of the picture&apos;s window on the near plane: where the view volume begins in y of view space.</source>
        <translation>Pildi akna alumine serv lähitasandil: kust nähtav ruum kaamerafreimi y-sihis algab.</translation>
    </message>
    <message>
        <source>Chain</source>
        <translation>Ahel</translation>
    </message>
    <message>
        <source>Depth is drawn at full length, rising at 30°.</source>
        <translation>Sügavus joonistatakse täispikkuses, tõusuga 30°.</translation>
    </message>
    <message>
        <source>Depth is drawn at full length, rising at 45°.</source>
        <translation>Sügavus joonistatakse täispikkuses, tõusuga 45°.</translation>
    </message>
    <message>
        <source>Depth is drawn at full length, rising at 63.4°.</source>
        <translation>Sügavus joonistatakse täispikkuses, tõusuga 63.4°.</translation>
    </message>
    <message>
        <source>Depth is drawn at half its length, rising at 30°.</source>
        <translation>Sügavus joonistatakse poole pikkusega, tõusuga 30°.</translation>
    </message>
    <message>
        <source>Depth is drawn at half its length, rising at 45°.</source>
        <translation>Sügavus joonistatakse poole pikkusega, tõusuga 45°.</translation>
    </message>
    <message>
        <source>Depth is drawn at half its length, rising at 63.4°.</source>
        <translation>Sügavus joonistatakse poole pikkusega, tõusuga 63.4°.</translation>
    </message>
    <message>
        <source>Depth range</source>
        <translation>Sügavusvahemik</translation>
    </message>
    <message>
        <source>Direct3D: 0 to 1</source>
        <translation>Direct3D: 0 kuni 1</translation>
    </message>
    <message>
        <source>Direction</source>
        <translation>Suund</translation>
    </message>
    <message>
        <source>Direction in which depth is drawn, anticlockwise from the right. The target stays in its place in the picture.</source>
        <translation>Suund, milles sügavus joonistatakse, paremalt vastupäeva. Sihtpunkt jääb pildil oma kohale.</translation>
    </message>
    <message>
        <source>Distance</source>
        <translation>Kaugus</translation>
    </message>
    <message>
        <source>Distance from the eye to the far plane: nothing farther is drawn. A perspective lens also takes inf (∞), at the slider&apos;s end.</source>
        <translation>Kaugus silmast kaugtasandini: midagi kaugemat ei joonistata. Perspektiivne objektiiv lubab liuguri otsas ka inf (∞).</translation>
    </message>
    <message>
        <source>Distance from the eye to the near plane: nothing nearer is drawn. The closer to 0, the coarser the depth buffer of a perspective lens.</source>
        <translation>Kaugus silmast lähitasandini: midagi lähemat ei joonistata. Mida lähemal 0-le, seda jämedam on perspektiivse objektiivi sügavuspuhver.</translation>
    </message>
    <message>
        <source>Distance from the target to the eye.</source>
        <translation>Kaugus sihtpunktist silmani.</translation>
    </message>
    <message>
        <source>Drag along the axis to stretch the object</source>
        <translation>Lohistage piki telge, et objekti venitada</translation>
    </message>
    <message>
        <source>Drag in a circle to turn the object</source>
        <translation>Lohistage ringi mööda, et objekti pöörata</translation>
    </message>
    <message>
        <source>Drag the eye (Shift: up and down)</source>
        <translation>Lohistage silma (Shift: üles ja alla)</translation>
    </message>
    <message>
        <source>Drag the far plane</source>
        <translation>Lohistage kaugtasandit</translation>
    </message>
    <message>
        <source>Drag the near plane</source>
        <translation>Lohistage lähitasandit</translation>
    </message>
    <message>
        <source>Drag the object (Shift: up and down)</source>
        <translation>Lohistage objekti (Shift: üles ja alla)</translation>
    </message>
    <message>
        <source>Drag the target (Shift: up and down)</source>
        <translation>Lohistage sihtpunkti (Shift: üles ja alla)</translation>
    </message>
    <message>
        <source>Drag the tip of up</source>
        <translation>Lohistage ülesvektori otsa</translation>
    </message>
    <message>
        <source>Drag the window&apos;s edge (Shift: both sides)</source>
        <translation>Lohistage akna serva (Shift: mõlemad küljed)</translation>
    </message>
    <message>
        <source>Drag to change the field of view</source>
        <translation>Lohistage, et frustumi nurka muuta</translation>
    </message>
    <message>
        <source>Drawing</source>
        <translation>Joonis</translation>
    </message>
    <message>
        <source>Drawn length of a line perpendicular to the picture, relative to its true length: 1 is a cavalier, 0.5 a cabinet drawing, 0 orthographic. The target stays in its place in the picture.</source>
        <translation>Pildiga risti oleva joone joonistatud pikkus tegeliku pikkuse suhtes: 1 on cavalier-joonis, 0.5 cabinet-joonis, 0 ortograafiline. Sihtpunkt jääb pildil oma kohale.</translation>
    </message>
    <message>
        <source>Elevation</source>
        <translation>Tõusunurk</translation>
    </message>
    <message>
        <source>Eye</source>
        <translation>Silm</translation>
    </message>
    <message>
        <source>Far</source>
        <translation>Kaugtasand</translation>
    </message>
    <message>
        <source>Field of view</source>
        <translation>Frustumi nurk</translation>
    </message>
    <message>
        <source>Focal length</source>
        <translation>Fookuskaugus</translation>
    </message>
    <message>
        <source>Focal length e</source>
        <translation>Fookuskaugus e</translation>
    </message>
    <message>
        <source>Focal length in pixel heights: K&apos;s second diagonal entry. Equal to fx if the pixels are square.</source>
        <translation>Fookuskaugus piksli kõrgustes: K teine diagonaalielement. Kui pikslid on ruudukujulised, võrdub see fx-iga.</translation>
    </message>
    <message>
        <source>Focal length in pixel widths: K&apos;s first diagonal entry.</source>
        <translation>Fookuskaugus piksli laiustes: K esimene diagonaalielement.</translation>
    </message>
    <message>
        <source>Focal length of a 35 mm film camera (36 × 24 mm) with the same diagonal field of view: below 35 is wide angle, above 70 telephoto.</source>
        <translation>35 mm filmikaamera (36 × 24 mm) fookuskaugus sama diagonaalse frustumi nurgaga: alla 35 on lainurk, üle 70 tele.</translation>
    </message>
    <message>
        <source>Half the height of the picture on the near plane: glFrustum&apos;s top, and −bottom. With near it sets the field of view.</source>
        <translation>Pool pildi kõrgusest lähitasandil: glFrustumi top ja −bottom. Koos lähitasandiga määrab see frustumi nurga.</translation>
    </message>
    <message>
        <source>Half the width of the picture on the near plane: glFrustum&apos;s right, and −left. With near it sets the field of view.</source>
        <translation>Pool pildi laiusest lähitasandil: glFrustumi right ja −left. Koos lähitasandiga määrab see frustumi nurga.</translation>
    </message>
    <message>
        <source>Half-height</source>
        <translation>Pool kõrgust</translation>
    </message>
    <message>
        <source>Half-width</source>
        <translation>Pool laiust</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Kõrgus</translation>
    </message>
    <message>
        <source>Height above the target&apos;s horizon as an angle: 90 looks straight down.</source>
        <translation>Kõrgus sihtpunkti horisondi kohal nurgana: 90 vaatab otse alla.</translation>
    </message>
    <message>
        <source>Height of the picture in pixels.</source>
        <translation>Pildi kõrgus pikslites.</translation>
    </message>
    <message>
        <source>Horizontal fov</source>
        <translation>Horisontaalne FOV</translation>
    </message>
    <message>
        <source>How the window follows the aspect of the image.</source>
        <translation>Kuidas aken järgib pildi kuvasuhet.</translation>
    </message>
    <message>
        <source>K intrinsics calibrated camera OpenCV principal point</source>
        <translation>K sisemised parameetrid kalibreeritud kaamera OpenCV peapunkt</translation>
    </message>
    <message>
        <source>Kind of projection. Objects at the target keep their size when it changes.</source>
        <translation>Projektsiooni liik. Sihtpunkti kaugusel olevate objektide suurus sellest ei muutu.</translation>
    </message>
    <message>
        <source>Lecture 003&apos;s focal length e = 1/tan(fov/2), with the horizontal fov: at this distance the picture reaches from x = −1 to 1.</source>
        <translation>Loengu 003 fookuskaugus e = 1/tan(fov/2), kus fov on horisontaalne: sellel kaugusel ulatub pilt kohast x = −1 kuni 1.</translation>
    </message>
    <message>
        <source>Left</source>
        <translation>Vasak</translation>
    </message>
    <message>
        <source>Left edge of the picture&apos;s window on the near plane: where the view volume begins in x of view space.</source>
        <translation>Pildi akna vasak serv lähitasandil: kust nähtav ruum kaamerafreimi x-sihis algab.</translation>
    </message>
    <message>
        <source>Lens</source>
        <translation>Objektiiv</translation>
    </message>
    <message>
        <source>Moves the object along the axes of the tiles to its left.</source>
        <translation>Nihutab objekti piki telgi, mille annavad lülid sellest vasakul.</translation>
    </message>
    <message>
        <source>NDC z</source>
        <translation>NDC z</translation>
    </message>
    <message>
        <source>Near</source>
        <translation>Lähitasand</translation>
    </message>
    <message>
        <source>Near goes to 0, far to 1.</source>
        <translation>Lähitasandist saab 0, kaugtasandist 1.</translation>
    </message>
    <message>
        <source>Near goes to 1, far to 0: floats are densest where depth needs them.</source>
        <translation>Lähitasandist saab 1, kaugtasandist 0: ujukomaarvud on kõige tihedamad seal, kus sügavus neid vajab.</translation>
    </message>
    <message>
        <source>Near goes to −1, far to 1.</source>
        <translation>Lähitasandist saab −1, kaugtasandist 1.</translation>
    </message>
    <message>
        <source>OpenGL: −1 to 1</source>
        <translation>OpenGL: −1 kuni 1</translation>
    </message>
    <message>
        <source>Principal point, downwards from the centre of the first pixel. At the image&apos;s centre the lens is symmetric, elsewhere off-axis.</source>
        <translation>Peapunkt, esimese piksli keskpunktist allapoole. Pildi keskpunktis on objektiiv sümmeetriline, mujal teljeväline.</translation>
    </message>
    <message>
        <source>Principal point, to the right from the centre of the first pixel. At the image&apos;s centre the lens is symmetric, elsewhere off-axis.</source>
        <translation>Peapunkt, esimese piksli keskpunktist paremale. Pildi keskpunktis on objektiiv sümmeetriline, mujal teljeväline.</translation>
    </message>
    <message>
        <source>Proportions</source>
        <translation>Proportsioonid</translation>
    </message>
    <message>
        <source>Receding</source>
        <translation>Sügavusmastaap</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>Parem</translation>
    </message>
    <message>
        <source>Right edge of the picture&apos;s window on the near plane: where the view volume ends in x of view space.</source>
        <translation>Pildi akna parem serv lähitasandil: kus nähtav ruum kaamerafreimi x-sihis lõpeb.</translation>
    </message>
    <message>
        <source>Roll</source>
        <translation>Kallutus</translation>
    </message>
    <message>
        <source>Rotation</source>
        <translation>Pööre</translation>
    </message>
    <message>
        <source>Scale</source>
        <translation>Skaleerimine</translation>
    </message>
    <message>
        <source>Shear</source>
        <translation>Kaldnihe</translation>
    </message>
    <message>
        <source>Stretches the object along the axes of the tiles to its left: 0 flattens it, −1 mirrors it.</source>
        <translation>Venitab objekti piki telgi, mille annavad lülid sellest vasakul: 0 surub selle lamedaks, −1 peegeldab.</translation>
    </message>
    <message>
        <source>Target</source>
        <translation>Sihtpunkt</translation>
    </message>
    <message>
        <source>The centre of projection, in world coordinates.</source>
        <translation>Projektsiooni keskpunkt ehk kaamera positsioon, maailma koordinaatides.</translation>
    </message>
    <message>
        <source>The direction that is vertical in the picture (the lectures&apos; view-up vector); its length does not matter.</source>
        <translation>Suund, mis on pildil vertikaalne (loengute view-up vektor); selle pikkus ei loe.</translation>
    </message>
    <message>
        <source>The moves of the object, as their product is written: the rightmost acts first.</source>
        <translation>Objekti liigutused nii, nagu nende korrutis kirjutatakse: kõige parempoolsem mõjub esimesena.</translation>
    </message>
    <message>
        <source>The point that the camera looks at, in world coordinates.</source>
        <translation>Punkt, mida kaamera vaatab, maailma koordinaatides.</translation>
    </message>
    <message>
        <source>The standard drawings of textbooks. The target stays in its place in the picture.</source>
        <translation>Õpikute standardjoonised. Sihtpunkt jääb pildil oma kohale.</translation>
    </message>
    <message>
        <source>The window fills the image; circles may become ellipses.</source>
        <translation>Aken täidab pildi; ringidest võivad saada ellipsid.</translation>
    </message>
    <message>
        <source>The x range grows or shrinks about its centre (lecture 000, variant Y).</source>
        <translation>x-vahemik kasvab või kahaneb oma keskkoha ümber (loengu 000 variant Y).</translation>
    </message>
    <message>
        <source>The y range grows or shrinks about its centre (lecture 000, variant X).</source>
        <translation>y-vahemik kasvab või kahaneb oma keskkoha ümber (loengu 000 variant X).</translation>
    </message>
    <message>
        <source>The z of the near and the far plane in the NDC cube.</source>
        <translation>Lähi- ja kaugtasandi z NDC kuubis.</translation>
    </message>
    <message>
        <source>Top</source>
        <translation>Ülemine</translation>
    </message>
    <message>
        <source>Top edge of the picture&apos;s window on the near plane: where the view volume ends in y of view space.</source>
        <translation>Pildi akna ülemine serv lähitasandil: kus nähtav ruum kaamerafreimi y-sihis lõpeb.</translation>
    </message>
    <message>
        <source>Translation</source>
        <translation>Nihe</translation>
    </message>
    <message>
        <source>Turns the camera about its view direction; clockwise as the photographer sees it.</source>
        <translation>Pöörab kaamerat ümber vaate suuna; fotograafi poolt vaadates päripäeva.</translation>
    </message>
    <message>
        <source>Turns the object about an axis through the origin of the tiles to its left.</source>
        <translation>Pöörab objekti ümber telje, mis läbib sellest vasakul olevate lülide alguspunkti.</translation>
    </message>
    <message>
        <source>Typed matrix</source>
        <translation>Sisestatud maatriks</translation>
    </message>
    <message>
        <source>Up</source>
        <translation>Üles</translation>
    </message>
    <message>
        <source>Walks round the target: 0 is on its +z side, 90 on its +x side.</source>
        <translation>Käib ümber sihtpunkti: 0 on selle +z-poolel, 90 selle +x-poolel.</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Laius</translation>
    </message>
    <message>
        <source>Width becomes 1/1 of the height, in whole pixels.</source>
        <translation>Laiuseks saab 1/1 kõrgusest, täispikslites.</translation>
    </message>
    <message>
        <source>Width becomes 16/9 of the height, in whole pixels.</source>
        <translation>Laiuseks saab 16/9 kõrgusest, täispikslites.</translation>
    </message>
    <message>
        <source>Width becomes 4/3 of the height, in whole pixels.</source>
        <translation>Laiuseks saab 4/3 kõrgusest, täispikslites.</translation>
    </message>
    <message>
        <source>Width of the picture in pixels.</source>
        <translation>Pildi laius pikslites.</translation>
    </message>
    <message>
        <source>Width over height. The height stays, and with it the vertical field of view: the picture gains or loses at its sides. The window of another lens follows as “Proportions” says.</source>
        <translation>Laius jagatud kõrgusega. Kõrgus jääb samaks ja koos sellega vertikaalne frustumi nurk: pilt võidab või kaotab külgedelt. Teise objektiivi aken järgib seda nii, nagu määravad „Proportsioonid“.</translation>
    </message>
    <message>
        <source>cabinet, 30°</source>
        <translation>cabinet, 30°</translation>
    </message>
    <message>
        <source>cabinet, 45°</source>
        <translation>cabinet, 45°</translation>
    </message>
    <message>
        <source>cabinet, 63.4°</source>
        <translation>cabinet, 63.4°</translation>
    </message>
    <message>
        <source>cavalier, 30°</source>
        <translation>cavalier, 30°</translation>
    </message>
    <message>
        <source>cavalier, 45°</source>
        <translation>cavalier, 45°</translation>
    </message>
    <message>
        <source>cavalier, 63.4°</source>
        <translation>cavalier, 63.4°</translation>
    </message>
    <message>
        <source>cx</source>
        <translation>cx</translation>
    </message>
    <message>
        <source>cy</source>
        <translation>cy</translation>
    </message>
    <message>
        <source>depth range NDC z buffer OpenGL Direct3D reversed</source>
        <translation>sügavusvahemik NDC z puhver OpenGL Direct3D pööratud</translation>
    </message>
    <message>
        <source>f plane clipping zFar infinity</source>
        <translation>f tasand pügamine kärpimine zFar lõpmatus</translation>
    </message>
    <message>
        <source>field of view angle</source>
        <translation>vaateväli vaatenurk nurk</translation>
    </message>
    <message>
        <source>free</source>
        <translation>vaba</translation>
    </message>
    <message>
        <source>fx</source>
        <translation>fx</translation>
    </message>
    <message>
        <source>fy</source>
        <translation>fy</translation>
    </message>
    <message>
        <source>half-angle</source>
        <translation>poolnurk</translation>
    </message>
    <message>
        <source>image size ratio proportions</source>
        <translation>pildi suurus suhe proportsioonid</translation>
    </message>
    <message>
        <source>image size resolution pixels</source>
        <translation>pildi suurus lahutus pikslid</translation>
    </message>
    <message>
        <source>keep aspect stretch</source>
        <translation>säilita kuvasuhe venita</translation>
    </message>
    <message>
        <source>keep x, fit y</source>
        <translation>säilita x, sobita y</translation>
    </message>
    <message>
        <source>keep y, fit x</source>
        <translation>säilita y, sobita x</translation>
    </message>
    <message>
        <source>n plane clipping zNear</source>
        <translation>n tasand pügamine kärpimine zNear</translation>
    </message>
    <message>
        <source>object transform translate rotate scale shear mirror matrix tiles order</source>
        <translation>objekti teisendus nihe pööre skaleerimine kaldnihe peegeldus maatriks lülid järjekord</translation>
    </message>
    <message>
        <source>oblique shear</source>
        <translation>kaldnurgaline kaldnihe</translation>
    </message>
    <message>
        <source>orbit angles</source>
        <translation>tiirlemise nurgad</translation>
    </message>
    <message>
        <source>orbit tilt</source>
        <translation>tiirlemise kalle</translation>
    </message>
    <message>
        <source>preset cavalier cabinet oblique</source>
        <translation>valmisjoonis cavalier cabinet kaldnurgaline</translation>
    </message>
    <message>
        <source>projection lens perspective glFrustum glOrtho orthographic oblique matrix</source>
        <translation>projektsioon objektiiv perspektiivne glFrustum glOrtho ortograafiline kaldnurgaline maatriks</translation>
    </message>
    <message>
        <source>reversed: 1 to 0</source>
        <translation>pööratud: 1 kuni 0</translation>
    </message>
    <message>
        <source>stretch</source>
        <translation>venita</translation>
    </message>
    <message>
        <source>times the true length</source>
        <translation>tegelikust pikkusest</translation>
    </message>
    <message>
        <source>vectors look at</source>
        <translation>vektorid vaate suund</translation>
    </message>
    <message>
        <source>vectors position</source>
        <translation>vektorid kaamera positsioon asukoht</translation>
    </message>
    <message>
        <source>vectors view-up VUP</source>
        <translation>vektorid view-up VUP</translation>
    </message>
    <message>
        <source>vertical fov angle zoom gluPerspective</source>
        <translation>vertikaalne FOV nurk suum gluPerspective</translation>
    </message>
    <message>
        <source>window l r b t glFrustum glOrtho off-axis</source>
        <translation>aken l r b t glFrustum glOrtho teljeväline</translation>
    </message>
    <message>
        <source>window right r glFrustum</source>
        <translation>aken parem r glFrustum</translation>
    </message>
    <message>
        <source>window top t glFrustum</source>
        <translation>aken ülemine t glFrustum</translation>
    </message>
    <message>
        <source>zoom 35 mm camera f</source>
        <translation>suum 35 mm kaamera f</translation>
    </message>
</context>
<context>
    <name>Files</name>
    <message>
        <source>Opening {0}</source>
        <translation>Avatakse {0}</translation>
    </message>
    <message>
        <source>Open a document, a lesson, a mesh, a camera or an exported picture</source>
        <translation>Dokumendi, õppetunni, võrgu, kaamera või eksporditud pildi avamine</translation>
    </message>
    <message>
        <source>All supported files ({0});;All files (*)</source>
        <translation>Kõik toetatud failid ({0});;Kõik failid (*)</translation>
    </message>
    <message>
        <source>Open a camera</source>
        <translation>Kaamera avamine</translation>
    </message>
    <message>
        <source>The file has {0} views:</source>
        <translation>Vaateid failis: {0}</translation>
    </message>
    <message>
        <source>Close the lesson, and Undo brings back the unsaved changes to {0}.</source>
        <translation>Sulgege õppetund, siis toob „Võta tagasi“ dokumendi {0} salvestamata muudatused tagasi.</translation>
    </message>
    <message>
        <source>Undo brings back the unsaved changes to {0}.</source>
        <translation>„Võta tagasi“ toob dokumendi {0} salvestamata muudatused tagasi.</translation>
    </message>
    <message>
        <source>Where is the mesh {0} of this picture?</source>
        <translation>Kus on selle pildi võrk {0}?</translation>
    </message>
    <message>
        <source>Meshes ({0});;All files (*)</source>
        <translation>Võrgud ({0});;Kõik failid (*)</translation>
    </message>
    <message>
        <source>Use a mesh in place of the scene&apos;s own objects</source>
        <translation>Võrk stseeni oma objektide asemel</translation>
    </message>
    <message>
        <source>{0} has been changed elsewhere since it was opened or saved here.</source>
        <translation>{0} on pärast siin avamist või salvestamist mujal muutunud.</translation>
    </message>
    <message>
        <source>Save over it?</source>
        <translation>Kas kirjutada see üle?</translation>
    </message>
    <message>
        <source>Save &amp;over it</source>
        <translation>Kirjuta &amp;üle</translation>
    </message>
    <message>
        <source>Save &amp;as…</source>
        <translation>Salvesta &amp;nimega…</translation>
    </message>
    <message>
        <source>Save the document</source>
        <translation>Dokumendi salvestamine</translation>
    </message>
    <message>
        <source>Frustum Lab documents (*.json)</source>
        <translation>Frustum Labi dokumendid (*.json)</translation>
    </message>
    <message>
        <source>There are unsaved changes.</source>
        <translation>Mõned muudatused on salvestamata.</translation>
    </message>
    <message>
        <source>Save them first?</source>
        <translation>Kas salvestada need enne?</translation>
    </message>
    <message>
        <source>Untitled</source>
        <translation>Nimetu</translation>
    </message>
</context>
<context>
    <name>FixedViews</name>
    <message>
        <source>Free</source>
        <translation>Vabalt</translation>
    </message>
    <message>
        <source>As you turned it with the mouse</source>
        <translation>Nii, nagu te selle hiirega pöörasite</translation>
    </message>
    <message>
        <source>Side</source>
        <translation>Küljelt</translation>
    </message>
    <message>
        <source>From the side, flat like a sketch on the blackboard, with its lengths</source>
        <translation>Küljelt, lamedalt nagu visand tahvlil, koos pikkustega</translation>
    </message>
    <message>
        <source>Above</source>
        <translation>Ülalt</translation>
    </message>
    <message>
        <source>From above, flat, with its lengths</source>
        <translation>Ülalt, lamedalt, koos pikkustega</translation>
    </message>
    <message>
        <source>Axis</source>
        <translation>Piki telge</translation>
    </message>
    <message>
        <source>Along the camera&apos;s axis, flat</source>
        <translation>Piki kaamera telge, lamedalt</translation>
    </message>
    <message>
        <source>Eye</source>
        <translation>Silmast</translation>
    </message>
    <message>
        <source>From the eye, as the camera sees it</source>
        <translation>Silmast, nii nagu kaamera näeb</translation>
    </message>
    <message>
        <source>Viewpoint of the world</source>
        <translation>Maailma vaatepunkt</translation>
    </message>
</context>
<context>
    <name>FramePanel</name>
    <message>
        <source>Camera frame</source>
        <translation>Kaamerafreim</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Tagasi</translation>
    </message>
    <message>
        <source>One step back</source>
        <translation>Üks samm tagasi</translation>
    </message>
    <message>
        <source>Next</source>
        <translation>Edasi</translation>
    </message>
    <message>
        <source>The next step</source>
        <translation>Järgmine samm</translation>
    </message>
    <message>
        <source>Show all</source>
        <translation>Näita kõike</translation>
    </message>
    <message>
        <source>All steps at once</source>
        <translation>Kõik sammud korraga</translation>
    </message>
    <message>
        <source>The step in numbers</source>
        <translation>Samm arvudes</translation>
    </message>
    <message>
        <source>Up from view</source>
        <translation>Üles, nurk vaatega</translation>
    </message>
    <message>
        <source>Turns up towards the view direction, in the plane of both. The frame stays the same until up is too close to the view direction to say where right is.</source>
        <translation>Pöörab ülesvektorit vaate suuna poole, nende ühises tasandis. Freim jääb samaks, kuni ülesvektor on vaate suunale nii lähedal, et see ei ütle enam, kus on parem pool.</translation>
    </message>
    <message>
        <source>degrees</source>
        <translation>kraadi</translation>
    </message>
    <message>
        <source>Nudge up by {0}° to the side</source>
        <translation>Nihuta ülesvektorit {0}° kõrvale</translation>
    </message>
    <message>
        <source>Make an error in up, and see how far the picture turns</source>
        <translation>Tekitage ülesvektorisse viga ja vaadake, kui palju pilt pöördub</translation>
    </message>
    <message>
        <source>The effect of up</source>
        <translation>Ülesvektori mõju</translation>
    </message>
    <message>
        <source>The step</source>
        <translation>Samm</translation>
    </message>
    <message>
        <source>{0} of {1}: {2}</source>
        <translation>{0} / {1}: {2}</translation>
    </message>
    <message>
        <source>Play</source>
        <translation>Esita</translation>
    </message>
    <message>
        <source>Show one step after the other</source>
        <translation>Näitab samme üksteise järel</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Paus</translation>
    </message>
    <message>
        <source>Stay at this step</source>
        <translation>Jääb selle sammu juurde</translation>
    </message>
    <message>
        <source>Angle of {3} and view direction: {0}°
|{3} × {4}| = {1}
An error in {3} is {2} times as large in u and v.</source>
        <translation>Nurk {3} ja vaate suuna vahel: {0}°
|{3} × {4}| = {1}
Vektori {3} viga on telgedel u ja v {2} korda nii suur.</translation>
    </message>
    <message>
        <source>Up is only {0}° from the line of sight: up × n is nearly 0, and an error of {1}° in up turns the picture by up to {2}°.</source>
        <translation>Ülesvektor on vaatekiirest ainult {0}° kaugusel: üles × n on peaaegu 0 ja {1}° viga ülesvektoris pöörab pilti kuni {2}°.</translation>
    </message>
    <message>
        <source>No camera has the typed view matrix: these are the numbers of the previous camera. Undo, or choose a lens.</source>
        <translation>Sisestatud vaatemaatriks ei sobi ühelegi kaamerale: need on eelmise kaamera arvud. Võtke tagasi või valige objektiiv.</translation>
    </message>
    <message>
        <source>Backwards, from the target to the eye, of length 1: the camera looks along −{n}.</source>
        <translation>Tahapoole, sihtpunktist silma, pikkusega 1: kaamera vaatab suunas −{n}.</translation>
    </message>
    <message>
        <source>The camera looks at the target; only the direction matters.</source>
        <translation>Kaamera vaatab sihtpunkti; tähtis on ainult suund.</translation>
    </message>
    <message>
        <source>The centre of projection: where the camera stands in the world.</source>
        <translation>Projektsiooni keskpunkt: kus kaamera maailmas seisab.</translation>
    </message>
    <message>
        <source>The direction that is vertical in the picture. It need not be perpendicular to the view, and its length does not matter.</source>
        <translation>Suund, mis on pildil vertikaalne. See ei pea olema vaate suunaga risti ja selle pikkus ei loe.</translation>
    </message>
    <message>
        <source>The rows of the rotation R are {u}, {v} and {n}; {T} moves the eye to the origin, so that the last column is −R {e}.</source>
        <translation>Pöörde R read on {u}, {v} ja {n}; {T} viib silma alguspunkti, nii et viimane veerg on −R {e}.</translation>
    </message>
    <message>
        <source>To the right in the picture: at right angles to {up} and {n}, of length 1.</source>
        <translation>Pildil paremale: risti vektoritega {up} ja {n}, pikkusega 1.</translation>
    </message>
    <message>
        <source>Upwards in the picture: at right angles to {n} and {u}. It is the part of {up} at right angles to the view.</source>
        <translation>Pildil üles: risti vektoritega {n} ja {u}. See on vektori {up} see osa, mis on vaate suunaga risti.</translation>
    </message>
    <message>
        <source>eye</source>
        <translation>silm</translation>
    </message>
    <message>
        <source>look</source>
        <translation>vaate suund</translation>
    </message>
    <message>
        <source>up</source>
        <translation>üles</translation>
    </message>
    <message>
        <source>view matrix</source>
        <translation>vaatemaatriks</translation>
    </message>
    <message>
        <source>{n}</source>
        <translation>{n}</translation>
    </message>
    <message>
        <source>{u}</source>
        <translation>{u}</translation>
    </message>
    <message>
        <source>{v}</source>
        <translation>{v}</translation>
    </message>
</context>
<context>
    <name>Hand</name>
    <message>
        <source>Drag to turn, Shift-drag to move, wheel to zoom</source>
        <translation>Lohistamine pöörab, Shift-lohistamine nihutab, ratas suumib</translation>
    </message>
    <message>
        <source>Arrow keys turn, Shift and an arrow moves, + and − zoom, Home resets.</source>
        <translation>Nooleklahvid pööravad, Shift ja nool nihutavad, + ja − suumivad, Home lähtestab.</translation>
    </message>
    <message>
        <source>Drag to move the camera, wheel to go nearer</source>
        <translation>Lohistamine liigutab kaamerat, ratas viib lähemale</translation>
    </message>
    <message>
        <source>Arrow keys move the camera in its plane, + and − go nearer and back.</source>
        <translation>Nooleklahvid liigutavad kaamerat oma tasandis, + ja − viivad lähemale ja tagasi.</translation>
    </message>
    <message>
        <source>Page Down and Page Up go from vertex to vertex, with Shift from handle to handle or probe to probe; Space follows a vertex; Enter takes hold and lets go, Shift and Enter as a drag with Shift; arrows drag by a pixel, with Shift by ten; Escape puts back.</source>
        <translation>Page Down ja Page Up lähevad tipust tippu, koos klahviga Shift pidemelt pidemele või sondilt sondile; tühik jälgib tippu; Enter haarab ja laseb lahti, Shift ja Enter nagu Shift-lohistamine; nooled lohistavad piksli kaupa, koos klahviga Shift kümne kaupa; Escape paneb tagasi.</translation>
    </message>
</context>
<context>
    <name>Header</name>
    <message>
        <source>Double-click to enlarge this pane, again for the whole window, and again to go back</source>
        <translation>Topeltklõps suurendab paani, teine annab sellele kogu akna ja kolmas viib tagasi</translation>
    </message>
</context>
<context>
    <name>Health</name>
    <message>
        <source>A GPU&apos;s float32 cannot hold this picture: it is computed in float64</source>
        <translation>GPU float32 ei suuda seda pilti esitada: see arvutatakse float64-s</translation>
    </message>
    <message>
        <source>A GPU&apos;s float32 could be up to {0} px off: the picture is computed in float64</source>
        <translation>GPU float32 võiks eksida kuni {0} px: pilt arvutatakse float64-s</translation>
    </message>
    <message>
        <source>At the target, a 24-bit depth buffer cannot tell any two surfaces apart</source>
        <translation>Sihtpunkti kaugusel ei erista 24-bitine sügavuspuhver üht pinda teisest</translation>
    </message>
    <message>
        <source>At the target, a 24-bit depth buffer separates only surfaces at least {0} apart</source>
        <translation>Sihtpunkti kaugusel eristab 24-bitine sügavuspuhver ainult pindu, mille vahe on vähemalt {0}</translation>
    </message>
    <message>
        <source>In float64 few decimals would be certain, {0} of a pixel and {1} of the depth: the numbers are computed exactly</source>
        <translation>float64-s oleks kindlaid kümnendkohti vähe, pikslil {0} ja sügavusel {1}: arvud arvutatakse täpselt</translation>
    </message>
    <message>
        <source>None of the scene&apos;s objects is in the picture: all lie outside the {0} plane</source>
        <translation>Pildil ei ole ühtki stseeni objekti: kõik jäävad väljapoole tasandit ({0})</translation>
    </message>
    <message>
        <source>The free matrix has no inverse: no frustum is drawn</source>
        <translation>Vabal maatriksil ei ole pöördmaatriksit: frustumit ei joonistata</translation>
    </message>
    <message>
        <source>The free matrix is too nearly singular: no frustum is drawn</source>
        <translation>Vaba maatriks on peaaegu singulaarne: frustumit ei joonistata</translation>
    </message>
    <message>
        <source>The free matrix&apos;s view volume reaches infinity: no frustum is drawn</source>
        <translation>Vaba maatriksi nähtav ruum ulatub lõpmatusse: frustumit ei joonistata</translation>
    </message>
    <message>
        <source>The scene is {0} times as large as the near distance: from 1e7 on, VTK alone does not draw what is near</source>
        <translation>Stseen on lähitasandi kaugusest {0} korda suurem: alates 1e7-st ei joonista VTK üksi lähedal olevat</translation>
    </message>
    <message>
        <source>VTK&apos;s own camera would clamp the field of view to {0}°</source>
        <translation>VTK oma kaamera piiraks frustumi nurga väärtusega {0}°</translation>
    </message>
</context>
<context>
    <name>Help</name>
    <message>
        <source>Keys and mouse</source>
        <translation>Klahvid ja hiir</translation>
    </message>
    <message>
        <source>. or B</source>
        <translation>. või B</translation>
    </message>
    <message>
        <source>&lt;b&gt;Frustum Lab {0}&lt;/b&gt;</source>
        <translation>&lt;b&gt;Frustum Lab {0}&lt;/b&gt;</translation>
    </message>
    <message>
        <source>A black screen, and back</source>
        <translation>Must ekraan, ja tagasi</translation>
    </message>
    <message>
        <source>A corner</source>
        <translation>Nurk</translation>
    </message>
    <message>
        <source>A hint; {Alt+W} shows why an answer is wrong</source>
        <translation>Vihje; {Alt+D} näitab, miks vastus on vale</translation>
    </message>
    <message>
        <source>A lamp, a point, also in the cube and the image</source>
        <translation>Lamp, punkt, ka kuubis ja pildil</translation>
    </message>
    <message>
        <source>A laser pointer; pictures do not react to it</source>
        <translation>Laserosuti; pildid sellele ei reageeri</translation>
    </message>
    <message>
        <source>A pane&apos;s own view (the model does not change)</source>
        <translation>Paani oma vaade (mudel ei muutu)</translation>
    </message>
    <message>
        <source>A picture plane, a film, a plane in focus</source>
        <translation>Pilditasand, film, fookustasand</translation>
    </message>
    <message>
        <source>A side of a lens with a window</source>
        <translation>Aknaga objektiivi külg</translation>
    </message>
    <message>
        <source>A small step; Home and End go to its ends</source>
        <translation>Väike samm; Home ja End lähevad otstesse</translation>
    </message>
    <message>
        <source>About Frustum Lab</source>
        <translation>Frustum Labist</translation>
    </message>
    <message>
        <source>Always turn the view</source>
        <translation>Pööra alati vaadet</translation>
    </message>
    <message>
        <source>Arrows, Enter</source>
        <translation>Nooled, Enter</translation>
    </message>
    <message>
        <source>Arrows, while held</source>
        <translation>Nooled, kui see on haaratud</translation>
    </message>
    <message>
        <source>Backspace, or {Ctrl+Z}</source>
        <translation>Backspace või {Ctrl+Z}</translation>
    </message>
    <message>
        <source>Bring World, NDC cube or Image into the large slot</source>
        <translation>Too Maailm, NDC kuup või Pilt suurele kohale</translation>
    </message>
    <message>
        <source>Camera frame: &lt;i&gt;n&lt;/i&gt; = (eye − target)/|·|, &lt;i&gt;u&lt;/i&gt; = up × n/|·|, &lt;i&gt;v&lt;/i&gt; = n × u.</source>
        <translation>Kaamerafreim: &lt;i&gt;n&lt;/i&gt; = (silm − siht)/|·|, &lt;i&gt;u&lt;/i&gt; = üles × n/|·|, &lt;i&gt;v&lt;/i&gt; = n × u.</translation>
    </message>
    <message>
        <source>Change the field of view, or that corner of a lens with a window; with Shift, both sides</source>
        <translation>Muuda frustumi nurka või aknaga objektiivi seda nurka; koos klahviga Shift mõlemat külge</translation>
    </message>
    <message>
        <source>Change the value, with Ctrl or when the slider has the focus</source>
        <translation>Muuda väärtust, koos klahviga Ctrl või kui fookus on liuguril</translation>
    </message>
    <message>
        <source>Choose an answer and submit it; Enter also checks a typed answer</source>
        <translation>Vali vastus ja esita see; Enter kontrollib ka sisestatud vastust</translation>
    </message>
    <message>
        <source>Click</source>
        <translation>Klõps</translation>
    </message>
    <message>
        <source>Close what is on top, or cancel a drag</source>
        <translation>Sulge kõige pealmine või katkesta lohistamine</translation>
    </message>
    <message>
        <source>Column vectors, &lt;i&gt;p&apos; = M p&lt;/i&gt;. World and view are right-handed with y up; the camera looks along −z of view space.</source>
        <translation>Veeruvektorid, &lt;i&gt;p&apos; = M p&lt;/i&gt;. Maailm ja vaade on paremakäelised, y suunaga üles; kaamera vaatab kaamerafreimi −z suunas.</translation>
    </message>
    <message>
        <source>Compare side by side or overlaid</source>
        <translation>Võrdle kõrvuti või ülestikku</translation>
    </message>
    <message>
        <source>Controls</source>
        <translation>Juhtelemendid</translation>
    </message>
    <message>
        <source>Conventions</source>
        <translation>Kokkulepped</translation>
    </message>
    <message>
        <source>Digits, then Enter</source>
        <translation>Numbrid, siis Enter</translation>
    </message>
    <message>
        <source>Double-click</source>
        <translation>Topeltklõps</translation>
    </message>
    <message>
        <source>Double-click its name</source>
        <translation>Topeltklõps nimel</translation>
    </message>
    <message>
        <source>Double-click, F2 or Enter</source>
        <translation>Topeltklõps, F2 või Enter</translation>
    </message>
    <message>
        <source>Drag</source>
        <translation>Lohistamine</translation>
    </message>
    <message>
        <source>Drag by one pixel; with Shift, by ten; Esc cancels</source>
        <translation>Lohista ühe piksli võrra; koos klahviga Shift kümne võrra; Esc katkestab</translation>
    </message>
    <message>
        <source>Drag it; with Shift, ten times finer</source>
        <translation>Lohista seda; koos klahviga Shift kümme korda peenemalt</translation>
    </message>
    <message>
        <source>Drag its mark in the image</source>
        <translation>Lohista selle märki pildil</translation>
    </message>
    <message>
        <source>Drag, or arrows</source>
        <translation>Lohistamine või nooled</translation>
    </message>
    <message>
        <source>Draw on the slide, or put the pen away</source>
        <translation>Joonista slaidile või pane pliiats ära</translation>
    </message>
    <message>
        <source>Draw; with the right mouse button, erase</source>
        <translation>Joonista; parema hiirenupuga kustuta</translation>
    </message>
    <message>
        <source>Drop a file</source>
        <translation>Faili aknasse lohistamine</translation>
    </message>
    <message>
        <source>E</source>
        <translation>E</translation>
    </message>
    <message>
        <source>Enlarge or shrink the speaker&apos;s notes</source>
        <translation>Suurenda või vähenda esineja märkmeid</translation>
    </message>
    <message>
        <source>Enter</source>
        <translation>Enter</translation>
    </message>
    <message>
        <source>Esc</source>
        <translation>Esc</translation>
    </message>
    <message>
        <source>Everywhere</source>
        <translation>Kõikjal</translation>
    </message>
    <message>
        <source>Export the panes as a picture</source>
        <translation>Ekspordi paanid pildina</translation>
    </message>
    <message>
        <source>Eye, target</source>
        <translation>Silm, sihtpunkt</translation>
    </message>
    <message>
        <source>Field</source>
        <translation>Väli</translation>
    </message>
    <message>
        <source>Find a control by its name</source>
        <translation>Otsi juhtelementi nime järgi</translation>
    </message>
    <message>
        <source>Follow the point through all panes</source>
        <translation>Jälgi punkti läbi kõigi paanide</translation>
    </message>
    <message>
        <source>Follow the vertex</source>
        <translation>Jälgi tippu</translation>
    </message>
    <message>
        <source>Give that pane the whole window</source>
        <translation>Anna sellele paanile kogu aken</translation>
    </message>
    <message>
        <source>Go from stage to stage</source>
        <translation>Mine etapist etappi</translation>
    </message>
    <message>
        <source>Go from vertex to vertex; with Shift, from grip to grip</source>
        <translation>Mine tipust tippu; koos klahviga Shift pidemelt pidemele</translation>
    </message>
    <message>
        <source>Go nearer or farther</source>
        <translation>Mine lähemale või kaugemale</translation>
    </message>
    <message>
        <source>Go to the next number; Esc leaves the field</source>
        <translation>Mine järgmise arvu juurde; Esc lahkub väljalt</translation>
    </message>
    <message>
        <source>Go to the step of that number</source>
        <translation>Mine selle numbriga sammu juurde</translation>
    </message>
    <message>
        <source>Hide the controls, or show them</source>
        <translation>Peida juhtelemendid või näita neid</translation>
    </message>
    <message>
        <source>Highlight the same thing everywhere; the keyboard&apos;s focus does the same</source>
        <translation>Tõsta sama asi kõikjal esile; klaviatuuri fookus teeb sedasama</translation>
    </message>
    <message>
        <source>Hold it and compare it with later ones, or end the comparison</source>
        <translation>Jäta see meelde ja võrdle hilisematega või lõpeta võrdlus</translation>
    </message>
    <message>
        <source>Hold what has the grip and release it; with Shift, it works like a Shift-drag</source>
        <translation>Haara see, millel on pide, ja lase lahti; koos klahviga Shift mõjub see nagu Shift-lohistamine</translation>
    </message>
    <message>
        <source>Hover over a control, a number, a matrix cell, or what can be dragged</source>
        <translation>Hiir juhtelemendi, arvu, maatriksi lahtri või lohistatava asja kohal</translation>
    </message>
    <message>
        <source>How a camera turns a 3-D scene into a picture: the world, the NDC cube and the image, from one model.</source>
        <translation>Kuidas kaamera teeb 3-D stseenist pildi: maailm, NDC kuup ja pilt ühest mudelist.</translation>
    </message>
    <message>
        <source>Image: origin top left, x right, y down, in pixels; the first pixel&apos;s centre is at 0.5.</source>
        <translation>Pilt: alguspunkt üleval vasakul, x paremale, y alla, pikslites; esimese piksli keskpunkt on kohal 0.5.</translation>
    </message>
    <message>
        <source>K</source>
        <translation>K</translation>
    </message>
    <message>
        <source>Keep the slides with their strokes beside the talk, for the handout</source>
        <translation>Hoia slaidid koos joontega ettekande kõrval alles, jaotusmaterjali jaoks</translation>
    </message>
    <message>
        <source>Lessons</source>
        <translation>Õppetunnid</translation>
    </message>
    <message>
        <source>MIT licence.</source>
        <translation>MIT litsents.</translation>
    </message>
    <message>
        <source>Make World, NDC cube or Image the slide; the same key again shows all panes</source>
        <translation>Tee Maailm, NDC kuup või Pilt slaidiks; sama klahv näitab jälle kõiki paane</translation>
    </message>
    <message>
        <source>Mark in all panes the point under the mouse</source>
        <translation>Märgi kõigis paanides punkt, mis on hiire all</translation>
    </message>
    <message>
        <source>Matrices</source>
        <translation>Maatriksid</translation>
    </message>
    <message>
        <source>Middle mouse button</source>
        <translation>Keskmine hiirenupp</translation>
    </message>
    <message>
        <source>Mouse at the top</source>
        <translation>Hiir üleval servas</translation>
    </message>
    <message>
        <source>Move along the view direction; by the face, too, where the scene has their controls</source>
        <translation>Liiguta piki vaate suunda; ka tahust, kui stseenis on selle juhtelemendid</translation>
    </message>
    <message>
        <source>Move in the plane that faces you; with Shift, up and down</source>
        <translation>Liiguta vaataja poole pööratud tasandis; koos klahviga Shift üles ja alla</translation>
    </message>
    <message>
        <source>Move it</source>
        <translation>Liiguta seda</translation>
    </message>
    <message>
        <source>Move it along its way</source>
        <translation>Liiguta seda mööda selle teed</translation>
    </message>
    <message>
        <source>Move it; with Shift, both sides</source>
        <translation>Liiguta seda; koos klahviga Shift mõlemat külge</translation>
    </message>
    <message>
        <source>Move it; with Shift, finer; Home and End go to the edges; Esc ends the comparison</source>
        <translation>Liiguta seda; koos klahviga Shift peenemalt; Home ja End lähevad servadeni; Esc lõpetab võrdluse</translation>
    </message>
    <message>
        <source>Move it; with Shift, up and down</source>
        <translation>Liiguta seda; koos klahviga Shift üles ja alla</translation>
    </message>
    <message>
        <source>Move the camera in its plane</source>
        <translation>Liiguta kaamerat oma tasandis</translation>
    </message>
    <message>
        <source>Move the camera towards the target or away from it</source>
        <translation>Liiguta kaamerat sihtpunkti poole või sellest eemale</translation>
    </message>
    <message>
        <source>Move the point in its plane; with Shift, along its ray</source>
        <translation>Liiguta punkti oma tasandis; koos klahviga Shift piki oma kiirt</translation>
    </message>
    <message>
        <source>NDC is the OpenGL cube [−1, 1]³, near at −1 and far at +1; Direct3D has z in [0, 1], reversed in [1, 0]. It is drawn with z mirrored so that the near face is towards you.</source>
        <translation>NDC on OpenGL-i kuup [−1, 1]³, lähitasand kohal −1 ja kaugtasand kohal +1; Direct3D z on vahemikus [0, 1], pööratud z vahemikus [1, 0]. Joonisel on z peegeldatud, et lähitasandi tahk oleks teie poole.</translation>
    </message>
    <message>
        <source>Name everything in the pictures, or only what the scene is about</source>
        <translation>Nimeta piltidel kõik või ainult see, millest stseen räägib</translation>
    </message>
    <message>
        <source>Near, far, by an edge or their name</source>
        <translation>Lähi- ja kaugtasand, servast või nimest</translation>
    </message>
    <message>
        <source>Open a document, a lesson, a mesh (OBJ, STL, PLY, glTF), a camera (NeRF, COLMAP, OpenCV) or an exported picture</source>
        <translation>Ava dokument, õppetund, võrk (OBJ, STL, PLY, glTF), kaamera (NeRF, COLMAP, OpenCV) või eksporditud pilt</translation>
    </message>
    <message>
        <source>Page Down</source>
        <translation>Page Down</translation>
    </message>
    <message>
        <source>Page Down, Page Up</source>
        <translation>Page Down, Page Up</translation>
    </message>
    <message>
        <source>Page Up, Page Down</source>
        <translation>Page Up, Page Down</translation>
    </message>
    <message>
        <source>Paste a number into the cell, or a whole matrix</source>
        <translation>Aseta lahtrisse arv või kogu maatriks</translation>
    </message>
    <message>
        <source>Play it back and forth</source>
        <translation>Esita seda edasi-tagasi</translation>
    </message>
    <message>
        <source>Play or pause the camera&apos;s walk</source>
        <translation>Pane kaamera ringkäik käima või seisma</translation>
    </message>
    <message>
        <source>Pointing</source>
        <translation>Osutamine</translation>
    </message>
    <message>
        <source>Points to follow</source>
        <translation>Jälgitavad punktid</translation>
    </message>
    <message>
        <source>Present a talk from its first step</source>
        <translation>Esitle ettekannet esimesest sammust alates</translation>
    </message>
    <message>
        <source>Present on the full screen, in letters for the back row; again to end</source>
        <translation>Esitle täisekraanil, tagumise rea jaoks suurte tähtedega; teist korda lõpetab</translation>
    </message>
    <message>
        <source>Presenting</source>
        <translation>Esitlemine</translation>
    </message>
    <message>
        <source>Presenting a talk, and in the speaker&apos;s window</source>
        <translation>Ettekande esitlemisel ja esineja aknas</translation>
    </message>
    <message>
        <source>Remove it</source>
        <translation>Eemalda see</translation>
    </message>
    <message>
        <source>Remove the last stroke; Delete removes all strokes of the step</source>
        <translation>Eemalda viimane joon; Delete eemaldab kõik selle sammu jooned</translation>
    </message>
    <message>
        <source>Reset all to how the scene opens</source>
        <translation>Lähtesta kõik nii, nagu stseen avaneb</translation>
    </message>
    <message>
        <source>Reset it</source>
        <translation>Lähtesta see</translation>
    </message>
    <message>
        <source>Shift-drag</source>
        <translation>Shift-lohistamine</translation>
    </message>
    <message>
        <source>Show all panes as the scene opens</source>
        <translation>Näita kõiki paane nii, nagu stseen avaneb</translation>
    </message>
    <message>
        <source>Show the controls of the slide, or hide them</source>
        <translation>Näita slaidi juhtelemente või peida need</translation>
    </message>
    <message>
        <source>Show the dock, or hide it</source>
        <translation>Näita külgriba või peida see</translation>
    </message>
    <message>
        <source>Show the question, then its answer, and stay at the step</source>
        <translation>Näita küsimust, siis selle vastust, ja jää selle sammu juurde</translation>
    </message>
    <message>
        <source>Show the question, then its answer, then the next step; Page Up goes the same way back</source>
        <translation>Näita küsimust, siis selle vastust, siis järgmist sammu; Page Up läheb sama teed tagasi</translation>
    </message>
    <message>
        <source>Show the slide of the step again</source>
        <translation>Näita sammu slaidi uuesti</translation>
    </message>
    <message>
        <source>Show the step again, without your changes</source>
        <translation>Näita sammu uuesti, ilma muudatusteta</translation>
    </message>
    <message>
        <source>Show the tool bar</source>
        <translation>Näita tööriistariba</translation>
    </message>
    <message>
        <source>Slider</source>
        <translation>Liugur</translation>
    </message>
    <message>
        <source>Space</source>
        <translation>Tühik</translation>
    </message>
    <message>
        <source>Swap the screens of the class and of the notes</source>
        <translation>Vaheta klassi ja märkmete ekraanid</translation>
    </message>
    <message>
        <source>Tab</source>
        <translation>Tab</translation>
    </message>
    <message>
        <source>Tab to the divider, then arrows</source>
        <translation>Tab eraldusjoonele, siis nooled</translation>
    </message>
    <message>
        <source>Tab, then arrows</source>
        <translation>Tab, siis nooled</translation>
    </message>
    <message>
        <source>The arrangement of the panes</source>
        <translation>Paanide paigutus</translation>
    </message>
    <message>
        <source>The eraser, or the pen again</source>
        <translation>Kustutaja või jälle pliiats</translation>
    </message>
    <message>
        <source>The next colour</source>
        <translation>Järgmine värv</translation>
    </message>
    <message>
        <source>The next step and the previous one, unless a pane or a control has the focus</source>
        <translation>Järgmine ja eelmine samm, kui fookus ei ole paanis ega juhtelemendil</translation>
    </message>
    <message>
        <source>The next step; {Alt+Left} for the previous one</source>
        <translation>Järgmine samm; {Alt+Left} viib eelmise juurde</translation>
    </message>
    <message>
        <source>The picture in the image pane</source>
        <translation>Pilt pildi paanis</translation>
    </message>
    <message>
        <source>The same key again, or a double-click on a title</source>
        <translation>Sama klahv uuesti või topeltklõps pealkirjal</translation>
    </message>
    <message>
        <source>The strip of stages</source>
        <translation>Etapiriba</translation>
    </message>
    <message>
        <source>The triangle</source>
        <translation>Kolmnurk</translation>
    </message>
    <message>
        <source>Turn it</source>
        <translation>Pööra seda</translation>
    </message>
    <message>
        <source>Turn it; with Shift, move it; + and − go nearer or farther; Home resets it</source>
        <translation>Pööra seda; koos klahviga Shift nihuta; + ja − viivad lähemale või kaugemale; Home lähtestab</translation>
    </message>
    <message>
        <source>Type a number, even beyond the slider&apos;s ends, and press Enter; Esc discards it</source>
        <translation>Sisesta arv, kas või väljaspool liuguri otsi, ja vajuta Enter; Esc loobub</translation>
    </message>
    <message>
        <source>Type another number into view ← world or clip ← view</source>
        <translation>Sisesta maatriksisse vaade ← maailm või kärperuum ← vaade teine arv</translation>
    </message>
    <message>
        <source>Undo; a drag is one step</source>
        <translation>Võta tagasi; lohistamine on üks samm</translation>
    </message>
    <message>
        <source>What you can drag (it lights up, and the pointer shows its way)</source>
        <translation>Mida saab lohistada (see süttib ja osuti näitab selle teed)</translation>
    </message>
    <message>
        <source>Wheel</source>
        <translation>Ratas</translation>
    </message>
    <message>
        <source>Wheel, or + and −</source>
        <translation>Ratas või + ja −</translation>
    </message>
    <message>
        <source>With the pen</source>
        <translation>Pliiatsiga</translation>
    </message>
    <message>
        <source>Without a mouse, in a pane that Tab has reached</source>
        <translation>Ilma hiireta, paanis, kuhu Tab on jõudnud</translation>
    </message>
    <message>
        <source>X</source>
        <translation>X</translation>
    </message>
    <message>
        <source>{Alt+I}</source>
        <translation>{Alt+I}</translation>
    </message>
    <message>
        <source>{Alt+Right}</source>
        <translation>{Alt+Right}</translation>
    </message>
    <message>
        <source>{B}</source>
        <translation>{B}</translation>
    </message>
    <message>
        <source>{Ctrl++}, {Ctrl+-}</source>
        <translation>{Ctrl++}, {Ctrl+-}</translation>
    </message>
    <message>
        <source>{Ctrl+0}</source>
        <translation>{Ctrl+0}</translation>
    </message>
    <message>
        <source>{Ctrl+1}, {Ctrl+2}, {Ctrl+3}</source>
        <translation>{Ctrl+1}, {Ctrl+2}, {Ctrl+3}</translation>
    </message>
    <message>
        <source>{Ctrl+E}</source>
        <translation>{Ctrl+E}</translation>
    </message>
    <message>
        <source>{Ctrl+F} or /</source>
        <translation>{Ctrl+F} või /</translation>
    </message>
    <message>
        <source>{Ctrl+R}</source>
        <translation>{Ctrl+R}</translation>
    </message>
    <message>
        <source>{Ctrl+V}</source>
        <translation>{Ctrl+V}</translation>
    </message>
    <message>
        <source>{Ctrl+Z}</source>
        <translation>{Ctrl+Z}</translation>
    </message>
    <message>
        <source>{C}</source>
        <translation>{C}</translation>
    </message>
    <message>
        <source>{D}</source>
        <translation>{D}</translation>
    </message>
    <message>
        <source>{F4}</source>
        <translation>{F4}</translation>
    </message>
    <message>
        <source>{F5}</source>
        <translation>{F5}</translation>
    </message>
    <message>
        <source>{F6}</source>
        <translation>{F6}</translation>
    </message>
    <message>
        <source>{F7}</source>
        <translation>{F7}</translation>
    </message>
    <message>
        <source>{L}, held</source>
        <translation>{L}, all hoides</translation>
    </message>
    <message>
        <source>{N}</source>
        <translation>{N}</translation>
    </message>
    <message>
        <source>{Play}</source>
        <translation>{Play}</translation>
    </message>
    <message>
        <source>{P}</source>
        <translation>{P}</translation>
    </message>
    <message>
        <source>{Shift+F5}</source>
        <translation>{Shift+F5}</translation>
    </message>
    <message>
        <source>{Shift+F6}</source>
        <translation>{Shift+F6}</translation>
    </message>
    <message>
        <source>{V}</source>
        <translation>{V}</translation>
    </message>
    <message>
        <source>{W}</source>
        <translation>{W}</translation>
    </message>
    <message>
        <source>← →</source>
        <translation>← →</translation>
    </message>
</context>
<context>
    <name>Hiding</name>
    <message>
        <source>Hidden until the exercise is answered</source>
        <translation>Peidetud, kuni ülesanne on vastatud</translation>
    </message>
    <message>
        <source>Closed during a test</source>
        <translation>Testi ajal suletud</translation>
    </message>
</context>
<context>
    <name>Kind</name>
    <message>
        <source>1-point</source>
        <translation>1-punkti</translation>
    </message>
    <message>
        <source>2-point</source>
        <translation>2-punkti</translation>
    </message>
    <message>
        <source>3-point</source>
        <translation>3-punkti</translation>
    </message>
    <message>
        <source>all projectors are parallel</source>
        <translation>kõik projektsioonikiired on paralleelsed</translation>
    </message>
    <message>
        <source>all projectors meet in the eye</source>
        <translation>kõik projektsioonikiired lõikuvad silmas</translation>
    </message>
    <message>
        <source>all three axes make equal angles with the image plane</source>
        <translation>kõik kolm telge moodustavad pilditasandiga võrdse nurga</translation>
    </message>
    <message>
        <source>axonometric</source>
        <translation>aksonomeetriline</translation>
    </message>
    <message>
        <source>cabinet</source>
        <translation>cabinet</translation>
    </message>
    <message>
        <source>cavalier</source>
        <translation>cavalier</translation>
    </message>
    <message>
        <source>dimetric</source>
        <translation>dimeetriline</translation>
    </message>
    <message>
        <source>front</source>
        <translation>eestvaade</translation>
    </message>
    <message>
        <source>isometric</source>
        <translation>isomeetriline</translation>
    </message>
    <message>
        <source>multiview</source>
        <translation>ortogonaalne</translation>
    </message>
    <message>
        <source>no axis is parallel to the image plane: three vanishing points</source>
        <translation>ükski telg ei ole pilditasandiga paralleelne: kolm koondumispunkti</translation>
    </message>
    <message>
        <source>no two axes are parallel to the image plane</source>
        <translation>pilditasandiga on paralleelne kõige rohkem üks telg</translation>
    </message>
    <message>
        <source>oblique</source>
        <translation>kaldnurgaline</translation>
    </message>
    <message>
        <source>one axis is parallel to the image plane: two vanishing points</source>
        <translation>üks telg on pilditasandiga paralleelne: kaks koondumispunkti</translation>
    </message>
    <message>
        <source>orthographic</source>
        <translation>ortograafiline</translation>
    </message>
    <message>
        <source>parallel</source>
        <translation>paralleelne</translation>
    </message>
    <message>
        <source>perspective</source>
        <translation>perspektiivne</translation>
    </message>
    <message>
        <source>planar projections</source>
        <translation>planaarsed projektsioonid</translation>
    </message>
    <message>
        <source>projectors are at right angles to the image plane</source>
        <translation>projektsioonikiired on pilditasandiga risti</translation>
    </message>
    <message>
        <source>projectors are oblique to the image plane</source>
        <translation>projektsioonikiired on pilditasandi suhtes kaldu</translation>
    </message>
    <message>
        <source>projectors are straight lines, and meet a plane</source>
        <translation>projektsioonikiired on sirgjooned ja lõikavad tasandit</translation>
    </message>
    <message>
        <source>side</source>
        <translation>külgvaade</translation>
    </message>
    <message>
        <source>the axes make three different angles with the image plane</source>
        <translation>teljed moodustavad pilditasandiga kolm eri nurka</translation>
    </message>
    <message>
        <source>top</source>
        <translation>pealtvaade</translation>
    </message>
    <message>
        <source>trimetric</source>
        <translation>trimeetriline</translation>
    </message>
    <message>
        <source>two axes are parallel to the image plane</source>
        <translation>kaks telge on pilditasandiga paralleelsed</translation>
    </message>
    <message>
        <source>two axes are parallel to the image plane, the third is drawn at full length</source>
        <translation>kaks telge on pilditasandiga paralleelsed, kolmas joonistatakse täispikkuses</translation>
    </message>
    <message>
        <source>two axes are parallel to the image plane, the third is drawn at half its length</source>
        <translation>kaks telge on pilditasandiga paralleelsed, kolmas joonistatakse poole pikkusega</translation>
    </message>
    <message>
        <source>two axes are parallel to the image plane: one vanishing point</source>
        <translation>kaks telge on pilditasandiga paralleelsed: üks koondumispunkt</translation>
    </message>
    <message>
        <source>two axes make equal angles with the image plane</source>
        <translation>kaks telge moodustavad pilditasandiga võrdse nurga</translation>
    </message>
    <message>
        <source>x and y are parallel to the image plane, seen along −z</source>
        <translation>x ja y on pilditasandiga paralleelsed, vaade piki −z</translation>
    </message>
    <message>
        <source>x and z are parallel to the image plane, seen along −y</source>
        <translation>x ja z on pilditasandiga paralleelsed, vaade piki −y</translation>
    </message>
    <message>
        <source>y and z are parallel to the image plane, seen along −x</source>
        <translation>y ja z on pilditasandiga paralleelsed, vaade piki −x</translation>
    </message>
</context>
<context>
    <name>KindsPanel</name>
    <message>
        <source>Kinds of projection</source>
        <translation>Projektsioonide liigid</translation>
    </message>
    <message>
        <source>A free matrix belongs to no kind. Choose a kind, and its lens replaces the matrix.</source>
        <translation>Vaba maatriks ei kuulu ühtegi liiki. Valige liik ja selle objektiiv asendab maatriksi.</translation>
    </message>
    <message>
        <source>{0}: {1}.</source>
        <translation>{0}: {1}.</translation>
    </message>
    <message>
        <source>{0} Not possible here: {1}</source>
        <translation>{0} Siin ei ole võimalik: {1}</translation>
    </message>
    <message>
        <source>No scale factors: things farther away are drawn smaller.</source>
        <translation>Mastaabikordajaid ei ole: kaugemad asjad joonistatakse väiksemalt.</translation>
    </message>
    <message>
        <source>A unit would be drawn {0} long along x, {1} along y, {2} along z.</source>
        <translation>Ühiku joonistatud pikkus oleks x-sihis {0}, y-sihis {1}, z-sihis {2}.</translation>
    </message>
    <message>
        <source>A unit is drawn {0} long along x, {1} along y, {2} along z.</source>
        <translation>Ühiku joonistatud pikkus on x-sihis {0}, y-sihis {1}, z-sihis {2}.</translation>
    </message>
    <message>
        <source>{0} This scene: {1}.</source>
        <translation>{0} See stseen: {1}.</translation>
    </message>
</context>
<context>
    <name>Lens</name>
    <message>
        <source>None of these: the cells of clip ← view that you typed in the Matrices panel. If you choose another kind, the previous lens comes back.</source>
        <translation>Mitte ükski neist: maatriksi kärperuum ← vaade lahtrid, mille te paneelis Maatriksid sisestasite. Kui valite teise liigi, tuleb eelmine objektiiv tagasi.</translation>
    </message>
    <message>
        <source>Rays are parallel and meet the picture at a slant: a slanted box, as in cavalier and cabinet drawings (lecture 002: H, then orthographic).</source>
        <translation>Kiired on paralleelsed ja lõikavad pilti kaldu: rööptahukas, nagu cavalier- ja cabinet-joonistel (loeng 002: H, siis ortograafiline).</translation>
    </message>
    <message>
        <source>Rays are parallel and meet the picture at right angles: distance does not change size. The view volume is a box (glOrtho).</source>
        <translation>Kiired on paralleelsed ja lõikavad pilti risti: kaugus ei muuda suurust. Nähtav ruum on risttahukas (glOrtho).</translation>
    </message>
    <message>
        <source>Rays meet in the eye, but the window may be anywhere on the near plane: a shifted pyramid (glFrustum).</source>
        <translation>Kiired lõikuvad silmas, aga aken võib olla lähitasandil ükskõik kus: nihutatud püramiid (glFrustum).</translation>
    </message>
    <message>
        <source>Rays meet in the eye: farther objects look smaller. The view volume is a pyramid cut off by near and far, symmetric about the view direction (gluPerspective).</source>
        <translation>Kiired lõikuvad silmas: kaugemad objektid paistavad väiksemad. Nähtav ruum on lähi- ja kaugtasandiga pügatud püramiid, vaate suuna suhtes sümmeetriline (gluPerspective).</translation>
    </message>
    <message>
        <source>free matrix</source>
        <translation>vaba maatriks</translation>
    </message>
    <message>
        <source>frustum (off-axis)</source>
        <translation>frustum (teljeväline)</translation>
    </message>
    <message>
        <source>oblique</source>
        <translation>kaldnurgaline</translation>
    </message>
    <message>
        <source>orthographic</source>
        <translation>ortograafiline</translation>
    </message>
    <message>
        <source>perspective</source>
        <translation>perspektiivne</translation>
    </message>
</context>
<context>
    <name>LessonCard</name>
    <message>
        <source>Lesson</source>
        <translation>Õppetund</translation>
    </message>
    <message>
        <source>Begin again: forget the answers of this lesson</source>
        <translation>Alusta uuesti: unusta selle õppetunni vastused</translation>
    </message>
    <message>
        <source>Close the lesson</source>
        <translation>Sulge õppetund</translation>
    </message>
    <message>
        <source>Previous step ({0})</source>
        <translation>Eelmine samm ({0})</translation>
    </message>
    <message>
        <source>Show the step as the lesson&apos;s file has it, without your changes ({0})</source>
        <translation>Näita sammu nii, nagu see on õppetunni failis, ilma muudatusteta ({0})</translation>
    </message>
    <message>
        <source>Show the next hint (Alt+I)</source>
        <translation>Näita järgmist vihjet (Alt+I)</translation>
    </message>
    <message>
        <source>Next step ({0})</source>
        <translation>Järgmine samm ({0})</translation>
    </message>
    <message>
        <source>&amp;Back</source>
        <translation>&amp;Tagasi</translation>
    </message>
    <message>
        <source>Show again</source>
        <translation>Näita uuesti</translation>
    </message>
    <message>
        <source>Show the step again</source>
        <translation>Näita sammu uuesti</translation>
    </message>
    <message>
        <source>H&amp;int</source>
        <translation>V&amp;ihje</translation>
    </message>
    <message>
        <source>&amp;Next</source>
        <translation>&amp;Edasi</translation>
    </message>
    <message>
        <source>Do&amp;ne</source>
        <translation>Va&amp;lmis</translation>
    </message>
    <message>
        <source>Make your prediction first: choose one, then Commit.</source>
        <translation>Tehke enne ennustus: valige üks ja siis Kinnita.</translation>
    </message>
    <message>
        <source>Nothing is wrong in this lesson&apos;s file.</source>
        <translation>Selle õppetunni failis ei ole ühtki viga.</translation>
    </message>
    <message>
        <source>Done: “{0}”.</source>
        <translation>Valmis: „{0}“.</translation>
    </message>
    <message>
        <source>Something is left to do in step {0}.</source>
        <translation>Midagi on tegemata sammus {0}.</translation>
    </message>
    <message>
        <source>Something is left to do in steps {0}.</source>
        <translation>Midagi on tegemata sammudes {0}.</translation>
    </message>
    <message>
        <source>Next lesson: {0}</source>
        <translation>Järgmine õppetund: {0}</translation>
    </message>
    <message>
        <source>Open it</source>
        <translation>Ava see</translation>
    </message>
    <message>
        <source>&amp;Close</source>
        <translation>Sul&amp;ge</translation>
    </message>
    <message>
        <source>Back to step {0}</source>
        <translation>Tagasi sammu {0} juurde</translation>
    </message>
    <message>
        <source>Go on there</source>
        <translation>Jätka sealt</translation>
    </message>
    <message>
        <source>Not answered yet: {0}.</source>
        <translation>Vastamata: {0}.</translation>
    </message>
    <message>
        <source>Back to exercise {0}</source>
        <translation>Tagasi ülesande {0} juurde</translation>
    </message>
    <message>
        <source>&amp;Mark the test now</source>
        <translation>&amp;Hinda testi nüüd</translation>
    </message>
    <message>
        <source>End the test</source>
        <translation>Lõpeta test</translation>
    </message>
    <message>
        <source>Save the &amp;result…</source>
        <translation>Salvesta tu&amp;lemus…</translation>
    </message>
    <message>
        <source>Write a file for your teacher</source>
        <translation>Kirjutab faili teie õpetaja jaoks</translation>
    </message>
    <message>
        <source>Close the test</source>
        <translation>Sulge test</translation>
    </message>
</context>
<context>
    <name>LessonMenu</name>
    <message>
        <source>done</source>
        <translation>valmis</translation>
    </message>
    <message>
        <source>Open a lesson or a talk</source>
        <translation>Õppetunni või ettekande avamine</translation>
    </message>
    <message>
        <source>Lessons and talks (*.md);;All files (*)</source>
        <translation>Õppetunnid ja ettekanded (*.md);;Kõik failid (*)</translation>
    </message>
</context>
<context>
    <name>Lessons</name>
    <message>
        <source>Checking {0}</source>
        <translation>Kontrollitakse: {0}</translation>
    </message>
    <message>
        <source>… and {0} more</source>
        <translation>… ja veel {0}</translation>
    </message>
</context>
<context>
    <name>Look</name>
    <message>
        <source>up</source>
        <translation>üles</translation>
    </message>
    <message>
        <source>eye</source>
        <translation>silm</translation>
    </message>
    <message>
        <source>target</source>
        <translation>siht</translation>
    </message>
    <message>
        <source>A parallel lens has no angle: it is equally wide at every distance.</source>
        <translation>Paralleelsel objektiivil ei ole nurka: see on igal kaugusel ühelaiune.</translation>
    </message>
    <message>
        <source>A parallel lens has no eye: this is the view along its axis.</source>
        <translation>Paralleelsel objektiivil ei ole silma: see on vaade piki selle telge.</translation>
    </message>
    <message>
        <source>A free matrix has no near, no far and no angle.</source>
        <translation>Vabal maatriksil ei ole lähitasandit, kaugtasandit ega nurka.</translation>
    </message>
    <message>
        <source>This window is off-axis: the axis does not halve its angle.</source>
        <translation>See aken on teljeväline: telg ei poolita selle nurka.</translation>
    </message>
    <message>
        <source>half height</source>
        <translation>pool kõrgust</translation>
    </message>
    <message>
        <source>half width</source>
        <translation>pool laiust</translation>
    </message>
    <message>
        <source>look</source>
        <translation>vaate suund</translation>
    </message>
</context>
<context>
    <name>MainWindow</name>
    <message>
        <source>World</source>
        <translation>Maailm</translation>
    </message>
    <message>
        <source>NDC cube</source>
        <translation>NDC kuup</translation>
    </message>
    <message>
        <source>Image</source>
        <translation>Pilt</translation>
    </message>
    <message>
        <source>The default settings are used.</source>
        <translation>Kasutatakse vaikesätteid.</translation>
    </message>
    <message>
        <source>Matrices</source>
        <translation>Maatriksid</translation>
    </message>
    <message>
        <source>Every stage&apos;s matrix: numbers, formulas, factors and products</source>
        <translation>Iga etapi maatriks: arvud, valemid, tegurid ja korrutised</translation>
    </message>
    <message>
        <source>Camera frame</source>
        <translation>Kaamerafreim</translation>
    </message>
    <message>
        <source>The camera&apos;s axes, step by step: eye, target and up make the view matrix</source>
        <translation>Kaamera teljed samm-sammult: silmast, sihtpunktist ja ülesvektorist saab vaatemaatriks</translation>
    </message>
    <message>
        <source>Kinds of projection</source>
        <translation>Projektsioonide liigid</translation>
    </message>
    <message>
        <source>The tree of planar projections: it marks the kind of the picture; click a kind to change to it</source>
        <translation>Planaarsete projektsioonide puu: see märgib pildi liigi; liigil klõpsates lähete selle juurde</translation>
    </message>
    <message>
        <source>Probe</source>
        <translation>Sond</translation>
    </message>
    <message>
        <source>Follow points through every stage</source>
        <translation>Jälgib punkte läbi kõigi etappide</translation>
    </message>
    <message>
        <source>Explanation and diagrams</source>
        <translation>Selgitus ja diagrammid</translation>
    </message>
    <message>
        <source>What the scene shows, the lectures that use it, and its diagrams</source>
        <translation>Mida stseen näitab, millised loengud seda kasutavad ja selle diagrammid</translation>
    </message>
    <message>
        <source>Precision</source>
        <translation>Täpsus</translation>
    </message>
    <message>
        <source>How exact the picture and its numbers are, and what speed costs on this computer</source>
        <translation>Kui täpsed on pilt ja selle arvud ning mida kiirus selles arvutis maksab</translation>
    </message>
    <message>
        <source>The answers in “{0}” were deleted.</source>
        <translation>Vastused on kustutatud: „{0}“.</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Võta tagasi</translation>
    </message>
    <message>
        <source>{0} Settings and progress are kept until the program ends, and saving them is tried again with the next change.</source>
        <translation>{0} Sätted ja edenemine on alles programmi lõpuni ning neid proovitakse järgmise muudatuse järel uuesti salvestada.</translation>
    </message>
    <message>
        <source>{0} cannot be drawn, so the previous scene stays: {1}</source>
        <translation>Stseeni {0} ei saa joonistada, seepärast jääb eelmine stseen: {1}</translation>
    </message>
    <message>
        <source>One file is opened at a time: {0}</source>
        <translation>Korraga avatakse üks fail: {0}</translation>
    </message>
</context>
<context>
    <name>Manipulation</name>
    <message>
        <source>Drag along its way</source>
        <translation>Lohistage mööda selle teed</translation>
    </message>
    <message>
        <source>Drag this point (Shift: up and down)</source>
        <translation>Lohistage seda punkti (Shift: üles ja alla)</translation>
    </message>
</context>
<context>
    <name>MarkedAnswerView</name>
    <message>
        <source>So far so good, but three significant digits are needed.</source>
        <translation>Seni on õige, aga vaja on kolme tüvenumbrit.</translation>
    </message>
    <message>
        <source>Too few digits</source>
        <translation>Liiga vähe numbrikohti</translation>
    </message>
    <message>
        <source>That is not it.</source>
        <translation>See ei ole õige.</translation>
    </message>
    <message>
        <source>The hint (Alt+I) says how to begin.</source>
        <translation>Vihje (Alt+I) ütleb, kuidas alustada.</translation>
    </message>
    <message>
        <source>Wrong</source>
        <translation>Vale</translation>
    </message>
    <message>
        <source>The answer is {0}.</source>
        <translation>Vastus on {0}.</translation>
    </message>
    <message>
        <source>The answer is:</source>
        <translation>Vastus on:</translation>
    </message>
</context>
<context>
    <name>Matrix</name>
    <message>
        <source>eye ({0}), looks along ({1})</source>
        <translation>silm ({0}), vaatab suunas ({1})</translation>
    </message>
    <message>
        <source>its lens is used, looking along −z; change the sign of its view matrix in row {0}</source>
        <translation>kasutatakse selle objektiivi, vaatega −z suunas; muutke vaatemaatriksis märki reas {0}</translation>
    </message>
    <message>
        <source>its lens is used, with y up</source>
        <translation>kasutatakse selle objektiivi, y suunaga üles</translation>
    </message>
    <message>
        <source>affine: w is {0} everywhere</source>
        <translation>afiinne: w on kõikjal {0}</translation>
    </message>
    <message>
        <source>not affine: w depends on {0}</source>
        <translation>mitteafiinne: w sõltub suurustest {0}</translation>
    </message>
    <message>
        <source>singular (rank {0}): the frustum cannot be drawn</source>
        <translation>singulaarne (astak {0}): frustumit ei saa joonistada</translation>
    </message>
    <message>
        <source>mirrored: it turns right-handed space into left-handed (determinant {0})</source>
        <translation>peegeldav: see muudab paremakäelise ruumi vasakukäeliseks (determinant {0})</translation>
    </message>
    <message>
        <source>mirrored: as if left and right, top and bottom, or near and far were exchanged</source>
        <translation>peegeldav: nagu oleks vahetatud vasak ja parem, ülemine ja alumine või lähi- ja kaugtasand</translation>
    </message>
    <message>
        <source>not rigid: it changes lengths or angles, so that no camera has it</source>
        <translation>ei ole jäik: see muudab pikkusi või nurki, nii et ühelgi kaameral seda ei ole</translation>
    </message>
    <message>
        <source>w vanishes where {0} = 0: the divide sends these points to infinity</source>
        <translation>w muutub nulliks, kus {0} = 0: jagamine saadab need punktid lõpmatusse</translation>
    </message>
    <message>
        <source>w is {0} everywhere: there is no picture</source>
        <translation>w on kõikjal {0}: pilti ei ole</translation>
    </message>
    <message>
        <source>w is negative all over the view volume: there is no picture</source>
        <translation>w on kogu nähtavas ruumis negatiivne: pilti ei ole</translation>
    </message>
    <message>
        <source>the view volume reaches infinity: the frustum cannot be drawn</source>
        <translation>nähtav ruum ulatub lõpmatusse: frustumit ei saa joonistada</translation>
    </message>
    <message>
        <source>rows are orthonormal to {0}: rounded to float32</source>
        <translation>read on ortonormeeritud täpsusega {0}: ümardatud float32-ks</translation>
    </message>
    <message>
        <source>rows are orthonormal to {0}: rounded to {1} digits</source>
        <translation>read on ortonormeeritud täpsusega {0}: numbrikohti pärast ümardamist {1}</translation>
    </message>
    <message>
        <source>the nearest camera is used; it moves the picture by at most {0} px</source>
        <translation>kasutatakse lähimat kaamerat; see nihutab pilti ülimalt {0} px</translation>
    </message>
    <message>
        <source>the nearest camera would move the picture by at most {0} px</source>
        <translation>lähim kaamera nihutaks pilti ülimalt {0} px</translation>
    </message>
    <message>
        <source>rows and columns are exchanged: its transpose is meant</source>
        <translation>read ja veerud on vahetuses: mõeldud on transponeeritud maatriksit</translation>
    </message>
    <message>
        <source>looks along −z, y up; z from {0} at near to {1} at far; {2}, near {3}, far {4}</source>
        <translation>vaatab suunas −z, y üles; z muutub arvust {0} lähitasandil arvuni {1} kaugtasandil; {2}, lähitasand {3}, kaugtasand {4}</translation>
    </message>
    <message>
        <source>left-handed: looks along +z, y up; z from {0} at near to {1} at far; {2}, near {3}, far {4}</source>
        <translation>vasakukäeline: vaatab suunas +z, y üles; z muutub arvust {0} lähitasandil arvuni {1} kaugtasandil; {2}, lähitasand {3}, kaugtasand {4}</translation>
    </message>
    <message>
        <source>looks along −z, the picture&apos;s y down; z from {0} at near to {1} at far; {2}, near {3}, far {4}</source>
        <translation>vaatab suunas −z, pildi y alla; z muutub arvust {0} lähitasandil arvuni {1} kaugtasandil; {2}, lähitasand {3}, kaugtasand {4}</translation>
    </message>
    <message>
        <source>looks along +z, y down; z from {0} at near to {1} at far; {2}, near {3}, far {4}</source>
        <translation>vaatab suunas +z, y alla; z muutub arvust {0} lähitasandil arvuni {1} kaugtasandil; {2}, lähitasand {3}, kaugtasand {4}</translation>
    </message>
</context>
<context>
    <name>MatrixAnswerView</name>
    <message>
        <source>A number: 0.5, 1 1/2, √3/2 or 2e-3; arrow keys change the cell (Enter)</source>
        <translation>Arv: 0.5; 1 1/2; √3/2 või 2e-3; nooleklahvid vahetavad lahtrit (Enter)</translation>
    </message>
</context>
<context>
    <name>MatrixBox</name>
    <message>
        <source>Show the factors of this matrix</source>
        <translation>Näitab selle maatriksi tegureid</translation>
    </message>
    <message>
        <source>Factors of {0}</source>
        <translation>{0}: tegurid</translation>
    </message>
    <message>
        <source>the stage strip is here</source>
        <translation>etapiriba on siin</translation>
    </message>
</context>
<context>
    <name>MatrixPanel</name>
    <message>
        <source>then x, y and z are divided by w</source>
        <translation>siis jagatakse x, y ja z arvuga w</translation>
    </message>
    <message>
        <source>with lecture 002&apos;s sign: w = z</source>
        <translation>loengu 002 märgiga: w = z</translation>
    </message>
    <message>
        <source>with lecture 002&apos;s sign: z runs from 1 at near to −1</source>
        <translation>loengu 002 märgiga: z muutub lähitasandi 1-st kuni −1-ni</translation>
    </message>
    <message>
        <source>with lecture 002&apos;s signs: w = z, and z runs from 1 at near to −1</source>
        <translation>loengu 002 märkidega: w = z ja z muutub lähitasandi 1-st kuni −1-ni</translation>
    </message>
    <message>
        <source>Matrices</source>
        <translation>Maatriksid</translation>
    </message>
    <message>
        <source>Cells</source>
        <translation>Lahtrid</translation>
    </message>
    <message>
        <source>What each cell shows</source>
        <translation>Mida iga lahter näitab</translation>
    </message>
    <message>
        <source>Numbers</source>
        <translation>Arvud</translation>
    </message>
    <message>
        <source>Formulas</source>
        <translation>Valemid</translation>
    </message>
    <message>
        <source>Vectors</source>
        <translation>Vektorid</translation>
    </message>
    <message>
        <source>Points as columns, right of the matrix, or as rows, left of it; rows transpose every matrix and reverse every product</source>
        <translation>Punktid veergudena maatriksist paremal või ridadena sellest vasakul; read transponeerivad iga maatriksi ja pööravad iga korrutise järjekorra ümber</translation>
    </message>
    <message>
        <source>Column vectors</source>
        <translation>Veeruvektorid</translation>
    </message>
    <message>
        <source>Row vectors</source>
        <translation>Reavektorid</translation>
    </message>
    <message>
        <source>Letters</source>
        <translation>Tähed</translation>
    </message>
    <message>
        <source>The lecture whose letters the formulas use; vectors are bold; lecture 002 has its own signs too</source>
        <translation>Loeng, mille tähti valemites kasutatakse; vektorid on poolpaksud; loengul 002 on ka omad märgid</translation>
    </message>
    <message>
        <source>own: u v n, n f, fov</source>
        <translation>omad: u v n, n f, fov</translation>
    </message>
    <message>
        <source>xₘᵢₙ … zₘₐₓ</source>
        <translation>xₘᵢₙ … zₘₐₓ</translation>
    </message>
    <message>
        <source>u v w, θ</source>
        <translation>u v w, θ</translation>
    </message>
    <message>
        <source>z of near, far: negative</source>
        <translation>lähi- ja kaugtasandi z: negatiivne</translation>
    </message>
    <message>
        <source>e, n f</source>
        <translation>e, n f</translation>
    </message>
    <message>
        <source>x₀ y₀ z₀, V</source>
        <translation>x₀ y₀ z₀, V</translation>
    </message>
    <message>
        <source>Those of lecture {0}</source>
        <translation>Loengu {0} tähed</translation>
    </message>
    <message>
        <source>Take letters of your own from a file, letters.toml</source>
        <translation>Võtab teie oma tähed failist letters.toml</translation>
    </message>
    <message>
        <source>Letters of a file</source>
        <translation>Faili tähed</translation>
    </message>
    <message>
        <source>Running products</source>
        <translation>Osakorrutised</translation>
    </message>
    <message>
        <source>Also the product of all stages so far, and the view matrix&apos;s inverse, whose columns are the camera&apos;s axes and the eye</source>
        <translation>Ka kõigi seniste etappide korrutis ja vaatemaatriksi pöördmaatriks, mille veerud on kaamera teljed ja silm</translation>
    </message>
    <message>
        <source>Copy all</source>
        <translation>Kopeeri kõik</translation>
    </message>
    <message>
        <source>Copy every matrix shown, in the order of the stages</source>
        <translation>Kopeerib kõik näidatavad maatriksid etappide järjekorras</translation>
    </message>
    <message>
        <source>Copy all matrices</source>
        <translation>Kopeeri kõik maatriksid</translation>
    </message>
    <message>
        <source>About the cell</source>
        <translation>Lahtrist</translation>
    </message>
    <message>
        <source>of a file</source>
        <translation>failist</translation>
    </message>
    <message>
        <source>Letters (*.toml);;All files (*)</source>
        <translation>Tähed (*.toml);;Kõik failid (*)</translation>
    </message>
    <message>
        <source>{0}, row {1}, column {2}</source>
        <translation>{0}, rida {1}, veerg {2}</translation>
    </message>
    <message>
        <source>{0} is taken as {1}, its quotient to all digits of float64.</source>
        <translation>{0} loetakse arvuks {1}, jagatis on kõigi float64 numbrikohtadega.</translation>
    </message>
    <message>
        <source>This matrix may mean:</source>
        <translation>See maatriks võib tähendada:</translation>
    </message>
    <message>
        <source>{0}, a free matrix</source>
        <translation>{0}, vaba maatriks</translation>
    </message>
</context>
<context>
    <name>MatrixRow</name>
    <message>
        <source>Matrices</source>
        <translation>Maatriksid</translation>
    </message>
    <message>
        <source>More matrices: show the next one that is cut off or hidden</source>
        <translation>Veel maatrikseid: näitab järgmist, mis on osaliselt või täiesti peidus</translation>
    </message>
    <message>
        <source>Matrices to the left</source>
        <translation>Vasakpoolsed maatriksid</translation>
    </message>
    <message>
        <source>Matrices to the right</source>
        <translation>Parempoolsed maatriksid</translation>
    </message>
</context>
<context>
    <name>MatrixView</name>
    <message>
        <source>{0}, row {1}, column {2}</source>
        <translation>{0}, rida {1}, veerg {2}</translation>
    </message>
    <message>
        <source>A number, or a fraction such as 1/3, which is divided to all digits</source>
        <translation>Arv või murd, näiteks 1/3, mis jagatakse välja kõigi numbrikohtadega</translation>
    </message>
    <message>
        <source>Paste</source>
        <translation>Aseta</translation>
    </message>
    <message>
        <source>Copy as text</source>
        <translation>Kopeeri tekstina</translation>
    </message>
    <message>
        <source>Copy for NumPy (numbers)</source>
        <translation>Kopeeri NumPy jaoks (arvud)</translation>
    </message>
    <message>
        <source>Copy for LaTeX (needs amsmath)</source>
        <translation>Kopeeri LaTeXi jaoks (vajab paketti amsmath)</translation>
    </message>
</context>
<context>
    <name>Measure</name>
    <message>
        <source>180 − vertical fov, degrees</source>
        <translation>180 − vertikaalne FOV, kraadides</translation>
    </message>
    <message>
        <source>A logarithmic depth only at the vertices: the floor sinks behind the wall.</source>
        <translation>Logaritmiline sügavus ainult tippudes: põrand vajub seina taha.</translation>
    </message>
    <message>
        <source>A turn made of many small turns: a full round does not come home.</source>
        <translation>Paljudest väikestest pööretest koosnev pööre: täisring ei lõpe lähtekohas.</translation>
    </message>
    <message>
        <source>Antialiasing and resolution</source>
        <translation>Silumine ja lahutus</translation>
    </message>
    <message>
        <source>Arithmetic</source>
        <translation>Aritmeetika</translation>
    </message>
    <message>
        <source>At the target, {0} with {2} separates surfaces at least {1} world units apart; the finest, {3} with {4}, surfaces at least {5} apart.</source>
        <translation>Sihtpunkti kaugusel eristab {0} puhvriga {2} pindu, mille vahe on vähemalt {1} maailma ühikut; peenim, {3} puhvriga {4}, pindu vahega vähemalt {5}.</translation>
    </message>
    <message>
        <source>Back from the picture</source>
        <translation>Pildilt tagasi</translation>
    </message>
    <message>
        <source>Cracks</source>
        <translation>Praod</translation>
    </message>
    <message>
        <source>Depth at the vertices</source>
        <translation>Sügavus tippudes</translation>
    </message>
    <message>
        <source>Depth buffer</source>
        <translation>Sügavuspuhver</translation>
    </message>
    <message>
        <source>Depth gap over the distance</source>
        <translation>Sügavuse vahe kauguse järgi</translation>
    </message>
    <message>
        <source>Detail</source>
        <translation>Detailsus</translation>
    </message>
    <message>
        <source>Drift</source>
        <translation>Triiv</translation>
    </message>
    <message>
        <source>Each mesh rounded in a box of its own: light comes through the seam.</source>
        <translation>Kumbki võrk on ümardatud omaenda risttahukas: valgus paistab õmblusest läbi.</translation>
    </message>
    <message>
        <source>Equal in bytes to {0}: {1}.</source>
        <translation>Baitides sama mis {0}: {1}.</translation>
    </message>
    <message>
        <source>Equal in time to {0}: {1}.</source>
        <translation>Ajas sama mis {0}: {1}.</translation>
    </message>
    <message>
        <source>Fewer bits of depth: what lies behind comes through in stripes.</source>
        <translation>Vähem sügavuse bitte: taga olev paistab triipudena läbi.</translation>
    </message>
    <message>
        <source>Fewer digits for each vertex: the corners move.</source>
        <translation>Vähem numbrikohti iga tipu jaoks: nurgad nihkuvad.</translation>
    </message>
    <message>
        <source>Fewer samples in a pixel: edges become stairs.</source>
        <translation>Vähem valimeid pikslis: servad muutuvad treppideks.</translation>
    </message>
    <message>
        <source>Fewer triangles: outlines become angular.</source>
        <translation>Vähem kolmnurki: kontuurid muutuvad nurgeliseks.</translation>
    </message>
    <message>
        <source>From a pixel back into the world by one matrix: the point misses.</source>
        <translation>Pikslist ühe maatriksiga maailma tagasi: punktist minnakse mööda.</translation>
    </message>
    <message>
        <source>Interpolation</source>
        <translation>Interpoleerimine</translation>
    </message>
    <message>
        <source>Its price is in {0}: {1}, against {2} for {3}.</source>
        <translation>Hind on {0}: {1}, võrdluseks {2} ({3}).</translation>
    </message>
    <message>
        <source>Jitter</source>
        <translation>Värin</translation>
    </message>
    <message>
        <source>No choice is cheaper ({1}) or more exact ({2}) than {0}.</source>
        <translation>Ükski valik ei ole odavam ({1}) ega täpsem ({2}) kui {0}.</translation>
    </message>
    <message>
        <source>No choice is cheaper than {0} ({1}, off by {2}), none more exact than {3} ({4}, off by {5}); none is off by less than {6}.</source>
        <translation>Ükski valik ei ole odavam kui {0} ({1}, viga {2}), ükski täpsem kui {3} ({4}, viga {5}); ühelgi ei ole viga väiksem kui {6}.</translation>
    </message>
    <message>
        <source>No choice is cheaper than {0} ({1}, off by {2}), none more exact than {3} ({4}, off by {5}); of those off by less than {6}, none is cheaper than {7}.</source>
        <translation>Ükski valik ei ole odavam kui {0} ({1}, viga {2}), ükski täpsem kui {3} ({4}, viga {5}); nendest, mille viga on väiksem kui {6}, ei ole ükski odavam kui {7}.</translation>
    </message>
    <message>
        <source>No division at each pixel: the pattern bends along the diagonal.</source>
        <translation>Pikslites ei jagata: muster murdub diagonaalil.</translation>
    </message>
    <message>
        <source>Not certain: {0}.</source>
        <translation>Ei ole kindel: {0}.</translation>
    </message>
    <message>
        <source>Nothing could be measured: {0}.</source>
        <translation>Midagi ei saanud mõõta: {0}.</translation>
    </message>
    <message>
        <source>Sweep of far</source>
        <translation>Kaugtasandi mõõterida</translation>
    </message>
    <message>
        <source>Sweep of near</source>
        <translation>Lähitasandi mõõterida</translation>
    </message>
    <message>
        <source>Sweep of the aspect</source>
        <translation>Kuvasuhte mõõterida</translation>
    </message>
    <message>
        <source>Sweep of the distance from the origin</source>
        <translation>Alguspunkti kauguse mõõterida</translation>
    </message>
    <message>
        <source>Sweep of the field of view</source>
        <translation>Frustumi nurga mõõterida</translation>
    </message>
    <message>
        <source>Sweep of up</source>
        <translation>Ülesvektori mõõterida</translation>
    </message>
    <message>
        <source>VTK&apos;s transform</source>
        <translation>VTK teisendus</translation>
    </message>
    <message>
        <source>World coordinates in float32, far from the origin: the picture jumps.</source>
        <translation>Maailma koordinaadid float32-s, alguspunktist kaugel: pilt hüppab.</translation>
    </message>
    <message>
        <source>a sphere: the scene has too few triangles</source>
        <translation>kera: stseenis on liiga vähe kolmnurki</translation>
    </message>
    <message>
        <source>affine</source>
        <translation>afiinne</translation>
    </message>
    <message>
        <source>angle between up and view direction, degrees</source>
        <translation>nurk ülesvektori ja vaate suuna vahel, kraadides</translation>
    </message>
    <message>
        <source>aspect</source>
        <translation>kuvasuhe</translation>
    </message>
    <message>
        <source>aspect of the window</source>
        <translation>akna kuvasuhe</translation>
    </message>
    <message>
        <source>at most {0} off</source>
        <translation>viga ülimalt {0}</translation>
    </message>
    <message>
        <source>bytes</source>
        <translation>baiti</translation>
    </message>
    <message>
        <source>bytes a camera</source>
        <translation>baiti kaamera kohta</translation>
    </message>
    <message>
        <source>bytes a pixel</source>
        <translation>baiti piksli kohta</translation>
    </message>
    <message>
        <source>bytes a point</source>
        <translation>baiti punkti kohta</translation>
    </message>
    <message>
        <source>bytes a vertex</source>
        <translation>baiti tipu kohta</translation>
    </message>
    <message>
        <source>bytes an edge</source>
        <translation>baiti serva kohta</translation>
    </message>
    <message>
        <source>bytes of the mesh</source>
        <translation>võrgu baidid</translation>
    </message>
    <message>
        <source>cancelled</source>
        <translation>katkestatud</translation>
    </message>
    <message>
        <source>common grid</source>
        <translation>ühine ruudustik</translation>
    </message>
    <message>
        <source>depth error (of 1)</source>
        <translation>sügavuse viga (1-st)</translation>
    </message>
    <message>
        <source>direct3d</source>
        <translation>direct3d</translation>
    </message>
    <message>
        <source>distance</source>
        <translation>kaugus</translation>
    </message>
    <message>
        <source>distance from the eye plane</source>
        <translation>kaugus silmatasandist</translation>
    </message>
    <message>
        <source>distance from the origin</source>
        <translation>kaugus alguspunktist</translation>
    </message>
    <message>
        <source>each pixel</source>
        <translation>iga piksel</translation>
    </message>
    <message>
        <source>each vertex</source>
        <translation>iga tipp</translation>
    </message>
    <message>
        <source>error after 360°, px</source>
        <translation>viga pärast 360°, px</translation>
    </message>
    <message>
        <source>error of a jump, px</source>
        <translation>hüppe viga, px</translation>
    </message>
    <message>
        <source>error, levels of 255</source>
        <translation>viga, tasemeid 255-st</translation>
    </message>
    <message>
        <source>error, parts of the distance</source>
        <translation>viga, osa kaugusest</translation>
    </message>
    <message>
        <source>error, parts of the distance w</source>
        <translation>viga, osa kaugusest w</translation>
    </message>
    <message>
        <source>error, px</source>
        <translation>viga, px</translation>
    </message>
    <message>
        <source>error, texels</source>
        <translation>viga, tekslid</translation>
    </message>
    <message>
        <source>every stage</source>
        <translation>iga etapp</translation>
    </message>
    <message>
        <source>exact</source>
        <translation>täpne</translation>
    </message>
    <message>
        <source>eye 1 000 from the origin</source>
        <translation>silm 1 000 ühikut alguspunktist</translation>
    </message>
    <message>
        <source>eye 1 from the origin</source>
        <translation>silm 1 ühik alguspunktist</translation>
    </message>
    <message>
        <source>eye first</source>
        <translation>silm enne</translation>
    </message>
    <message>
        <source>far</source>
        <translation>kaugtasand</translation>
    </message>
    <message>
        <source>far is at least 4 near</source>
        <translation>kaugtasand on vähemalt 4 lähitasandit</translation>
    </message>
    <message>
        <source>fast inverse root</source>
        <translation>kiirmeetodil leitud pöördruutjuur</translation>
    </message>
    <message>
        <source>first frame (ms)</source>
        <translation>esimene kaader (ms)</translation>
    </message>
    <message>
        <source>fov</source>
        <translation>FOV</translation>
    </message>
    <message>
        <source>gap, px</source>
        <translation>pilu, px</translation>
    </message>
    <message>
        <source>gap, world units</source>
        <translation>vahe, maailma ühikutes</translation>
    </message>
    <message>
        <source>half resolution</source>
        <translation>pool lahutust</translation>
    </message>
    <message>
        <source>imitated in software: its time says nothing</source>
        <translation>tarkvaras jäljendatud: aeg ei ütle midagi</translation>
    </message>
    <message>
        <source>inverse of P V</source>
        <translation>P V pöördmaatriks</translation>
    </message>
    <message>
        <source>inverses of P and of V</source>
        <translation>P ja V pöördmaatriksid</translation>
    </message>
    <message>
        <source>largest error, px</source>
        <translation>suurim viga, px</translation>
    </message>
    <message>
        <source>levels RMS</source>
        <translation>taset, RMS</translation>
    </message>
    <message>
        <source>logarithmic</source>
        <translation>logaritmiline</translation>
    </message>
    <message>
        <source>matplotlib&apos;s proj3d</source>
        <translation>matplotlibi proj3d</translation>
    </message>
    <message>
        <source>ms a frame</source>
        <translation>ms kaadri kohta</translation>
    </message>
    <message>
        <source>near</source>
        <translation>lähitasand</translation>
    </message>
    <message>
        <source>near is at most far / 4</source>
        <translation>lähitasand on ülimalt kaugtasand / 4</translation>
    </message>
    <message>
        <source>no edge of the scene&apos;s box is in the picture</source>
        <translation>pildil ei ole ühtki stseeni risttahuka serva</translation>
    </message>
    <message>
        <source>no outline of the scene is in the picture</source>
        <translation>pildil ei ole ühtki stseeni kontuuri</translation>
    </message>
    <message>
        <source>no vertex is in front of the eye, so there is nothing to measure</source>
        <translation>ükski tipp ei ole silma ees, nii et midagi ei ole mõõta</translation>
    </message>
    <message>
        <source>none</source>
        <translation>pole</translation>
    </message>
    <message>
        <source>not installed</source>
        <translation>paigaldamata</translation>
    </message>
    <message>
        <source>ns a frame</source>
        <translation>ns kaadri kohta</translation>
    </message>
    <message>
        <source>ns a pixel</source>
        <translation>ns piksli kohta</translation>
    </message>
    <message>
        <source>ns a point</source>
        <translation>ns punkti kohta</translation>
    </message>
    <message>
        <source>numpy&apos;s hstack</source>
        <translation>numpy hstack</translation>
    </message>
    <message>
        <source>object first</source>
        <translation>objekt enne</translation>
    </message>
    <message>
        <source>of the distance</source>
        <translation>kaugusest</translation>
    </message>
    <message>
        <source>opengl</source>
        <translation>opengl</translation>
    </message>
    <message>
        <source>overflows</source>
        <translation>täitub üle</translation>
    </message>
    <message>
        <source>own boxes</source>
        <translation>oma risttahukad</translation>
    </message>
    <message>
        <source>p95</source>
        <translation>p95</translation>
    </message>
    <message>
        <source>pairs collapsed (of 1)</source>
        <translation>kokku langevaid paare (1-st)</translation>
    </message>
    <message>
        <source>perspective-correct</source>
        <translation>perspektiivselt korrektne</translation>
    </message>
    <message>
        <source>predicted</source>
        <translation>ennustatud</translation>
    </message>
    <message>
        <source>predicted depth error (of 1)</source>
        <translation>ennustatud sügavuse viga (1-st)</translation>
    </message>
    <message>
        <source>predicted to collapse (of 1)</source>
        <translation>ennustatult kokku langevaid (1-st)</translation>
    </message>
    <message>
        <source>products</source>
        <translation>korrutised</translation>
    </message>
    <message>
        <source>ray times depth</source>
        <translation>kiir korda sügavus</translation>
    </message>
    <message>
        <source>reciprocal table</source>
        <translation>pöördarvude tabel</translation>
    </message>
    <message>
        <source>reducing (ms)</source>
        <translation>lihtsustamine (ms)</translation>
    </message>
    <message>
        <source>renormalised</source>
        <translation>uuesti normeeritud</translation>
    </message>
    <message>
        <source>returns NaN</source>
        <translation>annab NaN-i</translation>
    </message>
    <message>
        <source>reversed</source>
        <translation>pööratud</translation>
    </message>
    <message>
        <source>separates surfaces {0} apart</source>
        <translation>eristab pindu vahega {0}</translation>
    </message>
    <message>
        <source>silhouette, px</source>
        <translation>siluett, px</translation>
    </message>
    <message>
        <source>snapped to 1/16 px</source>
        <translation>ümardatud 1/16 px-ni</translation>
    </message>
    <message>
        <source>snapped to 1/4 px</source>
        <translation>ümardatud 1/4 px-ni</translation>
    </message>
    <message>
        <source>snapped to whole px</source>
        <translation>ümardatud täispiksliteni</translation>
    </message>
    <message>
        <source>supersampling {0} x {0}</source>
        <translation>ülediskreetimine {0} x {0}</translation>
    </message>
    <message>
        <source>tells nothing behind it apart</source>
        <translation>ei erista selle taga midagi</translation>
    </message>
    <message>
        <source>texels</source>
        <translation>tekslit</translation>
    </message>
    <message>
        <source>the largest of up to {0} points against 200 digits of mpmath</source>
        <translation>suurim kuni {0} punktist, võrreldes mpmathi 200 numbrikohaga</translation>
    </message>
    <message>
        <source>the same picture</source>
        <translation>sama pilt</translation>
    </message>
    <message>
        <source>the smallest gap at the target (at 2 near or far / 2 if it lies outside)</source>
        <translation>väikseim vahe sihtpunkti kaugusel (kui see jääb väljapoole, siis kaugusel 2 lähitasandit või kaugtasand / 2)</translation>
    </message>
    <message>
        <source>the smallest gap behind a surface at this distance</source>
        <translation>väikseim vahe pinna taga sellel kaugusel</translation>
    </message>
    <message>
        <source>the target lies outside of near and far</source>
        <translation>sihtpunkt jääb väljapoole lähi- ja kaugtasandit</translation>
    </message>
    <message>
        <source>the whole edge is equally far away, so there is no error</source>
        <translation>kogu serv on ühel kaugusel, nii et viga ei ole</translation>
    </message>
    <message>
        <source>this OpenGL gives {0} samples</source>
        <translation>see OpenGL annab valimeid: {0}</translation>
    </message>
    <message>
        <source>this also switches off the early depth test, whose loss is not in this time</source>
        <translation>see lülitab välja ka varajase sügavustesti, mille kadu selles ajas ei sisaldu</translation>
    </message>
    <message>
        <source>this machine is busy: compare again</source>
        <translation>see masin on hõivatud: võrrelge uuesti</translation>
    </message>
    <message>
        <source>time ran out before the least time was steady</source>
        <translation>aeg lõppes, enne kui lühim aeg püsima jäi</translation>
    </message>
    <message>
        <source>triangles</source>
        <translation>kolmnurki</translation>
    </message>
    <message>
        <source>two floats</source>
        <translation>kaks ujukomaarvu</translation>
    </message>
    <message>
        <source>two sines</source>
        <translation>kaks siinust</translation>
    </message>
    <message>
        <source>up</source>
        <translation>ülesvektor</translation>
    </message>
    <message>
        <source>up to {0} off</source>
        <translation>viga kuni {0}</translation>
    </message>
    <message>
        <source>vertical fov, degrees</source>
        <translation>vertikaalne FOV, kraadides</translation>
    </message>
    <message>
        <source>vertices moved by up to (px)</source>
        <translation>tippude nihe kuni (px)</translation>
    </message>
    <message>
        <source>world coordinates</source>
        <translation>maailma koordinaadid</translation>
    </message>
    <message>
        <source>world units</source>
        <translation>maailma ühikut</translation>
    </message>
    <message>
        <source>{0} (cancelled)</source>
        <translation>{0} (katkestatud)</translation>
    </message>
    <message>
        <source>{0} (now)</source>
        <translation>{0} (nüüd)</translation>
    </message>
    <message>
        <source>{0} Newton step</source>
        <translation>{0} Newtoni samm</translation>
    </message>
    <message>
        <source>{0} Newton steps</source>
        <translation>{0} Newtoni sammu</translation>
    </message>
    <message>
        <source>{0} bits</source>
        <translation>{0} bitti</translation>
    </message>
    <message>
        <source>{0} instead of {1}: the same cost, {3}.</source>
        <translation>{0}, mitte {1}: sama kulu, {3}.</translation>
    </message>
    <message>
        <source>{0} instead of {1}: {2} times faster, {3}.</source>
        <translation>{0}, mitte {1}: {2} korda kiirem, {3}.</translation>
    </message>
    <message>
        <source>{0} instead of {1}: {2} times larger, {3}.</source>
        <translation>{0}, mitte {1}: {2} korda suurem, {3}.</translation>
    </message>
    <message>
        <source>{0} instead of {1}: {2} times slower, {3}.</source>
        <translation>{0}, mitte {1}: {2} korda aeglasem, {3}.</translation>
    </message>
    <message>
        <source>{0} instead of {1}: {2} times smaller, {3}.</source>
        <translation>{0}, mitte {1}: {2} korda väiksem, {3}.</translation>
    </message>
    <message>
        <source>{0} is only measured: the panes are not drawn with it.</source>
        <translation>{0} on ainult mõõdetud: paane sellega ei joonistata.</translation>
    </message>
    <message>
        <source>{0} pieces</source>
        <translation>{0} tükki</translation>
    </message>
    <message>
        <source>{0}; eye {1}, target {2}, {3}</source>
        <translation>{0}; silm {1}, siht {2}, {3}</translation>
    </message>
</context>
<context>
    <name>MeasurePanel</name>
    <message>
        <source>Trades and sweeps</source>
        <translation>Kompromissid ja mõõteread</translation>
    </message>
    <message>
        <source>What to measure and to show; Ctrl or Shift to choose several to measure</source>
        <translation>Mida mõõta ja näidata; mitme valimiseks Ctrl või Shift</translation>
    </message>
    <message>
        <source>How exactly</source>
        <translation>Kui täpselt</translation>
    </message>
    <message>
        <source>Quick: 2 s a trade, 13 values a sweep; full: 30 s a trade, 49 values</source>
        <translation>Kiire: 2 s kompromissi kohta, 13 väärtust mõõtereas; täielik: 30 s kompromissi kohta, 49 väärtust</translation>
    </message>
    <message>
        <source>Quick</source>
        <translation>Kiire</translation>
    </message>
    <message>
        <source>Full</source>
        <translation>Täielik</translation>
    </message>
    <message>
        <source>Measure here</source>
        <translation>Mõõda siin</translation>
    </message>
    <message>
        <source>Measure on this machine what is chosen, for this scene and camera</source>
        <translation>Mõõdab selles masinas valitut, selle stseeni ja kaameraga</translation>
    </message>
    <message>
        <source>Stop, and keep the results so far</source>
        <translation>Katkestab ja jätab senised tulemused alles</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Loobu</translation>
    </message>
    <message>
        <source>Progress of the measurement</source>
        <translation>Mõõtmise edenemine</translation>
    </message>
    <message>
        <source>Save what is shown: CSV, JSON, PNG or PDF</source>
        <translation>Salvestab näidatu: CSV, JSON, PNG või PDF</translation>
    </message>
    <message>
        <source>Export…</source>
        <translation>Ekspordi…</translation>
    </message>
    <message>
        <source>Draw the results from a file, perhaps from another machine, over these</source>
        <translation>Joonistab nende peale tulemused failist, võib-olla teisest masinast</translation>
    </message>
    <message>
        <source>Compare…</source>
        <translation>Võrdle…</translation>
    </message>
    <message>
        <source>Remove the results of the file</source>
        <translation>Eemaldab faili tulemused</translation>
    </message>
    <message>
        <source>Forget</source>
        <translation>Unusta</translation>
    </message>
    <message>
        <source>Cost</source>
        <translation>Kulu</translation>
    </message>
    <message>
        <source>What errors are drawn over: time, or bytes, the same on every machine</source>
        <translation>Mille suhtes vigu joonistatakse: aeg või baidid, mis on igas masinas samad</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Aeg</translation>
    </message>
    <message>
        <source>Memory</source>
        <translation>Mälu</translation>
    </message>
    <message>
        <source>Results</source>
        <translation>Tulemused</translation>
    </message>
    <message>
        <source>paused</source>
        <translation>peatatud</translation>
    </message>
    <message>
        <source>Export what is shown</source>
        <translation>Näidatu eksportimine</translation>
    </message>
    <message>
        <source>Tables (*.csv);;Results (*.json);;Pictures (*.png);;Vectors (*.pdf)</source>
        <translation>Tabelid (*.csv);;Tulemused (*.json);;Pildid (*.png);;Vektorgraafika (*.pdf)</translation>
    </message>
    <message>
        <source>Vectors (*.pdf)</source>
        <translation>Vektorgraafika (*.pdf)</translation>
    </message>
    <message>
        <source>There is nothing to export yet: run a measurement first.</source>
        <translation>Veel ei ole midagi eksportida: tehke enne mõõtmine.</translation>
    </message>
    <message>
        <source>{0}: its name must end in one of {1}.</source>
        <translation>{0}: nime lõpp peab olema üks järgmistest: {1}.</translation>
    </message>
    <message>
        <source>Compare with results of a file</source>
        <translation>Võrdlemine faili tulemustega</translation>
    </message>
    <message>
        <source>Results (*.json);;All files (*)</source>
        <translation>Tulemused (*.json);;Kõik failid (*)</translation>
    </message>
    <message>
        <source>{0}: cannot be read: {1}.</source>
        <translation>{0}: ei saa lugeda: {1}.</translation>
    </message>
    <message>
        <source>Measured with the letter F on another machine: {0}.</source>
        <translation>Mõõdetud F-tähega teises masinas: {0}.</translation>
    </message>
    <message>
        <source>There are no results yet: “Measure here” makes them.</source>
        <translation>Tulemusi veel ei ole: need teeb „Mõõda siin“.</translation>
    </message>
    <message>
        <source>Click a choice to use it in the panes; choices in italics cannot be used, and those in grey are worse than another one in both cost and error</source>
        <translation>Klõpsake valikul, et seda paanides kasutada; kaldkirjas valikuid ei saa kasutada ja hallid on mõnest teisest valikust halvemad nii kulu kui ka vea poolest</translation>
    </message>
    <message>
        <source>The results at each value; of near, far, fov and gap, click one to use it</source>
        <translation>Tulemused iga väärtuse juures; lähitasandi, kaugtasandi, FOV ja vahe puhul klõpsake väärtusel, et seda kasutada</translation>
    </message>
    <message>
        <source>{0} (measured only)</source>
        <translation>{0} (ainult mõõdetud)</translation>
    </message>
</context>
<context>
    <name>Measuring</name>
    <message>
        <source>The measurement cannot be started: {0}.</source>
        <translation>Mõõtmist ei saa alustada: {0}.</translation>
    </message>
    <message>
        <source>The measurement</source>
        <translation>Mõõtmine</translation>
    </message>
    <message>
        <source>The measurement ended unexpectedly.</source>
        <translation>Mõõtmine lõppes ootamatult.</translation>
    </message>
</context>
<context>
    <name>MessageBar</name>
    <message>
        <source>Message</source>
        <translation>Teade</translation>
    </message>
    <message>
        <source>Dismiss this message</source>
        <translation>Peidab selle teate</translation>
    </message>
</context>
<context>
    <name>MoveButton</name>
    <message>
        <source>Drag it to another place, or press the arrow keys up and down</source>
        <translation>Lohistage see teise kohta või vajutage üles- või allanoolt</translation>
    </message>
</context>
<context>
    <name>NumberAnswerView</name>
    <message>
        <source>Answer: {0}</source>
        <translation>Vastus: {0}</translation>
    </message>
    <message>
        <source>A number: 0.5, 1 1/2, √3/2, 2e-3 or 45°, to three significant digits (Enter)</source>
        <translation>Arv: 0.5; 1 1/2; √3/2; 2e-3 või 45°, kolme tüvenumbriga (Enter)</translation>
    </message>
</context>
<context>
    <name>NumberRow</name>
    <message>
        <source>{0}, slider</source>
        <translation>{0}, liugur</translation>
    </message>
    <message>
        <source>units</source>
        <translation>ühikut</translation>
    </message>
</context>
<context>
    <name>Options</name>
    <message>
        <source>How a camera turns a 3-D scene into a picture.</source>
        <translation>Kuidas kaamera teeb 3-D stseenist pildi.</translation>
    </message>
    <message>
        <source>a document, an exported PNG picture, a mesh, a camera, a lesson or a talk (default: the letter F)</source>
        <translation>dokument, eksporditud PNG-pilt, võrk, kaamera, õppetund või ettekanne (vaikimisi: F-täht)</translation>
    </message>
    <message>
        <source>a document, picture or mesh to measure (default: the letter F)</source>
        <translation>mõõdetav dokument, pilt või võrk (vaikimisi: F-täht)</translation>
    </message>
    <message>
        <source>a document, picture, mesh or camera file whose camera is used (default: the letter F)</source>
        <translation>dokumendi, pildi, võrgu või kaamera fail, mille kaamerat kasutatakse (vaikimisi: F-täht)</translation>
    </message>
    <message>
        <source>a document, picture, mesh or camera file whose camera is used (default: the letter F), and the points: CSV with the columns x,y,z, or - for standard input; a fourth column, w, may be 0 for a point at infinity; any other w divides x, y and z</source>
        <translation>dokumendi, pildi, võrgu või kaamera fail, mille kaamerat kasutatakse (vaikimisi: F-täht), ja punktid: CSV veergudega x,y,z, või - standardsisendi jaoks; neljas veerg w võib olla 0 lõpmatuspunkti jaoks; iga muu w jagab x, y ja z</translation>
    </message>
    <message>
        <source>a talk or a lesson, or the name of one that comes with the program, such as 001 or L5</source>
        <translation>ettekanne või õppetund, või programmiga kaasas oleva ettekande või õppetunni nimi, näiteks 001 või L5</translation>
    </message>
    <message>
        <source>after --convention (default: those of that program)</source>
        <translation>pärast valikut --convention (vaikimisi: seal nimetatud programmi omad)</translation>
    </message>
    <message>
        <source>arithmetic (default: float64, or exact where that is needed)</source>
        <translation>aritmeetika (vaikimisi: float64, või exact, kus seda on vaja)</translation>
    </message>
    <message>
        <source>camera and lens as another program writes them</source>
        <translation>kaamera ja objektiiv nii, nagu mõni teine programm need kirjutab</translation>
    </message>
    <message>
        <source>check or list lessons and talks, print tests of exercises, mark results</source>
        <translation>kontrolli või loetle õppetunde ja ettekandeid, trüki ülesannete teste, hinda tulemusi</translation>
    </message>
    <message>
        <source>check: try every state, answer key and sample of lessons and talks, and measure their pictures (default: those that come with the program); list: list them; names: print every name that their files may use; print: print tests, see below; results: mark files of results again from what was typed, count the wrong ideas, and list what no idea explains. FILE may also be a name such as L5 or 001</source>
        <translation>check: proovib läbi õppetundide ja ettekannete kõik olekud, vastusevõtmed ja näidised ning mõõdab nende pildid (vaikimisi: programmiga kaasas olevad); list: loetleb need; names: trükib kõik nimed, mida nende failid kasutada võivad; print: trükib testid, vt allpool; results: hindab tulemuste failid uuesti sisestatu põhjal, loendab väärarusaamad ja loetleb, mida ükski väärarusaam ei seleta. FILE võib olla ka nimi, näiteks L5 või 001</translation>
    </message>
    <message>
        <source>colours, for this start only</source>
        <translation>värvid, ainult selle käivituse jaoks</translation>
    </message>
    <message>
        <source>colours: as on a light or dark screen; for print, where faces and lines differ in grey, too; or with the most contrast (default: screen)</source>
        <translation>värvid: nagu heledal või tumedal ekraanil; trüki jaoks, kus tahud ja jooned erinevad ka halltoonilt; või suurima kontrastiga (vaikimisi: screen)</translation>
    </message>
    <message>
        <source>delete the settings, then open the window</source>
        <translation>kustuta sätted ja ava siis aken</translation>
    </message>
    <message>
        <source>draw a figure as PNG, SVG, PDF, TikZ or HTML, without a window or display</source>
        <translation>joonista joonis PNG-, SVG-, PDF-, TikZ- või HTML-failina, ilma akna ja ekraanita</translation>
    </message>
    <message>
        <source>draw a film: a value of --set changes from FIRST to LAST; may be repeated for values that change together</source>
        <translation>joonista film: valiku --set väärtus muutub väärtusest FIRST väärtuseni LAST; võib korrata koos muutuvate väärtuste jaoks</translation>
    </message>
    <message>
        <source>draw a film: how --step follows from the step before</source>
        <translation>joonista film: kuidas --step eelmisest sammust järgneb</translation>
    </message>
    <message>
        <source>draw a film: the ndc pane goes from the world through all stages to the image, and back</source>
        <translation>joonista film: ndc paan läheb maailmast läbi kõigi etappide pildini ja tagasi</translation>
    </message>
    <message>
        <source>draw a film: the world is seen from all round, or as far round as DEGREES say, and back; the camera stays where it is</source>
        <translation>joonista film: maailma nähakse igast küljest, või nii palju ringi, kui ütleb DEGREES, ja tagasi; kaamera jääb oma kohale</translation>
    </message>
    <message>
        <source>draw all results; FILE as for --json, ending in .png, or in .svg or .pdf for vectors</source>
        <translation>joonista kõik tulemused; FILE nagu valikul --json, lõpuga .png, või vektorgraafika jaoks .svg või .pdf</translation>
    </message>
    <message>
        <source>draw errors over time, or over bytes, which are the same on every machine</source>
        <translation>joonista vead aja suhtes või baitide suhtes, mis on igas masinas samad</translation>
    </message>
    <message>
        <source>draw every step of a talk, or print it with its notes</source>
        <translation>joonista ettekande iga samm või trüki see koos märkmetega</translation>
    </message>
    <message>
        <source>draw every step without a display, run lesson check, measure the pictures, and report each mistake with file and line</source>
        <translation>joonista iga samm ilma ekraanita, käivita lesson check, mõõda pildid ja teata igast veast koos faili ja reaga</translation>
    </message>
    <message>
        <source>draw many figures: a CSV file with a line for each, whose columns are out, file, the options without their dashes, and names of --set; each document, and each step of the lessons and talks, of a folder; or each step of one lesson</source>
        <translation>joonista palju jooniseid: CSV-fail, milles on igaühe jaoks rida ja mille veerud on out, file, valikud ilma kriipsudeta ja valiku --set nimed; kausta iga dokument ning õppetundide ja ettekannete iga samm; või ühe õppetunni iga samm</translation>
    </message>
    <message>
        <source>draw the same figure with more pixels (default: 1)</source>
        <translation>joonista sama joonis rohkemate pikslitega (vaikimisi: 1)</translation>
    </message>
    <message>
        <source>every factor from the object to the picture, and the products so far</source>
        <translation>iga tegur objektist pildini ja senised korrutised</translation>
    </message>
    <message>
        <source>follow points through every stage of the projection</source>
        <translation>jälgi punkte läbi projektsiooni kõigi etappide</translation>
    </message>
    <message>
        <source>how panes draw (default: opengl with a graphics card, raster without)</source>
        <translation>kuidas paanid joonistavad (vaikimisi: graafikakaardiga opengl, ilma selleta raster)</translation>
    </message>
    <message>
        <source>in LaTeX: formulas in the cells instead of numbers</source>
        <translation>LaTeXis: lahtrites on arvude asemel valemid</translation>
    </message>
    <message>
        <source>in LaTeX: letters of axes and formulas: own, 000, 001, 002, 003, 004, or those of a file such as letters.toml (default: the document&apos;s)</source>
        <translation>LaTeXis: telgede ja valemite tähed: own, 000, 001, 002, 003, 004 või faili, näiteks letters.toml, omad (vaikimisi: dokumendi omad)</translation>
    </message>
    <message>
        <source>in LaTeX: numbers, also after --symbols</source>
        <translation>LaTeXis: arvud, ka pärast valikut --symbols</translation>
    </message>
    <message>
        <source>in LaTeX: significant digits of numbers, up to 17, which are all (default: 4)</source>
        <translation>LaTeXis: arvude tüvenumbrid, kuni 17, mis on kõik (vaikimisi: 4)</translation>
    </message>
    <message>
        <source>in LaTeX: the width of the text or the column, such as 84mm, in mm, cm, in or pt (default: 345pt, the text of an article)</source>
        <translation>LaTeXis: teksti või veeru laius, näiteks 84mm, ühikutes mm, cm, in või pt (vaikimisi: 345pt, artikli tekst)</translation>
    </message>
    <message>
        <source>in all but .png, lines behind faces: left out, dashed as in ISO 128, or thin and grey (default: none)</source>
        <translation>kõigis failides peale .png-faili: tahkude taga olevad jooned jäetakse ära, on katkendlikud nagu standardis ISO 128 või peenikesed ja hallid (vaikimisi: none)</translation>
    </message>
    <message>
        <source>instead of --size: how wide it is after it was cropped without a margin, such as 84mm; its height is free, and letters keep their size</source>
        <translation>valiku --size asemel: kui lai see on pärast servata kärpimist, näiteks 84mm; kõrgus on vaba ja tähed säilitavad oma suuruse</translation>
    </message>
    <message>
        <source>instead: the code and its packages, for machines with Python</source>
        <translation>selle asemel: kood ja selle paketid, Pythoniga masinate jaoks</translation>
    </message>
    <message>
        <source>leave out what is empty around the figure, but for a margin of 2 mm</source>
        <translation>jäta joonise ümbert ära kõik tühi, välja arvatud 2 mm serv</translation>
    </message>
    <message>
        <source>leave the background transparent</source>
        <translation>jäta taust läbipaistvaks</translation>
    </message>
    <message>
        <source>letters of axes and formulas: own, 000, 001, 002, 003, 004, or those of a file such as letters.toml (default: the document&apos;s)</source>
        <translation>telgede ja valemite tähed: own, 000, 001, 002, 003, 004 või faili, näiteks letters.toml, omad (vaikimisi: dokumendi omad)</translation>
    </message>
    <message>
        <source>letters of axes and formulas: own, 000, 001, 002, 003, 004, or those of a file such as letters.toml (default: the document&apos;s, or the lesson&apos;s)</source>
        <translation>telgede ja valemite tähed: own, 000, 001, 002, 003, 004 või faili, näiteks letters.toml, omad (vaikimisi: dokumendi või õppetunni omad)</translation>
    </message>
    <message>
        <source>letters of axes and formulas: own, 000, 001, 002, 003, 004, or those of a file such as letters.toml (default: the talk&apos;s)</source>
        <translation>telgede ja valemite tähed: own, 000, 001, 002, 003, 004 või faili, näiteks letters.toml, omad (vaikimisi: ettekande omad)</translation>
    </message>
    <message>
        <source>make a folder to carry to machines without a network or an administrator</source>
        <translation>tee kaust, mille saab viia masinatesse, kus ei ole võrguühendust ega administraatorit</translation>
    </message>
    <message>
        <source>measure for half a minute only, less exactly</source>
        <translation>mõõda ainult pool minutit, vähem täpselt</translation>
    </message>
    <message>
        <source>measure the errors over a parameter&apos;s range; NAME is one of near, far, fov, distance, up, aspect, gap</source>
        <translation>mõõda vead parameetri vahemikus; NAME on üks nendest: near, far, fov, distance, up, aspect, gap</translation>
    </message>
    <message>
        <source>measure this trade; may be repeated (default, without --sweep: all)</source>
        <translation>mõõda see kompromiss; võib korrata (vaikimisi, ilma valikuta --sweep: kõik)</translation>
    </message>
    <message>
        <source>measure, on this machine, what speed costs in accuracy</source>
        <translation>mõõda selles masinas, mida kiirus täpsuses maksab</translation>
    </message>
    <message>
        <source>of --batch with a folder or a lesson: what to write (default: png)</source>
        <translation>valikul --batch kausta või õppetunniga: mida kirjutada (vaikimisi: png)</translation>
    </message>
    <message>
        <source>of --batch: leave out figures that are newer than the list and their document</source>
        <translation>valikul --batch: jäta vahele joonised, mis on loendist ja oma dokumendist uuemad</translation>
    </message>
    <message>
        <source>of --sweep: in equal steps, in equal ratios, or slowly at both ends (default: linear)</source>
        <translation>valikul --sweep: võrdsete sammudega, võrdsete suhetega või mõlemas otsas aeglaselt (vaikimisi: linear)</translation>
    </message>
    <message>
        <source>of --sweep: write the values below the panes</source>
        <translation>valikul --sweep: kirjuta väärtused paanide alla</translation>
    </message>
    <message>
        <source>of --wheels, such as 3.12; may be repeated (default: this one&apos;s)</source>
        <translation>valikul --wheels, näiteks 3.12; võib korrata (vaikimisi: praegune)</translation>
    </message>
    <message>
        <source>of --wheels; may be repeated (default: all of them)</source>
        <translation>valikul --wheels; võib korrata (vaikimisi: kõik)</translation>
    </message>
    <message>
        <source>of a film: from the last frame to the first, not at all, or there and back in all frames together (default: repeat for --sweep and all round, once for --transition and numbered files, else back-and-forth)</source>
        <translation>filmil: viimasest kaadrist esimesse, üldse mitte, või kõigi kaadrite jooksul kokku edasi ja tagasi (vaikimisi: repeat valikul --sweep ja täisringil, once valikul --transition ja nummerdatud failidel, muidu back-and-forth)</translation>
    </message>
    <message>
        <source>of a film: how many frames (default: 48; of --stages 120, of --transition 24; in .html 21)</source>
        <translation>filmil: mitu kaadrit (vaikimisi: 48; valikul --stages 120, valikul --transition 24; .html-failis 21)</translation>
    </message>
    <message>
        <source>of a film: how many frames a second (default: 25)</source>
        <translation>filmil: mitu kaadrit sekundis (vaikimisi: 25)</translation>
    </message>
    <message>
        <source>of check and print: letters of axes and formulas: own, 000, 001, 002, 003, 004, or those of a file such as letters.toml (default: the lesson&apos;s)</source>
        <translation>käskudel check ja print: telgede ja valemite tähed: own, 000, 001, 002, 003, 004 või faili, näiteks letters.toml, omad (vaikimisi: õppetunni omad)</translation>
    </message>
    <message>
        <source>of print: the topics, or files of lessons, whose exercises make the test</source>
        <translation>käsul print: teemad või õppetundide failid, mille ülesannetest test koosneb</translation>
    </message>
    <message>
        <source>of print: the variants, one file for each; a variant has the same numbers everywhere</source>
        <translation>käsul print: variandid, igaühe jaoks üks fail; variandil on kõikjal samad arvud</translation>
    </message>
    <message>
        <source>of print: where the PDF files go; existing files are overwritten</source>
        <translation>käsul print: kuhu PDF-failid lähevad; olemasolevad failid kirjutatakse üle</translation>
    </message>
    <message>
        <source>of print: write one more file, with the answers of all variants and their ways</source>
        <translation>käsul print: kirjuta veel üks fail, kõigi variantide vastuste ja lahenduskäikudega</translation>
    </message>
    <message>
        <source>of results: write a table, a row for each answer; an existing file is overwritten</source>
        <translation>käsul results: kirjuta tabel, iga vastuse jaoks üks rida; olemasolev fail kirjutatakse üle</translation>
    </message>
    <message>
        <source>of the chart, as of a figure (default: screen)</source>
        <translation>diagrammil, nagu joonisel (vaikimisi: screen)</translation>
    </message>
    <message>
        <source>of the chart, as of a figure; with --size, --width or --text-size there are no notes below</source>
        <translation>diagrammil, nagu joonisel; valikutega --size, --width või --text-size ei ole all märkusi</translation>
    </message>
    <message>
        <source>of the chart, instead of --size; its height is free</source>
        <translation>diagrammil, valiku --size asemel; kõrgus on vaba</translation>
    </message>
    <message>
        <source>of the handout: teacher has answers and notes, students room to write instead</source>
        <translation>jaotusmaterjalil: teacher on vastuste ja märkmetega, students jätab nende asemel ruumi kirjutamiseks</translation>
    </message>
    <message>
        <source>output format (default: table)</source>
        <translation>väljundi vorming (vaikimisi: table)</translation>
    </message>
    <message>
        <source>output format (default: text)</source>
        <translation>väljundi vorming (vaikimisi: text)</translation>
    </message>
    <message>
        <source>print every stage&apos;s matrix</source>
        <translation>trüki iga etapi maatriks</translation>
    </message>
    <message>
        <source>report the fraction done, one per line, and take the commands pause, resume and cancel from standard input</source>
        <translation>teata, kui suur osa on tehtud, igaüks oma real, ja võta standardsisendist vastu käsud pause, resume ja cancel</translation>
    </message>
    <message>
        <source>report what this machine has, what is missing and how to get it</source>
        <translation>teata, mis selles masinas on, mis puudub ja kust seda saab</translation>
    </message>
    <message>
        <source>save a picture of the window as PNG and quit</source>
        <translation>salvesta akna pilt PNG-failina ja lõpeta</translation>
    </message>
    <message>
        <source>show program&apos;s version number and exit</source>
        <translation>näita programmi versiooni ja lõpeta</translation>
    </message>
    <message>
        <source>size of all letters of the chart in points (default: 7 with --size or --width)</source>
        <translation>diagrammi kõigi tähtede suurus punktides (vaikimisi: 7 valikuga --size või --width)</translation>
    </message>
    <message>
        <source>size of the window</source>
        <translation>akna suurus</translation>
    </message>
    <message>
        <source>size of all letters in points; 72 points are 300 pixels at scale 1 (default: 7 in a pane of 640 pixels, in proportion in others)</source>
        <translation>kõigi tähtede suurus punktides; 72 punkti on 300 pikslit mastaabis 1 (vaikimisi: 7 paanis, mille laius on 640 pikslit, teistes võrdeliselt)</translation>
    </message>
    <message>
        <source>size on paper, such as 120mmx80mm, in mm, cm or in; or in pixels at scale 1, 300 an inch (default: 640x640 for each pane, or its own size for the image alone); in .html, of each pane</source>
        <translation>suurus paberil, näiteks 120mmx80mm, ühikutes mm, cm või in; või pikslites mastaabis 1, 300 tolli kohta (vaikimisi: 640x640 iga paani jaoks, või ainult pildi puhul selle oma suurus); .html-failis iga paani suurus</translation>
    </message>
    <message>
        <source>space of the coordinates (default: world)</source>
        <translation>koordinaatide ruum (vaikimisi: world)</translation>
    </message>
    <message>
        <source>the figure to write (.png; .svg, .pdf or TikZ&apos;s .tex for shapes and text; .html for a page that phones show), and the document, picture, mesh, camera, lesson or talk to draw (default: the letter F); with --batch, the folder of the figures; with --sweep, --orbit, --stages or --transition, a film (.gif, .apng, .webp, or .mp4 with ffmpeg), a page with a slider (.html), or a name with %03d for a figure of each frame</source>
        <translation>kirjutatav joonis (.png; .svg, .pdf või TikZ-i .tex kujundite ja teksti jaoks; .html lehe jaoks, mida telefonid näitavad) ja joonistatav dokument, pilt, võrk, kaamera, õppetund või ettekanne (vaikimisi: F-täht); koos valikuga --batch jooniste kaust; koos valikuga --sweep, --orbit, --stages või --transition film (.gif, .apng, .webp, või ffmpegiga .mp4), liuguriga leht (.html) või nimi, milles on %03d, iga kaadri joonise jaoks</translation>
    </message>
    <message>
        <source>the panes to draw, side by side, or below each other with / instead of commas (default: all, side by side; of a step, those of its slide); or equation, alone: that of view.equation, which is the default where --set asks for one</source>
        <translation>joonistatavad paanid, kõrvuti, või komade asemel märgiga / üksteise all (vaikimisi: kõik, kõrvuti; sammu puhul selle slaidi paanid); või üksi equation: see on väärtuse view.equation võrrand, mis on vaikimisi, kui --set mõnda võrrandit küsib</translation>
    </message>
    <message>
        <source>the same as --set scene=NAME</source>
        <translation>sama mis --set scene=NAME</translation>
    </message>
    <message>
        <source>the six planes of the view volume in world space</source>
        <translation>nähtava ruumi kuus tasandit maailmas</translation>
    </message>
    <message>
        <source>the step of a lesson or a talk to draw, its number or its name (default: the first)</source>
        <translation>joonistatav õppetunni või ettekande samm, selle number või nimi (vaikimisi: esimene)</translation>
    </message>
    <message>
        <source>what the world pane frames: what is named, with the whole frustum too, or the objects alone (default: named)</source>
        <translation>mida maailma paan raamib: seda, mis on nimetatud, ka koos kogu frustumiga, või ainult objekte (vaikimisi: named)</translation>
    </message>
    <message>
        <source>where to put the folder frustum-lab, with the program and all that it needs, for machines like this one without Python; and an archive of it</source>
        <translation>kuhu panna kaust frustum-lab, milles on programm ja kõik, mida see vajab, sarnaste Pythonita masinate jaoks; ja selle arhiiv</translation>
    </message>
    <message>
        <source>write all results; FILE is overwritten, - is standard output</source>
        <translation>kirjuta kõik tulemused; FILE kirjutatakse üle, - on standardväljund</translation>
    </message>
    <message>
        <source>write the figures, text and notes of every step on A4 pages (.pdf) or as a page that phones show (.html); an existing file is overwritten</source>
        <translation>kirjuta iga sammu joonised, tekst ja märkmed A4-lehtedele (.pdf) või lehele, mida telefonid näitavad (.html); olemasolev fail kirjutatakse üle</translation>
    </message>
    <message>
        <source>write the tables, one after the other; FILE as for --json</source>
        <translation>kirjuta tabelid üksteise järel; FILE nagu valikul --json</translation>
    </message>
</context>
<context>
    <name>OrderView</name>
    <message>
        <source>The tile at the bottom acts first.</source>
        <translation>Esimesena mõjub kõige alumine lüli.</translation>
    </message>
</context>
<context>
    <name>Overview</name>
    <message>
        <source>Overview of what you practised</source>
        <translation>Ülevaade sellest, mida te harjutasite</translation>
    </message>
    <message>
        <source>solved alone</source>
        <translation>ise lahendatud</translation>
    </message>
    <message>
        <source>solved with help</source>
        <translation>abiga lahendatud</translation>
    </message>
    <message>
        <source>answer shown</source>
        <translation>vastus näidatud</translation>
    </message>
    <message>
        <source>not yet</source>
        <translation>veel mitte</translation>
    </message>
    <message>
        <source>Test &amp;yourself…</source>
        <translation>Kontrolli en&amp;nast…</translation>
    </message>
    <message>
        <source>&amp;Export…</source>
        <translation>&amp;Ekspordi…</translation>
    </message>
    <message>
        <source>Write all of it into a file for your teacher</source>
        <translation>Kirjutab selle kõik faili teie õpetaja jaoks</translation>
    </message>
    <message>
        <source>only a number: not yet</source>
        <translation>ainult number: veel mitte</translation>
    </message>
    <message>
        <source>Open the lesson</source>
        <translation>Ava õppetund</translation>
    </message>
    <message>
        <source>{0}, exercise {1}: {2}. {3}</source>
        <translation>{0}, ülesanne {1}: {2}. {3}</translation>
    </message>
    <message>
        <source>once</source>
        <translation>üks kord</translation>
    </message>
    <message numerus="yes">
        <source>%n times</source>
        <translation>
            <numerusform>%n kord</numerusform>
            <numerusform>%n korda</numerusform>
        </translation>
    </message>
    <message>
        <source>“{0}” {1}; then: {2}</source>
        <translation>„{0}“ {1}; siis: {2}</translation>
    </message>
</context>
<context>
    <name>Pane</name>
    <message>
        <source>Reset this pane&apos;s own view (double-click)</source>
        <translation>Lähtesta selle paani oma vaade (topeltklõps)</translation>
    </message>
    <message>
        <source>Enlarge; click again for the whole window</source>
        <translation>Suurenda; teine klõps annab kogu akna</translation>
    </message>
    <message>
        <source>Move to a window of its own, and back</source>
        <translation>Vii oma aknasse ja tagasi</translation>
    </message>
</context>
<context>
    <name>Pen</name>
    <message>
        <source>Pen</source>
        <translation>Pliiats</translation>
    </message>
    <message>
        <source>Colours, eraser, undo, clear, keep</source>
        <translation>Värvid, kustutaja, tagasivõtmine, tühjendamine, hoidmine</translation>
    </message>
    <message>
        <source>Black</source>
        <translation>Must</translation>
    </message>
    <message>
        <source>Orange</source>
        <translation>Oranž</translation>
    </message>
    <message>
        <source>Green</source>
        <translation>Roheline</translation>
    </message>
    <message>
        <source>Blue</source>
        <translation>Sinine</translation>
    </message>
    <message>
        <source>Erase</source>
        <translation>Kustuta</translation>
    </message>
    <message>
        <source>Remove the strokes that are touched (E)</source>
        <translation>Eemaldab puudutatud jooned (E)</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Võta tagasi</translation>
    </message>
    <message>
        <source>Remove the last stroke (Ctrl+Z)</source>
        <translation>Eemaldab viimase joone (Ctrl+Z)</translation>
    </message>
    <message>
        <source>Clear</source>
        <translation>Tühjenda</translation>
    </message>
    <message>
        <source>Remove all strokes of the step (Delete)</source>
        <translation>Eemaldab kõik selle sammu jooned (Delete)</translation>
    </message>
    <message>
        <source>Keep</source>
        <translation>Hoia alles</translation>
    </message>
    <message>
        <source>Keep the strokes for the handout (K)</source>
        <translation>Hoiab jooned jaotusmaterjali jaoks alles (K)</translation>
    </message>
</context>
<context>
    <name>Pictures</name>
    <message>
        <source>Export a picture</source>
        <translation>Pildi eksportimine</translation>
    </message>
    <message>
        <source>{0} pictures (*.{1})</source>
        <translation>{0}-pildid (*.{1})</translation>
    </message>
    <message>
        <source>Exported {0}</source>
        <translation>Eksporditud: {0}</translation>
    </message>
    <message>
        <source>Drawing the picture</source>
        <translation>Joonistatakse pilti</translation>
    </message>
    <message>
        <source>Export a diagram</source>
        <translation>Diagrammi eksportimine</translation>
    </message>
    <message>
        <source>Copied the diagram</source>
        <translation>Diagramm on kopeeritud</translation>
    </message>
    <message>
        <source>Copied the picture</source>
        <translation>Pilt on kopeeritud</translation>
    </message>
</context>
<context>
    <name>Plane</name>
    <message>
        <source>near</source>
        <translation>lähitasand</translation>
    </message>
    <message>
        <source>far</source>
        <translation>kaugtasand</translation>
    </message>
    <message>
        <source>left</source>
        <translation>vasak</translation>
    </message>
    <message>
        <source>right</source>
        <translation>parem</translation>
    </message>
    <message>
        <source>bottom</source>
        <translation>alumine</translation>
    </message>
    <message>
        <source>top</source>
        <translation>ülemine</translation>
    </message>
</context>
<context>
    <name>Playing</name>
    <message>
        <source>Play</source>
        <translation>Esita</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Paus</translation>
    </message>
</context>
<context>
    <name>Practice</name>
    <message>
        <source>&amp;Review</source>
        <translation>&amp;Kordamine</translation>
    </message>
    <message>
        <source>{0} of {1}</source>
        <translation>{0}/{1}</translation>
    </message>
    <message>
        <source>The next review is tomorrow.</source>
        <translation>Järgmine kordamine on homme.</translation>
    </message>
    <message>
        <source>The next review is on {0}.</source>
        <translation>Järgmise kordamise päev: {0}.</translation>
    </message>
    <message>
        <source>Go on with it</source>
        <translation>Jätka seda</translation>
    </message>
    <message>
        <source>The test is kept.</source>
        <translation>Test on alles.</translation>
    </message>
    <message>
        <source>all topics</source>
        <translation>kõik teemad</translation>
    </message>
    <message>
        <source>Test {0}: {1}</source>
        <translation>Test {0}: {1}</translation>
    </message>
    <message>
        <source>These topics have no exercises yet.</source>
        <translation>Nendel teemadel ei ole veel ülesandeid.</translation>
    </message>
    <message>
        <source>Save the result</source>
        <translation>Tulemuse salvestamine</translation>
    </message>
    <message>
        <source>Your name, if your teacher is to read it in the file:</source>
        <translation>Teie nimi, kui õpetaja peab seda failis nägema:</translation>
    </message>
    <message>
        <source>Results (*.json);;All files (*)</source>
        <translation>Tulemused (*.json);;Kõik failid (*)</translation>
    </message>
    <message>
        <source>result</source>
        <translation>tulemus</translation>
    </message>
    <message>
        <source>The result is in {0}.</source>
        <translation>Tulemus on failis {0}.</translation>
    </message>
    <message>
        <source>Review</source>
        <translation>Kordamine</translation>
    </message>
    <message>
        <source>What you do not solve alone comes back in a day.</source>
        <translation>Mida te ise ei lahenda, tuleb päeva pärast tagasi.</translation>
    </message>
    <message>
        <source>Nothing has come back today.</source>
        <translation>Täna ei ole midagi tagasi tulnud.</translation>
    </message>
    <message>
        <source>&amp;Review: {0}, about {1}</source>
        <translation>&amp;Kordamine: {0}, umbes {1}</translation>
    </message>
</context>
<context>
    <name>ProbeNumbers</name>
    <message>
        <source>object</source>
        <translation>objekt</translation>
    </message>
    <message>
        <source>world</source>
        <translation>maailm</translation>
    </message>
    <message>
        <source>view</source>
        <translation>vaade</translation>
    </message>
    <message>
        <source>clip</source>
        <translation>kärperuum</translation>
    </message>
    <message>
        <source>divide</source>
        <translation>jagamine</translation>
    </message>
    <message>
        <source>NDC</source>
        <translation>NDC</translation>
    </message>
    <message>
        <source>image px</source>
        <translation>pilt px</translation>
    </message>
    <message>
        <source>depth</source>
        <translation>sügavus</translation>
    </message>
    <message>
        <source>inside</source>
        <translation>sees</translation>
    </message>
    <message>
        <source>outside of: {0}</source>
        <translation>väljaspool: {0}</translation>
    </message>
    <message>
        <source>none: a scale of 0 has flattened the object</source>
        <translation>puudub: skaleerimine 0-ga on objekti lamedaks surunud</translation>
    </message>
    <message>
        <source>the vanishing point; {0}</source>
        <translation>koondumispunkt; {0}</translation>
    </message>
    <message>
        <source>behind the eye</source>
        <translation>silma taga</translation>
    </message>
    <message>
        <source>in the eye plane (w = 0)</source>
        <translation>silmatasandil (w = 0)</translation>
    </message>
    <message>
        <source>the opposite direction has a picture</source>
        <translation>vastassuunal on kujutis</translation>
    </message>
    <message>
        <source>behind the eye: no picture</source>
        <translation>silma taga: kujutist ei ole</translation>
    </message>
    <message>
        <source>parallel to the image: lines stay parallel</source>
        <translation>pildiga paralleelne: sirged jäävad paralleelseks</translation>
    </message>
    <message>
        <source>parallel projectors: lines stay parallel</source>
        <translation>paralleelsed projektsioonikiired: sirged jäävad paralleelseks</translation>
    </message>
    <message>
        <source>w = 0: its picture is at infinity too</source>
        <translation>w = 0: ka selle kujutis on lõpmatuses</translation>
    </message>
    <message>
        <source>beside the eye: no number is large enough</source>
        <translation>silma kõrval: ükski arv ei ole piisavalt suur</translation>
    </message>
    <message>
        <source>the pixel&apos;s ray, from near to far</source>
        <translation>piksli kiir lähitasandist kaugtasandini</translation>
    </message>
    <message>
        <source>the pixel&apos;s ray, as far as it is in front of the eye</source>
        <translation>piksli kiir, niipalju kui seda silma ees on</translation>
    </message>
    <message>
        <source>no ray in the world: the matrix has no inverse</source>
        <translation>maailmas kiirt ei ole: maatriksil ei ole pöördmaatriksit</translation>
    </message>
    <message>
        <source>no ray in the world: all of it is behind the eye</source>
        <translation>maailmas kiirt ei ole: see jääb tervikuna silma taha</translation>
    </message>
</context>
<context>
    <name>ProbePanel</name>
    <message>
        <source>The probes&apos; numbers at every stage</source>
        <translation>Sondide arvud igas etapis</translation>
    </message>
    <message>
        <source>The probe that the fields and buttons change</source>
        <translation>Sond, mida väljad ja nupud muudavad</translation>
    </message>
    <message>
        <source>Probe</source>
        <translation>Sond</translation>
    </message>
    <message>
        <source>Probe, world {0}</source>
        <translation>Sond, maailma {0}</translation>
    </message>
    <message>
        <source>World {0} of the probe; type a number</source>
        <translation>Sondi koordinaat {0} maailmas; sisestage arv</translation>
    </message>
    <message>
        <source>w of the probe: 1 for a point; 0 for the point at infinity in the direction x, y, z; with any other w the point is (x/w, y/w, z/w)</source>
        <translation>Sondi w: 1 on punkt; 0 on lõpmatuspunkt suunas x, y, z; iga muu w puhul on punkt (x/w, y/w, z/w)</translation>
    </message>
    <message>
        <source>Keep this probe: the next click makes another one</source>
        <translation>Hoiab selle sondi alles: järgmine klõps teeb uue</translation>
    </message>
    <message>
        <source>Pin</source>
        <translation>Fikseeri</translation>
    </message>
    <message>
        <source>Remove this probe (Esc)</source>
        <translation>Eemaldab selle sondi (Esc)</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Eemalda</translation>
    </message>
    <message>
        <source>Clear</source>
        <translation>Tühjenda</translation>
    </message>
    <message>
        <source>Remove all probes</source>
        <translation>Eemaldab kõik sondid</translation>
    </message>
    <message>
        <source>Click a point in any pane to follow it from the world to its pixel; click an empty place in the image for the ray of that pixel.</source>
        <translation>Klõpsake mis tahes paanis punktil, et jälgida seda maailmast pikslini; klõpsake pildi tühjal kohal, et näha selle piksli kiirt.</translation>
    </message>
    <message>
        <source>Probes = {0}: at most {1} can be pinned; remove one first.</source>
        <translation>Sondide arv = {0}: fikseerida saab ülimalt {1}; eemaldage enne üks.</translation>
    </message>
    <message>
        <source>{0}, pinned</source>
        <translation>{0}, fikseeritud</translation>
    </message>
    <message>
        <source>Ray {0}</source>
        <translation>Kiir {0}</translation>
    </message>
    <message>
        <source>Point {0}</source>
        <translation>Punkt {0}</translation>
    </message>
    <message>
        <source>Direction {0}</source>
        <translation>Suund {0}</translation>
    </message>
</context>
<context>
    <name>ProbeTable</name>
    <message>
        <source>Copy, with all digits</source>
        <translation>Kopeeri kõigi numbrikohtadega</translation>
    </message>
</context>
<context>
    <name>Probing</name>
    <message>
        <source>depth = {0}: must be that of something drawn, but nothing is here</source>
        <translation>sügavus = {0}: see peab olema millegi joonistatu sügavus, aga siin ei ole midagi</translation>
    </message>
</context>
<context>
    <name>Progress</name>
    <message>
        <source>Cancel</source>
        <translation>Loobu</translation>
    </message>
</context>
<context>
    <name>QPlatformTheme</name>
    <message>
        <source>&amp;No</source>
        <translation>&amp;Ei</translation>
    </message>
    <message>
        <source>&amp;Yes</source>
        <translation>&amp;Jah</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Loobu</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Sulge</translation>
    </message>
    <message>
        <source>Discard</source>
        <translation>Ära salvesta</translation>
    </message>
    <message>
        <source>OK</source>
        <translation>OK</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Salvesta</translation>
    </message>
</context>
<context>
    <name>Readout</name>
    <message>
        <source>More numbers</source>
        <translation>Veel arve</translation>
    </message>
    <message>
        <source>Show or fold the other numbers of this scene</source>
        <translation>Näitab või peidab selle stseeni ülejäänud arvud</translation>
    </message>
</context>
<context>
    <name>Recovery</name>
    <message>
        <source>There is unsaved work from {0}.</source>
        <translation>Salvestamata töö: {0}.</translation>
    </message>
    <message>
        <source>Recover it</source>
        <translation>Taasta see</translation>
    </message>
    <message>
        <source>Discard it</source>
        <translation>Loobu sellest</translation>
    </message>
    <message>
        <source>The recovered work cannot be kept in {0}: save it soon.</source>
        <translation>Taastatud tööd ei saa kohas {0} hoida: salvestage see peagi.</translation>
    </message>
    <message>
        <source>{0} could not be removed: {1}.</source>
        <translation>Faili {0} ei saanud eemaldada: {1}.</translation>
    </message>
    <message>
        <source>No copy of unsaved work can be kept in {0}: save it soon.</source>
        <translation>Salvestamata töö koopiat ei saa kohas {0} hoida: salvestage see peagi.</translation>
    </message>
</context>
<context>
    <name>Refusal</name>
    <message>
        <source>A film&apos;s frames have one size: leave out crop and width.</source>
        <translation>Filmi kaadrid on ühe suurusega: jätke crop ja width ära.</translation>
    </message>
    <message>
        <source>A point ends at {0} instead of {1}.</source>
        <translation>Punkt satub kohta {0}, mitte kohta {1}.</translation>
    </message>
    <message>
        <source>All signs are turned round.</source>
        <translation>Kõik märgid on vastupidised.</translation>
    </message>
    <message>
        <source>Both orders do the same.</source>
        <translation>Mõlemad järjekorrad teevad sama.</translation>
    </message>
    <message>
        <source>It is close, but not exact enough.</source>
        <translation>See on lähedal, aga mitte piisavalt täpne.</translation>
    </message>
    <message>
        <source>It is off by the factor 180/π: degrees and radians are mixed up.</source>
        <translation>Vastus erineb kordaja 180/π võrra: kraadid ja radiaanid on segamini.</translation>
    </message>
    <message>
        <source>It is too large, by a factor of about {0}.</source>
        <translation>Vastus on liiga suur, umbes {0} korda.</translation>
    </message>
    <message>
        <source>It is too small, by a factor of about {0}.</source>
        <translation>Vastus on liiga väike, umbes {0} korda.</translation>
    </message>
    <message>
        <source>It swings about the origin, and ends {0} units away from its place.</source>
        <translation>See läheb kaarega ümber alguspunkti ja satub oma kohast {0} ühiku kaugusele.</translation>
    </message>
    <message>
        <source>None of the numbers is right.</source>
        <translation>Ükski arvudest ei ole õige.</translation>
    </message>
    <message>
        <source>Only column {0} is wrong.</source>
        <translation>Vale on ainult veerg {0}.</translation>
    </message>
    <message>
        <source>Only row {0} is wrong.</source>
        <translation>Vale on ainult rida {0}.</translation>
    </message>
    <message>
        <source>Only the number in row {0}, column {1} is wrong.</source>
        <translation>Vale on ainult arv, mis on reas {0} ja veerus {1}.</translation>
    </message>
    <message>
        <source>The digits are right, but the power of ten is wrong.</source>
        <translation>Numbrid on õiged, aga kümne aste on vale.</translation>
    </message>
    <message>
        <source>The document</source>
        <translation>Dokument</translation>
    </message>
    <message>
        <source>The marked numbers have the wrong sign.</source>
        <translation>Märgitud arvudel on vale märk.</translation>
    </message>
    <message>
        <source>The numbers are right, but columns {0} and {1} are exchanged.</source>
        <translation>Arvud on õiged, aga veerud {0} ja {1} on vahetuses.</translation>
    </message>
    <message>
        <source>The numbers are right, but rows and columns are exchanged.</source>
        <translation>Arvud on õiged, aga read ja veerud on vahetuses.</translation>
    </message>
    <message>
        <source>The numbers are right, but rows {0} and {1} are exchanged.</source>
        <translation>Arvud on õiged, aga read {0} ja {1} on vahetuses.</translation>
    </message>
    <message>
        <source>The origin ends at {0} instead of {1}.</source>
        <translation>Alguspunkt satub kohta {0}, mitte kohta {1}.</translation>
    </message>
    <message>
        <source>The sign is wrong, and so is the size.</source>
        <translation>Vale on märk ja vale on ka suurus.</translation>
    </message>
    <message>
        <source>The size is right, but the sign is wrong.</source>
        <translation>Suurus on õige, aga märk on vale.</translation>
    </message>
    <message>
        <source>The w of a point becomes {0} instead of {1}.</source>
        <translation>Punkti w-ks saab {0}, mitte {1}.</translation>
    </message>
    <message>
        <source>The {0} axis becomes {1} instead of {2}.</source>
        <translation>{0}-teljest saab {1}, mitte {2}.</translation>
    </message>
    <message>
        <source>There is no preview of {0} triangles and points.</source>
        <translation>Eelvaadet ei ole, kui kolmnurkade ja punktide arv on {0}.</translation>
    </message>
    <message>
        <source>There is no scene “{0}”, only {1} or {2}; a mesh file needs its ending.</source>
        <translation>Stseeni „{0}“ ei ole, on ainult {1} või {2}; võrgufail vajab oma laiendit.</translation>
    </message>
    <message>
        <source>There is no scene “{0}”, only {1} or {2}; did you mean “{3}”?</source>
        <translation>Stseeni „{0}“ ei ole, on ainult {1} või {2}; kas mõtlesite „{3}“?</translation>
    </message>
    <message>
        <source>This is 1 divided by the right number.</source>
        <translation>See on 1 jagatud õige arvuga.</translation>
    </message>
    <message>
        <source>asks for a part that {0} does not have</source>
        <translation>küsib osa, mida {0} ei sisalda</translation>
    </message>
    <message>
        <source>begins a block that is not closed: a line ``` must end it</source>
        <translation>alustab plokki, mis jääb sulgemata: selle peab lõpetama rida ```</translation>
    </message>
    <message>
        <source>begins a block that is not closed: a line ``` must end it, above line {0}, where another begins</source>
        <translation>alustab plokki, mis jääb sulgemata: selle peab lõpetama rida ```, enne rida {0}, kus algab uus</translation>
    </message>
    <message>
        <source>begins a block, but is indented: ``` must begin the line</source>
        <translation>alustab plokki, aga on taandega: ``` peab olema rea alguses</translation>
    </message>
    <message>
        <source>begins a formula with $ that no other $ on its line ends</source>
        <translation>alustab märgiga $ valemit, mida ükski teine $ samal real ei lõpeta</translation>
    </message>
    <message>
        <source>begins code that is not closed: there is one ``` line too many, or one without its kind</source>
        <translation>alustab koodi, mis jääb sulgemata: üks rida ``` on üleliigne või ilma liigita</translation>
    </message>
    <message>
        <source>begins code, not a block, and the block of line {0} is in it: there is one ``` line too many, or one without its kind</source>
        <translation>alustab koodi, mitte plokki, ja real {0} algav plokk jääb selle sisse: üks rida ``` on üleliigne või ilma liigita</translation>
    </message>
    <message>
        <source>belongs to another lens: set lens.kind as well ({0})</source>
        <translation>kuulub teise objektiivi juurde: seadke ka lens.kind ({0})</translation>
    </message>
    <message>
        <source>belongs to another scene: set scene as well ({0})</source>
        <translation>kuulub teise stseeni juurde: seadke ka scene ({0})</translation>
    </message>
    <message>
        <source>can be read as {0} numbers with decimal commas or as {1} numbers: write decimal points</source>
        <translation>võib lugeda nii, et kümnendkomaga arve on {0}, või nii, et arve on {1}: kasutage kümnendpunkti</translation>
    </message>
    <message>
        <source>cannot be moved in the scene {0}, whose objects are fixed</source>
        <translation>ei saa stseenis {0} liigutada, sest selle objektid on liikumatud</translation>
    </message>
    <message>
        <source>cannot be read: {0}</source>
        <translation>ei saa lugeda: {0}</translation>
    </message>
    <message>
        <source>cannot be set together with {0}, which it replaces</source>
        <translation>ei saa seada koos nimega {0}, mille see asendab</translation>
    </message>
    <message>
        <source>cannot be set together with {0}: both decide what the lens sees</source>
        <translation>ei saa seada koos nimega {0}: mõlemad määravad, mida objektiiv näeb</translation>
    </message>
    <message>
        <source>cannot be shown in the scene {0}, which needs its own objects</source>
        <translation>ei saa näidata stseenis {0}, mis vajab oma objekte</translation>
    </message>
    <message>
        <source>cannot be shown: {0}</source>
        <translation>ei saa näidata: {0}</translation>
    </message>
    <message>
        <source>cannot be told from the wrong value of line {0}, {1}</source>
        <translation>ei saa eristada valest väärtusest real {0}, {1}</translation>
    </message>
    <message>
        <source>cannot be written as NAME=VALUE alone</source>
        <translation>ei saa kirjutada ainult kujul NAME=VALUE</translation>
    </message>
    <message>
        <source>cannot be written: another program may be writing it</source>
        <translation>ei saa kirjutada: võib-olla kirjutab seda mõni teine programm</translation>
    </message>
    <message>
        <source>cannot be written: it is a pipe or a device, not a regular file</source>
        <translation>ei saa kirjutada: see on toru või seade, mitte tavaline fail</translation>
    </message>
    <message>
        <source>cannot be written: it is write-protected</source>
        <translation>ei saa kirjutada: see on kirjutuskaitsega</translation>
    </message>
    <message>
        <source>cannot be written: {0}</source>
        <translation>ei saa kirjutada: {0}</translation>
    </message>
    <message>
        <source>cannot be written: {0} says “{1}”</source>
        <translation>ei saa kirjutada: {0} ütleb „{1}“</translation>
    </message>
    <message>
        <source>cloud: must have 1 to {1} points, and {0} were given.</source>
        <translation>cloud: punktide arv peab olema 1 kuni {1}, aga anti {0}.</translation>
    </message>
    <message>
        <source>comes with the program and cannot be changed: copy it, and open the copy</source>
        <translation>kuulub programmi juurde ja seda ei saa muuta: kopeerige see ja avage koopia</translation>
    </message>
    <message>
        <source>counts something, but its value is {0}</source>
        <translation>loendab midagi, aga selle väärtus on {0}</translation>
    </message>
    <message>
        <source>divides by zero</source>
        <translation>jagab nulliga</translation>
    </message>
    <message>
        <source>does not exist</source>
        <translation>ei ole olemas</translation>
    </message>
    <message>
        <source>does not fulfil the task</source>
        <translation>ei täida ülesannet</translation>
    </message>
    <message>
        <source>does not hold</source>
        <translation>ei kehti</translation>
    </message>
    <message>
        <source>ease = log: {0} has no equal ratios from {1} to {2}; choose linear.</source>
        <translation>ease = log: {0} ei muutu arvust {1} arvuni {2} võrdsete suhetega; valige linear.</translation>
    </message>
    <message>
        <source>finds no numbers that suit, for seed {0}; the last ones were refused: {1}</source>
        <translation>ei leia sobivaid arve, seemnearv {0}; viimased lükati tagasi: {1}</translation>
    </message>
    <message>
        <source>fps = {0}: must be from 1 to {1}.</source>
        <translation>fps = {0}: peab olema 1 kuni {1}.</translation>
    </message>
    <message>
        <source>frames = {0}: must be a whole number from 2 to {1}.</source>
        <translation>frames = {0}: peab olema täisarv 2 kuni {1}.</translation>
    </message>
    <message>
        <source>frames = {0}: must be even to go back and forth.</source>
        <translation>frames = {0}: edasi-tagasi minekuks peab olema paarisarv.</translation>
    </message>
    <message>
        <source>gets “{0}” instead of “{1}”</source>
        <translation>saab „{0}“, mitte „{1}“</translation>
    </message>
    <message>
        <source>gets “{0}” instead of “{1}”; this variant has {2}</source>
        <translation>saab „{0}“, mitte „{1}“; selle variandi arvud: {2}</translation>
    </message>
    <message>
        <source>gives the answer in a second way: keep one of {0}</source>
        <translation>annab vastuse teist moodi: jätke alles üks nendest: {0}</translation>
    </message>
    <message>
        <source>has a formula that only an exercise writes in</source>
        <translation>sisaldab valemit, mille kirjutab sisse ainult „exercise“</translation>
    </message>
    <message>
        <source>has HTML, which a lesson shows as it is typed</source>
        <translation>sisaldab HTML-i, mida õppetund näitab nii, nagu see on kirjutatud</translation>
    </message>
    <message>
        <source>has “{0}:”, which belongs to {1} only</source>
        <translation>sisaldab võtit „{0}:“, mis käib ainult koos järgmistega: {1}</translation>
    </message>
    <message>
        <source>has a CAMERA_ID that is not in cameras.txt</source>
        <translation>sisaldab väärtust CAMERA_ID, mida failis cameras.txt ei ole</translation>
    </message>
    <message>
        <source>has a formula that cannot be typeset: {0}</source>
        <translation>sisaldab valemit, mida ei saa laduda: {0}</translation>
    </message>
    <message>
        <source>has a function that is not defined for its argument</source>
        <translation>sisaldab funktsiooni, mis ei ole oma argumendi jaoks määratud</translation>
    </message>
    <message>
        <source>has a note of {0} words; the limit is {1}</source>
        <translation>sisaldab märkmeid, mille sõnade arv on {0}; piir on {1}</translation>
    </message>
    <message>
        <source>has a picture or a link, which a lesson shows as it is typed</source>
        <translation>sisaldab pilti või linki, mida õppetund näitab nii, nagu see on kirjutatud</translation>
    </message>
    <message>
        <source>has a power with a degree above {0} (character {1})</source>
        <translation>sisaldab astet, mille astendaja on suurem kui {0} (märk {1})</translation>
    </message>
    <message>
        <source>has a value that is too large; the limit is {0}</source>
        <translation>sisaldab liiga suurt väärtust; piir on {0}</translation>
    </message>
    <message>
        <source>has an answer that the scene shows as “{0}”: add “hide: numbers”</source>
        <translation>vastust näitab stseen nimega „{0}“: lisage „hide: numbers“</translation>
    </message>
    <message>
        <source>has an unknown kind of block, {0}; the nearest is {1}</source>
        <translation>sisaldab tundmatut liiki plokki, {0}; lähim on {1}</translation>
    </message>
    <message>
        <source>has faces that cross each other in too many places for a figure without pixels: write it as .png</source>
        <translation>sisaldab tahke, mis lõikuvad pikslita joonise jaoks liiga paljudes kohtades: kirjutage see .png-failina</translation>
    </message>
    <message>
        <source>has more than {0} answers</source>
        <translation>vastuste arv on suurem kui {0}</translation>
    </message>
    <message>
        <source>has more than {0} levels of brackets</source>
        <translation>sulgude tasemeid on rohkem kui {0}</translation>
    </message>
    <message>
        <source>has more than {0} nested brackets (character {1})</source>
        <translation>üksteise sees on sulge rohkem kui {0} (märk {1})</translation>
    </message>
    <message>
        <source>has more than {0} steps</source>
        <translation>sammude arv on suurem kui {0}</translation>
    </message>
    <message>
        <source>has more than {0} values</source>
        <translation>väärtuste arv on suurem kui {0}</translation>
    </message>
    <message>
        <source>has no camera: no camera_matrix, K or fx, and no frame</source>
        <translation>kaamerat ei ole: ei ole camera_matrix, K ega fx ning ei ole kaadrit</translation>
    </message>
    <message>
        <source>has no steps</source>
        <translation>samme ei ole</translation>
    </message>
    <message>
        <source>has no strokes as Frustum Lab writes them</source>
        <translation>ei ole jooni kujul, nagu Frustum Lab neid kirjutab</translation>
    </message>
    <message>
        <source>has no value in this state, which has no {0}</source>
        <translation>ei ole selles olekus väärtust, sest puudub {0}</translation>
    </message>
    <message>
        <source>has no value, because infinity minus infinity or infinity times 0 is no number</source>
        <translation>ei ole väärtust, sest lõpmatus miinus lõpmatus ja lõpmatus korda 0 ei ole arv</translation>
    </message>
    <message>
        <source>has the place ({0}), which is not in the picture</source>
        <translation>koht on ({0}), mida pildil ei ole</translation>
    </message>
    <message>
        <source>has the title of a step, but no line --- above it</source>
        <translation>on sammu pealkiri, aga selle kohal ei ole rida ---</translation>
    </message>
    <message>
        <source>has tiles that do the same in every order</source>
        <translation>sisaldab lülisid, mis teevad igas järjekorras sama</translation>
    </message>
    <message>
        <source>has too few variants, about {0}; it needs at least {1}</source>
        <translation>variante on liiga vähe, umbes {0}; vaja on vähemalt {1}</translation>
    </message>
    <message>
        <source>has unreadable lines ({0}), which are left out</source>
        <translation>on loetamatuid ridu ({0}), mis jäetakse välja</translation>
    </message>
    <message>
        <source>has {0} characters, with the indented lines below; the limit is {1}</source>
        <translation>märkide arv koos allpool olevate taandega ridadega on {0}; piir on {1}</translation>
    </message>
    <message>
        <source>has {0} characters; the limit is {1}</source>
        <translation>märkide arv on {0}; piir on {1}</translation>
    </message>
    <message>
        <source>has {0} faces, lines and points in a pane; the limit of a figure without pixels is {1}: write it as .png</source>
        <translation>tahkude, joonte ja punktide arv paanis on {0}; ilma piksliteta joonise piir on {1}: kirjutage see .png-failina</translation>
    </message>
    <message>
        <source>has {0} faces, lines and points in a pane; the limit of a figure without pixels is {1}: write {2}</source>
        <translation>tahkude, joonte ja punktide arv paanis on {0}; ilma piksliteta joonise piir on {1}: kirjutage {2}</translation>
    </message>
    <message>
        <source>has {0} twice</source>
        <translation>sisaldab kaks korda: {0}</translation>
    </message>
    <message>
        <source>has {0} values; the limit is {1}</source>
        <translation>väärtuste arv on {0}; piir on {1}</translation>
    </message>
    <message>
        <source>has {0} words in its step; the limit is {1}</source>
        <translation>sõnade arv sammus on {0}; piir on {1}</translation>
    </message>
    <message>
        <source>has {0} × {1} cells; the answer has {2} × {3}</source>
        <translation>lahtreid on {0} × {1}; vastuses on neid {2} × {3}</translation>
    </message>
    <message>
        <source>has {0}, which no formula may contain (character {1})</source>
        <translation>sisaldab {0}, mida ei tohi üheski valemis olla (märk {1})</translation>
    </message>
    <message>
        <source>has {0}, which no picture of the step can name</source>
        <translation>sisaldab {0}, mida ükski sammu pilt ei saa nimetada</translation>
    </message>
    <message>
        <source>height = {0} times scale {3}: must be from {1} to {2} pixels.</source>
        <translation>height = {0} korda scale {3}: peab olema {1} kuni {2} pikslit.</translation>
    </message>
    <message>
        <source>height = {0} {3}: must be from {1} to {2} {3}.</source>
        <translation>height = {0} {3}: peab olema {1} kuni {2} {3}.</translation>
    </message>
    <message>
        <source>height = {0}: must be a whole number of pixels from {1} to {2}.</source>
        <translation>height = {0}: peab olema pikslite täisarv {1} kuni {2}.</translation>
    </message>
    <message>
        <source>is a cloud of points of another kind ({0}): convert it to .ply; the command “project --points” reads a table of x, y, z</source>
        <translation>on teist liiki punktipilv ({0}): teisendage see .ply-failiks; käsk „project --points“ loeb x, y, z tabelit</translation>
    </message>
    <message>
        <source>is a document, and has no view {0}</source>
        <translation>on dokument ja vaadet {0} sellel ei ole</translation>
    </message>
    <message>
        <source>is a file of {0}, which is not read: export its cameras as COLMAP text, transforms.json or OpenCV&apos;s K, R, t</source>
        <translation>on programmi {0} fail, mida ei loeta: eksportige selle kaamerad COLMAPi tekstina, failina transforms.json või OpenCV K, R, t-na</translation>
    </message>
    <message>
        <source>is a folder, not a file</source>
        <translation>on kaust, mitte fail</translation>
    </message>
    <message>
        <source>is a lens with distortion, and here straight lines stay straight: undistort the pictures, and use the camera of the new ones</source>
        <translation>on moonutusega objektiiv, aga siin jäävad sirged sirgeks: eemaldage piltidelt moonutus ja kasutage uute piltide kaamerat</translation>
    </message>
    <message>
        <source>is a picture without a Frustum Lab document in it</source>
        <translation>on pilt, milles ei ole Frustum Labi dokumenti</translation>
    </message>
    <message>
        <source>is a skew of the pixels, which must be 0: the window of a lens is a rectangle</source>
        <translation>on pikslite kalle, mis peab olema 0: objektiivi aken on ristkülik</translation>
    </message>
    <message>
        <source>is a transposed K, with cx and cy in the last row: swap rows and columns</source>
        <translation>on transponeeritud K, kus cx ja cy on viimases reas: vahetage read ja veerud</translation>
    </message>
    <message>
        <source>is a wrong idea, but stands at the right choice</source>
        <translation>on väärarusaam, aga seisab õige valiku juures</translation>
    </message>
    <message>
        <source>is at infinity, so it is a direction and not a point</source>
        <translation>on lõpmatuses, seega on see suund ja mitte punkt</translation>
    </message>
    <message>
        <source>is binary: write text with colmap model_converter --input_path IN --output_path OUT --output_type TXT</source>
        <translation>on binaarne: kirjutage tekst käsuga colmap model_converter --input_path IN --output_path OUT --output_type TXT</translation>
    </message>
    <message>
        <source>is broken or cut short: the text from line {0}, column {1} on is not JSON</source>
        <translation>on vigane või katkenud: tekst alates reast {0}, veerust {1} ei ole JSON</translation>
    </message>
    <message>
        <source>is damaged, and cannot be renamed: {0}</source>
        <translation>on kahjustatud ja seda ei saa ümber nimetada: {0}</translation>
    </message>
    <message>
        <source>is done before the student does anything</source>
        <translation>on täidetud, enne kui õppija midagi teeb</translation>
    </message>
    <message>
        <source>is empty</source>
        <translation>on tühi</translation>
    </message>
    <message>
        <source>is given twice</source>
        <translation>on antud kaks korda</translation>
    </message>
    <message>
        <source>is in pixels of an image whose size is not known, and which is not {0} x {1}: set image.width and image.height, or add image_width and image_height to the file</source>
        <translation>on pildi pikslites, mille suurus ei ole teada ega ole {0} x {1}: seadke image.width ja image.height või lisage faili image_width ja image_height</translation>
    </message>
    <message>
        <source>is indented, but belongs to nothing above it</source>
        <translation>on taandega, aga ei kuulu millegi ülalpool oleva juurde</translation>
    </message>
    <message>
        <source>is larger than {0}</source>
        <translation>on suurem kui {0}</translation>
    </message>
    <message>
        <source>is longer than {0} characters</source>
        <translation>on pikem kui {0} märki</translation>
    </message>
    <message>
        <source>is missing</source>
        <translation>puudub</translation>
    </message>
    <message>
        <source>is neither a document (.json), a lesson (.md), an exported picture (.png), a mesh ({0}) nor a camera file (.json, .yml, .xml, cameras.txt, images.txt)</source>
        <translation>ei ole dokument (.json), õppetund (.md), eksporditud pilt (.png), võrk ({0}) ega kaamerafail (.json, .yml, .xml, cameras.txt, images.txt)</translation>
    </message>
    <message>
        <source>is no perspective camera, and is not read</source>
        <translation>ei ole perspektiivne kaamera ja seda ei loeta</translation>
    </message>
    <message>
        <source>is not UTF-8 text, some letters may be wrong: save the file in that encoding</source>
        <translation>ei ole UTF-8 tekst, mõni täht võib olla vale: salvestage fail selles kodeeringus</translation>
    </message>
    <message>
        <source>is not XML as OpenCV writes it: {0}</source>
        <translation>ei ole XML, nagu OpenCV seda kirjutab: {0}</translation>
    </message>
    <message>
        <source>is not a Frustum Lab document</source>
        <translation>ei ole Frustum Labi dokument</translation>
    </message>
    <message>
        <source>is not a Frustum Lab document: it is not text</source>
        <translation>ei ole Frustum Labi dokument: see ei ole tekst</translation>
    </message>
    <message>
        <source>is not a complete PNG picture: it is damaged or cut short</source>
        <translation>ei ole terviklik PNG-pilt: see on kahjustatud või katkenud</translation>
    </message>
    <message>
        <source>is not a file of results of Frustum Lab</source>
        <translation>ei ole Frustum Labi tulemuste fail</translation>
    </message>
    <message>
        <source>is not a name that a file can have</source>
        <translation>ei ole nimi, mis failil olla saab</translation>
    </message>
    <message>
        <source>is not in the picture that is printed</source>
        <translation>ei ole pildil, mis trükitakse</translation>
    </message>
    <message>
        <source>is not known; the nearest name is {0}</source>
        <translation>ei ole tuntud; lähim nimi on {0}</translation>
    </message>
    <message>
        <source>is shown as it is typed: the name of an idea stands at the end of a choice, one at each, in small letters</source>
        <translation>kuvatakse nii, nagu kirjutatud: väärarusaama nimi seisab valiku lõpus, igaühe juures üks, väiketähtedega</translation>
    </message>
    <message>
        <source>is step {0} of a lesson; the limit is {1}</source>
        <translation>on õppetunni samm {0}; piir on {1}</translation>
    </message>
    <message>
        <source>is step {0} with an exercise; the limit of a lesson is {1}</source>
        <translation>on ülesandega samm {0}; õppetunni piir on {1}</translation>
    </message>
    <message>
        <source>is the choice of line {0} again</source>
        <translation>kordab rea {0} valikut</translation>
    </message>
    <message>
        <source>is the letter of {0} already; two things cannot share one</source>
        <translation>on juba täht tähendusega {0}; kahel asjal ei saa olla ühte tähte</translation>
    </message>
    <message>
        <source>is the verdict of no sample in a “test”</source>
        <translation>ei ole ühegi „test“-ploki näidise otsus</translation>
    </message>
    <message>
        <source>is too close to {0} for a plane as far from the eye as near is</source>
        <translation>on arvule {0} liiga lähedal tasandi jaoks, mis on silmast sama kaugel kui lähitasand</translation>
    </message>
    <message>
        <source>is too close to {0} for float64 to tell the two apart</source>
        <translation>on väärtusele {0} liiga lähedal, et float64 neid eristaks</translation>
    </message>
    <message>
        <source>is too long for one page</source>
        <translation>on ühe lehekülje jaoks liiga pikk</translation>
    </message>
    <message>
        <source>is tried by no sample “{0}: ... -&gt; right”, so a wrong value would not be noticed</source>
        <translation>ei ole ühegi näidisega „{0}: ... -&gt; right“ proovitud, nii et vale väärtus jääks märkamata</translation>
    </message>
    <message>
        <source>is wrong, but has no reply: name a wrong idea, or add “says:” below</source>
        <translation>on vale, aga sellel ei ole vastust: nimetage väärarusaam või lisage alla „says:“</translation>
    </message>
    <message>
        <source>is wrong, but holds in the right state</source>
        <translation>on vale, aga kehtib õiges olekus</translation>
    </message>
    <message>
        <source>is wrong, but its formula gives the right value, {0}</source>
        <translation>on vale, aga selle valem annab õige väärtuse {0}</translation>
    </message>
    <message>
        <source>lacks a line --- above it, which ends the lines like “title: ...”</source>
        <translation>selle kohal puudub rida ---, mis lõpetab read nagu „title: ...“</translation>
    </message>
    <message>
        <source>lacks a line “title: ...”</source>
        <translation>puudub rida „title: ...“</translation>
    </message>
    <message>
        <source>mesh = {0}: the file has only lines or points, but the scene “{1}” needs a surface; open the file as a scene of its own.</source>
        <translation>mesh = {0}: failis on ainult jooned või punktid, aga stseen „{1}“ vajab pinda; avage fail omaette stseenina.</translation>
    </message>
    <message>
        <source>mesh = {1}: the scene “{0}” has a subject of its own, which no mesh can replace.</source>
        <translation>mesh = {1}: stseenil „{0}“ on oma motiiv, mida ükski võrk ei saa asendada.</translation>
    </message>
    <message>
        <source>must be #rrggbb, or red, green and blue, for all points or for each of {0}: whole numbers up to 255, or parts of 1</source>
        <translation>peab olema #rrggbb või punane, roheline ja sinine, kõigi punktide jaoks või igaühe jaoks ({0}): täisarvud kuni 255 või osad arvust 1</translation>
    </message>
    <message>
        <source>must be 0 or at least {0} in size</source>
        <translation>peab olema 0 või suuruselt vähemalt {0}</translation>
    </message>
    <message>
        <source>must be 16 numbers, or a calibrated camera&apos;s K: fx 0 cx, 0 fy cy, 0 0 1</source>
        <translation>peab olema 16 arvu või kalibreeritud kaamera K: fx 0 cx, 0 fy cy, 0 0 1</translation>
    </message>
    <message>
        <source>must be 9, 12 or 16 numbers, but has {0}</source>
        <translation>peab olema 9, 12 või 16 arvu, aga neid on {0}</translation>
    </message>
    <message>
        <source>must be NAME=VALUE, or document: FILE.json</source>
        <translation>peab olema NAME=VALUE või document: FILE.json</translation>
    </message>
    <message>
        <source>must be [SECTION], or NAME = &quot;LETTER&quot;, or begin with # as a comment</source>
        <translation>peab olema [SECTION] või NAME = &quot;LETTER&quot; või algama märgiga # nagu kommentaar</translation>
    </message>
    <message>
        <source>must be a Latin letter or word, or one of {0}, with an index after _ if it has one, such as x_min, and of at most {1} characters</source>
        <translation>peab olema ladina täht või sõna või üks järgmistest: {0}, koos indeksiga pärast märki _, kui see on, nagu x_min, ja ülimalt {1} märki</translation>
    </message>
    <message>
        <source>must be a condition: two formulas with =, !=, &lt;, &gt;, &lt;= or &gt;= between them, or NAME = WORD</source>
        <translation>peab olema tingimus: kaks valemit, mille vahel on =, !=, &lt;, &gt;, &lt;= või &gt;=, või NAME = WORD</translation>
    </message>
    <message>
        <source>must be a document or a projection, such as load({0})</source>
        <translation>peab olema dokument või projektsioon, näiteks load({0})</translation>
    </message>
    <message>
        <source>must be a file beside the lesson, or in a folder there</source>
        <translation>peab olema fail õppetunni kõrval või sealses kaustas</translation>
    </message>
    <message>
        <source>must be a finite number</source>
        <translation>peab olema lõplik arv</translation>
    </message>
    <message>
        <source>must be a finite number or inf</source>
        <translation>peab olema lõplik arv või inf</translation>
    </message>
    <message>
        <source>must be a list of 2 to {0} pictures, exactly one of them the document&apos;s own</source>
        <translation>peab olema loend 2 kuni {0} pildist, millest täpselt üks on dokumendi oma</translation>
    </message>
    <message>
        <source>must be a list of at most {0} different names, or only *</source>
        <translation>peab olema loend, milles on ülimalt {0} eri nime, või ainult *</translation>
    </message>
    <message>
        <source>must be a list of at most {0} names from {1}</source>
        <translation>peab olema loend, milles on ülimalt {0} nime järgmistest: {1}</translation>
    </message>
    <message>
        <source>must be a list of at most {0} names of values</source>
        <translation>peab olema loend, milles on ülimalt {0} väärtuse nime</translation>
    </message>
    <message>
        <source>must be a list of at most {0} probes</source>
        <translation>peab olema loend, milles on ülimalt {0} sondi</translation>
    </message>
    <message>
        <source>must be a list of names from {0}</source>
        <translation>peab olema loend nimedest, mis on {0}</translation>
    </message>
    <message>
        <source>must be a list of texts NAME=VALUE</source>
        <translation>peab olema loend tekstidest NAME=VALUE</translation>
    </message>
    <message>
        <source>must be a list of the numbers of probes</source>
        <translation>peab olema loend sondide numbritest</translation>
    </message>
    <message>
        <source>must be a matrix of finite numbers, but has {0}</source>
        <translation>peab olema lõplike arvude maatriks, aga selles on {0}</translation>
    </message>
    <message>
        <source>must be a matrix of numbers, but has {0}</source>
        <translation>peab olema arvude maatriks, aga selles on {0}</translation>
    </message>
    <message>
        <source>must be a name</source>
        <translation>peab olema nimi</translation>
    </message>
    <message>
        <source>must be a name of letters, digits and -</source>
        <translation>peab olema nimi tähtedest, numbritest ja märgist -</translation>
    </message>
    <message>
        <source>must be a number from {0} to {1}</source>
        <translation>peab olema arv {0} kuni {1}</translation>
    </message>
    <message>
        <source>must be a number like 0.5, 1/2, √3/2 or 2e-3; {0} cannot be read as part of one</source>
        <translation>peab olema arv nagu 0.5; 1/2; √3/2 või 2e-3; {0} ei ole loetav arvu osana</translation>
    </message>
    <message>
        <source>must be a number of at most {0} characters</source>
        <translation>peab olema arv, milles on ülimalt {0} märki</translation>
    </message>
    <message>
        <source>must be a number of points, such as 8 or 8pt</source>
        <translation>peab olema punktide arv, näiteks 8 või 8pt</translation>
    </message>
    <message>
        <source>must be a number of the model that can be set, and the answer; it is {0} here</source>
        <translation>peab olema mudeli arv, mida saab seada, ja vastus; siin on see {0}</translation>
    </message>
    <message>
        <source>must be a number whose power of ten is between -{0} and {0}</source>
        <translation>peab olema arv, mille kümne aste on -{0} ja {0} vahel</translation>
    </message>
    <message>
        <source>must be a number without {0}</source>
        <translation>peab olema arv, milles ei ole {0}</translation>
    </message>
    <message>
        <source>must be a number, or inf for ∞</source>
        <translation>peab olema arv, või inf märgi ∞ asemel</translation>
    </message>
    <message>
        <source>must be a number, such as 0.5 or 2e-3</source>
        <translation>peab olema arv, näiteks 0.5 või 2e-3</translation>
    </message>
    <message>
        <source>must be a number, such as {0}</source>
        <translation>peab olema arv, näiteks {0}</translation>
    </message>
    <message>
        <source>must be a number: a function has no value there</source>
        <translation>peab olema arv: funktsioonil ei ole seal väärtust</translation>
    </message>
    <message>
        <source>must be a number: nothing can be divided by 0</source>
        <translation>peab olema arv: 0-ga ei saa midagi jagada</translation>
    </message>
    <message>
        <source>must be a number; nothing is typed yet</source>
        <translation>peab olema arv; midagi ei ole veel sisestatud</translation>
    </message>
    <message>
        <source>must be a number; something is missing after {0}</source>
        <translation>peab olema arv; pärast {0} on midagi puudu</translation>
    </message>
    <message>
        <source>must be a number; {0} is neither a number nor a unit</source>
        <translation>peab olema arv; {0} ei ole arv ega ühik</translation>
    </message>
    <message>
        <source>must be a number; {0} may be {1} or {2}: write one of them</source>
        <translation>peab olema arv; {0} võib olla {1} või {2}: kirjutage üks neist</translation>
    </message>
    <message>
        <source>must be a number; {0} mixes degrees and radians</source>
        <translation>peab olema arv; {0} ajab kraadid ja radiaanid segamini</translation>
    </message>
    <message>
        <source>must be a range like 20..100 step 5, or numbers separated by commas</source>
        <translation>peab olema vahemik nagu 20..100 step 5 või komadega eraldatud arvud</translation>
    </message>
    <message>
        <source>must be a rotation: axes of length 1 at right angles, not mirrored</source>
        <translation>peab olema pööre: teljed pikkusega 1 täisnurga all, peegeldamata</translation>
    </message>
    <message>
        <source>must be a rotation: equally long axes at right angles, not mirrored</source>
        <translation>peab olema pööre: ühepikkused teljed täisnurga all, peegeldamata</translation>
    </message>
    <message>
        <source>must be a row and a column, separated by “,”</source>
        <translation>peab olema rida ja veerg, mille vahel on „,“</translation>
    </message>
    <message>
        <source>must be a sample like “NAME: SAMPLE -&gt; VERDICT”</source>
        <translation>peab olema näidis nagu „NAME: SAMPLE -&gt; VERDICT“</translation>
    </message>
    <message>
        <source>must be a text</source>
        <translation>peab olema tekst</translation>
    </message>
    <message>
        <source>must be a text or a list of some of {0}</source>
        <translation>peab olema tekst või loend mõnedest järgmistest: {0}</translation>
    </message>
    <message>
        <source>must be a type such as float64, to which numpy.asarray(points, float) converts</source>
        <translation>peab olema tüüp nagu float64, milleks numpy.asarray(points, float) teisendab</translation>
    </message>
    <message>
        <source>must be a value of settings, camera, lens, image, object or depth, as NAME=VALUE</source>
        <translation>peab olema rühma settings, camera, lens, image, object või depth väärtus kujul NAME=VALUE</translation>
    </message>
    <message>
        <source>must be a whole number</source>
        <translation>peab olema täisarv</translation>
    </message>
    <message>
        <source>must be a whole number from {0} to {1}</source>
        <translation>peab olema täisarv {0} kuni {1}</translation>
    </message>
    <message>
        <source>must be a whole number of pixels from 1 to {0}</source>
        <translation>peab olema pikslite täisarv 1 kuni {0}</translation>
    </message>
    <message>
        <source>must be a whole number, 1 or more</source>
        <translation>peab olema täisarv, 1 või rohkem</translation>
    </message>
    <message>
        <source>must be a whole number: the question asks for a count</source>
        <translation>peab olema täisarv: küsitakse, mitu neid on</translation>
    </message>
    <message>
        <source>must be an answer with its lesson, exercise and time</source>
        <translation>peab olema vastus koos õppetunni, ülesande ja ajaga</translation>
    </message>
    <message>
        <source>must be an object with named values in braces</source>
        <translation>peab olema objekt, milles on looksulgudes nimedega väärtused</translation>
    </message>
    <message>
        <source>must be at least {0}</source>
        <translation>peab olema vähemalt {0}</translation>
    </message>
    <message>
        <source>must be at least {0} away from the target</source>
        <translation>peab olema sihtpunktist vähemalt {0} kaugusel</translation>
    </message>
    <message>
        <source>must be at least {0} long</source>
        <translation>peab olema vähemalt {0} pikk</translation>
    </message>
    <message>
        <source>must be at most {0}</source>
        <translation>peab olema ülimalt {0}</translation>
    </message>
    <message>
        <source>must be axes of matplotlib, such as pyplot.gca()</source>
        <translation>peab olema matplotlibi axes, näiteks pyplot.gca()</translation>
    </message>
    <message>
        <source>must be followed by # and the number, up to {0}, or the name of a view: {1}</source>
        <translation>sellele peab järgnema # ja number, kuni {0}, või vaate nimi: {1}</translation>
    </message>
    <message>
        <source>must be four rows of four finite numbers</source>
        <translation>peab olema neli rida, igas neli lõplikku arvu</translation>
    </message>
    <message>
        <source>must be from {0} to {1} points</source>
        <translation>peab olema {0} kuni {1} punkti</translation>
    </message>
    <message>
        <source>must be fx, fy, cx, cy, or K: three rows fx, 0, cx and 0, fy, cy and 0, 0, 1</source>
        <translation>peab olema fx, fy, cx, cy või K: kolm rida fx, 0, cx ja 0, fy, cy ja 0, 0, 1</translation>
    </message>
    <message>
        <source>must be greater than 0; below 0 the image&apos;s x points left: take fx = {0} and cx = W - 1 - cx</source>
        <translation>peab olema suurem kui 0; alla 0 on pildi x suunatud vasakule: võtke fx = {0} ja cx = W - 1 - cx</translation>
    </message>
    <message>
        <source>must be greater than 0; below 0 the image&apos;s y points up: take fy = {0} and cy = H - 1 - cy</source>
        <translation>peab olema suurem kui 0; alla 0 on pildi y suunatud üles: võtke fy = {0} ja cy = H - 1 - cy</translation>
    </message>
    <message>
        <source>must be greater than bottom, which is {0}</source>
        <translation>peab olema suurem kui alumine, mis on {0}</translation>
    </message>
    <message>
        <source>must be greater than left, which is {0}</source>
        <translation>peab olema suurem kui vasak, mis on {0}</translation>
    </message>
    <message>
        <source>must be greater than near, which is {0}</source>
        <translation>peab olema suurem kui lähitasand, mis on {0}</translation>
    </message>
    <message>
        <source>must be greater than {0}</source>
        <translation>peab olema suurem kui {0}</translation>
    </message>
    <message>
        <source>must be in pixels, but the four numbers are in widths and heights of the image: multiply fx and cx by {0}, fy and cy by {1}, then subtract 0.5 from cx and cy</source>
        <translation>peab olema pikslites, aga need neli arvu on pildi laiustes ja kõrgustes: korrutage fx ja cx arvuga {0}, fy ja cy arvuga {1} ning lahutage siis cx-st ja cy-st 0.5</translation>
    </message>
    <message>
        <source>must be in {0}</source>
        <translation>ühik peab olema {0}</translation>
    </message>
    <message>
        <source>must be increasing numbers from 0 to 1, one fewer than the compared pictures, or none for side by side</source>
        <translation>peab olema kasvavad arvud 0 kuni 1, üks vähem kui võrreldavaid pilte, või mitte ühtegi, kui pildid on kõrvuti</translation>
    </message>
    <message>
        <source>must be left out where there is no cloud</source>
        <translation>tuleb ära jätta, kui cloud puudub</translation>
    </message>
    <message>
        <source>must be left out where width is given, which crops the figure</source>
        <translation>tuleb ära jätta, kui on antud width, mis kärbib joonise</translation>
    </message>
    <message>
        <source>must be less than far, which is {0}</source>
        <translation>peab olema väiksem kui kaugtasand, mis on {0}</translation>
    </message>
    <message>
        <source>must be less than right, which is {0}</source>
        <translation>peab olema väiksem kui parem, mis on {0}</translation>
    </message>
    <message>
        <source>must be less than top, which is {0}</source>
        <translation>peab olema väiksem kui ülemine, mis on {0}</translation>
    </message>
    <message>
        <source>must be of the type {0}</source>
        <translation>peab olema tüüpi {0}</translation>
    </message>
    <message>
        <source>must be one line of at most {0} characters</source>
        <translation>peab olema üks rida, milles on ülimalt {0} märki</translation>
    </message>
    <message>
        <source>must be one line of text</source>
        <translation>peab olema üks rida teksti</translation>
    </message>
    <message>
        <source>must be one of the scene&apos;s own comparisons ({0}), or PATH=VALUE, with ; between the values of a picture, | between pictures, and NAME: before a picture that has a name</source>
        <translation>peab olema üks stseeni enda võrdlustest ({0}) või PATH=VALUE, kus pildi väärtuste vahel on ;, piltide vahel | ja pildi ees, millel on nimi, NAME:</translation>
    </message>
    <message>
        <source>must be one of {0}</source>
        <translation>peab olema üks järgmistest: {0}</translation>
    </message>
    <message>
        <source>must be one of {0}, a colon, and its value</source>
        <translation>peab olema üks järgmistest: {0}, siis koolon ja selle väärtus</translation>
    </message>
    <message>
        <source>must be one of {0}, or a file of letters beside the lesson, such as letters.toml</source>
        <translation>peab olema üks järgmistest: {0}, või tähtede fail õppetunni kõrval, näiteks letters.toml</translation>
    </message>
    <message>
        <source>must be one of {0}, or a file of letters of at most {1} characters</source>
        <translation>peab olema üks järgmistest: {0}, või tähtede fail, milles on ülimalt {1} märki</translation>
    </message>
    <message>
        <source>must be one of {0}, or a number from {1} to {2}</source>
        <translation>peab olema üks järgmistest: {0}, või arv {1} kuni {2}</translation>
    </message>
    <message>
        <source>must be one of {0}, or empty for none</source>
        <translation>peab olema üks järgmistest: {0}, või tühi, kui mitte ükski</translation>
    </message>
    <message>
        <source>must be one of {0}; the nearest is {1}</source>
        <translation>peab olema üks järgmistest: {0}; lähim on {1}</translation>
    </message>
    <message>
        <source>must be the document&apos;s own, {0}</source>
        <translation>peab olema dokumendi oma, {0}</translation>
    </message>
    <message>
        <source>must be the name of a file</source>
        <translation>peab olema faili nimi</translation>
    </message>
    <message>
        <source>must be the name of a scene or of a mesh file</source>
        <translation>peab olema stseeni või võrgufaili nimi</translation>
    </message>
    <message>
        <source>must be the number of a choice, from 1 to {0}</source>
        <translation>peab olema valiku number 1 kuni {0}</translation>
    </message>
    <message>
        <source>must be the numbers x, y, z of each point in turn</source>
        <translation>peab olema järgemööda iga punkti arvud x, y, z</translation>
    </message>
    <message>
        <source>must be the path of a mesh file ({0}), or empty for none</source>
        <translation>peab olema võrgufaili tee ({0}) või tühi, kui võrku ei ole</translation>
    </message>
    <message>
        <source>must be the text of one matrix, up to {0} characters long</source>
        <translation>peab olema ühe maatriksi tekst, pikkusega kuni {0} märki</translation>
    </message>
    <message>
        <source>must be three finite numbers x, y, z</source>
        <translation>peab olema kolm lõplikku arvu x, y, z</translation>
    </message>
    <message>
        <source>must be three numbers for a point, four with w, two for the ray of a pixel, or null for no probe</source>
        <translation>peab olema kolm arvu punkti jaoks, neli koos w-ga, kaks piksli kiire jaoks või null, kui sondi ei ole</translation>
    </message>
    <message>
        <source>must be three rows of four finite numbers</source>
        <translation>peab olema kolm rida, igas neli lõplikku arvu</translation>
    </message>
    <message>
        <source>must be three rows of three finite numbers</source>
        <translation>peab olema kolm rida, igas kolm lõplikku arvu</translation>
    </message>
    <message>
        <source>must be tiles such as translate 3,0,0 or rotate z 90</source>
        <translation>peab olema lülid, näiteks translate 3,0,0 või rotate z 90</translation>
    </message>
    <message>
        <source>must be topics from L1 to L27, separated by commas</source>
        <translation>peab olema teemad L1 kuni L27, eraldatud komadega</translation>
    </message>
    <message>
        <source>must be true or false</source>
        <translation>peab olema true või false</translation>
    </message>
    <message>
        <source>must be two numbers of pixels, width and height</source>
        <translation>peab olema kaks pikslite arvu, laius ja kõrgus</translation>
    </message>
    <message>
        <source>must be world or ndc with the pane&apos;s eye, or its eye and its target, as in world: 6,4,8 or ndc: 1.3,0.2,0.3,0,0,0; a | separates the two panes (what a class sees is view.slide)</source>
        <translation>peab olema world või ndc koos paani silmaga või silma ja sihtpunktiga, nagu world: 6,4,8 või ndc: 1.3,0.2,0.3,0,0,0; kaht paani eraldab | (mida klass näeb, on view.slide)</translation>
    </message>
    <message>
        <source>must be written as NAME=VALUE</source>
        <translation>peab olema kirjutatud kujul NAME=VALUE</translation>
    </message>
    <message>
        <source>must be {0} coordinates, separated by spaces</source>
        <translation>peab olema {0} koordinaati, eraldatud tühikutega</translation>
    </message>
    <message>
        <source>must be {0} finite numbers</source>
        <translation>lõplike arvude arv peab olema {0}</translation>
    </message>
    <message>
        <source>must be {0} numbers, but has {1}</source>
        <translation>arvude arv peab olema {0}, aga on {1}</translation>
    </message>
    <message>
        <source>must begin a step with its title, like “# Title”</source>
        <translation>peab alustama sammu selle pealkirjaga, nagu „# Pealkiri“</translation>
    </message>
    <message>
        <source>must begin the lesson: ---, then lines like “title: ...”, then --- again</source>
        <translation>peab alustama õppetundi: ---, siis read nagu „title: ...“, siis jälle ---</translation>
    </message>
    <message>
        <source>must begin with a seed, a whole number from 1 to {0}</source>
        <translation>peab algama seemnearvuga, mis on täisarv 1 kuni {0}</translation>
    </message>
    <message>
        <source>must begin with “- [x]” if it is right, else “- [ ]”</source>
        <translation>peab algama märkidega „- [x]“, kui see on õige, muidu „- [ ]“</translation>
    </message>
    <message>
        <source>must differ from the eye, or the camera looks nowhere</source>
        <translation>peab silmast erinema, muidu ei vaata kaamera kuhugi</translation>
    </message>
    <message>
        <source>must differ from the target, or the camera looks nowhere</source>
        <translation>peab sihtpunktist erinema, muidu ei vaata kaamera kuhugi</translation>
    </message>
    <message>
        <source>must end in {0}, the numbers of a point</source>
        <translation>lõpus peab olema {0}, punkti arvud</translation>
    </message>
    <message>
        <source>must have 0, 0, 0, 1 in its last row: no move of an object changes w</source>
        <translation>viimases reas peab olema 0, 0, 0, 1: ükski objekti liigutus ei muuda w-d</translation>
    </message>
    <message>
        <source>must have 1 to {0} rows, separated by “;”, each with the same number of cells, 1 to {0}, separated by “,”; and at least two cells</source>
        <translation>peab olema 1 kuni {0} rida, eraldatud märgiga „;“, igas sama palju lahtreid, 1 kuni {0}, eraldatud märgiga „,“; ja vähemalt kaks lahtrit</translation>
    </message>
    <message>
        <source>must have a left 3 x 3 block with an inverse: the camera is at infinity, as a parallel one is</source>
        <translation>vasakpoolsel 3 x 3 plokil peab olema pöördmaatriks: kaamera on lõpmatuses, nagu paralleelne kaamera</translation>
    </message>
    <message>
        <source>must have a product with numbers up to {0} only</source>
        <translation>korrutise arvud tohivad olla ainult kuni {0}</translation>
    </message>
    <message>
        <source>must have a result whose formulas have at most {0} characters, or end in {1}</source>
        <translation>tulemuse valemites tohib olla ülimalt {0} märki, või lõpp peab olema {1}</translation>
    </message>
    <message>
        <source>must have an inverse whose numbers and products float64 can hold</source>
        <translation>peab olema pöördmaatriks, mille arve ja korrutisi float64 suudab hoida</translation>
    </message>
    <message>
        <source>must have an inverse, but its rank is {0}</source>
        <translation>peab olema pöördmaatriks, aga astak on {0}</translation>
    </message>
    <message>
        <source>must have at most {0} tiles, but has {1}</source>
        <translation>lülisid tohib olla ülimalt {0}, aga neid on {1}</translation>
    </message>
    <message>
        <source>must have equally many numbers in every row</source>
        <translation>igas reas peab olema sama palju arve</translation>
    </message>
    <message>
        <source>must have finite numbers after {1}, {0} in all</source>
        <translation>pärast {1} peab lõplikke arve olema kokku {0}</translation>
    </message>
    <message>
        <source>must have finite real numbers only</source>
        <translation>peab sisaldama ainult lõplikke reaalarve</translation>
    </message>
    <message>
        <source>must have no masked number</source>
        <translation>maskitud arve ei tohi olla</translation>
    </message>
    <message>
        <source>must have no number after {0}</source>
        <translation>pärast {0} ei tohi olla arvu</translation>
    </message>
    <message>
        <source>must have numbers up to {0} in size only</source>
        <translation>arvud tohivad olla suuruselt ainult kuni {0}</translation>
    </message>
    <message>
        <source>must have the product that the state shows, which is another {0}</source>
        <translation>peab andma sama korrutise, mida näitab olek: seal on {0} teistsugune</translation>
    </message>
    <message>
        <source>must be 0, 0, 0, 1, the last row of a pose: perhaps rows and columns are exchanged</source>
        <translation>peab olema 0, 0, 0, 1, asendi viimane rida: võib-olla on read ja veerud vahetuses</translation>
    </message>
    <message>
        <source>must have three numbers for each rotation, which has three or nine</source>
        <translation>igal pöördel peab olema kolm arvu; pöördel on neid kolm või üheksa</translation>
    </message>
    <message>
        <source>must have {0} coordinates, separated by “,”</source>
        <translation>koordinaatide arv peab olema {0}, eraldatud märgiga „,“</translation>
    </message>
    <message>
        <source>must have {0} significant digits in front of “...”</source>
        <translation>märkide „...“ ees peab tüvenumbreid olema: {0}</translation>
    </message>
    <message>
        <source>must have {0} × {1} cells: “;” separates rows, “|” the cells of a row</source>
        <translation>peab olema {0} × {1} lahtrit: „;“ eraldab ridu, „|“ rea lahtreid</translation>
    </message>
    <message>
        <source>must lie above the plane y = {0}: a light on the plane or under it casts no shadow there</source>
        <translation>peab olema tasandist y = {0} kõrgemal: valgus tasandil või selle all ei heida sinna varju</translation>
    </message>
    <message>
        <source>must lie between {0} and {1}, both excluded</source>
        <translation>peab olema {0} ja {1} vahel, otspunktid välja arvatud</translation>
    </message>
    <message>
        <source>must name 1 to {0} matrices, such as {1}</source>
        <translation>peab nimetama 1 kuni {0} maatriksit, näiteks {1}</translation>
    </message>
    <message>
        <source>must name matrices such as {0}; this lens has no matrix {1}</source>
        <translation>peab nimetama maatrikseid nagu {0}; sellel objektiivil ei ole maatriksit {1}</translation>
    </message>
    <message>
        <source>must name matrices that one lecture has together</source>
        <translation>peab nimetama maatrikseid, mis on ühes loengus koos</translation>
    </message>
    <message>
        <source>must not be 0 if x, y and z are 0: (0, 0, 0, 0) is neither a point nor a direction</source>
        <translation>ei tohi olla 0, kui x, y ja z on 0: (0, 0, 0, 0) ei ole punkt ega suund</translation>
    </message>
    <message>
        <source>must not be 0: the plane would go through the eye, where nothing is cut</source>
        <translation>ei tohi olla 0: tasand läbiks silma, kus midagi ei lõigata</translation>
    </message>
    <message>
        <source>must not be before the near plane ({0})</source>
        <translation>ei tohi olla lähitasandi ees ({0})</translation>
    </message>
    <message>
        <source>must not be parallel to the view direction</source>
        <translation>ei tohi olla vaate suunaga paralleelne</translation>
    </message>
    <message>
        <source>must not be the zero vector</source>
        <translation>ei tohi olla nullvektor</translation>
    </message>
    <message>
        <source>must point upward, to the sun: otherwise its rays never meet the plane</source>
        <translation>peab olema suunatud üles, päikese poole: muidu ei kohta selle kiired kunagi tasandit</translation>
    </message>
    <message>
        <source>names an unknown wrong idea (the nearest is {0}), and has no “says:” of its own</source>
        <translation>nimetab tundmatut väärarusaama (lähim on {0}) ja sellel ei ole oma „says:“</translation>
    </message>
    <message>
        <source>needs 2 to {0} choices, just one of them right: “- [x]”, the others “- [ ]”</source>
        <translation>vajab 2 kuni {0} valikut, millest õige on vaid üks: „- [x]“, ülejäänud „- [ ]“</translation>
    </message>
    <message>
        <source>needs a closing bracket instead of {0} (character {1})</source>
        <translation>vajab lõpetavat sulgu, mitte {0} (märk {1})</translation>
    </message>
    <message>
        <source>needs a number, a letter or a bracket instead of {0} (character {1})</source>
        <translation>vajab arvu, tähte või sulgu, mitte {0} (märk {1})</translation>
    </message>
    <message>
        <source>needs a sign such as + or * in front of {0} (character {1})</source>
        <translation>vajab märki nagu + või * enne {0} (märk {1})</translation>
    </message>
    <message>
        <source>needs a whole number as its power instead of {0} (character {1})</source>
        <translation>vajab astendajaks täisarvu, mitte {0} (märk {1})</translation>
    </message>
    <message>
        <source>needs lens.sensor_width_mm or lens.sensor_height_mm; the one that compares with 36 x 24 mm is lens.focal_length_mm</source>
        <translation>vajab väärtust lens.sensor_width_mm või lens.sensor_height_mm; 36 x 24 mm-ga võrreldav on lens.focal_length_mm</translation>
    </message>
    <message>
        <source>needs the program {0}, which is not on the PATH: write .webp instead</source>
        <translation>vajab programmi {0}, mida PATH-is ei ole: kirjutage selle asemel .webp</translation>
    </message>
    <message>
        <source>needs {0}</source>
        <translation>vaja on {0}</translation>
    </message>
    <message>
        <source>needs {0} among its tiles</source>
        <translation>vajab oma lülide hulka ka {0}</translation>
    </message>
    <message>
        <source>pane = {0}: must be one of {1}.</source>
        <translation>pane = {0}: peab olema üks järgmistest: {1}.</translation>
    </message>
    <message>
        <source>panes = {0}: must name at least one of {1}.</source>
        <translation>panes = {0}: peab nimetama vähemalt ühe järgmistest: {1}.</translation>
    </message>
    <message>
        <source>plotter() needs the package pyvista: pip install pyvista.</source>
        <translation>plotter() vajab paketti pyvista: pip install pyvista.</translation>
    </message>
    <message>
        <source>points: at most {0} can be marked, and {1} were given.</source>
        <translation>points: märkida saab ülimalt {0}, aga anti {1}.</translation>
    </message>
    <message>
        <source>repeats the name of line {0}; each needs its own</source>
        <translation>kordab nime realt {0}; igaüks vajab oma nime</translation>
    </message>
    <message>
        <source>says another number than its formula&apos;s value, {0}</source>
        <translation>ütleb teist arvu, kui on valemi väärtus {0}</translation>
    </message>
    <message>
        <source>scale = {0}: must be greater than 0 and at most {1}.</source>
        <translation>scale = {0}: peab olema suurem kui 0 ja ülimalt {1}.</translation>
    </message>
    <message>
        <source>size = {0}: must be WIDTHxHEIGHT in {1}, such as 120mmx80mm, or two numbers of pixels.</source>
        <translation>size = {0}: peab olema WIDTHxHEIGHT ühikutes {1}, näiteks 120mmx80mm, või kaks pikslite arvu.</translation>
    </message>
    <message>
        <source>sweep = {0}: must be NAME=FIRST:LAST with finite numbers, such as lens.near=0.5:8 or camera.eye=3,2,4:0,2,5.</source>
        <translation>sweep = {0}: peab olema NAME=FIRST:LAST lõplike arvudega, näiteks lens.near=0.5:8 või camera.eye=3,2,4:0,2,5.</translation>
    </message>
    <message>
        <source>sweep = {0}: {1} is swept already.</source>
        <translation>sweep = {0}: {1} juba muutub.</translation>
    </message>
    <message>
        <source>text size = {0}: must be from {1} to {2} points in panes of this size.</source>
        <translation>text size = {0}: selle suurusega paanides peab olema {1} kuni {2} punkti.</translation>
    </message>
    <message>
        <source>uses an unknown function or matrix, {0}; the nearest is {1}</source>
        <translation>kasutab tundmatut funktsiooni või maatriksit {0}; lähim on {1}</translation>
    </message>
    <message>
        <source>uses an unknown name, {0}; the nearest is {1}</source>
        <translation>kasutab tundmatut nime {0}; lähim on {1}</translation>
    </message>
    <message>
        <source>varies more than {0} numbers</source>
        <translation>muudab rohkem kui {0} arvu</translation>
    </message>
    <message>
        <source>varies {0} twice</source>
        <translation>muudab kaks korda: {0}</translation>
    </message>
    <message>
        <source>was damaged, and is kept as {0}</source>
        <translation>oli kahjustatud ja on alles nimega {0}</translation>
    </message>
    <message>
        <source>was written by a newer Frustum Lab: its version is {0}, the limit is {1}</source>
        <translation>on kirjutatud uuema Frustum Labiga: selle versioon on {0}, piir on {1}</translation>
    </message>
    <message>
        <source>was written by a newer Frustum Lab: its version is {0}, this program reads up to {1}</source>
        <translation>on kirjutatud uuema Frustum Labiga: selle versioon on {0}, see programm loeb kuni versioonini {1}</translation>
    </message>
    <message>
        <source>was written for a newer Frustum Lab, which reads version {0}; this one reads up to {1}</source>
        <translation>on kirjutatud uuema Frustum Labi jaoks, mis loeb versiooni {0}; see loeb kuni versioonini {1}</translation>
    </message>
    <message>
        <source>width = {0} mm: a line of this equation needs {1} mm in letters of {2} points.</source>
        <translation>width = {0} mm: selle võrrandi üks rida vajab {1} mm, kui tähtede suurus on {2} punkti.</translation>
    </message>
    <message>
        <source>width = {0} times scale {3}: must be from {1} to {2} pixels.</source>
        <translation>width = {0} korda scale {3}: peab olema {1} kuni {2} pikslit.</translation>
    </message>
    <message>
        <source>width = {0} {3}: must be from {1} to {2} {3}.</source>
        <translation>width = {0} {3}: peab olema {1} kuni {2} {3}.</translation>
    </message>
    <message>
        <source>width = {0}: must be a length in {1}, such as 84mm, or a number of pixels.</source>
        <translation>width = {0}: peab olema pikkus ühikutes {1}, näiteks 84mm, või pikslite arv.</translation>
    </message>
    <message>
        <source>width = {0}: must be a whole number of pixels from {1} to {2}.</source>
        <translation>width = {0}: peab olema pikslite täisarv {1} kuni {2}.</translation>
    </message>
    <message>
        <source>{0} of {1} numbers are right; the others are marked.</source>
        <translation>Õigeid arve on {0}, kokku {1}; ülejäänud on märgitud.</translation>
    </message>
    <message>
        <source>{0}, with {1}; “where: CONDITION” excludes numbers</source>
        <translation>{0}, kui {1}; „where: CONDITION“ jätab arve välja</translation>
    </message>
    <message>
        <source>{0}: TeX reads a picture beside it, whose name may have only letters from a to z, digits and . _ + = -.</source>
        <translation>{0}: TeX loeb selle kõrvalt pilti, mille nimes tohivad olla ainult tähed a kuni z, numbrid ja . _ + = -.</translation>
    </message>
    <message>
        <source>{0}: a face, line or point names a vertex that does not exist (there are {1}); export or download the file again.</source>
        <translation>{0}: mõni tahk, joon või punkt nimetab tippu, mida ei ole (neid on {1}); eksportige fail uuesti või laadige uuesti alla.</translation>
    </message>
    <message>
        <source>{0}: a mesh file must end in {1} or {2}; convert it to one of these.</source>
        <translation>{0}: võrgufaili lõpp peab olema {1} või {2}; teisendage see üheks nendest.</translation>
    </message>
    <message>
        <source>{0}: a vertex has the coordinate {1}, but it must be within ±{2}, 1e12 times the mesh&apos;s size; move the mesh to the origin.</source>
        <translation>{0}: mõne tipu koordinaat on {1}, aga see peab olema ±{2} piires, mis on 1e12 korda võrgu suurus; viige võrk alguspunkti.</translation>
    </message>
    <message>
        <source>{0}: all vertices are at one point, so there is nothing to see; check the export.</source>
        <translation>{0}: kõik tipud on ühes punktis, nii et midagi ei ole näha; kontrollige eksporti.</translation>
    </message>
    <message>
        <source>{0}: all vertices are on one line, so there is nothing to see; check the export.</source>
        <translation>{0}: kõik tipud on ühel sirgel, nii et midagi ei ole näha; kontrollige eksporti.</translation>
    </message>
    <message>
        <source>{0}: cannot be opened ({1}); check its name and its permissions.</source>
        <translation>{0}: ei saa avada ({1}); kontrollige selle nime ja õigusi.</translation>
    </message>
    <message>
        <source>{0}: faces left out: {1} of {2}, because they have fewer than three different corners; the first is number {3}.</source>
        <translation>{0}: välja jäetud tahke: {1}, kokku {2}, sest neil on vähem kui kolm eri nurka; esimese number on {3}.</translation>
    </message>
    <message>
        <source>{0}: faces left out: {1} of {2}, because they have fewer than three different corners; the first is on line {3}.</source>
        <translation>{0}: välja jäetud tahke: {1}, kokku {2}, sest neil on vähem kui kolm eri nurka; esimene on real {3}.</translation>
    </message>
    <message>
        <source>{0}: from line {1} on, it has more rows than its header counts; correct the header, or export the file again.</source>
        <translation>{0}: alates reast {1} on ridu rohkem, kui päis loendab; parandage päis või eksportige fail uuesti.</translation>
    </message>
    <message>
        <source>{0}: is a link, where a picture of the figure would be.</source>
        <translation>{0}: on link, aga seal oleks joonise pilt.</translation>
    </message>
    <message>
        <source>{0}: is damaged: {1}.</source>
        <translation>{0}: on kahjustatud: {1}.</translation>
    </message>
    <message>
        <source>{0}: is not a file of measurements.</source>
        <translation>{0}: ei ole mõõtmiste fail.</translation>
    </message>
    <message>
        <source>{0}: it cannot be read ({1}); export or download the file again.</source>
        <translation>{0}: seda ei saa lugeda ({1}); eksportige fail uuesti või laadige uuesti alla.</translation>
    </message>
    <message>
        <source>{0}: it uses “{1}”, which this program does not read; export it without that.</source>
        <translation>{0}: see kasutab võimalust „{1}“, mida see programm ei loe; eksportige fail ilma selleta.</translation>
    </message>
    <message>
        <source>{0}: it would grow to {1} triangles, lines and points and {2} MiB, but may have at most {3} and {4} MiB; make it smaller.</source>
        <translation>{0}: kolmnurkade, joonte ja punktide arv kasvaks arvuni {1} ja maht {2} MiB-ni, aga lubatud on ülimalt {3} ja {4} MiB; tehke see väiksemaks.</translation>
    </message>
    <message>
        <source>{0}: its faces are not divided into triangles within {1} s; give them fewer corners, or divide them before the export.</source>
        <translation>{0}: selle tahud ei jagune {1} s jooksul kolmnurkadeks; andke neile vähem nurki või jagage need enne eksporti.</translation>
    </message>
    <message>
        <source>{0}: its part {1} is not a readable file in the folder of the mesh; keep the files of a glTF mesh together.</source>
        <translation>{0}: selle osa {1} ei ole loetav fail võrgu kaustas; hoidke glTF-võrgu failid koos.</translation>
    </message>
    <message>
        <source>{0}: line {1} cannot be read as {2}; export or download the file again.</source>
        <translation>{0}: rida {1} ei saa lugeda kui {2}; eksportige fail uuesti või laadige uuesti alla.</translation>
    </message>
    <message>
        <source>{0}: line {1} has a vertex that is not finite (nan or inf), and line {2} uses it; repair the mesh and export it again.</source>
        <translation>{0}: real {1} on tipp, mis ei ole lõplik (nan või inf), ja rida {2} kasutab seda; parandage võrk ja eksportige uuesti.</translation>
    </message>
    <message>
        <source>{0}: line {1} names a vertex that does not exist (there are {2}); export or download the file again.</source>
        <translation>{0}: rida {1} nimetab tippu, mida ei ole (neid on {2}); eksportige fail uuesti või laadige uuesti alla.</translation>
    </message>
    <message>
        <source>{0}: must end in .svg, .pdf, .tex or .png.</source>
        <translation>{0}: lõpp peab olema .svg, .pdf, .tex või .png.</translation>
    </message>
    <message>
        <source>{0}: must end in one of {1}.</source>
        <translation>{0}: lõpp peab olema üks järgmistest: {1}.</translation>
    </message>
    <message>
        <source>{0}: some vertices are not finite (nan or inf: {1} of {2}); repair the mesh and export it again.</source>
        <translation>{0}: osa tippe ei ole lõplikud (nan või inf: {1}, kokku {2}); parandage võrk ja eksportige uuesti.</translation>
    </message>
    <message>
        <source>{0}: the content of the file is not {1}; check what kind of file it is.</source>
        <translation>{0}: faili sisu ei ole {1}; kontrollige, mis liiki fail see on.</translation>
    </message>
    <message>
        <source>{0}: the file has no faces (vertices: {1}), so there is no surface to draw; export the mesh with faces.</source>
        <translation>{0}: failis ei ole tahke (tippe: {1}), nii et joonistamiseks ei ole pinda; eksportige võrk koos tahkudega.</translation>
    </message>
    <message>
        <source>{0}: the file is cut off: it has {1} of {2} rows of “{3}”; export or download the file again.</source>
        <translation>{0}: fail on katkenud: ridu „{3}“ on {1}, kokku peaks olema {2}; eksportige fail uuesti või laadige uuesti alla.</translation>
    </message>
    <message>
        <source>{0}: the file is cut off: it has {1} of {2} triangles; export or download the file again.</source>
        <translation>{0}: fail on katkenud: kolmnurki on {1}, kokku peaks olema {2}; eksportige fail uuesti või laadige uuesti alla.</translation>
    </message>
    <message>
        <source>{0}: the file is cut off; export or download the file again.</source>
        <translation>{0}: fail on katkenud; eksportige fail uuesti või laadige uuesti alla.</translation>
    </message>
    <message>
        <source>{0}: the file is empty; save or download it again.</source>
        <translation>{0}: fail on tühi; salvestage see uuesti või laadige uuesti alla.</translation>
    </message>
    <message>
        <source>{0}: the number of a face&apos;s corners is {1}, but must be from 3 to {2}; divide or repair it.</source>
        <translation>{0}: ühe tahu nurkade arv on {1}, aga peab olema 3 kuni {2}; jagage või parandage see.</translation>
    </message>
    <message>
        <source>{0}: the process that reads it ended too early; make it smaller, or export or download the file again.</source>
        <translation>{0}: seda lugev protsess lõppes liiga vara; tehke fail väiksemaks, eksportige see uuesti või laadige uuesti alla.</translation>
    </message>
    <message>
        <source>{0}: the size of the mesh is {1} units, but must be between 1e-30 and 1e30; scale it.</source>
        <translation>{0}: võrgu suurus on {1} ühikut, aga peab olema 1e-30 ja 1e30 vahel; skaleerige see.</translation>
    </message>
    <message>
        <source>{0}: the window could not be shown whole.</source>
        <translation>{0}: akent ei saanud tervikuna näidata.</translation>
    </message>
    <message>
        <source>{0}: the window did not appear on the screen.</source>
        <translation>{0}: aken ei ilmunud ekraanile.</translation>
    </message>
    <message>
        <source>{0}: there is no such file; check its name and folder.</source>
        <translation>{0}: sellist faili ei ole; kontrollige selle nime ja kausta.</translation>
    </message>
    <message>
        <source>{0}: its description has {1} lists and objects, but may have at most {2}; make it smaller.</source>
        <translation>{0}: kirjelduses on {1} loendit ja objekti, aga lubatud on kõige rohkem {2}; tehke fail väiksemaks.</translation>
    </message>
    <message>
        <source>{0}: there is not enough memory to read it; make it smaller, or close other programs.</source>
        <translation>{0}: selle lugemiseks ei ole piisavalt mälu; tehke see väiksemaks või sulgege teisi programme.</translation>
    </message>
    <message>
        <source>{0}: vertices left out: {1} of {2}, because they are not finite (nan or inf) and no face or line uses them; the first is number {3}.</source>
        <translation>{0}: välja jäetud tippe: {1}, kokku {2}, sest need ei ole lõplikud (nan või inf) ja ükski tahk ega joon neid ei kasuta; esimese number on {3}.</translation>
    </message>
    <message>
        <source>{0}: vertices left out: {1} of {2}, because they are not finite (nan or inf) and no face or line uses them; the first is on line {3}.</source>
        <translation>{0}: välja jäetud tippe: {1}, kokku {2}, sest need ei ole lõplikud (nan või inf) ja ükski tahk ega joon neid ei kasuta; esimene on real {3}.</translation>
    </message>
    <message>
        <source>{0}: was measured by another Frustum Lab: its version is {1}, this one reads {2}.</source>
        <translation>{0}: on mõõdetud teise Frustum Labiga: selle versioon on {1}, see loeb versiooni {2}.</translation>
    </message>
    <message>
        <source>{0}: would have {1} MB; TeX&apos;s memory holds figures of {2} MB: write {3}.</source>
        <translation>{0}: oleks {1} MB; TeXi mällu mahuvad joonised suurusega {2} MB: kirjutage {3}.</translation>
    </message>
    <message>
        <source>{0}: {1}</source>
        <translation>{0}: {1}</translation>
    </message>
</context>
<context>
    <name>Row</name>
    <message>
        <source>Double-click the name to reset it.</source>
        <translation>Lähtestamiseks tehke nimel topeltklõps.</translation>
    </message>
    <message>
        <source>Reset {0}</source>
        <translation>Lähtesta {0}</translation>
    </message>
    <message>
        <source>Not possible.</source>
        <translation>Ei ole võimalik.</translation>
    </message>
</context>
<context>
    <name>Saving</name>
    <message>
        <source>{0} already exists.</source>
        <translation>{0} on juba olemas.</translation>
    </message>
    <message>
        <source>Overwrite it?</source>
        <translation>Kas kirjutada see üle?</translation>
    </message>
</context>
<context>
    <name>SceneCard</name>
    <message>
        <source>My mesh…</source>
        <translation>Minu võrk…</translation>
    </message>
    <message>
        <source>Replace the scene&apos;s own objects with a mesh from a file</source>
        <translation>Asendab stseeni oma objektid võrguga failist</translation>
    </message>
    <message>
        <source>My mesh</source>
        <translation>Minu võrk</translation>
    </message>
    <message>
        <source>Own objects</source>
        <translation>Oma objektid</translation>
    </message>
    <message>
        <source>Restore the scene&apos;s own objects</source>
        <translation>Toob tagasi stseeni oma objektid</translation>
    </message>
    <message>
        <source>Explanation…</source>
        <translation>Selgitus…</translation>
    </message>
    <message>
        <source>Show what the scene is about, its lectures and its diagrams, below the panes</source>
        <translation>Näitab paanide all, millest stseen räägib, selle loenguid ja diagramme</translation>
    </message>
    <message>
        <source>Explanation and diagrams</source>
        <translation>Selgitus ja diagrammid</translation>
    </message>
    <message>
        <source>none of these</source>
        <translation>mitte ükski neist</translation>
    </message>
    <message>
        <source>Compare: {0}</source>
        <translation>Võrdle: {0}</translation>
    </message>
    <message>
        <source>Show these pictures side by side, enlarged</source>
        <translation>Näitab neid pilte kõrvuti, suurendatult</translation>
    </message>
    <message>
        <source>Diagrams…</source>
        <translation>Diagrammid…</translation>
    </message>
    <message>
        <source>The lens does not have this value: choose one of the above first.</source>
        <translation>Objektiivil ei ole seda väärtust: valige enne üks ülalpool olevatest.</translation>
    </message>
    <message>
        <source>Only with “{0}” switched on.</source>
        <translation>Ainult siis, kui „{0}“ on sisse lülitatud.</translation>
    </message>
    <message>
        <source>Only with “{0}”: {1}.</source>
        <translation>Ainult koos valikuga „{0}“: {1}.</translation>
    </message>
</context>
<context>
    <name>ScenePanel</name>
    <message>
        <source>Diagrams</source>
        <translation>Diagrammid</translation>
    </message>
    <message>
        <source>What this scene shows</source>
        <translation>Mida see stseen näitab</translation>
    </message>
    <message>
        <source>Lectures: {0}</source>
        <translation>Loengud: {0}</translation>
    </message>
</context>
<context>
    <name>SearchBox</name>
    <message>
        <source>Find a control</source>
        <translation>Otsi juhtelementi</translation>
    </message>
    <message>
        <source>Shows the controls with this name, also folded ones; Enter goes to the first, Esc shows all again (Ctrl+F)</source>
        <translation>Näitab sellenimelisi juhtelemente, ka peidetuid; Enter läheb esimese juurde, Esc näitab jälle kõiki (Ctrl+F)</translation>
    </message>
</context>
<context>
    <name>Section</name>
    <message>
        <source>Fold</source>
        <translation>Voldi kokku</translation>
    </message>
    <message>
        <source>Unfold</source>
        <translation>Voldi lahti</translation>
    </message>
    <message>
        <source>unfolded</source>
        <translation>lahti volditud</translation>
    </message>
    <message>
        <source>folded</source>
        <translation>kokku volditud</translation>
    </message>
</context>
<context>
    <name>SelfTestDialog</name>
    <message>
        <source>Test yourself</source>
        <translation>Enesekontroll</translation>
    </message>
    <message>
        <source>The same topics and number give everyone the same test</source>
        <translation>Samad teemad ja number annavad kõigile sama testi</translation>
    </message>
    <message>
        <source>&amp;All topics</source>
        <translation>&amp;Kõik teemad</translation>
    </message>
    <message>
        <source>&amp;None</source>
        <translation>&amp;Mitte ükski</translation>
    </message>
    <message>
        <source>Up to {0} exercises. One try each, no hints, panels closed; give three significant digits. At the end you see all solutions.</source>
        <translation>Kuni {0} ülesannet. Igaühe jaoks üks katse, vihjeid ei ole, paneelid on suletud; vastake kolme tüvenumbriga. Lõpus näete kõiki lahendusi.</translation>
    </message>
    <message>
        <source>&amp;Begin</source>
        <translation>&amp;Alusta</translation>
    </message>
    <message>
        <source>Test number</source>
        <translation>Testi number</translation>
    </message>
    <message>
        <source>Choose topics.</source>
        <translation>Valige teemad.</translation>
    </message>
</context>
<context>
    <name>SelfTestMarks</name>
    <message>
        <source>{0} of {1} right</source>
        <translation>Õigeid: {0} / {1}</translation>
    </message>
    <message>
        <source>The right answer:</source>
        <translation>Õige vastus:</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>Õige</translation>
    </message>
    <message>
        <source>Wrong</source>
        <translation>Vale</translation>
    </message>
    <message>
        <source>You gave no answer.</source>
        <translation>Te ei vastanud.</translation>
    </message>
    <message>
        <source>Your answer:</source>
        <translation>Teie vastus:</translation>
    </message>
    <message>
        <source>The idea behind it: “{0}”.</source>
        <translation>Mõte selle taga: „{0}“.</translation>
    </message>
</context>
<context>
    <name>SettingMotion</name>
    <message>
        <source>Move it back and forth between the ends of its slider</source>
        <translation>Liigutab seda edasi-tagasi liuguri otste vahel</translation>
    </message>
    <message>
        <source>Pause it here; playing continues from here</source>
        <translation>Peatab siin; esitamine jätkub siit</translation>
    </message>
</context>
<context>
    <name>Space</name>
    <message>
        <source>NDC</source>
        <translation>NDC</translation>
    </message>
    <message>
        <source>canonical parallel</source>
        <translation>kanooniline paralleelne</translation>
    </message>
    <message>
        <source>canonical perspective</source>
        <translation>kanooniline perspektiivne</translation>
    </message>
    <message>
        <source>clip</source>
        <translation>kärperuum</translation>
    </message>
    <message>
        <source>depth range</source>
        <translation>sügavusvahemik</translation>
    </message>
    <message>
        <source>image</source>
        <translation>pilt</translation>
    </message>
    <message>
        <source>object</source>
        <translation>objekt</translation>
    </message>
    <message>
        <source>sheared</source>
        <translation>kaldnihkega</translation>
    </message>
    <message>
        <source>view</source>
        <translation>vaade</translation>
    </message>
    <message>
        <source>world</source>
        <translation>maailm</translation>
    </message>
</context>
<context>
    <name>SpeakerWindow</name>
    <message>
        <source>Speaker&apos;s window – Frustum Lab</source>
        <translation>Esineja aken – Frustum Lab</translation>
    </message>
    <message>
        <source>Notes</source>
        <translation>Märkmed</translation>
    </message>
    <message>
        <source>The slide</source>
        <translation>Slaid</translation>
    </message>
    <message>
        <source>Next</source>
        <translation>Järgmine</translation>
    </message>
    <message>
        <source>Steps</source>
        <translation>Sammud</translation>
    </message>
    <message>
        <source>&amp;Reset</source>
        <translation>&amp;Lähtesta</translation>
    </message>
    <message>
        <source>◀ &amp;Back</source>
        <translation>◀ &amp;Tagasi</translation>
    </message>
    <message>
        <source>&amp;Next ▶</source>
        <translation>&amp;Edasi ▶</translation>
    </message>
    <message>
        <source>B&amp;lank</source>
        <translation>&amp;Must ekraan</translation>
    </message>
    <message>
        <source>S&amp;wap screens</source>
        <translation>&amp;Vaheta ekraanid</translation>
    </message>
    <message>
        <source>Swap the screens of class and notes (W); the choice is remembered</source>
        <translation>Vahetab klassi ja märkmete ekraanid (W); valik jäetakse meelde</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Aeg</translation>
    </message>
    <message>
        <source>Elapsed</source>
        <translation>Möödunud</translation>
    </message>
    <message>
        <source>step {0} of {1}</source>
        <translation>samm {0} / {1}</translation>
    </message>
    <message>
        <source>Next: the answer</source>
        <translation>Järgmiseks: vastus</translation>
    </message>
    <message>
        <source>Next: the question</source>
        <translation>Järgmiseks: küsimus</translation>
    </message>
    <message>
        <source>{0}; later: {1}</source>
        <translation>{0}; hiljem: {1}</translation>
    </message>
    <message>
        <source>Next: {0}</source>
        <translation>Järgmiseks: {0}</translation>
    </message>
    <message>
        <source>This is the last step.</source>
        <translation>See on viimane samm.</translation>
    </message>
    <message>
        <source>&amp;Pause</source>
        <translation>&amp;Paus</translation>
    </message>
    <message>
        <source>&amp;Start</source>
        <translation>&amp;Käivita</translation>
    </message>
    <message>
        <source>planned {0} to {1} min</source>
        <translation>kavandatud {0} kuni {1} min</translation>
    </message>
    <message>
        <source>planned {0} min</source>
        <translation>kavandatud {0} min</translation>
    </message>
    <message>
        <source>{0} min late</source>
        <translation>{0} min hiljaks jäänud</translation>
    </message>
</context>
<context>
    <name>Spoken</name>
    <message>
        <source>at least</source>
        <translation>vähemalt</translation>
    </message>
    <message>
        <source>at most</source>
        <translation>ülimalt</translation>
    </message>
    <message>
        <source>degrees</source>
        <translation>kraadi</translation>
    </message>
    <message>
        <source>equals</source>
        <translation>võrdub</translation>
    </message>
    <message>
        <source>infinity</source>
        <translation>lõpmatus</translation>
    </message>
    <message>
        <source>is about</source>
        <translation>on umbes</translation>
    </message>
    <message>
        <source>is not</source>
        <translation>ei võrdu</translation>
    </message>
    <message>
        <source>minus</source>
        <translation>miinus</translation>
    </message>
    <message>
        <source>over</source>
        <translation>jagatud</translation>
    </message>
    <message>
        <source>phi</source>
        <translation>fii</translation>
    </message>
    <message>
        <source>plus</source>
        <translation>pluss</translation>
    </message>
    <message>
        <source>plus or minus</source>
        <translation>pluss-miinus</translation>
    </message>
    <message>
        <source>prime</source>
        <translation>primm</translation>
    </message>
    <message>
        <source>root of</source>
        <translation>ruutjuur</translation>
    </message>
    <message>
        <source>sum of</source>
        <translation>summa</translation>
    </message>
    <message>
        <source>times</source>
        <translation>korda</translation>
    </message>
    <message>
        <source>to</source>
        <translation>nool</translation>
    </message>
    <message>
        <source>to the power</source>
        <translation>astmes</translation>
    </message>
    <message>
        <source>vector</source>
        <translation>vektor</translation>
    </message>
</context>
<context>
    <name>Stage</name>
    <message>
        <source>the scene&apos;s objects are given in world coordinates</source>
        <translation>stseeni objektid on antud maailma koordinaatides</translation>
    </message>
    <message>
        <source>a scale of 0 flattens the object: it has no inverse and no normals</source>
        <translation>skaleerimine 0-ga surub objekti lamedaks: sellel ei ole pöördmaatriksit ega normaale</translation>
    </message>
    <message>
        <source>a parallel lens has no M_pp: this is the identity</source>
        <translation>paralleelsel objektiivil ei ole M_pp-d: see on ühikmaatriks</translation>
    </message>
    <message>
        <source>far is infinite: the canonical pyramid is scaled by near, which is at z = -1</source>
        <translation>kaugtasand on lõpmatuses: kanooniline püramiid on skaleeritud lähitasandi järgi, mis on kohal z = -1</translation>
    </message>
</context>
<context>
    <name>StageStrip</name>
    <message>
        <source>World</source>
        <translation>Maailm</translation>
    </message>
    <message>
        <source>World space: the scene and the view volume in it</source>
        <translation>Maailm: stseen ja selles nähtav ruum</translation>
    </message>
    <message>
        <source>View</source>
        <translation>Vaade</translation>
    </message>
    <message>
        <source>View space: the eye is at 0 and looks along −z</source>
        <translation>Kaamerafreim: silm on punktis 0 ja vaatab suunas −z</translation>
    </message>
    <message>
        <source>Pyramid</source>
        <translation>Püramiid</translation>
    </message>
    <message>
        <source>The canonical perspective volume: a pyramid with its tip in the eye</source>
        <translation>Kanooniline perspektiivne nähtav ruum: püramiid, mille tipp on silmas</translation>
    </message>
    <message>
        <source>Box</source>
        <translation>Risttahukas</translation>
    </message>
    <message>
        <source>The canonical parallel volume: Mₚₚ has turned the pyramid into a box</source>
        <translation>Kanooniline paralleelne nähtav ruum: Mₚₚ on püramiidist teinud risttahuka</translation>
    </message>
    <message>
        <source>NDC</source>
        <translation>NDC</translation>
    </message>
    <message>
        <source>Normalised device coordinates, z mirrored for display</source>
        <translation>Normaliseeritud koordinaadid, z on näitamiseks peegeldatud</translation>
    </message>
    <message>
        <source>Image</source>
        <translation>Pilt</translation>
    </message>
    <message>
        <source>The picture in pixels: x right, y down</source>
        <translation>Pilt pikslites: x paremale, y alla</translation>
    </message>
    <message>
        <source>Mₚₚ</source>
        <translation>Mₚₚ</translation>
    </message>
    <message>
        <source>Stage</source>
        <translation>Etapp</translation>
    </message>
    <message>
        <source>From the world through all stages to the picture; the arrow keys go from stop to stop</source>
        <translation>Maailmast läbi kõigi etappide pildini; nooleklahvid viivad peatusest peatusesse</translation>
    </message>
    <message>
        <source>Object</source>
        <translation>Objekt</translation>
    </message>
    <message>
        <source>The object&apos;s own space</source>
        <translation>Objekti enda ruum</translation>
    </message>
    <message>
        <source>After {0}</source>
        <translation>Pärast: {0}</translation>
    </message>
    <message>
        <source>The canonical parallel volume: a parallel lens has no pyramid before it</source>
        <translation>Kanooniline paralleelne nähtav ruum: paralleelsel objektiivil ei ole enne seda püramiidi</translation>
    </message>
    <message>
        <source>The same box: Mₚₚ of a parallel lens is the identity</source>
        <translation>Sama risttahukas: paralleelse objektiivi Mₚₚ on ühikmaatriks</translation>
    </message>
    <message>
        <source>Canonical parallel</source>
        <translation>Kanooniline paralleelne</translation>
    </message>
    <message>
        <source>Canonical perspective</source>
        <translation>Kanooniline perspektiivne</translation>
    </message>
    <message>
        <source>NDC cube</source>
        <translation>NDC kuup</translation>
    </message>
    <message>
        <source>The moves of object and camera done from the left: each in the axes that the moves before have moved</source>
        <translation>Objekti ja kaamera liigutused tehakse vasakult: iga liigutus telgedes, mida varasemad liigutused on liigutanud</translation>
    </message>
    <message>
        <source>The moves of object and camera read from the right: each in fixed axes</source>
        <translation>Objekti ja kaamera liigutused loetakse paremalt: iga liigutus paigalseisvates telgedes</translation>
    </message>
    <message>
        <source>x, y, z in world units</source>
        <translation>x, y, z maailma ühikutes</translation>
    </message>
    <message>
        <source>no canonical volumes</source>
        <translation>kanoonilisi ruume ei ole</translation>
    </message>
    <message>
        <source>x, y, z of view space</source>
        <translation>kaamerafreimi x, y, z</translation>
    </message>
    <message>
        <source>{axis_u}, {axis_v}, {axis_n} in world units</source>
        <translation>{axis_u}, {axis_v}, {axis_n} maailma ühikutes</translation>
    </message>
    <message>
        <source>x, y ±1, z {0} … {1}</source>
        <translation>x, y ±1, z {0} … {1}</translation>
    </message>
    <message>
        <source>{0} × {1} pixels, y down</source>
        <translation>{0} × {1} pikslit, y alla</translation>
    </message>
    <message>
        <source>x, y ±1, z 0 … -1; Mₚₚ: identity</source>
        <translation>x, y ±1, z 0 … -1; Mₚₚ: ühikmaatriks</translation>
    </message>
    <message>
        <source>x, y ±1, z 0 … -1</source>
        <translation>x, y ±1, z 0 … -1</translation>
    </message>
    <message>
        <source>near z -1, far -∞ (scaled by 1/{n})</source>
        <translation>lähitasandi z -1, kaugtasandi z -∞ (skaleeritud 1/{n})</translation>
    </message>
    <message>
        <source>x, y ±1, z -{n}/{f} = {0} … -1</source>
        <translation>x, y ±1, z -{n}/{f} = {0} … -1</translation>
    </message>
    <message>
        <source>{0} the stages</source>
        <translation>{0} etapid</translation>
    </message>
    <message>
        <source>Run through all stages to the picture, resting at each.</source>
        <translation>Läbib kõik etapid pildini ja peatub igas.</translation>
    </message>
    <message>
        <source>Pause; playing again continues from here.</source>
        <translation>Paus; uuesti esitamine jätkub siit.</translation>
    </message>
</context>
<context>
    <name>StartCard</name>
    <message>
        <source>Start</source>
        <translation>Avakaart</translation>
    </message>
    <message>
        <source>Learn</source>
        <translation>Õppimine</translation>
    </message>
    <message>
        <source>Files</source>
        <translation>Failid</translation>
    </message>
    <message>
        <source>Show this at every start</source>
        <translation>Näita seda igal käivitamisel</translation>
    </message>
    <message>
        <source>Help &gt; Start card shows it at any time</source>
        <translation>Abi &gt; Avakaart näitab seda igal ajal</translation>
    </message>
    <message>
        <source>How a camera turns a 3-D scene into a picture</source>
        <translation>Kuidas kaamera teeb 3-D stseenist pildi</translation>
    </message>
    <message>
        <source>Begin with the letter F (Esc)</source>
        <translation>Alusta F-tähega (Esc)</translation>
    </message>
    <message>
        <source>Two-minute tour</source>
        <translation>Kaheminutiline ringkäik</translation>
    </message>
    <message>
        <source>Six things to try, one after the other</source>
        <translation>Kuus asja, mida üksteise järel proovida</translation>
    </message>
    <message>
        <source>24 topics of the lectures, to work through alone</source>
        <translation>Loengute 24 teemat iseseisvaks läbitöötamiseks</translation>
    </message>
    <message>
        <source>The five lectures, to present to a class</source>
        <translation>Viis loengut klassile esitlemiseks</translation>
    </message>
    <message>
        <source>Lessons</source>
        <translation>Õppetunnid</translation>
    </message>
    <message>
        <source>Talks</source>
        <translation>Ettekanded</translation>
    </message>
    <message>
        <source>Speed and accuracy</source>
        <translation>Kiirus ja täpsus</translation>
    </message>
    <message>
        <source>What a renderer gives up to be fast, measured</source>
        <translation>Millest renderdaja kiiruse nimel loobub, mõõdetult</translation>
    </message>
    <message>
        <source>What you did not solve alone, with other numbers, the topics mixed</source>
        <translation>Mida te ise ei lahendanud, teiste arvudega, teemad segamini</translation>
    </message>
    <message>
        <source>Open a file…</source>
        <translation>Ava fail…</translation>
    </message>
    <message>
        <source>Open a document, a lesson, a mesh, a camera or an exported picture</source>
        <translation>Avab dokumendi, õppetunni, võrgu, kaamera või eksporditud pildi</translation>
    </message>
</context>
<context>
    <name>StatusLine</name>
    <message>
        <source>Numerical health</source>
        <translation>Arvuline seisund</translation>
    </message>
    <message>
        <source>The precision of the picture (drawn) and of its numbers (read), each with a bound on its error. The bound of the picture holds for what is visible. The bounds of the numbers and of the alternatives in the menu hold for every point in front of the eye</source>
        <translation>Pildi (joonistatud) ja selle arvude (loetud) täpsus, kumbki koos vea tõkkega. Pildi tõke kehtib nähtava kohta. Arvude ja menüüs olevate teiste valikute tõkked kehtivad iga silma ees oleva punkti kohta</translation>
    </message>
    <message>
        <source>The panes are drawn with the quality that you chose; click for the automatic one</source>
        <translation>Paane joonistatakse teie valitud kvaliteediga; klõpsake automaatse kvaliteedi saamiseks</translation>
    </message>
    <message>
        <source>Cost of a step</source>
        <translation>Sammu kulu</translation>
    </message>
    <message>
        <source>{0} {1} + {2}</source>
        <translation>{0} {1} + {2}</translation>
    </message>
    <message>
        <source>model {0}</source>
        <translation>mudel {0}</translation>
    </message>
    <message>
        <source>{0} ms</source>
        <translation>{0} ms</translation>
    </message>
    <message>
        <source>Time of the last step in ms: the model; for each pane its matrices + its repaint</source>
        <translation>Viimase sammu aeg millisekundites: mudel; iga paani maatriksid + ümberjoonistamine</translation>
    </message>
    <message>
        <source>quality: {0}</source>
        <translation>kvaliteet: {0}</translation>
    </message>
    <message>
        <source>drawn {0}, read {1}</source>
        <translation>joonistatud {0}, loetud {1}</translation>
    </message>
    <message>
        <source>drawn {0} ±{1} px, read {2} ±{3} px</source>
        <translation>joonistatud {0} ±{1} px, loetud {2} ±{3} px</translation>
    </message>
    <message>
        <source>{0}: up to {1} px, {2} in depth</source>
        <translation>{0}: kuni {1} px, sügavuses {2}</translation>
    </message>
    <message>
        <source>{0}: its error has no bound here</source>
        <translation>{0}: selle veal ei ole siin tõket</translation>
    </message>
    <message>
        <source>drawn</source>
        <translation>joonistatud</translation>
    </message>
    <message>
        <source>read</source>
        <translation>loetud</translation>
    </message>
    <message>
        <source>Frames of at most {0} ms while dragging…</source>
        <translation>Kaadri aeg lohistamisel ülimalt {0} ms…</translation>
    </message>
    <message>
        <source>No limit on the frame time while dragging…</source>
        <translation>Kaadriaeg lohistamisel piiramata…</translation>
    </message>
    <message>
        <source>While you drag a control, antialiasing and triangles may be left out to keep each frame within this many milliseconds; 0 for no limit:</source>
        <translation>Kui te juhtelementi lohistate, võib silumise ja kolmnurki ära jätta, et iga kaader mahuks nii mitme millisekundi sisse; 0 tähendab, et piirangut ei ole:</translation>
    </message>
    <message>
        <source>Frame time</source>
        <translation>Kaadriaeg</translation>
    </message>
    <message>
        <source>Drawing tolerance {0} px…</source>
        <translation>Joonistamise lubatud viga {0} px…</translation>
    </message>
    <message>
        <source>Drawing tolerance</source>
        <translation>Joonistamise lubatud viga</translation>
    </message>
    <message>
        <source>A GPU&apos;s own arithmetic (float32) may draw with an error of up to this many pixels:</source>
        <translation>GPU oma aritmeetika (float32) võib joonistada veaga kuni nii mitu pikslit:</translation>
    </message>
</context>
<context>
    <name>StepMarks</name>
    <message>
        <source>Steps</source>
        <translation>Sammud</translation>
    </message>
    <message>
        <source>Practice</source>
        <translation>Harjutamine</translation>
    </message>
    <message>
        <source>Step {0} of {1}</source>
        <translation>Samm {0} / {1}</translation>
    </message>
    <message>
        <source>done</source>
        <translation>valmis</translation>
    </message>
    <message>
        <source>answered</source>
        <translation>vastatud</translation>
    </message>
    <message>
        <source>Step {0}: {1}</source>
        <translation>Samm {0}: {1}</translation>
    </message>
    <message>
        <source>Step {0}, practice: {1}</source>
        <translation>Samm {0}, harjutamine: {1}</translation>
    </message>
</context>
<context>
    <name>StepPage</name>
    <message>
        <source>Step</source>
        <translation>Samm</translation>
    </message>
</context>
<context>
    <name>TalkWriter</name>
    <message>
        <source>Add this state as a step</source>
        <translation>Selle oleku lisamine sammuna</translation>
    </message>
    <message>
        <source>{0} is not in its folder any more, and no step was added: put the file back, or choose “A new talk from here” in the Lessons menu.</source>
        <translation>{0} ei ole enam oma kaustas ja sammu ei lisatud: pange fail tagasi või valige menüüst Õppetunnid „Uus ettekanne siit edasi“.</translation>
    </message>
    <message>
        <source>Added as step {0} of {1}</source>
        <translation>Lisatud sammuna {0} faili {1}</translation>
    </message>
    <message>
        <source>Talks and lessons (*.md)</source>
        <translation>Ettekanded ja õppetunnid (*.md)</translation>
    </message>
    <message>
        <source>A new talk from here</source>
        <translation>Uus ettekanne siit edasi</translation>
    </message>
</context>
<context>
    <name>Talks</name>
    <message>
        <source>There is only one screen.</source>
        <translation>Ekraane on ainult üks.</translation>
    </message>
    <message>
        <source>Open a talk first: its handout shows the strokes.</source>
        <translation>Avage enne ettekanne: joonistatud jooned on selle jaotusmaterjalis.</translation>
    </message>
    <message>
        <source>Kept for the handout: {0}</source>
        <translation>Jaotusmaterjali jaoks hoitud: {0}</translation>
    </message>
    <message>
        <source>This is the last step.</source>
        <translation>See on viimane samm.</translation>
    </message>
    <message>
        <source>There is no step {0}; the last is {1}.</source>
        <translation>Sammu {0} ei ole; viimane on {1}.</translation>
    </message>
    <message>
        <source>To step {0}…</source>
        <translation>Sammu juurde: {0}…</translation>
    </message>
    <message>
        <source>The file was changed, and cannot be read.</source>
        <translation>Faili on muudetud ja seda ei saa lugeda.</translation>
    </message>
    <message>
        <source>Open a talk first: the speaker&apos;s window shows its notes.</source>
        <translation>Avage enne ettekanne: esineja aken näitab selle märkmeid.</translation>
    </message>
</context>
<context>
    <name>TaskView</name>
    <message>
        <source>To do</source>
        <translation>Teha</translation>
    </message>
    <message>
        <source>The window as it is now is my answer</source>
        <translation>Minu vastus on aken nii, nagu see praegu on</translation>
    </message>
    <message>
        <source>Hand it &amp;in</source>
        <translation>Esita vast&amp;us</translation>
    </message>
    <message>
        <source>Nothing is changed yet.</source>
        <translation>Midagi ei ole veel muudetud.</translation>
    </message>
    <message>
        <source>You can see a state that fulfils the task.</source>
        <translation>Saate vaadata olekut, mis ülesande täidab.</translation>
    </message>
    <message>
        <source>Show a state that makes it visible (Alt+W)</source>
        <translation>Näitab olekut, kus see näha on (Alt+D)</translation>
    </message>
    <message>
        <source>Sho&amp;w it</source>
        <translation>Näita se&amp;da</translation>
    </message>
    <message>
        <source>Done.</source>
        <translation>Valmis.</translation>
    </message>
    <message>
        <source>Done</source>
        <translation>Valmis</translation>
    </message>
</context>
<context>
    <name>TitleDialog</name>
    <message>
        <source>&amp;Title of the step</source>
        <translation>Sammu &amp;pealkiri</translation>
    </message>
    <message>
        <source>Keep the &amp;panes turned as they are</source>
        <translation>&amp;Jäta paanid nii pööratuks, nagu need on</translation>
    </message>
    <message>
        <source>The state is then a document beside the file</source>
        <translation>Olek on siis dokument faili kõrval</translation>
    </message>
</context>
<context>
    <name>TradesCard</name>
    <message>
        <source>Speed and accuracy</source>
        <translation>Kiirus ja täpsus</translation>
    </message>
    <message>
        <source>Back to the start card</source>
        <translation>Tagasi avakaardile</translation>
    </message>
    <message>
        <source>Start card</source>
        <translation>Avakaart</translation>
    </message>
    <message>
        <source>Speed and accuracy: what a renderer gives up to be fast</source>
        <translation>Kiirus ja täpsus: millest renderdaja kiiruse nimel loobub</translation>
    </message>
    <message>
        <source>Go on with the scene (Esc)</source>
        <translation>Jätka stseeniga (Esc)</translation>
    </message>
    <message>
        <source>Measured with the letter F on another machine: {0}. Choose a trade to see it, and to measure it here.</source>
        <translation>Mõõdetud F-tähega teises masinas: {0}. Valige kompromiss, et seda näha ja siin mõõta.</translation>
    </message>
    <message>
        <source>Not measured yet.</source>
        <translation>Veel mõõtmata.</translation>
    </message>
</context>
<context>
    <name>TypesetLabel</name>
    <message>
        <source>Copy with all digits</source>
        <translation>Kopeeri kõigi numbrikohtadega</translation>
    </message>
</context>
<context>
    <name>VectorRow</name>
    <message>
        <source>{0} {1}</source>
        <translation>{0} {1}</translation>
    </message>
</context>
<context>
    <name>_Elided</name>
    <message>
        <source>{0} And {1} more.</source>
        <translation>{0} Ja veel {1}.</translation>
    </message>
</context>
<context>
    <name>_MatrixCellEdit</name>
    <message>
        <source>Row {0}, column {1}</source>
        <translation>Rida {0}, veerg {1}</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>Õige</translation>
    </message>
    <message>
        <source>Wrong</source>
        <translation>Vale</translation>
    </message>
</context>
<context>
    <name>_Node</name>
    <message>
        <source>the picture is of this kind now: {0}</source>
        <translation>pilt on nüüd seda liiki: {0}</translation>
    </message>
</context>
<context>
    <name>_TileCard</name>
    <message>
        <source>Whether the product has this tile</source>
        <translation>Kas see lüli on korrutises</translation>
    </message>
    <message>
        <source>Remove it</source>
        <translation>Eemalda see</translation>
    </message>
    <message>
        <source>origin</source>
        <translation>alguspunkt</translation>
    </message>
    <message>
        <source>axis</source>
        <translation>telg</translation>
    </message>
</context>
<context>
    <name>_TileRow</name>
    <message>
        <source>Whether the product has this tile</source>
        <translation>Kas see lüli on korrutises</translation>
    </message>
</context>
<context>
    <name>phenomena</name>
    <message>
        <source>on</source>
        <translation>sees</translation>
    </message>
    <message>
        <source>off</source>
        <translation>väljas</translation>
    </message>
    <message>
        <source>this computer&apos;s OpenGL rejects the shader that this scene needs: the picture is drawn without it, and only the computed numbers are right</source>
        <translation>selle arvuti OpenGL ei võta vastu šeiderit, mida see stseen vajab: pilt joonistatakse ilma selleta ja õiged on ainult arvutatud arvud</translation>
    </message>
    <message>
        <source>{0} faces with {1} parts a side are too many triangles to draw: the picture has {2} parts</source>
        <translation>tahkude arv {0}, igaühe küljel osi {1}: seda on joonistamiseks liiga palju kolmnurki; pildi osade arv küljel on {2}</translation>
    </message>
    <message>
        <source>your idea</source>
        <translation>teie mõte</translation>
    </message>
    <message>
        <source>the model</source>
        <translation>mudel</translation>
    </message>
    <message>
        <source>truncated pyramid</source>
        <translation>pügatud püramiid</translation>
    </message>
    <message>
        <source>oblique box</source>
        <translation>rööptahukas</translation>
    </message>
    <message>
        <source>box</source>
        <translation>risttahukas</translation>
    </message>
    <message>
        <source>a free matrix has no near, no far and no window: choose a lens to see this</source>
        <translation>vabal maatriksil ei ole lähitasandit, kaugtasandit ega akent: selle nägemiseks valige objektiiv</translation>
    </message>
    <message>
        <source>0 is the orthographic drawing, 1 the oblique one</source>
        <translation>0 on ortograafiline joonis, 1 kaldnurgaline</translation>
    </message>
    <message>
        <source>0: uncut; then near, far, left, right, bottom and top, one by one</source>
        <translation>0: lõikamata; siis lähitasand, kaugtasand, vasak, parem, alumine ja ülemine, ühekaupa</translation>
    </message>
    <message>
        <source>1-point</source>
        <translation>1-punkti</translation>
    </message>
    <message>
        <source>1-point perspective</source>
        <translation>1-punkti perspektiiv</translation>
    </message>
    <message>
        <source>1/16 px</source>
        <translation>1/16 px</translation>
    </message>
    <message>
        <source>1/4 px</source>
        <translation>1/4 px</translation>
    </message>
    <message>
        <source>1/w along the marked edge is straight</source>
        <translation>1/w on piki märgitud serva sirge</translation>
    </message>
    <message>
        <source>105 mm, enlarged 3.3 times</source>
        <translation>105 mm, suurendatud 3.3 korda</translation>
    </message>
    <message>
        <source>12 bits</source>
        <translation>12 bitti</translation>
    </message>
    <message>
        <source>12 bits a coordinate</source>
        <translation>12 bitti koordinaadi kohta</translation>
    </message>
    <message>
        <source>16 bits</source>
        <translation>16 bitti</translation>
    </message>
    <message>
        <source>16 bits a coordinate</source>
        <translation>16 bitti koordinaadi kohta</translation>
    </message>
    <message>
        <source>1994 console</source>
        <translation>1994. aasta mängukonsool</translation>
    </message>
    <message>
        <source>1: both ends in front of it</source>
        <translation>1: mõlemad otsad selle ees</translation>
    </message>
    <message>
        <source>2-point</source>
        <translation>2-punkti</translation>
    </message>
    <message>
        <source>2-point perspective</source>
        <translation>2-punkti perspektiiv</translation>
    </message>
    <message>
        <source>24 bits</source>
        <translation>24 bitti</translation>
    </message>
    <message>
        <source>29 mm</source>
        <translation>29 mm</translation>
    </message>
    <message>
        <source>2: both ends behind it</source>
        <translation>2: mõlemad otsad selle taga</translation>
    </message>
    <message>
        <source>3-point</source>
        <translation>3-punkti</translation>
    </message>
    <message>
        <source>3-point perspective</source>
        <translation>3-punkti perspektiiv</translation>
    </message>
    <message>
        <source>32 bits</source>
        <translation>32 bitti</translation>
    </message>
    <message>
        <source>3: only A behind it</source>
        <translation>3: ainult A selle taga</translation>
    </message>
    <message>
        <source>4: only B behind it</source>
        <translation>4: ainult B selle taga</translation>
    </message>
    <message>
        <source>8 bits</source>
        <translation>8 bitti</translation>
    </message>
    <message>
        <source>8 bits a coordinate</source>
        <translation>8 bitti koordinaadi kohta</translation>
    </message>
    <message>
        <source>A camera turns by 1° a frame: each frame multiplies its axes by the same small turn, and every product is rounded. After 360° it should be home. The pale picture is the true one, and beside it is what the camera sees: one matrix product a frame instead of two sines has its price. Every tenth frame the axes can be renormalised, which repairs their lengths and right angles, but not their direction.</source>
        <translation>Kaamera pöördub iga kaadriga 1°: iga kaader korrutab selle teljed sama väikese pöördega ja iga korrutis ümardatakse. Pärast 360° peaks see olema lähtekohas tagasi. Kahvatu pilt on õige ja selle kõrval on see, mida kaamera näeb: üks maatriksikorrutis kaadri kohta kahe siinuse asemel nõuab oma hinda. Iga kümnenda kaadriga saab telgi uuesti normeerida; see parandab nende pikkused ja täisnurgad, aga mitte suunda.</translation>
    </message>
    <message>
        <source>A field of view from lecture 001; the camera moves so that things at the target&apos;s distance keep their size</source>
        <translation>Üks loengu 001 frustumi nurkadest; kaamera liigub nii, et asjad sihtpunkti kaugusel jäävad sama suureks</translation>
    </message>
    <message>
        <source>A lamp at a point, or the sun: a point at infinity</source>
        <translation>Lamp mingis punktis või päike: lõpmatuspunkt</translation>
    </message>
    <message>
        <source>A logarithmic depth has digits for every distance. Computed for each vertex, it costs one logarithm a vertex, and the early depth test stays on. But between the vertices the rasteriser interpolates it linearly on the screen, where 1/w is linear and log w is not. So a long face is drawn too far away: the wall&apos;s foundation, which is below the floor, is seen through it. Shorter pieces or a logarithm for each pixel mend that.</source>
        <translation>Logaritmilisel sügavusel jätkub numbrikohti igale kaugusele. Kui see arvutatakse iga tipu jaoks, maksab see ühe logaritmi tipu kohta ja varajane sügavustest jääb sisse. Aga tippude vahel interpoleerib rasterdaja seda ekraanil lineaarselt, kus 1/w on lineaarne ja log w ei ole. Nii joonistatakse pikk tahk liiga kaugele: seina alusmüür, mis on põrandast allpool, paistab sellest läbi. Abi on lühematest tükkidest või logaritmist iga piksli jaoks.</translation>
    </message>
    <message>
        <source>A pixel and its depth lead back to the point that was drawn there. The inverse of P V does it in one product, but it multiplies the eye&apos;s coordinates with 1/w, a difference of nearly equal numbers. Far from the world&apos;s origin, float32 then misses the point by parts of its distance. If the pixel&apos;s ray is multiplied with the depth, or if P and V are undone one after the other, the eye is only added, and is rounded once. On the way to the picture, it hardly matters whether P and V are one matrix or two: that these make the difference is a myth.</source>
        <translation>Piksel ja selle sügavus viivad tagasi punktini, mis seal joonistati. P V pöördmaatriks teeb seda ühe korrutisega, aga see korrutab silma koordinaate arvuga 1/w, mis on peaaegu võrdsete arvude vahe. Maailma alguspunktist kaugel läheb float32 siis punktist mööda, ja seda märgatava osa võrra selle kaugusest. Kui piksli kiir korrutatakse sügavusega või kui P ja V võetakse tagasi üksteise järel, siis silma ainult liidetakse ja see ümardatakse üks kord. Teel pildini peaaegu ei loe, kas P ja V on üks maatriks või kaks: et vahe tuleb sellest, on müüt.</translation>
    </message>
    <message>
        <source>A point behind the eye has w &lt; 0, and the divide by w mirrors its image. With one end behind, AB is then drawn along the wrong part of its line, because the right part goes through infinity. So AB must be cut before the divide: at z = −0.01 as in lecture 004, or in homogeneous coordinates, which need no such number.</source>
        <translation>Silma taga oleval punktil on w &lt; 0 ja jagamine w-ga peegeldab selle kujutise. Kui üks ots on taga, joonistatakse AB seega oma sirge vale osana, sest õige osa läbib lõpmatust. Seepärast tuleb AB enne jagamist läbi lõigata: kohal z = −0.01, nagu loengus 004, või homogeensetes koordinaatides, mis sellist arvu ei vaja.</translation>
    </message>
    <message>
        <source>A shadow is a projection with its centre in the light: the matrix S draws the object once more, in one colour. For the sun, a light at infinity with w = 0, the projection is parallel. Parts of the object above a lamp have w &lt; 0. Unless they are clipped, they are drawn on the other side of the lamp as an anti-shadow.</source>
        <translation>Vari on projektsioon, mille keskpunkt on valgusallikas: maatriks S joonistab objekti veel kord, ühe värviga. Päikese puhul, mis on lõpmatuses asuv valgusallikas, kus w = 0, on projektsioon paralleelne. Objekti osadel, mis on lambist kõrgemal, on w &lt; 0. Kui neid ei kärbita, joonistatakse need teisele poole lampi antivarjuna.</translation>
    </message>
    <message>
        <source>A shape inside the view volume is drawn, and a shape outside it is not. A shape that crosses it is cut by each plane in turn, and gets a new corner where an edge passes through the plane. Near removes everything at the eye or behind it, where w ≤ 0 and the divide fails, and far bounds the depths. Clipping is done in the canonical volume, before the divide, because there the planes are the same for every lens: −w ≤ x, y, z ≤ w in OpenGL&apos;s.</source>
        <translation>Kujund nähtava ruumi sees joonistatakse, sellest väljas olev kujund mitte. Selle piiri ületava kujundi lõikab iga tasand oma järjekorras läbi ja kus serv tasandit läbib, tekib uus nurk. Lähitasand eemaldab kõik, mis on silma juures või taga, kus w ≤ 0 ja jagada ei saa, ja kaugtasand piirab sügavusi. Kärbitakse kanoonilises ruumis, enne jagamist, sest seal on tasandid iga objektiivi jaoks samad: OpenGL-is −w ≤ x, y, z ≤ w.</translation>
    </message>
    <message>
        <source>A table of 8 bits is quick, and each Newton step doubles its right digits</source>
        <translation>8-bitine tabel on kiire ja iga Newtoni samm kahekordistab õigete numbrikohtade arvu</translation>
    </message>
    <message>
        <source>A wall of two</source>
        <translation>Sein kahest ekraanist</translation>
    </message>
    <message>
        <source>AB drawn wrongly</source>
        <translation>AB valesti joonistatud</translation>
    </message>
    <message>
        <source>AB left out by the cut at z = −0.01</source>
        <translation>AB osa, mille lõige kohal z = −0.01 ära jätab</translation>
    </message>
    <message>
        <source>AB missed</source>
        <translation>AB puudu</translation>
    </message>
    <message>
        <source>All projectors are parallel, but slant towards the image. Faces parallel to the image keep their shape, and receding edges are drawn at one angle and one scale. Scale 1 gives a cavalier drawing, 1/2 a cabinet drawing, and 0 the orthographic drawing.</source>
        <translation>Kõik projektsioonikiired on paralleelsed, aga pildi suhtes kaldu. Pildiga paralleelsed tahud säilitavad oma kuju ja sügavusse minevad servad joonistatakse ühe nurga all ja ühes mastaabis. Mastaap 1 annab cavalier-joonise, 1/2 cabinet-joonise ja 0 ortograafilise joonise.</translation>
    </message>
    <message>
        <source>Aperture N</source>
        <translation>Diafragma N</translation>
    </message>
    <message>
        <source>Arithmetic</source>
        <translation>Aritmeetika</translation>
    </message>
    <message>
        <source>B is behind the eye: where is it drawn?</source>
        <translation>B on silma taga: kuhu see joonistatakse?</translation>
    </message>
    <message>
        <source>Back from the picture</source>
        <translation>Pildilt tagasi</translation>
    </message>
    <message>
        <source>Bent by an affine z</source>
        <translation>Afiinse z-ga kõverdunud</translation>
    </message>
    <message>
        <source>Bits of a coordinate</source>
        <translation>Koordinaadi bitid</translation>
    </message>
    <message>
        <source>Box (orthographic)</source>
        <translation>Risttahukas (ortograafiline)</translation>
    </message>
    <message>
        <source>Cabinet: 1/2 ×</source>
        <translation>Cabinet: 1/2 ×</translation>
    </message>
    <message>
        <source>Camera obscura</source>
        <translation>Camera obscura</translation>
    </message>
    <message>
        <source>Cameras</source>
        <translation>Kaamerad</translation>
    </message>
    <message>
        <source>Cavalier or cabinet: which looks right?</source>
        <translation>Cavalier või cabinet: kumb tundub õige?</translation>
    </message>
    <message>
        <source>Cavalier: 1 ×</source>
        <translation>Cavalier: 1 ×</translation>
    </message>
    <message>
        <source>Changes the lens, but keeps the picture of the target&apos;s plane</source>
        <translation>Vahetab objektiivi, aga säilitab sihtpunkti tasandi pildi</translation>
    </message>
    <message>
        <source>Cheap arithmetic</source>
        <translation>Odav aritmeetika</translation>
    </message>
    <message>
        <source>Checks, or the coordinates themselves as colours</source>
        <translation>Ruudud või koordinaadid ise värvidena</translation>
    </message>
    <message>
        <source>Choose 12 bits: how narrow is the gap?</source>
        <translation>Valige 12 bitti: kui kitsas on pilu?</translation>
    </message>
    <message>
        <source>Choose 24 bits: is it enough?</source>
        <translation>Valige 24 bitti: kas sellest piisab?</translation>
    </message>
    <message>
        <source>Choose 8 bits and go nearer. And farther?</source>
        <translation>Valige 8 bitti ja minge lähemale. Ja kaugemale?</translation>
    </message>
    <message>
        <source>Choose a fog that hides it.</source>
        <translation>Valige udu, mis selle peidab.</translation>
    </message>
    <message>
        <source>Choose half floats, products alone.</source>
        <translation>Valige pooltäpsed ujukomaarvud, ainult korrutised.</translation>
    </message>
    <message>
        <source>Choose the box: which come, which go?</source>
        <translation>Valige risttahukas: mis tuleb, mis kaob?</translation>
    </message>
    <message>
        <source>Choose the common grid: what closes?</source>
        <translation>Valige ühine ruudustik: mis sulgub?</translation>
    </message>
    <message>
        <source>Choose the orthographic lens: and now?</source>
        <translation>Valige ortograafiline objektiiv: ja nüüd?</translation>
    </message>
    <message>
        <source>Choose “correct”: what has moved?</source>
        <translation>Valige „korrektne“: mis on liikunud?</translation>
    </message>
    <message>
        <source>Choose “each pixel”: what disappears?</source>
        <translation>Valige „iga piksel“: mis kaob?</translation>
    </message>
    <message>
        <source>Circle of confusion c</source>
        <translation>Hajumisring c</translation>
    </message>
    <message>
        <source>Click in the image: what comes back?</source>
        <translation>Klõpsake pildil: mis tuleb tagasi?</translation>
    </message>
    <message>
        <source>Clip parts above the light</source>
        <translation>Kärbi valgusest kõrgemad osad</translation>
    </message>
    <message>
        <source>Clipping, plane by plane</source>
        <translation>Kärpimine, tasand tasandi järel</translation>
    </message>
    <message>
        <source>Compare 29 mm with 105 mm.</source>
        <translation>Võrrelge 29 mm ja 105 mm.</translation>
    </message>
    <message>
        <source>Compare both films: what is turned over?</source>
        <translation>Võrrelge mõlemat filmi: mis on ümber pööratud?</translation>
    </message>
    <message>
        <source>Cone (the eye&apos;s own)</source>
        <translation>Koonus (silma oma)</translation>
    </message>
    <message>
        <source>Contrast left by fog</source>
        <translation>Kontrast, mis udust üle jääb</translation>
    </message>
    <message>
        <source>Coordinates</source>
        <translation>Koordinaadid</translation>
    </message>
    <message>
        <source>Cracks</source>
        <translation>Praod</translation>
    </message>
    <message>
        <source>Crossed, left eye&apos;s on the right</source>
        <translation>Ristatud, vasaku silma pilt paremal</translation>
    </message>
    <message>
        <source>Crossing the eye plane</source>
        <translation>Läbi silmatasandi</translation>
    </message>
    <message>
        <source>Cut the floor: how many pieces are enough?</source>
        <translation>Tükeldage põrandat: mitmest tükist piisab?</translation>
    </message>
    <message>
        <source>Depth at the vertices</source>
        <translation>Sügavus tippudes</translation>
    </message>
    <message>
        <source>Depth buffer</source>
        <translation>Sügavuspuhver</translation>
    </message>
    <message>
        <source>Depth range</source>
        <translation>Sügavusvahemik</translation>
    </message>
    <message>
        <source>Direction of receding edges, anticlockwise from the right</source>
        <translation>Sügavusse minevate servade suund, paremalt vastupäeva</translation>
    </message>
    <message>
        <source>Distance at which linear fog begins</source>
        <translation>Kaugus, kust lineaarne udu algab</translation>
    </message>
    <message>
        <source>Distance at which linear fog leaves nothing</source>
        <translation>Kaugus, kus lineaarne udu enam midagi järele ei jäta</translation>
    </message>
    <message>
        <source>Distance between the two eyes</source>
        <translation>Kahe silma vahekaugus</translation>
    </message>
    <message>
        <source>Distance from the eye to the plane of projection; negative behind the eye</source>
        <translation>Kaugus silmast projektsiooni tasandini; silma taga negatiivne</translation>
    </message>
    <message>
        <source>Distance from the hole to the film behind it, and to the synthetic film in front of it: near</source>
        <translation>Kaugus avast filmini selle taga ja sünteetilise filmini selle ees: lähitasand</translation>
    </message>
    <message>
        <source>Distance from the lens at which things are in focus</source>
        <translation>Kaugus objektiivist, millel asjad on teravad</translation>
    </message>
    <message>
        <source>Distance from which trees have fewer vertices</source>
        <translation>Kaugus, millest alates on puudel vähem tippe</translation>
    </message>
    <message>
        <source>Distance from which trees have fewest vertices</source>
        <translation>Kaugus, millest alates on puudel kõige vähem tippe</translation>
    </message>
    <message>
        <source>Distance of surface 2 behind surface 1, along the view direction</source>
        <translation>Pinna 2 kaugus pinna 1 taga, piki vaate suunda</translation>
    </message>
    <message>
        <source>Distance of the eye from the window&apos;s middle; the window stays in the world</source>
        <translation>Silma kaugus akna keskkohast; aken jääb maailmas paigale</translation>
    </message>
    <message>
        <source>Distance of the origin</source>
        <translation>Alguspunkti kaugus</translation>
    </message>
    <message>
        <source>Distance of the screen plane from the eyes: what lies in it does not move between the pictures</source>
        <translation>Ekraanitasandi kaugus silmadest: mis sellel asub, ei liigu piltide vahel</translation>
    </message>
    <message>
        <source>Distance, relative to the preset</source>
        <translation>Kaugus, valmisväärtuse suhtes</translation>
    </message>
    <message>
        <source>Do near and far change the bow?</source>
        <translation>Kas lähi- ja kaugtasand muudavad kaart?</translation>
    </message>
    <message>
        <source>Double d: how large is h&apos;?</source>
        <translation>Kahekordistage d: kui suur on h&apos;?</translation>
    </message>
    <message>
        <source>Double d: what are x_p and y_p now?</source>
        <translation>Kahekordistage d: millised on nüüd x_p ja y_p?</translation>
    </message>
    <message>
        <source>Double the parts: is the error halved?</source>
        <translation>Kahekordistage osade arv: kas viga jääb pooleks?</translation>
    </message>
    <message>
        <source>Double z: and now?</source>
        <translation>Kahekordistage z: ja nüüd?</translation>
    </message>
    <message>
        <source>Drag P towards the eye: and now?</source>
        <translation>Lohistage P silma poole: ja nüüd?</translation>
    </message>
    <message>
        <source>Drag d: how large is the image of P?</source>
        <translation>Lohistage d-d: kui suur on P kujutis?</translation>
    </message>
    <message>
        <source>Drag t to 1: where does P go?</source>
        <translation>Lohistage t väärtuseni 1: kuhu läheb P?</translation>
    </message>
    <message>
        <source>Drag the distance: what keeps its size?</source>
        <translation>Lohistage kaugust: mille suurus jääb samaks?</translation>
    </message>
    <message>
        <source>Drag the lamp: where is the shadow?</source>
        <translation>Lohistage lampi: kus on vari?</translation>
    </message>
    <message>
        <source>Drag the near plane towards the F.</source>
        <translation>Lohistage lähitasandit F-i poole.</translation>
    </message>
    <message>
        <source>Drag the screen plane to P: what happens?</source>
        <translation>Lohistage ekraanitasand punkti P: mis juhtub?</translation>
    </message>
    <message>
        <source>Drawing</source>
        <translation>Joonis</translation>
    </message>
    <message>
        <source>Drawn length of a receding edge relative to its true length, in the free drawing</source>
        <translation>Sügavusse mineva serva joonistatud pikkus tegeliku pikkuse suhtes, vabal joonisel</translation>
    </message>
    <message>
        <source>Draws distant trees with fewer vertices</source>
        <translation>Joonistab kauged puud vähemate tippudega</translation>
    </message>
    <message>
        <source>Drift</source>
        <translation>Triiv</translation>
    </message>
    <message>
        <source>Each coordinate is stored as an integer over the mesh&apos;s box</source>
        <translation>Iga koordinaat salvestatakse täisarvuna üle võrgu risttahuka</translation>
    </message>
    <message>
        <source>End B</source>
        <translation>Ots B</translation>
    </message>
    <message>
        <source>End P</source>
        <translation>Ots P</translation>
    </message>
    <message>
        <source>End Q</source>
        <translation>Ots Q</translation>
    </message>
    <message>
        <source>Enlarge the 105-mm photograph</source>
        <translation>Suurenda 105-mm fotot</translation>
    </message>
    <message>
        <source>Enlarges the middle of the picture until things at the target&apos;s distance are as large as on the 29-mm photograph; this narrows the field of view</source>
        <translation>Suurendab pildi keskosa, kuni asjad sihtpunkti kaugusel on sama suured kui 29-mm fotol; see kitsendab frustumi nurka</translation>
    </message>
    <message>
        <source>Every projector runs from a point to the eye. It meets the plane at distance d in the image of that point. The triangles between eye, axis and projector are similar, so x_p : d = x : (−z). If d is negative, the plane is behind the eye, as in a camera obscura, and the image is upside down.</source>
        <translation>Iga projektsioonikiir läheb punktist silma. See kohtab tasandit kaugusel d selle punkti kujutises. Silma, telje ja projektsioonikiire vahelised kolmnurgad on sarnased, seega x_p : d = x : (−z). Kui d on negatiivne, on tasand silma taga, nagu camera obscuras, ja kujutis on tagurpidi.</translation>
    </message>
    <message>
        <source>Exponential fog leaves exp(-density w)</source>
        <translation>Eksponentsiaalne udu jätab alles osa exp(-tihedus w)</translation>
    </message>
    <message>
        <source>Eye right of the middle</source>
        <translation>Silm keskkohast paremal</translation>
    </message>
    <message>
        <source>Eye separation s</source>
        <translation>Silmade vahe s</translation>
    </message>
    <message>
        <source>F drawn wrongly</source>
        <translation>F valesti joonistatud</translation>
    </message>
    <message>
        <source>F missed</source>
        <translation>F puudu</translation>
    </message>
    <message>
        <source>Far from the origin: move the origin.</source>
        <translation>Alguspunktist kaugel: nihutage alguspunkti.</translation>
    </message>
    <message>
        <source>Fewer bits make a picture smaller and quicker, and less exact. Every vertex is stored and projected with the chosen formats, and drawn where they put it. An arrow runs from each vertex&apos;s exact pixel towards the drawn one, enlarged as much as is written beside it. The bound is predicted from the formats alone, and no error is larger. A console of 1994 drew whole pixels and affine textures, and its vertices jumped whenever the camera moved.</source>
        <translation>Vähemad bitid teevad pildi väiksemaks ja kiiremaks, aga ka vähem täpseks. Iga tipp salvestatakse ja projitseeritakse valitud vormingutes ning joonistatakse sinna, kuhu need selle panevad. Iga tipu täpsest pikslist osutab nool joonistatud piksli poole, suurendatud nii palju, nagu selle kõrval kirjas. Tõke ennustatakse ainult vormingute järgi ja ükski viga ei ole sellest suurem. 1994. aasta mängukonsool joonistas täispiksleid ja afiinseid tekstuure ning selle tipud hüppasid iga kord, kui kaamera liikus.</translation>
    </message>
    <message>
        <source>Field of view</source>
        <translation>Frustumi nurk</translation>
    </message>
    <message>
        <source>Film distance d</source>
        <translation>Filmi kaugus d</translation>
    </message>
    <message>
        <source>Focal distance s</source>
        <translation>Teravustamiskaugus s</translation>
    </message>
    <message>
        <source>Focus on the post at 10 m.</source>
        <translation>Teravustage 10 m kaugusel olevale postile.</translation>
    </message>
    <message>
        <source>Fog</source>
        <translation>Udu</translation>
    </message>
    <message>
        <source>Fog density</source>
        <translation>Udu tihedus</translation>
    </message>
    <message>
        <source>Fog ends at</source>
        <translation>Udu lõpp</translation>
    </message>
    <message>
        <source>Fog starts at</source>
        <translation>Udu algus</translation>
    </message>
    <message>
        <source>Format</source>
        <translation>Vorming</translation>
    </message>
    <message>
        <source>Frame</source>
        <translation>Kaader</translation>
    </message>
    <message>
        <source>Free receding scale</source>
        <translation>Vaba sügavusmastaap</translation>
    </message>
    <message>
        <source>Free scale</source>
        <translation>Vaba mastaap</translation>
    </message>
    <message>
        <source>Free: turn the camera yourself</source>
        <translation>Vaba: pöörake kaamerat ise</translation>
    </message>
    <message>
        <source>From orthographic</source>
        <translation>Ortograafilisest alates</translation>
    </message>
    <message>
        <source>From the side</source>
        <translation>Küljelt</translation>
    </message>
    <message>
        <source>From which distance on does P stand still?</source>
        <translation>Millisest kaugusest alates P paigal püsib?</translation>
    </message>
    <message>
        <source>Gap</source>
        <translation>Vahe</translation>
    </message>
    <message>
        <source>Go back until AB is drawn right.</source>
        <translation>Minge tagasi, kuni AB on õigesti joonistatud.</translation>
    </message>
    <message>
        <source>Go back: which planes leave it as it is?</source>
        <translation>Minge tagasi: millised tasandid jätavad selle samaks?</translation>
    </message>
    <message>
        <source>Go nearer the origin: do the ways agree?</source>
        <translation>Minge alguspunktile lähemale: kas viisid langevad kokku?</translation>
    </message>
    <message>
        <source>Go nearer: does the gap stay as wide?</source>
        <translation>Minge lähemale: kas pilu jääb sama laiaks?</translation>
    </message>
    <message>
        <source>Go nearer: which edges grow?</source>
        <translation>Minge lähemale: millised servad kasvavad?</translation>
    </message>
    <message>
        <source>Grid</source>
        <translation>Ruudustik</translation>
    </message>
    <message>
        <source>Half-way on the screen is not half-way in the world: along an edge 1/w is linear on the screen, and so is s/w, but s is not. If a texture is interpolated linearly (affine), it bends at the diagonal of every quadrangle. Smaller triangles hide this. Twice as many parts leave more than a quarter of the error while they are few, and a quarter in the limit.</source>
        <translation>Poolel teel ekraanil ei ole poolel teel maailmas: piki serva on ekraanil lineaarne 1/w ja samuti s/w, aga mitte s. Kui tekstuuri interpoleeritakse lineaarselt (afiinselt), murdub see iga nelinurga diagonaalil. Väiksemad kolmnurgad peidavad seda. Kui osi on vähe, jätab kaks korda suurem osade arv alles rohkem kui neljandiku veast, piirjuhul täpselt neljandiku.</translation>
    </message>
    <message>
        <source>Hardware</source>
        <translation>Riistvara</translation>
    </message>
    <message>
        <source>Height of the plane</source>
        <translation>Tasandi kõrgus</translation>
    </message>
    <message>
        <source>How a coordinate is stored; 8 to 16 bits are integers over the scene&apos;s box</source>
        <translation>Kuidas koordinaat salvestatakse; 8 kuni 16 bitti on täisarvud üle stseeni risttahuka</translation>
    </message>
    <message>
        <source>How a depth is stored: as an integer or as a float</source>
        <translation>Kuidas sügavus salvestatakse: täisarvu või ujukomaarvuna</translation>
    </message>
    <message>
        <source>How a pixel and its depth become a point of the world</source>
        <translation>Kuidas pikslist ja selle sügavusest saab maailma punkt</translation>
    </message>
    <message>
        <source>How colours fade into the background with distance</source>
        <translation>Kuidas värvid kaugusega tausta sulavad</translation>
    </message>
    <message>
        <source>How distance becomes depth; infinite puts the far plane at infinity</source>
        <translation>Kuidas kaugusest saab sügavus; lõpmatu viib kaugtasandi lõpmatusse</translation>
    </message>
    <message>
        <source>How does the error grow with the rounds?</source>
        <translation>Kuidas viga ringidega kasvab?</translation>
    </message>
    <message>
        <source>How each frame finds its axes: a fast inverse square root takes bits for a logarithm, and one Newton step</source>
        <translation>Kuidas iga kaader oma teljed leiab: kiire pöördruutjuur loeb bitte logaritmina ja teeb ühe Newtoni sammu</translation>
    </message>
    <message>
        <source>How far away the world&apos;s origin lies, along x: coordinates are measured from there</source>
        <translation>Kui kaugel piki x-telge on maailma alguspunkt: koordinaate mõõdetakse sealt</translation>
    </message>
    <message>
        <source>How far from the eye the world&apos;s origin lies: coordinates are measured from there</source>
        <translation>Kui kaugel silmast on maailma alguspunkt: koordinaate mõõdetakse sealt</translation>
    </message>
    <message>
        <source>How far the camera has driven along the avenue</source>
        <translation>Kui kaugele on kaamera mööda alleed sõitnud</translation>
    </message>
    <message>
        <source>How far the origin of the coordinates is from the scene</source>
        <translation>Kui kaugel stseenist on koordinaatide alguspunkt</translation>
    </message>
    <message>
        <source>How long receding edges are drawn</source>
        <translation>Kui pikana sügavusse minevad servad joonistatakse</translation>
    </message>
    <message>
        <source>How many times the camera turns by 360°, in 360 frames each</source>
        <translation>Mitu korda pöördub kaamera 360°, igaüks 360 kaadriga</translation>
    </message>
    <message>
        <source>How the texture&apos;s coordinates are spread over a face</source>
        <translation>Kuidas tekstuuri koordinaadid tahule jaotatakse</translation>
    </message>
    <message>
        <source>How the two cameras look at the screen plane</source>
        <translation>Kuidas kaks kaamerat ekraanitasandit vaatavad</translation>
    </message>
    <message>
        <source>How the two pictures are shown</source>
        <translation>Kuidas kahte pilti näidatakse</translation>
    </message>
    <message>
        <source>How the vertex and the eye are stored before they are subtracted</source>
        <translation>Kuidas tipp ja silm salvestatakse, enne kui need lahutatakse</translation>
    </message>
    <message>
        <source>How vertices are stored and computed; the console stores 16 bits, draws whole pixels and stretches textures</source>
        <translation>Kuidas tippe salvestatakse ja arvutatakse; mängukonsool salvestab 16 bitti, joonistab täispiksleid ja venitab tekstuure</translation>
    </message>
    <message>
        <source>Human eye: 120° across</source>
        <translation>Inimese silm: 120° laiuselt</translation>
    </message>
    <message>
        <source>If you walk past a window, it stays in its wall. The frustum from your eye through it leans, and left and right of the near plane&apos;s window are no longer opposite. Things in the window&apos;s own plane keep their place in the image. Two screens side by side are two such frusta with one eye, and their pictures join without a gap.</source>
        <translation>Kui te aknast mööda kõnnite, jääb see oma seina. Frustum teie silmast läbi akna on kaldu ning lähitasandi akna vasak ja parem ei ole enam vastandarvud. Akna enda tasandil olevad asjad säilitavad pildil oma koha. Kaks kõrvuti ekraani on kaks sellist ühise silmaga frustumit ja nende pildid liituvad ilma vaheta.</translation>
    </message>
    <message>
        <source>Interpolation</source>
        <translation>Interpoleerimine</translation>
    </message>
    <message>
        <source>Inverse of P V</source>
        <translation>P V pöördmaatriks</translation>
    </message>
    <message>
        <source>Inverse of P, then of V</source>
        <translation>P, siis V pöördmaatriks</translation>
    </message>
    <message>
        <source>Is the line PQ straight in the cube?</source>
        <translation>Kas sirge PQ on kuubis sirge?</translation>
    </message>
    <message>
        <source>Its other end, in world coordinates</source>
        <translation>Selle teine ots, maailma koordinaatides</translation>
    </message>
    <message>
        <source>Jitter</source>
        <translation>Värin</translation>
    </message>
    <message>
        <source>Kind of light</source>
        <translation>Valguse liik</translation>
    </message>
    <message>
        <source>Lamp at a point</source>
        <translation>Lamp mingis punktis</translation>
    </message>
    <message>
        <source>Largest disc on 35-mm film that passes for a point: 0.03 mm is usual</source>
        <translation>Suurim ketas 35-mm filmil, mida veel punktiks peetakse: tavaliselt 0.03 mm</translation>
    </message>
    <message>
        <source>Lens and focus</source>
        <translation>Objektiiv ja teravus</translation>
    </message>
    <message>
        <source>Letter F</source>
        <translation>F-täht</translation>
    </message>
    <message>
        <source>Level of detail</source>
        <translation>Detailsus</translation>
    </message>
    <message>
        <source>Light L</source>
        <translation>Valgus L</translation>
    </message>
    <message>
        <source>Light enters a dark box through a small hole. The rays cross there, so the picture on the film behind the hole is upside down and left for right: h&apos; = −d·h/z. The synthetic camera has its centre in place of the hole, and its film at the same distance in front of it. The image has the same size, but it is upright: only the sign changes.</source>
        <translation>Valgus tuleb väikese ava kaudu pimedasse kasti. Kiired ristuvad seal, nii et pilt ava taga oleval filmil on tagurpidi ja vasak on paremal: h&apos; = −d·h/z. Sünteetilise kaamera keskpunkt on ava kohal ja selle film samal kaugusel ava ees. Pilt on sama suur, aga püstine: muutub ainult märk.</translation>
    </message>
    <message>
        <source>Logarithm</source>
        <translation>Logaritm</translation>
    </message>
    <message>
        <source>Lower it below the top of the F.</source>
        <translation>Laske see F-i ülemisest otsast madalamale.</translation>
    </message>
    <message>
        <source>Make N small: how much stays sharp?</source>
        <translation>Tehke N väikeseks: kui palju jääb teravaks?</translation>
    </message>
    <message>
        <source>Make d negative: what turns over?</source>
        <translation>Tehke d negatiivseks: mis pöördub ümber?</translation>
    </message>
    <message>
        <source>Make near larger: do they spread out?</source>
        <translation>Viige lähitasand kaugemale: kas need hajuvad laiali?</translation>
    </message>
    <message>
        <source>Measure from the object: is it smooth?</source>
        <translation>Mõõtke objektist: kas see on sujuv?</translation>
    </message>
    <message>
        <source>Monitor: 30° across</source>
        <translation>Monitor: 30° laiuselt</translation>
    </message>
    <message>
        <source>Move far in: which posts are gone?</source>
        <translation>Tooge kaugtasand lähemale: millised postid on kadunud?</translation>
    </message>
    <message>
        <source>Move near and far close to it.</source>
        <translation>Viige lähi- ja kaugtasand selle lähedale.</translation>
    </message>
    <message>
        <source>Move near and far past the points.</source>
        <translation>Viige lähi- ja kaugtasand punktidest mööda.</translation>
    </message>
    <message>
        <source>Move near and far: which cards cross?</source>
        <translation>Liigutage lähi- ja kaugtasandit: millised kaardid on piiril?</translation>
    </message>
    <message>
        <source>Moves the eye; the field of view keeps the sizes at the target&apos;s distance</source>
        <translation>Liigutab silma; frustumi nurk säilitab suurused sihtpunkti kaugusel</translation>
    </message>
    <message>
        <source>Nothing beyond the far plane is drawn: on a drive along the avenue, trees appear out of nothing, or vanish into it on the way back. Fog hides this if little contrast is left at the far plane. Level of detail draws far trees with fewer vertices, so that the far plane can be farther away at the same cost.</source>
        <translation>Kaugtasandist kaugemal ei joonistata midagi: sõidul mööda alleed ilmuvad puud eikuskilt või kaovad tagasiteel eikuhugi. Udu peidab selle, kui kaugtasandil jääb kontrasti vähe järele. Detailsus joonistab kauged puud vähemate tippudega, nii et kaugtasand võib sama kulu juures olla kaugemal.</translation>
    </message>
    <message>
        <source>Number of parts into which each side of the board is cut</source>
        <translation>Osade arv, milleks laua iga külg on jagatud</translation>
    </message>
    <message>
        <source>Number of pieces of equal length into which the floor is cut from near to far</source>
        <translation>Võrdse pikkusega tükkide arv, milleks põrand on lähedalt kaugele jagatud</translation>
    </message>
    <message>
        <source>Numbers</source>
        <translation>Arvud</translation>
    </message>
    <message>
        <source>Oblique box (oblique)</source>
        <translation>Rööptahukas (kaldnurgaline)</translation>
    </message>
    <message>
        <source>Oblique drawing</source>
        <translation>Kaldnurgaline joonis</translation>
    </message>
    <message>
        <source>Off-axis frusta</source>
        <translation>Teljevälised frustumid</translation>
    </message>
    <message>
        <source>Off-axis window</source>
        <translation>Teljeväline aken</translation>
    </message>
    <message>
        <source>One end of the segment, in world coordinates</source>
        <translation>Lõigu üks ots, maailma koordinaatides</translation>
    </message>
    <message>
        <source>One window</source>
        <translation>Üks aken</translation>
    </message>
    <message>
        <source>One window, or a wall of two screens side by side</source>
        <translation>Üks aken või sein kahest kõrvuti ekraanist</translation>
    </message>
    <message>
        <source>Only parts between light and plane cast a shadow; without clipping, parts above the light cast an anti-shadow, with w &lt; 0</source>
        <translation>Varju heidavad ainult osad, mis on valguse ja tasandi vahel; kärpimata heidavad valgusest kõrgemad osad antivarju, kus w &lt; 0</translation>
    </message>
    <message>
        <source>Only what lies in the view volume is drawn. An eye sees a truncated cone. A perspective lens uses the pyramid around it, because a picture is a rectangle. A parallel lens has a box, straight or oblique: the view from very far away. A test point with a grey name is outside.</source>
        <translation>Joonistatakse ainult see, mis on nähtavas ruumis. Silm näeb pügatud koonust. Perspektiivne objektiiv kasutab selle ümber olevat püramiidi, sest pilt on ristkülik. Paralleelsel objektiivil on risttahukas või rööptahukas: vaade väga kaugelt. Halli nimega katsepunkt on väljas.</translation>
    </message>
    <message>
        <source>P = (1 − t)·C + t·(D : 0): at the corner C for t = 0, at infinity for t = 1; above 1 it comes back from the other side</source>
        <translation>P = (1 − t)·C + t·(D : 0): t = 0 puhul nurgas C, t = 1 puhul lõpmatuses; üle 1 tuleb see tagasi teiselt poolt</translation>
    </message>
    <message>
        <source>P appears</source>
        <translation>P ilmub</translation>
    </message>
    <message>
        <source>P is not in front of the eye, so it has no pixel</source>
        <translation>P ei ole silma ees, seepärast ei ole sellel pikslit</translation>
    </message>
    <message>
        <source>P runs along</source>
        <translation>P liigub piki</translation>
    </message>
    <message>
        <source>P&apos;s image is at infinity</source>
        <translation>P kujutis on lõpmatuses</translation>
    </message>
    <message>
        <source>Parallel edges of the world meet in the image at the vanishing point of their direction. It lies where the ray from the eye in that direction meets the picture. A direction parallel to the picture has no vanishing point, so a box has one, two or three. As w of the point P goes to 0, P goes to infinity, and its image to the vanishing point.</source>
        <translation>Maailma paralleelsed servad kohtuvad pildil oma suuna koondumispunktis. See on seal, kus silmast selles suunas minev kiir lõikab pilti. Pildiga paralleelsel suunal koondumispunkti ei ole, nii et risttahukal on neid üks, kaks või kolm. Kui punkti P w läheneb nullile 0, läheb P lõpmatusse ja selle kujutis koondumispunkti.</translation>
    </message>
    <message>
        <source>Parts a side</source>
        <translation>Osi küljel</translation>
    </message>
    <message>
        <source>Perspective</source>
        <translation>Perspektiiv</translation>
    </message>
    <message>
        <source>Perspective-correct interpolation</source>
        <translation>Perspektiivselt korrektne interpoleerimine</translation>
    </message>
    <message>
        <source>Phone: 5° across</source>
        <translation>Telefon: 5° laiuselt</translation>
    </message>
    <message>
        <source>Photograph: 105 mm at 360 cm</source>
        <translation>Foto: 105 mm 360 cm kauguselt</translation>
    </message>
    <message>
        <source>Photograph: 29 mm at 30 cm</source>
        <translation>Foto: 29 mm 30 cm kauguselt</translation>
    </message>
    <message>
        <source>Picture</source>
        <translation>Pilt</translation>
    </message>
    <message>
        <source>Pictures</source>
        <translation>Pildid</translation>
    </message>
    <message>
        <source>Pieces of the floor</source>
        <translation>Põranda tükid</translation>
    </message>
    <message>
        <source>Planar shadow</source>
        <translation>Vari tasandil</translation>
    </message>
    <message>
        <source>Plane distance d</source>
        <translation>Tasandi kaugus d</translation>
    </message>
    <message>
        <source>Planes that have cut</source>
        <translation>Tasandid, mis on lõiganud</translation>
    </message>
    <message>
        <source>Play the drive: where do trees appear?</source>
        <translation>Esitage sõit: kus puud ilmuvad?</translation>
    </message>
    <message>
        <source>Play the frames.</source>
        <translation>Esitage kaadrid.</translation>
    </message>
    <message>
        <source>Play “From orthographic”.</source>
        <translation>Esitage „Ortograafilisest alates“.</translation>
    </message>
    <message>
        <source>Point P</source>
        <translation>Punkt P</translation>
    </message>
    <message>
        <source>Popping at the far plane</source>
        <translation>Hüppeline ilmumine kaugtasandil</translation>
    </message>
    <message>
        <source>Position</source>
        <translation>Asukoht</translation>
    </message>
    <message>
        <source>Position of the lamp in world coordinates, or the direction to the sun</source>
        <translation>Lambi asukoht maailma koordinaatides või suund päikesele</translation>
    </message>
    <message>
        <source>Pyramid (perspective)</source>
        <translation>Püramiid (perspektiivne)</translation>
    </message>
    <message>
        <source>Ray times depth</source>
        <translation>Kiir korda sügavus</translation>
    </message>
    <message>
        <source>Receding angle</source>
        <translation>Sügavusnurk</translation>
    </message>
    <message>
        <source>Reciprocal 1/w</source>
        <translation>Pöördarv 1/w</translation>
    </message>
    <message>
        <source>Red-cyan, for glasses</source>
        <translation>Puna-tsüaan, prillide jaoks</translation>
    </message>
    <message>
        <source>Renormalise: which numbers stay?</source>
        <translation>Normeerige uuesti: millised arvud jäävad?</translation>
    </message>
    <message>
        <source>Reverse the depth range: why is it better?</source>
        <translation>Pöörake sügavusvahemik ümber: miks on see parem?</translation>
    </message>
    <message>
        <source>Rounds</source>
        <translation>Ringid</translation>
    </message>
    <message>
        <source>Row of posts</source>
        <translation>Postide rida</translation>
    </message>
    <message>
        <source>S = (p·L) I − L pᵀ, plane p = (0, 1, 0, {0}), L = ({1}, {2}, {3}, 0): the direction divided by its largest part, {4}</source>
        <translation>S = (p·L) I − L pᵀ, tasand p = (0, 1, 0, {0}), L = ({1}, {2}, {3}, 0): suund jagatud oma suurima komponendiga, {4}</translation>
    </message>
    <message>
        <source>S = (p·L) I − L pᵀ, plane p = (0, 1, 0, {0}), L = ({1}, {2}, {3}, 1)</source>
        <translation>S = (p·L) I − L pᵀ, tasand p = (0, 1, 0, {0}), L = ({1}, {2}, {3}, 1)</translation>
    </message>
    <message>
        <source>Screen plane</source>
        <translation>Ekraanitasand</translation>
    </message>
    <message>
        <source>Screens</source>
        <translation>Ekraanid</translation>
    </message>
    <message>
        <source>Seen by</source>
        <translation>Vaataja</translation>
    </message>
    <message>
        <source>Set far to 1000: how far off is the floor?</source>
        <translation>Kaugtasand 1000: kui palju on põrand paigast ära?</translation>
    </message>
    <message>
        <source>Set far to 60: does it help as much?</source>
        <translation>Kaugtasand 60: kas see aitab sama palju?</translation>
    </message>
    <message>
        <source>Set near to 0.1: what improves?</source>
        <translation>Lähitasand 0.1: mis paraneb?</translation>
    </message>
    <message>
        <source>Side by side</source>
        <translation>Kõrvuti</translation>
    </message>
    <message>
        <source>Similar triangles</source>
        <translation>Sarnased kolmnurgad</translation>
    </message>
    <message>
        <source>Simpler from</source>
        <translation>Lihtsam alates</translation>
    </message>
    <message>
        <source>Simplest from</source>
        <translation>Kõige lihtsam alates</translation>
    </message>
    <message>
        <source>Snapping</source>
        <translation>Pikslivõrk</translation>
    </message>
    <message>
        <source>Start A</source>
        <translation>Algus A</translation>
    </message>
    <message>
        <source>Step on: which plane adds a corner?</source>
        <translation>Minge edasi: milline tasand lisab nurga?</translation>
    </message>
    <message>
        <source>Stop clipping: on which side is a shadow?</source>
        <translation>Lõpetage kärpimine: kummal pool on vari?</translation>
    </message>
    <message>
        <source>Sun</source>
        <translation>Päike</translation>
    </message>
    <message>
        <source>Surface 2 lies behind surface 1 by the gap, and reaches out at its side. Where the depth buffer stores both with the same code, the surface that is drawn last is seen: z-fighting. With a perspective lens and the standard range most codes lie just behind near, so near matters much more than far. When the scene opens, with its ramp, 63 % of the pixels that both cover are wrong, 0 % with near 0.1, 63 % with far 60. The picture tells codes of up to 24 bits apart exactly.</source>
        <translation>Pind 2 on pinna 1 taga, nende vahe on ette antud, ja ulatub kõrvalt välja. Kus sügavuspuhver salvestab mõlemad sama koodiga, on näha pind, mis joonistatakse viimasena: z-fighting. Perspektiivse objektiivi ja tavalise vahemiku puhul on enamik koode kohe lähitasandi taga, nii et lähitasand loeb palju rohkem kui kaugtasand. Kui stseen avaneb oma kaldteega, on valesid piksleid nende seas, mida mõlemad katavad, 63 %, lähitasandi 0.1 korral 0 %, kaugtasandi 60 korral 63 %. Pilt eristab kuni 24-bitised koodid täpselt.</translation>
    </message>
    <message>
        <source>Switch the detail on: what is saved?</source>
        <translation>Lülitage detailsus sisse: mida säästetakse?</translation>
    </message>
    <message>
        <source>Texture</source>
        <translation>Tekstuur</translation>
    </message>
    <message>
        <source>The direction D of the edge that P follows</source>
        <translation>Serva suund D, mida P järgib</translation>
    </message>
    <message>
        <source>The eye moves to the right by 1 mm a frame, and a unit is 1 m. Far from the origin neighbouring float32 numbers are farther apart than that: the eye stands still for some frames and then jumps, and every vertex jumps with it. In the picture each frame has its own line, from top to bottom: how far P has moved across, enlarged, and pale beside it the smooth path. It helps to measure from a place nearby, or to store each coordinate in two floats.</source>
        <translation>Silm liigub iga kaadriga 1 mm paremale ja ühik on 1 m. Alguspunktist kaugel on naabruses olevate float32-arvude vahe sellest suurem: silm seisab mõne kaadri paigal ja siis hüppab ning iga tipp hüppab koos sellega. Pildil on igal kaadril ülalt alla oma joon: kui palju on P kõrvale liikunud, suurendatult, ja selle kõrval kahvatult sujuv tee. Aitab see, kui mõõta mõnest lähedasest kohast või salvestada iga koordinaat kahe ujukomaarvuna.</translation>
    </message>
    <message>
        <source>The f-number: the lens is opened to f / N, and no lens opens wider than f / 0.5</source>
        <translation>Diafragmaarv: objektiivi ava on f / N ja ükski objektiiv ei avane laiemalt kui f / 0.5</translation>
    </message>
    <message>
        <source>The faces with AB over them, or the edges alone, drawn in one of the three ways</source>
        <translation>Tahud, mille peal on AB, või ainult servad, joonistatud ühel kolmest viisist</translation>
    </message>
    <message>
        <source>The format of every number, sum, product and quotient</source>
        <translation>Iga arvu, summa, korrutise ja jagatise vorming</translation>
    </message>
    <message>
        <source>The format of every sum, product and quotient</source>
        <translation>Iga summa, korrutise ja jagatise vorming</translation>
    </message>
    <message>
        <source>The format of every sum, product and root</source>
        <translation>Iga summa, korrutise ja juure vorming</translation>
    </message>
    <message>
        <source>The grid of the pixels at which vertices are drawn</source>
        <translation>Pikslite ruudustik, millel tipud joonistatakse</translation>
    </message>
    <message>
        <source>The grid on which the vertices of a mesh are stored</source>
        <translation>Ruudustik, millel võrgu tipud salvestatakse</translation>
    </message>
    <message>
        <source>The point whose pixel and depth are known; a click in the image chooses it</source>
        <translation>Punkt, mille piksel ja sügavus on teada; selle valib klõps pildil</translation>
    </message>
    <message>
        <source>The point whose places are compared: parallax is that in the right picture minus that in the left one</source>
        <translation>Punkt, mille kohti võrreldakse: parallaks on koht parempoolsel pildil miinus koht vasakpoolsel</translation>
    </message>
    <message>
        <source>The point whose projector is followed</source>
        <translation>Punkt, mille projektsioonikiirt jälgitakse</translation>
    </message>
    <message>
        <source>The synthetic camera has a point as its lens, and its whole picture is sharp. A real lens draws only points at the focal distance as points, and all others as discs. Between the two limits the discs are no larger than the circle of confusion and pass for points: sharp posts are outlined. The picture is the average of pinhole pictures from all over the lens, and becomes finer while nothing changes. One world unit is 1 m.</source>
        <translation>Sünteetilise kaamera objektiiv on punkt ja kogu selle pilt on terav. Tegelik objektiiv joonistab punktidena ainult punktid teravustamiskaugusel, kõik teised aga ketastena. Kahe piiri vahel ei ole kettad hajumisringist suuremad ja neid peetakse punktideks: teravad postid on kontuuriga. Pilt on nõelaaugupiltide keskmine üle kogu objektiivi ja muutub järjest peenemaks seni, kuni midagi ei muudeta. Üks maailma ühik on 1 m.</translation>
    </message>
    <message>
        <source>Toe the cameras in: is P still level?</source>
        <translation>Pöörake kaamerad kokku: kas P on endiselt ühel kõrgusel?</translation>
    </message>
    <message>
        <source>Toed in</source>
        <translation>Kokku pööratud</translation>
    </message>
    <message>
        <source>Turn the azimuth: when is V at infinity?</source>
        <translation>Muutke asimuuti: millal on V lõpmatuses?</translation>
    </message>
    <message>
        <source>Turn the camera slowly: what jumps?</source>
        <translation>Pöörake kaamerat aeglaselt: mis hüppab?</translation>
    </message>
    <message>
        <source>Turned by</source>
        <translation>Pööramine</translation>
    </message>
    <message>
        <source>Turns the camera about its target</source>
        <translation>Pöörab kaamerat ümber sihtpunkti</translation>
    </message>
    <message>
        <source>Two eyes</source>
        <translation>Kaks silma</translation>
    </message>
    <message>
        <source>Two eyes see the world from two places, and so a stereo pair has two pictures. With off-axis frusta both eyes look through one window, the screen plane: what lies in it does not move between the pictures, what is behind it moves right, and what is before it moves left. Cameras that are toed in to the screen&apos;s middle tilt their pictures against each other, and points at the sides are no longer equally high. A red-cyan picture takes its red light from the left eye&apos;s and the rest from the right eye&apos;s, for glasses with red on the left.</source>
        <translation>Kaks silma näevad maailma kahest kohast ja seepärast on stereopaaris kaks pilti. Teljeväliste frustumitega vaatavad mõlemad silmad läbi ühe akna, milleks on ekraanitasand: mis sellel asub, ei liigu piltide vahel, selle taga olev liigub paremale ja ees olev vasakule. Kaamerad, mis on ekraani keskkoha poole kokku pööratud, kallutavad oma pilte üksteise suhtes ja äärtes olevad punktid ei ole enam ühel kõrgusel. Puna-tsüaan pilt võtab punase valguse vasaku silma pildilt ja ülejäänu parema silma pildilt, prillide jaoks, mille vasak klaas on punane.</translation>
    </message>
    <message>
        <source>Two meshes share a seam. Each stores its vertices in few bits over its own box, and so rounds the same place in its own way: light comes through. The gap is at most half of both steps together along each axis. In a common grid both round alike, and nothing gapes, though the smaller mesh loses its finer steps.</source>
        <translation>Kahel võrgul on ühine õmblus. Kumbki salvestab oma tipud väheste bittidega üle omaenda risttahuka ja ümardab seega sama kohta omamoodi: valgus paistab läbi. Pilu on piki iga telge ülimalt pool mõlema astme summast. Ühisel ruudustikul ümardavad mõlemad ühtemoodi ja pilu ei ole, kuigi väiksem võrk kaotab oma peenemad astmed.</translation>
    </message>
    <message>
        <source>Unit cube</source>
        <translation>Ühikkuup</translation>
    </message>
    <message>
        <source>Up to which frame the path is drawn</source>
        <translation>Mis kaadrini tee joonistatakse</translation>
    </message>
    <message>
        <source>V_x of edges along x</source>
        <translation>x-sihiliste servade V_x</translation>
    </message>
    <message>
        <source>V_y of edges along y</source>
        <translation>y-sihiliste servade V_y</translation>
    </message>
    <message>
        <source>V_z of edges along z</source>
        <translation>z-sihiliste servade V_z</translation>
    </message>
    <message>
        <source>V_{0} is at infinity: edges along {0} stay parallel, at {1}° from the right</source>
        <translation>V_{0} on lõpmatuses: {0}-sihilised servad jäävad paralleelseks, nurgaga {1}° paremalt</translation>
    </message>
    <message>
        <source>Vanishing points</source>
        <translation>Koondumispunktid</translation>
    </message>
    <message>
        <source>Vertices</source>
        <translation>Tipud</translation>
    </message>
    <message>
        <source>View volume</source>
        <translation>Nähtav ruum</translation>
    </message>
    <message>
        <source>View volumes</source>
        <translation>Nähtavad ruumid</translation>
    </message>
    <message>
        <source>Walk past the window: drag the eye.</source>
        <translation>Kõndige aknast mööda: lohistage silma.</translation>
    </message>
    <message>
        <source>Walk round it: drag the azimuth.</source>
        <translation>Kõndige selle ümber: lohistage asimuuti.</translation>
    </message>
    <message>
        <source>Way back</source>
        <translation>Tagasitee</translation>
    </message>
    <message>
        <source>What does cutting before the divide do?</source>
        <translation>Mida teeb lõikamine enne jagamist?</translation>
    </message>
    <message>
        <source>What happens in the cube?</source>
        <translation>Mis juhtub kuubis?</translation>
    </message>
    <message>
        <source>What happens to its shape in the cube?</source>
        <translation>Mis juhtub selle kujuga kuubis?</translation>
    </message>
    <message>
        <source>What happens to the picture?</source>
        <translation>Mis juhtub pildiga?</translation>
    </message>
    <message>
        <source>What stays in its place in the image?</source>
        <translation>Mis jääb pildil oma kohale?</translation>
    </message>
    <message>
        <source>When is everything far away sharp?</source>
        <translation>Millal on kõik kaugel olev terav?</translation>
    </message>
    <message>
        <source>Where do both pictures agree?</source>
        <translation>Kus langevad mõlemad pildid kokku?</translation>
    </message>
    <message>
        <source>Where does the texture bend?</source>
        <translation>Kus tekstuur murdub?</translation>
    </message>
    <message>
        <source>Where in the cube do the posts crowd?</source>
        <translation>Kus kuubis postid tihenevad?</translation>
    </message>
    <message>
        <source>Where it ends; behind the eye its image is mirrored</source>
        <translation>Kus see lõpeb; silma taga on selle kujutis peegeldatud</translation>
    </message>
    <message>
        <source>Where the logarithm of the distance is computed</source>
        <translation>Kus arvutatakse kauguse logaritm</translation>
    </message>
    <message>
        <source>Where the segment starts, in world coordinates</source>
        <translation>Kus lõik algab, maailma koordinaatides</translation>
    </message>
    <message>
        <source>Which edges are parallel in the picture?</source>
        <translation>Millised servad on pildil paralleelsed?</translation>
    </message>
    <message>
        <source>Which edges meet, and where?</source>
        <translation>Millised servad kohtuvad, ja kus?</translation>
    </message>
    <message>
        <source>Which faces keep their shape?</source>
        <translation>Millised tahud säilitavad oma kuju?</translation>
    </message>
    <message>
        <source>Which of A to E are inside now?</source>
        <translation>Millised punktidest A kuni E on nüüd sees?</translation>
    </message>
    <message>
        <source>Which parts grow when you come near?</source>
        <translation>Millised osad kasvavad, kui lähemale tulete?</translation>
    </message>
    <message>
        <source>Which way does the frustum lean?</source>
        <translation>Kuhu poole on frustum kaldu?</translation>
    </message>
    <message>
        <source>Width of the left mesh</source>
        <translation>Vasaku võrgu laius</translation>
    </message>
    <message>
        <source>Width of the left mesh&apos;s box, whose steps grow with it</source>
        <translation>Vasaku võrgu risttahuka laius; selle astmed kasvavad kaasa</translation>
    </message>
    <message>
        <source>Width of the right mesh</source>
        <translation>Parema võrgu laius</translation>
    </message>
    <message>
        <source>Width of the right mesh&apos;s box, whose steps grow with it</source>
        <translation>Parema võrgu risttahuka laius; selle astmed kasvavad kaasa</translation>
    </message>
    <message>
        <source>With a wider field of view the camera must be nearer to show the subject at the same size. Its near parts then look larger compared with its far parts: foreshortening depends on the distance alone. If you change the distance, the field of view follows, so that things at the target&apos;s distance keep their size (a dolly zoom). One unit is 10 cm.</source>
        <translation>Laiema frustumi nurgaga peab kaamera olema lähemal, et motiiv jääks sama suureks. Selle lähedased osad paistavad siis kaugetega võrreldes suuremad: perspektiivne lühenemine sõltub ainult kaugusest. Kui te kaugust muudate, muutub frustumi nurk kaasa, nii et asjad sihtpunkti kaugusel jäävad sama suureks (dolly zoom). Üks ühik on 10 cm.</translation>
    </message>
    <message>
        <source>World y of the plane; at most 0, where the object stands</source>
        <translation>Tasandi y maailmas; ülimalt 0, kus objekt seisab</translation>
    </message>
    <message>
        <source>Your mesh</source>
        <translation>Teie võrk</translation>
    </message>
    <message>
        <source>a corner is behind the eye: until near has cut, there is nothing to draw in NDC</source>
        <translation>üks nurk on silma taga: kuni lähitasand ei ole lõiganud, ei ole NDC-s midagi joonistada</translation>
    </message>
    <message>
        <source>a logarithmic depth buffer needs a perspective lens and a far plane that is not at infinity</source>
        <translation>logaritmiline sügavuspuhver vajab perspektiivset objektiivi ja kaugtasandit, mis ei ole lõpmatuses</translation>
    </message>
    <message>
        <source>a logarithmic depth needs a far plane that is not at infinity</source>
        <translation>logaritmiline sügavus vajab kaugtasandit, mis ei ole lõpmatuses</translation>
    </message>
    <message>
        <source>a parallel lens cannot have its far plane at infinity</source>
        <translation>paralleelse objektiivi kaugtasand ei saa olla lõpmatuses</translation>
    </message>
    <message>
        <source>a parallel lens divides by 1 and has no eye plane: choose a perspective lens</source>
        <translation>paralleelne objektiiv jagab 1-ga ja sellel ei ole silmatasandit: valige perspektiivne objektiiv</translation>
    </message>
    <message>
        <source>a parallel lens divides by 1: its own z&apos; is affine, and nothing is bent</source>
        <translation>paralleelne objektiiv jagab 1-ga: selle z&apos; on ise afiinne ja midagi ei kõverdu</translation>
    </message>
    <message>
        <source>a parallel lens has no eye in which a cone could start: its own volume is shown</source>
        <translation>paralleelsel objektiivil ei ole silma, kust koonus võiks alata: näidatakse selle oma nähtavat ruumi</translation>
    </message>
    <message>
        <source>a parallel lens has no field of view, only a width</source>
        <translation>paralleelsel objektiivil ei ole frustumi nurka, ainult laius</translation>
    </message>
    <message>
        <source>a parallel lens has no focal length: choose a perspective lens to focus it</source>
        <translation>paralleelsel objektiivil ei ole fookuskaugust: teravustamiseks valige perspektiivne objektiiv</translation>
    </message>
    <message>
        <source>a parallel lens has no hole through which all light passes: choose a perspective lens</source>
        <translation>paralleelsel objektiivil ei ole ava, mille kaudu kogu valgus tuleb: valige perspektiivne objektiiv</translation>
    </message>
    <message>
        <source>a perspective lens draws equal edges with unequal lengths: choose the oblique lens</source>
        <translation>perspektiivne objektiiv joonistab võrdsed servad eri pikkusega: valige kaldnurgaline objektiiv</translation>
    </message>
    <message>
        <source>a step is so long that it may lead past the eye: there is no bound</source>
        <translation>üks samm on nii pikk, et see võib silmast mööda viia: tõket ei ole</translation>
    </message>
    <message>
        <source>a vertex of the picture has come behind the drifted camera</source>
        <translation>üks pildi tipp on sattunud triivinud kaamera taha</translation>
    </message>
    <message>
        <source>affine</source>
        <translation>afiinne</translation>
    </message>
    <message>
        <source>affine: s linear on the screen</source>
        <translation>afiinne: s on ekraanil lineaarne</translation>
    </message>
    <message>
        <source>all</source>
        <translation>kõik</translation>
    </message>
    <message>
        <source>an axis is too long or too short by up to</source>
        <translation>telg on liiga pikk või liiga lühike kuni</translation>
    </message>
    <message>
        <source>an axis leans by up to</source>
        <translation>telg on viltu kuni</translation>
    </message>
    <message>
        <source>arrows in the image, enlarged</source>
        <translation>nooled pildil, suurendatud</translation>
    </message>
    <message>
        <source>as drawn</source>
        <translation>nagu joonistatud</translation>
    </message>
    <message>
        <source>at each pixel</source>
        <translation>igas pikslis</translation>
    </message>
    <message>
        <source>at each vertex</source>
        <translation>igas tipus</translation>
    </message>
    <message>
        <source>axis</source>
        <translation>telg</translation>
    </message>
    <message>
        <source>before the screen</source>
        <translation>ekraani ees</translation>
    </message>
    <message>
        <source>behind the screen</source>
        <translation>ekraani taga</translation>
    </message>
    <message>
        <source>bfloat16</source>
        <translation>bfloat16</translation>
    </message>
    <message>
        <source>blur disc</source>
        <translation>hägususketas</translation>
    </message>
    <message>
        <source>blur disc on the film</source>
        <translation>hägususketas filmil</translation>
    </message>
    <message>
        <source>blur of the target</source>
        <translation>sihtpunkti hägusus</translation>
    </message>
    <message>
        <source>both agree only if the lens&apos;s axis meets the middle of the picture; here it meets ({0}, {1}) px, and their sum is twice that</source>
        <translation>mõlemad langevad kokku ainult siis, kui objektiivi telg läbib pildi keskkoha; siin läbib see kohta ({0}, {1}) px ja nende summa on sellest kaks korda suurem</translation>
    </message>
    <message>
        <source>bottom</source>
        <translation>alumine</translation>
    </message>
    <message>
        <source>bound of the error</source>
        <translation>vea tõke</translation>
    </message>
    <message>
        <source>bytes a vertex</source>
        <translation>baiti tipu kohta</translation>
    </message>
    <message>
        <source>cards crossing: to be cut</source>
        <translation>kaardid piiril: lõikamisele</translation>
    </message>
    <message>
        <source>cards outside</source>
        <translation>kaardid väljas</translation>
    </message>
    <message>
        <source>cards whole inside</source>
        <translation>kaardid tervenisti sees</translation>
    </message>
    <message>
        <source>case, by the cut at z = −0.01</source>
        <translation>juhtum, kui lõige on kohal z = −0.01</translation>
    </message>
    <message>
        <source>cheap</source>
        <translation>odav</translation>
    </message>
    <message>
        <source>checks</source>
        <translation>ruudud</translation>
    </message>
    <message>
        <source>circle of confusion</source>
        <translation>hajumisring</translation>
    </message>
    <message>
        <source>clip coordinates are too large for float64 numbers, or lie on one ray of the eye</source>
        <translation>kärperuumi koordinaadid on float64-arvude jaoks liiga suured või asuvad ühel silmast lähtuval kiirel</translation>
    </message>
    <message>
        <source>clipped</source>
        <translation>kärbitud</translation>
    </message>
    <message>
        <source>clipped, then divided</source>
        <translation>kärbitud, siis jagatud</translation>
    </message>
    <message>
        <source>codes of the buffer</source>
        <translation>puhvri koodid</translation>
    </message>
    <message>
        <source>common grid</source>
        <translation>ühine ruudustik</translation>
    </message>
    <message>
        <source>computed: gap and codes are finer than the graphics card&apos;s float32, so the picture shows its noise instead</source>
        <translation>arvutatud: vahe ja koodid on graafikakaardi float32-st peenemad, nii et pilt näitab hoopis selle müra</translation>
    </message>
    <message>
        <source>contrast left where they pop</source>
        <translation>kontrast, mis ilmumisel alles on</translation>
    </message>
    <message>
        <source>corners after it</source>
        <translation>nurki pärast seda</translation>
    </message>
    <message>
        <source>corners before it</source>
        <translation>nurki enne seda</translation>
    </message>
    <message>
        <source>correct</source>
        <translation>korrektne</translation>
    </message>
    <message>
        <source>correct: s/w and 1/w, divided</source>
        <translation>korrektne: s/w ja 1/w, jagatud</translation>
    </message>
    <message>
        <source>cut</source>
        <translation>lõigatud</translation>
    </message>
    <message>
        <source>cut at z = −0.01</source>
        <translation>lõigatud kohal z = −0.01</translation>
    </message>
    <message>
        <source>d over w, 32 of the codes</source>
        <translation>d w järgi, 32 koodi</translation>
    </message>
    <message>
        <source>depth of field</source>
        <translation>teravussügavus</translation>
    </message>
    <message>
        <source>depth z&apos; = A + B/z along the marked edge is, too</source>
        <translation>sügavus z&apos; = A + B/z piki märgitud serva samuti</translation>
    </message>
    <message>
        <source>diameter, mm</source>
        <translation>läbimõõt, mm</translation>
    </message>
    <message>
        <source>distance d to the target</source>
        <translation>kaugus d sihtpunktini</translation>
    </message>
    <message>
        <source>distance of the target, w</source>
        <translation>sihtpunkti kaugus, w</translation>
    </message>
    <message>
        <source>distance, m</source>
        <translation>kaugus, m</translation>
    </message>
    <message>
        <source>divided, not cut</source>
        <translation>jagatud, lõikamata</translation>
    </message>
    <message>
        <source>drawn at</source>
        <translation>joonistatud kohal</translation>
    </message>
    <message>
        <source>drawn by P V, off by</source>
        <translation>joonistatud P V kaudu, viga</translation>
    </message>
    <message>
        <source>drawn by V, then P, off by</source>
        <translation>joonistatud V ja siis P kaudu, viga</translation>
    </message>
    <message>
        <source>drawn floor</source>
        <translation>joonistatud põrand</translation>
    </message>
    <message>
        <source>drift drawn, enlarged</source>
        <translation>joonistatud triiv, suurendatud</translation>
    </message>
    <message>
        <source>each camera turns in by</source>
        <translation>kumbki kaamera pöördub sissepoole</translation>
    </message>
    <message>
        <source>each mesh its own</source>
        <translation>igal võrgul oma</translation>
    </message>
    <message>
        <source>each pixel</source>
        <translation>iga piksel</translation>
    </message>
    <message>
        <source>each vertex</source>
        <translation>iga tipp</translation>
    </message>
    <message>
        <source>edges along {0} are seen end on, as points</source>
        <translation>{0}-sihilised servad on otsevaates, punktidena</translation>
    </message>
    <message>
        <source>edges of the mesh that are counted, and all</source>
        <translation>võrgu servad: arvesse võetud, ja kõik</translation>
    </message>
    <message>
        <source>error of P</source>
        <translation>P viga</translation>
    </message>
    <message>
        <source>error of a jump, measured</source>
        <translation>hüppe viga, mõõdetud</translation>
    </message>
    <message>
        <source>error of a jump, predicted</source>
        <translation>hüppe viga, ennustatud</translation>
    </message>
    <message>
        <source>error of the join</source>
        <translation>liitekoha viga</translation>
    </message>
    <message>
        <source>error, of the distance</source>
        <translation>viga, kauguse suhtes</translation>
    </message>
    <message>
        <source>error, px</source>
        <translation>viga, px</translation>
    </message>
    <message>
        <source>every vertex is as high as the light or higher: none has a shadow on the plane</source>
        <translation>kõik tipud on valgusega samal kõrgusel või kõrgemal: ühelgi ei ole tasandil varju</translation>
    </message>
    <message>
        <source>everything from the target to the far plane may share its code</source>
        <translation>kõik sihtpunktist kaugtasandini võib olla ühesama koodiga</translation>
    </message>
    <message>
        <source>exact</source>
        <translation>täpne</translation>
    </message>
    <message>
        <source>exponential, by its density</source>
        <translation>eksponentsiaalne, tiheduse järgi</translation>
    </message>
    <message>
        <source>faces, with both images of AB</source>
        <translation>tahud koos AB mõlema kujutisega</translation>
    </message>
    <message>
        <source>far</source>
        <translation>kaugtasand</translation>
    </message>
    <message>
        <source>far is infinite, and so is the volume</source>
        <translation>kaugtasand on lõpmatuses ja maht seega lõpmatu</translation>
    </message>
    <message>
        <source>farthest</source>
        <translation>kaugeim</translation>
    </message>
    <message>
        <source>farthest that a vertex of the right seam moves</source>
        <translation>kõige rohkem, mis parema õmbluse tipp nihkub</translation>
    </message>
    <message>
        <source>fast root</source>
        <translation>kiire juur</translation>
    </message>
    <message>
        <source>film</source>
        <translation>film</translation>
    </message>
    <message>
        <source>film in front: +d·h / z</source>
        <translation>film ees: +d·h / z</translation>
    </message>
    <message>
        <source>fixed point 16.16</source>
        <translation>püsikoma 16.16</translation>
    </message>
    <message>
        <source>float of 16 bits</source>
        <translation>ujukoma, 16 bitti</translation>
    </message>
    <message>
        <source>float of 32 bits</source>
        <translation>ujukoma, 32 bitti</translation>
    </message>
    <message>
        <source>float16</source>
        <translation>float16</translation>
    </message>
    <message>
        <source>float32</source>
        <translation>float32</translation>
    </message>
    <message>
        <source>float32, far from the origin</source>
        <translation>float32, alguspunktist kaugel</translation>
    </message>
    <message>
        <source>float32, from the object</source>
        <translation>float32, objektist</translation>
    </message>
    <message>
        <source>float32, from the origin</source>
        <translation>float32, alguspunktist</translation>
    </message>
    <message>
        <source>float64</source>
        <translation>float64</translation>
    </message>
    <message>
        <source>floor</source>
        <translation>põrand</translation>
    </message>
    <message>
        <source>focal length f</source>
        <translation>fookuskaugus f</translation>
    </message>
    <message>
        <source>focal length, 35-mm camera</source>
        <translation>fookuskaugus, 35-mm kaamera</translation>
    </message>
    <message>
        <source>foreshortening, nearest : farthest</source>
        <translation>perspektiivne lühenemine, lähim : kaugeim</translation>
    </message>
    <message>
        <source>found point</source>
        <translation>leitud punkt</translation>
    </message>
    <message>
        <source>foundation</source>
        <translation>alusmüür</translation>
    </message>
    <message>
        <source>frame size minus right end</source>
        <translation>kaadri suurus miinus parem ots</translation>
    </message>
    <message>
        <source>frames in which P stands still</source>
        <translation>kaadrid, milles P seisab paigal</translation>
    </message>
    <message>
        <source>from P to V</source>
        <translation>punktist P punkti V</translation>
    </message>
    <message>
        <source>from there to the ray&apos;s end</source>
        <translation>sealt kiire lõpuni</translation>
    </message>
    <message>
        <source>half floats</source>
        <translation>pooltäpsed ujukomaarvud</translation>
    </message>
    <message>
        <source>half-way along the marked edge on the screen, in the world, from its nearer end</source>
        <translation>ekraanil poolel teel piki märgitud serva, maailmas, selle lähemast otsast</translation>
    </message>
    <message>
        <source>hole</source>
        <translation>ava</translation>
    </message>
    <message>
        <source>horizon</source>
        <translation>horisont</translation>
    </message>
    <message>
        <source>horizontal field of view</source>
        <translation>horisontaalne frustumi nurk</translation>
    </message>
    <message>
        <source>horizontal parallax of P</source>
        <translation>P horisontaalne parallaks</translation>
    </message>
    <message>
        <source>hyperfocal distance H</source>
        <translation>hüperfokaalne kaugus H</translation>
    </message>
    <message>
        <source>if w were linear</source>
        <translation>kui w oleks lineaarne</translation>
    </message>
    <message>
        <source>image of AB</source>
        <translation>AB kujutis</translation>
    </message>
    <message>
        <source>image of P</source>
        <translation>P kujutis</translation>
    </message>
    <message>
        <source>in focus</source>
        <translation>fookus</translation>
    </message>
    <message>
        <source>in its own plane</source>
        <translation>oma tasandil</translation>
    </message>
    <message>
        <source>in the screen</source>
        <translation>ekraanis</translation>
    </message>
    <message>
        <source>inverse of P V</source>
        <translation>P V pöördmaatriks</translation>
    </message>
    <message>
        <source>it keeps</source>
        <translation>alles jääb</translation>
    </message>
    <message>
        <source>its distance z from the hole</source>
        <translation>selle kaugus z avast</translation>
    </message>
    <message>
        <source>its height in the plane through the target is not in the picture</source>
        <translation>selle kõrgust sihtpunkti läbival tasandil pildil ei ole</translation>
    </message>
    <message>
        <source>its image is straight, so no place is the farthest</source>
        <translation>selle kujutis on sirge, nii et kõige kaugemat kohta ei ole</translation>
    </message>
    <message>
        <source>its shadow S·P / w</source>
        <translation>selle vari S·P / w</translation>
    </message>
    <message>
        <source>its volume, cubic units</source>
        <translation>selle ruumala, kuupühikut</translation>
    </message>
    <message>
        <source>join</source>
        <translation>liitekoht</translation>
    </message>
    <message>
        <source>keep x</source>
        <translation>säilita x</translation>
    </message>
    <message>
        <source>keep y</source>
        <translation>säilita y</translation>
    </message>
    <message>
        <source>kind of projection</source>
        <translation>projektsiooni liik</translation>
    </message>
    <message>
        <source>largest deviation, of the length</source>
        <translation>suurim kõrvalekalle, pikkusest</translation>
    </message>
    <message>
        <source>largest error of affine, in texels of 256</source>
        <translation>afiinse suurim viga, tekslites, kokku 256</translation>
    </message>
    <message>
        <source>largest error of affine, on the screen</source>
        <translation>afiinse suurim viga, ekraanil</translation>
    </message>
    <message>
        <source>largest error, by the format of the vertices</source>
        <translation>suurim viga, tippude vormingu järgi</translation>
    </message>
    <message>
        <source>largest error, measured</source>
        <translation>suurim viga, mõõdetud</translation>
    </message>
    <message>
        <source>largest error, predicted</source>
        <translation>suurim viga, ennustatud</translation>
    </message>
    <message>
        <source>largest gap, measured</source>
        <translation>suurim pilu, mõõdetud</translation>
    </message>
    <message>
        <source>largest gap, predicted</source>
        <translation>suurim pilu, ennustatud</translation>
    </message>
    <message>
        <source>largest jump of P between two frames</source>
        <translation>P suurim hüpe kahe kaadri vahel</translation>
    </message>
    <message>
        <source>largest vertical parallax in the screen plane</source>
        <translation>suurim vertikaalne parallaks ekraanitasandil</translation>
    </message>
    <message>
        <source>left</source>
        <translation>vasak</translation>
    </message>
    <message>
        <source>left eye</source>
        <translation>vasak silm</translation>
    </message>
    <message>
        <source>left mesh</source>
        <translation>vasak võrk</translation>
    </message>
    <message>
        <source>left screen</source>
        <translation>vasak ekraan</translation>
    </message>
    <message>
        <source>light</source>
        <translation>valgus</translation>
    </message>
    <message>
        <source>linear, from start to end</source>
        <translation>lineaarne, algusest lõpuni</translation>
    </message>
    <message>
        <source>logarithmic</source>
        <translation>logaritmiline</translation>
    </message>
    <message>
        <source>measured</source>
        <translation>mõõdetud</translation>
    </message>
    <message>
        <source>mesh drawn wrongly</source>
        <translation>võrk valesti joonistatud</translation>
    </message>
    <message>
        <source>mesh missed</source>
        <translation>võrk puudu</translation>
    </message>
    <message>
        <source>mirrored end</source>
        <translation>peegeldatud ots</translation>
    </message>
    <message>
        <source>naive</source>
        <translation>naiivne</translation>
    </message>
    <message>
        <source>naive divide</source>
        <translation>naiivne jagamine</translation>
    </message>
    <message>
        <source>near</source>
        <translation>lähitasand</translation>
    </message>
    <message>
        <source>nearest</source>
        <translation>lähim</translation>
    </message>
    <message>
        <source>no edge of the letter lies in the view volume</source>
        <translation>ükski tähe serv ei ole nähtavas ruumis</translation>
    </message>
    <message>
        <source>no end is behind the eye, so none is mirrored</source>
        <translation>kumbki ots ei ole silma taga, nii et kumbki ei ole peegeldatud</translation>
    </message>
    <message>
        <source>no lens makes a cone: everything in the pyramid around it is drawn</source>
        <translation>ükski objektiiv ei tee koonust: joonistatakse kõik, mis on selle ümber olevas püramiidis</translation>
    </message>
    <message>
        <source>no pixel of the picture shows both surfaces</source>
        <translation>ükski pildi piksel ei näita mõlemat pinda</translation>
    </message>
    <message>
        <source>no tree passes the far plane in the picture</source>
        <translation>pildil ei läbi kaugtasandit ükski puu</translation>
    </message>
    <message>
        <source>no vertex of the scene is in the picture</source>
        <translation>pildil ei ole ühtki stseeni tippu</translation>
    </message>
    <message>
        <source>none</source>
        <translation>pole</translation>
    </message>
    <message>
        <source>none of the examined edges of the mesh lies in the view volume</source>
        <translation>ükski vaadeldud võrgu servadest ei ole nähtavas ruumis</translation>
    </message>
    <message>
        <source>none of the subject&apos;s compared points is in the picture</source>
        <translation>pildil ei ole ühtki motiivi võrreldavat punkti</translation>
    </message>
    <message>
        <source>none yet</source>
        <translation>veel mitte ükski</translation>
    </message>
    <message>
        <source>nothing of the subject is in the picture</source>
        <translation>motiivist ei ole pildil midagi</translation>
    </message>
    <message>
        <source>of P: (x, y, z, −z/d)</source>
        <translation>P homogeensed koordinaadid: (x, y, z, −z/d)</translation>
    </message>
    <message>
        <source>of {0} vertices</source>
        <translation>{0} tipust</translation>
    </message>
    <message>
        <source>off the axis, ({r} + {l})/({r} − {l})</source>
        <translation>teljest kõrvale, ({r} + {l})/({r} − {l})</translation>
    </message>
    <message>
        <source>off-axis</source>
        <translation>teljeväline</translation>
    </message>
    <message>
        <source>on the film: h&apos; = −d·h / z</source>
        <translation>filmil: h&apos; = −d·h / z</translation>
    </message>
    <message>
        <source>one for both</source>
        <translation>üks mõlemale</translation>
    </message>
    <message>
        <source>only the {0} longest of the mesh&apos;s {1} edges are drawn and counted</source>
        <translation>joonistatakse ja võetakse arvesse ainult pikimad servad, {0} võrgu {1} servast</translation>
    </message>
    <message>
        <source>only {0} of the mesh&apos;s {1} edges are drawn and counted: first those that cross the eye plane, then the longest</source>
        <translation>joonistatakse ja võetakse arvesse ainult {0} võrgu {1} servast: enne need, mis läbivad silmatasandit, siis pikimad</translation>
    </message>
    <message>
        <source>opening f / N</source>
        <translation>ava f / N</translation>
    </message>
    <message>
        <source>own boxes</source>
        <translation>oma risttahukad</translation>
    </message>
    <message>
        <source>parallel projection</source>
        <translation>paralleelne projektsioon</translation>
    </message>
    <message>
        <source>part of the subject is beside the eye or behind it</source>
        <translation>osa motiivist on silma kõrval või taga</translation>
    </message>
    <message>
        <source>path in the image, enlarged</source>
        <translation>tee pildil, suurendatud</translation>
    </message>
    <message>
        <source>pixels that show surface 2, which is behind</source>
        <translation>pikslid, mis näitavad taga olevat pinda 2</translation>
    </message>
    <message>
        <source>plane of this step</source>
        <translation>selle sammu tasand</translation>
    </message>
    <message>
        <source>predicted</source>
        <translation>ennustatud</translation>
    </message>
    <message>
        <source>products</source>
        <translation>korrutised</translation>
    </message>
    <message>
        <source>products alone</source>
        <translation>ainult korrutised</translation>
    </message>
    <message>
        <source>products, fast inverse root</source>
        <translation>korrutised, kiire pöördruutjuur</translation>
    </message>
    <message>
        <source>products, renormalised</source>
        <translation>korrutised, uuesti normeeritud</translation>
    </message>
    <message>
        <source>projection, with −1/d</source>
        <translation>projektsioon, koos arvuga −1/d</translation>
    </message>
    <message>
        <source>px</source>
        <translation>px</translation>
    </message>
    <message>
        <source>ray times depth</source>
        <translation>kiir korda sügavus</translation>
    </message>
    <message>
        <source>receding angle as drawn</source>
        <translation>sügavusnurk joonisel</translation>
    </message>
    <message>
        <source>receding edges are seen end on, as points</source>
        <translation>sügavusse minevad servad on otsevaates, punktidena</translation>
    </message>
    <message>
        <source>receding scale as drawn</source>
        <translation>sügavusmastaap joonisel</translation>
    </message>
    <message>
        <source>renormalised</source>
        <translation>uuesti normeeritud</translation>
    </message>
    <message>
        <source>reversed, 1 at near</source>
        <translation>pööratud, lähitasandil 1</translation>
    </message>
    <message>
        <source>right</source>
        <translation>parem</translation>
    </message>
    <message>
        <source>right eye</source>
        <translation>parem silm</translation>
    </message>
    <message>
        <source>right mesh</source>
        <translation>parem võrk</translation>
    </message>
    <message>
        <source>right screen</source>
        <translation>parem ekraan</translation>
    </message>
    <message>
        <source>s red, t green</source>
        <translation>s punane, t roheline</translation>
    </message>
    <message>
        <source>scale d / −z</source>
        <translation>mastaap d / −z</translation>
    </message>
    <message>
        <source>screen plane</source>
        <translation>ekraanitasand</translation>
    </message>
    <message>
        <source>seam</source>
        <translation>õmblus</translation>
    </message>
    <message>
        <source>sharp</source>
        <translation>terav</translation>
    </message>
    <message>
        <source>sharp from</source>
        <translation>terav alates</translation>
    </message>
    <message>
        <source>sharp to</source>
        <translation>terav kuni</translation>
    </message>
    <message>
        <source>sine and cosine of the angle</source>
        <translation>nurga siinus ja koosinus</translation>
    </message>
    <message>
        <source>smallest gap that is sure at the target</source>
        <translation>väikseim vahe, mis on sihtpunkti kaugusel kindel</translation>
    </message>
    <message>
        <source>smooth jump</source>
        <translation>sujuv hüpe</translation>
    </message>
    <message>
        <source>smooth path</source>
        <translation>sujuv tee</translation>
    </message>
    <message>
        <source>standard, 0 at near</source>
        <translation>tavaline, lähitasandil 0</translation>
    </message>
    <message>
        <source>standard, far at infinity</source>
        <translation>tavaline, kaugtasand lõpmatuses</translation>
    </message>
    <message>
        <source>steps of the two grids</source>
        <translation>kahe ruudustiku astmed</translation>
    </message>
    <message>
        <source>stretch</source>
        <translation>venita</translation>
    </message>
    <message>
        <source>subject&apos;s height, at the target&apos;s distance</source>
        <translation>motiivi kõrgus, sihtpunkti kaugusel</translation>
    </message>
    <message>
        <source>sun</source>
        <translation>päike</translation>
    </message>
    <message>
        <source>surface 1</source>
        <translation>pind 1</translation>
    </message>
    <message>
        <source>surface 2</source>
        <translation>pind 2</translation>
    </message>
    <message>
        <source>synthetic film</source>
        <translation>sünteetiline film</translation>
    </message>
    <message>
        <source>t, part of the edge on the screen</source>
        <translation>t, osa servast ekraanil</translation>
    </message>
    <message>
        <source>t, to infinity at 1</source>
        <translation>t, 1 puhul lõpmatusse</translation>
    </message>
    <message>
        <source>table alone</source>
        <translation>ainult tabel</translation>
    </message>
    <message>
        <source>table, 1 Newton step</source>
        <translation>tabel, 1 Newtoni samm</translation>
    </message>
    <message>
        <source>table, 2 Newton steps</source>
        <translation>tabel, 2 Newtoni sammu</translation>
    </message>
    <message>
        <source>test points inside</source>
        <translation>katsepunkte sees</translation>
    </message>
    <message>
        <source>the angles α and β give scale and angle before the picture is stretched</source>
        <translation>nurgad α ja β annavad mastaabi ja nurga enne pildi venitamist</translation>
    </message>
    <message>
        <source>the arrow is behind the hole or beside it: no light comes from it into the box</source>
        <translation>nool on ava taga või kõrval: sellest ei tule kasti valgust</translation>
    </message>
    <message>
        <source>the arrow&apos;s height h</source>
        <translation>noole kõrgus h</translation>
    </message>
    <message>
        <source>the board reaches behind the near plane: the edges that are cut there have no picture</source>
        <translation>laud ulatub lähitasandi taha: seal läbi lõigatud servadel kujutist ei ole</translation>
    </message>
    <message>
        <source>the bound is so large that a vertex may be behind the camera</source>
        <translation>tõke on nii suur, et mõni tipp võib olla kaamera taga</translation>
    </message>
    <message>
        <source>the camera looks straight down or up: there is no floor from near to far</source>
        <translation>kaamera vaatab otse alla või üles: lähedalt kaugele ulatuvat põrandat ei ole</translation>
    </message>
    <message>
        <source>the edge&apos;s pixels are too many or too few for float64 to measure</source>
        <translation>serva piksleid on float64-ga mõõtmiseks liiga palju või liiga vähe</translation>
    </message>
    <message>
        <source>the end lies in the eye plane: its image is at ∞</source>
        <translation>ots on silmatasandil: selle kujutis on kohal ∞</translation>
    </message>
    <message>
        <source>the eye lies in the seam, or the seam behind it: its picture has no width</source>
        <translation>silm on õmblusel või on õmblus selle taga: selle kujutisel ei ole laiust</translation>
    </message>
    <message>
        <source>the far plane is at infinity: nothing pops in</source>
        <translation>kaugtasand on lõpmatuses: midagi ei ilmu äkki</translation>
    </message>
    <message>
        <source>the floor is drawn too far by a factor of up to</source>
        <translation>põrand joonistatakse liiga kaugele, kordajaga kuni</translation>
    </message>
    <message>
        <source>the focal distance {0} m is not beyond the focal length {1} m: nothing so close has an image</source>
        <translation>teravustamiskaugus {0} m ei ole suurem kui fookuskaugus {1} m: nii lähedasel asjal kujutist ei ole</translation>
    </message>
    <message>
        <source>the image on the plane</source>
        <translation>kujutis tasandil</translation>
    </message>
    <message>
        <source>the light is inside the object&apos;s bounds: move it out to see the whole shadow</source>
        <translation>valgus on objekti piiride sees: viige see välja, et kogu varju näha</translation>
    </message>
    <message>
        <source>the line as a circle</source>
        <translation>sirge ringjoonena</translation>
    </message>
    <message>
        <source>the mesh reaches behind the near plane: the edges that are cut there have no picture</source>
        <translation>võrk ulatub lähitasandi taha: seal läbi lõigatud servadel kujutist ei ole</translation>
    </message>
    <message>
        <source>the middle of a 105-mm photograph, enlarged {0} times</source>
        <translation>105-mm foto keskosa, suurendatud {0} korda</translation>
    </message>
    <message>
        <source>the next tree</source>
        <translation>järgmine puu</translation>
    </message>
    <message>
        <source>the object</source>
        <translation>objekt</translation>
    </message>
    <message>
        <source>the origin</source>
        <translation>alguspunkt</translation>
    </message>
    <message>
        <source>the picture is stretched {0} times as much upwards as across: faces do not keep their shape</source>
        <translation>pilt on püstsihis venitatud {0} korda rohkem kui rõhtsihis: tahud ei säilita oma kuju</translation>
    </message>
    <message>
        <source>the picture is stretched: the target&apos;s disc is an ellipse of this width and height</source>
        <translation>pilt on venitatud: sihtpunkti ketas on selle laiuse ja kõrgusega ellips</translation>
    </message>
    <message>
        <source>the point is behind the eye or beside it: its projector meets no plane in front</source>
        <translation>punkt on silma taga või kõrval: selle projektsioonikiir ei kohta ühtki tasandit ees</translation>
    </message>
    <message>
        <source>the point is not in front of both eyes</source>
        <translation>punkt ei ole mõlema silma ees</translation>
    </message>
    <message>
        <source>the projectors of a parallel lens do not meet in an eye: choose a perspective lens</source>
        <translation>paralleelse objektiivi projektsioonikiired ei kohtu silmas: valige perspektiivne objektiiv</translation>
    </message>
    <message>
        <source>the same, counted in the picture</source>
        <translation>sama, pildilt loendatud</translation>
    </message>
    <message>
        <source>the screen plane is before the near plane: nothing that is drawn can lie in it</source>
        <translation>ekraanitasand on lähitasandi ees: miski joonistatu ei saa sellel asuda</translation>
    </message>
    <message>
        <source>the segment is a single point of the cube</source>
        <translation>lõik on kuubi üksainus punkt</translation>
    </message>
    <message>
        <source>the segment lies in the eye plane: its whole image is at infinity</source>
        <translation>lõik on silmatasandil: kogu selle kujutis on lõpmatuses</translation>
    </message>
    <message>
        <source>the segment lies outside the view volume</source>
        <translation>lõik on väljaspool nähtavat ruumi</translation>
    </message>
    <message>
        <source>the segment points at the eye: the image of its whole line is one point</source>
        <translation>lõik on suunatud silma: kogu selle sirge kujutis on üks punkt</translation>
    </message>
    <message>
        <source>the shadow is farther than 1e30 away</source>
        <translation>vari on kaugemal kui 1e30</translation>
    </message>
    <message>
        <source>the subject&apos;s pixels are more than float64 can hold on one of the screens</source>
        <translation>ühel ekraanidest on motiivi piksleid rohkem, kui float64 suudab hoida</translation>
    </message>
    <message>
        <source>the target is not between near and far</source>
        <translation>sihtpunkt ei ole lähi- ja kaugtasandi vahel</translation>
    </message>
    <message>
        <source>the target is so close to the lens that its disc has no finite size</source>
        <translation>sihtpunkt on objektiivile nii lähedal, et selle kettal ei ole lõplikku suurust</translation>
    </message>
    <message>
        <source>the texture is laid over the mesh&apos;s two largest extents; only the {0} triangles with the longest sides are examined</source>
        <translation>tekstuur on laotatud võrgu kahe suurima mõõtme peale; vaadeldakse ainult kõige pikemate külgedega kolmnurki: {0}</translation>
    </message>
    <message>
        <source>the texture is laid over the mesh&apos;s two largest extents; texture coordinates in its file are not used</source>
        <translation>tekstuur on laotatud võrgu kahe suurima mõõtme peale; failis olevaid tekstuuri koordinaate ei kasutata</translation>
    </message>
    <message>
        <source>the view volume cuts PQ: the part inside it, from P&apos; to Q&apos;, is measured</source>
        <translation>nähtav ruum lõikab PQ läbi: mõõdetakse selle sees olevat osa P&apos;-st Q&apos;-ni</translation>
    </message>
    <message>
        <source>the wall reaches behind the eye: a vertex there has no logarithm</source>
        <translation>sein ulatub silma taha: sealsel tipul ei ole logaritmi</translation>
    </message>
    <message>
        <source>there is no error that an arrow could show</source>
        <translation>ei ole viga, mida nool saaks näidata</translation>
    </message>
    <message>
        <source>there is no number: a vertex may be behind the eye</source>
        <translation>arvu ei ole: mõni tipp võib olla silma taga</translation>
    </message>
    <message>
        <source>there is only one screen, and so no join</source>
        <translation>ekraane on ainult üks, seega liitekohta ei ole</translation>
    </message>
    <message>
        <source>there, it is drawn at</source>
        <translation>seal joonistatakse see kohale</translation>
    </message>
    <message>
        <source>there, its distance w</source>
        <translation>seal on selle kaugus w</translation>
    </message>
    <message>
        <source>these are</source>
        <translation>need on</translation>
    </message>
    <message>
        <source>these formats may overflow or divide by 0 here, so there is no bound</source>
        <translation>need vormingud võivad siin üle täituda või jagada 0-ga, seega tõket ei ole</translation>
    </message>
    <message>
        <source>this lens has no inverse whose numbers float64 can hold</source>
        <translation>sellel objektiivil ei ole pöördmaatriksit, mille arve float64 suudaks hoida</translation>
    </message>
    <message>
        <source>this window is too narrow for two screens</source>
        <translation>see aken on kahe ekraani jaoks liiga kitsas</translation>
    </message>
    <message>
        <source>toed in</source>
        <translation>kokku pööratud</translation>
    </message>
    <message>
        <source>too few pixels of the picture show both surfaces to count them</source>
        <translation>piksleid, mis näitavad mõlemat pinda, on pildil loendamiseks liiga vähe</translation>
    </message>
    <message>
        <source>too large or too small for a float64 number</source>
        <translation>float64-arvu jaoks liiga suur või liiga väike</translation>
    </message>
    <message>
        <source>too large or too small for a number in pixels</source>
        <translation>pikslites arvu jaoks liiga suur või liiga väike</translation>
    </message>
    <message>
        <source>top</source>
        <translation>ülemine</translation>
    </message>
    <message>
        <source>trees that pop in each second, driving on at 12 units a second</source>
        <translation>puud, mis igas sekundis ilmuvad, kui sõita edasi 12 ühikut sekundis</translation>
    </message>
    <message>
        <source>trees that pop out each second, driving on</source>
        <translation>puud, mis igas sekundis kaovad, kui sõita edasi</translation>
    </message>
    <message>
        <source>true distance w</source>
        <translation>tegelik kaugus w</translation>
    </message>
    <message>
        <source>truncated cone</source>
        <translation>pügatud koonus</translation>
    </message>
    <message>
        <source>two eyes so far apart have no pictures with this lens</source>
        <translation>nii kaugel teineteisest asuvatel silmadel ei ole selle objektiiviga pilte</translation>
    </message>
    <message>
        <source>two floats</source>
        <translation>kaks ujukomaarvu</translation>
    </message>
    <message>
        <source>two floats, from the origin</source>
        <translation>kaks ujukomaarvu, alguspunktist</translation>
    </message>
    <message>
        <source>upright</source>
        <translation>püstine</translation>
    </message>
    <message>
        <source>upside down and left for right</source>
        <translation>tagurpidi ja vasak on paremal</translation>
    </message>
    <message>
        <source>vertex P</source>
        <translation>tipp P</translation>
    </message>
    <message>
        <source>vertical field of view</source>
        <translation>vertikaalne frustumi nurk</translation>
    </message>
    <message>
        <source>vertical parallax of P</source>
        <translation>P vertikaalne parallaks</translation>
    </message>
    <message>
        <source>vertices drawn</source>
        <translation>joonistatud tipud</translation>
    </message>
    <message>
        <source>vertices drawn without level of detail</source>
        <translation>joonistatud tipud ilma detailsuseta</translation>
    </message>
    <message>
        <source>vertices not below the light</source>
        <translation>tipud, mis ei ole valgusest madalamal</translation>
    </message>
    <message>
        <source>view volume</source>
        <translation>nähtav ruum</translation>
    </message>
    <message>
        <source>w may be 0 in these numbers, so nothing is known</source>
        <translation>w võib nendes arvudes olla 0, nii et midagi ei ole teada</translation>
    </message>
    <message>
        <source>w of P = (1 − t)·C + t·(D : 0)</source>
        <translation>w punktil P = (1 − t)·C + t·(D : 0)</translation>
    </message>
    <message>
        <source>wall against one picture, float64</source>
        <translation>sein võrreldes ühe pildiga, float64</translation>
    </message>
    <message>
        <source>where the floor is drawn</source>
        <translation>kuhu põrand joonistatakse</translation>
    </message>
    <message>
        <source>where: w = √(w_P&apos;·w_Q&apos;)</source>
        <translation>kus: w = √(w_P&apos;·w_Q&apos;)</translation>
    </message>
    <message>
        <source>where: w = √(w_P·w_Q)</source>
        <translation>kus: w = √(w_P·w_Q)</translation>
    </message>
    <message>
        <source>whole pixels</source>
        <translation>täispikslid</translation>
    </message>
    <message>
        <source>width of the gap along the seam</source>
        <translation>pilu laius piki õmblust</translation>
    </message>
    <message>
        <source>window</source>
        <translation>aken</translation>
    </message>
    <message>
        <source>with a parallel lens a box goes through the window, not a frustum from the eye</source>
        <translation>paralleelse objektiivi puhul läbib akent risttahukas, mitte silmast lähtuv frustum</translation>
    </message>
    <message>
        <source>with a parallel lens half-way on the screen is half-way in the world: affine is correct</source>
        <translation>paralleelse objektiivi puhul on poolel teel ekraanil ka poolel teel maailmas: afiinne on korrektne</translation>
    </message>
    <message>
        <source>with a parallel lens parallel edges stay parallel in the image</source>
        <translation>paralleelse objektiivi puhul jäävad paralleelsed servad pildil paralleelseks</translation>
    </message>
    <message>
        <source>with a parallel lens the distance itself is linear on the screen: nobody needs its logarithm</source>
        <translation>paralleelse objektiivi puhul on kaugus ise ekraanil lineaarne: selle logaritmi ei vaja keegi</translation>
    </message>
    <message>
        <source>with far at infinity, no affine z&apos; = A z + B covers all depths: choose a finite far plane</source>
        <translation>kui kaugtasand on lõpmatuses, ei kata ükski afiinne z&apos; = A z + B kõiki sügavusi: valige lõplik kaugtasand</translation>
    </message>
    <message>
        <source>worst edge of the letter F, inside</source>
        <translation>F-tähe halvim serv, sees</translation>
    </message>
    <message>
        <source>worst edge of the mesh, inside</source>
        <translation>võrgu halvim serv, sees</translation>
    </message>
    <message>
        <source>wrong</source>
        <translation>vale</translation>
    </message>
    <message>
        <source>x</source>
        <translation>x</translation>
    </message>
    <message>
        <source>x and y are divided by the distance w. If z were only scaled and shifted, z&apos; = A z + B, a straight segment PQ would be a bow in the cube. Nothing between its ends could then be interpolated or clipped as on a line. With z&apos; = {divided_z} it stays straight.</source>
        <translation>x ja y jagatakse kaugusega w. Kui z-i ainult skaleeritaks ja nihutataks, z&apos; = A z + B, oleks sirge lõik PQ kuubis kaar. Selle otste vahel ei saaks siis midagi interpoleerida ega kärpida nagu sirgel. Valikuga z&apos; = {divided_z} jääb see sirgeks.</translation>
    </message>
    <message>
        <source>y</source>
        <translation>y</translation>
    </message>
    <message>
        <source>your own</source>
        <translation>teie oma</translation>
    </message>
    <message>
        <source>z</source>
        <translation>z</translation>
    </message>
    <message>
        <source>{0} = {1}: is at infinity, so it is a direction and not a point; it must be another than {2}</source>
        <translation>{0} = {1}: on lõpmatuses, seega on see suund ja mitte punkt; see peab olema mõni muu kui {2}</translation>
    </message>
    <message>
        <source>{0} = {1}: must be from 0 to {2}, or P has no pixel and no depth in the picture</source>
        <translation>{0} = {1}: peab olema 0 kuni {2}, muidu ei ole P-l pildil pikslit ega sügavust</translation>
    </message>
    <message>
        <source>{0} is beyond what float64 can hold in pixels</source>
        <translation>{0} ületab selle, mida float64 suudab pikslites hoida</translation>
    </message>
    <message>
        <source>{0} vertices of the picture have no number in these formats: they are drawn where they belong</source>
        <translation>pildi tippude arv, millel nendes vormingutes arvu ei ole: {0}; need joonistatakse sinna, kuhu need kuuluvad</translation>
    </message>
    <message>
        <source>{b}, {t}</source>
        <translation>{b}, {t}</translation>
    </message>
    <message>
        <source>{l}, {r} of the left screen</source>
        <translation>vasaku ekraani {l}, {r}</translation>
    </message>
    <message>
        <source>{l}, {r} of the right screen</source>
        <translation>parema ekraani {l}, {r}</translation>
    </message>
    <message>
        <source>{l}, {r} of the window</source>
        <translation>akna {l}, {r}</translation>
    </message>
    <message>
        <source>½ in the world</source>
        <translation>½ maailmas</translation>
    </message>
    <message>
        <source>½ on the screen</source>
        <translation>½ ekraanil</translation>
    </message>
    <message>
        <source>∞: focused at the hyperfocal distance or beyond, everything far away is sharp</source>
        <translation>∞: kui teravustada hüperfokaalsele kaugusele või kaugemale, on kõik kaugel olev terav</translation>
    </message>
</context>
</TS>
