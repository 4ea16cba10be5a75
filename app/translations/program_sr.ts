<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="sr" sourcelanguage="en">
<context>
    <name>Actions</name>
    <message>
        <source>Scene</source>
        <translation>Сцена</translation>
    </message>
    <message>
        <source>The scene in front of the camera</source>
        <translation>Сцена испред камере</translation>
    </message>
    <message>
        <source>Tools</source>
        <translation>Алатке</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Паузирај</translation>
    </message>
    <message>
        <source>Play</source>
        <translation>Пусти</translation>
    </message>
    <message>
        <source>&amp;About Frustum Lab</source>
        <translation>&amp;О програму Frustum Lab</translation>
    </message>
    <message>
        <source>&amp;Blank the screen</source>
        <translation>Зата&amp;мни екран</translation>
    </message>
    <message>
        <source>&amp;Camera</source>
        <translation>&amp;Камера</translation>
    </message>
    <message>
        <source>&amp;Close the lesson</source>
        <translation>&amp;Затвори лекцију</translation>
    </message>
    <message>
        <source>&amp;Controls</source>
        <translation>&amp;Контроле</translation>
    </message>
    <message>
        <source>&amp;Conventions</source>
        <translation>&amp;Конвенције</translation>
    </message>
    <message>
        <source>&amp;Copy picture</source>
        <translation>&amp;Копирај слику</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>&amp;Уређивање</translation>
    </message>
    <message>
        <source>&amp;Export picture…</source>
        <translation>&amp;Извези слику…</translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation>&amp;Датотека</translation>
    </message>
    <message>
        <source>&amp;Find a control</source>
        <translation>&amp;Нађи контролу</translation>
    </message>
    <message>
        <source>&amp;Freely</source>
        <translation>&amp;Слободно</translation>
    </message>
    <message>
        <source>&amp;Frustum</source>
        <translation>&amp;Зарубљена пирамида</translation>
    </message>
    <message>
        <source>&amp;Full screen</source>
        <translation>Ц&amp;ео екран</translation>
    </message>
    <message>
        <source>&amp;Grid</source>
        <translation>Реше&amp;тка</translation>
    </message>
    <message>
        <source>&amp;Handles</source>
        <translation>&amp;Ручице</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>По&amp;моћ</translation>
    </message>
    <message>
        <source>&amp;Hint</source>
        <translation>Наго&amp;вештај</translation>
    </message>
    <message>
        <source>&amp;Keys and mouse</source>
        <translation>&amp;Тастери и миш</translation>
    </message>
    <message>
        <source>&amp;Labels</source>
        <translation>&amp;Ознаке</translation>
    </message>
    <message>
        <source>&amp;Layers</source>
        <translation>Сл&amp;ојеви</translation>
    </message>
    <message>
        <source>&amp;Lessons</source>
        <translation>&amp;Лекције</translation>
    </message>
    <message>
        <source>&amp;Next step</source>
        <translation>&amp;Следећи корак</translation>
    </message>
    <message>
        <source>&amp;Open a lesson…</source>
        <translation>&amp;Отвори лекцију…</translation>
    </message>
    <message>
        <source>&amp;Open…</source>
        <translation>&amp;Отвори…</translation>
    </message>
    <message>
        <source>&amp;Picture on the near plane</source>
        <translation>&amp;Слика на предњој равни</translation>
    </message>
    <message>
        <source>&amp;Present</source>
        <translation>&amp;Излагање</translation>
    </message>
    <message>
        <source>&amp;Previous step</source>
        <translation>&amp;Претходни корак</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>Иза&amp;ђи</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>&amp;Понови</translation>
    </message>
    <message>
        <source>&amp;Reset the panes&apos; own views</source>
        <translation>Врати сопствене по&amp;гледе приказа</translation>
    </message>
    <message>
        <source>&amp;Review</source>
        <translation>По&amp;нављање</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>&amp;Сачувај</translation>
    </message>
    <message>
        <source>&amp;Scenes</source>
        <translation>&amp;Сцене</translation>
    </message>
    <message>
        <source>&amp;Show cost</source>
        <translation>Прикажи &amp;цену</translation>
    </message>
    <message>
        <source>&amp;Show the step again</source>
        <translation>Прикажи кора&amp;к поново</translation>
    </message>
    <message>
        <source>&amp;Start card</source>
        <translation>&amp;Почетна страница</translation>
    </message>
    <message>
        <source>&amp;Theme</source>
        <translation>&amp;Тема</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Опозови</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>&amp;Поглед</translation>
    </message>
    <message>
        <source>All &amp;digits</source>
        <translation>Све ци&amp;фре</translation>
    </message>
    <message>
        <source>Along the a&amp;xis</source>
        <translation>Дуж &amp;осе</translation>
    </message>
    <message>
        <source>As the s&amp;ystem</source>
        <translation>Као у систе&amp;му</translation>
    </message>
    <message>
        <source>As the system</source>
        <translation>Као у систему</translation>
    </message>
    <message>
        <source>Back to &amp;all panes</source>
        <translation>Назад на &amp;све приказе</translation>
    </message>
    <message>
        <source>Begin the lesson a&amp;gain</source>
        <translation>Почни лекцију испо&amp;четка</translation>
    </message>
    <message>
        <source>Chec&amp;k the lesson</source>
        <translation>Пров&amp;ери лекцију</translation>
    </message>
    <message>
        <source>Co&amp;ntrols of the slide</source>
        <translation>Контроле слај&amp;да</translation>
    </message>
    <message>
        <source>Compare s&amp;ide by side or overlaid</source>
        <translation>Упореди &amp;једно поред другог или преклопљено</translation>
    </message>
    <message>
        <source>Compare wit&amp;h this picture</source>
        <translation>&amp;Упореди са овом сликом</translation>
    </message>
    <message>
        <source>Controls</source>
        <translation>Контроле</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Копирај</translation>
    </message>
    <message>
        <source>Copy the three panes to the clipboard, including the document</source>
        <translation>Копирај три приказа у оставу, заједно са документом</translation>
    </message>
    <message>
        <source>Dark</source>
        <translation>Тамна</translation>
    </message>
    <message>
        <source>Every topic with its exercises, as you solved them</source>
        <translation>Све теме са задацима, како сте их решили</translation>
    </message>
    <message>
        <source>Exercises of topics that you choose, without help</source>
        <translation>Задаци из тема које изаберете, без помоћи</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>Извоз</translation>
    </message>
    <message>
        <source>Export panes as PNG, SVG, PDF or TikZ; a PNG contains the document</source>
        <translation>Извези приказе као PNG, SVG, PDF или TikZ; PNG садржи и документ</translation>
    </message>
    <message>
        <source>Find a control by its name, its letter or what it does</source>
        <translation>Нађи контролу по имену, по слову или по ономе што ради</translation>
    </message>
    <message>
        <source>From &amp;above</source>
        <translation>Одо&amp;зго</translation>
    </message>
    <message>
        <source>From the &amp;eye</source>
        <translation>&amp;Из камере</translation>
    </message>
    <message>
        <source>From the &amp;side</source>
        <translation>Са с&amp;тране</translation>
    </message>
    <message>
        <source>Go on with the t&amp;est</source>
        <translation>Настави &amp;тест</translation>
    </message>
    <message>
        <source>Help</source>
        <translation>Помоћ</translation>
    </message>
    <message>
        <source>Hold the current picture and compare it with later ones, or end the comparison</source>
        <translation>Задржи тренутну слику и упореди је са каснијим, или заврши поређење</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>Језик</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>Светла</translation>
    </message>
    <message>
        <source>Look at the &amp;world</source>
        <translation>Поглед &amp;на свет</translation>
    </message>
    <message>
        <source>Measure the cost of every step: the model, each pane&apos;s matrices and repaint</source>
        <translation>Измери цену сваког корака: модела, матрица и исцртавања сваког приказа</translation>
    </message>
    <message>
        <source>Name e&amp;verything</source>
        <translation>Именуј с&amp;ве</translation>
    </message>
    <message>
        <source>Name everything in the pictures, not only what the scene is about</source>
        <translation>Именуј све на сликама, а не само оно о чему је сцена</translation>
    </message>
    <message>
        <source>O&amp;verview…</source>
        <translation>Пре&amp;глед…</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Отвори</translation>
    </message>
    <message>
        <source>Open &amp;recent</source>
        <translation>Отвори &amp;недавно</translation>
    </message>
    <message>
        <source>Open a &amp;mesh…</source>
        <translation>Отвори &amp;мрежу…</translation>
    </message>
    <message>
        <source>Open a document, a lesson, a mesh, a camera or an exported picture</source>
        <translation>Отвори документ, лекцију, мрежу, камеру или извезену слику</translation>
    </message>
    <message>
        <source>Open a lesson or a talk from its file</source>
        <translation>Отвори лекцију или презентацију из датотеке</translation>
    </message>
    <message>
        <source>P&amp;en</source>
        <translation>О&amp;ловка</translation>
    </message>
    <message>
        <source>P&amp;ointer in all panes</source>
        <translation>Показива&amp;ч у свим приказима</translation>
    </message>
    <message>
        <source>Panes in col&amp;umns</source>
        <translation>Прикази у колон&amp;ама</translation>
    </message>
    <message>
        <source>Play or pause the camera&apos;s orbit</source>
        <translation>Пусти или паузирај кружење камере</translation>
    </message>
    <message>
        <source>Present</source>
        <translation>Излагање</translation>
    </message>
    <message>
        <source>Present from the beginnin&amp;g</source>
        <translation>Излажи од &amp;почетка</translation>
    </message>
    <message>
        <source>Present the open talk from its first step</source>
        <translation>Излажи отворену презентацију од првог корака</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>Понови</translation>
    </message>
    <message>
        <source>Reduce &amp;motion</source>
        <translation>Умањи к&amp;ретање</translation>
    </message>
    <message>
        <source>Remove the &amp;probe</source>
        <translation>Уклони сон&amp;ду</translation>
    </message>
    <message>
        <source>Remove the chosen probe from the panes</source>
        <translation>Уклони изабрану сонду из приказа</translation>
    </message>
    <message>
        <source>Reset</source>
        <translation>Врати на почетно</translation>
    </message>
    <message>
        <source>Reset &amp;all</source>
        <translation>Врати &amp;све на почетно</translation>
    </message>
    <message>
        <source>Reset camera, lens, image and settings to how the scene opens</source>
        <translation>Врати камеру, објектив, слику и подешавања на оно са чим се сцена отвара</translation>
    </message>
    <message>
        <source>S&amp;peed and accuracy</source>
        <translation>&amp;Брзина и тачност</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Сачувај</translation>
    </message>
    <message>
        <source>Save &amp;as…</source>
        <translation>Сачувај к&amp;ао…</translation>
    </message>
    <message>
        <source>Show all digits of every number, not only four</source>
        <translation>Прикажи све цифре сваког броја, а не само четири</translation>
    </message>
    <message>
        <source>Show the class a black screen, or the panes again</source>
        <translation>Прикажи слушаоцима црн екран, или поново приказе</translation>
    </message>
    <message>
        <source>Show the next step of a lesson or a talk at once, without a transition</source>
        <translation>Прикажи следећи корак лекције или презентације одмах, без прелаза</translation>
    </message>
    <message>
        <source>Show the pane in the large slot; choose it again to fill the window</source>
        <translation>Прикажи овај приказ на великом месту; изаберите га поново да попуни прозор</translation>
    </message>
    <message>
        <source>Show the panes and the essential controls on the full screen, for a class</source>
        <translation>Прикажи приказе и најважније контроле на целом екрану, за слушаоце</translation>
    </message>
    <message>
        <source>Show the step as the lesson&apos;s file has it, without your changes</source>
        <translation>Прикажи корак онако како стоји у датотеци лекције, без ваших измена</translation>
    </message>
    <message>
        <source>T&amp;alks</source>
        <translation>П&amp;резентације</translation>
    </message>
    <message>
        <source>Test &amp;yourself…</source>
        <translation>&amp;Испитајте се…</translation>
    </message>
    <message>
        <source>The scenes as pictures, lessons, talks, and recent files</source>
        <translation>Сцене као слике, лекције, презентације и недавне датотеке</translation>
    </message>
    <message>
        <source>Try everything in the lesson&apos;s file</source>
        <translation>Испробај све што је у датотеци лекције</translation>
    </message>
    <message>
        <source>Two-minute &amp;tour</source>
        <translation>Обилазак за два &amp;минута</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Опозови</translation>
    </message>
    <message>
        <source>What a renderer gives up to be fast: trades as pictures, measured</source>
        <translation>Чега се програм за исцртавање одриче да би био брз: компромиси као слике, измерени</translation>
    </message>
    <message>
        <source>What you did not solve alone comes back after 1, 3 and 7 days</source>
        <translation>Оно што нисте решили сами враћа се после 1, 3 и 7 дана</translation>
    </message>
    <message>
        <source>While presenting, draw on the slide, or put the pen away</source>
        <translation>Током излагања цртај по слајду, или одложи оловку</translation>
    </message>
    <message>
        <source>While presenting, mark in all panes the point under the mouse</source>
        <translation>Током излагања обележи у свим приказима тачку испод миша</translation>
    </message>
    <message>
        <source>While presenting, show the controls of the slide below it, or hide them</source>
        <translation>Током излагања прикажи контроле слајда испод њега, или их сакриј</translation>
    </message>
    <message>
        <source>{0} in large</source>
        <translation>{0} – велики приказ</translation>
    </message>
    <message>
        <source>Speaker&apos;s &amp;window</source>
        <translation>Прозор пре&amp;давача</translation>
    </message>
    <message>
        <source>Open it when a talk is presente&amp;d</source>
        <translation>Отвори га при изл&amp;агању презентације</translation>
    </message>
    <message>
        <source>Add th&amp;is state as a step…</source>
        <translation>Дода&amp;ј ово стање као корак…</translation>
    </message>
    <message>
        <source>A new talk fro&amp;m here…</source>
        <translation>Нова презента&amp;ција одавде…</translation>
    </message>
</context>
<context>
    <name>Adaptive</name>
    <message>
        <source>Making coarser versions of the scene</source>
        <translation>Праве се грубље верзије сцене</translation>
    </message>
</context>
<context>
    <name>AnimationBar</name>
    <message>
        <source>Play</source>
        <translation>Пусти</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Брзина</translation>
    </message>
    <message>
        <source>Angle per second of the walk round the vertical through the target; below 0 the camera walks the other way.</source>
        <translation>Угао у секунди при кружењу око вертикале кроз циљ; испод 0 камера кружи у супротном смеру.</translation>
    </message>
    <message>
        <source>°/s</source>
        <translation>°/s</translation>
    </message>
    <message>
        <source>degrees per second</source>
        <translation>степени у секунди</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Висина</translation>
    </message>
    <message>
        <source>How the eye&apos;s y changes during the walk (the exercise of lecture 004).</source>
        <translation>Како се y позиције камере мења током кружења (задатак из предавања 004).</translation>
    </message>
    <message>
        <source>fixed</source>
        <translation>стална</translation>
    </message>
    <message>
        <source>The eye keeps its y.</source>
        <translation>Позиција камере задржава свој y.</translation>
    </message>
    <message>
        <source>swinging smoothly</source>
        <translation>глатко њихање</translation>
    </message>
    <message>
        <source>The eye&apos;s y swings between the lowest and the highest value.</source>
        <translation>y позиције камере њише се између најмање и највеће вредности.</translation>
    </message>
    <message>
        <source>in steps</source>
        <translation>у скоковима</translation>
    </message>
    <message>
        <source>The eye&apos;s y jumps to the next of four values every 2 seconds.</source>
        <translation>y позиције камере сваке 2 секунде скаче на следећу од четири вредности.</translation>
    </message>
    <message>
        <source>units</source>
        <translation>јединица</translation>
    </message>
    <message>
        <source>world units</source>
        <translation>јединица света</translation>
    </message>
    <message>
        <source>Lowest</source>
        <translation>Најниже</translation>
    </message>
    <message>
        <source>The lowest y of the eye while its height changes.</source>
        <translation>Најмањи y позиције камере док се висина мења.</translation>
    </message>
    <message>
        <source>Highest</source>
        <translation>Највише</translation>
    </message>
    <message>
        <source>The highest y of the eye while its height changes.</source>
        <translation>Највећа координата y позиције камере док се висина мења.</translation>
    </message>
    <message>
        <source>Look</source>
        <translation>Поглед</translation>
    </message>
    <message>
        <source>Where the camera looks during the walk.</source>
        <translation>Куда камера гледа током кружења.</translation>
    </message>
    <message>
        <source>at the target</source>
        <translation>у циљ</translation>
    </message>
    <message>
        <source>The target stays in place.</source>
        <translation>Циљ остаје на месту.</translation>
    </message>
    <message>
        <source>level</source>
        <translation>водоравно</translation>
    </message>
    <message>
        <source>The target gets the eye&apos;s y: the camera looks horizontally.</source>
        <translation>Циљ добија y позиције камере: камера гледа хоризонтално.</translation>
    </message>
    <message>
        <source>The camera is straight below the target and cannot look level.</source>
        <translation>Камера је тачно испод циља и не може да гледа водоравно.</translation>
    </message>
    <message>
        <source>The camera stands straight above the target and cannot look level.</source>
        <translation>Камера стоји тачно изнад циља и не може да гледа водоравно.</translation>
    </message>
    <message>
        <source>The camera is at the target and cannot look at it.</source>
        <translation>Камера је у самом циљу и не може да га гледа.</translation>
    </message>
    <message>
        <source>The camera would look along its own up vector.</source>
        <translation>Камера би гледала дуж свог вектора нагоре.</translation>
    </message>
    <message>
        <source>Walk round the target, as in the exercise of lecture 004.</source>
        <translation>Кружи око циља, као у задатку из предавања 004.</translation>
    </message>
    <message>
        <source>Pause here; playing continues from here.</source>
        <translation>Паузирај овде; пуштање наставља одавде.</translation>
    </message>
    <message>
        <source>Stopped.</source>
        <translation>Заустављено.</translation>
    </message>
</context>
<context>
    <name>BlockView</name>
    <message>
        <source>Hand it &amp;in</source>
        <translation>Пр&amp;едај</translation>
    </message>
    <message>
        <source>This is my answer; there is one try (Enter)</source>
        <translation>Ово је мој одговор; има само један покушај (Enter)</translation>
    </message>
    <message>
        <source>Chec&amp;k</source>
        <translation>Пров&amp;ери</translation>
    </message>
    <message>
        <source>Enter</source>
        <translation>Enter</translation>
    </message>
    <message>
        <source>Kept</source>
        <translation>Сачувано</translation>
    </message>
    <message>
        <source>Your answer is kept until the end.</source>
        <translation>Ваш одговор се чува до краја.</translation>
    </message>
    <message>
        <source>Hint {0}:</source>
        <translation>Наговештај {0}:</translation>
    </message>
    <message>
        <source>Hint:</source>
        <translation>Наговештај:</translation>
    </message>
    <message>
        <source>Show the right answer, and why it is right (Alt+A)</source>
        <translation>Прикажи тачан одговор и зашто је тачан (Alt+A)</translation>
    </message>
    <message>
        <source>Show the &amp;answer</source>
        <translation>Прикажи &amp;одговор</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>Тачно</translation>
    </message>
    <message>
        <source>Right.</source>
        <translation>Тачно.</translation>
    </message>
    <message>
        <source>The idea behind it: “{0}”.</source>
        <translation>Представа иза тога: „{0}”.</translation>
    </message>
    <message>
        <source>Wrong</source>
        <translation>Нетачно</translation>
    </message>
    <message>
        <source>That is not it.</source>
        <translation>Није то.</translation>
    </message>
    <message>
        <source>Show a state that makes it visible (Alt+W)</source>
        <translation>Прикажи стање у коме се то види (Alt+W)</translation>
    </message>
    <message>
        <source>Sho&amp;w it</source>
        <translation>При&amp;кажи то</translation>
    </message>
    <message>
        <source>Show the picture with your number beside that with the model&apos;s (Alt+M)</source>
        <translation>Прикажи слику са вашим бројем поред слике са бројем модела (Alt+M)</translation>
    </message>
    <message>
        <source>Your idea beside the &amp;model</source>
        <translation>Ва&amp;ша представа поред модела</translation>
    </message>
</context>
<context>
    <name>CellWords</name>
    <message>
        <source>It depends on no control.</source>
        <translation>Не зависи ни од једне контроле.</translation>
    </message>
    <message>
        <source>It depends on: {0}.</source>
        <translation>Зависи од: {0}.</translation>
    </message>
    <message>
        <source>row {0}, column {1}</source>
        <translation>врста {0}, колона {1}</translation>
    </message>
    <message>
        <source>Double-click or press Enter to type another number, or a fraction such as 1/3.</source>
        <translation>Двапут кликните или притисните Enter да бисте унели други број, или разломак као 1/3.</translation>
    </message>
    <message>
        <source>The world&apos;s {1} component of the camera&apos;s axis {0}: it adds {3} times {1} to {2}.</source>
        <translation>Компонента {1} осе {0} камере у координатном систему света: додаје {3} пута {1} на {2}.</translation>
    </message>
    <message>
        <source>The {0} of the eye, where view space has its origin.</source>
        <translation>Координата {0} позиције камере, где је почетак координатног система камере.</translation>
    </message>
    <message>
        <source>The world&apos;s {1} component of the camera&apos;s axis {0}.</source>
        <translation>Компонента {1} осе {0} камере у координатном систему света.</translation>
    </message>
    <message>
        <source>It scales {0} by {2}.</source>
        <translation>Скалира {0} са {2}.</translation>
    </message>
    <message>
        <source>It leaves the scale of {0} unchanged.</source>
        <translation>Не мења размеру за {0}.</translation>
    </message>
    <message>
        <source>It scales {0} by {2}, which reverses its direction.</source>
        <translation>Скалира {0} са {2}, што окреће смер.</translation>
    </message>
    <message>
        <source>It adds {2} times {1} to {0}: a shear.</source>
        <translation>Додаје {2} пута {1} на {0}: смицање.</translation>
    </message>
    <message>
        <source>{0} does not depend on {1}.</source>
        <translation>{0} не зависи од {1}.</translation>
    </message>
    <message>
        <source>It does not shift {0}.</source>
        <translation>Не помера {0}.</translation>
    </message>
    <message>
        <source>It shifts {0} by {2}.</source>
        <translation>Помера {0} за {2}.</translation>
    </message>
    <message>
        <source>It adds {2} to {0} before the divide, and so {2}/w to the quotient.</source>
        <translation>Додаје {2} на {0} пре дељења, а тиме {2}/w на количник.</translation>
    </message>
    <message>
        <source>It adds {1} times {0} to w, the divisor.</source>
        <translation>Делиоцу w додаје {1} пута {0}.</translation>
    </message>
    <message>
        <source>w does not depend on {0}.</source>
        <translation>w не зависи од {0}.</translation>
    </message>
    <message>
        <source>It scales w, the divisor, by {1}.</source>
        <translation>Скалира w, делилац, са {1}.</translation>
    </message>
    <message>
        <source>It leaves w unchanged.</source>
        <translation>Не мења w.</translation>
    </message>
    <message>
        <source>It makes w, the divisor, the distance −z: perspective.</source>
        <translation>Чини да w, делилац, буде растојање −z: перспектива.</translation>
    </message>
    <message>
        <source>It adds {1} to w, the divisor.</source>
        <translation>Додаје {1} на w, делилац.</translation>
    </message>
    <message>
        <source>the incoming w</source>
        <translation>w на улазу</translation>
    </message>
</context>
<context>
    <name>ChainEditor</name>
    <message>
        <source>View: the camera&apos;s moves undone</source>
        <translation>Поглед: поништени покрети камере</translation>
    </message>
    <message>
        <source>The view as R T, or as the inverse of each move</source>
        <translation>Поглед као R T или као инверз сваког покрета</translation>
    </message>
    <message>
        <source>Add a tile</source>
        <translation>Додај плочицу</translation>
    </message>
    <message>
        <source>It acts last: left of the others</source>
        <translation>Делује последња: лево од осталих</translation>
    </message>
    <message>
        <source>Letters</source>
        <translation>Слова</translation>
    </message>
    <message>
        <source>Row vectors</source>
        <translation>Вектори-врсте</translation>
    </message>
    <message>
        <source>Show its factors in Matrices</source>
        <translation>Прикажи његове чиниоце у панелу „Матрице”</translation>
    </message>
    <message>
        <source>The tile at the bottom acts first.</source>
        <translation>Плочица на дну делује прва.</translation>
    </message>
    <message>
        <source>Show the scene after this factor</source>
        <translation>Прикажи сцену после овог чиниоца</translation>
    </message>
</context>
<context>
    <name>ChoiceView</name>
    <message>
        <source>&amp;Commit</source>
        <translation>По&amp;тврди</translation>
    </message>
    <message>
        <source>This is my prediction (Enter)</source>
        <translation>Ово је моје предвиђање (Enter)</translation>
    </message>
    <message>
        <source>Choose one first: with the arrow keys, or a click.</source>
        <translation>Прво изаберите: стрелицама или кликом.</translation>
    </message>
    <message>
        <source>The answer is {0}.</source>
        <translation>Одговор је {0}.</translation>
    </message>
    <message>
        <source>The model&apos;s answer</source>
        <translation>Одговор модела</translation>
    </message>
    <message>
        <source>Your choice</source>
        <translation>Ваш избор</translation>
    </message>
    <message>
        <source>You said {0}; the model says {1}.</source>
        <translation>Рекли сте {0}; модел каже {1}.</translation>
    </message>
    <message>
        <source>Show what happens</source>
        <translation>Прикажи шта се дешава</translation>
    </message>
    <message>
        <source>Show the model&apos;s answer once more</source>
        <translation>Прикажи још једном одговор модела</translation>
    </message>
</context>
<context>
    <name>ClickView</name>
    <message>
        <source>world</source>
        <translation>свет</translation>
    </message>
    <message>
        <source>NDC cube</source>
        <translation>NDC коцка</translation>
    </message>
    <message>
        <source>image</source>
        <translation>слика</translation>
    </message>
    <message>
        <source>Click in the picture: {0}</source>
        <translation>Кликните на слику: {0}</translation>
    </message>
    <message>
        <source>Click there; or here, then move the crosshair with the arrow keys (Enter)</source>
        <translation>Кликните тамо; или овде, па померајте нишан стрелицама (Enter)</translation>
    </message>
    <message>
        <source>The picture shows something else now.</source>
        <translation>Слика сада приказује нешто друго.</translation>
    </message>
    <message>
        <source>Show it a&amp;gain</source>
        <translation>Прика&amp;жи поново</translation>
    </message>
    <message>
        <source>Show the state of the question</source>
        <translation>Прикажи стање из питања</translation>
    </message>
</context>
<context>
    <name>Command</name>
    <message>
        <source>, or in .html for a page</source>
        <translation>, или на .html за страницу</translation>
    </message>
    <message>
        <source>--batch = {0!r}: has no documents (.json, .md) and no meshes.</source>
        <translation>--batch = {0!r}: нема докумената (.json, .md) ни мрежа.</translation>
    </message>
    <message>
        <source>--batch: takes one name, the folder of the figures.</source>
        <translation>--batch: прима једно име, име фасцикле за цртеже.</translation>
    </message>
    <message>
        <source>--chart = {0!r}: must end in {1}.</source>
        <translation>--chart = {0!r}: мора да се завршава на {1}.</translation>
    </message>
    <message>
        <source>--csv: is an option of lesson results, not of lesson {0}.</source>
        <translation>--csv: опција је наредбе lesson results, а не lesson {0}.</translation>
    </message>
    <message>
        <source>--for: needs --handout OUT.pdf.</source>
        <translation>--for: тражи --handout OUT.pdf.</translation>
    </message>
    <message>
        <source>--format: is for a folder or a lesson; in a list the endings decide.</source>
        <translation>--format: служи за фасциклу или лекцију; у списку одлучују завршеци имена.</translation>
    </message>
    <message>
        <source>--handout = {0!r}: must end in .pdf or .html.</source>
        <translation>--handout = {0!r}: мора да се завршава на .pdf или .html.</translation>
    </message>
    <message>
        <source>--hidden: is for .svg, .pdf, .tex and .html, whose lines are shapes.</source>
        <translation>--hidden: служи за .svg, .pdf, .tex и .html, чије су линије облици.</translation>
    </message>
    <message>
        <source>--letters: is an option of lesson check and print, not of lesson {0}.</source>
        <translation>--letters: опција је наредби lesson check и print, а не lesson {0}.</translation>
    </message>
    <message>
        <source>--orbit = {0:g}: must be from -{1:g} to {1:g} degrees, not 0.</source>
        <translation>--orbit = {0:g}: мора да буде од -{1:g} до {1:g} степени, а не 0.</translation>
    </message>
    <message>
        <source>--orbit: needs the pane world, and --panes = {0!r}.</source>
        <translation>--orbit: тражи приказ world, а --panes = {0!r}.</translation>
    </message>
    <message>
        <source>--out = {0!r}: cannot be made a folder: {1}.</source>
        <translation>--out = {0!r}: не може да се направи фасцикла: {1}.</translation>
    </message>
    <message>
        <source>--panes = {0!r}: must be a row or a column, not both.</source>
        <translation>--panes = {0!r}: прикази морају да буду један поред другог или један испод другог, а не обоје.</translation>
    </message>
    <message>
        <source>--scale: is for .png; shapes are as fine at every scale.</source>
        <translation>--scale: служи за .png; облици су у свакој размери једнако фини.</translation>
    </message>
    <message>
        <source>--screenshot = {0!r}: must end in .png.</source>
        <translation>--screenshot = {0!r}: мора да се завршава на .png.</translation>
    </message>
    <message>
        <source>--seeds = {0!r}: has {1} variants; the limit is {2}.</source>
        <translation>--seeds = {0!r}: број варијанти је {1}; граница је {2}.</translation>
    </message>
    <message>
        <source>--seeds = {0!r}: must be FIRST:LAST, such as 1:30, from 1 to {1}.</source>
        <translation>--seeds = {0!r}: мора да буде FIRST:LAST, као 1:30, од 1 до {1}.</translation>
    </message>
    <message>
        <source>--set scene: the steps of a lesson have scenes of their own.</source>
        <translation>--set scene: кораци лекције имају сопствене сцене.</translation>
    </message>
    <message>
        <source>--set {0}: {1} is a lesson, whose steps set what is shown.</source>
        <translation>--set {0}: {1} је лекција, а њени кораци одређују шта се приказује.</translation>
    </message>
    <message>
        <source>--size = {0!r}: must be WIDTHxHEIGHT in pixels, such as 1800x600.</source>
        <translation>--size = {0!r}: мора да буде WIDTHxHEIGHT у пикселима, као 1800x600.</translation>
    </message>
    <message>
        <source>       … and {0} more; --csv has them all</source>
        <translation>       … и још {0}; --csv има све</translation>
    </message>
    <message>
        <source>  installing packages: {0}</source>
        <translation>  инсталирам пакете: {0}</translation>
    </message>
    <message>
        <source> (cancelled)</source>
        <translation> (отказано)</translation>
    </message>
    <message>
        <source> failed</source>
        <translation> није успело</translation>
    </message>
    <message>
        <source> is there already</source>
        <translation> већ постоји</translation>
    </message>
    <message>
        <source>, or have one number such as %03d</source>
        <translation>, или имати један број као %03d</translation>
    </message>
    <message>
        <source>--size, --width and --text-size: need --chart.</source>
        <translation>--size, --width и --text-size: траже --chart.</translation>
    </message>
    <message>
        <source>--stages: needs the pane ndc, and --panes = {0!r}.</source>
        <translation>--stages: тражи приказ ndc, а --panes = {0!r}.</translation>
    </message>
    <message>
        <source>--step = {0!r}: must be a number from 1 to {1}, or the name of a step{2}.</source>
        <translation>--step = {0!r}: мора да буде број од 1 до {1}, или име корака{2}.</translation>
    </message>
    <message>
        <source>--step: is a column of the list of --batch.</source>
        <translation>--step: колона је списка за --batch.</translation>
    </message>
    <message>
        <source>--step: needs a lesson or a talk as FILE.</source>
        <translation>--step: тражи лекцију или презентацију као FILE.</translation>
    </message>
    <message>
        <source>--sweep {0} = &apos;&apos;: must be LOW:HIGH, such as 0.001:10.</source>
        <translation>--sweep {0} = &apos;&apos;: мора да буде LOW:HIGH, као 0.001:10.</translation>
    </message>
    <message>
        <source>--sweep {0} = {1!r}: must be LOW:HIGH, such as 0.001:10.</source>
        <translation>--sweep {0} = {1!r}: мора да буде LOW:HIGH, као 0.001:10.</translation>
    </message>
    <message>
        <source>--sweep {0} = {1!r}: must have LOW below HIGH, both from {2:g} to {3:.15g}.</source>
        <translation>--sweep {0} = {1!r}: LOW мора да буде мање од HIGH, а оба од {2:g} до {3:.15g}.</translation>
    </message>
    <message>
        <source>--topics = {0!r}: has no exercise that can be solved on paper.</source>
        <translation>--topics = {0!r}: нема задатка који може да се реши на папиру.</translation>
    </message>
    <message>
        <source>--topics = {0!r}: must be topics from L1 to L{1}, or files of lessons, separated by commas.</source>
        <translation>--topics = {0!r}: мора да садржи теме од L1 до L{1}, или датотеке лекција, раздвојене зарезима.</translation>
    </message>
    <message>
        <source>--topics = {0!r}: names {1} twice.</source>
        <translation>--topics = {0!r}: наводи {1} двапут.</translation>
    </message>
    <message>
        <source>--transition: needs a lesson or a talk as FILE, and --step.</source>
        <translation>--transition: тражи лекцију или презентацију као FILE, и --step.</translation>
    </message>
    <message>
        <source>--transition: no step comes before --step {0}.</source>
        <translation>--transition: пре --step {0} нема корака.</translation>
    </message>
    <message>
        <source>--transition: step {0} shows another scene or another kind of lens than the step before; nothing moves from one to the other.</source>
        <translation>--transition: корак {0} приказује другу сцену или другу врсту објектива него корак пре њега; од једног до другог се ништа не помера.</translation>
    </message>
    <message>
        <source>--transition: step {0} shows the same as the step before.</source>
        <translation>--transition: корак {0} приказује исто што и корак пре њега.</translation>
    </message>
    <message>
        <source>--transparent: {0} has {1}; write .apng or .webp.</source>
        <translation>--transparent: {0} има {1}; упишите .apng или .webp.</translation>
    </message>
    <message>
        <source>--vectors: needs --convention.</source>
        <translation>--vectors: тражи --convention.</translation>
    </message>
    <message>
        <source>--width = {0!r}: must be a length in {1} from {2}pt to {3}pt, such as 84mm.</source>
        <translation>--width = {0!r}: мора да буде дужина у {1}, од {2}pt до {3}pt, као 84mm.</translation>
    </message>
    <message>
        <source>--width: is cropped, and its height is free; leave out --size and --crop.</source>
        <translation>--width: цртеж се опсеца, и висина му је слободна; изоставите --size и --crop.</translation>
    </message>
    <message>
        <source>--width: its height is free; leave out --size.</source>
        <translation>--width: висина је слободна; изоставите --size.</translation>
    </message>
    <message>
        <source>--{0}: cannot be used with --{1}.</source>
        <translation>--{0}: не може уз --{1}.</translation>
    </message>
    <message>
        <source>--{0}: frames of a film have one size; set --size.</source>
        <translation>--{0}: кадрови филма су једне величине; поставите --size.</translation>
    </message>
    <message>
        <source>--{0}: is an option of lesson print, not of lesson {1}.</source>
        <translation>--{0}: опција је наредбе lesson print, а не lesson {1}.</translation>
    </message>
    <message>
        <source>--{0}: is for single figures; frames of a film have one size.</source>
        <translation>--{0}: служи за појединачне цртеже; кадрови филма су једне величине.</translation>
    </message>
    <message>
        <source>--{0}: is not for .html, whose pictures change under a slider.</source>
        <translation>--{0}: није за .html, чије се слике мењају клизачем.</translation>
    </message>
    <message>
        <source>--{0}: needs --format latex.</source>
        <translation>--{0}: тражи --format latex.</translation>
    </message>
    <message>
        <source>--{0}: needs --sweep.</source>
        <translation>--{0}: тражи --sweep.</translation>
    </message>
    <message>
        <source>--{0}: needs {1}.</source>
        <translation>--{0}: тражи {1}.</translation>
    </message>
    <message>
        <source>--{0}: stands alone, and needs --format text or json.</source>
        <translation>--{0}: стоји сама, и тражи --format text или json.</translation>
    </message>
    <message>
        <source>; for a film add --sweep, --orbit, --stages or --transition</source>
        <translation>; за филм додајте --sweep, --orbit, --stages или --transition</translation>
    </message>
    <message>
        <source>; needs the network</source>
        <translation>; потребна је мрежа</translation>
    </message>
    <message>
        <source>; the nearest is {0}</source>
        <translation>; најближе је {0}</translation>
    </message>
    <message>
        <source>A library cannot be loaded ({0}); {1} doctor says more.</source>
        <translation>Библиотека не може да се учита ({0}); више каже {1} doctor.</translation>
    </message>
    <message>
        <source>Display</source>
        <translation>Екран</translation>
    </message>
    <message>
        <source>Environment</source>
        <translation>Окружење</translation>
    </message>
    <message>
        <source>Everything needed is here.</source>
        <translation>Све што је потребно је ту.</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>Извоз</translation>
    </message>
    <message>
        <source>Left out, because it is done in the window: {0}.</source>
        <translation>Изостављено јер се ради у прозору: {0}.</translation>
    </message>
    <message>
        <source>Log folder</source>
        <translation>Фасцикла дневника</translation>
    </message>
    <message>
        <source>No OpenGL could be started, and 3.2 is needed. {0}</source>
        <translation>OpenGL није могао да се покрене, а потребан је 3.2. {0}</translation>
    </message>
    <message>
        <source>No idea explains (answers; lesson, exercise, variant; what was typed; right):</source>
        <translation>Ниједна погрешна представа не објашњава (одговори; лекција, задатак, варијанта; шта је уписано; тачно):</translation>
    </message>
    <message>
        <source>OUT = {0!r}: .mp4 has even sides in pixels, not {1}; set --size.</source>
        <translation>OUT = {0!r}: .mp4 има парне странице у пикселима, а не {1}; поставите --size.</translation>
    </message>
    <message>
        <source>OUT = {0!r}: .webp has at most {1} pixels along each side.</source>
        <translation>OUT = {0!r}: .webp има дуж сваке странице највише {1} пиксела.</translation>
    </message>
    <message>
        <source>OUT = {0!r}: must be a folder, for the figures.</source>
        <translation>OUT = {0!r}: мора да буде фасцикла, за цртеже.</translation>
    </message>
    <message>
        <source>OUT = {0!r}: must end in {1}{2}.</source>
        <translation>OUT = {0!r}: мора да се завршава на {1}{2}.</translation>
    </message>
    <message>
        <source>Only OpenGL ES is offered here ({0}), not OpenGL 3.2. {1}</source>
        <translation>Овде постоји само OpenGL ES ({0}), а не OpenGL 3.2. {1}</translation>
    </message>
    <message>
        <source>OpenGL {0}.{1} is too old ({2}): 3.2 is needed. {3}</source>
        <translation>OpenGL {0}.{1} је сувише стар ({2}): потребан је 3.2. {3}</translation>
    </message>
    <message>
        <source>P does not say near, far and the size of the image</source>
        <translation>P не одређује предњу и задњу раван ни величину слике</translation>
    </message>
    <message>
        <source>P has w &gt; 0 behind the camera: perhaps y points up in its image</source>
        <translation>P има w &gt; 0 иза камере: можда је y у њеној слици усмерено нагоре</translation>
    </message>
    <message>
        <source>POINTS = {0!r}: must be a CSV file, or - for standard input; for a point: echo {1} | {2} project -.</source>
        <translation>POINTS = {0!r}: мора да буде датотека CSV, или - за стандардни улаз; за једну тачку: echo {1} | {2} project -.</translation>
    </message>
    <message>
        <source>POINTS is missing: {0} gives the camera only.</source>
        <translation>POINTS недостаје: {0} даје само камеру.</translation>
    </message>
    <message>
        <source>Panes</source>
        <translation>Прикази</translation>
    </message>
    <message>
        <source>Platform</source>
        <translation>Платформа</translation>
    </message>
    <message>
        <source>PyInstaller ended with status {0}.</source>
        <translation>PyInstaller је завршио са статусом {0}.</translation>
    </message>
    <message>
        <source>Python {0}, {1} bits, {2},</source>
        <translation>Python {0}, {1}-битни, {2},</translation>
    </message>
    <message>
        <source>QT_QPA_PLATFORM = {0}: must be one of {1}; unset it.</source>
        <translation>QT_QPA_PLATFORM = {0}: мора бити једно од {1}; уклоните ту променљиву.</translation>
    </message>
    <message>
        <source>Qt cannot reach the X server, because a system library is missing ({0}); {1} doctor says which package provides it.</source>
        <translation>Qt не може да дође до X сервера, јер недостаје системска библиотека ({0}); {1} doctor каже који је пакет садржи.</translation>
    </message>
    <message>
        <source>Qt&apos;s platform {0} shows no OpenGL windows. {1}</source>
        <translation>Qt платформа {0} не приказује прозоре са OpenGL-ом. {1}</translation>
    </message>
    <message>
        <source>Recovery folder</source>
        <translation>Опоравак</translation>
    </message>
    <message>
        <source>Screen</source>
        <translation>Монитор</translation>
    </message>
    <message>
        <source>Set aside</source>
        <translation>Занемарено</translation>
    </message>
    <message>
        <source>Settings folder</source>
        <translation>Подешавања</translation>
    </message>
    <message>
        <source>Standard input</source>
        <translation>Стандардни улаз</translation>
    </message>
    <message>
        <source>Standard output cannot be written: {0}.</source>
        <translation>Не може да се пише на стандардни излаз: {0}.</translation>
    </message>
    <message>
        <source>Standard output is closed.</source>
        <translation>Стандардни излаз је затворен.</translation>
    </message>
    <message>
        <source>System libraries</source>
        <translation>Системске библ.</translation>
    </message>
    <message>
        <source>The X server DISPLAY = {0} does not answer or does not let this user in</source>
        <translation>X сервер, DISPLAY = {0}, не одговара или не пушта овог корисника</translation>
    </message>
    <message>
        <source>The other states need scripts.</source>
        <translation>За остала стања потребне су скрипте.</translation>
    </message>
    <message>
        <source>The settings cannot be deleted: {0}.</source>
        <translation>Подешавања не могу да се избришу: {0}.</translation>
    </message>
    <message>
        <source>The window</source>
        <translation>Прозор</translation>
    </message>
    <message>
        <source>There is no screen to open a window on ({0} names none)</source>
        <translation>Нема екрана на ком би се отворио прозор ({0} не именује ниједан)</translation>
    </message>
    <message>
        <source>This is missing:</source>
        <translation>Недостаје:</translation>
    </message>
    <message>
        <source>This page does not keep what you type; print it to keep it.</source>
        <translation>Ова страница не чува оно што упишете; одштампајте је да бисте то сачували.</translation>
    </message>
    <message>
        <source>Update the graphics driver; on Linux install Mesa (libgl1-mesa-dri) or start with LIBGL_ALWAYS_SOFTWARE=1, and over a remote desktop use one that offers OpenGL.</source>
        <translation>Ажурирајте управљачки програм графике; на Linux-у инсталирајте Mesa (libgl1-mesa-dri) или покрените са LIBGL_ALWAYS_SOFTWARE=1, а за удаљену радну површину користите ону која нуди OpenGL.</translation>
    </message>
    <message>
        <source>WIDTHxHEIGHT in {0}, such as 120mmx80mm or 1800x600</source>
        <translation>WIDTHxHEIGHT у {0}, на пример 120mmx80mm или 1800x600</translation>
    </message>
    <message>
        <source>Window</source>
        <translation>Прозор</translation>
    </message>
    <message>
        <source>Wrong ideas (answers, students):</source>
        <translation>Погрешне представе (одговори, студенти):</translation>
    </message>
    <message>
        <source>Your answer</source>
        <translation>Ваш одговор</translation>
    </message>
    <message>
        <source>a finite number</source>
        <translation>коначан број</translation>
    </message>
    <message>
        <source>a font</source>
        <translation>фонт</translation>
    </message>
    <message>
        <source>a length in {0}, such as 84mm</source>
        <translation>дужина у {0}, на пример 84mm</translation>
    </message>
    <message>
        <source>a number of degrees</source>
        <translation>број степени</translation>
    </message>
    <message>
        <source>a number of points</source>
        <translation>број тачака</translation>
    </message>
    <message>
        <source>a part</source>
        <translation>једног дела</translation>
    </message>
    <message>
        <source>a whole number</source>
        <translation>цео број</translation>
    </message>
    <message>
        <source>a whole number from 1 to 17</source>
        <translation>цео број од 1 до 17</translation>
    </message>
    <message>
        <source>a x + b y + c z + d &gt;= 0 in the view volume, in world space</source>
        <translation>a x + b y + c z + d &gt;= 0 у запремини погледа, у координатном систему света</translation>
    </message>
    <message>
        <source>all here</source>
        <translation>све су ту</translation>
    </message>
    <message>
        <source>and {0} more</source>
        <translation>и још {0}</translation>
    </message>
    <message>
        <source>angle = {0}°</source>
        <translation>угао = {0}°</translation>
    </message>
    <message>
        <source>another start is setting up Frustum Lab; waiting for it to finish</source>
        <translation>друго покретање управо поставља Frustum Lab; чекам да заврши</translation>
    </message>
    <message>
        <source>apt-get failed ({0}); try: {1}</source>
        <translation>apt-get није успео ({0}); пробајте: {1}</translation>
    </message>
    <message>
        <source>argument %(argument_name)s: %(message)s</source>
        <translation>%(argument_name)s: %(message)s</translation>
    </message>
    <message>
        <source>at infinity</source>
        <translation>у бесконачности</translation>
    </message>
    <message>
        <source>bringing {0} up to date</source>
        <translation>ажурирам {0}</translation>
    </message>
    <message>
        <source>bundle needs PyInstaller, which is not installed; run: {0}</source>
        <translation>bundle тражи PyInstaller, који није инсталиран; покрените: {0}</translation>
    </message>
    <message>
        <source>bundle: this program has no folder of its code to make one of.</source>
        <translation>bundle: овај програм нема фасциклу свог кода од које би се пакет направио.</translation>
    </message>
    <message>
        <source>cannot be loaded: {0}</source>
        <translation>не може да се учита: {0}</translation>
    </message>
    <message>
        <source>capitals are {0:.1%} of the screen&apos;s height; must be from {1:.1%} to {2:.1%}.</source>
        <translation>велика слова имају {0:.1%} висине екрана; мора бити од {1:.1%} до {2:.1%}.</translation>
    </message>
    <message>
        <source>check the network and run again: {again}</source>
        <translation>проверите мрежу и покрените поново: {again}</translation>
    </message>
    <message>
        <source>close all windows of Frustum Lab and run again: {again}</source>
        <translation>затворите све прозоре програма Frustum Lab и покрените поново: {again}</translation>
    </message>
    <message>
        <source>column vectors, M p</source>
        <translation>вектори колоне, M p</translation>
    </message>
    <message>
        <source>commands are {0}</source>
        <translation>наредбе су {0}</translation>
    </message>
    <message>
        <source>computed in {0}; errors are below: {1}</source>
        <translation>рачунато у {0}; грешке су мање од: {1}</translation>
    </message>
    <message>
        <source>does not answer within {0:g} s</source>
        <translation>не одговара у року од {0:g} s</translation>
    </message>
    <message>
        <source>drawn in the window by OpenGL</source>
        <translation>у прозору их црта OpenGL</translation>
    </message>
    <message>
        <source>drawn off-screen and painted as pixels</source>
        <translation>цртају се ван екрана и приказују као пиксели</translation>
    </message>
    <message>
        <source>exit status {0}</source>
        <translation>излазни статус {0}</translation>
    </message>
    <message>
        <source>expected one argument</source>
        <translation>потребан је један аргумент</translation>
    </message>
    <message>
        <source>file = {0!r}: is a lesson; name its step in a column step, or write a number such as %02d in out = {1!r}.</source>
        <translation>file = {0!r}: ово је лекција; наведите њен корак у колони step, или упишите број као %02d у out = {1!r}.</translation>
    </message>
    <message>
        <source>first start: setting up {0} (once{1})</source>
        <translation>прво покретање: постављам {0} (једном{1})</translation>
    </message>
    <message>
        <source>float32 cannot hold its numbers</source>
        <translation>float32 не може да држи њене бројеве</translation>
    </message>
    <message>
        <source>for x right, y down, z forward; pixels from the centre of the first one</source>
        <translation>за x удесно, y надоле, z напред; пиксели од средине првог</translation>
    </message>
    <message>
        <source>frame {0}/{1}</source>
        <translation>кадар {0}/{1}</translation>
    </message>
    <message>
        <source>going on with the installed packages</source>
        <translation>настављам са инсталираним пакетима</translation>
    </message>
    <message>
        <source>going on with the installed packages, which do not meet {0}</source>
        <translation>настављам са инсталираним пакетима, који не задовољавају {0}</translation>
    </message>
    <message>
        <source>graphics card</source>
        <translation>графичка картица</translation>
    </message>
    <message>
        <source>has {0} columns, but the first row names {1}.</source>
        <translation>број колона је {0}, а први ред их именује {1}.</translation>
    </message>
    <message>
        <source>ignored explicit argument %r</source>
        <translation>не прима вредност %r</translation>
    </message>
    <message>
        <source>inside</source>
        <translation>унутар</translation>
    </message>
    <message>
        <source>install Mesa (libegl1 libegl-mesa0 libgl1-mesa-dri), or update the driver</source>
        <translation>инсталирајте Mesa (libegl1 libegl-mesa0 libgl1-mesa-dri) или ажурирајте управљачки програм</translation>
    </message>
    <message>
        <source>installing system packages: {0}</source>
        <translation>инсталирам системске пакете: {0}</translation>
    </message>
    <message>
        <source>it is a device, neither a file nor a pipe</source>
        <translation>то је уређај, а не датотека ни цев</translation>
    </message>
    <message>
        <source>it is closed</source>
        <translation>затворен је</translation>
    </message>
    <message>
        <source>it is larger than {0} MiB</source>
        <translation>веће је од {0} MiB</translation>
    </message>
    <message>
        <source>its view coordinates are at infinity</source>
        <translation>њене координате у систему камере су у бесконачности</translation>
    </message>
    <message>
        <source>key</source>
        <translation>решења</translation>
    </message>
    <message>
        <source>largest error in px</source>
        <translation>највећа грешка у px</translation>
    </message>
    <message>
        <source>left-handed world: z reversed; the view looks along -z, y up (worldToCameraMatrix)</source>
        <translation>леви систем света: z обрнуто; камера гледа дуж -z, y нагоре (worldToCameraMatrix)</translation>
    </message>
    <message>
        <source>left-handed: world z reversed; looks along +z, y up</source>
        <translation>леви систем: z света обрнуто; гледа дуж +z, y нагоре</translation>
    </message>
    <message>
        <source>lens.kind = matrix: a free matrix has no near, no far and no angle to measure; it must be one of {0}.</source>
        <translation>lens.kind = matrix: слободна матрица нема предњу раван, задњу раван ни угао који би се мерили; мора да буде једно од {0}.</translation>
    </message>
    <message>
        <source>lesson</source>
        <translation>лекција</translation>
    </message>
    <message>
        <source>lesson = {0!r}: must be one of {1}; {2} {0} opens the lesson.</source>
        <translation>lesson = {0!r}: мора да буде једно од {1}; {2} {0} отвара лекцију.</translation>
    </message>
    <message>
        <source>lesson print needs --{0}.</source>
        <translation>lesson print тражи --{0}.</translation>
    </message>
    <message>
        <source>lesson print takes no FILE such as {0!r}: use --topics.</source>
        <translation>lesson print не прима FILE као {0!r}: користите --topics.</translation>
    </message>
    <message>
        <source>lesson results needs a FILE.</source>
        <translation>lesson results тражи FILE.</translation>
    </message>
    <message>
        <source>line</source>
        <translation>ред</translation>
    </message>
    <message>
        <source>looks along -z, y up</source>
        <translation>гледа дуж -z, y нагоре</translation>
    </message>
    <message>
        <source>looks along -z; y of clip down</source>
        <translation>гледа дуж -z; y простора одсецања надоле</translation>
    </message>
    <message>
        <source>make {0} a folder that you may write to</source>
        <translation>нека {0} буде фасцикла у коју смете да пишете</translation>
    </message>
    <message>
        <source>missing</source>
        <translation>недостаје</translation>
    </message>
    <message>
        <source>missing: {0}</source>
        <translation>недостаје: {0}</translation>
    </message>
    <message>
        <source>nearest command is {0}</source>
        <translation>најближа је наредба {0}</translation>
    </message>
    <message>
        <source>no names</source>
        <translation>нула имена</translation>
    </message>
    <message>
        <source>no package server could be reached</source>
        <translation>ниједан сервер пакета није доступан</translation>
    </message>
    <message>
        <source>no smooth edges then</source>
        <translation>тада само оштре ивице</translation>
    </message>
    <message>
        <source>no tested version of {0} here: trying others</source>
        <translation>овде нема испробане верзије пакета {0}: пробам друге</translation>
    </message>
    <message>
        <source>no transparency</source>
        <translation>само непровидне пикселе</translation>
    </message>
    <message>
        <source>no version fits {python} on this machine; use another Python</source>
        <translation>за {python} на овом рачунару нема одговарајуће верзије; користите други Python</translation>
    </message>
    <message>
        <source>none</source>
        <translation>нема</translation>
    </message>
    <message>
        <source>none for windows: {0}</source>
        <translation>нема за прозоре: {0}</translation>
    </message>
    <message>
        <source>none: {0}</source>
        <translation>нема: {0}</translation>
    </message>
    <message>
        <source>not set up yet</source>
        <translation>још није постављено</translation>
    </message>
    <message>
        <source>not without ffmpeg; .webp needs none</source>
        <translation>не без програма ffmpeg; .webp га не тражи</translation>
    </message>
    <message>
        <source>options</source>
        <translation>опције</translation>
    </message>
    <message>
        <source>out = {0!r}: is a link, which may lead out of {1}.</source>
        <translation>out = {0!r}: ово је веза, која може да води изван {1}.</translation>
    </message>
    <message>
        <source>out = {0!r}: is written by {1}.</source>
        <translation>out = {0!r}: већ га уписује {1}.</translation>
    </message>
    <message>
        <source>out = {0!r}: must be a file name without a folder.</source>
        <translation>out = {0!r}: мора да буде име датотеке без фасцикле.</translation>
    </message>
    <message>
        <source>outside of</source>
        <translation>ван:</translation>
    </message>
    <message>
        <source>overwritten</source>
        <translation>замењено</translation>
    </message>
    <message>
        <source>packages</source>
        <translation>пакета</translation>
    </message>
    <message>
        <source>part of the text is only in the speaker&apos;s notes: {0}</source>
        <translation>део текста је само у белешкама предавача: {0}</translation>
    </message>
    <message>
        <source>pip does not find all packages for {0}, Python {1}.</source>
        <translation>pip не налази све пакете за {0}, Python {1}.</translation>
    </message>
    <message>
        <source>point {0}</source>
        <translation>тачка {0}</translation>
    </message>
    <message>
        <source>positional arguments</source>
        <translation>позициони аргументи</translation>
    </message>
    <message>
        <source>put Frustum Lab into a folder that you may write to</source>
        <translation>ставите Frustum Lab у фасциклу у коју смете да пишете</translation>
    </message>
    <message>
        <source>row vectors, p M</source>
        <translation>вектори врсте, p M</translation>
    </message>
    <message>
        <source>run again: {again}; {program} doctor says more</source>
        <translation>покрените поново: {again}; више каже {program} doctor</translation>
    </message>
    <message>
        <source>scale = {0} is free, and so is its sign</source>
        <translation>scale = {0} је слободно, а слободан је и знак</translation>
    </message>
    <message>
        <source>see Window</source>
        <translation>видети Прозор</translation>
    </message>
    <message>
        <source>see the system libraries above</source>
        <translation>видети системске библиотеке изнад</translation>
    </message>
    <message>
        <source>set up in {0:.0f} s</source>
        <translation>постављено за {0:.0f} s</translation>
    </message>
    <message>
        <source>show this help message and exit</source>
        <translation>прикажи ову помоћ и заврши</translation>
    </message>
    <message>
        <source>smallest gap in world units</source>
        <translation>најмањи размак у јединицама света</translation>
    </message>
    <message>
        <source>so far</source>
        <translation>досад</translation>
    </message>
    <message>
        <source>software, without a graphics card</source>
        <translation>програмски, без графичке картице</translation>
    </message>
    <message>
        <source>talk</source>
        <translation>презентација</translation>
    </message>
    <message>
        <source>talk needs --check or --handout OUT.pdf; {0} {1} opens the talk.</source>
        <translation>talk тражи --check или --handout OUT.pdf; {0} {1} отвара презентацију.</translation>
    </message>
    <message>
        <source>the Python packages could not be installed</source>
        <translation>пакети за Python нису могли да се инсталирају</translation>
    </message>
    <message>
        <source>the camera looks along +z, y down; K is in pixels, the first pixel&apos;s centre at 0, 0</source>
        <translation>камера гледа дуж +z, y надоле; K је у пикселима, средина првог пиксела је у 0, 0</translation>
    </message>
    <message>
        <source>the driver crashed (signal {0})</source>
        <translation>управљачки програм се срушио (сигнал {0})</translation>
    </message>
    <message>
        <source>the first start sets it up, which needs the network: {0}</source>
        <translation>поставља га прво покретање, за шта је потребна мрежа: {0}</translation>
    </message>
    <message>
        <source>the following arguments are required: %s</source>
        <translation>недостају аргументи: %s</translation>
    </message>
    <message>
        <source>the package server does not answer; trying again</source>
        <translation>сервер пакета не одговара; пробам поново</translation>
    </message>
    <message>
        <source>the package {0} is damaged ({1}); replace it, and start again: {2}</source>
        <translation>пакет {0} је оштећен ({1}); замените га и покрените поново: {2}</translation>
    </message>
    <message>
        <source>the path {folder} is too long: move the folder of the code nearer to the drive&apos;s root</source>
        <translation>путања {folder} је предуга: преместите фасциклу са кодом ближе корену диска</translation>
    </message>
    <message>
        <source>the picture is at infinity too: w = 0, and lines of this direction stay parallel</source>
        <translation>и слика је у бесконачности: w = 0, па праве тог смера остају паралелне</translation>
    </message>
    <message>
        <source>the point at infinity is behind the eye; the opposite direction has a picture</source>
        <translation>бесконачно далека тачка је иза камере; супротан смер има слику</translation>
    </message>
    <message>
        <source>the point is in front of the eye; its pixel is larger than float64 can hold</source>
        <translation>тачка је испред камере; њен пиксел је већи него што стаје у float64</translation>
    </message>
    <message>
        <source>the point is not in front of the eye</source>
        <translation>тачка није испред камере</translation>
    </message>
    <message>
        <source>the rightmost factor acts first</source>
        <translation>чинилац сасвим десно делује први</translation>
    </message>
    <message>
        <source>the set-up failed</source>
        <translation>постављање није успело</translation>
    </message>
    <message>
        <source>the set-up was stopped; to go on: {0}</source>
        <translation>постављање је прекинуто; за наставак: {0}</translation>
    </message>
    <message>
        <source>the skew {0:.1g} of K is left out: so many px at 45 degrees above or below</source>
        <translation>косина {0:.1g} матрице K је изостављена: толико px на 45 степени изнад или испод</translation>
    </message>
    <message>
        <source>the text is longer or higher than the two lines above the picture.</source>
        <translation>текст је дужи или виши од два реда изнад слике.</translation>
    </message>
    <message>
        <source>the view volume</source>
        <translation>запремине погледа</translation>
    </message>
    <message>
        <source>the window</source>
        <translation>прозор</translation>
    </message>
    <message>
        <source>there is no room</source>
        <translation>нема места</translation>
    </message>
    <message>
        <source>this machine&apos;s rules forbid programs in {folder}; ask who set it up</source>
        <translation>правила овог рачунара забрањују програме у {folder}; питајте онога ко га је поставио</translation>
    </message>
    <message>
        <source>this system lacks {0}; install what provides them, and start again</source>
        <translation>на овом систему недостаје: {0}; инсталирајте оно што то садржи и покрените поново</translation>
    </message>
    <message>
        <source>this system lacks {0}; run: {1}</source>
        <translation>на овом систему недостаје: {0}; покрените: {1}</translation>
    </message>
    <message>
        <source>through {0}</source>
        <translation>преко {0}</translation>
    </message>
    <message>
        <source>too little space is left: free {space} GB beside {folder}, or set TMPDIR if the folder of temporary files is full, and run again: {again}</source>
        <translation>премало је слободног места: ослободите {space} GB на диску на ком је {folder}, или поставите TMPDIR ако је пуна фасцикла привремених датотека, и покрените поново: {again}</translation>
    </message>
    <message>
        <source>unrecognized arguments: %s</source>
        <translation>непознати аргументи: %s</translation>
    </message>
    <message>
        <source>update the graphics driver, or start with LIBGL_ALWAYS_SOFTWARE=1</source>
        <translation>ажурирајте управљачки програм графике или покрените са LIBGL_ALWAYS_SOFTWARE=1</translation>
    </message>
    <message>
        <source>usage: </source>
        <translation>употреба: </translation>
    </message>
    <message>
        <source>view.names has {0}, which no pane draws here.</source>
        <translation>view.names садржи {0}, а то овде не црта ниједан приказ.</translation>
    </message>
    <message>
        <source>way = {0} %</source>
        <translation>пут = {0} %</translation>
    </message>
    <message>
        <source>what is drawn covers {0:.0%} of the width and {1:.0%} of the height; at least {2:.0%} of one of them, and below {3:.0%} also {4:.0%} of the area.</source>
        <translation>нацртано покрива {0:.0%} ширине и {1:.0%} висине; потребно је бар {2:.0%} једног од тога, а ако је мање од {3:.0%}, онда још и {4:.0%} површине.</translation>
    </message>
    <message>
        <source>without a display through {0}, {1}</source>
        <translation>без екрана, преко {0}, {1}</translation>
    </message>
    <message>
        <source>written</source>
        <translation>записано</translation>
    </message>
    <message>
        <source>x, y and z divided by w</source>
        <translation>x, y и z подељени са w</translation>
    </message>
    <message>
        <source>{0!r} is in the current folder, which was deleted.</source>
        <translation>{0!r} је у текућој фасцикли, која је избрисана.</translation>
    </message>
    <message>
        <source>{0!r} is not a name that a file can have.</source>
        <translation>{0!r} није име које датотека може да има.</translation>
    </message>
    <message>
        <source>{0} (needed: {1})</source>
        <translation>{0} (потребно: {1})</translation>
    </message>
    <message>
        <source>{0} = {1!r}: has a character NUL.</source>
        <translation>{0} = {1!r}: садржи знак NUL.</translation>
    </message>
    <message>
        <source>{0} = {1!r}: is a folder.</source>
        <translation>{0} = {1!r}: ово је фасцикла.</translation>
    </message>
    <message>
        <source>{0} = {1!r}: is a pipe or a device, not a regular file.</source>
        <translation>{0} = {1!r}: ово је цев или уређај, а не обична датотека.</translation>
    </message>
    <message>
        <source>{0} = {1!r}: is read by this command; write to another file.</source>
        <translation>{0} = {1!r}: ову датотеку чита ова наредба; упишите у неку другу.</translation>
    </message>
    <message>
        <source>{0} = {1!r}: may not be written.</source>
        <translation>{0} = {1!r}: упис није дозвољен.</translation>
    </message>
    <message>
        <source>{0} = {1!r}: must be one of {2}.</source>
        <translation>{0} = {1!r}: мора да буде једно од {2}.</translation>
    </message>
    <message>
        <source>{0} = {1!r}: must be true or false.</source>
        <translation>{0} = {1!r}: мора да буде true или false.</translation>
    </message>
    <message>
        <source>{0} = {1!r}: must be {2}.</source>
        <translation>{0} = {1!r}: мора да буде {2}.</translation>
    </message>
    <message>
        <source>{0} = {1!r}: there is no folder {2}.</source>
        <translation>{0} = {1!r}: нема фасцикле {2}.</translation>
    </message>
    <message>
        <source>{0} Not measured: {1}.</source>
        <translation>{0} Није мерено: {1}.</translation>
    </message>
    <message>
        <source>{0} cannot be read: {1}.</source>
        <translation>{0} не може да се прочита: {1}.</translation>
    </message>
    <message>
        <source>{0} could not be removed ({1}); close the programs that run in it and run again: {2}</source>
        <translation>{0} није могло да се уклони ({1}); затворите програме који у томе раде и покрените поново: {2}</translation>
    </message>
    <message>
        <source>{0} failed</source>
        <translation>{0} није успело</translation>
    </message>
    <message>
        <source>{0} has no bound</source>
        <translation>{0} нема границу</translation>
    </message>
    <message>
        <source>{0} has no figures: its first row names columns, the others are one.</source>
        <translation>{0} нема цртежа: први ред именује колоне, а сваки од осталих је један цртеж.</translation>
    </message>
    <message>
        <source>{0} has no points: it must have rows of x,y,z.</source>
        <translation>{0} нема тачака: мора да има редове x,y,z.</translation>
    </message>
    <message>
        <source>{0} has {1} kB, and a page for phones should have at most {2} kB: ask for fewer {3}.</source>
        <translation>{0} има {1} kB, а страница за телефоне треба да има највише {2} kB: тражите мање помоћу {3}.</translation>
    </message>
    <message>
        <source>{0} in {1}</source>
        <translation>{0} у {1}</translation>
    </message>
    <message>
        <source>{0} is a command and must come first: {1} {0} ...</source>
        <translation>{0} је наредба и мора да буде прва: {1} {0} ...</translation>
    </message>
    <message>
        <source>{0} is a scene: write --set scene={0}.</source>
        <translation>{0} је сцена: напишите --set scene={0}.</translation>
    </message>
    <message>
        <source>{0} is not a folder; rename or remove it, and run again: {1}</source>
        <translation>{0} није фасцикла; преименујте или уклоните то и покрените поново: {1}</translation>
    </message>
    <message>
        <source>{0} is not an option of {1}; the nearest is {2}.</source>
        <translation>{0} није опција за {1}; најближа је {2}.</translation>
    </message>
    <message>
        <source>{0} lacks {1} although pip installed them; remove it and start again: {2}</source>
        <translation>{0} нема {1} иако их је pip инсталирао; уклоните то и покрените поново: {2}</translation>
    </message>
    <message>
        <source>{0} lacks {1}; start again: {2}</source>
        <translation>{0} нема {1}; покрените поново: {2}</translation>
    </message>
    <message>
        <source>{0} left out: already in these files</source>
        <translation>Изостављено: {0}; већ у овим датотекама</translation>
    </message>
    <message>
        <source>{0} must go to different files.</source>
        <translation>{0} морају да иду у различите датотеке.</translation>
    </message>
    <message>
        <source>{0} not as in the files</source>
        <translation>{0} другачије него у датотекама</translation>
    </message>
    <message>
        <source>{0} of {1}</source>
        <translation>{0} од {1}</translation>
    </message>
    <message>
        <source>{0} or {1}</source>
        <translation>{0} или {1}</translation>
    </message>
    <message>
        <source>{0} takes {1}, and was given {2}.</source>
        <translation>{0} прима {1}, а дато је {2}.</translation>
    </message>
    <message>
        <source>{0} was given an empty name.</source>
        <translation>{0}: дато је празно име.</translation>
    </message>
    <message>
        <source>{0} was made by another program and lacks {1}; complete it with that program, or remove it and start again: {2}</source>
        <translation>{0} је направио други програм и нема {1}; допуните то тим програмом, или уклоните и покрените поново: {2}</translation>
    </message>
    <message>
        <source>{0} wrong</source>
        <translation>погрешно: {0}</translation>
    </message>
    <message>
        <source>{0}, line {1}: is not CSV ({2}).</source>
        <translation>{0}, ред {1}: није CSV ({2}).</translation>
    </message>
    <message>
        <source>{0}, step {1}</source>
        <translation>{0}, корак {1}</translation>
    </message>
    <message>
        <source>{0}, {1} crowded, {2} empty, {3} hidden, {4} cut of {5}</source>
        <translation>{0}, пренатрпано: {1}, празно: {2}, скривено: {3}, одсечено: {4}; укупно: {5}</translation>
    </message>
    <message>
        <source>{0}, {1}: {2} right, {3} wrong, {4} shown, {5} not marked</source>
        <translation>{0}, {1}: тачно {2}, погрешно {3}, приказано {4}, неоцењено {5}</translation>
    </message>
    <message>
        <source>{0}: has no column out, for the names of the figures.</source>
        <translation>{0}: нема колоне out, за имена цртежа.</translation>
    </message>
    <message>
        <source>{0}: has two columns of the same name.</source>
        <translation>{0}: има две колоне истог имена.</translation>
    </message>
    <message>
        <source>{0}: has two columns {1}.</source>
        <translation>{0}: има две колоне {1}.</translation>
    </message>
    <message>
        <source>{0}: {1} drawn, {2} wrong</source>
        <translation>{0}: нацртано: {1}, погрешно: {2}</translation>
    </message>
    <message>
        <source>{0}: {1} x {2} at scale {3:g}</source>
        <translation>{0}: {1} x {2}, размера {3:g}</translation>
    </message>
    <message>
        <source>{0}; Frustum Lab prefers its own packages</source>
        <translation>{0}; Frustum Lab даје предност својим пакетима</translation>
    </message>
    <message>
        <source>{0}; at most {1}.</source>
        <translation>{0}; највише {1}.</translation>
    </message>
    <message>
        <source>“{0}” has an underscore that is not typeset.</source>
        <translation>„{0}” има доњу црту која није сложена као индекс.</translation>
    </message>
    <message>
        <source>“{0}” is cut off at the border.</source>
        <translation>„{0}” је одсечено на ивици.</translation>
    </message>
    <message>
        <source>“{0}” is named and not drawn: there is no place for it.</source>
        <translation>„{0}” је именовано, а није нацртано: нема места.</translation>
    </message>
    <message>
        <source>“{0}” lies behind the viewer.</source>
        <translation>„{0}” лежи иза посматрача.</translation>
    </message>
    <message>
        <source>“{0}” lies on the point that “{1}” names.</source>
        <translation>„{0}” лежи на тачки коју именује „{1}”.</translation>
    </message>
    <message>
        <source>“{0}” lies outside the pane by {1:.1%} of its height.</source>
        <translation>„{0}” лежи ван приказа за {1:.1%} његове висине.</translation>
    </message>
    <message>
        <source>“{0}” overlaps “{1}”.</source>
        <translation>„{0}” се преклапа са „{1}”.</translation>
    </message>
    <message>
        <source>{0}: has {1} columns, must have three: x,y,z, or w too; name other columns in a first row: x,y,z,name.</source>
        <translation>{0}: број колона је {1}, а мора да их буде три: x,y,z, или и w; друге колоне именујте у првом реду: x,y,z,name.</translation>
    </message>
    <message>
        <source>{0!r} is neither a file, a lesson nor a command; the {1}.</source>
        <translation>{0!r} није ни датотека, ни лекција, ни наредба; {1}.</translation>
    </message>
    <message>
        <source>{0}: has {1}, must have three: x,y,z, or w too.</source>
        <translation>{0}: има {1}, а мора да их буде три: x,y,z, или и w.</translation>
    </message>
    <message>
        <source>{0}: is there already; remove it, or choose another folder.</source>
        <translation>{0}: већ постоји; уклоните је, или изаберите другу фасциклу.</translation>
    </message>
    <message>
        <source>{0}: line {1}, step {2} ({3})</source>
        <translation>{0}: ред {1}, корак {2} ({3})</translation>
    </message>
    <message>
        <source>{0}: must name columns x, y and z, or hold a point.</source>
        <translation>{0}: мора да именује колоне x, y и z, или да садржи тачку.</translation>
    </message>
    <message>
        <source>{0}: not writable</source>
        <translation>{0}: нема дозволе за писање</translation>
    </message>
    <message>
        <source>{0}: start the program in a desktop session, over ssh with -X, or with xvfb-run -s &apos;+extension GLX&apos;{1} in front; “export”, “project”, “matrices”, “measure”, “lesson”, “talk --check”, “talk --handout” and “doctor” need no screen.</source>
        <translation>{0}: покрените програм на радној површини, преко ssh са -X, или са xvfb-run -s &apos;+extension GLX&apos;{1} испред; за „export”, „project”, „matrices”, „measure”, „lesson”, „talk --check”, „talk --handout” и „doctor” екран није потребан.</translation>
    </message>
    <message>
        <source>{0}: {1!r} is not a column; the nearest is {2}.</source>
        <translation>{0}: {1!r} није колона; најближа је {2}.</translation>
    </message>
    <message>
        <source>{0}: {1!r} is one column; they are separated by commas.</source>
        <translation>{0}: {1!r} је једна колона; колоне се раздвајају зарезима.</translation>
    </message>
    <message>
        <source>{0}: {1} = {2}: must lie within ±{3}.</source>
        <translation>{0}: {1} = {2}: мора да лежи унутар ±{3}.</translation>
    </message>
    <message>
        <source>There are no settings to delete: {0}</source>
        <translation>Нема подешавања за брисање: {0}</translation>
    </message>
    <message>
        <source>Settings deleted: {0}</source>
        <translation>Подешавања су избрисана: {0}</translation>
    </message>
    <message>
        <source>it is a pipe or a device, not a regular file</source>
        <translation>то је цев или уређај, а не обична датотека</translation>
    </message>
    <message>
        <source>it is larger than {0} GiB</source>
        <translation>веће је од {0} GiB</translation>
    </message>
    <message>
        <source>it is not a regular file</source>
        <translation>то није обична датотека</translation>
    </message>
    <message>
        <source>is neither UTF-8 nor UTF-16 text, and is read as Latin-1; some letters may be wrong</source>
        <translation>није текст ни у UTF-8 ни у UTF-16, па се чита као Latin-1; нека слова могу бити погрешна</translation>
    </message>
    <message>
        <source>is damaged UTF-16 or UTF-32 text; what cannot be read is shown as �</source>
        <translation>оштећен је текст у UTF-16 или UTF-32; нечитљиво се приказује као �</translation>
    </message>
    <message>
        <source>a question or a task</source>
        <translation>питање или задатак</translation>
    </message>
    <message>
        <source>“value:”, “count:”, “matrix:”, “click:”, “order:”, or choices</source>
        <translation>„value:”, „count:”, „matrix:”, „click:”, „order:” или понуђени одговори</translation>
    </message>
    <message>
        <source>{0} and choices</source>
        <translation>{0} и понуђени одговори</translation>
    </message>
    <message>
        <source>the end</source>
        <translation>краја</translation>
    </message>
    <message>
        <source>There is no OpenGL 3.2 to draw with: update the graphics driver; on Linux install Mesa (libegl1 libegl-mesa0 libgl1-mesa-dri) or start with LIBGL_ALWAYS_SOFTWARE=1.</source>
        <translation>Нема OpenGL-а 3.2 за цртање: ажурирајте управљачки програм графике; на Linux-у инсталирајте Mesa (libegl1 libegl-mesa0 libgl1-mesa-dri) или покрените са LIBGL_ALWAYS_SOFTWARE=1.</translation>
    </message>
    <message>
        <source>the whole numbers from 0 to {0}</source>
        <translation>целих бројева од 0 до {0}</translation>
    </message>
    <message>
        <source>the opposite of the segment&apos;s other end</source>
        <translation>супротној другом крају дужи</translation>
    </message>
    <message>
        <source>change a value of the document, such as lens.far=inf; may be repeated; the names are {0} and settings.NAME for a setting of the scene</source>
        <translation>промени вредност у документу, као lens.far=inf; може да се понови; имена су {0} и settings.NAME за подешавање сцене</translation>
    </message>
    <message>
        <source>commands, each with its own --help:</source>
        <translation>наредбе, свака са сопственим --help:</translation>
    </message>
    <message>
        <source>language of messages, lessons and figures (default: the system&apos;s)</source>
        <translation>језик порука, лекција и цртежа (подразумевано: језик система)</translation>
    </message>
    <message>
        <source>{0} and {1}</source>
        <translation>{0} и {1}</translation>
    </message>
    <message>
        <source>Qt has no OpenGL here: VTK draws the panes off the screen.</source>
        <translation>Qt овде нема OpenGL: VTK црта приказе ван екрана.</translation>
    </message>
    <message>
        <source>world</source>
        <translation>свет</translation>
    </message>
    <message>
        <source>view</source>
        <translation>камера</translation>
    </message>
    <message>
        <source>clip</source>
        <translation>одсецање</translation>
    </message>
    <message>
        <source>image px</source>
        <translation>слика px</translation>
    </message>
    <message>
        <source>depth</source>
        <translation>дубина</translation>
    </message>
</context>
<context>
    <name>Compare</name>
    <message>
        <source>Differences between the pictures</source>
        <translation>Разлике између слика</translation>
    </message>
    <message>
        <source>End the comparison (Esc)</source>
        <translation>Заврши поређење (Esc)</translation>
    </message>
    <message>
        <source>End the comparison</source>
        <translation>Заврши поређење</translation>
    </message>
    <message>
        <source>Over each other</source>
        <translation>Једна преко друге</translation>
    </message>
    <message>
        <source>Lay the pictures over each other, with a divider that you can drag</source>
        <translation>Постави слике једну преко друге, са преградом коју можете да превлачите</translation>
    </message>
    <message>
        <source>Side by side</source>
        <translation>Једна поред друге</translation>
    </message>
    <message>
        <source>Show every picture whole, beside the others</source>
        <translation>Прикажи сваку слику целу, поред осталих</translation>
    </message>
    <message>
        <source>held</source>
        <translation>задржана</translation>
    </message>
    <message>
        <source>no difference yet: change something</source>
        <translation>још нема разлике: промените нешто</translation>
    </message>
    <message>
        <source>different shapes: side by side, at equal heights</source>
        <translation>различити облици: једна поред друге, исте висине</translation>
    </message>
</context>
<context>
    <name>Comparing</name>
    <message>
        <source>Compare</source>
        <translation>Упореди</translation>
    </message>
</context>
<context>
    <name>Controls</name>
    <message>
        <source>Controls</source>
        <translation>Контроле</translation>
    </message>
    <message>
        <source>Camera</source>
        <translation>Камера</translation>
    </message>
    <message>
        <source>More of the lens</source>
        <translation>Још о објективу</translation>
    </message>
    <message>
        <source>More of the camera</source>
        <translation>Још о камери</translation>
    </message>
    <message>
        <source>Image and depth range</source>
        <translation>Слика и опсег дубине</translation>
    </message>
    <message>
        <source>Chain</source>
        <translation>Ланац</translation>
    </message>
    <message>
        <source>Animation</source>
        <translation>Анимација</translation>
    </message>
    <message>
        <source>The objects of this scene are fixed, because its numbers depend on them. You can move those of the letter F, the cube, the posts and any mesh.</source>
        <translation>Објекти ове сцене су непомични, јер од њих зависе њени бројеви. Можете да померате слово F, коцку, стубове и сваку мрежу.</translation>
    </message>
    <message>
        <source>Calibrated camera (OpenCV K)</source>
        <translation>Калибрисана камера (OpenCV K)</translation>
    </message>
    <message>
        <source>No camera has the typed view matrix: undo, or choose a lens.</source>
        <translation>Ниједна камера нема унету матрицу погледа: опозовите, или изаберите објектив.</translation>
    </message>
    <message>
        <source>animation play walk turn</source>
        <translation>анимација пусти кружење окретање</translation>
    </message>
    <message>
        <source>{0}: only with the lens “{1}”.</source>
        <translation>{0}: само са објективом „{1}”.</translation>
    </message>
    <message>
        <source>No control has this name.</source>
        <translation>Ниједна контрола нема то име.</translation>
    </message>
</context>
<context>
    <name>Count</name>
    <message numerus="yes">
        <source>%n answers</source>
        <translation>
            <numerusform>%n одговор</numerusform>
            <numerusform>%n одговора</numerusform>
            <numerusform>%n одговора</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n checks</source>
        <translation>
            <numerusform>%n провера</numerusform>
            <numerusform>%n провере</numerusform>
            <numerusform>%n провера</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n columns</source>
        <translation>
            <numerusform>%n колона</numerusform>
            <numerusform>%n колоне</numerusform>
            <numerusform>%n колона</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n files</source>
        <translation>
            <numerusform>%n датотека</numerusform>
            <numerusform>%n датотеке</numerusform>
            <numerusform>%n датотека</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n labels</source>
        <translation>
            <numerusform>%n натпис</numerusform>
            <numerusform>%n натписа</numerusform>
            <numerusform>%n натписа</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n lessons</source>
        <translation>
            <numerusform>%n лекција</numerusform>
            <numerusform>%n лекције</numerusform>
            <numerusform>%n лекција</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n marks</source>
        <translation>
            <numerusform>%n оцена</numerusform>
            <numerusform>%n оцене</numerusform>
            <numerusform>%n оцена</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n names</source>
        <translation>
            <numerusform>%n име</numerusform>
            <numerusform>%n имена</numerusform>
            <numerusform>%n имена</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n overlaps</source>
        <translation>
            <numerusform>%n преклапање</numerusform>
            <numerusform>%n преклапања</numerusform>
            <numerusform>%n преклапања</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n steps</source>
        <translation>
            <numerusform>%n корак</numerusform>
            <numerusform>%n корака</numerusform>
            <numerusform>%n корака</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n talks</source>
        <translation>
            <numerusform>%n презентација</numerusform>
            <numerusform>%n презентације</numerusform>
            <numerusform>%n презентација</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n warnings</source>
        <translation>
            <numerusform>%n упозорење</numerusform>
            <numerusform>%n упозорења</numerusform>
            <numerusform>%n упозорења</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n exercises</source>
        <translation>
            <numerusform>%n задатак</numerusform>
            <numerusform>%n задатка</numerusform>
            <numerusform>%n задатака</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n minutes</source>
        <translation>
            <numerusform>%n минут</numerusform>
            <numerusform>%n минута</numerusform>
            <numerusform>%n минута</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n samples</source>
        <translation>
            <numerusform>%n узорак</numerusform>
            <numerusform>%n узорка</numerusform>
            <numerusform>%n узорака</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>CoverCard</name>
    <message>
        <source>Close</source>
        <translation>Затвори</translation>
    </message>
</context>
<context>
    <name>Cursor</name>
    <message>
        <source>No other vertex is visible</source>
        <translation>Ниједно друго теме није видљиво</translation>
    </message>
    <message>
        <source>There is nothing else to drag</source>
        <translation>Нема ничег другог за превлачење</translation>
    </message>
    <message>
        <source>There is nothing to drag here</source>
        <translation>Овде нема ничега за превлачење</translation>
    </message>
    <message>
        <source>Point {0} ({1})</source>
        <translation>Тачка {0} ({1})</translation>
    </message>
    <message>
        <source>Vertex ({0})</source>
        <translation>Теме ({0})</translation>
    </message>
</context>
<context>
    <name>Description</name>
    <message>
        <source>All of the scene&apos;s objects lie inside the view volume.</source>
        <translation>Сви објекти сцене су унутар запремине погледа.</translation>
    </message>
    <message>
        <source>Cube: the scene in {0} coordinates.</source>
        <translation>Коцка: сцена, координате: {0}.</translation>
    </message>
    <message>
        <source>Cube: the scene on its way from {0} to {1} coordinates.</source>
        <translation>Коцка: сцена на путу од координата „{0}” до координата „{1}”.</translation>
    </message>
    <message>
        <source>Equation: {0}.</source>
        <translation>Једначина: {0}.</translation>
    </message>
    <message>
        <source>Image: the picture, {0} by {1} pixels.</source>
        <translation>Слика: {0} пута {1} пиксела.</translation>
    </message>
    <message>
        <source>Lens: {0}, near {1}, far {2}.</source>
        <translation>Објектив: {0}, предња раван {1}, задња раван {2}.</translation>
    </message>
    <message>
        <source>Lens: {0}.</source>
        <translation>Објектив: {0}.</translation>
    </message>
    <message>
        <source>Parts of the scene&apos;s objects lie behind the eye, where a point has no picture.</source>
        <translation>Делови објеката сцене су иза камере, где тачка нема слику.</translation>
    </message>
    <message>
        <source>Parts of the scene&apos;s objects lie outside of these planes: {0}.</source>
        <translation>Делови објеката сцене су са спољне стране ових равни: {0}.</translation>
    </message>
    <message>
        <source>Point {0} at ({1}) has its picture at the pixel ({2}).</source>
        <translation>Тачка {0} са координатама ({1}) има слику у пикселу ({2}).</translation>
    </message>
    <message>
        <source>Point {0} has no picture.</source>
        <translation>Тачка {0} нема слику.</translation>
    </message>
    <message>
        <source>Point {0}, at infinity in the direction ({1}), has its picture at ({2}).</source>
        <translation>Тачка {0}, бесконачно далека у смеру ({1}), има слику у ({2}).</translation>
    </message>
    <message>
        <source>The eye is at ({0}) and looks at ({1}).</source>
        <translation>Позиција камере је ({0}), а гледа у ({1}).</translation>
    </message>
    <message>
        <source>The file is drawn with triangles: {0}, lines: {1}, points: {2}.</source>
        <translation>Датотека је нацртана; број троуглова: {0}, линија: {1}, тачака: {2}.</translation>
    </message>
    <message>
        <source>The vertical field of view is {0}°.</source>
        <translation>Вертикално видно поље је {0}°.</translation>
    </message>
    <message>
        <source>World: the scene along the camera&apos;s axis, in parallel projection.</source>
        <translation>Свет: сцена дуж осе камере, у паралелној пројекцији.</translation>
    </message>
    <message>
        <source>World: the scene as the camera sees it.</source>
        <translation>Свет: сцена како је види камера.</translation>
    </message>
    <message>
        <source>World: the scene from a free viewpoint.</source>
        <translation>Свет: сцена из слободног угла.</translation>
    </message>
    <message>
        <source>World: the scene from above the camera, in parallel projection.</source>
        <translation>Свет: сцена изнад камере, у паралелној пројекцији.</translation>
    </message>
    <message>
        <source>World: the scene from the camera&apos;s side, in parallel projection.</source>
        <translation>Свет: сцена са бока камере, у паралелној пројекцији.</translation>
    </message>
    <message>
        <source>canonical parallel</source>
        <translation>стандардне паралелне</translation>
    </message>
    <message>
        <source>canonical perspective</source>
        <translation>стандардне перспективне</translation>
    </message>
    <message>
        <source>image</source>
        <translation>слика</translation>
    </message>
    <message>
        <source>normalized device</source>
        <translation>нормализоване (NDC)</translation>
    </message>
    <message>
        <source>view</source>
        <translation>камера</translation>
    </message>
    <message>
        <source>world</source>
        <translation>свет</translation>
    </message>
    <message>
        <source>{0} pictures are compared.</source>
        <translation>Број слика које се пореде: {0}.</translation>
    </message>
</context>
<context>
    <name>DiagramView</name>
    <message>
        <source>Copy this diagram</source>
        <translation>Копирај овај дијаграм</translation>
    </message>
    <message>
        <source>Export this diagram…</source>
        <translation>Извези овај дијаграм…</translation>
    </message>
</context>
<context>
    <name>Divider</name>
    <message>
        <source>Divider between two pictures</source>
        <translation>Преграда између две слике</translation>
    </message>
    <message>
        <source>Drag it, or press ← → (with Shift for finer steps), Home or End; Esc ends the comparison</source>
        <translation>Превуците је, или притисните ← → (уз Shift за ситније кораке), Home или End; Esc завршава поређење</translation>
    </message>
</context>
<context>
    <name>DrawnQuality</name>
    <message>
        <source>A pane cannot draw with {0}: it uses its default smoothing</source>
        <translation>Приказ не може да црта са {0}: користи своје подразумевано умекшавање</translation>
    </message>
    <message>
        <source>The scene has too few triangles to leave any out</source>
        <translation>Сцена има премало троуглова да би се иједан изоставио</translation>
    </message>
    <message>
        <source>A textured surface can be drawn in float32 only</source>
        <translation>Површ са текстуром може да се црта само у float32</translation>
    </message>
    <message>
        <source>The image uses the ordinary depth buffer: {0}</source>
        <translation>Слика користи обичан бафер дубине: {0}</translation>
    </message>
    <message>
        <source>A picture takes {0} ms to draw, so dragging stutters; a smaller window is smoother</source>
        <translation>Слика се црта {0} ms, па превлачење запиње; у мањем прозору је глађе</translation>
    </message>
    <message>
        <source>This computer&apos;s OpenGL gives {0} per pixel instead of {1}</source>
        <translation>OpenGL овог рачунара даје {0} по пикселу уместо {1}</translation>
    </message>
</context>
<context>
    <name>EquationSlide</name>
    <message>
        <source>turns</source>
        <translation>окреће</translation>
    </message>
    <message>
        <source>moves</source>
        <translation>помера</translation>
    </message>
</context>
<context>
    <name>ErrorReport</name>
    <message>
        <source>Something went wrong</source>
        <translation>Нешто је пошло наопако</translation>
    </message>
    <message>
        <source>Copy details</source>
        <translation>Копирај детаље</translation>
    </message>
    <message>
        <source>Copies the details that a developer needs</source>
        <translation>Копира детаље који су потребни програмеру</translation>
    </message>
    <message>
        <source>An error in the program: {0}. Your work is still there.</source>
        <translation>Грешка у програму: {0}. Ваш рад је и даље ту.</translation>
    </message>
    <message>
        <source>Another error followed it.</source>
        <translation>Уследила је још једна грешка.</translation>
    </message>
    <message>
        <source>{0} more errors followed it.</source>
        <translation>Број грешака које су уследиле: {0}.</translation>
    </message>
    <message>
        <source>There is no log, because it could not be written.</source>
        <translation>Нема дневника, јер није могао да се упише.</translation>
    </message>
    <message>
        <source>The log: {0}</source>
        <translation>Дневник: {0}</translation>
    </message>
</context>
<context>
    <name>Exam</name>
    <message>
        <source>Test: {0}</source>
        <translation>Тест: {0}</translation>
    </message>
    <message>
        <source>{0}, variant {1}</source>
        <translation>{0}, варијанта {1}</translation>
    </message>
    <message>
        <source>Key: {0}</source>
        <translation>Решења: {0}</translation>
    </message>
    <message>
        <source>Variant {0}</source>
        <translation>Варијанта {0}</translation>
    </message>
    <message>
        <source>Wrong ideas:</source>
        <translation>Погрешне представе:</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Име</translation>
    </message>
    <message>
        <source>Date</source>
        <translation>Датум</translation>
    </message>
    <message>
        <source>A sketch, not to scale.</source>
        <translation>Скица, није у размери.</translation>
    </message>
    <message>
        <source>Mark the place in the picture with a cross.</source>
        <translation>Обележите место на слици крстићем.</translation>
    </message>
    <message>
        <source>Answer:</source>
        <translation>Одговор:</translation>
    </message>
    <message>
        <source>Write the letters of the tiles as a product: what stands on the right acts first.</source>
        <translation>Напишите слова плочица као производ: прва делује десна.</translation>
    </message>
</context>
<context>
    <name>ExerciseView</name>
    <message>
        <source>Number of the variant</source>
        <translation>Број варијанте</translation>
    </message>
    <message>
        <source>The same number gives the same exercise to everyone (Enter)</source>
        <translation>Исти број свима даје исти задатак (Enter)</translation>
    </message>
    <message>
        <source>Be&amp;gin</source>
        <translation>По&amp;чни</translation>
    </message>
    <message>
        <source>Draw the numbers, and show their state</source>
        <translation>Извуци бројеве и прикажи њихово стање</translation>
    </message>
    <message>
        <source>Another &amp;one</source>
        <translation>Још &amp;један</translation>
    </message>
    <message>
        <source>The same exercise with new numbers</source>
        <translation>Исти задатак са новим бројевима</translation>
    </message>
    <message>
        <source>Exercise</source>
        <translation>Задатак</translation>
    </message>
    <message>
        <source>Variant</source>
        <translation>Варијанта</translation>
    </message>
</context>
<context>
    <name>ExportDialog</name>
    <message>
        <source>Export a picture</source>
        <translation>Извези слику</translation>
    </message>
    <message>
        <source>Height of the letters in points, 72 to an inch; at scale 1 an inch has {0} pixels</source>
        <translation>Висина слова у тачкама, 72 у инчу; при размери 1 инч има {0} пиксела</translation>
    </message>
    <message>
        <source>Width of the picture</source>
        <translation>Ширина слике</translation>
    </message>
    <message>
        <source>Height of the picture</source>
        <translation>Висина слике</translation>
    </message>
    <message>
        <source>Height of the letters in points</source>
        <translation>Висина слова у тачкама</translation>
    </message>
    <message>
        <source>The file&apos;s format; SVG, PDF and TEX (TikZ) have shapes and text, no pixels. Films and many at once: the command “export”</source>
        <translation>Формат датотеке; SVG, PDF и TEX (TikZ) имају облике и текст, без пиксела. Филмови и више слика одједном: наредба „export”</translation>
    </message>
    <message>
        <source>&amp;Format</source>
        <translation>&amp;Формат</translation>
    </message>
    <message>
        <source>Panes</source>
        <translation>Прикази</translation>
    </message>
    <message>
        <source>Whether the panes stand beside or below each other</source>
        <translation>Да ли прикази стоје један поред другог или један испод другог</translation>
    </message>
    <message>
        <source>in a row</source>
        <translation>у реду</translation>
    </message>
    <message>
        <source>in a column</source>
        <translation>у колони</translation>
    </message>
    <message>
        <source>&amp;Arranged</source>
        <translation>&amp;Распоред</translation>
    </message>
    <message>
        <source>Unit of the size; a picture has {0} pixels an inch</source>
        <translation>Јединица величине; слика има {0} пиксела по инчу</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Величина</translation>
    </message>
    <message>
        <source>&amp;Letters (pt)</source>
        <translation>&amp;Слова (pt)</translation>
    </message>
    <message>
        <source>In print, faces and lines that differ in colour differ in grey, too</source>
        <translation>За штампу: стране и линије које се разликују по боји разликују се и по нијанси сиве</translation>
    </message>
    <message>
        <source>as on the screen</source>
        <translation>као на екрану</translation>
    </message>
    <message>
        <source>for print</source>
        <translation>за штампу</translation>
    </message>
    <message>
        <source>dark</source>
        <translation>тамне</translation>
    </message>
    <message>
        <source>most contrast</source>
        <translation>највећи контраст</translation>
    </message>
    <message>
        <source>C&amp;olours</source>
        <translation>&amp;Боје</translation>
    </message>
    <message>
        <source>What becomes of lines behind faces, in SVG, PDF and TEX</source>
        <translation>Шта бива са линијама иза страна, у SVG, PDF и TEX</translation>
    </message>
    <message>
        <source>left out</source>
        <translation>изостављене</translation>
    </message>
    <message>
        <source>dashed</source>
        <translation>испрекидане</translation>
    </message>
    <message>
        <source>grey</source>
        <translation>сиве</translation>
    </message>
    <message>
        <source>&amp;Hidden lines</source>
        <translation>С&amp;кривене линије</translation>
    </message>
    <message>
        <source>Draws the same PNG with more pixels; text and lines scale with it</source>
        <translation>Црта исти PNG са више пиксела; текст и линије расту заједно са њим</translation>
    </message>
    <message>
        <source>Scal&amp;e</source>
        <translation>Раз&amp;мера</translation>
    </message>
    <message>
        <source>What is behind the picture</source>
        <translation>Шта је иза слике</translation>
    </message>
    <message>
        <source>filled</source>
        <translation>попуњена</translation>
    </message>
    <message>
        <source>transparent</source>
        <translation>провидна</translation>
    </message>
    <message>
        <source>&amp;Background</source>
        <translation>&amp;Позадина</translation>
    </message>
    <message>
        <source>C&amp;rop to the content</source>
        <translation>Исе&amp;ци на садржај</translation>
    </message>
    <message>
        <source>Leaves a margin of 2 mm around what is drawn</source>
        <translation>Оставља маргину од 2 mm око нацртаног</translation>
    </message>
    <message>
        <source>Preview</source>
        <translation>Преглед</translation>
    </message>
    <message>
        <source>Letters</source>
        <translation>Слова</translation>
    </message>
    <message>
        <source>Choose at least one pane.</source>
        <translation>Изаберите бар један приказ.</translation>
    </message>
    <message>
        <source>Width and height must be whole numbers.</source>
        <translation>Ширина и висина морају бити цели бројеви.</translation>
    </message>
    <message>
        <source>Drawing the preview</source>
        <translation>Црта се преглед</translation>
    </message>
</context>
<context>
    <name>Factor</name>
    <message>
        <source>division by w</source>
        <translation>дељење са w</translation>
    </message>
    <message>
        <source>mirror</source>
        <translation>рефлексија</translation>
    </message>
    <message>
        <source>rotation</source>
        <translation>ротација</translation>
    </message>
    <message>
        <source>rotation about x</source>
        <translation>ротација око x</translation>
    </message>
    <message>
        <source>rotation about y</source>
        <translation>ротација око y</translation>
    </message>
    <message>
        <source>rotation about z</source>
        <translation>ротација око z</translation>
    </message>
    <message>
        <source>scale</source>
        <translation>скалирање</translation>
    </message>
    <message>
        <source>shear</source>
        <translation>смицање</translation>
    </message>
    <message>
        <source>translation</source>
        <translation>транслација</translation>
    </message>
    <message>
        <source>typed matrix</source>
        <translation>унета матрица</translation>
    </message>
    <message>
        <source>x, y, z divided by w</source>
        <translation>x, y, z подељени са w</translation>
    </message>
</context>
<context>
    <name>Field</name>
    <message>
        <source>Image</source>
        <translation>Слика</translation>
    </message>
    <message>
        <source>Answer</source>
        <translation>Одговор</translation>
    </message>
    <message>
        <source>{0} {1}</source>
        <translation>{0} {1}</translation>
    </message>
    <message>
        <source>degrees</source>
        <translation>степени</translation>
    </message>
    <message>
        <source>units</source>
        <translation>јединица</translation>
    </message>
    <message>
        <source>world units</source>
        <translation>јединица света</translation>
    </message>
    <message>
        <source>mm</source>
        <translation>mm</translation>
    </message>
    <message>
        <source>millimetres</source>
        <translation>милиметара</translation>
    </message>
    <message>
        <source>px</source>
        <translation>px</translation>
    </message>
    <message>
        <source>pixels</source>
        <translation>пиксела</translation>
    </message>
    <message>
        <source>×</source>
        <translation>×</translation>
    </message>
    <message>
        <source>times</source>
        <translation>пута</translation>
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
        <translation>Додаје умножак једне координате другој: смицање xy помера x заједно са y.</translation>
    </message>
    <message>
        <source>Alpha</source>
        <translation>Алфа</translation>
    </message>
    <message>
        <source>Angle between the bottom and the top of the frustum, as seen from the eye.</source>
        <translation>Угао између доње и горње стране зарубљене пирамиде, гледано из позиције камере.</translation>
    </message>
    <message>
        <source>Angle between the left and the right of the frustum, as seen from the eye: the vertical field of view and the aspect in one number.</source>
        <translation>Угао између леве и десне стране зарубљене пирамиде, гледано из позиције камере: вертикално видно поље и однос ширине и висине у једном броју.</translation>
    </message>
    <message>
        <source>Angle of the projectors with the x axis, seen from above: H of lecture 002 adds (z + near) cot(alpha) to x. Points on the near plane do not move.</source>
        <translation>Угао зрака пројекције са осом x, гледано одозго: H из предавања 002 додаје (z + near) cot(alpha) на x. Тачке на предњој равни се не померају.</translation>
    </message>
    <message>
        <source>Angle of the projectors with the y axis, seen from the side: H of lecture 002 adds (z + near) cot(beta) to y. Points on the near plane do not move.</source>
        <translation>Угао зрака пројекције са осом y, гледано са стране: H из предавања 002 додаје (z + near) cot(beta) на y. Тачке на предњој равни се не померају.</translation>
    </message>
    <message>
        <source>Any four by four matrix with an inverse that leaves w alone.</source>
        <translation>Било која матрица четири пута четири са инверзом која не мења w.</translation>
    </message>
    <message>
        <source>Aspect</source>
        <translation>Однос ширине и висине</translation>
    </message>
    <message>
        <source>Azimuth</source>
        <translation>Азимут</translation>
    </message>
    <message>
        <source>Beta</source>
        <translation>Бета</translation>
    </message>
    <message>
        <source>Bottom</source>
        <translation>Доле</translation>
    </message>
    <message>
        <source>Bottom edge of the picture&apos;s window on the near plane: where the view volume begins in y of view space.</source>
        <translation>Доња ивица прозора слике на предњој равни: где запремина погледа почиње по y координатног система камере.</translation>
    </message>
    <message>
        <source>Chain</source>
        <translation>Ланац</translation>
    </message>
    <message>
        <source>Depth is drawn at full length, rising at 30°.</source>
        <translation>Дубина се црта у пуној дужини, са успоном од 30°.</translation>
    </message>
    <message>
        <source>Depth is drawn at full length, rising at 45°.</source>
        <translation>Дубина се црта у пуној дужини, са успоном од 45°.</translation>
    </message>
    <message>
        <source>Depth is drawn at full length, rising at 63.4°.</source>
        <translation>Дубина се црта у пуној дужини, са успоном од 63.4°.</translation>
    </message>
    <message>
        <source>Depth is drawn at half its length, rising at 30°.</source>
        <translation>Дубина се црта у половини дужине, са успоном од 30°.</translation>
    </message>
    <message>
        <source>Depth is drawn at half its length, rising at 45°.</source>
        <translation>Дубина се црта у половини дужине, са успоном од 45°.</translation>
    </message>
    <message>
        <source>Depth is drawn at half its length, rising at 63.4°.</source>
        <translation>Дубина се црта у половини дужине, са успоном од 63.4°.</translation>
    </message>
    <message>
        <source>Depth range</source>
        <translation>Опсег дубине</translation>
    </message>
    <message>
        <source>Direct3D: 0 to 1</source>
        <translation>Direct3D: 0 до 1</translation>
    </message>
    <message>
        <source>Direction</source>
        <translation>Смер</translation>
    </message>
    <message>
        <source>Direction in which depth is drawn, anticlockwise from the right. The target stays in its place in the picture.</source>
        <translation>Смер у коме се црта дубина, супротно од казаљке на сату почев од десне стране. Циљ остаје на свом месту на слици.</translation>
    </message>
    <message>
        <source>Distance</source>
        <translation>Растојање</translation>
    </message>
    <message>
        <source>Distance from the eye to the far plane: nothing farther is drawn. A perspective lens also takes inf (∞), at the slider&apos;s end.</source>
        <translation>Растојање од позиције камере до задње равни: ништа даље се не црта. Перспективни објектив прима и inf (∞), на крају клизача.</translation>
    </message>
    <message>
        <source>Distance from the eye to the near plane: nothing nearer is drawn. The closer to 0, the coarser the depth buffer of a perspective lens.</source>
        <translation>Растојање од позиције камере до предње равни: ништа ближе се не црта. Што је ближе 0, то је бафер дубине перспективног објектива грубљи.</translation>
    </message>
    <message>
        <source>Distance from the target to the eye.</source>
        <translation>Растојање од циља до позиције камере.</translation>
    </message>
    <message>
        <source>Drag along the axis to stretch the object</source>
        <translation>Превуците дуж осе да растегнете објекат</translation>
    </message>
    <message>
        <source>Drag in a circle to turn the object</source>
        <translation>Превуците укруг да окренете објекат</translation>
    </message>
    <message>
        <source>Drag the eye (Shift: up and down)</source>
        <translation>Превуците позицију камере (Shift: горе и доле)</translation>
    </message>
    <message>
        <source>Drag the far plane</source>
        <translation>Превуците задњу раван</translation>
    </message>
    <message>
        <source>Drag the near plane</source>
        <translation>Превуците предњу раван</translation>
    </message>
    <message>
        <source>Drag the object (Shift: up and down)</source>
        <translation>Превуците објекат (Shift: горе и доле)</translation>
    </message>
    <message>
        <source>Drag the target (Shift: up and down)</source>
        <translation>Превуците циљ (Shift: горе и доле)</translation>
    </message>
    <message>
        <source>Drag the tip of up</source>
        <translation>Превуците врх вектора нагоре</translation>
    </message>
    <message>
        <source>Drag the window&apos;s edge (Shift: both sides)</source>
        <translation>Превуците ивицу прозора (Shift: обе стране)</translation>
    </message>
    <message>
        <source>Drag to change the field of view</source>
        <translation>Превуците да промените видно поље</translation>
    </message>
    <message>
        <source>Drawing</source>
        <translation>Цртеж</translation>
    </message>
    <message>
        <source>Drawn length of a line perpendicular to the picture, relative to its true length: 1 is a cavalier, 0.5 a cabinet drawing, 0 orthographic. The target stays in its place in the picture.</source>
        <translation>Нацртана дужина праве управне на слику, у односу на њену стварну дужину: 1 је кавалјер, 0.5 кабинет, 0 ортографски цртеж. Циљ остаје на свом месту на слици.</translation>
    </message>
    <message>
        <source>Elevation</source>
        <translation>Елевација</translation>
    </message>
    <message>
        <source>Eye</source>
        <translation>Позиција камере</translation>
    </message>
    <message>
        <source>Far</source>
        <translation>Задња раван</translation>
    </message>
    <message>
        <source>Field of view</source>
        <translation>Видно поље</translation>
    </message>
    <message>
        <source>Focal length</source>
        <translation>Жижна даљина</translation>
    </message>
    <message>
        <source>Focal length e</source>
        <translation>Жижна даљина e</translation>
    </message>
    <message>
        <source>Focal length in pixel heights: K&apos;s second diagonal entry. Equal to fx if the pixels are square.</source>
        <translation>Жижна даљина у висинама пиксела: други дијагонални елемент матрице K. Једнака је fx ако су пиксели квадратни.</translation>
    </message>
    <message>
        <source>Focal length in pixel widths: K&apos;s first diagonal entry.</source>
        <translation>Жижна даљина у ширинама пиксела: први дијагонални елемент матрице K.</translation>
    </message>
    <message>
        <source>Focal length of a 35 mm film camera (36 × 24 mm) with the same diagonal field of view: below 35 is wide angle, above 70 telephoto.</source>
        <translation>Жижна даљина фотоапарата за филм од 35 mm (36 × 24 mm) са истим дијагоналним видним пољем: испод 35 је широкоугаони објектив, изнад 70 телеобјектив.</translation>
    </message>
    <message>
        <source>Half the height of the picture on the near plane: glFrustum&apos;s top, and −bottom. With near it sets the field of view.</source>
        <translation>Половина висине слике на предњој равни: top у glFrustum, и −bottom. Заједно са предњом равни одређује видно поље.</translation>
    </message>
    <message>
        <source>Half the width of the picture on the near plane: glFrustum&apos;s right, and −left. With near it sets the field of view.</source>
        <translation>Половина ширине слике на предњој равни: right у glFrustum, и −left. Заједно са предњом равни одређује видно поље.</translation>
    </message>
    <message>
        <source>Half-height</source>
        <translation>Пола висине</translation>
    </message>
    <message>
        <source>Half-width</source>
        <translation>Пола ширине</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Висина</translation>
    </message>
    <message>
        <source>Height above the target&apos;s horizon as an angle: 90 looks straight down.</source>
        <translation>Висина изнад хоризонта циља као угао: 90 гледа право надоле.</translation>
    </message>
    <message>
        <source>Height of the picture in pixels.</source>
        <translation>Висина слике у пикселима.</translation>
    </message>
    <message>
        <source>Horizontal fov</source>
        <translation>Хоризонтално видно поље</translation>
    </message>
    <message>
        <source>How the window follows the aspect of the image.</source>
        <translation>Како прозор прати однос ширине и висине слике.</translation>
    </message>
    <message>
        <source>K intrinsics calibrated camera OpenCV principal point</source>
        <translation>K унутрашњи параметри калибрисана камера OpenCV главна тачка</translation>
    </message>
    <message>
        <source>Kind of projection. Objects at the target keep their size when it changes.</source>
        <translation>Врста пројекције. Објекти код циља задржавају величину када се она промени.</translation>
    </message>
    <message>
        <source>Lecture 003&apos;s focal length e = 1/tan(fov/2), with the horizontal fov: at this distance the picture reaches from x = −1 to 1.</source>
        <translation>Жижна даљина из предавања 003, e = 1/tan(fov/2), са хоризонталним видним пољем: на том растојању слика досеже од x = −1 до 1.</translation>
    </message>
    <message>
        <source>Left</source>
        <translation>Лево</translation>
    </message>
    <message>
        <source>Left edge of the picture&apos;s window on the near plane: where the view volume begins in x of view space.</source>
        <translation>Лева ивица прозора слике на предњој равни: где запремина погледа почиње по x координатног система камере.</translation>
    </message>
    <message>
        <source>Lens</source>
        <translation>Објектив</translation>
    </message>
    <message>
        <source>Moves the object along the axes of the tiles to its left.</source>
        <translation>Помера објекат дуж оса плочица лево од себе.</translation>
    </message>
    <message>
        <source>NDC z</source>
        <translation>NDC z</translation>
    </message>
    <message>
        <source>Near</source>
        <translation>Предња раван</translation>
    </message>
    <message>
        <source>Near goes to 0, far to 1.</source>
        <translation>Предња раван прелази у 0, задња у 1.</translation>
    </message>
    <message>
        <source>Near goes to 1, far to 0: floats are densest where depth needs them.</source>
        <translation>Предња раван прелази у 1, задња у 0: бројеви у покретном зарезу најгушћи су тамо где су дубини потребни.</translation>
    </message>
    <message>
        <source>Near goes to −1, far to 1.</source>
        <translation>Предња раван прелази у −1, задња у 1.</translation>
    </message>
    <message>
        <source>OpenGL: −1 to 1</source>
        <translation>OpenGL: −1 до 1</translation>
    </message>
    <message>
        <source>Principal point, downwards from the centre of the first pixel. At the image&apos;s centre the lens is symmetric, elsewhere off-axis.</source>
        <translation>Главна тачка, надоле од средишта првог пиксела. У средишту слике објектив је симетричан, другде је ван осе.</translation>
    </message>
    <message>
        <source>Principal point, to the right from the centre of the first pixel. At the image&apos;s centre the lens is symmetric, elsewhere off-axis.</source>
        <translation>Главна тачка, удесно од средишта првог пиксела. У средишту слике објектив је симетричан, другде је ван осе.</translation>
    </message>
    <message>
        <source>Proportions</source>
        <translation>Пропорције</translation>
    </message>
    <message>
        <source>Receding</source>
        <translation>Размера дубине</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>Десно</translation>
    </message>
    <message>
        <source>Right edge of the picture&apos;s window on the near plane: where the view volume ends in x of view space.</source>
        <translation>Десна ивица прозора слике на предњој равни: где се запремина погледа завршава по x координатног система камере.</translation>
    </message>
    <message>
        <source>Roll</source>
        <translation>Бочни нагиб</translation>
    </message>
    <message>
        <source>Rotation</source>
        <translation>Ротација</translation>
    </message>
    <message>
        <source>Scale</source>
        <translation>Скалирање</translation>
    </message>
    <message>
        <source>Shear</source>
        <translation>Смицање</translation>
    </message>
    <message>
        <source>Stretches the object along the axes of the tiles to its left: 0 flattens it, −1 mirrors it.</source>
        <translation>Растеже објекат дуж оса плочица лево од себе: 0 га спљошти, −1 га пресликава као у огледалу.</translation>
    </message>
    <message>
        <source>Target</source>
        <translation>Циљ</translation>
    </message>
    <message>
        <source>The centre of projection, in world coordinates.</source>
        <translation>Центар пројекције, у координатама света.</translation>
    </message>
    <message>
        <source>The direction that is vertical in the picture (the lectures&apos; view-up vector); its length does not matter.</source>
        <translation>Смер који је на слици вертикалан (вектор нагоре из предавања); дужина му није важна.</translation>
    </message>
    <message>
        <source>The moves of the object, as their product is written: the rightmost acts first.</source>
        <translation>Покрети објекта, како се пише њихов производ: крајњи десни делује први.</translation>
    </message>
    <message>
        <source>The point that the camera looks at, in world coordinates.</source>
        <translation>Тачка у коју камера гледа, у координатама света.</translation>
    </message>
    <message>
        <source>The standard drawings of textbooks. The target stays in its place in the picture.</source>
        <translation>Стандардни цртежи из уџбеника. Циљ остаје на свом месту на слици.</translation>
    </message>
    <message>
        <source>The window fills the image; circles may become ellipses.</source>
        <translation>Прозор попуњава слику; кругови могу да постану елипсе.</translation>
    </message>
    <message>
        <source>The x range grows or shrinks about its centre (lecture 000, variant Y).</source>
        <translation>Опсег по x расте или се смањује око своје средине (предавање 000, варијанта Y).</translation>
    </message>
    <message>
        <source>The y range grows or shrinks about its centre (lecture 000, variant X).</source>
        <translation>Опсег по y расте или се смањује око своје средине (предавање 000, варијанта X).</translation>
    </message>
    <message>
        <source>The z of the near and the far plane in the NDC cube.</source>
        <translation>z предње и задње равни у NDC коцки.</translation>
    </message>
    <message>
        <source>Top</source>
        <translation>Горе</translation>
    </message>
    <message>
        <source>Top edge of the picture&apos;s window on the near plane: where the view volume ends in y of view space.</source>
        <translation>Горња ивица прозора слике на предњој равни: где се запремина погледа завршава по y координатног система камере.</translation>
    </message>
    <message>
        <source>Translation</source>
        <translation>Транслација</translation>
    </message>
    <message>
        <source>Turns the camera about its view direction; clockwise as the photographer sees it.</source>
        <translation>Окреће камеру око смера погледа; у смеру казаљке на сату како га види фотограф.</translation>
    </message>
    <message>
        <source>Turns the object about an axis through the origin of the tiles to its left.</source>
        <translation>Окреће објекат око осе кроз координатни почетак плочица лево од себе.</translation>
    </message>
    <message>
        <source>Typed matrix</source>
        <translation>Унета матрица</translation>
    </message>
    <message>
        <source>Up</source>
        <translation>Вектор нагоре</translation>
    </message>
    <message>
        <source>Walks round the target: 0 is on its +z side, 90 on its +x side.</source>
        <translation>Кружи око циља: 0 је на његовој +z страни, 90 на његовој +x страни.</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Ширина</translation>
    </message>
    <message>
        <source>Width becomes 1/1 of the height, in whole pixels.</source>
        <translation>Ширина постаје 1/1 висине, у целим пикселима.</translation>
    </message>
    <message>
        <source>Width becomes 16/9 of the height, in whole pixels.</source>
        <translation>Ширина постаје 16/9 висине, у целим пикселима.</translation>
    </message>
    <message>
        <source>Width becomes 4/3 of the height, in whole pixels.</source>
        <translation>Ширина постаје 4/3 висине, у целим пикселима.</translation>
    </message>
    <message>
        <source>Width of the picture in pixels.</source>
        <translation>Ширина слике у пикселима.</translation>
    </message>
    <message>
        <source>Width over height. The height stays, and with it the vertical field of view: the picture gains or loses at its sides. The window of another lens follows as “Proportions” says.</source>
        <translation>Ширина према висини. Висина остаје, а са њом и вертикално видно поље: слика добија или губи са страна. Прозор другог објектива прати је како је задато под „Пропорције”.</translation>
    </message>
    <message>
        <source>cabinet, 30°</source>
        <translation>кабинет, 30°</translation>
    </message>
    <message>
        <source>cabinet, 45°</source>
        <translation>кабинет, 45°</translation>
    </message>
    <message>
        <source>cabinet, 63.4°</source>
        <translation>кабинет, 63.4°</translation>
    </message>
    <message>
        <source>cavalier, 30°</source>
        <translation>кавалјер, 30°</translation>
    </message>
    <message>
        <source>cavalier, 45°</source>
        <translation>кавалјер, 45°</translation>
    </message>
    <message>
        <source>cavalier, 63.4°</source>
        <translation>кавалјер, 63.4°</translation>
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
        <translation>опсег дубине NDC z бафер OpenGL Direct3D обрнуто</translation>
    </message>
    <message>
        <source>f plane clipping zFar infinity</source>
        <translation>f раван одсецање zFar бесконачност</translation>
    </message>
    <message>
        <source>field of view angle</source>
        <translation>видно поље угао</translation>
    </message>
    <message>
        <source>free</source>
        <translation>слободно</translation>
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
        <translation>половина угла</translation>
    </message>
    <message>
        <source>image size ratio proportions</source>
        <translation>величина слике однос размера пропорције</translation>
    </message>
    <message>
        <source>image size resolution pixels</source>
        <translation>величина слике резолуција пиксели</translation>
    </message>
    <message>
        <source>keep aspect stretch</source>
        <translation>задржи однос растегни</translation>
    </message>
    <message>
        <source>keep x, fit y</source>
        <translation>задржи x, уклопи y</translation>
    </message>
    <message>
        <source>keep y, fit x</source>
        <translation>задржи y, уклопи x</translation>
    </message>
    <message>
        <source>n plane clipping zNear</source>
        <translation>n раван одсецање zNear</translation>
    </message>
    <message>
        <source>object transform translate rotate scale shear mirror matrix tiles order</source>
        <translation>објекат трансформација транслација ротација скалирање смицање рефлексија матрица плочице редослед</translation>
    </message>
    <message>
        <source>oblique shear</source>
        <translation>косо смицање</translation>
    </message>
    <message>
        <source>orbit angles</source>
        <translation>углови кружења</translation>
    </message>
    <message>
        <source>orbit tilt</source>
        <translation>бочни нагиб кружења</translation>
    </message>
    <message>
        <source>preset cavalier cabinet oblique</source>
        <translation>предлошци кавалјер кабинет коса</translation>
    </message>
    <message>
        <source>projection lens perspective glFrustum glOrtho orthographic oblique matrix</source>
        <translation>пројекција објектив перспектива glFrustum glOrtho ортографски коси матрица</translation>
    </message>
    <message>
        <source>reversed: 1 to 0</source>
        <translation>обрнуто: 1 до 0</translation>
    </message>
    <message>
        <source>stretch</source>
        <translation>растегни</translation>
    </message>
    <message>
        <source>times the true length</source>
        <translation>пута стварна дужина</translation>
    </message>
    <message>
        <source>vectors look at</source>
        <translation>вектори гледа у</translation>
    </message>
    <message>
        <source>vectors position</source>
        <translation>вектори позиција</translation>
    </message>
    <message>
        <source>vectors view-up VUP</source>
        <translation>вектори нагоре VUP</translation>
    </message>
    <message>
        <source>vertical fov angle zoom gluPerspective</source>
        <translation>вертикално fov угао зум gluPerspective</translation>
    </message>
    <message>
        <source>window l r b t glFrustum glOrtho off-axis</source>
        <translation>прозор l r b t glFrustum glOrtho ван осе</translation>
    </message>
    <message>
        <source>window right r glFrustum</source>
        <translation>прозор десно r glFrustum</translation>
    </message>
    <message>
        <source>window top t glFrustum</source>
        <translation>прозор горе t glFrustum</translation>
    </message>
    <message>
        <source>zoom 35 mm camera f</source>
        <translation>зум 35 mm фотоапарат f</translation>
    </message>
</context>
<context>
    <name>Files</name>
    <message>
        <source>Opening {0}</source>
        <translation>Отвара се {0}</translation>
    </message>
    <message>
        <source>Open a document, a lesson, a mesh, a camera or an exported picture</source>
        <translation>Отвори документ, лекцију, мрежу, камеру или извезену слику</translation>
    </message>
    <message>
        <source>All supported files ({0});;All files (*)</source>
        <translation>Све подржане датотеке ({0});;Све датотеке (*)</translation>
    </message>
    <message>
        <source>Open a camera</source>
        <translation>Отвори камеру</translation>
    </message>
    <message>
        <source>The file has {0} views:</source>
        <translation>Број погледа у датотеци: {0}</translation>
    </message>
    <message>
        <source>Close the lesson, and Undo brings back the unsaved changes to {0}.</source>
        <translation>Затворите лекцију, а „Опозови” затим враћа несачуване измене: {0}.</translation>
    </message>
    <message>
        <source>Undo brings back the unsaved changes to {0}.</source>
        <translation>„Опозови” враћа несачуване измене: {0}.</translation>
    </message>
    <message>
        <source>Where is the mesh {0} of this picture?</source>
        <translation>Где је мрежа {0} ове слике?</translation>
    </message>
    <message>
        <source>Meshes ({0});;All files (*)</source>
        <translation>Мреже ({0});;Све датотеке (*)</translation>
    </message>
    <message>
        <source>Use a mesh in place of the scene&apos;s own objects</source>
        <translation>Употреби мрежу уместо сопствених објеката сцене</translation>
    </message>
    <message>
        <source>{0} has been changed elsewhere since it was opened or saved here.</source>
        <translation>{0}: измењено је на другом месту откад је овде отворено или сачувано.</translation>
    </message>
    <message>
        <source>Save over it?</source>
        <translation>Сачувати преко тога?</translation>
    </message>
    <message>
        <source>Save &amp;over it</source>
        <translation>Сачувај &amp;преко</translation>
    </message>
    <message>
        <source>Save &amp;as…</source>
        <translation>Сачувај &amp;као…</translation>
    </message>
    <message>
        <source>Save the document</source>
        <translation>Сачувај документ</translation>
    </message>
    <message>
        <source>Frustum Lab documents (*.json)</source>
        <translation>Документи програма Frustum Lab (*.json)</translation>
    </message>
    <message>
        <source>There are unsaved changes.</source>
        <translation>Има несачуваних измена.</translation>
    </message>
    <message>
        <source>Save them first?</source>
        <translation>Прво их сачувати?</translation>
    </message>
    <message>
        <source>Untitled</source>
        <translation>Без имена</translation>
    </message>
</context>
<context>
    <name>FixedViews</name>
    <message>
        <source>Free</source>
        <translation>Слободно</translation>
    </message>
    <message>
        <source>As you turned it with the mouse</source>
        <translation>Како сте га окренули мишем</translation>
    </message>
    <message>
        <source>Side</source>
        <translation>Са стране</translation>
    </message>
    <message>
        <source>From the side, flat like a sketch on the blackboard, with its lengths</source>
        <translation>Са стране, у равни као скица на табли, са дужинама</translation>
    </message>
    <message>
        <source>Above</source>
        <translation>Одозго</translation>
    </message>
    <message>
        <source>From above, flat, with its lengths</source>
        <translation>Одозго, у равни, са дужинама</translation>
    </message>
    <message>
        <source>Axis</source>
        <translation>Дуж осе</translation>
    </message>
    <message>
        <source>Along the camera&apos;s axis, flat</source>
        <translation>Дуж осе камере, у равни</translation>
    </message>
    <message>
        <source>Eye</source>
        <translation>Из камере</translation>
    </message>
    <message>
        <source>From the eye, as the camera sees it</source>
        <translation>Из позиције камере, како камера види</translation>
    </message>
    <message>
        <source>Viewpoint of the world</source>
        <translation>Тачка из које се посматра свет</translation>
    </message>
</context>
<context>
    <name>FramePanel</name>
    <message>
        <source>Camera frame</source>
        <translation>Координатни систем камере</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Назад</translation>
    </message>
    <message>
        <source>One step back</source>
        <translation>Један корак назад</translation>
    </message>
    <message>
        <source>Next</source>
        <translation>Даље</translation>
    </message>
    <message>
        <source>The next step</source>
        <translation>Следећи корак</translation>
    </message>
    <message>
        <source>Show all</source>
        <translation>Прикажи све</translation>
    </message>
    <message>
        <source>All steps at once</source>
        <translation>Сви кораци одједном</translation>
    </message>
    <message>
        <source>The step in numbers</source>
        <translation>Корак у бројевима</translation>
    </message>
    <message>
        <source>Up from view</source>
        <translation>Нагоре од погледа</translation>
    </message>
    <message>
        <source>Turns up towards the view direction, in the plane of both. The frame stays the same until up is too close to the view direction to say where right is.</source>
        <translation>Окреће вектор нагоре ка смеру погледа, у њиховој равни. Координатни систем остаје исти све док вектор нагоре не буде преблизу смеру погледа да би одредио где је десно.</translation>
    </message>
    <message>
        <source>degrees</source>
        <translation>степени</translation>
    </message>
    <message>
        <source>Nudge up by {0}° to the side</source>
        <translation>Гурни вектор нагоре за {0}° у страну</translation>
    </message>
    <message>
        <source>Make an error in up, and see how far the picture turns</source>
        <translation>Направи грешку у вектору нагоре и погледај колико се слика окрене</translation>
    </message>
    <message>
        <source>The effect of up</source>
        <translation>Утицај вектора нагоре</translation>
    </message>
    <message>
        <source>The step</source>
        <translation>Корак</translation>
    </message>
    <message>
        <source>{0} of {1}: {2}</source>
        <translation>{0} од {1}: {2}</translation>
    </message>
    <message>
        <source>Play</source>
        <translation>Пусти</translation>
    </message>
    <message>
        <source>Show one step after the other</source>
        <translation>Прикажи кораке један за другим</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Паузирај</translation>
    </message>
    <message>
        <source>Stay at this step</source>
        <translation>Остани на овом кораку</translation>
    </message>
    <message>
        <source>Angle of {3} and view direction: {0}°
|{3} × {4}| = {1}
An error in {3} is {2} times as large in u and v.</source>
        <translation>Угао између {3} и смера погледа: {0}°
|{3} × {4}| = {1}
Грешка у {3} је у u и v већа {2} пута.</translation>
    </message>
    <message>
        <source>Up is only {0}° from the line of sight: up × n is nearly 0, and an error of {1}° in up turns the picture by up to {2}°.</source>
        <translation>Вектор нагоре је само {0}° од правца погледа: нагоре × n је скоро 0, па грешка од {1}° у вектору нагоре окреће слику и до {2}°.</translation>
    </message>
    <message>
        <source>No camera has the typed view matrix: these are the numbers of the previous camera. Undo, or choose a lens.</source>
        <translation>Ниједна камера нема унету матрицу погледа: ово су бројеви претходне камере. Опозовите, или изаберите објектив.</translation>
    </message>
    <message>
        <source>Backwards, from the target to the eye, of length 1: the camera looks along −{n}.</source>
        <translation>Уназад, од циља ка позицији камере, дужине 1: камера гледа дуж −{n}.</translation>
    </message>
    <message>
        <source>The camera looks at the target; only the direction matters.</source>
        <translation>Камера гледа у циљ; важан је само смер.</translation>
    </message>
    <message>
        <source>The centre of projection: where the camera stands in the world.</source>
        <translation>Центар пројекције: место где камера стоји у свету.</translation>
    </message>
    <message>
        <source>The direction that is vertical in the picture. It need not be perpendicular to the view, and its length does not matter.</source>
        <translation>Смер који је на слици вертикалан. Не мора бити управан на смер погледа, а дужина му није важна.</translation>
    </message>
    <message>
        <source>The rows of the rotation R are {u}, {v} and {n}; {T} moves the eye to the origin, so that the last column is −R {e}.</source>
        <translation>Врсте ротације R су {u}, {v} и {n}; {T} помера позицију камере у координатни почетак, па је последња колона −R {e}.</translation>
    </message>
    <message>
        <source>To the right in the picture: at right angles to {up} and {n}, of length 1.</source>
        <translation>Удесно на слици: управно на {up} и {n}, дужине 1.</translation>
    </message>
    <message>
        <source>Upwards in the picture: at right angles to {n} and {u}. It is the part of {up} at right angles to the view.</source>
        <translation>Нагоре на слици: управно на {n} и {u}. То је компонента вектора {up} управна на смер погледа.</translation>
    </message>
    <message>
        <source>eye</source>
        <translation>позиција камере</translation>
    </message>
    <message>
        <source>look</source>
        <translation>поглед</translation>
    </message>
    <message>
        <source>up</source>
        <translation>нагоре</translation>
    </message>
    <message>
        <source>view matrix</source>
        <translation>матрица погледа</translation>
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
        <translation>Превлачење окреће, превлачење уз Shift помера, точкић зумира</translation>
    </message>
    <message>
        <source>Arrow keys turn, Shift and an arrow moves, + and − zoom, Home resets.</source>
        <translation>Стрелице окрећу, Shift и стрелица померају, + и − зумирају, Home враћа на почетно.</translation>
    </message>
    <message>
        <source>Drag to move the camera, wheel to go nearer</source>
        <translation>Превлачење помера камеру, точкић је приближава</translation>
    </message>
    <message>
        <source>Arrow keys move the camera in its plane, + and − go nearer and back.</source>
        <translation>Стрелице померају камеру у њеној равни, + и − је приближавају и удаљавају.</translation>
    </message>
    <message>
        <source>Page Down and Page Up go from vertex to vertex, with Shift from handle to handle or probe to probe; Space follows a vertex; Enter takes hold and lets go, Shift and Enter as a drag with Shift; arrows drag by a pixel, with Shift by ten; Escape puts back.</source>
        <translation>Page Down и Page Up иду од темена до темена, уз Shift од ручице до ручице или од сонде до сонде; Space прати теме; Enter хвата и пушта, Shift и Enter као превлачење уз Shift; стрелице вуку за пиксел, уз Shift за десет; Escape враћа на старо.</translation>
    </message>
</context>
<context>
    <name>Header</name>
    <message>
        <source>Double-click to enlarge this pane, again for the whole window, and again to go back</source>
        <translation>Двоклик увећава овај приказ, још један га шири на цео прозор, а следећи га враћа назад</translation>
    </message>
</context>
<context>
    <name>Health</name>
    <message>
        <source>A GPU&apos;s float32 cannot hold this picture: it is computed in float64</source>
        <translation>float32 графичког процесора не може да прими ову слику: рачуна се у float64</translation>
    </message>
    <message>
        <source>A GPU&apos;s float32 could be up to {0} px off: the picture is computed in float64</source>
        <translation>float32 графичког процесора могао би да погреши и до {0} px: слика се рачуна у float64</translation>
    </message>
    <message>
        <source>At the target, a 24-bit depth buffer cannot tell any two surfaces apart</source>
        <translation>На растојању циља 24-битни бафер дубине не може да разликује никоје две површи</translation>
    </message>
    <message>
        <source>At the target, a 24-bit depth buffer separates only surfaces at least {0} apart</source>
        <translation>На растојању циља 24-битни бафер дубине раздваја само површи размакнуте бар {0}</translation>
    </message>
    <message>
        <source>In float64 few decimals would be certain, {0} of a pixel and {1} of the depth: the numbers are computed exactly</source>
        <translation>У float64 било би сигурно само неколико децимала, {0} пиксела и {1} дубине: бројеви се рачунају тачно</translation>
    </message>
    <message>
        <source>None of the scene&apos;s objects is in the picture: all lie outside the {0} plane</source>
        <translation>Ниједан објекат сцене није на слици: сви леже са спољне стране равни „{0}”</translation>
    </message>
    <message>
        <source>The free matrix has no inverse: no frustum is drawn</source>
        <translation>Слободна матрица нема инверз: зарубљена пирамида се не црта</translation>
    </message>
    <message>
        <source>The free matrix is too nearly singular: no frustum is drawn</source>
        <translation>Слободна матрица је превише близу сингуларној: зарубљена пирамида се не црта</translation>
    </message>
    <message>
        <source>The free matrix&apos;s view volume reaches infinity: no frustum is drawn</source>
        <translation>Запремина погледа слободне матрице досеже до бесконачности: зарубљена пирамида се не црта</translation>
    </message>
    <message>
        <source>The scene is {0} times as large as the near distance: from 1e7 on, VTK alone does not draw what is near</source>
        <translation>Сцена је {0} пута већа од растојања предње равни: од 1e7 па надаље сам VTK не црта оно што је близу</translation>
    </message>
    <message>
        <source>VTK&apos;s own camera would clamp the field of view to {0}°</source>
        <translation>Сопствена камера програма VTK ограничила би видно поље на {0}°</translation>
    </message>
</context>
<context>
    <name>Help</name>
    <message>
        <source>Keys and mouse</source>
        <translation>Тастери и миш</translation>
    </message>
    <message>
        <source>. or B</source>
        <translation>. или B</translation>
    </message>
    <message>
        <source>&lt;b&gt;Frustum Lab {0}&lt;/b&gt;</source>
        <translation>&lt;b&gt;Frustum Lab {0}&lt;/b&gt;</translation>
    </message>
    <message>
        <source>A black screen, and back</source>
        <translation>Црн екран, и назад</translation>
    </message>
    <message>
        <source>A corner</source>
        <translation>Угао прозора</translation>
    </message>
    <message>
        <source>A hint; {Alt+W} shows why an answer is wrong</source>
        <translation>Наговештај; {Alt+W} показује зашто је одговор нетачан</translation>
    </message>
    <message>
        <source>A lamp, a point, also in the cube and the image</source>
        <translation>Лампа, тачка, и у коцки и на слици</translation>
    </message>
    <message>
        <source>A laser pointer; pictures do not react to it</source>
        <translation>Ласерски показивач; слике на њега не реагују</translation>
    </message>
    <message>
        <source>A pane&apos;s own view (the model does not change)</source>
        <translation>Сопствени поглед приказа (модел се не мења)</translation>
    </message>
    <message>
        <source>A picture plane, a film, a plane in focus</source>
        <translation>Раван слике, филм, раван у фокусу</translation>
    </message>
    <message>
        <source>A side of a lens with a window</source>
        <translation>Страна прозора, код објектива са прозором</translation>
    </message>
    <message>
        <source>A small step; Home and End go to its ends</source>
        <translation>Мали корак; Home и End иду на крајеве</translation>
    </message>
    <message>
        <source>About Frustum Lab</source>
        <translation>О програму Frustum Lab</translation>
    </message>
    <message>
        <source>Always turn the view</source>
        <translation>Увек окреће поглед</translation>
    </message>
    <message>
        <source>Arrows, Enter</source>
        <translation>Стрелице, Enter</translation>
    </message>
    <message>
        <source>Arrows, while held</source>
        <translation>Стрелице, док се држи</translation>
    </message>
    <message>
        <source>Backspace, or {Ctrl+Z}</source>
        <translation>Backspace, или {Ctrl+Z}</translation>
    </message>
    <message>
        <source>Bring World, NDC cube or Image into the large slot</source>
        <translation>Доводи „Свет”, „NDC коцку” или „Слику” на велико место</translation>
    </message>
    <message>
        <source>Camera frame: &lt;i&gt;n&lt;/i&gt; = (eye − target)/|·|, &lt;i&gt;u&lt;/i&gt; = up × n/|·|, &lt;i&gt;v&lt;/i&gt; = n × u.</source>
        <translation>Координатни систем камере: &lt;i&gt;n&lt;/i&gt; = (позиција камере − циљ)/|·|, &lt;i&gt;u&lt;/i&gt; = нагоре × n/|·|, &lt;i&gt;v&lt;/i&gt; = n × u.</translation>
    </message>
    <message>
        <source>Change the field of view, or that corner of a lens with a window; with Shift, both sides</source>
        <translation>Мења видно поље или, код објектива са прозором, тај угао прозора; уз Shift, обе стране</translation>
    </message>
    <message>
        <source>Change the value, with Ctrl or when the slider has the focus</source>
        <translation>Мења вредност, уз Ctrl или када је клизач у фокусу</translation>
    </message>
    <message>
        <source>Choose an answer and submit it; Enter also checks a typed answer</source>
        <translation>Бира одговор и предаје га; Enter такође проверава унети одговор</translation>
    </message>
    <message>
        <source>Click</source>
        <translation>Клик</translation>
    </message>
    <message>
        <source>Close what is on top, or cancel a drag</source>
        <translation>Затвара оно што је на врху, или отказује превлачење</translation>
    </message>
    <message>
        <source>Column vectors, &lt;i&gt;p&apos; = M p&lt;/i&gt;. World and view are right-handed with y up; the camera looks along −z of view space.</source>
        <translation>Вектори-колоне, &lt;i&gt;p&apos; = M p&lt;/i&gt;. Координатни системи света и камере су десни, са y нагоре; камера гледа дуж −z свог координатног система.</translation>
    </message>
    <message>
        <source>Compare side by side or overlaid</source>
        <translation>Пореди једно поред другог или преклопљено</translation>
    </message>
    <message>
        <source>Controls</source>
        <translation>Контроле</translation>
    </message>
    <message>
        <source>Conventions</source>
        <translation>Конвенције</translation>
    </message>
    <message>
        <source>Digits, then Enter</source>
        <translation>Цифре, па Enter</translation>
    </message>
    <message>
        <source>Double-click</source>
        <translation>Двоклик</translation>
    </message>
    <message>
        <source>Double-click its name</source>
        <translation>Двоклик на име</translation>
    </message>
    <message>
        <source>Double-click, F2 or Enter</source>
        <translation>Двоклик, F2 или Enter</translation>
    </message>
    <message>
        <source>Drag</source>
        <translation>Превлачење</translation>
    </message>
    <message>
        <source>Drag by one pixel; with Shift, by ten; Esc cancels</source>
        <translation>Вуче за један пиксел; уз Shift, за десет; Esc отказује</translation>
    </message>
    <message>
        <source>Drag it; with Shift, ten times finer</source>
        <translation>Превуците; уз Shift, десет пута ситније</translation>
    </message>
    <message>
        <source>Drag its mark in the image</source>
        <translation>Превлачење његове ознаке на слици</translation>
    </message>
    <message>
        <source>Drag, or arrows</source>
        <translation>Превлачење, или стрелице</translation>
    </message>
    <message>
        <source>Draw on the slide, or put the pen away</source>
        <translation>Црта по слајду, или одлаже оловку</translation>
    </message>
    <message>
        <source>Draw; with the right mouse button, erase</source>
        <translation>Црта; десним дугметом миша брише</translation>
    </message>
    <message>
        <source>Drop a file</source>
        <translation>Испуштање датотеке</translation>
    </message>
    <message>
        <source>E</source>
        <translation>E</translation>
    </message>
    <message>
        <source>Enlarge or shrink the speaker&apos;s notes</source>
        <translation>Увећава или смањује белешке предавача</translation>
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
        <translation>Свуда</translation>
    </message>
    <message>
        <source>Export the panes as a picture</source>
        <translation>Извози приказе као слику</translation>
    </message>
    <message>
        <source>Eye, target</source>
        <translation>Позиција камере, циљ</translation>
    </message>
    <message>
        <source>Field</source>
        <translation>Поље</translation>
    </message>
    <message>
        <source>Find a control by its name</source>
        <translation>Налази контролу по имену</translation>
    </message>
    <message>
        <source>Follow the point through all panes</source>
        <translation>Прати тачку кроз све приказе</translation>
    </message>
    <message>
        <source>Follow the vertex</source>
        <translation>Прати теме</translation>
    </message>
    <message>
        <source>Give that pane the whole window</source>
        <translation>Даје том приказу цео прозор</translation>
    </message>
    <message>
        <source>Go from stage to stage</source>
        <translation>Иде од фазе до фазе</translation>
    </message>
    <message>
        <source>Go from vertex to vertex; with Shift, from grip to grip</source>
        <translation>Иде од темена до темена; уз Shift, од ручице до ручице</translation>
    </message>
    <message>
        <source>Go nearer or farther</source>
        <translation>Приближава или удаљава камеру</translation>
    </message>
    <message>
        <source>Go to the next number; Esc leaves the field</source>
        <translation>Иде на следећи број; Esc напушта поље</translation>
    </message>
    <message>
        <source>Go to the step of that number</source>
        <translation>Иде на корак са тим бројем</translation>
    </message>
    <message>
        <source>Hide the controls, or show them</source>
        <translation>Скрива контроле, или их приказује</translation>
    </message>
    <message>
        <source>Highlight the same thing everywhere; the keyboard&apos;s focus does the same</source>
        <translation>Истиче исту ствар на свим местима; исто чини и фокус тастатуре</translation>
    </message>
    <message>
        <source>Hold it and compare it with later ones, or end the comparison</source>
        <translation>Задржава слику и пореди је са каснијим, или завршава поређење</translation>
    </message>
    <message>
        <source>Hold what has the grip and release it; with Shift, it works like a Shift-drag</source>
        <translation>Хвата ручицу и пушта је; уз Shift делује као превлачење уз Shift</translation>
    </message>
    <message>
        <source>Hover over a control, a number, a matrix cell, or what can be dragged</source>
        <translation>Задржавање миша над контролом, бројем, пољем матрице или оним што може да се превлачи</translation>
    </message>
    <message>
        <source>How a camera turns a 3-D scene into a picture: the world, the NDC cube and the image, from one model.</source>
        <translation>Како камера претвара 3D сцену у слику: свет, NDC коцка и слика, из једног модела.</translation>
    </message>
    <message>
        <source>Image: origin top left, x right, y down, in pixels; the first pixel&apos;s centre is at 0.5.</source>
        <translation>Слика: координатни почетак горе лево, x удесно, y надоле, у пикселима; средиште првог пиксела је у 0.5.</translation>
    </message>
    <message>
        <source>K</source>
        <translation>K</translation>
    </message>
    <message>
        <source>Keep the slides with their strokes beside the talk, for the handout</source>
        <translation>Чува слајдове са потезима поред презентације, за материјал за слушаоце</translation>
    </message>
    <message>
        <source>Lessons</source>
        <translation>Лекције</translation>
    </message>
    <message>
        <source>MIT licence.</source>
        <translation>Лиценца MIT.</translation>
    </message>
    <message>
        <source>Make World, NDC cube or Image the slide; the same key again shows all panes</source>
        <translation>Чини слајдом „Свет”, „NDC коцку” или „Слику”; исти тастер поново приказује све приказе</translation>
    </message>
    <message>
        <source>Mark in all panes the point under the mouse</source>
        <translation>Обележава у свим приказима тачку испод миша</translation>
    </message>
    <message>
        <source>Matrices</source>
        <translation>Матрице</translation>
    </message>
    <message>
        <source>Middle mouse button</source>
        <translation>Средње дугме миша</translation>
    </message>
    <message>
        <source>Mouse at the top</source>
        <translation>Миш при врху</translation>
    </message>
    <message>
        <source>Move along the view direction; by the face, too, where the scene has their controls</source>
        <translation>Помера их дуж смера погледа; хватањем и за саму страну, где сцена има њихове контроле</translation>
    </message>
    <message>
        <source>Move in the plane that faces you; with Shift, up and down</source>
        <translation>Помера у равни која је окренута ка вама; уз Shift, горе и доле</translation>
    </message>
    <message>
        <source>Move it</source>
        <translation>Помера</translation>
    </message>
    <message>
        <source>Move it along its way</source>
        <translation>Помера дуж путање</translation>
    </message>
    <message>
        <source>Move it; with Shift, both sides</source>
        <translation>Помера; уз Shift, обе стране</translation>
    </message>
    <message>
        <source>Move it; with Shift, finer; Home and End go to the edges; Esc ends the comparison</source>
        <translation>Помера; уз Shift, ситније; Home и End иду на ивице; Esc завршава поређење</translation>
    </message>
    <message>
        <source>Move it; with Shift, up and down</source>
        <translation>Помера; уз Shift, горе и доле</translation>
    </message>
    <message>
        <source>Move the camera in its plane</source>
        <translation>Помера камеру у њеној равни</translation>
    </message>
    <message>
        <source>Move the camera towards the target or away from it</source>
        <translation>Помера камеру ка циљу или од њега</translation>
    </message>
    <message>
        <source>Move the point in its plane; with Shift, along its ray</source>
        <translation>Помера тачку у њеној равни; уз Shift, дуж њеног зрака</translation>
    </message>
    <message>
        <source>NDC is the OpenGL cube [−1, 1]³, near at −1 and far at +1; Direct3D has z in [0, 1], reversed in [1, 0]. It is drawn with z mirrored so that the near face is towards you.</source>
        <translation>NDC је OpenGL коцка [−1, 1]³, предња раван на −1 и задња на +1; код Direct3D z је у [0, 1], обрнуто у [1, 0]. Црта се са огледалски окренутим z, тако да је предња страна окренута ка вама.</translation>
    </message>
    <message>
        <source>Name everything in the pictures, or only what the scene is about</source>
        <translation>Именује све на сликама, или само оно о чему је сцена</translation>
    </message>
    <message>
        <source>Near, far, by an edge or their name</source>
        <translation>Предња и задња раван, за ивицу или име</translation>
    </message>
    <message>
        <source>Open a document, a lesson, a mesh (OBJ, STL, PLY, glTF), a camera (NeRF, COLMAP, OpenCV) or an exported picture</source>
        <translation>Отвара документ, лекцију, мрежу (OBJ, STL, PLY, glTF), камеру (NeRF, COLMAP, OpenCV) или извезену слику</translation>
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
        <translation>Лепи број у поље, или целу матрицу</translation>
    </message>
    <message>
        <source>Play it back and forth</source>
        <translation>Пушта напред-назад</translation>
    </message>
    <message>
        <source>Play or pause the camera&apos;s walk</source>
        <translation>Пушта или паузира кружење камере</translation>
    </message>
    <message>
        <source>Pointing</source>
        <translation>Показивање</translation>
    </message>
    <message>
        <source>Points to follow</source>
        <translation>Тачке које се прате</translation>
    </message>
    <message>
        <source>Present a talk from its first step</source>
        <translation>Излаже презентацију од првог корака</translation>
    </message>
    <message>
        <source>Present on the full screen, in letters for the back row; again to end</source>
        <translation>Излаже на целом екрану, словима видљивим из последњег реда; поново за крај</translation>
    </message>
    <message>
        <source>Presenting</source>
        <translation>Излагање</translation>
    </message>
    <message>
        <source>Presenting a talk, and in the speaker&apos;s window</source>
        <translation>При излагању презентације, и у прозору предавача</translation>
    </message>
    <message>
        <source>Remove it</source>
        <translation>Уклања</translation>
    </message>
    <message>
        <source>Remove the last stroke; Delete removes all strokes of the step</source>
        <translation>Уклања последњи потез; Delete уклања све потезе корака</translation>
    </message>
    <message>
        <source>Reset all to how the scene opens</source>
        <translation>Враћа све на оно са чим се сцена отвара</translation>
    </message>
    <message>
        <source>Reset it</source>
        <translation>Враћа на почетно</translation>
    </message>
    <message>
        <source>Shift-drag</source>
        <translation>Превлачење уз Shift</translation>
    </message>
    <message>
        <source>Show all panes as the scene opens</source>
        <translation>Приказује све приказе како се сцена отвара</translation>
    </message>
    <message>
        <source>Show the controls of the slide, or hide them</source>
        <translation>Приказује контроле слајда, или их скрива</translation>
    </message>
    <message>
        <source>Show the dock, or hide it</source>
        <translation>Приказује бочни панел, или га скрива</translation>
    </message>
    <message>
        <source>Show the question, then its answer, and stay at the step</source>
        <translation>Приказује питање, па његов одговор, и остаје на кораку</translation>
    </message>
    <message>
        <source>Show the question, then its answer, then the next step; Page Up goes the same way back</source>
        <translation>Приказује питање, па његов одговор, па следећи корак; Page Up иде истим путем назад</translation>
    </message>
    <message>
        <source>Show the slide of the step again</source>
        <translation>Поново приказује слајд корака</translation>
    </message>
    <message>
        <source>Show the step again, without your changes</source>
        <translation>Приказује корак поново, без ваших измена</translation>
    </message>
    <message>
        <source>Show the tool bar</source>
        <translation>Приказује траку са алаткама</translation>
    </message>
    <message>
        <source>Slider</source>
        <translation>Клизач</translation>
    </message>
    <message>
        <source>Space</source>
        <translation>Space</translation>
    </message>
    <message>
        <source>Swap the screens of the class and of the notes</source>
        <translation>Замењује екране за слушаоце и за белешке</translation>
    </message>
    <message>
        <source>Tab</source>
        <translation>Tab</translation>
    </message>
    <message>
        <source>Tab to the divider, then arrows</source>
        <translation>Tab до преграде, па стрелице</translation>
    </message>
    <message>
        <source>Tab, then arrows</source>
        <translation>Tab, па стрелице</translation>
    </message>
    <message>
        <source>The arrangement of the panes</source>
        <translation>Распоред приказа</translation>
    </message>
    <message>
        <source>The eraser, or the pen again</source>
        <translation>Гумица, или опет оловка</translation>
    </message>
    <message>
        <source>The next colour</source>
        <translation>Следећа боја</translation>
    </message>
    <message>
        <source>The next step and the previous one, unless a pane or a control has the focus</source>
        <translation>Следећи и претходни корак, осим кад је фокус у приказу или на контроли</translation>
    </message>
    <message>
        <source>The next step; {Alt+Left} for the previous one</source>
        <translation>Следећи корак; {Alt+Left} за претходни</translation>
    </message>
    <message>
        <source>The picture in the image pane</source>
        <translation>Слика у приказу „Слика”</translation>
    </message>
    <message>
        <source>The same key again, or a double-click on a title</source>
        <translation>Исти тастер поново, или двоклик на наслов</translation>
    </message>
    <message>
        <source>The strip of stages</source>
        <translation>Трака фаза</translation>
    </message>
    <message>
        <source>The triangle</source>
        <translation>Троугао</translation>
    </message>
    <message>
        <source>Turn it</source>
        <translation>Окреће</translation>
    </message>
    <message>
        <source>Turn it; with Shift, move it; + and − go nearer or farther; Home resets it</source>
        <translation>Окреће; уз Shift, помера; + и − приближавају и удаљавају; Home враћа на почетно</translation>
    </message>
    <message>
        <source>Type a number, even beyond the slider&apos;s ends, and press Enter; Esc discards it</source>
        <translation>Унесите број, чак и преко крајева клизача, па притисните Enter; Esc га одбацује</translation>
    </message>
    <message>
        <source>Type another number into view ← world or clip ← view</source>
        <translation>Уноси други број у „камера ← свет” или „одсецање ← камера”</translation>
    </message>
    <message>
        <source>Undo; a drag is one step</source>
        <translation>Опозива; превлачење је један корак</translation>
    </message>
    <message>
        <source>What you can drag (it lights up, and the pointer shows its way)</source>
        <translation>Оно што можете да превлачите (засветли, а показивач показује путању)</translation>
    </message>
    <message>
        <source>Wheel</source>
        <translation>Точкић</translation>
    </message>
    <message>
        <source>Wheel, or + and −</source>
        <translation>Точкић, или + и −</translation>
    </message>
    <message>
        <source>With the pen</source>
        <translation>Са оловком</translation>
    </message>
    <message>
        <source>Without a mouse, in a pane that Tab has reached</source>
        <translation>Без миша, у приказу до кога је стигао Tab</translation>
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
        <translation>{Ctrl+F} или /</translation>
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
        <translation>{L}, док се држи</translation>
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
        <translation>Скривено док се не одговори на задатак</translation>
    </message>
    <message>
        <source>Closed during a test</source>
        <translation>Затворено током теста</translation>
    </message>
</context>
<context>
    <name>Kind</name>
    <message>
        <source>1-point</source>
        <translation>1 недоглед</translation>
    </message>
    <message>
        <source>2-point</source>
        <translation>2 недогледа</translation>
    </message>
    <message>
        <source>3-point</source>
        <translation>3 недогледа</translation>
    </message>
    <message>
        <source>all projectors are parallel</source>
        <translation>сви зраци пројекције су паралелни</translation>
    </message>
    <message>
        <source>all projectors meet in the eye</source>
        <translation>сви зраци пројекције секу се у позицији камере</translation>
    </message>
    <message>
        <source>all three axes make equal angles with the image plane</source>
        <translation>све три осе заклапају једнаке углове са равни слике</translation>
    </message>
    <message>
        <source>axonometric</source>
        <translation>аксонометријска</translation>
    </message>
    <message>
        <source>cabinet</source>
        <translation>кабинет</translation>
    </message>
    <message>
        <source>cavalier</source>
        <translation>кавалјер</translation>
    </message>
    <message>
        <source>dimetric</source>
        <translation>диметрија</translation>
    </message>
    <message>
        <source>front</source>
        <translation>спреда</translation>
    </message>
    <message>
        <source>isometric</source>
        <translation>изометрија</translation>
    </message>
    <message>
        <source>multiview</source>
        <translation>ортогонални погледи</translation>
    </message>
    <message>
        <source>no axis is parallel to the image plane: three vanishing points</source>
        <translation>ниједна оса није паралелна равни слике: три тачке недогледа</translation>
    </message>
    <message>
        <source>no two axes are parallel to the image plane</source>
        <translation>никоје две осе нису паралелне равни слике</translation>
    </message>
    <message>
        <source>oblique</source>
        <translation>коса</translation>
    </message>
    <message>
        <source>one axis is parallel to the image plane: two vanishing points</source>
        <translation>једна оса је паралелна равни слике: две тачке недогледа</translation>
    </message>
    <message>
        <source>orthographic</source>
        <translation>ортографска</translation>
    </message>
    <message>
        <source>parallel</source>
        <translation>паралелна</translation>
    </message>
    <message>
        <source>perspective</source>
        <translation>перспективна</translation>
    </message>
    <message>
        <source>planar projections</source>
        <translation>равнинске пројекције</translation>
    </message>
    <message>
        <source>projectors are at right angles to the image plane</source>
        <translation>зраци пројекције су управни на раван слике</translation>
    </message>
    <message>
        <source>projectors are oblique to the image plane</source>
        <translation>зраци пројекције су коси према равни слике</translation>
    </message>
    <message>
        <source>projectors are straight lines, and meet a plane</source>
        <translation>зраци пројекције су праве и секу раван</translation>
    </message>
    <message>
        <source>side</source>
        <translation>са стране</translation>
    </message>
    <message>
        <source>the axes make three different angles with the image plane</source>
        <translation>осе заклапају три различита угла са равни слике</translation>
    </message>
    <message>
        <source>top</source>
        <translation>одозго</translation>
    </message>
    <message>
        <source>trimetric</source>
        <translation>триметрија</translation>
    </message>
    <message>
        <source>two axes are parallel to the image plane</source>
        <translation>две осе су паралелне равни слике</translation>
    </message>
    <message>
        <source>two axes are parallel to the image plane, the third is drawn at full length</source>
        <translation>две осе су паралелне равни слике, трећа се црта у пуној дужини</translation>
    </message>
    <message>
        <source>two axes are parallel to the image plane, the third is drawn at half its length</source>
        <translation>две осе су паралелне равни слике, трећа се црта у половини дужине</translation>
    </message>
    <message>
        <source>two axes are parallel to the image plane: one vanishing point</source>
        <translation>две осе су паралелне равни слике: једна тачка недогледа</translation>
    </message>
    <message>
        <source>two axes make equal angles with the image plane</source>
        <translation>две осе заклапају једнаке углове са равни слике</translation>
    </message>
    <message>
        <source>x and y are parallel to the image plane, seen along −z</source>
        <translation>x и y су паралелне равни слике, гледано дуж −z</translation>
    </message>
    <message>
        <source>x and z are parallel to the image plane, seen along −y</source>
        <translation>x и z су паралелне равни слике, гледано дуж −y</translation>
    </message>
    <message>
        <source>y and z are parallel to the image plane, seen along −x</source>
        <translation>y и z су паралелне равни слике, гледано дуж −x</translation>
    </message>
</context>
<context>
    <name>KindsPanel</name>
    <message>
        <source>Kinds of projection</source>
        <translation>Врсте пројекција</translation>
    </message>
    <message>
        <source>A free matrix belongs to no kind. Choose a kind, and its lens replaces the matrix.</source>
        <translation>Слободна матрица не припада ниједној врсти. Изаберите врсту, и њен објектив ће заменити матрицу.</translation>
    </message>
    <message>
        <source>{0}: {1}.</source>
        <translation>{0}: {1}.</translation>
    </message>
    <message>
        <source>{0} Not possible here: {1}</source>
        <translation>{0} Овде није могуће: {1}</translation>
    </message>
    <message>
        <source>No scale factors: things farther away are drawn smaller.</source>
        <translation>Нема размера по осама: што је даље, црта се мање.</translation>
    </message>
    <message>
        <source>A unit would be drawn {0} long along x, {1} along y, {2} along z.</source>
        <translation>Јединица би била нацртана са дужином {0} дуж x, {1} дуж y, {2} дуж z.</translation>
    </message>
    <message>
        <source>A unit is drawn {0} long along x, {1} along y, {2} along z.</source>
        <translation>Јединица се црта са дужином {0} дуж x, {1} дуж y, {2} дуж z.</translation>
    </message>
    <message>
        <source>{0} This scene: {1}.</source>
        <translation>{0} Ова сцена: {1}.</translation>
    </message>
</context>
<context>
    <name>Lens</name>
    <message>
        <source>None of these: the cells of clip ← view that you typed in the Matrices panel. If you choose another kind, the previous lens comes back.</source>
        <translation>Ништа од тога: поља матрице „одсецање ← камера” која сте унели у панелу „Матрице”. Ако изаберете другу врсту, враћа се претходни објектив.</translation>
    </message>
    <message>
        <source>Rays are parallel and meet the picture at a slant: a slanted box, as in cavalier and cabinet drawings (lecture 002: H, then orthographic).</source>
        <translation>Зраци су паралелни и косо падају на слику: коси паралелепипед, као у цртежима кавалјер и кабинет (предавање 002: H, па ортографска).</translation>
    </message>
    <message>
        <source>Rays are parallel and meet the picture at right angles: distance does not change size. The view volume is a box (glOrtho).</source>
        <translation>Зраци су паралелни и управни на слику: растојање не мења величину. Запремина погледа је квадар (glOrtho).</translation>
    </message>
    <message>
        <source>Rays meet in the eye, but the window may be anywhere on the near plane: a shifted pyramid (glFrustum).</source>
        <translation>Зраци се секу у позицији камере, али прозор може бити било где на предњој равни: померена пирамида (glFrustum).</translation>
    </message>
    <message>
        <source>Rays meet in the eye: farther objects look smaller. The view volume is a pyramid cut off by near and far, symmetric about the view direction (gluPerspective).</source>
        <translation>Зраци се секу у позицији камере: даљи објекти изгледају мањи. Запремина погледа је пирамида зарубљена предњом и задњом равни, симетрична око смера погледа (gluPerspective).</translation>
    </message>
    <message>
        <source>free matrix</source>
        <translation>слободна матрица</translation>
    </message>
    <message>
        <source>frustum (off-axis)</source>
        <translation>зарубљена пирамида (ван осе)</translation>
    </message>
    <message>
        <source>oblique</source>
        <translation>коси</translation>
    </message>
    <message>
        <source>orthographic</source>
        <translation>ортографски</translation>
    </message>
    <message>
        <source>perspective</source>
        <translation>перспективни</translation>
    </message>
</context>
<context>
    <name>LessonCard</name>
    <message>
        <source>Lesson</source>
        <translation>Лекција</translation>
    </message>
    <message>
        <source>Begin again: forget the answers of this lesson</source>
        <translation>Почни испочетка: заборави одговоре ове лекције</translation>
    </message>
    <message>
        <source>Close the lesson</source>
        <translation>Затвори лекцију</translation>
    </message>
    <message>
        <source>Previous step ({0})</source>
        <translation>Претходни корак ({0})</translation>
    </message>
    <message>
        <source>Show the step as the lesson&apos;s file has it, without your changes ({0})</source>
        <translation>Прикажи корак онако како стоји у датотеци лекције, без ваших измена ({0})</translation>
    </message>
    <message>
        <source>Show the next hint (Alt+I)</source>
        <translation>Прикажи следећи наговештај (Alt+I)</translation>
    </message>
    <message>
        <source>Next step ({0})</source>
        <translation>Следећи корак ({0})</translation>
    </message>
    <message>
        <source>&amp;Back</source>
        <translation>&amp;Назад</translation>
    </message>
    <message>
        <source>Show again</source>
        <translation>Прикажи поново</translation>
    </message>
    <message>
        <source>Show the step again</source>
        <translation>Прикажи корак поново</translation>
    </message>
    <message>
        <source>H&amp;int</source>
        <translation>Наго&amp;вештај</translation>
    </message>
    <message>
        <source>&amp;Next</source>
        <translation>Д&amp;аље</translation>
    </message>
    <message>
        <source>Do&amp;ne</source>
        <translation>&amp;Готово</translation>
    </message>
    <message>
        <source>Make your prediction first: choose one, then Commit.</source>
        <translation>Прво дајте своје предвиђање: изаберите једно, па притисните „Потврди”.</translation>
    </message>
    <message>
        <source>Nothing is wrong in this lesson&apos;s file.</source>
        <translation>У датотеци ове лекције ништа није погрешно.</translation>
    </message>
    <message>
        <source>Done: “{0}”.</source>
        <translation>Завршено: „{0}”.</translation>
    </message>
    <message>
        <source>Something is left to do in step {0}.</source>
        <translation>Остало је још нешто да се уради у кораку {0}.</translation>
    </message>
    <message>
        <source>Something is left to do in steps {0}.</source>
        <translation>Остало је још нешто да се уради у корацима {0}.</translation>
    </message>
    <message>
        <source>Next lesson: {0}</source>
        <translation>Следећа лекција: {0}</translation>
    </message>
    <message>
        <source>Open it</source>
        <translation>Отвори је</translation>
    </message>
    <message>
        <source>&amp;Close</source>
        <translation>&amp;Затвори</translation>
    </message>
    <message>
        <source>Back to step {0}</source>
        <translation>Назад на корак {0}</translation>
    </message>
    <message>
        <source>Go on there</source>
        <translation>Настави тамо</translation>
    </message>
    <message>
        <source>Not answered yet: {0}.</source>
        <translation>Још без одговора: {0}.</translation>
    </message>
    <message>
        <source>Back to exercise {0}</source>
        <translation>Назад на задатак {0}</translation>
    </message>
    <message>
        <source>&amp;Mark the test now</source>
        <translation>&amp;Оцени тест сада</translation>
    </message>
    <message>
        <source>End the test</source>
        <translation>Заврши тест</translation>
    </message>
    <message>
        <source>Save the &amp;result…</source>
        <translation>Сачувај &amp;резултат…</translation>
    </message>
    <message>
        <source>Write a file for your teacher</source>
        <translation>Упиши датотеку за наставника</translation>
    </message>
    <message>
        <source>Close the test</source>
        <translation>Затвори тест</translation>
    </message>
</context>
<context>
    <name>LessonMenu</name>
    <message>
        <source>done</source>
        <translation>завршено</translation>
    </message>
    <message>
        <source>Open a lesson or a talk</source>
        <translation>Отвори лекцију или презентацију</translation>
    </message>
    <message>
        <source>Lessons and talks (*.md);;All files (*)</source>
        <translation>Лекције и презентације (*.md);;Све датотеке (*)</translation>
    </message>
</context>
<context>
    <name>Lessons</name>
    <message>
        <source>Checking {0}</source>
        <translation>Проверава се {0}</translation>
    </message>
    <message>
        <source>… and {0} more</source>
        <translation>… и још {0}</translation>
    </message>
</context>
<context>
    <name>Look</name>
    <message>
        <source>up</source>
        <translation>нагоре</translation>
    </message>
    <message>
        <source>eye</source>
        <translation>камера</translation>
    </message>
    <message>
        <source>target</source>
        <translation>циљ</translation>
    </message>
    <message>
        <source>A parallel lens has no angle: it is equally wide at every distance.</source>
        <translation>Паралелни објектив нема угао: подједнако је широк на сваком растојању.</translation>
    </message>
    <message>
        <source>A parallel lens has no eye: this is the view along its axis.</source>
        <translation>Паралелни објектив нема позицију камере: ово је поглед дуж његове осе.</translation>
    </message>
    <message>
        <source>A free matrix has no near, no far and no angle.</source>
        <translation>Слободна матрица нема ни предњу ни задњу раван ни угао.</translation>
    </message>
    <message>
        <source>This window is off-axis: the axis does not halve its angle.</source>
        <translation>Овај прозор је ван осе: оса не полови његов угао.</translation>
    </message>
    <message>
        <source>half height</source>
        <translation>пола висине</translation>
    </message>
    <message>
        <source>half width</source>
        <translation>пола ширине</translation>
    </message>
    <message>
        <source>look</source>
        <translation>поглед</translation>
    </message>
</context>
<context>
    <name>MainWindow</name>
    <message>
        <source>World</source>
        <translation>Свет</translation>
    </message>
    <message>
        <source>NDC cube</source>
        <translation>NDC коцка</translation>
    </message>
    <message>
        <source>Image</source>
        <translation>Слика</translation>
    </message>
    <message>
        <source>The default settings are used.</source>
        <translation>Користе се подразумевана подешавања.</translation>
    </message>
    <message>
        <source>Matrices</source>
        <translation>Матрице</translation>
    </message>
    <message>
        <source>Every stage&apos;s matrix: numbers, formulas, factors and products</source>
        <translation>Матрица сваке фазе: бројеви, формуле, чиниоци и производи</translation>
    </message>
    <message>
        <source>Camera frame</source>
        <translation>Координатни систем камере</translation>
    </message>
    <message>
        <source>The camera&apos;s axes, step by step: eye, target and up make the view matrix</source>
        <translation>Осе камере, корак по корак: позиција камере, циљ и вектор нагоре дају матрицу погледа</translation>
    </message>
    <message>
        <source>Kinds of projection</source>
        <translation>Врсте пројекција</translation>
    </message>
    <message>
        <source>The tree of planar projections: it marks the kind of the picture; click a kind to change to it</source>
        <translation>Стабло равнинских пројекција: обележава врсту слике; кликните на врсту да пређете на њу</translation>
    </message>
    <message>
        <source>Probe</source>
        <translation>Сонда</translation>
    </message>
    <message>
        <source>Follow points through every stage</source>
        <translation>Прати тачке кроз све фазе</translation>
    </message>
    <message>
        <source>Explanation and diagrams</source>
        <translation>Објашњење и дијаграми</translation>
    </message>
    <message>
        <source>What the scene shows, the lectures that use it, and its diagrams</source>
        <translation>Шта сцена показује, предавања која је користе и њени дијаграми</translation>
    </message>
    <message>
        <source>Precision</source>
        <translation>Прецизност</translation>
    </message>
    <message>
        <source>How exact the picture and its numbers are, and what speed costs on this computer</source>
        <translation>Колико су тачни слика и њени бројеви, и колико кошта брзина на овом рачунару</translation>
    </message>
    <message>
        <source>The answers in “{0}” were deleted.</source>
        <translation>Одговори у лекцији „{0}” су избрисани.</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Опозови</translation>
    </message>
    <message>
        <source>{0} Settings and progress are kept until the program ends, and saving them is tried again with the next change.</source>
        <translation>{0} Подешавања и напредак чувају се до краја рада програма, а упис се поново покушава при следећој измени.</translation>
    </message>
    <message>
        <source>{0} cannot be drawn, so the previous scene stays: {1}</source>
        <translation>Не може да се нацрта {0}, па остаје претходна сцена: {1}</translation>
    </message>
    <message>
        <source>One file is opened at a time: {0}</source>
        <translation>Отвара се једна по једна датотека: {0}</translation>
    </message>
</context>
<context>
    <name>Manipulation</name>
    <message>
        <source>Drag along its way</source>
        <translation>Превуците дуж путање</translation>
    </message>
    <message>
        <source>Drag this point (Shift: up and down)</source>
        <translation>Превуците ову тачку (Shift: горе и доле)</translation>
    </message>
</context>
<context>
    <name>MarkedAnswerView</name>
    <message>
        <source>So far so good, but three significant digits are needed.</source>
        <translation>Засад је добро, али потребне су три значајне цифре.</translation>
    </message>
    <message>
        <source>Too few digits</source>
        <translation>Премало цифара</translation>
    </message>
    <message>
        <source>That is not it.</source>
        <translation>Није то.</translation>
    </message>
    <message>
        <source>The hint (Alt+I) says how to begin.</source>
        <translation>Наговештај (Alt+I) каже како се почиње.</translation>
    </message>
    <message>
        <source>Wrong</source>
        <translation>Нетачно</translation>
    </message>
    <message>
        <source>The answer is {0}.</source>
        <translation>Одговор је {0}.</translation>
    </message>
    <message>
        <source>The answer is:</source>
        <translation>Одговор је:</translation>
    </message>
</context>
<context>
    <name>Matrix</name>
    <message>
        <source>eye ({0}), looks along ({1})</source>
        <translation>позиција камере ({0}), гледа дуж ({1})</translation>
    </message>
    <message>
        <source>its lens is used, looking along −z; change the sign of its view matrix in row {0}</source>
        <translation>користи се њен објектив, који гледа дуж −z; промените предзнак врсте {0} у њеној матрици погледа</translation>
    </message>
    <message>
        <source>its lens is used, with y up</source>
        <translation>користи се њен објектив, са y нагоре</translation>
    </message>
    <message>
        <source>affine: w is {0} everywhere</source>
        <translation>афина: w је свуда {0}</translation>
    </message>
    <message>
        <source>not affine: w depends on {0}</source>
        <translation>није афина: w зависи од {0}</translation>
    </message>
    <message>
        <source>singular (rank {0}): the frustum cannot be drawn</source>
        <translation>сингуларна (ранг {0}): зарубљена пирамида не може да се нацрта</translation>
    </message>
    <message>
        <source>mirrored: it turns right-handed space into left-handed (determinant {0})</source>
        <translation>огледалска: десни координатни систем претвара у леви (детерминанта {0})</translation>
    </message>
    <message>
        <source>mirrored: as if left and right, top and bottom, or near and far were exchanged</source>
        <translation>огледалска: као да су замењени лево и десно, горе и доле, или предња и задња раван</translation>
    </message>
    <message>
        <source>not rigid: it changes lengths or angles, so that no camera has it</source>
        <translation>није крута: мења дужине или углове, па је ниједна камера нема</translation>
    </message>
    <message>
        <source>w vanishes where {0} = 0: the divide sends these points to infinity</source>
        <translation>w се поништава где је {0} = 0: дељење шаље те тачке у бесконачност</translation>
    </message>
    <message>
        <source>w is {0} everywhere: there is no picture</source>
        <translation>w је свуда {0}: нема слике</translation>
    </message>
    <message>
        <source>w is negative all over the view volume: there is no picture</source>
        <translation>w је негативно у целој запремини погледа: нема слике</translation>
    </message>
    <message>
        <source>the view volume reaches infinity: the frustum cannot be drawn</source>
        <translation>запремина погледа досеже до бесконачности: зарубљена пирамида не може да се нацрта</translation>
    </message>
    <message>
        <source>rows are orthonormal to {0}: rounded to float32</source>
        <translation>врсте су ортонормиране до на {0}: заокружено на float32</translation>
    </message>
    <message>
        <source>rows are orthonormal to {0}: rounded to {1} digits</source>
        <translation>врсте су ортонормиране до на {0}; број цифара при заокруживању: {1}</translation>
    </message>
    <message>
        <source>the nearest camera is used; it moves the picture by at most {0} px</source>
        <translation>користи се најближа камера; она помера слику највише за {0} px</translation>
    </message>
    <message>
        <source>the nearest camera would move the picture by at most {0} px</source>
        <translation>најближа камера померила би слику највише за {0} px</translation>
    </message>
    <message>
        <source>rows and columns are exchanged: its transpose is meant</source>
        <translation>врсте и колоне су замењене: мисли се на транспоновану матрицу</translation>
    </message>
    <message>
        <source>looks along −z, y up; z from {0} at near to {1} at far; {2}, near {3}, far {4}</source>
        <translation>гледа дуж −z, y нагоре; z од {0} на предњој до {1} на задњој равни; {2}, предња раван {3}, задња {4}</translation>
    </message>
    <message>
        <source>left-handed: looks along +z, y up; z from {0} at near to {1} at far; {2}, near {3}, far {4}</source>
        <translation>леви систем: гледа дуж +z, y нагоре; z од {0} на предњој до {1} на задњој равни; {2}, предња раван {3}, задња {4}</translation>
    </message>
    <message>
        <source>looks along −z, the picture&apos;s y down; z from {0} at near to {1} at far; {2}, near {3}, far {4}</source>
        <translation>гледа дуж −z, y слике надоле; z од {0} на предњој до {1} на задњој равни; {2}, предња раван {3}, задња {4}</translation>
    </message>
    <message>
        <source>looks along +z, y down; z from {0} at near to {1} at far; {2}, near {3}, far {4}</source>
        <translation>гледа дуж +z, y надоле; z од {0} на предњој до {1} на задњој равни; {2}, предња раван {3}, задња {4}</translation>
    </message>
</context>
<context>
    <name>MatrixAnswerView</name>
    <message>
        <source>A number: 0.5, 1 1/2, √3/2 or 2e-3; arrow keys change the cell (Enter)</source>
        <translation>Број: 0.5; 1 1/2; √3/2 или 2e-3; стрелице прелазе на друго поље (Enter)</translation>
    </message>
</context>
<context>
    <name>MatrixBox</name>
    <message>
        <source>Show the factors of this matrix</source>
        <translation>Прикажи чиниоце ове матрице</translation>
    </message>
    <message>
        <source>Factors of {0}</source>
        <translation>Чиниоци: {0}</translation>
    </message>
    <message>
        <source>the stage strip is here</source>
        <translation>трака фаза је овде</translation>
    </message>
</context>
<context>
    <name>MatrixPanel</name>
    <message>
        <source>then x, y and z are divided by w</source>
        <translation>затим се x, y и z деле са w</translation>
    </message>
    <message>
        <source>with lecture 002&apos;s sign: w = z</source>
        <translation>са предзнаком из предавања 002: w = z</translation>
    </message>
    <message>
        <source>with lecture 002&apos;s sign: z runs from 1 at near to −1</source>
        <translation>са предзнаком из предавања 002: z иде од 1 на предњој равни до −1</translation>
    </message>
    <message>
        <source>with lecture 002&apos;s signs: w = z, and z runs from 1 at near to −1</source>
        <translation>са предзнацима из предавања 002: w = z, а z иде од 1 на предњој равни до −1</translation>
    </message>
    <message>
        <source>Matrices</source>
        <translation>Матрице</translation>
    </message>
    <message>
        <source>Cells</source>
        <translation>Поља</translation>
    </message>
    <message>
        <source>What each cell shows</source>
        <translation>Шта показује свако поље</translation>
    </message>
    <message>
        <source>Numbers</source>
        <translation>Бројеви</translation>
    </message>
    <message>
        <source>Formulas</source>
        <translation>Формуле</translation>
    </message>
    <message>
        <source>Vectors</source>
        <translation>Вектори</translation>
    </message>
    <message>
        <source>Points as columns, right of the matrix, or as rows, left of it; rows transpose every matrix and reverse every product</source>
        <translation>Тачке као колоне, десно од матрице, или као врсте, лево од ње; врсте транспонују сваку матрицу и обрћу сваки производ</translation>
    </message>
    <message>
        <source>Column vectors</source>
        <translation>Вектори-колоне</translation>
    </message>
    <message>
        <source>Row vectors</source>
        <translation>Вектори-врсте</translation>
    </message>
    <message>
        <source>Letters</source>
        <translation>Слова</translation>
    </message>
    <message>
        <source>The lecture whose letters the formulas use; vectors are bold; lecture 002 has its own signs too</source>
        <translation>Предавање чија слова користе формуле; вектори су подебљани; предавање 002 има и своје предзнаке</translation>
    </message>
    <message>
        <source>own: u v n, n f, fov</source>
        <translation>сопствена: u v n, n f, fov</translation>
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
        <translation>z предње и задње равни: негативно</translation>
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
        <translation>Слова из предавања {0}</translation>
    </message>
    <message>
        <source>Take letters of your own from a file, letters.toml</source>
        <translation>Узми своја слова из датотеке, letters.toml</translation>
    </message>
    <message>
        <source>Letters of a file</source>
        <translation>Слова из датотеке</translation>
    </message>
    <message>
        <source>Running products</source>
        <translation>Међупроизводи</translation>
    </message>
    <message>
        <source>Also the product of all stages so far, and the view matrix&apos;s inverse, whose columns are the camera&apos;s axes and the eye</source>
        <translation>И производ свих досадашњих фаза, као и инверз матрице погледа, чије су колоне осе камере и њена позиција</translation>
    </message>
    <message>
        <source>Copy all</source>
        <translation>Копирај све</translation>
    </message>
    <message>
        <source>Copy every matrix shown, in the order of the stages</source>
        <translation>Копирај све приказане матрице, редоследом фаза</translation>
    </message>
    <message>
        <source>Copy all matrices</source>
        <translation>Копирај све матрице</translation>
    </message>
    <message>
        <source>About the cell</source>
        <translation>О пољу</translation>
    </message>
    <message>
        <source>of a file</source>
        <translation>из датотеке</translation>
    </message>
    <message>
        <source>Letters (*.toml);;All files (*)</source>
        <translation>Слова (*.toml);;Све датотеке (*)</translation>
    </message>
    <message>
        <source>{0}, row {1}, column {2}</source>
        <translation>{0}, врста {1}, колона {2}</translation>
    </message>
    <message>
        <source>{0} is taken as {1}, its quotient to all digits of float64.</source>
        <translation>{0} се узима као {1}, количник на све цифре типа float64.</translation>
    </message>
    <message>
        <source>This matrix may mean:</source>
        <translation>Ова матрица може да значи:</translation>
    </message>
    <message>
        <source>{0}, a free matrix</source>
        <translation>{0}, слободна матрица</translation>
    </message>
</context>
<context>
    <name>MatrixRow</name>
    <message>
        <source>Matrices</source>
        <translation>Матрице</translation>
    </message>
    <message>
        <source>More matrices: show the next one that is cut off or hidden</source>
        <translation>Још матрица: прикажи следећу која је одсечена или скривена</translation>
    </message>
    <message>
        <source>Matrices to the left</source>
        <translation>Матрице улево</translation>
    </message>
    <message>
        <source>Matrices to the right</source>
        <translation>Матрице удесно</translation>
    </message>
</context>
<context>
    <name>MatrixView</name>
    <message>
        <source>{0}, row {1}, column {2}</source>
        <translation>{0}, врста {1}, колона {2}</translation>
    </message>
    <message>
        <source>A number, or a fraction such as 1/3, which is divided to all digits</source>
        <translation>Број, или разломак као 1/3, који се дели на све цифре</translation>
    </message>
    <message>
        <source>Paste</source>
        <translation>Налепи</translation>
    </message>
    <message>
        <source>Copy as text</source>
        <translation>Копирај као текст</translation>
    </message>
    <message>
        <source>Copy for NumPy (numbers)</source>
        <translation>Копирај за NumPy (бројеви)</translation>
    </message>
    <message>
        <source>Copy for LaTeX (needs amsmath)</source>
        <translation>Копирај за LaTeX (захтева amsmath)</translation>
    </message>
</context>
<context>
    <name>Measure</name>
    <message>
        <source>180 − vertical fov, degrees</source>
        <translation>180 − вертикално видно поље, степени</translation>
    </message>
    <message>
        <source>A logarithmic depth only at the vertices: the floor sinks behind the wall.</source>
        <translation>Логаритамска дубина само у теменима: под тоне иза зида.</translation>
    </message>
    <message>
        <source>A turn made of many small turns: a full round does not come home.</source>
        <translation>Окретање састављено од много малих окретања: пун круг не враћа кући.</translation>
    </message>
    <message>
        <source>Antialiasing and resolution</source>
        <translation>Умекшавање ивица и резолуција</translation>
    </message>
    <message>
        <source>Arithmetic</source>
        <translation>Аритметика</translation>
    </message>
    <message>
        <source>At the target, {0} with {2} separates surfaces at least {1} world units apart; the finest, {3} with {4}, surfaces at least {5} apart.</source>
        <translation>На растојању циља {0} са {2} раздваја површи размакнуте бар {1} јединица света; најфиније, {3} са {4}, површи размакнуте бар {5}.</translation>
    </message>
    <message>
        <source>Back from the picture</source>
        <translation>Назад од слике</translation>
    </message>
    <message>
        <source>Cracks</source>
        <translation>Пукотине</translation>
    </message>
    <message>
        <source>Depth at the vertices</source>
        <translation>Дубина у теменима</translation>
    </message>
    <message>
        <source>Depth buffer</source>
        <translation>Бафер дубине</translation>
    </message>
    <message>
        <source>Depth gap over the distance</source>
        <translation>Размак дубине према растојању</translation>
    </message>
    <message>
        <source>Detail</source>
        <translation>Детаљност</translation>
    </message>
    <message>
        <source>Drift</source>
        <translation>Заношење</translation>
    </message>
    <message>
        <source>Each mesh rounded in a box of its own: light comes through the seam.</source>
        <translation>Свака мрежа заокружена у сопственом оквиру: светлост пролази кроз шав.</translation>
    </message>
    <message>
        <source>Equal in bytes to {0}: {1}.</source>
        <translation>Исто бајтова као {0}: {1}.</translation>
    </message>
    <message>
        <source>Equal in time to {0}: {1}.</source>
        <translation>Исто време као {0}: {1}.</translation>
    </message>
    <message>
        <source>Fewer bits of depth: what lies behind comes through in stripes.</source>
        <translation>Мање битова дубине: оно што је иза пробија у пругама.</translation>
    </message>
    <message>
        <source>Fewer digits for each vertex: the corners move.</source>
        <translation>Мање цифара за свако теме: темена се померају.</translation>
    </message>
    <message>
        <source>Fewer samples in a pixel: edges become stairs.</source>
        <translation>Мање узорака у пикселу: ивице постају степенице.</translation>
    </message>
    <message>
        <source>Fewer triangles: outlines become angular.</source>
        <translation>Мање троуглова: обриси постају угласти.</translation>
    </message>
    <message>
        <source>From a pixel back into the world by one matrix: the point misses.</source>
        <translation>Од пиксела назад у свет једном матрицом: тачка промашује.</translation>
    </message>
    <message>
        <source>Interpolation</source>
        <translation>Интерполација</translation>
    </message>
    <message>
        <source>Its price is in {0}: {1}, against {2} for {3}.</source>
        <translation>Цена је у {0}: {1}, према {2} за {3}.</translation>
    </message>
    <message>
        <source>Jitter</source>
        <translation>Подрхтавање</translation>
    </message>
    <message>
        <source>No choice is cheaper ({1}) or more exact ({2}) than {0}.</source>
        <translation>Ниједан избор није јефтинији ({1}) ни тачнији ({2}) од {0}.</translation>
    </message>
    <message>
        <source>No choice is cheaper than {0} ({1}, off by {2}), none more exact than {3} ({4}, off by {5}); none is off by less than {6}.</source>
        <translation>Ниједан избор није јефтинији од {0} ({1}, одступа за {2}), ниједан тачнији од {3} ({4}, одступа за {5}); ниједан не одступа за мање од {6}.</translation>
    </message>
    <message>
        <source>No choice is cheaper than {0} ({1}, off by {2}), none more exact than {3} ({4}, off by {5}); of those off by less than {6}, none is cheaper than {7}.</source>
        <translation>Ниједан избор није јефтинији од {0} ({1}, одступа за {2}), ниједан тачнији од {3} ({4}, одступа за {5}); од оних који одступају за мање од {6}, ниједан није јефтинији од {7}.</translation>
    </message>
    <message>
        <source>No division at each pixel: the pattern bends along the diagonal.</source>
        <translation>Нема дељења у сваком пикселу: шара се прелама дуж дијагонале.</translation>
    </message>
    <message>
        <source>Not certain: {0}.</source>
        <translation>Није сигурно: {0}.</translation>
    </message>
    <message>
        <source>Nothing could be measured: {0}.</source>
        <translation>Ништа није могло да се измери: {0}.</translation>
    </message>
    <message>
        <source>Sweep of far</source>
        <translation>Низ мерења: задња раван</translation>
    </message>
    <message>
        <source>Sweep of near</source>
        <translation>Низ мерења: предња раван</translation>
    </message>
    <message>
        <source>Sweep of the aspect</source>
        <translation>Низ мерења: однос ширине и висине</translation>
    </message>
    <message>
        <source>Sweep of the distance from the origin</source>
        <translation>Низ мерења: растојање од координатног почетка</translation>
    </message>
    <message>
        <source>Sweep of the field of view</source>
        <translation>Низ мерења: видно поље</translation>
    </message>
    <message>
        <source>Sweep of up</source>
        <translation>Низ мерења: вектор нагоре</translation>
    </message>
    <message>
        <source>VTK&apos;s transform</source>
        <translation>трансформација VTK-а</translation>
    </message>
    <message>
        <source>World coordinates in float32, far from the origin: the picture jumps.</source>
        <translation>Координате света у float32, далеко од координатног почетка: слика скаче.</translation>
    </message>
    <message>
        <source>a sphere: the scene has too few triangles</source>
        <translation>сфера: сцена има премало троуглова</translation>
    </message>
    <message>
        <source>affine</source>
        <translation>афино</translation>
    </message>
    <message>
        <source>angle between up and view direction, degrees</source>
        <translation>угао између вектора нагоре и смера погледа, степени</translation>
    </message>
    <message>
        <source>aspect</source>
        <translation>однос ширине и висине</translation>
    </message>
    <message>
        <source>aspect of the window</source>
        <translation>однос ширине и висине прозора</translation>
    </message>
    <message>
        <source>at most {0} off</source>
        <translation>одступа највише {0}</translation>
    </message>
    <message>
        <source>bytes</source>
        <translation>бајтови</translation>
    </message>
    <message>
        <source>bytes a camera</source>
        <translation>бајтова по камери</translation>
    </message>
    <message>
        <source>bytes a pixel</source>
        <translation>бајтова по пикселу</translation>
    </message>
    <message>
        <source>bytes a point</source>
        <translation>бајтова по тачки</translation>
    </message>
    <message>
        <source>bytes a vertex</source>
        <translation>бајтова по темену</translation>
    </message>
    <message>
        <source>bytes an edge</source>
        <translation>бајтова по ивици</translation>
    </message>
    <message>
        <source>bytes of the mesh</source>
        <translation>бајтови мреже</translation>
    </message>
    <message>
        <source>cancelled</source>
        <translation>отказано</translation>
    </message>
    <message>
        <source>common grid</source>
        <translation>заједничка решетка</translation>
    </message>
    <message>
        <source>depth error (of 1)</source>
        <translation>грешка дубине (од 1)</translation>
    </message>
    <message>
        <source>direct3d</source>
        <translation>direct3d</translation>
    </message>
    <message>
        <source>distance</source>
        <translation>растојање</translation>
    </message>
    <message>
        <source>distance from the eye plane</source>
        <translation>растојање од равни камере</translation>
    </message>
    <message>
        <source>distance from the origin</source>
        <translation>растојање од координатног почетка</translation>
    </message>
    <message>
        <source>each pixel</source>
        <translation>сваки пиксел</translation>
    </message>
    <message>
        <source>each vertex</source>
        <translation>свако теме</translation>
    </message>
    <message>
        <source>error after 360°, px</source>
        <translation>грешка после 360°, px</translation>
    </message>
    <message>
        <source>error of a jump, px</source>
        <translation>грешка скока, px</translation>
    </message>
    <message>
        <source>error, levels of 255</source>
        <translation>грешка, нивоа од 255</translation>
    </message>
    <message>
        <source>error, parts of the distance</source>
        <translation>грешка, делова растојања</translation>
    </message>
    <message>
        <source>error, parts of the distance w</source>
        <translation>грешка, делова растојања w</translation>
    </message>
    <message>
        <source>error, px</source>
        <translation>грешка, px</translation>
    </message>
    <message>
        <source>error, texels</source>
        <translation>грешка, тексела</translation>
    </message>
    <message>
        <source>every stage</source>
        <translation>свака фаза</translation>
    </message>
    <message>
        <source>exact</source>
        <translation>тачно</translation>
    </message>
    <message>
        <source>eye 1 000 from the origin</source>
        <translation>камера 1 000 од координатног почетка</translation>
    </message>
    <message>
        <source>eye 1 from the origin</source>
        <translation>камера 1 од координатног почетка</translation>
    </message>
    <message>
        <source>eye first</source>
        <translation>прво камера</translation>
    </message>
    <message>
        <source>far</source>
        <translation>задња раван</translation>
    </message>
    <message>
        <source>far is at least 4 near</source>
        <translation>растојање задње равни је бар 4 растојања предње</translation>
    </message>
    <message>
        <source>fast inverse root</source>
        <translation>брзи инверзни корен</translation>
    </message>
    <message>
        <source>first frame (ms)</source>
        <translation>први кадар (ms)</translation>
    </message>
    <message>
        <source>fov</source>
        <translation>видно поље</translation>
    </message>
    <message>
        <source>gap, px</source>
        <translation>процеп, px</translation>
    </message>
    <message>
        <source>gap, world units</source>
        <translation>размак, јединица света</translation>
    </message>
    <message>
        <source>half resolution</source>
        <translation>половина резолуције</translation>
    </message>
    <message>
        <source>imitated in software: its time says nothing</source>
        <translation>опонашано софтвером: његово време ништа не говори</translation>
    </message>
    <message>
        <source>inverse of P V</source>
        <translation>инверз од P V</translation>
    </message>
    <message>
        <source>inverses of P and of V</source>
        <translation>инверзи од P и од V</translation>
    </message>
    <message>
        <source>largest error, px</source>
        <translation>највећа грешка, px</translation>
    </message>
    <message>
        <source>levels RMS</source>
        <translation>нивоа RMS</translation>
    </message>
    <message>
        <source>logarithmic</source>
        <translation>логаритамски</translation>
    </message>
    <message>
        <source>matplotlib&apos;s proj3d</source>
        <translation>proj3d из matplotlib-а</translation>
    </message>
    <message>
        <source>ms a frame</source>
        <translation>ms по кадру</translation>
    </message>
    <message>
        <source>near</source>
        <translation>предња раван</translation>
    </message>
    <message>
        <source>near is at most far / 4</source>
        <translation>растојање предње равни је највише (растојање задње) / 4</translation>
    </message>
    <message>
        <source>no edge of the scene&apos;s box is in the picture</source>
        <translation>ниједна ивица оквира сцене није на слици</translation>
    </message>
    <message>
        <source>no outline of the scene is in the picture</source>
        <translation>ниједан обрис сцене није на слици</translation>
    </message>
    <message>
        <source>no vertex is in front of the eye, so there is nothing to measure</source>
        <translation>ниједно теме није испред камере, па нема шта да се мери</translation>
    </message>
    <message>
        <source>none</source>
        <translation>нема</translation>
    </message>
    <message>
        <source>not installed</source>
        <translation>није инсталирано</translation>
    </message>
    <message>
        <source>ns a frame</source>
        <translation>ns по кадру</translation>
    </message>
    <message>
        <source>ns a pixel</source>
        <translation>ns по пикселу</translation>
    </message>
    <message>
        <source>ns a point</source>
        <translation>ns по тачки</translation>
    </message>
    <message>
        <source>numpy&apos;s hstack</source>
        <translation>hstack из numpy-ја</translation>
    </message>
    <message>
        <source>object first</source>
        <translation>прво објекат</translation>
    </message>
    <message>
        <source>of the distance</source>
        <translation>од растојања</translation>
    </message>
    <message>
        <source>opengl</source>
        <translation>opengl</translation>
    </message>
    <message>
        <source>overflows</source>
        <translation>прекорачење</translation>
    </message>
    <message>
        <source>own boxes</source>
        <translation>сопствени оквири</translation>
    </message>
    <message>
        <source>p95</source>
        <translation>p95</translation>
    </message>
    <message>
        <source>pairs collapsed (of 1)</source>
        <translation>спојени парови (од 1)</translation>
    </message>
    <message>
        <source>perspective-correct</source>
        <translation>перспективно исправно</translation>
    </message>
    <message>
        <source>predicted</source>
        <translation>предвиђено</translation>
    </message>
    <message>
        <source>predicted depth error (of 1)</source>
        <translation>предвиђена грешка дубине (од 1)</translation>
    </message>
    <message>
        <source>predicted to collapse (of 1)</source>
        <translation>предвиђено спојених (од 1)</translation>
    </message>
    <message>
        <source>products</source>
        <translation>производи</translation>
    </message>
    <message>
        <source>ray times depth</source>
        <translation>зрак пута дубина</translation>
    </message>
    <message>
        <source>reciprocal table</source>
        <translation>табела реципрочних вредности</translation>
    </message>
    <message>
        <source>reducing (ms)</source>
        <translation>смањивање (ms)</translation>
    </message>
    <message>
        <source>renormalised</source>
        <translation>поново нормирано</translation>
    </message>
    <message>
        <source>returns NaN</source>
        <translation>даје NaN</translation>
    </message>
    <message>
        <source>reversed</source>
        <translation>обрнуто</translation>
    </message>
    <message>
        <source>separates surfaces {0} apart</source>
        <translation>раздваја површи размакнуте {0}</translation>
    </message>
    <message>
        <source>silhouette, px</source>
        <translation>силуета, px</translation>
    </message>
    <message>
        <source>snapped to 1/16 px</source>
        <translation>приањање на 1/16 px</translation>
    </message>
    <message>
        <source>snapped to 1/4 px</source>
        <translation>приањање на 1/4 px</translation>
    </message>
    <message>
        <source>snapped to whole px</source>
        <translation>приањање на целе px</translation>
    </message>
    <message>
        <source>supersampling {0} x {0}</source>
        <translation>суперузорковање {0} x {0}</translation>
    </message>
    <message>
        <source>tells nothing behind it apart</source>
        <translation>иза њега ништа не разликује</translation>
    </message>
    <message>
        <source>texels</source>
        <translation>тексела</translation>
    </message>
    <message>
        <source>the largest of up to {0} points against 200 digits of mpmath</source>
        <translation>највећа од највише {0} тачака према 200 цифара из mpmath</translation>
    </message>
    <message>
        <source>the same picture</source>
        <translation>иста слика</translation>
    </message>
    <message>
        <source>the smallest gap at the target (at 2 near or far / 2 if it lies outside)</source>
        <translation>најмањи размак код циља (на 2 растојања предње равни, или на растојању задње / 2, ако циљ лежи изван)</translation>
    </message>
    <message>
        <source>the smallest gap behind a surface at this distance</source>
        <translation>најмањи размак иза површи на овом растојању</translation>
    </message>
    <message>
        <source>the target lies outside of near and far</source>
        <translation>циљ лежи изван предње и задње равни</translation>
    </message>
    <message>
        <source>the whole edge is equally far away, so there is no error</source>
        <translation>цела ивица је једнако далеко, па нема грешке</translation>
    </message>
    <message>
        <source>this OpenGL gives {0} samples</source>
        <translation>овај OpenGL даје узорака: {0}</translation>
    </message>
    <message>
        <source>this also switches off the early depth test, whose loss is not in this time</source>
        <translation>ово уједно искључује рани тест дубине, чији губитак није у овом времену</translation>
    </message>
    <message>
        <source>this machine is busy: compare again</source>
        <translation>ова машина је заузета: упоредите поново</translation>
    </message>
    <message>
        <source>time ran out before the least time was steady</source>
        <translation>време је истекло пре него што се најкраће време усталило</translation>
    </message>
    <message>
        <source>triangles</source>
        <translation>троуглови</translation>
    </message>
    <message>
        <source>two floats</source>
        <translation>два float-а</translation>
    </message>
    <message>
        <source>two sines</source>
        <translation>два синуса</translation>
    </message>
    <message>
        <source>up</source>
        <translation>вектор нагоре</translation>
    </message>
    <message>
        <source>up to {0} off</source>
        <translation>одступа до {0}</translation>
    </message>
    <message>
        <source>vertical fov, degrees</source>
        <translation>вертикално видно поље, степени</translation>
    </message>
    <message>
        <source>vertices moved by up to (px)</source>
        <translation>темена померена и до (px)</translation>
    </message>
    <message>
        <source>world coordinates</source>
        <translation>координате света</translation>
    </message>
    <message>
        <source>world units</source>
        <translation>јединица света</translation>
    </message>
    <message>
        <source>{0} (cancelled)</source>
        <translation>{0} (отказано)</translation>
    </message>
    <message>
        <source>{0} (now)</source>
        <translation>{0} (сада)</translation>
    </message>
    <message>
        <source>{0} Newton step</source>
        <translation>{0} Њутнов корак</translation>
    </message>
    <message>
        <source>{0} Newton steps</source>
        <translation>Њутнови кораци: {0}</translation>
    </message>
    <message>
        <source>{0} bits</source>
        <translation>битова: {0}</translation>
    </message>
    <message>
        <source>{0} instead of {1}: the same cost, {3}.</source>
        <translation>{0} уместо {1}: иста цена, {3}.</translation>
    </message>
    <message>
        <source>{0} instead of {1}: {2} times faster, {3}.</source>
        <translation>{0} уместо {1}: брже {2} пута, {3}.</translation>
    </message>
    <message>
        <source>{0} instead of {1}: {2} times larger, {3}.</source>
        <translation>{0} уместо {1}: веће {2} пута, {3}.</translation>
    </message>
    <message>
        <source>{0} instead of {1}: {2} times slower, {3}.</source>
        <translation>{0} уместо {1}: спорије {2} пута, {3}.</translation>
    </message>
    <message>
        <source>{0} instead of {1}: {2} times smaller, {3}.</source>
        <translation>{0} уместо {1}: мање {2} пута, {3}.</translation>
    </message>
    <message>
        <source>{0} is only measured: the panes are not drawn with it.</source>
        <translation>{0} је само измерено: прикази се њиме не цртају.</translation>
    </message>
    <message>
        <source>{0} pieces</source>
        <translation>делова: {0}</translation>
    </message>
    <message>
        <source>{0}; eye {1}, target {2}, {3}</source>
        <translation>{0}; камера {1}, циљ {2}, {3}</translation>
    </message>
</context>
<context>
    <name>MeasurePanel</name>
    <message>
        <source>Trades and sweeps</source>
        <translation>Компромиси и низови мерења</translation>
    </message>
    <message>
        <source>What to measure and to show; Ctrl or Shift to choose several to measure</source>
        <translation>Шта да се мери и приказује; Ctrl или Shift за избор више мерења</translation>
    </message>
    <message>
        <source>How exactly</source>
        <translation>Колико прецизно</translation>
    </message>
    <message>
        <source>Quick: 2 s a trade, 13 values a sweep; full: 30 s a trade, 49 values</source>
        <translation>Брзо: 2 s по компромису, 13 вредности по низу; потпуно: 30 s по компромису, 49 вредности</translation>
    </message>
    <message>
        <source>Quick</source>
        <translation>Брзо</translation>
    </message>
    <message>
        <source>Full</source>
        <translation>Потпуно</translation>
    </message>
    <message>
        <source>Measure here</source>
        <translation>Измери овде</translation>
    </message>
    <message>
        <source>Measure on this machine what is chosen, for this scene and camera</source>
        <translation>Измери на овој машини оно што је изабрано, за ову сцену и камеру</translation>
    </message>
    <message>
        <source>Stop, and keep the results so far</source>
        <translation>Заустави, и задржи досадашње резултате</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Откажи</translation>
    </message>
    <message>
        <source>Progress of the measurement</source>
        <translation>Напредак мерења</translation>
    </message>
    <message>
        <source>Save what is shown: CSV, JSON, PNG or PDF</source>
        <translation>Сачувај приказано: CSV, JSON, PNG или PDF</translation>
    </message>
    <message>
        <source>Export…</source>
        <translation>Извези…</translation>
    </message>
    <message>
        <source>Draw the results from a file, perhaps from another machine, over these</source>
        <translation>Нацртај преко ових резултате из датотеке, можда са друге машине</translation>
    </message>
    <message>
        <source>Compare…</source>
        <translation>Упореди…</translation>
    </message>
    <message>
        <source>Remove the results of the file</source>
        <translation>Уклони резултате из датотеке</translation>
    </message>
    <message>
        <source>Forget</source>
        <translation>Заборави</translation>
    </message>
    <message>
        <source>Cost</source>
        <translation>Цена</translation>
    </message>
    <message>
        <source>What errors are drawn over: time, or bytes, the same on every machine</source>
        <translation>Према чему се цртају грешке: према времену, или према бајтовима, који су исти на свакој машини</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Време</translation>
    </message>
    <message>
        <source>Memory</source>
        <translation>Меморија</translation>
    </message>
    <message>
        <source>Results</source>
        <translation>Резултати</translation>
    </message>
    <message>
        <source>paused</source>
        <translation>паузирано</translation>
    </message>
    <message>
        <source>Export what is shown</source>
        <translation>Извези приказано</translation>
    </message>
    <message>
        <source>Tables (*.csv);;Results (*.json);;Pictures (*.png);;Vectors (*.pdf)</source>
        <translation>Табеле (*.csv);;Резултати (*.json);;Слике (*.png);;Векторски цртежи (*.pdf)</translation>
    </message>
    <message>
        <source>Vectors (*.pdf)</source>
        <translation>Векторски цртежи (*.pdf)</translation>
    </message>
    <message>
        <source>There is nothing to export yet: run a measurement first.</source>
        <translation>Још нема шта да се извезе: прво покрените мерење.</translation>
    </message>
    <message>
        <source>{0}: its name must end in one of {1}.</source>
        <translation>{0}: име мора да се завршава једним од наставака {1}.</translation>
    </message>
    <message>
        <source>Compare with results of a file</source>
        <translation>Упореди са резултатима из датотеке</translation>
    </message>
    <message>
        <source>Results (*.json);;All files (*)</source>
        <translation>Резултати (*.json);;Све датотеке (*)</translation>
    </message>
    <message>
        <source>{0}: cannot be read: {1}.</source>
        <translation>{0}: не може да се прочита: {1}.</translation>
    </message>
    <message>
        <source>Measured with the letter F on another machine: {0}.</source>
        <translation>Измерено са словом F на другој машини: {0}.</translation>
    </message>
    <message>
        <source>There are no results yet: “Measure here” makes them.</source>
        <translation>Још нема резултата: прави их „Измери овде”.</translation>
    </message>
    <message>
        <source>Click a choice to use it in the panes; choices in italics cannot be used, and those in grey are worse than another one in both cost and error</source>
        <translation>Кликните на избор да га употребите у приказима; изборе у курзиву није могуће употребити, а сиви су од неког другог гори и по цени и по грешци</translation>
    </message>
    <message>
        <source>The results at each value; of near, far, fov and gap, click one to use it</source>
        <translation>Резултати за сваку вредност; код предње и задње равни, видног поља и размака кликните на неку да је употребите</translation>
    </message>
    <message>
        <source>{0} (measured only)</source>
        <translation>{0} (само измерено)</translation>
    </message>
</context>
<context>
    <name>Measuring</name>
    <message>
        <source>The measurement cannot be started: {0}.</source>
        <translation>Мерење не може да почне: {0}.</translation>
    </message>
    <message>
        <source>The measurement</source>
        <translation>Мерење</translation>
    </message>
    <message>
        <source>The measurement ended unexpectedly.</source>
        <translation>Мерење се неочекивано завршило.</translation>
    </message>
</context>
<context>
    <name>MessageBar</name>
    <message>
        <source>Message</source>
        <translation>Порука</translation>
    </message>
    <message>
        <source>Dismiss this message</source>
        <translation>Уклони ову поруку</translation>
    </message>
</context>
<context>
    <name>MoveButton</name>
    <message>
        <source>Drag it to another place, or press the arrow keys up and down</source>
        <translation>Превуците на друго место, или притисните тастер са стрелицом нагоре или надоле</translation>
    </message>
</context>
<context>
    <name>NumberAnswerView</name>
    <message>
        <source>Answer: {0}</source>
        <translation>Одговор: {0}</translation>
    </message>
    <message>
        <source>A number: 0.5, 1 1/2, √3/2, 2e-3 or 45°, to three significant digits (Enter)</source>
        <translation>Број: 0.5; 1 1/2; √3/2; 2e-3 или 45°, на три значајне цифре (Enter)</translation>
    </message>
</context>
<context>
    <name>NumberRow</name>
    <message>
        <source>{0}, slider</source>
        <translation>{0}, клизач</translation>
    </message>
    <message>
        <source>units</source>
        <translation>јединица</translation>
    </message>
</context>
<context>
    <name>Options</name>
    <message>
        <source>How a camera turns a 3-D scene into a picture.</source>
        <translation>Како камера претвара 3D сцену у слику.</translation>
    </message>
    <message>
        <source>a document, an exported PNG picture, a mesh, a camera, a lesson or a talk (default: the letter F)</source>
        <translation>документ, извезена PNG слика, мрежа, камера, лекција или презентација (подразумевано: слово F)</translation>
    </message>
    <message>
        <source>a document, picture or mesh to measure (default: the letter F)</source>
        <translation>документ, слика или мрежа за мерење (подразумевано: слово F)</translation>
    </message>
    <message>
        <source>a document, picture, mesh or camera file whose camera is used (default: the letter F)</source>
        <translation>датотека документа, слике, мреже или камере чија се камера користи (подразумевано: слово F)</translation>
    </message>
    <message>
        <source>a document, picture, mesh or camera file whose camera is used (default: the letter F), and the points: CSV with the columns x,y,z, or - for standard input; a fourth column, w, may be 0 for a point at infinity; any other w divides x, y and z</source>
        <translation>датотека документа, слике, мреже или камере чија се камера користи (подразумевано: слово F), и тачке: CSV са колонама x,y,z, или - за стандардни улаз; четврта колона, w, може да буде 0 за бесконачно далеку тачку; свако друго w дели x, y и z</translation>
    </message>
    <message>
        <source>a talk or a lesson, or the name of one that comes with the program, such as 001 or L5</source>
        <translation>презентација или лекција, или име неке која долази са програмом, као 001 или L5</translation>
    </message>
    <message>
        <source>after --convention (default: those of that program)</source>
        <translation>после --convention (подразумевано: оне тог програма)</translation>
    </message>
    <message>
        <source>arithmetic (default: float64, or exact where that is needed)</source>
        <translation>аритметика (подразумевано: float64, или тачна где је потребна)</translation>
    </message>
    <message>
        <source>camera and lens as another program writes them</source>
        <translation>камера и објектив како их пише други програм</translation>
    </message>
    <message>
        <source>check or list lessons and talks, print tests of exercises, mark results</source>
        <translation>провери или наброј лекције и презентације, штампај тестове са задацима, оцени резултате</translation>
    </message>
    <message>
        <source>check: try every state, answer key and sample of lessons and talks, and measure their pictures (default: those that come with the program); list: list them; names: print every name that their files may use; print: print tests, see below; results: mark files of results again from what was typed, count the wrong ideas, and list what no idea explains. FILE may also be a name such as L5 or 001</source>
        <translation>check: испробај свако стање, решење и узорак у лекцијама и презентацијама, и измери њихове слике (подразумевано: оне које долазе са програмом); list: наброј их; names: испиши свако име које њихове датотеке могу да користе; print: штампај тестове, види доле; results: поново оцени датотеке са резултатима из онога што је откуцано, преброј погрешне представе и наброј шта ниједна представа не објашњава. FILE може да буде и име као L5 или 001</translation>
    </message>
    <message>
        <source>colours, for this start only</source>
        <translation>боје, само за ово покретање</translation>
    </message>
    <message>
        <source>colours: as on a light or dark screen; for print, where faces and lines differ in grey, too; or with the most contrast (default: screen)</source>
        <translation>боје: као на светлом или тамном екрану; за штампу, где се стране и линије разликују и по нијанси сиве; или са највећим контрастом (подразумевано: screen)</translation>
    </message>
    <message>
        <source>delete the settings, then open the window</source>
        <translation>избриши подешавања, па отвори прозор</translation>
    </message>
    <message>
        <source>draw a figure as PNG, SVG, PDF, TikZ or HTML, without a window or display</source>
        <translation>нацртај цртеж као PNG, SVG, PDF, TikZ или HTML, без прозора и екрана</translation>
    </message>
    <message>
        <source>draw a film: a value of --set changes from FIRST to LAST; may be repeated for values that change together</source>
        <translation>нацртај филм: вредност из --set мења се од FIRST до LAST; може да се понови за вредности које се мењају заједно</translation>
    </message>
    <message>
        <source>draw a film: how --step follows from the step before</source>
        <translation>нацртај филм: како --step следи из претходног корака</translation>
    </message>
    <message>
        <source>draw a film: the ndc pane goes from the world through all stages to the image, and back</source>
        <translation>нацртај филм: приказ ndc иде од света кроз све фазе до слике, и назад</translation>
    </message>
    <message>
        <source>draw a film: the world is seen from all round, or as far round as DEGREES say, and back; the camera stays where it is</source>
        <translation>нацртај филм: свет се види са свих страна, или унаоколо колико каже DEGREES, и назад; камера остаје где јесте</translation>
    </message>
    <message>
        <source>draw all results; FILE as for --json, ending in .png, or in .svg or .pdf for vectors</source>
        <translation>нацртај све резултате; FILE као за --json, са завршетком .png, или .svg или .pdf за векторе</translation>
    </message>
    <message>
        <source>draw errors over time, or over bytes, which are the same on every machine</source>
        <translation>нацртај грешке према времену, или према бајтовима, који су исти на свакој машини</translation>
    </message>
    <message>
        <source>draw every step of a talk, or print it with its notes</source>
        <translation>нацртај сваки корак презентације, или је штампај са белешкама</translation>
    </message>
    <message>
        <source>draw every step without a display, run lesson check, measure the pictures, and report each mistake with file and line</source>
        <translation>нацртај сваки корак без екрана, изврши lesson check, измери слике, и пријави сваку грешку са датотеком и редом</translation>
    </message>
    <message>
        <source>draw many figures: a CSV file with a line for each, whose columns are out, file, the options without their dashes, and names of --set; each document, and each step of the lessons and talks, of a folder; or each step of one lesson</source>
        <translation>нацртај много цртежа: датотека CSV са по једним редом за сваки, чије су колоне out, file, опције без својих цртица, и имена из --set; сваки документ, и сваки корак лекција и презентација, из фасцикле; или сваки корак једне лекције</translation>
    </message>
    <message>
        <source>draw the same figure with more pixels (default: 1)</source>
        <translation>нацртај исти цртеж са више пиксела (подразумевано: 1)</translation>
    </message>
    <message>
        <source>every factor from the object to the picture, and the products so far</source>
        <translation>сваки чинилац од објекта до слике, и досадашњи производи</translation>
    </message>
    <message>
        <source>follow points through every stage of the projection</source>
        <translation>прати тачке кроз сваку фазу пројекције</translation>
    </message>
    <message>
        <source>how panes draw (default: opengl with a graphics card, raster without)</source>
        <translation>како прикази цртају (подразумевано: opengl са графичком картицом, raster без ње)</translation>
    </message>
    <message>
        <source>in LaTeX: formulas in the cells instead of numbers</source>
        <translation>у LaTeX-у: формуле у пољима уместо бројева</translation>
    </message>
    <message>
        <source>in LaTeX: letters of axes and formulas: own, 000, 001, 002, 003, 004, or those of a file such as letters.toml (default: the document&apos;s)</source>
        <translation>у LaTeX-у: слова оса и формула: own, 000, 001, 002, 003, 004, или она из датотеке као letters.toml (подразумевано: она из документа)</translation>
    </message>
    <message>
        <source>in LaTeX: numbers, also after --symbols</source>
        <translation>у LaTeX-у: бројеви, и после --symbols</translation>
    </message>
    <message>
        <source>in LaTeX: significant digits of numbers, up to 17, which are all (default: 4)</source>
        <translation>у LaTeX-у: значајне цифре бројева, највише 17, што су све (подразумевано: 4)</translation>
    </message>
    <message>
        <source>in LaTeX: the width of the text or the column, such as 84mm, in mm, cm, in or pt (default: 345pt, the text of an article)</source>
        <translation>у LaTeX-у: ширина текста или ступца, као 84mm, у mm, cm, in или pt (подразумевано: 345pt, текст класе article)</translation>
    </message>
    <message>
        <source>in all but .png, lines behind faces: left out, dashed as in ISO 128, or thin and grey (default: none)</source>
        <translation>у свему осим .png, линије иза страна: изостављене, испрекидане као у ISO 128, или танке и сиве (подразумевано: none)</translation>
    </message>
    <message>
        <source>instead of --size: how wide it is after it was cropped without a margin, such as 84mm; its height is free, and letters keep their size</source>
        <translation>уместо --size: ширина после опсецања без маргине, као 84mm; висина је слободна, а слова задржавају величину</translation>
    </message>
    <message>
        <source>instead: the code and its packages, for machines with Python</source>
        <translation>уместо тога: кôд и његови пакети, за машине са Python-ом</translation>
    </message>
    <message>
        <source>leave out what is empty around the figure, but for a margin of 2 mm</source>
        <translation>изостави оно што је око цртежа празно, осим маргине од 2 mm</translation>
    </message>
    <message>
        <source>leave the background transparent</source>
        <translation>остави позадину провидном</translation>
    </message>
    <message>
        <source>letters of axes and formulas: own, 000, 001, 002, 003, 004, or those of a file such as letters.toml (default: the document&apos;s)</source>
        <translation>слова оса и формула: own, 000, 001, 002, 003, 004, или она из датотеке као letters.toml (подразумевано: она из документа)</translation>
    </message>
    <message>
        <source>letters of axes and formulas: own, 000, 001, 002, 003, 004, or those of a file such as letters.toml (default: the document&apos;s, or the lesson&apos;s)</source>
        <translation>слова оса и формула: own, 000, 001, 002, 003, 004, или она из датотеке као letters.toml (подразумевано: она из документа, или из лекције)</translation>
    </message>
    <message>
        <source>letters of axes and formulas: own, 000, 001, 002, 003, 004, or those of a file such as letters.toml (default: the talk&apos;s)</source>
        <translation>слова оса и формула: own, 000, 001, 002, 003, 004, или она из датотеке као letters.toml (подразумевано: она из презентације)</translation>
    </message>
    <message>
        <source>make a folder to carry to machines without a network or an administrator</source>
        <translation>направи фасциклу која се носи на машине без мреже и администратора</translation>
    </message>
    <message>
        <source>measure for half a minute only, less exactly</source>
        <translation>мери само пола минута, мање прецизно</translation>
    </message>
    <message>
        <source>measure the errors over a parameter&apos;s range; NAME is one of near, far, fov, distance, up, aspect, gap</source>
        <translation>измери грешке у опсегу једног параметра; NAME је једно од near, far, fov, distance, up, aspect, gap</translation>
    </message>
    <message>
        <source>measure this trade; may be repeated (default, without --sweep: all)</source>
        <translation>измери овај компромис; може да се понови (подразумевано, без --sweep: све)</translation>
    </message>
    <message>
        <source>measure, on this machine, what speed costs in accuracy</source>
        <translation>измери, на овој машини, колико тачности кошта брзина</translation>
    </message>
    <message>
        <source>of --batch with a folder or a lesson: what to write (default: png)</source>
        <translation>уз --batch са фасциклом или лекцијом: шта се уписује (подразумевано: png)</translation>
    </message>
    <message>
        <source>of --batch: leave out figures that are newer than the list and their document</source>
        <translation>уз --batch: изостави цртеже новије од списка и свог документа</translation>
    </message>
    <message>
        <source>of --sweep: in equal steps, in equal ratios, or slowly at both ends (default: linear)</source>
        <translation>уз --sweep: у једнаким корацима, у једнаким односима, или споро на оба краја (подразумевано: linear)</translation>
    </message>
    <message>
        <source>of --sweep: write the values below the panes</source>
        <translation>уз --sweep: испиши вредности испод приказа</translation>
    </message>
    <message>
        <source>of --wheels, such as 3.12; may be repeated (default: this one&apos;s)</source>
        <translation>уз --wheels, као 3.12; може да се понови (подразумевано: верзија овог)</translation>
    </message>
    <message>
        <source>of --wheels; may be repeated (default: all of them)</source>
        <translation>уз --wheels; може да се понови (подразумевано: све)</translation>
    </message>
    <message>
        <source>of a film: from the last frame to the first, not at all, or there and back in all frames together (default: repeat for --sweep and all round, once for --transition and numbered files, else back-and-forth)</source>
        <translation>за филм: од последњег кадра на први, без понављања, или тамо и назад укупно у свим кадровима (подразумевано: repeat за --sweep и кружење, once за --transition и нумерисане датотеке, иначе back-and-forth)</translation>
    </message>
    <message>
        <source>of a film: how many frames (default: 48; of --stages 120, of --transition 24; in .html 21)</source>
        <translation>за филм: колико кадрова (подразумевано: 48; за --stages 120, за --transition 24; у .html 21)</translation>
    </message>
    <message>
        <source>of a film: how many frames a second (default: 25)</source>
        <translation>за филм: колико кадрова у секунди (подразумевано: 25)</translation>
    </message>
    <message>
        <source>of check and print: letters of axes and formulas: own, 000, 001, 002, 003, 004, or those of a file such as letters.toml (default: the lesson&apos;s)</source>
        <translation>уз check и print: слова оса и формула: own, 000, 001, 002, 003, 004, или она из датотеке као letters.toml (подразумевано: она из лекције)</translation>
    </message>
    <message>
        <source>of print: the topics, or files of lessons, whose exercises make the test</source>
        <translation>уз print: теме, или датотеке лекција, чији задаци чине тест</translation>
    </message>
    <message>
        <source>of print: the variants, one file for each; a variant has the same numbers everywhere</source>
        <translation>уз print: варијанте, по једна датотека за сваку; варијанта свуда има исте бројеве</translation>
    </message>
    <message>
        <source>of print: where the PDF files go; existing files are overwritten</source>
        <translation>уз print: где иду PDF датотеке; постојеће датотеке се преписују</translation>
    </message>
    <message>
        <source>of print: write one more file, with the answers of all variants and their ways</source>
        <translation>уз print: упиши још једну датотеку, са одговорима свих варијанти и поступцима</translation>
    </message>
    <message>
        <source>of results: write a table, a row for each answer; an existing file is overwritten</source>
        <translation>уз results: упиши табелу, по један ред за сваки одговор; постојећа датотека се преписује</translation>
    </message>
    <message>
        <source>of the chart, as of a figure (default: screen)</source>
        <translation>за дијаграм, као за цртеж (подразумевано: screen)</translation>
    </message>
    <message>
        <source>of the chart, as of a figure; with --size, --width or --text-size there are no notes below</source>
        <translation>за дијаграм, као за цртеж; уз --size, --width или --text-size испод нема белешки</translation>
    </message>
    <message>
        <source>of the chart, instead of --size; its height is free</source>
        <translation>за дијаграм, уместо --size; висина је слободна</translation>
    </message>
    <message>
        <source>of the handout: teacher has answers and notes, students room to write instead</source>
        <translation>за материјал за слушаоце: teacher има одговоре и белешке, students место за писање</translation>
    </message>
    <message>
        <source>output format (default: table)</source>
        <translation>излазни формат (подразумевано: table)</translation>
    </message>
    <message>
        <source>output format (default: text)</source>
        <translation>излазни формат (подразумевано: text)</translation>
    </message>
    <message>
        <source>print every stage&apos;s matrix</source>
        <translation>испиши матрицу сваке фазе</translation>
    </message>
    <message>
        <source>report the fraction done, one per line, and take the commands pause, resume and cancel from standard input</source>
        <translation>пријављуј урађени део, по један у реду, и примај наредбе pause, resume и cancel са стандардног улаза</translation>
    </message>
    <message>
        <source>report what this machine has, what is missing and how to get it</source>
        <translation>извести шта ова машина има, шта недостаје и како се то набавља</translation>
    </message>
    <message>
        <source>save a picture of the window as PNG and quit</source>
        <translation>сачувај слику прозора као PNG и изађи</translation>
    </message>
    <message>
        <source>show program&apos;s version number and exit</source>
        <translation>прикажи број верзије програма и изађи</translation>
    </message>
    <message>
        <source>size of all letters of the chart in points (default: 7 with --size or --width)</source>
        <translation>величина свих слова дијаграма у тачкама (подразумевано: 7 уз --size или --width)</translation>
    </message>
    <message>
        <source>size of the window</source>
        <translation>величина прозора</translation>
    </message>
    <message>
        <source>size of all letters in points; 72 points are 300 pixels at scale 1 (default: 7 in a pane of 640 pixels, in proportion in others)</source>
        <translation>величина свих слова у тачкама; 72 тачке су 300 пиксела при размери 1 (подразумевано: 7 у приказу од 640 пиксела, у осталима сразмерно)</translation>
    </message>
    <message>
        <source>size on paper, such as 120mmx80mm, in mm, cm or in; or in pixels at scale 1, 300 an inch (default: 640x640 for each pane, or its own size for the image alone); in .html, of each pane</source>
        <translation>величина на папиру, као 120mmx80mm, у mm, cm или in; или у пикселима при размери 1, 300 по инчу (подразумевано: 640x640 за сваки приказ, или сопствена величина за саму слику); у .html, сваког приказа</translation>
    </message>
    <message>
        <source>space of the coordinates (default: world)</source>
        <translation>координатни систем тачака (подразумевано: world)</translation>
    </message>
    <message>
        <source>the figure to write (.png; .svg, .pdf or TikZ&apos;s .tex for shapes and text; .html for a page that phones show), and the document, picture, mesh, camera, lesson or talk to draw (default: the letter F); with --batch, the folder of the figures; with --sweep, --orbit, --stages or --transition, a film (.gif, .apng, .webp, or .mp4 with ffmpeg), a page with a slider (.html), or a name with %03d for a figure of each frame</source>
        <translation>цртеж који се уписује (.png; .svg, .pdf или TikZ-ов .tex за облике и текст; .html за страницу коју приказују телефони), и документ, слика, мрежа, камера, лекција или презентација која се црта (подразумевано: слово F); уз --batch, фасцикла цртежа; уз --sweep, --orbit, --stages или --transition, филм (.gif, .apng, .webp, или .mp4 са програмом ffmpeg), страница са клизачем (.html), или име са %03d за цртеж сваког кадра</translation>
    </message>
    <message>
        <source>the panes to draw, side by side, or below each other with / instead of commas (default: all, side by side; of a step, those of its slide); or equation, alone: that of view.equation, which is the default where --set asks for one</source>
        <translation>прикази који се цртају, један поред другог, или један испод другог са / уместо зареза (подразумевано: сви, један поред другог; за корак, они са његовог слајда); или equation, само: она из view.equation, што је подразумевано кад је --set тражи</translation>
    </message>
    <message>
        <source>the same as --set scene=NAME</source>
        <translation>исто што и --set scene=NAME</translation>
    </message>
    <message>
        <source>the six planes of the view volume in world space</source>
        <translation>шест равни запремине погледа у координатном систему света</translation>
    </message>
    <message>
        <source>the step of a lesson or a talk to draw, its number or its name (default: the first)</source>
        <translation>корак лекције или презентације који се црта, његов број или име (подразумевано: први)</translation>
    </message>
    <message>
        <source>what the world pane frames: what is named, with the whole frustum too, or the objects alone (default: named)</source>
        <translation>шта приказ света обухвата: оно што је именовано, и уз целу зарубљену пирамиду, или само објекте (подразумевано: named)</translation>
    </message>
    <message>
        <source>where to put the folder frustum-lab, with the program and all that it needs, for machines like this one without Python; and an archive of it</source>
        <translation>где да се смести фасцикла frustum-lab, са програмом и свиме што му треба, за машине као ова али без Python-а; и њена архива</translation>
    </message>
    <message>
        <source>write all results; FILE is overwritten, - is standard output</source>
        <translation>упиши све резултате; FILE се преписује, - је стандардни излаз</translation>
    </message>
    <message>
        <source>write the figures, text and notes of every step on A4 pages (.pdf) or as a page that phones show (.html); an existing file is overwritten</source>
        <translation>упиши цртеже, текст и белешке сваког корака на страницама A4 (.pdf) или као страницу коју приказују телефони (.html); постојећа датотека се преписује</translation>
    </message>
    <message>
        <source>write the tables, one after the other; FILE as for --json</source>
        <translation>упиши табеле, једну за другом; FILE као за --json</translation>
    </message>
</context>
<context>
    <name>OrderView</name>
    <message>
        <source>The tile at the bottom acts first.</source>
        <translation>Плочица на дну делује прва.</translation>
    </message>
</context>
<context>
    <name>Overview</name>
    <message>
        <source>Overview of what you practised</source>
        <translation>Преглед онога што сте вежбали</translation>
    </message>
    <message>
        <source>solved alone</source>
        <translation>решено без помоћи</translation>
    </message>
    <message>
        <source>solved with help</source>
        <translation>решено уз помоћ</translation>
    </message>
    <message>
        <source>answer shown</source>
        <translation>одговор приказан</translation>
    </message>
    <message>
        <source>not yet</source>
        <translation>још није</translation>
    </message>
    <message>
        <source>Test &amp;yourself…</source>
        <translation>Испитајте &amp;се…</translation>
    </message>
    <message>
        <source>&amp;Export…</source>
        <translation>&amp;Извези…</translation>
    </message>
    <message>
        <source>Write all of it into a file for your teacher</source>
        <translation>Упиши све то у датотеку за наставника</translation>
    </message>
    <message>
        <source>only a number: not yet</source>
        <translation>само број: још није</translation>
    </message>
    <message>
        <source>Open the lesson</source>
        <translation>Отвори лекцију</translation>
    </message>
    <message>
        <source>{0}, exercise {1}: {2}. {3}</source>
        <translation>{0}, задатак {1}: {2}. {3}</translation>
    </message>
    <message>
        <source>once</source>
        <translation>једном</translation>
    </message>
    <message numerus="yes">
        <source>%n times</source>
        <translation>
            <numerusform>%n пут</numerusform>
            <numerusform>%n пута</numerusform>
            <numerusform>%n пута</numerusform>
        </translation>
    </message>
    <message>
        <source>“{0}” {1}; then: {2}</source>
        <translation>„{0}” {1}; затим: {2}</translation>
    </message>
</context>
<context>
    <name>Pane</name>
    <message>
        <source>Reset this pane&apos;s own view (double-click)</source>
        <translation>Врати сопствени поглед овог приказа на почетни (двоклик)</translation>
    </message>
    <message>
        <source>Enlarge; click again for the whole window</source>
        <translation>Увећај; поновни клик за цео прозор</translation>
    </message>
    <message>
        <source>Move to a window of its own, and back</source>
        <translation>Премести у сопствени прозор, и назад</translation>
    </message>
</context>
<context>
    <name>Pen</name>
    <message>
        <source>Pen</source>
        <translation>Оловка</translation>
    </message>
    <message>
        <source>Colours, eraser, undo, clear, keep</source>
        <translation>Боје, гумица, опозив, брисање, чување</translation>
    </message>
    <message>
        <source>Black</source>
        <translation>Црна</translation>
    </message>
    <message>
        <source>Orange</source>
        <translation>Наранџаста</translation>
    </message>
    <message>
        <source>Green</source>
        <translation>Зелена</translation>
    </message>
    <message>
        <source>Blue</source>
        <translation>Плава</translation>
    </message>
    <message>
        <source>Erase</source>
        <translation>Гумица</translation>
    </message>
    <message>
        <source>Remove the strokes that are touched (E)</source>
        <translation>Уклони потезе који се додирну (E)</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Опозови</translation>
    </message>
    <message>
        <source>Remove the last stroke (Ctrl+Z)</source>
        <translation>Уклони последњи потез (Ctrl+Z)</translation>
    </message>
    <message>
        <source>Clear</source>
        <translation>Обриши</translation>
    </message>
    <message>
        <source>Remove all strokes of the step (Delete)</source>
        <translation>Уклони све потезе овог корака (Delete)</translation>
    </message>
    <message>
        <source>Keep</source>
        <translation>Задржи</translation>
    </message>
    <message>
        <source>Keep the strokes for the handout (K)</source>
        <translation>Задржи потезе за материјал за слушаоце (K)</translation>
    </message>
</context>
<context>
    <name>Pictures</name>
    <message>
        <source>Export a picture</source>
        <translation>Извези слику</translation>
    </message>
    <message>
        <source>{0} pictures (*.{1})</source>
        <translation>Слике {0} (*.{1})</translation>
    </message>
    <message>
        <source>Exported {0}</source>
        <translation>Извезено: {0}</translation>
    </message>
    <message>
        <source>Drawing the picture</source>
        <translation>Црта се слика</translation>
    </message>
    <message>
        <source>Export a diagram</source>
        <translation>Извези дијаграм</translation>
    </message>
    <message>
        <source>Copied the diagram</source>
        <translation>Дијаграм је копиран</translation>
    </message>
    <message>
        <source>Copied the picture</source>
        <translation>Слика је копирана</translation>
    </message>
</context>
<context>
    <name>Plane</name>
    <message>
        <source>near</source>
        <translation>предња</translation>
    </message>
    <message>
        <source>far</source>
        <translation>задња</translation>
    </message>
    <message>
        <source>left</source>
        <translation>лева</translation>
    </message>
    <message>
        <source>right</source>
        <translation>десна</translation>
    </message>
    <message>
        <source>bottom</source>
        <translation>доња</translation>
    </message>
    <message>
        <source>top</source>
        <translation>горња</translation>
    </message>
</context>
<context>
    <name>Playing</name>
    <message>
        <source>Play</source>
        <translation>Пусти</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Паузирај</translation>
    </message>
</context>
<context>
    <name>Practice</name>
    <message>
        <source>&amp;Review</source>
        <translation>По&amp;нављање</translation>
    </message>
    <message>
        <source>{0} of {1}</source>
        <translation>{0} од {1}</translation>
    </message>
    <message>
        <source>The next review is tomorrow.</source>
        <translation>Следеће понављање је сутра.</translation>
    </message>
    <message>
        <source>The next review is on {0}.</source>
        <translation>Следеће понављање: {0}</translation>
    </message>
    <message>
        <source>Go on with it</source>
        <translation>Настави</translation>
    </message>
    <message>
        <source>The test is kept.</source>
        <translation>Тест је сачуван.</translation>
    </message>
    <message>
        <source>all topics</source>
        <translation>све теме</translation>
    </message>
    <message>
        <source>Test {0}: {1}</source>
        <translation>Тест {0}: {1}</translation>
    </message>
    <message>
        <source>These topics have no exercises yet.</source>
        <translation>Ове теме још немају задатке.</translation>
    </message>
    <message>
        <source>Save the result</source>
        <translation>Сачувај резултат</translation>
    </message>
    <message>
        <source>Your name, if your teacher is to read it in the file:</source>
        <translation>Ваше име, ако наставник треба да га прочита у датотеци:</translation>
    </message>
    <message>
        <source>Results (*.json);;All files (*)</source>
        <translation>Резултати (*.json);;Све датотеке (*)</translation>
    </message>
    <message>
        <source>result</source>
        <translation>резултат</translation>
    </message>
    <message>
        <source>The result is in {0}.</source>
        <translation>Резултат је у датотеци {0}.</translation>
    </message>
    <message>
        <source>Review</source>
        <translation>Понављање</translation>
    </message>
    <message>
        <source>What you do not solve alone comes back in a day.</source>
        <translation>Оно што не решите сами враћа се за један дан.</translation>
    </message>
    <message>
        <source>Nothing has come back today.</source>
        <translation>Данас се ништа није вратило.</translation>
    </message>
    <message>
        <source>&amp;Review: {0}, about {1}</source>
        <translation>По&amp;нављање: {0}, око {1}</translation>
    </message>
</context>
<context>
    <name>ProbeNumbers</name>
    <message>
        <source>object</source>
        <translation>објекат</translation>
    </message>
    <message>
        <source>world</source>
        <translation>свет</translation>
    </message>
    <message>
        <source>view</source>
        <translation>камера</translation>
    </message>
    <message>
        <source>clip</source>
        <translation>одсецање</translation>
    </message>
    <message>
        <source>divide</source>
        <translation>дељење</translation>
    </message>
    <message>
        <source>NDC</source>
        <translation>NDC</translation>
    </message>
    <message>
        <source>image px</source>
        <translation>слика px</translation>
    </message>
    <message>
        <source>depth</source>
        <translation>дубина</translation>
    </message>
    <message>
        <source>inside</source>
        <translation>унутар</translation>
    </message>
    <message>
        <source>outside of: {0}</source>
        <translation>са спољне стране: {0}</translation>
    </message>
    <message>
        <source>none: a scale of 0 has flattened the object</source>
        <translation>ниједна: скалирање са 0 је спљоштило објекат</translation>
    </message>
    <message>
        <source>the vanishing point; {0}</source>
        <translation>тачка недогледа; {0}</translation>
    </message>
    <message>
        <source>behind the eye</source>
        <translation>иза камере</translation>
    </message>
    <message>
        <source>in the eye plane (w = 0)</source>
        <translation>у равни камере (w = 0)</translation>
    </message>
    <message>
        <source>the opposite direction has a picture</source>
        <translation>супротан смер има слику</translation>
    </message>
    <message>
        <source>behind the eye: no picture</source>
        <translation>иза камере: нема слике</translation>
    </message>
    <message>
        <source>parallel to the image: lines stay parallel</source>
        <translation>паралелно слици: праве остају паралелне</translation>
    </message>
    <message>
        <source>parallel projectors: lines stay parallel</source>
        <translation>паралелни зраци пројекције: праве остају паралелне</translation>
    </message>
    <message>
        <source>w = 0: its picture is at infinity too</source>
        <translation>w = 0: и слика је у бесконачности</translation>
    </message>
    <message>
        <source>beside the eye: no number is large enough</source>
        <translation>поред камере: ниједан број није довољно велик</translation>
    </message>
    <message>
        <source>the pixel&apos;s ray, from near to far</source>
        <translation>зрак пиксела, од предње до задње равни</translation>
    </message>
    <message>
        <source>the pixel&apos;s ray, as far as it is in front of the eye</source>
        <translation>зрак пиксела, докле год је испред камере</translation>
    </message>
    <message>
        <source>no ray in the world: the matrix has no inverse</source>
        <translation>у свету нема зрака: матрица нема инверз</translation>
    </message>
    <message>
        <source>no ray in the world: all of it is behind the eye</source>
        <translation>у свету нема зрака: цео је иза камере</translation>
    </message>
</context>
<context>
    <name>ProbePanel</name>
    <message>
        <source>The probes&apos; numbers at every stage</source>
        <translation>Бројеви сонди у свакој фази</translation>
    </message>
    <message>
        <source>The probe that the fields and buttons change</source>
        <translation>Сонда коју мењају поља и дугмад</translation>
    </message>
    <message>
        <source>Probe</source>
        <translation>Сонда</translation>
    </message>
    <message>
        <source>Probe, world {0}</source>
        <translation>Сонда, свет: {0}</translation>
    </message>
    <message>
        <source>World {0} of the probe; type a number</source>
        <translation>Координата {0} сонде у свету; унесите број</translation>
    </message>
    <message>
        <source>w of the probe: 1 for a point; 0 for the point at infinity in the direction x, y, z; with any other w the point is (x/w, y/w, z/w)</source>
        <translation>w сонде: 1 за тачку; 0 за бесконачно далеку тачку у смеру x, y, z; са било којим другим w тачка је (x/w, y/w, z/w)</translation>
    </message>
    <message>
        <source>Keep this probe: the next click makes another one</source>
        <translation>Задржи ову сонду: следећи клик прави нову</translation>
    </message>
    <message>
        <source>Pin</source>
        <translation>Закачи</translation>
    </message>
    <message>
        <source>Remove this probe (Esc)</source>
        <translation>Уклони ову сонду (Esc)</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Уклони</translation>
    </message>
    <message>
        <source>Clear</source>
        <translation>Обриши</translation>
    </message>
    <message>
        <source>Remove all probes</source>
        <translation>Уклони све сонде</translation>
    </message>
    <message>
        <source>Click a point in any pane to follow it from the world to its pixel; click an empty place in the image for the ray of that pixel.</source>
        <translation>Кликните на тачку у било ком приказу да бисте је пратили од света до пиксела; кликните на празно место на слици за зрак тог пиксела.</translation>
    </message>
    <message>
        <source>Probes = {0}: at most {1} can be pinned; remove one first.</source>
        <translation>Број сонди = {0}: може да се закачи највише {1}; прво уклоните једну.</translation>
    </message>
    <message>
        <source>{0}, pinned</source>
        <translation>{0}, закачено</translation>
    </message>
    <message>
        <source>Ray {0}</source>
        <translation>Зрак {0}</translation>
    </message>
    <message>
        <source>Point {0}</source>
        <translation>Тачка {0}</translation>
    </message>
    <message>
        <source>Direction {0}</source>
        <translation>Смер {0}</translation>
    </message>
</context>
<context>
    <name>ProbeTable</name>
    <message>
        <source>Copy, with all digits</source>
        <translation>Копирај, са свим цифрама</translation>
    </message>
</context>
<context>
    <name>Probing</name>
    <message>
        <source>depth = {0}: must be that of something drawn, but nothing is here</source>
        <translation>дубина = {0}: мора да буде дубина нечег нацртаног, али овде нема ничега</translation>
    </message>
</context>
<context>
    <name>Progress</name>
    <message>
        <source>Cancel</source>
        <translation>Откажи</translation>
    </message>
</context>
<context>
    <name>QPlatformTheme</name>
    <message>
        <source>&amp;No</source>
        <translation>&amp;Не</translation>
    </message>
    <message>
        <source>&amp;Yes</source>
        <translation>&amp;Да</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Откажи</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Затвори</translation>
    </message>
    <message>
        <source>Discard</source>
        <translation>Одбаци</translation>
    </message>
    <message>
        <source>OK</source>
        <translation>У реду</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Сачувај</translation>
    </message>
</context>
<context>
    <name>Readout</name>
    <message>
        <source>More numbers</source>
        <translation>Још бројева</translation>
    </message>
    <message>
        <source>Show or fold the other numbers of this scene</source>
        <translation>Прикажи или склопи остале бројеве ове сцене</translation>
    </message>
</context>
<context>
    <name>Recovery</name>
    <message>
        <source>There is unsaved work from {0}.</source>
        <translation>Има несачуваног рада од {0}.</translation>
    </message>
    <message>
        <source>Recover it</source>
        <translation>Поврати га</translation>
    </message>
    <message>
        <source>Discard it</source>
        <translation>Одбаци га</translation>
    </message>
    <message>
        <source>The recovered work cannot be kept in {0}: save it soon.</source>
        <translation>Повраћени рад не може да се чува на месту {0}: ускоро га сачувајте.</translation>
    </message>
    <message>
        <source>{0} could not be removed: {1}.</source>
        <translation>Није могло да се уклони {0}: {1}.</translation>
    </message>
    <message>
        <source>No copy of unsaved work can be kept in {0}: save it soon.</source>
        <translation>Копија несачуваног рада не може да се чува на месту {0}: ускоро га сачувајте.</translation>
    </message>
</context>
<context>
    <name>Refusal</name>
    <message>
        <source>A film&apos;s frames have one size: leave out crop and width.</source>
        <translation>Кадрови филма имају исту величину: изоставите опсецање и ширину.</translation>
    </message>
    <message>
        <source>A point ends at {0} instead of {1}.</source>
        <translation>Једна тачка завршава у {0} уместо у {1}.</translation>
    </message>
    <message>
        <source>All signs are turned round.</source>
        <translation>Сви предзнаци су обрнути.</translation>
    </message>
    <message>
        <source>Both orders do the same.</source>
        <translation>Оба редоследа чине исто.</translation>
    </message>
    <message>
        <source>It is close, but not exact enough.</source>
        <translation>Близу је, али није довољно тачно.</translation>
    </message>
    <message>
        <source>It is off by the factor 180/π: degrees and radians are mixed up.</source>
        <translation>Одступа за чинилац 180/π: помешани су степени и радијани.</translation>
    </message>
    <message>
        <source>It is too large, by a factor of about {0}.</source>
        <translation>Превелико је, и то приближно {0} пута.</translation>
    </message>
    <message>
        <source>It is too small, by a factor of about {0}.</source>
        <translation>Премало је, и то приближно {0} пута.</translation>
    </message>
    <message>
        <source>It swings about the origin, and ends {0} units away from its place.</source>
        <translation>Описује лук око координатног почетка и завршава на растојању {0} од свог места.</translation>
    </message>
    <message>
        <source>None of the numbers is right.</source>
        <translation>Ниједан број није тачан.</translation>
    </message>
    <message>
        <source>Only column {0} is wrong.</source>
        <translation>Погрешна је само колона {0}.</translation>
    </message>
    <message>
        <source>Only row {0} is wrong.</source>
        <translation>Погрешна је само врста {0}.</translation>
    </message>
    <message>
        <source>Only the number in row {0}, column {1} is wrong.</source>
        <translation>Погрешан је само број у врсти {0}, колони {1}.</translation>
    </message>
    <message>
        <source>The digits are right, but the power of ten is wrong.</source>
        <translation>Цифре су тачне, али је степен броја десет погрешан.</translation>
    </message>
    <message>
        <source>The document</source>
        <translation>Документ</translation>
    </message>
    <message>
        <source>The marked numbers have the wrong sign.</source>
        <translation>Обележени бројеви имају погрешан предзнак.</translation>
    </message>
    <message>
        <source>The numbers are right, but columns {0} and {1} are exchanged.</source>
        <translation>Бројеви су тачни, али су колоне {0} и {1} замењене.</translation>
    </message>
    <message>
        <source>The numbers are right, but rows and columns are exchanged.</source>
        <translation>Бројеви су тачни, али су врсте и колоне замењене.</translation>
    </message>
    <message>
        <source>The numbers are right, but rows {0} and {1} are exchanged.</source>
        <translation>Бројеви су тачни, али су врсте {0} и {1} замењене.</translation>
    </message>
    <message>
        <source>The origin ends at {0} instead of {1}.</source>
        <translation>Координатни почетак завршава у {0} уместо у {1}.</translation>
    </message>
    <message>
        <source>The sign is wrong, and so is the size.</source>
        <translation>Предзнак је погрешан, а и величина.</translation>
    </message>
    <message>
        <source>The size is right, but the sign is wrong.</source>
        <translation>Величина је тачна, али је предзнак погрешан.</translation>
    </message>
    <message>
        <source>The w of a point becomes {0} instead of {1}.</source>
        <translation>w једне тачке постаје {0} уместо {1}.</translation>
    </message>
    <message>
        <source>The {0} axis becomes {1} instead of {2}.</source>
        <translation>Оса {0} постаје {1} уместо {2}.</translation>
    </message>
    <message>
        <source>There is no preview of {0} triangles and points.</source>
        <translation>Нема прегледа када је број троуглова и тачака {0}.</translation>
    </message>
    <message>
        <source>There is no scene “{0}”, only {1} or {2}; a mesh file needs its ending.</source>
        <translation>Нема сцене „{0}”, само {1} или {2}; датотеци мреже потребан је наставак имена.</translation>
    </message>
    <message>
        <source>There is no scene “{0}”, only {1} or {2}; did you mean “{3}”?</source>
        <translation>Нема сцене „{0}”, само {1} или {2}; да ли сте мислили на „{3}”?</translation>
    </message>
    <message>
        <source>This is 1 divided by the right number.</source>
        <translation>Ово је 1 подељено тачним бројем.</translation>
    </message>
    <message>
        <source>asks for a part that {0} does not have</source>
        <translation>тражи део који {0} нема</translation>
    </message>
    <message>
        <source>begins a block that is not closed: a line ``` must end it</source>
        <translation>почиње блок који није затворен: мора да га заврши ред ```</translation>
    </message>
    <message>
        <source>begins a block that is not closed: a line ``` must end it, above line {0}, where another begins</source>
        <translation>почиње блок који није затворен: мора да га заврши ред ```, изнад реда {0}, где почиње други</translation>
    </message>
    <message>
        <source>begins a block, but is indented: ``` must begin the line</source>
        <translation>почиње блок, али је увучено: ``` мора да почне ред</translation>
    </message>
    <message>
        <source>begins a formula with $ that no other $ on its line ends</source>
        <translation>почиње формулу знаком $ коју ниједан други $ у том реду не завршава</translation>
    </message>
    <message>
        <source>begins code that is not closed: there is one ``` line too many, or one without its kind</source>
        <translation>почиње кôд који није затворен: један ред ``` је вишак, или је један без врсте</translation>
    </message>
    <message>
        <source>begins code, not a block, and the block of line {0} is in it: there is one ``` line too many, or one without its kind</source>
        <translation>почиње кôд, а не блок, и у њему је блок из реда {0}: један ред ``` је вишак, или је један без врсте</translation>
    </message>
    <message>
        <source>belongs to another lens: set lens.kind as well ({0})</source>
        <translation>припада другом објективу: поставите и lens.kind ({0})</translation>
    </message>
    <message>
        <source>belongs to another scene: set scene as well ({0})</source>
        <translation>припада другој сцени: поставите и scene ({0})</translation>
    </message>
    <message>
        <source>can be read as {0} numbers with decimal commas or as {1} numbers: write decimal points</source>
        <translation>може да се чита као {0} бројева са децималним зарезом или као {1} бројева: пишите децималну тачку</translation>
    </message>
    <message>
        <source>cannot be moved in the scene {0}, whose objects are fixed</source>
        <translation>не може да се помера у сцени {0}, чији су објекти непомични</translation>
    </message>
    <message>
        <source>cannot be read: {0}</source>
        <translation>не може да се прочита: {0}</translation>
    </message>
    <message>
        <source>cannot be set together with {0}, which it replaces</source>
        <translation>не може да се постави заједно са {0}, јер то замењује</translation>
    </message>
    <message>
        <source>cannot be set together with {0}: both decide what the lens sees</source>
        <translation>не може да се постави заједно са {0}: обоје одређују шта објектив види</translation>
    </message>
    <message>
        <source>cannot be shown in the scene {0}, which needs its own objects</source>
        <translation>не може да се прикаже у сцени {0}, којој су потребни сопствени објекти</translation>
    </message>
    <message>
        <source>cannot be shown: {0}</source>
        <translation>не може да се прикаже: {0}</translation>
    </message>
    <message>
        <source>cannot be told from the wrong value of line {0}, {1}</source>
        <translation>не може да се разликује од погрешне вредности у реду {0}, {1}</translation>
    </message>
    <message>
        <source>cannot be written as NAME=VALUE alone</source>
        <translation>не може да се напише само као NAME=VALUE</translation>
    </message>
    <message>
        <source>cannot be written: another program may be writing it</source>
        <translation>не може да се упише: можда уписује други програм</translation>
    </message>
    <message>
        <source>cannot be written: it is a pipe or a device, not a regular file</source>
        <translation>не може да се упише: то је цев или уређај, а не обична датотека</translation>
    </message>
    <message>
        <source>cannot be written: it is write-protected</source>
        <translation>не може да се упише: постоји заштита од писања</translation>
    </message>
    <message>
        <source>cannot be written: {0}</source>
        <translation>не може да се упише: {0}</translation>
    </message>
    <message>
        <source>cannot be written: {0} says “{1}”</source>
        <translation>не може да се упише: {0} каже „{1}”</translation>
    </message>
    <message>
        <source>cloud: must have 1 to {1} points, and {0} were given.</source>
        <translation>облак: мора да има од 1 до {1} тачака, а дато их је {0}.</translation>
    </message>
    <message>
        <source>comes with the program and cannot be changed: copy it, and open the copy</source>
        <translation>долази са програмом и не може да се мења: копирајте, и отворите копију</translation>
    </message>
    <message>
        <source>counts something, but its value is {0}</source>
        <translation>нешто броји, али му је вредност {0}</translation>
    </message>
    <message>
        <source>divides by zero</source>
        <translation>дели нулом</translation>
    </message>
    <message>
        <source>does not exist</source>
        <translation>не постоји</translation>
    </message>
    <message>
        <source>does not fulfil the task</source>
        <translation>не испуњава задатак</translation>
    </message>
    <message>
        <source>does not hold</source>
        <translation>не важи</translation>
    </message>
    <message>
        <source>ease = log: {0} has no equal ratios from {1} to {2}; choose linear.</source>
        <translation>ease = log: {0} нема једнаке односе од {1} до {2}; изаберите linear.</translation>
    </message>
    <message>
        <source>finds no numbers that suit, for seed {0}; the last ones were refused: {1}</source>
        <translation>не налази бројеве који одговарају, за семе {0}; последњи су одбијени: {1}</translation>
    </message>
    <message>
        <source>fps = {0}: must be from 1 to {1}.</source>
        <translation>fps = {0}: мора да буде од 1 до {1}.</translation>
    </message>
    <message>
        <source>frames = {0}: must be a whole number from 2 to {1}.</source>
        <translation>frames = {0}: мора да буде цео број од 2 до {1}.</translation>
    </message>
    <message>
        <source>frames = {0}: must be even to go back and forth.</source>
        <translation>frames = {0}: мора да буде паран број за кретање напред-назад.</translation>
    </message>
    <message>
        <source>gets “{0}” instead of “{1}”</source>
        <translation>добија „{0}” уместо „{1}”</translation>
    </message>
    <message>
        <source>gets “{0}” instead of “{1}”; this variant has {2}</source>
        <translation>добија „{0}” уместо „{1}”; ова варијанта има {2}</translation>
    </message>
    <message>
        <source>gives the answer in a second way: keep one of {0}</source>
        <translation>даје одговор на други начин: задржите једно од {0}</translation>
    </message>
    <message>
        <source>has a formula that only an exercise writes in</source>
        <translation>има формулу коју уписује само „exercise”</translation>
    </message>
    <message>
        <source>has HTML, which a lesson shows as it is typed</source>
        <translation>садржи HTML, који лекција приказује онако како је откуцан</translation>
    </message>
    <message>
        <source>has “{0}:”, which belongs to {1} only</source>
        <translation>садржи „{0}:”, што иде само уз {1}</translation>
    </message>
    <message>
        <source>has a CAMERA_ID that is not in cameras.txt</source>
        <translation>садржи CAMERA_ID кога нема у cameras.txt</translation>
    </message>
    <message>
        <source>has a formula that cannot be typeset: {0}</source>
        <translation>садржи формулу која не може да се сложи: {0}</translation>
    </message>
    <message>
        <source>has a function that is not defined for its argument</source>
        <translation>садржи функцију која није дефинисана за свој аргумент</translation>
    </message>
    <message>
        <source>has a note of {0} words; the limit is {1}</source>
        <translation>има белешку са бројем речи {0}; граница је {1}</translation>
    </message>
    <message>
        <source>has a picture or a link, which a lesson shows as it is typed</source>
        <translation>садржи слику или везу, коју лекција приказује онако како је откуцана</translation>
    </message>
    <message>
        <source>has a power with a degree above {0} (character {1})</source>
        <translation>садржи степен са изложиоцем изнад {0} (знак {1})</translation>
    </message>
    <message>
        <source>has a value that is too large; the limit is {0}</source>
        <translation>садржи превелику вредност; граница је {0}</translation>
    </message>
    <message>
        <source>has an answer that the scene shows as “{0}”: add “hide: numbers”</source>
        <translation>има одговор који сцена приказује као „{0}”: додајте „hide: numbers”</translation>
    </message>
    <message>
        <source>has an unknown kind of block, {0}; the nearest is {1}</source>
        <translation>има непознату врсту блока, {0}; најближа је {1}</translation>
    </message>
    <message>
        <source>has faces that cross each other in too many places for a figure without pixels: write it as .png</source>
        <translation>има стране које се секу на превише места за цртеж без пиксела: упишите као .png</translation>
    </message>
    <message>
        <source>has more than {0} answers</source>
        <translation>има више одговора од {0}</translation>
    </message>
    <message>
        <source>has more than {0} levels of brackets</source>
        <translation>има више нивоа заграда од {0}</translation>
    </message>
    <message>
        <source>has more than {0} nested brackets (character {1})</source>
        <translation>има више угнежђених заграда од {0} (знак {1})</translation>
    </message>
    <message>
        <source>has more than {0} steps</source>
        <translation>има више корака од {0}</translation>
    </message>
    <message>
        <source>has more than {0} values</source>
        <translation>има више вредности од {0}</translation>
    </message>
    <message>
        <source>has no camera: no camera_matrix, K or fx, and no frame</source>
        <translation>нема камеру: нема ни camera_matrix, ни K, ни fx, ни кадра</translation>
    </message>
    <message>
        <source>has no steps</source>
        <translation>нема корака</translation>
    </message>
    <message>
        <source>has no strokes as Frustum Lab writes them</source>
        <translation>нема потеза какве пише Frustum Lab</translation>
    </message>
    <message>
        <source>has no value in this state, which has no {0}</source>
        <translation>нема вредност у овом стању, у коме нема: {0}</translation>
    </message>
    <message>
        <source>has no value, because infinity minus infinity or infinity times 0 is no number</source>
        <translation>нема вредност, јер бесконачност минус бесконачност или бесконачност пута 0 није број</translation>
    </message>
    <message>
        <source>has the place ({0}), which is not in the picture</source>
        <translation>садржи место ({0}), које није на слици</translation>
    </message>
    <message>
        <source>has the title of a step, but no line --- above it</source>
        <translation>има наслов корака, али нема реда --- изнад</translation>
    </message>
    <message>
        <source>has tiles that do the same in every order</source>
        <translation>има плочице које у сваком редоследу чине исто</translation>
    </message>
    <message>
        <source>has too few variants, about {0}; it needs at least {1}</source>
        <translation>има премало варијаната, око {0}; потребно је бар {1}</translation>
    </message>
    <message>
        <source>has unreadable lines ({0}), which are left out</source>
        <translation>има нечитљиве редове ({0}), који су изостављени</translation>
    </message>
    <message>
        <source>has {0} characters, with the indented lines below; the limit is {1}</source>
        <translation>има знакова {0}, рачунајући увучене редове испод; граница је {1}</translation>
    </message>
    <message>
        <source>has {0} characters; the limit is {1}</source>
        <translation>има знакова {0}; граница је {1}</translation>
    </message>
    <message>
        <source>has {0} faces, lines and points in a pane; the limit of a figure without pixels is {1}: write it as .png</source>
        <translation>у једном приказу има страна, линија и тачака {0}; граница цртежа без пиксела је {1}: упишите као .png</translation>
    </message>
    <message>
        <source>has {0} faces, lines and points in a pane; the limit of a figure without pixels is {1}: write {2}</source>
        <translation>у једном приказу има страна, линија и тачака {0}; граница цртежа без пиксела је {1}: упишите {2}</translation>
    </message>
    <message>
        <source>has {0} twice</source>
        <translation>садржи {0} двапут</translation>
    </message>
    <message>
        <source>has {0} values; the limit is {1}</source>
        <translation>има вредности {0}; граница је {1}</translation>
    </message>
    <message>
        <source>has {0} words in its step; the limit is {1}</source>
        <translation>има речи {0} у свом кораку; граница је {1}</translation>
    </message>
    <message>
        <source>has {0} × {1} cells; the answer has {2} × {3}</source>
        <translation>има {0} × {1} поља; одговор има {2} × {3}</translation>
    </message>
    <message>
        <source>has {0}, which no formula may contain (character {1})</source>
        <translation>садржи {0}, што ниједна формула не сме да садржи (знак {1})</translation>
    </message>
    <message>
        <source>has {0}, which no picture of the step can name</source>
        <translation>садржи {0}, што ниједна слика корака не може да именује</translation>
    </message>
    <message>
        <source>height = {0} times scale {3}: must be from {1} to {2} pixels.</source>
        <translation>height = {0} пута scale {3}: мора да буде од {1} до {2} пиксела.</translation>
    </message>
    <message>
        <source>height = {0} {3}: must be from {1} to {2} {3}.</source>
        <translation>height = {0} {3}: мора да буде од {1} до {2} {3}.</translation>
    </message>
    <message>
        <source>height = {0}: must be a whole number of pixels from {1} to {2}.</source>
        <translation>height = {0}: мора да буде цео број пиксела од {1} до {2}.</translation>
    </message>
    <message>
        <source>is a cloud of points of another kind ({0}): convert it to .ply; the command “project --points” reads a table of x, y, z</source>
        <translation>је облак тачака друге врсте ({0}): претворите га у .ply; наредба „project --points” чита табелу x, y, z</translation>
    </message>
    <message>
        <source>is a document, and has no view {0}</source>
        <translation>је документ и нема поглед {0}</translation>
    </message>
    <message>
        <source>is a file of {0}, which is not read: export its cameras as COLMAP text, transforms.json or OpenCV&apos;s K, R, t</source>
        <translation>је датотека програма {0}, која се не чита: извезите њене камере као COLMAP текст, transforms.json или OpenCV-ове K, R, t</translation>
    </message>
    <message>
        <source>is a folder, not a file</source>
        <translation>је фасцикла, а не датотека</translation>
    </message>
    <message>
        <source>is a lens with distortion, and here straight lines stay straight: undistort the pictures, and use the camera of the new ones</source>
        <translation>је објектив са дисторзијом, а овде праве остају праве: уклоните дисторзију са слика и употребите камеру нових слика</translation>
    </message>
    <message>
        <source>is a picture without a Frustum Lab document in it</source>
        <translation>је слика без документа програма Frustum Lab у себи</translation>
    </message>
    <message>
        <source>is a skew of the pixels, which must be 0: the window of a lens is a rectangle</source>
        <translation>је искошење пиксела, које мора бити 0: прозор објектива је правоугаоник</translation>
    </message>
    <message>
        <source>is a transposed K, with cx and cy in the last row: swap rows and columns</source>
        <translation>је транспонована K, са cx и cy у последњој врсти: замените врсте и колоне</translation>
    </message>
    <message>
        <source>is a wrong idea, but stands at the right choice</source>
        <translation>погрешна је представа, а стоји уз тачан одговор</translation>
    </message>
    <message>
        <source>is at infinity, so it is a direction and not a point</source>
        <translation>је у бесконачности, па је то смер, а не тачка</translation>
    </message>
    <message>
        <source>is binary: write text with colmap model_converter --input_path IN --output_path OUT --output_type TXT</source>
        <translation>је бинарна датотека: упишите текст помоћу colmap model_converter --input_path IN --output_path OUT --output_type TXT</translation>
    </message>
    <message>
        <source>is broken or cut short: the text from line {0}, column {1} on is not JSON</source>
        <translation>има оштећен или прекинут садржај: текст од реда {0}, колоне {1} надаље није JSON</translation>
    </message>
    <message>
        <source>is damaged, and cannot be renamed: {0}</source>
        <translation>има оштећен садржај и не може да се преименује: {0}</translation>
    </message>
    <message>
        <source>is done before the student does anything</source>
        <translation>је урађено пре него што студент ишта учини</translation>
    </message>
    <message>
        <source>is empty</source>
        <translation>нема садржаја</translation>
    </message>
    <message>
        <source>is given twice</source>
        <translation>стоји двапут</translation>
    </message>
    <message>
        <source>is in pixels of an image whose size is not known, and which is not {0} x {1}: set image.width and image.height, or add image_width and image_height to the file</source>
        <translation>је у пикселима слике чија величина није позната и није {0} x {1}: поставите image.width и image.height, или у датотеку додајте image_width и image_height</translation>
    </message>
    <message>
        <source>is indented, but belongs to nothing above it</source>
        <translation>стоји увучено, али не припада ничему изнад</translation>
    </message>
    <message>
        <source>is larger than {0}</source>
        <translation>прелази величину {0}</translation>
    </message>
    <message>
        <source>is longer than {0} characters</source>
        <translation>има знакова више од {0}</translation>
    </message>
    <message>
        <source>is missing</source>
        <translation>недостаје</translation>
    </message>
    <message>
        <source>is neither a document (.json), a lesson (.md), an exported picture (.png), a mesh ({0}) nor a camera file (.json, .yml, .xml, cameras.txt, images.txt)</source>
        <translation>није ни документ (.json), ни лекција (.md), ни извезена слика (.png), ни мрежа ({0}), ни датотека камере (.json, .yml, .xml, cameras.txt, images.txt)</translation>
    </message>
    <message>
        <source>is no perspective camera, and is not read</source>
        <translation>није перспективна камера и не чита се</translation>
    </message>
    <message>
        <source>is not UTF-8 text, some letters may be wrong: save the file in that encoding</source>
        <translation>није текст UTF-8, нека слова су можда погрешна: сачувајте датотеку у том кодирању</translation>
    </message>
    <message>
        <source>is not XML as OpenCV writes it: {0}</source>
        <translation>није XML какав пише OpenCV: {0}</translation>
    </message>
    <message>
        <source>is not a Frustum Lab document</source>
        <translation>није документ програма Frustum Lab</translation>
    </message>
    <message>
        <source>is not a Frustum Lab document: it is not text</source>
        <translation>није документ програма Frustum Lab: није текст</translation>
    </message>
    <message>
        <source>is not a complete PNG picture: it is damaged or cut short</source>
        <translation>није потпуна PNG слика: оштећена је или прекинута</translation>
    </message>
    <message>
        <source>is not a file of results of Frustum Lab</source>
        <translation>није датотека са резултатима програма Frustum Lab</translation>
    </message>
    <message>
        <source>is not a name that a file can have</source>
        <translation>није име какво датотека може да има</translation>
    </message>
    <message>
        <source>is not in the picture that is printed</source>
        <translation>није на слици која се штампа</translation>
    </message>
    <message>
        <source>is not known; the nearest name is {0}</source>
        <translation>није познато; најближе име је {0}</translation>
    </message>
    <message>
        <source>is shown as it is typed: the name of an idea stands at the end of a choice, one at each, in small letters</source>
        <translation>приказује се како је уписано: име представе стоји на крају понуђеног одговора, уз сваки по једно, малим словима</translation>
    </message>
    <message>
        <source>is step {0} of a lesson; the limit is {1}</source>
        <translation>је корак {0} лекције; граница је {1}</translation>
    </message>
    <message>
        <source>is step {0} with an exercise; the limit of a lesson is {1}</source>
        <translation>је корак {0} са задатком; граница лекције је {1}</translation>
    </message>
    <message>
        <source>is the choice of line {0} again</source>
        <translation>понавља понуђени одговор из реда {0}</translation>
    </message>
    <message>
        <source>is the letter of {0} already; two things cannot share one</source>
        <translation>већ је слово за {0}; две ствари не могу да деле исто</translation>
    </message>
    <message>
        <source>is the verdict of no sample in a “test”</source>
        <translation>није исход ниједног узорка у блоку „test”</translation>
    </message>
    <message>
        <source>is too close to {0} for a plane as far from the eye as near is</source>
        <translation>је преблизу вредности {0} за раван која је од камере далеко колико и предња</translation>
    </message>
    <message>
        <source>is too close to {0} for float64 to tell the two apart</source>
        <translation>је преблизу вредности {0} да би float64 разликовао једно од другог</translation>
    </message>
    <message>
        <source>is too long for one page</source>
        <translation>не стаје на једну страну</translation>
    </message>
    <message>
        <source>is tried by no sample “{0}: ... -&gt; right”, so a wrong value would not be noticed</source>
        <translation>не испробава ниједан узорак „{0}: ... -&gt; right”, па се погрешна вредност не би приметила</translation>
    </message>
    <message>
        <source>is wrong, but has no reply: name a wrong idea, or add “says:” below</source>
        <translation>је нетачно, али нема одзив: наведите погрешну представу, или испод додајте „says:”</translation>
    </message>
    <message>
        <source>is wrong, but holds in the right state</source>
        <translation>је нетачно, али важи у тачном стању</translation>
    </message>
    <message>
        <source>is wrong, but its formula gives the right value, {0}</source>
        <translation>је нетачно, али формула даје тачну вредност, {0}</translation>
    </message>
    <message>
        <source>lacks a line --- above it, which ends the lines like “title: ...”</source>
        <translation>нема изнад себе реда ---, који завршава редове као „title: ...”</translation>
    </message>
    <message>
        <source>lacks a line “title: ...”</source>
        <translation>нема реда „title: ...”</translation>
    </message>
    <message>
        <source>mesh = {0}: the file has only lines or points, but the scene “{1}” needs a surface; open the file as a scene of its own.</source>
        <translation>mesh = {0}: датотека има само линије или тачке, а сцени „{1}” је потребна површ; отворите датотеку као посебну сцену.</translation>
    </message>
    <message>
        <source>mesh = {1}: the scene “{0}” has a subject of its own, which no mesh can replace.</source>
        <translation>mesh = {1}: сцена „{0}” има сопствени предмет, који ниједна мрежа не може да замени.</translation>
    </message>
    <message>
        <source>must be #rrggbb, or red, green and blue, for all points or for each of {0}: whole numbers up to 255, or parts of 1</source>
        <translation>мора да буде #rrggbb, или црвено, зелено и плаво, за све тачке или за сваку од {0}: цели бројеви до 255, или делови од 1</translation>
    </message>
    <message>
        <source>must be 0 or at least {0} in size</source>
        <translation>мора да буде 0 или по величини бар {0}</translation>
    </message>
    <message>
        <source>must be 16 numbers, or a calibrated camera&apos;s K: fx 0 cx, 0 fy cy, 0 0 1</source>
        <translation>мора да буде 16 бројева, или матрица K калибрисане камере: fx 0 cx, 0 fy cy, 0 0 1</translation>
    </message>
    <message>
        <source>must be 9, 12 or 16 numbers, but has {0}</source>
        <translation>мора да буде 9, 12 или 16 бројева, а има их {0}</translation>
    </message>
    <message>
        <source>must be NAME=VALUE, or document: FILE.json</source>
        <translation>мора да буде NAME=VALUE, или document: FILE.json</translation>
    </message>
    <message>
        <source>must be [SECTION], or NAME = &quot;LETTER&quot;, or begin with # as a comment</source>
        <translation>мора да буде [SECTION], или NAME = &quot;LETTER&quot;, или да почиње са # као коментар</translation>
    </message>
    <message>
        <source>must be a Latin letter or word, or one of {0}, with an index after _ if it has one, such as x_min, and of at most {1} characters</source>
        <translation>мора да буде латиничко слово или реч, или нешто од {0}, са индексом после _ ако га има, као x_min, и највећа дужина у знаковима је {1}</translation>
    </message>
    <message>
        <source>must be a condition: two formulas with =, !=, &lt;, &gt;, &lt;= or &gt;= between them, or NAME = WORD</source>
        <translation>мора да буде услов: две формуле са =, !=, &lt;, &gt;, &lt;= или &gt;= између, или NAME = WORD</translation>
    </message>
    <message>
        <source>must be a document or a projection, such as load({0})</source>
        <translation>мора да буде документ или пројекција, као load({0})</translation>
    </message>
    <message>
        <source>must be a file beside the lesson, or in a folder there</source>
        <translation>мора да буде датотека поред лекције, или у тамошњој фасцикли</translation>
    </message>
    <message>
        <source>must be a finite number</source>
        <translation>мора да буде коначан број</translation>
    </message>
    <message>
        <source>must be a finite number or inf</source>
        <translation>мора да буде коначан број или inf</translation>
    </message>
    <message>
        <source>must be a list of 2 to {0} pictures, exactly one of them the document&apos;s own</source>
        <translation>мора да буде списак од 2 до {0} слика, од којих је тачно једна из самог документа</translation>
    </message>
    <message>
        <source>must be a list of at most {0} different names, or only *</source>
        <translation>мора да буде списак различитих имена, највише {0}, или само *</translation>
    </message>
    <message>
        <source>must be a list of at most {0} names from {1}</source>
        <translation>мора да буде списак имена, највише {0}, из {1}</translation>
    </message>
    <message>
        <source>must be a list of at most {0} names of values</source>
        <translation>мора да буде списак имена вредности, највише {0}</translation>
    </message>
    <message>
        <source>must be a list of at most {0} probes</source>
        <translation>мора да буде списак сонди, највише {0}</translation>
    </message>
    <message>
        <source>must be a list of names from {0}</source>
        <translation>мора да буде списак имена из {0}</translation>
    </message>
    <message>
        <source>must be a list of texts NAME=VALUE</source>
        <translation>мора да буде списак текстова NAME=VALUE</translation>
    </message>
    <message>
        <source>must be a list of the numbers of probes</source>
        <translation>мора да буде списак бројева сонди</translation>
    </message>
    <message>
        <source>must be a matrix of finite numbers, but has {0}</source>
        <translation>мора да буде матрица коначних бројева, а садржи {0}</translation>
    </message>
    <message>
        <source>must be a matrix of numbers, but has {0}</source>
        <translation>мора да буде матрица бројева, а садржи {0}</translation>
    </message>
    <message>
        <source>must be a name</source>
        <translation>мора да буде име</translation>
    </message>
    <message>
        <source>must be a name of letters, digits and -</source>
        <translation>мора да буде име од слова, цифара и -</translation>
    </message>
    <message>
        <source>must be a number from {0} to {1}</source>
        <translation>мора да буде број од {0} до {1}</translation>
    </message>
    <message>
        <source>must be a number like 0.5, 1/2, √3/2 or 2e-3; {0} cannot be read as part of one</source>
        <translation>мора да буде број као 0.5; 1/2; √3/2 или 2e-3; {0} не може да се чита као његов део</translation>
    </message>
    <message>
        <source>must be a number of at most {0} characters</source>
        <translation>мора да буде број; највећи број знакова је {0}</translation>
    </message>
    <message>
        <source>must be a number of points, such as 8 or 8pt</source>
        <translation>мора да буде број тачака, као 8 или 8pt</translation>
    </message>
    <message>
        <source>must be a number of the model that can be set, and the answer; it is {0} here</source>
        <translation>мора да буде број модела који може да се постави, и одговор; овде је {0}</translation>
    </message>
    <message>
        <source>must be a number whose power of ten is between -{0} and {0}</source>
        <translation>мора да буде број чији је степен броја десет између -{0} и {0}</translation>
    </message>
    <message>
        <source>must be a number without {0}</source>
        <translation>мора да буде број без {0}</translation>
    </message>
    <message>
        <source>must be a number, or inf for ∞</source>
        <translation>мора да буде број, или inf за ∞</translation>
    </message>
    <message>
        <source>must be a number, such as 0.5 or 2e-3</source>
        <translation>мора да буде број, као 0.5 или 2e-3</translation>
    </message>
    <message>
        <source>must be a number, such as {0}</source>
        <translation>мора да буде број, као {0}</translation>
    </message>
    <message>
        <source>must be a number: a function has no value there</source>
        <translation>мора да буде број: функција ту нема вредност</translation>
    </message>
    <message>
        <source>must be a number: nothing can be divided by 0</source>
        <translation>мора да буде број: ништа не може да се дели са 0</translation>
    </message>
    <message>
        <source>must be a number; nothing is typed yet</source>
        <translation>мора да буде број; још ништа није откуцано</translation>
    </message>
    <message>
        <source>must be a number; something is missing after {0}</source>
        <translation>мора да буде број; нешто недостаје после {0}</translation>
    </message>
    <message>
        <source>must be a number; {0} is neither a number nor a unit</source>
        <translation>мора да буде број; {0} није ни број ни јединица</translation>
    </message>
    <message>
        <source>must be a number; {0} may be {1} or {2}: write one of them</source>
        <translation>мора да буде број; {0} може да буде {1} или {2}: напишите једно од тога</translation>
    </message>
    <message>
        <source>must be a number; {0} mixes degrees and radians</source>
        <translation>мора да буде број; {0} меша степене и радијане</translation>
    </message>
    <message>
        <source>must be a range like 20..100 step 5, or numbers separated by commas</source>
        <translation>мора да буде опсег као 20..100 step 5, или бројеви раздвојени зарезима</translation>
    </message>
    <message>
        <source>must be a rotation: axes of length 1 at right angles, not mirrored</source>
        <translation>мора да буде ротација: осе дужине 1 под правим угловима, без рефлексије</translation>
    </message>
    <message>
        <source>must be a rotation: equally long axes at right angles, not mirrored</source>
        <translation>мора да буде ротација: једнако дугачке осе под правим угловима, без рефлексије</translation>
    </message>
    <message>
        <source>must be a row and a column, separated by “,”</source>
        <translation>мора да буде врста и колона, раздвојене знаком „,”</translation>
    </message>
    <message>
        <source>must be a sample like “NAME: SAMPLE -&gt; VERDICT”</source>
        <translation>мора да буде узорак као „NAME: SAMPLE -&gt; VERDICT”</translation>
    </message>
    <message>
        <source>must be a text</source>
        <translation>мора да буде текст</translation>
    </message>
    <message>
        <source>must be a text or a list of some of {0}</source>
        <translation>мора да буде текст или списак нечега од {0}</translation>
    </message>
    <message>
        <source>must be a type such as float64, to which numpy.asarray(points, float) converts</source>
        <translation>мора да буде тип као float64, у који претвара numpy.asarray(points, float)</translation>
    </message>
    <message>
        <source>must be a value of settings, camera, lens, image, object or depth, as NAME=VALUE</source>
        <translation>мора да буде вредност за settings, camera, lens, image, object или depth, као NAME=VALUE</translation>
    </message>
    <message>
        <source>must be a whole number</source>
        <translation>мора да буде цео број</translation>
    </message>
    <message>
        <source>must be a whole number from {0} to {1}</source>
        <translation>мора да буде цео број од {0} до {1}</translation>
    </message>
    <message>
        <source>must be a whole number of pixels from 1 to {0}</source>
        <translation>мора да буде цео број пиксела од 1 до {0}</translation>
    </message>
    <message>
        <source>must be a whole number, 1 or more</source>
        <translation>мора да буде цео број, 1 или више</translation>
    </message>
    <message>
        <source>must be a whole number: the question asks for a count</source>
        <translation>мора да буде цео број: питање тражи да се преброји</translation>
    </message>
    <message>
        <source>must be an answer with its lesson, exercise and time</source>
        <translation>мора да буде одговор са својом лекцијом, задатком и временом</translation>
    </message>
    <message>
        <source>must be an object with named values in braces</source>
        <translation>мора да буде објекат са именованим вредностима у витичастим заградама</translation>
    </message>
    <message>
        <source>must be at least {0}</source>
        <translation>мора да буде бар {0}</translation>
    </message>
    <message>
        <source>must be at least {0} away from the target</source>
        <translation>мора да буде од циља удаљено бар {0}</translation>
    </message>
    <message>
        <source>must be at least {0} long</source>
        <translation>мора да буде дугачко бар {0}</translation>
    </message>
    <message>
        <source>must be at most {0}</source>
        <translation>мора да буде највише {0}</translation>
    </message>
    <message>
        <source>must be axes of matplotlib, such as pyplot.gca()</source>
        <translation>мора да буде axes из matplotlib-а, као pyplot.gca()</translation>
    </message>
    <message>
        <source>must be followed by # and the number, up to {0}, or the name of a view: {1}</source>
        <translation>после њега мора да стоји # и број, највише {0}, или име погледа: {1}</translation>
    </message>
    <message>
        <source>must be four rows of four finite numbers</source>
        <translation>мора да буде четири врсте од по четири коначна броја</translation>
    </message>
    <message>
        <source>must be from {0} to {1} points</source>
        <translation>мора да буде од {0} до {1} тачака</translation>
    </message>
    <message>
        <source>must be fx, fy, cx, cy, or K: three rows fx, 0, cx and 0, fy, cy and 0, 0, 1</source>
        <translation>мора да буде fx, fy, cx, cy, или K: три врсте fx, 0, cx и 0, fy, cy и 0, 0, 1</translation>
    </message>
    <message>
        <source>must be greater than 0; below 0 the image&apos;s x points left: take fx = {0} and cx = W - 1 - cx</source>
        <translation>мора да буде веће од 0; испод 0 је x слике окренуто улево: узмите fx = {0} и cx = W - 1 - cx</translation>
    </message>
    <message>
        <source>must be greater than 0; below 0 the image&apos;s y points up: take fy = {0} and cy = H - 1 - cy</source>
        <translation>мора да буде веће од 0; испод 0 је y слике окренуто нагоре: узмите fy = {0} и cy = H - 1 - cy</translation>
    </message>
    <message>
        <source>must be greater than bottom, which is {0}</source>
        <translation>мора да буде веће од доње границе, која је {0}</translation>
    </message>
    <message>
        <source>must be greater than left, which is {0}</source>
        <translation>мора да буде веће од леве границе, која је {0}</translation>
    </message>
    <message>
        <source>must be greater than near, which is {0}</source>
        <translation>мора да буде веће од предње равни, која је {0}</translation>
    </message>
    <message>
        <source>must be greater than {0}</source>
        <translation>мора да буде веће од {0}</translation>
    </message>
    <message>
        <source>must be in pixels, but the four numbers are in widths and heights of the image: multiply fx and cx by {0}, fy and cy by {1}, then subtract 0.5 from cx and cy</source>
        <translation>мора да буде у пикселима, а четири броја су у ширинама и висинама слике: помножите fx и cx са {0}, fy и cy са {1}, па одузмите 0.5 од cx и cy</translation>
    </message>
    <message>
        <source>must be in {0}</source>
        <translation>мора да буде у {0}</translation>
    </message>
    <message>
        <source>must be increasing numbers from 0 to 1, one fewer than the compared pictures, or none for side by side</source>
        <translation>мора да буде растући низ бројева од 0 до 1, за један мањи од броја слика које се пореде, или ниједан за једну поред друге</translation>
    </message>
    <message>
        <source>must be left out where there is no cloud</source>
        <translation>мора да изостане када нема облака (cloud)</translation>
    </message>
    <message>
        <source>must be left out where width is given, which crops the figure</source>
        <translation>мора да изостане када је задат width, који опсеца цртеж</translation>
    </message>
    <message>
        <source>must be less than far, which is {0}</source>
        <translation>мора да буде мање од задње равни, која је {0}</translation>
    </message>
    <message>
        <source>must be less than right, which is {0}</source>
        <translation>мора да буде мање од десне границе, која је {0}</translation>
    </message>
    <message>
        <source>must be less than top, which is {0}</source>
        <translation>мора да буде мање од горње границе, која је {0}</translation>
    </message>
    <message>
        <source>must be of the type {0}</source>
        <translation>мора да буде типа {0}</translation>
    </message>
    <message>
        <source>must be one line of at most {0} characters</source>
        <translation>мора да буде један ред; највећи број знакова је {0}</translation>
    </message>
    <message>
        <source>must be one line of text</source>
        <translation>мора да буде један ред текста</translation>
    </message>
    <message>
        <source>must be one of the scene&apos;s own comparisons ({0}), or PATH=VALUE, with ; between the values of a picture, | between pictures, and NAME: before a picture that has a name</source>
        <translation>мора да буде једно од сопствених поређења сцене ({0}), или PATH=VALUE, са ; између вредности једне слике, | између слика, и NAME: испред слике која има име</translation>
    </message>
    <message>
        <source>must be one of {0}</source>
        <translation>мора да буде једно од {0}</translation>
    </message>
    <message>
        <source>must be one of {0}, a colon, and its value</source>
        <translation>мора да буде једно од {0}, двотачка, и вредност</translation>
    </message>
    <message>
        <source>must be one of {0}, or a file of letters beside the lesson, such as letters.toml</source>
        <translation>мора да буде једно од {0}, или датотека са словима поред лекције, као letters.toml</translation>
    </message>
    <message>
        <source>must be one of {0}, or a file of letters of at most {1} characters</source>
        <translation>мора да буде једно од {0}, или датотека са словима; највећи број знакова је {1}</translation>
    </message>
    <message>
        <source>must be one of {0}, or a number from {1} to {2}</source>
        <translation>мора да буде једно од {0}, или број од {1} до {2}</translation>
    </message>
    <message>
        <source>must be one of {0}, or empty for none</source>
        <translation>мора да буде једно од {0}, или празно за ниједно</translation>
    </message>
    <message>
        <source>must be one of {0}; the nearest is {1}</source>
        <translation>мора да буде једно од {0}; најближе је {1}</translation>
    </message>
    <message>
        <source>must be the document&apos;s own, {0}</source>
        <translation>мора да буде оно из самог документа, {0}</translation>
    </message>
    <message>
        <source>must be the name of a file</source>
        <translation>мора да буде име датотеке</translation>
    </message>
    <message>
        <source>must be the name of a scene or of a mesh file</source>
        <translation>мора да буде име сцене или датотеке мреже</translation>
    </message>
    <message>
        <source>must be the number of a choice, from 1 to {0}</source>
        <translation>мора да буде број понуђеног одговора, од 1 до {0}</translation>
    </message>
    <message>
        <source>must be the numbers x, y, z of each point in turn</source>
        <translation>мора да буде x, y, z сваке тачке редом</translation>
    </message>
    <message>
        <source>must be the path of a mesh file ({0}), or empty for none</source>
        <translation>мора да буде путања датотеке мреже ({0}), или празно за ниједну</translation>
    </message>
    <message>
        <source>must be the text of one matrix, up to {0} characters long</source>
        <translation>мора да буде текст једне матрице; највећи број знакова је {0}</translation>
    </message>
    <message>
        <source>must be three finite numbers x, y, z</source>
        <translation>мора да буде три коначна броја x, y, z</translation>
    </message>
    <message>
        <source>must be three numbers for a point, four with w, two for the ray of a pixel, or null for no probe</source>
        <translation>мора да буде три броја за тачку, четири са w, два за зрак пиксела, или null за ниједну сонду</translation>
    </message>
    <message>
        <source>must be three rows of four finite numbers</source>
        <translation>мора да буде три врсте од по четири коначна броја</translation>
    </message>
    <message>
        <source>must be three rows of three finite numbers</source>
        <translation>мора да буде три врсте од по три коначна броја</translation>
    </message>
    <message>
        <source>must be tiles such as translate 3,0,0 or rotate z 90</source>
        <translation>мора да буде низ плочица као translate 3,0,0 или rotate z 90</translation>
    </message>
    <message>
        <source>must be topics from L1 to L27, separated by commas</source>
        <translation>мора да буде списак тема од L1 до L27, раздвојених зарезима</translation>
    </message>
    <message>
        <source>must be true or false</source>
        <translation>мора да буде true или false</translation>
    </message>
    <message>
        <source>must be two numbers of pixels, width and height</source>
        <translation>мора да буде два броја пиксела, ширина и висина</translation>
    </message>
    <message>
        <source>must be world or ndc with the pane&apos;s eye, or its eye and its target, as in world: 6,4,8 or ndc: 1.3,0.2,0.3,0,0,0; a | separates the two panes (what a class sees is view.slide)</source>
        <translation>мора да буде world или ndc са позицијом камере приказа, или са њом и циљем, као у world: 6,4,8 или ndc: 1.3,0.2,0.3,0,0,0; знак | раздваја два приказа (оно што виде слушаоци је view.slide)</translation>
    </message>
    <message>
        <source>must be written as NAME=VALUE</source>
        <translation>мора да се пише као NAME=VALUE</translation>
    </message>
    <message>
        <source>must be {0} coordinates, separated by spaces</source>
        <translation>мора да буде {0} координата, раздвојених размацима</translation>
    </message>
    <message>
        <source>must be {0} finite numbers</source>
        <translation>мора да буде {0} коначних бројева</translation>
    </message>
    <message>
        <source>must be {0} numbers, but has {1}</source>
        <translation>мора да буде {0} бројева, а има их {1}</translation>
    </message>
    <message>
        <source>must begin a step with its title, like “# Title”</source>
        <translation>мора да почиње корак својим насловом, као „# Title”</translation>
    </message>
    <message>
        <source>must begin the lesson: ---, then lines like “title: ...”, then --- again</source>
        <translation>мора да почиње лекцију: ---, затим редови као „title: ...”, па опет ---</translation>
    </message>
    <message>
        <source>must begin with a seed, a whole number from 1 to {0}</source>
        <translation>мора да почиње семеном, целим бројем од 1 до {0}</translation>
    </message>
    <message>
        <source>must begin with “- [x]” if it is right, else “- [ ]”</source>
        <translation>мора да почиње са „- [x]” ако је тачно, иначе са „- [ ]”</translation>
    </message>
    <message>
        <source>must differ from the eye, or the camera looks nowhere</source>
        <translation>мора да се разликује од позиције камере, иначе камера не гледа никуда</translation>
    </message>
    <message>
        <source>must differ from the target, or the camera looks nowhere</source>
        <translation>мора да се разликује од циља, иначе камера не гледа никуда</translation>
    </message>
    <message>
        <source>must end in {0}, the numbers of a point</source>
        <translation>мора да се завршава са {0}, бројевима једне тачке</translation>
    </message>
    <message>
        <source>must have 0, 0, 0, 1 in its last row: no move of an object changes w</source>
        <translation>мора да има 0, 0, 0, 1 у последњој врсти: ниједан покрет објекта не мења w</translation>
    </message>
    <message>
        <source>must have 1 to {0} rows, separated by “;”, each with the same number of cells, 1 to {0}, separated by “,”; and at least two cells</source>
        <translation>мора да има од 1 до {0} врста, раздвојених знаком „;”, свака са једнаким бројем поља, од 1 до {0}, раздвојених знаком „,”; и бар два поља</translation>
    </message>
    <message>
        <source>must have a left 3 x 3 block with an inverse: the camera is at infinity, as a parallel one is</source>
        <translation>мора да има леви блок 3 x 3 са инверзом: камера је у бесконачности, као код паралелне пројекције</translation>
    </message>
    <message>
        <source>must have a product with numbers up to {0} only</source>
        <translation>мора да има производ само са бројевима до {0}</translation>
    </message>
    <message>
        <source>must have a result whose formulas have at most {0} characters, or end in {1}</source>
        <translation>мора да има резултат чије формуле имају знакова највише {0}, или да се завршава на {1}</translation>
    </message>
    <message>
        <source>must have an inverse whose numbers and products float64 can hold</source>
        <translation>мора да има инверз чије бројеве и производе float64 може да прими</translation>
    </message>
    <message>
        <source>must have an inverse, but its rank is {0}</source>
        <translation>мора да има инверз, али му је ранг {0}</translation>
    </message>
    <message>
        <source>must have at most {0} tiles, but has {1}</source>
        <translation>може да има плочица највише {0}, а има их {1}</translation>
    </message>
    <message>
        <source>must have equally many numbers in every row</source>
        <translation>мора да има једнако много бројева у свакој врсти</translation>
    </message>
    <message>
        <source>must have finite numbers after {1}, {0} in all</source>
        <translation>мора да има коначне бројеве после {1}, укупно {0}</translation>
    </message>
    <message>
        <source>must have finite real numbers only</source>
        <translation>мора да има само коначне реалне бројеве</translation>
    </message>
    <message>
        <source>must have no masked number</source>
        <translation>не сме да има маскиране бројеве</translation>
    </message>
    <message>
        <source>must have no number after {0}</source>
        <translation>не сме да има број после {0}</translation>
    </message>
    <message>
        <source>must have numbers up to {0} in size only</source>
        <translation>мора да има само бројеве по величини до {0}</translation>
    </message>
    <message>
        <source>must have the product that the state shows, which is another {0}</source>
        <translation>мора да има производ који показује стање, а то је друга матрица {0}</translation>
    </message>
    <message>
        <source>must be 0, 0, 0, 1, the last row of a pose: perhaps rows and columns are exchanged</source>
        <translation>мора да буде 0, 0, 0, 1, последња врста положаја: можда су врсте и колоне замењене</translation>
    </message>
    <message>
        <source>must have three numbers for each rotation, which has three or nine</source>
        <translation>мора да има три броја за сваку ротацију, која има три или девет</translation>
    </message>
    <message>
        <source>must have {0} coordinates, separated by “,”</source>
        <translation>мора да има {0} координата, раздвојених знаком „,”</translation>
    </message>
    <message>
        <source>must have {0} significant digits in front of “...”</source>
        <translation>мора да има {0} значајних цифара испред „...”</translation>
    </message>
    <message>
        <source>must have {0} × {1} cells: “;” separates rows, “|” the cells of a row</source>
        <translation>мора да има {0} × {1} поља: „;” раздваја врсте, „|” поља једне врсте</translation>
    </message>
    <message>
        <source>must lie above the plane y = {0}: a light on the plane or under it casts no shadow there</source>
        <translation>мора да лежи изнад равни y = {0}: светло на равни или испод ње на њој не баца сенку</translation>
    </message>
    <message>
        <source>must lie between {0} and {1}, both excluded</source>
        <translation>мора да лежи између {0} и {1}, без њих самих</translation>
    </message>
    <message>
        <source>must name 1 to {0} matrices, such as {1}</source>
        <translation>мора да именује од 1 до {0} матрица, као {1}</translation>
    </message>
    <message>
        <source>must name matrices such as {0}; this lens has no matrix {1}</source>
        <translation>мора да именује матрице као {0}; овај објектив нема матрицу {1}</translation>
    </message>
    <message>
        <source>must name matrices that one lecture has together</source>
        <translation>мора да именује матрице које једно предавање има заједно</translation>
    </message>
    <message>
        <source>must not be 0 if x, y and z are 0: (0, 0, 0, 0) is neither a point nor a direction</source>
        <translation>не сме да буде 0 ако су x, y и z једнаки 0: (0, 0, 0, 0) није ни тачка ни смер</translation>
    </message>
    <message>
        <source>must not be 0: the plane would go through the eye, where nothing is cut</source>
        <translation>не сме да буде 0: раван би пролазила кроз позицију камере, где се ништа не сече</translation>
    </message>
    <message>
        <source>must not be before the near plane ({0})</source>
        <translation>не сме да буде испред предње равни ({0})</translation>
    </message>
    <message>
        <source>must not be parallel to the view direction</source>
        <translation>не сме да буде паралелно смеру погледа</translation>
    </message>
    <message>
        <source>must not be the zero vector</source>
        <translation>не сме да буде нула-вектор</translation>
    </message>
    <message>
        <source>must point upward, to the sun: otherwise its rays never meet the plane</source>
        <translation>мора да буде усмерено нагоре, ка сунцу: иначе његови зраци никада не секу раван</translation>
    </message>
    <message>
        <source>names an unknown wrong idea (the nearest is {0}), and has no “says:” of its own</source>
        <translation>именује непознату погрешну представу (најближа је {0}) и нема сопствено „says:”</translation>
    </message>
    <message>
        <source>needs 2 to {0} choices, just one of them right: “- [x]”, the others “- [ ]”</source>
        <translation>тражи 2 до {0} понуђених одговора, од којих је тачан само један: „- [x]”, остали „- [ ]”</translation>
    </message>
    <message>
        <source>needs a closing bracket instead of {0} (character {1})</source>
        <translation>тражи затворену заграду уместо {0} (знак {1})</translation>
    </message>
    <message>
        <source>needs a number, a letter or a bracket instead of {0} (character {1})</source>
        <translation>тражи број, слово или заграду уместо {0} (знак {1})</translation>
    </message>
    <message>
        <source>needs a sign such as + or * in front of {0} (character {1})</source>
        <translation>тражи знак као + или * испред {0} (знак {1})</translation>
    </message>
    <message>
        <source>needs a whole number as its power instead of {0} (character {1})</source>
        <translation>тражи цео број као изложилац уместо {0} (знак {1})</translation>
    </message>
    <message>
        <source>needs lens.sensor_width_mm or lens.sensor_height_mm; the one that compares with 36 x 24 mm is lens.focal_length_mm</source>
        <translation>тражи lens.sensor_width_mm или lens.sensor_height_mm; онај који пореди са 36 x 24 mm је lens.focal_length_mm</translation>
    </message>
    <message>
        <source>needs the program {0}, which is not on the PATH: write .webp instead</source>
        <translation>тражи програм {0}, кога нема у променљивој PATH: упишите уместо тога .webp</translation>
    </message>
    <message>
        <source>needs {0}</source>
        <translation>тражи {0}</translation>
    </message>
    <message>
        <source>needs {0} among its tiles</source>
        <translation>тражи {0} међу својим плочицама</translation>
    </message>
    <message>
        <source>pane = {0}: must be one of {1}.</source>
        <translation>pane = {0}: мора да буде једно од {1}.</translation>
    </message>
    <message>
        <source>panes = {0}: must name at least one of {1}.</source>
        <translation>panes = {0}: мора да именује бар једно од {1}.</translation>
    </message>
    <message>
        <source>plotter() needs the package pyvista: pip install pyvista.</source>
        <translation>plotter() тражи пакет pyvista: pip install pyvista.</translation>
    </message>
    <message>
        <source>points: at most {0} can be marked, and {1} were given.</source>
        <translation>points: може да се обележи највише {0}, а дато их је {1}.</translation>
    </message>
    <message>
        <source>repeats the name of line {0}; each needs its own</source>
        <translation>понавља име из реда {0}; свако мора да има своје</translation>
    </message>
    <message>
        <source>says another number than its formula&apos;s value, {0}</source>
        <translation>каже други број, а не вредност своје формуле, {0}</translation>
    </message>
    <message>
        <source>scale = {0}: must be greater than 0 and at most {1}.</source>
        <translation>scale = {0}: мора да буде веће од 0 и највише {1}.</translation>
    </message>
    <message>
        <source>size = {0}: must be WIDTHxHEIGHT in {1}, such as 120mmx80mm, or two numbers of pixels.</source>
        <translation>size = {0}: мора да буде WIDTHxHEIGHT у {1}, као 120mmx80mm, или два броја пиксела.</translation>
    </message>
    <message>
        <source>sweep = {0}: must be NAME=FIRST:LAST with finite numbers, such as lens.near=0.5:8 or camera.eye=3,2,4:0,2,5.</source>
        <translation>sweep = {0}: мора да буде NAME=FIRST:LAST са коначним бројевима, као lens.near=0.5:8 или camera.eye=3,2,4:0,2,5.</translation>
    </message>
    <message>
        <source>sweep = {0}: {1} is swept already.</source>
        <translation>sweep = {0}: {1} се већ мења.</translation>
    </message>
    <message>
        <source>text size = {0}: must be from {1} to {2} points in panes of this size.</source>
        <translation>величина текста = {0}: мора да буде од {1} до {2} тачака у приказима ове величине.</translation>
    </message>
    <message>
        <source>uses an unknown function or matrix, {0}; the nearest is {1}</source>
        <translation>користи непознату функцију или матрицу, {0}; најближа је {1}</translation>
    </message>
    <message>
        <source>uses an unknown name, {0}; the nearest is {1}</source>
        <translation>користи непознато име, {0}; најближе је {1}</translation>
    </message>
    <message>
        <source>varies more than {0} numbers</source>
        <translation>мења више бројева од {0}</translation>
    </message>
    <message>
        <source>varies {0} twice</source>
        <translation>мења {0} двапут</translation>
    </message>
    <message>
        <source>was damaged, and is kept as {0}</source>
        <translation>има оштећен садржај, и чува се као {0}</translation>
    </message>
    <message>
        <source>was written by a newer Frustum Lab: its version is {0}, the limit is {1}</source>
        <translation>је из новијег програма Frustum Lab: верзија је {0}, граница је {1}</translation>
    </message>
    <message>
        <source>was written by a newer Frustum Lab: its version is {0}, this program reads up to {1}</source>
        <translation>је из новијег програма Frustum Lab: верзија је {0}, овај програм чита до {1}</translation>
    </message>
    <message>
        <source>was written for a newer Frustum Lab, which reads version {0}; this one reads up to {1}</source>
        <translation>је за новији програм Frustum Lab, који чита верзију {0}; овај чита до {1}</translation>
    </message>
    <message>
        <source>width = {0} mm: a line of this equation needs {1} mm in letters of {2} points.</source>
        <translation>width = {0} mm: једном реду ове једначине треба {1} mm са словима од {2} тачака.</translation>
    </message>
    <message>
        <source>width = {0} times scale {3}: must be from {1} to {2} pixels.</source>
        <translation>width = {0} пута scale {3}: мора да буде од {1} до {2} пиксела.</translation>
    </message>
    <message>
        <source>width = {0} {3}: must be from {1} to {2} {3}.</source>
        <translation>width = {0} {3}: мора да буде од {1} до {2} {3}.</translation>
    </message>
    <message>
        <source>width = {0}: must be a length in {1}, such as 84mm, or a number of pixels.</source>
        <translation>width = {0}: мора да буде дужина у {1}, као 84mm, или број пиксела.</translation>
    </message>
    <message>
        <source>width = {0}: must be a whole number of pixels from {1} to {2}.</source>
        <translation>width = {0}: мора да буде цео број пиксела од {1} до {2}.</translation>
    </message>
    <message>
        <source>{0} of {1} numbers are right; the others are marked.</source>
        <translation>Тачних бројева: {0} од {1}; остали су обележени.</translation>
    </message>
    <message>
        <source>{0}, with {1}; “where: CONDITION” excludes numbers</source>
        <translation>{0}, са {1}; „where: CONDITION” искључује бројеве</translation>
    </message>
    <message>
        <source>{0}: TeX reads a picture beside it, whose name may have only letters from a to z, digits and . _ + = -.</source>
        <translation>{0}: TeX чита слику поред ње, чије име може да има само слова од a до z, цифре и . _ + = -.</translation>
    </message>
    <message>
        <source>{0}: a face, line or point names a vertex that does not exist (there are {1}); export or download the file again.</source>
        <translation>{0}: страна, линија или тачка наводи теме које не постоји (има их {1}); поново извезите или преузмите датотеку.</translation>
    </message>
    <message>
        <source>{0}: a mesh file must end in {1} or {2}; convert it to one of these.</source>
        <translation>{0}: датотека мреже мора да се завршава на {1} или {2}; претворите је у једну од ових.</translation>
    </message>
    <message>
        <source>{0}: a vertex has the coordinate {1}, but it must be within ±{2}, 1e12 times the mesh&apos;s size; move the mesh to the origin.</source>
        <translation>{0}: теме има координату {1}, али она мора да буде унутар ±{2}, 1e12 пута величина мреже; померите мрежу у координатни почетак.</translation>
    </message>
    <message>
        <source>{0}: all vertices are at one point, so there is nothing to see; check the export.</source>
        <translation>{0}: сва темена су у једној тачки, па нема шта да се види; проверите извоз.</translation>
    </message>
    <message>
        <source>{0}: all vertices are on one line, so there is nothing to see; check the export.</source>
        <translation>{0}: сва темена су на једној правој, па нема шта да се види; проверите извоз.</translation>
    </message>
    <message>
        <source>{0}: cannot be opened ({1}); check its name and its permissions.</source>
        <translation>{0}: не може да се отвори ({1}); проверите име и дозволе.</translation>
    </message>
    <message>
        <source>{0}: faces left out: {1} of {2}, because they have fewer than three different corners; the first is number {3}.</source>
        <translation>{0}: изостављене стране: {1} од {2}, јер имају мање од три различита темена; прва је број {3}.</translation>
    </message>
    <message>
        <source>{0}: faces left out: {1} of {2}, because they have fewer than three different corners; the first is on line {3}.</source>
        <translation>{0}: изостављене стране: {1} од {2}, јер имају мање од три различита темена; прва је у реду {3}.</translation>
    </message>
    <message>
        <source>{0}: from line {1} on, it has more rows than its header counts; correct the header, or export the file again.</source>
        <translation>{0}: од реда {1} надаље има више редова него што заглавље броји; исправите заглавље, или поново извезите датотеку.</translation>
    </message>
    <message>
        <source>{0}: is a link, where a picture of the figure would be.</source>
        <translation>{0}: на том месту је веза, а ту би дошла слика цртежа.</translation>
    </message>
    <message>
        <source>{0}: is damaged: {1}.</source>
        <translation>{0}: датотека је оштећена: {1}.</translation>
    </message>
    <message>
        <source>{0}: is not a file of measurements.</source>
        <translation>{0}: није датотека мерења.</translation>
    </message>
    <message>
        <source>{0}: it cannot be read ({1}); export or download the file again.</source>
        <translation>{0}: не може да се прочита ({1}); поново извезите или преузмите датотеку.</translation>
    </message>
    <message>
        <source>{0}: it uses “{1}”, which this program does not read; export it without that.</source>
        <translation>{0}: користи „{1}”, што овај програм не чита; извезите без тога.</translation>
    </message>
    <message>
        <source>{0}: it would grow to {1} triangles, lines and points and {2} MiB, but may have at most {3} and {4} MiB; make it smaller.</source>
        <translation>{0}: нарасло би на {1} троуглова, линија и тачака и {2} MiB, а може највише {3} и {4} MiB; смањите.</translation>
    </message>
    <message>
        <source>{0}: its faces are not divided into triangles within {1} s; give them fewer corners, or divide them before the export.</source>
        <translation>{0}: стране нису подељене на троуглове за {1} s; дајте им мање темена, или их поделите пре извоза.</translation>
    </message>
    <message>
        <source>{0}: its part {1} is not a readable file in the folder of the mesh; keep the files of a glTF mesh together.</source>
        <translation>{0}: део {1} није читљива датотека у фасцикли мреже; држите датотеке glTF мреже заједно.</translation>
    </message>
    <message>
        <source>{0}: line {1} cannot be read as {2}; export or download the file again.</source>
        <translation>{0}: ред {1} не може да се чита као {2}; поново извезите или преузмите датотеку.</translation>
    </message>
    <message>
        <source>{0}: line {1} has a vertex that is not finite (nan or inf), and line {2} uses it; repair the mesh and export it again.</source>
        <translation>{0}: ред {1} има теме које није коначно (nan или inf), а ред {2} га користи; поправите мрежу и извезите је поново.</translation>
    </message>
    <message>
        <source>{0}: line {1} names a vertex that does not exist (there are {2}); export or download the file again.</source>
        <translation>{0}: ред {1} наводи теме које не постоји (има их {2}); поново извезите или преузмите датотеку.</translation>
    </message>
    <message>
        <source>{0}: must end in .svg, .pdf, .tex or .png.</source>
        <translation>{0}: мора да се завршава на .svg, .pdf, .tex или .png.</translation>
    </message>
    <message>
        <source>{0}: must end in one of {1}.</source>
        <translation>{0}: мора да се завршава једним од {1}.</translation>
    </message>
    <message>
        <source>{0}: some vertices are not finite (nan or inf: {1} of {2}); repair the mesh and export it again.</source>
        <translation>{0}: нека темена нису коначна (nan или inf: {1} од {2}); поправите мрежу и извезите је поново.</translation>
    </message>
    <message>
        <source>{0}: the content of the file is not {1}; check what kind of file it is.</source>
        <translation>{0}: садржај датотеке није {1}; проверите које је врсте датотека.</translation>
    </message>
    <message>
        <source>{0}: the file has no faces (vertices: {1}), so there is no surface to draw; export the mesh with faces.</source>
        <translation>{0}: датотека нема страна (број темена: {1}), па нема површи за цртање; извезите мрежу са странама.</translation>
    </message>
    <message>
        <source>{0}: the file is cut off: it has {1} of {2} rows of “{3}”; export or download the file again.</source>
        <translation>{0}: датотека је прекинута: има {1} од {2} редова „{3}”; поново извезите или преузмите датотеку.</translation>
    </message>
    <message>
        <source>{0}: the file is cut off: it has {1} of {2} triangles; export or download the file again.</source>
        <translation>{0}: датотека је прекинута: има {1} од {2} троуглова; поново извезите или преузмите датотеку.</translation>
    </message>
    <message>
        <source>{0}: the file is cut off; export or download the file again.</source>
        <translation>{0}: датотека је прекинута; поново извезите или преузмите датотеку.</translation>
    </message>
    <message>
        <source>{0}: the file is empty; save or download it again.</source>
        <translation>{0}: датотека је празна; поново је сачувајте или преузмите.</translation>
    </message>
    <message>
        <source>{0}: the number of a face&apos;s corners is {1}, but must be from 3 to {2}; divide or repair it.</source>
        <translation>{0}: број темена једне стране је {1}, а мора да буде од 3 до {2}; поделите је или поправите.</translation>
    </message>
    <message>
        <source>{0}: the process that reads it ended too early; make it smaller, or export or download the file again.</source>
        <translation>{0}: процес који чита завршио се прерано; смањите датотеку, или је поново извезите или преузмите.</translation>
    </message>
    <message>
        <source>{0}: the size of the mesh is {1} units, but must be between 1e-30 and 1e30; scale it.</source>
        <translation>{0}: величина мреже је {1} јединица, а мора да буде између 1e-30 и 1e30; скалирајте је.</translation>
    </message>
    <message>
        <source>{0}: the window could not be shown whole.</source>
        <translation>{0}: прозор није могао да се прикаже цео.</translation>
    </message>
    <message>
        <source>{0}: the window did not appear on the screen.</source>
        <translation>{0}: прозор се није појавио на екрану.</translation>
    </message>
    <message>
        <source>{0}: there is no such file; check its name and folder.</source>
        <translation>{0}: нема такве датотеке; проверите име и фасциклу.</translation>
    </message>
    <message>
        <source>{0}: its description has {1} lists and objects, but may have at most {2}; make it smaller.</source>
        <translation>{0}: опис има {1} спискова и објеката, а сме да их има највише {2}; смањите датотеку.</translation>
    </message>
    <message>
        <source>{0}: there is not enough memory to read it; make it smaller, or close other programs.</source>
        <translation>{0}: нема довољно меморије за читање; смањите датотеку, или затворите друге програме.</translation>
    </message>
    <message>
        <source>{0}: vertices left out: {1} of {2}, because they are not finite (nan or inf) and no face or line uses them; the first is number {3}.</source>
        <translation>{0}: изостављена темена: {1} од {2}, јер нису коначна (nan или inf) и не користи их ниједна страна ни линија; прво је број {3}.</translation>
    </message>
    <message>
        <source>{0}: vertices left out: {1} of {2}, because they are not finite (nan or inf) and no face or line uses them; the first is on line {3}.</source>
        <translation>{0}: изостављена темена: {1} од {2}, јер нису коначна (nan или inf) и не користи их ниједна страна ни линија; прво је у реду {3}.</translation>
    </message>
    <message>
        <source>{0}: was measured by another Frustum Lab: its version is {1}, this one reads {2}.</source>
        <translation>{0}: измерио је други програм Frustum Lab: верзија је {1}, овај чита {2}.</translation>
    </message>
    <message>
        <source>{0}: would have {1} MB; TeX&apos;s memory holds figures of {2} MB: write {3}.</source>
        <translation>{0}: имало би {1} MB; меморија TeX-а прима цртеже од {2} MB: упишите {3}.</translation>
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
        <translation>Двапут кликните на име да вратите почетну вредност.</translation>
    </message>
    <message>
        <source>Reset {0}</source>
        <translation>Врати на почетно: {0}</translation>
    </message>
    <message>
        <source>Not possible.</source>
        <translation>Није могуће.</translation>
    </message>
</context>
<context>
    <name>Saving</name>
    <message>
        <source>{0} already exists.</source>
        <translation>{0} већ постоји.</translation>
    </message>
    <message>
        <source>Overwrite it?</source>
        <translation>Преписати је?</translation>
    </message>
</context>
<context>
    <name>SceneCard</name>
    <message>
        <source>My mesh…</source>
        <translation>Моја мрежа…</translation>
    </message>
    <message>
        <source>Replace the scene&apos;s own objects with a mesh from a file</source>
        <translation>Замени сопствене објекте сцене мрежом из датотеке</translation>
    </message>
    <message>
        <source>My mesh</source>
        <translation>Моја мрежа</translation>
    </message>
    <message>
        <source>Own objects</source>
        <translation>Сопствени објекти</translation>
    </message>
    <message>
        <source>Restore the scene&apos;s own objects</source>
        <translation>Врати сопствене објекте сцене</translation>
    </message>
    <message>
        <source>Explanation…</source>
        <translation>Објашњење…</translation>
    </message>
    <message>
        <source>Show what the scene is about, its lectures and its diagrams, below the panes</source>
        <translation>Прикажи испод приказа о чему је сцена, њена предавања и дијаграме</translation>
    </message>
    <message>
        <source>Explanation and diagrams</source>
        <translation>Објашњење и дијаграми</translation>
    </message>
    <message>
        <source>none of these</source>
        <translation>ништа од овога</translation>
    </message>
    <message>
        <source>Compare: {0}</source>
        <translation>Упореди: {0}</translation>
    </message>
    <message>
        <source>Show these pictures side by side, enlarged</source>
        <translation>Прикажи ове слике једну поред друге, увећане</translation>
    </message>
    <message>
        <source>Diagrams…</source>
        <translation>Дијаграми…</translation>
    </message>
    <message>
        <source>The lens does not have this value: choose one of the above first.</source>
        <translation>Објектив нема ову вредност: прво изаберите неки од горњих.</translation>
    </message>
    <message>
        <source>Only with “{0}” switched on.</source>
        <translation>Само када је укључено „{0}”.</translation>
    </message>
    <message>
        <source>Only with “{0}”: {1}.</source>
        <translation>Само уз „{0}”: {1}.</translation>
    </message>
</context>
<context>
    <name>ScenePanel</name>
    <message>
        <source>Diagrams</source>
        <translation>Дијаграми</translation>
    </message>
    <message>
        <source>What this scene shows</source>
        <translation>Шта показује ова сцена</translation>
    </message>
    <message>
        <source>Lectures: {0}</source>
        <translation>Предавања: {0}</translation>
    </message>
</context>
<context>
    <name>SearchBox</name>
    <message>
        <source>Find a control</source>
        <translation>Нађи контролу</translation>
    </message>
    <message>
        <source>Shows the controls with this name, also folded ones; Enter goes to the first, Esc shows all again (Ctrl+F)</source>
        <translation>Приказује контроле са овим именом, и склопљене; Enter иде на прву, Esc поново приказује све (Ctrl+F)</translation>
    </message>
</context>
<context>
    <name>Section</name>
    <message>
        <source>Fold</source>
        <translation>Склопи</translation>
    </message>
    <message>
        <source>Unfold</source>
        <translation>Расклопи</translation>
    </message>
    <message>
        <source>unfolded</source>
        <translation>расклопљено</translation>
    </message>
    <message>
        <source>folded</source>
        <translation>склопљено</translation>
    </message>
</context>
<context>
    <name>SelfTestDialog</name>
    <message>
        <source>Test yourself</source>
        <translation>Испитајте се</translation>
    </message>
    <message>
        <source>The same topics and number give everyone the same test</source>
        <translation>Исте теме и исти број свима дају исти тест</translation>
    </message>
    <message>
        <source>&amp;All topics</source>
        <translation>&amp;Све теме</translation>
    </message>
    <message>
        <source>&amp;None</source>
        <translation>&amp;Ниједна</translation>
    </message>
    <message>
        <source>Up to {0} exercises. One try each, no hints, panels closed; give three significant digits. At the end you see all solutions.</source>
        <translation>Број задатака: до {0}. По један покушај, без наговештаја, панели затворени; дајте три значајне цифре. На крају видите сва решења.</translation>
    </message>
    <message>
        <source>&amp;Begin</source>
        <translation>&amp;Почни</translation>
    </message>
    <message>
        <source>Test number</source>
        <translation>Број теста</translation>
    </message>
    <message>
        <source>Choose topics.</source>
        <translation>Изаберите теме.</translation>
    </message>
</context>
<context>
    <name>SelfTestMarks</name>
    <message>
        <source>{0} of {1} right</source>
        <translation>тачно {0} од {1}</translation>
    </message>
    <message>
        <source>The right answer:</source>
        <translation>Тачан одговор:</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>Тачно</translation>
    </message>
    <message>
        <source>Wrong</source>
        <translation>Нетачно</translation>
    </message>
    <message>
        <source>You gave no answer.</source>
        <translation>Нисте дали одговор.</translation>
    </message>
    <message>
        <source>Your answer:</source>
        <translation>Ваш одговор:</translation>
    </message>
    <message>
        <source>The idea behind it: “{0}”.</source>
        <translation>Представа иза тога: „{0}”.</translation>
    </message>
</context>
<context>
    <name>SettingMotion</name>
    <message>
        <source>Move it back and forth between the ends of its slider</source>
        <translation>Помери га напред-назад између крајева клизача</translation>
    </message>
    <message>
        <source>Pause it here; playing continues from here</source>
        <translation>Паузирај овде; пуштање наставља одавде</translation>
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
        <translation>стандардни паралелни</translation>
    </message>
    <message>
        <source>canonical perspective</source>
        <translation>стандардни перспективни</translation>
    </message>
    <message>
        <source>clip</source>
        <translation>одсецање</translation>
    </message>
    <message>
        <source>depth range</source>
        <translation>опсег дубине</translation>
    </message>
    <message>
        <source>image</source>
        <translation>слика</translation>
    </message>
    <message>
        <source>object</source>
        <translation>објекат</translation>
    </message>
    <message>
        <source>sheared</source>
        <translation>после смицања</translation>
    </message>
    <message>
        <source>view</source>
        <translation>камера</translation>
    </message>
    <message>
        <source>world</source>
        <translation>свет</translation>
    </message>
</context>
<context>
    <name>SpeakerWindow</name>
    <message>
        <source>Speaker&apos;s window – Frustum Lab</source>
        <translation>Прозор предавача – Frustum Lab</translation>
    </message>
    <message>
        <source>Notes</source>
        <translation>Белешке</translation>
    </message>
    <message>
        <source>The slide</source>
        <translation>Слајд</translation>
    </message>
    <message>
        <source>Next</source>
        <translation>Следеће</translation>
    </message>
    <message>
        <source>Steps</source>
        <translation>Кораци</translation>
    </message>
    <message>
        <source>&amp;Reset</source>
        <translation>&amp;Врати на почетно</translation>
    </message>
    <message>
        <source>◀ &amp;Back</source>
        <translation>◀ &amp;Назад</translation>
    </message>
    <message>
        <source>&amp;Next ▶</source>
        <translation>&amp;Даље ▶</translation>
    </message>
    <message>
        <source>B&amp;lank</source>
        <translation>&amp;Затамни</translation>
    </message>
    <message>
        <source>S&amp;wap screens</source>
        <translation>За&amp;мени екране</translation>
    </message>
    <message>
        <source>Swap the screens of class and notes (W); the choice is remembered</source>
        <translation>Замени екране за слушаоце и за белешке (W); избор се памти</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Време</translation>
    </message>
    <message>
        <source>Elapsed</source>
        <translation>Протекло</translation>
    </message>
    <message>
        <source>step {0} of {1}</source>
        <translation>корак {0} од {1}</translation>
    </message>
    <message>
        <source>Next: the answer</source>
        <translation>Следеће: одговор</translation>
    </message>
    <message>
        <source>Next: the question</source>
        <translation>Следеће: питање</translation>
    </message>
    <message>
        <source>{0}; later: {1}</source>
        <translation>{0}; касније: {1}</translation>
    </message>
    <message>
        <source>Next: {0}</source>
        <translation>Следеће: {0}</translation>
    </message>
    <message>
        <source>This is the last step.</source>
        <translation>Ово је последњи корак.</translation>
    </message>
    <message>
        <source>&amp;Pause</source>
        <translation>Паузира&amp;ј</translation>
    </message>
    <message>
        <source>&amp;Start</source>
        <translation>&amp;Покрени</translation>
    </message>
    <message>
        <source>planned {0} to {1} min</source>
        <translation>планирано {0} до {1} min</translation>
    </message>
    <message>
        <source>planned {0} min</source>
        <translation>планирано {0} min</translation>
    </message>
    <message>
        <source>{0} min late</source>
        <translation>касни {0} min</translation>
    </message>
</context>
<context>
    <name>Spoken</name>
    <message>
        <source>at least</source>
        <translation>најмање</translation>
    </message>
    <message>
        <source>at most</source>
        <translation>највише</translation>
    </message>
    <message>
        <source>degrees</source>
        <translation>степени</translation>
    </message>
    <message>
        <source>equals</source>
        <translation>једнако</translation>
    </message>
    <message>
        <source>infinity</source>
        <translation>бесконачно</translation>
    </message>
    <message>
        <source>is about</source>
        <translation>приближно једнако</translation>
    </message>
    <message>
        <source>is not</source>
        <translation>различито од</translation>
    </message>
    <message>
        <source>minus</source>
        <translation>минус</translation>
    </message>
    <message>
        <source>over</source>
        <translation>кроз</translation>
    </message>
    <message>
        <source>phi</source>
        <translation>фи</translation>
    </message>
    <message>
        <source>plus</source>
        <translation>плус</translation>
    </message>
    <message>
        <source>plus or minus</source>
        <translation>плус-минус</translation>
    </message>
    <message>
        <source>prime</source>
        <translation>прим</translation>
    </message>
    <message>
        <source>root of</source>
        <translation>корен из</translation>
    </message>
    <message>
        <source>sum of</source>
        <translation>збир</translation>
    </message>
    <message>
        <source>times</source>
        <translation>пута</translation>
    </message>
    <message>
        <source>to</source>
        <translation>у</translation>
    </message>
    <message>
        <source>to the power</source>
        <translation>на степен</translation>
    </message>
    <message>
        <source>vector</source>
        <translation>вектор</translation>
    </message>
</context>
<context>
    <name>Stage</name>
    <message>
        <source>the scene&apos;s objects are given in world coordinates</source>
        <translation>објекти сцене дати су у координатама света</translation>
    </message>
    <message>
        <source>a scale of 0 flattens the object: it has no inverse and no normals</source>
        <translation>скалирање са 0 спљошти објекат: нема инверз ни нормале</translation>
    </message>
    <message>
        <source>a parallel lens has no M_pp: this is the identity</source>
        <translation>паралелни објектив нема M_pp: ово је јединична матрица</translation>
    </message>
    <message>
        <source>far is infinite: the canonical pyramid is scaled by near, which is at z = -1</source>
        <translation>задња раван је у бесконачности: стандардна пирамида је скалирана предњом равни, која је на z = -1</translation>
    </message>
</context>
<context>
    <name>StageStrip</name>
    <message>
        <source>World</source>
        <translation>Свет</translation>
    </message>
    <message>
        <source>World space: the scene and the view volume in it</source>
        <translation>Координатни систем света: сцена и запремина погледа у њему</translation>
    </message>
    <message>
        <source>View</source>
        <translation>Камера</translation>
    </message>
    <message>
        <source>View space: the eye is at 0 and looks along −z</source>
        <translation>Координатни систем камере: камера је у 0 и гледа дуж −z</translation>
    </message>
    <message>
        <source>Pyramid</source>
        <translation>Пирамида</translation>
    </message>
    <message>
        <source>The canonical perspective volume: a pyramid with its tip in the eye</source>
        <translation>Стандардна перспективна запремина: пирамида са врхом у позицији камере</translation>
    </message>
    <message>
        <source>Box</source>
        <translation>Квадар</translation>
    </message>
    <message>
        <source>The canonical parallel volume: Mₚₚ has turned the pyramid into a box</source>
        <translation>Стандардна паралелна запремина: Mₚₚ је пирамиду претворила у квадар</translation>
    </message>
    <message>
        <source>NDC</source>
        <translation>NDC</translation>
    </message>
    <message>
        <source>Normalised device coordinates, z mirrored for display</source>
        <translation>Нормализоване координате уређаја, z је за приказ огледалски окренуто</translation>
    </message>
    <message>
        <source>Image</source>
        <translation>Слика</translation>
    </message>
    <message>
        <source>The picture in pixels: x right, y down</source>
        <translation>Слика у пикселима: x удесно, y надоле</translation>
    </message>
    <message>
        <source>Mₚₚ</source>
        <translation>Mₚₚ</translation>
    </message>
    <message>
        <source>Stage</source>
        <translation>Фаза</translation>
    </message>
    <message>
        <source>From the world through all stages to the picture; the arrow keys go from stop to stop</source>
        <translation>Од света кроз све фазе до слике; стрелице иду од станице до станице</translation>
    </message>
    <message>
        <source>Object</source>
        <translation>Објекат</translation>
    </message>
    <message>
        <source>The object&apos;s own space</source>
        <translation>Сопствени координатни систем објекта</translation>
    </message>
    <message>
        <source>After {0}</source>
        <translation>После: {0}</translation>
    </message>
    <message>
        <source>The canonical parallel volume: a parallel lens has no pyramid before it</source>
        <translation>Стандардна паралелна запремина: паралелни објектив пре ње нема пирамиду</translation>
    </message>
    <message>
        <source>The same box: Mₚₚ of a parallel lens is the identity</source>
        <translation>Исти квадар: Mₚₚ паралелног објектива је јединична матрица</translation>
    </message>
    <message>
        <source>Canonical parallel</source>
        <translation>Стандардна паралелна</translation>
    </message>
    <message>
        <source>Canonical perspective</source>
        <translation>Стандардна перспективна</translation>
    </message>
    <message>
        <source>NDC cube</source>
        <translation>NDC коцка</translation>
    </message>
    <message>
        <source>The moves of object and camera done from the left: each in the axes that the moves before have moved</source>
        <translation>Покрети објекта и камере извршавају се слева: сваки у осама које су ранији покрети померили</translation>
    </message>
    <message>
        <source>The moves of object and camera read from the right: each in fixed axes</source>
        <translation>Покрети објекта и камере читају се здесна: сваки у непомичним осама</translation>
    </message>
    <message>
        <source>x, y, z in world units</source>
        <translation>x, y, z у јединицама света</translation>
    </message>
    <message>
        <source>no canonical volumes</source>
        <translation>нема стандардних запремина</translation>
    </message>
    <message>
        <source>x, y, z of view space</source>
        <translation>x, y, z у координатном систему камере</translation>
    </message>
    <message>
        <source>{axis_u}, {axis_v}, {axis_n} in world units</source>
        <translation>{axis_u}, {axis_v}, {axis_n} у јединицама света</translation>
    </message>
    <message>
        <source>x, y ±1, z {0} … {1}</source>
        <translation>x, y ±1, z {0} … {1}</translation>
    </message>
    <message>
        <source>{0} × {1} pixels, y down</source>
        <translation>{0} × {1} пиксела, y надоле</translation>
    </message>
    <message>
        <source>x, y ±1, z 0 … -1; Mₚₚ: identity</source>
        <translation>x, y ±1, z 0 … -1; Mₚₚ: јединична</translation>
    </message>
    <message>
        <source>x, y ±1, z 0 … -1</source>
        <translation>x, y ±1, z 0 … -1</translation>
    </message>
    <message>
        <source>near z -1, far -∞ (scaled by 1/{n})</source>
        <translation>предња z -1, задња -∞ (скалирано са 1/{n})</translation>
    </message>
    <message>
        <source>x, y ±1, z -{n}/{f} = {0} … -1</source>
        <translation>x, y ±1, z -{n}/{f} = {0} … -1</translation>
    </message>
    <message>
        <source>{0} the stages</source>
        <translation>{0} фазе</translation>
    </message>
    <message>
        <source>Run through all stages to the picture, resting at each.</source>
        <translation>Прођи кроз све фазе до слике, са застанком на свакој.</translation>
    </message>
    <message>
        <source>Pause; playing again continues from here.</source>
        <translation>Паузирај; поновно пуштање наставља одавде.</translation>
    </message>
</context>
<context>
    <name>StartCard</name>
    <message>
        <source>Start</source>
        <translation>Почетак</translation>
    </message>
    <message>
        <source>Learn</source>
        <translation>Учење</translation>
    </message>
    <message>
        <source>Files</source>
        <translation>Датотеке</translation>
    </message>
    <message>
        <source>Show this at every start</source>
        <translation>Прикажи ово при сваком покретању</translation>
    </message>
    <message>
        <source>Help &gt; Start card shows it at any time</source>
        <translation>Помоћ &gt; Почетна страница приказује је у свако доба</translation>
    </message>
    <message>
        <source>How a camera turns a 3-D scene into a picture</source>
        <translation>Како камера претвара 3D сцену у слику</translation>
    </message>
    <message>
        <source>Begin with the letter F (Esc)</source>
        <translation>Почни са словом F (Esc)</translation>
    </message>
    <message>
        <source>Two-minute tour</source>
        <translation>Обилазак за два минута</translation>
    </message>
    <message>
        <source>Six things to try, one after the other</source>
        <translation>Шест ствари за испробавање, једна за другом</translation>
    </message>
    <message>
        <source>24 topics of the lectures, to work through alone</source>
        <translation>24 теме из предавања, за самосталан рад</translation>
    </message>
    <message>
        <source>The five lectures, to present to a class</source>
        <translation>Пет предавања, за излагање слушаоцима</translation>
    </message>
    <message>
        <source>Lessons</source>
        <translation>Лекције</translation>
    </message>
    <message>
        <source>Talks</source>
        <translation>Презентације</translation>
    </message>
    <message>
        <source>Speed and accuracy</source>
        <translation>Брзина и тачност</translation>
    </message>
    <message>
        <source>What a renderer gives up to be fast, measured</source>
        <translation>Чега се програм за исцртавање одриче да би био брз, измерено</translation>
    </message>
    <message>
        <source>What you did not solve alone, with other numbers, the topics mixed</source>
        <translation>Оно што нисте решили сами, са другим бројевима, теме измешане</translation>
    </message>
    <message>
        <source>Open a file…</source>
        <translation>Отвори датотеку…</translation>
    </message>
    <message>
        <source>Open a document, a lesson, a mesh, a camera or an exported picture</source>
        <translation>Отвори документ, лекцију, мрежу, камеру или извезену слику</translation>
    </message>
</context>
<context>
    <name>StatusLine</name>
    <message>
        <source>Numerical health</source>
        <translation>Нумеричка поузданост</translation>
    </message>
    <message>
        <source>The precision of the picture (drawn) and of its numbers (read), each with a bound on its error. The bound of the picture holds for what is visible. The bounds of the numbers and of the alternatives in the menu hold for every point in front of the eye</source>
        <translation>Прецизност слике (нацртано) и њених бројева (очитано), обе са границом грешке. Граница за слику важи за оно што је видљиво. Границе за бројеве и за могућности у менију важе за сваку тачку испред камере</translation>
    </message>
    <message>
        <source>The panes are drawn with the quality that you chose; click for the automatic one</source>
        <translation>Прикази се цртају квалитетом који сте изабрали; кликните за аутоматски</translation>
    </message>
    <message>
        <source>Cost of a step</source>
        <translation>Цена корака</translation>
    </message>
    <message>
        <source>{0} {1} + {2}</source>
        <translation>{0} {1} + {2}</translation>
    </message>
    <message>
        <source>model {0}</source>
        <translation>модел {0}</translation>
    </message>
    <message>
        <source>{0} ms</source>
        <translation>{0} ms</translation>
    </message>
    <message>
        <source>Time of the last step in ms: the model; for each pane its matrices + its repaint</source>
        <translation>Време последњег корака у ms: модел; за сваки приказ матрице + исцртавање</translation>
    </message>
    <message>
        <source>quality: {0}</source>
        <translation>квалитет: {0}</translation>
    </message>
    <message>
        <source>drawn {0}, read {1}</source>
        <translation>нацртано {0}, очитано {1}</translation>
    </message>
    <message>
        <source>drawn {0} ±{1} px, read {2} ±{3} px</source>
        <translation>нацртано {0} ±{1} px, очитано {2} ±{3} px</translation>
    </message>
    <message>
        <source>{0}: up to {1} px, {2} in depth</source>
        <translation>{0}: до {1} px, {2} у дубини</translation>
    </message>
    <message>
        <source>{0}: its error has no bound here</source>
        <translation>{0}: његова грешка овде нема границу</translation>
    </message>
    <message>
        <source>drawn</source>
        <translation>нацртано</translation>
    </message>
    <message>
        <source>read</source>
        <translation>очитано</translation>
    </message>
    <message>
        <source>Frames of at most {0} ms while dragging…</source>
        <translation>Кадрови од највише {0} ms при превлачењу…</translation>
    </message>
    <message>
        <source>No limit on the frame time while dragging…</source>
        <translation>Без ограничења трајања кадра при превлачењу…</translation>
    </message>
    <message>
        <source>While you drag a control, antialiasing and triangles may be left out to keep each frame within this many milliseconds; 0 for no limit:</source>
        <translation>Док превлачите контролу, могу да се изоставе умекшавање ивица и троуглови да би сваки кадар стао у оволико милисекунди; 0 за без ограничења:</translation>
    </message>
    <message>
        <source>Frame time</source>
        <translation>Трајање кадра</translation>
    </message>
    <message>
        <source>Drawing tolerance {0} px…</source>
        <translation>Допуштено одступање цртежа {0} px…</translation>
    </message>
    <message>
        <source>Drawing tolerance</source>
        <translation>Допуштено одступање цртежа</translation>
    </message>
    <message>
        <source>A GPU&apos;s own arithmetic (float32) may draw with an error of up to this many pixels:</source>
        <translation>Сопствена аритметика графичког процесора (float32) може да црта са грешком до оволико пиксела:</translation>
    </message>
</context>
<context>
    <name>StepMarks</name>
    <message>
        <source>Steps</source>
        <translation>Кораци</translation>
    </message>
    <message>
        <source>Practice</source>
        <translation>Вежбање</translation>
    </message>
    <message>
        <source>Step {0} of {1}</source>
        <translation>Корак {0} од {1}</translation>
    </message>
    <message>
        <source>done</source>
        <translation>завршено</translation>
    </message>
    <message>
        <source>answered</source>
        <translation>одговорено</translation>
    </message>
    <message>
        <source>Step {0}: {1}</source>
        <translation>Корак {0}: {1}</translation>
    </message>
    <message>
        <source>Step {0}, practice: {1}</source>
        <translation>Корак {0}, вежбање: {1}</translation>
    </message>
</context>
<context>
    <name>StepPage</name>
    <message>
        <source>Step</source>
        <translation>Корак</translation>
    </message>
</context>
<context>
    <name>TalkWriter</name>
    <message>
        <source>Add this state as a step</source>
        <translation>Додај ово стање као корак</translation>
    </message>
    <message>
        <source>{0} is not in its folder any more, and no step was added: put the file back, or choose “A new talk from here” in the Lessons menu.</source>
        <translation>{0} више није у својој фасцикли и ниједан корак није додат: вратите датотеку, или изаберите „Нова презентација одавде” у менију „Лекције”.</translation>
    </message>
    <message>
        <source>Added as step {0} of {1}</source>
        <translation>Додато као корак {0} од {1}</translation>
    </message>
    <message>
        <source>Talks and lessons (*.md)</source>
        <translation>Презентације и лекције (*.md)</translation>
    </message>
    <message>
        <source>A new talk from here</source>
        <translation>Нова презентација одавде</translation>
    </message>
</context>
<context>
    <name>Talks</name>
    <message>
        <source>There is only one screen.</source>
        <translation>Постоји само један екран.</translation>
    </message>
    <message>
        <source>Open a talk first: its handout shows the strokes.</source>
        <translation>Прво отворите презентацију: потези се виде у њеном материјалу за слушаоце.</translation>
    </message>
    <message>
        <source>Kept for the handout: {0}</source>
        <translation>Задржано за материјал за слушаоце: {0}</translation>
    </message>
    <message>
        <source>This is the last step.</source>
        <translation>Ово је последњи корак.</translation>
    </message>
    <message>
        <source>There is no step {0}; the last is {1}.</source>
        <translation>Нема корака {0}; последњи је {1}.</translation>
    </message>
    <message>
        <source>To step {0}…</source>
        <translation>На корак {0}…</translation>
    </message>
    <message>
        <source>The file was changed, and cannot be read.</source>
        <translation>Датотека је измењена и не може да се прочита.</translation>
    </message>
    <message>
        <source>Open a talk first: the speaker&apos;s window shows its notes.</source>
        <translation>Прво отворите презентацију: прозор предавача приказује њене белешке.</translation>
    </message>
</context>
<context>
    <name>TaskView</name>
    <message>
        <source>To do</source>
        <translation>Урадите</translation>
    </message>
    <message>
        <source>The window as it is now is my answer</source>
        <translation>Прозор какав је сада је мој одговор</translation>
    </message>
    <message>
        <source>Hand it &amp;in</source>
        <translation>Пр&amp;едај</translation>
    </message>
    <message>
        <source>Nothing is changed yet.</source>
        <translation>Још ништа није промењено.</translation>
    </message>
    <message>
        <source>You can see a state that fulfils the task.</source>
        <translation>Можете да видите стање које испуњава задатак.</translation>
    </message>
    <message>
        <source>Show a state that makes it visible (Alt+W)</source>
        <translation>Прикажи стање у коме се то види (Alt+W)</translation>
    </message>
    <message>
        <source>Sho&amp;w it</source>
        <translation>При&amp;кажи то</translation>
    </message>
    <message>
        <source>Done.</source>
        <translation>Урађено.</translation>
    </message>
    <message>
        <source>Done</source>
        <translation>Урађено</translation>
    </message>
</context>
<context>
    <name>TitleDialog</name>
    <message>
        <source>&amp;Title of the step</source>
        <translation>&amp;Наслов корака</translation>
    </message>
    <message>
        <source>Keep the &amp;panes turned as they are</source>
        <translation>Задржи при&amp;казе окренуте како јесу</translation>
    </message>
    <message>
        <source>The state is then a document beside the file</source>
        <translation>Стање је тада документ поред датотеке</translation>
    </message>
</context>
<context>
    <name>TradesCard</name>
    <message>
        <source>Speed and accuracy</source>
        <translation>Брзина и тачност</translation>
    </message>
    <message>
        <source>Back to the start card</source>
        <translation>Назад на почетну страницу</translation>
    </message>
    <message>
        <source>Start card</source>
        <translation>Почетна страница</translation>
    </message>
    <message>
        <source>Speed and accuracy: what a renderer gives up to be fast</source>
        <translation>Брзина и тачност: чега се програм за исцртавање одриче да би био брз</translation>
    </message>
    <message>
        <source>Go on with the scene (Esc)</source>
        <translation>Настави са сценом (Esc)</translation>
    </message>
    <message>
        <source>Measured with the letter F on another machine: {0}. Choose a trade to see it, and to measure it here.</source>
        <translation>Измерено са словом F на другој машини: {0}. Изаберите компромис да бисте га видели, и да бисте га овде измерили.</translation>
    </message>
    <message>
        <source>Not measured yet.</source>
        <translation>Још није измерено.</translation>
    </message>
</context>
<context>
    <name>TypesetLabel</name>
    <message>
        <source>Copy with all digits</source>
        <translation>Копирај са свим цифрама</translation>
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
        <translation>{0} И још {1}.</translation>
    </message>
</context>
<context>
    <name>_MatrixCellEdit</name>
    <message>
        <source>Row {0}, column {1}</source>
        <translation>Врста {0}, колона {1}</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>Тачно</translation>
    </message>
    <message>
        <source>Wrong</source>
        <translation>Нетачно</translation>
    </message>
</context>
<context>
    <name>_Node</name>
    <message>
        <source>the picture is of this kind now: {0}</source>
        <translation>слика је сада ове врсте: {0}</translation>
    </message>
</context>
<context>
    <name>_TileCard</name>
    <message>
        <source>Whether the product has this tile</source>
        <translation>Да ли производ садржи ову плочицу</translation>
    </message>
    <message>
        <source>Remove it</source>
        <translation>Уклони је</translation>
    </message>
    <message>
        <source>origin</source>
        <translation>координатни почетак</translation>
    </message>
    <message>
        <source>axis</source>
        <translation>оса</translation>
    </message>
</context>
<context>
    <name>_TileRow</name>
    <message>
        <source>Whether the product has this tile</source>
        <translation>Да ли производ садржи ову плочицу</translation>
    </message>
</context>
<context>
    <name>phenomena</name>
    <message>
        <source>on</source>
        <translation>укључено</translation>
    </message>
    <message>
        <source>off</source>
        <translation>искључено</translation>
    </message>
    <message>
        <source>this computer&apos;s OpenGL rejects the shader that this scene needs: the picture is drawn without it, and only the computed numbers are right</source>
        <translation>OpenGL овог рачунара одбија шејдер који је овој сцени потребан: слика се црта без њега, и само израчунати бројеви су тачни</translation>
    </message>
    <message>
        <source>{0} faces with {1} parts a side are too many triangles to draw: the picture has {2} parts</source>
        <translation>премного је троуглова за цртање (број страна: {0}, делова по ивици: {1}): на слици је број делова {2}</translation>
    </message>
    <message>
        <source>your idea</source>
        <translation>ваша представа</translation>
    </message>
    <message>
        <source>the model</source>
        <translation>модел</translation>
    </message>
    <message>
        <source>truncated pyramid</source>
        <translation>зарубљена пирамида</translation>
    </message>
    <message>
        <source>oblique box</source>
        <translation>коси паралелепипед</translation>
    </message>
    <message>
        <source>box</source>
        <translation>квадар</translation>
    </message>
    <message>
        <source>a free matrix has no near, no far and no window: choose a lens to see this</source>
        <translation>слободна матрица нема ни предњу ни задњу раван ни прозор: изаберите објектив да бисте ово видели</translation>
    </message>
    <message>
        <source>0 is the orthographic drawing, 1 the oblique one</source>
        <translation>0 је ортографски цртеж, 1 коси</translation>
    </message>
    <message>
        <source>0: uncut; then near, far, left, right, bottom and top, one by one</source>
        <translation>0: неодсечено; затим предња, задња, лева, десна, доња и горња, једна по једна</translation>
    </message>
    <message>
        <source>1-point</source>
        <translation>1 недоглед</translation>
    </message>
    <message>
        <source>1-point perspective</source>
        <translation>перспектива са 1 недогледом</translation>
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
        <translation>1/w је дуж обележене ивице права</translation>
    </message>
    <message>
        <source>105 mm, enlarged 3.3 times</source>
        <translation>105 mm, увећано 3.3 пута</translation>
    </message>
    <message>
        <source>12 bits</source>
        <translation>12 бита</translation>
    </message>
    <message>
        <source>12 bits a coordinate</source>
        <translation>12 бита по координати</translation>
    </message>
    <message>
        <source>16 bits</source>
        <translation>16 бита</translation>
    </message>
    <message>
        <source>16 bits a coordinate</source>
        <translation>16 бита по координати</translation>
    </message>
    <message>
        <source>1994 console</source>
        <translation>конзола из 1994</translation>
    </message>
    <message>
        <source>1: both ends in front of it</source>
        <translation>1: оба краја испред ње</translation>
    </message>
    <message>
        <source>2-point</source>
        <translation>2 недогледа</translation>
    </message>
    <message>
        <source>2-point perspective</source>
        <translation>перспектива са 2 недогледа</translation>
    </message>
    <message>
        <source>24 bits</source>
        <translation>24 бита</translation>
    </message>
    <message>
        <source>29 mm</source>
        <translation>29 mm</translation>
    </message>
    <message>
        <source>2: both ends behind it</source>
        <translation>2: оба краја иза ње</translation>
    </message>
    <message>
        <source>3-point</source>
        <translation>3 недогледа</translation>
    </message>
    <message>
        <source>3-point perspective</source>
        <translation>перспектива са 3 недогледа</translation>
    </message>
    <message>
        <source>32 bits</source>
        <translation>32 бита</translation>
    </message>
    <message>
        <source>3: only A behind it</source>
        <translation>3: само A иза ње</translation>
    </message>
    <message>
        <source>4: only B behind it</source>
        <translation>4: само B иза ње</translation>
    </message>
    <message>
        <source>8 bits</source>
        <translation>8 бита</translation>
    </message>
    <message>
        <source>8 bits a coordinate</source>
        <translation>8 бита по координати</translation>
    </message>
    <message>
        <source>A camera turns by 1° a frame: each frame multiplies its axes by the same small turn, and every product is rounded. After 360° it should be home. The pale picture is the true one, and beside it is what the camera sees: one matrix product a frame instead of two sines has its price. Every tenth frame the axes can be renormalised, which repairs their lengths and right angles, but not their direction.</source>
        <translation>Камера се окреће за 1° по кадру: сваки кадар множи њене осе истим малим окретањем, и сваки производ се заокружује. После 360° требало би да буде тамо где је почела. Бледа слика је тачна, а поред ње је оно што камера види: један производ матрица по кадру уместо два синуса има своју цену. Сваки десети кадар осе могу да се поново нормирају, што поправља њихове дужине и праве углове, али не и смер.</translation>
    </message>
    <message>
        <source>A field of view from lecture 001; the camera moves so that things at the target&apos;s distance keep their size</source>
        <translation>Видно поље из предавања 001; камера се помера тако да оно што је на растојању циља задржи величину</translation>
    </message>
    <message>
        <source>A lamp at a point, or the sun: a point at infinity</source>
        <translation>Лампа у тачки, или сунце: бесконачно далека тачка</translation>
    </message>
    <message>
        <source>A logarithmic depth has digits for every distance. Computed for each vertex, it costs one logarithm a vertex, and the early depth test stays on. But between the vertices the rasteriser interpolates it linearly on the screen, where 1/w is linear and log w is not. So a long face is drawn too far away: the wall&apos;s foundation, which is below the floor, is seen through it. Shorter pieces or a logarithm for each pixel mend that.</source>
        <translation>Логаритамска дубина има цифре за свако растојање. Израчуната за свако теме кошта један логаритам по темену, а рани тест дубине остаје укључен. Али између темена растеризатор је интерполира линеарно на екрану, где је 1/w линеарно, а log w није. Зато се дугачка страна црта предалеко: темељ зида, који је испод пода, види се кроз њега. Краћи делови или логаритам за сваки пиксел то поправљају.</translation>
    </message>
    <message>
        <source>A pixel and its depth lead back to the point that was drawn there. The inverse of P V does it in one product, but it multiplies the eye&apos;s coordinates with 1/w, a difference of nearly equal numbers. Far from the world&apos;s origin, float32 then misses the point by parts of its distance. If the pixel&apos;s ray is multiplied with the depth, or if P and V are undone one after the other, the eye is only added, and is rounded once. On the way to the picture, it hardly matters whether P and V are one matrix or two: that these make the difference is a myth.</source>
        <translation>Пиксел и његова дубина воде назад до тачке која је тамо нацртана. Инверз од P V то ради у једном производу, али множи координате позиције камере са 1/w, разликом скоро једнаких бројева. Далеко од координатног почетка света float32 тада промашује тачку за делове њеног растојања. Ако се зрак пиксела множи дубином, или ако се P и V поништавају једно по једно, позиција камере се само додаје и заокружује једном. На путу ка слици једва да је важно да ли су P и V једна матрица или две: да оне праве разлику, то је мит.</translation>
    </message>
    <message>
        <source>A point behind the eye has w &lt; 0, and the divide by w mirrors its image. With one end behind, AB is then drawn along the wrong part of its line, because the right part goes through infinity. So AB must be cut before the divide: at z = −0.01 as in lecture 004, or in homogeneous coordinates, which need no such number.</source>
        <translation>Тачка иза камере има w &lt; 0, и дељење са w пресликава њену слику као у огледалу. Ако је један крај иза, AB се црта дуж погрешног дела своје праве, јер исправни део пролази кроз бесконачност. Зато AB мора да се одсече пре дељења: на z = −0.01 као у предавању 004, или у хомогеним координатама, којима такав број није потребан.</translation>
    </message>
    <message>
        <source>A shadow is a projection with its centre in the light: the matrix S draws the object once more, in one colour. For the sun, a light at infinity with w = 0, the projection is parallel. Parts of the object above a lamp have w &lt; 0. Unless they are clipped, they are drawn on the other side of the lamp as an anti-shadow.</source>
        <translation>Сенка је пројекција са центром у светлу: матрица S црта објекат још једном, једном бојом. За сунце, светло у бесконачности са w = 0, пројекција је паралелна. Делови објекта изнад лампе имају w &lt; 0. Ако се не одсеку, цртају се са друге стране лампе као антисенка.</translation>
    </message>
    <message>
        <source>A shape inside the view volume is drawn, and a shape outside it is not. A shape that crosses it is cut by each plane in turn, and gets a new corner where an edge passes through the plane. Near removes everything at the eye or behind it, where w ≤ 0 and the divide fails, and far bounds the depths. Clipping is done in the canonical volume, before the divide, because there the planes are the same for every lens: −w ≤ x, y, z ≤ w in OpenGL&apos;s.</source>
        <translation>Облик унутар запремине погледа се црта, а облик изван ње не. Облик који пресеца њену границу одсеца се редом сваком равни, и добија ново теме где ивица пролази кроз раван. Предња раван уклања све што је код камере или иза ње, где је w ≤ 0 и дељење не успева, а задња ограничава дубине. Одсецање се ради у стандардној запремини, пре дељења, јер су тамо равни исте за сваки објектив: −w ≤ x, y, z ≤ w у OpenGL.</translation>
    </message>
    <message>
        <source>A table of 8 bits is quick, and each Newton step doubles its right digits</source>
        <translation>Табела од 8 бита је брза, а сваки Њутнов корак удвостручује број тачних цифара</translation>
    </message>
    <message>
        <source>A wall of two</source>
        <translation>Зид од два екрана</translation>
    </message>
    <message>
        <source>AB drawn wrongly</source>
        <translation>погрешно нацртан део AB</translation>
    </message>
    <message>
        <source>AB left out by the cut at z = −0.01</source>
        <translation>део AB који сечење на z = −0.01 изоставља</translation>
    </message>
    <message>
        <source>AB missed</source>
        <translation>део AB који недостаје</translation>
    </message>
    <message>
        <source>All projectors are parallel, but slant towards the image. Faces parallel to the image keep their shape, and receding edges are drawn at one angle and one scale. Scale 1 gives a cavalier drawing, 1/2 a cabinet drawing, and 0 the orthographic drawing.</source>
        <translation>Сви зраци пројекције су паралелни, али коси према слици. Стране паралелне слици задржавају облик, а ивице по дубини цртају се под једним углом и у једној размери. Размера 1 даје цртеж кавалјер, 1/2 цртеж кабинет, а 0 ортографски цртеж.</translation>
    </message>
    <message>
        <source>Aperture N</source>
        <translation>Бленда N</translation>
    </message>
    <message>
        <source>Arithmetic</source>
        <translation>Аритметика</translation>
    </message>
    <message>
        <source>B is behind the eye: where is it drawn?</source>
        <translation>B је иза камере: где се црта?</translation>
    </message>
    <message>
        <source>Back from the picture</source>
        <translation>Назад од слике</translation>
    </message>
    <message>
        <source>Bent by an affine z</source>
        <translation>Савијено афиним z</translation>
    </message>
    <message>
        <source>Bits of a coordinate</source>
        <translation>Битови координате</translation>
    </message>
    <message>
        <source>Box (orthographic)</source>
        <translation>Квадар (ортографски)</translation>
    </message>
    <message>
        <source>Cabinet: 1/2 ×</source>
        <translation>Кабинет: 1/2 ×</translation>
    </message>
    <message>
        <source>Camera obscura</source>
        <translation>Камера опскура</translation>
    </message>
    <message>
        <source>Cameras</source>
        <translation>Камере</translation>
    </message>
    <message>
        <source>Cavalier or cabinet: which looks right?</source>
        <translation>Кавалјер или кабинет: шта изгледа исправно?</translation>
    </message>
    <message>
        <source>Cavalier: 1 ×</source>
        <translation>Кавалјер: 1 ×</translation>
    </message>
    <message>
        <source>Changes the lens, but keeps the picture of the target&apos;s plane</source>
        <translation>Мења објектив, али задржава слику равни циља</translation>
    </message>
    <message>
        <source>Cheap arithmetic</source>
        <translation>Јефтина аритметика</translation>
    </message>
    <message>
        <source>Checks, or the coordinates themselves as colours</source>
        <translation>Шаховница, или саме координате као боје</translation>
    </message>
    <message>
        <source>Choose 12 bits: how narrow is the gap?</source>
        <translation>Изаберите 12 бита: колико је процеп узак?</translation>
    </message>
    <message>
        <source>Choose 24 bits: is it enough?</source>
        <translation>Изаберите 24 бита: да ли је довољно?</translation>
    </message>
    <message>
        <source>Choose 8 bits and go nearer. And farther?</source>
        <translation>Изаберите 8 бита и приђите ближе. А даље?</translation>
    </message>
    <message>
        <source>Choose a fog that hides it.</source>
        <translation>Изаберите маглу која то скрива.</translation>
    </message>
    <message>
        <source>Choose half floats, products alone.</source>
        <translation>Изаберите половичну прецизност, само производи.</translation>
    </message>
    <message>
        <source>Choose the box: which come, which go?</source>
        <translation>Изаберите квадар: шта улази, а шта излази?</translation>
    </message>
    <message>
        <source>Choose the common grid: what closes?</source>
        <translation>Изаберите заједничку решетку: шта се затвара?</translation>
    </message>
    <message>
        <source>Choose the orthographic lens: and now?</source>
        <translation>Изаберите ортографски објектив: шта је сада?</translation>
    </message>
    <message>
        <source>Choose “correct”: what has moved?</source>
        <translation>Изаберите „исправно”: шта се померило?</translation>
    </message>
    <message>
        <source>Choose “each pixel”: what disappears?</source>
        <translation>Изаберите „сваки пиксел”: шта нестаје?</translation>
    </message>
    <message>
        <source>Circle of confusion c</source>
        <translation>Кружић неоштрине c</translation>
    </message>
    <message>
        <source>Click in the image: what comes back?</source>
        <translation>Кликните на слику: шта се враћа?</translation>
    </message>
    <message>
        <source>Clip parts above the light</source>
        <translation>Одсеци делове изнад светла</translation>
    </message>
    <message>
        <source>Clipping, plane by plane</source>
        <translation>Одсецање, раван по раван</translation>
    </message>
    <message>
        <source>Compare 29 mm with 105 mm.</source>
        <translation>Упоредите 29 mm са 105 mm.</translation>
    </message>
    <message>
        <source>Compare both films: what is turned over?</source>
        <translation>Упоредите оба филма: шта је преокренуто?</translation>
    </message>
    <message>
        <source>Cone (the eye&apos;s own)</source>
        <translation>Купа (самог ока)</translation>
    </message>
    <message>
        <source>Contrast left by fog</source>
        <translation>Контраст који магла оставља</translation>
    </message>
    <message>
        <source>Coordinates</source>
        <translation>Координате</translation>
    </message>
    <message>
        <source>Cracks</source>
        <translation>Пукотине</translation>
    </message>
    <message>
        <source>Crossed, left eye&apos;s on the right</source>
        <translation>Укрштено, слика левог ока десно</translation>
    </message>
    <message>
        <source>Crossing the eye plane</source>
        <translation>Пролаз кроз раван камере</translation>
    </message>
    <message>
        <source>Cut the floor: how many pieces are enough?</source>
        <translation>Исеците под: колико је делова довољно?</translation>
    </message>
    <message>
        <source>Depth at the vertices</source>
        <translation>Дубина у теменима</translation>
    </message>
    <message>
        <source>Depth buffer</source>
        <translation>Бафер дубине</translation>
    </message>
    <message>
        <source>Depth range</source>
        <translation>Опсег дубине</translation>
    </message>
    <message>
        <source>Direction of receding edges, anticlockwise from the right</source>
        <translation>Смер ивица по дубини, супротно од казаљке на сату почев од десне стране</translation>
    </message>
    <message>
        <source>Distance at which linear fog begins</source>
        <translation>Растојање на коме почиње линеарна магла</translation>
    </message>
    <message>
        <source>Distance at which linear fog leaves nothing</source>
        <translation>Растојање на коме линеарна магла више ништа не оставља</translation>
    </message>
    <message>
        <source>Distance between the two eyes</source>
        <translation>Растојање између два ока</translation>
    </message>
    <message>
        <source>Distance from the eye to the plane of projection; negative behind the eye</source>
        <translation>Растојање од позиције камере до равни пројектовања; негативно иза камере</translation>
    </message>
    <message>
        <source>Distance from the hole to the film behind it, and to the synthetic film in front of it: near</source>
        <translation>Растојање од рупе до филма иза ње, и до синтетичког филма испред ње: предња раван</translation>
    </message>
    <message>
        <source>Distance from the lens at which things are in focus</source>
        <translation>Растојање од објектива на коме је све у фокусу</translation>
    </message>
    <message>
        <source>Distance from which trees have fewer vertices</source>
        <translation>Растојање од кога дрвеће има мање темена</translation>
    </message>
    <message>
        <source>Distance from which trees have fewest vertices</source>
        <translation>Растојање од кога дрвеће има најмање темена</translation>
    </message>
    <message>
        <source>Distance of surface 2 behind surface 1, along the view direction</source>
        <translation>Растојање површи 2 иза површи 1, дуж смера погледа</translation>
    </message>
    <message>
        <source>Distance of the eye from the window&apos;s middle; the window stays in the world</source>
        <translation>Растојање камере од средине прозора; прозор остаје у свету</translation>
    </message>
    <message>
        <source>Distance of the origin</source>
        <translation>Растојање координатног почетка</translation>
    </message>
    <message>
        <source>Distance of the screen plane from the eyes: what lies in it does not move between the pictures</source>
        <translation>Растојање равни екрана од очију: оно што у њој лежи не помера се између слика</translation>
    </message>
    <message>
        <source>Distance, relative to the preset</source>
        <translation>Растојање у односу на предложак</translation>
    </message>
    <message>
        <source>Do near and far change the bow?</source>
        <translation>Мењају ли предња и задња раван лук?</translation>
    </message>
    <message>
        <source>Double d: how large is h&apos;?</source>
        <translation>Удвостручите d: колико је h&apos;?</translation>
    </message>
    <message>
        <source>Double d: what are x_p and y_p now?</source>
        <translation>Удвостручите d: колики су сада x_p и y_p?</translation>
    </message>
    <message>
        <source>Double the parts: is the error halved?</source>
        <translation>Удвостручите делове: преполови ли се грешка?</translation>
    </message>
    <message>
        <source>Double z: and now?</source>
        <translation>Удвостручите z: шта је сада?</translation>
    </message>
    <message>
        <source>Drag P towards the eye: and now?</source>
        <translation>Превуците P ка камери: шта је сада?</translation>
    </message>
    <message>
        <source>Drag d: how large is the image of P?</source>
        <translation>Превуците d: колика је слика тачке P?</translation>
    </message>
    <message>
        <source>Drag t to 1: where does P go?</source>
        <translation>Превуците t на 1: куда иде P?</translation>
    </message>
    <message>
        <source>Drag the distance: what keeps its size?</source>
        <translation>Превуците растојање: шта задржава величину?</translation>
    </message>
    <message>
        <source>Drag the lamp: where is the shadow?</source>
        <translation>Превуците лампу: где је сенка?</translation>
    </message>
    <message>
        <source>Drag the near plane towards the F.</source>
        <translation>Превуците предњу раван ка слову F.</translation>
    </message>
    <message>
        <source>Drag the screen plane to P: what happens?</source>
        <translation>Превуците раван екрана до P: шта се дешава?</translation>
    </message>
    <message>
        <source>Drawing</source>
        <translation>Цртеж</translation>
    </message>
    <message>
        <source>Drawn length of a receding edge relative to its true length, in the free drawing</source>
        <translation>Нацртана дужина ивице по дубини у односу на стварну дужину, у слободном цртежу</translation>
    </message>
    <message>
        <source>Draws distant trees with fewer vertices</source>
        <translation>Црта далеко дрвеће са мање темена</translation>
    </message>
    <message>
        <source>Drift</source>
        <translation>Заношење</translation>
    </message>
    <message>
        <source>Each coordinate is stored as an integer over the mesh&apos;s box</source>
        <translation>Свака координата се чува као цео број у оквиру мреже</translation>
    </message>
    <message>
        <source>End B</source>
        <translation>Крај B</translation>
    </message>
    <message>
        <source>End P</source>
        <translation>Крај P</translation>
    </message>
    <message>
        <source>End Q</source>
        <translation>Крај Q</translation>
    </message>
    <message>
        <source>Enlarge the 105-mm photograph</source>
        <translation>Увећај фотографију од 105 mm</translation>
    </message>
    <message>
        <source>Enlarges the middle of the picture until things at the target&apos;s distance are as large as on the 29-mm photograph; this narrows the field of view</source>
        <translation>Увећава средину слике док оно што је на растојању циља не буде велико као на фотографији од 29 mm; то сужава видно поље</translation>
    </message>
    <message>
        <source>Every projector runs from a point to the eye. It meets the plane at distance d in the image of that point. The triangles between eye, axis and projector are similar, so x_p : d = x : (−z). If d is negative, the plane is behind the eye, as in a camera obscura, and the image is upside down.</source>
        <translation>Сваки зрак пројекције иде од тачке до камере. На растојању d он сече раван у слици те тачке. Троуглови између камере, осе и зрака су слични, па је x_p : d = x : (−z). Ако је d негативно, раван је иза камере, као у камери опскури, и слика је наопачке.</translation>
    </message>
    <message>
        <source>Exponential fog leaves exp(-density w)</source>
        <translation>Експоненцијална магла оставља exp(-density w)</translation>
    </message>
    <message>
        <source>Eye right of the middle</source>
        <translation>Камера десно од средине</translation>
    </message>
    <message>
        <source>Eye separation s</source>
        <translation>Размак очију s</translation>
    </message>
    <message>
        <source>F drawn wrongly</source>
        <translation>погрешно нацртани делови слова F</translation>
    </message>
    <message>
        <source>F missed</source>
        <translation>делови слова F који недостају</translation>
    </message>
    <message>
        <source>Far from the origin: move the origin.</source>
        <translation>Далеко од почетка: померите координатни почетак.</translation>
    </message>
    <message>
        <source>Fewer bits make a picture smaller and quicker, and less exact. Every vertex is stored and projected with the chosen formats, and drawn where they put it. An arrow runs from each vertex&apos;s exact pixel towards the drawn one, enlarged as much as is written beside it. The bound is predicted from the formats alone, and no error is larger. A console of 1994 drew whole pixels and affine textures, and its vertices jumped whenever the camera moved.</source>
        <translation>Са мање битова слика је мања и бржа, али мање тачна. Свако теме се чува и пројектује у изабраним форматима, и црта тамо где га они ставе. Стрелица иде од тачног пиксела сваког темена ка нацртаном, увећана онолико колико пише поред ње. Граница се предвиђа само на основу формата, и ниједна грешка није већа. Конзола из 1994. цртала је целе пикселе и афине текстуре, и њена темена су скакала чим би се камера померила.</translation>
    </message>
    <message>
        <source>Field of view</source>
        <translation>Видно поље</translation>
    </message>
    <message>
        <source>Film distance d</source>
        <translation>Растојање филма d</translation>
    </message>
    <message>
        <source>Focal distance s</source>
        <translation>Растојање фокуса s</translation>
    </message>
    <message>
        <source>Focus on the post at 10 m.</source>
        <translation>Фокусирајте стуб на 10 m.</translation>
    </message>
    <message>
        <source>Fog</source>
        <translation>Магла</translation>
    </message>
    <message>
        <source>Fog density</source>
        <translation>Густина магле</translation>
    </message>
    <message>
        <source>Fog ends at</source>
        <translation>Магла се завршава на</translation>
    </message>
    <message>
        <source>Fog starts at</source>
        <translation>Магла почиње на</translation>
    </message>
    <message>
        <source>Format</source>
        <translation>Формат</translation>
    </message>
    <message>
        <source>Frame</source>
        <translation>Кадар</translation>
    </message>
    <message>
        <source>Free receding scale</source>
        <translation>Слободна размера дубине</translation>
    </message>
    <message>
        <source>Free scale</source>
        <translation>Слободна размера</translation>
    </message>
    <message>
        <source>Free: turn the camera yourself</source>
        <translation>Слободно: сами окрените камеру</translation>
    </message>
    <message>
        <source>From orthographic</source>
        <translation>Од ортографског</translation>
    </message>
    <message>
        <source>From the side</source>
        <translation>Са стране</translation>
    </message>
    <message>
        <source>From which distance on does P stand still?</source>
        <translation>Од ког растојања P мирује?</translation>
    </message>
    <message>
        <source>Gap</source>
        <translation>Размак</translation>
    </message>
    <message>
        <source>Go back until AB is drawn right.</source>
        <translation>Идите назад док се AB не нацрта исправно.</translation>
    </message>
    <message>
        <source>Go back: which planes leave it as it is?</source>
        <translation>Идите назад: које га равни не мењају?</translation>
    </message>
    <message>
        <source>Go nearer the origin: do the ways agree?</source>
        <translation>Приђите ближе почетку: слажу ли се начини?</translation>
    </message>
    <message>
        <source>Go nearer: does the gap stay as wide?</source>
        <translation>Приђите ближе: остаје ли процеп једнако широк?</translation>
    </message>
    <message>
        <source>Go nearer: which edges grow?</source>
        <translation>Приђите ближе: које ивице расту?</translation>
    </message>
    <message>
        <source>Grid</source>
        <translation>Решетка</translation>
    </message>
    <message>
        <source>Half-way on the screen is not half-way in the world: along an edge 1/w is linear on the screen, and so is s/w, but s is not. If a texture is interpolated linearly (affine), it bends at the diagonal of every quadrangle. Smaller triangles hide this. Twice as many parts leave more than a quarter of the error while they are few, and a quarter in the limit.</source>
        <translation>Пола пута на екрану није пола пута у свету: дуж ивице је 1/w на екрану линеарно, а и s/w, али s није. Ако се текстура интерполира линеарно (афино), она се прелама на дијагонали сваког четвороугла. Мањи троуглови то скривају. Двоструко више делова оставља више од четвртине грешке док их је мало, а у граничном случају четвртину.</translation>
    </message>
    <message>
        <source>Hardware</source>
        <translation>Хардвер</translation>
    </message>
    <message>
        <source>Height of the plane</source>
        <translation>Висина равни</translation>
    </message>
    <message>
        <source>How a coordinate is stored; 8 to 16 bits are integers over the scene&apos;s box</source>
        <translation>Како се чува координата; 8 до 16 бита су цели бројеви у оквиру сцене</translation>
    </message>
    <message>
        <source>How a depth is stored: as an integer or as a float</source>
        <translation>Како се чува дубина: као цео број или у покретном зарезу</translation>
    </message>
    <message>
        <source>How a pixel and its depth become a point of the world</source>
        <translation>Како пиксел и његова дубина постају тачка света</translation>
    </message>
    <message>
        <source>How colours fade into the background with distance</source>
        <translation>Како боје са растојањем прелазе у боју позадине</translation>
    </message>
    <message>
        <source>How distance becomes depth; infinite puts the far plane at infinity</source>
        <translation>Како растојање постаје дубина; „бесконачно” шаље задњу раван у бесконачност</translation>
    </message>
    <message>
        <source>How does the error grow with the rounds?</source>
        <translation>Како грешка расте са бројем кругова?</translation>
    </message>
    <message>
        <source>How each frame finds its axes: a fast inverse square root takes bits for a logarithm, and one Newton step</source>
        <translation>Како сваки кадар налази своје осе: брзи инверзни корен узима битове као логаритам, и један Њутнов корак</translation>
    </message>
    <message>
        <source>How far away the world&apos;s origin lies, along x: coordinates are measured from there</source>
        <translation>Колико је далеко координатни почетак света, дуж x: координате се мере одатле</translation>
    </message>
    <message>
        <source>How far from the eye the world&apos;s origin lies: coordinates are measured from there</source>
        <translation>Колико је координатни почетак света далеко од камере: координате се мере одатле</translation>
    </message>
    <message>
        <source>How far the camera has driven along the avenue</source>
        <translation>Колико се камера одвезла дуж алеје</translation>
    </message>
    <message>
        <source>How far the origin of the coordinates is from the scene</source>
        <translation>Колико је координатни почетак далеко од сцене</translation>
    </message>
    <message>
        <source>How long receding edges are drawn</source>
        <translation>Колико се дугачке цртају ивице по дубини</translation>
    </message>
    <message>
        <source>How many times the camera turns by 360°, in 360 frames each</source>
        <translation>Колико се пута камера окрене за 360°, сваки пут у 360 кадрова</translation>
    </message>
    <message>
        <source>How the texture&apos;s coordinates are spread over a face</source>
        <translation>Како се координате текстуре распоређују по страни</translation>
    </message>
    <message>
        <source>How the two cameras look at the screen plane</source>
        <translation>Како две камере гледају у раван екрана</translation>
    </message>
    <message>
        <source>How the two pictures are shown</source>
        <translation>Како се приказују две слике</translation>
    </message>
    <message>
        <source>How the vertex and the eye are stored before they are subtracted</source>
        <translation>Како се теме и позиција камере чувају пре него што се одузму</translation>
    </message>
    <message>
        <source>How vertices are stored and computed; the console stores 16 bits, draws whole pixels and stretches textures</source>
        <translation>Како се темена чувају и рачунају; конзола чува 16 бита, црта целе пикселе и растеже текстуре</translation>
    </message>
    <message>
        <source>Human eye: 120° across</source>
        <translation>Људско око: 120° у ширину</translation>
    </message>
    <message>
        <source>If you walk past a window, it stays in its wall. The frustum from your eye through it leans, and left and right of the near plane&apos;s window are no longer opposite. Things in the window&apos;s own plane keep their place in the image. Two screens side by side are two such frusta with one eye, and their pictures join without a gap.</source>
        <translation>Ако прођете поред прозора, он остаје у свом зиду. Зарубљена пирамида од ваше позиције кроз њега се нагиње, и лева и десна граница прозора на предњој равни више нису супротни бројеви. Оно што лежи у самој равни прозора остаје на свом месту на слици. Два екрана један поред другог су две такве пирамиде са истом позицијом камере, и њихове слике се спајају без процепа.</translation>
    </message>
    <message>
        <source>Interpolation</source>
        <translation>Интерполација</translation>
    </message>
    <message>
        <source>Inverse of P V</source>
        <translation>Инверз од P V</translation>
    </message>
    <message>
        <source>Inverse of P, then of V</source>
        <translation>Инверз од P, па од V</translation>
    </message>
    <message>
        <source>Is the line PQ straight in the cube?</source>
        <translation>Да ли је дуж PQ у коцки права?</translation>
    </message>
    <message>
        <source>Its other end, in world coordinates</source>
        <translation>Њен други крај, у координатама света</translation>
    </message>
    <message>
        <source>Jitter</source>
        <translation>Подрхтавање</translation>
    </message>
    <message>
        <source>Kind of light</source>
        <translation>Врста светла</translation>
    </message>
    <message>
        <source>Lamp at a point</source>
        <translation>Лампа у тачки</translation>
    </message>
    <message>
        <source>Largest disc on 35-mm film that passes for a point: 0.03 mm is usual</source>
        <translation>Највећи диск на филму од 35 mm који пролази као тачка: уобичајено је 0.03 mm</translation>
    </message>
    <message>
        <source>Lens and focus</source>
        <translation>Објектив и фокус</translation>
    </message>
    <message>
        <source>Letter F</source>
        <translation>Слово F</translation>
    </message>
    <message>
        <source>Level of detail</source>
        <translation>Ниво детаљности</translation>
    </message>
    <message>
        <source>Light L</source>
        <translation>Светло L</translation>
    </message>
    <message>
        <source>Light enters a dark box through a small hole. The rays cross there, so the picture on the film behind the hole is upside down and left for right: h&apos; = −d·h/z. The synthetic camera has its centre in place of the hole, and its film at the same distance in front of it. The image has the same size, but it is upright: only the sign changes.</source>
        <translation>Светлост улази у мрачну кутију кроз малу рупу. Зраци се ту укрштају, па је слика на филму иза рупе наопачке и са замењеним лево и десно: h&apos; = −d·h/z. Синтетичка камера има центар на месту рупе, а филм на истом растојању испред ње. Слика је исте величине, али усправна: мења се само предзнак.</translation>
    </message>
    <message>
        <source>Logarithm</source>
        <translation>Логаритам</translation>
    </message>
    <message>
        <source>Lower it below the top of the F.</source>
        <translation>Спустите је испод врха слова F.</translation>
    </message>
    <message>
        <source>Make N small: how much stays sharp?</source>
        <translation>Узмите мало N: колико остаје оштро?</translation>
    </message>
    <message>
        <source>Make d negative: what turns over?</source>
        <translation>Узмите негативно d: шта се преокреће?</translation>
    </message>
    <message>
        <source>Make near larger: do they spread out?</source>
        <translation>Удаљите предњу раван: размичу ли се?</translation>
    </message>
    <message>
        <source>Measure from the object: is it smooth?</source>
        <translation>Мерите од објекта: је ли глатко?</translation>
    </message>
    <message>
        <source>Monitor: 30° across</source>
        <translation>Монитор: 30° у ширину</translation>
    </message>
    <message>
        <source>Move far in: which posts are gone?</source>
        <translation>Приближите задњу раван: који стубови нестају?</translation>
    </message>
    <message>
        <source>Move near and far close to it.</source>
        <translation>Приближите му предњу и задњу раван.</translation>
    </message>
    <message>
        <source>Move near and far past the points.</source>
        <translation>Померите предњу и задњу раван преко тачака.</translation>
    </message>
    <message>
        <source>Move near and far: which cards cross?</source>
        <translation>Померите предњу и задњу раван: које картице их секу?</translation>
    </message>
    <message>
        <source>Moves the eye; the field of view keeps the sizes at the target&apos;s distance</source>
        <translation>Помера камеру; видно поље задржава величине на растојању циља</translation>
    </message>
    <message>
        <source>Nothing beyond the far plane is drawn: on a drive along the avenue, trees appear out of nothing, or vanish into it on the way back. Fog hides this if little contrast is left at the far plane. Level of detail draws far trees with fewer vertices, so that the far plane can be farther away at the same cost.</source>
        <translation>Ништа иза задње равни се не црта: током вожње алејом дрвеће искаче ни из чега, или на путу назад у ништа нестаје. Магла то скрива ако код задње равни остаје мало контраста. Нивои детаљности цртају далеко дрвеће са мање темена, па задња раван може бити даље по истој цени.</translation>
    </message>
    <message>
        <source>Number of parts into which each side of the board is cut</source>
        <translation>Број делова на које се дели свака ивица табле</translation>
    </message>
    <message>
        <source>Number of pieces of equal length into which the floor is cut from near to far</source>
        <translation>Број једнако дугачких делова на које се под дели од предње до задње равни</translation>
    </message>
    <message>
        <source>Numbers</source>
        <translation>Бројеви</translation>
    </message>
    <message>
        <source>Oblique box (oblique)</source>
        <translation>Коси паралелепипед (коси)</translation>
    </message>
    <message>
        <source>Oblique drawing</source>
        <translation>Коси цртеж</translation>
    </message>
    <message>
        <source>Off-axis frusta</source>
        <translation>Пирамиде ван осе</translation>
    </message>
    <message>
        <source>Off-axis window</source>
        <translation>Прозор ван осе</translation>
    </message>
    <message>
        <source>One end of the segment, in world coordinates</source>
        <translation>Један крај дужи, у координатама света</translation>
    </message>
    <message>
        <source>One window</source>
        <translation>Један прозор</translation>
    </message>
    <message>
        <source>One window, or a wall of two screens side by side</source>
        <translation>Један прозор, или зид од два екрана један поред другог</translation>
    </message>
    <message>
        <source>Only parts between light and plane cast a shadow; without clipping, parts above the light cast an anti-shadow, with w &lt; 0</source>
        <translation>Сенку бацају само делови између светла и равни; без одсецања делови изнад светла бацају антисенку, са w &lt; 0</translation>
    </message>
    <message>
        <source>Only what lies in the view volume is drawn. An eye sees a truncated cone. A perspective lens uses the pyramid around it, because a picture is a rectangle. A parallel lens has a box, straight or oblique: the view from very far away. A test point with a grey name is outside.</source>
        <translation>Црта се само оно што лежи у запремини погледа. Око види зарубљену купу. Перспективни објектив користи пирамиду око ње, јер је слика правоугаоник. Паралелни објектив има квадар или коси паралелепипед: поглед са веома велике удаљености. Пробна тачка са сивим именом је изван.</translation>
    </message>
    <message>
        <source>P = (1 − t)·C + t·(D : 0): at the corner C for t = 0, at infinity for t = 1; above 1 it comes back from the other side</source>
        <translation>P = (1 − t)·C + t·(D : 0): у темену C за t = 0, у бесконачности за t = 1; изнад 1 враћа се са друге стране</translation>
    </message>
    <message>
        <source>P appears</source>
        <translation>P се појављује</translation>
    </message>
    <message>
        <source>P is not in front of the eye, so it has no pixel</source>
        <translation>P није испред камере, па нема пиксел</translation>
    </message>
    <message>
        <source>P runs along</source>
        <translation>P иде дуж</translation>
    </message>
    <message>
        <source>P&apos;s image is at infinity</source>
        <translation>Слика тачке P је у бесконачности</translation>
    </message>
    <message>
        <source>Parallel edges of the world meet in the image at the vanishing point of their direction. It lies where the ray from the eye in that direction meets the picture. A direction parallel to the picture has no vanishing point, so a box has one, two or three. As w of the point P goes to 0, P goes to infinity, and its image to the vanishing point.</source>
        <translation>Паралелне ивице света секу се на слици у тачки недогледа свог смера. Она лежи тамо где зрак из позиције камере у том смеру сече слику. Смер паралелан слици нема тачку недогледа, па их кутија има једну, две или три. Када w тачке P тежи 0, P иде у бесконачност, а њена слика у тачку недогледа.</translation>
    </message>
    <message>
        <source>Parts a side</source>
        <translation>Делова по ивици</translation>
    </message>
    <message>
        <source>Perspective</source>
        <translation>Перспектива</translation>
    </message>
    <message>
        <source>Perspective-correct interpolation</source>
        <translation>Перспективно исправна интерполација</translation>
    </message>
    <message>
        <source>Phone: 5° across</source>
        <translation>Телефон: 5° у ширину</translation>
    </message>
    <message>
        <source>Photograph: 105 mm at 360 cm</source>
        <translation>Фотографија: 105 mm са 360 cm</translation>
    </message>
    <message>
        <source>Photograph: 29 mm at 30 cm</source>
        <translation>Фотографија: 29 mm са 30 cm</translation>
    </message>
    <message>
        <source>Picture</source>
        <translation>Слика</translation>
    </message>
    <message>
        <source>Pictures</source>
        <translation>Слике</translation>
    </message>
    <message>
        <source>Pieces of the floor</source>
        <translation>Делови пода</translation>
    </message>
    <message>
        <source>Planar shadow</source>
        <translation>Сенка на равни</translation>
    </message>
    <message>
        <source>Plane distance d</source>
        <translation>Растојање равни d</translation>
    </message>
    <message>
        <source>Planes that have cut</source>
        <translation>Равни које су одсекле</translation>
    </message>
    <message>
        <source>Play the drive: where do trees appear?</source>
        <translation>Пустите вожњу: где се дрвеће појављује?</translation>
    </message>
    <message>
        <source>Play the frames.</source>
        <translation>Пустите кадрове.</translation>
    </message>
    <message>
        <source>Play “From orthographic”.</source>
        <translation>Пустите „Од ортографског”.</translation>
    </message>
    <message>
        <source>Point P</source>
        <translation>Тачка P</translation>
    </message>
    <message>
        <source>Popping at the far plane</source>
        <translation>Искакање на задњој равни</translation>
    </message>
    <message>
        <source>Position</source>
        <translation>Позиција</translation>
    </message>
    <message>
        <source>Position of the lamp in world coordinates, or the direction to the sun</source>
        <translation>Позиција лампе у координатама света, или смер ка сунцу</translation>
    </message>
    <message>
        <source>Pyramid (perspective)</source>
        <translation>Пирамида (перспектива)</translation>
    </message>
    <message>
        <source>Ray times depth</source>
        <translation>Зрак пута дубина</translation>
    </message>
    <message>
        <source>Receding angle</source>
        <translation>Угао дубине</translation>
    </message>
    <message>
        <source>Reciprocal 1/w</source>
        <translation>Реципрочна вредност 1/w</translation>
    </message>
    <message>
        <source>Red-cyan, for glasses</source>
        <translation>Црвено-цијан, за наочаре</translation>
    </message>
    <message>
        <source>Renormalise: which numbers stay?</source>
        <translation>Нормирајте поново: који бројеви остају?</translation>
    </message>
    <message>
        <source>Reverse the depth range: why is it better?</source>
        <translation>Обрните опсег дубине: зашто је боље?</translation>
    </message>
    <message>
        <source>Rounds</source>
        <translation>Кругови</translation>
    </message>
    <message>
        <source>Row of posts</source>
        <translation>Ред стубова</translation>
    </message>
    <message>
        <source>S = (p·L) I − L pᵀ, plane p = (0, 1, 0, {0}), L = ({1}, {2}, {3}, 0): the direction divided by its largest part, {4}</source>
        <translation>S = (p·L) I − L pᵀ, раван p = (0, 1, 0, {0}), L = ({1}, {2}, {3}, 0): смер подељен својом највећом компонентом, {4}</translation>
    </message>
    <message>
        <source>S = (p·L) I − L pᵀ, plane p = (0, 1, 0, {0}), L = ({1}, {2}, {3}, 1)</source>
        <translation>S = (p·L) I − L pᵀ, раван p = (0, 1, 0, {0}), L = ({1}, {2}, {3}, 1)</translation>
    </message>
    <message>
        <source>Screen plane</source>
        <translation>Раван екрана</translation>
    </message>
    <message>
        <source>Screens</source>
        <translation>Екрани</translation>
    </message>
    <message>
        <source>Seen by</source>
        <translation>Чиме се гледа</translation>
    </message>
    <message>
        <source>Set far to 1000: how far off is the floor?</source>
        <translation>Поставите задњу раван на 1000: колико под одступа?</translation>
    </message>
    <message>
        <source>Set far to 60: does it help as much?</source>
        <translation>Поставите задњу раван на 60: помаже ли једнако?</translation>
    </message>
    <message>
        <source>Set near to 0.1: what improves?</source>
        <translation>Поставите предњу раван на 0.1: шта је боље?</translation>
    </message>
    <message>
        <source>Side by side</source>
        <translation>Једна поред друге</translation>
    </message>
    <message>
        <source>Similar triangles</source>
        <translation>Слични троуглови</translation>
    </message>
    <message>
        <source>Simpler from</source>
        <translation>Простије преко</translation>
    </message>
    <message>
        <source>Simplest from</source>
        <translation>Најпростије преко</translation>
    </message>
    <message>
        <source>Snapping</source>
        <translation>Приањање</translation>
    </message>
    <message>
        <source>Start A</source>
        <translation>Почетак A</translation>
    </message>
    <message>
        <source>Step on: which plane adds a corner?</source>
        <translation>Идите даље: која раван додаје теме?</translation>
    </message>
    <message>
        <source>Stop clipping: on which side is a shadow?</source>
        <translation>Престаните да одсецате: са које је стране сенка?</translation>
    </message>
    <message>
        <source>Sun</source>
        <translation>Сунце</translation>
    </message>
    <message>
        <source>Surface 2 lies behind surface 1 by the gap, and reaches out at its side. Where the depth buffer stores both with the same code, the surface that is drawn last is seen: z-fighting. With a perspective lens and the standard range most codes lie just behind near, so near matters much more than far. When the scene opens, with its ramp, 63 % of the pixels that both cover are wrong, 0 % with near 0.1, 63 % with far 60. The picture tells codes of up to 24 bits apart exactly.</source>
        <translation>Површ 2 лежи иза површи 1 на датом размаку, и вири са њене стране. Где бафер дубине обе чува под истим кодом, види се површ која је нацртана последња: борба за z (z-fighting). Са перспективним објективом и стандардним опсегом већина кодова лежи одмах иза предње равни, па је она много важнија од задње. Када се сцена отвори, са својом рампом, погрешно је 63 % пиксела које обе покривају, 0 % са предњом равни на 0.1, 63 % са задњом равни на 60. Слика тачно разликује кодове до 24 бита.</translation>
    </message>
    <message>
        <source>Switch the detail on: what is saved?</source>
        <translation>Укључите детаљност: шта се штеди?</translation>
    </message>
    <message>
        <source>Texture</source>
        <translation>Текстура</translation>
    </message>
    <message>
        <source>The direction D of the edge that P follows</source>
        <translation>Смер D ивице коју P следи</translation>
    </message>
    <message>
        <source>The eye moves to the right by 1 mm a frame, and a unit is 1 m. Far from the origin neighbouring float32 numbers are farther apart than that: the eye stands still for some frames and then jumps, and every vertex jumps with it. In the picture each frame has its own line, from top to bottom: how far P has moved across, enlarged, and pale beside it the smooth path. It helps to measure from a place nearby, or to store each coordinate in two floats.</source>
        <translation>Камера се помера удесно за 1 mm по кадру, а јединица је 1 m. Далеко од координатног почетка суседни бројеви типа float32 размакнутији су од тога: камера неколико кадрова стоји па скочи, и свако теме скочи са њом. На слици сваки кадар има свој ред, одозго надоле: колико се P померила попреко, увећано, а поред тога бледо глатка путања. Помаже да се мери од неког блиског места, или да се свака координата чува као два броја у покретном зарезу.</translation>
    </message>
    <message>
        <source>The f-number: the lens is opened to f / N, and no lens opens wider than f / 0.5</source>
        <translation>Бленда: објектив је отворен на f / N, и ниједан објектив се не отвара шире од f / 0.5</translation>
    </message>
    <message>
        <source>The faces with AB over them, or the edges alone, drawn in one of the three ways</source>
        <translation>Стране са AB преко њих, или само ивице, нацртане на један од три начина</translation>
    </message>
    <message>
        <source>The format of every number, sum, product and quotient</source>
        <translation>Формат сваког броја, збира, производа и количника</translation>
    </message>
    <message>
        <source>The format of every sum, product and quotient</source>
        <translation>Формат сваког збира, производа и количника</translation>
    </message>
    <message>
        <source>The format of every sum, product and root</source>
        <translation>Формат сваког збира, производа и корена</translation>
    </message>
    <message>
        <source>The grid of the pixels at which vertices are drawn</source>
        <translation>Решетка пиксела на којој се темена цртају</translation>
    </message>
    <message>
        <source>The grid on which the vertices of a mesh are stored</source>
        <translation>Решетка на којој се чувају темена мреже</translation>
    </message>
    <message>
        <source>The point whose pixel and depth are known; a click in the image chooses it</source>
        <translation>Тачка чији су пиксел и дубина познати; бира је клик на слику</translation>
    </message>
    <message>
        <source>The point whose places are compared: parallax is that in the right picture minus that in the left one</source>
        <translation>Тачка чија се места пореде: паралакса је место на десној слици минус место на левој</translation>
    </message>
    <message>
        <source>The point whose projector is followed</source>
        <translation>Тачка чији се зрак пројекције прати</translation>
    </message>
    <message>
        <source>The synthetic camera has a point as its lens, and its whole picture is sharp. A real lens draws only points at the focal distance as points, and all others as discs. Between the two limits the discs are no larger than the circle of confusion and pass for points: sharp posts are outlined. The picture is the average of pinhole pictures from all over the lens, and becomes finer while nothing changes. One world unit is 1 m.</source>
        <translation>Синтетичка камера за објектив има тачку, и цела њена слика је оштра. Прави објектив као тачке црта само тачке на растојању фокуса, а све остале као дискове. Између две границе дискови нису већи од кружића неоштрине и пролазе као тачке: оштри стубови су уоквирени. Слика је просек слика тачкасте камере са целог објектива, и постаје све финија док се ништа не мења. Једна јединица света је 1 m.</translation>
    </message>
    <message>
        <source>Toe the cameras in: is P still level?</source>
        <translation>Закрените камере ка средини: је ли P и даље на истој висини?</translation>
    </message>
    <message>
        <source>Toed in</source>
        <translation>Закренуте ка средини</translation>
    </message>
    <message>
        <source>Turn the azimuth: when is V at infinity?</source>
        <translation>Мењајте азимут: када је V у бесконачности?</translation>
    </message>
    <message>
        <source>Turn the camera slowly: what jumps?</source>
        <translation>Окрећите камеру полако: шта скаче?</translation>
    </message>
    <message>
        <source>Turned by</source>
        <translation>Окретање</translation>
    </message>
    <message>
        <source>Turns the camera about its target</source>
        <translation>Окреће камеру око њеног циља</translation>
    </message>
    <message>
        <source>Two eyes</source>
        <translation>Два ока</translation>
    </message>
    <message>
        <source>Two eyes see the world from two places, and so a stereo pair has two pictures. With off-axis frusta both eyes look through one window, the screen plane: what lies in it does not move between the pictures, what is behind it moves right, and what is before it moves left. Cameras that are toed in to the screen&apos;s middle tilt their pictures against each other, and points at the sides are no longer equally high. A red-cyan picture takes its red light from the left eye&apos;s and the rest from the right eye&apos;s, for glasses with red on the left.</source>
        <translation>Два ока виде свет са два места, па стереопар има две слике. Са пирамидама ван осе оба ока гледају кроз један прозор, раван екрана: оно што у њој лежи не помера се између слика, оно што је иза ње помера се удесно, а оно што је испред ње улево. Камере закренуте ка средини екрана нагињу своје слике једну према другој, и тачке са стране више нису на истој висини. Црвено-цијан слика узима црвену светлост из слике левог ока, а остало из слике десног, за наочаре са црвеним стаклом лево.</translation>
    </message>
    <message>
        <source>Two meshes share a seam. Each stores its vertices in few bits over its own box, and so rounds the same place in its own way: light comes through. The gap is at most half of both steps together along each axis. In a common grid both round alike, and nothing gapes, though the smaller mesh loses its finer steps.</source>
        <translation>Две мреже деле шав. Свака чува своја темена са мало битова у сопственом оквиру, па исто место заокружује на свој начин: светлост пролази. Процеп је по свакој оси највише половина збира оба корака. У заједничкој решетки обе заокружују једнако и ништа не зјапи, мада мања мрежа губи своје финије кораке.</translation>
    </message>
    <message>
        <source>Unit cube</source>
        <translation>Јединична коцка</translation>
    </message>
    <message>
        <source>Up to which frame the path is drawn</source>
        <translation>До ког кадра се црта путања</translation>
    </message>
    <message>
        <source>V_x of edges along x</source>
        <translation>V_x ивица дуж x</translation>
    </message>
    <message>
        <source>V_y of edges along y</source>
        <translation>V_y ивица дуж y</translation>
    </message>
    <message>
        <source>V_z of edges along z</source>
        <translation>V_z ивица дуж z</translation>
    </message>
    <message>
        <source>V_{0} is at infinity: edges along {0} stay parallel, at {1}° from the right</source>
        <translation>V_{0} је у бесконачности: ивице дуж {0} остају паралелне, под {1}° од десне стране</translation>
    </message>
    <message>
        <source>Vanishing points</source>
        <translation>Тачке недогледа</translation>
    </message>
    <message>
        <source>Vertices</source>
        <translation>Темена</translation>
    </message>
    <message>
        <source>View volume</source>
        <translation>Запремина погледа</translation>
    </message>
    <message>
        <source>View volumes</source>
        <translation>Запремине погледа</translation>
    </message>
    <message>
        <source>Walk past the window: drag the eye.</source>
        <translation>Прођите поред прозора: превуците камеру.</translation>
    </message>
    <message>
        <source>Walk round it: drag the azimuth.</source>
        <translation>Обиђите је: превуците азимут.</translation>
    </message>
    <message>
        <source>Way back</source>
        <translation>Пут назад</translation>
    </message>
    <message>
        <source>What does cutting before the divide do?</source>
        <translation>Шта чини сечење пре дељења?</translation>
    </message>
    <message>
        <source>What happens in the cube?</source>
        <translation>Шта се дешава у коцки?</translation>
    </message>
    <message>
        <source>What happens to its shape in the cube?</source>
        <translation>Шта бива са његовим обликом у коцки?</translation>
    </message>
    <message>
        <source>What happens to the picture?</source>
        <translation>Шта бива са сликом?</translation>
    </message>
    <message>
        <source>What stays in its place in the image?</source>
        <translation>Шта на слици остаје на свом месту?</translation>
    </message>
    <message>
        <source>When is everything far away sharp?</source>
        <translation>Када је све далеко оштро?</translation>
    </message>
    <message>
        <source>Where do both pictures agree?</source>
        <translation>Где се обе слике слажу?</translation>
    </message>
    <message>
        <source>Where does the texture bend?</source>
        <translation>Где се текстура прелама?</translation>
    </message>
    <message>
        <source>Where in the cube do the posts crowd?</source>
        <translation>Где се у коцки стубови згусну?</translation>
    </message>
    <message>
        <source>Where it ends; behind the eye its image is mirrored</source>
        <translation>Где се завршава; иза камере његова слика је као у огледалу</translation>
    </message>
    <message>
        <source>Where the logarithm of the distance is computed</source>
        <translation>Где се рачуна логаритам растојања</translation>
    </message>
    <message>
        <source>Where the segment starts, in world coordinates</source>
        <translation>Где дуж почиње, у координатама света</translation>
    </message>
    <message>
        <source>Which edges are parallel in the picture?</source>
        <translation>Које ивице су на слици паралелне?</translation>
    </message>
    <message>
        <source>Which edges meet, and where?</source>
        <translation>Које ивице се секу, и где?</translation>
    </message>
    <message>
        <source>Which faces keep their shape?</source>
        <translation>Које стране задржавају облик?</translation>
    </message>
    <message>
        <source>Which of A to E are inside now?</source>
        <translation>Које су од A до E сада унутра?</translation>
    </message>
    <message>
        <source>Which parts grow when you come near?</source>
        <translation>Који делови расту када приђете ближе?</translation>
    </message>
    <message>
        <source>Which way does the frustum lean?</source>
        <translation>На коју страну се пирамида нагиње?</translation>
    </message>
    <message>
        <source>Width of the left mesh</source>
        <translation>Ширина леве мреже</translation>
    </message>
    <message>
        <source>Width of the left mesh&apos;s box, whose steps grow with it</source>
        <translation>Ширина оквира леве мреже, са којом расту његови кораци</translation>
    </message>
    <message>
        <source>Width of the right mesh</source>
        <translation>Ширина десне мреже</translation>
    </message>
    <message>
        <source>Width of the right mesh&apos;s box, whose steps grow with it</source>
        <translation>Ширина оквира десне мреже, са којом расту његови кораци</translation>
    </message>
    <message>
        <source>With a wider field of view the camera must be nearer to show the subject at the same size. Its near parts then look larger compared with its far parts: foreshortening depends on the distance alone. If you change the distance, the field of view follows, so that things at the target&apos;s distance keep their size (a dolly zoom). One unit is 10 cm.</source>
        <translation>Са ширим видним пољем камера мора бити ближе да би предмет био једнако велик. Његови ближи делови тада изгледају већи у односу на даље: скраћење зависи само од растојања. Ако промените растојање, видно поље га прати, тако да оно што је на растојању циља задржи величину (доли-зум). Једна јединица је 10 cm.</translation>
    </message>
    <message>
        <source>World y of the plane; at most 0, where the object stands</source>
        <translation>y равни у свету; највише 0, где стоји објекат</translation>
    </message>
    <message>
        <source>Your mesh</source>
        <translation>Ваша мрежа</translation>
    </message>
    <message>
        <source>a corner is behind the eye: until near has cut, there is nothing to draw in NDC</source>
        <translation>једно теме је иза камере: док предња раван не одсече, у NDC нема шта да се црта</translation>
    </message>
    <message>
        <source>a logarithmic depth buffer needs a perspective lens and a far plane that is not at infinity</source>
        <translation>логаритамском баферу дубине потребан је перспективни објектив и задња раван која није у бесконачности</translation>
    </message>
    <message>
        <source>a logarithmic depth needs a far plane that is not at infinity</source>
        <translation>логаритамској дубини потребна је задња раван која није у бесконачности</translation>
    </message>
    <message>
        <source>a parallel lens cannot have its far plane at infinity</source>
        <translation>паралелни објектив не може да има задњу раван у бесконачности</translation>
    </message>
    <message>
        <source>a parallel lens divides by 1 and has no eye plane: choose a perspective lens</source>
        <translation>паралелни објектив дели са 1 и нема раван камере: изаберите перспективни објектив</translation>
    </message>
    <message>
        <source>a parallel lens divides by 1: its own z&apos; is affine, and nothing is bent</source>
        <translation>паралелни објектив дели са 1: његово z&apos; је и само афино, и ништа се не савија</translation>
    </message>
    <message>
        <source>a parallel lens has no eye in which a cone could start: its own volume is shown</source>
        <translation>паралелни објектив нема позицију камере у којој би купа почела: приказује се његова сопствена запремина</translation>
    </message>
    <message>
        <source>a parallel lens has no field of view, only a width</source>
        <translation>паралелни објектив нема видно поље, само ширину</translation>
    </message>
    <message>
        <source>a parallel lens has no focal length: choose a perspective lens to focus it</source>
        <translation>паралелни објектив нема жижну даљину: изаберите перспективни објектив да бисте га фокусирали</translation>
    </message>
    <message>
        <source>a parallel lens has no hole through which all light passes: choose a perspective lens</source>
        <translation>паралелни објектив нема рупу кроз коју пролази сва светлост: изаберите перспективни објектив</translation>
    </message>
    <message>
        <source>a perspective lens draws equal edges with unequal lengths: choose the oblique lens</source>
        <translation>перспективни објектив једнаке ивице црта у различитим дужинама: изаберите коси објектив</translation>
    </message>
    <message>
        <source>a step is so long that it may lead past the eye: there is no bound</source>
        <translation>корак је толико дугачак да можда води поред камере: границе нема</translation>
    </message>
    <message>
        <source>a vertex of the picture has come behind the drifted camera</source>
        <translation>једно теме слике доспело је иза занете камере</translation>
    </message>
    <message>
        <source>affine</source>
        <translation>афино</translation>
    </message>
    <message>
        <source>affine: s linear on the screen</source>
        <translation>афино: s линеарно на екрану</translation>
    </message>
    <message>
        <source>all</source>
        <translation>све</translation>
    </message>
    <message>
        <source>an axis is too long or too short by up to</source>
        <translation>оса је предугачка или прекратка и до</translation>
    </message>
    <message>
        <source>an axis leans by up to</source>
        <translation>оса се нагиње и до</translation>
    </message>
    <message>
        <source>arrows in the image, enlarged</source>
        <translation>стрелице на слици, увећане</translation>
    </message>
    <message>
        <source>as drawn</source>
        <translation>како је нацртано</translation>
    </message>
    <message>
        <source>at each pixel</source>
        <translation>у сваком пикселу</translation>
    </message>
    <message>
        <source>at each vertex</source>
        <translation>у сваком темену</translation>
    </message>
    <message>
        <source>axis</source>
        <translation>оса</translation>
    </message>
    <message>
        <source>before the screen</source>
        <translation>испред екрана</translation>
    </message>
    <message>
        <source>behind the screen</source>
        <translation>иза екрана</translation>
    </message>
    <message>
        <source>bfloat16</source>
        <translation>bfloat16</translation>
    </message>
    <message>
        <source>blur disc</source>
        <translation>диск неоштрине</translation>
    </message>
    <message>
        <source>blur disc on the film</source>
        <translation>диск неоштрине на филму</translation>
    </message>
    <message>
        <source>blur of the target</source>
        <translation>неоштрина циља</translation>
    </message>
    <message>
        <source>both agree only if the lens&apos;s axis meets the middle of the picture; here it meets ({0}, {1}) px, and their sum is twice that</source>
        <translation>оба се слажу само ако оса објектива погађа средину слике; овде погађа ({0}, {1}) px, а њихов збир је двапут толико</translation>
    </message>
    <message>
        <source>bottom</source>
        <translation>доња</translation>
    </message>
    <message>
        <source>bound of the error</source>
        <translation>граница грешке</translation>
    </message>
    <message>
        <source>bytes a vertex</source>
        <translation>бајтова по темену</translation>
    </message>
    <message>
        <source>cards crossing: to be cut</source>
        <translation>картице које секу границу: за одсецање</translation>
    </message>
    <message>
        <source>cards outside</source>
        <translation>картице изван</translation>
    </message>
    <message>
        <source>cards whole inside</source>
        <translation>картице целе унутра</translation>
    </message>
    <message>
        <source>case, by the cut at z = −0.01</source>
        <translation>случај, по сечењу на z = −0.01</translation>
    </message>
    <message>
        <source>cheap</source>
        <translation>јефтино</translation>
    </message>
    <message>
        <source>checks</source>
        <translation>шаховница</translation>
    </message>
    <message>
        <source>circle of confusion</source>
        <translation>кружић неоштрине</translation>
    </message>
    <message>
        <source>clip coordinates are too large for float64 numbers, or lie on one ray of the eye</source>
        <translation>координате одсецања су превелике за бројеве float64, или леже на једном зраку из камере</translation>
    </message>
    <message>
        <source>clipped</source>
        <translation>одсечено</translation>
    </message>
    <message>
        <source>clipped, then divided</source>
        <translation>одсечено, па подељено</translation>
    </message>
    <message>
        <source>codes of the buffer</source>
        <translation>кодови бафера</translation>
    </message>
    <message>
        <source>common grid</source>
        <translation>заједничка решетка</translation>
    </message>
    <message>
        <source>computed: gap and codes are finer than the graphics card&apos;s float32, so the picture shows its noise instead</source>
        <translation>израчунато: размак и кодови су ситнији од float32 графичке картице, па слика уместо тога показује њен шум</translation>
    </message>
    <message>
        <source>contrast left where they pop</source>
        <translation>преостали контраст тамо где искачу</translation>
    </message>
    <message>
        <source>corners after it</source>
        <translation>темена после ње</translation>
    </message>
    <message>
        <source>corners before it</source>
        <translation>темена пре ње</translation>
    </message>
    <message>
        <source>correct</source>
        <translation>исправно</translation>
    </message>
    <message>
        <source>correct: s/w and 1/w, divided</source>
        <translation>исправно: s/w и 1/w, подељени</translation>
    </message>
    <message>
        <source>cut</source>
        <translation>исечено</translation>
    </message>
    <message>
        <source>cut at z = −0.01</source>
        <translation>исечено на z = −0.01</translation>
    </message>
    <message>
        <source>d over w, 32 of the codes</source>
        <translation>d према w, 32 кода</translation>
    </message>
    <message>
        <source>depth of field</source>
        <translation>дубина видног поља</translation>
    </message>
    <message>
        <source>depth z&apos; = A + B/z along the marked edge is, too</source>
        <translation>и дубина z&apos; = A + B/z је дуж обележене ивице права</translation>
    </message>
    <message>
        <source>diameter, mm</source>
        <translation>пречник, mm</translation>
    </message>
    <message>
        <source>distance d to the target</source>
        <translation>растојање d до циља</translation>
    </message>
    <message>
        <source>distance of the target, w</source>
        <translation>растојање циља, w</translation>
    </message>
    <message>
        <source>distance, m</source>
        <translation>растојање, m</translation>
    </message>
    <message>
        <source>divided, not cut</source>
        <translation>подељено, неисечено</translation>
    </message>
    <message>
        <source>drawn at</source>
        <translation>нацртано на</translation>
    </message>
    <message>
        <source>drawn by P V, off by</source>
        <translation>нацртано са P V, одступа за</translation>
    </message>
    <message>
        <source>drawn by V, then P, off by</source>
        <translation>нацртано са V, па P, одступа за</translation>
    </message>
    <message>
        <source>drawn floor</source>
        <translation>нацртани под</translation>
    </message>
    <message>
        <source>drift drawn, enlarged</source>
        <translation>нацртано заношење, увећано</translation>
    </message>
    <message>
        <source>each camera turns in by</source>
        <translation>свака камера је закренута за</translation>
    </message>
    <message>
        <source>each mesh its own</source>
        <translation>свака мрежа своја</translation>
    </message>
    <message>
        <source>each pixel</source>
        <translation>сваки пиксел</translation>
    </message>
    <message>
        <source>each vertex</source>
        <translation>свако теме</translation>
    </message>
    <message>
        <source>edges along {0} are seen end on, as points</source>
        <translation>ивице дуж {0} виде се с краја, као тачке</translation>
    </message>
    <message>
        <source>edges of the mesh that are counted, and all</source>
        <translation>ивице мреже које се броје, и све</translation>
    </message>
    <message>
        <source>error of P</source>
        <translation>грешка тачке P</translation>
    </message>
    <message>
        <source>error of a jump, measured</source>
        <translation>грешка скока, измерена</translation>
    </message>
    <message>
        <source>error of a jump, predicted</source>
        <translation>грешка скока, предвиђена</translation>
    </message>
    <message>
        <source>error of the join</source>
        <translation>грешка споја</translation>
    </message>
    <message>
        <source>error, of the distance</source>
        <translation>грешка, од растојања</translation>
    </message>
    <message>
        <source>error, px</source>
        <translation>грешка, px</translation>
    </message>
    <message>
        <source>every vertex is as high as the light or higher: none has a shadow on the plane</source>
        <translation>свако теме је високо колико и светло, или више: ниједно нема сенку на равни</translation>
    </message>
    <message>
        <source>everything from the target to the far plane may share its code</source>
        <translation>све од циља до задње равни може да дели исти код</translation>
    </message>
    <message>
        <source>exact</source>
        <translation>тачно</translation>
    </message>
    <message>
        <source>exponential, by its density</source>
        <translation>експоненцијална, по густини</translation>
    </message>
    <message>
        <source>faces, with both images of AB</source>
        <translation>стране, са обе слике AB</translation>
    </message>
    <message>
        <source>far</source>
        <translation>задња</translation>
    </message>
    <message>
        <source>far is infinite, and so is the volume</source>
        <translation>задња раван је у бесконачности, па је и запремина бесконачна</translation>
    </message>
    <message>
        <source>farthest</source>
        <translation>најдаље</translation>
    </message>
    <message>
        <source>farthest that a vertex of the right seam moves</source>
        <translation>највећи помак темена на десном шаву</translation>
    </message>
    <message>
        <source>fast root</source>
        <translation>брзи корен</translation>
    </message>
    <message>
        <source>film</source>
        <translation>филм</translation>
    </message>
    <message>
        <source>film in front: +d·h / z</source>
        <translation>филм испред: +d·h / z</translation>
    </message>
    <message>
        <source>fixed point 16.16</source>
        <translation>непокретни зарез 16.16</translation>
    </message>
    <message>
        <source>float of 16 bits</source>
        <translation>покретни зарез од 16 бита</translation>
    </message>
    <message>
        <source>float of 32 bits</source>
        <translation>покретни зарез од 32 бита</translation>
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
        <translation>float32, далеко од нуле</translation>
    </message>
    <message>
        <source>float32, from the object</source>
        <translation>float32, од објекта</translation>
    </message>
    <message>
        <source>float32, from the origin</source>
        <translation>float32, од координатног почетка</translation>
    </message>
    <message>
        <source>float64</source>
        <translation>float64</translation>
    </message>
    <message>
        <source>floor</source>
        <translation>под</translation>
    </message>
    <message>
        <source>focal length f</source>
        <translation>жижна даљина f</translation>
    </message>
    <message>
        <source>focal length, 35-mm camera</source>
        <translation>жижна даљина, фотоапарат за филм од 35 mm</translation>
    </message>
    <message>
        <source>foreshortening, nearest : farthest</source>
        <translation>скраћење, најближе : најдаље</translation>
    </message>
    <message>
        <source>found point</source>
        <translation>нађена тачка</translation>
    </message>
    <message>
        <source>foundation</source>
        <translation>темељ</translation>
    </message>
    <message>
        <source>frame size minus right end</source>
        <translation>величина кадра минус десни крај</translation>
    </message>
    <message>
        <source>frames in which P stands still</source>
        <translation>кадрови у којима P мирује</translation>
    </message>
    <message>
        <source>from P to V</source>
        <translation>од P до V</translation>
    </message>
    <message>
        <source>from there to the ray&apos;s end</source>
        <translation>одатле до краја зрака</translation>
    </message>
    <message>
        <source>half floats</source>
        <translation>половична прецизност</translation>
    </message>
    <message>
        <source>half-way along the marked edge on the screen, in the world, from its nearer end</source>
        <translation>пола пута дуж обележене ивице на екрану, у свету, од ближег краја</translation>
    </message>
    <message>
        <source>hole</source>
        <translation>рупа</translation>
    </message>
    <message>
        <source>horizon</source>
        <translation>хоризонт</translation>
    </message>
    <message>
        <source>horizontal field of view</source>
        <translation>хоризонтално видно поље</translation>
    </message>
    <message>
        <source>horizontal parallax of P</source>
        <translation>хоризонтална паралакса тачке P</translation>
    </message>
    <message>
        <source>hyperfocal distance H</source>
        <translation>хиперфокално растојање H</translation>
    </message>
    <message>
        <source>if w were linear</source>
        <translation>када би w било линеарно</translation>
    </message>
    <message>
        <source>image of AB</source>
        <translation>слика дужи AB</translation>
    </message>
    <message>
        <source>image of P</source>
        <translation>слика тачке P</translation>
    </message>
    <message>
        <source>in focus</source>
        <translation>у&#xa0;фокусу</translation>
    </message>
    <message>
        <source>in its own plane</source>
        <translation>у сопственој равни</translation>
    </message>
    <message>
        <source>in the screen</source>
        <translation>у екрану</translation>
    </message>
    <message>
        <source>inverse of P V</source>
        <translation>инверз од P V</translation>
    </message>
    <message>
        <source>it keeps</source>
        <translation>задржава</translation>
    </message>
    <message>
        <source>its distance z from the hole</source>
        <translation>њено растојање z од рупе</translation>
    </message>
    <message>
        <source>its height in the plane through the target is not in the picture</source>
        <translation>његова висина у равни кроз циљ није на слици</translation>
    </message>
    <message>
        <source>its image is straight, so no place is the farthest</source>
        <translation>његова слика је права, па ниједно место није најдаље</translation>
    </message>
    <message>
        <source>its shadow S·P / w</source>
        <translation>његова сенка S·P / w</translation>
    </message>
    <message>
        <source>its volume, cubic units</source>
        <translation>њена запремина, кубних јединица</translation>
    </message>
    <message>
        <source>join</source>
        <translation>спој</translation>
    </message>
    <message>
        <source>keep x</source>
        <translation>задржи x</translation>
    </message>
    <message>
        <source>keep y</source>
        <translation>задржи y</translation>
    </message>
    <message>
        <source>kind of projection</source>
        <translation>врста пројекције</translation>
    </message>
    <message>
        <source>largest deviation, of the length</source>
        <translation>највеће одступање, од дужине</translation>
    </message>
    <message>
        <source>largest error of affine, in texels of 256</source>
        <translation>највећа грешка афине, у текселима од 256</translation>
    </message>
    <message>
        <source>largest error of affine, on the screen</source>
        <translation>највећа грешка афине, на екрану</translation>
    </message>
    <message>
        <source>largest error, by the format of the vertices</source>
        <translation>највећа грешка, по формату темена</translation>
    </message>
    <message>
        <source>largest error, measured</source>
        <translation>највећа грешка, измерена</translation>
    </message>
    <message>
        <source>largest error, predicted</source>
        <translation>највећа грешка, предвиђена</translation>
    </message>
    <message>
        <source>largest gap, measured</source>
        <translation>највећи процеп, измерен</translation>
    </message>
    <message>
        <source>largest gap, predicted</source>
        <translation>највећи процеп, предвиђен</translation>
    </message>
    <message>
        <source>largest jump of P between two frames</source>
        <translation>највећи скок тачке P између два кадра</translation>
    </message>
    <message>
        <source>largest vertical parallax in the screen plane</source>
        <translation>највећа вертикална паралакса у равни екрана</translation>
    </message>
    <message>
        <source>left</source>
        <translation>лева</translation>
    </message>
    <message>
        <source>left eye</source>
        <translation>лево око</translation>
    </message>
    <message>
        <source>left mesh</source>
        <translation>лева мрежа</translation>
    </message>
    <message>
        <source>left screen</source>
        <translation>леви екран</translation>
    </message>
    <message>
        <source>light</source>
        <translation>светло</translation>
    </message>
    <message>
        <source>linear, from start to end</source>
        <translation>линеарна, од почетка до краја</translation>
    </message>
    <message>
        <source>logarithmic</source>
        <translation>логаритамски</translation>
    </message>
    <message>
        <source>measured</source>
        <translation>измерено</translation>
    </message>
    <message>
        <source>mesh drawn wrongly</source>
        <translation>погрешно нацртани делови мреже</translation>
    </message>
    <message>
        <source>mesh missed</source>
        <translation>делови мреже који недостају</translation>
    </message>
    <message>
        <source>mirrored end</source>
        <translation>крај као у огледалу</translation>
    </message>
    <message>
        <source>naive</source>
        <translation>наивно</translation>
    </message>
    <message>
        <source>naive divide</source>
        <translation>наивно дељење</translation>
    </message>
    <message>
        <source>near</source>
        <translation>предња</translation>
    </message>
    <message>
        <source>nearest</source>
        <translation>најближе</translation>
    </message>
    <message>
        <source>no edge of the letter lies in the view volume</source>
        <translation>ниједна ивица слова не лежи у запремини погледа</translation>
    </message>
    <message>
        <source>no end is behind the eye, so none is mirrored</source>
        <translation>ниједан крај није иза камере, па ниједан није као у огледалу</translation>
    </message>
    <message>
        <source>no lens makes a cone: everything in the pyramid around it is drawn</source>
        <translation>ниједан објектив не прави купу: црта се све у пирамиди око ње</translation>
    </message>
    <message>
        <source>no pixel of the picture shows both surfaces</source>
        <translation>ниједан пиксел слике не показује обе површи</translation>
    </message>
    <message>
        <source>no tree passes the far plane in the picture</source>
        <translation>ниједно дрво на слици не пролази задњу раван</translation>
    </message>
    <message>
        <source>no vertex of the scene is in the picture</source>
        <translation>ниједно теме сцене није на слици</translation>
    </message>
    <message>
        <source>none</source>
        <translation>нема</translation>
    </message>
    <message>
        <source>none of the examined edges of the mesh lies in the view volume</source>
        <translation>ниједна од испитаних ивица мреже не лежи у запремини погледа</translation>
    </message>
    <message>
        <source>none of the subject&apos;s compared points is in the picture</source>
        <translation>ниједна од поређених тачака предмета није на слици</translation>
    </message>
    <message>
        <source>none yet</source>
        <translation>још ниједна</translation>
    </message>
    <message>
        <source>nothing of the subject is in the picture</source>
        <translation>ништа од предмета није на слици</translation>
    </message>
    <message>
        <source>of P: (x, y, z, −z/d)</source>
        <translation>тачке P: (x, y, z, −z/d)</translation>
    </message>
    <message>
        <source>of {0} vertices</source>
        <translation>од {0} темена</translation>
    </message>
    <message>
        <source>off the axis, ({r} + {l})/({r} − {l})</source>
        <translation>ван осе, ({r} + {l})/({r} − {l})</translation>
    </message>
    <message>
        <source>off-axis</source>
        <translation>ван осе</translation>
    </message>
    <message>
        <source>on the film: h&apos; = −d·h / z</source>
        <translation>на филму: h&apos; = −d·h / z</translation>
    </message>
    <message>
        <source>one for both</source>
        <translation>једна за обе</translation>
    </message>
    <message>
        <source>only the {0} longest of the mesh&apos;s {1} edges are drawn and counted</source>
        <translation>цртају се и броје само најдуже ивице мреже: {0} од {1}</translation>
    </message>
    <message>
        <source>only {0} of the mesh&apos;s {1} edges are drawn and counted: first those that cross the eye plane, then the longest</source>
        <translation>цртају се и броје само неке ивице мреже, {0} од {1}: прво оне које секу раван камере, затим најдуже</translation>
    </message>
    <message>
        <source>opening f / N</source>
        <translation>отвор f / N</translation>
    </message>
    <message>
        <source>own boxes</source>
        <translation>сопствени оквири</translation>
    </message>
    <message>
        <source>parallel projection</source>
        <translation>паралелна пројекција</translation>
    </message>
    <message>
        <source>part of the subject is beside the eye or behind it</source>
        <translation>део предмета је поред камере или иза ње</translation>
    </message>
    <message>
        <source>path in the image, enlarged</source>
        <translation>путања на слици, увећана</translation>
    </message>
    <message>
        <source>pixels that show surface 2, which is behind</source>
        <translation>пиксели који показују површ 2, која је иза</translation>
    </message>
    <message>
        <source>plane of this step</source>
        <translation>раван овог корака</translation>
    </message>
    <message>
        <source>predicted</source>
        <translation>предвиђено</translation>
    </message>
    <message>
        <source>products</source>
        <translation>производи</translation>
    </message>
    <message>
        <source>products alone</source>
        <translation>само производи</translation>
    </message>
    <message>
        <source>products, fast inverse root</source>
        <translation>производи, брзи инверзни корен</translation>
    </message>
    <message>
        <source>products, renormalised</source>
        <translation>производи, поново нормирано</translation>
    </message>
    <message>
        <source>projection, with −1/d</source>
        <translation>пројекција, са −1/d</translation>
    </message>
    <message>
        <source>px</source>
        <translation>px</translation>
    </message>
    <message>
        <source>ray times depth</source>
        <translation>зрак пута дубина</translation>
    </message>
    <message>
        <source>receding angle as drawn</source>
        <translation>нацртани угао дубине</translation>
    </message>
    <message>
        <source>receding edges are seen end on, as points</source>
        <translation>ивице по дубини виде се с краја, као тачке</translation>
    </message>
    <message>
        <source>receding scale as drawn</source>
        <translation>нацртана размера дубине</translation>
    </message>
    <message>
        <source>renormalised</source>
        <translation>поново нормирано</translation>
    </message>
    <message>
        <source>reversed, 1 at near</source>
        <translation>обрнуто, 1 на предњој равни</translation>
    </message>
    <message>
        <source>right</source>
        <translation>десна</translation>
    </message>
    <message>
        <source>right eye</source>
        <translation>десно око</translation>
    </message>
    <message>
        <source>right mesh</source>
        <translation>десна мрежа</translation>
    </message>
    <message>
        <source>right screen</source>
        <translation>десни екран</translation>
    </message>
    <message>
        <source>s red, t green</source>
        <translation>s црвено, t зелено</translation>
    </message>
    <message>
        <source>scale d / −z</source>
        <translation>размера d / −z</translation>
    </message>
    <message>
        <source>screen plane</source>
        <translation>раван екрана</translation>
    </message>
    <message>
        <source>seam</source>
        <translation>шав</translation>
    </message>
    <message>
        <source>sharp</source>
        <translation>оштро</translation>
    </message>
    <message>
        <source>sharp from</source>
        <translation>оштро од</translation>
    </message>
    <message>
        <source>sharp to</source>
        <translation>оштро до</translation>
    </message>
    <message>
        <source>sine and cosine of the angle</source>
        <translation>синус и косинус угла</translation>
    </message>
    <message>
        <source>smallest gap that is sure at the target</source>
        <translation>најмањи размак који је код циља сигуран</translation>
    </message>
    <message>
        <source>smooth jump</source>
        <translation>гладак скок</translation>
    </message>
    <message>
        <source>smooth path</source>
        <translation>глатка путања</translation>
    </message>
    <message>
        <source>standard, 0 at near</source>
        <translation>стандардно, 0 на предњој равни</translation>
    </message>
    <message>
        <source>standard, far at infinity</source>
        <translation>стандардно, задња у ∞</translation>
    </message>
    <message>
        <source>steps of the two grids</source>
        <translation>кораци двеју решетки</translation>
    </message>
    <message>
        <source>stretch</source>
        <translation>растегни</translation>
    </message>
    <message>
        <source>subject&apos;s height, at the target&apos;s distance</source>
        <translation>висина предмета, на растојању циља</translation>
    </message>
    <message>
        <source>sun</source>
        <translation>сунце</translation>
    </message>
    <message>
        <source>surface 1</source>
        <translation>површ 1</translation>
    </message>
    <message>
        <source>surface 2</source>
        <translation>површ 2</translation>
    </message>
    <message>
        <source>synthetic film</source>
        <translation>синтетички филм</translation>
    </message>
    <message>
        <source>t, part of the edge on the screen</source>
        <translation>t, део ивице на екрану</translation>
    </message>
    <message>
        <source>t, to infinity at 1</source>
        <translation>t, до бесконачности на 1</translation>
    </message>
    <message>
        <source>table alone</source>
        <translation>само табела</translation>
    </message>
    <message>
        <source>table, 1 Newton step</source>
        <translation>табела, 1 Њутнов корак</translation>
    </message>
    <message>
        <source>table, 2 Newton steps</source>
        <translation>табела, 2 Њутнова корака</translation>
    </message>
    <message>
        <source>test points inside</source>
        <translation>пробне тачке унутра</translation>
    </message>
    <message>
        <source>the angles α and β give scale and angle before the picture is stretched</source>
        <translation>углови α и β дају размеру и угао пре него што се слика растегне</translation>
    </message>
    <message>
        <source>the arrow is behind the hole or beside it: no light comes from it into the box</source>
        <translation>стрелица је иза рупе или поред ње: од ње у кутију не долази светлост</translation>
    </message>
    <message>
        <source>the arrow&apos;s height h</source>
        <translation>висина стрелице h</translation>
    </message>
    <message>
        <source>the board reaches behind the near plane: the edges that are cut there have no picture</source>
        <translation>табла залази иза предње равни: ивице које су тамо одсечене немају слику</translation>
    </message>
    <message>
        <source>the bound is so large that a vertex may be behind the camera</source>
        <translation>граница је толико велика да је неко теме можда иза камере</translation>
    </message>
    <message>
        <source>the camera looks straight down or up: there is no floor from near to far</source>
        <translation>камера гледа право надоле или нагоре: нема пода од предње до задње равни</translation>
    </message>
    <message>
        <source>the edge&apos;s pixels are too many or too few for float64 to measure</source>
        <translation>пиксела ивице има превише или премало да би их float64 измерио</translation>
    </message>
    <message>
        <source>the end lies in the eye plane: its image is at ∞</source>
        <translation>крај лежи у равни камере: његова слика је у ∞</translation>
    </message>
    <message>
        <source>the eye lies in the seam, or the seam behind it: its picture has no width</source>
        <translation>камера лежи у шаву, или је шав иза ње: његова слика нема ширину</translation>
    </message>
    <message>
        <source>the far plane is at infinity: nothing pops in</source>
        <translation>задња раван је у бесконачности: ништа не искаче</translation>
    </message>
    <message>
        <source>the floor is drawn too far by a factor of up to</source>
        <translation>под се црта предалеко, чинилац до</translation>
    </message>
    <message>
        <source>the focal distance {0} m is not beyond the focal length {1} m: nothing so close has an image</source>
        <translation>растојање фокуса {0} m није веће од жижне даљине {1} m: ништа тако близу нема слику</translation>
    </message>
    <message>
        <source>the image on the plane</source>
        <translation>слика на равни</translation>
    </message>
    <message>
        <source>the light is inside the object&apos;s bounds: move it out to see the whole shadow</source>
        <translation>светло је унутар граница објекта: изнесите га напоље да видите целу сенку</translation>
    </message>
    <message>
        <source>the line as a circle</source>
        <translation>права као кружница</translation>
    </message>
    <message>
        <source>the mesh reaches behind the near plane: the edges that are cut there have no picture</source>
        <translation>мрежа залази иза предње равни: ивице које су тамо одсечене немају слику</translation>
    </message>
    <message>
        <source>the middle of a 105-mm photograph, enlarged {0} times</source>
        <translation>средина фотографије од 105 mm, увећана {0} пута</translation>
    </message>
    <message>
        <source>the next tree</source>
        <translation>следеће дрво</translation>
    </message>
    <message>
        <source>the object</source>
        <translation>објекат</translation>
    </message>
    <message>
        <source>the origin</source>
        <translation>координатни почетак</translation>
    </message>
    <message>
        <source>the picture is stretched {0} times as much upwards as across: faces do not keep their shape</source>
        <translation>слика је растегнута {0} пута више увис него у ширину: стране не задржавају облик</translation>
    </message>
    <message>
        <source>the picture is stretched: the target&apos;s disc is an ellipse of this width and height</source>
        <translation>слика је растегнута: диск циља је елипса ове ширине и висине</translation>
    </message>
    <message>
        <source>the point is behind the eye or beside it: its projector meets no plane in front</source>
        <translation>тачка је иза камере или поред ње: њен зрак пројекције не сече ниједну раван испред</translation>
    </message>
    <message>
        <source>the point is not in front of both eyes</source>
        <translation>тачка није испред оба ока</translation>
    </message>
    <message>
        <source>the projectors of a parallel lens do not meet in an eye: choose a perspective lens</source>
        <translation>зраци пројекције паралелног објектива не секу се у позицији камере: изаберите перспективни објектив</translation>
    </message>
    <message>
        <source>the same, counted in the picture</source>
        <translation>исто, пребројано на слици</translation>
    </message>
    <message>
        <source>the screen plane is before the near plane: nothing that is drawn can lie in it</source>
        <translation>раван екрана је испред предње равни: ништа од нацртаног не може да лежи у њој</translation>
    </message>
    <message>
        <source>the segment is a single point of the cube</source>
        <translation>дуж је једна једина тачка коцке</translation>
    </message>
    <message>
        <source>the segment lies in the eye plane: its whole image is at infinity</source>
        <translation>дуж лежи у равни камере: цела њена слика је у бесконачности</translation>
    </message>
    <message>
        <source>the segment lies outside the view volume</source>
        <translation>дуж лежи изван запремине погледа</translation>
    </message>
    <message>
        <source>the segment points at the eye: the image of its whole line is one point</source>
        <translation>дуж је усмерена ка камери: слика целе њене праве је једна тачка</translation>
    </message>
    <message>
        <source>the shadow is farther than 1e30 away</source>
        <translation>сенка је даље од 1e30</translation>
    </message>
    <message>
        <source>the subject&apos;s pixels are more than float64 can hold on one of the screens</source>
        <translation>пиксела предмета има више него што float64 може да прими на једном од екрана</translation>
    </message>
    <message>
        <source>the target is not between near and far</source>
        <translation>циљ није између предње и задње равни</translation>
    </message>
    <message>
        <source>the target is so close to the lens that its disc has no finite size</source>
        <translation>циљ је толико близу објектива да његов диск нема коначну величину</translation>
    </message>
    <message>
        <source>the texture is laid over the mesh&apos;s two largest extents; only the {0} triangles with the longest sides are examined</source>
        <translation>текстура је положена преко две највеће димензије мреже; испитују се само троуглови са најдужим страницама: {0}</translation>
    </message>
    <message>
        <source>the texture is laid over the mesh&apos;s two largest extents; texture coordinates in its file are not used</source>
        <translation>текстура је положена преко две највеће димензије мреже; координате текстуре из датотеке се не користе</translation>
    </message>
    <message>
        <source>the view volume cuts PQ: the part inside it, from P&apos; to Q&apos;, is measured</source>
        <translation>запремина погледа сече PQ: мери се део унутар ње, од P&apos; до Q&apos;</translation>
    </message>
    <message>
        <source>the wall reaches behind the eye: a vertex there has no logarithm</source>
        <translation>зид досеже иза камере: теме тамо нема логаритам</translation>
    </message>
    <message>
        <source>there is no error that an arrow could show</source>
        <translation>нема грешке коју би стрелица могла да покаже</translation>
    </message>
    <message>
        <source>there is no number: a vertex may be behind the eye</source>
        <translation>нема броја: неко теме је можда иза камере</translation>
    </message>
    <message>
        <source>there is only one screen, and so no join</source>
        <translation>постоји само један екран, па нема споја</translation>
    </message>
    <message>
        <source>there, it is drawn at</source>
        <translation>тамо се црта на</translation>
    </message>
    <message>
        <source>there, its distance w</source>
        <translation>тамо је његово растојање w</translation>
    </message>
    <message>
        <source>these are</source>
        <translation>то су</translation>
    </message>
    <message>
        <source>these formats may overflow or divide by 0 here, so there is no bound</source>
        <translation>у овим форматима овде може доћи до прекорачења или дељења са 0, па границе нема</translation>
    </message>
    <message>
        <source>this lens has no inverse whose numbers float64 can hold</source>
        <translation>овај објектив нема инверз чије би бројеве float64 могао да прими</translation>
    </message>
    <message>
        <source>this window is too narrow for two screens</source>
        <translation>овај прозор је преузак за два екрана</translation>
    </message>
    <message>
        <source>toed in</source>
        <translation>закренуте ка средини</translation>
    </message>
    <message>
        <source>too few pixels of the picture show both surfaces to count them</source>
        <translation>премало пиксела слике показује обе површи да би се бројали</translation>
    </message>
    <message>
        <source>too large or too small for a float64 number</source>
        <translation>превелико или премало за број float64</translation>
    </message>
    <message>
        <source>too large or too small for a number in pixels</source>
        <translation>превелико или премало за број у пикселима</translation>
    </message>
    <message>
        <source>top</source>
        <translation>горња</translation>
    </message>
    <message>
        <source>trees that pop in each second, driving on at 12 units a second</source>
        <translation>дрвећа које искочи сваке секунде, при вожњи са 12 јединица у секунди</translation>
    </message>
    <message>
        <source>trees that pop out each second, driving on</source>
        <translation>дрвећа које нестане сваке секунде, при даљој вожњи</translation>
    </message>
    <message>
        <source>true distance w</source>
        <translation>стварно растојање w</translation>
    </message>
    <message>
        <source>truncated cone</source>
        <translation>зарубљена купа</translation>
    </message>
    <message>
        <source>two eyes so far apart have no pictures with this lens</source>
        <translation>два ока на толиком размаку са овим објективом немају слике</translation>
    </message>
    <message>
        <source>two floats</source>
        <translation>два float-а</translation>
    </message>
    <message>
        <source>two floats, from the origin</source>
        <translation>два float-а, од нуле</translation>
    </message>
    <message>
        <source>upright</source>
        <translation>усправна</translation>
    </message>
    <message>
        <source>upside down and left for right</source>
        <translation>наопачке и са замењеним лево и десно</translation>
    </message>
    <message>
        <source>vertex P</source>
        <translation>теме P</translation>
    </message>
    <message>
        <source>vertical field of view</source>
        <translation>вертикално видно поље</translation>
    </message>
    <message>
        <source>vertical parallax of P</source>
        <translation>вертикална паралакса тачке P</translation>
    </message>
    <message>
        <source>vertices drawn</source>
        <translation>нацртана темена</translation>
    </message>
    <message>
        <source>vertices drawn without level of detail</source>
        <translation>нацртана темена без нивоа детаљности</translation>
    </message>
    <message>
        <source>vertices not below the light</source>
        <translation>темена која нису испод светла</translation>
    </message>
    <message>
        <source>view volume</source>
        <translation>запремина погледа</translation>
    </message>
    <message>
        <source>w may be 0 in these numbers, so nothing is known</source>
        <translation>w у овим бројевима може бити 0, па се ништа не зна</translation>
    </message>
    <message>
        <source>w of P = (1 − t)·C + t·(D : 0)</source>
        <translation>w тачке P = (1 − t)·C + t·(D : 0)</translation>
    </message>
    <message>
        <source>wall against one picture, float64</source>
        <translation>зид према једној слици, float64</translation>
    </message>
    <message>
        <source>where the floor is drawn</source>
        <translation>где се под црта</translation>
    </message>
    <message>
        <source>where: w = √(w_P&apos;·w_Q&apos;)</source>
        <translation>где: w = √(w_P&apos;·w_Q&apos;)</translation>
    </message>
    <message>
        <source>where: w = √(w_P·w_Q)</source>
        <translation>где: w = √(w_P·w_Q)</translation>
    </message>
    <message>
        <source>whole pixels</source>
        <translation>цели пиксели</translation>
    </message>
    <message>
        <source>width of the gap along the seam</source>
        <translation>ширина процепа дуж шава</translation>
    </message>
    <message>
        <source>window</source>
        <translation>прозор</translation>
    </message>
    <message>
        <source>with a parallel lens a box goes through the window, not a frustum from the eye</source>
        <translation>са паралелним објективом кроз прозор пролази квадар, а не зарубљена пирамида из камере</translation>
    </message>
    <message>
        <source>with a parallel lens half-way on the screen is half-way in the world: affine is correct</source>
        <translation>са паралелним објективом пола пута на екрану је пола пута у свету: афино је исправно</translation>
    </message>
    <message>
        <source>with a parallel lens parallel edges stay parallel in the image</source>
        <translation>са паралелним објективом паралелне ивице и на слици остају паралелне</translation>
    </message>
    <message>
        <source>with a parallel lens the distance itself is linear on the screen: nobody needs its logarithm</source>
        <translation>са паралелним објективом само растојање је линеарно на екрану: његов логаритам ником није потребан</translation>
    </message>
    <message>
        <source>with far at infinity, no affine z&apos; = A z + B covers all depths: choose a finite far plane</source>
        <translation>са задњом равни у бесконачности ниједно афино z&apos; = A z + B не покрива све дубине: изаберите коначну задњу раван</translation>
    </message>
    <message>
        <source>worst edge of the letter F, inside</source>
        <translation>најгора ивица слова F, унутра</translation>
    </message>
    <message>
        <source>worst edge of the mesh, inside</source>
        <translation>најгора ивица мреже, унутра</translation>
    </message>
    <message>
        <source>wrong</source>
        <translation>погрешно</translation>
    </message>
    <message>
        <source>x</source>
        <translation>x</translation>
    </message>
    <message>
        <source>x and y are divided by the distance w. If z were only scaled and shifted, z&apos; = A z + B, a straight segment PQ would be a bow in the cube. Nothing between its ends could then be interpolated or clipped as on a line. With z&apos; = {divided_z} it stays straight.</source>
        <translation>x и y се деле растојањем w. Када би се z само скалирало и померило, z&apos; = A z + B, права дуж PQ била би у коцки лук. Ништа између њених крајева тада не би могло да се интерполира или одсеца као на правој. Са z&apos; = {divided_z} она остаје права.</translation>
    </message>
    <message>
        <source>y</source>
        <translation>y</translation>
    </message>
    <message>
        <source>your own</source>
        <translation>сопствени</translation>
    </message>
    <message>
        <source>z</source>
        <translation>z</translation>
    </message>
    <message>
        <source>{0} = {1}: is at infinity, so it is a direction and not a point; it must be another than {2}</source>
        <translation>{0} = {1}: у бесконачности је, па је то смер, а не тачка; мора да буде неки други, а не {2}</translation>
    </message>
    <message>
        <source>{0} = {1}: must be from 0 to {2}, or P has no pixel and no depth in the picture</source>
        <translation>{0} = {1}: мора да буде од 0 до {2}, иначе P на слици нема ни пиксел ни дубину</translation>
    </message>
    <message>
        <source>{0} is beyond what float64 can hold in pixels</source>
        <translation>{0} је више него што float64 може да прими у пикселима</translation>
    </message>
    <message>
        <source>{0} vertices of the picture have no number in these formats: they are drawn where they belong</source>
        <translation>Темена слике без броја у овим форматима: {0}; цртају се тамо где им је место</translation>
    </message>
    <message>
        <source>{b}, {t}</source>
        <translation>{b}, {t}</translation>
    </message>
    <message>
        <source>{l}, {r} of the left screen</source>
        <translation>{l}, {r} левог екрана</translation>
    </message>
    <message>
        <source>{l}, {r} of the right screen</source>
        <translation>{l}, {r} десног екрана</translation>
    </message>
    <message>
        <source>{l}, {r} of the window</source>
        <translation>{l}, {r} прозора</translation>
    </message>
    <message>
        <source>½ in the world</source>
        <translation>½ у&#xa0;свету</translation>
    </message>
    <message>
        <source>½ on the screen</source>
        <translation>½ на екрану</translation>
    </message>
    <message>
        <source>∞: focused at the hyperfocal distance or beyond, everything far away is sharp</source>
        <translation>∞: са фокусом на хиперфокалном растојању или даље, све далеко је оштро</translation>
    </message>
</context>
</TS>
