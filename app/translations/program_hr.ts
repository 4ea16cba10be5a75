<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="hr" sourcelanguage="en">
<context>
    <name>Actions</name>
    <message>
        <source>Scene</source>
        <translation>Scena</translation>
    </message>
    <message>
        <source>The scene in front of the camera</source>
        <translation>Scena pred kamerom</translation>
    </message>
    <message>
        <source>Tools</source>
        <translation>Alati</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Zaustavi</translation>
    </message>
    <message>
        <source>Play</source>
        <translation>Pokreni</translation>
    </message>
    <message>
        <source>&amp;About Frustum Lab</source>
        <translation>&amp;O programu Frustum Lab</translation>
    </message>
    <message>
        <source>&amp;Blank the screen</source>
        <translation>Zatamni &amp;ekran</translation>
    </message>
    <message>
        <source>&amp;Camera</source>
        <translation>&amp;Kamera</translation>
    </message>
    <message>
        <source>&amp;Close the lesson</source>
        <translation>&amp;Zatvori lekciju</translation>
    </message>
    <message>
        <source>&amp;Controls</source>
        <translation>&amp;Kontrole</translation>
    </message>
    <message>
        <source>&amp;Conventions</source>
        <translation>&amp;Dogovori o oznakama</translation>
    </message>
    <message>
        <source>&amp;Copy picture</source>
        <translation>&amp;Kopiraj sliku</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>&amp;Uređivanje</translation>
    </message>
    <message>
        <source>&amp;Export picture…</source>
        <translation>&amp;Izvezi sliku…</translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation>&amp;Datoteka</translation>
    </message>
    <message>
        <source>&amp;Find a control</source>
        <translation>&amp;Nađi kontrolu</translation>
    </message>
    <message>
        <source>&amp;Freely</source>
        <translation>&amp;Slobodno</translation>
    </message>
    <message>
        <source>&amp;Frustum</source>
        <translation>Krnja p&amp;iramida</translation>
    </message>
    <message>
        <source>&amp;Full screen</source>
        <translation>&amp;Cijeli ekran</translation>
    </message>
    <message>
        <source>&amp;Grid</source>
        <translation>Re&amp;šetka</translation>
    </message>
    <message>
        <source>&amp;Handles</source>
        <translation>&amp;Ručice</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>Pomo&amp;ć</translation>
    </message>
    <message>
        <source>&amp;Hint</source>
        <translation>&amp;Savjet</translation>
    </message>
    <message>
        <source>&amp;Keys and mouse</source>
        <translation>&amp;Tipke i miš</translation>
    </message>
    <message>
        <source>&amp;Labels</source>
        <translation>&amp;Oznake</translation>
    </message>
    <message>
        <source>&amp;Layers</source>
        <translation>S&amp;lojevi</translation>
    </message>
    <message>
        <source>&amp;Lessons</source>
        <translation>Lek&amp;cije</translation>
    </message>
    <message>
        <source>&amp;Next step</source>
        <translation>S&amp;ljedeći korak</translation>
    </message>
    <message>
        <source>&amp;Open a lesson…</source>
        <translation>&amp;Otvori lekciju…</translation>
    </message>
    <message>
        <source>&amp;Open…</source>
        <translation>&amp;Otvori…</translation>
    </message>
    <message>
        <source>&amp;Picture on the near plane</source>
        <translation>&amp;Slika na bliskoj ravnini</translation>
    </message>
    <message>
        <source>&amp;Present</source>
        <translation>&amp;Izlaži</translation>
    </message>
    <message>
        <source>&amp;Previous step</source>
        <translation>&amp;Prethodni korak</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>I&amp;zađi</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>Pono&amp;vi</translation>
    </message>
    <message>
        <source>&amp;Reset the panes&apos; own views</source>
        <translation>Vrati po&amp;glede okana</translation>
    </message>
    <message>
        <source>&amp;Review</source>
        <translation>Ponavljan&amp;je</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>&amp;Spremi</translation>
    </message>
    <message>
        <source>&amp;Scenes</source>
        <translation>&amp;Scene</translation>
    </message>
    <message>
        <source>&amp;Show cost</source>
        <translation>P&amp;rikaži trošak</translation>
    </message>
    <message>
        <source>&amp;Show the step again</source>
        <translation>Ponovno po&amp;kaži korak</translation>
    </message>
    <message>
        <source>&amp;Start card</source>
        <translation>&amp;Početna kartica</translation>
    </message>
    <message>
        <source>&amp;Theme</source>
        <translation>&amp;Tema</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Poništi</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>&amp;Pogled</translation>
    </message>
    <message>
        <source>All &amp;digits</source>
        <translation>Sve &amp;znamenke</translation>
    </message>
    <message>
        <source>Along the a&amp;xis</source>
        <translation>Duž &amp;osi</translation>
    </message>
    <message>
        <source>As the s&amp;ystem</source>
        <translation>Kao u s&amp;ustavu</translation>
    </message>
    <message>
        <source>As the system</source>
        <translation>Kao u sustavu</translation>
    </message>
    <message>
        <source>Back to &amp;all panes</source>
        <translation>&amp;Natrag na sva okna</translation>
    </message>
    <message>
        <source>Begin the lesson a&amp;gain</source>
        <translation>Počni lekciju iznov&amp;a</translation>
    </message>
    <message>
        <source>Chec&amp;k the lesson</source>
        <translation>Pro&amp;vjeri lekciju</translation>
    </message>
    <message>
        <source>Co&amp;ntrols of the slide</source>
        <translation>Kontrole sla&amp;jda</translation>
    </message>
    <message>
        <source>Compare s&amp;ide by side or overlaid</source>
        <translation>Usporedi je&amp;dno uz drugo ili preklopljeno</translation>
    </message>
    <message>
        <source>Compare wit&amp;h this picture</source>
        <translation>Usporedi s &amp;ovom slikom</translation>
    </message>
    <message>
        <source>Controls</source>
        <translation>Kontrole</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Kopiraj</translation>
    </message>
    <message>
        <source>Copy the three panes to the clipboard, including the document</source>
        <translation>Kopira tri okna u međuspremnik, zajedno s dokumentom</translation>
    </message>
    <message>
        <source>Dark</source>
        <translation>Tamna</translation>
    </message>
    <message>
        <source>Every topic with its exercises, as you solved them</source>
        <translation>Sve teme s vježbama, onako kako ste ih riješili</translation>
    </message>
    <message>
        <source>Exercises of topics that you choose, without help</source>
        <translation>Vježbe iz tema koje odaberete, bez pomoći</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>Izvoz</translation>
    </message>
    <message>
        <source>Export panes as PNG, SVG, PDF or TikZ; a PNG contains the document</source>
        <translation>Izvozi okna kao PNG, SVG, PDF ili TikZ; PNG sadrži i dokument</translation>
    </message>
    <message>
        <source>Find a control by its name, its letter or what it does</source>
        <translation>Nalazi kontrolu po imenu, slovu ili onome što radi</translation>
    </message>
    <message>
        <source>From &amp;above</source>
        <translation>Odo&amp;zgo</translation>
    </message>
    <message>
        <source>From the &amp;eye</source>
        <translation>Iz &amp;kamere</translation>
    </message>
    <message>
        <source>From the &amp;side</source>
        <translation>Sa s&amp;trane</translation>
    </message>
    <message>
        <source>Go on with the t&amp;est</source>
        <translation>Nas&amp;tavi test</translation>
    </message>
    <message>
        <source>Help</source>
        <translation>Pomoć</translation>
    </message>
    <message>
        <source>Hold the current picture and compare it with later ones, or end the comparison</source>
        <translation>Zadržava trenutačnu sliku i uspoređuje je s kasnijima ili završava usporedbu</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>Jezik</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>Svijetla</translation>
    </message>
    <message>
        <source>Look at the &amp;world</source>
        <translation>Pogled n&amp;a svijet</translation>
    </message>
    <message>
        <source>Measure the cost of every step: the model, each pane&apos;s matrices and repaint</source>
        <translation>Mjeri trošak svakog koraka: model te matrice i crtanje svakog okna</translation>
    </message>
    <message>
        <source>Name e&amp;verything</source>
        <translation>Imenuj &amp;sve</translation>
    </message>
    <message>
        <source>Name everything in the pictures, not only what the scene is about</source>
        <translation>Imenuje sve na slikama, a ne samo ono o čemu scena govori</translation>
    </message>
    <message>
        <source>O&amp;verview…</source>
        <translation>P&amp;regled…</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Otvori</translation>
    </message>
    <message>
        <source>Open &amp;recent</source>
        <translation>Otvori &amp;nedavno</translation>
    </message>
    <message>
        <source>Open a &amp;mesh…</source>
        <translation>Otvori &amp;mrežu…</translation>
    </message>
    <message>
        <source>Open a document, a lesson, a mesh, a camera or an exported picture</source>
        <translation>Otvara dokument, lekciju, mrežu, kameru ili izvezenu sliku</translation>
    </message>
    <message>
        <source>Open a lesson or a talk from its file</source>
        <translation>Otvara lekciju ili izlaganje iz datoteke</translation>
    </message>
    <message>
        <source>P&amp;en</source>
        <translation>Olo&amp;vka</translation>
    </message>
    <message>
        <source>P&amp;ointer in all panes</source>
        <translation>Pokaziva&amp;č u svim oknima</translation>
    </message>
    <message>
        <source>Panes in col&amp;umns</source>
        <translation>Okna u st&amp;upcima</translation>
    </message>
    <message>
        <source>Play or pause the camera&apos;s orbit</source>
        <translation>Pokreće ili zaustavlja kruženje kamere</translation>
    </message>
    <message>
        <source>Present</source>
        <translation>Izlaži</translation>
    </message>
    <message>
        <source>Present from the beginnin&amp;g</source>
        <translation>Izlaži od &amp;početka</translation>
    </message>
    <message>
        <source>Present the open talk from its first step</source>
        <translation>Izlaže otvoreno izlaganje od prvog koraka</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>Ponovi</translation>
    </message>
    <message>
        <source>Reduce &amp;motion</source>
        <translation>&amp;Manje kretanja</translation>
    </message>
    <message>
        <source>Remove the &amp;probe</source>
        <translation>&amp;Ukloni sondu</translation>
    </message>
    <message>
        <source>Remove the chosen probe from the panes</source>
        <translation>Uklanja odabranu sondu iz okana</translation>
    </message>
    <message>
        <source>Reset</source>
        <translation>Vrati</translation>
    </message>
    <message>
        <source>Reset &amp;all</source>
        <translation>Vrati &amp;sve</translation>
    </message>
    <message>
        <source>Reset camera, lens, image and settings to how the scene opens</source>
        <translation>Vraća kameru, objektiv, sliku i postavke na ono s čime se scena otvara</translation>
    </message>
    <message>
        <source>S&amp;peed and accuracy</source>
        <translation>&amp;Brzina i točnost</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Spremi</translation>
    </message>
    <message>
        <source>Save &amp;as…</source>
        <translation>Spremi k&amp;ao…</translation>
    </message>
    <message>
        <source>Show all digits of every number, not only four</source>
        <translation>Prikazuje sve znamenke svakog broja, a ne samo četiri</translation>
    </message>
    <message>
        <source>Show the class a black screen, or the panes again</source>
        <translation>Prikazuje studentima crn ekran ili ponovno okna</translation>
    </message>
    <message>
        <source>Show the next step of a lesson or a talk at once, without a transition</source>
        <translation>Prikazuje sljedeći korak lekcije ili izlaganja odmah, bez prijelaza</translation>
    </message>
    <message>
        <source>Show the pane in the large slot; choose it again to fill the window</source>
        <translation>Prikazuje okno na velikom mjestu; ponovni odabir ispunjava prozor</translation>
    </message>
    <message>
        <source>Show the panes and the essential controls on the full screen, for a class</source>
        <translation>Prikazuje okna i najvažnije kontrole preko cijelog ekrana, za nastavu</translation>
    </message>
    <message>
        <source>Show the step as the lesson&apos;s file has it, without your changes</source>
        <translation>Prikazuje korak kakav je u datoteci lekcije, bez vaših promjena</translation>
    </message>
    <message>
        <source>T&amp;alks</source>
        <translation>Izla&amp;ganja</translation>
    </message>
    <message>
        <source>Test &amp;yourself…</source>
        <translation>Provjerite znanj&amp;e…</translation>
    </message>
    <message>
        <source>The scenes as pictures, lessons, talks, and recent files</source>
        <translation>Scene u slikama, lekcije, izlaganja i nedavne datoteke</translation>
    </message>
    <message>
        <source>Try everything in the lesson&apos;s file</source>
        <translation>Isprobava sve u datoteci lekcije</translation>
    </message>
    <message>
        <source>Two-minute &amp;tour</source>
        <translation>O&amp;bilazak u dvije minute</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Poništi</translation>
    </message>
    <message>
        <source>What a renderer gives up to be fast: trades as pictures, measured</source>
        <translation>Čega se program za iscrtavanje odriče radi brzine: kompromisi u slikama, izmjereni</translation>
    </message>
    <message>
        <source>What you did not solve alone comes back after 1, 3 and 7 days</source>
        <translation>Što niste riješili sami, vraća se nakon 1, 3 i 7 dana</translation>
    </message>
    <message>
        <source>While presenting, draw on the slide, or put the pen away</source>
        <translation>Tijekom izlaganja crta po slajdu ili odlaže olovku</translation>
    </message>
    <message>
        <source>While presenting, mark in all panes the point under the mouse</source>
        <translation>Tijekom izlaganja označava u svim oknima točku pod mišem</translation>
    </message>
    <message>
        <source>While presenting, show the controls of the slide below it, or hide them</source>
        <translation>Tijekom izlaganja prikazuje ispod slajda njegove kontrole ili ih skriva</translation>
    </message>
    <message>
        <source>{0} in large</source>
        <translation>{0}: veliko okno</translation>
    </message>
    <message>
        <source>Speaker&apos;s &amp;window</source>
        <translation>Prozor predava&amp;ča</translation>
    </message>
    <message>
        <source>Open it when a talk is presente&amp;d</source>
        <translation>Otvori ga kad se &amp;izlaže</translation>
    </message>
    <message>
        <source>Add th&amp;is state as a step…</source>
        <translation>&amp;Dodaj ovo stanje kao korak…</translation>
    </message>
    <message>
        <source>A new talk fro&amp;m here…</source>
        <translation>&amp;Novo izlaganje odavde…</translation>
    </message>
</context>
<context>
    <name>Adaptive</name>
    <message>
        <source>Making coarser versions of the scene</source>
        <translation>Izrađuju se grublje inačice scene</translation>
    </message>
</context>
<context>
    <name>AnimationBar</name>
    <message>
        <source>Play</source>
        <translation>Pokreni</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Brzina</translation>
    </message>
    <message>
        <source>Angle per second of the walk round the vertical through the target; below 0 the camera walks the other way.</source>
        <translation>Kut u sekundi pri obilasku oko vertikale kroz cilj; ispod 0 kamera kruži u drugom smjeru.</translation>
    </message>
    <message>
        <source>°/s</source>
        <translation>°/s</translation>
    </message>
    <message>
        <source>degrees per second</source>
        <translation>stupnjeva u sekundi</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Visina</translation>
    </message>
    <message>
        <source>How the eye&apos;s y changes during the walk (the exercise of lecture 004).</source>
        <translation>Kako se tijekom obilaska mijenja y kamere (vježba iz predavanja 004).</translation>
    </message>
    <message>
        <source>fixed</source>
        <translation>stalna</translation>
    </message>
    <message>
        <source>The eye keeps its y.</source>
        <translation>Kamera zadržava svoj y.</translation>
    </message>
    <message>
        <source>swinging smoothly</source>
        <translation>glatko se njiše</translation>
    </message>
    <message>
        <source>The eye&apos;s y swings between the lowest and the highest value.</source>
        <translation>y kamere njiše se između najniže i najviše vrijednosti.</translation>
    </message>
    <message>
        <source>in steps</source>
        <translation>u skokovima</translation>
    </message>
    <message>
        <source>The eye&apos;s y jumps to the next of four values every 2 seconds.</source>
        <translation>y kamere skače svake 2 sekunde na sljedeću od četiri vrijednosti.</translation>
    </message>
    <message>
        <source>units</source>
        <translation>jedinica</translation>
    </message>
    <message>
        <source>world units</source>
        <translation>globalnih jedinica</translation>
    </message>
    <message>
        <source>Lowest</source>
        <translation>Najniža</translation>
    </message>
    <message>
        <source>The lowest y of the eye while its height changes.</source>
        <translation>Najniži y kamere dok se njezina visina mijenja.</translation>
    </message>
    <message>
        <source>Highest</source>
        <translation>Najviša</translation>
    </message>
    <message>
        <source>The highest y of the eye while its height changes.</source>
        <translation>Najviši y kamere dok se njezina visina mijenja.</translation>
    </message>
    <message>
        <source>Look</source>
        <translation>Pogled</translation>
    </message>
    <message>
        <source>Where the camera looks during the walk.</source>
        <translation>Kamo kamera gleda tijekom obilaska.</translation>
    </message>
    <message>
        <source>at the target</source>
        <translation>prema cilju</translation>
    </message>
    <message>
        <source>The target stays in place.</source>
        <translation>Cilj ostaje na mjestu.</translation>
    </message>
    <message>
        <source>level</source>
        <translation>horizontalno</translation>
    </message>
    <message>
        <source>The target gets the eye&apos;s y: the camera looks horizontally.</source>
        <translation>Cilj dobiva y kamere: kamera gleda horizontalno.</translation>
    </message>
    <message>
        <source>The camera is straight below the target and cannot look level.</source>
        <translation>Kamera je točno ispod cilja i ne može gledati horizontalno.</translation>
    </message>
    <message>
        <source>The camera stands straight above the target and cannot look level.</source>
        <translation>Kamera je točno iznad cilja i ne može gledati horizontalno.</translation>
    </message>
    <message>
        <source>The camera is at the target and cannot look at it.</source>
        <translation>Kamera je u cilju i ne može gledati prema njemu.</translation>
    </message>
    <message>
        <source>The camera would look along its own up vector.</source>
        <translation>Kamera bi gledala duž svojega smjera prema gore.</translation>
    </message>
    <message>
        <source>Walk round the target, as in the exercise of lecture 004.</source>
        <translation>Kruži oko cilja, kao u vježbi iz predavanja 004.</translation>
    </message>
    <message>
        <source>Pause here; playing continues from here.</source>
        <translation>Zaustavlja ovdje; nastavlja se odavde.</translation>
    </message>
    <message>
        <source>Stopped.</source>
        <translation>Zaustavljeno.</translation>
    </message>
</context>
<context>
    <name>BlockView</name>
    <message>
        <source>Hand it &amp;in</source>
        <translation>P&amp;redaj</translation>
    </message>
    <message>
        <source>This is my answer; there is one try (Enter)</source>
        <translation>Ovo je moj odgovor; pokušaj je jedan (Enter)</translation>
    </message>
    <message>
        <source>Chec&amp;k</source>
        <translation>Provj&amp;eri</translation>
    </message>
    <message>
        <source>Enter</source>
        <translation>Enter</translation>
    </message>
    <message>
        <source>Kept</source>
        <translation>Zabilježeno</translation>
    </message>
    <message>
        <source>Your answer is kept until the end.</source>
        <translation>Vaš je odgovor zabilježen do kraja.</translation>
    </message>
    <message>
        <source>Hint {0}:</source>
        <translation>Savjet {0}:</translation>
    </message>
    <message>
        <source>Hint:</source>
        <translation>Savjet:</translation>
    </message>
    <message>
        <source>Show the right answer, and why it is right (Alt+A)</source>
        <translation>Prikazuje točan odgovor i zašto je točan (Alt+G)</translation>
    </message>
    <message>
        <source>Show the &amp;answer</source>
        <translation>Prikaži od&amp;govor</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>Točno</translation>
    </message>
    <message>
        <source>Right.</source>
        <translation>Točno.</translation>
    </message>
    <message>
        <source>The idea behind it: “{0}”.</source>
        <translation>Predodžba iza toga: „{0}”.</translation>
    </message>
    <message>
        <source>Wrong</source>
        <translation>Netočno</translation>
    </message>
    <message>
        <source>That is not it.</source>
        <translation>To nije to.</translation>
    </message>
    <message>
        <source>Show a state that makes it visible (Alt+W)</source>
        <translation>Prikazuje stanje u kojem se to vidi (Alt+K)</translation>
    </message>
    <message>
        <source>Sho&amp;w it</source>
        <translation>Po&amp;kaži</translation>
    </message>
    <message>
        <source>Show the picture with your number beside that with the model&apos;s (Alt+M)</source>
        <translation>Prikazuje sliku s vašim brojem pokraj slike s brojem iz modela (Alt+M)</translation>
    </message>
    <message>
        <source>Your idea beside the &amp;model</source>
        <translation>Vaša zamisao uz &amp;model</translation>
    </message>
</context>
<context>
    <name>CellWords</name>
    <message>
        <source>It depends on no control.</source>
        <translation>Ne ovisi ni o jednoj kontroli.</translation>
    </message>
    <message>
        <source>It depends on: {0}.</source>
        <translation>Ovisi o kontrolama: {0}.</translation>
    </message>
    <message>
        <source>row {0}, column {1}</source>
        <translation>redak {0}, stupac {1}</translation>
    </message>
    <message>
        <source>Double-click or press Enter to type another number, or a fraction such as 1/3.</source>
        <translation>Dvaput kliknite ili pritisnite Enter i upišite drugi broj ili razlomak, npr. 1/3.</translation>
    </message>
    <message>
        <source>The world&apos;s {1} component of the camera&apos;s axis {0}: it adds {3} times {1} to {2}.</source>
        <translation>Globalna komponenta {1} osi kamere {0}: dodaje {3} puta {1} koordinati {2}.</translation>
    </message>
    <message>
        <source>The {0} of the eye, where view space has its origin.</source>
        <translation>Koordinata {0} položaja kamere, u kojem je ishodište koordinatnog sustava kamere.</translation>
    </message>
    <message>
        <source>The world&apos;s {1} component of the camera&apos;s axis {0}.</source>
        <translation>Globalna komponenta {1} osi kamere {0}.</translation>
    </message>
    <message>
        <source>It scales {0} by {2}.</source>
        <translation>Skalira {0} faktorom {2}.</translation>
    </message>
    <message>
        <source>It leaves the scale of {0} unchanged.</source>
        <translation>Ne mijenja mjerilo koordinate {0}.</translation>
    </message>
    <message>
        <source>It scales {0} by {2}, which reverses its direction.</source>
        <translation>Skalira {0} faktorom {2}, čime joj okreće smjer.</translation>
    </message>
    <message>
        <source>It adds {2} times {1} to {0}: a shear.</source>
        <translation>Dodaje {2} puta {1} koordinati {0}: smicanje.</translation>
    </message>
    <message>
        <source>{0} does not depend on {1}.</source>
        <translation>{0} ne ovisi o koordinati {1}.</translation>
    </message>
    <message>
        <source>It does not shift {0}.</source>
        <translation>Ne pomiče {0}.</translation>
    </message>
    <message>
        <source>It shifts {0} by {2}.</source>
        <translation>Pomiče {0} za {2}.</translation>
    </message>
    <message>
        <source>It adds {2} to {0} before the divide, and so {2}/w to the quotient.</source>
        <translation>Dodaje {2} koordinati {0} prije dijeljenja, a time {2}/w kvocijentu.</translation>
    </message>
    <message>
        <source>It adds {1} times {0} to w, the divisor.</source>
        <translation>Dodaje {1} puta {0} djelitelju w.</translation>
    </message>
    <message>
        <source>w does not depend on {0}.</source>
        <translation>w ne ovisi o koordinati {0}.</translation>
    </message>
    <message>
        <source>It scales w, the divisor, by {1}.</source>
        <translation>Skalira djelitelj w faktorom {1}.</translation>
    </message>
    <message>
        <source>It leaves w unchanged.</source>
        <translation>Ne mijenja w.</translation>
    </message>
    <message>
        <source>It makes w, the divisor, the distance −z: perspective.</source>
        <translation>Djelitelj w čini udaljenošću −z: perspektiva.</translation>
    </message>
    <message>
        <source>It adds {1} to w, the divisor.</source>
        <translation>Dodaje {1} djelitelju w.</translation>
    </message>
    <message>
        <source>the incoming w</source>
        <translation>ulazni w</translation>
    </message>
</context>
<context>
    <name>ChainEditor</name>
    <message>
        <source>View: the camera&apos;s moves undone</source>
        <translation>Pogled: poništeni pokreti kamere</translation>
    </message>
    <message>
        <source>The view as R T, or as the inverse of each move</source>
        <translation>Pogled kao R T ili kao inverz svakog pokreta</translation>
    </message>
    <message>
        <source>Add a tile</source>
        <translation>Dodaj pločicu</translation>
    </message>
    <message>
        <source>It acts last: left of the others</source>
        <translation>Djeluje posljednja: lijevo od ostalih</translation>
    </message>
    <message>
        <source>Letters</source>
        <translation>Slova</translation>
    </message>
    <message>
        <source>Row vectors</source>
        <translation>Vektori retci</translation>
    </message>
    <message>
        <source>Show its factors in Matrices</source>
        <translation>Prikaži njegove faktore u ploči Matrice</translation>
    </message>
    <message>
        <source>The tile at the bottom acts first.</source>
        <translation>Pločica na dnu djeluje prva.</translation>
    </message>
    <message>
        <source>Show the scene after this factor</source>
        <translation>Prikaži scenu nakon ovog faktora</translation>
    </message>
</context>
<context>
    <name>ChoiceView</name>
    <message>
        <source>&amp;Commit</source>
        <translation>Po&amp;tvrdi</translation>
    </message>
    <message>
        <source>This is my prediction (Enter)</source>
        <translation>Ovo je moje predviđanje (Enter)</translation>
    </message>
    <message>
        <source>Choose one first: with the arrow keys, or a click.</source>
        <translation>Najprije odaberite: strelicama ili klikom.</translation>
    </message>
    <message>
        <source>The answer is {0}.</source>
        <translation>Odgovor je {0}.</translation>
    </message>
    <message>
        <source>The model&apos;s answer</source>
        <translation>Odgovor modela</translation>
    </message>
    <message>
        <source>Your choice</source>
        <translation>Vaš izbor</translation>
    </message>
    <message>
        <source>You said {0}; the model says {1}.</source>
        <translation>Vi kažete {0}; model kaže {1}.</translation>
    </message>
    <message>
        <source>Show what happens</source>
        <translation>Pokaži što se događa</translation>
    </message>
    <message>
        <source>Show the model&apos;s answer once more</source>
        <translation>Prikazuje odgovor modela još jednom</translation>
    </message>
</context>
<context>
    <name>ClickView</name>
    <message>
        <source>world</source>
        <translation>svijet</translation>
    </message>
    <message>
        <source>NDC cube</source>
        <translation>kocka NDC</translation>
    </message>
    <message>
        <source>image</source>
        <translation>slika</translation>
    </message>
    <message>
        <source>Click in the picture: {0}</source>
        <translation>Kliknite na slici: {0}</translation>
    </message>
    <message>
        <source>Click there; or here, then move the crosshair with the arrow keys (Enter)</source>
        <translation>Kliknite tamo; ili ovdje, pa pomičite križić strelicama (Enter)</translation>
    </message>
    <message>
        <source>The picture shows something else now.</source>
        <translation>Slika sada prikazuje nešto drugo.</translation>
    </message>
    <message>
        <source>Show it a&amp;gain</source>
        <translation>Pokaži p&amp;onovno</translation>
    </message>
    <message>
        <source>Show the state of the question</source>
        <translation>Prikazuje stanje iz pitanja</translation>
    </message>
</context>
<context>
    <name>Command</name>
    <message>
        <source>, or in .html for a page</source>
        <translation>, ili na .html za stranicu</translation>
    </message>
    <message>
        <source>--batch = {0!r}: has no documents (.json, .md) and no meshes.</source>
        <translation>--batch = {0!r}: nema ni dokumenata (.json, .md) ni mreža.</translation>
    </message>
    <message>
        <source>--batch: takes one name, the folder of the figures.</source>
        <translation>--batch: prima jedno ime, mapu za slike.</translation>
    </message>
    <message>
        <source>--chart = {0!r}: must end in {1}.</source>
        <translation>--chart = {0!r}: mora završavati na {1}.</translation>
    </message>
    <message>
        <source>--csv: is an option of lesson results, not of lesson {0}.</source>
        <translation>--csv: opcija je naredbe lesson results, a ne lesson {0}.</translation>
    </message>
    <message>
        <source>--for: needs --handout OUT.pdf.</source>
        <translation>--for: treba --handout OUT.pdf.</translation>
    </message>
    <message>
        <source>--format: is for a folder or a lesson; in a list the endings decide.</source>
        <translation>--format: vrijedi za mapu ili lekciju; u popisu odlučuju nastavci imena.</translation>
    </message>
    <message>
        <source>--handout = {0!r}: must end in .pdf or .html.</source>
        <translation>--handout = {0!r}: mora završavati na .pdf ili .html.</translation>
    </message>
    <message>
        <source>--hidden: is for .svg, .pdf, .tex and .html, whose lines are shapes.</source>
        <translation>--hidden: vrijedi za .svg, .pdf, .tex i .html, u kojima su linije oblici.</translation>
    </message>
    <message>
        <source>--letters: is an option of lesson check and print, not of lesson {0}.</source>
        <translation>--letters: opcija je naredbi lesson check i print, a ne lesson {0}.</translation>
    </message>
    <message>
        <source>--orbit = {0:g}: must be from -{1:g} to {1:g} degrees, not 0.</source>
        <translation>--orbit = {0:g}: mora biti od -{1:g} do {1:g} stupnjeva, a ne 0.</translation>
    </message>
    <message>
        <source>--orbit: needs the pane world, and --panes = {0!r}.</source>
        <translation>--orbit: treba okno world, a --panes = {0!r}.</translation>
    </message>
    <message>
        <source>--out = {0!r}: cannot be made a folder: {1}.</source>
        <translation>--out = {0!r}: ne može postati mapa: {1}.</translation>
    </message>
    <message>
        <source>--panes = {0!r}: must be a row or a column, not both.</source>
        <translation>--panes = {0!r}: mora biti redak ili stupac, a ne oboje.</translation>
    </message>
    <message>
        <source>--scale: is for .png; shapes are as fine at every scale.</source>
        <translation>--scale: vrijedi za .png; oblici su jednako fini u svakom mjerilu.</translation>
    </message>
    <message>
        <source>--screenshot = {0!r}: must end in .png.</source>
        <translation>--screenshot = {0!r}: mora završavati na .png.</translation>
    </message>
    <message>
        <source>--seeds = {0!r}: has {1} variants; the limit is {2}.</source>
        <translation>--seeds = {0!r}: ima previše varijanti, {1}; granica je {2}.</translation>
    </message>
    <message>
        <source>--seeds = {0!r}: must be FIRST:LAST, such as 1:30, from 1 to {1}.</source>
        <translation>--seeds = {0!r}: mora biti FIRST:LAST, npr. 1:30, od 1 do {1}.</translation>
    </message>
    <message>
        <source>--set scene: the steps of a lesson have scenes of their own.</source>
        <translation>--set scene: koraci lekcije imaju vlastite scene.</translation>
    </message>
    <message>
        <source>--set {0}: {1} is a lesson, whose steps set what is shown.</source>
        <translation>--set {0}: {1} je lekcija, čiji koraci određuju što se prikazuje.</translation>
    </message>
    <message>
        <source>--size = {0!r}: must be WIDTHxHEIGHT in pixels, such as 1800x600.</source>
        <translation>--size = {0!r}: mora biti WIDTHxHEIGHT u pikselima, npr. 1800x600.</translation>
    </message>
    <message>
        <source>       … and {0} more; --csv has them all</source>
        <translation>       … i još {0}; --csv ima sve</translation>
    </message>
    <message>
        <source>  installing packages: {0}</source>
        <translation>  instaliram pakete: {0}</translation>
    </message>
    <message>
        <source> (cancelled)</source>
        <translation> (prekinuto)</translation>
    </message>
    <message>
        <source> failed</source>
        <translation> nije uspjelo</translation>
    </message>
    <message>
        <source> is there already</source>
        <translation> već postoji</translation>
    </message>
    <message>
        <source>, or have one number such as %03d</source>
        <translation>, ili imati jedan broj kao %03d</translation>
    </message>
    <message>
        <source>--size, --width and --text-size: need --chart.</source>
        <translation>--size, --width i --text-size: trebaju --chart.</translation>
    </message>
    <message>
        <source>--stages: needs the pane ndc, and --panes = {0!r}.</source>
        <translation>--stages: treba okno ndc, a --panes = {0!r}.</translation>
    </message>
    <message>
        <source>--step = {0!r}: must be a number from 1 to {1}, or the name of a step{2}.</source>
        <translation>--step = {0!r}: mora biti broj od 1 do {1} ili ime koraka{2}.</translation>
    </message>
    <message>
        <source>--step: is a column of the list of --batch.</source>
        <translation>--step: stupac je popisa za --batch.</translation>
    </message>
    <message>
        <source>--step: needs a lesson or a talk as FILE.</source>
        <translation>--step: treba lekciju ili izlaganje kao FILE.</translation>
    </message>
    <message>
        <source>--sweep {0} = &apos;&apos;: must be LOW:HIGH, such as 0.001:10.</source>
        <translation>--sweep {0} = &apos;&apos;: mora biti LOW:HIGH, npr. 0.001:10.</translation>
    </message>
    <message>
        <source>--sweep {0} = {1!r}: must be LOW:HIGH, such as 0.001:10.</source>
        <translation>--sweep {0} = {1!r}: mora biti LOW:HIGH, npr. 0.001:10.</translation>
    </message>
    <message>
        <source>--sweep {0} = {1!r}: must have LOW below HIGH, both from {2:g} to {3:.15g}.</source>
        <translation>--sweep {0} = {1!r}: LOW mora biti manje od HIGH, oboje od {2:g} do {3:.15g}.</translation>
    </message>
    <message>
        <source>--topics = {0!r}: has no exercise that can be solved on paper.</source>
        <translation>--topics = {0!r}: nema nijedne vježbe koja se može riješiti na papiru.</translation>
    </message>
    <message>
        <source>--topics = {0!r}: must be topics from L1 to L{1}, or files of lessons, separated by commas.</source>
        <translation>--topics = {0!r}: mora sadržavati teme od L1 do L{1} ili datoteke lekcija, odvojene zarezima.</translation>
    </message>
    <message>
        <source>--topics = {0!r}: names {1} twice.</source>
        <translation>--topics = {0!r}: imenuje {1} dvaput.</translation>
    </message>
    <message>
        <source>--transition: needs a lesson or a talk as FILE, and --step.</source>
        <translation>--transition: treba lekciju ili izlaganje kao FILE, i --step.</translation>
    </message>
    <message>
        <source>--transition: no step comes before --step {0}.</source>
        <translation>--transition: prije --step {0} nema nijednog koraka.</translation>
    </message>
    <message>
        <source>--transition: step {0} shows another scene or another kind of lens than the step before; nothing moves from one to the other.</source>
        <translation>--transition: korak {0} prikazuje drugu scenu ili drugu vrstu objektiva nego prethodni; od jednoga do drugoga ništa se ne pomiče.</translation>
    </message>
    <message>
        <source>--transition: step {0} shows the same as the step before.</source>
        <translation>--transition: korak {0} prikazuje isto što i prethodni.</translation>
    </message>
    <message>
        <source>--transparent: {0} has {1}; write .apng or .webp.</source>
        <translation>--transparent: {0} ima {1}; zapišite .apng ili .webp.</translation>
    </message>
    <message>
        <source>--vectors: needs --convention.</source>
        <translation>--vectors: treba --convention.</translation>
    </message>
    <message>
        <source>--width = {0!r}: must be a length in {1} from {2}pt to {3}pt, such as 84mm.</source>
        <translation>--width = {0!r}: mora biti duljina u {1}, od {2}pt do {3}pt, npr. 84mm.</translation>
    </message>
    <message>
        <source>--width: is cropped, and its height is free; leave out --size and --crop.</source>
        <translation>--width: slika se obrezuje i visina joj je slobodna; izostavite --size i --crop.</translation>
    </message>
    <message>
        <source>--width: its height is free; leave out --size.</source>
        <translation>--width: visina je slobodna; izostavite --size.</translation>
    </message>
    <message>
        <source>--{0}: cannot be used with --{1}.</source>
        <translation>--{0}: ne može se koristiti zajedno s --{1}.</translation>
    </message>
    <message>
        <source>--{0}: frames of a film have one size; set --size.</source>
        <translation>--{0}: kadrovi filma imaju istu veličinu; postavite --size.</translation>
    </message>
    <message>
        <source>--{0}: is an option of lesson print, not of lesson {1}.</source>
        <translation>--{0}: opcija je naredbe lesson print, a ne lesson {1}.</translation>
    </message>
    <message>
        <source>--{0}: is for single figures; frames of a film have one size.</source>
        <translation>--{0}: vrijedi za pojedinačne slike; kadrovi filma imaju istu veličinu.</translation>
    </message>
    <message>
        <source>--{0}: is not for .html, whose pictures change under a slider.</source>
        <translation>--{0}: ne vrijedi za .html, u kojem se slike mijenjaju klizačem.</translation>
    </message>
    <message>
        <source>--{0}: needs --format latex.</source>
        <translation>--{0}: treba --format latex.</translation>
    </message>
    <message>
        <source>--{0}: needs --sweep.</source>
        <translation>--{0}: treba --sweep.</translation>
    </message>
    <message>
        <source>--{0}: needs {1}.</source>
        <translation>--{0}: treba {1}.</translation>
    </message>
    <message>
        <source>--{0}: stands alone, and needs --format text or json.</source>
        <translation>--{0}: stoji samostalno i treba --format text ili json.</translation>
    </message>
    <message>
        <source>; for a film add --sweep, --orbit, --stages or --transition</source>
        <translation>; za film dodajte --sweep, --orbit, --stages ili --transition</translation>
    </message>
    <message>
        <source>; needs the network</source>
        <translation>; treba mreža</translation>
    </message>
    <message>
        <source>; the nearest is {0}</source>
        <translation>; najbliže je {0}</translation>
    </message>
    <message>
        <source>A library cannot be loaded ({0}); {1} doctor says more.</source>
        <translation>Biblioteka se ne može učitati ({0}); više kaže {1} doctor.</translation>
    </message>
    <message>
        <source>Display</source>
        <translation>Zaslon</translation>
    </message>
    <message>
        <source>Environment</source>
        <translation>Okruženje</translation>
    </message>
    <message>
        <source>Everything needed is here.</source>
        <translation>Sve što treba je tu.</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>Izvoz</translation>
    </message>
    <message>
        <source>Left out, because it is done in the window: {0}.</source>
        <translation>Izostavljeno jer se radi u prozoru: {0}.</translation>
    </message>
    <message>
        <source>Log folder</source>
        <translation>Mapa zapisnika</translation>
    </message>
    <message>
        <source>No OpenGL could be started, and 3.2 is needed. {0}</source>
        <translation>OpenGL se nije mogao pokrenuti, a treba 3.2. {0}</translation>
    </message>
    <message>
        <source>No idea explains (answers; lesson, exercise, variant; what was typed; right):</source>
        <translation>Nijedna pogrešna predodžba ne objašnjava (odgovori; lekcija, vježba, varijanta; što je upisano; točno):</translation>
    </message>
    <message>
        <source>OUT = {0!r}: .mp4 has even sides in pixels, not {1}; set --size.</source>
        <translation>OUT = {0!r}: .mp4 ima stranice s parnim brojem piksela, a ne {1}; postavite --size.</translation>
    </message>
    <message>
        <source>OUT = {0!r}: .webp has at most {1} pixels along each side.</source>
        <translation>OUT = {0!r}: .webp ima po stranici najviše ovoliko piksela: {1}.</translation>
    </message>
    <message>
        <source>OUT = {0!r}: must be a folder, for the figures.</source>
        <translation>OUT = {0!r}: mora biti mapa, za slike.</translation>
    </message>
    <message>
        <source>OUT = {0!r}: must end in {1}{2}.</source>
        <translation>OUT = {0!r}: mora završavati na {1}{2}.</translation>
    </message>
    <message>
        <source>Only OpenGL ES is offered here ({0}), not OpenGL 3.2. {1}</source>
        <translation>Ovdje postoji samo OpenGL ES ({0}), a ne OpenGL 3.2. {1}</translation>
    </message>
    <message>
        <source>OpenGL {0}.{1} is too old ({2}): 3.2 is needed. {3}</source>
        <translation>OpenGL {0}.{1} je prestar ({2}): treba 3.2. {3}</translation>
    </message>
    <message>
        <source>P does not say near, far and the size of the image</source>
        <translation>P ne određuje blisku ni daleku ravninu ni veličinu slike</translation>
    </message>
    <message>
        <source>P has w &gt; 0 behind the camera: perhaps y points up in its image</source>
        <translation>P ima w &gt; 0 iza kamere: možda je y u njezinoj slici usmjeren prema gore</translation>
    </message>
    <message>
        <source>POINTS = {0!r}: must be a CSV file, or - for standard input; for a point: echo {1} | {2} project -.</source>
        <translation>POINTS = {0!r}: mora biti datoteka CSV, ili - za standardni ulaz; za jednu točku: echo {1} | {2} project -.</translation>
    </message>
    <message>
        <source>POINTS is missing: {0} gives the camera only.</source>
        <translation>POINTS nedostaje: {0} daje samo kameru.</translation>
    </message>
    <message>
        <source>Panes</source>
        <translation>Okna</translation>
    </message>
    <message>
        <source>Platform</source>
        <translation>Platforma</translation>
    </message>
    <message>
        <source>PyInstaller ended with status {0}.</source>
        <translation>PyInstaller je završio sa statusom {0}.</translation>
    </message>
    <message>
        <source>Python {0}, {1} bits, {2},</source>
        <translation>Python {0}, {1}-bitni, {2},</translation>
    </message>
    <message>
        <source>QT_QPA_PLATFORM = {0}: must be one of {1}; unset it.</source>
        <translation>QT_QPA_PLATFORM = {0}: mora biti jedno od {1}; uklonite tu varijablu.</translation>
    </message>
    <message>
        <source>Qt cannot reach the X server, because a system library is missing ({0}); {1} doctor says which package provides it.</source>
        <translation>Qt ne može doći do poslužitelja X, jer nedostaje biblioteka sustava ({0}); {1} doctor kaže koji je paket sadrži.</translation>
    </message>
    <message>
        <source>Qt&apos;s platform {0} shows no OpenGL windows. {1}</source>
        <translation>Qt-ova platforma {0} ne prikazuje prozore s OpenGL-om. {1}</translation>
    </message>
    <message>
        <source>Recovery folder</source>
        <translation>Mapa za oporavak</translation>
    </message>
    <message>
        <source>Screen</source>
        <translation>Ekran</translation>
    </message>
    <message>
        <source>Set aside</source>
        <translation>Zanemareno</translation>
    </message>
    <message>
        <source>Settings folder</source>
        <translation>Mapa postavki</translation>
    </message>
    <message>
        <source>Standard input</source>
        <translation>Standardni ulaz</translation>
    </message>
    <message>
        <source>Standard output cannot be written: {0}.</source>
        <translation>Na standardni izlaz ne može se pisati: {0}.</translation>
    </message>
    <message>
        <source>Standard output is closed.</source>
        <translation>Standardni izlaz je zatvoren.</translation>
    </message>
    <message>
        <source>System libraries</source>
        <translation>Biblioteke sustava</translation>
    </message>
    <message>
        <source>The X server DISPLAY = {0} does not answer or does not let this user in</source>
        <translation>Poslužitelj X, DISPLAY = {0}, ne odgovara ili ne pušta ovog korisnika</translation>
    </message>
    <message>
        <source>The other states need scripts.</source>
        <translation>Za ostala stanja trebaju skripte.</translation>
    </message>
    <message>
        <source>The settings cannot be deleted: {0}.</source>
        <translation>Postavke se ne mogu izbrisati: {0}.</translation>
    </message>
    <message>
        <source>The window</source>
        <translation>Prozor</translation>
    </message>
    <message>
        <source>There is no screen to open a window on ({0} names none)</source>
        <translation>Nema ekrana na kojem bi se otvorio prozor ({0} ne imenuje nijedan)</translation>
    </message>
    <message>
        <source>This is missing:</source>
        <translation>Nedostaje:</translation>
    </message>
    <message>
        <source>This page does not keep what you type; print it to keep it.</source>
        <translation>Ova stranica ne čuva ono što upišete; ispišite je da to sačuvate.</translation>
    </message>
    <message>
        <source>Update the graphics driver; on Linux install Mesa (libgl1-mesa-dri) or start with LIBGL_ALWAYS_SOFTWARE=1, and over a remote desktop use one that offers OpenGL.</source>
        <translation>Ažurirajte upravljački program grafike; na Linuxu instalirajte Mesu (libgl1-mesa-dri) ili pokrenite s LIBGL_ALWAYS_SOFTWARE=1, a za udaljenu radnu površinu upotrijebite onu koja nudi OpenGL.</translation>
    </message>
    <message>
        <source>WIDTHxHEIGHT in {0}, such as 120mmx80mm or 1800x600</source>
        <translation>WIDTHxHEIGHT u {0}, npr. 120mmx80mm ili 1800x600</translation>
    </message>
    <message>
        <source>Window</source>
        <translation>Prozor</translation>
    </message>
    <message>
        <source>Wrong ideas (answers, students):</source>
        <translation>Pogrešne predodžbe (odgovori, studenti):</translation>
    </message>
    <message>
        <source>Your answer</source>
        <translation>Vaš odgovor</translation>
    </message>
    <message>
        <source>a finite number</source>
        <translation>konačan broj</translation>
    </message>
    <message>
        <source>a font</source>
        <translation>font</translation>
    </message>
    <message>
        <source>a length in {0}, such as 84mm</source>
        <translation>duljina u {0}, npr. 84mm</translation>
    </message>
    <message>
        <source>a number of degrees</source>
        <translation>broj stupnjeva</translation>
    </message>
    <message>
        <source>a number of points</source>
        <translation>broj točaka</translation>
    </message>
    <message>
        <source>a part</source>
        <translation>dio</translation>
    </message>
    <message>
        <source>a whole number</source>
        <translation>cijeli broj</translation>
    </message>
    <message>
        <source>a whole number from 1 to 17</source>
        <translation>cijeli broj od 1 do 17</translation>
    </message>
    <message>
        <source>a x + b y + c z + d &gt;= 0 in the view volume, in world space</source>
        <translation>a x + b y + c z + d &gt;= 0 u volumenu pogleda, u globalnom koordinatnom sustavu</translation>
    </message>
    <message>
        <source>all here</source>
        <translation>sve su tu</translation>
    </message>
    <message>
        <source>and {0} more</source>
        <translation>i još {0}</translation>
    </message>
    <message>
        <source>angle = {0}°</source>
        <translation>kut = {0}°</translation>
    </message>
    <message>
        <source>another start is setting up Frustum Lab; waiting for it to finish</source>
        <translation>drugo pokretanje upravo postavlja Frustum Lab; čekam da završi</translation>
    </message>
    <message>
        <source>apt-get failed ({0}); try: {1}</source>
        <translation>apt-get nije uspio ({0}); pokušajte: {1}</translation>
    </message>
    <message>
        <source>argument %(argument_name)s: %(message)s</source>
        <translation>%(argument_name)s: %(message)s</translation>
    </message>
    <message>
        <source>at infinity</source>
        <translation>u beskonačnosti</translation>
    </message>
    <message>
        <source>bringing {0} up to date</source>
        <translation>ažuriram {0}</translation>
    </message>
    <message>
        <source>bundle needs PyInstaller, which is not installed; run: {0}</source>
        <translation>bundle treba PyInstaller, koji nije instaliran; pokrenite: {0}</translation>
    </message>
    <message>
        <source>bundle: this program has no folder of its code to make one of.</source>
        <translation>bundle: ovaj program nema mapu sa svojim kodom od koje bi se to načinilo.</translation>
    </message>
    <message>
        <source>cannot be loaded: {0}</source>
        <translation>ne može se učitati: {0}</translation>
    </message>
    <message>
        <source>capitals are {0:.1%} of the screen&apos;s height; must be from {1:.1%} to {2:.1%}.</source>
        <translation>velika slova imaju {0:.1%} visine ekrana; mora biti od {1:.1%} do {2:.1%}.</translation>
    </message>
    <message>
        <source>check the network and run again: {again}</source>
        <translation>provjerite mrežu i pokrenite ponovno: {again}</translation>
    </message>
    <message>
        <source>close all windows of Frustum Lab and run again: {again}</source>
        <translation>zatvorite sve prozore programa Frustum Lab i pokrenite ponovno: {again}</translation>
    </message>
    <message>
        <source>column vectors, M p</source>
        <translation>vektori stupci, M p</translation>
    </message>
    <message>
        <source>commands are {0}</source>
        <translation>naredbe su {0}</translation>
    </message>
    <message>
        <source>computed in {0}; errors are below: {1}</source>
        <translation>računano u {0}; pogreške su manje od: {1}</translation>
    </message>
    <message>
        <source>does not answer within {0:g} s</source>
        <translation>ne odgovara unutar {0:g} s</translation>
    </message>
    <message>
        <source>drawn in the window by OpenGL</source>
        <translation>u prozoru ih crta OpenGL</translation>
    </message>
    <message>
        <source>drawn off-screen and painted as pixels</source>
        <translation>crtaju se izvan ekrana i prikazuju kao pikseli</translation>
    </message>
    <message>
        <source>exit status {0}</source>
        <translation>izlazni status {0}</translation>
    </message>
    <message>
        <source>expected one argument</source>
        <translation>treba jedan argument</translation>
    </message>
    <message>
        <source>file = {0!r}: is a lesson; name its step in a column step, or write a number such as %02d in out = {1!r}.</source>
        <translation>file = {0!r}: to je lekcija; navedite njezin korak u stupcu step ili u out = {1!r} upišite broj poput %02d.</translation>
    </message>
    <message>
        <source>first start: setting up {0} (once{1})</source>
        <translation>prvo pokretanje: postavljam {0} (jednom{1})</translation>
    </message>
    <message>
        <source>float32 cannot hold its numbers</source>
        <translation>float32 ne može držati njezine brojeve</translation>
    </message>
    <message>
        <source>for x right, y down, z forward; pixels from the centre of the first one</source>
        <translation>za x udesno, y dolje, z naprijed; pikseli od sredine prvoga</translation>
    </message>
    <message>
        <source>frame {0}/{1}</source>
        <translation>kadar {0}/{1}</translation>
    </message>
    <message>
        <source>going on with the installed packages</source>
        <translation>nastavljam s instaliranim paketima</translation>
    </message>
    <message>
        <source>going on with the installed packages, which do not meet {0}</source>
        <translation>nastavljam s instaliranim paketima, koji ne zadovoljavaju {0}</translation>
    </message>
    <message>
        <source>graphics card</source>
        <translation>grafička kartica</translation>
    </message>
    <message>
        <source>has {0} columns, but the first row names {1}.</source>
        <translation>broj stupaca je {0}, a prvi ih redak imenuje {1}.</translation>
    </message>
    <message>
        <source>ignored explicit argument %r</source>
        <translation>ne prima vrijednost %r</translation>
    </message>
    <message>
        <source>inside</source>
        <translation>unutar</translation>
    </message>
    <message>
        <source>install Mesa (libegl1 libegl-mesa0 libgl1-mesa-dri), or update the driver</source>
        <translation>instalirajte Mesu (libegl1 libegl-mesa0 libgl1-mesa-dri) ili ažurirajte upravljački program</translation>
    </message>
    <message>
        <source>installing system packages: {0}</source>
        <translation>instaliram pakete sustava: {0}</translation>
    </message>
    <message>
        <source>it is a device, neither a file nor a pipe</source>
        <translation>to je uređaj, a ne datoteka ni cijev</translation>
    </message>
    <message>
        <source>it is closed</source>
        <translation>zatvoren je</translation>
    </message>
    <message>
        <source>it is larger than {0} MiB</source>
        <translation>veće je od {0} MiB</translation>
    </message>
    <message>
        <source>its view coordinates are at infinity</source>
        <translation>njezine su koordinate u sustavu kamere u beskonačnosti</translation>
    </message>
    <message>
        <source>key</source>
        <translation>rješenja</translation>
    </message>
    <message>
        <source>largest error in px</source>
        <translation>najveća pogreška u px</translation>
    </message>
    <message>
        <source>left-handed world: z reversed; the view looks along -z, y up (worldToCameraMatrix)</source>
        <translation>lijevi globalni sustav: z obrnut; kamera gleda duž -z, y gore (worldToCameraMatrix)</translation>
    </message>
    <message>
        <source>left-handed: world z reversed; looks along +z, y up</source>
        <translation>lijevi sustav: globalni z obrnut; gleda duž +z, y gore</translation>
    </message>
    <message>
        <source>lens.kind = matrix: a free matrix has no near, no far and no angle to measure; it must be one of {0}.</source>
        <translation>lens.kind = matrix: slobodna matrica nema ni bliske ni daleke ravnine ni kuta za mjerenje; mora biti jedno od {0}.</translation>
    </message>
    <message>
        <source>lesson</source>
        <translation>lekcija</translation>
    </message>
    <message>
        <source>lesson = {0!r}: must be one of {1}; {2} {0} opens the lesson.</source>
        <translation>lesson = {0!r}: mora biti jedno od {1}; {2} {0} otvara lekciju.</translation>
    </message>
    <message>
        <source>lesson print needs --{0}.</source>
        <translation>lesson print treba --{0}.</translation>
    </message>
    <message>
        <source>lesson print takes no FILE such as {0!r}: use --topics.</source>
        <translation>lesson print ne prima FILE poput {0!r}: upotrijebite --topics.</translation>
    </message>
    <message>
        <source>lesson results needs a FILE.</source>
        <translation>lesson results treba FILE.</translation>
    </message>
    <message>
        <source>line</source>
        <translation>redak</translation>
    </message>
    <message>
        <source>looks along -z, y up</source>
        <translation>gleda duž -z, y gore</translation>
    </message>
    <message>
        <source>looks along -z; y of clip down</source>
        <translation>gleda duž -z; y prostora odsijecanja dolje</translation>
    </message>
    <message>
        <source>make {0} a folder that you may write to</source>
        <translation>neka {0} bude mapa u koju smijete pisati</translation>
    </message>
    <message>
        <source>missing</source>
        <translation>nedostaje</translation>
    </message>
    <message>
        <source>missing: {0}</source>
        <translation>nedostaje: {0}</translation>
    </message>
    <message>
        <source>nearest command is {0}</source>
        <translation>najbliža je naredba {0}</translation>
    </message>
    <message>
        <source>no names</source>
        <translation>samo opcije</translation>
    </message>
    <message>
        <source>no package server could be reached</source>
        <translation>nijedan poslužitelj paketa nije dostupan</translation>
    </message>
    <message>
        <source>no smooth edges then</source>
        <translation>tada samo oštre rubove</translation>
    </message>
    <message>
        <source>no tested version of {0} here: trying others</source>
        <translation>ovdje nema isprobane inačice paketa {0}: pokušavam druge</translation>
    </message>
    <message>
        <source>no transparency</source>
        <translation>samo neprozirne piksele</translation>
    </message>
    <message>
        <source>no version fits {python} on this machine; use another Python</source>
        <translation>nijedna inačica ne odgovara za {python} na ovom računalu; upotrijebite drugi Python</translation>
    </message>
    <message>
        <source>none</source>
        <translation>nema</translation>
    </message>
    <message>
        <source>none for windows: {0}</source>
        <translation>nema za prozore: {0}</translation>
    </message>
    <message>
        <source>none: {0}</source>
        <translation>nema: {0}</translation>
    </message>
    <message>
        <source>not set up yet</source>
        <translation>još nije postavljeno</translation>
    </message>
    <message>
        <source>not without ffmpeg; .webp needs none</source>
        <translation>ne bez programa ffmpeg; .webp ga ne treba</translation>
    </message>
    <message>
        <source>options</source>
        <translation>opcije</translation>
    </message>
    <message>
        <source>out = {0!r}: is a link, which may lead out of {1}.</source>
        <translation>out = {0!r}: to je poveznica, koja može voditi izvan mape {1}.</translation>
    </message>
    <message>
        <source>out = {0!r}: is written by {1}.</source>
        <translation>out = {0!r}: to već zapisuje {1}.</translation>
    </message>
    <message>
        <source>out = {0!r}: must be a file name without a folder.</source>
        <translation>out = {0!r}: mora biti ime datoteke bez mape.</translation>
    </message>
    <message>
        <source>outside of</source>
        <translation>izvan:</translation>
    </message>
    <message>
        <source>overwritten</source>
        <translation>zamijenjeno</translation>
    </message>
    <message>
        <source>packages</source>
        <translation>paketi</translation>
    </message>
    <message>
        <source>part of the text is only in the speaker&apos;s notes: {0}</source>
        <translation>dio teksta je samo u bilješkama predavača: {0}</translation>
    </message>
    <message>
        <source>pip does not find all packages for {0}, Python {1}.</source>
        <translation>pip ne nalazi sve pakete za {0}, Python {1}.</translation>
    </message>
    <message>
        <source>point {0}</source>
        <translation>točka {0}</translation>
    </message>
    <message>
        <source>positional arguments</source>
        <translation>argumenti po mjestu</translation>
    </message>
    <message>
        <source>put Frustum Lab into a folder that you may write to</source>
        <translation>stavite Frustum Lab u mapu u koju smijete pisati</translation>
    </message>
    <message>
        <source>row vectors, p M</source>
        <translation>vektori retci, p M</translation>
    </message>
    <message>
        <source>run again: {again}; {program} doctor says more</source>
        <translation>pokrenite ponovno: {again}; više kaže {program} doctor</translation>
    </message>
    <message>
        <source>scale = {0} is free, and so is its sign</source>
        <translation>scale = {0} je slobodan, a tako i predznak</translation>
    </message>
    <message>
        <source>see Window</source>
        <translation>vidi Prozor</translation>
    </message>
    <message>
        <source>see the system libraries above</source>
        <translation>vidi biblioteke sustava iznad</translation>
    </message>
    <message>
        <source>set up in {0:.0f} s</source>
        <translation>postavljeno za {0:.0f} s</translation>
    </message>
    <message>
        <source>show this help message and exit</source>
        <translation>prikaži ovu pomoć i završi</translation>
    </message>
    <message>
        <source>smallest gap in world units</source>
        <translation>najmanji razmak u jedinicama svijeta</translation>
    </message>
    <message>
        <source>so far</source>
        <translation>dosad</translation>
    </message>
    <message>
        <source>software, without a graphics card</source>
        <translation>programski, bez grafičke kartice</translation>
    </message>
    <message>
        <source>talk</source>
        <translation>izlaganje</translation>
    </message>
    <message>
        <source>talk needs --check or --handout OUT.pdf; {0} {1} opens the talk.</source>
        <translation>talk treba --check ili --handout OUT.pdf; {0} {1} otvara izlaganje.</translation>
    </message>
    <message>
        <source>the Python packages could not be installed</source>
        <translation>paketi za Python nisu se mogli instalirati</translation>
    </message>
    <message>
        <source>the camera looks along +z, y down; K is in pixels, the first pixel&apos;s centre at 0, 0</source>
        <translation>kamera gleda duž +z, y dolje; K je u pikselima, sredina prvog piksela je u 0, 0</translation>
    </message>
    <message>
        <source>the driver crashed (signal {0})</source>
        <translation>upravljački program se srušio (signal {0})</translation>
    </message>
    <message>
        <source>the first start sets it up, which needs the network: {0}</source>
        <translation>postavlja ga prvo pokretanje, za što treba mreža: {0}</translation>
    </message>
    <message>
        <source>the following arguments are required: %s</source>
        <translation>nedostaju argumenti: %s</translation>
    </message>
    <message>
        <source>the package server does not answer; trying again</source>
        <translation>poslužitelj paketa ne odgovara; pokušavam ponovno</translation>
    </message>
    <message>
        <source>the package {0} is damaged ({1}); replace it, and start again: {2}</source>
        <translation>paket {0} je oštećen ({1}); zamijenite ga i pokrenite ponovno: {2}</translation>
    </message>
    <message>
        <source>the path {folder} is too long: move the folder of the code nearer to the drive&apos;s root</source>
        <translation>putanja {folder} je preduga: premjestite mapu s kodom bliže korijenu diska</translation>
    </message>
    <message>
        <source>the picture is at infinity too: w = 0, and lines of this direction stay parallel</source>
        <translation>i slika je u beskonačnosti: w = 0, pa pravci tog smjera ostaju paralelni</translation>
    </message>
    <message>
        <source>the point at infinity is behind the eye; the opposite direction has a picture</source>
        <translation>beskonačno daleka točka je iza kamere; suprotni smjer ima sliku</translation>
    </message>
    <message>
        <source>the point is in front of the eye; its pixel is larger than float64 can hold</source>
        <translation>točka je ispred kamere; njezin je piksel veći nego što stane u float64</translation>
    </message>
    <message>
        <source>the point is not in front of the eye</source>
        <translation>točka nije ispred kamere</translation>
    </message>
    <message>
        <source>the rightmost factor acts first</source>
        <translation>faktor sasvim desno djeluje prvi</translation>
    </message>
    <message>
        <source>the set-up failed</source>
        <translation>postavljanje nije uspjelo</translation>
    </message>
    <message>
        <source>the set-up was stopped; to go on: {0}</source>
        <translation>postavljanje je prekinuto; za nastavak: {0}</translation>
    </message>
    <message>
        <source>the skew {0:.1g} of K is left out: so many px at 45 degrees above or below</source>
        <translation>kosina {0:.1g} matrice K je izostavljena: toliko px na 45 stupnjeva iznad ili ispod</translation>
    </message>
    <message>
        <source>the text is longer or higher than the two lines above the picture.</source>
        <translation>tekst je dulji ili viši od dvaju redaka iznad slike.</translation>
    </message>
    <message>
        <source>the view volume</source>
        <translation>volumena pogleda</translation>
    </message>
    <message>
        <source>the window</source>
        <translation>prozor</translation>
    </message>
    <message>
        <source>there is no room</source>
        <translation>nema mjesta</translation>
    </message>
    <message>
        <source>this machine&apos;s rules forbid programs in {folder}; ask who set it up</source>
        <translation>pravila ovog računala zabranjuju programe u {folder}; pitajte onoga tko ga je postavio</translation>
    </message>
    <message>
        <source>this system lacks {0}; install what provides them, and start again</source>
        <translation>na ovom sustavu nedostaje: {0}; instalirajte što je potrebno i pokrenite ponovno</translation>
    </message>
    <message>
        <source>this system lacks {0}; run: {1}</source>
        <translation>na ovom sustavu nedostaje: {0}; pokrenite: {1}</translation>
    </message>
    <message>
        <source>through {0}</source>
        <translation>preko {0}</translation>
    </message>
    <message>
        <source>too little space is left: free {space} GB beside {folder}, or set TMPDIR if the folder of temporary files is full, and run again: {again}</source>
        <translation>premalo je slobodnog mjesta: oslobodite {space} GB pokraj {folder}, ili postavite TMPDIR ako je puna mapa privremenih datoteka, i pokrenite ponovno: {again}</translation>
    </message>
    <message>
        <source>unrecognized arguments: %s</source>
        <translation>nepoznati argumenti: %s</translation>
    </message>
    <message>
        <source>update the graphics driver, or start with LIBGL_ALWAYS_SOFTWARE=1</source>
        <translation>ažurirajte upravljački program grafike ili pokrenite s LIBGL_ALWAYS_SOFTWARE=1</translation>
    </message>
    <message>
        <source>usage: </source>
        <translation>uporaba: </translation>
    </message>
    <message>
        <source>view.names has {0}, which no pane draws here.</source>
        <translation>view.names sadrži {0}, a to ovdje ne crta nijedno okno.</translation>
    </message>
    <message>
        <source>way = {0} %</source>
        <translation>put = {0} %</translation>
    </message>
    <message>
        <source>what is drawn covers {0:.0%} of the width and {1:.0%} of the height; at least {2:.0%} of one of them, and below {3:.0%} also {4:.0%} of the area.</source>
        <translation>nacrtano pokriva {0:.0%} širine i {1:.0%} visine; treba barem {2:.0%} jednoga od toga, a ako je to manje od {3:.0%}, onda i {4:.0%} površine.</translation>
    </message>
    <message>
        <source>without a display through {0}, {1}</source>
        <translation>bez zaslona, preko {0}, {1}</translation>
    </message>
    <message>
        <source>written</source>
        <translation>zapisano</translation>
    </message>
    <message>
        <source>x, y and z divided by w</source>
        <translation>x, y i z podijeljeno s w</translation>
    </message>
    <message>
        <source>{0!r} is in the current folder, which was deleted.</source>
        <translation>{0!r} je u trenutačnoj mapi, koja je izbrisana.</translation>
    </message>
    <message>
        <source>{0!r} is not a name that a file can have.</source>
        <translation>{0!r} nije ime koje datoteka može imati.</translation>
    </message>
    <message>
        <source>{0} (needed: {1})</source>
        <translation>{0} (potrebno: {1})</translation>
    </message>
    <message>
        <source>{0} = {1!r}: has a character NUL.</source>
        <translation>{0} = {1!r}: ima znak NUL.</translation>
    </message>
    <message>
        <source>{0} = {1!r}: is a folder.</source>
        <translation>{0} = {1!r}: to je mapa.</translation>
    </message>
    <message>
        <source>{0} = {1!r}: is a pipe or a device, not a regular file.</source>
        <translation>{0} = {1!r}: to je cijev ili uređaj, a ne obična datoteka.</translation>
    </message>
    <message>
        <source>{0} = {1!r}: is read by this command; write to another file.</source>
        <translation>{0} = {1!r}: tu datoteku čita ova naredba; zapišite u neku drugu.</translation>
    </message>
    <message>
        <source>{0} = {1!r}: may not be written.</source>
        <translation>{0} = {1!r}: nema dopuštenja za pisanje.</translation>
    </message>
    <message>
        <source>{0} = {1!r}: must be one of {2}.</source>
        <translation>{0} = {1!r}: mora biti jedno od {2}.</translation>
    </message>
    <message>
        <source>{0} = {1!r}: must be true or false.</source>
        <translation>{0} = {1!r}: mora biti true ili false.</translation>
    </message>
    <message>
        <source>{0} = {1!r}: must be {2}.</source>
        <translation>{0} = {1!r}: mora biti {2}.</translation>
    </message>
    <message>
        <source>{0} = {1!r}: there is no folder {2}.</source>
        <translation>{0} = {1!r}: nema mape {2}.</translation>
    </message>
    <message>
        <source>{0} Not measured: {1}.</source>
        <translation>{0} Nije mjereno: {1}.</translation>
    </message>
    <message>
        <source>{0} cannot be read: {1}.</source>
        <translation>{0} se ne može pročitati: {1}.</translation>
    </message>
    <message>
        <source>{0} could not be removed ({1}); close the programs that run in it and run again: {2}</source>
        <translation>{0} se nije moglo ukloniti ({1}); zatvorite programe koji u tome rade i pokrenite ponovno: {2}</translation>
    </message>
    <message>
        <source>{0} failed</source>
        <translation>{0} nije uspjelo</translation>
    </message>
    <message>
        <source>{0} has no bound</source>
        <translation>{0} nema granice</translation>
    </message>
    <message>
        <source>{0} has no figures: its first row names columns, the others are one.</source>
        <translation>{0} nema slika: prvi redak imenuje stupce, a svaki sljedeći je jedna slika.</translation>
    </message>
    <message>
        <source>{0} has no points: it must have rows of x,y,z.</source>
        <translation>{0} nema točaka: mora imati retke x,y,z.</translation>
    </message>
    <message>
        <source>{0} has {1} kB, and a page for phones should have at most {2} kB: ask for fewer {3}.</source>
        <translation>{0} ima {1} kB, a stranica za telefone trebala bi imati najviše {2} kB: zatražite manje s {3}.</translation>
    </message>
    <message>
        <source>{0} in {1}</source>
        <translation>{0} u {1}</translation>
    </message>
    <message>
        <source>{0} is a command and must come first: {1} {0} ...</source>
        <translation>{0} je naredba i mora stajati prva: {1} {0} ...</translation>
    </message>
    <message>
        <source>{0} is a scene: write --set scene={0}.</source>
        <translation>{0} je scena: napišite --set scene={0}.</translation>
    </message>
    <message>
        <source>{0} is not a folder; rename or remove it, and run again: {1}</source>
        <translation>{0} nije mapa; preimenujte ili uklonite to i pokrenite ponovno: {1}</translation>
    </message>
    <message>
        <source>{0} is not an option of {1}; the nearest is {2}.</source>
        <translation>{0} nije opcija za {1}; najbliža je {2}.</translation>
    </message>
    <message>
        <source>{0} lacks {1} although pip installed them; remove it and start again: {2}</source>
        <translation>u {0} nedostaje: {1}, iako je pip to instalirao; uklonite to i pokrenite ponovno: {2}</translation>
    </message>
    <message>
        <source>{0} lacks {1}; start again: {2}</source>
        <translation>u {0} nedostaje: {1}; pokrenite ponovno: {2}</translation>
    </message>
    <message>
        <source>{0} left out: already in these files</source>
        <translation>Izostavljeno: {0}; već u ovim datotekama</translation>
    </message>
    <message>
        <source>{0} must go to different files.</source>
        <translation>{0} moraju ići u različite datoteke.</translation>
    </message>
    <message>
        <source>{0} not as in the files</source>
        <translation>{0} drukčije nego u datotekama</translation>
    </message>
    <message>
        <source>{0} of {1}</source>
        <translation>{0} od {1}</translation>
    </message>
    <message>
        <source>{0} or {1}</source>
        <translation>{0} ili {1}</translation>
    </message>
    <message>
        <source>{0} takes {1}, and was given {2}.</source>
        <translation>{0} prima {1}; zadano: {2}.</translation>
    </message>
    <message>
        <source>{0} was given an empty name.</source>
        <translation>{0}: zadano je prazno ime.</translation>
    </message>
    <message>
        <source>{0} was made by another program and lacks {1}; complete it with that program, or remove it and start again: {2}</source>
        <translation>{0} je načinio drugi program, a nedostaje: {1}; dopunite to tim programom ili uklonite i pokrenite ponovno: {2}</translation>
    </message>
    <message>
        <source>{0} wrong</source>
        <translation>pogrešno: {0}</translation>
    </message>
    <message>
        <source>{0}, line {1}: is not CSV ({2}).</source>
        <translation>{0}, redak {1}: nije CSV ({2}).</translation>
    </message>
    <message>
        <source>{0}, step {1}</source>
        <translation>{0}, korak {1}</translation>
    </message>
    <message>
        <source>{0}, {1} crowded, {2} empty, {3} hidden, {4} cut of {5}</source>
        <translation>{0}, prenatrpano: {1}, prazno: {2}, skriveno: {3}, odsječeno: {4}; ukupno: {5}</translation>
    </message>
    <message>
        <source>{0}, {1}: {2} right, {3} wrong, {4} shown, {5} not marked</source>
        <translation>{0}, {1}: točno {2}, pogrešno {3}, prikazano {4}, neocijenjeno {5}</translation>
    </message>
    <message>
        <source>{0}: has no column out, for the names of the figures.</source>
        <translation>{0}: nema stupca out, za imena slika.</translation>
    </message>
    <message>
        <source>{0}: has two columns of the same name.</source>
        <translation>{0}: ima dva stupca istog imena.</translation>
    </message>
    <message>
        <source>{0}: has two columns {1}.</source>
        <translation>{0}: ima dva stupca {1}.</translation>
    </message>
    <message>
        <source>{0}: {1} drawn, {2} wrong</source>
        <translation>{0}: nacrtano: {1}, pogrešno: {2}</translation>
    </message>
    <message>
        <source>{0}: {1} x {2} at scale {3:g}</source>
        <translation>{0}: {1} x {2}, mjerilo {3:g}</translation>
    </message>
    <message>
        <source>{0}; Frustum Lab prefers its own packages</source>
        <translation>{0}; Frustum Lab daje prednost svojim paketima</translation>
    </message>
    <message>
        <source>{0}; at most {1}.</source>
        <translation>{0}; najviše {1}.</translation>
    </message>
    <message>
        <source>“{0}” has an underscore that is not typeset.</source>
        <translation>„{0}” ima podvlaku koja nije složena kao indeks.</translation>
    </message>
    <message>
        <source>“{0}” is cut off at the border.</source>
        <translation>„{0}” je odsječeno na rubu.</translation>
    </message>
    <message>
        <source>“{0}” is named and not drawn: there is no place for it.</source>
        <translation>„{0}” je imenovano, a nije nacrtano: nema mjesta.</translation>
    </message>
    <message>
        <source>“{0}” lies behind the viewer.</source>
        <translation>„{0}” leži iza promatrača.</translation>
    </message>
    <message>
        <source>“{0}” lies on the point that “{1}” names.</source>
        <translation>„{0}” leži na točki koju imenuje „{1}”.</translation>
    </message>
    <message>
        <source>“{0}” lies outside the pane by {1:.1%} of its height.</source>
        <translation>„{0}” leži izvan okna za {1:.1%} njegove visine.</translation>
    </message>
    <message>
        <source>“{0}” overlaps “{1}”.</source>
        <translation>„{0}” se preklapa s „{1}”.</translation>
    </message>
    <message>
        <source>{0}: has {1} columns, must have three: x,y,z, or w too; name other columns in a first row: x,y,z,name.</source>
        <translation>{0}: broj stupaca je {1}, a moraju biti tri: x,y,z, ili i w; druge stupce imenujte u prvom retku: x,y,z,name.</translation>
    </message>
    <message>
        <source>{0!r} is neither a file, a lesson nor a command; the {1}.</source>
        <translation>{0!r} nije ni datoteka, ni lekcija, ni naredba ({1}).</translation>
    </message>
    <message>
        <source>{0}: has {1}, must have three: x,y,z, or w too.</source>
        <translation>{0}: ima {1}, a mora imati tri: x,y,z, ili i w.</translation>
    </message>
    <message>
        <source>{0}: is there already; remove it, or choose another folder.</source>
        <translation>{0}: već postoji; uklonite to ili odaberite drugu mapu.</translation>
    </message>
    <message>
        <source>{0}: line {1}, step {2} ({3})</source>
        <translation>{0}: redak {1}, korak {2} ({3})</translation>
    </message>
    <message>
        <source>{0}: must name columns x, y and z, or hold a point.</source>
        <translation>{0}: mora imenovati stupce x, y i z ili sadržavati točku.</translation>
    </message>
    <message>
        <source>{0}: not writable</source>
        <translation>{0}: nema dopuštenja za pisanje</translation>
    </message>
    <message>
        <source>{0}: start the program in a desktop session, over ssh with -X, or with xvfb-run -s &apos;+extension GLX&apos;{1} in front; “export”, “project”, “matrices”, “measure”, “lesson”, “talk --check”, “talk --handout” and “doctor” need no screen.</source>
        <translation>{0}: pokrenite program na radnoj površini, preko ssh s -X, ili s xvfb-run -s &apos;+extension GLX&apos;{1} ispred; „export”, „project”, „matrices”, „measure”, „lesson”, „talk --check”, „talk --handout” i „doctor” ne trebaju ekran.</translation>
    </message>
    <message>
        <source>{0}: {1!r} is not a column; the nearest is {2}.</source>
        <translation>{0}: {1!r} nije stupac; najbliži je {2}.</translation>
    </message>
    <message>
        <source>{0}: {1!r} is one column; they are separated by commas.</source>
        <translation>{0}: {1!r} je jedan stupac; stupci se odvajaju zarezima.</translation>
    </message>
    <message>
        <source>{0}: {1} = {2}: must lie within ±{3}.</source>
        <translation>{0}: {1} = {2}: mora biti unutar ±{3}.</translation>
    </message>
    <message>
        <source>There are no settings to delete: {0}</source>
        <translation>Nema postavki za brisanje: {0}</translation>
    </message>
    <message>
        <source>Settings deleted: {0}</source>
        <translation>Postavke su izbrisane: {0}</translation>
    </message>
    <message>
        <source>it is a pipe or a device, not a regular file</source>
        <translation>to je cijev ili uređaj, a ne obična datoteka</translation>
    </message>
    <message>
        <source>it is larger than {0} GiB</source>
        <translation>veće je od {0} GiB</translation>
    </message>
    <message>
        <source>it is not a regular file</source>
        <translation>to nije obična datoteka</translation>
    </message>
    <message>
        <source>is neither UTF-8 nor UTF-16 text, and is read as Latin-1; some letters may be wrong</source>
        <translation>nije tekst ni u UTF-8 ni u UTF-16, pa se čita kao Latin-1; neka slova mogu biti pogrešna</translation>
    </message>
    <message>
        <source>is damaged UTF-16 or UTF-32 text; what cannot be read is shown as �</source>
        <translation>oštećen je tekst u UTF-16 ili UTF-32; nečitljivo se prikazuje kao �</translation>
    </message>
    <message>
        <source>a question or a task</source>
        <translation>pitanje ili zadatak</translation>
    </message>
    <message>
        <source>“value:”, “count:”, “matrix:”, “click:”, “order:”, or choices</source>
        <translation>„value:”, „count:”, „matrix:”, „click:”, „order:” ili mogućnosti</translation>
    </message>
    <message>
        <source>{0} and choices</source>
        <translation>{0} i mogućnosti</translation>
    </message>
    <message>
        <source>the end</source>
        <translation>kraj</translation>
    </message>
    <message>
        <source>There is no OpenGL 3.2 to draw with: update the graphics driver; on Linux install Mesa (libegl1 libegl-mesa0 libgl1-mesa-dri) or start with LIBGL_ALWAYS_SOFTWARE=1.</source>
        <translation>Nema OpenGL-a 3.2 za crtanje: ažurirajte upravljački program grafike; na Linuxu instalirajte Mesu (libegl1 libegl-mesa0 libgl1-mesa-dri) ili pokrenite s LIBGL_ALWAYS_SOFTWARE=1.</translation>
    </message>
    <message>
        <source>the whole numbers from 0 to {0}</source>
        <translation>cijelih brojeva od 0 do {0}</translation>
    </message>
    <message>
        <source>the opposite of the segment&apos;s other end</source>
        <translation>suprotnoj drugom kraju dužine</translation>
    </message>
    <message>
        <source>change a value of the document, such as lens.far=inf; may be repeated; the names are {0} and settings.NAME for a setting of the scene</source>
        <translation>mijenja vrijednost dokumenta, npr. lens.far=inf; može se ponoviti; imena su {0} te settings.NAME za postavku scene</translation>
    </message>
    <message>
        <source>commands, each with its own --help:</source>
        <translation>naredbe, svaka s vlastitim --help:</translation>
    </message>
    <message>
        <source>language of messages, lessons and figures (default: the system&apos;s)</source>
        <translation>jezik poruka, lekcija i slika (zadano: jezik sustava)</translation>
    </message>
    <message>
        <source>{0} and {1}</source>
        <translation>{0} i {1}</translation>
    </message>
    <message>
        <source>Qt has no OpenGL here: VTK draws the panes off the screen.</source>
        <translation>Qt ovdje nema OpenGL: VTK crta okna izvan ekrana.</translation>
    </message>
    <message>
        <source>world</source>
        <translation>svijet</translation>
    </message>
    <message>
        <source>view</source>
        <translation>kamera</translation>
    </message>
    <message>
        <source>clip</source>
        <translation>odsijecanje</translation>
    </message>
    <message>
        <source>image px</source>
        <translation>slika px</translation>
    </message>
    <message>
        <source>depth</source>
        <translation>dubina</translation>
    </message>
</context>
<context>
    <name>Compare</name>
    <message>
        <source>Differences between the pictures</source>
        <translation>Razlike između slika</translation>
    </message>
    <message>
        <source>End the comparison (Esc)</source>
        <translation>Završava usporedbu (Esc)</translation>
    </message>
    <message>
        <source>End the comparison</source>
        <translation>Završi usporedbu</translation>
    </message>
    <message>
        <source>Over each other</source>
        <translation>Preklopljeno</translation>
    </message>
    <message>
        <source>Lay the pictures over each other, with a divider that you can drag</source>
        <translation>Slaže slike jednu preko druge, s razdjelnikom koji možete povlačiti</translation>
    </message>
    <message>
        <source>Side by side</source>
        <translation>Jedno uz drugo</translation>
    </message>
    <message>
        <source>Show every picture whole, beside the others</source>
        <translation>Prikazuje svaku sliku cijelu, uz ostale</translation>
    </message>
    <message>
        <source>held</source>
        <translation>zadržano</translation>
    </message>
    <message>
        <source>no difference yet: change something</source>
        <translation>još nema razlike: nešto promijenite</translation>
    </message>
    <message>
        <source>different shapes: side by side, at equal heights</source>
        <translation>različiti oblici: jedno uz drugo, iste visine</translation>
    </message>
</context>
<context>
    <name>Comparing</name>
    <message>
        <source>Compare</source>
        <translation>Usporedi</translation>
    </message>
</context>
<context>
    <name>Controls</name>
    <message>
        <source>Controls</source>
        <translation>Kontrole</translation>
    </message>
    <message>
        <source>Camera</source>
        <translation>Kamera</translation>
    </message>
    <message>
        <source>More of the lens</source>
        <translation>Više o objektivu</translation>
    </message>
    <message>
        <source>More of the camera</source>
        <translation>Više o kameri</translation>
    </message>
    <message>
        <source>Image and depth range</source>
        <translation>Slika i raspon dubine</translation>
    </message>
    <message>
        <source>Chain</source>
        <translation>Lanac</translation>
    </message>
    <message>
        <source>Animation</source>
        <translation>Animacija</translation>
    </message>
    <message>
        <source>The objects of this scene are fixed, because its numbers depend on them. You can move those of the letter F, the cube, the posts and any mesh.</source>
        <translation>Objekti ove scene su nepomični jer njezini brojevi ovise o njima. Možete pomicati objekte slova F, kocke, stupova i bilo koje mreže.</translation>
    </message>
    <message>
        <source>Calibrated camera (OpenCV K)</source>
        <translation>Kalibrirana kamera (OpenCV K)</translation>
    </message>
    <message>
        <source>No camera has the typed view matrix: undo, or choose a lens.</source>
        <translation>Nijedna kamera nema upisanu matricu pogleda: poništite ili odaberite objektiv.</translation>
    </message>
    <message>
        <source>animation play walk turn</source>
        <translation>animacija pokreni obilazak kruženje okretanje</translation>
    </message>
    <message>
        <source>{0}: only with the lens “{1}”.</source>
        <translation>{0}: samo uz objektiv „{1}”.</translation>
    </message>
    <message>
        <source>No control has this name.</source>
        <translation>Nijedna kontrola nema to ime.</translation>
    </message>
</context>
<context>
    <name>Count</name>
    <message numerus="yes">
        <source>%n answers</source>
        <translation>
            <numerusform>%n odgovor</numerusform>
            <numerusform>%n odgovora</numerusform>
            <numerusform>%n odgovora</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n checks</source>
        <translation>
            <numerusform>%n provjera</numerusform>
            <numerusform>%n provjere</numerusform>
            <numerusform>%n provjera</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n columns</source>
        <translation>
            <numerusform>%n stupac</numerusform>
            <numerusform>%n stupca</numerusform>
            <numerusform>%n stupaca</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n files</source>
        <translation>
            <numerusform>%n datoteka</numerusform>
            <numerusform>%n datoteke</numerusform>
            <numerusform>%n datoteka</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n labels</source>
        <translation>
            <numerusform>%n natpis</numerusform>
            <numerusform>%n natpisa</numerusform>
            <numerusform>%n natpisa</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n lessons</source>
        <translation>
            <numerusform>%n lekcija</numerusform>
            <numerusform>%n lekcije</numerusform>
            <numerusform>%n lekcija</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n marks</source>
        <translation>
            <numerusform>%n ocjena</numerusform>
            <numerusform>%n ocjene</numerusform>
            <numerusform>%n ocjena</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n names</source>
        <translation>
            <numerusform>%n ime</numerusform>
            <numerusform>%n imena</numerusform>
            <numerusform>%n imena</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n overlaps</source>
        <translation>
            <numerusform>%n preklapanje</numerusform>
            <numerusform>%n preklapanja</numerusform>
            <numerusform>%n preklapanja</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n steps</source>
        <translation>
            <numerusform>%n korak</numerusform>
            <numerusform>%n koraka</numerusform>
            <numerusform>%n koraka</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n talks</source>
        <translation>
            <numerusform>%n izlaganje</numerusform>
            <numerusform>%n izlaganja</numerusform>
            <numerusform>%n izlaganja</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n warnings</source>
        <translation>
            <numerusform>%n upozorenje</numerusform>
            <numerusform>%n upozorenja</numerusform>
            <numerusform>%n upozorenja</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n exercises</source>
        <translation>
            <numerusform>%n vježba</numerusform>
            <numerusform>%n vježbe</numerusform>
            <numerusform>%n vježbi</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n minutes</source>
        <translation>
            <numerusform>%n minuta</numerusform>
            <numerusform>%n minute</numerusform>
            <numerusform>%n minuta</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n samples</source>
        <translation>
            <numerusform>%n uzorak</numerusform>
            <numerusform>%n uzorka</numerusform>
            <numerusform>%n uzoraka</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>CoverCard</name>
    <message>
        <source>Close</source>
        <translation>Zatvori</translation>
    </message>
</context>
<context>
    <name>Cursor</name>
    <message>
        <source>No other vertex is visible</source>
        <translation>Nijedan drugi vrh nije vidljiv</translation>
    </message>
    <message>
        <source>There is nothing else to drag</source>
        <translation>Nema ničega drugog za povlačenje</translation>
    </message>
    <message>
        <source>There is nothing to drag here</source>
        <translation>Ovdje nema ničega za povlačenje</translation>
    </message>
    <message>
        <source>Point {0} ({1})</source>
        <translation>Točka {0} ({1})</translation>
    </message>
    <message>
        <source>Vertex ({0})</source>
        <translation>Vrh ({0})</translation>
    </message>
</context>
<context>
    <name>Description</name>
    <message>
        <source>All of the scene&apos;s objects lie inside the view volume.</source>
        <translation>Svi objekti scene leže unutar volumena pogleda.</translation>
    </message>
    <message>
        <source>Cube: the scene in {0} coordinates.</source>
        <translation>Kocka: scena u koordinatama: {0}.</translation>
    </message>
    <message>
        <source>Cube: the scene on its way from {0} to {1} coordinates.</source>
        <translation>Kocka: scena na putu između koordinata: {0} → {1}.</translation>
    </message>
    <message>
        <source>Equation: {0}.</source>
        <translation>Jednadžba: {0}.</translation>
    </message>
    <message>
        <source>Image: the picture, {0} by {1} pixels.</source>
        <translation>Slika: {0} puta {1} piksela.</translation>
    </message>
    <message>
        <source>Lens: {0}, near {1}, far {2}.</source>
        <translation>Objektiv: {0}, bliska ravnina {1}, daleka ravnina {2}.</translation>
    </message>
    <message>
        <source>Lens: {0}.</source>
        <translation>Objektiv: {0}.</translation>
    </message>
    <message>
        <source>Parts of the scene&apos;s objects lie behind the eye, where a point has no picture.</source>
        <translation>Dijelovi objekata scene leže iza kamere, gdje točka nema sliku.</translation>
    </message>
    <message>
        <source>Parts of the scene&apos;s objects lie outside of these planes: {0}.</source>
        <translation>Dijelovi objekata scene leže izvan ovih ravnina: {0}.</translation>
    </message>
    <message>
        <source>Point {0} at ({1}) has its picture at the pixel ({2}).</source>
        <translation>Točka {0} u ({1}) ima sliku u pikselu ({2}).</translation>
    </message>
    <message>
        <source>Point {0} has no picture.</source>
        <translation>Točka {0} nema sliku.</translation>
    </message>
    <message>
        <source>Point {0}, at infinity in the direction ({1}), has its picture at ({2}).</source>
        <translation>Točka {0}, beskonačno daleka u smjeru ({1}), ima sliku u ({2}).</translation>
    </message>
    <message>
        <source>The eye is at ({0}) and looks at ({1}).</source>
        <translation>Kamera je u ({0}) i gleda prema ({1}).</translation>
    </message>
    <message>
        <source>The file is drawn with triangles: {0}, lines: {1}, points: {2}.</source>
        <translation>Datoteka je nacrtana; trokuti: {0}, linije: {1}, točke: {2}.</translation>
    </message>
    <message>
        <source>The vertical field of view is {0}°.</source>
        <translation>Vertikalno vidno polje iznosi {0}°.</translation>
    </message>
    <message>
        <source>World: the scene along the camera&apos;s axis, in parallel projection.</source>
        <translation>Svijet: scena duž osi kamere, u paralelnoj projekciji.</translation>
    </message>
    <message>
        <source>World: the scene as the camera sees it.</source>
        <translation>Svijet: scena kako je vidi kamera.</translation>
    </message>
    <message>
        <source>World: the scene from a free viewpoint.</source>
        <translation>Svijet: scena sa slobodnog gledišta.</translation>
    </message>
    <message>
        <source>World: the scene from above the camera, in parallel projection.</source>
        <translation>Svijet: scena odozgo iznad kamere, u paralelnoj projekciji.</translation>
    </message>
    <message>
        <source>World: the scene from the camera&apos;s side, in parallel projection.</source>
        <translation>Svijet: scena sa strane kamere, u paralelnoj projekciji.</translation>
    </message>
    <message>
        <source>canonical parallel</source>
        <translation>kanonske paralelne</translation>
    </message>
    <message>
        <source>canonical perspective</source>
        <translation>kanonske perspektivne</translation>
    </message>
    <message>
        <source>image</source>
        <translation>na slici</translation>
    </message>
    <message>
        <source>normalized device</source>
        <translation>normalizirane</translation>
    </message>
    <message>
        <source>view</source>
        <translation>u sustavu kamere</translation>
    </message>
    <message>
        <source>world</source>
        <translation>globalne</translation>
    </message>
    <message>
        <source>{0} pictures are compared.</source>
        <translation>Broj uspoređenih slika: {0}.</translation>
    </message>
</context>
<context>
    <name>DiagramView</name>
    <message>
        <source>Copy this diagram</source>
        <translation>Kopiraj ovaj dijagram</translation>
    </message>
    <message>
        <source>Export this diagram…</source>
        <translation>Izvezi ovaj dijagram…</translation>
    </message>
</context>
<context>
    <name>Divider</name>
    <message>
        <source>Divider between two pictures</source>
        <translation>Razdjelnik između dviju slika</translation>
    </message>
    <message>
        <source>Drag it, or press ← → (with Shift for finer steps), Home or End; Esc ends the comparison</source>
        <translation>Povucite ga ili pritisnite ← → (uz Shift finiji koraci), Home ili End; Esc završava usporedbu</translation>
    </message>
</context>
<context>
    <name>DrawnQuality</name>
    <message>
        <source>A pane cannot draw with {0}: it uses its default smoothing</source>
        <translation>Okno ne može crtati uz {0}: koristi svoje uobičajeno zaglađivanje</translation>
    </message>
    <message>
        <source>The scene has too few triangles to leave any out</source>
        <translation>Scena ima premalo trokuta da bi se ijedan izostavio</translation>
    </message>
    <message>
        <source>A textured surface can be drawn in float32 only</source>
        <translation>Ploha s teksturom može se crtati samo u float32</translation>
    </message>
    <message>
        <source>The image uses the ordinary depth buffer: {0}</source>
        <translation>Slika koristi obični spremnik dubine: {0}</translation>
    </message>
    <message>
        <source>A picture takes {0} ms to draw, so dragging stutters; a smaller window is smoother</source>
        <translation>Slika se crta {0} ms, pa povlačenje zapinje; u manjem je prozoru glađe</translation>
    </message>
    <message>
        <source>This computer&apos;s OpenGL gives {0} per pixel instead of {1}</source>
        <translation>OpenGL ovog računala daje {0} po pikselu umjesto {1}</translation>
    </message>
</context>
<context>
    <name>EquationSlide</name>
    <message>
        <source>turns</source>
        <translation>okreće</translation>
    </message>
    <message>
        <source>moves</source>
        <translation>pomiče</translation>
    </message>
</context>
<context>
    <name>ErrorReport</name>
    <message>
        <source>Something went wrong</source>
        <translation>Nešto je pošlo po zlu</translation>
    </message>
    <message>
        <source>Copy details</source>
        <translation>Kopiraj pojedinosti</translation>
    </message>
    <message>
        <source>Copies the details that a developer needs</source>
        <translation>Kopira pojedinosti koje trebaju razvojnom programeru</translation>
    </message>
    <message>
        <source>An error in the program: {0}. Your work is still there.</source>
        <translation>Pogreška u programu: {0}. Vaš rad je sačuvan.</translation>
    </message>
    <message>
        <source>Another error followed it.</source>
        <translation>Nakon nje javila se još jedna pogreška.</translation>
    </message>
    <message>
        <source>{0} more errors followed it.</source>
        <translation>Broj pogrešaka koje su se javile nakon nje: {0}.</translation>
    </message>
    <message>
        <source>There is no log, because it could not be written.</source>
        <translation>Nema zapisnika jer se nije mogao zapisati.</translation>
    </message>
    <message>
        <source>The log: {0}</source>
        <translation>Zapisnik: {0}</translation>
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
        <translation>{0}, varijanta {1}</translation>
    </message>
    <message>
        <source>Key: {0}</source>
        <translation>Rješenja: {0}</translation>
    </message>
    <message>
        <source>Variant {0}</source>
        <translation>Varijanta {0}</translation>
    </message>
    <message>
        <source>Wrong ideas:</source>
        <translation>Pogrešne predodžbe:</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Ime</translation>
    </message>
    <message>
        <source>Date</source>
        <translation>Datum</translation>
    </message>
    <message>
        <source>A sketch, not to scale.</source>
        <translation>Skica, nije u mjerilu.</translation>
    </message>
    <message>
        <source>Mark the place in the picture with a cross.</source>
        <translation>Označite mjesto na slici križićem.</translation>
    </message>
    <message>
        <source>Answer:</source>
        <translation>Odgovor:</translation>
    </message>
    <message>
        <source>Write the letters of the tiles as a product: what stands on the right acts first.</source>
        <translation>Napišite slova pločica kao umnožak: desna djeluje prva.</translation>
    </message>
</context>
<context>
    <name>ExerciseView</name>
    <message>
        <source>Number of the variant</source>
        <translation>Broj varijante</translation>
    </message>
    <message>
        <source>The same number gives the same exercise to everyone (Enter)</source>
        <translation>Isti broj svima daje istu vježbu (Enter)</translation>
    </message>
    <message>
        <source>Be&amp;gin</source>
        <translation>Počn&amp;i</translation>
    </message>
    <message>
        <source>Draw the numbers, and show their state</source>
        <translation>Izvlači brojeve i prikazuje njihovo stanje</translation>
    </message>
    <message>
        <source>Another &amp;one</source>
        <translation>&amp;Još jedna</translation>
    </message>
    <message>
        <source>The same exercise with new numbers</source>
        <translation>Ista vježba s novim brojevima</translation>
    </message>
    <message>
        <source>Exercise</source>
        <translation>Vježba</translation>
    </message>
    <message>
        <source>Variant</source>
        <translation>Varijanta</translation>
    </message>
</context>
<context>
    <name>ExportDialog</name>
    <message>
        <source>Export a picture</source>
        <translation>Izvezi sliku</translation>
    </message>
    <message>
        <source>Height of the letters in points, 72 to an inch; at scale 1 an inch has {0} pixels</source>
        <translation>Visina slova u točkama, 72 na palac; pri mjerilu 1 palac ima {0} piksela</translation>
    </message>
    <message>
        <source>Width of the picture</source>
        <translation>Širina slike</translation>
    </message>
    <message>
        <source>Height of the picture</source>
        <translation>Visina slike</translation>
    </message>
    <message>
        <source>Height of the letters in points</source>
        <translation>Visina slova u točkama</translation>
    </message>
    <message>
        <source>The file&apos;s format; SVG, PDF and TEX (TikZ) have shapes and text, no pixels. Films and many at once: the command “export”</source>
        <translation>Format datoteke; SVG, PDF i TEX (TikZ) imaju oblike i tekst, bez piksela. Filmovi i mnogo slika odjednom: naredba „export”</translation>
    </message>
    <message>
        <source>&amp;Format</source>
        <translation>&amp;Format</translation>
    </message>
    <message>
        <source>Panes</source>
        <translation>Okna</translation>
    </message>
    <message>
        <source>Whether the panes stand beside or below each other</source>
        <translation>Stoje li okna jedno uz drugo ili jedno ispod drugog</translation>
    </message>
    <message>
        <source>in a row</source>
        <translation>u retku</translation>
    </message>
    <message>
        <source>in a column</source>
        <translation>u stupcu</translation>
    </message>
    <message>
        <source>&amp;Arranged</source>
        <translation>&amp;Raspored</translation>
    </message>
    <message>
        <source>Unit of the size; a picture has {0} pixels an inch</source>
        <translation>Jedinica veličine; slika ima {0} piksela po palcu</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Veličina</translation>
    </message>
    <message>
        <source>&amp;Letters (pt)</source>
        <translation>&amp;Slova (pt)</translation>
    </message>
    <message>
        <source>In print, faces and lines that differ in colour differ in grey, too</source>
        <translation>Za tisak se strane i linije različitih boja razlikuju i u sivim tonovima</translation>
    </message>
    <message>
        <source>as on the screen</source>
        <translation>kao na ekranu</translation>
    </message>
    <message>
        <source>for print</source>
        <translation>za tisak</translation>
    </message>
    <message>
        <source>dark</source>
        <translation>tamno</translation>
    </message>
    <message>
        <source>most contrast</source>
        <translation>najveći kontrast</translation>
    </message>
    <message>
        <source>C&amp;olours</source>
        <translation>&amp;Boje</translation>
    </message>
    <message>
        <source>What becomes of lines behind faces, in SVG, PDF and TEX</source>
        <translation>Što biva s linijama iza strana, u formatima SVG, PDF i TEX</translation>
    </message>
    <message>
        <source>left out</source>
        <translation>izostavljene</translation>
    </message>
    <message>
        <source>dashed</source>
        <translation>crtkane</translation>
    </message>
    <message>
        <source>grey</source>
        <translation>sive</translation>
    </message>
    <message>
        <source>&amp;Hidden lines</source>
        <translation>S&amp;krivene linije</translation>
    </message>
    <message>
        <source>Draws the same PNG with more pixels; text and lines scale with it</source>
        <translation>Crta isti PNG s više piksela; tekst i linije skaliraju se s njim</translation>
    </message>
    <message>
        <source>Scal&amp;e</source>
        <translation>&amp;Mjerilo</translation>
    </message>
    <message>
        <source>What is behind the picture</source>
        <translation>Što je iza slike</translation>
    </message>
    <message>
        <source>filled</source>
        <translation>ispunjeno</translation>
    </message>
    <message>
        <source>transparent</source>
        <translation>prozirno</translation>
    </message>
    <message>
        <source>&amp;Background</source>
        <translation>&amp;Pozadina</translation>
    </message>
    <message>
        <source>C&amp;rop to the content</source>
        <translation>&amp;Obreži na sadržaj</translation>
    </message>
    <message>
        <source>Leaves a margin of 2 mm around what is drawn</source>
        <translation>Ostavlja rub od 2 mm oko nacrtanog</translation>
    </message>
    <message>
        <source>Preview</source>
        <translation>Pretpregled</translation>
    </message>
    <message>
        <source>Letters</source>
        <translation>Slova</translation>
    </message>
    <message>
        <source>Choose at least one pane.</source>
        <translation>Odaberite bar jedno okno.</translation>
    </message>
    <message>
        <source>Width and height must be whole numbers.</source>
        <translation>Širina i visina moraju biti cijeli brojevi.</translation>
    </message>
    <message>
        <source>Drawing the preview</source>
        <translation>Crta se pretpregled</translation>
    </message>
</context>
<context>
    <name>Factor</name>
    <message>
        <source>division by w</source>
        <translation>dijeljenje s w</translation>
    </message>
    <message>
        <source>mirror</source>
        <translation>zrcaljenje</translation>
    </message>
    <message>
        <source>rotation</source>
        <translation>rotacija</translation>
    </message>
    <message>
        <source>rotation about x</source>
        <translation>rotacija oko x</translation>
    </message>
    <message>
        <source>rotation about y</source>
        <translation>rotacija oko y</translation>
    </message>
    <message>
        <source>rotation about z</source>
        <translation>rotacija oko z</translation>
    </message>
    <message>
        <source>scale</source>
        <translation>skaliranje</translation>
    </message>
    <message>
        <source>shear</source>
        <translation>smicanje</translation>
    </message>
    <message>
        <source>translation</source>
        <translation>translacija</translation>
    </message>
    <message>
        <source>typed matrix</source>
        <translation>upisana matrica</translation>
    </message>
    <message>
        <source>x, y, z divided by w</source>
        <translation>x, y, z podijeljeno s w</translation>
    </message>
</context>
<context>
    <name>Field</name>
    <message>
        <source>Image</source>
        <translation>Slika</translation>
    </message>
    <message>
        <source>Answer</source>
        <translation>Odgovor</translation>
    </message>
    <message>
        <source>{0} {1}</source>
        <translation>{0} {1}</translation>
    </message>
    <message>
        <source>degrees</source>
        <translation>stupnjeva</translation>
    </message>
    <message>
        <source>units</source>
        <translation>jedinica</translation>
    </message>
    <message>
        <source>world units</source>
        <translation>globalnih jedinica</translation>
    </message>
    <message>
        <source>mm</source>
        <translation>mm</translation>
    </message>
    <message>
        <source>millimetres</source>
        <translation>milimetara</translation>
    </message>
    <message>
        <source>px</source>
        <translation>px</translation>
    </message>
    <message>
        <source>pixels</source>
        <translation>piksela</translation>
    </message>
    <message>
        <source>×</source>
        <translation>×</translation>
    </message>
    <message>
        <source>times</source>
        <translation>puta</translation>
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
        <translation>Dodaje višekratnik jedne koordinate drugoj: smicanje xy pomiče x zajedno s y.</translation>
    </message>
    <message>
        <source>Alpha</source>
        <translation>Alfa</translation>
    </message>
    <message>
        <source>Angle between the bottom and the top of the frustum, as seen from the eye.</source>
        <translation>Kut između dna i vrha krnje piramide, gledano iz kamere.</translation>
    </message>
    <message>
        <source>Angle between the left and the right of the frustum, as seen from the eye: the vertical field of view and the aspect in one number.</source>
        <translation>Kut između lijeve i desne strane krnje piramide, gledano iz kamere: vertikalno vidno polje i omjer stranica u jednom broju.</translation>
    </message>
    <message>
        <source>Angle of the projectors with the x axis, seen from above: H of lecture 002 adds (z + near) cot(alpha) to x. Points on the near plane do not move.</source>
        <translation>Kut zraka projiciranja s osi x, gledano odozgo: H iz predavanja 002 dodaje (z + near) cot(alpha) koordinati x. Točke na bliskoj ravnini ne pomiču se.</translation>
    </message>
    <message>
        <source>Angle of the projectors with the y axis, seen from the side: H of lecture 002 adds (z + near) cot(beta) to y. Points on the near plane do not move.</source>
        <translation>Kut zraka projiciranja s osi y, gledano sa strane: H iz predavanja 002 dodaje (z + near) cot(beta) koordinati y. Točke na bliskoj ravnini ne pomiču se.</translation>
    </message>
    <message>
        <source>Any four by four matrix with an inverse that leaves w alone.</source>
        <translation>Bilo koja matrica četiri puta četiri koja ima inverz i ne mijenja w.</translation>
    </message>
    <message>
        <source>Aspect</source>
        <translation>Omjer stranica</translation>
    </message>
    <message>
        <source>Azimuth</source>
        <translation>Azimut</translation>
    </message>
    <message>
        <source>Beta</source>
        <translation>Beta</translation>
    </message>
    <message>
        <source>Bottom</source>
        <translation>Donji rub</translation>
    </message>
    <message>
        <source>Bottom edge of the picture&apos;s window on the near plane: where the view volume begins in y of view space.</source>
        <translation>Donji rub prozora slike na bliskoj ravnini: gdje volumen pogleda počinje po y u koordinatnom sustavu kamere.</translation>
    </message>
    <message>
        <source>Chain</source>
        <translation>Lanac</translation>
    </message>
    <message>
        <source>Depth is drawn at full length, rising at 30°.</source>
        <translation>Dubina se crta u punoj duljini, pod kutom od 30°.</translation>
    </message>
    <message>
        <source>Depth is drawn at full length, rising at 45°.</source>
        <translation>Dubina se crta u punoj duljini, prema gore pod kutom od 45°.</translation>
    </message>
    <message>
        <source>Depth is drawn at full length, rising at 63.4°.</source>
        <translation>Dubina se crta u punoj duljini, prema gore pod kutom od 63.4°.</translation>
    </message>
    <message>
        <source>Depth is drawn at half its length, rising at 30°.</source>
        <translation>Dubina se crta u pola duljine, pod kutom od 30°.</translation>
    </message>
    <message>
        <source>Depth is drawn at half its length, rising at 45°.</source>
        <translation>Dubina se crta u pola duljine, prema gore pod kutom od 45°.</translation>
    </message>
    <message>
        <source>Depth is drawn at half its length, rising at 63.4°.</source>
        <translation>Dubina se crta u pola duljine, prema gore pod kutom od 63.4°.</translation>
    </message>
    <message>
        <source>Depth range</source>
        <translation>Raspon dubine</translation>
    </message>
    <message>
        <source>Direct3D: 0 to 1</source>
        <translation>Direct3D: 0 do 1</translation>
    </message>
    <message>
        <source>Direction</source>
        <translation>Smjer</translation>
    </message>
    <message>
        <source>Direction in which depth is drawn, anticlockwise from the right. The target stays in its place in the picture.</source>
        <translation>Smjer u kojem se crta dubina, od desne strane suprotno od kazaljke na satu. Cilj ostaje na svojem mjestu na slici.</translation>
    </message>
    <message>
        <source>Distance</source>
        <translation>Udaljenost</translation>
    </message>
    <message>
        <source>Distance from the eye to the far plane: nothing farther is drawn. A perspective lens also takes inf (∞), at the slider&apos;s end.</source>
        <translation>Udaljenost od kamere do daleke ravnine: ništa udaljenije se ne crta. Perspektivni objektiv prima i inf (∞), na kraju klizača.</translation>
    </message>
    <message>
        <source>Distance from the eye to the near plane: nothing nearer is drawn. The closer to 0, the coarser the depth buffer of a perspective lens.</source>
        <translation>Udaljenost od kamere do bliske ravnine: ništa bliže se ne crta. Što je bliža 0, to je spremnik dubine perspektivnog objektiva grublji.</translation>
    </message>
    <message>
        <source>Distance from the target to the eye.</source>
        <translation>Udaljenost od cilja do kamere.</translation>
    </message>
    <message>
        <source>Drag along the axis to stretch the object</source>
        <translation>Povucite duž osi da rastegnete objekt</translation>
    </message>
    <message>
        <source>Drag in a circle to turn the object</source>
        <translation>Povucite ukrug da okrenete objekt</translation>
    </message>
    <message>
        <source>Drag the eye (Shift: up and down)</source>
        <translation>Povucite kameru (Shift: gore i dolje)</translation>
    </message>
    <message>
        <source>Drag the far plane</source>
        <translation>Povucite daleku ravninu</translation>
    </message>
    <message>
        <source>Drag the near plane</source>
        <translation>Povucite blisku ravninu</translation>
    </message>
    <message>
        <source>Drag the object (Shift: up and down)</source>
        <translation>Povucite objekt (Shift: gore i dolje)</translation>
    </message>
    <message>
        <source>Drag the target (Shift: up and down)</source>
        <translation>Povucite cilj (Shift: gore i dolje)</translation>
    </message>
    <message>
        <source>Drag the tip of up</source>
        <translation>Povucite vrh vektora prema gore</translation>
    </message>
    <message>
        <source>Drag the window&apos;s edge (Shift: both sides)</source>
        <translation>Povucite rub prozora (Shift: obje strane)</translation>
    </message>
    <message>
        <source>Drag to change the field of view</source>
        <translation>Povucite da promijenite vidno polje</translation>
    </message>
    <message>
        <source>Drawing</source>
        <translation>Crtež</translation>
    </message>
    <message>
        <source>Drawn length of a line perpendicular to the picture, relative to its true length: 1 is a cavalier, 0.5 a cabinet drawing, 0 orthographic. The target stays in its place in the picture.</source>
        <translation>Nacrtana duljina linije okomite na sliku, u odnosu na njezinu pravu duljinu: 1 je kavalirski, 0.5 kabinetski crtež, 0 ortogonalni. Cilj ostaje na svojem mjestu na slici.</translation>
    </message>
    <message>
        <source>Elevation</source>
        <translation>Elevacija</translation>
    </message>
    <message>
        <source>Eye</source>
        <translation>Položaj kamere</translation>
    </message>
    <message>
        <source>Far</source>
        <translation>Daleka ravnina</translation>
    </message>
    <message>
        <source>Field of view</source>
        <translation>Vidno polje</translation>
    </message>
    <message>
        <source>Focal length</source>
        <translation>Žarišna duljina</translation>
    </message>
    <message>
        <source>Focal length e</source>
        <translation>Žarišna duljina e</translation>
    </message>
    <message>
        <source>Focal length in pixel heights: K&apos;s second diagonal entry. Equal to fx if the pixels are square.</source>
        <translation>Žarišna duljina u visinama piksela: drugi dijagonalni element matrice K. Jednaka fx ako su pikseli kvadratni.</translation>
    </message>
    <message>
        <source>Focal length in pixel widths: K&apos;s first diagonal entry.</source>
        <translation>Žarišna duljina u širinama piksela: prvi dijagonalni element matrice K.</translation>
    </message>
    <message>
        <source>Focal length of a 35 mm film camera (36 × 24 mm) with the same diagonal field of view: below 35 is wide angle, above 70 telephoto.</source>
        <translation>Žarišna duljina fotoaparata za film od 35 mm (36 × 24 mm) s istim dijagonalnim vidnim poljem: ispod 35 je širokokutni objektiv, iznad 70 teleobjektiv.</translation>
    </message>
    <message>
        <source>Half the height of the picture on the near plane: glFrustum&apos;s top, and −bottom. With near it sets the field of view.</source>
        <translation>Pola visine slike na bliskoj ravnini: top iz glFrustum, i −bottom. Zajedno s bliskom ravninom određuje vidno polje.</translation>
    </message>
    <message>
        <source>Half the width of the picture on the near plane: glFrustum&apos;s right, and −left. With near it sets the field of view.</source>
        <translation>Pola širine slike na bliskoj ravnini: right iz glFrustum, i −left. Zajedno s bliskom ravninom određuje vidno polje.</translation>
    </message>
    <message>
        <source>Half-height</source>
        <translation>Pola visine</translation>
    </message>
    <message>
        <source>Half-width</source>
        <translation>Pola širine</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Visina</translation>
    </message>
    <message>
        <source>Height above the target&apos;s horizon as an angle: 90 looks straight down.</source>
        <translation>Visina iznad horizonta cilja kao kut: 90 gleda ravno dolje.</translation>
    </message>
    <message>
        <source>Height of the picture in pixels.</source>
        <translation>Visina slike u pikselima.</translation>
    </message>
    <message>
        <source>Horizontal fov</source>
        <translation>Horizontalno vidno polje</translation>
    </message>
    <message>
        <source>How the window follows the aspect of the image.</source>
        <translation>Kako prozor slijedi omjer stranica slike.</translation>
    </message>
    <message>
        <source>K intrinsics calibrated camera OpenCV principal point</source>
        <translation>K unutarnji parametri kalibrirana kamera OpenCV glavna točka</translation>
    </message>
    <message>
        <source>Kind of projection. Objects at the target keep their size when it changes.</source>
        <translation>Vrsta projekcije. Kad se promijeni, objekti kod cilja zadržavaju veličinu.</translation>
    </message>
    <message>
        <source>Lecture 003&apos;s focal length e = 1/tan(fov/2), with the horizontal fov: at this distance the picture reaches from x = −1 to 1.</source>
        <translation>Žarišna duljina e = 1/tan(fov/2) iz predavanja 003, s horizontalnim vidnim poljem: na toj udaljenosti slika seže od x = −1 do 1.</translation>
    </message>
    <message>
        <source>Left</source>
        <translation>Lijevi rub</translation>
    </message>
    <message>
        <source>Left edge of the picture&apos;s window on the near plane: where the view volume begins in x of view space.</source>
        <translation>Lijevi rub prozora slike na bliskoj ravnini: gdje volumen pogleda počinje po x u koordinatnom sustavu kamere.</translation>
    </message>
    <message>
        <source>Lens</source>
        <translation>Objektiv</translation>
    </message>
    <message>
        <source>Moves the object along the axes of the tiles to its left.</source>
        <translation>Pomiče objekt duž osi pločica lijevo od sebe.</translation>
    </message>
    <message>
        <source>NDC z</source>
        <translation>NDC z</translation>
    </message>
    <message>
        <source>Near</source>
        <translation>Bliska ravnina</translation>
    </message>
    <message>
        <source>Near goes to 0, far to 1.</source>
        <translation>Bliska ravnina ide u 0, daleka u 1.</translation>
    </message>
    <message>
        <source>Near goes to 1, far to 0: floats are densest where depth needs them.</source>
        <translation>Bliska ravnina ide u 1, daleka u 0: brojevi s pomičnim zarezom najgušći su ondje gdje ih dubina treba.</translation>
    </message>
    <message>
        <source>Near goes to −1, far to 1.</source>
        <translation>Bliska ravnina ide u −1, daleka u 1.</translation>
    </message>
    <message>
        <source>OpenGL: −1 to 1</source>
        <translation>OpenGL: −1 do 1</translation>
    </message>
    <message>
        <source>Principal point, downwards from the centre of the first pixel. At the image&apos;s centre the lens is symmetric, elsewhere off-axis.</source>
        <translation>Glavna točka, prema dolje od središta prvog piksela. U središtu slike objektiv je simetričan, inače je asimetričan.</translation>
    </message>
    <message>
        <source>Principal point, to the right from the centre of the first pixel. At the image&apos;s centre the lens is symmetric, elsewhere off-axis.</source>
        <translation>Glavna točka, udesno od središta prvog piksela. U središtu slike objektiv je simetričan, inače je asimetričan.</translation>
    </message>
    <message>
        <source>Proportions</source>
        <translation>Proporcije</translation>
    </message>
    <message>
        <source>Receding</source>
        <translation>Mjerilo dubine</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>Desni rub</translation>
    </message>
    <message>
        <source>Right edge of the picture&apos;s window on the near plane: where the view volume ends in x of view space.</source>
        <translation>Desni rub prozora slike na bliskoj ravnini: gdje volumen pogleda završava po x u koordinatnom sustavu kamere.</translation>
    </message>
    <message>
        <source>Roll</source>
        <translation>Zakret</translation>
    </message>
    <message>
        <source>Rotation</source>
        <translation>Rotacija</translation>
    </message>
    <message>
        <source>Scale</source>
        <translation>Skaliranje</translation>
    </message>
    <message>
        <source>Shear</source>
        <translation>Smicanje</translation>
    </message>
    <message>
        <source>Stretches the object along the axes of the tiles to its left: 0 flattens it, −1 mirrors it.</source>
        <translation>Rasteže objekt duž osi pločica lijevo od sebe: 0 ga spljošti, −1 ga zrcali.</translation>
    </message>
    <message>
        <source>Target</source>
        <translation>Cilj</translation>
    </message>
    <message>
        <source>The centre of projection, in world coordinates.</source>
        <translation>Centar projekcije, u globalnim koordinatama.</translation>
    </message>
    <message>
        <source>The direction that is vertical in the picture (the lectures&apos; view-up vector); its length does not matter.</source>
        <translation>Smjer koji je na slici vertikalan (view-up vector iz predavanja); duljina mu nije važna.</translation>
    </message>
    <message>
        <source>The moves of the object, as their product is written: the rightmost acts first.</source>
        <translation>Pomicanja objekta, onako kako se piše njihov umnožak: krajnje desno djeluje prvo.</translation>
    </message>
    <message>
        <source>The point that the camera looks at, in world coordinates.</source>
        <translation>Točka prema kojoj kamera gleda, u globalnim koordinatama.</translation>
    </message>
    <message>
        <source>The standard drawings of textbooks. The target stays in its place in the picture.</source>
        <translation>Standardni crteži iz udžbenika. Cilj ostaje na svojem mjestu na slici.</translation>
    </message>
    <message>
        <source>The window fills the image; circles may become ellipses.</source>
        <translation>Prozor ispunjava sliku; kružnice mogu postati elipse.</translation>
    </message>
    <message>
        <source>The x range grows or shrinks about its centre (lecture 000, variant Y).</source>
        <translation>Interval x raste ili se smanjuje oko svoje sredine (predavanje 000, varijanta Y).</translation>
    </message>
    <message>
        <source>The y range grows or shrinks about its centre (lecture 000, variant X).</source>
        <translation>Interval y raste ili se smanjuje oko svoje sredine (predavanje 000, varijanta X).</translation>
    </message>
    <message>
        <source>The z of the near and the far plane in the NDC cube.</source>
        <translation>z bliske i daleke ravnine u kocki NDC.</translation>
    </message>
    <message>
        <source>Top</source>
        <translation>Gornji rub</translation>
    </message>
    <message>
        <source>Top edge of the picture&apos;s window on the near plane: where the view volume ends in y of view space.</source>
        <translation>Gornji rub prozora slike na bliskoj ravnini: gdje volumen pogleda završava po y u koordinatnom sustavu kamere.</translation>
    </message>
    <message>
        <source>Translation</source>
        <translation>Translacija</translation>
    </message>
    <message>
        <source>Turns the camera about its view direction; clockwise as the photographer sees it.</source>
        <translation>Okreće kameru oko njezina smjera gledanja; u smjeru kazaljke na satu kako to vidi fotograf.</translation>
    </message>
    <message>
        <source>Turns the object about an axis through the origin of the tiles to its left.</source>
        <translation>Okreće objekt oko osi kroz ishodište pločica lijevo od sebe.</translation>
    </message>
    <message>
        <source>Typed matrix</source>
        <translation>Upisana matrica</translation>
    </message>
    <message>
        <source>Up</source>
        <translation>Prema gore</translation>
    </message>
    <message>
        <source>Walks round the target: 0 is on its +z side, 90 on its +x side.</source>
        <translation>Kruži oko cilja: 0 je na njegovoj strani +z, 90 na strani +x.</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Širina</translation>
    </message>
    <message>
        <source>Width becomes 1/1 of the height, in whole pixels.</source>
        <translation>Širina postaje 1/1 visine, u cijelim pikselima.</translation>
    </message>
    <message>
        <source>Width becomes 16/9 of the height, in whole pixels.</source>
        <translation>Širina postaje 16/9 visine, u cijelim pikselima.</translation>
    </message>
    <message>
        <source>Width becomes 4/3 of the height, in whole pixels.</source>
        <translation>Širina postaje 4/3 visine, u cijelim pikselima.</translation>
    </message>
    <message>
        <source>Width of the picture in pixels.</source>
        <translation>Širina slike u pikselima.</translation>
    </message>
    <message>
        <source>Width over height. The height stays, and with it the vertical field of view: the picture gains or loses at its sides. The window of another lens follows as “Proportions” says.</source>
        <translation>Širina kroz visinu. Visina ostaje, a s njom i vertikalno vidno polje: slika se proširuje ili sužava sa strana. Prozor drugog objektiva prati je kako je zadano pod „Proporcije”.</translation>
    </message>
    <message>
        <source>cabinet, 30°</source>
        <translation>kabinetski, 30°</translation>
    </message>
    <message>
        <source>cabinet, 45°</source>
        <translation>kabinetski, 45°</translation>
    </message>
    <message>
        <source>cabinet, 63.4°</source>
        <translation>kabinetski, 63.4°</translation>
    </message>
    <message>
        <source>cavalier, 30°</source>
        <translation>kavalirski, 30°</translation>
    </message>
    <message>
        <source>cavalier, 45°</source>
        <translation>kavalirski, 45°</translation>
    </message>
    <message>
        <source>cavalier, 63.4°</source>
        <translation>kavalirski, 63.4°</translation>
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
        <translation>raspon dubine NDC z spremnik OpenGL Direct3D obrnuti</translation>
    </message>
    <message>
        <source>f plane clipping zFar infinity</source>
        <translation>f ravnina odsijecanje zFar far beskonačnost</translation>
    </message>
    <message>
        <source>field of view angle</source>
        <translation>kut vidnog polja</translation>
    </message>
    <message>
        <source>free</source>
        <translation>slobodno</translation>
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
        <translation>polovica kuta</translation>
    </message>
    <message>
        <source>image size ratio proportions</source>
        <translation>veličina slike omjer proporcije</translation>
    </message>
    <message>
        <source>image size resolution pixels</source>
        <translation>veličina slike rezolucija pikseli</translation>
    </message>
    <message>
        <source>keep aspect stretch</source>
        <translation>omjer stranica čuvanje rastezanje</translation>
    </message>
    <message>
        <source>keep x, fit y</source>
        <translation>zadrži x, prilagodi y</translation>
    </message>
    <message>
        <source>keep y, fit x</source>
        <translation>zadrži y, prilagodi x</translation>
    </message>
    <message>
        <source>n plane clipping zNear</source>
        <translation>n ravnina odsijecanje zNear near</translation>
    </message>
    <message>
        <source>object transform translate rotate scale shear mirror matrix tiles order</source>
        <translation>objekt transformacija translacija rotacija skaliranje smicanje zrcaljenje matrica pločice redoslijed</translation>
    </message>
    <message>
        <source>oblique shear</source>
        <translation>koso smicanje</translation>
    </message>
    <message>
        <source>orbit angles</source>
        <translation>kutovi kruženja</translation>
    </message>
    <message>
        <source>orbit tilt</source>
        <translation>nagib kruženja</translation>
    </message>
    <message>
        <source>preset cavalier cabinet oblique</source>
        <translation>gotovi crteži kavalirski kabinetski kosi</translation>
    </message>
    <message>
        <source>projection lens perspective glFrustum glOrtho orthographic oblique matrix</source>
        <translation>projekcija objektiv perspektivna glFrustum glOrtho ortogonalna kosa matrica</translation>
    </message>
    <message>
        <source>reversed: 1 to 0</source>
        <translation>obrnuti: 1 do 0</translation>
    </message>
    <message>
        <source>stretch</source>
        <translation>rastegni</translation>
    </message>
    <message>
        <source>times the true length</source>
        <translation>puta prava duljina</translation>
    </message>
    <message>
        <source>vectors look at</source>
        <translation>vektori gleda prema look at</translation>
    </message>
    <message>
        <source>vectors position</source>
        <translation>vektori položaj eye</translation>
    </message>
    <message>
        <source>vectors view-up VUP</source>
        <translation>vektori view-up VUP</translation>
    </message>
    <message>
        <source>vertical fov angle zoom gluPerspective</source>
        <translation>vertikalno fov kut zum gluPerspective</translation>
    </message>
    <message>
        <source>window l r b t glFrustum glOrtho off-axis</source>
        <translation>prozor l r b t glFrustum glOrtho asimetrični</translation>
    </message>
    <message>
        <source>window right r glFrustum</source>
        <translation>prozor desno r glFrustum</translation>
    </message>
    <message>
        <source>window top t glFrustum</source>
        <translation>prozor gore t glFrustum</translation>
    </message>
    <message>
        <source>zoom 35 mm camera f</source>
        <translation>zum 35 mm fotoaparat f</translation>
    </message>
</context>
<context>
    <name>Files</name>
    <message>
        <source>Opening {0}</source>
        <translation>Otvara se {0}</translation>
    </message>
    <message>
        <source>Open a document, a lesson, a mesh, a camera or an exported picture</source>
        <translation>Otvara dokument, lekciju, mrežu, kameru ili izvezenu sliku</translation>
    </message>
    <message>
        <source>All supported files ({0});;All files (*)</source>
        <translation>Sve podržane datoteke ({0});;Sve datoteke (*)</translation>
    </message>
    <message>
        <source>Open a camera</source>
        <translation>Otvori kameru</translation>
    </message>
    <message>
        <source>The file has {0} views:</source>
        <translation>Datoteka ima više pogleda ({0}):</translation>
    </message>
    <message>
        <source>Close the lesson, and Undo brings back the unsaved changes to {0}.</source>
        <translation>Zatvorite lekciju, a Poništi zatim vraća nespremljene promjene: {0}.</translation>
    </message>
    <message>
        <source>Undo brings back the unsaved changes to {0}.</source>
        <translation>Poništi vraća nespremljene promjene: {0}.</translation>
    </message>
    <message>
        <source>Where is the mesh {0} of this picture?</source>
        <translation>Gdje je mreža {0} ove slike?</translation>
    </message>
    <message>
        <source>Meshes ({0});;All files (*)</source>
        <translation>Mreže ({0});;Sve datoteke (*)</translation>
    </message>
    <message>
        <source>Use a mesh in place of the scene&apos;s own objects</source>
        <translation>Koristi mrežu umjesto vlastitih objekata scene</translation>
    </message>
    <message>
        <source>{0} has been changed elsewhere since it was opened or saved here.</source>
        <translation>Datoteka {0} promijenjena je drugdje otkako je ovdje otvorena ili spremljena.</translation>
    </message>
    <message>
        <source>Save over it?</source>
        <translation>Želite li spremiti preko nje?</translation>
    </message>
    <message>
        <source>Save &amp;over it</source>
        <translation>Spremi &amp;preko nje</translation>
    </message>
    <message>
        <source>Save &amp;as…</source>
        <translation>Spremi k&amp;ao…</translation>
    </message>
    <message>
        <source>Save the document</source>
        <translation>Spremi dokument</translation>
    </message>
    <message>
        <source>Frustum Lab documents (*.json)</source>
        <translation>Dokumenti programa Frustum Lab (*.json)</translation>
    </message>
    <message>
        <source>There are unsaved changes.</source>
        <translation>Ima nespremljenih promjena.</translation>
    </message>
    <message>
        <source>Save them first?</source>
        <translation>Želite li ih najprije spremiti?</translation>
    </message>
    <message>
        <source>Untitled</source>
        <translation>Bez naslova</translation>
    </message>
</context>
<context>
    <name>FixedViews</name>
    <message>
        <source>Free</source>
        <translation>Slobodno</translation>
    </message>
    <message>
        <source>As you turned it with the mouse</source>
        <translation>Kako ste ga okrenuli mišem</translation>
    </message>
    <message>
        <source>Side</source>
        <translation>Sa strane</translation>
    </message>
    <message>
        <source>From the side, flat like a sketch on the blackboard, with its lengths</source>
        <translation>Sa strane, ravno kao skica na ploči, s duljinama</translation>
    </message>
    <message>
        <source>Above</source>
        <translation>Odozgo</translation>
    </message>
    <message>
        <source>From above, flat, with its lengths</source>
        <translation>Odozgo, ravno, s duljinama</translation>
    </message>
    <message>
        <source>Axis</source>
        <translation>Os</translation>
    </message>
    <message>
        <source>Along the camera&apos;s axis, flat</source>
        <translation>Duž osi kamere, ravno</translation>
    </message>
    <message>
        <source>Eye</source>
        <translation>Kamera</translation>
    </message>
    <message>
        <source>From the eye, as the camera sees it</source>
        <translation>Iz kamere, onako kako ona vidi</translation>
    </message>
    <message>
        <source>Viewpoint of the world</source>
        <translation>Gledište na svijet</translation>
    </message>
</context>
<context>
    <name>FramePanel</name>
    <message>
        <source>Camera frame</source>
        <translation>Koordinatni sustav kamere</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Natrag</translation>
    </message>
    <message>
        <source>One step back</source>
        <translation>Jedan korak natrag</translation>
    </message>
    <message>
        <source>Next</source>
        <translation>Dalje</translation>
    </message>
    <message>
        <source>The next step</source>
        <translation>Sljedeći korak</translation>
    </message>
    <message>
        <source>Show all</source>
        <translation>Prikaži sve</translation>
    </message>
    <message>
        <source>All steps at once</source>
        <translation>Svi koraci odjednom</translation>
    </message>
    <message>
        <source>The step in numbers</source>
        <translation>Korak u brojevima</translation>
    </message>
    <message>
        <source>Up from view</source>
        <translation>Prema gore od pogleda</translation>
    </message>
    <message>
        <source>Turns up towards the view direction, in the plane of both. The frame stays the same until up is too close to the view direction to say where right is.</source>
        <translation>Okreće smjer prema gore k smjeru gledanja, u ravnini obaju. Koordinatni sustav ostaje isti dok smjer prema gore ne dođe preblizu smjeru gledanja da bi određivao što je desno.</translation>
    </message>
    <message>
        <source>degrees</source>
        <translation>stupnjeva</translation>
    </message>
    <message>
        <source>Nudge up by {0}° to the side</source>
        <translation>Pomakni smjer prema gore za {0}° u stranu</translation>
    </message>
    <message>
        <source>Make an error in up, and see how far the picture turns</source>
        <translation>Unosi pogrešku u smjer prema gore i pokazuje koliko se slika okrene</translation>
    </message>
    <message>
        <source>The effect of up</source>
        <translation>Učinak smjera prema gore</translation>
    </message>
    <message>
        <source>The step</source>
        <translation>Korak</translation>
    </message>
    <message>
        <source>{0} of {1}: {2}</source>
        <translation>{0} od {1}: {2}</translation>
    </message>
    <message>
        <source>Play</source>
        <translation>Pokreni</translation>
    </message>
    <message>
        <source>Show one step after the other</source>
        <translation>Prikazuje korak za korakom</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Zaustavi</translation>
    </message>
    <message>
        <source>Stay at this step</source>
        <translation>Ostaje na ovom koraku</translation>
    </message>
    <message>
        <source>Angle of {3} and view direction: {0}°
|{3} × {4}| = {1}
An error in {3} is {2} times as large in u and v.</source>
        <translation>Kut između {3} i smjera gledanja: {0}°
|{3} × {4}| = {1}
Pogreška u {3} postaje {2} puta veća u osima u i v.</translation>
    </message>
    <message>
        <source>Up is only {0}° from the line of sight: up × n is nearly 0, and an error of {1}° in up turns the picture by up to {2}°.</source>
        <translation>Smjer prema gore je samo {0}° od smjera gledanja: gore × n je gotovo 0, a pogreška od {1}° u smjeru prema gore okreće sliku do {2}°.</translation>
    </message>
    <message>
        <source>No camera has the typed view matrix: these are the numbers of the previous camera. Undo, or choose a lens.</source>
        <translation>Nijedna kamera nema upisanu matricu pogleda: ovo su brojevi prethodne kamere. Poništite ili odaberite objektiv.</translation>
    </message>
    <message>
        <source>Backwards, from the target to the eye, of length 1: the camera looks along −{n}.</source>
        <translation>Unatrag, od cilja prema kameri, duljine 1: kamera gleda duž −{n}.</translation>
    </message>
    <message>
        <source>The camera looks at the target; only the direction matters.</source>
        <translation>Kamera gleda prema cilju; važan je samo smjer.</translation>
    </message>
    <message>
        <source>The centre of projection: where the camera stands in the world.</source>
        <translation>Centar projekcije: mjesto na kojem kamera stoji u svijetu.</translation>
    </message>
    <message>
        <source>The direction that is vertical in the picture. It need not be perpendicular to the view, and its length does not matter.</source>
        <translation>Smjer koji je na slici vertikalan. Ne mora biti okomit na smjer gledanja, a duljina mu nije važna.</translation>
    </message>
    <message>
        <source>The rows of the rotation R are {u}, {v} and {n}; {T} moves the eye to the origin, so that the last column is −R {e}.</source>
        <translation>Retci rotacije R su {u}, {v} i {n}; {T} pomiče kameru u ishodište, pa je posljednji stupac −R {e}.</translation>
    </message>
    <message>
        <source>To the right in the picture: at right angles to {up} and {n}, of length 1.</source>
        <translation>Na slici udesno: okomito na {up} i {n}, duljine 1.</translation>
    </message>
    <message>
        <source>Upwards in the picture: at right angles to {n} and {u}. It is the part of {up} at right angles to the view.</source>
        <translation>Na slici prema gore: okomito na {n} i {u}. To je dio vektora {up} okomit na smjer gledanja.</translation>
    </message>
    <message>
        <source>eye</source>
        <translation>položaj kamere</translation>
    </message>
    <message>
        <source>look</source>
        <translation>smjer gledanja</translation>
    </message>
    <message>
        <source>up</source>
        <translation>prema gore</translation>
    </message>
    <message>
        <source>view matrix</source>
        <translation>matrica pogleda</translation>
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
        <translation>Povlačenje okreće, povlačenje uz Shift pomiče, kotačić mijenja veličinu</translation>
    </message>
    <message>
        <source>Arrow keys turn, Shift and an arrow moves, + and − zoom, Home resets.</source>
        <translation>Strelice okreću, Shift i strelica pomiču, + i − mijenjaju veličinu, Home vraća.</translation>
    </message>
    <message>
        <source>Drag to move the camera, wheel to go nearer</source>
        <translation>Povlačenje pomiče kameru, kotačić je približava</translation>
    </message>
    <message>
        <source>Arrow keys move the camera in its plane, + and − go nearer and back.</source>
        <translation>Strelice pomiču kameru u njezinoj ravnini, + i − je približavaju i udaljavaju.</translation>
    </message>
    <message>
        <source>Page Down and Page Up go from vertex to vertex, with Shift from handle to handle or probe to probe; Space follows a vertex; Enter takes hold and lets go, Shift and Enter as a drag with Shift; arrows drag by a pixel, with Shift by ten; Escape puts back.</source>
        <translation>Page Down i Page Up idu od vrha do vrha, uz Shift od ručice do ručice ili od sonde do sonde; Space prati vrh; Enter hvata i pušta, Shift i Enter kao povlačenje uz Shift; strelice povlače za piksel, uz Shift za deset; Escape vraća na mjesto.</translation>
    </message>
</context>
<context>
    <name>Header</name>
    <message>
        <source>Double-click to enlarge this pane, again for the whole window, and again to go back</source>
        <translation>Dvoklik povećava ovo okno, još jedan ga širi na cijeli prozor, a sljedeći vraća natrag</translation>
    </message>
</context>
<context>
    <name>Health</name>
    <message>
        <source>A GPU&apos;s float32 cannot hold this picture: it is computed in float64</source>
        <translation>float32 grafičke kartice ne može prikazati ovu sliku: računa se u float64</translation>
    </message>
    <message>
        <source>A GPU&apos;s float32 could be up to {0} px off: the picture is computed in float64</source>
        <translation>float32 grafičke kartice mogao bi pogriješiti do {0} px: slika se računa u float64</translation>
    </message>
    <message>
        <source>At the target, a 24-bit depth buffer cannot tell any two surfaces apart</source>
        <translation>Kod cilja 24-bitni spremnik dubine ne može razlikovati nikoje dvije plohe</translation>
    </message>
    <message>
        <source>At the target, a 24-bit depth buffer separates only surfaces at least {0} apart</source>
        <translation>Kod cilja 24-bitni spremnik dubine razlikuje samo plohe koje su razmaknute bar {0}</translation>
    </message>
    <message>
        <source>In float64 few decimals would be certain, {0} of a pixel and {1} of the depth: the numbers are computed exactly</source>
        <translation>U float64 bilo bi sigurno malo decimala, {0} piksela i {1} dubine: brojevi se računaju egzaktno</translation>
    </message>
    <message>
        <source>None of the scene&apos;s objects is in the picture: all lie outside the {0} plane</source>
        <translation>Nijedan objekt scene nije na slici: svi leže izvan ove ravnine: {0}</translation>
    </message>
    <message>
        <source>The free matrix has no inverse: no frustum is drawn</source>
        <translation>Slobodna matrica nema inverz: krnja piramida se ne crta</translation>
    </message>
    <message>
        <source>The free matrix is too nearly singular: no frustum is drawn</source>
        <translation>Slobodna matrica je gotovo singularna: krnja piramida se ne crta</translation>
    </message>
    <message>
        <source>The free matrix&apos;s view volume reaches infinity: no frustum is drawn</source>
        <translation>Volumen pogleda slobodne matrice seže u beskonačnost: krnja piramida se ne crta</translation>
    </message>
    <message>
        <source>The scene is {0} times as large as the near distance: from 1e7 on, VTK alone does not draw what is near</source>
        <translation>Scena je {0} puta veća od udaljenosti bliske ravnine: od 1e7 naviše VTK sam ne crta ono što je blizu</translation>
    </message>
    <message>
        <source>VTK&apos;s own camera would clamp the field of view to {0}°</source>
        <translation>Kamera samog VTK-a ograničila bi vidno polje na {0}°</translation>
    </message>
</context>
<context>
    <name>Help</name>
    <message>
        <source>Keys and mouse</source>
        <translation>Tipke i miš</translation>
    </message>
    <message>
        <source>. or B</source>
        <translation>. ili B</translation>
    </message>
    <message>
        <source>&lt;b&gt;Frustum Lab {0}&lt;/b&gt;</source>
        <translation>&lt;b&gt;Frustum Lab {0}&lt;/b&gt;</translation>
    </message>
    <message>
        <source>A black screen, and back</source>
        <translation>Crn ekran i natrag</translation>
    </message>
    <message>
        <source>A corner</source>
        <translation>Kut prozora</translation>
    </message>
    <message>
        <source>A hint; {Alt+W} shows why an answer is wrong</source>
        <translation>Savjet; {Alt+K} pokazuje zašto je odgovor netočan</translation>
    </message>
    <message>
        <source>A lamp, a point, also in the cube and the image</source>
        <translation>Svjetiljka, točka, i u kocki i na slici</translation>
    </message>
    <message>
        <source>A laser pointer; pictures do not react to it</source>
        <translation>Laserski pokazivač; slike na njega ne reagiraju</translation>
    </message>
    <message>
        <source>A pane&apos;s own view (the model does not change)</source>
        <translation>Vlastiti pogled okna (model se ne mijenja)</translation>
    </message>
    <message>
        <source>A picture plane, a film, a plane in focus</source>
        <translation>Ravnina slike, film, izoštrena ravnina</translation>
    </message>
    <message>
        <source>A side of a lens with a window</source>
        <translation>Stranica prozora objektiva</translation>
    </message>
    <message>
        <source>A small step; Home and End go to its ends</source>
        <translation>Mali korak; Home i End idu na krajeve</translation>
    </message>
    <message>
        <source>About Frustum Lab</source>
        <translation>O programu Frustum Lab</translation>
    </message>
    <message>
        <source>Always turn the view</source>
        <translation>Uvijek okreće pogled</translation>
    </message>
    <message>
        <source>Arrows, Enter</source>
        <translation>Strelice, Enter</translation>
    </message>
    <message>
        <source>Arrows, while held</source>
        <translation>Strelice, dok se drži</translation>
    </message>
    <message>
        <source>Backspace, or {Ctrl+Z}</source>
        <translation>Backspace ili {Ctrl+Z}</translation>
    </message>
    <message>
        <source>Bring World, NDC cube or Image into the large slot</source>
        <translation>Stavlja Svijet, Kocku NDC ili Sliku na veliko mjesto</translation>
    </message>
    <message>
        <source>Camera frame: &lt;i&gt;n&lt;/i&gt; = (eye − target)/|·|, &lt;i&gt;u&lt;/i&gt; = up × n/|·|, &lt;i&gt;v&lt;/i&gt; = n × u.</source>
        <translation>Koordinatni sustav kamere: &lt;i&gt;n&lt;/i&gt; = (kamera − cilj)/|·|, &lt;i&gt;u&lt;/i&gt; = gore × n/|·|, &lt;i&gt;v&lt;/i&gt; = n × u.</translation>
    </message>
    <message>
        <source>Change the field of view, or that corner of a lens with a window; with Shift, both sides</source>
        <translation>Mijenja vidno polje ili taj kut kod objektiva s prozorom; uz Shift obje strane</translation>
    </message>
    <message>
        <source>Change the value, with Ctrl or when the slider has the focus</source>
        <translation>Mijenja vrijednost, uz Ctrl ili kad je fokus na klizaču</translation>
    </message>
    <message>
        <source>Choose an answer and submit it; Enter also checks a typed answer</source>
        <translation>Bira odgovor i predaje ga; Enter provjerava i upisan odgovor</translation>
    </message>
    <message>
        <source>Click</source>
        <translation>Klik</translation>
    </message>
    <message>
        <source>Close what is on top, or cancel a drag</source>
        <translation>Zatvara ono što je na vrhu ili prekida povlačenje</translation>
    </message>
    <message>
        <source>Column vectors, &lt;i&gt;p&apos; = M p&lt;/i&gt;. World and view are right-handed with y up; the camera looks along −z of view space.</source>
        <translation>Vektori stupci, &lt;i&gt;p&apos; = M p&lt;/i&gt;. Globalni sustav i sustav kamere su desni, s osi y prema gore; kamera gleda duž −z svojega koordinatnog sustava.</translation>
    </message>
    <message>
        <source>Compare side by side or overlaid</source>
        <translation>Uspoređuje jedno uz drugo ili preklopljeno</translation>
    </message>
    <message>
        <source>Controls</source>
        <translation>Kontrole</translation>
    </message>
    <message>
        <source>Conventions</source>
        <translation>Dogovori o oznakama</translation>
    </message>
    <message>
        <source>Digits, then Enter</source>
        <translation>Znamenke, zatim Enter</translation>
    </message>
    <message>
        <source>Double-click</source>
        <translation>Dvoklik</translation>
    </message>
    <message>
        <source>Double-click its name</source>
        <translation>Dvoklik na ime</translation>
    </message>
    <message>
        <source>Double-click, F2 or Enter</source>
        <translation>Dvoklik, F2 ili Enter</translation>
    </message>
    <message>
        <source>Drag</source>
        <translation>Povlačenje</translation>
    </message>
    <message>
        <source>Drag by one pixel; with Shift, by ten; Esc cancels</source>
        <translation>Povlači za jedan piksel, uz Shift za deset; Esc prekida</translation>
    </message>
    <message>
        <source>Drag it; with Shift, ten times finer</source>
        <translation>Povlači ga; uz Shift deset puta finije</translation>
    </message>
    <message>
        <source>Drag its mark in the image</source>
        <translation>Povlačenje njezine oznake na slici</translation>
    </message>
    <message>
        <source>Drag, or arrows</source>
        <translation>Povlačenje ili strelice</translation>
    </message>
    <message>
        <source>Draw on the slide, or put the pen away</source>
        <translation>Crta po slajdu ili odlaže olovku</translation>
    </message>
    <message>
        <source>Draw; with the right mouse button, erase</source>
        <translation>Crta; desnom tipkom miša briše</translation>
    </message>
    <message>
        <source>Drop a file</source>
        <translation>Ispuštanje datoteke</translation>
    </message>
    <message>
        <source>E</source>
        <translation>E</translation>
    </message>
    <message>
        <source>Enlarge or shrink the speaker&apos;s notes</source>
        <translation>Povećava ili smanjuje bilješke predavača</translation>
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
        <translation>Svuda</translation>
    </message>
    <message>
        <source>Export the panes as a picture</source>
        <translation>Izvozi okna kao sliku</translation>
    </message>
    <message>
        <source>Eye, target</source>
        <translation>Kamera, cilj</translation>
    </message>
    <message>
        <source>Field</source>
        <translation>Polje</translation>
    </message>
    <message>
        <source>Find a control by its name</source>
        <translation>Nalazi kontrolu po imenu</translation>
    </message>
    <message>
        <source>Follow the point through all panes</source>
        <translation>Prati točku kroz sva okna</translation>
    </message>
    <message>
        <source>Follow the vertex</source>
        <translation>Prati vrh</translation>
    </message>
    <message>
        <source>Give that pane the whole window</source>
        <translation>Daje tom oknu cijeli prozor</translation>
    </message>
    <message>
        <source>Go from stage to stage</source>
        <translation>Ide od etape do etape</translation>
    </message>
    <message>
        <source>Go from vertex to vertex; with Shift, from grip to grip</source>
        <translation>Ide od vrha do vrha; uz Shift od ručice do ručice</translation>
    </message>
    <message>
        <source>Go nearer or farther</source>
        <translation>Približava ili udaljava</translation>
    </message>
    <message>
        <source>Go to the next number; Esc leaves the field</source>
        <translation>Ide na sljedeći broj; Esc napušta polje</translation>
    </message>
    <message>
        <source>Go to the step of that number</source>
        <translation>Ide na korak s tim brojem</translation>
    </message>
    <message>
        <source>Hide the controls, or show them</source>
        <translation>Skriva ili prikazuje kontrole</translation>
    </message>
    <message>
        <source>Highlight the same thing everywhere; the keyboard&apos;s focus does the same</source>
        <translation>Ističe isto svuda; isto čini i fokus tipkovnice</translation>
    </message>
    <message>
        <source>Hold it and compare it with later ones, or end the comparison</source>
        <translation>Zadržava je i uspoređuje s kasnijima ili završava usporedbu</translation>
    </message>
    <message>
        <source>Hold what has the grip and release it; with Shift, it works like a Shift-drag</source>
        <translation>Hvata ono što ima ručicu i pušta ga; uz Shift djeluje kao povlačenje uz Shift</translation>
    </message>
    <message>
        <source>Hover over a control, a number, a matrix cell, or what can be dragged</source>
        <translation>Pokazivač nad kontrolom, brojem, ćelijom matrice ili nečim što se može povlačiti</translation>
    </message>
    <message>
        <source>How a camera turns a 3-D scene into a picture: the world, the NDC cube and the image, from one model.</source>
        <translation>Kako kamera 3D scenu pretvara u sliku: svijet, kocka NDC i slika, iz jednog modela.</translation>
    </message>
    <message>
        <source>Image: origin top left, x right, y down, in pixels; the first pixel&apos;s centre is at 0.5.</source>
        <translation>Slika: ishodište gore lijevo, x udesno, y prema dolje, u pikselima; središte prvog piksela je na 0.5.</translation>
    </message>
    <message>
        <source>K</source>
        <translation>K</translation>
    </message>
    <message>
        <source>Keep the slides with their strokes beside the talk, for the handout</source>
        <translation>Čuva slajdove s potezima uz izlaganje, za materijal za podjelu</translation>
    </message>
    <message>
        <source>Lessons</source>
        <translation>Lekcije</translation>
    </message>
    <message>
        <source>MIT licence.</source>
        <translation>Licenca MIT.</translation>
    </message>
    <message>
        <source>Make World, NDC cube or Image the slide; the same key again shows all panes</source>
        <translation>Čini Svijet, Kocku NDC ili Sliku slajdom; ista tipka opet prikazuje sva okna</translation>
    </message>
    <message>
        <source>Mark in all panes the point under the mouse</source>
        <translation>Označava u svim oknima točku pod mišem</translation>
    </message>
    <message>
        <source>Matrices</source>
        <translation>Matrice</translation>
    </message>
    <message>
        <source>Middle mouse button</source>
        <translation>Srednja tipka miša</translation>
    </message>
    <message>
        <source>Mouse at the top</source>
        <translation>Miš uz gornji rub</translation>
    </message>
    <message>
        <source>Move along the view direction; by the face, too, where the scene has their controls</source>
        <translation>Pomiče duž smjera gledanja; ako scena ima kontrole tih ravnina, mogu se uhvatiti i za samu plohu</translation>
    </message>
    <message>
        <source>Move in the plane that faces you; with Shift, up and down</source>
        <translation>Pomiče u ravnini okrenutoj prema vama; uz Shift gore i dolje</translation>
    </message>
    <message>
        <source>Move it</source>
        <translation>Pomiče ga</translation>
    </message>
    <message>
        <source>Move it along its way</source>
        <translation>Pomiče je po njezinu putu</translation>
    </message>
    <message>
        <source>Move it; with Shift, both sides</source>
        <translation>Pomiče je; uz Shift obje strane</translation>
    </message>
    <message>
        <source>Move it; with Shift, finer; Home and End go to the edges; Esc ends the comparison</source>
        <translation>Pomiče ga; uz Shift finije; Home i End idu na rubove; Esc završava usporedbu</translation>
    </message>
    <message>
        <source>Move it; with Shift, up and down</source>
        <translation>Pomiče je; uz Shift gore i dolje</translation>
    </message>
    <message>
        <source>Move the camera in its plane</source>
        <translation>Pomiče kameru u njezinoj ravnini</translation>
    </message>
    <message>
        <source>Move the camera towards the target or away from it</source>
        <translation>Pomiče kameru prema cilju ili od njega</translation>
    </message>
    <message>
        <source>Move the point in its plane; with Shift, along its ray</source>
        <translation>Pomiče točku u njezinoj ravnini; uz Shift duž njezine zrake</translation>
    </message>
    <message>
        <source>NDC is the OpenGL cube [−1, 1]³, near at −1 and far at +1; Direct3D has z in [0, 1], reversed in [1, 0]. It is drawn with z mirrored so that the near face is towards you.</source>
        <translation>NDC je kocka OpenGL-a [−1, 1]³, bliska ravnina na −1, a daleka na +1; Direct3D ima z u [0, 1], obrnuti raspon u [1, 0]. Crta se sa zrcaljenim z, tako da je bliska strana okrenuta prema vama.</translation>
    </message>
    <message>
        <source>Name everything in the pictures, or only what the scene is about</source>
        <translation>Imenuje sve na slikama ili samo ono o čemu scena govori</translation>
    </message>
    <message>
        <source>Near, far, by an edge or their name</source>
        <translation>Bliska i daleka ravnina, za rub ili za ime</translation>
    </message>
    <message>
        <source>Open a document, a lesson, a mesh (OBJ, STL, PLY, glTF), a camera (NeRF, COLMAP, OpenCV) or an exported picture</source>
        <translation>Otvara dokument, lekciju, mrežu (OBJ, STL, PLY, glTF), kameru (NeRF, COLMAP, OpenCV) ili izvezenu sliku</translation>
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
        <translation>Lijepi broj u ćeliju ili cijelu matricu</translation>
    </message>
    <message>
        <source>Play it back and forth</source>
        <translation>Pokreće ga naprijed-natrag</translation>
    </message>
    <message>
        <source>Play or pause the camera&apos;s walk</source>
        <translation>Pokreće ili zaustavlja obilazak kamere</translation>
    </message>
    <message>
        <source>Pointing</source>
        <translation>Pokazivanje</translation>
    </message>
    <message>
        <source>Points to follow</source>
        <translation>Točke koje se prate</translation>
    </message>
    <message>
        <source>Present a talk from its first step</source>
        <translation>Izlaže izlaganje od prvog koraka</translation>
    </message>
    <message>
        <source>Present on the full screen, in letters for the back row; again to end</source>
        <translation>Izlaže preko cijelog ekrana, slovima za posljednji red; ponovno za kraj</translation>
    </message>
    <message>
        <source>Presenting</source>
        <translation>Izlaganje</translation>
    </message>
    <message>
        <source>Presenting a talk, and in the speaker&apos;s window</source>
        <translation>Pri izlaganju i u prozoru predavača</translation>
    </message>
    <message>
        <source>Remove it</source>
        <translation>Uklanja je</translation>
    </message>
    <message>
        <source>Remove the last stroke; Delete removes all strokes of the step</source>
        <translation>Uklanja posljednji potez; Delete uklanja sve poteze u koraku</translation>
    </message>
    <message>
        <source>Reset all to how the scene opens</source>
        <translation>Vraća sve na ono s čime se scena otvara</translation>
    </message>
    <message>
        <source>Reset it</source>
        <translation>Vraća početnu vrijednost</translation>
    </message>
    <message>
        <source>Shift-drag</source>
        <translation>Povlačenje uz Shift</translation>
    </message>
    <message>
        <source>Show all panes as the scene opens</source>
        <translation>Prikazuje sva okna kako se scena otvara</translation>
    </message>
    <message>
        <source>Show the controls of the slide, or hide them</source>
        <translation>Prikazuje ili skriva kontrole slajda</translation>
    </message>
    <message>
        <source>Show the dock, or hide it</source>
        <translation>Prikazuje ili skriva bočnu ploču</translation>
    </message>
    <message>
        <source>Show the question, then its answer, and stay at the step</source>
        <translation>Prikazuje pitanje, zatim odgovor, i ostaje na koraku</translation>
    </message>
    <message>
        <source>Show the question, then its answer, then the next step; Page Up goes the same way back</source>
        <translation>Prikazuje pitanje, zatim odgovor, zatim sljedeći korak; Page Up ide istim putem natrag</translation>
    </message>
    <message>
        <source>Show the slide of the step again</source>
        <translation>Ponovno prikazuje slajd koraka</translation>
    </message>
    <message>
        <source>Show the step again, without your changes</source>
        <translation>Ponovno prikazuje korak, bez vaših promjena</translation>
    </message>
    <message>
        <source>Show the tool bar</source>
        <translation>Prikazuje alatnu traku</translation>
    </message>
    <message>
        <source>Slider</source>
        <translation>Klizač</translation>
    </message>
    <message>
        <source>Space</source>
        <translation>Space</translation>
    </message>
    <message>
        <source>Swap the screens of the class and of the notes</source>
        <translation>Zamjenjuje ekrane za studente i za bilješke</translation>
    </message>
    <message>
        <source>Tab</source>
        <translation>Tab</translation>
    </message>
    <message>
        <source>Tab to the divider, then arrows</source>
        <translation>Tab do razdjelnika, zatim strelice</translation>
    </message>
    <message>
        <source>Tab, then arrows</source>
        <translation>Tab, zatim strelice</translation>
    </message>
    <message>
        <source>The arrangement of the panes</source>
        <translation>Raspored okana</translation>
    </message>
    <message>
        <source>The eraser, or the pen again</source>
        <translation>Gumica ili opet olovka</translation>
    </message>
    <message>
        <source>The next colour</source>
        <translation>Sljedeća boja</translation>
    </message>
    <message>
        <source>The next step and the previous one, unless a pane or a control has the focus</source>
        <translation>Sljedeći i prethodni korak, osim kad je fokus u oknu ili na kontroli</translation>
    </message>
    <message>
        <source>The next step; {Alt+Left} for the previous one</source>
        <translation>Sljedeći korak; {Alt+Left} za prethodni</translation>
    </message>
    <message>
        <source>The picture in the image pane</source>
        <translation>Slika u oknu Slika</translation>
    </message>
    <message>
        <source>The same key again, or a double-click on a title</source>
        <translation>Ista tipka ponovno ili dvoklik na naslov</translation>
    </message>
    <message>
        <source>The strip of stages</source>
        <translation>Traka etapa</translation>
    </message>
    <message>
        <source>The triangle</source>
        <translation>Trokutić</translation>
    </message>
    <message>
        <source>Turn it</source>
        <translation>Okreće ga</translation>
    </message>
    <message>
        <source>Turn it; with Shift, move it; + and − go nearer or farther; Home resets it</source>
        <translation>Okreće ga; uz Shift ga pomiče; + i − približavaju ili udaljavaju; Home ga vraća</translation>
    </message>
    <message>
        <source>Type a number, even beyond the slider&apos;s ends, and press Enter; Esc discards it</source>
        <translation>Upišite broj, i izvan krajeva klizača, pa pritisnite Enter; Esc ga odbacuje</translation>
    </message>
    <message>
        <source>Type another number into view ← world or clip ← view</source>
        <translation>Upišite drugi broj u kamera ← svijet ili odsijecanje ← kamera</translation>
    </message>
    <message>
        <source>Undo; a drag is one step</source>
        <translation>Poništava; povlačenje je jedan korak</translation>
    </message>
    <message>
        <source>What you can drag (it lights up, and the pointer shows its way)</source>
        <translation>Što možete povlačiti (zasvijetli, a pokazivač pokazuje njegov put)</translation>
    </message>
    <message>
        <source>Wheel</source>
        <translation>Kotačić</translation>
    </message>
    <message>
        <source>Wheel, or + and −</source>
        <translation>Kotačić ili + i −</translation>
    </message>
    <message>
        <source>With the pen</source>
        <translation>S olovkom</translation>
    </message>
    <message>
        <source>Without a mouse, in a pane that Tab has reached</source>
        <translation>Bez miša, u oknu do kojeg je došao Tab</translation>
    </message>
    <message>
        <source>X</source>
        <translation>X</translation>
    </message>
    <message>
        <source>{Alt+I}</source>
        <translation>{Alt+A}</translation>
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
        <translation>{Ctrl+F} ili /</translation>
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
        <translation>{L}, držati</translation>
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
        <translation>Skriveno dok se na vježbu ne odgovori</translation>
    </message>
    <message>
        <source>Closed during a test</source>
        <translation>Zatvoreno tijekom testa</translation>
    </message>
</context>
<context>
    <name>Kind</name>
    <message>
        <source>1-point</source>
        <translation>1 nedogled</translation>
    </message>
    <message>
        <source>2-point</source>
        <translation>2 nedogleda</translation>
    </message>
    <message>
        <source>3-point</source>
        <translation>3 nedogleda</translation>
    </message>
    <message>
        <source>all projectors are parallel</source>
        <translation>sve su zrake projiciranja paralelne</translation>
    </message>
    <message>
        <source>all projectors meet in the eye</source>
        <translation>sve se zrake projiciranja sijeku u kameri</translation>
    </message>
    <message>
        <source>all three axes make equal angles with the image plane</source>
        <translation>sve tri osi zatvaraju jednake kutove s ravninom slike</translation>
    </message>
    <message>
        <source>axonometric</source>
        <translation>aksonometrijska</translation>
    </message>
    <message>
        <source>cabinet</source>
        <translation>kabinetska</translation>
    </message>
    <message>
        <source>cavalier</source>
        <translation>kavalirska</translation>
    </message>
    <message>
        <source>dimetric</source>
        <translation>dimetrijska</translation>
    </message>
    <message>
        <source>front</source>
        <translation>sprijeda</translation>
    </message>
    <message>
        <source>isometric</source>
        <translation>izometrijska</translation>
    </message>
    <message>
        <source>multiview</source>
        <translation>u više pogleda</translation>
    </message>
    <message>
        <source>no axis is parallel to the image plane: three vanishing points</source>
        <translation>nijedna os nije paralelna s ravninom slike: tri nedogleda</translation>
    </message>
    <message>
        <source>no two axes are parallel to the image plane</source>
        <translation>nikoje dvije osi nisu paralelne s ravninom slike</translation>
    </message>
    <message>
        <source>oblique</source>
        <translation>kosa</translation>
    </message>
    <message>
        <source>one axis is parallel to the image plane: two vanishing points</source>
        <translation>jedna os je paralelna s ravninom slike: dva nedogleda</translation>
    </message>
    <message>
        <source>orthographic</source>
        <translation>ortogonalna</translation>
    </message>
    <message>
        <source>parallel</source>
        <translation>paralelna</translation>
    </message>
    <message>
        <source>perspective</source>
        <translation>perspektivna</translation>
    </message>
    <message>
        <source>planar projections</source>
        <translation>projekcije na ravninu</translation>
    </message>
    <message>
        <source>projectors are at right angles to the image plane</source>
        <translation>zrake projiciranja okomite su na ravninu slike</translation>
    </message>
    <message>
        <source>projectors are oblique to the image plane</source>
        <translation>zrake projiciranja kose su prema ravnini slike</translation>
    </message>
    <message>
        <source>projectors are straight lines, and meet a plane</source>
        <translation>zrake projiciranja su pravci i sijeku ravninu</translation>
    </message>
    <message>
        <source>side</source>
        <translation>sa strane</translation>
    </message>
    <message>
        <source>the axes make three different angles with the image plane</source>
        <translation>osi zatvaraju tri različita kuta s ravninom slike</translation>
    </message>
    <message>
        <source>top</source>
        <translation>odozgo</translation>
    </message>
    <message>
        <source>trimetric</source>
        <translation>trimetrijska</translation>
    </message>
    <message>
        <source>two axes are parallel to the image plane</source>
        <translation>dvije osi su paralelne s ravninom slike</translation>
    </message>
    <message>
        <source>two axes are parallel to the image plane, the third is drawn at full length</source>
        <translation>dvije osi su paralelne s ravninom slike, treća se crta u punoj duljini</translation>
    </message>
    <message>
        <source>two axes are parallel to the image plane, the third is drawn at half its length</source>
        <translation>dvije osi su paralelne s ravninom slike, treća se crta u pola duljine</translation>
    </message>
    <message>
        <source>two axes are parallel to the image plane: one vanishing point</source>
        <translation>dvije osi su paralelne s ravninom slike: jedan nedogled</translation>
    </message>
    <message>
        <source>two axes make equal angles with the image plane</source>
        <translation>dvije osi zatvaraju jednake kutove s ravninom slike</translation>
    </message>
    <message>
        <source>x and y are parallel to the image plane, seen along −z</source>
        <translation>x i y su paralelne s ravninom slike, gledano duž −z</translation>
    </message>
    <message>
        <source>x and z are parallel to the image plane, seen along −y</source>
        <translation>x i z su paralelne s ravninom slike, gledano duž −y</translation>
    </message>
    <message>
        <source>y and z are parallel to the image plane, seen along −x</source>
        <translation>y i z su paralelne s ravninom slike, gledano duž −x</translation>
    </message>
</context>
<context>
    <name>KindsPanel</name>
    <message>
        <source>Kinds of projection</source>
        <translation>Vrste projekcija</translation>
    </message>
    <message>
        <source>A free matrix belongs to no kind. Choose a kind, and its lens replaces the matrix.</source>
        <translation>Slobodna matrica ne pripada nijednoj vrsti. Odaberite vrstu, i njezin će objektiv zamijeniti matricu.</translation>
    </message>
    <message>
        <source>{0}: {1}.</source>
        <translation>{0}: {1}.</translation>
    </message>
    <message>
        <source>{0} Not possible here: {1}</source>
        <translation>{0} Ovdje nije moguće: {1}</translation>
    </message>
    <message>
        <source>No scale factors: things farther away are drawn smaller.</source>
        <translation>Nema faktora mjerila: ono što je dalje crta se manjim.</translation>
    </message>
    <message>
        <source>A unit would be drawn {0} long along x, {1} along y, {2} along z.</source>
        <translation>Jedinica bi se nacrtala duljinom {0} duž x, {1} duž y, {2} duž z.</translation>
    </message>
    <message>
        <source>A unit is drawn {0} long along x, {1} along y, {2} along z.</source>
        <translation>Jedinica se crta duljinom {0} duž x, {1} duž y, {2} duž z.</translation>
    </message>
    <message>
        <source>{0} This scene: {1}.</source>
        <translation>{0} Ova scena: {1}.</translation>
    </message>
</context>
<context>
    <name>Lens</name>
    <message>
        <source>None of these: the cells of clip ← view that you typed in the Matrices panel. If you choose another kind, the previous lens comes back.</source>
        <translation>Nijedan od ovih: ćelije matrice odsijecanje ← kamera koje ste upisali u ploči Matrice. Ako odaberete drugu vrstu, vraća se prethodni objektiv.</translation>
    </message>
    <message>
        <source>Rays are parallel and meet the picture at a slant: a slanted box, as in cavalier and cabinet drawings (lecture 002: H, then orthographic).</source>
        <translation>Zrake su paralelne i padaju na sliku koso: kosi kvadar, kao na kavalirskim i kabinetskim crtežima (predavanje 002: H, zatim ortogonalna projekcija).</translation>
    </message>
    <message>
        <source>Rays are parallel and meet the picture at right angles: distance does not change size. The view volume is a box (glOrtho).</source>
        <translation>Zrake su paralelne i padaju na sliku okomito: udaljenost ne mijenja veličinu. Volumen pogleda je kvadar (glOrtho).</translation>
    </message>
    <message>
        <source>Rays meet in the eye, but the window may be anywhere on the near plane: a shifted pyramid (glFrustum).</source>
        <translation>Zrake se sijeku u kameri, ali prozor može biti bilo gdje na bliskoj ravnini: pomaknuta piramida (glFrustum).</translation>
    </message>
    <message>
        <source>Rays meet in the eye: farther objects look smaller. The view volume is a pyramid cut off by near and far, symmetric about the view direction (gluPerspective).</source>
        <translation>Zrake se sijeku u kameri: udaljeniji objekti izgledaju manji. Volumen pogleda je piramida odrezana bliskom i dalekom ravninom, simetrična oko smjera gledanja (gluPerspective).</translation>
    </message>
    <message>
        <source>free matrix</source>
        <translation>slobodna matrica</translation>
    </message>
    <message>
        <source>frustum (off-axis)</source>
        <translation>asimetrična krnja piramida</translation>
    </message>
    <message>
        <source>oblique</source>
        <translation>kosi</translation>
    </message>
    <message>
        <source>orthographic</source>
        <translation>ortogonalni</translation>
    </message>
    <message>
        <source>perspective</source>
        <translation>perspektivni</translation>
    </message>
</context>
<context>
    <name>LessonCard</name>
    <message>
        <source>Lesson</source>
        <translation>Lekcija</translation>
    </message>
    <message>
        <source>Begin again: forget the answers of this lesson</source>
        <translation>Počinje iznova: zaboravlja odgovore ove lekcije</translation>
    </message>
    <message>
        <source>Close the lesson</source>
        <translation>Zatvara lekciju</translation>
    </message>
    <message>
        <source>Previous step ({0})</source>
        <translation>Prethodni korak ({0})</translation>
    </message>
    <message>
        <source>Show the step as the lesson&apos;s file has it, without your changes ({0})</source>
        <translation>Prikazuje korak kakav je u datoteci lekcije, bez vaših promjena ({0})</translation>
    </message>
    <message>
        <source>Show the next hint (Alt+I)</source>
        <translation>Prikazuje sljedeći savjet (Alt+A)</translation>
    </message>
    <message>
        <source>Next step ({0})</source>
        <translation>Sljedeći korak ({0})</translation>
    </message>
    <message>
        <source>&amp;Back</source>
        <translation>&amp;Natrag</translation>
    </message>
    <message>
        <source>Show again</source>
        <translation>Ponovno pokaži</translation>
    </message>
    <message>
        <source>Show the step again</source>
        <translation>Ponovno prikazuje korak</translation>
    </message>
    <message>
        <source>H&amp;int</source>
        <translation>S&amp;avjet</translation>
    </message>
    <message>
        <source>&amp;Next</source>
        <translation>Da&amp;lje</translation>
    </message>
    <message>
        <source>Do&amp;ne</source>
        <translation>Goto&amp;vo</translation>
    </message>
    <message>
        <source>Make your prediction first: choose one, then Commit.</source>
        <translation>Najprije predvidite: odaberite, zatim potvrdite.</translation>
    </message>
    <message>
        <source>Nothing is wrong in this lesson&apos;s file.</source>
        <translation>U datoteci ove lekcije nema pogrešaka.</translation>
    </message>
    <message>
        <source>Done: “{0}”.</source>
        <translation>Gotovo: „{0}”.</translation>
    </message>
    <message>
        <source>Something is left to do in step {0}.</source>
        <translation>U koraku {0} ostalo je nešto neriješeno.</translation>
    </message>
    <message>
        <source>Something is left to do in steps {0}.</source>
        <translation>U ovim koracima ostalo je nešto neriješeno: {0}.</translation>
    </message>
    <message>
        <source>Next lesson: {0}</source>
        <translation>Sljedeća lekcija: {0}</translation>
    </message>
    <message>
        <source>Open it</source>
        <translation>Otvori je</translation>
    </message>
    <message>
        <source>&amp;Close</source>
        <translation>&amp;Zatvori</translation>
    </message>
    <message>
        <source>Back to step {0}</source>
        <translation>Natrag na korak {0}</translation>
    </message>
    <message>
        <source>Go on there</source>
        <translation>Nastavi ondje</translation>
    </message>
    <message>
        <source>Not answered yet: {0}.</source>
        <translation>Još bez odgovora: {0}.</translation>
    </message>
    <message>
        <source>Back to exercise {0}</source>
        <translation>Natrag na vježbu {0}</translation>
    </message>
    <message>
        <source>&amp;Mark the test now</source>
        <translation>Oci&amp;jeni test sada</translation>
    </message>
    <message>
        <source>End the test</source>
        <translation>Završi test</translation>
    </message>
    <message>
        <source>Save the &amp;result…</source>
        <translation>Spremi &amp;rezultat…</translation>
    </message>
    <message>
        <source>Write a file for your teacher</source>
        <translation>Zapisuje datoteku za vašeg nastavnika</translation>
    </message>
    <message>
        <source>Close the test</source>
        <translation>Zatvori test</translation>
    </message>
</context>
<context>
    <name>LessonMenu</name>
    <message>
        <source>done</source>
        <translation>gotovo</translation>
    </message>
    <message>
        <source>Open a lesson or a talk</source>
        <translation>Otvori lekciju ili izlaganje</translation>
    </message>
    <message>
        <source>Lessons and talks (*.md);;All files (*)</source>
        <translation>Lekcije i izlaganja (*.md);;Sve datoteke (*)</translation>
    </message>
</context>
<context>
    <name>Lessons</name>
    <message>
        <source>Checking {0}</source>
        <translation>Provjerava se {0}</translation>
    </message>
    <message>
        <source>… and {0} more</source>
        <translation>… i još {0}</translation>
    </message>
</context>
<context>
    <name>Look</name>
    <message>
        <source>up</source>
        <translation>gore</translation>
    </message>
    <message>
        <source>eye</source>
        <translation>kamera</translation>
    </message>
    <message>
        <source>target</source>
        <translation>cilj</translation>
    </message>
    <message>
        <source>A parallel lens has no angle: it is equally wide at every distance.</source>
        <translation>Paralelni objektiv nema kut: jednako je širok na svakoj udaljenosti.</translation>
    </message>
    <message>
        <source>A parallel lens has no eye: this is the view along its axis.</source>
        <translation>Paralelni objektiv nema centar projekcije: ovo je pogled duž njegove osi.</translation>
    </message>
    <message>
        <source>A free matrix has no near, no far and no angle.</source>
        <translation>Slobodna matrica nema ni blisku ni daleku ravninu ni kut.</translation>
    </message>
    <message>
        <source>This window is off-axis: the axis does not halve its angle.</source>
        <translation>Ovaj je prozor asimetričan: os mu ne raspolavlja kut.</translation>
    </message>
    <message>
        <source>half height</source>
        <translation>pola visine</translation>
    </message>
    <message>
        <source>half width</source>
        <translation>pola širine</translation>
    </message>
    <message>
        <source>look</source>
        <translation>smjer gledanja</translation>
    </message>
</context>
<context>
    <name>MainWindow</name>
    <message>
        <source>World</source>
        <translation>Svijet</translation>
    </message>
    <message>
        <source>NDC cube</source>
        <translation>Kocka NDC</translation>
    </message>
    <message>
        <source>Image</source>
        <translation>Slika</translation>
    </message>
    <message>
        <source>The default settings are used.</source>
        <translation>Koriste se zadane postavke.</translation>
    </message>
    <message>
        <source>Matrices</source>
        <translation>Matrice</translation>
    </message>
    <message>
        <source>Every stage&apos;s matrix: numbers, formulas, factors and products</source>
        <translation>Matrica svake etape: brojevi, formule, faktori i umnošci</translation>
    </message>
    <message>
        <source>Camera frame</source>
        <translation>Koordinatni sustav kamere</translation>
    </message>
    <message>
        <source>The camera&apos;s axes, step by step: eye, target and up make the view matrix</source>
        <translation>Osi kamere, korak po korak: položaj kamere, cilj i smjer prema gore daju matricu pogleda</translation>
    </message>
    <message>
        <source>Kinds of projection</source>
        <translation>Vrste projekcija</translation>
    </message>
    <message>
        <source>The tree of planar projections: it marks the kind of the picture; click a kind to change to it</source>
        <translation>Stablo projekcija na ravninu: označava vrstu slike; klik na vrstu prelazi na nju</translation>
    </message>
    <message>
        <source>Probe</source>
        <translation>Sonda</translation>
    </message>
    <message>
        <source>Follow points through every stage</source>
        <translation>Prati točke kroz sve etape</translation>
    </message>
    <message>
        <source>Explanation and diagrams</source>
        <translation>Objašnjenje i dijagrami</translation>
    </message>
    <message>
        <source>What the scene shows, the lectures that use it, and its diagrams</source>
        <translation>Što scena pokazuje, predavanja koja je koriste i njezini dijagrami</translation>
    </message>
    <message>
        <source>Precision</source>
        <translation>Preciznost</translation>
    </message>
    <message>
        <source>How exact the picture and its numbers are, and what speed costs on this computer</source>
        <translation>Koliko su slika i njezini brojevi točni i koliko brzina stoji na ovom računalu</translation>
    </message>
    <message>
        <source>The answers in “{0}” were deleted.</source>
        <translation>Odgovori u lekciji „{0}” su izbrisani.</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Poništi</translation>
    </message>
    <message>
        <source>{0} Settings and progress are kept until the program ends, and saving them is tried again with the next change.</source>
        <translation>{0} Postavke i napredak čuvaju se do kraja rada programa, a spremanje se ponovno pokušava pri sljedećoj promjeni.</translation>
    </message>
    <message>
        <source>{0} cannot be drawn, so the previous scene stays: {1}</source>
        <translation>{0} se ne može nacrtati, pa ostaje prethodna scena: {1}</translation>
    </message>
    <message>
        <source>One file is opened at a time: {0}</source>
        <translation>Otvara se po jedna datoteka: {0}</translation>
    </message>
</context>
<context>
    <name>Manipulation</name>
    <message>
        <source>Drag along its way</source>
        <translation>Povucite po njezinu putu</translation>
    </message>
    <message>
        <source>Drag this point (Shift: up and down)</source>
        <translation>Povucite ovu točku (Shift: gore i dolje)</translation>
    </message>
</context>
<context>
    <name>MarkedAnswerView</name>
    <message>
        <source>So far so good, but three significant digits are needed.</source>
        <translation>Zasad dobro, ali potrebne su tri značajne znamenke.</translation>
    </message>
    <message>
        <source>Too few digits</source>
        <translation>Premalo znamenaka</translation>
    </message>
    <message>
        <source>That is not it.</source>
        <translation>To nije to.</translation>
    </message>
    <message>
        <source>The hint (Alt+I) says how to begin.</source>
        <translation>Savjet (Alt+A) kaže kako početi.</translation>
    </message>
    <message>
        <source>Wrong</source>
        <translation>Netočno</translation>
    </message>
    <message>
        <source>The answer is {0}.</source>
        <translation>Odgovor je {0}.</translation>
    </message>
    <message>
        <source>The answer is:</source>
        <translation>Odgovor je:</translation>
    </message>
</context>
<context>
    <name>Matrix</name>
    <message>
        <source>eye ({0}), looks along ({1})</source>
        <translation>položaj kamere ({0}), gleda duž ({1})</translation>
    </message>
    <message>
        <source>its lens is used, looking along −z; change the sign of its view matrix in row {0}</source>
        <translation>koristi se njezin objektiv, s pogledom duž −z; promijenite predznak u retku {0} njezine matrice pogleda</translation>
    </message>
    <message>
        <source>its lens is used, with y up</source>
        <translation>koristi se njezin objektiv, s osi y prema gore</translation>
    </message>
    <message>
        <source>affine: w is {0} everywhere</source>
        <translation>afina: w je svuda {0}</translation>
    </message>
    <message>
        <source>not affine: w depends on {0}</source>
        <translation>nije afina: w ovisi o {0}</translation>
    </message>
    <message>
        <source>singular (rank {0}): the frustum cannot be drawn</source>
        <translation>singularna (rang {0}): krnja piramida ne može se nacrtati</translation>
    </message>
    <message>
        <source>mirrored: it turns right-handed space into left-handed (determinant {0})</source>
        <translation>zrcali: pretvara desni koordinatni sustav u lijevi (determinanta {0})</translation>
    </message>
    <message>
        <source>mirrored: as if left and right, top and bottom, or near and far were exchanged</source>
        <translation>zrcali: kao da su zamijenjeni lijevo i desno, gore i dolje ili blisko i daleko</translation>
    </message>
    <message>
        <source>not rigid: it changes lengths or angles, so that no camera has it</source>
        <translation>nije kruta: mijenja duljine ili kutove, pa je nema nijedna kamera</translation>
    </message>
    <message>
        <source>w vanishes where {0} = 0: the divide sends these points to infinity</source>
        <translation>w nestaje gdje je {0} = 0: dijeljenje šalje te točke u beskonačnost</translation>
    </message>
    <message>
        <source>w is {0} everywhere: there is no picture</source>
        <translation>w je svuda {0}: slike nema</translation>
    </message>
    <message>
        <source>w is negative all over the view volume: there is no picture</source>
        <translation>w je negativan u cijelom volumenu pogleda: slike nema</translation>
    </message>
    <message>
        <source>the view volume reaches infinity: the frustum cannot be drawn</source>
        <translation>volumen pogleda seže u beskonačnost: krnja piramida ne može se nacrtati</translation>
    </message>
    <message>
        <source>rows are orthonormal to {0}: rounded to float32</source>
        <translation>retci su ortonormirani do na {0}: zaokruženo na float32</translation>
    </message>
    <message>
        <source>rows are orthonormal to {0}: rounded to {1} digits</source>
        <translation>retci su ortonormirani do na {0}: zaokruženo na {1} znamenaka</translation>
    </message>
    <message>
        <source>the nearest camera is used; it moves the picture by at most {0} px</source>
        <translation>koristi se najbliža kamera; ona pomiče sliku za najviše {0} px</translation>
    </message>
    <message>
        <source>the nearest camera would move the picture by at most {0} px</source>
        <translation>najbliža kamera pomaknula bi sliku za najviše {0} px</translation>
    </message>
    <message>
        <source>rows and columns are exchanged: its transpose is meant</source>
        <translation>retci i stupci su zamijenjeni: misli se na transponiranu matricu</translation>
    </message>
    <message>
        <source>looks along −z, y up; z from {0} at near to {1} at far; {2}, near {3}, far {4}</source>
        <translation>gleda duž −z, y prema gore; z od {0} na bliskoj do {1} na dalekoj ravnini; {2}, bliska {3}, daleka {4}</translation>
    </message>
    <message>
        <source>left-handed: looks along +z, y up; z from {0} at near to {1} at far; {2}, near {3}, far {4}</source>
        <translation>lijevi sustav: gleda duž +z, y prema gore; z od {0} na bliskoj do {1} na dalekoj ravnini; {2}, bliska {3}, daleka {4}</translation>
    </message>
    <message>
        <source>looks along −z, the picture&apos;s y down; z from {0} at near to {1} at far; {2}, near {3}, far {4}</source>
        <translation>gleda duž −z, y slike prema dolje; z od {0} na bliskoj do {1} na dalekoj ravnini; {2}, bliska {3}, daleka {4}</translation>
    </message>
    <message>
        <source>looks along +z, y down; z from {0} at near to {1} at far; {2}, near {3}, far {4}</source>
        <translation>gleda duž +z, y prema dolje; z od {0} na bliskoj do {1} na dalekoj ravnini; {2}, bliska {3}, daleka {4}</translation>
    </message>
</context>
<context>
    <name>MatrixAnswerView</name>
    <message>
        <source>A number: 0.5, 1 1/2, √3/2 or 2e-3; arrow keys change the cell (Enter)</source>
        <translation>Broj: 0.5; 1 1/2; √3/2 ili 2e-3; strelice mijenjaju ćeliju (Enter)</translation>
    </message>
</context>
<context>
    <name>MatrixBox</name>
    <message>
        <source>Show the factors of this matrix</source>
        <translation>Prikazuje faktore ove matrice</translation>
    </message>
    <message>
        <source>Factors of {0}</source>
        <translation>Faktori matrice {0}</translation>
    </message>
    <message>
        <source>the stage strip is here</source>
        <translation>ovdje je traka etapa</translation>
    </message>
</context>
<context>
    <name>MatrixPanel</name>
    <message>
        <source>then x, y and z are divided by w</source>
        <translation>zatim se x, y i z dijele s w</translation>
    </message>
    <message>
        <source>with lecture 002&apos;s sign: w = z</source>
        <translation>s predznakom predavanja 002: w = z</translation>
    </message>
    <message>
        <source>with lecture 002&apos;s sign: z runs from 1 at near to −1</source>
        <translation>s predznakom predavanja 002: z ide od 1 na bliskoj ravnini do −1</translation>
    </message>
    <message>
        <source>with lecture 002&apos;s signs: w = z, and z runs from 1 at near to −1</source>
        <translation>s predznacima predavanja 002: w = z, a z ide od 1 na bliskoj ravnini do −1</translation>
    </message>
    <message>
        <source>Matrices</source>
        <translation>Matrice</translation>
    </message>
    <message>
        <source>Cells</source>
        <translation>Ćelije</translation>
    </message>
    <message>
        <source>What each cell shows</source>
        <translation>Što pokazuje svaka ćelija</translation>
    </message>
    <message>
        <source>Numbers</source>
        <translation>Brojevi</translation>
    </message>
    <message>
        <source>Formulas</source>
        <translation>Formule</translation>
    </message>
    <message>
        <source>Vectors</source>
        <translation>Vektori</translation>
    </message>
    <message>
        <source>Points as columns, right of the matrix, or as rows, left of it; rows transpose every matrix and reverse every product</source>
        <translation>Točke kao stupci, desno od matrice, ili kao retci, lijevo od nje; retci transponiraju svaku matricu i okreću svaki umnožak</translation>
    </message>
    <message>
        <source>Column vectors</source>
        <translation>Vektori stupci</translation>
    </message>
    <message>
        <source>Row vectors</source>
        <translation>Vektori retci</translation>
    </message>
    <message>
        <source>Letters</source>
        <translation>Slova</translation>
    </message>
    <message>
        <source>The lecture whose letters the formulas use; vectors are bold; lecture 002 has its own signs too</source>
        <translation>Predavanje čija slova koriste formule; vektori su podebljani; predavanje 002 ima i vlastite predznake</translation>
    </message>
    <message>
        <source>own: u v n, n f, fov</source>
        <translation>vlastita: u v n, n f, fov</translation>
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
        <translation>z bliske, daleke: negativan</translation>
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
        <translation>Slova predavanja {0}</translation>
    </message>
    <message>
        <source>Take letters of your own from a file, letters.toml</source>
        <translation>Uzima vaša slova iz datoteke letters.toml</translation>
    </message>
    <message>
        <source>Letters of a file</source>
        <translation>Slova iz datoteke</translation>
    </message>
    <message>
        <source>Running products</source>
        <translation>Djelomični umnošci</translation>
    </message>
    <message>
        <source>Also the product of all stages so far, and the view matrix&apos;s inverse, whose columns are the camera&apos;s axes and the eye</source>
        <translation>I umnožak svih dosadašnjih etapa te inverz matrice pogleda, čiji su stupci osi kamere i njezin položaj</translation>
    </message>
    <message>
        <source>Copy all</source>
        <translation>Kopiraj sve</translation>
    </message>
    <message>
        <source>Copy every matrix shown, in the order of the stages</source>
        <translation>Kopira svaku prikazanu matricu, redom etapa</translation>
    </message>
    <message>
        <source>Copy all matrices</source>
        <translation>Kopiraj sve matrice</translation>
    </message>
    <message>
        <source>About the cell</source>
        <translation>O ćeliji</translation>
    </message>
    <message>
        <source>of a file</source>
        <translation>iz datoteke</translation>
    </message>
    <message>
        <source>Letters (*.toml);;All files (*)</source>
        <translation>Slova (*.toml);;Sve datoteke (*)</translation>
    </message>
    <message>
        <source>{0}, row {1}, column {2}</source>
        <translation>{0}, redak {1}, stupac {2}</translation>
    </message>
    <message>
        <source>{0} is taken as {1}, its quotient to all digits of float64.</source>
        <translation>{0} se uzima kao {1}, kvocijent na sve znamenke tipa float64.</translation>
    </message>
    <message>
        <source>This matrix may mean:</source>
        <translation>Ova matrica može značiti:</translation>
    </message>
    <message>
        <source>{0}, a free matrix</source>
        <translation>{0}, slobodna matrica</translation>
    </message>
</context>
<context>
    <name>MatrixRow</name>
    <message>
        <source>Matrices</source>
        <translation>Matrice</translation>
    </message>
    <message>
        <source>More matrices: show the next one that is cut off or hidden</source>
        <translation>Još matrica: prikazuje sljedeću koja je odrezana ili skrivena</translation>
    </message>
    <message>
        <source>Matrices to the left</source>
        <translation>Matrice lijevo</translation>
    </message>
    <message>
        <source>Matrices to the right</source>
        <translation>Matrice desno</translation>
    </message>
</context>
<context>
    <name>MatrixView</name>
    <message>
        <source>{0}, row {1}, column {2}</source>
        <translation>{0}, redak {1}, stupac {2}</translation>
    </message>
    <message>
        <source>A number, or a fraction such as 1/3, which is divided to all digits</source>
        <translation>Broj ili razlomak, npr. 1/3, koji se dijeli na sve znamenke</translation>
    </message>
    <message>
        <source>Paste</source>
        <translation>Zalijepi</translation>
    </message>
    <message>
        <source>Copy as text</source>
        <translation>Kopiraj kao tekst</translation>
    </message>
    <message>
        <source>Copy for NumPy (numbers)</source>
        <translation>Kopiraj za NumPy (brojevi)</translation>
    </message>
    <message>
        <source>Copy for LaTeX (needs amsmath)</source>
        <translation>Kopiraj za LaTeX (treba amsmath)</translation>
    </message>
</context>
<context>
    <name>Measure</name>
    <message>
        <source>180 − vertical fov, degrees</source>
        <translation>180 − vertikalno vidno polje, stupnjeva</translation>
    </message>
    <message>
        <source>A logarithmic depth only at the vertices: the floor sinks behind the wall.</source>
        <translation>Logaritamska dubina samo u vrhovima: pod tone iza zida.</translation>
    </message>
    <message>
        <source>A turn made of many small turns: a full round does not come home.</source>
        <translation>Okret sastavljen od mnogo malih zakreta: puni krug ne vraća se na početak.</translation>
    </message>
    <message>
        <source>Antialiasing and resolution</source>
        <translation>Zaglađivanje i rezolucija</translation>
    </message>
    <message>
        <source>Arithmetic</source>
        <translation>Aritmetika</translation>
    </message>
    <message>
        <source>At the target, {0} with {2} separates surfaces at least {1} world units apart; the finest, {3} with {4}, surfaces at least {5} apart.</source>
        <translation>Kod cilja {0} uz {2} razlikuje plohe razmaknute bar {1} globalnih jedinica; najfinije, {3} uz {4}, plohe razmaknute bar {5}.</translation>
    </message>
    <message>
        <source>Back from the picture</source>
        <translation>Natrag sa slike</translation>
    </message>
    <message>
        <source>Cracks</source>
        <translation>Pukotine</translation>
    </message>
    <message>
        <source>Depth at the vertices</source>
        <translation>Dubina u vrhovima</translation>
    </message>
    <message>
        <source>Depth buffer</source>
        <translation>Spremnik dubine</translation>
    </message>
    <message>
        <source>Depth gap over the distance</source>
        <translation>Razmak dubina ovisno o udaljenosti</translation>
    </message>
    <message>
        <source>Detail</source>
        <translation>Detalji</translation>
    </message>
    <message>
        <source>Drift</source>
        <translation>Odlutavanje</translation>
    </message>
    <message>
        <source>Each mesh rounded in a box of its own: light comes through the seam.</source>
        <translation>Svaka mreža zaokružena nad vlastitim kvadrom: kroz šav prolazi svjetlo.</translation>
    </message>
    <message>
        <source>Equal in bytes to {0}: {1}.</source>
        <translation>Po bajtovima jednako kao {0}: {1}.</translation>
    </message>
    <message>
        <source>Equal in time to {0}: {1}.</source>
        <translation>Po vremenu jednako kao {0}: {1}.</translation>
    </message>
    <message>
        <source>Fewer bits of depth: what lies behind comes through in stripes.</source>
        <translation>Manje bitova dubine: što leži iza, probija u prugama.</translation>
    </message>
    <message>
        <source>Fewer digits for each vertex: the corners move.</source>
        <translation>Manje znamenaka za svaki vrh: vrhovi se pomiču.</translation>
    </message>
    <message>
        <source>Fewer samples in a pixel: edges become stairs.</source>
        <translation>Manje uzoraka u pikselu: bridovi postaju stepenice.</translation>
    </message>
    <message>
        <source>Fewer triangles: outlines become angular.</source>
        <translation>Manje trokuta: obrisi postaju uglati.</translation>
    </message>
    <message>
        <source>From a pixel back into the world by one matrix: the point misses.</source>
        <translation>Od piksela natrag u svijet jednom matricom: točka promašuje.</translation>
    </message>
    <message>
        <source>Interpolation</source>
        <translation>Interpolacija</translation>
    </message>
    <message>
        <source>Its price is in {0}: {1}, against {2} for {3}.</source>
        <translation>Cijena je ovdje – {0}: {1}, prema {2} za {3}.</translation>
    </message>
    <message>
        <source>Jitter</source>
        <translation>Podrhtavanje</translation>
    </message>
    <message>
        <source>No choice is cheaper ({1}) or more exact ({2}) than {0}.</source>
        <translation>Nijedan izbor nije jeftiniji ({1}) ni točniji ({2}) od: {0}.</translation>
    </message>
    <message>
        <source>No choice is cheaper than {0} ({1}, off by {2}), none more exact than {3} ({4}, off by {5}); none is off by less than {6}.</source>
        <translation>Nijedan izbor nije jeftiniji od: {0} ({1}, pogreška {2}), nijedan točniji od: {3} ({4}, pogreška {5}); nijedan ne griješi manje od {6}.</translation>
    </message>
    <message>
        <source>No choice is cheaper than {0} ({1}, off by {2}), none more exact than {3} ({4}, off by {5}); of those off by less than {6}, none is cheaper than {7}.</source>
        <translation>Nijedan izbor nije jeftiniji od: {0} ({1}, pogreška {2}), nijedan točniji od: {3} ({4}, pogreška {5}); među onima koji griješe manje od {6} nijedan nije jeftiniji od: {7}.</translation>
    </message>
    <message>
        <source>No division at each pixel: the pattern bends along the diagonal.</source>
        <translation>Bez dijeljenja u svakom pikselu: uzorak se savija duž dijagonale.</translation>
    </message>
    <message>
        <source>Not certain: {0}.</source>
        <translation>Nije sigurno: {0}.</translation>
    </message>
    <message>
        <source>Nothing could be measured: {0}.</source>
        <translation>Ništa se nije moglo izmjeriti: {0}.</translation>
    </message>
    <message>
        <source>Sweep of far</source>
        <translation>Niz: daleka ravnina</translation>
    </message>
    <message>
        <source>Sweep of near</source>
        <translation>Niz: bliska ravnina</translation>
    </message>
    <message>
        <source>Sweep of the aspect</source>
        <translation>Niz: omjer stranica</translation>
    </message>
    <message>
        <source>Sweep of the distance from the origin</source>
        <translation>Niz: udaljenost od ishodišta</translation>
    </message>
    <message>
        <source>Sweep of the field of view</source>
        <translation>Niz: vidno polje</translation>
    </message>
    <message>
        <source>Sweep of up</source>
        <translation>Niz: smjer prema gore</translation>
    </message>
    <message>
        <source>VTK&apos;s transform</source>
        <translation>transformacija iz VTK-a</translation>
    </message>
    <message>
        <source>World coordinates in float32, far from the origin: the picture jumps.</source>
        <translation>Globalne koordinate u float32, daleko od ishodišta: slika skače.</translation>
    </message>
    <message>
        <source>a sphere: the scene has too few triangles</source>
        <translation>kugla: scena ima premalo trokuta</translation>
    </message>
    <message>
        <source>affine</source>
        <translation>afino</translation>
    </message>
    <message>
        <source>angle between up and view direction, degrees</source>
        <translation>kut između smjera prema gore i smjera gledanja, stupnjeva</translation>
    </message>
    <message>
        <source>aspect</source>
        <translation>omjer stranica</translation>
    </message>
    <message>
        <source>aspect of the window</source>
        <translation>omjer stranica prozora</translation>
    </message>
    <message>
        <source>at most {0} off</source>
        <translation>pogreška najviše {0}</translation>
    </message>
    <message>
        <source>bytes</source>
        <translation>bajtova</translation>
    </message>
    <message>
        <source>bytes a camera</source>
        <translation>bajtova po kameri</translation>
    </message>
    <message>
        <source>bytes a pixel</source>
        <translation>bajtova po pikselu</translation>
    </message>
    <message>
        <source>bytes a point</source>
        <translation>bajtova po točki</translation>
    </message>
    <message>
        <source>bytes a vertex</source>
        <translation>bajtova po vrhu</translation>
    </message>
    <message>
        <source>bytes an edge</source>
        <translation>bajtova po bridu</translation>
    </message>
    <message>
        <source>bytes of the mesh</source>
        <translation>bajtova mreže</translation>
    </message>
    <message>
        <source>cancelled</source>
        <translation>prekinuto</translation>
    </message>
    <message>
        <source>common grid</source>
        <translation>zajednička rešetka</translation>
    </message>
    <message>
        <source>depth error (of 1)</source>
        <translation>pogreška dubine (od 1)</translation>
    </message>
    <message>
        <source>direct3d</source>
        <translation>direct3d</translation>
    </message>
    <message>
        <source>distance</source>
        <translation>udaljenost</translation>
    </message>
    <message>
        <source>distance from the eye plane</source>
        <translation>udaljenost od ravnine kamere</translation>
    </message>
    <message>
        <source>distance from the origin</source>
        <translation>udaljenost od ishodišta</translation>
    </message>
    <message>
        <source>each pixel</source>
        <translation>svaki piksel</translation>
    </message>
    <message>
        <source>each vertex</source>
        <translation>svaki vrh</translation>
    </message>
    <message>
        <source>error after 360°, px</source>
        <translation>pogreška nakon 360°, px</translation>
    </message>
    <message>
        <source>error of a jump, px</source>
        <translation>pogreška skoka, px</translation>
    </message>
    <message>
        <source>error, levels of 255</source>
        <translation>pogreška, razina od 255</translation>
    </message>
    <message>
        <source>error, parts of the distance</source>
        <translation>pogreška, dijelova udaljenosti</translation>
    </message>
    <message>
        <source>error, parts of the distance w</source>
        <translation>pogreška, dijelova udaljenosti w</translation>
    </message>
    <message>
        <source>error, px</source>
        <translation>pogreška, px</translation>
    </message>
    <message>
        <source>error, texels</source>
        <translation>pogreška, teksela</translation>
    </message>
    <message>
        <source>every stage</source>
        <translation>svaka etapa</translation>
    </message>
    <message>
        <source>exact</source>
        <translation>egzaktno</translation>
    </message>
    <message>
        <source>eye 1 000 from the origin</source>
        <translation>kamera 1 000 od ishodišta</translation>
    </message>
    <message>
        <source>eye 1 from the origin</source>
        <translation>kamera 1 od ishodišta</translation>
    </message>
    <message>
        <source>eye first</source>
        <translation>najprije kamera</translation>
    </message>
    <message>
        <source>far</source>
        <translation>daleka ravnina</translation>
    </message>
    <message>
        <source>far is at least 4 near</source>
        <translation>daleka ravnina je bar 4 bliske</translation>
    </message>
    <message>
        <source>fast inverse root</source>
        <translation>brzi inverzni korijen</translation>
    </message>
    <message>
        <source>first frame (ms)</source>
        <translation>prvi kadar (ms)</translation>
    </message>
    <message>
        <source>fov</source>
        <translation>vidno polje</translation>
    </message>
    <message>
        <source>gap, px</source>
        <translation>procjep, px</translation>
    </message>
    <message>
        <source>gap, world units</source>
        <translation>razmak, globalnih jedinica</translation>
    </message>
    <message>
        <source>half resolution</source>
        <translation>pola rezolucije</translation>
    </message>
    <message>
        <source>imitated in software: its time says nothing</source>
        <translation>oponašano u softveru: vrijeme mu ništa ne govori</translation>
    </message>
    <message>
        <source>inverse of P V</source>
        <translation>inverz od P V</translation>
    </message>
    <message>
        <source>inverses of P and of V</source>
        <translation>inverzi od P i od V</translation>
    </message>
    <message>
        <source>largest error, px</source>
        <translation>najveća pogreška, px</translation>
    </message>
    <message>
        <source>levels RMS</source>
        <translation>razina RMS</translation>
    </message>
    <message>
        <source>logarithmic</source>
        <translation>logaritamski</translation>
    </message>
    <message>
        <source>matplotlib&apos;s proj3d</source>
        <translation>proj3d iz matplotliba</translation>
    </message>
    <message>
        <source>ms a frame</source>
        <translation>ms po kadru</translation>
    </message>
    <message>
        <source>near</source>
        <translation>bliska ravnina</translation>
    </message>
    <message>
        <source>near is at most far / 4</source>
        <translation>bliska ravnina je najviše daleka / 4</translation>
    </message>
    <message>
        <source>no edge of the scene&apos;s box is in the picture</source>
        <translation>nijedan brid kvadra scene nije na slici</translation>
    </message>
    <message>
        <source>no outline of the scene is in the picture</source>
        <translation>nijedan obris scene nije na slici</translation>
    </message>
    <message>
        <source>no vertex is in front of the eye, so there is nothing to measure</source>
        <translation>nijedan vrh nije ispred kamere, pa nema ničega za mjerenje</translation>
    </message>
    <message>
        <source>none</source>
        <translation>nema</translation>
    </message>
    <message>
        <source>not installed</source>
        <translation>nije instalirano</translation>
    </message>
    <message>
        <source>ns a frame</source>
        <translation>ns po kadru</translation>
    </message>
    <message>
        <source>ns a pixel</source>
        <translation>ns po pikselu</translation>
    </message>
    <message>
        <source>ns a point</source>
        <translation>ns po točki</translation>
    </message>
    <message>
        <source>numpy&apos;s hstack</source>
        <translation>hstack iz numpyja</translation>
    </message>
    <message>
        <source>object first</source>
        <translation>najprije objekt</translation>
    </message>
    <message>
        <source>of the distance</source>
        <translation>udaljenosti</translation>
    </message>
    <message>
        <source>opengl</source>
        <translation>opengl</translation>
    </message>
    <message>
        <source>overflows</source>
        <translation>prelazi najveći broj</translation>
    </message>
    <message>
        <source>own boxes</source>
        <translation>vlastiti kvadri</translation>
    </message>
    <message>
        <source>p95</source>
        <translation>p95</translation>
    </message>
    <message>
        <source>pairs collapsed (of 1)</source>
        <translation>parova koji se stapaju (od 1)</translation>
    </message>
    <message>
        <source>perspective-correct</source>
        <translation>perspektivno ispravno</translation>
    </message>
    <message>
        <source>predicted</source>
        <translation>predviđeno</translation>
    </message>
    <message>
        <source>predicted depth error (of 1)</source>
        <translation>predviđena pogreška dubine (od 1)</translation>
    </message>
    <message>
        <source>predicted to collapse (of 1)</source>
        <translation>predviđeno da se stapa (od 1)</translation>
    </message>
    <message>
        <source>products</source>
        <translation>umnošci</translation>
    </message>
    <message>
        <source>ray times depth</source>
        <translation>zraka puta dubina</translation>
    </message>
    <message>
        <source>reciprocal table</source>
        <translation>tablica recipročnih vrijednosti</translation>
    </message>
    <message>
        <source>reducing (ms)</source>
        <translation>pojednostavnjivanje (ms)</translation>
    </message>
    <message>
        <source>renormalised</source>
        <translation>renormirano</translation>
    </message>
    <message>
        <source>returns NaN</source>
        <translation>vraća NaN</translation>
    </message>
    <message>
        <source>reversed</source>
        <translation>obrnuti</translation>
    </message>
    <message>
        <source>separates surfaces {0} apart</source>
        <translation>razlikuje plohe razmaknute {0}</translation>
    </message>
    <message>
        <source>silhouette, px</source>
        <translation>silueta, px</translation>
    </message>
    <message>
        <source>snapped to 1/16 px</source>
        <translation>hvatanje na 1/16 px</translation>
    </message>
    <message>
        <source>snapped to 1/4 px</source>
        <translation>hvatanje na 1/4 px</translation>
    </message>
    <message>
        <source>snapped to whole px</source>
        <translation>hvatanje na cijele px</translation>
    </message>
    <message>
        <source>supersampling {0} x {0}</source>
        <translation>supersampling {0} x {0}</translation>
    </message>
    <message>
        <source>tells nothing behind it apart</source>
        <translation>iza nje ne razlikuje ništa</translation>
    </message>
    <message>
        <source>texels</source>
        <translation>teksela</translation>
    </message>
    <message>
        <source>the largest of up to {0} points against 200 digits of mpmath</source>
        <translation>najveća od najviše {0} točaka, prema 200 znamenaka iz mpmatha</translation>
    </message>
    <message>
        <source>the same picture</source>
        <translation>ista slika</translation>
    </message>
    <message>
        <source>the smallest gap at the target (at 2 near or far / 2 if it lies outside)</source>
        <translation>najmanji razmak kod cilja (kod 2 bliske ili daleke / 2 ako leži izvan)</translation>
    </message>
    <message>
        <source>the smallest gap behind a surface at this distance</source>
        <translation>najmanji razmak iza plohe na ovoj udaljenosti</translation>
    </message>
    <message>
        <source>the target lies outside of near and far</source>
        <translation>cilj leži izvan bliske i daleke ravnine</translation>
    </message>
    <message>
        <source>the whole edge is equally far away, so there is no error</source>
        <translation>cijeli je brid jednako daleko, pa pogreške nema</translation>
    </message>
    <message>
        <source>this OpenGL gives {0} samples</source>
        <translation>ovaj OpenGL daje uzoraka: {0}</translation>
    </message>
    <message>
        <source>this also switches off the early depth test, whose loss is not in this time</source>
        <translation>to isključuje i rani test dubine, a njegov gubitak nije u ovom vremenu</translation>
    </message>
    <message>
        <source>this machine is busy: compare again</source>
        <translation>ovo je računalo zauzeto: usporedite ponovno</translation>
    </message>
    <message>
        <source>time ran out before the least time was steady</source>
        <translation>vrijeme je isteklo prije nego što se najkraće vrijeme ustalilo</translation>
    </message>
    <message>
        <source>triangles</source>
        <translation>trokuta</translation>
    </message>
    <message>
        <source>two floats</source>
        <translation>dva broja float</translation>
    </message>
    <message>
        <source>two sines</source>
        <translation>dva sinusa</translation>
    </message>
    <message>
        <source>up</source>
        <translation>smjer prema gore</translation>
    </message>
    <message>
        <source>up to {0} off</source>
        <translation>pogreška do {0}</translation>
    </message>
    <message>
        <source>vertical fov, degrees</source>
        <translation>vertikalno vidno polje, stupnjeva</translation>
    </message>
    <message>
        <source>vertices moved by up to (px)</source>
        <translation>pomak vrhova do (px)</translation>
    </message>
    <message>
        <source>world coordinates</source>
        <translation>globalne koordinate</translation>
    </message>
    <message>
        <source>world units</source>
        <translation>globalnih jedinica</translation>
    </message>
    <message>
        <source>{0} (cancelled)</source>
        <translation>{0} (prekinuto)</translation>
    </message>
    <message>
        <source>{0} (now)</source>
        <translation>{0} (sada)</translation>
    </message>
    <message>
        <source>{0} Newton step</source>
        <translation>Newtonovih koraka: {0}</translation>
    </message>
    <message>
        <source>{0} Newton steps</source>
        <translation>Newtonovih koraka: {0}</translation>
    </message>
    <message>
        <source>{0} bits</source>
        <translation>bitova: {0}</translation>
    </message>
    <message>
        <source>{0} instead of {1}: the same cost, {3}.</source>
        <translation>{0} umjesto {1}: isti trošak, {3}.</translation>
    </message>
    <message>
        <source>{0} instead of {1}: {2} times faster, {3}.</source>
        <translation>{0} umjesto {1}: {2} puta brže, {3}.</translation>
    </message>
    <message>
        <source>{0} instead of {1}: {2} times larger, {3}.</source>
        <translation>{0} umjesto {1}: {2} puta veće, {3}.</translation>
    </message>
    <message>
        <source>{0} instead of {1}: {2} times slower, {3}.</source>
        <translation>{0} umjesto {1}: {2} puta sporije, {3}.</translation>
    </message>
    <message>
        <source>{0} instead of {1}: {2} times smaller, {3}.</source>
        <translation>{0} umjesto {1}: {2} puta manje, {3}.</translation>
    </message>
    <message>
        <source>{0} is only measured: the panes are not drawn with it.</source>
        <translation>{0} se samo mjeri: okna se time ne crtaju.</translation>
    </message>
    <message>
        <source>{0} pieces</source>
        <translation>komada: {0}</translation>
    </message>
    <message>
        <source>{0}; eye {1}, target {2}, {3}</source>
        <translation>{0}; kamera {1}, cilj {2}, {3}</translation>
    </message>
</context>
<context>
    <name>MeasurePanel</name>
    <message>
        <source>Trades and sweeps</source>
        <translation>Kompromisi i nizovi</translation>
    </message>
    <message>
        <source>What to measure and to show; Ctrl or Shift to choose several to measure</source>
        <translation>Što mjeriti i prikazati; Ctrl ili Shift za odabir više njih za mjerenje</translation>
    </message>
    <message>
        <source>How exactly</source>
        <translation>Koliko točno</translation>
    </message>
    <message>
        <source>Quick: 2 s a trade, 13 values a sweep; full: 30 s a trade, 49 values</source>
        <translation>Brzo: 2 s po kompromisu, 13 vrijednosti po nizu; potpuno: 30 s po kompromisu, 49 vrijednosti</translation>
    </message>
    <message>
        <source>Quick</source>
        <translation>Brzo</translation>
    </message>
    <message>
        <source>Full</source>
        <translation>Potpuno</translation>
    </message>
    <message>
        <source>Measure here</source>
        <translation>Izmjeri ovdje</translation>
    </message>
    <message>
        <source>Measure on this machine what is chosen, for this scene and camera</source>
        <translation>Mjeri odabrano na ovom računalu, za ovu scenu i kameru</translation>
    </message>
    <message>
        <source>Stop, and keep the results so far</source>
        <translation>Zaustavlja i čuva dosadašnje rezultate</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Prekini</translation>
    </message>
    <message>
        <source>Progress of the measurement</source>
        <translation>Napredak mjerenja</translation>
    </message>
    <message>
        <source>Save what is shown: CSV, JSON, PNG or PDF</source>
        <translation>Sprema prikazano: CSV, JSON, PNG ili PDF</translation>
    </message>
    <message>
        <source>Export…</source>
        <translation>Izvezi…</translation>
    </message>
    <message>
        <source>Draw the results from a file, perhaps from another machine, over these</source>
        <translation>Crta preko ovih rezultate iz datoteke, možda s drugog računala</translation>
    </message>
    <message>
        <source>Compare…</source>
        <translation>Usporedi…</translation>
    </message>
    <message>
        <source>Remove the results of the file</source>
        <translation>Uklanja rezultate iz datoteke</translation>
    </message>
    <message>
        <source>Forget</source>
        <translation>Zaboravi</translation>
    </message>
    <message>
        <source>Cost</source>
        <translation>Trošak</translation>
    </message>
    <message>
        <source>What errors are drawn over: time, or bytes, the same on every machine</source>
        <translation>U ovisnosti o čemu se crtaju pogreške: o vremenu ili o bajtovima, koji su isti na svakom računalu</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Vrijeme</translation>
    </message>
    <message>
        <source>Memory</source>
        <translation>Memorija</translation>
    </message>
    <message>
        <source>Results</source>
        <translation>Rezultati</translation>
    </message>
    <message>
        <source>paused</source>
        <translation>pauzirano</translation>
    </message>
    <message>
        <source>Export what is shown</source>
        <translation>Izvezi prikazano</translation>
    </message>
    <message>
        <source>Tables (*.csv);;Results (*.json);;Pictures (*.png);;Vectors (*.pdf)</source>
        <translation>Tablice (*.csv);;Rezultati (*.json);;Slike (*.png);;Vektori (*.pdf)</translation>
    </message>
    <message>
        <source>Vectors (*.pdf)</source>
        <translation>Vektori (*.pdf)</translation>
    </message>
    <message>
        <source>There is nothing to export yet: run a measurement first.</source>
        <translation>Još nema ničega za izvoz: najprije pokrenite mjerenje.</translation>
    </message>
    <message>
        <source>{0}: its name must end in one of {1}.</source>
        <translation>{0}: ime mora završavati na jedno od: {1}.</translation>
    </message>
    <message>
        <source>Compare with results of a file</source>
        <translation>Usporedi s rezultatima iz datoteke</translation>
    </message>
    <message>
        <source>Results (*.json);;All files (*)</source>
        <translation>Rezultati (*.json);;Sve datoteke (*)</translation>
    </message>
    <message>
        <source>{0}: cannot be read: {1}.</source>
        <translation>{0}: ne može se pročitati: {1}.</translation>
    </message>
    <message>
        <source>Measured with the letter F on another machine: {0}.</source>
        <translation>Izmjereno na slovu F na drugom računalu: {0}.</translation>
    </message>
    <message>
        <source>There are no results yet: “Measure here” makes them.</source>
        <translation>Još nema rezultata: „Izmjeri ovdje” ih stvara.</translation>
    </message>
    <message>
        <source>Click a choice to use it in the panes; choices in italics cannot be used, and those in grey are worse than another one in both cost and error</source>
        <translation>Kliknite izbor da ga primijenite u oknima; izbori u kurzivu ne mogu se primijeniti, a sivi su i skuplji i netočniji od nekog drugog</translation>
    </message>
    <message>
        <source>The results at each value; of near, far, fov and gap, click one to use it</source>
        <translation>Rezultati za svaku vrijednost; kod bliske i daleke ravnine, vidnog polja i razmaka kliknite jednu da je primijenite</translation>
    </message>
    <message>
        <source>{0} (measured only)</source>
        <translation>{0} (samo izmjereno)</translation>
    </message>
</context>
<context>
    <name>Measuring</name>
    <message>
        <source>The measurement cannot be started: {0}.</source>
        <translation>Mjerenje se ne može pokrenuti: {0}.</translation>
    </message>
    <message>
        <source>The measurement</source>
        <translation>Mjerenje</translation>
    </message>
    <message>
        <source>The measurement ended unexpectedly.</source>
        <translation>Mjerenje je neočekivano prekinuto.</translation>
    </message>
</context>
<context>
    <name>MessageBar</name>
    <message>
        <source>Message</source>
        <translation>Poruka</translation>
    </message>
    <message>
        <source>Dismiss this message</source>
        <translation>Uklanja ovu poruku</translation>
    </message>
</context>
<context>
    <name>MoveButton</name>
    <message>
        <source>Drag it to another place, or press the arrow keys up and down</source>
        <translation>Povucite na drugo mjesto ili pritišćite strelice gore i dolje</translation>
    </message>
</context>
<context>
    <name>NumberAnswerView</name>
    <message>
        <source>Answer: {0}</source>
        <translation>Odgovor: {0}</translation>
    </message>
    <message>
        <source>A number: 0.5, 1 1/2, √3/2, 2e-3 or 45°, to three significant digits (Enter)</source>
        <translation>Broj: 0.5; 1 1/2; √3/2; 2e-3 ili 45°, na tri značajne znamenke (Enter)</translation>
    </message>
</context>
<context>
    <name>NumberRow</name>
    <message>
        <source>{0}, slider</source>
        <translation>{0}, klizač</translation>
    </message>
    <message>
        <source>units</source>
        <translation>jedinica</translation>
    </message>
</context>
<context>
    <name>Options</name>
    <message>
        <source>How a camera turns a 3-D scene into a picture.</source>
        <translation>Kako kamera 3D scenu pretvara u sliku.</translation>
    </message>
    <message>
        <source>a document, an exported PNG picture, a mesh, a camera, a lesson or a talk (default: the letter F)</source>
        <translation>dokument, izvezena slika PNG, mreža, kamera, lekcija ili izlaganje (zadano: slovo F)</translation>
    </message>
    <message>
        <source>a document, picture or mesh to measure (default: the letter F)</source>
        <translation>dokument, slika ili mreža za mjerenje (zadano: slovo F)</translation>
    </message>
    <message>
        <source>a document, picture, mesh or camera file whose camera is used (default: the letter F)</source>
        <translation>dokument, slika, mreža ili datoteka kamere čija se kamera koristi (zadano: slovo F)</translation>
    </message>
    <message>
        <source>a document, picture, mesh or camera file whose camera is used (default: the letter F), and the points: CSV with the columns x,y,z, or - for standard input; a fourth column, w, may be 0 for a point at infinity; any other w divides x, y and z</source>
        <translation>dokument, slika, mreža ili datoteka kamere čija se kamera koristi (zadano: slovo F) te točke: CSV sa stupcima x,y,z, ili - za standardni ulaz; četvrti stupac, w, može biti 0 za beskonačno daleku točku; svaki drugi w dijeli x, y i z</translation>
    </message>
    <message>
        <source>a talk or a lesson, or the name of one that comes with the program, such as 001 or L5</source>
        <translation>izlaganje ili lekcija, ili ime jednog od priloženih uz program, npr. 001 ili L5</translation>
    </message>
    <message>
        <source>after --convention (default: those of that program)</source>
        <translation>nakon --convention (zadano: ono što taj program koristi)</translation>
    </message>
    <message>
        <source>arithmetic (default: float64, or exact where that is needed)</source>
        <translation>aritmetika (zadano: float64, ili egzaktna gdje je potrebna)</translation>
    </message>
    <message>
        <source>camera and lens as another program writes them</source>
        <translation>kamera i objektiv kako ih piše drugi program</translation>
    </message>
    <message>
        <source>check or list lessons and talks, print tests of exercises, mark results</source>
        <translation>provjerava ili nabraja lekcije i izlaganja, ispisuje testove od vježbi, ocjenjuje rezultate</translation>
    </message>
    <message>
        <source>check: try every state, answer key and sample of lessons and talks, and measure their pictures (default: those that come with the program); list: list them; names: print every name that their files may use; print: print tests, see below; results: mark files of results again from what was typed, count the wrong ideas, and list what no idea explains. FILE may also be a name such as L5 or 001</source>
        <translation>check: isprobava svako stanje, rješenje i uzorak lekcija i izlaganja te mjeri njihove slike (zadano: sve što dolazi s programom); list: nabraja ih; names: ispisuje svako ime koje njihove datoteke smiju koristiti; print: ispisuje testove, vidi dolje; results: iz upisanog ponovno ocjenjuje datoteke rezultata, broji pogrešne predodžbe i nabraja ono što nijedna pogrešna predodžba ne objašnjava. FILE može biti i ime poput L5 ili 001</translation>
    </message>
    <message>
        <source>colours, for this start only</source>
        <translation>boje, samo za ovo pokretanje</translation>
    </message>
    <message>
        <source>colours: as on a light or dark screen; for print, where faces and lines differ in grey, too; or with the most contrast (default: screen)</source>
        <translation>boje: kao na svijetlom ili tamnom ekranu; za tisak, gdje se strane i linije razlikuju i u sivom; ili s najvećim kontrastom (zadano: screen)</translation>
    </message>
    <message>
        <source>delete the settings, then open the window</source>
        <translation>briše postavke, zatim otvara prozor</translation>
    </message>
    <message>
        <source>draw a figure as PNG, SVG, PDF, TikZ or HTML, without a window or display</source>
        <translation>crta sliku kao PNG, SVG, PDF, TikZ ili HTML, bez prozora i zaslona</translation>
    </message>
    <message>
        <source>draw a film: a value of --set changes from FIRST to LAST; may be repeated for values that change together</source>
        <translation>crta film: vrijednost, imenovana kao kod --set, mijenja se od FIRST do LAST; može se ponoviti za vrijednosti koje se mijenjaju zajedno</translation>
    </message>
    <message>
        <source>draw a film: how --step follows from the step before</source>
        <translation>crta film: kako --step slijedi iz prethodnog koraka</translation>
    </message>
    <message>
        <source>draw a film: the ndc pane goes from the world through all stages to the image, and back</source>
        <translation>crta film: okno ndc ide od svijeta kroz sve etape do slike i natrag</translation>
    </message>
    <message>
        <source>draw a film: the world is seen from all round, or as far round as DEGREES say, and back; the camera stays where it is</source>
        <translation>crta film: svijet se gleda sa svih strana, ili onoliko ukrug koliko kaže DEGREES, i natrag; kamera ostaje gdje jest</translation>
    </message>
    <message>
        <source>draw all results; FILE as for --json, ending in .png, or in .svg or .pdf for vectors</source>
        <translation>crta sve rezultate; FILE kao kod --json, s nastavkom .png, ili .svg ili .pdf za vektore</translation>
    </message>
    <message>
        <source>draw errors over time, or over bytes, which are the same on every machine</source>
        <translation>crta pogreške u ovisnosti o vremenu ili o bajtovima, koji su isti na svakom računalu</translation>
    </message>
    <message>
        <source>draw every step of a talk, or print it with its notes</source>
        <translation>crta svaki korak izlaganja ili ga ispisuje s bilješkama</translation>
    </message>
    <message>
        <source>draw every step without a display, run lesson check, measure the pictures, and report each mistake with file and line</source>
        <translation>crta svaki korak bez zaslona, pokreće lesson check, mjeri slike i prijavljuje svaku pogrešku s datotekom i retkom</translation>
    </message>
    <message>
        <source>draw many figures: a CSV file with a line for each, whose columns are out, file, the options without their dashes, and names of --set; each document, and each step of the lessons and talks, of a folder; or each step of one lesson</source>
        <translation>crta mnogo slika: datoteka CSV s retkom za svaku, čiji su stupci out, file, opcije bez crtica i imena za --set; svaki dokument i svaki korak lekcija i izlaganja iz mape; ili svaki korak jedne lekcije</translation>
    </message>
    <message>
        <source>draw the same figure with more pixels (default: 1)</source>
        <translation>crta istu sliku s više piksela (zadano: 1)</translation>
    </message>
    <message>
        <source>every factor from the object to the picture, and the products so far</source>
        <translation>svaki faktor od objekta do slike te dosadašnji umnošci</translation>
    </message>
    <message>
        <source>follow points through every stage of the projection</source>
        <translation>prati točke kroz svaku etapu projekcije</translation>
    </message>
    <message>
        <source>how panes draw (default: opengl with a graphics card, raster without)</source>
        <translation>kako okna crtaju (zadano: opengl s grafičkom karticom, raster bez nje)</translation>
    </message>
    <message>
        <source>in LaTeX: formulas in the cells instead of numbers</source>
        <translation>u LaTeX-u: formule u ćelijama umjesto brojeva</translation>
    </message>
    <message>
        <source>in LaTeX: letters of axes and formulas: own, 000, 001, 002, 003, 004, or those of a file such as letters.toml (default: the document&apos;s)</source>
        <translation>u LaTeX-u: slova osi i formula: own, 000, 001, 002, 003, 004 ili ona iz datoteke poput letters.toml (zadano: ona iz dokumenta)</translation>
    </message>
    <message>
        <source>in LaTeX: numbers, also after --symbols</source>
        <translation>u LaTeX-u: brojevi, i nakon --symbols</translation>
    </message>
    <message>
        <source>in LaTeX: significant digits of numbers, up to 17, which are all (default: 4)</source>
        <translation>u LaTeX-u: značajne znamenke brojeva, najviše 17, a to su sve (zadano: 4)</translation>
    </message>
    <message>
        <source>in LaTeX: the width of the text or the column, such as 84mm, in mm, cm, in or pt (default: 345pt, the text of an article)</source>
        <translation>u LaTeX-u: širina teksta ili stupca, npr. 84mm, u mm, cm, in ili pt (zadano: 345pt, tekst članka)</translation>
    </message>
    <message>
        <source>in all but .png, lines behind faces: left out, dashed as in ISO 128, or thin and grey (default: none)</source>
        <translation>u svemu osim .png, linije iza strana: izostavljene, crtkane kao u ISO 128, ili tanke i sive (zadano: none)</translation>
    </message>
    <message>
        <source>instead of --size: how wide it is after it was cropped without a margin, such as 84mm; its height is free, and letters keep their size</source>
        <translation>umjesto --size: koliko je široka nakon obrezivanja bez ruba, npr. 84mm; visina je slobodna, a slova zadržavaju veličinu</translation>
    </message>
    <message>
        <source>instead: the code and its packages, for machines with Python</source>
        <translation>umjesto toga: kod i njegovi paketi, za računala s Pythonom</translation>
    </message>
    <message>
        <source>leave out what is empty around the figure, but for a margin of 2 mm</source>
        <translation>izostavlja ono što je oko slike prazno, osim ruba od 2 mm</translation>
    </message>
    <message>
        <source>leave the background transparent</source>
        <translation>ostavlja pozadinu prozirnom</translation>
    </message>
    <message>
        <source>letters of axes and formulas: own, 000, 001, 002, 003, 004, or those of a file such as letters.toml (default: the document&apos;s)</source>
        <translation>slova osi i formula: own, 000, 001, 002, 003, 004 ili ona iz datoteke poput letters.toml (zadano: ona iz dokumenta)</translation>
    </message>
    <message>
        <source>letters of axes and formulas: own, 000, 001, 002, 003, 004, or those of a file such as letters.toml (default: the document&apos;s, or the lesson&apos;s)</source>
        <translation>slova osi i formula: own, 000, 001, 002, 003, 004 ili ona iz datoteke poput letters.toml (zadano: ona iz dokumenta ili iz lekcije)</translation>
    </message>
    <message>
        <source>letters of axes and formulas: own, 000, 001, 002, 003, 004, or those of a file such as letters.toml (default: the talk&apos;s)</source>
        <translation>slova osi i formula: own, 000, 001, 002, 003, 004 ili ona iz datoteke poput letters.toml (zadano: ona iz izlaganja)</translation>
    </message>
    <message>
        <source>make a folder to carry to machines without a network or an administrator</source>
        <translation>stvara mapu za prijenos na računala bez mreže ili administratora</translation>
    </message>
    <message>
        <source>measure for half a minute only, less exactly</source>
        <translation>mjeri samo pola minute, manje točno</translation>
    </message>
    <message>
        <source>measure the errors over a parameter&apos;s range; NAME is one of near, far, fov, distance, up, aspect, gap</source>
        <translation>mjeri pogreške kroz raspon parametra; NAME je jedno od near, far, fov, distance, up, aspect, gap</translation>
    </message>
    <message>
        <source>measure this trade; may be repeated (default, without --sweep: all)</source>
        <translation>mjeri ovaj kompromis; može se ponoviti (zadano, bez --sweep: svi)</translation>
    </message>
    <message>
        <source>measure, on this machine, what speed costs in accuracy</source>
        <translation>mjeri, na ovom računalu, koliko se točnosti gubi radi brzine</translation>
    </message>
    <message>
        <source>of --batch with a folder or a lesson: what to write (default: png)</source>
        <translation>uz --batch s mapom ili lekcijom: što zapisati (zadano: png)</translation>
    </message>
    <message>
        <source>of --batch: leave out figures that are newer than the list and their document</source>
        <translation>uz --batch: izostavlja slike koje su novije od popisa i njihova dokumenta</translation>
    </message>
    <message>
        <source>of --sweep: in equal steps, in equal ratios, or slowly at both ends (default: linear)</source>
        <translation>uz --sweep: u jednakim koracima, u jednakim omjerima ili polako na oba kraja (zadano: linear)</translation>
    </message>
    <message>
        <source>of --sweep: write the values below the panes</source>
        <translation>uz --sweep: ispisuje vrijednosti ispod okana</translation>
    </message>
    <message>
        <source>of --wheels, such as 3.12; may be repeated (default: this one&apos;s)</source>
        <translation>uz --wheels, npr. 3.12; može se ponoviti (zadano: verzija ovog Pythona)</translation>
    </message>
    <message>
        <source>of --wheels; may be repeated (default: all of them)</source>
        <translation>uz --wheels; može se ponoviti (zadano: sve)</translation>
    </message>
    <message>
        <source>of a film: from the last frame to the first, not at all, or there and back in all frames together (default: repeat for --sweep and all round, once for --transition and numbered files, else back-and-forth)</source>
        <translation>uz film: od posljednjeg kadra na prvi, nikako, ili tamo i natrag u svim kadrovima zajedno (zadano: repeat za --sweep i cijeli krug, once za --transition i numerirane datoteke, inače back-and-forth)</translation>
    </message>
    <message>
        <source>of a film: how many frames (default: 48; of --stages 120, of --transition 24; in .html 21)</source>
        <translation>uz film: koliko kadrova (zadano: 48; za --stages 120, za --transition 24; u .html 21)</translation>
    </message>
    <message>
        <source>of a film: how many frames a second (default: 25)</source>
        <translation>uz film: koliko kadrova u sekundi (zadano: 25)</translation>
    </message>
    <message>
        <source>of check and print: letters of axes and formulas: own, 000, 001, 002, 003, 004, or those of a file such as letters.toml (default: the lesson&apos;s)</source>
        <translation>uz check i print: slova osi i formula: own, 000, 001, 002, 003, 004 ili ona iz datoteke poput letters.toml (zadano: ona iz lekcije)</translation>
    </message>
    <message>
        <source>of print: the topics, or files of lessons, whose exercises make the test</source>
        <translation>uz print: teme ili datoteke lekcija čije vježbe čine test</translation>
    </message>
    <message>
        <source>of print: the variants, one file for each; a variant has the same numbers everywhere</source>
        <translation>uz print: varijante, jedna datoteka za svaku; varijanta ima svuda iste brojeve</translation>
    </message>
    <message>
        <source>of print: where the PDF files go; existing files are overwritten</source>
        <translation>uz print: kamo idu datoteke PDF; postojeće se zamjenjuju</translation>
    </message>
    <message>
        <source>of print: write one more file, with the answers of all variants and their ways</source>
        <translation>uz print: zapisuje još jednu datoteku, s odgovorima svih varijanti i postupcima</translation>
    </message>
    <message>
        <source>of results: write a table, a row for each answer; an existing file is overwritten</source>
        <translation>uz results: zapisuje tablicu, redak za svaki odgovor; postojeća datoteka se zamjenjuje</translation>
    </message>
    <message>
        <source>of the chart, as of a figure (default: screen)</source>
        <translation>za grafikon, kao za sliku (zadano: screen)</translation>
    </message>
    <message>
        <source>of the chart, as of a figure; with --size, --width or --text-size there are no notes below</source>
        <translation>za grafikon, kao za sliku; uz --size, --width ili --text-size ispod nema napomena</translation>
    </message>
    <message>
        <source>of the chart, instead of --size; its height is free</source>
        <translation>za grafikon, umjesto --size; visina je slobodna</translation>
    </message>
    <message>
        <source>of the handout: teacher has answers and notes, students room to write instead</source>
        <translation>za materijal za podjelu: teacher ima odgovore i bilješke, students umjesto toga prostor za pisanje</translation>
    </message>
    <message>
        <source>output format (default: table)</source>
        <translation>format ispisa (zadano: table)</translation>
    </message>
    <message>
        <source>output format (default: text)</source>
        <translation>format ispisa (zadano: text)</translation>
    </message>
    <message>
        <source>print every stage&apos;s matrix</source>
        <translation>ispisuje matricu svake etape</translation>
    </message>
    <message>
        <source>report the fraction done, one per line, and take the commands pause, resume and cancel from standard input</source>
        <translation>javlja obavljeni dio, po jedan u retku, i prima naredbe pause, resume i cancel sa standardnog ulaza</translation>
    </message>
    <message>
        <source>report what this machine has, what is missing and how to get it</source>
        <translation>javlja što ovo računalo ima, što nedostaje i kako to nabaviti</translation>
    </message>
    <message>
        <source>save a picture of the window as PNG and quit</source>
        <translation>sprema sliku prozora kao PNG i završava</translation>
    </message>
    <message>
        <source>show program&apos;s version number and exit</source>
        <translation>ispisuje verziju programa i završava</translation>
    </message>
    <message>
        <source>size of all letters of the chart in points (default: 7 with --size or --width)</source>
        <translation>veličina svih slova grafikona u točkama (zadano: 7 uz --size ili --width)</translation>
    </message>
    <message>
        <source>size of the window</source>
        <translation>veličina prozora</translation>
    </message>
    <message>
        <source>size of all letters in points; 72 points are 300 pixels at scale 1 (default: 7 in a pane of 640 pixels, in proportion in others)</source>
        <translation>veličina svih slova u točkama; 72 točke su 300 piksela pri mjerilu 1 (zadano: 7 u oknu od 640 piksela, u drugima razmjerno)</translation>
    </message>
    <message>
        <source>size on paper, such as 120mmx80mm, in mm, cm or in; or in pixels at scale 1, 300 an inch (default: 640x640 for each pane, or its own size for the image alone); in .html, of each pane</source>
        <translation>veličina na papiru, npr. 120mmx80mm, u mm, cm ili in; ili u pikselima pri mjerilu 1, 300 po palcu (zadano: 640x640 za svako okno, a kad se crta samo image, njezina vlastita veličina); u .html, svakog okna</translation>
    </message>
    <message>
        <source>space of the coordinates (default: world)</source>
        <translation>koordinatni sustav koordinata (zadano: world)</translation>
    </message>
    <message>
        <source>the figure to write (.png; .svg, .pdf or TikZ&apos;s .tex for shapes and text; .html for a page that phones show), and the document, picture, mesh, camera, lesson or talk to draw (default: the letter F); with --batch, the folder of the figures; with --sweep, --orbit, --stages or --transition, a film (.gif, .apng, .webp, or .mp4 with ffmpeg), a page with a slider (.html), or a name with %03d for a figure of each frame</source>
        <translation>slika koju treba zapisati (.png; .svg, .pdf ili TikZ-ov .tex za oblike i tekst; .html za stranicu koju prikazuju telefoni) te dokument, slika, mreža, kamera, lekcija ili izlaganje za crtanje (zadano: slovo F); uz --batch, mapa za slike; uz --sweep, --orbit, --stages ili --transition, film (.gif, .apng, .webp ili .mp4 s ffmpegom), stranica s klizačem (.html) ili ime s %03d za sliku svakog kadra</translation>
    </message>
    <message>
        <source>the panes to draw, side by side, or below each other with / instead of commas (default: all, side by side; of a step, those of its slide); or equation, alone: that of view.equation, which is the default where --set asks for one</source>
        <translation>okna za crtanje, jedno uz drugo, ili jedno ispod drugog uz / umjesto zareza (zadano: sva, jedno uz drugo; za korak, ona s njegova slajda); ili samo equation: jednadžba iz view.equation, što je zadano gdje je traži --set</translation>
    </message>
    <message>
        <source>the same as --set scene=NAME</source>
        <translation>isto što i --set scene=NAME</translation>
    </message>
    <message>
        <source>the six planes of the view volume in world space</source>
        <translation>šest ravnina volumena pogleda u globalnom koordinatnom sustavu</translation>
    </message>
    <message>
        <source>the step of a lesson or a talk to draw, its number or its name (default: the first)</source>
        <translation>korak lekcije ili izlaganja za crtanje, njegov broj ili ime (zadano: prvi)</translation>
    </message>
    <message>
        <source>what the world pane frames: what is named, with the whole frustum too, or the objects alone (default: named)</source>
        <translation>što okno svijeta obuhvaća: ono što je imenovano, i s cijelom krnjom piramidom, ili samo objekte (zadano: named)</translation>
    </message>
    <message>
        <source>where to put the folder frustum-lab, with the program and all that it needs, for machines like this one without Python; and an archive of it</source>
        <translation>kamo staviti mapu frustum-lab, s programom i svime što treba, za računala poput ovoga bez Pythona; i njezinu arhivu</translation>
    </message>
    <message>
        <source>write all results; FILE is overwritten, - is standard output</source>
        <translation>zapisuje sve rezultate; postojeća datoteka FILE se zamjenjuje, - je standardni izlaz</translation>
    </message>
    <message>
        <source>write the figures, text and notes of every step on A4 pages (.pdf) or as a page that phones show (.html); an existing file is overwritten</source>
        <translation>zapisuje slike, tekst i bilješke svakog koraka na stranice A4 (.pdf) ili kao stranicu koju prikazuju telefoni (.html); postojeća datoteka se zamjenjuje</translation>
    </message>
    <message>
        <source>write the tables, one after the other; FILE as for --json</source>
        <translation>zapisuje tablice, jednu za drugom; FILE kao kod --json</translation>
    </message>
</context>
<context>
    <name>OrderView</name>
    <message>
        <source>The tile at the bottom acts first.</source>
        <translation>Pločica na dnu djeluje prva.</translation>
    </message>
</context>
<context>
    <name>Overview</name>
    <message>
        <source>Overview of what you practised</source>
        <translation>Pregled vježbanja</translation>
    </message>
    <message>
        <source>solved alone</source>
        <translation>riješeno samostalno</translation>
    </message>
    <message>
        <source>solved with help</source>
        <translation>riješeno uz pomoć</translation>
    </message>
    <message>
        <source>answer shown</source>
        <translation>odgovor prikazan</translation>
    </message>
    <message>
        <source>not yet</source>
        <translation>još ne</translation>
    </message>
    <message>
        <source>Test &amp;yourself…</source>
        <translation>Provjerite znanj&amp;e…</translation>
    </message>
    <message>
        <source>&amp;Export…</source>
        <translation>&amp;Izvezi…</translation>
    </message>
    <message>
        <source>Write all of it into a file for your teacher</source>
        <translation>Zapisuje sve to u datoteku za vašeg nastavnika</translation>
    </message>
    <message>
        <source>only a number: not yet</source>
        <translation>samo broj: još ne</translation>
    </message>
    <message>
        <source>Open the lesson</source>
        <translation>Otvara lekciju</translation>
    </message>
    <message>
        <source>{0}, exercise {1}: {2}. {3}</source>
        <translation>{0}, vježba {1}: {2}. {3}</translation>
    </message>
    <message>
        <source>once</source>
        <translation>jednom</translation>
    </message>
    <message numerus="yes">
        <source>%n times</source>
        <translation>
            <numerusform>%n put</numerusform>
            <numerusform>%n puta</numerusform>
            <numerusform>%n puta</numerusform>
        </translation>
    </message>
    <message>
        <source>“{0}” {1}; then: {2}</source>
        <translation>„{0}” {1}; zatim: {2}</translation>
    </message>
</context>
<context>
    <name>Pane</name>
    <message>
        <source>Reset this pane&apos;s own view (double-click)</source>
        <translation>Vraća vlastiti pogled ovog okna (dvoklik)</translation>
    </message>
    <message>
        <source>Enlarge; click again for the whole window</source>
        <translation>Povećava; još jedan klik za cijeli prozor</translation>
    </message>
    <message>
        <source>Move to a window of its own, and back</source>
        <translation>Premješta u vlastiti prozor i natrag</translation>
    </message>
</context>
<context>
    <name>Pen</name>
    <message>
        <source>Pen</source>
        <translation>Olovka</translation>
    </message>
    <message>
        <source>Colours, eraser, undo, clear, keep</source>
        <translation>Boje, gumica, poništavanje, brisanje, čuvanje</translation>
    </message>
    <message>
        <source>Black</source>
        <translation>Crna</translation>
    </message>
    <message>
        <source>Orange</source>
        <translation>Narančasta</translation>
    </message>
    <message>
        <source>Green</source>
        <translation>Zelena</translation>
    </message>
    <message>
        <source>Blue</source>
        <translation>Plava</translation>
    </message>
    <message>
        <source>Erase</source>
        <translation>Gumica</translation>
    </message>
    <message>
        <source>Remove the strokes that are touched (E)</source>
        <translation>Uklanja dotaknute poteze (E)</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Poništi</translation>
    </message>
    <message>
        <source>Remove the last stroke (Ctrl+Z)</source>
        <translation>Uklanja posljednji potez (Ctrl+Z)</translation>
    </message>
    <message>
        <source>Clear</source>
        <translation>Obriši</translation>
    </message>
    <message>
        <source>Remove all strokes of the step (Delete)</source>
        <translation>Uklanja sve poteze u koraku (Delete)</translation>
    </message>
    <message>
        <source>Keep</source>
        <translation>Sačuvaj</translation>
    </message>
    <message>
        <source>Keep the strokes for the handout (K)</source>
        <translation>Čuva poteze za materijal za podjelu (K)</translation>
    </message>
</context>
<context>
    <name>Pictures</name>
    <message>
        <source>Export a picture</source>
        <translation>Izvezi sliku</translation>
    </message>
    <message>
        <source>{0} pictures (*.{1})</source>
        <translation>Slike {0} (*.{1})</translation>
    </message>
    <message>
        <source>Exported {0}</source>
        <translation>Izvezeno: {0}</translation>
    </message>
    <message>
        <source>Drawing the picture</source>
        <translation>Slika se crta</translation>
    </message>
    <message>
        <source>Export a diagram</source>
        <translation>Izvezi dijagram</translation>
    </message>
    <message>
        <source>Copied the diagram</source>
        <translation>Dijagram je kopiran</translation>
    </message>
    <message>
        <source>Copied the picture</source>
        <translation>Slika je kopirana</translation>
    </message>
</context>
<context>
    <name>Plane</name>
    <message>
        <source>near</source>
        <translation>bliska</translation>
    </message>
    <message>
        <source>far</source>
        <translation>daleka</translation>
    </message>
    <message>
        <source>left</source>
        <translation>lijeva</translation>
    </message>
    <message>
        <source>right</source>
        <translation>desna</translation>
    </message>
    <message>
        <source>bottom</source>
        <translation>donja</translation>
    </message>
    <message>
        <source>top</source>
        <translation>gornja</translation>
    </message>
</context>
<context>
    <name>Playing</name>
    <message>
        <source>Play</source>
        <translation>Pokreni</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Zaustavi</translation>
    </message>
</context>
<context>
    <name>Practice</name>
    <message>
        <source>&amp;Review</source>
        <translation>Ponavljan&amp;je</translation>
    </message>
    <message>
        <source>{0} of {1}</source>
        <translation>{0} od {1}</translation>
    </message>
    <message>
        <source>The next review is tomorrow.</source>
        <translation>Sljedeće ponavljanje je sutra.</translation>
    </message>
    <message>
        <source>The next review is on {0}.</source>
        <translation>Sljedeće ponavljanje: {0}</translation>
    </message>
    <message>
        <source>Go on with it</source>
        <translation>Nastavi</translation>
    </message>
    <message>
        <source>The test is kept.</source>
        <translation>Test je sačuvan.</translation>
    </message>
    <message>
        <source>all topics</source>
        <translation>sve teme</translation>
    </message>
    <message>
        <source>Test {0}: {1}</source>
        <translation>Test {0}: {1}</translation>
    </message>
    <message>
        <source>These topics have no exercises yet.</source>
        <translation>Te teme još nemaju vježbi.</translation>
    </message>
    <message>
        <source>Save the result</source>
        <translation>Spremi rezultat</translation>
    </message>
    <message>
        <source>Your name, if your teacher is to read it in the file:</source>
        <translation>Vaše ime, ako ga nastavnik treba pročitati u datoteci:</translation>
    </message>
    <message>
        <source>Results (*.json);;All files (*)</source>
        <translation>Rezultati (*.json);;Sve datoteke (*)</translation>
    </message>
    <message>
        <source>result</source>
        <translation>rezultat</translation>
    </message>
    <message>
        <source>The result is in {0}.</source>
        <translation>Rezultat je u datoteci {0}.</translation>
    </message>
    <message>
        <source>Review</source>
        <translation>Ponavljanje</translation>
    </message>
    <message>
        <source>What you do not solve alone comes back in a day.</source>
        <translation>Što ne riješite sami, vraća se za jedan dan.</translation>
    </message>
    <message>
        <source>Nothing has come back today.</source>
        <translation>Danas se ništa nije vratilo.</translation>
    </message>
    <message>
        <source>&amp;Review: {0}, about {1}</source>
        <translation>Ponavljan&amp;je: {0}, otprilike {1}</translation>
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
        <translation>svijet</translation>
    </message>
    <message>
        <source>view</source>
        <translation>kamera</translation>
    </message>
    <message>
        <source>clip</source>
        <translation>odsijecanje</translation>
    </message>
    <message>
        <source>divide</source>
        <translation>dijeljenje</translation>
    </message>
    <message>
        <source>NDC</source>
        <translation>NDC</translation>
    </message>
    <message>
        <source>image px</source>
        <translation>slika px</translation>
    </message>
    <message>
        <source>depth</source>
        <translation>dubina</translation>
    </message>
    <message>
        <source>inside</source>
        <translation>unutar</translation>
    </message>
    <message>
        <source>outside of: {0}</source>
        <translation>izvan ravnina: {0}</translation>
    </message>
    <message>
        <source>none: a scale of 0 has flattened the object</source>
        <translation>nema: mjerilo 0 spljoštilo je objekt</translation>
    </message>
    <message>
        <source>the vanishing point; {0}</source>
        <translation>nedogled; {0}</translation>
    </message>
    <message>
        <source>behind the eye</source>
        <translation>iza kamere</translation>
    </message>
    <message>
        <source>in the eye plane (w = 0)</source>
        <translation>u ravnini kamere (w = 0)</translation>
    </message>
    <message>
        <source>the opposite direction has a picture</source>
        <translation>suprotni smjer ima sliku</translation>
    </message>
    <message>
        <source>behind the eye: no picture</source>
        <translation>iza kamere: nema slike</translation>
    </message>
    <message>
        <source>parallel to the image: lines stay parallel</source>
        <translation>paralelno sa slikom: pravci ostaju paralelni</translation>
    </message>
    <message>
        <source>parallel projectors: lines stay parallel</source>
        <translation>paralelne zrake projiciranja: pravci ostaju paralelni</translation>
    </message>
    <message>
        <source>w = 0: its picture is at infinity too</source>
        <translation>w = 0: i slika je u beskonačnosti</translation>
    </message>
    <message>
        <source>beside the eye: no number is large enough</source>
        <translation>pokraj kamere: nijedan broj nije dovoljno velik</translation>
    </message>
    <message>
        <source>the pixel&apos;s ray, from near to far</source>
        <translation>zraka piksela, od bliske do daleke ravnine</translation>
    </message>
    <message>
        <source>the pixel&apos;s ray, as far as it is in front of the eye</source>
        <translation>zraka piksela, dokle je ispred kamere</translation>
    </message>
    <message>
        <source>no ray in the world: the matrix has no inverse</source>
        <translation>nema zrake u svijetu: matrica nema inverz</translation>
    </message>
    <message>
        <source>no ray in the world: all of it is behind the eye</source>
        <translation>nema zrake u svijetu: cijela je iza kamere</translation>
    </message>
</context>
<context>
    <name>ProbePanel</name>
    <message>
        <source>The probes&apos; numbers at every stage</source>
        <translation>Brojevi sonda u svakoj etapi</translation>
    </message>
    <message>
        <source>The probe that the fields and buttons change</source>
        <translation>Sonda koju mijenjaju polja i gumbi</translation>
    </message>
    <message>
        <source>Probe</source>
        <translation>Sonda</translation>
    </message>
    <message>
        <source>Probe, world {0}</source>
        <translation>Sonda, svijet {0}</translation>
    </message>
    <message>
        <source>World {0} of the probe; type a number</source>
        <translation>Globalna koordinata {0} sonde; upišite broj</translation>
    </message>
    <message>
        <source>w of the probe: 1 for a point; 0 for the point at infinity in the direction x, y, z; with any other w the point is (x/w, y/w, z/w)</source>
        <translation>w sonde: 1 za točku; 0 za beskonačno daleku točku u smjeru x, y, z; za svaki drugi w točka je (x/w, y/w, z/w)</translation>
    </message>
    <message>
        <source>Keep this probe: the next click makes another one</source>
        <translation>Zadržava ovu sondu: sljedeći klik stvara drugu</translation>
    </message>
    <message>
        <source>Pin</source>
        <translation>Prikvači</translation>
    </message>
    <message>
        <source>Remove this probe (Esc)</source>
        <translation>Uklanja ovu sondu (Esc)</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Ukloni</translation>
    </message>
    <message>
        <source>Clear</source>
        <translation>Obriši</translation>
    </message>
    <message>
        <source>Remove all probes</source>
        <translation>Uklanja sve sonde</translation>
    </message>
    <message>
        <source>Click a point in any pane to follow it from the world to its pixel; click an empty place in the image for the ray of that pixel.</source>
        <translation>Kliknite točku u bilo kojem oknu da je pratite od svijeta do njezina piksela; kliknite prazno mjesto na slici za zraku tog piksela.</translation>
    </message>
    <message>
        <source>Probes = {0}: at most {1} can be pinned; remove one first.</source>
        <translation>Broj sonda = {0}: može ih se prikvačiti najviše {1}; najprije uklonite jednu.</translation>
    </message>
    <message>
        <source>{0}, pinned</source>
        <translation>{0}, prikvačeno</translation>
    </message>
    <message>
        <source>Ray {0}</source>
        <translation>Zraka {0}</translation>
    </message>
    <message>
        <source>Point {0}</source>
        <translation>Točka {0}</translation>
    </message>
    <message>
        <source>Direction {0}</source>
        <translation>Smjer {0}</translation>
    </message>
</context>
<context>
    <name>ProbeTable</name>
    <message>
        <source>Copy, with all digits</source>
        <translation>Kopiraj, sa svim znamenkama</translation>
    </message>
</context>
<context>
    <name>Probing</name>
    <message>
        <source>depth = {0}: must be that of something drawn, but nothing is here</source>
        <translation>dubina = {0}: mora biti dubina nečega nacrtanog, a ovdje nema ničega</translation>
    </message>
</context>
<context>
    <name>Progress</name>
    <message>
        <source>Cancel</source>
        <translation>Odustani</translation>
    </message>
</context>
<context>
    <name>QPlatformTheme</name>
    <message>
        <source>&amp;No</source>
        <translation>&amp;Ne</translation>
    </message>
    <message>
        <source>&amp;Yes</source>
        <translation>&amp;Da</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Odustani</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Zatvori</translation>
    </message>
    <message>
        <source>Discard</source>
        <translation>Odbaci</translation>
    </message>
    <message>
        <source>OK</source>
        <translation>U redu</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Spremi</translation>
    </message>
</context>
<context>
    <name>Readout</name>
    <message>
        <source>More numbers</source>
        <translation>Još brojeva</translation>
    </message>
    <message>
        <source>Show or fold the other numbers of this scene</source>
        <translation>Prikazuje ili skriva ostale brojeve ove scene</translation>
    </message>
</context>
<context>
    <name>Recovery</name>
    <message>
        <source>There is unsaved work from {0}.</source>
        <translation>Ima nespremljenog rada: {0}.</translation>
    </message>
    <message>
        <source>Recover it</source>
        <translation>Vrati ga</translation>
    </message>
    <message>
        <source>Discard it</source>
        <translation>Odbaci ga</translation>
    </message>
    <message>
        <source>The recovered work cannot be kept in {0}: save it soon.</source>
        <translation>Vraćeni rad ne može se čuvati u {0}: uskoro ga spremite.</translation>
    </message>
    <message>
        <source>{0} could not be removed: {1}.</source>
        <translation>{0} se nije mogao ukloniti: {1}.</translation>
    </message>
    <message>
        <source>No copy of unsaved work can be kept in {0}: save it soon.</source>
        <translation>Nijedna kopija nespremljenog rada ne može se čuvati u {0}: uskoro ga spremite.</translation>
    </message>
</context>
<context>
    <name>Refusal</name>
    <message>
        <source>A film&apos;s frames have one size: leave out crop and width.</source>
        <translation>Kadrovi filma imaju istu veličinu: izostavite crop i width.</translation>
    </message>
    <message>
        <source>A point ends at {0} instead of {1}.</source>
        <translation>Točka završava u {0} umjesto u {1}.</translation>
    </message>
    <message>
        <source>All signs are turned round.</source>
        <translation>Svi su predznaci obrnuti.</translation>
    </message>
    <message>
        <source>Both orders do the same.</source>
        <translation>Oba redoslijeda čine isto.</translation>
    </message>
    <message>
        <source>It is close, but not exact enough.</source>
        <translation>Blizu je, ali nije dovoljno točno.</translation>
    </message>
    <message>
        <source>It is off by the factor 180/π: degrees and radians are mixed up.</source>
        <translation>Razlikuje se za faktor 180/π: pomiješani su stupnjevi i radijani.</translation>
    </message>
    <message>
        <source>It is too large, by a factor of about {0}.</source>
        <translation>Previše je, za faktor oko {0}.</translation>
    </message>
    <message>
        <source>It is too small, by a factor of about {0}.</source>
        <translation>Premalo je, za faktor oko {0}.</translation>
    </message>
    <message>
        <source>It swings about the origin, and ends {0} units away from its place.</source>
        <translation>Ide ukrug oko ishodišta i završava na udaljenosti {0} od svojeg mjesta.</translation>
    </message>
    <message>
        <source>None of the numbers is right.</source>
        <translation>Nijedan broj nije točan.</translation>
    </message>
    <message>
        <source>Only column {0} is wrong.</source>
        <translation>Pogrešan je samo stupac {0}.</translation>
    </message>
    <message>
        <source>Only row {0} is wrong.</source>
        <translation>Pogrešan je samo redak {0}.</translation>
    </message>
    <message>
        <source>Only the number in row {0}, column {1} is wrong.</source>
        <translation>Pogrešan je samo broj u retku {0}, stupcu {1}.</translation>
    </message>
    <message>
        <source>The digits are right, but the power of ten is wrong.</source>
        <translation>Znamenke su točne, ali je potencija broja deset pogrešna.</translation>
    </message>
    <message>
        <source>The document</source>
        <translation>Dokument</translation>
    </message>
    <message>
        <source>The marked numbers have the wrong sign.</source>
        <translation>Označeni brojevi imaju pogrešan predznak.</translation>
    </message>
    <message>
        <source>The numbers are right, but columns {0} and {1} are exchanged.</source>
        <translation>Brojevi su točni, ali su stupci {0} i {1} zamijenjeni.</translation>
    </message>
    <message>
        <source>The numbers are right, but rows and columns are exchanged.</source>
        <translation>Brojevi su točni, ali su retci i stupci zamijenjeni.</translation>
    </message>
    <message>
        <source>The numbers are right, but rows {0} and {1} are exchanged.</source>
        <translation>Brojevi su točni, ali su retci {0} i {1} zamijenjeni.</translation>
    </message>
    <message>
        <source>The origin ends at {0} instead of {1}.</source>
        <translation>Ishodište završava u {0} umjesto u {1}.</translation>
    </message>
    <message>
        <source>The sign is wrong, and so is the size.</source>
        <translation>Predznak je pogrešan, a i veličina.</translation>
    </message>
    <message>
        <source>The size is right, but the sign is wrong.</source>
        <translation>Veličina je točna, ali je predznak pogrešan.</translation>
    </message>
    <message>
        <source>The w of a point becomes {0} instead of {1}.</source>
        <translation>w točke postaje {0} umjesto {1}.</translation>
    </message>
    <message>
        <source>The {0} axis becomes {1} instead of {2}.</source>
        <translation>Os {0} postaje {1} umjesto {2}.</translation>
    </message>
    <message>
        <source>There is no preview of {0} triangles and points.</source>
        <translation>Nema pretpregleda za toliko trokuta i točaka: {0}.</translation>
    </message>
    <message>
        <source>There is no scene “{0}”, only {1} or {2}; a mesh file needs its ending.</source>
        <translation>Nema scene „{0}”, samo {1} ili {2}; datoteka mreže treba nastavak imena.</translation>
    </message>
    <message>
        <source>There is no scene “{0}”, only {1} or {2}; did you mean “{3}”?</source>
        <translation>Nema scene „{0}”, samo {1} ili {2}; jeste li mislili „{3}”?</translation>
    </message>
    <message>
        <source>This is 1 divided by the right number.</source>
        <translation>Ovo je 1 podijeljeno točnim brojem.</translation>
    </message>
    <message>
        <source>asks for a part that {0} does not have</source>
        <translation>traži dio kojeg u {0} nema</translation>
    </message>
    <message>
        <source>begins a block that is not closed: a line ``` must end it</source>
        <translation>počinje blok koji nije zatvoren: mora ga završiti redak ```</translation>
    </message>
    <message>
        <source>begins a block that is not closed: a line ``` must end it, above line {0}, where another begins</source>
        <translation>počinje blok koji nije zatvoren: mora ga završiti redak ```, iznad retka {0}, u kojem počinje drugi</translation>
    </message>
    <message>
        <source>begins a block, but is indented: ``` must begin the line</source>
        <translation>počinje blok, ali je uvučeno: ``` mora biti na početku retka</translation>
    </message>
    <message>
        <source>begins a formula with $ that no other $ on its line ends</source>
        <translation>počinje formulu znakom $ koju nijedan drugi $ u istom retku ne završava</translation>
    </message>
    <message>
        <source>begins code that is not closed: there is one ``` line too many, or one without its kind</source>
        <translation>počinje kod koji nije zatvoren: jedan je redak ``` viška ili je jedan bez svoje vrste</translation>
    </message>
    <message>
        <source>begins code, not a block, and the block of line {0} is in it: there is one ``` line too many, or one without its kind</source>
        <translation>počinje kod, a ne blok, i u njemu je blok iz retka {0}: jedan je redak ``` viška ili je jedan bez svoje vrste</translation>
    </message>
    <message>
        <source>belongs to another lens: set lens.kind as well ({0})</source>
        <translation>pripada drugom objektivu: postavite i lens.kind ({0})</translation>
    </message>
    <message>
        <source>belongs to another scene: set scene as well ({0})</source>
        <translation>pripada drugoj sceni: postavite i scene ({0})</translation>
    </message>
    <message>
        <source>can be read as {0} numbers with decimal commas or as {1} numbers: write decimal points</source>
        <translation>može se čitati kao {0} brojeva s decimalnim zarezima ili kao {1} brojeva: pišite decimalne točke</translation>
    </message>
    <message>
        <source>cannot be moved in the scene {0}, whose objects are fixed</source>
        <translation>ne može se pomicati u sceni {0}, čiji su objekti nepomični</translation>
    </message>
    <message>
        <source>cannot be read: {0}</source>
        <translation>ne može se pročitati: {0}</translation>
    </message>
    <message>
        <source>cannot be set together with {0}, which it replaces</source>
        <translation>ne može se postaviti zajedno s {0}, jer to zamjenjuje</translation>
    </message>
    <message>
        <source>cannot be set together with {0}: both decide what the lens sees</source>
        <translation>ne može se postaviti zajedno s {0}: oboje određuje što objektiv vidi</translation>
    </message>
    <message>
        <source>cannot be shown in the scene {0}, which needs its own objects</source>
        <translation>ne može se prikazati u sceni {0}, koja treba vlastite objekte</translation>
    </message>
    <message>
        <source>cannot be shown: {0}</source>
        <translation>ne može se prikazati: {0}</translation>
    </message>
    <message>
        <source>cannot be told from the wrong value of line {0}, {1}</source>
        <translation>ne može se razlikovati od pogrešne vrijednosti iz retka {0}, {1}</translation>
    </message>
    <message>
        <source>cannot be written as NAME=VALUE alone</source>
        <translation>ne može se zapisati samo kao NAME=VALUE</translation>
    </message>
    <message>
        <source>cannot be written: another program may be writing it</source>
        <translation>ne može se zapisati: možda u to piše drugi program</translation>
    </message>
    <message>
        <source>cannot be written: it is a pipe or a device, not a regular file</source>
        <translation>ne može se zapisati: to je cijev ili uređaj, a ne obična datoteka</translation>
    </message>
    <message>
        <source>cannot be written: it is write-protected</source>
        <translation>ne može se zapisati: zaštićeno je od pisanja</translation>
    </message>
    <message>
        <source>cannot be written: {0}</source>
        <translation>ne može se zapisati: {0}</translation>
    </message>
    <message>
        <source>cannot be written: {0} says “{1}”</source>
        <translation>ne može se zapisati: {0} kaže „{1}”</translation>
    </message>
    <message>
        <source>cloud: must have 1 to {1} points, and {0} were given.</source>
        <translation>cloud: mora imati od 1 do {1} točaka, a zadano ih je {0}.</translation>
    </message>
    <message>
        <source>comes with the program and cannot be changed: copy it, and open the copy</source>
        <translation>dolazi s programom i ne može se mijenjati: kopirajte datoteku i otvorite kopiju</translation>
    </message>
    <message>
        <source>counts something, but its value is {0}</source>
        <translation>nešto broji, ali vrijednost je {0}</translation>
    </message>
    <message>
        <source>divides by zero</source>
        <translation>dijeli s nulom</translation>
    </message>
    <message>
        <source>does not exist</source>
        <translation>ne postoji</translation>
    </message>
    <message>
        <source>does not fulfil the task</source>
        <translation>ne ispunjava zadatak</translation>
    </message>
    <message>
        <source>does not hold</source>
        <translation>ne vrijedi</translation>
    </message>
    <message>
        <source>ease = log: {0} has no equal ratios from {1} to {2}; choose linear.</source>
        <translation>ease = log: {0} nema jednake omjere od {1} do {2}; odaberite linear.</translation>
    </message>
    <message>
        <source>finds no numbers that suit, for seed {0}; the last ones were refused: {1}</source>
        <translation>ne nalazi prikladne brojeve, za sjeme {0}; posljednji su odbijeni: {1}</translation>
    </message>
    <message>
        <source>fps = {0}: must be from 1 to {1}.</source>
        <translation>fps = {0}: mora biti od 1 do {1}.</translation>
    </message>
    <message>
        <source>frames = {0}: must be a whole number from 2 to {1}.</source>
        <translation>frames = {0}: mora biti cijeli broj od 2 do {1}.</translation>
    </message>
    <message>
        <source>frames = {0}: must be even to go back and forth.</source>
        <translation>frames = {0}: mora biti parno da bi išlo naprijed-natrag.</translation>
    </message>
    <message>
        <source>gets “{0}” instead of “{1}”</source>
        <translation>dobiva „{0}” umjesto „{1}”</translation>
    </message>
    <message>
        <source>gets “{0}” instead of “{1}”; this variant has {2}</source>
        <translation>dobiva „{0}” umjesto „{1}”; ova varijanta ima {2}</translation>
    </message>
    <message>
        <source>gives the answer in a second way: keep one of {0}</source>
        <translation>daje odgovor na drugi način: zadržite jedno od {0}</translation>
    </message>
    <message>
        <source>has a formula that only an exercise writes in</source>
        <translation>ima formulu koju upisuje samo „exercise”</translation>
    </message>
    <message>
        <source>has HTML, which a lesson shows as it is typed</source>
        <translation>ima HTML, koji lekcija prikazuje onako kako je upisan</translation>
    </message>
    <message>
        <source>has “{0}:”, which belongs to {1} only</source>
        <translation>sadrži „{0}:”, što pripada samo uz {1}</translation>
    </message>
    <message>
        <source>has a CAMERA_ID that is not in cameras.txt</source>
        <translation>ima CAMERA_ID kojeg nema u cameras.txt</translation>
    </message>
    <message>
        <source>has a formula that cannot be typeset: {0}</source>
        <translation>ima formulu koja se ne može složiti: {0}</translation>
    </message>
    <message>
        <source>has a function that is not defined for its argument</source>
        <translation>ima funkciju koja za svoj argument nije definirana</translation>
    </message>
    <message>
        <source>has a note of {0} words; the limit is {1}</source>
        <translation>ima bilješku s brojem riječi {0}; granica je {1}</translation>
    </message>
    <message>
        <source>has a picture or a link, which a lesson shows as it is typed</source>
        <translation>ima sliku ili poveznicu, koju lekcija prikazuje onako kako je upisana</translation>
    </message>
    <message>
        <source>has a power with a degree above {0} (character {1})</source>
        <translation>ima potenciju stupnja većeg od {0} (znak {1})</translation>
    </message>
    <message>
        <source>has a value that is too large; the limit is {0}</source>
        <translation>ima preveliku vrijednost; granica je {0}</translation>
    </message>
    <message>
        <source>has an answer that the scene shows as “{0}”: add “hide: numbers”</source>
        <translation>ima odgovor koji scena prikazuje kao „{0}”: dodajte „hide: numbers”</translation>
    </message>
    <message>
        <source>has an unknown kind of block, {0}; the nearest is {1}</source>
        <translation>ima nepoznatu vrstu bloka, {0}; najbliža je {1}</translation>
    </message>
    <message>
        <source>has faces that cross each other in too many places for a figure without pixels: write it as .png</source>
        <translation>ima strane koje se međusobno sijeku na previše mjesta za sliku bez piksela: zapišite je kao .png</translation>
    </message>
    <message>
        <source>has more than {0} answers</source>
        <translation>ima više odgovora od {0}</translation>
    </message>
    <message>
        <source>has more than {0} levels of brackets</source>
        <translation>ima više razina zagrada od {0}</translation>
    </message>
    <message>
        <source>has more than {0} nested brackets (character {1})</source>
        <translation>ima više ugniježđenih zagrada od {0} (znak {1})</translation>
    </message>
    <message>
        <source>has more than {0} steps</source>
        <translation>ima više koraka od {0}</translation>
    </message>
    <message>
        <source>has more than {0} values</source>
        <translation>ima više vrijednosti od {0}</translation>
    </message>
    <message>
        <source>has no camera: no camera_matrix, K or fx, and no frame</source>
        <translation>nema kamere: ni camera_matrix, ni K ni fx, a ni kadra</translation>
    </message>
    <message>
        <source>has no steps</source>
        <translation>nema koraka</translation>
    </message>
    <message>
        <source>has no strokes as Frustum Lab writes them</source>
        <translation>nema poteza kako ih piše Frustum Lab</translation>
    </message>
    <message>
        <source>has no value in this state, which has no {0}</source>
        <translation>nema vrijednosti u ovom stanju, u kojem nema {0}</translation>
    </message>
    <message>
        <source>has no value, because infinity minus infinity or infinity times 0 is no number</source>
        <translation>nema vrijednosti, jer beskonačno minus beskonačno i beskonačno puta 0 nisu brojevi</translation>
    </message>
    <message>
        <source>has the place ({0}), which is not in the picture</source>
        <translation>ima mjesto ({0}), kojeg nema na slici</translation>
    </message>
    <message>
        <source>has the title of a step, but no line --- above it</source>
        <translation>ima naslov koraka, ali bez retka --- iznad sebe</translation>
    </message>
    <message>
        <source>has tiles that do the same in every order</source>
        <translation>ima pločice koje svakim redoslijedom čine isto</translation>
    </message>
    <message>
        <source>has too few variants, about {0}; it needs at least {1}</source>
        <translation>ima premalo varijanti, oko {0}; treba ih bar {1}</translation>
    </message>
    <message>
        <source>has unreadable lines ({0}), which are left out</source>
        <translation>ima nečitljive retke ({0}), koji su izostavljeni</translation>
    </message>
    <message>
        <source>has {0} characters, with the indented lines below; the limit is {1}</source>
        <translation>ima {0} znakova, s uvučenim retcima ispod; granica je {1}</translation>
    </message>
    <message>
        <source>has {0} characters; the limit is {1}</source>
        <translation>ima {0} znakova; granica je {1}</translation>
    </message>
    <message>
        <source>has {0} faces, lines and points in a pane; the limit of a figure without pixels is {1}: write it as .png</source>
        <translation>ima {0} strana, linija i točaka u oknu; granica slike bez piksela je {1}: zapišite je kao .png</translation>
    </message>
    <message>
        <source>has {0} faces, lines and points in a pane; the limit of a figure without pixels is {1}: write {2}</source>
        <translation>ima {0} strana, linija i točaka u oknu; granica slike bez piksela je {1}: zapišite {2}</translation>
    </message>
    <message>
        <source>has {0} twice</source>
        <translation>ima {0} dvaput</translation>
    </message>
    <message>
        <source>has {0} values; the limit is {1}</source>
        <translation>ima {0} vrijednosti; granica je {1}</translation>
    </message>
    <message>
        <source>has {0} words in its step; the limit is {1}</source>
        <translation>ima {0} riječi u svojem koraku; granica je {1}</translation>
    </message>
    <message>
        <source>has {0} × {1} cells; the answer has {2} × {3}</source>
        <translation>ima {0} × {1} ćelija; odgovor ima {2} × {3}</translation>
    </message>
    <message>
        <source>has {0}, which no formula may contain (character {1})</source>
        <translation>ima {0}, što nijedna formula ne smije sadržavati (znak {1})</translation>
    </message>
    <message>
        <source>has {0}, which no picture of the step can name</source>
        <translation>ima {0}, što nijedna slika koraka ne može imenovati</translation>
    </message>
    <message>
        <source>height = {0} times scale {3}: must be from {1} to {2} pixels.</source>
        <translation>height = {0} puta mjerilo {3}: mora biti od {1} do {2} piksela.</translation>
    </message>
    <message>
        <source>height = {0} {3}: must be from {1} to {2} {3}.</source>
        <translation>height = {0} {3}: mora biti od {1} do {2} {3}.</translation>
    </message>
    <message>
        <source>height = {0}: must be a whole number of pixels from {1} to {2}.</source>
        <translation>height = {0}: mora biti cijeli broj piksela od {1} do {2}.</translation>
    </message>
    <message>
        <source>is a cloud of points of another kind ({0}): convert it to .ply; the command “project --points” reads a table of x, y, z</source>
        <translation>sadrži oblak točaka druge vrste ({0}): pretvorite ga u .ply; naredba „project --points” čita tablicu x, y, z</translation>
    </message>
    <message>
        <source>is a document, and has no view {0}</source>
        <translation>kao dokument nema pogled {0}</translation>
    </message>
    <message>
        <source>is a file of {0}, which is not read: export its cameras as COLMAP text, transforms.json or OpenCV&apos;s K, R, t</source>
        <translation>ne čita se, jer je datoteka programa {0}: izvezite njezine kamere kao COLMAP-ov tekst, transforms.json ili K, R, t iz OpenCV-a</translation>
    </message>
    <message>
        <source>is a folder, not a file</source>
        <translation>nije datoteka, nego mapa</translation>
    </message>
    <message>
        <source>is a lens with distortion, and here straight lines stay straight: undistort the pictures, and use the camera of the new ones</source>
        <translation>opisuje objektiv s distorzijom, a ovdje pravci ostaju ravni: ispravite distorziju slika i koristite kameru novih</translation>
    </message>
    <message>
        <source>is a picture without a Frustum Lab document in it</source>
        <translation>nema u slici dokument programa Frustum Lab</translation>
    </message>
    <message>
        <source>is a skew of the pixels, which must be 0: the window of a lens is a rectangle</source>
        <translation>znači nakošenost piksela, koja mora biti 0: prozor objektiva je pravokutnik</translation>
    </message>
    <message>
        <source>is a transposed K, with cx and cy in the last row: swap rows and columns</source>
        <translation>predstavlja transponiranu K, s cx i cy u posljednjem retku: zamijenite retke i stupce</translation>
    </message>
    <message>
        <source>is a wrong idea, but stands at the right choice</source>
        <translation>pogrešna je predodžba, a stoji uz točan odgovor</translation>
    </message>
    <message>
        <source>is at infinity, so it is a direction and not a point</source>
        <translation>leži u beskonačnosti, pa je smjer, a ne točka</translation>
    </message>
    <message>
        <source>is binary: write text with colmap model_converter --input_path IN --output_path OUT --output_type TXT</source>
        <translation>ima binarni sadržaj: zapišite tekst naredbom colmap model_converter --input_path IN --output_path OUT --output_type TXT</translation>
    </message>
    <message>
        <source>is broken or cut short: the text from line {0}, column {1} on is not JSON</source>
        <translation>ima oštećen ili prekinut sadržaj: tekst od retka {0}, stupca {1} nadalje nije JSON</translation>
    </message>
    <message>
        <source>is damaged, and cannot be renamed: {0}</source>
        <translation>ima oštećen sadržaj i ne može se preimenovati: {0}</translation>
    </message>
    <message>
        <source>is done before the student does anything</source>
        <translation>ispunjava se prije nego što student išta učini</translation>
    </message>
    <message>
        <source>is empty</source>
        <translation>nema sadržaja</translation>
    </message>
    <message>
        <source>is given twice</source>
        <translation>pojavljuje se dvaput</translation>
    </message>
    <message>
        <source>is in pixels of an image whose size is not known, and which is not {0} x {1}: set image.width and image.height, or add image_width and image_height to the file</source>
        <translation>vrijedi u pikselima slike čija veličina nije poznata, a nije ni {0} x {1}: postavite image.width i image.height ili dodajte image_width i image_height u datoteku</translation>
    </message>
    <message>
        <source>is indented, but belongs to nothing above it</source>
        <translation>ima uvlaku, ali ne pripada ničemu iznad sebe</translation>
    </message>
    <message>
        <source>is larger than {0}</source>
        <translation>prelazi veličinu {0}</translation>
    </message>
    <message>
        <source>is longer than {0} characters</source>
        <translation>prelazi duljinu od {0} znakova</translation>
    </message>
    <message>
        <source>is missing</source>
        <translation>nedostaje</translation>
    </message>
    <message>
        <source>is neither a document (.json), a lesson (.md), an exported picture (.png), a mesh ({0}) nor a camera file (.json, .yml, .xml, cameras.txt, images.txt)</source>
        <translation>nije ni dokument (.json), ni lekcija (.md), ni izvezena slika (.png), ni mreža ({0}), ni datoteka kamere (.json, .yml, .xml, cameras.txt, images.txt)</translation>
    </message>
    <message>
        <source>is no perspective camera, and is not read</source>
        <translation>nije perspektivna kamera i ne čita se</translation>
    </message>
    <message>
        <source>is not UTF-8 text, some letters may be wrong: save the file in that encoding</source>
        <translation>nije tekst UTF-8, neka slova mogu biti pogrešna: spremite datoteku u tom kodiranju</translation>
    </message>
    <message>
        <source>is not XML as OpenCV writes it: {0}</source>
        <translation>nije XML kako ga piše OpenCV: {0}</translation>
    </message>
    <message>
        <source>is not a Frustum Lab document</source>
        <translation>nije dokument programa Frustum Lab</translation>
    </message>
    <message>
        <source>is not a Frustum Lab document: it is not text</source>
        <translation>nije dokument programa Frustum Lab: nije tekst</translation>
    </message>
    <message>
        <source>is not a complete PNG picture: it is damaged or cut short</source>
        <translation>nije potpuna slika PNG: oštećena je ili prekinuta</translation>
    </message>
    <message>
        <source>is not a file of results of Frustum Lab</source>
        <translation>nije datoteka rezultata programa Frustum Lab</translation>
    </message>
    <message>
        <source>is not a name that a file can have</source>
        <translation>nije ime koje datoteka može imati</translation>
    </message>
    <message>
        <source>is not in the picture that is printed</source>
        <translation>nije na slici koja se tiska</translation>
    </message>
    <message>
        <source>is not known; the nearest name is {0}</source>
        <translation>nije poznato; najbliže ime je {0}</translation>
    </message>
    <message>
        <source>is shown as it is typed: the name of an idea stands at the end of a choice, one at each, in small letters</source>
        <translation>prikazuje se kako je upisano: ime predodžbe stoji na kraju ponuđenog odgovora, uz svaki po jedno, malim slovima</translation>
    </message>
    <message>
        <source>is step {0} of a lesson; the limit is {1}</source>
        <translation>pripada koraku {0} lekcije; granica je {1}</translation>
    </message>
    <message>
        <source>is step {0} with an exercise; the limit of a lesson is {1}</source>
        <translation>pripada koraku {0} s vježbom; granica lekcije je {1}</translation>
    </message>
    <message>
        <source>is the choice of line {0} again</source>
        <translation>ponavlja ponuđeni odgovor iz retka {0}</translation>
    </message>
    <message>
        <source>is the letter of {0} already; two things cannot share one</source>
        <translation>već označava {0}; dvije stvari ne mogu dijeliti isto slovo</translation>
    </message>
    <message>
        <source>is the verdict of no sample in a “test”</source>
        <translation>nije ishod nijednog uzorka u bloku „test”</translation>
    </message>
    <message>
        <source>is too close to {0} for a plane as far from the eye as near is</source>
        <translation>leži preblizu vrijednosti {0} za ravninu koja je od kamere udaljena koliko i bliska ravnina</translation>
    </message>
    <message>
        <source>is too close to {0} for float64 to tell the two apart</source>
        <translation>leži preblizu vrijednosti {0} da bi ih float64 razlikovao</translation>
    </message>
    <message>
        <source>is too long for one page</source>
        <translation>ne stane na jednu stranicu</translation>
    </message>
    <message>
        <source>is tried by no sample “{0}: ... -&gt; right”, so a wrong value would not be noticed</source>
        <translation>nema uzorak „{0}: ... -&gt; right” koji bi ga isprobao, pa se pogrešna vrijednost ne bi primijetila</translation>
    </message>
    <message>
        <source>is wrong, but has no reply: name a wrong idea, or add “says:” below</source>
        <translation>vrijedi kao pogrešno, ali nema odgovora: navedite pogrešnu predodžbu ili ispod dodajte „says:”</translation>
    </message>
    <message>
        <source>is wrong, but holds in the right state</source>
        <translation>vrijedi kao pogrešno, a ispunjeno je i u točnom stanju</translation>
    </message>
    <message>
        <source>is wrong, but its formula gives the right value, {0}</source>
        <translation>vrijedi kao pogrešno, a formula daje točnu vrijednost, {0}</translation>
    </message>
    <message>
        <source>lacks a line --- above it, which ends the lines like “title: ...”</source>
        <translation>nema iznad sebe redak --- koji završava retke poput „title: ...”</translation>
    </message>
    <message>
        <source>lacks a line “title: ...”</source>
        <translation>nema redak „title: ...”</translation>
    </message>
    <message>
        <source>mesh = {0}: the file has only lines or points, but the scene “{1}” needs a surface; open the file as a scene of its own.</source>
        <translation>mesh = {0}: datoteka ima samo linije ili točke, ali scena „{1}” treba plohu; otvorite datoteku kao zasebnu scenu.</translation>
    </message>
    <message>
        <source>mesh = {1}: the scene “{0}” has a subject of its own, which no mesh can replace.</source>
        <translation>mesh = {1}: scena „{0}” ima vlastiti motiv, koji nijedna mreža ne može zamijeniti.</translation>
    </message>
    <message>
        <source>must be #rrggbb, or red, green and blue, for all points or for each of {0}: whole numbers up to 255, or parts of 1</source>
        <translation>mora biti #rrggbb ili crvena, zelena i plava, za sve točke ili za svaku od {0}: cijeli brojevi do 255 ili dijelovi od 1</translation>
    </message>
    <message>
        <source>must be 0 or at least {0} in size</source>
        <translation>mora biti 0 ili po veličini bar {0}</translation>
    </message>
    <message>
        <source>must be 16 numbers, or a calibrated camera&apos;s K: fx 0 cx, 0 fy cy, 0 0 1</source>
        <translation>mora biti 16 brojeva ili K kalibrirane kamere: fx 0 cx, 0 fy cy, 0 0 1</translation>
    </message>
    <message>
        <source>must be 9, 12 or 16 numbers, but has {0}</source>
        <translation>mora imati 9, 12 ili 16 brojeva, a ima ih {0}</translation>
    </message>
    <message>
        <source>must be NAME=VALUE, or document: FILE.json</source>
        <translation>mora biti NAME=VALUE ili document: FILE.json</translation>
    </message>
    <message>
        <source>must be [SECTION], or NAME = &quot;LETTER&quot;, or begin with # as a comment</source>
        <translation>mora biti [SECTION] ili NAME = &quot;LETTER&quot;, ili počinjati s # kao komentar</translation>
    </message>
    <message>
        <source>must be a Latin letter or word, or one of {0}, with an index after _ if it has one, such as x_min, and of at most {1} characters</source>
        <translation>mora biti latinično slovo ili riječ, ili jedno od {0}, s indeksom nakon _ ako ga ima, npr. x_min, i od najviše {1} znakova</translation>
    </message>
    <message>
        <source>must be a condition: two formulas with =, !=, &lt;, &gt;, &lt;= or &gt;= between them, or NAME = WORD</source>
        <translation>mora biti uvjet: dvije formule sa znakom =, !=, &lt;, &gt;, &lt;= ili &gt;= između njih, ili NAME = WORD</translation>
    </message>
    <message>
        <source>must be a document or a projection, such as load({0})</source>
        <translation>mora biti dokument ili projekcija, npr. load({0})</translation>
    </message>
    <message>
        <source>must be a file beside the lesson, or in a folder there</source>
        <translation>mora biti datoteka uz lekciju ili u mapi ondje</translation>
    </message>
    <message>
        <source>must be a finite number</source>
        <translation>mora biti konačan broj</translation>
    </message>
    <message>
        <source>must be a finite number or inf</source>
        <translation>mora biti konačan broj ili inf</translation>
    </message>
    <message>
        <source>must be a list of 2 to {0} pictures, exactly one of them the document&apos;s own</source>
        <translation>mora biti popis od 2 do {0} slika, od kojih je točno jedna slika samog dokumenta</translation>
    </message>
    <message>
        <source>must be a list of at most {0} different names, or only *</source>
        <translation>mora biti popis od najviše {0} različitih imena ili samo *</translation>
    </message>
    <message>
        <source>must be a list of at most {0} names from {1}</source>
        <translation>mora biti popis od najviše {0} imena iz {1}</translation>
    </message>
    <message>
        <source>must be a list of at most {0} names of values</source>
        <translation>mora biti popis od najviše {0} imena vrijednosti</translation>
    </message>
    <message>
        <source>must be a list of at most {0} probes</source>
        <translation>mora biti popis od najviše {0} sonda</translation>
    </message>
    <message>
        <source>must be a list of names from {0}</source>
        <translation>mora biti popis imena iz {0}</translation>
    </message>
    <message>
        <source>must be a list of texts NAME=VALUE</source>
        <translation>mora biti popis tekstova NAME=VALUE</translation>
    </message>
    <message>
        <source>must be a list of the numbers of probes</source>
        <translation>mora biti popis brojeva sonda</translation>
    </message>
    <message>
        <source>must be a matrix of finite numbers, but has {0}</source>
        <translation>mora biti matrica konačnih brojeva, a ima {0}</translation>
    </message>
    <message>
        <source>must be a matrix of numbers, but has {0}</source>
        <translation>mora biti matrica brojeva, a ima {0}</translation>
    </message>
    <message>
        <source>must be a name</source>
        <translation>mora biti ime</translation>
    </message>
    <message>
        <source>must be a name of letters, digits and -</source>
        <translation>mora biti ime od slova, znamenaka i -</translation>
    </message>
    <message>
        <source>must be a number from {0} to {1}</source>
        <translation>mora biti broj od {0} do {1}</translation>
    </message>
    <message>
        <source>must be a number like 0.5, 1/2, √3/2 or 2e-3; {0} cannot be read as part of one</source>
        <translation>mora biti broj poput 0.5; 1/2; √3/2 ili 2e-3; {0} se ne može čitati kao njegov dio</translation>
    </message>
    <message>
        <source>must be a number of at most {0} characters</source>
        <translation>mora biti broj od najviše {0} znakova</translation>
    </message>
    <message>
        <source>must be a number of points, such as 8 or 8pt</source>
        <translation>mora biti broj točaka (pt), npr. 8 ili 8pt</translation>
    </message>
    <message>
        <source>must be a number of the model that can be set, and the answer; it is {0} here</source>
        <translation>mora biti broj modela koji se može postaviti, i odgovor; ovdje je {0}</translation>
    </message>
    <message>
        <source>must be a number whose power of ten is between -{0} and {0}</source>
        <translation>mora biti broj čija je potencija broja deset između -{0} i {0}</translation>
    </message>
    <message>
        <source>must be a number without {0}</source>
        <translation>mora biti broj bez {0}</translation>
    </message>
    <message>
        <source>must be a number, or inf for ∞</source>
        <translation>mora biti broj, ili inf za ∞</translation>
    </message>
    <message>
        <source>must be a number, such as 0.5 or 2e-3</source>
        <translation>mora biti broj, npr. 0.5 ili 2e-3</translation>
    </message>
    <message>
        <source>must be a number, such as {0}</source>
        <translation>mora biti broj, npr. {0}</translation>
    </message>
    <message>
        <source>must be a number: a function has no value there</source>
        <translation>mora biti broj: funkcija ondje nema vrijednost</translation>
    </message>
    <message>
        <source>must be a number: nothing can be divided by 0</source>
        <translation>mora biti broj: ništa se ne može dijeliti s 0</translation>
    </message>
    <message>
        <source>must be a number; nothing is typed yet</source>
        <translation>mora biti broj; još ništa nije upisano</translation>
    </message>
    <message>
        <source>must be a number; something is missing after {0}</source>
        <translation>mora biti broj; nešto nedostaje nakon {0}</translation>
    </message>
    <message>
        <source>must be a number; {0} is neither a number nor a unit</source>
        <translation>mora biti broj; {0} nije ni broj ni jedinica</translation>
    </message>
    <message>
        <source>must be a number; {0} may be {1} or {2}: write one of them</source>
        <translation>mora biti broj; {0} može biti {1} ili {2}: napišite jedno od toga</translation>
    </message>
    <message>
        <source>must be a number; {0} mixes degrees and radians</source>
        <translation>mora biti broj; {0} miješa stupnjeve i radijane</translation>
    </message>
    <message>
        <source>must be a range like 20..100 step 5, or numbers separated by commas</source>
        <translation>mora biti raspon poput 20..100 step 5 ili brojevi odvojeni zarezima</translation>
    </message>
    <message>
        <source>must be a rotation: axes of length 1 at right angles, not mirrored</source>
        <translation>mora biti rotacija: međusobno okomite osi duljine 1, bez zrcaljenja</translation>
    </message>
    <message>
        <source>must be a rotation: equally long axes at right angles, not mirrored</source>
        <translation>mora biti rotacija: jednako duge, međusobno okomite osi, bez zrcaljenja</translation>
    </message>
    <message>
        <source>must be a row and a column, separated by “,”</source>
        <translation>mora biti redak i stupac, odvojeni znakom „,”</translation>
    </message>
    <message>
        <source>must be a sample like “NAME: SAMPLE -&gt; VERDICT”</source>
        <translation>mora biti uzorak poput „NAME: SAMPLE -&gt; VERDICT”</translation>
    </message>
    <message>
        <source>must be a text</source>
        <translation>mora biti tekst</translation>
    </message>
    <message>
        <source>must be a text or a list of some of {0}</source>
        <translation>mora biti tekst ili popis od nekih od {0}</translation>
    </message>
    <message>
        <source>must be a type such as float64, to which numpy.asarray(points, float) converts</source>
        <translation>mora biti tip poput float64 u koji pretvara numpy.asarray(points, float)</translation>
    </message>
    <message>
        <source>must be a value of settings, camera, lens, image, object or depth, as NAME=VALUE</source>
        <translation>mora biti vrijednost iz settings, camera, lens, image, object ili depth, kao NAME=VALUE</translation>
    </message>
    <message>
        <source>must be a whole number</source>
        <translation>mora biti cijeli broj</translation>
    </message>
    <message>
        <source>must be a whole number from {0} to {1}</source>
        <translation>mora biti cijeli broj od {0} do {1}</translation>
    </message>
    <message>
        <source>must be a whole number of pixels from 1 to {0}</source>
        <translation>mora biti cijeli broj piksela od 1 do {0}</translation>
    </message>
    <message>
        <source>must be a whole number, 1 or more</source>
        <translation>mora biti cijeli broj, 1 ili veći</translation>
    </message>
    <message>
        <source>must be a whole number: the question asks for a count</source>
        <translation>mora biti cijeli broj: pitanje pita koliko ih ima</translation>
    </message>
    <message>
        <source>must be an answer with its lesson, exercise and time</source>
        <translation>mora biti odgovor s lekcijom, vježbom i vremenom</translation>
    </message>
    <message>
        <source>must be an object with named values in braces</source>
        <translation>mora biti objekt s imenovanim vrijednostima u vitičastim zagradama</translation>
    </message>
    <message>
        <source>must be at least {0}</source>
        <translation>mora biti bar {0}</translation>
    </message>
    <message>
        <source>must be at least {0} away from the target</source>
        <translation>mora biti bar {0} udaljeno od cilja</translation>
    </message>
    <message>
        <source>must be at least {0} long</source>
        <translation>mora biti dugo bar {0}</translation>
    </message>
    <message>
        <source>must be at most {0}</source>
        <translation>mora biti najviše {0}</translation>
    </message>
    <message>
        <source>must be axes of matplotlib, such as pyplot.gca()</source>
        <translation>mora biti axes iz matplotliba, npr. pyplot.gca()</translation>
    </message>
    <message>
        <source>must be followed by # and the number, up to {0}, or the name of a view: {1}</source>
        <translation>mora iza sebe imati # i broj, do {0}, ili ime pogleda: {1}</translation>
    </message>
    <message>
        <source>must be four rows of four finite numbers</source>
        <translation>mora imati četiri retka s po četiri konačna broja</translation>
    </message>
    <message>
        <source>must be from {0} to {1} points</source>
        <translation>mora biti od {0} do {1} točaka (pt)</translation>
    </message>
    <message>
        <source>must be fx, fy, cx, cy, or K: three rows fx, 0, cx and 0, fy, cy and 0, 0, 1</source>
        <translation>mora biti fx, fy, cx, cy ili K: tri retka fx, 0, cx i 0, fy, cy i 0, 0, 1</translation>
    </message>
    <message>
        <source>must be greater than 0; below 0 the image&apos;s x points left: take fx = {0} and cx = W - 1 - cx</source>
        <translation>mora biti veće od 0; ispod 0 os x slike pokazuje ulijevo: uzmite fx = {0} i cx = W - 1 - cx</translation>
    </message>
    <message>
        <source>must be greater than 0; below 0 the image&apos;s y points up: take fy = {0} and cy = H - 1 - cy</source>
        <translation>mora biti veće od 0; ispod 0 os y slike pokazuje prema gore: uzmite fy = {0} i cy = H - 1 - cy</translation>
    </message>
    <message>
        <source>must be greater than bottom, which is {0}</source>
        <translation>mora biti veće od donjeg ruba, koji je {0}</translation>
    </message>
    <message>
        <source>must be greater than left, which is {0}</source>
        <translation>mora biti veće od lijevog ruba, koji je {0}</translation>
    </message>
    <message>
        <source>must be greater than near, which is {0}</source>
        <translation>mora biti veće od udaljenosti bliske ravnine, koja je {0}</translation>
    </message>
    <message>
        <source>must be greater than {0}</source>
        <translation>mora biti veće od {0}</translation>
    </message>
    <message>
        <source>must be in pixels, but the four numbers are in widths and heights of the image: multiply fx and cx by {0}, fy and cy by {1}, then subtract 0.5 from cx and cy</source>
        <translation>mora biti u pikselima, a ta četiri broja su u širinama i visinama slike: pomnožite fx i cx s {0}, fy i cy s {1}, zatim oduzmite 0.5 od cx i cy</translation>
    </message>
    <message>
        <source>must be in {0}</source>
        <translation>mora biti u {0}</translation>
    </message>
    <message>
        <source>must be increasing numbers from 0 to 1, one fewer than the compared pictures, or none for side by side</source>
        <translation>mora biti rastući niz brojeva od 0 do 1, jedan manje od broja uspoređenih slika, ili nijedan za prikaz jedno uz drugo</translation>
    </message>
    <message>
        <source>must be left out where there is no cloud</source>
        <translation>mora izostati kad nema oblaka (cloud)</translation>
    </message>
    <message>
        <source>must be left out where width is given, which crops the figure</source>
        <translation>mora izostati kad je zadan width, koji obrezuje sliku</translation>
    </message>
    <message>
        <source>must be less than far, which is {0}</source>
        <translation>mora biti manje od udaljenosti daleke ravnine, koja je {0}</translation>
    </message>
    <message>
        <source>must be less than right, which is {0}</source>
        <translation>mora biti manje od desnog ruba, koji je {0}</translation>
    </message>
    <message>
        <source>must be less than top, which is {0}</source>
        <translation>mora biti manje od gornjeg ruba, koji je {0}</translation>
    </message>
    <message>
        <source>must be of the type {0}</source>
        <translation>mora biti tipa {0}</translation>
    </message>
    <message>
        <source>must be one line of at most {0} characters</source>
        <translation>mora biti jedan redak od najviše {0} znakova</translation>
    </message>
    <message>
        <source>must be one line of text</source>
        <translation>mora biti jedan redak teksta</translation>
    </message>
    <message>
        <source>must be one of the scene&apos;s own comparisons ({0}), or PATH=VALUE, with ; between the values of a picture, | between pictures, and NAME: before a picture that has a name</source>
        <translation>mora biti jedna od usporedbi same scene ({0}) ili PATH=VALUE, s ; između vrijednosti jedne slike, | između slika i NAME: ispred slike koja ima ime</translation>
    </message>
    <message>
        <source>must be one of {0}</source>
        <translation>mora biti jedno od {0}</translation>
    </message>
    <message>
        <source>must be one of {0}, a colon, and its value</source>
        <translation>mora biti jedno od {0}, dvotočka i vrijednost</translation>
    </message>
    <message>
        <source>must be one of {0}, or a file of letters beside the lesson, such as letters.toml</source>
        <translation>mora biti jedno od {0} ili datoteka slova uz lekciju, npr. letters.toml</translation>
    </message>
    <message>
        <source>must be one of {0}, or a file of letters of at most {1} characters</source>
        <translation>mora biti jedno od {0} ili datoteka slova s najviše {1} znakova</translation>
    </message>
    <message>
        <source>must be one of {0}, or a number from {1} to {2}</source>
        <translation>mora biti jedno od {0} ili broj od {1} do {2}</translation>
    </message>
    <message>
        <source>must be one of {0}, or empty for none</source>
        <translation>mora biti jedno od {0} ili prazno za ništa</translation>
    </message>
    <message>
        <source>must be one of {0}; the nearest is {1}</source>
        <translation>mora biti jedno od {0}; najbliže je {1}</translation>
    </message>
    <message>
        <source>must be the document&apos;s own, {0}</source>
        <translation>mora biti vlastito dokumentu, {0}</translation>
    </message>
    <message>
        <source>must be the name of a file</source>
        <translation>mora biti ime datoteke</translation>
    </message>
    <message>
        <source>must be the name of a scene or of a mesh file</source>
        <translation>mora biti ime scene ili datoteke mreže</translation>
    </message>
    <message>
        <source>must be the number of a choice, from 1 to {0}</source>
        <translation>mora biti broj ponuđenog odgovora, od 1 do {0}</translation>
    </message>
    <message>
        <source>must be the numbers x, y, z of each point in turn</source>
        <translation>mora sadržavati redom brojeve x, y, z svake točke</translation>
    </message>
    <message>
        <source>must be the path of a mesh file ({0}), or empty for none</source>
        <translation>mora biti put do datoteke mreže ({0}) ili prazno za ništa</translation>
    </message>
    <message>
        <source>must be the text of one matrix, up to {0} characters long</source>
        <translation>mora biti tekst jedne matrice, dug najviše {0} znakova</translation>
    </message>
    <message>
        <source>must be three finite numbers x, y, z</source>
        <translation>mora imati tri konačna broja x, y, z</translation>
    </message>
    <message>
        <source>must be three numbers for a point, four with w, two for the ray of a pixel, or null for no probe</source>
        <translation>mora imati tri broja za točku, četiri s w, dva za zraku piksela ili null za nijednu sondu</translation>
    </message>
    <message>
        <source>must be three rows of four finite numbers</source>
        <translation>mora imati tri retka s po četiri konačna broja</translation>
    </message>
    <message>
        <source>must be three rows of three finite numbers</source>
        <translation>mora imati tri retka s po tri konačna broja</translation>
    </message>
    <message>
        <source>must be tiles such as translate 3,0,0 or rotate z 90</source>
        <translation>mora biti lanac pločica poput translate 3,0,0 ili rotate z 90</translation>
    </message>
    <message>
        <source>must be topics from L1 to L27, separated by commas</source>
        <translation>mora biti popis tema od L1 do L27, odvojenih zarezima</translation>
    </message>
    <message>
        <source>must be true or false</source>
        <translation>mora biti true ili false</translation>
    </message>
    <message>
        <source>must be two numbers of pixels, width and height</source>
        <translation>mora imati dva broja piksela, širinu i visinu</translation>
    </message>
    <message>
        <source>must be world or ndc with the pane&apos;s eye, or its eye and its target, as in world: 6,4,8 or ndc: 1.3,0.2,0.3,0,0,0; a | separates the two panes (what a class sees is view.slide)</source>
        <translation>mora biti world ili ndc s položajem kamere okna, ili s njezinim položajem i ciljem, npr. world: 6,4,8 ili ndc: 1.3,0.2,0.3,0,0,0; znak | odvaja ta dva okna (što vide studenti, kaže view.slide)</translation>
    </message>
    <message>
        <source>must be written as NAME=VALUE</source>
        <translation>mora biti napisano kao NAME=VALUE</translation>
    </message>
    <message>
        <source>must be {0} coordinates, separated by spaces</source>
        <translation>mora biti {0} koordinata, odvojenih razmacima</translation>
    </message>
    <message>
        <source>must be {0} finite numbers</source>
        <translation>mora biti {0} konačnih brojeva</translation>
    </message>
    <message>
        <source>must be {0} numbers, but has {1}</source>
        <translation>mora biti {0} brojeva, a ima ih {1}</translation>
    </message>
    <message>
        <source>must begin a step with its title, like “# Title”</source>
        <translation>mora početi korak naslovom, poput „# Title”</translation>
    </message>
    <message>
        <source>must begin the lesson: ---, then lines like “title: ...”, then --- again</source>
        <translation>mora početi lekciju: ---, zatim retci poput „title: ...”, zatim opet ---</translation>
    </message>
    <message>
        <source>must begin with a seed, a whole number from 1 to {0}</source>
        <translation>mora početi sjemenom, cijelim brojem od 1 do {0}</translation>
    </message>
    <message>
        <source>must begin with “- [x]” if it is right, else “- [ ]”</source>
        <translation>mora početi s „- [x]” ako je točno, inače s „- [ ]”</translation>
    </message>
    <message>
        <source>must differ from the eye, or the camera looks nowhere</source>
        <translation>mora se razlikovati od položaja kamere, inače kamera ne gleda nikamo</translation>
    </message>
    <message>
        <source>must differ from the target, or the camera looks nowhere</source>
        <translation>mora se razlikovati od cilja, inače kamera ne gleda nikamo</translation>
    </message>
    <message>
        <source>must end in {0}, the numbers of a point</source>
        <translation>mora završiti s {0}, brojevima točke</translation>
    </message>
    <message>
        <source>must have 0, 0, 0, 1 in its last row: no move of an object changes w</source>
        <translation>mora imati 0, 0, 0, 1 u posljednjem retku: nijedno pomicanje objekta ne mijenja w</translation>
    </message>
    <message>
        <source>must have 1 to {0} rows, separated by “;”, each with the same number of cells, 1 to {0}, separated by “,”; and at least two cells</source>
        <translation>mora imati od 1 do {0} redaka, odvojenih znakom „;”, svaki s jednakim brojem ćelija, od 1 do {0}, odvojenih znakom „,”; i bar dvije ćelije</translation>
    </message>
    <message>
        <source>must have a left 3 x 3 block with an inverse: the camera is at infinity, as a parallel one is</source>
        <translation>mora imati lijevi blok 3 x 3 koji ima inverz: kamera je u beskonačnosti, kao paralelna</translation>
    </message>
    <message>
        <source>must have a product with numbers up to {0} only</source>
        <translation>mora imati umnožak s brojevima samo do {0}</translation>
    </message>
    <message>
        <source>must have a result whose formulas have at most {0} characters, or end in {1}</source>
        <translation>mora imati rezultat čije formule imaju najviše {0} znakova, ili završavati na {1}</translation>
    </message>
    <message>
        <source>must have an inverse whose numbers and products float64 can hold</source>
        <translation>mora imati inverz čije brojeve i umnoške float64 može zapisati</translation>
    </message>
    <message>
        <source>must have an inverse, but its rank is {0}</source>
        <translation>mora imati inverz, a rang je {0}</translation>
    </message>
    <message>
        <source>must have at most {0} tiles, but has {1}</source>
        <translation>mora imati najviše {0} pločica, a ima ih {1}</translation>
    </message>
    <message>
        <source>must have equally many numbers in every row</source>
        <translation>mora imati jednako mnogo brojeva u svakom retku</translation>
    </message>
    <message>
        <source>must have finite numbers after {1}, {0} in all</source>
        <translation>mora imati konačne brojeve nakon {1}, ukupno {0}</translation>
    </message>
    <message>
        <source>must have finite real numbers only</source>
        <translation>mora imati samo konačne realne brojeve</translation>
    </message>
    <message>
        <source>must have no masked number</source>
        <translation>ne smije imati nijedan maskirani broj</translation>
    </message>
    <message>
        <source>must have no number after {0}</source>
        <translation>ne smije imati broj nakon {0}</translation>
    </message>
    <message>
        <source>must have numbers up to {0} in size only</source>
        <translation>mora imati samo brojeve veličine do {0}</translation>
    </message>
    <message>
        <source>must have the product that the state shows, which is another {0}</source>
        <translation>mora imati umnožak koji stanje pokazuje, a to je druga matrica {0}</translation>
    </message>
    <message>
        <source>must be 0, 0, 0, 1, the last row of a pose: perhaps rows and columns are exchanged</source>
        <translation>mora biti 0, 0, 0, 1, posljednji redak položaja i orijentacije: možda su retci i stupci zamijenjeni</translation>
    </message>
    <message>
        <source>must have three numbers for each rotation, which has three or nine</source>
        <translation>mora imati tri broja za svaku rotaciju, koja ih ima tri ili devet</translation>
    </message>
    <message>
        <source>must have {0} coordinates, separated by “,”</source>
        <translation>mora imati {0} koordinata, odvojenih znakom „,”</translation>
    </message>
    <message>
        <source>must have {0} significant digits in front of “...”</source>
        <translation>mora imati {0} značajnih znamenaka ispred „...”</translation>
    </message>
    <message>
        <source>must have {0} × {1} cells: “;” separates rows, “|” the cells of a row</source>
        <translation>mora imati {0} × {1} ćelija: „;” odvaja retke, „|” ćelije u retku</translation>
    </message>
    <message>
        <source>must lie above the plane y = {0}: a light on the plane or under it casts no shadow there</source>
        <translation>mora ležati iznad ravnine y = {0}: svjetlo na ravnini ili ispod nje ondje ne baca sjenu</translation>
    </message>
    <message>
        <source>must lie between {0} and {1}, both excluded</source>
        <translation>mora ležati između {0} i {1}, bez njih samih</translation>
    </message>
    <message>
        <source>must name 1 to {0} matrices, such as {1}</source>
        <translation>mora imenovati od 1 do {0} matrica, npr. {1}</translation>
    </message>
    <message>
        <source>must name matrices such as {0}; this lens has no matrix {1}</source>
        <translation>mora imenovati matrice kao {0}; ovaj objektiv nema matricu {1}</translation>
    </message>
    <message>
        <source>must name matrices that one lecture has together</source>
        <translation>mora imenovati matrice koje jedno predavanje ima zajedno</translation>
    </message>
    <message>
        <source>must not be 0 if x, y and z are 0: (0, 0, 0, 0) is neither a point nor a direction</source>
        <translation>ne smije biti 0 ako su x, y i z 0: (0, 0, 0, 0) nije ni točka ni smjer</translation>
    </message>
    <message>
        <source>must not be 0: the plane would go through the eye, where nothing is cut</source>
        <translation>ne smije biti 0: ravnina bi prolazila kroz kameru, gdje se ništa ne siječe</translation>
    </message>
    <message>
        <source>must not be before the near plane ({0})</source>
        <translation>ne smije biti ispred bliske ravnine ({0})</translation>
    </message>
    <message>
        <source>must not be parallel to the view direction</source>
        <translation>ne smije biti paralelno sa smjerom gledanja</translation>
    </message>
    <message>
        <source>must not be the zero vector</source>
        <translation>ne smije biti nulvektor</translation>
    </message>
    <message>
        <source>must point upward, to the sun: otherwise its rays never meet the plane</source>
        <translation>mora biti usmjereno prema gore, prema suncu: inače njegove zrake nikad ne sijeku ravninu</translation>
    </message>
    <message>
        <source>names an unknown wrong idea (the nearest is {0}), and has no “says:” of its own</source>
        <translation>imenuje nepoznatu pogrešnu predodžbu (najbliža je {0}) i nema vlastiti „says:”</translation>
    </message>
    <message>
        <source>needs 2 to {0} choices, just one of them right: “- [x]”, the others “- [ ]”</source>
        <translation>treba 2 do {0} ponuđenih odgovora, od kojih je točan samo jedan: „- [x]”, ostali „- [ ]”</translation>
    </message>
    <message>
        <source>needs a closing bracket instead of {0} (character {1})</source>
        <translation>treba zatvorenu zagradu umjesto {0} (znak {1})</translation>
    </message>
    <message>
        <source>needs a number, a letter or a bracket instead of {0} (character {1})</source>
        <translation>treba broj, slovo ili zagradu umjesto {0} (znak {1})</translation>
    </message>
    <message>
        <source>needs a sign such as + or * in front of {0} (character {1})</source>
        <translation>treba znak poput + ili * ispred {0} (znak {1})</translation>
    </message>
    <message>
        <source>needs a whole number as its power instead of {0} (character {1})</source>
        <translation>treba cijeli broj kao eksponent umjesto {0} (znak {1})</translation>
    </message>
    <message>
        <source>needs lens.sensor_width_mm or lens.sensor_height_mm; the one that compares with 36 x 24 mm is lens.focal_length_mm</source>
        <translation>treba lens.sensor_width_mm ili lens.sensor_height_mm; za usporedbu s 36 x 24 mm služi lens.focal_length_mm</translation>
    </message>
    <message>
        <source>needs the program {0}, which is not on the PATH: write .webp instead</source>
        <translation>treba program {0}, koji nije na PATH: zapišite umjesto toga .webp</translation>
    </message>
    <message>
        <source>needs {0}</source>
        <translation>treba {0}</translation>
    </message>
    <message>
        <source>needs {0} among its tiles</source>
        <translation>treba {0} među svojim pločicama</translation>
    </message>
    <message>
        <source>pane = {0}: must be one of {1}.</source>
        <translation>pane = {0}: mora biti jedno od {1}.</translation>
    </message>
    <message>
        <source>panes = {0}: must name at least one of {1}.</source>
        <translation>panes = {0}: mora imenovati bar jedno od {1}.</translation>
    </message>
    <message>
        <source>plotter() needs the package pyvista: pip install pyvista.</source>
        <translation>plotter() treba paket pyvista: pip install pyvista.</translation>
    </message>
    <message>
        <source>points: at most {0} can be marked, and {1} were given.</source>
        <translation>points: može se označiti najviše {0}, a zadano ih je {1}.</translation>
    </message>
    <message>
        <source>repeats the name of line {0}; each needs its own</source>
        <translation>ponavlja ime iz retka {0}; svaki treba svoje</translation>
    </message>
    <message>
        <source>says another number than its formula&apos;s value, {0}</source>
        <translation>kaže drugi broj, a ne vrijednost svoje formule, {0}</translation>
    </message>
    <message>
        <source>scale = {0}: must be greater than 0 and at most {1}.</source>
        <translation>scale = {0}: mora biti veće od 0 i najviše {1}.</translation>
    </message>
    <message>
        <source>size = {0}: must be WIDTHxHEIGHT in {1}, such as 120mmx80mm, or two numbers of pixels.</source>
        <translation>size = {0}: mora biti WIDTHxHEIGHT u {1}, npr. 120mmx80mm, ili dva broja piksela.</translation>
    </message>
    <message>
        <source>sweep = {0}: must be NAME=FIRST:LAST with finite numbers, such as lens.near=0.5:8 or camera.eye=3,2,4:0,2,5.</source>
        <translation>sweep = {0}: mora biti NAME=FIRST:LAST s konačnim brojevima, npr. lens.near=0.5:8 ili camera.eye=3,2,4:0,2,5.</translation>
    </message>
    <message>
        <source>sweep = {0}: {1} is swept already.</source>
        <translation>sweep = {0}: {1} se već mijenja.</translation>
    </message>
    <message>
        <source>text size = {0}: must be from {1} to {2} points in panes of this size.</source>
        <translation>veličina teksta = {0}: mora biti od {1} do {2} točaka (pt) u oknima ove veličine.</translation>
    </message>
    <message>
        <source>uses an unknown function or matrix, {0}; the nearest is {1}</source>
        <translation>koristi nepoznatu funkciju ili matricu, {0}; najbliža je {1}</translation>
    </message>
    <message>
        <source>uses an unknown name, {0}; the nearest is {1}</source>
        <translation>koristi nepoznato ime, {0}; najbliže je {1}</translation>
    </message>
    <message>
        <source>varies more than {0} numbers</source>
        <translation>mijenja više brojeva od {0}</translation>
    </message>
    <message>
        <source>varies {0} twice</source>
        <translation>mijenja {0} dvaput</translation>
    </message>
    <message>
        <source>was damaged, and is kept as {0}</source>
        <translation>imalo je oštećen sadržaj i čuva se kao {0}</translation>
    </message>
    <message>
        <source>was written by a newer Frustum Lab: its version is {0}, the limit is {1}</source>
        <translation>dolazi iz novijeg programa Frustum Lab: verzija je {0}, granica je {1}</translation>
    </message>
    <message>
        <source>was written by a newer Frustum Lab: its version is {0}, this program reads up to {1}</source>
        <translation>dolazi iz novijeg programa Frustum Lab: verzija je {0}, ovaj program čita do {1}</translation>
    </message>
    <message>
        <source>was written for a newer Frustum Lab, which reads version {0}; this one reads up to {1}</source>
        <translation>treba noviji Frustum Lab, koji čita verziju {0}; ovaj čita do {1}</translation>
    </message>
    <message>
        <source>width = {0} mm: a line of this equation needs {1} mm in letters of {2} points.</source>
        <translation>width = {0} mm: redak ove jednadžbe treba {1} mm uz slova od {2} točaka (pt).</translation>
    </message>
    <message>
        <source>width = {0} times scale {3}: must be from {1} to {2} pixels.</source>
        <translation>width = {0} puta mjerilo {3}: mora biti od {1} do {2} piksela.</translation>
    </message>
    <message>
        <source>width = {0} {3}: must be from {1} to {2} {3}.</source>
        <translation>width = {0} {3}: mora biti od {1} do {2} {3}.</translation>
    </message>
    <message>
        <source>width = {0}: must be a length in {1}, such as 84mm, or a number of pixels.</source>
        <translation>width = {0}: mora biti duljina u {1}, npr. 84mm, ili broj piksela.</translation>
    </message>
    <message>
        <source>width = {0}: must be a whole number of pixels from {1} to {2}.</source>
        <translation>width = {0}: mora biti cijeli broj piksela od {1} do {2}.</translation>
    </message>
    <message>
        <source>{0} of {1} numbers are right; the others are marked.</source>
        <translation>Točnih brojeva: {0} od {1}; ostali su označeni.</translation>
    </message>
    <message>
        <source>{0}, with {1}; “where: CONDITION” excludes numbers</source>
        <translation>{0}, uz {1}; „where: CONDITION” isključuje brojeve</translation>
    </message>
    <message>
        <source>{0}: TeX reads a picture beside it, whose name may have only letters from a to z, digits and . _ + = -.</source>
        <translation>{0}: TeX čita sliku uz nju, čije ime smije imati samo slova od a do z, znamenke i . _ + = -.</translation>
    </message>
    <message>
        <source>{0}: a face, line or point names a vertex that does not exist (there are {1}); export or download the file again.</source>
        <translation>{0}: strana, linija ili točka imenuje vrh koji ne postoji (ima ih {1}); ponovno izvezite ili preuzmite datoteku.</translation>
    </message>
    <message>
        <source>{0}: a mesh file must end in {1} or {2}; convert it to one of these.</source>
        <translation>{0}: datoteka mreže mora završavati na {1} ili {2}; pretvorite je u jedno od toga.</translation>
    </message>
    <message>
        <source>{0}: a vertex has the coordinate {1}, but it must be within ±{2}, 1e12 times the mesh&apos;s size; move the mesh to the origin.</source>
        <translation>{0}: vrh ima koordinatu {1}, a ona mora biti unutar ±{2}, 1e12 puta veličina mreže; pomaknite mrežu u ishodište.</translation>
    </message>
    <message>
        <source>{0}: all vertices are at one point, so there is nothing to see; check the export.</source>
        <translation>{0}: svi su vrhovi u jednoj točki, pa se nema što vidjeti; provjerite izvoz.</translation>
    </message>
    <message>
        <source>{0}: all vertices are on one line, so there is nothing to see; check the export.</source>
        <translation>{0}: svi su vrhovi na jednom pravcu, pa se nema što vidjeti; provjerite izvoz.</translation>
    </message>
    <message>
        <source>{0}: cannot be opened ({1}); check its name and its permissions.</source>
        <translation>{0}: ne može se otvoriti ({1}); provjerite ime i dopuštenja.</translation>
    </message>
    <message>
        <source>{0}: faces left out: {1} of {2}, because they have fewer than three different corners; the first is number {3}.</source>
        <translation>{0}: izostavljene strane: {1} od {2}, jer imaju manje od tri različita vrha; prva je broj {3}.</translation>
    </message>
    <message>
        <source>{0}: faces left out: {1} of {2}, because they have fewer than three different corners; the first is on line {3}.</source>
        <translation>{0}: izostavljene strane: {1} od {2}, jer imaju manje od tri različita vrha; prva je u retku {3}.</translation>
    </message>
    <message>
        <source>{0}: from line {1} on, it has more rows than its header counts; correct the header, or export the file again.</source>
        <translation>{0}: od retka {1} nadalje ima više redaka nego što zaglavlje broji; ispravite zaglavlje ili ponovno izvezite datoteku.</translation>
    </message>
    <message>
        <source>{0}: is a link, where a picture of the figure would be.</source>
        <translation>{0}: to je poveznica, na mjestu gdje bi bila slika.</translation>
    </message>
    <message>
        <source>{0}: is damaged: {1}.</source>
        <translation>{0}: oštećeno je: {1}.</translation>
    </message>
    <message>
        <source>{0}: is not a file of measurements.</source>
        <translation>{0}: nije datoteka mjerenja.</translation>
    </message>
    <message>
        <source>{0}: it cannot be read ({1}); export or download the file again.</source>
        <translation>{0}: ne može se pročitati ({1}); ponovno izvezite ili preuzmite datoteku.</translation>
    </message>
    <message>
        <source>{0}: it uses “{1}”, which this program does not read; export it without that.</source>
        <translation>{0}: koristi „{1}”, što ovaj program ne čita; izvezite bez toga.</translation>
    </message>
    <message>
        <source>{0}: it would grow to {1} triangles, lines and points and {2} MiB, but may have at most {3} and {4} MiB; make it smaller.</source>
        <translation>{0}: naraslo bi na {1} trokuta, linija i točaka i {2} MiB, a smije imati najviše {3} i {4} MiB; smanjite je.</translation>
    </message>
    <message>
        <source>{0}: its faces are not divided into triangles within {1} s; give them fewer corners, or divide them before the export.</source>
        <translation>{0}: strane se ne daju podijeliti u trokute za {1} s; dajte im manje vrhova ili ih podijelite prije izvoza.</translation>
    </message>
    <message>
        <source>{0}: its part {1} is not a readable file in the folder of the mesh; keep the files of a glTF mesh together.</source>
        <translation>{0}: dio {1} nije čitljiva datoteka u mapi mreže; držite datoteke mreže glTF zajedno.</translation>
    </message>
    <message>
        <source>{0}: line {1} cannot be read as {2}; export or download the file again.</source>
        <translation>{0}: redak {1} ne može se čitati kao {2}; ponovno izvezite ili preuzmite datoteku.</translation>
    </message>
    <message>
        <source>{0}: line {1} has a vertex that is not finite (nan or inf), and line {2} uses it; repair the mesh and export it again.</source>
        <translation>{0}: redak {1} ima vrh koji nije konačan (nan ili inf), a redak {2} ga koristi; popravite mrežu i ponovno je izvezite.</translation>
    </message>
    <message>
        <source>{0}: line {1} names a vertex that does not exist (there are {2}); export or download the file again.</source>
        <translation>{0}: redak {1} imenuje vrh koji ne postoji (ima ih {2}); ponovno izvezite ili preuzmite datoteku.</translation>
    </message>
    <message>
        <source>{0}: must end in .svg, .pdf, .tex or .png.</source>
        <translation>{0}: mora završavati na .svg, .pdf, .tex ili .png.</translation>
    </message>
    <message>
        <source>{0}: must end in one of {1}.</source>
        <translation>{0}: mora završavati na jedno od {1}.</translation>
    </message>
    <message>
        <source>{0}: some vertices are not finite (nan or inf: {1} of {2}); repair the mesh and export it again.</source>
        <translation>{0}: neki vrhovi nisu konačni (nan ili inf: {1} od {2}); popravite mrežu i ponovno je izvezite.</translation>
    </message>
    <message>
        <source>{0}: the content of the file is not {1}; check what kind of file it is.</source>
        <translation>{0}: sadržaj datoteke nije {1}; provjerite koje je vrste.</translation>
    </message>
    <message>
        <source>{0}: the file has no faces (vertices: {1}), so there is no surface to draw; export the mesh with faces.</source>
        <translation>{0}: datoteka nema strana (vrhova: {1}), pa nema plohe za crtanje; izvezite mrežu sa stranama.</translation>
    </message>
    <message>
        <source>{0}: the file is cut off: it has {1} of {2} rows of “{3}”; export or download the file again.</source>
        <translation>{0}: datoteka je prekinuta: ima {1} od {2} redaka „{3}”; ponovno izvezite ili preuzmite datoteku.</translation>
    </message>
    <message>
        <source>{0}: the file is cut off: it has {1} of {2} triangles; export or download the file again.</source>
        <translation>{0}: datoteka je prekinuta: ima {1} od {2} trokuta; ponovno izvezite ili preuzmite datoteku.</translation>
    </message>
    <message>
        <source>{0}: the file is cut off; export or download the file again.</source>
        <translation>{0}: datoteka je prekinuta; ponovno izvezite ili preuzmite datoteku.</translation>
    </message>
    <message>
        <source>{0}: the file is empty; save or download it again.</source>
        <translation>{0}: datoteka je prazna; ponovno je spremite ili preuzmite.</translation>
    </message>
    <message>
        <source>{0}: the number of a face&apos;s corners is {1}, but must be from 3 to {2}; divide or repair it.</source>
        <translation>{0}: broj vrhova strane je {1}, a mora biti od 3 do {2}; podijelite je ili popravite.</translation>
    </message>
    <message>
        <source>{0}: the process that reads it ended too early; make it smaller, or export or download the file again.</source>
        <translation>{0}: proces koji čita završio je prerano; smanjite mrežu ili ponovno izvezite ili preuzmite datoteku.</translation>
    </message>
    <message>
        <source>{0}: the size of the mesh is {1} units, but must be between 1e-30 and 1e30; scale it.</source>
        <translation>{0}: veličina mreže je {1} jedinica, a mora biti između 1e-30 i 1e30; skalirajte je.</translation>
    </message>
    <message>
        <source>{0}: the window could not be shown whole.</source>
        <translation>{0}: cijeli se prozor nije mogao prikazati.</translation>
    </message>
    <message>
        <source>{0}: the window did not appear on the screen.</source>
        <translation>{0}: prozor se nije pojavio na ekranu.</translation>
    </message>
    <message>
        <source>{0}: there is no such file; check its name and folder.</source>
        <translation>{0}: nema takve datoteke; provjerite ime i mapu.</translation>
    </message>
    <message>
        <source>{0}: its description has {1} lists and objects, but may have at most {2}; make it smaller.</source>
        <translation>{0}: opis ima {1} popisa i objekata, a smije ih imati najviše {2}; smanjite datoteku.</translation>
    </message>
    <message>
        <source>{0}: there is not enough memory to read it; make it smaller, or close other programs.</source>
        <translation>{0}: nema dovoljno memorije za čitanje; smanjite mrežu ili zatvorite druge programe.</translation>
    </message>
    <message>
        <source>{0}: vertices left out: {1} of {2}, because they are not finite (nan or inf) and no face or line uses them; the first is number {3}.</source>
        <translation>{0}: izostavljeni vrhovi: {1} od {2}, jer nisu konačni (nan ili inf) i nijedna ih strana ni linija ne koristi; prvi je broj {3}.</translation>
    </message>
    <message>
        <source>{0}: vertices left out: {1} of {2}, because they are not finite (nan or inf) and no face or line uses them; the first is on line {3}.</source>
        <translation>{0}: izostavljeni vrhovi: {1} od {2}, jer nisu konačni (nan ili inf) i nijedna ih strana ni linija ne koristi; prvi je u retku {3}.</translation>
    </message>
    <message>
        <source>{0}: was measured by another Frustum Lab: its version is {1}, this one reads {2}.</source>
        <translation>{0}: izmjerio je drugi Frustum Lab: njegova je verzija {1}, ovaj čita {2}.</translation>
    </message>
    <message>
        <source>{0}: would have {1} MB; TeX&apos;s memory holds figures of {2} MB: write {3}.</source>
        <translation>{0}: imalo bi {1} MB; TeX-ova memorija prima slike od {2} MB: zapišite {3}.</translation>
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
        <translation>Dvoklik na ime vraća početnu vrijednost.</translation>
    </message>
    <message>
        <source>Reset {0}</source>
        <translation>Vrati {0}</translation>
    </message>
    <message>
        <source>Not possible.</source>
        <translation>Nije moguće.</translation>
    </message>
</context>
<context>
    <name>Saving</name>
    <message>
        <source>{0} already exists.</source>
        <translation>{0} već postoji.</translation>
    </message>
    <message>
        <source>Overwrite it?</source>
        <translation>Želite li je zamijeniti?</translation>
    </message>
</context>
<context>
    <name>SceneCard</name>
    <message>
        <source>My mesh…</source>
        <translation>Moja mreža…</translation>
    </message>
    <message>
        <source>Replace the scene&apos;s own objects with a mesh from a file</source>
        <translation>Zamjenjuje vlastite objekte scene mrežom iz datoteke</translation>
    </message>
    <message>
        <source>My mesh</source>
        <translation>Moja mreža</translation>
    </message>
    <message>
        <source>Own objects</source>
        <translation>Vlastiti objekti</translation>
    </message>
    <message>
        <source>Restore the scene&apos;s own objects</source>
        <translation>Vraća vlastite objekte scene</translation>
    </message>
    <message>
        <source>Explanation…</source>
        <translation>Objašnjenje…</translation>
    </message>
    <message>
        <source>Show what the scene is about, its lectures and its diagrams, below the panes</source>
        <translation>Prikazuje ispod okana o čemu je scena, njezina predavanja i njezine dijagrame</translation>
    </message>
    <message>
        <source>Explanation and diagrams</source>
        <translation>Objašnjenje i dijagrami</translation>
    </message>
    <message>
        <source>none of these</source>
        <translation>ništa od ovoga</translation>
    </message>
    <message>
        <source>Compare: {0}</source>
        <translation>Usporedi: {0}</translation>
    </message>
    <message>
        <source>Show these pictures side by side, enlarged</source>
        <translation>Prikazuje te slike jednu uz drugu, povećane</translation>
    </message>
    <message>
        <source>Diagrams…</source>
        <translation>Dijagrami…</translation>
    </message>
    <message>
        <source>The lens does not have this value: choose one of the above first.</source>
        <translation>Objektiv nema tu vrijednost: najprije odaberite jednu od gornjih.</translation>
    </message>
    <message>
        <source>Only with “{0}” switched on.</source>
        <translation>Samo kad je uključeno „{0}”.</translation>
    </message>
    <message>
        <source>Only with “{0}”: {1}.</source>
        <translation>Samo uz „{0}”: {1}.</translation>
    </message>
</context>
<context>
    <name>ScenePanel</name>
    <message>
        <source>Diagrams</source>
        <translation>Dijagrami</translation>
    </message>
    <message>
        <source>What this scene shows</source>
        <translation>Što ova scena pokazuje</translation>
    </message>
    <message>
        <source>Lectures: {0}</source>
        <translation>Predavanja: {0}</translation>
    </message>
</context>
<context>
    <name>SearchBox</name>
    <message>
        <source>Find a control</source>
        <translation>Nađi kontrolu</translation>
    </message>
    <message>
        <source>Shows the controls with this name, also folded ones; Enter goes to the first, Esc shows all again (Ctrl+F)</source>
        <translation>Prikazuje kontrole s tim imenom, i one skrivene; Enter ide na prvu, Esc opet prikazuje sve (Ctrl+F)</translation>
    </message>
</context>
<context>
    <name>Section</name>
    <message>
        <source>Fold</source>
        <translation>Sklopi</translation>
    </message>
    <message>
        <source>Unfold</source>
        <translation>Rasklopi</translation>
    </message>
    <message>
        <source>unfolded</source>
        <translation>rasklopljeno</translation>
    </message>
    <message>
        <source>folded</source>
        <translation>sklopljeno</translation>
    </message>
</context>
<context>
    <name>SelfTestDialog</name>
    <message>
        <source>Test yourself</source>
        <translation>Provjerite znanje</translation>
    </message>
    <message>
        <source>The same topics and number give everyone the same test</source>
        <translation>Iste teme i isti broj svima daju isti test</translation>
    </message>
    <message>
        <source>&amp;All topics</source>
        <translation>&amp;Sve teme</translation>
    </message>
    <message>
        <source>&amp;None</source>
        <translation>&amp;Nijedna</translation>
    </message>
    <message>
        <source>Up to {0} exercises. One try each, no hints, panels closed; give three significant digits. At the end you see all solutions.</source>
        <translation>Najviše vježbi: {0}. Za svaku jedan pokušaj, bez savjeta, uz zatvorene ploče; odgovorite na tri značajne znamenke. Na kraju vidite sva rješenja.</translation>
    </message>
    <message>
        <source>&amp;Begin</source>
        <translation>&amp;Počni</translation>
    </message>
    <message>
        <source>Test number</source>
        <translation>Broj testa</translation>
    </message>
    <message>
        <source>Choose topics.</source>
        <translation>Odaberite teme.</translation>
    </message>
</context>
<context>
    <name>SelfTestMarks</name>
    <message>
        <source>{0} of {1} right</source>
        <translation>točno: {0} od {1}</translation>
    </message>
    <message>
        <source>The right answer:</source>
        <translation>Točan odgovor:</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>Točno</translation>
    </message>
    <message>
        <source>Wrong</source>
        <translation>Netočno</translation>
    </message>
    <message>
        <source>You gave no answer.</source>
        <translation>Niste odgovorili.</translation>
    </message>
    <message>
        <source>Your answer:</source>
        <translation>Vaš odgovor:</translation>
    </message>
    <message>
        <source>The idea behind it: “{0}”.</source>
        <translation>Predodžba iza toga: „{0}”.</translation>
    </message>
</context>
<context>
    <name>SettingMotion</name>
    <message>
        <source>Move it back and forth between the ends of its slider</source>
        <translation>Pomiče ga naprijed-natrag između krajeva njegova klizača</translation>
    </message>
    <message>
        <source>Pause it here; playing continues from here</source>
        <translation>Zaustavlja ga ovdje; nastavlja se odavde</translation>
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
        <translation>kanonski paralelni</translation>
    </message>
    <message>
        <source>canonical perspective</source>
        <translation>kanonski perspektivni</translation>
    </message>
    <message>
        <source>clip</source>
        <translation>odsijecanje</translation>
    </message>
    <message>
        <source>depth range</source>
        <translation>raspon dubine</translation>
    </message>
    <message>
        <source>image</source>
        <translation>slika</translation>
    </message>
    <message>
        <source>object</source>
        <translation>objekt</translation>
    </message>
    <message>
        <source>sheared</source>
        <translation>smicanje</translation>
    </message>
    <message>
        <source>view</source>
        <translation>kamera</translation>
    </message>
    <message>
        <source>world</source>
        <translation>svijet</translation>
    </message>
</context>
<context>
    <name>SpeakerWindow</name>
    <message>
        <source>Speaker&apos;s window – Frustum Lab</source>
        <translation>Prozor predavača – Frustum Lab</translation>
    </message>
    <message>
        <source>Notes</source>
        <translation>Bilješke</translation>
    </message>
    <message>
        <source>The slide</source>
        <translation>Slajd</translation>
    </message>
    <message>
        <source>Next</source>
        <translation>Sljedeće</translation>
    </message>
    <message>
        <source>Steps</source>
        <translation>Koraci</translation>
    </message>
    <message>
        <source>&amp;Reset</source>
        <translation>Na n&amp;ulu</translation>
    </message>
    <message>
        <source>◀ &amp;Back</source>
        <translation>◀ &amp;Natrag</translation>
    </message>
    <message>
        <source>&amp;Next ▶</source>
        <translation>&amp;Dalje ▶</translation>
    </message>
    <message>
        <source>B&amp;lank</source>
        <translation>&amp;Zatamni</translation>
    </message>
    <message>
        <source>S&amp;wap screens</source>
        <translation>Za&amp;mijeni ekrane</translation>
    </message>
    <message>
        <source>Swap the screens of class and notes (W); the choice is remembered</source>
        <translation>Zamjenjuje ekrane za studente i za bilješke (W); izbor se pamti</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Vrijeme</translation>
    </message>
    <message>
        <source>Elapsed</source>
        <translation>Proteklo</translation>
    </message>
    <message>
        <source>step {0} of {1}</source>
        <translation>korak {0} od {1}</translation>
    </message>
    <message>
        <source>Next: the answer</source>
        <translation>Sljedeće: odgovor</translation>
    </message>
    <message>
        <source>Next: the question</source>
        <translation>Sljedeće: pitanje</translation>
    </message>
    <message>
        <source>{0}; later: {1}</source>
        <translation>{0}; kasnije: {1}</translation>
    </message>
    <message>
        <source>Next: {0}</source>
        <translation>Sljedeće: {0}</translation>
    </message>
    <message>
        <source>This is the last step.</source>
        <translation>Ovo je posljednji korak.</translation>
    </message>
    <message>
        <source>&amp;Pause</source>
        <translation>Zau&amp;stavi</translation>
    </message>
    <message>
        <source>&amp;Start</source>
        <translation>P&amp;okreni</translation>
    </message>
    <message>
        <source>planned {0} to {1} min</source>
        <translation>planirano {0} do {1} min</translation>
    </message>
    <message>
        <source>planned {0} min</source>
        <translation>planirano {0} min</translation>
    </message>
    <message>
        <source>{0} min late</source>
        <translation>kasni {0} min</translation>
    </message>
</context>
<context>
    <name>Spoken</name>
    <message>
        <source>at least</source>
        <translation>veće ili jednako</translation>
    </message>
    <message>
        <source>at most</source>
        <translation>manje ili jednako</translation>
    </message>
    <message>
        <source>degrees</source>
        <translation>stupnjeva</translation>
    </message>
    <message>
        <source>equals</source>
        <translation>jednako</translation>
    </message>
    <message>
        <source>infinity</source>
        <translation>beskonačno</translation>
    </message>
    <message>
        <source>is about</source>
        <translation>približno</translation>
    </message>
    <message>
        <source>is not</source>
        <translation>različito od</translation>
    </message>
    <message>
        <source>minus</source>
        <translation>minus</translation>
    </message>
    <message>
        <source>over</source>
        <translation>kroz</translation>
    </message>
    <message>
        <source>phi</source>
        <translation>fi</translation>
    </message>
    <message>
        <source>plus</source>
        <translation>plus</translation>
    </message>
    <message>
        <source>plus or minus</source>
        <translation>plus minus</translation>
    </message>
    <message>
        <source>prime</source>
        <translation>crtano</translation>
    </message>
    <message>
        <source>root of</source>
        <translation>korijen iz</translation>
    </message>
    <message>
        <source>sum of</source>
        <translation>zbroj po</translation>
    </message>
    <message>
        <source>times</source>
        <translation>puta</translation>
    </message>
    <message>
        <source>to</source>
        <translation>u</translation>
    </message>
    <message>
        <source>to the power</source>
        <translation>na potenciju</translation>
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
        <translation>objekti scene zadani su u globalnim koordinatama</translation>
    </message>
    <message>
        <source>a scale of 0 flattens the object: it has no inverse and no normals</source>
        <translation>mjerilo 0 spljošti objekt: nema inverz ni normale</translation>
    </message>
    <message>
        <source>a parallel lens has no M_pp: this is the identity</source>
        <translation>paralelni objektiv nema M_pp: ovo je identiteta</translation>
    </message>
    <message>
        <source>far is infinite: the canonical pyramid is scaled by near, which is at z = -1</source>
        <translation>daleka ravnina je u beskonačnosti: kanonska piramida skalirana je prema bliskoj ravnini, koja je na z = -1</translation>
    </message>
</context>
<context>
    <name>StageStrip</name>
    <message>
        <source>World</source>
        <translation>Svijet</translation>
    </message>
    <message>
        <source>World space: the scene and the view volume in it</source>
        <translation>Globalni koordinatni sustav: scena i volumen pogleda u njoj</translation>
    </message>
    <message>
        <source>View</source>
        <translation>Kamera</translation>
    </message>
    <message>
        <source>View space: the eye is at 0 and looks along −z</source>
        <translation>Koordinatni sustav kamere: kamera je u 0 i gleda duž −z</translation>
    </message>
    <message>
        <source>Pyramid</source>
        <translation>Piramida</translation>
    </message>
    <message>
        <source>The canonical perspective volume: a pyramid with its tip in the eye</source>
        <translation>Kanonski perspektivni volumen: piramida s vrhom u kameri</translation>
    </message>
    <message>
        <source>Box</source>
        <translation>Kvadar</translation>
    </message>
    <message>
        <source>The canonical parallel volume: Mₚₚ has turned the pyramid into a box</source>
        <translation>Kanonski paralelni volumen: Mₚₚ je piramidu pretvorio u kvadar</translation>
    </message>
    <message>
        <source>NDC</source>
        <translation>NDC</translation>
    </message>
    <message>
        <source>Normalised device coordinates, z mirrored for display</source>
        <translation>Normalizirane koordinate uređaja, z je za prikaz zrcaljen</translation>
    </message>
    <message>
        <source>Image</source>
        <translation>Slika</translation>
    </message>
    <message>
        <source>The picture in pixels: x right, y down</source>
        <translation>Slika u pikselima: x udesno, y prema dolje</translation>
    </message>
    <message>
        <source>Mₚₚ</source>
        <translation>Mₚₚ</translation>
    </message>
    <message>
        <source>Stage</source>
        <translation>Etapa</translation>
    </message>
    <message>
        <source>From the world through all stages to the picture; the arrow keys go from stop to stop</source>
        <translation>Od svijeta kroz sve etape do slike; strelice idu od postaje do postaje</translation>
    </message>
    <message>
        <source>Object</source>
        <translation>Objekt</translation>
    </message>
    <message>
        <source>The object&apos;s own space</source>
        <translation>Vlastiti koordinatni sustav objekta</translation>
    </message>
    <message>
        <source>After {0}</source>
        <translation>Nakon {0}</translation>
    </message>
    <message>
        <source>The canonical parallel volume: a parallel lens has no pyramid before it</source>
        <translation>Kanonski paralelni volumen: kod paralelnog objektiva pred njim nema piramide</translation>
    </message>
    <message>
        <source>The same box: Mₚₚ of a parallel lens is the identity</source>
        <translation>Isti kvadar: Mₚₚ paralelnog objektiva je identiteta</translation>
    </message>
    <message>
        <source>Canonical parallel</source>
        <translation>Kanonski paralelni</translation>
    </message>
    <message>
        <source>Canonical perspective</source>
        <translation>Kanonski perspektivni</translation>
    </message>
    <message>
        <source>NDC cube</source>
        <translation>Kocka NDC</translation>
    </message>
    <message>
        <source>The moves of object and camera done from the left: each in the axes that the moves before have moved</source>
        <translation>Pomicanja objekta i kamere izvedena slijeva: svako u osima koje su pomaknula prethodna pomicanja</translation>
    </message>
    <message>
        <source>The moves of object and camera read from the right: each in fixed axes</source>
        <translation>Pomicanja objekta i kamere čitana zdesna: svako u nepomičnim osima</translation>
    </message>
    <message>
        <source>x, y, z in world units</source>
        <translation>x, y, z u globalnim jedinicama</translation>
    </message>
    <message>
        <source>no canonical volumes</source>
        <translation>bez kanonskih volumena</translation>
    </message>
    <message>
        <source>x, y, z of view space</source>
        <translation>x, y, z u sustavu kamere</translation>
    </message>
    <message>
        <source>{axis_u}, {axis_v}, {axis_n} in world units</source>
        <translation>{axis_u}, {axis_v}, {axis_n} u globalnim jedinicama</translation>
    </message>
    <message>
        <source>x, y ±1, z {0} … {1}</source>
        <translation>x, y ±1, z {0} … {1}</translation>
    </message>
    <message>
        <source>{0} × {1} pixels, y down</source>
        <translation>{0} × {1} piksela, y prema dolje</translation>
    </message>
    <message>
        <source>x, y ±1, z 0 … -1; Mₚₚ: identity</source>
        <translation>x, y ±1, z 0 … -1; Mₚₚ: identiteta</translation>
    </message>
    <message>
        <source>x, y ±1, z 0 … -1</source>
        <translation>x, y ±1, z 0 … -1</translation>
    </message>
    <message>
        <source>near z -1, far -∞ (scaled by 1/{n})</source>
        <translation>bliska ravnina z -1, daleka -∞ (skalirano s 1/{n})</translation>
    </message>
    <message>
        <source>x, y ±1, z -{n}/{f} = {0} … -1</source>
        <translation>x, y ±1, z -{n}/{f} = {0} … -1</translation>
    </message>
    <message>
        <source>{0} the stages</source>
        <translation>{0} etape</translation>
    </message>
    <message>
        <source>Run through all stages to the picture, resting at each.</source>
        <translation>Prolazi kroz sve etape do slike i zastaje na svakoj.</translation>
    </message>
    <message>
        <source>Pause; playing again continues from here.</source>
        <translation>Zaustavlja; ponovno pokretanje nastavlja odavde.</translation>
    </message>
</context>
<context>
    <name>StartCard</name>
    <message>
        <source>Start</source>
        <translation>Početak</translation>
    </message>
    <message>
        <source>Learn</source>
        <translation>Učenje</translation>
    </message>
    <message>
        <source>Files</source>
        <translation>Datoteke</translation>
    </message>
    <message>
        <source>Show this at every start</source>
        <translation>Prikaži ovo pri svakom pokretanju</translation>
    </message>
    <message>
        <source>Help &gt; Start card shows it at any time</source>
        <translation>Pomoć &gt; Početna kartica prikazuje je u svakom trenutku</translation>
    </message>
    <message>
        <source>How a camera turns a 3-D scene into a picture</source>
        <translation>Kako kamera 3D scenu pretvara u sliku</translation>
    </message>
    <message>
        <source>Begin with the letter F (Esc)</source>
        <translation>Počnite sa slovom F (Esc)</translation>
    </message>
    <message>
        <source>Two-minute tour</source>
        <translation>Obilazak u dvije minute</translation>
    </message>
    <message>
        <source>Six things to try, one after the other</source>
        <translation>Šest stvari koje treba isprobati, jedna za drugom</translation>
    </message>
    <message>
        <source>24 topics of the lectures, to work through alone</source>
        <translation>24 teme predavanja, za samostalan rad</translation>
    </message>
    <message>
        <source>The five lectures, to present to a class</source>
        <translation>Pet predavanja, za izlaganje studentima</translation>
    </message>
    <message>
        <source>Lessons</source>
        <translation>Lekcije</translation>
    </message>
    <message>
        <source>Talks</source>
        <translation>Izlaganja</translation>
    </message>
    <message>
        <source>Speed and accuracy</source>
        <translation>Brzina i točnost</translation>
    </message>
    <message>
        <source>What a renderer gives up to be fast, measured</source>
        <translation>Čega se program za iscrtavanje odriče radi brzine, izmjereno</translation>
    </message>
    <message>
        <source>What you did not solve alone, with other numbers, the topics mixed</source>
        <translation>Što niste riješili sami, s drugim brojevima i pomiješanim temama</translation>
    </message>
    <message>
        <source>Open a file…</source>
        <translation>Otvori datoteku…</translation>
    </message>
    <message>
        <source>Open a document, a lesson, a mesh, a camera or an exported picture</source>
        <translation>Otvara dokument, lekciju, mrežu, kameru ili izvezenu sliku</translation>
    </message>
</context>
<context>
    <name>StatusLine</name>
    <message>
        <source>Numerical health</source>
        <translation>Numeričko stanje</translation>
    </message>
    <message>
        <source>The precision of the picture (drawn) and of its numbers (read), each with a bound on its error. The bound of the picture holds for what is visible. The bounds of the numbers and of the alternatives in the menu hold for every point in front of the eye</source>
        <translation>Preciznost slike (crtano) i njezinih brojeva (čitano), svaka s granicom pogreške. Granica slike vrijedi za ono što se vidi. Granice brojeva i drugih mogućnosti u izborniku vrijede za svaku točku ispred kamere</translation>
    </message>
    <message>
        <source>The panes are drawn with the quality that you chose; click for the automatic one</source>
        <translation>Okna se crtaju kvalitetom koju ste odabrali; kliknite za automatsku</translation>
    </message>
    <message>
        <source>Cost of a step</source>
        <translation>Trošak koraka</translation>
    </message>
    <message>
        <source>{0} {1} + {2}</source>
        <translation>{0} {1} + {2}</translation>
    </message>
    <message>
        <source>model {0}</source>
        <translation>model {0}</translation>
    </message>
    <message>
        <source>{0} ms</source>
        <translation>{0} ms</translation>
    </message>
    <message>
        <source>Time of the last step in ms: the model; for each pane its matrices + its repaint</source>
        <translation>Vrijeme posljednjeg koraka u ms: model; za svako okno njegove matrice + njegovo crtanje</translation>
    </message>
    <message>
        <source>quality: {0}</source>
        <translation>kvaliteta: {0}</translation>
    </message>
    <message>
        <source>drawn {0}, read {1}</source>
        <translation>crtano {0}, čitano {1}</translation>
    </message>
    <message>
        <source>drawn {0} ±{1} px, read {2} ±{3} px</source>
        <translation>crtano {0} ±{1} px, čitano {2} ±{3} px</translation>
    </message>
    <message>
        <source>{0}: up to {1} px, {2} in depth</source>
        <translation>{0}: do {1} px, {2} u dubini</translation>
    </message>
    <message>
        <source>{0}: its error has no bound here</source>
        <translation>{0}: pogreška ovdje nema granicu</translation>
    </message>
    <message>
        <source>drawn</source>
        <translation>crtano</translation>
    </message>
    <message>
        <source>read</source>
        <translation>čitano</translation>
    </message>
    <message>
        <source>Frames of at most {0} ms while dragging…</source>
        <translation>Kadrovi od najviše {0} ms pri povlačenju…</translation>
    </message>
    <message>
        <source>No limit on the frame time while dragging…</source>
        <translation>Bez ograničenja trajanja kadra pri povlačenju…</translation>
    </message>
    <message>
        <source>While you drag a control, antialiasing and triangles may be left out to keep each frame within this many milliseconds; 0 for no limit:</source>
        <translation>Dok povlačite kontrolu, zaglađivanje i trokuti mogu se izostaviti da svaki kadar stane u ovoliko milisekundi; 0 znači bez ograničenja:</translation>
    </message>
    <message>
        <source>Frame time</source>
        <translation>Trajanje kadra</translation>
    </message>
    <message>
        <source>Drawing tolerance {0} px…</source>
        <translation>Tolerancija crtanja {0} px…</translation>
    </message>
    <message>
        <source>Drawing tolerance</source>
        <translation>Tolerancija crtanja</translation>
    </message>
    <message>
        <source>A GPU&apos;s own arithmetic (float32) may draw with an error of up to this many pixels:</source>
        <translation>Vlastita aritmetika grafičke kartice (float32) smije crtati s pogreškom do ovoliko piksela:</translation>
    </message>
</context>
<context>
    <name>StepMarks</name>
    <message>
        <source>Steps</source>
        <translation>Koraci</translation>
    </message>
    <message>
        <source>Practice</source>
        <translation>Vježbanje</translation>
    </message>
    <message>
        <source>Step {0} of {1}</source>
        <translation>Korak {0} od {1}</translation>
    </message>
    <message>
        <source>done</source>
        <translation>gotovo</translation>
    </message>
    <message>
        <source>answered</source>
        <translation>odgovoreno</translation>
    </message>
    <message>
        <source>Step {0}: {1}</source>
        <translation>Korak {0}: {1}</translation>
    </message>
    <message>
        <source>Step {0}, practice: {1}</source>
        <translation>Korak {0}, vježbanje: {1}</translation>
    </message>
</context>
<context>
    <name>StepPage</name>
    <message>
        <source>Step</source>
        <translation>Korak</translation>
    </message>
</context>
<context>
    <name>TalkWriter</name>
    <message>
        <source>Add this state as a step</source>
        <translation>Dodaj ovo stanje kao korak</translation>
    </message>
    <message>
        <source>{0} is not in its folder any more, and no step was added: put the file back, or choose “A new talk from here” in the Lessons menu.</source>
        <translation>{0} više nije u svojoj mapi, pa korak nije dodan: vratite datoteku ili u izborniku Lekcije odaberite „Novo izlaganje odavde”.</translation>
    </message>
    <message>
        <source>Added as step {0} of {1}</source>
        <translation>Dodano kao korak {0} od {1}</translation>
    </message>
    <message>
        <source>Talks and lessons (*.md)</source>
        <translation>Izlaganja i lekcije (*.md)</translation>
    </message>
    <message>
        <source>A new talk from here</source>
        <translation>Novo izlaganje odavde</translation>
    </message>
</context>
<context>
    <name>Talks</name>
    <message>
        <source>There is only one screen.</source>
        <translation>Postoji samo jedan ekran.</translation>
    </message>
    <message>
        <source>Open a talk first: its handout shows the strokes.</source>
        <translation>Najprije otvorite izlaganje: potezi se vide u njegovu materijalu za podjelu.</translation>
    </message>
    <message>
        <source>Kept for the handout: {0}</source>
        <translation>Sačuvano za materijal za podjelu: {0}</translation>
    </message>
    <message>
        <source>This is the last step.</source>
        <translation>Ovo je posljednji korak.</translation>
    </message>
    <message>
        <source>There is no step {0}; the last is {1}.</source>
        <translation>Nema koraka {0}; posljednji je {1}.</translation>
    </message>
    <message>
        <source>To step {0}…</source>
        <translation>Na korak {0}…</translation>
    </message>
    <message>
        <source>The file was changed, and cannot be read.</source>
        <translation>Datoteka je promijenjena i ne može se pročitati.</translation>
    </message>
    <message>
        <source>Open a talk first: the speaker&apos;s window shows its notes.</source>
        <translation>Najprije otvorite izlaganje: prozor predavača prikazuje njegove bilješke.</translation>
    </message>
</context>
<context>
    <name>TaskView</name>
    <message>
        <source>To do</source>
        <translation>Zadatak</translation>
    </message>
    <message>
        <source>The window as it is now is my answer</source>
        <translation>Prozor kakav je sada moj je odgovor</translation>
    </message>
    <message>
        <source>Hand it &amp;in</source>
        <translation>P&amp;redaj</translation>
    </message>
    <message>
        <source>Nothing is changed yet.</source>
        <translation>Još ništa nije promijenjeno.</translation>
    </message>
    <message>
        <source>You can see a state that fulfils the task.</source>
        <translation>Možete vidjeti stanje koje ispunjava zadatak.</translation>
    </message>
    <message>
        <source>Show a state that makes it visible (Alt+W)</source>
        <translation>Prikazuje stanje u kojem se to vidi (Alt+K)</translation>
    </message>
    <message>
        <source>Sho&amp;w it</source>
        <translation>Po&amp;kaži</translation>
    </message>
    <message>
        <source>Done.</source>
        <translation>Gotovo.</translation>
    </message>
    <message>
        <source>Done</source>
        <translation>Gotovo</translation>
    </message>
</context>
<context>
    <name>TitleDialog</name>
    <message>
        <source>&amp;Title of the step</source>
        <translation>&amp;Naslov koraka</translation>
    </message>
    <message>
        <source>Keep the &amp;panes turned as they are</source>
        <translation>Zadrži &amp;okna okrenuta kao sada</translation>
    </message>
    <message>
        <source>The state is then a document beside the file</source>
        <translation>Stanje je tada dokument uz datoteku</translation>
    </message>
</context>
<context>
    <name>TradesCard</name>
    <message>
        <source>Speed and accuracy</source>
        <translation>Brzina i točnost</translation>
    </message>
    <message>
        <source>Back to the start card</source>
        <translation>Natrag na početnu karticu</translation>
    </message>
    <message>
        <source>Start card</source>
        <translation>Početna kartica</translation>
    </message>
    <message>
        <source>Speed and accuracy: what a renderer gives up to be fast</source>
        <translation>Brzina i točnost: čega se program za iscrtavanje odriče radi brzine</translation>
    </message>
    <message>
        <source>Go on with the scene (Esc)</source>
        <translation>Nastavi sa scenom (Esc)</translation>
    </message>
    <message>
        <source>Measured with the letter F on another machine: {0}. Choose a trade to see it, and to measure it here.</source>
        <translation>Izmjereno na slovu F na drugom računalu: {0}. Odaberite kompromis da ga vidite i ovdje izmjerite.</translation>
    </message>
    <message>
        <source>Not measured yet.</source>
        <translation>Još nije izmjereno.</translation>
    </message>
</context>
<context>
    <name>TypesetLabel</name>
    <message>
        <source>Copy with all digits</source>
        <translation>Kopiraj sa svim znamenkama</translation>
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
        <translation>{0} I još {1}.</translation>
    </message>
</context>
<context>
    <name>_MatrixCellEdit</name>
    <message>
        <source>Row {0}, column {1}</source>
        <translation>Redak {0}, stupac {1}</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>Točno</translation>
    </message>
    <message>
        <source>Wrong</source>
        <translation>Netočno</translation>
    </message>
</context>
<context>
    <name>_Node</name>
    <message>
        <source>the picture is of this kind now: {0}</source>
        <translation>slika je sada ove vrste: {0}</translation>
    </message>
</context>
<context>
    <name>_TileCard</name>
    <message>
        <source>Whether the product has this tile</source>
        <translation>Ima li umnožak ovu pločicu</translation>
    </message>
    <message>
        <source>Remove it</source>
        <translation>Uklanja je</translation>
    </message>
    <message>
        <source>origin</source>
        <translation>ishodište</translation>
    </message>
    <message>
        <source>axis</source>
        <translation>os</translation>
    </message>
</context>
<context>
    <name>_TileRow</name>
    <message>
        <source>Whether the product has this tile</source>
        <translation>Ima li umnožak ovu pločicu</translation>
    </message>
</context>
<context>
    <name>phenomena</name>
    <message>
        <source>on</source>
        <translation>uključeno</translation>
    </message>
    <message>
        <source>off</source>
        <translation>isključeno</translation>
    </message>
    <message>
        <source>this computer&apos;s OpenGL rejects the shader that this scene needs: the picture is drawn without it, and only the computed numbers are right</source>
        <translation>OpenGL ovog računala odbija program za sjenčanje koji ova scena treba: slika se crta bez njega i točni su samo izračunani brojevi</translation>
    </message>
    <message>
        <source>{0} faces with {1} parts a side are too many triangles to draw: the picture has {2} parts</source>
        <translation>previše je trokuta za crtanje: broj strana je {0}, dijelova po stranici {1}, a dijelova na slici {2}</translation>
    </message>
    <message>
        <source>your idea</source>
        <translation>vaša zamisao</translation>
    </message>
    <message>
        <source>the model</source>
        <translation>model</translation>
    </message>
    <message>
        <source>truncated pyramid</source>
        <translation>krnja piramida</translation>
    </message>
    <message>
        <source>oblique box</source>
        <translation>kosi kvadar</translation>
    </message>
    <message>
        <source>box</source>
        <translation>kvadar</translation>
    </message>
    <message>
        <source>a free matrix has no near, no far and no window: choose a lens to see this</source>
        <translation>slobodna matrica nema ni blisku ni daleku ravninu ni prozor: odaberite objektiv da biste ovo vidjeli</translation>
    </message>
    <message>
        <source>0 is the orthographic drawing, 1 the oblique one</source>
        <translation>0 je ortogonalni crtež, 1 kosi</translation>
    </message>
    <message>
        <source>0: uncut; then near, far, left, right, bottom and top, one by one</source>
        <translation>0: neodsječeno; zatim bliska, daleka, lijeva, desna, donja i gornja ravnina, jedna po jedna</translation>
    </message>
    <message>
        <source>1-point</source>
        <translation>1 nedogled</translation>
    </message>
    <message>
        <source>1-point perspective</source>
        <translation>perspektiva s 1 nedogledom</translation>
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
        <translation>1/w duž označenog brida je pravac</translation>
    </message>
    <message>
        <source>105 mm, enlarged 3.3 times</source>
        <translation>105 mm, povećano 3.3 puta</translation>
    </message>
    <message>
        <source>12 bits</source>
        <translation>12 bitova</translation>
    </message>
    <message>
        <source>12 bits a coordinate</source>
        <translation>12 bitova po koordinati</translation>
    </message>
    <message>
        <source>16 bits</source>
        <translation>16 bitova</translation>
    </message>
    <message>
        <source>16 bits a coordinate</source>
        <translation>16 bitova po koordinati</translation>
    </message>
    <message>
        <source>1994 console</source>
        <translation>konzola iz 1994.</translation>
    </message>
    <message>
        <source>1: both ends in front of it</source>
        <translation>1: oba kraja ispred nje</translation>
    </message>
    <message>
        <source>2-point</source>
        <translation>2 nedogleda</translation>
    </message>
    <message>
        <source>2-point perspective</source>
        <translation>perspektiva s 2 nedogleda</translation>
    </message>
    <message>
        <source>24 bits</source>
        <translation>24 bita</translation>
    </message>
    <message>
        <source>29 mm</source>
        <translation>29 mm</translation>
    </message>
    <message>
        <source>2: both ends behind it</source>
        <translation>2: oba kraja iza nje</translation>
    </message>
    <message>
        <source>3-point</source>
        <translation>3 nedogleda</translation>
    </message>
    <message>
        <source>3-point perspective</source>
        <translation>perspektiva s 3 nedogleda</translation>
    </message>
    <message>
        <source>32 bits</source>
        <translation>32 bita</translation>
    </message>
    <message>
        <source>3: only A behind it</source>
        <translation>3: samo je A iza nje</translation>
    </message>
    <message>
        <source>4: only B behind it</source>
        <translation>4: samo je B iza nje</translation>
    </message>
    <message>
        <source>8 bits</source>
        <translation>8 bitova</translation>
    </message>
    <message>
        <source>8 bits a coordinate</source>
        <translation>8 bitova po koordinati</translation>
    </message>
    <message>
        <source>A camera turns by 1° a frame: each frame multiplies its axes by the same small turn, and every product is rounded. After 360° it should be home. The pale picture is the true one, and beside it is what the camera sees: one matrix product a frame instead of two sines has its price. Every tenth frame the axes can be renormalised, which repairs their lengths and right angles, but not their direction.</source>
        <translation>Kamera se okreće za 1° po kadru: svaki kadar množi njezine osi istim malim zakretom, a svaki se umnožak zaokružuje. Nakon 360° trebala bi biti na početku. Blijeda slika je prava, a uz nju je ono što kamera vidi: jedan umnožak matrica po kadru umjesto dvaju sinusa ima svoju cijenu. Svakih deset kadrova osi se mogu renormirati, što popravlja njihove duljine i prave kutove, ali ne i smjer.</translation>
    </message>
    <message>
        <source>A field of view from lecture 001; the camera moves so that things at the target&apos;s distance keep their size</source>
        <translation>Vidno polje iz predavanja 001; kamera se pomiče tako da stvari na udaljenosti cilja zadržavaju veličinu</translation>
    </message>
    <message>
        <source>A lamp at a point, or the sun: a point at infinity</source>
        <translation>Svjetiljka u točki ili sunce: beskonačno daleka točka</translation>
    </message>
    <message>
        <source>A logarithmic depth has digits for every distance. Computed for each vertex, it costs one logarithm a vertex, and the early depth test stays on. But between the vertices the rasteriser interpolates it linearly on the screen, where 1/w is linear and log w is not. So a long face is drawn too far away: the wall&apos;s foundation, which is below the floor, is seen through it. Shorter pieces or a logarithm for each pixel mend that.</source>
        <translation>Logaritamska dubina ima znamenke za svaku udaljenost. Kad se računa za svaki vrh, stoji jedan logaritam po vrhu, a rani test dubine ostaje uključen. Ali između vrhova rasterizator je interpolira linearno na ekranu, gdje je 1/w linearan, a log w nije. Zato se duga strana crta predaleko: kroz nju se vidi temelj zida, koji je ispod poda. To popravljaju kraći komadi ili logaritam za svaki piksel.</translation>
    </message>
    <message>
        <source>A pixel and its depth lead back to the point that was drawn there. The inverse of P V does it in one product, but it multiplies the eye&apos;s coordinates with 1/w, a difference of nearly equal numbers. Far from the world&apos;s origin, float32 then misses the point by parts of its distance. If the pixel&apos;s ray is multiplied with the depth, or if P and V are undone one after the other, the eye is only added, and is rounded once. On the way to the picture, it hardly matters whether P and V are one matrix or two: that these make the difference is a myth.</source>
        <translation>Piksel i njegova dubina vode natrag do točke koja je ondje nacrtana. Inverz od P V čini to u jednom umnošku, ali množi koordinate kamere s 1/w, razlikom gotovo jednakih brojeva. Daleko od ishodišta svijeta float32 tada promašuje točku za dijelove njezine udaljenosti. Ako se zraka piksela množi dubinom ili ako se P i V poništavaju jedna za drugom, položaj kamere samo se pribraja i zaokružuje jednom. Na putu do slike jedva je važno jesu li P i V jedna matrica ili dvije: da je u tome razlika, mit je.</translation>
    </message>
    <message>
        <source>A point behind the eye has w &lt; 0, and the divide by w mirrors its image. With one end behind, AB is then drawn along the wrong part of its line, because the right part goes through infinity. So AB must be cut before the divide: at z = −0.01 as in lecture 004, or in homogeneous coordinates, which need no such number.</source>
        <translation>Točka iza kamere ima w &lt; 0, i dijeljenje s w zrcali njezinu sliku. Ako je jedan kraj iza kamere, AB se crta po pogrešnom dijelu svojega pravca, jer pravi dio prolazi kroz beskonačnost. Zato AB treba odsjeći prije dijeljenja: kod z = −0.01 kao u predavanju 004 ili u homogenim koordinatama, kojima taj broj ne treba.</translation>
    </message>
    <message>
        <source>A shadow is a projection with its centre in the light: the matrix S draws the object once more, in one colour. For the sun, a light at infinity with w = 0, the projection is parallel. Parts of the object above a lamp have w &lt; 0. Unless they are clipped, they are drawn on the other side of the lamp as an anti-shadow.</source>
        <translation>Sjena je projekcija s centrom u svjetlu: matrica S crta objekt još jednom, u jednoj boji. Za sunce, beskonačno daleko svjetlo s w = 0, projekcija je paralelna. Dijelovi objekta iznad svjetiljke imaju w &lt; 0. Ako se ne odsijeku, crtaju se s druge strane svjetiljke kao protusjena.</translation>
    </message>
    <message>
        <source>A shape inside the view volume is drawn, and a shape outside it is not. A shape that crosses it is cut by each plane in turn, and gets a new corner where an edge passes through the plane. Near removes everything at the eye or behind it, where w ≤ 0 and the divide fails, and far bounds the depths. Clipping is done in the canonical volume, before the divide, because there the planes are the same for every lens: −w ≤ x, y, z ≤ w in OpenGL&apos;s.</source>
        <translation>Lik unutar volumena pogleda se crta, a lik izvan njega ne. Lik koji ga siječe odsijecaju redom sve ravnine, i dobiva nov vrh gdje mu brid prolazi kroz ravninu. Bliska ravnina uklanja sve što je kod kamere ili iza nje, gdje je w ≤ 0 i dijeljenje zakaže, a daleka ograničava dubine. Odsijeca se u kanonskom volumenu, prije dijeljenja, jer su ondje ravnine iste za svaki objektiv: −w ≤ x, y, z ≤ w u OpenGL-ovu.</translation>
    </message>
    <message>
        <source>A table of 8 bits is quick, and each Newton step doubles its right digits</source>
        <translation>Tablica s 8 bitova je brza, a svaki Newtonov korak udvostručuje broj točnih znamenaka</translation>
    </message>
    <message>
        <source>A wall of two</source>
        <translation>Zid od dva ekrana</translation>
    </message>
    <message>
        <source>AB drawn wrongly</source>
        <translation>AB pogrešno nacrtano</translation>
    </message>
    <message>
        <source>AB left out by the cut at z = −0.01</source>
        <translation>AB izostavljeno odsijecanjem kod z = −0.01</translation>
    </message>
    <message>
        <source>AB missed</source>
        <translation>AB nenacrtano</translation>
    </message>
    <message>
        <source>All projectors are parallel, but slant towards the image. Faces parallel to the image keep their shape, and receding edges are drawn at one angle and one scale. Scale 1 gives a cavalier drawing, 1/2 a cabinet drawing, and 0 the orthographic drawing.</source>
        <translation>Sve su zrake projiciranja paralelne, ali padaju koso na sliku. Strane paralelne sa slikom zadržavaju oblik, a bridovi koji idu u dubinu crtaju se pod jednim kutom i u jednom mjerilu. Mjerilo 1 daje kavalirski crtež, 1/2 kabinetski, a 0 ortogonalni.</translation>
    </message>
    <message>
        <source>Aperture N</source>
        <translation>Otvor blende N</translation>
    </message>
    <message>
        <source>Arithmetic</source>
        <translation>Aritmetika</translation>
    </message>
    <message>
        <source>B is behind the eye: where is it drawn?</source>
        <translation>B je iza kamere: gdje se crta?</translation>
    </message>
    <message>
        <source>Back from the picture</source>
        <translation>Natrag sa slike</translation>
    </message>
    <message>
        <source>Bent by an affine z</source>
        <translation>Savijeno afinim z</translation>
    </message>
    <message>
        <source>Bits of a coordinate</source>
        <translation>Bitovi koordinate</translation>
    </message>
    <message>
        <source>Box (orthographic)</source>
        <translation>Kvadar (ortogonalni)</translation>
    </message>
    <message>
        <source>Cabinet: 1/2 ×</source>
        <translation>Kabinetski: 1/2 ×</translation>
    </message>
    <message>
        <source>Camera obscura</source>
        <translation>Camera obscura</translation>
    </message>
    <message>
        <source>Cameras</source>
        <translation>Kamere</translation>
    </message>
    <message>
        <source>Cavalier or cabinet: which looks right?</source>
        <translation>Kavalirski ili kabinetski: koji izgleda dobro?</translation>
    </message>
    <message>
        <source>Cavalier: 1 ×</source>
        <translation>Kavalirski: 1 ×</translation>
    </message>
    <message>
        <source>Changes the lens, but keeps the picture of the target&apos;s plane</source>
        <translation>Mijenja objektiv, ali zadržava sliku ravnine kroz cilj</translation>
    </message>
    <message>
        <source>Cheap arithmetic</source>
        <translation>Jeftina aritmetika</translation>
    </message>
    <message>
        <source>Checks, or the coordinates themselves as colours</source>
        <translation>Kvadratići ili same koordinate kao boje</translation>
    </message>
    <message>
        <source>Choose 12 bits: how narrow is the gap?</source>
        <translation>Odaberite 12 bitova: koliko je procjep uzak?</translation>
    </message>
    <message>
        <source>Choose 24 bits: is it enough?</source>
        <translation>Odaberite 24 bita: je li dosta?</translation>
    </message>
    <message>
        <source>Choose 8 bits and go nearer. And farther?</source>
        <translation>Odaberite 8 bitova i priđite bliže. A dalje?</translation>
    </message>
    <message>
        <source>Choose a fog that hides it.</source>
        <translation>Odaberite maglu koja ga skriva.</translation>
    </message>
    <message>
        <source>Choose half floats, products alone.</source>
        <translation>Odaberite polovičnu preciznost, samo umnoške.</translation>
    </message>
    <message>
        <source>Choose the box: which come, which go?</source>
        <translation>Odaberite kvadar: što dolazi, što odlazi?</translation>
    </message>
    <message>
        <source>Choose the common grid: what closes?</source>
        <translation>Odaberite zajedničku rešetku: što se zatvara?</translation>
    </message>
    <message>
        <source>Choose the orthographic lens: and now?</source>
        <translation>Odaberite ortogonalni objektiv: a sada?</translation>
    </message>
    <message>
        <source>Choose “correct”: what has moved?</source>
        <translation>Odaberite „točno”: što se pomaknulo?</translation>
    </message>
    <message>
        <source>Choose “each pixel”: what disappears?</source>
        <translation>Odaberite „svaki piksel”: što nestaje?</translation>
    </message>
    <message>
        <source>Circle of confusion c</source>
        <translation>Krug konfuzije c</translation>
    </message>
    <message>
        <source>Click in the image: what comes back?</source>
        <translation>Kliknite na slici: što se vraća?</translation>
    </message>
    <message>
        <source>Clip parts above the light</source>
        <translation>Odsijeci dijelove iznad svjetla</translation>
    </message>
    <message>
        <source>Clipping, plane by plane</source>
        <translation>Odsijecanje, ravninu po ravninu</translation>
    </message>
    <message>
        <source>Compare 29 mm with 105 mm.</source>
        <translation>Usporedite 29 mm s 105 mm.</translation>
    </message>
    <message>
        <source>Compare both films: what is turned over?</source>
        <translation>Usporedite oba filma: što je okrenuto?</translation>
    </message>
    <message>
        <source>Cone (the eye&apos;s own)</source>
        <translation>Stožac (vidno polje oka)</translation>
    </message>
    <message>
        <source>Contrast left by fog</source>
        <translation>Kontrast koji magla ostavlja</translation>
    </message>
    <message>
        <source>Coordinates</source>
        <translation>Koordinate</translation>
    </message>
    <message>
        <source>Cracks</source>
        <translation>Pukotine</translation>
    </message>
    <message>
        <source>Crossed, left eye&apos;s on the right</source>
        <translation>Unakrsno, slika lijevog oka desno</translation>
    </message>
    <message>
        <source>Crossing the eye plane</source>
        <translation>Kroz ravninu kamere</translation>
    </message>
    <message>
        <source>Cut the floor: how many pieces are enough?</source>
        <translation>Izrežite pod: koliko je komada dosta?</translation>
    </message>
    <message>
        <source>Depth at the vertices</source>
        <translation>Dubina u vrhovima</translation>
    </message>
    <message>
        <source>Depth buffer</source>
        <translation>Spremnik dubine</translation>
    </message>
    <message>
        <source>Depth range</source>
        <translation>Raspon dubine</translation>
    </message>
    <message>
        <source>Direction of receding edges, anticlockwise from the right</source>
        <translation>Smjer bridova koji idu u dubinu, od desne strane suprotno od kazaljke na satu</translation>
    </message>
    <message>
        <source>Distance at which linear fog begins</source>
        <translation>Udaljenost na kojoj počinje linearna magla</translation>
    </message>
    <message>
        <source>Distance at which linear fog leaves nothing</source>
        <translation>Udaljenost na kojoj linearna magla ne ostavlja ništa</translation>
    </message>
    <message>
        <source>Distance between the two eyes</source>
        <translation>Udaljenost između dviju očiju</translation>
    </message>
    <message>
        <source>Distance from the eye to the plane of projection; negative behind the eye</source>
        <translation>Udaljenost od kamere do ravnine projekcije; negativna iza kamere</translation>
    </message>
    <message>
        <source>Distance from the hole to the film behind it, and to the synthetic film in front of it: near</source>
        <translation>Udaljenost od rupice do filma iza nje i do sintetičkog filma ispred nje: bliska ravnina</translation>
    </message>
    <message>
        <source>Distance from the lens at which things are in focus</source>
        <translation>Udaljenost od objektiva na kojoj su stvari oštre</translation>
    </message>
    <message>
        <source>Distance from which trees have fewer vertices</source>
        <translation>Udaljenost od koje stabla imaju manje vrhova</translation>
    </message>
    <message>
        <source>Distance from which trees have fewest vertices</source>
        <translation>Udaljenost od koje stabla imaju najmanje vrhova</translation>
    </message>
    <message>
        <source>Distance of surface 2 behind surface 1, along the view direction</source>
        <translation>Udaljenost plohe 2 iza plohe 1, duž smjera gledanja</translation>
    </message>
    <message>
        <source>Distance of the eye from the window&apos;s middle; the window stays in the world</source>
        <translation>Udaljenost kamere od sredine prozora; prozor ostaje u svijetu</translation>
    </message>
    <message>
        <source>Distance of the origin</source>
        <translation>Udaljenost ishodišta</translation>
    </message>
    <message>
        <source>Distance of the screen plane from the eyes: what lies in it does not move between the pictures</source>
        <translation>Udaljenost ravnine ekrana od očiju: što leži u njoj, ne pomiče se između slika</translation>
    </message>
    <message>
        <source>Distance, relative to the preset</source>
        <translation>Udaljenost u odnosu na gotovu postavku</translation>
    </message>
    <message>
        <source>Do near and far change the bow?</source>
        <translation>Mijenjaju li bliska i daleka ravnina luk?</translation>
    </message>
    <message>
        <source>Double d: how large is h&apos;?</source>
        <translation>Udvostručite d: koliko je velik h&apos;?</translation>
    </message>
    <message>
        <source>Double d: what are x_p and y_p now?</source>
        <translation>Udvostručite d: koliki su sada x_p i y_p?</translation>
    </message>
    <message>
        <source>Double the parts: is the error halved?</source>
        <translation>Udvostručite dijelove: prepolovi li se pogreška?</translation>
    </message>
    <message>
        <source>Double z: and now?</source>
        <translation>Udvostručite z: a sada?</translation>
    </message>
    <message>
        <source>Drag P towards the eye: and now?</source>
        <translation>Povucite P prema kameri: a sada?</translation>
    </message>
    <message>
        <source>Drag d: how large is the image of P?</source>
        <translation>Povucite d: koliko je velika slika točke P?</translation>
    </message>
    <message>
        <source>Drag t to 1: where does P go?</source>
        <translation>Povucite t na 1: kamo ide P?</translation>
    </message>
    <message>
        <source>Drag the distance: what keeps its size?</source>
        <translation>Povucite udaljenost: što zadržava veličinu?</translation>
    </message>
    <message>
        <source>Drag the lamp: where is the shadow?</source>
        <translation>Povucite svjetiljku: gdje je sjena?</translation>
    </message>
    <message>
        <source>Drag the near plane towards the F.</source>
        <translation>Povucite blisku ravninu prema slovu F.</translation>
    </message>
    <message>
        <source>Drag the screen plane to P: what happens?</source>
        <translation>Povucite ravninu ekrana do P: što se događa?</translation>
    </message>
    <message>
        <source>Drawing</source>
        <translation>Crtanje</translation>
    </message>
    <message>
        <source>Drawn length of a receding edge relative to its true length, in the free drawing</source>
        <translation>Nacrtana duljina brida koji ide u dubinu u odnosu na pravu duljinu, na slobodnom crtežu</translation>
    </message>
    <message>
        <source>Draws distant trees with fewer vertices</source>
        <translation>Crta daleka stabla s manje vrhova</translation>
    </message>
    <message>
        <source>Drift</source>
        <translation>Odlutavanje</translation>
    </message>
    <message>
        <source>Each coordinate is stored as an integer over the mesh&apos;s box</source>
        <translation>Svaka koordinata sprema se kao cijeli broj nad kvadrom mreže</translation>
    </message>
    <message>
        <source>End B</source>
        <translation>Kraj B</translation>
    </message>
    <message>
        <source>End P</source>
        <translation>Kraj P</translation>
    </message>
    <message>
        <source>End Q</source>
        <translation>Kraj Q</translation>
    </message>
    <message>
        <source>Enlarge the 105-mm photograph</source>
        <translation>Povećaj fotografiju od 105 mm</translation>
    </message>
    <message>
        <source>Enlarges the middle of the picture until things at the target&apos;s distance are as large as on the 29-mm photograph; this narrows the field of view</source>
        <translation>Povećava sredinu slike dok stvari na udaljenosti cilja ne budu velike kao na fotografiji od 29 mm; to sužava vidno polje</translation>
    </message>
    <message>
        <source>Every projector runs from a point to the eye. It meets the plane at distance d in the image of that point. The triangles between eye, axis and projector are similar, so x_p : d = x : (−z). If d is negative, the plane is behind the eye, as in a camera obscura, and the image is upside down.</source>
        <translation>Svaka zraka projiciranja ide od točke do kamere. U slici te točke siječe ravninu na udaljenosti d. Trokuti između kamere, osi i zrake projiciranja su slični, pa je x_p : d = x : (−z). Ako je d negativan, ravnina je iza kamere, kao u cameri obscuri, i slika je naopačke.</translation>
    </message>
    <message>
        <source>Exponential fog leaves exp(-density w)</source>
        <translation>Eksponencijalna magla ostavlja exp(-gustoća w)</translation>
    </message>
    <message>
        <source>Eye right of the middle</source>
        <translation>Kamera desno od sredine</translation>
    </message>
    <message>
        <source>Eye separation s</source>
        <translation>Razmak očiju s</translation>
    </message>
    <message>
        <source>F drawn wrongly</source>
        <translation>F pogrešno nacrtano</translation>
    </message>
    <message>
        <source>F missed</source>
        <translation>F nenacrtano</translation>
    </message>
    <message>
        <source>Far from the origin: move the origin.</source>
        <translation>Daleko od ishodišta: pomaknite ishodište.</translation>
    </message>
    <message>
        <source>Fewer bits make a picture smaller and quicker, and less exact. Every vertex is stored and projected with the chosen formats, and drawn where they put it. An arrow runs from each vertex&apos;s exact pixel towards the drawn one, enlarged as much as is written beside it. The bound is predicted from the formats alone, and no error is larger. A console of 1994 drew whole pixels and affine textures, and its vertices jumped whenever the camera moved.</source>
        <translation>S manje bitova slika je manja i brža, ali i manje točna. Svaki se vrh sprema i projicira u odabranim formatima i crta ondje kamo ga oni stave. Strelica ide od točnog piksela svakog vrha prema nacrtanom, povećana onoliko koliko piše uz nju. Granica se predviđa samo iz formata i nijedna pogreška nije veća. Konzola iz 1994. crtala je cijele piksele i afine teksture, a vrhovi su joj skakali kad god se kamera pomaknula.</translation>
    </message>
    <message>
        <source>Field of view</source>
        <translation>Vidno polje</translation>
    </message>
    <message>
        <source>Film distance d</source>
        <translation>Udaljenost filma d</translation>
    </message>
    <message>
        <source>Focal distance s</source>
        <translation>Udaljenost izoštravanja s</translation>
    </message>
    <message>
        <source>Focus on the post at 10 m.</source>
        <translation>Izoštrite na stup na 10 m.</translation>
    </message>
    <message>
        <source>Fog</source>
        <translation>Magla</translation>
    </message>
    <message>
        <source>Fog density</source>
        <translation>Gustoća magle</translation>
    </message>
    <message>
        <source>Fog ends at</source>
        <translation>Magla završava na</translation>
    </message>
    <message>
        <source>Fog starts at</source>
        <translation>Magla počinje na</translation>
    </message>
    <message>
        <source>Format</source>
        <translation>Format</translation>
    </message>
    <message>
        <source>Frame</source>
        <translation>Kadar</translation>
    </message>
    <message>
        <source>Free receding scale</source>
        <translation>Slobodno mjerilo dubine</translation>
    </message>
    <message>
        <source>Free scale</source>
        <translation>Slobodno mjerilo</translation>
    </message>
    <message>
        <source>Free: turn the camera yourself</source>
        <translation>Slobodno: sami okrećite kameru</translation>
    </message>
    <message>
        <source>From orthographic</source>
        <translation>Od ortogonalnog</translation>
    </message>
    <message>
        <source>From the side</source>
        <translation>Sa strane</translation>
    </message>
    <message>
        <source>From which distance on does P stand still?</source>
        <translation>Od koje udaljenosti P miruje?</translation>
    </message>
    <message>
        <source>Gap</source>
        <translation>Razmak</translation>
    </message>
    <message>
        <source>Go back until AB is drawn right.</source>
        <translation>Idite unatrag dok se AB ne nacrta ispravno.</translation>
    </message>
    <message>
        <source>Go back: which planes leave it as it is?</source>
        <translation>Vratite se: koje ga ravnine ostavljaju kakav jest?</translation>
    </message>
    <message>
        <source>Go nearer the origin: do the ways agree?</source>
        <translation>Priđite ishodištu: slažu li se načini?</translation>
    </message>
    <message>
        <source>Go nearer: does the gap stay as wide?</source>
        <translation>Priđite bliže: ostaje li procjep jednako širok?</translation>
    </message>
    <message>
        <source>Go nearer: which edges grow?</source>
        <translation>Priđite bliže: koji bridovi rastu?</translation>
    </message>
    <message>
        <source>Grid</source>
        <translation>Rešetka</translation>
    </message>
    <message>
        <source>Half-way on the screen is not half-way in the world: along an edge 1/w is linear on the screen, and so is s/w, but s is not. If a texture is interpolated linearly (affine), it bends at the diagonal of every quadrangle. Smaller triangles hide this. Twice as many parts leave more than a quarter of the error while they are few, and a quarter in the limit.</source>
        <translation>Polovica na ekranu nije polovica u svijetu: duž brida je 1/w na ekranu linearan, pa tako i s/w, ali s nije. Ako se tekstura interpolira linearno (afino), savija se na dijagonali svakog četverokuta. Manji trokuti to skrivaju. Dvostruko više dijelova ostavlja više od četvrtine pogreške dok ih je malo, a u granici četvrtinu.</translation>
    </message>
    <message>
        <source>Hardware</source>
        <translation>Hardver</translation>
    </message>
    <message>
        <source>Height of the plane</source>
        <translation>Visina ravnine</translation>
    </message>
    <message>
        <source>How a coordinate is stored; 8 to 16 bits are integers over the scene&apos;s box</source>
        <translation>Kako se sprema koordinata; 8 do 16 bitova su cijeli brojevi nad kvadrom scene</translation>
    </message>
    <message>
        <source>How a depth is stored: as an integer or as a float</source>
        <translation>Kako se sprema dubina: kao cijeli broj ili kao broj s pomičnim zarezom</translation>
    </message>
    <message>
        <source>How a pixel and its depth become a point of the world</source>
        <translation>Kako piksel i njegova dubina postaju točka svijeta</translation>
    </message>
    <message>
        <source>How colours fade into the background with distance</source>
        <translation>Kako boje s udaljenošću blijede u pozadinu</translation>
    </message>
    <message>
        <source>How distance becomes depth; infinite puts the far plane at infinity</source>
        <translation>Kako udaljenost postaje dubina; „beskonačno” stavlja daleku ravninu u beskonačnost</translation>
    </message>
    <message>
        <source>How does the error grow with the rounds?</source>
        <translation>Kako pogreška raste s krugovima?</translation>
    </message>
    <message>
        <source>How each frame finds its axes: a fast inverse square root takes bits for a logarithm, and one Newton step</source>
        <translation>Kako svaki kadar nalazi svoje osi: brzi inverzni korijen uzima bitove za logaritam, i jedan Newtonov korak</translation>
    </message>
    <message>
        <source>How far away the world&apos;s origin lies, along x: coordinates are measured from there</source>
        <translation>Koliko je daleko ishodište svijeta, duž x: koordinate se mjere odande</translation>
    </message>
    <message>
        <source>How far from the eye the world&apos;s origin lies: coordinates are measured from there</source>
        <translation>Koliko je ishodište svijeta daleko od kamere: koordinate se mjere odande</translation>
    </message>
    <message>
        <source>How far the camera has driven along the avenue</source>
        <translation>Koliko se kamera odvezla duž drvoreda</translation>
    </message>
    <message>
        <source>How far the origin of the coordinates is from the scene</source>
        <translation>Koliko je ishodište koordinata daleko od scene</translation>
    </message>
    <message>
        <source>How long receding edges are drawn</source>
        <translation>Koliko se dugi crtaju bridovi koji idu u dubinu</translation>
    </message>
    <message>
        <source>How many times the camera turns by 360°, in 360 frames each</source>
        <translation>Koliko se puta kamera okrene za 360°, svaki put u 360 kadrova</translation>
    </message>
    <message>
        <source>How the texture&apos;s coordinates are spread over a face</source>
        <translation>Kako se koordinate teksture raspoređuju po strani</translation>
    </message>
    <message>
        <source>How the two cameras look at the screen plane</source>
        <translation>Kako dvije kamere gledaju prema ravnini ekrana</translation>
    </message>
    <message>
        <source>How the two pictures are shown</source>
        <translation>Kako se prikazuju dvije slike</translation>
    </message>
    <message>
        <source>How the vertex and the eye are stored before they are subtracted</source>
        <translation>Kako se spremaju vrh i položaj kamere prije nego što se oduzmu</translation>
    </message>
    <message>
        <source>How vertices are stored and computed; the console stores 16 bits, draws whole pixels and stretches textures</source>
        <translation>Kako se vrhovi spremaju i računaju; konzola sprema 16 bitova, crta cijele piksele i rasteže teksture</translation>
    </message>
    <message>
        <source>Human eye: 120° across</source>
        <translation>Ljudsko oko: 120° u širinu</translation>
    </message>
    <message>
        <source>If you walk past a window, it stays in its wall. The frustum from your eye through it leans, and left and right of the near plane&apos;s window are no longer opposite. Things in the window&apos;s own plane keep their place in the image. Two screens side by side are two such frusta with one eye, and their pictures join without a gap.</source>
        <translation>Ako hodate pokraj prozora, on ostaje u svojem zidu. Krnja piramida od kamere kroz njega nagne se, a lijevo i desno kod prozora na bliskoj ravnini više nisu suprotni. Stvari u ravnini samog prozora zadržavaju mjesto na slici. Dva ekrana jedan uz drugi dvije su takve krnje piramide s istom kamerom, i slike im se spajaju bez procjepa.</translation>
    </message>
    <message>
        <source>Interpolation</source>
        <translation>Interpolacija</translation>
    </message>
    <message>
        <source>Inverse of P V</source>
        <translation>Inverz od P V</translation>
    </message>
    <message>
        <source>Inverse of P, then of V</source>
        <translation>Inverz od P, zatim od V</translation>
    </message>
    <message>
        <source>Is the line PQ straight in the cube?</source>
        <translation>Je li linija PQ u kocki ravna?</translation>
    </message>
    <message>
        <source>Its other end, in world coordinates</source>
        <translation>Njezin drugi kraj, u globalnim koordinatama</translation>
    </message>
    <message>
        <source>Jitter</source>
        <translation>Podrhtavanje</translation>
    </message>
    <message>
        <source>Kind of light</source>
        <translation>Vrsta svjetla</translation>
    </message>
    <message>
        <source>Lamp at a point</source>
        <translation>Svjetiljka u točki</translation>
    </message>
    <message>
        <source>Largest disc on 35-mm film that passes for a point: 0.03 mm is usual</source>
        <translation>Najveći krug na filmu od 35 mm koji prolazi kao točka: uobičajeno je 0.03 mm</translation>
    </message>
    <message>
        <source>Lens and focus</source>
        <translation>Objektiv i izoštravanje</translation>
    </message>
    <message>
        <source>Letter F</source>
        <translation>Slovo F</translation>
    </message>
    <message>
        <source>Level of detail</source>
        <translation>Razina detalja</translation>
    </message>
    <message>
        <source>Light L</source>
        <translation>Svjetlo L</translation>
    </message>
    <message>
        <source>Light enters a dark box through a small hole. The rays cross there, so the picture on the film behind the hole is upside down and left for right: h&apos; = −d·h/z. The synthetic camera has its centre in place of the hole, and its film at the same distance in front of it. The image has the same size, but it is upright: only the sign changes.</source>
        <translation>Svjetlo ulazi u tamnu kutiju kroz malu rupicu. Zrake se ondje križaju, pa je slika na filmu iza rupice naopačke, a lijevo i desno su zamijenjeni: h&apos; = −d·h/z. Sintetička kamera ima centar na mjestu rupice, a film na istoj udaljenosti ispred njega. Slika je jednako velika, ali uspravna: mijenja se samo predznak.</translation>
    </message>
    <message>
        <source>Logarithm</source>
        <translation>Logaritam</translation>
    </message>
    <message>
        <source>Lower it below the top of the F.</source>
        <translation>Spustite je ispod vrha slova F.</translation>
    </message>
    <message>
        <source>Make N small: how much stays sharp?</source>
        <translation>Smanjite N: koliko toga ostaje oštro?</translation>
    </message>
    <message>
        <source>Make d negative: what turns over?</source>
        <translation>Neka d bude negativan: što se okreće?</translation>
    </message>
    <message>
        <source>Make near larger: do they spread out?</source>
        <translation>Povećajte udaljenost bliske ravnine: razmiču li se?</translation>
    </message>
    <message>
        <source>Measure from the object: is it smooth?</source>
        <translation>Mjerite od objekta: je li glatko?</translation>
    </message>
    <message>
        <source>Monitor: 30° across</source>
        <translation>Monitor: 30° u širinu</translation>
    </message>
    <message>
        <source>Move far in: which posts are gone?</source>
        <translation>Pomaknite daleku ravninu prema sebi: kojih stupova više nema?</translation>
    </message>
    <message>
        <source>Move near and far close to it.</source>
        <translation>Pomaknite blisku i daleku ravninu do njega.</translation>
    </message>
    <message>
        <source>Move near and far past the points.</source>
        <translation>Pomaknite blisku i daleku ravninu preko točaka.</translation>
    </message>
    <message>
        <source>Move near and far: which cards cross?</source>
        <translation>Pomaknite blisku i daleku ravninu: koje ih kartice sijeku?</translation>
    </message>
    <message>
        <source>Moves the eye; the field of view keeps the sizes at the target&apos;s distance</source>
        <translation>Pomiče kameru; vidno polje čuva veličine na udaljenosti cilja</translation>
    </message>
    <message>
        <source>Nothing beyond the far plane is drawn: on a drive along the avenue, trees appear out of nothing, or vanish into it on the way back. Fog hides this if little contrast is left at the far plane. Level of detail draws far trees with fewer vertices, so that the far plane can be farther away at the same cost.</source>
        <translation>Ništa iza daleke ravnine se ne crta: pri vožnji drvoredom stabla se pojavljuju niotkuda ili na povratku u ništa nestaju. Magla to skriva ako na dalekoj ravnini ostaje malo kontrasta. Razina detalja crta daleka stabla s manje vrhova, pa uz isti trošak daleka ravnina može biti dalje.</translation>
    </message>
    <message>
        <source>Number of parts into which each side of the board is cut</source>
        <translation>Broj dijelova na koje je podijeljena svaka stranica ploče</translation>
    </message>
    <message>
        <source>Number of pieces of equal length into which the floor is cut from near to far</source>
        <translation>Broj jednako dugih komada na koje je pod izrezan od bliske do daleke ravnine</translation>
    </message>
    <message>
        <source>Numbers</source>
        <translation>Brojevi</translation>
    </message>
    <message>
        <source>Oblique box (oblique)</source>
        <translation>Kosi kvadar (kosi)</translation>
    </message>
    <message>
        <source>Oblique drawing</source>
        <translation>Kosi crtež</translation>
    </message>
    <message>
        <source>Off-axis frusta</source>
        <translation>Asimetrične krnje piramide</translation>
    </message>
    <message>
        <source>Off-axis window</source>
        <translation>Asimetrični prozor</translation>
    </message>
    <message>
        <source>One end of the segment, in world coordinates</source>
        <translation>Jedan kraj dužine, u globalnim koordinatama</translation>
    </message>
    <message>
        <source>One window</source>
        <translation>Jedan prozor</translation>
    </message>
    <message>
        <source>One window, or a wall of two screens side by side</source>
        <translation>Jedan prozor ili zid od dva ekrana jednog uz drugi</translation>
    </message>
    <message>
        <source>Only parts between light and plane cast a shadow; without clipping, parts above the light cast an anti-shadow, with w &lt; 0</source>
        <translation>Samo dijelovi između svjetla i ravnine bacaju sjenu; bez odsijecanja dijelovi iznad svjetla bacaju protusjenu, s w &lt; 0</translation>
    </message>
    <message>
        <source>Only what lies in the view volume is drawn. An eye sees a truncated cone. A perspective lens uses the pyramid around it, because a picture is a rectangle. A parallel lens has a box, straight or oblique: the view from very far away. A test point with a grey name is outside.</source>
        <translation>Crta se samo ono što leži u volumenu pogleda. Oko vidi krnji stožac. Perspektivni objektiv koristi piramidu oko njega, jer je slika pravokutnik. Paralelni objektiv ima kvadar, uspravni ili kosi: pogled s vrlo velike udaljenosti. Testna točka sa sivim imenom leži izvan.</translation>
    </message>
    <message>
        <source>P = (1 − t)·C + t·(D : 0): at the corner C for t = 0, at infinity for t = 1; above 1 it comes back from the other side</source>
        <translation>P = (1 − t)·C + t·(D : 0): u vrhu C za t = 0, u beskonačnosti za t = 1; iznad 1 vraća se s druge strane</translation>
    </message>
    <message>
        <source>P appears</source>
        <translation>P se pojavljuje</translation>
    </message>
    <message>
        <source>P is not in front of the eye, so it has no pixel</source>
        <translation>P nije ispred kamere, pa nema piksel</translation>
    </message>
    <message>
        <source>P runs along</source>
        <translation>P ide duž</translation>
    </message>
    <message>
        <source>P&apos;s image is at infinity</source>
        <translation>Slika točke P je u beskonačnosti</translation>
    </message>
    <message>
        <source>Parallel edges of the world meet in the image at the vanishing point of their direction. It lies where the ray from the eye in that direction meets the picture. A direction parallel to the picture has no vanishing point, so a box has one, two or three. As w of the point P goes to 0, P goes to infinity, and its image to the vanishing point.</source>
        <translation>Paralelni bridovi svijeta sijeku se na slici u nedogledu svojega smjera. On leži ondje gdje zraka iz kamere u tom smjeru siječe sliku. Smjer paralelan sa slikom nema nedogled, pa ih kvadar ima jedan, dva ili tri. Kako w točke P ide u 0, P ide u beskonačnost, a njezina slika u nedogled.</translation>
    </message>
    <message>
        <source>Parts a side</source>
        <translation>Dijelova po stranici</translation>
    </message>
    <message>
        <source>Perspective</source>
        <translation>Perspektivni</translation>
    </message>
    <message>
        <source>Perspective-correct interpolation</source>
        <translation>Perspektivno ispravna interpolacija</translation>
    </message>
    <message>
        <source>Phone: 5° across</source>
        <translation>Telefon: 5° u širinu</translation>
    </message>
    <message>
        <source>Photograph: 105 mm at 360 cm</source>
        <translation>Fotografija: 105 mm na 360 cm</translation>
    </message>
    <message>
        <source>Photograph: 29 mm at 30 cm</source>
        <translation>Fotografija: 29 mm na 30 cm</translation>
    </message>
    <message>
        <source>Picture</source>
        <translation>Slika</translation>
    </message>
    <message>
        <source>Pictures</source>
        <translation>Slike</translation>
    </message>
    <message>
        <source>Pieces of the floor</source>
        <translation>Komada poda</translation>
    </message>
    <message>
        <source>Planar shadow</source>
        <translation>Sjena na ravnini</translation>
    </message>
    <message>
        <source>Plane distance d</source>
        <translation>Udaljenost ravnine d</translation>
    </message>
    <message>
        <source>Planes that have cut</source>
        <translation>Ravnine koje su odsjekle</translation>
    </message>
    <message>
        <source>Play the drive: where do trees appear?</source>
        <translation>Pokrenite vožnju: gdje se pojavljuju stabla?</translation>
    </message>
    <message>
        <source>Play the frames.</source>
        <translation>Pokrenite kadrove.</translation>
    </message>
    <message>
        <source>Play “From orthographic”.</source>
        <translation>Pokrenite „Od ortogonalnog”.</translation>
    </message>
    <message>
        <source>Point P</source>
        <translation>Točka P</translation>
    </message>
    <message>
        <source>Popping at the far plane</source>
        <translation>Iskakanje na dalekoj ravnini</translation>
    </message>
    <message>
        <source>Position</source>
        <translation>Položaj</translation>
    </message>
    <message>
        <source>Position of the lamp in world coordinates, or the direction to the sun</source>
        <translation>Položaj svjetiljke u globalnim koordinatama ili smjer prema suncu</translation>
    </message>
    <message>
        <source>Pyramid (perspective)</source>
        <translation>Piramida (perspektivna)</translation>
    </message>
    <message>
        <source>Ray times depth</source>
        <translation>Zraka puta dubina</translation>
    </message>
    <message>
        <source>Receding angle</source>
        <translation>Kut dubine</translation>
    </message>
    <message>
        <source>Reciprocal 1/w</source>
        <translation>Recipročni 1/w</translation>
    </message>
    <message>
        <source>Red-cyan, for glasses</source>
        <translation>Crveno-cijan, za naočale</translation>
    </message>
    <message>
        <source>Renormalise: which numbers stay?</source>
        <translation>Renormirajte: koji brojevi ostaju?</translation>
    </message>
    <message>
        <source>Reverse the depth range: why is it better?</source>
        <translation>Okrenite raspon dubine: zašto je bolji?</translation>
    </message>
    <message>
        <source>Rounds</source>
        <translation>Krugova</translation>
    </message>
    <message>
        <source>Row of posts</source>
        <translation>Niz stupova</translation>
    </message>
    <message>
        <source>S = (p·L) I − L pᵀ, plane p = (0, 1, 0, {0}), L = ({1}, {2}, {3}, 0): the direction divided by its largest part, {4}</source>
        <translation>S = (p·L) I − L pᵀ, ravnina p = (0, 1, 0, {0}), L = ({1}, {2}, {3}, 0): smjer podijeljen svojim najvećim dijelom, {4}</translation>
    </message>
    <message>
        <source>S = (p·L) I − L pᵀ, plane p = (0, 1, 0, {0}), L = ({1}, {2}, {3}, 1)</source>
        <translation>S = (p·L) I − L pᵀ, ravnina p = (0, 1, 0, {0}), L = ({1}, {2}, {3}, 1)</translation>
    </message>
    <message>
        <source>Screen plane</source>
        <translation>Ravnina ekrana</translation>
    </message>
    <message>
        <source>Screens</source>
        <translation>Ekrani</translation>
    </message>
    <message>
        <source>Seen by</source>
        <translation>Gleda</translation>
    </message>
    <message>
        <source>Set far to 1000: how far off is the floor?</source>
        <translation>Postavite daleku ravninu na 1000: koliko je pod pogrešan?</translation>
    </message>
    <message>
        <source>Set far to 60: does it help as much?</source>
        <translation>Postavite daleku ravninu na 60: pomaže li jednako?</translation>
    </message>
    <message>
        <source>Set near to 0.1: what improves?</source>
        <translation>Postavite blisku ravninu na 0.1: što se popravlja?</translation>
    </message>
    <message>
        <source>Side by side</source>
        <translation>Jedna uz drugu</translation>
    </message>
    <message>
        <source>Similar triangles</source>
        <translation>Slični trokuti</translation>
    </message>
    <message>
        <source>Simpler from</source>
        <translation>Jednostavnija nakon</translation>
    </message>
    <message>
        <source>Simplest from</source>
        <translation>Najjednostavnija nakon</translation>
    </message>
    <message>
        <source>Snapping</source>
        <translation>Hvatanje na rešetku</translation>
    </message>
    <message>
        <source>Start A</source>
        <translation>Početak A</translation>
    </message>
    <message>
        <source>Step on: which plane adds a corner?</source>
        <translation>Idite dalje: koja ravnina dodaje vrh?</translation>
    </message>
    <message>
        <source>Stop clipping: on which side is a shadow?</source>
        <translation>Prestanite odsijecati: na kojoj je strani sjena?</translation>
    </message>
    <message>
        <source>Sun</source>
        <translation>Sunce</translation>
    </message>
    <message>
        <source>Surface 2 lies behind surface 1 by the gap, and reaches out at its side. Where the depth buffer stores both with the same code, the surface that is drawn last is seen: z-fighting. With a perspective lens and the standard range most codes lie just behind near, so near matters much more than far. When the scene opens, with its ramp, 63 % of the pixels that both cover are wrong, 0 % with near 0.1, 63 % with far 60. The picture tells codes of up to 24 bits apart exactly.</source>
        <translation>Ploha 2 leži iza plohe 1 za razmak, a sa strane viri izvan nje. Gdje spremnik dubine obje sprema istim kodom, vidi se ploha koja se crta posljednja: borba za dubinu (z-fighting). Kod perspektivnog objektiva i standardnog raspona većina kodova leži odmah iza bliske ravnine, pa je bliska ravnina mnogo važnija od daleke. Kad se scena otvori, sa svojom kosinom, pogrešno je 63 % piksela koje obje pokrivaju, 0 % s bliskom ravninom na 0.1, a 63 % s dalekom na 60. Slika egzaktno razlikuje kodove do 24 bita.</translation>
    </message>
    <message>
        <source>Switch the detail on: what is saved?</source>
        <translation>Uključite razinu detalja: što se štedi?</translation>
    </message>
    <message>
        <source>Texture</source>
        <translation>Tekstura</translation>
    </message>
    <message>
        <source>The direction D of the edge that P follows</source>
        <translation>Smjer D brida koji P slijedi</translation>
    </message>
    <message>
        <source>The eye moves to the right by 1 mm a frame, and a unit is 1 m. Far from the origin neighbouring float32 numbers are farther apart than that: the eye stands still for some frames and then jumps, and every vertex jumps with it. In the picture each frame has its own line, from top to bottom: how far P has moved across, enlarged, and pale beside it the smooth path. It helps to measure from a place nearby, or to store each coordinate in two floats.</source>
        <translation>Kamera se pomiče udesno za 1 mm po kadru, a jedinica je 1 m. Daleko od ishodišta susjedni su brojevi float32 razmaknuti više od toga: kamera nekoliko kadrova stoji, pa skoči, a s njom skače i svaki vrh. Na slici svaki kadar ima svoju crtu, odozgo prema dolje: koliko se P pomaknula u širinu, povećano, a blijedo uz nju glatki put. Pomaže mjeriti od nekog mjesta u blizini ili svaku koordinatu spremiti u dva broja float.</translation>
    </message>
    <message>
        <source>The f-number: the lens is opened to f / N, and no lens opens wider than f / 0.5</source>
        <translation>F-broj: objektiv je otvoren do f / N, a nijedan se ne otvara šire od f / 0.5</translation>
    </message>
    <message>
        <source>The faces with AB over them, or the edges alone, drawn in one of the three ways</source>
        <translation>Strane s AB preko njih ili sami bridovi, nacrtani na jedan od tri načina</translation>
    </message>
    <message>
        <source>The format of every number, sum, product and quotient</source>
        <translation>Format svakog broja, zbroja, umnoška i kvocijenta</translation>
    </message>
    <message>
        <source>The format of every sum, product and quotient</source>
        <translation>Format svakog zbroja, umnoška i kvocijenta</translation>
    </message>
    <message>
        <source>The format of every sum, product and root</source>
        <translation>Format svakog zbroja, umnoška i korijena</translation>
    </message>
    <message>
        <source>The grid of the pixels at which vertices are drawn</source>
        <translation>Rešetka piksela na kojima se crtaju vrhovi</translation>
    </message>
    <message>
        <source>The grid on which the vertices of a mesh are stored</source>
        <translation>Rešetka na kojoj se spremaju vrhovi mreže</translation>
    </message>
    <message>
        <source>The point whose pixel and depth are known; a click in the image chooses it</source>
        <translation>Točka čiji su piksel i dubina poznati; bira se klikom na slici</translation>
    </message>
    <message>
        <source>The point whose places are compared: parallax is that in the right picture minus that in the left one</source>
        <translation>Točka čija se mjesta uspoređuju: paralaksa je mjesto na desnoj slici minus mjesto na lijevoj</translation>
    </message>
    <message>
        <source>The point whose projector is followed</source>
        <translation>Točka čija se zraka projiciranja slijedi</translation>
    </message>
    <message>
        <source>The synthetic camera has a point as its lens, and its whole picture is sharp. A real lens draws only points at the focal distance as points, and all others as discs. Between the two limits the discs are no larger than the circle of confusion and pass for points: sharp posts are outlined. The picture is the average of pinhole pictures from all over the lens, and becomes finer while nothing changes. One world unit is 1 m.</source>
        <translation>Sintetička kamera ima točku kao objektiv i cijela joj je slika oštra. Pravi objektiv crta kao točke samo one na udaljenosti izoštravanja, a sve ostale kao krugove. Između dviju granica krugovi nisu veći od kruga konfuzije i prolaze kao točke: oštri stupovi su obrubljeni. Slika je prosjek slika kroz rupice po cijelom objektivu i postaje finija dok se ništa ne mijenja. Jedna jedinica svijeta je 1 m.</translation>
    </message>
    <message>
        <source>Toe the cameras in: is P still level?</source>
        <translation>Okrenite kamere jednu prema drugoj: je li P još na istoj visini?</translation>
    </message>
    <message>
        <source>Toed in</source>
        <translation>Okrenute jedna prema drugoj</translation>
    </message>
    <message>
        <source>Turn the azimuth: when is V at infinity?</source>
        <translation>Okrećite azimut: kada je V u beskonačnosti?</translation>
    </message>
    <message>
        <source>Turn the camera slowly: what jumps?</source>
        <translation>Polako okrećite kameru: što skače?</translation>
    </message>
    <message>
        <source>Turned by</source>
        <translation>Okrenuto za</translation>
    </message>
    <message>
        <source>Turns the camera about its target</source>
        <translation>Okreće kameru oko cilja</translation>
    </message>
    <message>
        <source>Two eyes</source>
        <translation>Dva oka</translation>
    </message>
    <message>
        <source>Two eyes see the world from two places, and so a stereo pair has two pictures. With off-axis frusta both eyes look through one window, the screen plane: what lies in it does not move between the pictures, what is behind it moves right, and what is before it moves left. Cameras that are toed in to the screen&apos;s middle tilt their pictures against each other, and points at the sides are no longer equally high. A red-cyan picture takes its red light from the left eye&apos;s and the rest from the right eye&apos;s, for glasses with red on the left.</source>
        <translation>Dva oka vide svijet s dva mjesta, pa stereopar ima dvije slike. Kod asimetričnih krnjih piramida oba oka gledaju kroz isti prozor, ravninu ekrana: što leži u njoj, ne pomiče se između slika, što je iza nje, pomiče se udesno, a što je ispred nje, ulijevo. Kamere okrenute prema sredini ekrana naginju slike jednu prema drugoj, i točke sa strana više nisu na istoj visini. Crveno-cijan slika uzima crveno svjetlo iz slike lijevog oka, a ostalo iz slike desnoga, za naočale s crvenim lijevo.</translation>
    </message>
    <message>
        <source>Two meshes share a seam. Each stores its vertices in few bits over its own box, and so rounds the same place in its own way: light comes through. The gap is at most half of both steps together along each axis. In a common grid both round alike, and nothing gapes, though the smaller mesh loses its finer steps.</source>
        <translation>Dvije mreže dijele šav. Svaka sprema svoje vrhove u malo bitova nad vlastitim kvadrom, pa isto mjesto zaokružuje na svoj način: svjetlo prolazi. Procjep je duž svake osi najviše polovica zbroja obaju koraka. Na zajedničkoj rešetki obje zaokružuju jednako i ništa ne zjapi, premda manja mreža gubi svoje finije korake.</translation>
    </message>
    <message>
        <source>Unit cube</source>
        <translation>Jedinična kocka</translation>
    </message>
    <message>
        <source>Up to which frame the path is drawn</source>
        <translation>Do kojeg se kadra crta put</translation>
    </message>
    <message>
        <source>V_x of edges along x</source>
        <translation>V_x bridova duž x</translation>
    </message>
    <message>
        <source>V_y of edges along y</source>
        <translation>V_y bridova duž y</translation>
    </message>
    <message>
        <source>V_z of edges along z</source>
        <translation>V_z bridova duž z</translation>
    </message>
    <message>
        <source>V_{0} is at infinity: edges along {0} stay parallel, at {1}° from the right</source>
        <translation>V_{0} je u beskonačnosti: bridovi duž {0} ostaju paralelni, pod {1}° od desne strane</translation>
    </message>
    <message>
        <source>Vanishing points</source>
        <translation>Nedogledi</translation>
    </message>
    <message>
        <source>Vertices</source>
        <translation>Vrhovi</translation>
    </message>
    <message>
        <source>View volume</source>
        <translation>Volumen pogleda</translation>
    </message>
    <message>
        <source>View volumes</source>
        <translation>Volumeni pogleda</translation>
    </message>
    <message>
        <source>Walk past the window: drag the eye.</source>
        <translation>Prođite pokraj prozora: povucite kameru.</translation>
    </message>
    <message>
        <source>Walk round it: drag the azimuth.</source>
        <translation>Obiđite je: povucite azimut.</translation>
    </message>
    <message>
        <source>Way back</source>
        <translation>Put natrag</translation>
    </message>
    <message>
        <source>What does cutting before the divide do?</source>
        <translation>Što čini odsijecanje prije dijeljenja?</translation>
    </message>
    <message>
        <source>What happens in the cube?</source>
        <translation>Što se događa u kocki?</translation>
    </message>
    <message>
        <source>What happens to its shape in the cube?</source>
        <translation>Što u kocki biva s njezinim oblikom?</translation>
    </message>
    <message>
        <source>What happens to the picture?</source>
        <translation>Što se događa sa slikom?</translation>
    </message>
    <message>
        <source>What stays in its place in the image?</source>
        <translation>Što na slici ostaje na svojem mjestu?</translation>
    </message>
    <message>
        <source>When is everything far away sharp?</source>
        <translation>Kada je sve daleko oštro?</translation>
    </message>
    <message>
        <source>Where do both pictures agree?</source>
        <translation>Gdje se obje slike slažu?</translation>
    </message>
    <message>
        <source>Where does the texture bend?</source>
        <translation>Gdje se tekstura savija?</translation>
    </message>
    <message>
        <source>Where in the cube do the posts crowd?</source>
        <translation>Gdje se u kocki stupovi gomilaju?</translation>
    </message>
    <message>
        <source>Where it ends; behind the eye its image is mirrored</source>
        <translation>Gdje završava; iza kamere slika mu je zrcaljena</translation>
    </message>
    <message>
        <source>Where the logarithm of the distance is computed</source>
        <translation>Gdje se računa logaritam udaljenosti</translation>
    </message>
    <message>
        <source>Where the segment starts, in world coordinates</source>
        <translation>Gdje dužina počinje, u globalnim koordinatama</translation>
    </message>
    <message>
        <source>Which edges are parallel in the picture?</source>
        <translation>Koji su bridovi na slici paralelni?</translation>
    </message>
    <message>
        <source>Which edges meet, and where?</source>
        <translation>Koji se bridovi sijeku, i gdje?</translation>
    </message>
    <message>
        <source>Which faces keep their shape?</source>
        <translation>Koje strane zadržavaju oblik?</translation>
    </message>
    <message>
        <source>Which of A to E are inside now?</source>
        <translation>Koje su točke od A do E sada unutra?</translation>
    </message>
    <message>
        <source>Which parts grow when you come near?</source>
        <translation>Koji dijelovi rastu kad se približite?</translation>
    </message>
    <message>
        <source>Which way does the frustum lean?</source>
        <translation>Na koju se stranu naginje krnja piramida?</translation>
    </message>
    <message>
        <source>Width of the left mesh</source>
        <translation>Širina lijeve mreže</translation>
    </message>
    <message>
        <source>Width of the left mesh&apos;s box, whose steps grow with it</source>
        <translation>Širina kvadra lijeve mreže, s kojom rastu njezini koraci</translation>
    </message>
    <message>
        <source>Width of the right mesh</source>
        <translation>Širina desne mreže</translation>
    </message>
    <message>
        <source>Width of the right mesh&apos;s box, whose steps grow with it</source>
        <translation>Širina kvadra desne mreže, s kojom rastu njezini koraci</translation>
    </message>
    <message>
        <source>With a wider field of view the camera must be nearer to show the subject at the same size. Its near parts then look larger compared with its far parts: foreshortening depends on the distance alone. If you change the distance, the field of view follows, so that things at the target&apos;s distance keep their size (a dolly zoom). One unit is 10 cm.</source>
        <translation>Sa širim vidnim poljem kamera mora biti bliže da prikaže motiv jednako velikim. Njegovi bliži dijelovi tada izgledaju veći u odnosu na udaljenije: perspektivno skraćenje ovisi samo o udaljenosti. Ako promijenite udaljenost, vidno polje to slijedi, tako da stvari na udaljenosti cilja zadržavaju veličinu (dolly zoom). Jedna jedinica je 10 cm.</translation>
    </message>
    <message>
        <source>World y of the plane; at most 0, where the object stands</source>
        <translation>Globalni y ravnine; najviše 0, gdje objekt stoji</translation>
    </message>
    <message>
        <source>Your mesh</source>
        <translation>Vaša mreža</translation>
    </message>
    <message>
        <source>a corner is behind the eye: until near has cut, there is nothing to draw in NDC</source>
        <translation>jedan vrh je iza kamere: dok ga bliska ravnina ne odsiječe, u NDC nema ničega za crtanje</translation>
    </message>
    <message>
        <source>a logarithmic depth buffer needs a perspective lens and a far plane that is not at infinity</source>
        <translation>logaritamski spremnik dubine treba perspektivni objektiv i daleku ravninu koja nije u beskonačnosti</translation>
    </message>
    <message>
        <source>a logarithmic depth needs a far plane that is not at infinity</source>
        <translation>logaritamska dubina treba daleku ravninu koja nije u beskonačnosti</translation>
    </message>
    <message>
        <source>a parallel lens cannot have its far plane at infinity</source>
        <translation>paralelni objektiv ne može imati daleku ravninu u beskonačnosti</translation>
    </message>
    <message>
        <source>a parallel lens divides by 1 and has no eye plane: choose a perspective lens</source>
        <translation>paralelni objektiv dijeli s 1 i nema ravninu kamere: odaberite perspektivni objektiv</translation>
    </message>
    <message>
        <source>a parallel lens divides by 1: its own z&apos; is affine, and nothing is bent</source>
        <translation>paralelni objektiv dijeli s 1: njegov z&apos; je afin i ništa se ne savija</translation>
    </message>
    <message>
        <source>a parallel lens has no eye in which a cone could start: its own volume is shown</source>
        <translation>paralelni objektiv nema točku u kojoj bi stožac počinjao: prikazuje se njegov vlastiti volumen</translation>
    </message>
    <message>
        <source>a parallel lens has no field of view, only a width</source>
        <translation>paralelni objektiv nema vidno polje, samo širinu</translation>
    </message>
    <message>
        <source>a parallel lens has no focal length: choose a perspective lens to focus it</source>
        <translation>paralelni objektiv nema žarišnu duljinu: odaberite perspektivni objektiv da ga izoštrite</translation>
    </message>
    <message>
        <source>a parallel lens has no hole through which all light passes: choose a perspective lens</source>
        <translation>paralelni objektiv nema rupicu kroz koju prolazi sve svjetlo: odaberite perspektivni objektiv</translation>
    </message>
    <message>
        <source>a perspective lens draws equal edges with unequal lengths: choose the oblique lens</source>
        <translation>perspektivni objektiv crta jednake bridove nejednakih duljina: odaberite kosi objektiv</translation>
    </message>
    <message>
        <source>a step is so long that it may lead past the eye: there is no bound</source>
        <translation>korak je tako dug da može voditi iza kamere: nema granice</translation>
    </message>
    <message>
        <source>a vertex of the picture has come behind the drifted camera</source>
        <translation>jedan vrh slike došao je iza odlutale kamere</translation>
    </message>
    <message>
        <source>affine</source>
        <translation>afino</translation>
    </message>
    <message>
        <source>affine: s linear on the screen</source>
        <translation>afino: s linearno na ekranu</translation>
    </message>
    <message>
        <source>all</source>
        <translation>sve</translation>
    </message>
    <message>
        <source>an axis is too long or too short by up to</source>
        <translation>os je preduga ili prekratka za najviše</translation>
    </message>
    <message>
        <source>an axis leans by up to</source>
        <translation>os je nagnuta za najviše</translation>
    </message>
    <message>
        <source>arrows in the image, enlarged</source>
        <translation>strelice na slici, povećane</translation>
    </message>
    <message>
        <source>as drawn</source>
        <translation>kako je nacrtano</translation>
    </message>
    <message>
        <source>at each pixel</source>
        <translation>u svakom pikselu</translation>
    </message>
    <message>
        <source>at each vertex</source>
        <translation>u svakom vrhu</translation>
    </message>
    <message>
        <source>axis</source>
        <translation>os</translation>
    </message>
    <message>
        <source>before the screen</source>
        <translation>ispred ekrana</translation>
    </message>
    <message>
        <source>behind the screen</source>
        <translation>iza ekrana</translation>
    </message>
    <message>
        <source>bfloat16</source>
        <translation>bfloat16</translation>
    </message>
    <message>
        <source>blur disc</source>
        <translation>krug neoštrine</translation>
    </message>
    <message>
        <source>blur disc on the film</source>
        <translation>krug neoštrine na filmu</translation>
    </message>
    <message>
        <source>blur of the target</source>
        <translation>neoštrina cilja</translation>
    </message>
    <message>
        <source>both agree only if the lens&apos;s axis meets the middle of the picture; here it meets ({0}, {1}) px, and their sum is twice that</source>
        <translation>oba se slažu samo ako os objektiva pogađa sredinu slike; ovdje pogađa ({0}, {1}) px, a njihov je zbroj dvostruko veći</translation>
    </message>
    <message>
        <source>bottom</source>
        <translation>donja</translation>
    </message>
    <message>
        <source>bound of the error</source>
        <translation>granica pogreške</translation>
    </message>
    <message>
        <source>bytes a vertex</source>
        <translation>bajtova po vrhu</translation>
    </message>
    <message>
        <source>cards crossing: to be cut</source>
        <translation>kartice koje sijeku: treba ih odsjeći</translation>
    </message>
    <message>
        <source>cards outside</source>
        <translation>kartice cijele izvan</translation>
    </message>
    <message>
        <source>cards whole inside</source>
        <translation>kartice cijele unutra</translation>
    </message>
    <message>
        <source>case, by the cut at z = −0.01</source>
        <translation>slučaj, po odsijecanju kod z = −0.01</translation>
    </message>
    <message>
        <source>cheap</source>
        <translation>jeftino</translation>
    </message>
    <message>
        <source>checks</source>
        <translation>kvadratići</translation>
    </message>
    <message>
        <source>circle of confusion</source>
        <translation>krug konfuzije</translation>
    </message>
    <message>
        <source>clip coordinates are too large for float64 numbers, or lie on one ray of the eye</source>
        <translation>koordinate odsijecanja prevelike su za brojeve float64 ili leže na istoj zraci kamere</translation>
    </message>
    <message>
        <source>clipped</source>
        <translation>odsječeno homogeno</translation>
    </message>
    <message>
        <source>clipped, then divided</source>
        <translation>odsječeno homogeno, zatim dijeljeno</translation>
    </message>
    <message>
        <source>codes of the buffer</source>
        <translation>kodovi spremnika</translation>
    </message>
    <message>
        <source>common grid</source>
        <translation>zajednička rešetka</translation>
    </message>
    <message>
        <source>computed: gap and codes are finer than the graphics card&apos;s float32, so the picture shows its noise instead</source>
        <translation>izračunano: razmak i kodovi finiji su od tipa float32 grafičke kartice, pa slika umjesto toga pokazuje njezin šum</translation>
    </message>
    <message>
        <source>contrast left where they pop</source>
        <translation>preostali kontrast gdje iskaču</translation>
    </message>
    <message>
        <source>corners after it</source>
        <translation>vrhovi nakon nje</translation>
    </message>
    <message>
        <source>corners before it</source>
        <translation>vrhovi prije nje</translation>
    </message>
    <message>
        <source>correct</source>
        <translation>točno</translation>
    </message>
    <message>
        <source>correct: s/w and 1/w, divided</source>
        <translation>točno: s/w i 1/w, podijeljeno</translation>
    </message>
    <message>
        <source>cut</source>
        <translation>odsječeno</translation>
    </message>
    <message>
        <source>cut at z = −0.01</source>
        <translation>odsječeno kod z = −0.01</translation>
    </message>
    <message>
        <source>d over w, 32 of the codes</source>
        <translation>d u ovisnosti o w, 32 od svih kodova</translation>
    </message>
    <message>
        <source>depth of field</source>
        <translation>dubinska oštrina</translation>
    </message>
    <message>
        <source>depth z&apos; = A + B/z along the marked edge is, too</source>
        <translation>dubina z&apos; = A + B/z duž označenog brida također</translation>
    </message>
    <message>
        <source>diameter, mm</source>
        <translation>promjer, mm</translation>
    </message>
    <message>
        <source>distance d to the target</source>
        <translation>udaljenost d do cilja</translation>
    </message>
    <message>
        <source>distance of the target, w</source>
        <translation>udaljenost cilja, w</translation>
    </message>
    <message>
        <source>distance, m</source>
        <translation>udaljenost, m</translation>
    </message>
    <message>
        <source>divided, not cut</source>
        <translation>dijeljeno, bez odsijecanja</translation>
    </message>
    <message>
        <source>drawn at</source>
        <translation>nacrtani w</translation>
    </message>
    <message>
        <source>drawn by P V, off by</source>
        <translation>nacrtano s P V, pogreška</translation>
    </message>
    <message>
        <source>drawn by V, then P, off by</source>
        <translation>nacrtano s V, zatim P, pogreška</translation>
    </message>
    <message>
        <source>drawn floor</source>
        <translation>nacrtani pod</translation>
    </message>
    <message>
        <source>drift drawn, enlarged</source>
        <translation>nacrtano odlutavanje, povećano</translation>
    </message>
    <message>
        <source>each camera turns in by</source>
        <translation>svaka se kamera okreće prema unutra za</translation>
    </message>
    <message>
        <source>each mesh its own</source>
        <translation>svaka mreža svoju</translation>
    </message>
    <message>
        <source>each pixel</source>
        <translation>svaki piksel</translation>
    </message>
    <message>
        <source>each vertex</source>
        <translation>svaki vrh</translation>
    </message>
    <message>
        <source>edges along {0} are seen end on, as points</source>
        <translation>bridovi duž {0} vide se s kraja, kao točke</translation>
    </message>
    <message>
        <source>edges of the mesh that are counted, and all</source>
        <translation>bridovi mreže koji se broje, i svi</translation>
    </message>
    <message>
        <source>error of P</source>
        <translation>pogreška točke P</translation>
    </message>
    <message>
        <source>error of a jump, measured</source>
        <translation>pogreška skoka, izmjerena</translation>
    </message>
    <message>
        <source>error of a jump, predicted</source>
        <translation>pogreška skoka, predviđena</translation>
    </message>
    <message>
        <source>error of the join</source>
        <translation>pogreška spoja</translation>
    </message>
    <message>
        <source>error, of the distance</source>
        <translation>pogreška, u dijelovima udaljenosti</translation>
    </message>
    <message>
        <source>error, px</source>
        <translation>pogreška, px</translation>
    </message>
    <message>
        <source>every vertex is as high as the light or higher: none has a shadow on the plane</source>
        <translation>svaki je vrh visok kao svjetlo ili viši: nijedan nema sjenu na ravnini</translation>
    </message>
    <message>
        <source>everything from the target to the far plane may share its code</source>
        <translation>sve od cilja do daleke ravnine može imati isti kod</translation>
    </message>
    <message>
        <source>exact</source>
        <translation>egzaktno</translation>
    </message>
    <message>
        <source>exponential, by its density</source>
        <translation>eksponencijalna, po gustoći</translation>
    </message>
    <message>
        <source>faces, with both images of AB</source>
        <translation>strane, s objema slikama dužine AB</translation>
    </message>
    <message>
        <source>far</source>
        <translation>daleka</translation>
    </message>
    <message>
        <source>far is infinite, and so is the volume</source>
        <translation>daleka ravnina je u beskonačnosti, pa tako i volumen</translation>
    </message>
    <message>
        <source>farthest</source>
        <translation>najudaljenije</translation>
    </message>
    <message>
        <source>farthest that a vertex of the right seam moves</source>
        <translation>najviše što se pomakne vrh desnog šava</translation>
    </message>
    <message>
        <source>fast root</source>
        <translation>brzi korijen</translation>
    </message>
    <message>
        <source>film</source>
        <translation>film</translation>
    </message>
    <message>
        <source>film in front: +d·h / z</source>
        <translation>film sprijeda: +d·h / z</translation>
    </message>
    <message>
        <source>fixed point 16.16</source>
        <translation>nepomični zarez 16.16</translation>
    </message>
    <message>
        <source>float of 16 bits</source>
        <translation>float od 16 bitova</translation>
    </message>
    <message>
        <source>float of 32 bits</source>
        <translation>float od 32 bita</translation>
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
        <translation>float32, daleko od ishodišta</translation>
    </message>
    <message>
        <source>float32, from the object</source>
        <translation>float32, od objekta</translation>
    </message>
    <message>
        <source>float32, from the origin</source>
        <translation>float32, od ishodišta</translation>
    </message>
    <message>
        <source>float64</source>
        <translation>float64</translation>
    </message>
    <message>
        <source>floor</source>
        <translation>pod</translation>
    </message>
    <message>
        <source>focal length f</source>
        <translation>žarišna duljina f</translation>
    </message>
    <message>
        <source>focal length, 35-mm camera</source>
        <translation>žarišna duljina, film od 35 mm</translation>
    </message>
    <message>
        <source>foreshortening, nearest : farthest</source>
        <translation>skraćenje, najbliže : najudaljenije</translation>
    </message>
    <message>
        <source>found point</source>
        <translation>nađena točka</translation>
    </message>
    <message>
        <source>foundation</source>
        <translation>temelj</translation>
    </message>
    <message>
        <source>frame size minus right end</source>
        <translation>širina kadra minus desni kraj</translation>
    </message>
    <message>
        <source>frames in which P stands still</source>
        <translation>kadrova u kojima P miruje</translation>
    </message>
    <message>
        <source>from P to V</source>
        <translation>od P do V</translation>
    </message>
    <message>
        <source>from there to the ray&apos;s end</source>
        <translation>odande do kraja zrake</translation>
    </message>
    <message>
        <source>half floats</source>
        <translation>polovična preciznost</translation>
    </message>
    <message>
        <source>half-way along the marked edge on the screen, in the world, from its nearer end</source>
        <translation>polovica označenog brida na ekranu, u svijetu, od bližeg kraja</translation>
    </message>
    <message>
        <source>hole</source>
        <translation>rupica</translation>
    </message>
    <message>
        <source>horizon</source>
        <translation>horizont</translation>
    </message>
    <message>
        <source>horizontal field of view</source>
        <translation>horizontalno vidno polje</translation>
    </message>
    <message>
        <source>horizontal parallax of P</source>
        <translation>horizontalna paralaksa točke P</translation>
    </message>
    <message>
        <source>hyperfocal distance H</source>
        <translation>hiperfokalna udaljenost H</translation>
    </message>
    <message>
        <source>if w were linear</source>
        <translation>kad bi w bio linearan</translation>
    </message>
    <message>
        <source>image of AB</source>
        <translation>slika AB</translation>
    </message>
    <message>
        <source>image of P</source>
        <translation>slika točke P</translation>
    </message>
    <message>
        <source>in focus</source>
        <translation>izoštreno</translation>
    </message>
    <message>
        <source>in its own plane</source>
        <translation>u vlastitoj ravnini</translation>
    </message>
    <message>
        <source>in the screen</source>
        <translation>u ekranu</translation>
    </message>
    <message>
        <source>inverse of P V</source>
        <translation>inverz od P V</translation>
    </message>
    <message>
        <source>it keeps</source>
        <translation>zadržava</translation>
    </message>
    <message>
        <source>its distance z from the hole</source>
        <translation>njezina udaljenost z od rupice</translation>
    </message>
    <message>
        <source>its height in the plane through the target is not in the picture</source>
        <translation>njegova visina u ravnini kroz cilj nije na slici</translation>
    </message>
    <message>
        <source>its image is straight, so no place is the farthest</source>
        <translation>slika mu je ravna, pa nijedno mjesto nije najudaljenije</translation>
    </message>
    <message>
        <source>its shadow S·P / w</source>
        <translation>njezina sjena S·P / w</translation>
    </message>
    <message>
        <source>its volume, cubic units</source>
        <translation>njegov volumen, kubnih jedinica</translation>
    </message>
    <message>
        <source>join</source>
        <translation>spoj</translation>
    </message>
    <message>
        <source>keep x</source>
        <translation>zadrži x</translation>
    </message>
    <message>
        <source>keep y</source>
        <translation>zadrži y</translation>
    </message>
    <message>
        <source>kind of projection</source>
        <translation>vrsta projekcije</translation>
    </message>
    <message>
        <source>largest deviation, of the length</source>
        <translation>najveće odstupanje, od duljine</translation>
    </message>
    <message>
        <source>largest error of affine, in texels of 256</source>
        <translation>najveća pogreška afine, u tekselima od 256</translation>
    </message>
    <message>
        <source>largest error of affine, on the screen</source>
        <translation>najveća pogreška afine, na ekranu</translation>
    </message>
    <message>
        <source>largest error, by the format of the vertices</source>
        <translation>najveća pogreška, po formatu vrhova</translation>
    </message>
    <message>
        <source>largest error, measured</source>
        <translation>najveća pogreška, izmjerena</translation>
    </message>
    <message>
        <source>largest error, predicted</source>
        <translation>najveća pogreška, predviđena</translation>
    </message>
    <message>
        <source>largest gap, measured</source>
        <translation>najveći procjep, izmjeren</translation>
    </message>
    <message>
        <source>largest gap, predicted</source>
        <translation>najveći procjep, predviđen</translation>
    </message>
    <message>
        <source>largest jump of P between two frames</source>
        <translation>najveći skok točke P između dvaju kadrova</translation>
    </message>
    <message>
        <source>largest vertical parallax in the screen plane</source>
        <translation>najveća vertikalna paralaksa u ravnini ekrana</translation>
    </message>
    <message>
        <source>left</source>
        <translation>lijeva</translation>
    </message>
    <message>
        <source>left eye</source>
        <translation>lijevo oko</translation>
    </message>
    <message>
        <source>left mesh</source>
        <translation>lijeva mreža</translation>
    </message>
    <message>
        <source>left screen</source>
        <translation>lijevi ekran</translation>
    </message>
    <message>
        <source>light</source>
        <translation>svjetlo</translation>
    </message>
    <message>
        <source>linear, from start to end</source>
        <translation>linearna, od početka do kraja</translation>
    </message>
    <message>
        <source>logarithmic</source>
        <translation>logaritamski</translation>
    </message>
    <message>
        <source>measured</source>
        <translation>izmjereno</translation>
    </message>
    <message>
        <source>mesh drawn wrongly</source>
        <translation>mreža pogrešno nacrtana</translation>
    </message>
    <message>
        <source>mesh missed</source>
        <translation>mreža nenacrtana</translation>
    </message>
    <message>
        <source>mirrored end</source>
        <translation>zrcaljeni kraj</translation>
    </message>
    <message>
        <source>naive</source>
        <translation>naivno</translation>
    </message>
    <message>
        <source>naive divide</source>
        <translation>naivno dijeljenje</translation>
    </message>
    <message>
        <source>near</source>
        <translation>bliska</translation>
    </message>
    <message>
        <source>nearest</source>
        <translation>najbliže</translation>
    </message>
    <message>
        <source>no edge of the letter lies in the view volume</source>
        <translation>nijedan brid slova ne leži u volumenu pogleda</translation>
    </message>
    <message>
        <source>no end is behind the eye, so none is mirrored</source>
        <translation>nijedan kraj nije iza kamere, pa nijedan nije zrcaljen</translation>
    </message>
    <message>
        <source>no lens makes a cone: everything in the pyramid around it is drawn</source>
        <translation>nijedan objektiv ne čini stožac: crta se sve u piramidi oko njega</translation>
    </message>
    <message>
        <source>no pixel of the picture shows both surfaces</source>
        <translation>nijedan piksel slike ne pokazuje obje plohe</translation>
    </message>
    <message>
        <source>no tree passes the far plane in the picture</source>
        <translation>nijedno stablo ne prolazi na slici kroz daleku ravninu</translation>
    </message>
    <message>
        <source>no vertex of the scene is in the picture</source>
        <translation>nijedan vrh scene nije na slici</translation>
    </message>
    <message>
        <source>none</source>
        <translation>nema</translation>
    </message>
    <message>
        <source>none of the examined edges of the mesh lies in the view volume</source>
        <translation>nijedan ispitani brid mreže ne leži u volumenu pogleda</translation>
    </message>
    <message>
        <source>none of the subject&apos;s compared points is in the picture</source>
        <translation>nijedna uspoređena točka motiva nije na slici</translation>
    </message>
    <message>
        <source>none yet</source>
        <translation>još nijedna</translation>
    </message>
    <message>
        <source>nothing of the subject is in the picture</source>
        <translation>ništa od motiva nije na slici</translation>
    </message>
    <message>
        <source>of P: (x, y, z, −z/d)</source>
        <translation>od P: (x, y, z, −z/d)</translation>
    </message>
    <message>
        <source>of {0} vertices</source>
        <translation>od vrhova: {0}</translation>
    </message>
    <message>
        <source>off the axis, ({r} + {l})/({r} − {l})</source>
        <translation>odmak od osi, ({r} + {l})/({r} − {l})</translation>
    </message>
    <message>
        <source>off-axis</source>
        <translation>asimetrične</translation>
    </message>
    <message>
        <source>on the film: h&apos; = −d·h / z</source>
        <translation>na filmu: h&apos; = −d·h / z</translation>
    </message>
    <message>
        <source>one for both</source>
        <translation>jedna za obje</translation>
    </message>
    <message>
        <source>only the {0} longest of the mesh&apos;s {1} edges are drawn and counted</source>
        <translation>crtaju se i broje samo najdulji bridovi ({0} od {1}) mreže</translation>
    </message>
    <message>
        <source>only {0} of the mesh&apos;s {1} edges are drawn and counted: first those that cross the eye plane, then the longest</source>
        <translation>crta se i broji samo dio bridova mreže ({0} od {1}): najprije oni koji sijeku ravninu kamere, zatim najdulji</translation>
    </message>
    <message>
        <source>opening f / N</source>
        <translation>otvor f / N</translation>
    </message>
    <message>
        <source>own boxes</source>
        <translation>vlastiti kvadri</translation>
    </message>
    <message>
        <source>parallel projection</source>
        <translation>paralelna projekcija</translation>
    </message>
    <message>
        <source>part of the subject is beside the eye or behind it</source>
        <translation>dio motiva je pokraj kamere ili iza nje</translation>
    </message>
    <message>
        <source>path in the image, enlarged</source>
        <translation>put na slici, povećan</translation>
    </message>
    <message>
        <source>pixels that show surface 2, which is behind</source>
        <translation>piksela koji pokazuju plohu 2, koja je iza</translation>
    </message>
    <message>
        <source>plane of this step</source>
        <translation>ravnina ovog koraka</translation>
    </message>
    <message>
        <source>predicted</source>
        <translation>predviđeno</translation>
    </message>
    <message>
        <source>products</source>
        <translation>umnošci</translation>
    </message>
    <message>
        <source>products alone</source>
        <translation>samo umnošci</translation>
    </message>
    <message>
        <source>products, fast inverse root</source>
        <translation>umnošci, brzi inverzni korijen</translation>
    </message>
    <message>
        <source>products, renormalised</source>
        <translation>umnošci, renormirano</translation>
    </message>
    <message>
        <source>projection, with −1/d</source>
        <translation>projekcija, s −1/d</translation>
    </message>
    <message>
        <source>px</source>
        <translation>px</translation>
    </message>
    <message>
        <source>ray times depth</source>
        <translation>zraka puta dubina</translation>
    </message>
    <message>
        <source>receding angle as drawn</source>
        <translation>nacrtani kut dubine</translation>
    </message>
    <message>
        <source>receding edges are seen end on, as points</source>
        <translation>bridovi koji idu u dubinu vide se s kraja, kao točke</translation>
    </message>
    <message>
        <source>receding scale as drawn</source>
        <translation>nacrtano mjerilo dubine</translation>
    </message>
    <message>
        <source>renormalised</source>
        <translation>renormirano</translation>
    </message>
    <message>
        <source>reversed, 1 at near</source>
        <translation>obrnuti, 1 na bliskoj</translation>
    </message>
    <message>
        <source>right</source>
        <translation>desna</translation>
    </message>
    <message>
        <source>right eye</source>
        <translation>desno oko</translation>
    </message>
    <message>
        <source>right mesh</source>
        <translation>desna mreža</translation>
    </message>
    <message>
        <source>right screen</source>
        <translation>desni ekran</translation>
    </message>
    <message>
        <source>s red, t green</source>
        <translation>s crveno, t zeleno</translation>
    </message>
    <message>
        <source>scale d / −z</source>
        <translation>mjerilo d / −z</translation>
    </message>
    <message>
        <source>screen plane</source>
        <translation>ravnina ekrana</translation>
    </message>
    <message>
        <source>seam</source>
        <translation>šav</translation>
    </message>
    <message>
        <source>sharp</source>
        <translation>oštro</translation>
    </message>
    <message>
        <source>sharp from</source>
        <translation>oštro od</translation>
    </message>
    <message>
        <source>sharp to</source>
        <translation>oštro do</translation>
    </message>
    <message>
        <source>sine and cosine of the angle</source>
        <translation>sinus i kosinus kuta</translation>
    </message>
    <message>
        <source>smallest gap that is sure at the target</source>
        <translation>najmanji razmak koji je kod cilja siguran</translation>
    </message>
    <message>
        <source>smooth jump</source>
        <translation>glatki skok</translation>
    </message>
    <message>
        <source>smooth path</source>
        <translation>glatki put</translation>
    </message>
    <message>
        <source>standard, 0 at near</source>
        <translation>standardni, 0 na bliskoj</translation>
    </message>
    <message>
        <source>standard, far at infinity</source>
        <translation>standardni, daleka u beskonačnosti</translation>
    </message>
    <message>
        <source>steps of the two grids</source>
        <translation>koraci dviju rešetki</translation>
    </message>
    <message>
        <source>stretch</source>
        <translation>rastegni</translation>
    </message>
    <message>
        <source>subject&apos;s height, at the target&apos;s distance</source>
        <translation>visina motiva, na udaljenosti cilja</translation>
    </message>
    <message>
        <source>sun</source>
        <translation>sunce</translation>
    </message>
    <message>
        <source>surface 1</source>
        <translation>ploha 1</translation>
    </message>
    <message>
        <source>surface 2</source>
        <translation>ploha 2</translation>
    </message>
    <message>
        <source>synthetic film</source>
        <translation>sintetički film</translation>
    </message>
    <message>
        <source>t, part of the edge on the screen</source>
        <translation>t, dio brida na ekranu</translation>
    </message>
    <message>
        <source>t, to infinity at 1</source>
        <translation>t, do beskonačnosti u 1</translation>
    </message>
    <message>
        <source>table alone</source>
        <translation>samo tablica</translation>
    </message>
    <message>
        <source>table, 1 Newton step</source>
        <translation>tablica, 1 Newtonov korak</translation>
    </message>
    <message>
        <source>table, 2 Newton steps</source>
        <translation>tablica, 2 Newtonova koraka</translation>
    </message>
    <message>
        <source>test points inside</source>
        <translation>testne točke unutra</translation>
    </message>
    <message>
        <source>the angles α and β give scale and angle before the picture is stretched</source>
        <translation>kutovi α i β daju mjerilo i kut prije nego što se slika rastegne</translation>
    </message>
    <message>
        <source>the arrow is behind the hole or beside it: no light comes from it into the box</source>
        <translation>strelica je iza rupice ili pokraj nje: od nje u kutiju ne dolazi svjetlo</translation>
    </message>
    <message>
        <source>the arrow&apos;s height h</source>
        <translation>visina strelice h</translation>
    </message>
    <message>
        <source>the board reaches behind the near plane: the edges that are cut there have no picture</source>
        <translation>ploča seže iza bliske ravnine: bridovi koji su ondje odsječeni nemaju sliku</translation>
    </message>
    <message>
        <source>the bound is so large that a vertex may be behind the camera</source>
        <translation>granica je tako velika da bi neki vrh mogao biti iza kamere</translation>
    </message>
    <message>
        <source>the camera looks straight down or up: there is no floor from near to far</source>
        <translation>kamera gleda ravno dolje ili gore: nema poda od bliske do daleke ravnine</translation>
    </message>
    <message>
        <source>the edge&apos;s pixels are too many or too few for float64 to measure</source>
        <translation>piksela brida je previše ili premalo da bi ih float64 izmjerio</translation>
    </message>
    <message>
        <source>the end lies in the eye plane: its image is at ∞</source>
        <translation>kraj leži u ravnini kamere: slika mu je u ∞</translation>
    </message>
    <message>
        <source>the eye lies in the seam, or the seam behind it: its picture has no width</source>
        <translation>kamera leži u šavu ili je šav iza nje: slika mu nema širinu</translation>
    </message>
    <message>
        <source>the far plane is at infinity: nothing pops in</source>
        <translation>daleka ravnina je u beskonačnosti: ništa ne iskače</translation>
    </message>
    <message>
        <source>the floor is drawn too far by a factor of up to</source>
        <translation>pod se crta predaleko za faktor do</translation>
    </message>
    <message>
        <source>the focal distance {0} m is not beyond the focal length {1} m: nothing so close has an image</source>
        <translation>udaljenost izoštravanja {0} m nije veća od žarišne duljine {1} m: ništa tako blizu nema sliku</translation>
    </message>
    <message>
        <source>the image on the plane</source>
        <translation>slika na ravnini</translation>
    </message>
    <message>
        <source>the light is inside the object&apos;s bounds: move it out to see the whole shadow</source>
        <translation>svjetlo je unutar granica objekta: pomaknite ga van da vidite cijelu sjenu</translation>
    </message>
    <message>
        <source>the line as a circle</source>
        <translation>pravac kao kružnica</translation>
    </message>
    <message>
        <source>the mesh reaches behind the near plane: the edges that are cut there have no picture</source>
        <translation>mreža seže iza bliske ravnine: bridovi koji su ondje odsječeni nemaju sliku</translation>
    </message>
    <message>
        <source>the middle of a 105-mm photograph, enlarged {0} times</source>
        <translation>sredina fotografije od 105 mm, povećana {0} puta</translation>
    </message>
    <message>
        <source>the next tree</source>
        <translation>sljedeće stablo</translation>
    </message>
    <message>
        <source>the object</source>
        <translation>objekt</translation>
    </message>
    <message>
        <source>the origin</source>
        <translation>ishodište</translation>
    </message>
    <message>
        <source>the picture is stretched {0} times as much upwards as across: faces do not keep their shape</source>
        <translation>slika je u visinu rastegnuta {0} puta više nego u širinu: strane ne zadržavaju oblik</translation>
    </message>
    <message>
        <source>the picture is stretched: the target&apos;s disc is an ellipse of this width and height</source>
        <translation>slika je rastegnuta: krug cilja je elipsa ove širine i visine</translation>
    </message>
    <message>
        <source>the point is behind the eye or beside it: its projector meets no plane in front</source>
        <translation>točka je iza kamere ili pokraj nje: njezina zraka projiciranja ne siječe nijednu ravninu ispred</translation>
    </message>
    <message>
        <source>the point is not in front of both eyes</source>
        <translation>točka nije ispred oba oka</translation>
    </message>
    <message>
        <source>the projectors of a parallel lens do not meet in an eye: choose a perspective lens</source>
        <translation>zrake projiciranja paralelnog objektiva ne sijeku se u kameri: odaberite perspektivni objektiv</translation>
    </message>
    <message>
        <source>the same, counted in the picture</source>
        <translation>isto, prebrojeno na slici</translation>
    </message>
    <message>
        <source>the screen plane is before the near plane: nothing that is drawn can lie in it</source>
        <translation>ravnina ekrana je ispred bliske ravnine: ništa nacrtano ne može ležati u njoj</translation>
    </message>
    <message>
        <source>the segment is a single point of the cube</source>
        <translation>dužina je jedna točka kocke</translation>
    </message>
    <message>
        <source>the segment lies in the eye plane: its whole image is at infinity</source>
        <translation>dužina leži u ravnini kamere: cijela joj je slika u beskonačnosti</translation>
    </message>
    <message>
        <source>the segment lies outside the view volume</source>
        <translation>dužina leži izvan volumena pogleda</translation>
    </message>
    <message>
        <source>the segment points at the eye: the image of its whole line is one point</source>
        <translation>dužina je usmjerena prema kameri: slika cijelog njezina pravca je jedna točka</translation>
    </message>
    <message>
        <source>the shadow is farther than 1e30 away</source>
        <translation>sjena je dalje od 1e30</translation>
    </message>
    <message>
        <source>the subject&apos;s pixels are more than float64 can hold on one of the screens</source>
        <translation>piksela motiva na jednom je ekranu više nego što float64 može zapisati</translation>
    </message>
    <message>
        <source>the target is not between near and far</source>
        <translation>cilj nije između bliske i daleke ravnine</translation>
    </message>
    <message>
        <source>the target is so close to the lens that its disc has no finite size</source>
        <translation>cilj je tako blizu objektivu da njegov krug nema konačnu veličinu</translation>
    </message>
    <message>
        <source>the texture is laid over the mesh&apos;s two largest extents; only the {0} triangles with the longest sides are examined</source>
        <translation>tekstura je položena po dvjema najvećim dimenzijama mreže; ispituju se samo trokuti s najduljim stranicama ({0})</translation>
    </message>
    <message>
        <source>the texture is laid over the mesh&apos;s two largest extents; texture coordinates in its file are not used</source>
        <translation>tekstura je položena po dvjema najvećim dimenzijama mreže; koordinate teksture iz njezine datoteke ne koriste se</translation>
    </message>
    <message>
        <source>the view volume cuts PQ: the part inside it, from P&apos; to Q&apos;, is measured</source>
        <translation>volumen pogleda odsijeca PQ: mjeri se dio unutar njega, od P&apos; do Q&apos;</translation>
    </message>
    <message>
        <source>the wall reaches behind the eye: a vertex there has no logarithm</source>
        <translation>zid seže iza kamere: vrh ondje nema logaritam</translation>
    </message>
    <message>
        <source>there is no error that an arrow could show</source>
        <translation>nema pogreške koju bi strelica mogla pokazati</translation>
    </message>
    <message>
        <source>there is no number: a vertex may be behind the eye</source>
        <translation>nema broja: neki vrh može biti iza kamere</translation>
    </message>
    <message>
        <source>there is only one screen, and so no join</source>
        <translation>postoji samo jedan ekran, pa nema spoja</translation>
    </message>
    <message>
        <source>there, it is drawn at</source>
        <translation>ondje se crta u</translation>
    </message>
    <message>
        <source>there, its distance w</source>
        <translation>ondje, udaljenost w</translation>
    </message>
    <message>
        <source>these are</source>
        <translation>to su</translation>
    </message>
    <message>
        <source>these formats may overflow or divide by 0 here, so there is no bound</source>
        <translation>ti formati ovdje mogu prijeći najveći broj ili dijeliti s 0, pa granice nema</translation>
    </message>
    <message>
        <source>this lens has no inverse whose numbers float64 can hold</source>
        <translation>ovaj objektiv nema inverz čije bi brojeve float64 mogao zapisati</translation>
    </message>
    <message>
        <source>this window is too narrow for two screens</source>
        <translation>ovaj je prozor preuzak za dva ekrana</translation>
    </message>
    <message>
        <source>toed in</source>
        <translation>okrenute jedna prema drugoj</translation>
    </message>
    <message>
        <source>too few pixels of the picture show both surfaces to count them</source>
        <translation>premalo piksela slike pokazuje obje plohe da bi se brojili</translation>
    </message>
    <message>
        <source>too large or too small for a float64 number</source>
        <translation>prevelik ili premalen za broj float64</translation>
    </message>
    <message>
        <source>too large or too small for a number in pixels</source>
        <translation>prevelik ili premalen za broj u pikselima</translation>
    </message>
    <message>
        <source>top</source>
        <translation>gornja</translation>
    </message>
    <message>
        <source>trees that pop in each second, driving on at 12 units a second</source>
        <translation>stabala koja iskaču svake sekunde, pri vožnji naprijed od 12 jedinica u sekundi</translation>
    </message>
    <message>
        <source>trees that pop out each second, driving on</source>
        <translation>stabala koja nestaju svake sekunde, pri vožnji naprijed</translation>
    </message>
    <message>
        <source>true distance w</source>
        <translation>prava udaljenost w</translation>
    </message>
    <message>
        <source>truncated cone</source>
        <translation>krnji stožac</translation>
    </message>
    <message>
        <source>two eyes so far apart have no pictures with this lens</source>
        <translation>dva tako udaljena oka nemaju slike s ovim objektivom</translation>
    </message>
    <message>
        <source>two floats</source>
        <translation>dva broja float</translation>
    </message>
    <message>
        <source>two floats, from the origin</source>
        <translation>dva broja float, od ishodišta</translation>
    </message>
    <message>
        <source>upright</source>
        <translation>uspravno</translation>
    </message>
    <message>
        <source>upside down and left for right</source>
        <translation>naopačke, lijevo i desno zamijenjeni</translation>
    </message>
    <message>
        <source>vertex P</source>
        <translation>vrh P</translation>
    </message>
    <message>
        <source>vertical field of view</source>
        <translation>vertikalno vidno polje</translation>
    </message>
    <message>
        <source>vertical parallax of P</source>
        <translation>vertikalna paralaksa točke P</translation>
    </message>
    <message>
        <source>vertices drawn</source>
        <translation>nacrtanih vrhova</translation>
    </message>
    <message>
        <source>vertices drawn without level of detail</source>
        <translation>nacrtanih vrhova bez razine detalja</translation>
    </message>
    <message>
        <source>vertices not below the light</source>
        <translation>vrhova koji nisu ispod svjetla</translation>
    </message>
    <message>
        <source>view volume</source>
        <translation>volumen pogleda</translation>
    </message>
    <message>
        <source>w may be 0 in these numbers, so nothing is known</source>
        <translation>w u tim brojevima može biti 0, pa se ništa ne zna</translation>
    </message>
    <message>
        <source>w of P = (1 − t)·C + t·(D : 0)</source>
        <translation>w točke P = (1 − t)·C + t·(D : 0)</translation>
    </message>
    <message>
        <source>wall against one picture, float64</source>
        <translation>zid prema jednoj slici, float64</translation>
    </message>
    <message>
        <source>where the floor is drawn</source>
        <translation>gdje se pod crta</translation>
    </message>
    <message>
        <source>where: w = √(w_P&apos;·w_Q&apos;)</source>
        <translation>gdje: w = √(w_P&apos;·w_Q&apos;)</translation>
    </message>
    <message>
        <source>where: w = √(w_P·w_Q)</source>
        <translation>gdje: w = √(w_P·w_Q)</translation>
    </message>
    <message>
        <source>whole pixels</source>
        <translation>cijeli pikseli</translation>
    </message>
    <message>
        <source>width of the gap along the seam</source>
        <translation>širina procjepa duž šava</translation>
    </message>
    <message>
        <source>window</source>
        <translation>prozor</translation>
    </message>
    <message>
        <source>with a parallel lens a box goes through the window, not a frustum from the eye</source>
        <translation>kod paralelnog objektiva kroz prozor ide kvadar, a ne krnja piramida iz kamere</translation>
    </message>
    <message>
        <source>with a parallel lens half-way on the screen is half-way in the world: affine is correct</source>
        <translation>kod paralelnog objektiva polovica na ekranu jest polovica u svijetu: afino je točno</translation>
    </message>
    <message>
        <source>with a parallel lens parallel edges stay parallel in the image</source>
        <translation>kod paralelnog objektiva paralelni bridovi ostaju na slici paralelni</translation>
    </message>
    <message>
        <source>with a parallel lens the distance itself is linear on the screen: nobody needs its logarithm</source>
        <translation>kod paralelnog objektiva sama je udaljenost linearna na ekranu: nitko ne treba njezin logaritam</translation>
    </message>
    <message>
        <source>with far at infinity, no affine z&apos; = A z + B covers all depths: choose a finite far plane</source>
        <translation>s dalekom ravninom u beskonačnosti nijedan afini z&apos; = A z + B ne pokriva sve dubine: odaberite konačnu daleku ravninu</translation>
    </message>
    <message>
        <source>worst edge of the letter F, inside</source>
        <translation>najgori brid slova F, unutra</translation>
    </message>
    <message>
        <source>worst edge of the mesh, inside</source>
        <translation>najgori brid mreže, unutra</translation>
    </message>
    <message>
        <source>wrong</source>
        <translation>pogrešno</translation>
    </message>
    <message>
        <source>x</source>
        <translation>x</translation>
    </message>
    <message>
        <source>x and y are divided by the distance w. If z were only scaled and shifted, z&apos; = A z + B, a straight segment PQ would be a bow in the cube. Nothing between its ends could then be interpolated or clipped as on a line. With z&apos; = {divided_z} it stays straight.</source>
        <translation>x i y se dijele s udaljenošću w. Kad bi se z samo skalirao i pomaknuo, z&apos; = A z + B, ravna dužina PQ u kocki bi bila luk. Ništa između njezinih krajeva tada se ne bi moglo interpolirati ni odsjeći kao na pravcu. Sa z&apos; = {divided_z} ostaje ravna.</translation>
    </message>
    <message>
        <source>y</source>
        <translation>y</translation>
    </message>
    <message>
        <source>your own</source>
        <translation>vaše vlastito</translation>
    </message>
    <message>
        <source>z</source>
        <translation>z</translation>
    </message>
    <message>
        <source>{0} = {1}: is at infinity, so it is a direction and not a point; it must be another than {2}</source>
        <translation>{0} = {1}: leži u beskonačnosti, pa je smjer, a ne točka; mora se razlikovati od {2}</translation>
    </message>
    <message>
        <source>{0} = {1}: must be from 0 to {2}, or P has no pixel and no depth in the picture</source>
        <translation>{0} = {1}: mora biti od 0 do {2}, inače P na slici nema ni piksel ni dubinu</translation>
    </message>
    <message>
        <source>{0} is beyond what float64 can hold in pixels</source>
        <translation>{0} je izvan onoga što float64 može zapisati u pikselima</translation>
    </message>
    <message>
        <source>{0} vertices of the picture have no number in these formats: they are drawn where they belong</source>
        <translation>vrhovi slike bez broja u tim formatima ({0}) crtaju se ondje kamo pripadaju</translation>
    </message>
    <message>
        <source>{b}, {t}</source>
        <translation>{b}, {t}</translation>
    </message>
    <message>
        <source>{l}, {r} of the left screen</source>
        <translation>{l}, {r} lijevog ekrana</translation>
    </message>
    <message>
        <source>{l}, {r} of the right screen</source>
        <translation>{l}, {r} desnog ekrana</translation>
    </message>
    <message>
        <source>{l}, {r} of the window</source>
        <translation>{l}, {r} prozora</translation>
    </message>
    <message>
        <source>½ in the world</source>
        <translation>½ u&#xa0;svijetu</translation>
    </message>
    <message>
        <source>½ on the screen</source>
        <translation>½ na ekranu</translation>
    </message>
    <message>
        <source>∞: focused at the hyperfocal distance or beyond, everything far away is sharp</source>
        <translation>∞: izoštreno na hiperfokalnu udaljenost ili dalje, sve daleko je oštro</translation>
    </message>
</context>
</TS>
