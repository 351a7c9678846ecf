<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de_DE" sourcelanguage="en">
<context>
    <name>QObject</name>
    <message>
        <source>%1 cannot be put into %2: %3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the folder cannot be made</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Runs cannot be recorded in %1: %2.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 cannot be deleted: %2.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>PDF (*.pdf)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Web page (*.html)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save Report</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>StudyData</name>
    <message>
        <source>fabric</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>experiment</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>StudyFields</name>
    <message>
        <source>Fidelity</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>core</name>
    <message>
        <source>wetted radius</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>wetted radius in 5 mm rings</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>stain on top, semi-axis along warp</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>stain on top, semi-axis along weft</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>stain at rest from</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>water between the yarns</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>water shed below</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>absorbency time</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>wicking rate</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>wetting time</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>absorption rate</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>spreading speed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>one-way transport</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>overall capability (OMMC)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>class</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>height</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>steady drying rate</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>time to dry</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>steady temperature</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>regain at the start</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>regain at the end</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>half-change time</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>peak warming above air</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>top</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>bottom</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no 10 s without growth before the end</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>free liquid is left</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>some of the liquid dripped off instead of being absorbed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>nothing is wet</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>this face stayed dry</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the liquid did not rise</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>less than 70 % of the water has dried</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>more than 4 % of the water is left</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>still changing</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the regain did not change</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the computed value is not a finite number</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>water-proof or water-repellent</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>moisture management</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>water penetration</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>slow-absorbing and slow-drying</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>fast-absorbing and quick-drying</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>fast-absorbing and slow-drying</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>water delivered</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>free water</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>water in the pores</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>water absorbed by the fibres</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>water taken from the air</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>water evaporated</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>water dripped off</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>water imbalance</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>energy released</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>energy imbalance</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Wetted radius</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Height</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Water content</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>% of dry mass</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Water</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>free</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>in yarns</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>in fibres</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>evaporated</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>dripped off</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Water in the faces</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Temperature</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>sample</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>air</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>coldest yarn</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>warmest yarn</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Regain</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>fibres</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the wetted radius, top</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the wetted radius, bottom</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the height</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>absorbs, baseline does not</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>does not absorb, baseline does</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>only this has it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>only baseline has it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>together</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>difference</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Droplets</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Moisture management</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Vertical wicking</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Horizontal wicking</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drying</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Conditioning</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sweat</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>vertical wicking</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>horizontal wicking</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>drying</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>conditioning</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>sweat</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>liquid</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>wicking</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>sorption</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>vapour</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>heat</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>growth</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Plain, baskets and ribs</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Twills</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Broken and pointed twills</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Satins</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sateens</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Effects</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Bast fibres</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cotton</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Filament</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>From the paper</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Viscose</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Wool</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>greige</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>scoured and bleached</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>mercerised</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>hydrophilic softener</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>wicking finish on polyester</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>bare polyester</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>durable water repellent</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>cotton</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>wool</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>polyester</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>hemp</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>flax</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>silk</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>viscose</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>nylon 6.6</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>acrylic</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>lyocell</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>modal</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>polypropylene</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>elastane</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>water</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>saline</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>head</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>chest</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>abdomen</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>back</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>buttocks</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>upper arm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>forearm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>palm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>back of hand</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>thigh</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>shin</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>sole</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>top of foot</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>shoulder</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>taylor-2013 rest</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>taylor-2013 exercise</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>tee</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>singlet</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>leggings</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>warp</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>weft</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>extra yarns</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>climate</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>before</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>droplets</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>air speed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>areal density</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>at</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>capillary radius</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>contact angle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>crimp</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>density</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>diameter</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>drop</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>duration</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>ends</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>feed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>fibre diffusivity</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>fibre radius</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>fibres per yarn</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>filament count</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>flyaway</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>hair density</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>hair length</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>heat of wetting</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>immersion</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>initial water</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>irregularity</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>isotherm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>length</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>linear density</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>loop density</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>loop height</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>material</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>share</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>monolayer regain</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>packing factor</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>picks</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>plies</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>ply twist</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>porosity</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>rate</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>receding angle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>relative humidity</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>saturation regain</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>skin temperature</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>sorption heat</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>specific heat</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>speed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>standard regain</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>strip</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>surface tension</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>swelling</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>temperature</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>thermal conductivity</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>thickness</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>time</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>tortuosity</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>twist</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>viscosity</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>volume</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>warp crimp</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>weft crimp</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>initial</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>finish face</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>finish back</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>particles per droplet</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>fibre shells</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>crossings per cell</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>crossings per even cell</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>network step limit s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>saturation change</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>step error</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>liquid step factor</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>steps between absorption</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>density tolerance</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>settle share</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>rest tolerance</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>double precision</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>free liquid</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>neglected share</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>hygroloom</name>
    <message>
        <source>Error</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Warning</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Note</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 µm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Smaller is better.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Larger is better.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 of %2 runs</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>baseline</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Difference to %1: %2 to %3 %4, from %5.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>one run of each</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 pairs of runs</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>measured %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This run does not give this number.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 (%2 to %3)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>After ±: where one more such cloth is expected, from %1 runs with numerical error, scatter and what is not known of the cloth.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>After ±: the numerical error, as measured on runs of this kind.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The numerical error of this number is not known.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>better</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>probably better</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no difference shown</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>probably worse</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>worse</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>grade %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The recording does not contain its fabric.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>add %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>remove garment</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A garment needs a name.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A garment “%1” already exists. Choose another name.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>An experiment needs a name.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>An experiment “%1” already exists. Choose another name.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>rename garment</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>rename wear experiment</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>cut all panels from %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A zone needs a name.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>“%1” is a zone of the body. Choose another name.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A zone “%1” already exists. Choose another name.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>draw a zone</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>delete zone</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>add wear experiment</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>remove wear experiment</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Area, m²</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Water, g</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Water, g/m²</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Of capacity, %</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Wet area, %</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>On skin, g</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Evaporated, g</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cloth, °C</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Full after, s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Dry after, s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Garment</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Panel: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Zone: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the cloth lies level here</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the warp runs down here</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the weft runs down here</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the bias runs down here, %1° from the warp</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The graphics driver rejected a shader: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The picture needs OpenGL 3.3, which this display does not provide.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the wetted radius, top</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the wetted radius, bottom</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the run’s numbers at most</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>so no two cells lie at the same place</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>its setts differ from the baseline’s, %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>its sample is of another size than the baseline’s, %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The project has no fabric to begin with; add one.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 = %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The study has no fabric “%1”.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, study %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Added the fabric “%1”.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>These factors are no part of it: %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no run can be planned</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>1 run</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 runs</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>1 point</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 points</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 (%2); time not known: %3.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 (%2), %3, %4 at a time with %5 each.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>hygroloom::CalibrateDialog</name>
    <message>
        <source>Contact angle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Receding angle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Packing factor</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Browse…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Apply</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Save Report…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Calibrate</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>%n runs done</source>
        <translation type="unfinished">
            <numerusform></numerusform>
            <numerusform></numerusform>
        </translation>
    </message>
    <message>
        <source>Fabric</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Experiment</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Experiment</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>CSV: time_s and a series such as wick_height_mm, or a table of metrics</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Measured file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Measured</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: now %2, from %3 to %4</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: known</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fidelity</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>F&amp;idelity</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>before</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>fitted, 90 %</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>range</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fitted inputs</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Result of the calibration</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Progress of the runs</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Close</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Measured File</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tables (*.csv);;All files (*)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The project needs a fabric and an experiment.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The project has errors; correct them first.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose a file of what was measured.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tick what is to be fitted.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Cancel</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Run</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cancelled.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Residual: %1 before, %2 after, %3.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>in spreads</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>calibration</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Saved %1.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>hygroloom::CalibrationRun</name>
    <message>
        <source>Not enough memory for these runs. Choose a smaller sample or a lower fidelity.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>hygroloom::CandidateTable</name>
    <message>
        <source>Numbers of the candidates</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rank</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Baseline</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fabric</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Click to rank and sort by this number.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>1 is best by the number that sorts the table, or the first one. “=”: this simulation cannot tell them apart.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The others are compared with %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Click to compare the others with %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is the baseline</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Make %1 the baseline</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>run of another design</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1. Tick two to four to see their maps and curves below.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Click to open the run.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>reading…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>failed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>not run</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Use as &amp;Baseline</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Open This Run</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Run What Is Missing</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>hygroloom::CandidatesPanel</name>
    <message>
        <source>one drop</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This project has no fabric yet.
Add one to begin.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fabrics of the project</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Add Fabric</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add a plain-weave cotton fabric</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>D&amp;uplicate Fabric</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add a copy of the selected fabric</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Rename Fabric</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rename the selected fabric</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Delete Fabric</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Delete the selected fabric</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>From &amp;Preset…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add a fabric from the library</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Save to My Library</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save the selected fabric to my library</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: %2, %3 × %4 per cm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>free weave</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>New fabric</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>add fabric</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>add %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Saved %1 to my library.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>duplicate fabric</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 copy</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>delete fabric</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>rename fabric</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>hygroloom::Chart</name>
    <message>
        <source>In fibres: water absorbed since the start.
Click to show that time.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: %2 %3 at %4 s</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>hygroloom::ClimateCourse</name>
    <message>
        <source>Climate over time</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Time</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Temp.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Humidity</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Air</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Time from the start of the experiment</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Temperature</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Relative humidity</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Air speed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add a time</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remove the selected time</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>About the climate over time</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Row %1: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The climate changes linearly between these times and is constant after the last.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The climate is constant. Add a time to change it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>climate over time</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>add climate time</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>remove climate time</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>hygroloom::ClothsView</name>
    <message>
        <source>Problem</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Time of all cloths</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 in 3D</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>hygroloom::ClusterDialog</name>
    <message>
        <source>One &amp;GPU for each task</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Write the Folder</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Submit Here</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Study for a Cluster</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Options for sbatch</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>16 runs each</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tasks of the job array</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What to type on the cluster</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The folder receives the project and the study. It must be on a disk that all machines of the cluster have, or be copied there. Then type on the cluster:</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Folder:</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Options for sbatch:</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tasks:</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Copy the Commands</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Write the folder and submit the job array.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Written to %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Submitted job %1 with %2 tasks.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>hygroloom::CommandPalette</name>
    <message>
        <source>No command matches.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Find Command</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Commands</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Words of the command</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Type letters of a command</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>hygroloom::CompareBar</name>
    <message>
        <source>&amp;Run All Missing</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Cancel</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Measured…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save &amp;Table…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save Re&amp;port…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Runs of each fabric. With more than one, inputs are drawn within what is not known of the cloth, and yarns are as uneven as is typical; intervals then hold this scatter.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Progress of the runs</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Missing runs</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>E&amp;xperiment:</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>F&amp;idelity:</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>R&amp;eplicates:</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Filter fabrics</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Put a laboratory&apos;s numbers beside the simulated ones, from a CSV file with the columns fabric, metric, value, unit and, if known, spread.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Write the numbers as a CSV file for spreadsheets.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Write verdicts, intervals, maps, curves, and what is not known, as PDF or web page.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cannot run: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nothing is missing.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>1 run</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 runs</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Run each fabric that has no run of this experiment yet.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>, %1 left</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>hygroloom::CompareMaps</name>
    <message>
        <source>Maps</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Difference to baseline</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What the maps show</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Top face</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Bottom face</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Face of the fabrics</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Time of all maps</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Value under the pointer</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Water on %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Each cloth as given. Under the pointer also the %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is no difference map of %1: %2.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Of %1 and the baseline fewer than two replicates keep maps: grey is the numerical error alone.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tick a second fabric to see how it differs.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Water less that of %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a numerical error of %1 %</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no numerical error, which is not known</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 Mean of %2 pairs of replicates after %3, the nearest time of which they keep maps. Grey: the interval of the mean difference, with %4, holds 0.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 Grey: the difference is at most %2 % of the wetter one, the numerical error of %3.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 The numerical error of these runs is not known: grey cells are exactly equal.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Difference</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>g/m²</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Water</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>hygroloom::CompareView</name>
    <message>
        <source>Candidates</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>All Runs</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Maps</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Curves</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fingerprint</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Scatter</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Why</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>3D</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>At most four runs can be compared.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>All experiments</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, of other runs</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Enter or the button runs it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>running…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>waiting</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This project has no fabric. Add one with Fabric ▸ Add Fabric.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This project has no experiment. Add one with Experiment ▸ Add Experiment.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A comparison needs a second fabric: add one with Fabric ▸ Add Fabric, or tick an older run under All Runs.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Maps and 3D are of each cloth as given; curves and difference maps are of the replicates. In these, yarns without an unevenness of their own are as uneven as is typical.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>These runs have different fidelities, which is part of their difference.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tick two to four fabrics above to see them side by side.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nothing has been run yet. “Run All Missing” above runs the experiment on every fabric. Recordings that are opened stand under All Runs.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose one experiment above to see its maps and curves.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nothing can be run: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save Table</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tables (*.csv)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Another report is still being written. Save this one when that is done.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Measured Numbers</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tables (*.csv);;All files (*)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Runs are in progress</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stop the runs of Compare?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1. Those are kept with the project.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stop the Runs</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>hygroloom::CurveLegend</name>
    <message>
        <source>Curves: %1</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>hygroloom::CurvesView</name>
    <message>
        <source>%1: %2 %3 at %4 s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>numerical error</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 (%2: %3 to %4)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What the bands are</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Curve</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Value under the pointer</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Curves of the ticked runs</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Time (s)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>With replicates the line is their middle, and the band goes from the least to the most of them; of %1 and more, from the 5th to the 95th percentile.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Band: the numerical error of %1, as measured on runs of this kind.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No numerical error of this curve is known, so there is no band.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Of %1 the cloth as given is drawn, with its numerical error where that is known.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Of %1 some replicates were computed by a version that kept no curves, or are too old: they are not in the band.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tick two to four fabrics above to see their curves over each other.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>hygroloom::DesignForm</name>
    <message>
        <source>Show or hide these fields.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The same in other units</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>hygroloom::DesignWorkspace</name>
    <message>
        <source>Candidates</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Weave</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Draft</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fabric</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Water, live</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Edit the values of “%1” in the project file, under “materials”.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>hygroloom::Document</name>
    <message>
        <source>Example: %1</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>hygroloom::DraftEditor</name>
    <message>
        <source>Shafts</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Treadles</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Find Draft</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Find the draft of this weave with the fewest shafts and treadles.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>About the draft</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show the cloth in the colours of its yarns</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Zoom into the draft</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Zoom out of the draft</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Treadling or liftplan</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tie-up and treadling</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Liftplan</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A treadle lifts the shafts tied to it. A liftplan lists the shafts of each pick. Both weave the same cloth.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rising shed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sinking shed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Whether the marked shafts rise or sink. The marks stay; the cloth turns over.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>tie-up and treadling</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>liftplan</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>rising shed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>sinking shed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The weave has no draft of its own; this is the smallest one. Change it here or press Find Draft to keep it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>drawdown</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>threading</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>tie-up</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>order of the ends</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>order of the picks</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>treadling</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>find draft</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>number of shafts</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>number of treadles</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>hygroloom::DraftPaper</name>
    <message>
        <source>Draft</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Threading above, treadling on the right, tie-up in the corner, yarns along both edges. Click or drag to change; with Ctrl a second shaft or treadle is added. Arrow keys move, Space changes.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Scroll along the picks</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Scroll along the ends</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>hygroloom::DropletSection</name>
    <message>
        <source>Droplets</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add a droplet</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remove the droplet</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Place the droplet: click on the fabric</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No droplet yet. Add one to wet the fabric.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Volume</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>droplet volume</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Time</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>droplet time</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Time at which the drop appears.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Position along weft</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>droplet position</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Distance from the sample&apos;s centre.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Position along warp</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Height</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>droplet height</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Height of its lowest point above the fabric.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Speed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>droplet speed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Downward speed when it appears.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: %2 µl at %3 s, at (%4, %5) mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>add droplet</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>remove droplet</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>hygroloom::EffectsChart</name>
    <message>
        <source>Main effects of the factors</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 %2: mean %3 of %4, standard deviation %5, %6 rows</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>hygroloom::EffectsView</name>
    <message>
        <source>Metric of the effects</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Metric:</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What the effects show</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Line: the mean over all rows near a factor&apos;s value, whatever the others are. Band: one standard deviation of the rows either way.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>hygroloom::ExperimentPanel</name>
    <message>
        <source>%1 (%2)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>one drop</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Along the weft</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Along the warp</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>sample width</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>sample height</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Experiment</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add an experiment</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rename the experiment</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Delete the experiment</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A new type sets the climate, sample and duration of its standard.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Type of experiment</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Climate</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Temperature</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>temperature</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Humidity</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>relative humidity</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Relative humidity of the air, and of the fabric before the first drop.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Air speed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>air speed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sample</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Duration</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>duration</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Volume</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>volume of liquid</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Feed time</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>feed time</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Time for which the pump runs.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drop volume</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>drop volume of the feed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The feed comes in equal drops of at most this volume, each when the pump has delivered it. Drops join a pool that the cloth absorbs. 0: the feed flows evenly.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Strip</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>direction of the strip</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Immersion</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>immersion</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Depth of the strip&apos;s end below the liquid surface.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Initial water</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>initial water</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Liquid water in the fabric at the start, in addition to its regain in this climate.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Initial temperature</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>initial temperature</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Temperature of the air in which the sample was conditioned.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Initial humidity</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>initial humidity</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Relative humidity of the air in which the sample was conditioned.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sweat rate</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>sweat rate</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Bottom</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Top</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Face</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>sweating face</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Liquid</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Kissa (measured)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Li and Zhu</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mao et al. (as printed)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pores in and between yarns</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How liquid moves in the pores of the yarns. Mao et al.: pores of 0.2 mm, one contact angle for all fibres, uptake in proportion to regain. Pores in and between yarns: liquid follows suction, and a stain stops.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Wicking model</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>wicking model</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Wet fibres swell</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>swelling</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Strip width</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Strip length</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>type of experiment</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>add experiment</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rename experiment</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Name:</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>rename experiment</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>delete experiment</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>hygroloom::ExportDialog</name>
    <message>
        <source>&amp;Close the ends with caps</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Loops and hairs</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Open Folder</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Export</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Close</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Export Mesh</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Size of the export</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Result of the export</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Progress of the export</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Not enough memory for this piece. Choose a smaller one.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 samples per crossing are too few for this twist. Use %2 for smooth fibres.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 ends × %2 picks</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 curves with %2 points</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 triangles, %2 vertices</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>about %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The file may need up to %1; only %2 are free on the disk.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Many programs cannot open files larger than 1 GB.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Wrote %1, %2.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> and </source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cancelled. No file was written.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Not enough memory for this export. Choose a smaller piece.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cancelling…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Exported %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 already exists. Replace it?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 already exist. Replace them?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>weft × warp</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fabric</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Format</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>For&amp;mat</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Yarn centrelines</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Yarn surfaces</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Single fibres</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Detail</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Detail</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Repeats of the fabric</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>By size</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Piece</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Piece</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Along the weft.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Along the warp.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Repeats along the weft</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Repeats along the warp</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Width along the weft</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Height along the warp</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Repeats</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Si&amp;ze</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Samples per crossing</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rings of a tube, or points of a curve, from one crossing to the next.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sides</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sides of the tube that represents a yarn or a fibre.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Samples per crossing</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sides of a &amp;tube</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Close the ends with caps</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Seed of the fibres</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Start of the random numbers: equal seeds give equal fibres.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Seed of the &amp;fibres</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Browse…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>File</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>F&amp;ile</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sample of the experiment, %1 × %2 mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sample of the experiment (there is none)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Simulated piece with its water at %1 s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Simulated piece (open a recording, or run)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This project has no fabric to export.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This fabric has an error and cannot be exported. See the Issues panel.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Enter a file name.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This is a folder. Enter a file name.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The folder %1 does not exist.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The folder %1 cannot be written to.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 (*%2)</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>hygroloom::FabricPanel</name>
    <message>
        <source>Construction</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ends</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>ends per cm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Warp yarns per centimetre. You can type “89 epi”.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Picks</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>picks per cm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Weft yarns per centimetre. You can type “89 ppi”.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 /in</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Thickness</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>thickness</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Leave empty to calculate it from the yarns.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Auto</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Calculate the thickness from the yarns</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Contact angle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>contact angle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Advancing contact angle of water on the finished fabric. Leave empty to use that of each yarn&apos;s fibres. Above 90° the yarns do not absorb water.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>As the fibres</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, %2°</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Own contact angle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sets the contact angle above to a typical value for the finish. Measure your own fabric if you can.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Finish</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>finish</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Receding angle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Contact angle of water that draws back, of warp and weft; 0 on cotton, flax, hemp and viscose, else 20° less than the contact angle, both assumed, unless the material gives one. Acts in the closure “pores” only.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Contact angle of a finish on this face alone. Leave empty for the yarns&apos; own. Acts in the closure “pores” only.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Finish, top face</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>finish of the top face</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Finish, back</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>finish of the back</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1° × %2°</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How much longer the yarn is than the fabric. Leave empty to share the crimp between warp and weft by their stiffness.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Warp crimp</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>warp crimp</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Weft crimp</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>weft crimp</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Calculated</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Weight</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Dry mass per area.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cover factor</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Share of the area that yarns hide, seen from above; the rest are holes between them. 1: no hole.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Yarn path</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Round: yarns cross in circular arcs (Peirce). Flattened: the sett is too dense for full arcs, so yarns are flattened where they cross.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Porosity</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Share of the fabric&apos;s volume that is air, in yarns and between them.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Yarn layer</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Thickness of the interlaced yarns.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Gaps</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Between neighbouring ends × between neighbouring picks.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 g/m²</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>flattened at crossings</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>round (Peirce)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 × %2 mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Flyaways</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Loops</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>loop density</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fibres that leave the yarn and come back to it, per mm of yarn. With the closure “pores” they hold falling drops off dry yarns.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hairs</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>hair density</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fibre ends that stand out of the yarn, per mm of yarn. With the closure “pores” they hold falling drops off dry yarns.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Loop height</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>loop height</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Height of the highest loop above the yarn; the lowest is half as high. Loops make the cloth thicker, and the still air among them slows drying.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hair length</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>hair length</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mean length of the fibre ends; the shortest have half of it, the longest one and a half times.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Measured in the laboratory</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Replaces the calculated value. Leave empty to use the calculated one.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>measured porosity</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>measured weight</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pore radius</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>measured pore radius</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tortuosity</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>measured tortuosity</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Crimp</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>measured crimp</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>hygroloom::FactorForm</name>
    <message>
        <source>%1 to %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, step %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, logarithmic</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>normal, %1 ± %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>lognormal, %1 ± %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, most often %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Range</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>List of values</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Range, logarithmic</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Normal</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Lognormal</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Triangular</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How the factor is spread</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Spread:</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Values:</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Numbers or words, separated by commas: 20, 40, 60</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mean:</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Standard deviation:</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>From:</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Most often:</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>To:</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Step:</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Only values that are whole steps from the lowest; empty: any value.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Levels:</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>On a grid, and one at a time; empty: as many as the points allow.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Base:</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Where other factors change one at a time; empty: the project&apos;s own value.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no bound</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is missing; type a number.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 must be a number; given is “%2”.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The list is empty; type values separated by commas.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The mean</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The standard deviation</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The lowest value</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The most frequent value</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The highest value</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The step</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The number of levels</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The number of levels must be a whole number from 2 to 10000; given is %1.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>hygroloom::FieldPicker</name>
    <message>
        <source>Add Factors</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Letters of a name, such as “angle” or “weft twist”</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Find a field</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fields of the project</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Field</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Now</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Unit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Path</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Add</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A study changes these. Hold Ctrl to choose several.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>not set</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>It is a factor already.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>hygroloom::FingerprintView</name>
    <message>
        <source>What the fingerprint shows</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fingerprint of the ticked runs</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tick two to four fabrics above to see their fingerprints.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A fingerprint needs three numbers or more; this experiment has %1. See Scatter.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Grades of AATCC 195 of each cloth as given: 1 poor (inside) to 5 excellent (rim).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Each number from the worst (middle) to the best (rim) of the %1 candidates in the table. Differences are drawn however small they are: the table says which are real.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>hygroloom::FitChart</name>
    <message>
        <source>measured</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>before</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>fitted</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>time, s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Measured and simulated curves</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: %2 %3 at %4 s</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>hygroloom::FitForm</name>
    <message>
        <source>Gaps between skin and cloth</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Zone</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Gap</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Seams</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Seam</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Passes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Gap between skin and cloth</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Share of the water that seams pass</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>all others</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Gap: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>change gap: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Where cloth rests on the shoulder. Empty: as the zone there. 0: they touch.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Of zones that have no gap of their own. Empty: 3 mm. 0: they touch.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Empty: as all others. 0: they touch.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Seam: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>change seam: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Of seams that have no share of their own. Empty: 100 %, as where cloth overlaps; 0 %: taped.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>100 %: as where cloth overlaps; 0 %: taped. Empty: as all others.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>hygroloom::FlatView</name>
    <message>
        <source>Flat panels of the garment</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drag to move, wheel to zoom, click to pin a place. Plus and minus zoom, Home shows all panels.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>hygroloom::GarmentPanel</name>
    <message>
        <source>Fabrics to drag onto panels</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drag a fabric onto a panel. A double click cuts all panels from it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Panels</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fabrics</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Wearer</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Garment</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add a garment</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Built-in %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pattern or Mesh from a File…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rename the garment</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rename the Garment</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remove the garment and its experiments</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Chest</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Length</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ease</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sleeve</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>change %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Skin temperature</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>change skin temperature</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Gap between skin and cloth</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>change gap</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Air between skin and cloth, where the project names no other gap for a zone; 0: they touch.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sweat rates of the zones</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sweat of each zone of the body: Taylor and Machado-Moreira 2013, table 4, or a CSV with the columns zone and g_m2_h.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Skin</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Gap to skin</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sweat</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sweat Rates</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tables of zones (*.csv)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>choose sweat rates</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add a Garment</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Patterns and meshes (*.json *.obj *.glb *.gltf *.fbx *.ply *.dae);;All files (*)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hip</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>From a CSV File…</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>hygroloom::GarmentRun</name>
    <message>
        <source>Not enough memory for this run. Choose a lower fidelity.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>hygroloom::GarmentView</name>
    <message>
        <source>%1, %2: %3, %4</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, stopped at %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Place under the pointer</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This project has no garment yet.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add the built-in tee</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Adds a tee, cut from the project&apos;s first fabric, and an experiment in which it is worn.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Steps…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Set where each of the eight colours ends.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>cut %1 from %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reading the garment.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 in its fabrics</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>. Not an experiment of this project.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>. Out of date: the design has changed. Run again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Difference B − A</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>, ended before this time</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>, at %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Share of capacity, %</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Water, g/m²</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Difference B − A, %</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Difference B − A, g/m²</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Point at a cell to read its value; click to pin it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drag a fabric onto a panel, or choose it in the table.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: %2, grain %3°</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 has no fabric</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 g/m², %2 % of capacity</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A: %1; B: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, zone %2: %3; %4</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What is drawn</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>3D and flat</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>3D</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Flat</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What the colours show</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fabrics</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Share of capacity</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Which runs are drawn</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Newest run</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A | B</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A | B | B − A</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>End of the scale</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keep as A</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keeps this run, to compare the next ones with it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show the whole garment (Home).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The steps have ends of their own; Steps… under the legend edits and resets them.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Where the eight steps of the colours end. Empty: at a round number over the most that the runs hold.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>About the recording</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open Its Design</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Edit the design from which this run was made, in place of the project.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A recording of “%1” in “%2”, which this project does not hold. It cannot be edited; the forms edit the project.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>hygroloom::GarmentWorkspace</name>
    <message>
        <source>Garment</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Gaps and Seams</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Wear</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Wear Run</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Time of Wear</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Panels and Zones</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Garment Runs</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add Built-in %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add a %1 and an experiment in which it is worn.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add Garment from a &amp;File…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add a sewing pattern, or a mesh with flat coordinates.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remove &amp;Garment</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remove the chosen garment and its experiments.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Run the Wear Experiment</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Run the experiment on this garment.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Pause the Wear Experiment</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pause or resume the run.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>S&amp;top the Wear Experiment</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stop the run. What was computed is kept.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Keep This Run as A</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Compare the next runs with this one.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Drop A</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show the newest run alone.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>S&amp;teps of the Colours…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Set where each of the eight colours ends.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Open Recording of a Garment…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show a recorded run of a garment.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open the &amp;Design of the Recording of a Garment</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Edit the design from which the run on screen was made.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save R&amp;un As…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Write the run that is shown to another recording.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save &amp;A As…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Write the run that is kept as A to another recording.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save &amp;Map…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Write pictures and textures of the panels, a table of cells, OBJ and GLB of the time shown to a folder.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save Rep&amp;ort of the Garment…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save numbers, maps at each quarter of the run and curves, as PDF or web page.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Copy Numbers as CSV</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Copy the numbers per panel and zone.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Resume the Wear Ex&amp;periment</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open Recording of a Garment</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Recordings (*.hygrorec)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Another recording is being opened.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A garment is being worn. Stop that run, then open the recording.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Design of %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Making the report.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Saved %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save Map in a Folder</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 at %2 s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: The folder cannot be made.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Saved %1 files to %2.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save Run of a Garment</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save A</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Saved the run to %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A garment is being worn</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stop the run of the garment?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What is recorded up to now is kept with the project&apos;s runs.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stop the Run</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>hygroloom::HelpWindow</name>
    <message>
        <source>Hygroloom User&apos;s Guide</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Back</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Forward</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Contents</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Find on this page</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Page of the guide</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Not on this page.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>hygroloom::ImportDialog</name>
    <message>
        <source>Import Draft</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Name of the fabric</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Name</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What was understood, and what was repaired</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ends</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>per cm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Picks</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Warp diameter</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Weft diameter</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Use these values from the file:</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The file contains neither sett nor thickness. Set them in the Fabric panel.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add Fabric</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Report of the import</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Understood</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Repaired</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Error</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The cloth in the colours of its yarns</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 × %2 crossings in one repeat</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 shafts</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 more yarns in stripes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: %2 %3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> – doubtful</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>hygroloom::IndicesChart</name>
    <message>
        <source>Sensitivity indices</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: alone %2, with others %3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Not known: too few runs have this metric, or all have the same number.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Compute shows which factors matter.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>alone</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>with others</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>hygroloom::IndicesView</name>
    <message>
        <source>Co&amp;mpute</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What the indices rest on</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Metric of the indices</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Compute the indices from the study&apos;s results.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Metric:</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Co&amp;mpute Anew</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Alone: the share of the variance that a factor makes by itself. With others: with all that it does together with other factors. Whiskers: 95 %. Method: %1, %2 points.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>hygroloom::IssuesPanel</name>
    <message>
        <source>warp</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>weft</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>yarn %1 (extra yarn %2)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>droplet %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>initial climate</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>climate, row %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fabric %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Experiment %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Liquid %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Material %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, %2: %3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No issues.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Issues of the project</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 at %2</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>hygroloom::LiquidPanel</name>
    <message>
        <source>Liquid</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>liquid</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>About the liquid</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Liquids of the project</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Liquid of the project</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add a liquid like the experiment&apos;s, and use it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Duplicate the liquid</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rename the liquid</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Delete the liquid</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Experiments that use the liquid</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>At 20 °C. Other temperatures scale it as for water.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Surface tension</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>surface tension</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Viscosity</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>viscosity</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Density</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>density</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>“%1”</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 (missing)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, %2, %3 at 20 °C</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The project has no liquid of this name. Choose another.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>None yet. Add one to choose its surface tension, viscosity and density.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No experiment uses it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Used by %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>add liquid</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>duplicate liquid</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A liquid needs a name.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A liquid “%1” already exists. Choose another name.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>rename liquid</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>delete liquid</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Name:</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rename liquid</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Delete liquid</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>“%1” is used by %2. They will use %3 instead.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the library&apos;s liquid of the same name</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>water</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Delete</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>hygroloom::LiveAnswer</name>
    <message>
        <source>Not enough memory for this experiment. Choose a smaller sample.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>hygroloom::LivePanel</name>
    <message>
        <source>%1 s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Top</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Refine when I pause</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What the map shows</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>After a second without an edit the whole experiment runs at draft, then at standard.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add an experiment to see its water here.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add a fabric to see its water here.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The fabric has an error. Mend it to see its water here.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Off while this machine runs on its battery.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The whole follows.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Draft is being computed.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Standard is being computed.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: %2, %3; %4.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>after %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>after %1 of %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 / %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Water</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>g/m²</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>hygroloom::MainWindow</name>
    <message>
        <source>Issues</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Saved %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Untitled</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1[*] – Hygroloom</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This project has no fabric. Add one with Fabric ▸ Add Fabric.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Out of date: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>1 error</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 errors</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>1 warning</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 warnings</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>1 note</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 notes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No issues</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Issues: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show or hide the issues of the project.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hygroloom</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>F&amp;abric</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>E&amp;xperiment</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Garment</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;New Project</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Start with a plain-weave fabric and one droplet.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Open…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open a project or a recording.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open &amp;Recent</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Examples</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save the project.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save &amp;As…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save the project under another name.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Import Draft…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add a fabric from a WIF draft, a text grid or a picture.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>E&amp;xport Draft (WIF)…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Write the selected fabric&apos;s draft for other weaving programs.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Export &amp;Mesh…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Write yarns or fibres for modelling and rendering programs.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save &amp;Picture…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save the fabric or garment as it is seen, or in Compare the maps side by side, as a PNG file.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Close the window.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Mao et al.: Hygroscopicity of Woven Textiles</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The experiments of Mao et al., “Yarn-Level Simulation of Hygroscopicity of Woven Textiles”.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Colour &amp;Range</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Full: 0 to 100 %</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Follow the run</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Follow the time shown</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Water Colours</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Blue</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cividis</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Natural: wet yarns darken (maps stay blue)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Appearance</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Panels</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>R&amp;eset Layout</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Restore the original arrangement of the panels.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Design</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Edit the fabric.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Simulate</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Run an experiment on the fabric.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Co&amp;mpare</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Compare runs of the same experiment side by side.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cut a garment from fabrics, and wear it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>S&amp;tudy</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Run many points, and see what matters.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>As the &amp;Desktop</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Light</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>D&amp;ark</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>High &amp;Contrast</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;User&apos;s Guide</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Explain this workspace or experiment.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Find Command…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Find a command by letters of its name.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;About Hygroloom</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Version and licence.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>About &amp;Qt</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The toolkit of this program.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tools</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Workspace %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>About Hygroloom</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Simulates how woven fabrics take up, spread and dry water.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This program is free software under the GNU General Public License, version 3 or later, with an additional permission to link with the CUDA runtime. It comes with no warranty, to the extent the law permits.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Unsaved work found</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hygroloom ended before “%1” was saved. Open the recovered copy?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Last changed on %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The file %1 was saved later. The recovered copy opens separately and asks for a name when you save it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>1 run belongs to it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 runs belong to it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Open</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Discard</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Ask Again Later</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>one drop</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Projects and recordings (*.hygro *.hygrorec);;All files (*)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save Project</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Projects (*.hygro)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Saved %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is no garment to save a picture of. Add one.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No runs are compared, so there is no picture to save. Tick the runs in the list.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This display cannot draw the fabric, so there is no picture to save.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>study</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>comparison</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>garment</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save Picture</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pictures (*.png)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The picture cannot be written to %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Import Draft</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drafts, text grids and pictures (*.wif *.txt *.png *.bmp);;All files (*)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>import of %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This fabric has an error and its draft cannot be exported. See the Issues panel.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Export Draft</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drafts (*.wif)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>and %1 more</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Runs are not saved</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save the project, so that its runs are kept beside it?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Otherwise these runs are deleted:</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Delete the Run</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Delete the Runs</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Runs are being copied to the project.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Cancel</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Copying runs</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Unsaved changes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save the changes to “%1”?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Otherwise they are lost.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>An export is in progress</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stop the export?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No file will be written.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stop the Export</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>hygroloom::NameDialog</name>
    <message>
        <source>Name</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Why the name cannot be taken</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Name</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>hygroloom::NewestJob</name>
    <message>
        <source>Work in the background ended early: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the memory did not suffice</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>hygroloom::NumberDelegate</name>
    <message>
        <source>Run</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>hygroloom::OrderEditor</name>
    <message>
        <source>Type counts and yarn letters, such as 12A 4B.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is no yarn %1; the last one is %2.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Each stripe needs at least 1 yarn; all together at most %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>all A</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>One repeat of the stripes, such as 12A 4B. A is the fabric&apos;s own yarn. Leave empty for no stripes.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Yarns of the fabric</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Select a yarn, then drag over the bars along the draft. Double-click it to edit its fibre, count and twist.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add a yarn like the warp</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remove the selected yarn</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Colour of the selected yarn…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Order of the ends</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Order of the picks</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ends</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Picks</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A  warp | weft</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>add yarn</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>remove yarn</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>yarn colour</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Yarn Colour</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>order of the ends</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>order of the picks</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>hygroloom::PairsChart</name>
    <message>
        <source>Two columns against each other</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Left and Right choose the next row across.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>hygroloom::PairsView</name>
    <message>
        <source>Column across</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Column upwards</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Column that colours</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Across:</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Upwards:</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Colour:</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What the pairs show</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Each point is a row. Click one to choose it; it can then become a candidate.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>hygroloom::PanelTable</name>
    <message>
        <source>Panel</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fabric</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Grain</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Top face</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Angle of the warp from the pattern&apos;s upward direction, counter-clockwise seen from outside.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Where the fabric&apos;s top face lies.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>left sleeve</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>outside</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Panels of the garment</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fabric of %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>cut %1 from %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Grain of %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>turn the grain of %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>inside</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Top face of %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>turn %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This panel has no fabric.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>hygroloom::ParallelChart</name>
    <message>
        <source>Parallel coordinates</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Left and Right choose an axis, Up and Down move its range, with Shift they widen it, Escape keeps all rows.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>hygroloom::ParallelView</name>
    <message>
        <source>Column that colours the lines</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show &amp;All Rows</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Take away the ranges on the axes.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Colour:</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What the parallel coordinates show</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Each line is a row. Drag along an axis to keep the rows in that range, here and in the table; a click takes the range away.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>hygroloom::PartsTable</name>
    <message>
        <source>Numbers per panel and zone</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Part</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Copy as CSV</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>hygroloom::PlanDialog</name>
    <message>
        <source>numerical error %1 %</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 on %2, %3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>modelled</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>left out</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>, set by you</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>, checked during the run</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Region.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 × %2 crossings, %3 yarn segments.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Resolution.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>One frame every %1 s.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Expected.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Live</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Draft</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Standard</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reference</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>under 1 s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>about %1 s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>about %1 min</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>about %1 h</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 of %2 simulated in %3 s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>, paused.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>, %1 left.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>numerical error not known</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>reference for numerical errors</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, %2 of memory, %3. %4</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>expected numerical error not known</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the reference for numerical errors</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>expected %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What the next run models, and why</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The next run: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What was modelled, and why</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The run on screen: %1</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>hygroloom::Playback</name>
    <message>
        <source>%1 more frames are left out.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>hygroloom::PointPaper</name>
    <message>
        <source>Weave on point paper</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A filled square means the warp end lies over the weft pick. Arrow keys move, with Shift they select, Space uses the tool.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Scroll along the picks</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Scroll along the ends</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>hygroloom::PresetGallery</name>
    <message>
        <source>%1 % %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>, %1 tex</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>, %1 mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>My library</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Saved by you.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add a Fabric from the Library</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Group of fabrics</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Search the library</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Search: name, fibre, weave</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fabrics of the library</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>About the selected fabric</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add Fabric</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remove from My Library</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>All groups</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No fabric matches. Use fewer words.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 g/m²</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 × %2 per cm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Warp: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Weft: %1</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>hygroloom::ProjectRuns</name>
    <message>
        <source>cannot be read</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 cannot be read; Garment Runs lists why.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 cannot be read; Compare lists why.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Runs of this project cannot be read.

%1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is not deleted: it is no longer the run that was listed. Open the project again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is not deleted: it is being copied. Wait until that is done.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is not deleted: a run is writing it. Stop that run first.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>hygroloom::Quantity</name>
    <message>
        <source>Allowed: %1 to %2.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>“%1” does not begin with a number.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>“%1” is not a whole number.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This number has no unit; remove “%1”.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>“%1” is not a unit of this field. Use %2.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>hygroloom::QuantityEdit</name>
    <message>
        <source>%1 is out of range. %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>auto</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>auto %1</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>hygroloom::RatesFile</name>
    <message>
        <source>with skin temperatures</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>without skin temperatures</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 rows from %2 to %3 s, %4. Zones: %5.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Use the Table</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Take the zones&apos; rates over time from a CSV with the columns time_s, zone, g_m2_h and, if you have them, skin_temperature_c.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Leave the file, and let the wearer sweat as the table of activity says.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What the file of rates holds</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rates over Time</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tables of rates (*.csv)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>choose rates over time</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>leave rates over time</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Another CSV File…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>From a CSV File…</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>hygroloom::RecentFiles</name>
    <message>
        <source>&amp;Clear List</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>hygroloom::Recovery</name>
    <message>
        <source>%1 cannot be locked. Check that the folder can be written to.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Unsaved work cannot be kept for recovery: %1</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>hygroloom::ReplicateStore</name>
    <message>
        <source>The numbers of earlier replicates cannot be read: %1</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>hygroloom::ResultsPanel</name>
    <message>
        <source>took %1 s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>running</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>stopped</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>1 knob set</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 knobs set</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>on the CPU</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>on a GPU</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fidelity: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 set to %2 (%3 has %4)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 switched on by the user</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 switched off by the user</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Device: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Started: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>About the results</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How the results were computed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Results</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Copy the Results</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>top (grade)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>top</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>bottom (grade)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>bottom</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No results yet.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Run the experiment to see its results here.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1. &lt;a href=&apos;plan&apos;&gt;What was modelled…&lt;/a&gt;</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>hygroloom::RunActions</name>
    <message>
        <source>&amp;Keep</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>For&amp;get…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Forget &amp;Older…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mark the selected run: Forget Older leaves it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Delete the selected run&apos;s recording, after a question. A recording that was opened only leaves the list.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Delete the runs of older designs that are not marked with Keep, after a question.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Size of the project&apos;s runs</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>1 run, %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 runs, %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Forget this run?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Forget these %1 runs, %2?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Forget runs</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Its recording is deleted.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Their recordings are deleted.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Forget</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>hygroloom::RunForm</name>
    <message>
        <source>Run</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pause</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stop</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Resume</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Progress of the run</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>State of the run</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Paused.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Resuming.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cells about 12 mm wide.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cells about 6 mm wide.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cells about 3 mm wide.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cells about 1.5 mm wide.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fidelity: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Expected</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 (not usable)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Device</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Processor that runs the experiment.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add a garment.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add an experiment on this garment.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cutting the garment into cells.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 %2, %3; %4 on two cores.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Go on with the run.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pause the run; its frames so far can be looked at.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Run the experiment on this garment (Ctrl+R).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cannot run: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Finished.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stopped. What was computed up to here is shown.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>hygroloom::RunHistory</name>
    <message>
        <source>The recording %1 holds another run now. Open it again to compare that run.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: %2, %3, %4</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Runs of garments are compared in the workspace Garment.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Only completed runs can be compared.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The frames of this run are being read.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This run is of another experiment. Only runs of the same experiment can be compared.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>hygroloom::RunList</name>
    <message>
        <source>kept</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>older design</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>other design</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>not saved</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Runs of garments</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Runs to compare</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Garment</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fabric</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Experiment</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fidelity</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Took</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Size</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>State</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Double-click a run, or press Enter, to show it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tick two to four runs of the same experiment. Double-click one to open it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>stopped</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>hygroloom::ScatterView</name>
    <message>
        <source>smaller is better</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>larger is better</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What the scatter shows</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Two numbers of all candidates</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Number across</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Number upwards</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Candidate under the pointer</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Across:</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Upwards:</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is nothing to draw yet: run the experiment on the fabrics.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Bars: the intervals of the table. Filled and connected: no other candidate is better in both numbers, by their middles (across: %1; upwards: %2).</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>hygroloom::ShapeView</name>
    <message>
        <source>The garment in 3D</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drag to turn, middle button or Shift and drag to move, wheel to zoom, click to pin a place. Home shows the whole garment, 1, 3 and 7 look from the front, the side and the back.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The picture needs OpenGL 3.3, which this display does not provide.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>hygroloom::SimulateWorkspace</name>
    <message>
        <source>Experiment</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Simulation</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Time</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Results</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save Re&amp;cording As…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save the run that is shown.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save Repor&amp;t…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save the results of the run that is shown, with maps at the time shown and charts, as PDF or web page.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Run</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Run the experiment on the selected fabric.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Pause</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pause or resume the run.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>S&amp;top</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stop the run. Results up to now are kept.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;What Will Be Modelled, and Why…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Which physics the next run models, and the reasons.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What W&amp;as Modelled, and Why…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Which physics the run on screen modelled, and the reasons.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Calibrate…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fit what is not known of the selected fabric to a measurement.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>P&amp;lay or Pause the Recording</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Space</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Play back the run.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open the &amp;Design of the Recording</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Edit the design from which the run on screen was made.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Add Droplet</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add a droplet to the experiment.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add &amp;Experiment</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add a copy of the experiment.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Resume</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>These results are for “%1”. Run the selected fabric.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>These results are for “%1”. Run the selected experiment.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Out of date: the design has changed since this run. Run again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Design of the recording</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Copying runs to the project: %1 %</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The device failed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1

Run on the CPU instead?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the experiment</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A run is in progress</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stop the run of “%1”?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What is recorded up to now is kept with the project&apos;s runs.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Stop and Keep What Is Recorded</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Let It Run</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Design of %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Another recording is still being saved. Save this one when that is done.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save Recording</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Recordings (*.hygrorec)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Saved %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Saving %1: %2 %</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Saved %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The recording cannot be written to %1: %2</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>hygroloom::SimulationPanel</name>
    <message>
        <source>Run</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pause</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stop</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What will be modelled, and why…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Which physics the next run models, and the reasons.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Resume</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Progress of the run</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>State of the run</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Starting.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fidelity: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Expected for %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>about 4 min, 38 MB, numerical error 14 %</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 (not usable)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Device</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Processor that runs the simulation.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add a fabric to run an experiment on.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add an experiment to run.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Expected: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Run the experiment on the selected fabric (Ctrl+R).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cannot run: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 particles of free liquid.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Finished.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stopped. Results up to here are shown.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>hygroloom::SimulationRun</name>
    <message>
        <source>Not enough memory for this run. Choose a smaller sample or a lower fidelity.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>hygroloom::StepLegend</name>
    <message>
        <source>Legend of the colours</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 and more</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 and less</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Difference B − A, g/m²</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>−1000.5 and more</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>hygroloom::StepsDialog</name>
    <message>
        <source>&amp;Reset</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Steps of the Colours</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Why the ends are not in use</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Even steps again, up to the end of the scale.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>End of step %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Step %1 ends at</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Step 1 must end above 0.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Step %1 ends at %2; it must end above %3, where step %4 ends.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>hygroloom::StudyChart</name>
    <message>
        <source>Run a study, or open the results of one.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>hygroloom::StudyPage</name>
    <message>
        <source>&amp;Run</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>S&amp;top</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Run the &amp;Failed Again</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>For a C&amp;luster…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Why They Failed…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Make Candidate</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What is wrong with the study</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What the study will cost</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>State of the study</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Unsaved study</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 (edited)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>and %1 more.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The cost is being worked out.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open Study</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Studies (*.json);;All files (*)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Saved %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save Study</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Studies (*.json)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The study is not saved</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save the changes to the study?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Otherwise they are lost.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A study is in progress</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stop the study?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1. Those are kept in its folder.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stop the Study</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Folder for the Results</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open the Folder of a Study</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;New</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Begin another study.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Open…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open a study file.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save the study file.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sa&amp;ve As…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save the study file under another name.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Name of the study</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Choose…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose the folder for the results.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Folder for the results</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Results in:</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Run what the folder lacks of the study.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stop. The runs that have ended are kept; Run goes on.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Write the study for a cluster, and see what to type there.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open &amp;Results…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open the folder of a study that has run.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Results shown</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Table</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Main Effects</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pairs</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Parallel Coordinates</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sensitivity</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Chosen row</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add a fabric with the values of the chosen row to the project.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Progress of the study</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rows of the study</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stopping.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The study could not run.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 of %2 runs done, %3 failed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stopped. %1. Run goes on with those that are missing.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: The memory does not suffice for these results.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: %2 rows</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: %2 of %3 rows</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>, %1 failed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No results are open.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 of %2 rows are in the ranges.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The indices are being computed.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Point %1: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 more failed.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Runs that failed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>1 run failed.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 runs failed.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>hygroloom::StudyRuns</name>
    <message>
        <source>Not enough memory for this run. Choose a smaller sample or a lower fidelity.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 of %2 runs done</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>hygroloom::StudySetup</name>
    <message>
        <source>Fabrics of the study</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Experiments of the study</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Metrics of the study</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Add Factors…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Re&amp;move</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fabrics</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Experiments</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Metrics</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Factors of the study</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Factor</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Spread</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Factors</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Grid</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Latin hypercube</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sobol sequence</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>One at a time</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Live</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Draft</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Standard</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reference</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fastest within an error</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Off</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Points laid out for it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>From a surface</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> %</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Points</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Design:</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How the points are spread over the factors.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Points:</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Of a grid, the most that there may be.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Replicates:</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Runs of each point with cloths that their description leaves open.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fidelity:</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Error at most:</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sensitivity:</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Which factors matter. Points laid out for it need some hundred points a factor; a surface fitted to the points needs fewer.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Seed:</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The same seed gives the same points.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 (not in this project)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>incomplete</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Now %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Seed: This must be a whole number from 0 to 18446744073709551615; given is “%1”.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fabrics: Tick one at least.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Experiments: Tick one at least.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The project has an error; the Issues panel says which.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>hygroloom::StudyTableModel</name>
    <message>
        <source>point</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>replicate</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>status</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>time taken (s)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>device</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>program</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>why it failed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>done</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>failed</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>hygroloom::StudyTask</name>
    <message>
        <source>The memory does not suffice for this study. Choose a lower fidelity, or fewer points.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Preparing the runs.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 of %2 runs</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>, %1 failed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, %2 left</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>hygroloom::TextileCanvas</name>
    <message>
        <source>Picture of the woven fabric</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drag to turn, middle button or Shift and drag to move, wheel to zoom, click to choose a yarn. Arrow keys turn, plus and minus zoom, square brackets go from yarn to yarn. F shows the whole fabric, 1, 3 and 7 look from the front, the right and the top.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>weft %1 mm, warp %2 mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Click the first point on a yarn. Esc ends measuring.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Click the second point. Esc starts again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>End %1 of the repeat, %2 of the piece</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pick %1 of the repeat, %2 of the piece</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>warp %1, weft %2, height %3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>warp</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>weft</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>End %1, pick %2: %3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>warp over weft</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>weft over warp</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>End %1, pick %2 of the pores filled</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>hygroloom::TimeChartView</name>
    <message>
        <source>Click to show that time.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>hygroloom::Timeline</name>
    <message>
        <source>absorbed at %1 s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>To the start</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Play or pause (Space)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>To the end</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Time</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Time shown</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What has happened</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 / %2</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>hygroloom::ViewBar</name>
    <message>
        <source>View of the fabric</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Home</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Fit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show the whole fabric.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Look From</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>F&amp;ront</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Look along the warp.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Back</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Look against the warp.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ri&amp;ght</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Look along the weft.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Left</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Look against the weft.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Top</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Look down on the fabric.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>B&amp;ottom</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Look up at the fabric.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Isometric</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Isometric view.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Few Repeats</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show a few repeats in the middle.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Zoom to the Selected Yarn</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show a few crossings of the selected yarn.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Next Yarn</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Select the next yarn.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Previous Yarn</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Select the previous yarn.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>P&amp;arallel</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Parallel projection, without perspective.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pa&amp;rticles</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show the particles of free liquid instead of its surface.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>S&amp;watch</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>5 mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>2 cm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>5 cm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>10 cm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Mouse</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hygroloom: left turns, middle moves</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Blender: middle turns, Shift and middle moves</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>FreeCAD: middle moves, middle and left turns</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>View</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Viewing direction</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Swatch</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Size of the swatch on screen</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>S&amp;ection</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;None</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Across the &amp;Warp</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Across the We&amp;ft</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Level</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Section</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cut the fabric open</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Position of the cut</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Distance of the cut from the middle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Other Half</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keep the other half of the fabric.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Measure</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Measure the distance between two points on yarns.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>yarn centrelines</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>yarn surfaces</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Measure between</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>hygroloom::Viewport</name>
    <message>
        <source>This display cannot draw the fabric.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, dry</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The recording does not contain its fabric “%1”.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pores filled</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>hygroloom::WaterMap</name>
    <message>
        <source>Most water %1 grams per square metre</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1; wetted radius %2 millimetres.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Largest difference to the baseline %1 grams per square metre; %2 of %3 cells differ.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 g/m²</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 (%2: %3 to %4)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 g/m² less than the baseline</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 g/m² more than the baseline</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>, not shown to differ</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>dry</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>wetted radius %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: %2 at %3, %4 mm</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>hygroloom::WaterMapView</name>
    <message>
        <source>Top</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Bottom</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Run the experiment to see how the water spreads on both faces.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Map resolution, crossings per cell</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Each cell of the maps is the mean over N × N crossings.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Value under the pointer</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Map resolution (crossings per cell)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Water</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>g/m²</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>hygroloom::WearChart</name>
    <message>
        <source>Share of capacity at the pin, %</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Water at the pin, g/m²</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Share of the garment&apos;s capacity, %</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Water in the garment, g/m²</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>hygroloom::WearForm</name>
    <message>
        <source>Activity</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Duration</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Air</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Humidity</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Air speed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Water at start</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Wear experiment</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add an experiment on this garment</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rename the experiment</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rename the Experiment</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remove the experiment</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>change %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>From</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sweats</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How many times as much as the table of zones says.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Activity over time</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add a change of activity</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remove the selected change of activity</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>add activity</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>remove activity</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Activity: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 says how the zones sweat over time.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Time %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>change time of activity</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Factor %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>change activity</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>hygroloom::WearTimeline</name>
    <message>
        <source>To the start</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Play or pause (Space)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>To the end</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Time</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Time shown</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 / %2</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>hygroloom::WeaveEditor</name>
    <message>
        <source>Ends of the repeat</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Picks of the repeat</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Weave pattern</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose a weave, or type one such as “twill 3/1 S” or “satin 8/3”.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>free weave</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Repeat</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Edit the draft</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Edit threading, tie-up, treadling and the order of the yarns.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>weave</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>weave pattern</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>size of the repeat</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Brush</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Line</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rectangle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fill</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Select</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Zoom In</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Zoom Out</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fit the Repeat</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mirror Left and Right</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>mirrored ends</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mirror Top and Bottom</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>mirrored picks</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Invert</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>inverted weave</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rotate by 90°</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>rotated weave</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>shifted weave</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shift Left</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shift Right</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shift Up</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shift Down</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cut</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>cut weave</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Copy</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Paste</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Clear</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>cleared weave</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Insert End</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>inserted end</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Insert Pick</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>inserted pick</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Delete End</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>deleted end</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Delete Pick</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>deleted pick</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The copied part of %1 × %2 crossings does not fit into the repeat of %3 × %4. Enlarge the repeat first.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>pasted weave</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The clipboard holds no text; copy rows of 0 and 1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The rows on the clipboard differ in length; make them alike.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The clipboard holds no weave; copy rows of 0 and 1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What is on the clipboard is larger than 2000 ends or picks.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>hygroloom::WeaveNotes</name>
    <message>
        <source>Notes about the weave</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>About the weave</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Warnings about the weave</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Warp sett against its limit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Weft sett against its limit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add a fabric to draw its weave.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Longest floats: warp %1, weft %2. Warp shows on %3 % of the face.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 % of the crossings interlace.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>It repeats every %1 × %2.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A float passes over or under several yarns of the other system. 100 % interlacing is plain weave.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ends that never interlace: %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Picks that never interlace: %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Warp sett: %1 % of its limit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Weft sett: %1 % of its limit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ashenhurst&apos;s limit is %1 per cm: yarns side by side, with room to change sides. A firm cloth has about 75 % of it. Peirce&apos;s limit is %2 per cm (%3 %): circular arcs that touch.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>hygroloom::WhyView</name>
    <message>
        <source>Find &amp;Out</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>State of the question</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What the contributions rest on</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Answer</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Parts that differ and what they make</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Why is:</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a&amp;gainst:</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;by:</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Run fabrics that have some parts of the one and some of the other, and see what each part makes of the difference. The runs go on in the background.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose an experiment of the project above.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Run the experiment on two fabrics of the project first (Run All Missing).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose two different fabrics.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Replicates of these fabrics are missing: Run All Missing runs them.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Part</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Contribution to the difference</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>In words</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Looking for what differs…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>1 run</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 runs</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>. Failed: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>, %1 left</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ca&amp;ncel Runs</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>hygroloom::YarnPanel</name>
    <message>
        <source>warp</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>weft</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>stripe yarn</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Warp yarn</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Weft yarn</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Yarns of the stripes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Filaments</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>filament count</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Of a yarn of continuous filaments. Their radius, and the pores between them, follow from it and the linear density. Leave empty for staple yarns: the material&apos;s fibre radius counts.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fibres drawn</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>fibre count</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Per yarn, in pictures and exports. Each represents a bundle of real fibres.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Irregularity</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>irregularity</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Coefficient of variation of the linear density along the yarn (Uster CVm). Acts in the closure “pores” only.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Crimp</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How much longer the yarn is than the fabric.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fibre pores</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Radius of the pores between the fibres; they draw water in by capillarity.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Diameter</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>diameter</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Of the free, round yarn. Leave empty to calculate it from linear density and packing.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Linear density</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>linear density</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Grams per kilometre (tex). You can type Ne, Nm or denier: “30 Ne”.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Packing</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>packing factor</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fibre volume divided by yarn volume: 0.5 to 0.65 for spun yarns.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Twist</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>twist</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Twist direction</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 twist direction</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Plies</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>plies</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Single yarns twisted together. Diameter and linear density are those of the whole yarn.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ply twist</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>ply twist</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Turns of the plies round each other.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ply direction</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 ply twist direction</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>S twist</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Z twist</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Same as warp</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Weft yarn is the same as the warp yarn</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>weft same as warp</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Yarns beside the fabric&apos;s own, which is A. Letters are those of the stripes, such as 12A 4B.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Yarn</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Yarn of the stripes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Yarn Colour</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 colour</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Undyed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Colour</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fibre</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Blended with</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 fibre</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 blend</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Blend ratio</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 blend share</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fraction of the first fibre, by dry mass.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>undyed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ne %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 µm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>none</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>hygroloom::ZonesForm</name>
    <message>
        <source>Draw a zone on a flat panel: click its corners, and the first one again</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rename the selected zone</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Delete the selected zone</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Own zones</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Zone</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sweats</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>In place of the body&apos;s zone; times the factor of the activity.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rename the Zone</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>rename zone</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sweat of own zone %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>change sweat of a zone</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, on %2</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>main</name>
    <message>
        <source>Design woven fabrics and simulate how they take up water.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Write a report (.html) as PDF, without a window: --pdf page.html page.pdf.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A project (.hygro) or a recording (.hygrorec).</source>
        <translation type="unfinished"></translation>
    </message>
</context>
</TS>
